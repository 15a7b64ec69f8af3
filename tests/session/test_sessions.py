# SPDX-License-Identifier: MIT
"""Sessions: stops, going back, branches of the tape, clocks, listeners."""

from __future__ import annotations

import shutil
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from support.insides import core_of, lose_controller

from nctakt import Controller, Failure, NcText
from nctakt.run.access.inputs import Input
from nctakt.session import Session
from nctakt.session.engine import Engine
from nctakt.session.process.process_pool import ProcessPool
from nctakt.session.process.worker import can_fork
from nctakt.session.setup import Setup
from nctakt.session.stops import StopAt, read_stop

pytestmark = pytest.mark.slow

PROGRAM = """\
#RT CYCLE [ID=1 SCOPE=PROG]
  $IF EDGE V.E.VALUE > 0.5
    V.E.COUNT += 1
  $ENDIF
  $IF V.RTA.ACS.ACT_POS.X >= 50 && V.E.COUNT > 0
    V.E.CONDITION = 1
  $ENDIF
#RT CYCLE END
G01 X100 F6000
#MSG ["there"]
M100
G04 X0.05
M30
"""

PULSES = [("20 ms", "V.E.VALUE", 1), ("30 ms", "V.E.VALUE", 0), ("45 ms", "V.E.VALUE", 1)]


def opened(**options: object) -> Session:
    return Session(NcText("p.nc", PROGRAM), at=PULSES, **options)  # type: ignore[arg-type]


@pytest.fixture(scope="module")
def shared() -> Iterator[Session]:
    with opened() as session:
        yield session


@pytest.fixture
def session(shared: Session) -> Session:
    """A session at its start, on its first branch, without stops."""
    if shared.latest.tick or shared.branch != 1:
        shared.go_to(0, 1)
    shared.set_stops()
    return shared


# --- stops ----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("stop", "tick"),
    [
        ("V.E.COUNT > 0", 21),  # latched and counted in tick 20 (RC-002)
        ("changes V.E.COUNT", 21),
        ("changes V.E.VALUE 2 times", 31),
        ("V.E.VALUE == 0 if V.E.COUNT > 0", 31),
        ("fires 2", 21),
        ("fires p.nc:2 2 times", 46),
        ("turns 2", 21),
        ("line 9", 1),
        ("M100", 1026),
        ("message", 1026),
        ("V.RTA.ACS.ACT_POS.X >= 50", 513),  # after the tick that has moved the axis there
        ("runs 5", 514),  # the cycles run before the path (RC-002)
        ("error", 1076),  # never: the end of the run
    ],
)
def test_a_stop_ends_after_the_tick_in_which_it_holds(
    session: Session, stop: str, tick: int
) -> None:
    assert session.run(until=stop).tick == tick


def test_forward_from_a_stop_never_stops_in_the_same_tick_again(session: Session) -> None:
    session.set_stops("changes V.E.VALUE")
    assert [session.run().tick for _ in range(4)] == [21, 31, 46, 1076]


def test_a_hit_names_its_stop(session: Session) -> None:
    session.set_stops("M100", "V.E.COUNT > 1")
    assert session.run().hits == (1,)
    assert session.run().hits == (0,)


def test_a_count_goes_on_over_slices(session: Session) -> None:
    session.set_stops("changes V.E.VALUE 3 times")
    assert session.run("25 ms").hits == ()
    assert session.run("40 ms").hits == ()
    assert session.run().tick == 46


def test_all_mistakes_of_stops_are_reported_and_the_old_ones_stay(session: Session) -> None:
    session.set_stops("M100")
    with pytest.raises(Failure) as failure:
        session.set_stops("V.E.FOO > 1", "line x", "V.P.A > 1", "V.E.COUNT >", StopAt("function"))
    numbers = [found.id for found in failure.value.diagnostics]
    assert numbers[0] == 20196
    assert 901150 in numbers
    assert 901151 in numbers
    assert session.stops == (StopAt("function", "M100"),)


@pytest.mark.parametrize(
    "text", ["", "line", "line x", "fires", "M100 0 times", "turns a:b", "line " + 5000 * "9"]
)
def test_what_is_no_stop(text: str) -> None:
    with pytest.raises(Failure, match="901150"):
        read_stop(text)


# --- back -----------------------------------------------------------------------------------------


def test_back_by_ticks_and_to_the_start(session: Session) -> None:
    session.run("100 ms")
    position = session.read("X.ACS.ACT_POS")
    session.step(7)
    assert session.back(7).tick == 100
    assert session.read("X.ACS.ACT_POS") == position
    assert session.back(1000).tick == 0


def test_back_to_the_last_time_that_a_stop_held(session: Session) -> None:
    session.run()
    back = session.last_change("V.E.VALUE")
    assert back is not None
    assert back.tick == 46
    back = session.last_change("V.E.VALUE")
    assert back is not None
    assert back.tick == 31
    back = session.previous_reaction()
    assert back is not None
    assert back.tick == 21
    assert session.previous_reaction() is None
    assert session.tick == 21


def test_back_to_the_block_before(session: Session) -> None:
    session.run(until="M100")
    back = session.previous_block()
    assert back is not None
    assert back.blocks[1].line == 9


def test_a_moment_that_was_not_reached_is_refused(session: Session) -> None:
    session.step(10)
    with pytest.raises(Failure, match="901154"):
        session.go_to(99_999)
    with pytest.raises(Failure, match="901157"):
        session.go_to(0, 77)


def test_an_input_in_the_past_begins_a_branch_and_the_old_one_stays() -> None:
    with opened() as session:
        session.run()
        assert session.evaluate("V.E.COUNT") == 2
        session.go_to(40)
        session.write({"V.E.COUNT": 10})
        assert session.branch == 2
        session.run()
        assert session.evaluate("V.E.COUNT") == 11  # the pulse of 45 ms is still to come
        session.go_to(session.branches[1], 1)
        assert session.evaluate("V.E.COUNT") == 2
        assert set(session.branches) == {1, 2}


def test_a_wrong_input_is_refused_and_nothing_has_happened(session: Session) -> None:
    with pytest.raises(Failure, match="VALU"):
        session.write({"V.E.COUNT": 5, "V.E.VALU": 1})
    session.step()
    assert session.evaluate("V.E.COUNT") == 0


# --- looking --------------------------------------------------------------------------------------


@pytest.mark.parametrize("every", [1, 10])
def test_a_look_passes_the_stops_that_were_watched(every: int) -> None:
    """A parked controller still watches those of the run that it was parked in."""
    engine = Engine(Setup({1: [NcText("p.nc", PROGRAM)]}))
    engine.run(10, [StopAt("condition", "V.RTA.ACS.ACT_POS.X > 20")])
    assert len(engine.look(510, ["X.ACS.ACT_POS"], every)) == 8 * 500 // every


def test_a_look_at_the_past_is_the_trace_of_the_run(session: Session) -> None:
    session.run()
    trace = Controller().run(NcText("p.nc", PROGRAM), at=PULSES).trace
    assert trace is not None
    every, rows = session.look(0, 2000, ["X.ACS.ACT_POS", "PATH.SPEED"])
    assert every == 1
    assert list(rows[::2]) == trace["X.ACS.ACT_POS"].tolist()
    assert list(rows[1::2]) == trace["PATH.SPEED"].tolist()
    every, rows = session.look(100, 200, ["X.ACS.ACT_POS"], 10)
    assert every == 10
    assert list(rows) == trace["X.ACS.ACT_POS"].tolist()[109:200:10]
    assert session.tick == 1076


def test_the_result_so_far_is_that_of_a_run(session: Session) -> None:
    session.run()
    expected = Controller().run(NcText("p.nc", PROGRAM), at=PULSES, memory_trace=False)
    result = session.result()
    assert (result.state, result.ticks) == (expected.state, expected.ticks)
    assert result.cycles == expected.cycles
    assert result.outputs == expected.outputs
    assert result.messages == expected.messages


def test_conditions_have_their_truth_at_the_tick(session: Session) -> None:
    session.run(until="fires 2")
    (cycle,) = session.cycles()
    edge, plain = cycle.branches
    assert (cycle.name, cycle.state, cycle.scope) == ("1", "running", "PROG")
    assert (edge.frequency, edge.truth, edge.has_run, edge.count) == ("EDGE", True, True, 1)
    assert (plain.truth, plain.has_run, plain.count) == (False, False, 0)


def test_an_expression_that_is_not_defined_is_no_number(session: Session) -> None:
    assert str(session.evaluate("1 / V.E.COUNT")) == "nan"
    with pytest.raises(Failure, match="20196"):
        session.evaluate("V.E.NOTHING")


# --- the PLC --------------------------------------------------------------------------------------

PLC = """\
from nctakt import Plc

class Cell(Plc):
    def __init__(self):
        self.calls = 0

    def cycle(self, hli):
        self.calls += 1
        hli.write("V.E.COUNT", self.calls)
        super().cycle(hli)
"""


def test_a_scripted_plc_goes_back_with_its_controller(tmp_path: Path) -> None:
    file = tmp_path / "cell.py"
    file.write_text(PLC, "utf-8")
    with Session(NcText("p.nc", "G04 X0.2\nM30"), plc=file) as session:
        session.run("100 ms")
        assert session.evaluate("V.E.COUNT") == 99
        session.back(50)
        assert session.evaluate("V.E.COUNT") == 49
        session.step(10)
        assert session.evaluate("V.E.COUNT") == 59


def test_a_function_is_acknowledged_by_hand() -> None:
    with Session(NcText("p.nc", "M111\nM30"), acknowledges=False) as session:
        assert session.run("50 ms").run_state is None
        ((channel, entry),) = session.waiting()
        assert (channel, entry.name) == (1, "M111")
        session.acknowledge(channel, entry)
        assert session.run().run_state == "ended"
        assert session.tick == 51
        session.back(20)
        assert session.waiting() == [(channel, entry)]


@pytest.mark.parametrize(
    "values",
    [
        ("write", ("V.E.NO", 1)),
        ("write", ()),
        ("ack", (5, False, 0, 0, "M1")),
        ("ack", (0, False, 999, 0, "M1")),
        ("ack_spindle", (0, 99, 0, "S")),
        ("jump", ()),
    ],
)
def test_a_forged_input_is_refused_at_the_door(session: Session, values: tuple[str, Any]) -> None:
    with pytest.raises(Failure):
        core_of(session).timeline.post([Input(0, "page", *values)])
    assert session.step().state == "running"


# --- clock and listeners --------------------------------------------------------------------------


def test_on_the_wall_clock_no_tick_comes_before_its_time() -> None:
    with opened() as session:
        begin = time.monotonic()
        session.play(1.0)
        while session.tick < 200:
            time.sleep(0.01)
        tick = session.pause().tick
        assert tick <= 1000 * (time.monotonic() - begin) + 1


def test_a_listener_gets_the_latest_frame_and_all_notices(session: Session) -> None:
    with session.listen("X.ACS.ACT_POS", "V.E.COUNT") as listener:
        assert listener.take() is not None
        session.play()
        assert [notice.kind for notice in listener.notices(10.0)][-1] == "ended"
        frame = listener.take(10.0)
        assert frame is not None
        assert frame.tick == 1076
        assert frame.values == {"X.ACS.ACT_POS": 100.0, "V.E.COUNT": 2.0}
        assert [message.text for message in frame.messages] == ["there"]
        assert not session.is_playing


def test_an_unknown_signal_is_refused(session: Session) -> None:
    with pytest.raises(Failure), session.listen("X.NOTHING"):
        pass


@pytest.mark.parametrize("speed", [0.0, -1.0, 1e6])
def test_a_speed_outside_the_limits_is_refused(session: Session, speed: float) -> None:
    with pytest.raises(ValueError, match=str(speed)):
        session.play(speed)


# --- what can go wrong ----------------------------------------------------------------------------


def test_a_program_with_errors_is_a_session_that_is_over() -> None:
    with Session(NcText("p.nc", "G01 X1 F1 Q1\nM30")) as session:
        assert session.is_over
        assert session.description.is_over
        assert session.description.diagnostics[0].id == 20797


def test_a_setup_that_cannot_be_is_reported_at_once(tmp_path: Path) -> None:
    with pytest.raises(Failure, match="900500"):
        Session(tmp_path / "nofile.nc")
    with pytest.raises(Failure, match="NO"):
        Session(NcText("p.nc", "M30"), set={"V.E.NO": 1})


def test_a_closed_session_says_so() -> None:
    session = opened()
    session.close()
    session.close()
    with pytest.raises(Failure, match="901155"):
        session.step()


def test_a_run_of_another_thread_can_be_paused() -> None:
    endless = NcText("p.nc", "$WHILE 1\nG01 X10 F1000\nG01 X0\n$ENDWHILE\nM30")
    with Session(endless, until="24 h") as session:
        thread = threading.Thread(target=session.run)
        thread.start()
        while session.tick < 1000:
            time.sleep(0.01)
        session.pause()
        thread.join()
        assert not session.is_over


def test_a_time_that_has_passed_runs_nothing(session: Session) -> None:
    session.step(50)
    assert session.run("20 ms").tick == 50


def test_the_slices_of_a_run_are_reported_as_one(session: Session) -> None:
    done = session.run()
    expected = Controller().run(NcText("p.nc", PROGRAM), at=PULSES, blocks=True)
    assert (done.first_tick, done.tick) == (0, expected.ticks)
    assert list(done.events) == list(expected.events)
    assert [message.text for message in done.messages] == ["there"]


def test_a_controller_that_cannot_start_is_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    """Nobody waits for a process that ends before it has reported."""
    monkeypatch.setattr(sys, "executable", shutil.which("false") or "false")
    with pytest.raises(Failure, match="901153"):
        opened()


@pytest.mark.nightly
def test_a_session_goes_back_without_copies_too(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where there is no fork, the past is run again from the start."""
    monkeypatch.setattr(ProcessPool, "can_copy", False)
    with opened() as session:
        session.run()
        assert session.back(10).tick == 1066
        back = session.last_change("V.E.VALUE")
        assert back is not None
        assert back.tick == 46
        assert session.evaluate("V.E.COUNT") == 2


@pytest.mark.skipif(not can_fork(), reason="controllers are not parked on this system")
def test_a_controller_that_is_gone_is_reported_and_left_behind() -> None:
    with opened() as session:
        session.run("100 ms")
        session.back(50)
        lose_controller(session)
        with pytest.raises(Failure, match="901153"):
            session.step()
        assert session.go_to(20).tick == 20
        assert session.run().run_state == "ended"


def test_who_listens_hears_all_that_was_before_a_pause() -> None:
    """Slices that were not due for a frame come with the pause, not with the next frame."""
    text = "#RT CYCLE [ID=1]\nV.E.COUNT = V.E.COUNT + 1\n#RT CYCLE END\nG04 X3600\nM30"
    with Session(NcText("p.nc", text)) as own, own.listen(rate_hz=0.1) as listener:
        assert listener.take(10.0) is not None
        own.play(1.0)
        while own.tick < 100:
            time.sleep(0.01)
        end = own.pause().tick
        frame = listener.take(10.0)
        assert frame is not None
        assert (frame.tick, frame.events[-1].tick) == (end, end - 1)


def test_without_listeners_to_events_the_slice_that_ends_play_still_has_them() -> None:
    with Session(NcText("move.nc", "M100\nG01 X10 F6000\nM30"), until="1 s") as session:
        with session.listen("X.ACS.ACT_POS", events=False) as listener:
            session.play()
            while session.is_playing:
                frame = listener.take(1.0)
                assert frame is None or not frame.events
        kinds = [event.kind for event in session.latest.events]
    assert "output" in kinds
    assert kinds[-1] == "end"


def test_pause_brings_the_events_that_were_left_for_later() -> None:
    program = "M100\n" + "G01 X100 F6000\nG01 X0\n" * 400 + "M30"
    with Session(NcText("move.nc", program)) as session:
        session.play(1000.0)
        while session.tick < 2000:
            time.sleep(0.01)
        blocks = [event for event in session.pause().events if event.kind == "block"]
    assert blocks
