# SPDX-License-Identifier: MIT
"""Single axes moved by the PLC: PLCopen's outputs and states, one owner at a time (MO-11, MO-13).

The demo machine: 500 mm/s, 4000 mm/s², trapezoid. What is called after tick n moves from tick n + 1
on; 10 mm from rest to rest take 100 ticks, with 5 mm after 50 of them.
"""

from __future__ import annotations

import itertools
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest
from support.insides import machine_of

import nctakt
from nctakt.base.failure import Failure
from nctakt.plc import (
    NEGATIVE,
    POSITIVE,
    MC_Halt,
    MC_MoveAbsolute,
    MC_MoveRelative,
    MC_MoveVelocity,
    MC_Reset,
    Plc,
    PlcError,
    load_plc,
)
from nctakt.plc.axes import AxisBlock
from nctakt.results.run import Run
from nctakt.run.controller import Controller, NcText
from nctakt.run.plcs.plc_view import PlcView

WAIT = "G04 X0.500\nM30"
STANDSTILL, DISCRETE, CONTINUOUS, STOPPING, ERROR_STOP, SYNCHRONIZED = 1, 2, 3, 4, 5, 6


def outputs(block: AxisBlock) -> str:
    """The outputs that are true, and the error."""
    names = ("busy", "active", "done", "in_velocity", "command_aborted")
    shown = [name for name in names if getattr(block, name, False)]
    return " ".join([*shown, *([f"error {block.error_id}"] if block.error else [])])


class Cell(Plc):
    """Calls blocks as a function says, and notes their outputs where they change."""

    def __init__(self, call: Callable[[PlcView], None], *blocks: AxisBlock) -> None:
        self.call = call
        self.blocks = blocks
        self.reported: list[list[tuple[int, str]]] = [[] for _ in blocks]

    def each_tick(self, hli: PlcView) -> None:
        """After each tick."""
        self.call(hli)
        for block, reported in zip(self.blocks, self.reported, strict=True):
            if not reported or reported[-1][1] != outputs(block):
                reported.append((hli.tick, outputs(block)))


def run(text: str, plc: Plc, *signals: str) -> Run:
    """Run a program with a PLC."""
    names = ["X.ACS.ACT_POS", "X.STATE", "A.ACS.ACT_POS", *signals]
    return Controller().run(NcText("p.nc", text), plc=plc, signals=names)


def column(run: Run, name: str) -> list[float]:
    """The values of a signal."""
    assert run.trace is not None
    return [float(value) for value in run.trace[name]]


def test_move_absolute_goes_to_its_target_and_is_done() -> None:
    """Busy at once, active from the tick that latches it, done after the one that arrives."""
    move = MC_MoveAbsolute("X")
    plc = Cell(lambda hli: move(hli, execute=True, position=10, velocity=500), move)
    made = run(WAIT, plc)
    assert plc.reported == [[(0, "busy"), (1, "busy active"), (100, "done")]]
    x, states = column(made, "X.ACS.ACT_POS"), column(made, "X.STATE")
    assert x[0] == 0.0
    assert x[1] == pytest.approx(0.002)
    assert x[50] == pytest.approx(5.0)
    assert x[100] == 10.0
    assert (states[0], states[1], states[99], states[100]) == (
        STANDSTILL,
        DISCRETE,
        DISCRETE,
        STANDSTILL,
    )


def test_outputs_fall_with_execute_but_last_for_one_call() -> None:
    """Execute is taken away while the axis moves: done shows for one call."""
    move = MC_MoveAbsolute("X")
    plc = Cell(lambda hli: move(hli, execute=hli.tick < 5, position=10, velocity=500), move)
    run(WAIT, plc)
    assert plc.reported == [[(0, "busy"), (1, "busy active"), (100, "done"), (101, "")]]


def test_move_relative_counts_from_the_command_position() -> None:
    """Executed twice: 10 mm each."""
    move = MC_MoveRelative("X")
    plc = Cell(
        lambda hli: move(hli, execute=hli.tick not in (150, 151), distance=10, velocity=500), move
    )
    x = column(run(WAIT, plc), "X.ACS.ACT_POS")
    assert plc.reported[0][:4] == [(0, "busy"), (1, "busy active"), (100, "done"), (150, "")]
    assert plc.reported[0][4:] == [(152, "busy"), (153, "busy active"), (252, "done")]
    assert x[252] == 20.0


def test_move_velocity_is_in_velocity_until_something_else_comes() -> None:
    """100 mm/s take 25 ticks; Halt brakes in 25 more and aborts the motion."""
    move, halt = MC_MoveVelocity("X"), MC_Halt("X")

    def call(hli: PlcView) -> None:
        move(hli, execute=True, velocity=100, direction=POSITIVE)
        halt(hli, execute=hli.tick >= 100)

    plc = Cell(call, move, halt)
    made = run(WAIT, plc)
    assert plc.reported[0] == [
        (0, "busy"),
        (1, "busy active"),
        (25, "busy active in_velocity"),
        (101, "command_aborted"),
    ]
    assert plc.reported[1] == [(0, ""), (100, "busy"), (101, "busy active"), (125, "done")]
    states = column(made, "X.STATE")
    assert [states[tick] for tick in (1, 100, 101, 124, 125)] == [
        CONTINUOUS,
        CONTINUOUS,
        STOPPING,
        STOPPING,
        STANDSTILL,
    ]
    assert column(made, "X.ACS.ACT_POS")[125] == pytest.approx(1.25 + 7.5 + 1.25)


def test_a_new_command_aborts_the_one_before() -> None:
    """Half way to 10 mm the axis is sent back: no step in speed, the first block is aborted."""
    there, back = MC_MoveAbsolute("X"), MC_MoveAbsolute("X")

    def call(hli: PlcView) -> None:
        there(hli, execute=True, position=10, velocity=500)
        back(hli, execute=hli.tick >= 50, position=0, velocity=500)

    plc = Cell(call, there, back)
    x = column(run(WAIT, plc), "X.ACS.ACT_POS")
    assert plc.reported[0] == [(0, "busy"), (1, "busy active"), (51, "command_aborted")]
    assert plc.reported[1][:3] == [(0, ""), (50, "busy"), (51, "busy active")]
    assert plc.reported[1][3][1] == "done"
    assert max(x) == pytest.approx(10.0)  # 200 mm/s need 5 mm to stop
    assert x[-1] == 0.0


def test_a_buffered_command_waits_for_the_end_of_the_one_before() -> None:
    """Busy at once, active when the first one has arrived."""
    first, second = MC_MoveAbsolute("X"), MC_MoveRelative("X")

    def call(hli: PlcView) -> None:
        first(hli, execute=True, position=10, velocity=500)
        second(hli, execute=hli.tick >= 10, distance=10, velocity=500, buffered=True)

    plc = Cell(call, first, second)
    x = column(run(WAIT, plc), "X.ACS.ACT_POS")
    assert plc.reported[0][-1] == (100, "done")
    assert plc.reported[1] == [(0, ""), (10, "busy"), (100, "busy active"), (200, "done")]
    assert x[200] == 20.0


def test_a_modulo_axis_goes_in_the_wanted_direction() -> None:
    """From 0 to 350° backward: 10° in 2·sqrt(10/4000) s, as MO-14 has it."""
    move = MC_MoveAbsolute("A")
    plc = Cell(
        lambda hli: move(hli, execute=True, position=350, velocity=360, direction=NEGATIVE), move
    )
    a = column(run(WAIT, plc), "A.ACS.ACT_POS")
    assert plc.reported[0][-1] == (100, "done")
    assert a[100] == pytest.approx(350.0)


def test_an_endless_motion_ends_in_error_at_its_software_limit() -> None:
    """1702, ErrorStop; further commands are refused (60213) until RESET clears it."""
    endless, further = MC_MoveVelocity("X"), MC_MoveAbsolute("X")

    def call(hli: PlcView) -> None:
        endless(hli, execute=True, velocity=500, direction=POSITIVE)
        further(hli, execute=endless.error, position=0, velocity=500)

    plc = Cell(call, endless, further)
    made = run("G04 X21\nM30", plc)
    assert plc.reported[0][-1][1] == "error 1702"
    assert plc.reported[1][-1][1] == "error 60213"
    assert column(made, "X.STATE")[-1] == ERROR_STOP
    assert column(made, "X.ACS.ACT_POS")[-1] == 10_000.0


@pytest.mark.parametrize(
    ("axis", "position", "number"), [("X", 10_001.0, 60158), ("Y", -10_001.0, 60159)]
)
def test_a_target_beyond_the_software_limits_is_refused(
    axis: str, position: float, number: int
) -> None:
    """In the tick that latches it; nothing moves."""
    move = MC_MoveAbsolute(axis)
    plc = Cell(lambda hli: move(hli, execute=True, position=position, velocity=500), move)
    run(WAIT, plc)
    assert plc.reported == [[(0, "busy"), (1, f"error {number}")]]


def test_an_axis_that_the_path_moves_is_refused() -> None:
    """50603 while the block moves it; the path continues as if nothing had been asked (MO-13)."""
    move = MC_MoveAbsolute("X")
    plc = Cell(lambda hli: move(hli, execute=hli.tick >= 20, position=3, velocity=500), move)
    made = run("G00 X10\nM30", plc)
    assert plc.reported == [[(0, ""), (20, "busy"), (21, "error 50603")]]
    assert made.errors == ()
    assert column(made, "X.ACS.ACT_POS")[99] == 10.0
    assert column(made, "X.STATE")[50] == SYNCHRONIZED


def test_a_block_that_moves_an_axis_of_the_plc_is_an_error() -> None:
    """50766: the path never takes over an axis that moves; the PLC's motion goes on (MO-13)."""
    move = MC_MoveAbsolute("X")
    plc = Cell(lambda hli: move(hli, execute=True, position=10, velocity=500), move)
    made = run("G04 X0.050\nN20 G00 X5\nM30", plc)
    assert [found.id for found in made.errors] == [50766]
    assert plc.reported == [[(0, "busy"), (1, "busy active"), (100, "done")]]
    x = column(made, "X.ACS.ACT_POS")
    assert all(after - before <= 0.5 for before, after in itertools.pairwise(x))


@pytest.mark.parametrize(("begin", "number"), [(50, 900420), (300, 50766)])
def test_the_path_brakes_where_it_cannot_take_the_next_block(begin: int, number: int) -> None:
    """MO-1, MO-6: X passes its corner with speed, and brakes with its 4000 mm/s² after it.

    Z sets off in tick 51 or 301, while the block does not move it: when X comes to the corner, Z is
    elsewhere, or still moves. Z goes where the PLC sends it.
    """
    move = MC_MoveAbsolute("Z")
    plc = Cell(lambda hli: move(hli, execute=hli.tick >= begin, position=5, velocity=500), move)
    made = run("G01 F6000 X30\nX60 Z1\nX90\nM30", plc, "Z.ACS.ACT_POS", "PATH.SPEED")
    assert [found.id for found in made.errors] == [number]
    x = column(made, "X.ACS.ACT_POS")
    steps = [after - before for before, after in itertools.pairwise([0.0, *x])]
    changes = [abs(after - before) for before, after in itertools.pairwise([0.0, *steps])]
    assert max(changes) == pytest.approx(0.004)
    assert 30.0 < x[-1] < 31.0
    assert column(made, "PATH.SPEED")[-1] == 0.0
    assert column(made, "Z.ACS.ACT_POS")[-1] == 5.0


def test_other_axes_stay_the_paths() -> None:
    """The PLC moves Y while the program moves X: neither notices the other."""
    move = MC_MoveAbsolute("Y")
    plc = Cell(lambda hli: move(hli, execute=True, position=10, velocity=500), move)
    made = run("G00 X20\nM30", plc, "Y.ACS.ACT_POS")
    assert made.state == "ended"
    assert plc.reported[0][-1] == (100, "done")
    assert column(made, "Y.ACS.ACT_POS")[100] == 10.0
    assert column(made, "X.ACS.ACT_POS")[-1] == 20.0


def test_a_reset_aborts_what_the_plc_moves() -> None:
    """RESET brakes the axis: command aborted (RC-007)."""
    move = MC_MoveVelocity("X")

    def call(hli: PlcView) -> None:
        move(hli, execute=True, velocity=100)
        if hli.tick == 50:
            hli.reset()

    plc = Cell(call, move)
    run(WAIT, plc)
    assert plc.reported[0][-1] == (51, "command_aborted")


def test_during_a_reset_an_axis_takes_no_command() -> None:
    """RC-007, 900810: X brakes from 100 mm/s for 25 ticks; an endless motion would never end it."""
    first, again, later = MC_MoveVelocity("X"), MC_MoveVelocity("X"), MC_MoveAbsolute("Y")

    def call(hli: PlcView) -> None:
        first(hli, execute=True, velocity=100)
        if hli.tick == 50:
            hli.reset()
        again(hli, execute=hli.tick >= 55, velocity=100)
        later(hli, execute=hli.tick >= 80, position=1, velocity=500)

    plc = Cell(call, first, again, later)
    made = Controller().run(NcText("p.nc", WAIT), plc=plc, after="200 ms")
    assert plc.reported[1] == [(0, ""), (55, "busy"), (56, "error 900810")]
    assert made.state == "reset"
    assert made.ticks == 276


def test_reset_leaves_error_stop() -> None:
    """1702 at the limit; MC_Reset is done with its tick, and X takes commands again.

    0.1 mm take 2·√(0.1/4000) s, 10 ticks. The channel keeps the error until its RESET.
    """
    endless, reset, back = MC_MoveVelocity("X"), MC_Reset("X"), MC_MoveAbsolute("X")

    def call(hli: PlcView) -> None:
        if hli.tick == 0:
            hli.start()
        endless(hli, execute=True, velocity=500, direction=POSITIVE)
        reset(hli, execute=endless.error)
        back(hli, execute=reset.done, position=9999.9, velocity=500)

    plc = Cell(call, endless, reset, back)
    text = NcText("p.nc", "G04 X30\nM30")
    made = Controller().run(text, plc=plc, wait_for_start=True, ticks=20_200)
    (tick, shown) = plc.reported[1][-1]
    assert shown == "done"
    assert plc.reported[1][-2:] == [(tick - 1, "busy"), (tick, "done")]
    assert plc.reported[2][-3:] == [(tick, "busy"), (tick + 1, "busy active"), (tick + 10, "done")]
    assert [found.id for found in made.errors] == [1702]
    assert made.state == "error"
    assert column(made, "X.ACS.ACT_POS")[-1] == 9999.9


@pytest.mark.parametrize("block", [MC_MoveAbsolute, MC_MoveVelocity, MC_Halt, MC_Reset])
def test_an_axis_without_single_axis_interface_is_refused(
    block: type[AxisBlock], tmp_path: Path
) -> None:
    """50966: P-AXIS-00457 is not set, whatever the PLC asks for; nothing moves."""
    shutil.copytree(Path(nctakt.__file__).parent / "machines" / "demo", tmp_path / "machine")
    for file in (tmp_path / "machine").glob("*.lis"):
        text = file.read_text("utf-8").replace("enable_single_axis", "# enable_single_axis")
        lines = (line for line in text.splitlines() if "# enable_single_axis" not in line)
        file.write_text("\n".join([*lines, ""]), "utf-8")
    used = block("X")
    inputs = {
        MC_MoveAbsolute: {"position": 10, "velocity": 100},
        MC_MoveVelocity: {"velocity": 100},
    }.get(block, {})
    plc = Cell(lambda hli: used(hli, execute=True, **inputs), used)  # type: ignore[operator]
    made = Controller(tmp_path / "machine").run(NcText("p.nc", WAIT), plc=plc)
    assert plc.reported == [[(0, "busy"), (1, "error 50966")]]
    assert made.state == "ended"


def test_reset_of_an_axis_without_an_error_is_done() -> None:
    """PLCopen: no effect."""
    reset = MC_Reset("X")
    plc = Cell(lambda hli: reset(hli, execute=True), reset)
    made = run(WAIT, plc)
    assert plc.reported == [[(0, "busy"), (1, "done")]]
    assert set(column(made, "X.STATE")) == {STANDSTILL}


def test_a_run_waits_for_the_motions_of_the_plc() -> None:
    """After M30 until they are at rest, as for those of cycles (RC-006)."""
    move = MC_MoveAbsolute("X")
    plc = Cell(lambda hli: move(hli, execute=True, position=10, velocity=500), move)
    made = run("G04 X0.010\nM30", plc)
    assert made.ticks >= 100
    assert column(made, "X.ACS.ACT_POS")[-1] == 10.0


@pytest.mark.parametrize(
    ("call", "number"),
    [
        ("MC_MoveAbsolute('XX')(hli, execute=True, position=1, velocity=1)", 900656),
        ("MC_MoveAbsolute('X')(hli, execute=True, position=1, velocity=0)", 900657),
        ("MC_MoveAbsolute('X')(hli, execute=True, position=float('nan'), velocity=1)", 900657),
        ("MC_MoveVelocity('X')(hli, execute=True, velocity=-5)", 900657),
    ],
)
def test_what_cannot_be_commanded_is_a_diagnostic(tmp_path: Path, call: str, number: int) -> None:
    """With the line of the user's file."""
    text = "from nctakt.plc import *\n\nclass Cell(Plc):\n    def each_tick(self, hli):\n"
    text += f"        {call}\n"
    (tmp_path / "plc.py").write_text(text, "utf-8")
    with pytest.raises(PlcError) as caught:
        run(WAIT, load_plc(tmp_path / "plc.py"))  # type: ignore[arg-type]
    assert [found.id for found in caught.value.diagnostics] == [900523, number]


def test_more_commands_in_a_tick_than_there_is_room() -> None:
    """256 fit; the 257th is refused by name (900658)."""

    def call(hli: PlcView) -> None:
        for _ in range(257):
            MC_Halt("X")(hli, execute=True)

    with pytest.raises(Failure) as caught:
        run(WAIT, Cell(call))
    assert caught.value.diagnostics[0].id == 900658


def test_the_plc_and_a_cycle_take_an_axis_from_each_other() -> None:
    """A cycle (owner 1) sends X back in tick 50, the PLC takes it again: each aborts the other."""
    there, again = MC_MoveAbsolute("X"), MC_MoveAbsolute("X")
    controller = Controller()

    def call(hli: PlcView) -> None:
        there(hli, execute=True, position=10, velocity=500)
        again(hli, execute=hli.tick >= 80, position=20, velocity=500)
        if hli.tick == 49:
            assert machine_of(controller).single_axes.absolute(0, 0.0, 500.0, 0, 2, 1) == 0

    plc = Cell(call, there, again)
    made = controller.run(NcText("p.nc", WAIT), plc=plc, signals=["X.ACS.ACT_POS"])
    assert made.state == "ended"
    assert plc.reported[0] == [(0, "busy"), (1, "busy active"), (50, "command_aborted")]
    assert [reported for _, reported in plc.reported[1]] == ["", "busy", "busy active", "done"]
    x = column(made, "X.ACS.ACT_POS")
    assert all(abs(after - before) <= 0.5 for before, after in itertools.pairwise(x))
    assert x[-1] == 20.0
