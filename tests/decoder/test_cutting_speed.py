# SPDX-License-Identifier: MIT
"""Constant cutting speed against n = v / (2πr): G96, G97, G196 (language facts, section 3)."""

from __future__ import annotations

import math
import shutil
from pathlib import Path

import pytest

import nctakt
from nctakt.base.diagnostics import Severity
from nctakt.checking.check import check_files
from nctakt.lists.machine.machine import load_machine
from nctakt.results.run import Run
from nctakt.run.controller import Controller, NcText
from nctakt.run.realtime.assembly import AssembledMachine

SIGNALS = ("X.ACS.ACT_POS", "Z.ACS.ACT_POS", "S.SPEED", "BLOCK", "PATH.SPEED")


@pytest.fixture(scope="module")
def lathe(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the demo machine whose X is a face axis, with diameters under G90."""
    return _lathe(tmp_path_factory.mktemp("lathe"), absolute=1, relative=0)


def _lathe(folder: Path, absolute: int, relative: int) -> Path:
    """Make the demo machine with X as face axis (P-AXIS-00015 bit 0x40, P-AXIS-00058, 00059)."""
    machine = folder / "machine"
    shutil.copytree(Path(nctakt.__file__).parent / "machines" / "demo", machine)
    diameters = (
        f"kenngr.durchm_prog_abs {absolute}",
        f"kenngr.durchm_prog_rel {relative}",
    )
    for file in machine.rglob("*.lis"):
        text = file.read_text("utf-8")
        lines = [line.split() for line in text.splitlines()]
        if ["kopf.achs_nr", "1"] in lines:
            kept = [line for line in text.splitlines() if "kenngr.achs_mode" not in line]
            file.write_text("\n".join([*diameters, "kenngr.achs_mode 0x41", *kept, ""]), "utf-8")
    return machine


def run(machine: Path | None, text: str) -> Run:
    return Controller(machine).run(NcText("p.nc", text), signals=SIGNALS, until="1 min")


def values_of(result: Run, block: int, *names: str) -> list[tuple[float, ...]]:
    trace = result.trace
    assert trace is not None
    ticks = [tick for tick, number in enumerate(trace["BLOCK"]) if number == block]
    return [tuple(float(trace[name][tick]) for name in names) for tick in ticks]


FACE = """N10 G18 G00 X50
N20 G196 S4000
N30 G96 S100 M03
N40 G04 X1
N50 G01 X10 F300
N60 G97
N70 G01 X50
N80 M30"""


def test_the_speed_follows_the_radius(lathe: Path) -> None:
    """100 m/min at r = 50 mm are 318.3 1/min, at 10 mm 1591.5; n = v / (2πr) in each tick."""
    result = run(lathe, FACE)
    assert result.state == "ended", result.diagnostics
    assert [found.id for found in result.diagnostics] == [901533]
    pairs = values_of(result, 50, "X.ACS.ACT_POS", "S.SPEED")
    assert pairs[0][1] == pytest.approx(100_000 / (2 * math.pi * 50), rel=1e-4)
    for x, speed in pairs:
        assert speed == pytest.approx(100_000 / (2 * math.pi * x), rel=1e-9)
    assert pairs[-1][1] == pytest.approx(1591.549, rel=1e-3)


def test_g97_keeps_the_last_speed(lathe: Path) -> None:
    """After G97 the way back does not change the speed."""
    speeds = {round(speed, 6) for (speed,) in values_of(run(lathe, FACE), 70, "S.SPEED")}
    assert len(speeds) == 1
    assert speeds.pop() == pytest.approx(1591.549, rel=1e-3)


def test_g196_limits_the_speed_near_the_centre(lathe: Path) -> None:
    """At r < 100 m/min / (2π 500) = 31.8 mm the limit holds, down to the centre."""
    text = FACE.replace("S4000", "S500").replace("X10", "X0")
    for x, speed in values_of(run(lathe, text), 50, "X.ACS.ACT_POS", "S.SPEED"):
        expected = 500.0 if x < 31.83 else 100_000 / (2 * math.pi * x)
        assert speed == pytest.approx(expected, rel=1e-3)


def test_rapid_motions_do_not_change_the_speed(lathe: Path) -> None:
    """G00 of the face axis leaves the speed; the next feed block takes it up."""
    text = FACE.replace("G01 X10 F300", "G00 X10").replace("N60 G97", "N60 G01 X12 F300")
    result = run(lathe, text)
    first = {round(speed, 6) for (speed,) in values_of(result, 50, "S.SPEED")}
    assert first == {round(100_000 / (2 * math.pi * 50), 6)}
    assert values_of(result, 60, "S.SPEED")[-1][0] == pytest.approx(
        100_000 / (2 * math.pi * 12), rel=1e-3
    )


def test_feed_per_revolution_follows_the_cutting_speed(lathe: Path) -> None:
    """G95 under G96: the path has F times the present speed."""
    text = FACE.replace("G01 X10 F300", "G95 G01 X20 F0.2")
    pairs = values_of(run(lathe, text), 50, "X.ACS.ACT_POS", "PATH.SPEED")
    for x, path_v in pairs[20:-20]:
        assert path_v == pytest.approx(0.2 * 100_000 / (2 * math.pi * x) / 60.0, rel=1e-3)


def test_the_offset_of_the_face_axis_counts(lathe: Path) -> None:
    """The radius is counted from the program's zero: G92 X10 leaves 40 of 50 mm."""
    text = FACE.replace("N20", "N15 G92 X10\nN20")
    pairs = values_of(run(lathe, text), 50, "X.ACS.ACT_POS", "S.SPEED")
    for x, speed in pairs:
        assert speed == pytest.approx(100_000 / (2 * math.pi * (x - 10.0)), rel=1e-9)


@pytest.mark.parametrize(
    ("program", "numbers"),
    [
        ("N10 G96 S100 M03", [20634]),  # X Y: the demo has no face axis
        ("N10 G18 G00 X50\nN20 G196 S0", [120169]),
        ("N10 G18 G00 X0.1\nN20 G96 S100 M03", [901533, 20633]),
        ("N10 G18 G00 X50\nN20 G96 S100\nN30 G63 Z-10 F600", [901533, 901517, 20636]),
        ("N10 G18 G00 X50\nN30 G63 G196 Z-10 F600 S300", [20637]),
    ],
)
def test_each_mistake_has_its_number(lathe: Path, program: str, numbers: list[int]) -> None:
    """The numbers that the controller gives."""
    result = run(None if numbers == [20634] else lathe, f"{program}\nM30")
    found = [one.id for one in result.diagnostics]
    assert [number for number in numbers if number in found] == numbers


def test_programs_read_what_they_have_said_to_spindles(lathe: Path) -> None:
    """V.SPDL and V.SPDL_PROG: of the list, and the last words (language facts, section 8.3)."""
    names = "LOG_AX_NR.S PLC_CONTROL.S NBR_IN_CHANNEL LOG_AX_NR[0]".split()
    said = "SPEED.S MOVE_CMD.S POSITION.S MAX_SPEED.S CONST_CUT_SPEED.S DWELL_ROT_COUNT.S".split()
    formats = " ".join(["%f"] * (len(names) + len(said)))
    values = ", ".join([*(f"V.SPDL.{n}" for n in names), *(f"V.SPDL_PROG.{n}" for n in said)])
    head = "G18 G00 X50\nM19 S120 S.POS=45\nG196 S4000\nG96 S100 M04\nG04 S2.5\n"
    result = run(lathe, f'{head}#MSG ["{formats}", {values}]\nM30')
    assert result.state == "ended", result.diagnostics
    found = [float(value) for value in result.messages[0].text.split()]
    expected = [found[0], 0, 3, found[0], 100_000 / (2 * math.pi * 50), 4, 45, 4000, 100, 2.5]
    assert found == pytest.approx(expected, abs=1e-3)
    assert found[0] > 0


@pytest.mark.parametrize("name", ["V.SPDL.LOG_AX_NR.S9", "V.SPDL.LOG_AX_NR[7]"])
def test_an_unknown_spindle_is_an_error(name: str) -> None:
    """A name that no spindle of the channel has, or an index outside of them."""
    result = run(None, f"P1 = {name}\nM30")
    assert result.state == "error"


def test_data_of_spindles_is_read_only() -> None:
    """No program assigns to it."""
    assert run(None, "V.SPDL_PROG.SPEED.S = 5\nM30").state == "error"


def test_g51_halves_absolute_positions_of_the_face_axis(lathe: Path) -> None:
    """X100 is a diameter: the axis goes to 50 mm; relative ways and other axes are as written."""
    text = "N10 G18 G51 G00 X100 Z10\nN20 X80\nN30 G91 X-5 Z-1\nN40 G90 G52 X30\nN50 X40\nM30"
    result = run(lathe, text)
    assert result.state == "ended", result.diagnostics
    ends = {n: values_of(result, n, "X.ACS.ACT_POS", "Z.ACS.ACT_POS")[-1] for n in (30, 50)}
    assert values_of(result, 10, "X.ACS.ACT_POS")[-1][0] == pytest.approx(50.0, abs=0.1)
    assert values_of(result, 20, "X.ACS.ACT_POS")[-1][0] == pytest.approx(40.0, abs=0.1)
    assert ends[30] == pytest.approx((35.0, 9.0), abs=0.1)
    assert ends[50] == pytest.approx((40.0, 9.0), abs=0.1)


@pytest.mark.parametrize(
    ("absolute", "relative", "end"), [(1, 1, 25.0), (0, 0, 50.0), (1, 0, 30.0), (0, 1, 45.0)]
)
def test_the_list_says_what_is_a_diameter(
    absolute: int, relative: int, end: float, tmp_path: Path
) -> None:
    """P-AXIS-00058 for G90, P-AXIS-00059 for G91; neither: G51 has no effect, with a message."""
    machine = _lathe(tmp_path, absolute, relative)
    found = run(machine, "G18 G51\nG01 X40 F6000\nG91 X10\nM30")
    assert found.trace is not None
    assert found.trace["X.ACS.ACT_POS"][-1] == pytest.approx(end, abs=1e-9)
    assert [one.id for one in found.diagnostics] == ([] if absolute or relative else [901962])
    file = tmp_path / "far.nc"
    file.write_text("G18 G51\nG90 G00 X19000\nM30\n")
    errors = [] if absolute else [120002]
    checked = check_files([file], AssembledMachine(load_machine(machine)))
    found_ids = [one.diagnostic.id for one in checked.findings]
    assert [one for one in found_ids if one != 901962] == errors
    assert [one.id for one in Controller(machine).run(file, ticks=10).errors] == errors


def test_many_plain_blocks_know_diameters(lathe: Path) -> None:
    """What is decoded without a tree has them, too."""
    blocks = "".join(f"X{20 + number % 7}\n" for number in range(600))
    found = run(lathe, f"G18 G51 G01 F60000\n{blocks}X40\nM30")
    assert found.trace is not None
    assert max(found.trace["X.ACS.ACT_POS"]) == pytest.approx(20.0, abs=1e-9)


def test_g51_halves_the_centre_of_a_rotation(lathe: Path) -> None:
    """G68 turns about X = 10 mm, Z = 5 mm."""
    result = run(lathe, "N10 G18 G51\nG68 X20 Z5 R180\nN20 G01 X40 Z0 F6000\nM30")
    assert result.state == "ended", result.diagnostics
    assert values_of(result, 20, "X.ACS.ACT_POS", "Z.ACS.ACT_POS")[-1] == pytest.approx(
        (0.0, 10.0), abs=0.1
    )


def test_g51_does_nothing_without_a_face_axis() -> None:
    """The demo machine has none."""
    result = run(None, "N10 G51 G00 X100\nM30")
    assert values_of(result, 10, "X.ACS.ACT_POS")[-1][0] == pytest.approx(100.0, abs=0.1)


def test_the_main_spindle_does_not_change_under_g96(lathe: Path) -> None:
    """901871 (choice): the cutting speed is that of one spindle; after G97 another may follow."""
    begin = "N10 G18 G00 X50\nN20 G96 S100 M03\n"
    result = run(lathe, f"{begin}#MAIN SPINDLE [S2]\nM30")
    assert [found.id for found in result.diagnostics if found.severity is Severity.ERROR] == [
        901871
    ]
    result = run(lathe, f"{begin}N30 G97\n#MAIN SPINDLE [S2]\nN40 G96 S50 M03\nN50 G97\nM30")
    assert result.state == "ended", result.diagnostics
