# SPDX-License-Identifier: MIT
"""The thread of a session: who asks gets an answer, whatever happens beside it."""

from __future__ import annotations

import queue
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest
from support.insides import exchange_queue

from nctakt import Failure, NcText, Session
from nctakt.messages import diagnostic
from nctakt.messages.connections.session import CONTROLLER_LOST
from nctakt.session.core import SessionCore
from nctakt.session.engine import Engine
from nctakt.session.history.parking import SPARSE_US
from nctakt.session.process import thread as thread_module
from nctakt.session.process.thread import SessionThread
from nctakt.session.process.worker import can_fork
from nctakt.session.setup import Setup

#: How long a test waits, in seconds.
PATIENCE_S = 60.0


def test_who_asks_while_it_closes_gets_an_answer() -> None:
    """Also one whose command is on its way into the queue when the thread ends."""
    thread = SessionThread(lambda _clock: None, lambda: False, lambda: (0, None))
    is_on_its_way = threading.Event()

    class SlowQueue(queue.Queue[Any]):
        def put(self, item: Any, block: bool = True, timeout: float | None = None) -> None:
            if item is not None:
                is_on_its_way.set()
                time.sleep(0.3)
            super().put(item, block, timeout)

    assert thread.ask(int, "1") == 1
    slow = SlowQueue()
    first = exchange_queue(thread, slow)
    first.put(lambda: None)  # wakes the thread, which then waits at the slow queue
    with ThreadPoolExecutor(1) as pool:
        answer = pool.submit(thread.ask, int, "2")
        assert is_on_its_way.wait(PATIENCE_S)
        thread.close()
        assert answer.result(PATIENCE_S) == 2
    with pytest.raises(Failure, match="901155"):
        thread.ask(int, "3")


def test_it_works_for_commands_to_come_while_none_does(monkeypatch: pytest.MonkeyPatch) -> None:
    """Only after a command, and until nothing is left to do; then it waits."""
    monkeypatch.setattr(thread_module, "PREPARING_S", 0.01)
    left, is_done = [3], threading.Event()

    def prepare() -> bool:
        assert left[0] > 0
        left[0] -= 1
        if not left[0]:
            is_done.set()
        return left[0] > 0

    thread = SessionThread(lambda _clock: None, prepare, lambda: (0, None))
    assert not is_done.wait(0.05)
    assert left == [3]
    assert thread.ask(int, "1") == 1
    assert is_done.wait(PATIENCE_S)
    thread.close()
    assert left == [0]


@pytest.mark.skipif(not can_fork(), reason="only where controllers can be parked")
def test_after_a_journey_controllers_are_parked_for_steps_back() -> None:
    """The journey itself does not wait for that (``Timeline.refine``)."""
    program = NcText("p.nc", "$WHILE 1\nG01 X10 F1000\nG01 X0\n$ENDWHILE\nM30")
    core = SessionCore(Setup({1: [program]}, options={"until": "24 h"}))
    try:
        while core.timeline.branch.work_at(core.tick) < 4 * SPARSE_US:
            core.run(core.tick + 10_000)
        assert not core.prepare()
        front, works = core.tick, 1
        for part in range(2, 12):  # where some place is near a parked controller, another is not
            core.go_to(front // part)
            live, tick = core.timeline.live, core.tick
            while core.prepare():
                works += 1
            if works > 1:
                break
        assert works > 1
        assert core.timeline.live is live
        assert live.tick == tick
        assert not core.prepare()
        core.back(1)
        straight = Engine(Setup({1: [program]}, options={"until": "24 h"}))
        straight.run(tick - 1)
        assert core.read(["X.ACS.ACT_POS"]) == straight.read(["X.ACS.ACT_POS"])
    finally:
        core.close()


def test_a_controller_that_is_lost_while_it_is_read_ends_play_and_no_more(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    program = NcText("p.nc", "$WHILE 1\nG01 X10 F1000\nG01 X0\n$ENDWHILE\nM30")
    with Session(program, until="24 h") as session, session.listen("X.ACS.ACT_POS") as listener:

        def lost(_core: SessionCore, _names: object) -> None:
            raise Failure(diagnostic(CONTROLLER_LOST, reason="EOF"))

        monkeypatch.setattr(SessionCore, "read", lost)
        session.play()
        end_s = time.monotonic() + PATIENCE_S
        while session.is_playing and time.monotonic() < end_s:
            time.sleep(0.01)
        monkeypatch.undo()
        assert not session.is_playing
        assert [one.kind for one in listener.notices()] == ["refused"]
        assert session.step().tick == session.tick


HANGING_PLC = """import time
from pathlib import Path

from nctakt.plc import Plc, at


class Hangs(Plc):
    @at("0.1s")
    def wait(self, hli):
        Path(__file__).with_suffix(".hangs").touch()
        time.sleep(3600)
"""


@pytest.mark.slow
def test_a_controller_that_hangs_does_not_hold_up_the_end(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It is killed after a time, and closing returns."""
    monkeypatch.setattr(thread_module, "CLOSING_S", 0.2)
    plc = tmp_path / "plc.py"
    plc.write_text(HANGING_PLC, "utf-8")
    session = Session(NcText("p.nc", "G04 X60\nM30"), plc=str(plc))
    session.play()
    end_s = time.monotonic() + PATIENCE_S
    while not plc.with_suffix(".hangs").exists():
        assert time.monotonic() < end_s
        time.sleep(0.01)
    closing = threading.Thread(target=session.close, daemon=True)
    closing.start()
    closing.join(PATIENCE_S)
    assert not closing.is_alive()
