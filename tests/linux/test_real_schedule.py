# SPDX-License-Identifier: MIT
"""A controller whose own threads run by a scheduling list on a real clock (docs/schedule.md).

Nothing here depends on how fast this machine is: what the clock decides is an input, and the
recording of a run repeats it.
"""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip(
    "nctakt.schedule.real.processes", reason="a schedule runs for real on Linux only"
)

from nctakt import Controller, Failure, NcText, open_schedule
from nctakt.base.diagnostics import Diagnostic
from nctakt.files.access import FileAccess
from nctakt.hli.plc_entries import TechnologyEntry
from nctakt.lists.machine.machine import load_machine
from nctakt.messages.scheduling.linux_run import SCHED_FIFO_NOT_PERMITTED
from nctakt.results.run import ProgramMessage
from nctakt.run.access.inputs import DECODED, LOST, OVERFLOWED, SCHEDULE, Cells, Input, unpack
from nctakt.run.access.tape import Tape, read_tape
from nctakt.run.options import RunKeywords, completed
from nctakt.run.plcs.plc_view import PlcView
from nctakt.run.program_run import ProgramRun
from nctakt.run.realtime.assembly import AssembledMachine
from nctakt.run.scheduled.real_schedule import RealSchedule, _plan
from nctakt.run.scheduled.scheduled_run import scheduled
from nctakt.run.tick_loop import TickLoop
from nctakt.session.session import Session
from nctakt.session.setup import Setup

pytestmark = pytest.mark.slow

LIST = """\
interrupt_source 2 # 1: Hardware ISR 2: Real-time operating system timer
cycle_time 2000
time_slice 500
windows_time {windows}
schedule STANDARD
external_thread[0].cycle 4000
external_thread[0].semaphore_name {semaphore}
thread[0].name GEO
thread[0].cycle 2000
thread[0].priority 115
thread[0].cpu 1
thread[0].function[0].name task_int
thread[1].name BACKGROUND
thread[1].cycle 2000
thread[1].priority 100
thread[1].cpu 1
thread[1].function[0].name task_rnd
thread[2].name COM
thread[2].cycle 4000
thread[2].priority 90
thread[2].cpu 1
thread[2].function[0].name task_com
End
"""
PROGRAM = NcText(
    "part.nc",
    """\
V.P.I = 0
$WHILE V.P.I < 60
G01 X[V.P.I * 0.02] F20000
V.P.I = V.P.I + 1
#MSG["%d", V.P.I]
$ENDWHILE
M100
G04 X0.1
M30
""",
)
SIGNALS = ["X.ACS.ACT_POS", "BLOCK", "V.E.VALUE"]


PLC_FILE = """\
class Counting:
    def __init__(self):
        self.calls = 0

    def cycle(self, hli):
        self.calls += 1
        hli.write("V.E.VALUE1", self.calls)
        hli.acknowledge_all()
"""


class CountingPlc:
    """A PLC that counts its calls and acknowledges everything."""

    def __init__(self) -> None:
        self.calls = 0
        self.seen: list[TechnologyEntry] = []

    def cycle(self, hli: PlcView) -> None:
        """Show the calls in V.E."""
        self.calls += 1
        hli.write("V.E.VALUE", self.calls)
        self.seen += hli.functions()
        hli.acknowledge_all()


def list_file(folder: Path, windows: int = 0) -> Path:
    """A scheduling list with a semaphore that nobody else has."""
    path = folder / "rtconf.lis"
    path.write_text(LIST.format(windows=windows, semaphore=f"nctakt_{folder.name}"[:80]))
    return path


class Real:
    """A run on the clock; ``found``: all that the threads could not keep."""

    def __init__(
        self,
        path: Path,
        plc: CountingPlc | None = None,
        on_message: Callable[[ProgramMessage], None] | None = None,
    ) -> None:
        self.found: list[Diagnostic] = []
        self.inputs: list[Input] = []
        schedule = open_schedule(path)
        configuration, roles = scheduled(load_machine(), schedule)
        machine = AssembledMachine(configuration)
        self.schedule = RealSchedule(machine, schedule, roles, plc, self.found.append)
        loop = TickLoop(machine, self.found.append, None)
        loop.follow(self.schedule)
        options: RunKeywords = {
            "plc": plc,
            "signals": SIGNALS,
            "record": self.note,
            "ticks": 2000,
            "blocks": True,
            "on_message": on_message,
        }
        run = ProgramRun(loop, self.found, {1: [PROGRAM]}, completed(options))
        try:
            run.advance()
        finally:
            run.close()
            self.schedule.close()
        self.run = run.result()

    def note(self, cells: Cells) -> None:
        """Keep the inputs."""
        self.inputs += unpack(cells)

    def kinds(self) -> set[str]:
        """The kinds of the clock's inputs."""
        return {one.kind for one in self.inputs if one.source == SCHEDULE}


def repeated(path: Path, real: Real, *, has_plc: bool) -> Any:
    """The run again, from its inputs alone, without a clock."""
    tape = Tape({}, {}, has_plc, tuple(real.inputs), {}, real.run.ticks, "ended", {})
    controller = Controller(schedule=open_schedule(path))
    return controller.run(PROGRAM, signals=SIGNALS, replay=tape, ticks=2000, blocks=True)


def rows(run: Any) -> list[list[float]]:
    """The trace."""
    return [list(run.trace[name]) for name in SIGNALS]


def test_a_recording_repeats_what_the_clock_has_decided(tmp_path: Path) -> None:
    """From tick t on, n commands were there: the same trace, events and messages, cell by cell."""
    path = list_file(tmp_path)
    real = Real(path)
    again = repeated(path, real, has_plc=False)
    assert real.run.state == "ended"
    assert rows(real.run) == rows(again)
    assert list(map(repr, real.run.messages)) == list(map(repr, again.messages))
    assert real.run.trace is not None
    assert list(map(repr, real.run.trace.events)) == list(map(repr, again.trace.events))
    assert real.kinds() <= {DECODED, OVERFLOWED, LOST}
    given = [one.values for one in real.inputs if one.kind == DECODED]
    assert sum(int(steps) for _, steps in given) > 60 * 2


def test_a_plc_in_its_own_thread_is_repeated_without_it(tmp_path: Path) -> None:
    """What it writes and acknowledges is on the tape in the tick that latched it."""
    path = list_file(tmp_path)
    plc = CountingPlc()
    real = Real(path, plc)
    again = repeated(path, real, has_plc=True)
    assert rows(real.run) == rows(again)
    assert 0 < plc.calls <= real.run.ticks // 2 + 1  # due in each second NC cycle
    assert [entry.name for entry in plc.seen[:1]] == ["M100"]


def test_the_table_is_that_of_schedule_run(tmp_path: Path) -> None:
    """Each NC cycle is counted; the tick has a latency; what cannot be kept is reported."""
    real = Real(list_file(tmp_path, windows=500))
    table = real.schedule.table("en")
    assert "Wake-up latency" in table
    assert "GEO" in table
    assert {found.id for found in real.found} >= {901460, 901462}
    assert "COM" in next(str(found) for found in real.found if found.id == 901462)
    semaphore = Path("/dev/shm") / f"sem.nctakt_{tmp_path.name}"[:90]
    assert not semaphore.exists()


def test_an_error_in_the_plc_ends_the_run(tmp_path: Path) -> None:
    """The thread of the interpolation raises it; nothing stays behind."""

    class Broken(CountingPlc):
        def cycle(self, hli: PlcView) -> None:
            raise KeyError("door")

    before = sys.getswitchinterval(), os.sched_getscheduler(0), os.sched_getaffinity(0)
    with pytest.raises(KeyError):
        Real(list_file(tmp_path), Broken())
    assert (sys.getswitchinterval(), os.sched_getscheduler(0), os.sched_getaffinity(0)) == before


def test_a_semaphore_that_exists_is_refused(tmp_path: Path) -> None:
    """900685, before a thread runs."""
    from nctakt.schedule.real import processes  # noqa: PLC0415 - there is one

    path = list_file(tmp_path)
    name = f"/nctakt_{tmp_path.name}"[:81]
    processes.create(name)
    try:
        with pytest.raises(Failure) as caught:
            Real(path)
        assert caught.value.diagnostics[0].id == 900685
    finally:
        processes.remove(name)


def test_a_tick_that_begins_too_late_is_lost(tmp_path: Path) -> None:
    """The interpolation that is busy when it is due loses that activation; the tape says so."""
    path = list_file(tmp_path)
    real = Real(path, on_message=lambda _: time.sleep(0.005))  # longer than an NC cycle
    again = repeated(path, real, has_plc=False)
    assert LOST in real.kinds()
    assert rows(real.run) == rows(again)
    measured = real.schedule.measurement().run.tasks[0]
    lost = sum(one.kind == LOST for one in real.inputs)
    assert (measured.overflows, measured.lost) == (lost, lost)


def test_a_session_runs_by_the_list_and_cannot_go_back(tmp_path: Path) -> None:
    """Clients write while it runs; its tape repeats it; 901464 for the way back."""
    path = list_file(tmp_path)
    plc = tmp_path / "plc.py"
    plc.write_text(PLC_FILE)
    setup = Setup({1: [PROGRAM]}, plc=plc, rtconf=str(path), options={"stays": True})
    with Session.of_setup(setup) as session:
        session.play()
        with session.listen() as listener:
            while session.tick < 50:
                listener.take(1.0)
        session.write({"V.E.VALUE": 7})
        session.pause()
        session.play()
        while session.read("V.E.VALUE") != [7.0]:
            session.step()
        session.pause()
        assert "GEO" in session.schedule_table("de")
        with pytest.raises(Failure) as caught:
            session.back(10)
        assert caught.value.diagnostics[0].id == 901464
        session.save(tmp_path / "run.tape")
        position, count = session.read("X.ACS.ACT_POS", "V.E.VALUE1")
    tape = read_tape(tmp_path / "run.tape", FileAccess())
    assert {one.source for one in tape.inputs} == {SCHEDULE, "plc", "api"}
    controller = Controller(schedule=open_schedule(path))
    controller.run(PROGRAM, replay=tape, ticks=tape.ticks, stays=True)
    assert controller.signal("X.ACS.ACT_POS") == position
    assert controller.read("V.E.VALUE1") == count != 0


@pytest.mark.parametrize(("number", "notes"), [(1, [901552]), (2, []), (3, [901552])])
def test_nc_interrupts_come_from_a_timer(tmp_path: Path, number: int, notes: list[int]) -> None:
    """Whatever the list says; where it says otherwise a note reports it."""
    path = list_file(tmp_path)
    source = f"interrupt_source {number} # 1: Hardware ISR 2: timer 3: Semaphore"
    text = path.read_text().replace(LIST.splitlines()[0], source)
    path.write_text(f"external_object_name cell\n{text}" if number == 3 else text)
    found: list[Diagnostic] = []
    _plan(open_schedule(path), found.append)
    assert [one.id for one in found if one.id != SCHED_FIFO_NOT_PERMITTED.id] == notes
