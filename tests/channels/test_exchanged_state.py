# SPDX-License-Identifier: MIT
"""What a program says of its axes goes with them through ``#CALL AX``, ``#PUT AX``, ``#SET AX``.

``docs/conformance/axis-exchange.md`` says what is decided about limits of axes that leave.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from nctakt.lists.machine.machine import load_machine
from nctakt.results.run import Run
from nctakt.run.controller import Controller, NcText

#: Channel 1 has X (1), Y (2), Z (3), C (5), channel 2 has X (4); axis 6 belongs to none.
MACHINE = load_machine(Path(__file__).parent / "exchange_machine")

#: Z is at index 1 after it.
Z_MOVES_UP = "#SET AX [X, 1, 0] [Z, 3, 1]"


def run(*lines: str, two: tuple[str, ...] = (), controller: Controller | None = None) -> Run:
    """A run of these lines in channel 1, and of others in channel 2."""
    one, other = (
        "\n".join([f"%{name}", *text, "M30", ""]) for name, text in (("one", lines), ("two", two))
    )
    controller = controller or Controller(MACHINE)
    return controller.run(NcText("one", one), channels={2: [NcText("two", other)]}, ticks=3000)


def mistakes(found: Run) -> list[str]:
    """The texts of all errors and warnings."""
    return [one.headline() for one in found.diagnostics if one.severity.name != "NOTE"]


def numbers(found: Run) -> list[int]:
    """The numbers of all errors and warnings."""
    return [one.id for one in found.diagnostics if one.severity.name != "NOTE"]


def test_software_limits_follow_their_axis() -> None:
    found = run("G98 Z-5", Z_MOVES_UP, "G01 Z-10 F6000")
    assert numbers(found) == [120003]
    found = run("G98 Y-5", Z_MOVES_UP, "G01 Z-10 F6000")
    assert mistakes(found) == []


def test_an_axis_that_leaves_has_the_limits_of_its_list() -> None:
    found = run("G98 C-5", "#PUT AX [C]", "#CALL AX [C, 5, 3]", "G01 C-20 F60000")
    assert mistakes(found) == []


def test_limits_of_a_fetched_axis_end_with_the_program() -> None:
    """The next program does not have the axis: it is not one of its list."""
    controller = Controller(MACHINE)
    found = run("#CALL AX [W, 6, 4]", "G98 W-5", "G01 W5 F6000", controller=controller)
    assert mistakes(found) == []
    found = run("G01 X1 F6000", controller=controller)
    assert mistakes(found) == []
    found = run("#CALL AX [W, 6, 4]", "G01 W-10 F6000", controller=controller)
    assert mistakes(found) == []


def test_factors_of_scaling_follow_their_axis() -> None:
    found = run("#SCALE Y2", Z_MOVES_UP, "#SCALE ON", "G01 Z10 F6000", '#MSG ["%g", V.A.ACS.ABS.Z]')
    assert mistakes(found) == []
    assert [one.text for one in found.messages] == ["10"]


@pytest.mark.parametrize("before", ["G92 Z10", "#CS ON [1, 2, 3, 0, 0, 90]", "G01 X1 F6000"])
def test_machine_coordinates_keep_their_axes(before: str) -> None:
    """What ``#MCS OFF`` puts back belongs to the axes that ``#MCS ON`` has found."""
    assert numbers(run(before, "#MCS ON", Z_MOVES_UP, "#MCS OFF")) == [901806]
    assert numbers(run(before, "#MCS ON", "#MCS OFF", "#CS OFF ALL", Z_MOVES_UP)) == []


def test_lines_by_angle_have_the_names_of_the_channel() -> None:
    """The lists of these axes have no names, and V is where Y was."""
    found = run("#SET AX [X, 1, 0] [V, 3, 1]", "G01 X10 F6000 #ANG=45", '#MSG ["%.3f", V.A.ABS.V]')
    assert mistakes(found) == []
    assert [one.text for one in found.messages] == ["10.000"]


def test_a_mistake_names_the_axis_as_the_channel_does() -> None:
    found = run("#PUT AX [Y]", "#CALL AX [V, 2, 1]", "G99 V5", "G01 V10 F6000")
    assert [text.split("error ")[1] for text in mistakes(found)] == [
        "120002: the target 10 of axis V is outside its software limits -10000 … 5"
    ]


def test_the_next_program_has_the_limits_of_its_axes() -> None:
    """Also where the one before has given the last axis, and limited the path."""
    controller = Controller(MACHINE)
    found = run("#VECTOR LIMIT ON [VEL=600]", "#PUT AX [C]", "G01 X1 F60000", controller=controller)
    assert mistakes(found) == []
    again = run("G01 X50 C50 F60000", controller=controller)
    assert mistakes(again) == []
    fresh = run("G01 X49 C50 F60000")
    assert again.ticks == pytest.approx(fresh.ticks, abs=3)


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        (["#PUT AX [Y]", "#CS ON [1, 2, 3, 0, 0, 30]"], [20660]),
        (["#PUT AX [Y]", "G68 R30", "G01 X5 F600"], [20938]),
        (["#PUT AX [Y]", "#ROTATION ON [ANGLE=30]", "G01 X5 F600"], [20938]),
        (["#SET AX [X, 1, 0] [Y, 2, 1] [Z, 3, 2] [C, 5, 4]", "#CS ON [1, 2, 3, 0, 0, 30]"], []),
    ],
)
def test_systems_and_frames_beside_free_places(lines: list[str], expected: list[int]) -> None:
    assert numbers(run(*lines)) == expected


def test_corners_are_rounded_after_an_exchange() -> None:
    found = run("#PUT AX [C]", "G261 G01 X10 F6000", "G02 X20 I5 J0", "G01 Y10", "G260")
    assert mistakes(found) == []
