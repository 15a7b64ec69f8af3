# SPDX-License-Identifier: MIT
"""``Controller.reusable``: runs one after another, each as on a new controller."""

from __future__ import annotations

from pathlib import Path

import pytest

from nctakt.base.failure import Failure
from nctakt.lists.machine.machine import load_machine
from nctakt.run.controller import Controller, NcText
from nctakt.schedule.open_schedule import open_schedule

CYCLE = (
    "#RT CYCLE [ID=1 SCOPE=GLOBAL]\n$IF V.RTA.ACS.ACT_POS.X > V.E.VALUE\nV.E.COUNT += 1\n$ENDIF\n"
    "#RT CYCLE END\nG01 X20 F6000\nM30\n"
)


def test_each_run_is_that_of_a_new_controller() -> None:
    """A GLOBAL cycle and V.E variables live on in a controller, but not from run to run here."""
    part = NcText("part.nc", CYCLE)
    with Controller().reusable() as controller:
        for value in (5, 15, 5):
            run = controller.run(part, set={"V.E.VALUE": value}, why=True)
            assert run == Controller().run(part, set={"V.E.VALUE": value}, why=True)


def test_earlier_results_stay(tmp_path: Path) -> None:
    """What a run gave back does not change with the next one; files are programs as well."""
    file = tmp_path / "part.nc"
    file.write_text("G01 X[V.E.VALUE] F6000\nM30\n")
    with Controller().reusable() as controller:
        first = controller.run(file, set={"V.E.VALUE": 50})
        controller.run(file, set={"V.E.VALUE": 10})
        assert first == Controller().run(file, set={"V.E.VALUE": 50})


def test_mistakes_are_in_the_result() -> None:
    """As those of ``Controller.run``, each time."""
    wrong = NcText("part.nc", "G01 X[ F6000\nM30\n")
    with Controller().reusable() as controller:
        for _ in range(2):
            assert controller.run(wrong) == Controller().run(wrong)


def test_what_cannot_be_reused_is_refused() -> None:
    """A schedule (902536); an unknown option as everywhere."""
    with Controller().reusable() as controller, pytest.raises(TypeError):
        controller.run(NcText("part.nc", "M30"), unknown=1)  # type: ignore[call-arg]
    schedule = open_schedule(load_machine().folder / "rtconf.lis")
    with pytest.raises(Failure) as raised:
        Controller(schedule=schedule).reusable()
    assert [found.id for found in raised.value.diagnostics] == [902536]
