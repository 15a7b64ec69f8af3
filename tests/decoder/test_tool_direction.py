# SPDX-License-Identifier: MIT
"""``#ORI MODE`` and ``#TOOL ORI CS``: the direction of the tool (language: 1.1, 1.3)."""

from __future__ import annotations

import math
import re
from pathlib import Path

import pytest
from support.stepped_machine import machine_with_steps, numbers, run

from nctakt.messages.machines.kinematics import ORIENTATION_MODE_WITHOUT_EFFECT
from nctakt.messages.path.transformations import (
    NO_KINEMATIC_SELECTED,
    NO_TOOL_ORIENTATION,
    NOT_IN_MACHINE_COORDINATES,
    POSITION_NOT_REACHED,
    TRANSFORMATION_DURING_COMPENSATION,
)
from nctakt.messages.programs.checked_blocks import INVALID_COMMAND_FORM, UNKNOWN_WORD

SAY = (
    '#MSG ["%.6f %.6f %.6f %.6f %.6f", V.RTA.ACS.ACT_POS.C, V.RTA.ACS.ACT_POS.A,'
    " V.RTA.MCS.ACT_POS.X, V.RTA.MCS.ACT_POS.Y, V.RTA.MCS.ACT_POS.Z]\n"
)
VECTOR = "D1\n#TRAFO ON\nG00 X5 Y6 Z7\n#ORI MODE [VECTOR_2DOF]\n"


@pytest.fixture(scope="module")
def machines(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """``demo5`` with lines of its channel list."""
    folder = tmp_path_factory.mktemp("machines")
    rows = {
        "": "",
        "vector": "ori.mode VECTOR_2DOF\n",
        "six axes": "ori.mode VECTOR_IJK\n",
        "x": "tool_ori_cs.axis 1\n",
        "system": "ori_wcs 1\n",
        **{f"mode {mode}": f"tool_ori_cs.mode {mode}\n" for mode in (2, 3, 4)},
    }
    found = {
        name: machine_with_steps(folder / str(number), text)
        for number, (name, text) in enumerate(rows.items())
    }
    axis = found["mode 2"] / "achs_mds5.lis"
    axis.write_text(re.sub(r"(kenngr.swe_pos +)\d+", r"\g<1>200000", axis.read_text("utf-8")))
    return found


def direction(said: str) -> list[float]:
    """The tool's direction of the head C A, from the positions of its axes."""
    c, a = (math.radians(value) for value in numbers(said)[:2])
    return [math.sin(c) * math.sin(a), -math.cos(c) * math.sin(a), math.cos(a)]


@pytest.mark.parametrize(
    ("words", "vector"),
    [("A1 B0 C0", [1, 0, 0]), ("B3 C3", [0, 1, 1]), ("G91 A1 B2 C3", [1, 2, 3]), ("C9", [0, 0, 1])],
)
def test_vector_turns_the_tool(machines: dict[str, Path], words: str, vector: list[float]) -> None:
    """A, B and C are no axes then; the vector has any length, and the tip stays."""
    found, said = run(machines[""], VECTOR + f"G01 {words} F5000\n" + SAY)
    assert found.errors == ()
    size = math.hypot(*vector)
    assert direction(said[0]) == pytest.approx([value / size for value in vector], abs=1e-6)
    assert numbers(said[0])[2:] == pytest.approx([5.0, 6.0, 7.0], abs=1e-5)


def test_vector_is_in_directions_of_the_machine_whatever_is_active(
    machines: dict[str, Path],
) -> None:
    """A turned system and offsets of rotary axes change positions, not the vector."""
    text = VECTOR + "G55\n#CS ON [1,2,3,0,0,50]\nG01 A1 C1 F5000\n" + SAY + "X1\n" + SAY
    found, said = run(machines[""], text)
    assert found.errors == ()
    for one in said:
        assert direction(one) == pytest.approx([0.5**0.5, 0.0, 0.5**0.5], abs=1e-6)


def test_vector_is_in_the_active_system_by_the_list(machines: dict[str, Path]) -> None:
    """P-CHAN-00247 = 1: a system turned by 50° about Z turns the vector; without one it stays."""
    text = VECTOR + "#CS ON [1,2,3,0,0,50]\nG01 A1 C1 F5000\n" + SAY + "#CS OFF\nA1 C1\n" + SAY
    found, said = run(machines["system"], text)
    assert found.errors == ()
    half, angle = 0.5**0.5, math.radians(50.0)
    turned = [half * math.cos(angle), half * math.sin(angle), half]
    assert direction(said[0]) == pytest.approx(turned, abs=1e-6)
    assert direction(said[1]) == pytest.approx([half, 0.0, half], abs=1e-6)


def test_mode_of_the_list_acts_from_program_start(machines: dict[str, Path]) -> None:
    """P-CHAN-00177; angles again by #ORI MODE [ANGLE], and without a transformation."""
    text = "A45\n" + SAY + "#TRAFO ON\nB1\n" + SAY + "#ORI MODE [ANGLE]\nA30\n" + SAY
    found, said = run(machines["vector"], "G01 F5000\n" + text)
    assert found.errors == ()
    assert numbers(said[0])[1] == 45.0
    assert direction(said[1]) == pytest.approx([0.0, 1.0, 0.0], abs=1e-6)
    assert numbers(said[2])[1] == 30.0


def test_mode_for_six_axes_is_reported(machines: dict[str, Path]) -> None:
    """It has no effect."""
    found, _ = run(machines["six axes"], "A45\n")
    assert [one.message for one in found.diagnostics] == [ORIENTATION_MODE_WITHOUT_EFFECT]


@pytest.mark.parametrize(
    ("name", "angle", "vector", "positive"),
    [
        ("", 30, [0.5, 0.0, 0.75**0.5], None),
        ("x", -30, [0.75**0.5, 0.0, 0.5], None),
        ("mode 3", 30, [0.5, 0.0, 0.75**0.5], True),
        ("mode 4", 30, [0.5, 0.0, 0.75**0.5], False),
    ],
)
@pytest.mark.parametrize("switch", ["#TRAFO ON\n", ""])
def test_tool_is_on_an_axis_of_the_system(
    machines: dict[str, Path],
    name: str,
    angle: int,
    vector: list[float],
    positive: bool | None,
    switch: str,
) -> None:
    """By P-CHAN-00188 and P-CHAN-00189; about the tip, or with the linear axes at rest."""
    say = SAY + '#MSG ["%.6f", V.RTA.ACS.ACT_POS.X]\n'
    text = f"D1\nG00 X5\n{switch}{say}#CS ON [1,2,3,0,{angle},0]\nG01 F500\n#TOOL ORI CS\n{say}"
    found, said = run(machines[name], text)
    assert found.errors == ()
    assert direction(said[2]) == pytest.approx(vector, abs=1e-6)
    if positive is not None:
        assert (numbers(said[2])[1] > 0) is positive
    if switch:
        assert numbers(said[2])[2:] == pytest.approx(numbers(said[0])[2:], abs=1e-5)
    else:
        assert said[1] == said[3]


def test_tool_stays_within_software_limits_where_one_position_is(
    machines: dict[str, Path],
) -> None:
    """P-CHAN-00189 = 2: the nearer one but where it leaves them."""
    text = "G00 C180 A-9\n#CS ON [0,0,0,{},0,0]\n#TOOL ORI CS\n" + SAY
    found, said = run(machines["mode 2"], text.format(-40))
    assert found.errors == ()
    assert numbers(said[0])[:2] == pytest.approx([0.0, -40.0], abs=1e-6)  # +40 is outside
    found, said = run(machines["mode 2"], text.format(-15))
    assert numbers(said[0])[:2] == pytest.approx([180.0, 15.0], abs=1e-6)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (VECTOR + "A0 B0 C0\n", POSITION_NOT_REACHED),
        ("B1\n", UNKNOWN_WORD),
        ("#ORI MODE [VECTOR_2DOF]\nB1\n", UNKNOWN_WORD),
        (VECTOR + "G92 B1\n", UNKNOWN_WORD),
        ("#PSET B1\n", UNKNOWN_WORD),
        ("#ORI MODE\n", INVALID_COMMAND_FORM),
        ("#ORI MODE [VECTOR_3DOF]\n", INVALID_COMMAND_FORM),
        ("#ORI MODE [2]\n", INVALID_COMMAND_FORM),
        ("#TOOL ORI CS [1]\n", INVALID_COMMAND_FORM),
        ("#TRAFO [34]\n#ORI MODE [VECTOR_2DOF]\nA1\n", POSITION_NOT_REACHED),
        ("#KIN ID [34]\n#TOOL ORI CS\n", NO_TOOL_ORIENTATION),
        ("#KIN ID [NONE]\n#TOOL ORI CS\n", NO_KINEMATIC_SELECTED),
        ("D1\nG41 G01 X10 F1000\n#TOOL ORI CS\n", TRANSFORMATION_DURING_COMPENSATION),
        ("#MCS ON\n#TOOL ORI CS\n", NOT_IN_MACHINE_COORDINATES),
    ],
)
def test_what_is_refused(machines: dict[str, Path], text: str, message: object) -> None:
    """Each with its number, at its line."""
    found, _ = run(machines[""], text)
    (error,) = found.errors
    assert error.message is message
    assert error.span is not None
    assert error.span.line == len(text.splitlines())
