# SPDX-License-Identifier: MIT
"""Decisions on coordinate systems of the program, ``#CS`` (MO-8)."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.decided import left, numbers, perform
from support.run_folders import changed_machine

from nctakt.run.controller import Controller

POSITIONS = [f"{axis}.{system}.ACT_POS" for system in ("ACS", "PCS") for axis in "XYZ"]


#: Three systems on each other: turned by 90° about Z, shifted in X, shifted in Z.
STACK = "#CS ADD [ICS] [0, 0, 0, 0, 0, 90]\n#CS ADD [WCS] [1]\n#CS ADD [W2] [0, 0, 5]\n"


def ends_at(program: str, controller: Controller | None = None) -> list[float]:
    """The positions of X, Y, Z after a program: in ACS, then in PCS."""
    run = perform(program + "\nM30", controller, signals=POSITIONS)
    assert run.state == "ended", run.diagnostics
    assert run.trace is not None
    last = run.first_tick + run.ticks - 1
    return [run.trace.at(last, name) for name in POSITIONS]


@pytest.mark.parametrize(
    ("command", "place"),
    [
        ("#CS ON [1, 2, 3]", (11, 22, 33)),
        ("#CS ON [,,10,,,90]", (-20, 10, 40)),
        ("#CS ON [0, 0, 0, 90]", (10, -30, 20)),
        ("#CS ON [0, 0, 0, 0, 90]", (30, 20, -10)),
        ("#CS ON [0, 0, 0, 90, 0, 90]", (30, 10, 20)),
        ("#CS ON [2][0, 0, 5]", (10, 20, 35)),
        ("#CS DEF [2][0, 0, 5]\n#CS ON [2]", (10, 20, 35)),
        ("#CS DEF [0, 0, 5]\n#CS DEF [0, 0, 6]\n#CS ON", (10, 20, 36)),
        ("#CS DEF [0, 0, 5]\n#CS DEF [0, 0, 6]\n#CS ON [1]", (10, 20, 35)),
        ("G70\n#CS ON [1/25.4, 0, 0]\nG71", (11, 20, 30)),
        ("#CS ON [0, 0, 0, 0, 0, 90]\n#CS ON [1, 0, 0]", (-20, 11, 30)),
        ("#CS ON [1, 0, 0]\n#CS ON [1, 0, 0]\n#CS OFF", (11, 20, 30)),
        ("#CS ON [1, 0, 0]\n#CS ON [1, 0, 0]\n#CS OFF ALL", (10, 20, 30)),
        ("#CS OFF ALL", (10, 20, 30)),
        ("#CS ADD [A] [1, 2, 3]", (10, 20, 30)),
        ("#CS ADD [A] [1, 2, 3]\n#CS SELECT [A]", (11, 22, 33)),
        (f"{STACK}#CS SELECT [WCS]", (-20, 11, 30)),
        (f"{STACK}#CS SELECT [W2]", (-20, 11, 35)),
        (f"{STACK}#CS SELECT [W2]\n#CS SELECT [ICS]", (-20, 10, 30)),
        (f"{STACK}#CS SELECT [W2]\n#CS OFF", (10, 20, 30)),
        (f"{STACK}#CS SELECT [WCS]\n#CS ON [0, 0, 7]", (-20, 11, 37)),
        (f"{STACK}#CS SELECT [WCS]\n#CS ON [0, 0, 7]\n#CS OFF", (-20, 11, 30)),
        (f"{STACK}#CS SELECT [WCS]\n#CS ON [0, 0, 7]\n#CS OFF ALL", (10, 20, 30)),
        (f"G92 X1\n{STACK}#CS SELECT [ICS]\nG92 X5\n#CS SELECT [WCS]", (-19, 11, 30)),
    ],
)
def test_where_a_system_has_its_coordinates(command: str, place: tuple[float, ...]) -> None:
    """Shift, then the third angle about Z, the second about the new Y, then the first about X."""
    found = ends_at(f"{command}\nG00 X10 Y20 Z30")
    assert found[:3] == pytest.approx(place, abs=1e-9)


def test_a_turn_by_thirty_degrees() -> None:
    """Half and the root of three quarters; a relative way turns as well."""
    found = ends_at("#CS ON [0,0,0,0,0,30]\nG00 X10\nG91 Y10")
    root = 0.75**0.5
    assert found == pytest.approx([10 * root - 5, 5 + 10 * root, 0, 10, 10, 0], abs=1e-9)


def test_offsets_of_a_system_end_with_it() -> None:
    """G54 shifts it, restarts in it, and is restored after it; G92 is along its axes."""
    program = "G54\n#CS ON [0,0,0,0,0,90]\nG92 X5\nG00 X0 Y0 Z0"
    assert ends_at(program)[:3] == pytest.approx([100, 55, -10])
    assert ends_at(program + "\n#CS OFF\nG00 X0 Y0")[:3] == pytest.approx([100, 50, -10])
    program = "#CS ON [0,0,0,0,0,90]\nG54\nG00 X0 Y0 Z0"
    assert ends_at(program)[:3] == pytest.approx([-50, 100, -10])


def test_presets_are_those_of_the_system() -> None:
    """#PSET: where the axes are gets a name along the turned X."""
    found = ends_at("G00 X0 Y7\n#CS ON [0,0,0,0,0,90]\n#PSET X100\nG00 X101")
    assert found == pytest.approx([0, 8, 0, 101, 0, 0], abs=1e-9)


def test_a_system_moves_nothing_and_other_axes_keep_their_offsets() -> None:
    """G55 has A 90: after #CS ON the A axis begins there."""
    assert left("G55\n#CS ON [1,2,3]\nG00 A1\nM30", "V.RTA.ACS.ACT_POS.A") == 91.0
    assert ends_at("G00 X5\n#CS ON [1,2,3,4,5,6]")[:3] == [5, 0, 0]


def test_the_next_program_has_no_system() -> None:
    """It ends with its program, also where an error has ended that."""
    controller = Controller()
    perform("#CS ON [1,2,3,0,0,45]\nM30", controller)
    assert ends_at("G00 X10", controller)[:4] == [10, 0, 0, 10]
    perform("#CS ON [1,2,3,0,0,45]\nG00 X99999\nM30", controller)
    controller.reset()
    assert ends_at("G00 X20", controller)[:4] == [20, 0, 0, 20]


@pytest.mark.parametrize(
    ("program", "number"),
    [
        ("#CS ON", 20821),
        ("#CS ON [3]", 20821),
        ("$FOR P1 = 1, 6, 1\n#CS DEF [P1] [1, 2, 3]\n$ENDFOR", 21234),
        ("D1 G41 G01 X10 F100\n#CS ON [1,0,0]", 20802),
        ("D1 G41 G01 X10 F100\nX20\nG40\n#CS ON [1,0,0]", 20802),
        ("#CS ON [9000,0,0]\nG00 X2000", 120002),
        ("#CS ON [0,0,0,0,0,45]\nG00 X9000 Y9000", 120002),
    ],
)
def test_what_cannot_be(program: str, number: int) -> None:
    """Each with its own diagnostic; limits hold for all axes that move."""
    assert numbers(perform(program + "\nM30")) == [number]


def test_switching_off_what_is_off_is_a_warning() -> None:
    """20824 stops nothing."""
    run = perform("#CS OFF\nG00 X1\nM30")
    assert (run.state, numbers(run)) == ("ended", [20824])


def test_the_contour_of_a_turned_system_is_compensated() -> None:
    """A quarter turn about Z: the tool of 5 mm is left of the contour, on the side of -X."""
    run = perform(
        "D1\n#CS ON [0,0,0,0,0,90]\nG41 G01 X10 Y0 F6000\nX20\nX30\nM30", signals=POSITIONS
    )
    assert run.trace is not None
    assert run.trace.at(run.ticks - 2, "X.ACS.ACT_POS") == pytest.approx(-5.0)


@pytest.mark.parametrize("plane", [17, 18, 19])
def test_arcs_in_each_plane_of_a_turned_system(plane: int) -> None:
    """A half circle stays one where each axis lies along another one."""
    first, second = {17: "XY", 18: "ZX", 19: "YZ"}[plane]
    centre = dict(zip("XYZ", "IJK", strict=True))[first]
    for angles in ("0,0,90", "90,0,0", "0,90,0", "90,0,90", "180,0,0"):
        found = ends_at(
            f"#CS ON [0,0,0,{angles}]\nG{plane} G03 {first}20 {second}0 {centre}10 F6000"
        )
        place = dict(zip("XYZ", found[3:], strict=True))
        assert place[first] == pytest.approx(20.0)
        assert place[second] == pytest.approx(0.0, abs=1e-9)


def test_a_system_needs_three_linear_axes(tmp_path: Path) -> None:
    """20660: the third axis of this channel is rotary."""
    lines = ["gruppe[0].achse[2].log_achs_nr 4", "gruppe[0].achse[3].log_achs_nr 3"]
    machine = changed_machine({"sda_mds1.lis": lines}, tmp_path / "machine")
    assert 20660 in numbers(perform("#CS ON [1,0,0]\nM30", Controller(machine)))


def test_tool_offsets_are_not_turned() -> None:
    """Tool 2 has 80 mm along Z, though the system's third axis lies along X."""
    found = ends_at("D2\n#CS ON [0,0,0,0,90]\nG00 X1 Y2 Z3")
    assert found == pytest.approx([3, 2, 79, 1, 2, 3], abs=1e-9)


def test_single_axes_are_in_no_system() -> None:
    """The G54 of the system is added to the position of X; the shift of the system is not."""
    found = ends_at(
        "#CS ON [1,2,3,0,0,90]\nG54\n"
        "#RT CYCLE [SCOPE=PROG]\n$IF ONCE 1\nX[INDP OFFSET=ALL G90 POS=5 FEED=10000]\n$ENDIF\n"
        "#RT CYCLE END\nG04 X2"
    )
    assert found[0] == 105.0


@pytest.mark.parametrize(
    ("program", "number"),
    [
        ("#CS ADD [MCS] [1]", 900929),
        ("#CS ADD [LONGNAMES] [1]", 900929),
        ("#CS ADD [A] [1]\n#CS ADD [a] [2]", 21599),
        ("".join(f"#CS ADD [N{n}] [1]\n" for n in range(6)), 21600),
        ("#CS SELECT [A]", 21601),
        ("#CS ADD [A] [1]\n#CS SELECT [B]", 21601),
        ("#CS ADD [A] [1]\n#CS ON [2]\n#CS SELECT [A]", 20821),
        ("#CS ADD [A] [1]\n#CS ON [2, 0]\n#CS SELECT [A]", 900932),
        ("#CS ADD [A]", 900233),
        ("#CS ADD [1, 2] [1]", 900233),
        ("#CS SELECT [A] [1]", 900233),
        ("#CS MODE ON", 900233),
    ],
)
def test_systems_with_names_have_limits(program: str, number: int) -> None:
    """Each mistake has its own number, MO-8."""
    assert numbers(perform(program + "\nM30")) == [number]
