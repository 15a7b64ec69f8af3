# SPDX-License-Identifier: MIT
"""``#MCS`` and the conversions between programmed and machine positions (language: 1.1; MO-8)."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.stepped_machine import machine_with_steps, numbers, run

from nctakt.messages.path.coordinate_systems import (
    COORDINATE_SYSTEM_NOT_STORED,
    MACHINE_SYSTEM_MISSING,
)
from nctakt.messages.path.motion import COMMAND_WORD_NOT_SIMULATED
from nctakt.messages.path.transformations import (
    CONVERSION_DURING_TRANSFORMATION,
    COORDINATE_SYSTEM_DURING_PTP,
    KIN_ID_DURING_TRANSFORMATION,
    KINEMATIC_OF_TOOL_DIFFERS,
    MCS_DURING_PTP,
    NO_KINEMATIC_SELECTED,
    NOT_IN_MACHINE_COORDINATES,
    TRANSFORMATION_DURING_COMPENSATION,
)
from nctakt.messages.programs.checked_blocks import INVALID_COMMAND_FORM

SAY = '#MSG ["%.6f %.6f %.6f", V.A.ABS.X, V.A.ABS.Y, V.A.ABS.Z]\n'
SHOW = (
    '#MSG ["%.6f %.6f %.6f %.6f", V.RTA.ACS.ACT_POS.X, V.RTA.MCS.ACT_POS.X,'
    " V.RTA.PCS.ACT_POS.X, V.RTA.IPO.ACT_POS.X]\n"
)


@pytest.fixture(scope="module")
def machine(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """``demo5`` with further kinematics."""
    return machine_with_steps(tmp_path_factory.mktemp("machines") / "demo5")


def test_machine_coordinates_come_and_go(machine: Path) -> None:
    """Inside programmed positions are those of the axes; after it all is as before."""
    found, said = run(
        machine,
        "T1 D1\nG54\nG00 X10 Y20 Z200 C30 A40\n#TRAFO ON\nG92 X5\n#CS ON [10,20,30,0,0,45]\n"
        + SAY
        + "#MCS ON\n"
        + SAY
        + "G01 X-15 F5000\n"
        + SAY
        + "G01 X110\n#MCS OFF\n"
        + SAY
        + "#MCS OFF\nG01 X0 Y0 Z0\n"
        + SAY,
    )
    assert found.errors == ()
    before, inside, moved, behind, zero = map(numbers, said)
    assert inside == [110.0, 70.0, 290.0]  # with G54 and the tool's length
    assert moved == [-15.0, 70.0, 290.0]
    assert behind == pytest.approx(before, abs=1e-5)
    assert zero == pytest.approx([0.0, 0.0, 0.0], abs=1e-5)


def test_systems_of_the_realtime_part_follow(machine: Path) -> None:
    """ACS, MCS, PCS and IPO differ under a transformation with offsets, and not under #MCS."""
    found, said = run(
        machine,
        "G54\nG00 X0 Y0 Z300 C90 A90\n#TRAFO ON\n"
        + SHOW
        + "#MCS ON\n"
        + SHOW
        + "#MCS OFF\n"
        + SHOW,
    )
    assert found.errors == ()
    before, inside, behind = map(numbers, said)
    assert before == pytest.approx([100.0, -50.0, -150.0, -50.0], abs=1e-5)
    assert inside == [100.0, 100.0, 100.0, 100.0]
    assert behind == pytest.approx(before, abs=1e-5)


def test_contour_is_neither_turned_nor_mirrored_inside(machine: Path) -> None:
    """Rotation, scaling and mirroring are restored after it; those set inside are gone."""
    found, said = run(
        machine,
        "G22\n#ROTATION ON [ANGLE=90]\nG00 X10 Y0\n" + SAY + "#MCS ON\nG00 X20 Y0\n" + SAY
        + "#ROTATION ON [ANGLE=45]\n#MCS OFF\nG00 X20 Y0\n" + SAY,
    )  # fmt: skip
    assert found.errors == ()
    outside, inside, behind = map(numbers, said)
    assert inside == [20.0, 0.0, 0.0]
    assert behind == pytest.approx([2 * value for value in outside])


def test_offsets_inside_end_with_it(machine: Path) -> None:
    """G55, G92 and a plane inside are gone after it; G54 is back."""
    found, said = run(
        machine,
        "T1 D1\nG54\nG00 X0 Y0 Z0\n#MCS ON\nG55 G92 Y7\nG19\nG00 X0 Y0\n"
        + SAY
        + "#MCS OFF\nG17\nG00 X0 Y0 Z0\n"
        + SAY,
    )
    assert found.errors == ()
    inside, behind = map(numbers, said)
    assert inside == [-50.0, 32.0, 90.0]
    assert behind == [100.0, 50.0, 90.0]


@pytest.mark.parametrize(("words", "inside"), [("", 80.0), (" [EX TOOL]", 0.0)])
def test_tool_selected_inside(machine: Path, words: str, inside: float) -> None:
    """It has its length inside but for EX TOOL, and always after it."""
    found, said = run(
        machine,
        f"T1 D1\n#MCS ON{words}\nG00 Z0\n{SAY}D2\nG00 Z0\n{SAY}#MCS OFF\nG00 Z0\n{SAY}"
        f"#TRAFO ON\n#MCS ON{words}\nD1\n#MCS OFF\nG00 Z0\n"
        '#MSG ["%.6f", V.RTA.ACS.ACT_POS.Z]\n',
    )
    assert found.errors == ()
    assert [numbers(one)[-1] for one in said] == [0.0, inside, 80.0, 100.0]


def test_next_program_begins_without_it(machine: Path) -> None:
    """A program that ends inside leaves nothing behind."""
    found, _ = run(machine, "#TRAFO ON\n#MCS ON\n")
    assert found.errors == ()


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("#TRAFO ON\n#PTP ON\n#MCS ON\n", MCS_DURING_PTP),
        ("#TRAFO ON\n#PTP ON\n#MCS OFF\n", MCS_DURING_PTP),
        ("#TRAFO ON\n#PTP ON\n#CS ON [1,2,3]\n", COORDINATE_SYSTEM_DURING_PTP),
        ("#CS ON [1,2,3]\n#TRAFO ON\n#PTP ON\n#CS OFF\n", COORDINATE_SYSTEM_DURING_PTP),
        ("D1\nG41 G01 X10 F1000\n#MCS ON\n", TRANSFORMATION_DURING_COMPENSATION),
        ("#MCS ON\nD1\nG41 G01 X10 F1000\n#MCS OFF\n", TRANSFORMATION_DURING_COMPENSATION),
        *(
            (f"#MCS ON\n{command}\n", NOT_IN_MACHINE_COORDINATES)
            for command in (
                "#CS ON [1,2,3]",
                "#CS OFF",
                "#TRAFO ON",
                "#TRAFO [34]",
                "#RTCP OFF",
                "#TLC ON [1]",
                "#WCS TO MCS",
                "#MCS TO WCS [KIN]",
            )
        ),
        ("#TRAFO ON\n#MCS ON\n#KIN ID [34]\n", KIN_ID_DURING_TRANSFORMATION),
        ("#TRAFO ON\n#MCS ON\nD4\n", KINEMATIC_OF_TOOL_DIFFERS),
        ("#TRAFO ON\nD4\n", KINEMATIC_OF_TOOL_DIFFERS),
        ("#TRAFO ON\n#WCS TO MCS\n", CONVERSION_DURING_TRANSFORMATION),
        ("#CS ON [1,2,3]\n#MCS TO WCS\n", CONVERSION_DURING_TRANSFORMATION),
        ("#WCS TO MCS [CS 3]\n", COORDINATE_SYSTEM_NOT_STORED),
        ("#KIN ID [NONE]\n#WCS TO MCS [KIN]\n", NO_KINEMATIC_SELECTED),
        ("#CS ADD [A] [1]\n#CS SELECT [MCS]\n", MACHINE_SYSTEM_MISSING),
        ("#TRAFO ON\n#CS SELECT [IMCS]\n", COMMAND_WORD_NOT_SIMULATED),
        ("#MCS ON [TOOL]\n", INVALID_COMMAND_FORM),
        ("#MCS ON [EX=1 TOOL]\n", INVALID_COMMAND_FORM),
        ("#MCS OFF [EX TOOL]\n", INVALID_COMMAND_FORM),
        ("#WCS TO MCS [KIN CS 1]\n", INVALID_COMMAND_FORM),
        ("#MCS TO WCS [CS]\n", INVALID_COMMAND_FORM),
        ("#MCS TO WCS [1]\n", INVALID_COMMAND_FORM),
    ],
)
def test_what_is_refused(machine: Path, text: str, message: object) -> None:
    """Each with its number, at its line."""
    found, _ = run(machine, text)
    (error,) = found.errors
    assert error.message is message
    assert error.span is not None
    assert error.span.line == len(text.splitlines())


def test_the_machine_system_lies_below_the_stack(machine: Path) -> None:
    """``#CS SELECT [MCS]`` leaves the stack; the transformation and offsets stay (1047215243)."""
    found, said = run(
        machine,
        "G54\n#CS ADD [ICS] [1,2,3,0,0,30]\n#CS ADD [WCS] [4,5,6]\n#TRAFO ON\n"
        "#CS SELECT [WCS]\nG01 X10 Y10 F5000\n#CS SELECT [MCS]\nG01 X7 Y8 Z9\n" + SAY + SHOW
        + "#CS SELECT [WCS]\nG01 X0 Y0 Z0\n#CS SELECT [MCS]\n" + SAY,
    )  # fmt: skip
    assert found.errors == ()
    inside, shown, origin = map(numbers, said)
    assert inside == [107.0, 58.0, -1.0]  # with G54
    assert shown[1] - shown[2] == 100.0  # MCS and PCS differ by G54 only
    half = 0.5 * 3**0.5
    expected = [101 + 4 * half - 5 * 0.5, 52 + 4 * 0.5 + 5 * half, -1.0]
    assert origin == pytest.approx(expected, abs=2e-6)


def test_conversion_is_what_programming_reaches(machine: Path) -> None:
    """V.A.MCS is where the axes go if V.A.WCS is programmed with all of it active; and back."""
    target = "X12 Y-34 Z56 C70 A-25"
    axes = "V.A.MCS.X, V.A.MCS.Y, V.A.MCS.Z, V.A.MCS.C, V.A.MCS.A"
    reached = axes.replace("A.MCS", "RTA.ACS.ACT_POS")
    given = "".join(f"V.A.WCS.{word[0]} = {word[1:]}\n" for word in target.split())
    found, said = run(
        machine,
        "T1 D1\nG54\n#CS DEF [2] [10,20,-30,0,0,40]\n"
        + given
        + f'#WCS TO MCS [CS 2 KIN]\n#MSG ["%.6f %.6f %.6f %.6f %.6f", {axes}]\n'
        + "#TRAFO ON\n#CS ON [2]\nG00 "
        + target
        + f'\n#MSG ["%.6f %.6f %.6f %.6f %.6f", {reached}]\n#CS OFF\n#TRAFO OFF\n'
        + "V.A.WCS.X = 0\nV.A.WCS.A = 0\nP1 = 2\n#MCS TO WCS [CS P1] [KIN]\n"
        + f'#MSG ["%.6f %.6f %.6f %.6f %.6f", {axes.replace("MCS", "WCS")}]\n'
        + 'G70\n#WCS TO MCS\n#MSG ["%.6f", V.A.MCS.X]\n',
    )
    assert found.errors == ()
    converted, moved, back, inch = map(numbers, said)
    assert converted == pytest.approx(moved, abs=2e-6)
    assert back == pytest.approx([12.0, -34.0, 56.0, 70.0, -25.0], abs=2e-6)
    assert inch == pytest.approx([112.0 / 25.4], abs=2e-6)  # with G54


def test_conversion_moves_nothing(machine: Path) -> None:
    """The program goes there itself; what was never given is 0."""
    found, said = run(
        machine,
        "G00 X10\n#WCS TO MCS [KIN]\n"
        '#MSG ["%g %g %g", V.A.MCS.X, V.A.MCS.Z, V.RTA.ACS.ACT_POS.X]\n'
        'V.A.MCS.X = 25\n#MCS ON\nG00 X[V.A.MCS.X]\n#MCS OFF\n#MSG ["%g", V.RTA.ACS.ACT_POS.X]\n',
    )
    assert found.errors == ()
    assert said == ["0 0 10", "25"]
