# SPDX-License-Identifier: MIT
"""Two steps of transformations, ``#TLC``, ``#PTP``: programs and mistakes (language: 1.1, 1.2)."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from support.stepped_machine import machine_with_steps, numbers, run

from nctakt.messages.path.transformations import (
    ARC_DURING_PTP,
    KIN_ID_DURING_TRANSFORMATION,
    KINEMATIC_NOT_POSSIBLE,
    NO_KINEMATIC_SELECTED,
    PTP_DURING_COMPENSATION,
    PTP_WITHOUT_TRANSFORMATION,
    TLC_AND_RTCP,
    TLC_DURING_COMPENSATION,
    TRANSFORMATION_DURING_COMPENSATION,
    TRANSFORMATION_DURING_PTP,
    UNKNOWN_KINEMATIC,
)
from nctakt.messages.programs.checked_blocks import INVALID_COMMAND_FORM

#: The tip as the decoder has it, and as the realtime part shows it.
SAY = (
    '#MSG ["%.6f %.6f %.6f %.6f %.6f %.6f", V.A.ABS.X, V.A.ABS.Y, V.A.ABS.Z,'
    " V.RTA.MCS.ACT_POS.X, V.RTA.MCS.ACT_POS.Y, V.RTA.MCS.ACT_POS.Z]\n"
)
PLACE = "D1\nG00 X10 Y20 Z100 C30 A40\n"


@pytest.fixture(scope="module")
def machine(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """``demo5`` with kinematics of both steps; the second one has 340 for its default."""
    more = "default_id_of_kin_step[1] 340\n"
    return machine_with_steps(tmp_path_factory.mktemp("machines") / "demo5", more)


def on_the_table(tip: list[float], angle: float = 30.0) -> list[float]:
    """A tip in the workpiece on the table C about X50 Y-20."""
    turn = math.radians(-angle)
    x, y = tip[0] - 50.0, tip[1] + 20.0
    return [
        50.0 + x * math.cos(turn) - y * math.sin(turn),
        -20.0 + x * math.sin(turn) + y * math.cos(turn),
        tip[2],
    ]


def test_second_step_leads_on_from_the_first(machine: Path) -> None:
    """The tip of the head, in the workpiece on the table; decoder and cells agree."""
    found, said = run(
        machine,
        PLACE + "#TRAFO [91]\n" + SAY + "#TRAFO OFF\n#TRAFO [91, 340]\n" + SAY
        # one step after the other off, and by the IDs that are kept
        + "#TRAFO [ON, OFF]\n" + SAY + "#TRAFO [OFF, ON]\n" + SAY + "#TRAFO OFF\n" + SAY
        + "#TRAFO ON\n" + SAY,
    )  # fmt: skip
    assert found.errors == ()
    head, both, first, second, none, again = map(numbers, said)
    assert both == pytest.approx(on_the_table(head) * 2, abs=2e-6)
    assert first == pytest.approx(head, abs=2e-6)
    # alone the second step has the tool's length
    assert second == pytest.approx(on_the_table([10.0, 20.0, 100.0]) * 2, abs=2e-6)
    assert none == pytest.approx([10.0, 20.0, 200.0] * 2, abs=2e-6)
    assert again == pytest.approx(both, abs=2e-6)


def test_path_is_that_of_both_steps(machine: Path) -> None:
    """The axes end where the maps say, and G00 to the same words moves nothing."""
    found, said = run(
        machine,
        PLACE + "#TRAFO [91, 340]\nG01 X30 Y-10 Z60 C75 A-20 F3000\n" + SAY + "#TRAFO OFF\n"
        "#TRAFO [91, 340]\n" + SAY,
    )  # fmt: skip
    assert found.errors == ()
    moved, again = map(numbers, said)
    assert moved == pytest.approx([30.0, -10.0, 60.0] * 2, abs=2e-6)
    assert again == pytest.approx(moved, abs=2e-6)


def test_defaults_and_none(machine: Path) -> None:
    """DEFAULT is that of P-CHAN-00032 and P-CHAN-00264, NONE forgets, a value left out is NONE."""
    found, said = run(
        machine,
        PLACE + "#TRAFO ON\n" + SAY + "#TRAFO [NONE, ON]\n" + SAY + "#TRAFO OFF\n#KIN ID [NONE]\n"
        "#KIN ID\n#TRAFO [ON]\n" + SAY + "#TRAFO [NONE, NONE]\n#TRAFO [DEFAULT, DEFAULT]\n" + SAY
        + "#TRAFO OFF\n#TRAFO [NONE, DEFAULT]\n" + SAY,
    )  # fmt: skip
    assert found.errors == ()
    both, second, first, defaults, other = map(numbers, said)
    assert both == defaults
    assert second == other
    assert on_the_table(first[:3]) == pytest.approx(both[:3], abs=2e-6)


def test_length_correction_moves_along_the_tool(machine: Path) -> None:
    """#TLC ON [dL] takes dL off along the tool; a repeated one counts anew."""
    show = '#MSG ["%.6f %.6f", V.RTA.ACS.ACT_POS.Y, V.RTA.ACS.ACT_POS.Z]\n'
    found, said = run(
        machine,
        "G00 Y0 Z200 A90\n#TLC ON [10]\nG01 Y0 Z200 F5000\n" + show + "G00 A0 Y0 Z200\n" + show
        + "#TLC ON [2]\nG00 Y0 Z200\n" + show + "#TLC OFF\n#TLC OFF\nG00 Y0 Z200\n" + show,
    )  # fmt: skip
    assert found.errors == ()
    assert [numbers(one) for one in said] == [
        pytest.approx([-10.0, 200.0], abs=1e-6),
        pytest.approx([0.0, 210.0], abs=1e-6),
        pytest.approx([0.0, 202.0], abs=1e-6),
        pytest.approx([0.0, 200.0], abs=1e-6),
    ]


def test_point_to_point_ends_where_the_tip_is_programmed(machine: Path) -> None:
    """The axes go straight; MCS keeps on showing the tip."""
    found, said = run(
        machine,
        PLACE + "#TRAFO [91]\n#PTP ON\nG01 X5 Y6 Z7 C80 A-30 F9000\n" + SAY + "#PTP OFF\n" + SAY,
    )
    assert found.errors == ()
    assert [numbers(one) for one in said] == [pytest.approx([5.0, 6.0, 7.0] * 2, abs=2e-6)] * 2


@pytest.mark.parametrize(
    ("command", "reason"),
    [
        ("#AX LOCK ALL", "not published"),
        ("#AX UNLOCK ALL", "not published"),
        ("#TRAFO PCS ON", "user-written"),
        ("#TRAFO PCS ID [3]", "user-written"),
        ("#TRAFO STACK ON [NAME=A]", "of the channel list"),
        ("#KIN DATA [LOCKDOF AX=X]", "coupling kinematics"),
    ],
)
def test_what_is_not_simulated_says_why(machine: Path, command: str, reason: str) -> None:
    """By its name, before the first tick."""
    found, _ = run(machine, command + "\n")
    (error,) = found.errors
    assert error.id == 900200
    assert reason in error.text("en")


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("#TRAFO ON\n#KIN ID [34]\n", KIN_ID_DURING_TRANSFORMATION),
        ("#TRAFO [91, 340]\n#TRAFO [34, 340]\n", KIN_ID_DURING_TRANSFORMATION),
        ("#KIN ID [91]\n#TRAFO ON\n#TRAFO [91, 340]\n", KIN_ID_DURING_TRANSFORMATION),
        ("#KIN ID [NONE, NONE]\n#TRAFO ON\n", NO_KINEMATIC_SELECTED),
        ("#KIN ID [NONE]\n#TRAFO [ON, ON]\n", NO_KINEMATIC_SELECTED),
        ("#TRAFO [0]\n", NO_KINEMATIC_SELECTED),
        ("#KIN ID [5]\n#TRAFO ON\n", UNKNOWN_KINEMATIC),
        ("#TRAFO [91, 91]\n", UNKNOWN_KINEMATIC),
        ("#TRAFO [1.5]\n", UNKNOWN_KINEMATIC),
        ("#TRAFO [77]\n", KINEMATIC_NOT_POSSIBLE),
        ("#KIN ID [5]\n#TLC ON\n", UNKNOWN_KINEMATIC),
        ("D1\nG41 G01 X10 F1000\n#TRAFO ON\n", TRANSFORMATION_DURING_COMPENSATION),
        ("D1\nG41 G01 X10 F1000\n#TLC ON [1]\n", TLC_DURING_COMPENSATION),
        ("#TLC ON [1]\n#TRAFO ON\n", TLC_AND_RTCP),
        ("#TLC ON [1]\n#RTCP ON\n", TLC_AND_RTCP),
        ("#RTCP ON\n#TLC ON\n", TLC_AND_RTCP),
        ("#PTP ON\n", PTP_WITHOUT_TRANSFORMATION),
        ("D1\n#TRAFO ON\nG41 G01 X10 F1000\n#PTP ON\n", PTP_DURING_COMPENSATION),
        ("#TRAFO ON\n#PTP ON\n#TRAFO ON\n", TRANSFORMATION_DURING_PTP),
        ("#TRAFO ON\n#PTP ON\nG02 X10 I5 F1000\n", ARC_DURING_PTP),
        ("#TRAFO [1, 2, 3]\n", INVALID_COMMAND_FORM),
        ("#TRAFO [ALL]\n", INVALID_COMMAND_FORM),
        ("#KIN ID [ON]\n", INVALID_COMMAND_FORM),
    ],
)
def test_what_is_refused(machine: Path, text: str, message: object) -> None:
    """Each with its number, at its line."""
    found, _ = run(machine, text)
    (error,) = found.errors
    assert error.message is message
    assert error.span is not None
    assert error.span.line == len(text.splitlines())
