# SPDX-License-Identifier: MIT
"""A program that cannot be read at all raises ``Failure``; mistakes in one are in the result."""

from pathlib import Path

import pytest

from nctakt.base.failure import Failure
from nctakt.run.controller import Controller, NcText


def numbers_of(program: str | Path) -> list[int]:
    """The numbers that running a program fails with."""
    with pytest.raises(Failure) as failure:
        Controller().run(program)
    return [diagnostic.id for diagnostic in failure.value.diagnostics]


def test_a_file_that_does_not_exist_is_a_failure() -> None:
    """900500, not an empty run in error state."""
    assert numbers_of("nofile.nc") == [900500]


def test_a_folder_is_a_failure(tmp_path: Path) -> None:
    """900501."""
    assert numbers_of(tmp_path) == [900501]


@pytest.mark.parametrize("text", ["G00 X5\nM30", f"G00 X5\n{'X1 ' * 5000}\nM30\n", "%part\rM30"])
def test_a_text_by_mistake_is_a_failure_that_names_nctext(text: str) -> None:
    """A text of several lines is no file name: ``NcText`` takes it."""
    with pytest.raises(Failure, match="NcText") as failure:
        Controller().run(text)
    (diagnostic,) = failure.value.diagnostics
    assert diagnostic.id == 900515
    assert len(diagnostic.text()) < 100


def test_nothing_runs_and_the_controller_stays_usable() -> None:
    """The program before the missing one has not begun."""
    controller = Controller()
    with pytest.raises(Failure):
        controller.run(NcText("a.nc", "G00 X5\nM30"), "nofile.nc")
    assert (controller.tick, controller.state) == (0, "ready")
    assert controller.run(NcText("a.nc", "G00 X5\nM30")).state == "ended"


def test_mistakes_of_a_program_are_in_the_result() -> None:
    """They do not raise; all of them are there."""
    run = Controller().run(NcText("a.nc", "G9998\nM30"), NcText("b.nc", "G9999\nM30"))
    assert run.state == "error"
    assert len(run.errors) == 2
