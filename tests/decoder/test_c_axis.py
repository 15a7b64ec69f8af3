# SPDX-License-Identifier: MIT
"""``#CAX``: the main spindle as an axis of the path (language: 1.6, TU 208121867)."""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np
import pytest
from support.insides import machine_of

from nctakt import machines
from nctakt.base.diagnostics import Severity
from nctakt.lists.machine.machine import Machine, load_machine
from nctakt.results.run import Run
from nctakt.run.controller import Controller, NcText
from nctakt.run.realtime.snapshot import Snapshot

SIGNALS = ["X.ACS.ACT_POS", "S.SPEED", "S.POSITION", "BLOCK"]
LISTS = """
default_ax_name_of_spindle C
cax_face_id 1
trafo[0].id 13
trafo[1].id 15
Ende
"""


@pytest.fixture(scope="module")
def lathe(tmp_path_factory: pytest.TempPathFactory) -> Machine:
    """The demo machine with a main spindle of the mode 0x204, and both planes."""
    folder = tmp_path_factory.mktemp("lathe") / "machine"
    shutil.copytree(Path(machines.__path__[0]) / "demo", folder)
    spindle, channel = folder / "achs_mds5.lis", folder / "sda_mds1.lis"
    spindle.write_text(spindle.read_text("utf-8").replace("0x4 ", "0x204 "), "utf-8")
    listed = channel.read_text("utf-8").replace("Ende\n", "").replace("Ende", "")
    channel.write_text(listed + LISTS, "utf-8")
    return load_machine(folder)


def run_of(machine: Machine, *lines: str) -> Run:
    text = "\n".join([*lines, "M30"])
    return Controller(machine).run(NcText("t.nc", text), ticks=60_000, signals=SIGNALS)


def problems(run: Run) -> list[int]:
    return [one.id for one in run.diagnostics if one.severity is not Severity.NOTE]


def column(run: Run, name: str) -> np.ndarray:
    assert run.trace is not None
    return np.asarray(run.trace[name])


def test_the_spindle_stops_and_turns_with_the_path(lathe: Machine) -> None:
    """The tool stays on the programmed line of the face, by X and the angle of the spindle."""
    run = run_of(
        lathe,
        "N10 M3 S600",
        "N20 G00 X60",
        "N30 #CAX [S, C]",
        "N40 G01 C0 F20000",
        "N50 #FACE [X, C]",
        "N60 G01 X40 C-30 F3000",
        "N70 X-40",
        "N80 #FACE OFF",
        "N90 #CAX OFF",
        "N100 M4 S300",
        "N110 G04 X0.2",
    )
    assert problems(run) == []
    speed, blocks = column(run, "S.SPEED"), column(run, "BLOCK")
    assert speed[blocks == 20][-1] == 600.0
    angle = np.radians(column(run, "S.POSITION"))
    radius = column(run, "X.ACS.ACT_POS")
    points = np.column_stack([radius * np.cos(angle), radius * np.sin(angle)])[blocks == 70][:-1]
    assert np.abs(points[:, 1] + 30.0).max() < 1e-9
    assert points[0, 0] > 39.0
    assert points[-1, 0] < -39.0
    turned = np.diff(np.unwrap(column(run, "S.POSITION")[blocks == 70], period=360.0))
    shown = speed[blocks == 70][1:] * 6.0 * 0.001
    assert np.abs(turned - shown).max() < 1e-9
    assert speed[-1] == -300.0


def test_the_axis_begins_at_the_angle_of_the_spindle(lathe: Machine) -> None:
    run = run_of(lathe, "S[M19 REV100 POS90]", "#CAX", "G01 C91 F600")
    assert problems(run) == []
    assert column(run, "S.POSITION")[-1] == 91.0
    times = (column(run, "S.POSITION") > 90.0).sum()
    assert 100 <= times < 115  # 1° at 10°/s


@pytest.mark.parametrize(
    ("line", "number"),
    [
        ("#CAX [S2, C]", 21175),
        ("#CAX [S9, C]", 21175),
        ("#CAX [S, C, X]", 900233),
        ("#CAX OFF [C]", 900233),
        ("#CAX [S, K]", 901804),
        ("#CAX [A]", 901803),
        ("#CAX\nM3 S100", 901818),
        ("#CAX\nM5", 901818),
        ("#CAX\nG63 Z10 F100 S100", 901818),
        ("#CAX\nG96 S100", 901818),
        ("#CAX\n#RT CYCLE [ID=1]\nS[M3 REV100]\n#RT CYCLE END", 901818),
        ("#CAX\n#FACE [X, C]\n#CAX OFF", 20893),
        ("#CAX\n#CYL [Z, C, X60]\n#CAX OFF", 20893),
        ("#CS ON [1,2,3,0,0,0]\n#CAX", 901806),
        ("#CAX\n#CAX OFF\nG01 C10 F1000", 901800),
        ("#CAX\n#CAX [S, B]", 901803),
        ("#MAIN SPINDLE [S2]\n#CAX [C]", 901872),
    ],
)
def test_what_is_refused(lathe: Machine, line: str, number: int) -> None:
    assert problems(run_of(lathe, line)) == [number]


def test_what_changes_nothing(lathe: Machine) -> None:
    assert problems(run_of(lathe, "#CAX OFF", "#CAX [C]", "#CAX [S, C]", "G01 C9 F999")) == []


def test_another_main_spindle_turns_beside_the_c_axis(lathe: Machine) -> None:
    """ID 21980: after #CAX, #MAIN SPINDLE gives G95 a spindle again; S1 is the axis C."""
    lines = ("#CAX [S1, C]", "#MAIN SPINDLE [S2]", "M3 S600", "G04 X2", "G95 F0.1", "G01 X1 C5")
    assert problems(run_of(lathe, *lines)) == []
    assert problems(run_of(lathe, *lines, "S1[M3 REV100]")) == [901818]


def test_a_spindle_without_the_mode_cannot_be_an_axis() -> None:
    """P-AXIS-00015 without 0x200, as the demo machine has it."""
    run = Controller().run(NcText("t.nc", "#CAX [S, C]\nM30"), ticks=10)
    assert [one.id for one in run.diagnostics] == [20886]


def test_the_next_program_has_the_spindle_again(lathe: Machine) -> None:
    controller = Controller(lathe)
    first = controller.run(NcText("a.nc", "#CAX\nG01 C10 F6000\nM30"), ticks=2000, signals=SIGNALS)
    assert column(first, "S.POSITION")[-1] == 10.0
    second = controller.run(NcText("b.nc", "M3 S60\nG04 X0.1\nM30"), ticks=2000, signals=SIGNALS)
    assert problems(second) == []
    assert column(second, "S.SPEED")[-1] == 60.0


def test_a_snapshot_has_the_spindle_as_it_was(lathe: Machine) -> None:
    controller = Controller(lathe)
    part = machine_of(controller).realtime
    snapshot = Snapshot(part)
    controller.run(NcText("a.nc", "#CAX\nG01 C10 F6000\nM30"), ticks=2000)
    assert part.channels[0].exchange.c_axis.is_active
    snapshot.put_back()
    assert not part.channels[0].exchange.c_axis.is_active
