# SPDX-License-Identifier: MIT
"""What is decided about backward motion on the path (MO-7): docs/conformance/backward.md."""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np
import pytest
from support.decided import numbers

import nctakt
from nctakt.base.failure import Failure
from nctakt.decoder.axis_limits import history_blocks
from nctakt.lists.declared.startup import MAX_BACKWARD_MEMORY, MIN_BACKWARD_MEMORY
from nctakt.lists.machine.machine import load_machine
from nctakt.results.run import Run
from nctakt.run.access.stimuli import Stimulus
from nctakt.run.controller import Controller, NcText
from nctakt.run.plcs.plc_view import PlcView
from nctakt.run.realtime.assembly import AssembledMachine

SIGNALS = ("X.ACS.ACT_POS", "Y.ACS.ACT_POS", "BLOCK", "HLI.RETRACE")


def with_memory(folder: Path, size: int) -> Path:
    """The demo machine with this much memory for backward motion."""
    machine = folder / "machine"
    shutil.copytree(Path(nctakt.__file__).parent / "machines" / "demo", machine)
    startup = machine / "hochlauf.lis"
    lines = startup.read_text("utf-8").splitlines()
    kept = [line for line in lines if not line.startswith("fb_storage_size")]
    startup.write_text("\n".join([f"fb_storage_size[0] {size}", *kept, ""]), "utf-8")
    return machine


def perform(
    text: str, *changes: tuple[int, float], machine: Path | None = None, **others: float
) -> Run:
    """A run with backward motion switched at these ticks, and other values of ``name=tick``."""
    stimuli = [Stimulus(f"{tick} ms", "HLI.BACKWARD_MOTION", value) for tick, value in changes]
    stimuli += [Stimulus(f"{int(tick)} ms", f"HLI.{name}", 1.0) for name, tick in others.items()]
    run = Controller(machine).run(NcText("p.nc", text), signals=SIGNALS, at=stimuli, ticks=3000)
    assert run.trace is not None
    return run


def reported(run: Run, *kinds: str) -> list[tuple[int, str]]:
    """The events of these kinds, else of the walk."""
    assert run.trace is not None
    return [(one.tick, str(one)) for one in run.trace.events if one.kind in (kinds or "retrace")]


def at(run: Run, tick: int, name: str = "X.ACS.ACT_POS") -> float:
    """A value after a tick."""
    assert run.trace is not None
    return float(run.trace.at(tick, name))


def test_without_memory_the_path_goes_on_and_the_operator_is_warned(tmp_path: Path) -> None:
    """P-STUP-00033 0, the default: 50453 once for each command, and no change of the motion."""
    machine = with_memory(tmp_path, 0)
    run = perform("G00 X10\nM30", (20, 1.0), (30, 0.0), (40, 1.0), machine=machine)
    assert run.state == "ended"
    assert run.ticks == 101
    assert numbers(run) == [50453, 50453]
    with pytest.raises(Failure, match="50453"):
        Controller(machine).backward()


def test_a_program_that_begins_while_backward_is_commanded_waits_and_says_so() -> None:
    """There is nothing before its first block: 50449 once, then it waits until forward (MO-7)."""
    run = perform("N10 G00 X10\nM30", (0, 1.0), (200, 0.0))
    assert run.state == "ended"
    assert numbers(run) == [50449]
    assert run.diagnostics[0].span is not None
    assert run.diagnostics[0].span.line == 1
    assert at(run, 200) > 0.0 == at(run, 199)


def test_too_little_memory_is_raised_and_said(tmp_path: Path) -> None:
    """P-STUP-00033 below the least size: warning 50450, with the number of blocks that fit."""
    machine = with_memory(tmp_path, 1)
    assert [one.message.id for one in load_machine(machine).diagnostics] == [50450]
    controller = Controller(machine)
    assert controller.hli.history_size == history_blocks(MIN_BACKWARD_MEMORY, 4)
    assert Controller().hli.history_size == history_blocks(0x200000, 4)


def test_memory_beyond_reason_is_limited_and_a_check_takes_none(tmp_path: Path) -> None:
    """P-STUP-00033 of 2 GB: warning 902027, and as many blocks as fit into 64 MiB."""
    machine = load_machine(with_memory(tmp_path, 2147483647))
    assert [one.message.id for one in machine.diagnostics] == [902027]
    assert machine.channels[0].startup.backward_memory_bytes == MAX_BACKWARD_MEMORY == 64 << 20
    checked = AssembledMachine(machine, has_history=False)
    assert checked.channels[0].path.history_size == 0


def test_the_oldest_blocks_are_forgotten(tmp_path: Path) -> None:
    """A full history: the path goes back this many blocks and the part of the current one."""
    machine = with_memory(tmp_path, MIN_BACKWARD_MEMORY)
    size = Controller(machine).hli.history_size
    blocks = "\n".join(f"N{i} G01 X{i} F6000" for i in range(1, 101))
    run = perform(f"{blocks}\nM30", (703, 1.0), machine=machine)
    assert run.state == "limit"
    assert reported(run)[-1][1] == "retrace start"
    begun = reported(run)[0][0]
    assert at(run, begun, "BLOCK") == 71
    assert at(run, 2999) == 70 - size


def test_the_api_commands_it_too() -> None:
    """``Controller.backward`` and ``forward``, counted from the next tick on."""
    controller = Controller()
    controller.start(NcText("p.nc", "G00 X10\nM30"))
    controller.step(50)
    controller.backward()
    controller.step(100)
    assert controller.hli.retrace == "backward"
    assert controller.hli.backward_motion
    controller.step(200)
    assert controller.read("V.RTA.ACS.ACT_POS.X") == 0.0
    controller.forward()
    controller.step(101)
    assert controller.read("V.RTA.ACS.ACT_POS.X") == 10.0
    assert controller.state == "ready"


def test_dwells_are_passed_over_and_the_one_at_the_front_goes_on() -> None:
    """G04 has no way: back over it at once; what is left of the current one is waited for."""
    text = "G00 X10\nG04 0.1\nG00 X20\nG04 0.2\nG00 X30\nM30"
    run = perform(text, (350, 1.0), (450, 0.0))
    assert at(run, 350) == pytest.approx(
        19.998
    )  # the first dwell: ticks 100 … 199, the second from 300 on
    assert at(run, 449) == 10.0
    assert reported(run) == [
        (350, "retrace backward"),
        (450, "retrace forward"),
        (549, "retrace front"),
    ]
    assert run.ticks == 550 + 150 + 100 + 1


def test_a_function_that_waits_is_waited_for_again() -> None:
    """The path goes back while M101 waits for the PLC, and forth again; it is not repeated."""
    plc = 500
    run = perform("G00 X10\nM101\nG00 X20\nM30", (150, 1.0), (300, 0.0), PLC_PRESENT=plc)
    assert [text for _, text in reported(run, "output")] == ["output M 101"]
    assert run.state == "ended"


def test_the_history_starts_where_an_axis_was_moved_otherwise() -> None:
    """A realtime cycle moves Y between two blocks of Y: the walk ends at the second one."""
    text = (
        "#RT CYCLE DEF [ID = 1 SCOPE = PROG]\nY[INDP G90 POS=5 G00]\n#RT CYCLE END\n"
        "G00 X10\nG00 Y1\n#RT CYCLE START [ID = 1]\nG04 0.2\n#RT CYCLE DELETE [ID = 1]\n"
        "N10 G00 Y10\nN20 G00 X20\nM30"
    )
    run = perform(text, (450, 1.0))
    assert run.state == "limit"
    assert reported(run)[-1][1] == "retrace start"
    assert (at(run, 2999), at(run, 2999, "Y.ACS.ACT_POS")) == (10.0, 5.0)


def test_the_walk_stops_before_a_block_whose_axis_moves_on_its_own() -> None:
    """A cycle has an axis of the block before: that block cannot be walked back (MO-13)."""
    text = (
        "N10 G00 Y10\n#RT CYCLE [ID = 1 SCOPE = PROG]\n"
        "$IF ONCE V.RTA.ACS.ACT_POS.X > 1\nY[INDP G90 POS=0 G01 FEED=60]\n$ENDIF\n#RT CYCLE END\n"
        "N20 G00 X10\nM30"
    )
    run = perform(text, (180, 1.0))
    assert reported(run)[-1][1] == "retrace start"
    assert at(run, 1000) == 0.0
    assert at(run, 2999, "BLOCK") == 20


@pytest.mark.parametrize("slope", ["", "#SLOPE [TYPE=TRAPEZ]\n"])
@pytest.mark.parametrize(("x", "found"), [(26.0, []), (20.1, [50766])])
def test_an_axis_that_is_taken_before_its_block_does_not_stop_the_walk_in_a_step(
    x: float, found: list[int], slope: str
) -> None:
    """MO-1, MO-7, MO-13: braking from 100 mm/s takes 1.25 mm, with a limit of the jerk some more.

    On the way back a cycle takes Y, which N10 moves up to X20: at X26 the walk brakes to a
    standstill at that border, as at the start of the history; at X20.1 it cannot, brakes beyond it
    with X alone, and the channel is in error state. X keeps its acceleration, 4 mm/s a tick.
    """
    text = (
        f"#RT CYCLE [ID=1 SCOPE=PROG]\n$IF ONCE V.E.VALUE > 0 && V.RTA.ACS.ACT_POS.X < {x}\n"
        f"Y[INDP G90 POS=5 G01 FEED=60]\n$ENDIF\n#RT CYCLE END\n{slope}"
        "N10 G01 X20 Y0.02 F6000\nN20 G01 X60\nM30"
    )
    stimuli = [
        Stimulus("500 ms", "HLI.BACKWARD_MOTION", 1.0),
        Stimulus("500 ms", "V.E.VALUE", 1.0),
    ]
    run = Controller().run(NcText("p.nc", text), signals=SIGNALS, at=stimuli, ticks=2000)
    assert [number for number in numbers(run) if number != 900820] == found
    assert run.trace is not None
    path = np.asarray(run.trace["X.ACS.ACT_POS"])
    assert np.abs(np.diff(path, 2)).max() <= 0.004 + 1e-9
    if found:
        assert 18.0 < path[-1] < 20.0
    else:
        assert (path[-1], reported(run)[-1][1]) == (20.0, "retrace start")


def test_an_axis_that_moves_when_the_path_wants_it_again_stops_the_channel() -> None:
    """Forward the walk comes to a block whose axis a cycle has got meanwhile: 50766 (MO-13)."""
    text = (
        "N10 G00 Y10\n#RT CYCLE [ID = 1 SCOPE = PROG]\n"
        "$IF ONCE V.RTA.ACS.ACT_POS.Y < 5\nX[INDP G90 POS=-5 G01 FEED=60]\n$ENDIF\n#RT CYCLE END\n"
        "N20 G00 X10\nM30"
    )
    run = perform(text, (180, 1.0), (500, 0.0))
    assert run.state == "error"
    assert numbers(run) == [50766]
    assert run.diagnostics[0].span is not None
    assert run.diagnostics[0].span.line == 7


def test_the_history_ends_with_the_program_and_with_a_reset() -> None:
    """M30 and reset: nothing before them is walked back."""
    controller = Controller()
    controller.run(NcText("p.nc", "G00 X10\nM30"))
    assert controller.hli.history == 0
    controller.start(NcText("q.nc", "G00 X20\nM30"))
    controller.step(50)
    assert controller.hli.history == 1
    controller.reset()
    assert controller.hli.history == 0


def test_single_block_stops_the_walk_after_each_block() -> None:
    """Single block stops between the blocks of the walk as well; START goes on (MO-6)."""
    run = perform("N10 G01 X10 F6000\nN20 X20\nN30 X30\nM30", (250, 1.0), SINGLE_BLOCK=240)
    paused = reported(run, "paused")
    assert [text for _, text in paused] == ["paused line 2"]
    assert at(run, 2999) == 20.0


def test_reset_error_and_hold_stop_on_the_way_back() -> None:
    """MO-6: feed hold brakes on the path; a reset drops the rest where the axes are at rest."""
    run = perform("N10 G01 X100 F6000\nM30", (500, 1.0), FEED_HOLD=700)
    begun = reported(run)[0][0]
    held = at(run, 1500)
    assert begun == 525
    assert held == at(run, 2999) > 0.0
    controller = Controller()
    controller.start(NcText("p.nc", "N10 G01 X100 F6000\nM30"))
    controller.step(500)
    controller.backward()
    controller.step(200)
    controller.reset()
    assert controller.hli.retrace == "front"
    assert 0.0 < float(controller.read("V.RTA.ACS.ACT_POS.X")) < 50.0


def test_a_program_may_clear_the_history() -> None:
    """``#BACKWARD STORAGE CLEAR`` between two blocks that the path passes: no way back over it."""
    run = perform("N10 G01 X10 F6000\n#BACKWARD STORAGE CLEAR\nN20 X20\nM30", (150, 1.0))
    assert run.state == "limit"
    assert reported(run)[-1][1] == "retrace start"
    assert at(run, 149) == pytest.approx(13.75)  # N10 was passed without a stop
    assert at(run, 2999) == 10.0


@pytest.mark.parametrize(
    ("backward", "lines"),
    [(False, [5, 6, 7, 8, 9]), (True, [6, 5, 4, 5, 6, 8, 9])],
)
def test_the_way_around_a_corner_is_no_block_of_its_own(backward: bool, lines: list[int]) -> None:
    """MO-6, MO-9: single block stops after the arc that belongs to a block, there and back."""
    contour = "G01 F6000\nV.G.WZ_AKT.R = 5 G26\nG41 X20 Y20\nX20 Y60\nX60\nY20\nX20\nG40 X0 Y0\nM30"
    contour = contour.replace("5 G26", "5\nG26")

    class Operator:
        def cycle(self, hli: PlcView) -> None:
            hli.backward_motion = backward and 1500 <= hli.tick < 5000
            hli.single_block = not backward or hli.tick >= 1500
            if hli.is_paused:
                hli.start()

    run = Controller().run(NcText("p.nc", contour), ticks=20_000, plc=Operator())
    assert run.state == "ended"
    assert [text for _, text in reported(run, "paused")] == [
        f"paused line {line}" for line in lines
    ]


@pytest.mark.parametrize("ticks", [750, 1300])
def test_a_reset_ends_a_block_with_all_its_pieces(ticks: int) -> None:
    """MO-6: single block stops in the next program, whose first block goes on with nothing."""
    controller = Controller()
    contour = "G01 F6000\nV.G.WZ_AKT.R = 5\nG26\nG41 X20 Y20\nX20 Y60\nX60\nY20\nG40 X0\nM30"
    controller.start(NcText("p.nc", contour))
    controller.step(ticks)
    controller.reset()
    controller.hli.single_block = True
    controller.start(NcText("p.nc", "M100\nM101\nG01 F6000 X30\nM30"))
    controller.step(20)
    assert controller.hli.is_paused
