# SPDX-License-Identifier: MIT
"""Steps near to where a mark has proved the past are compared with their own digests alone."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from nctakt import Controller, NcText
from nctakt.session.core import NEXT_BLOCK, SessionCore
from nctakt.session.history.trail import Confirmed, Mark
from nctakt.session.process.process_pool import RemoteEngine
from nctakt.session.process.worker import can_fork
from nctakt.session.setup import Setup
from nctakt.session.stops import read_stop

needs_copies = pytest.mark.skipif(not can_fork(), reason="a controller cannot be copied here")

PROGRAM = "\n".join([*(f"G01 X{k % 7} Y{k} F60000" for k in range(60)), "M30"])


def test_what_no_mark_has_proved_is_not_known() -> None:
    known = Confirmed()
    known.enter(1)
    assert known.compare(1, [Mark(5, b"a", 0.0)]) is None
    assert 5 not in known
    known.enter(1)
    known.prove()
    assert 5 not in known
    known.compare(1, [Mark(5, b"a", 0.0), Mark(7, b"b", 0.0)])
    known.prove()
    assert known.between(4, 7, 9) == [5, 7]


def test_a_known_tick_that_comes_otherwise_is_found() -> None:
    known = Confirmed()
    known.enter(1)
    known.compare(1, [Mark(5, b"a", 0.0)])
    known.prove()
    known.enter(1)
    assert known.compare(1, [Mark(3, b"x", 0.0), Mark(5, b"other", 0.0)]) == 5
    assert not known.is_proved(5)
    assert known.compare(1, [Mark(5, b"a", 0.0)]) is None
    assert known.is_proved(5)
    assert known.compare(2, [Mark(5, b"of another branch", 0.0)]) is None
    known.enter(2)
    assert 5 not in known


@pytest.fixture
def core() -> Iterator[SessionCore]:
    """A session that has run to its end, in parts."""
    own = SessionCore(Setup({1: [NcText("p.nc", PROGRAM)]}))
    while not own.is_over:
        own.step(100)
    yield own
    own.close()


@needs_copies
def test_steps_back_need_one_copy_each_and_are_as_the_first_run(
    core: SessionCore, monkeypatch: pytest.MonkeyPatch
) -> None:
    names = ["V.RTA.ACS.ACT_POS.X", "V.RTA.ACS.ACT_POS.Y"]
    core.go_to(core.branch.latest // 2)
    copies = 0
    copy = RemoteEngine.copy

    def counted(engine: RemoteEngine) -> RemoteEngine:
        nonlocal copies
        copies += 1
        return copy(engine)

    monkeypatch.setattr(RemoteEngine, "copy", counted)
    seen = []
    for _ in range(4):
        core.back_to([NEXT_BLOCK])
        seen.append((core.tick, core.read(names)))
    assert copies == 4
    monkeypatch.undo()
    run = Controller().run(
        NcText("p.nc", PROGRAM), signals=["X.ACS.ACT_POS", "Y.ACS.ACT_POS"], memory_trace=True
    )
    for tick, values in seen:
        assert values == [run.trace[name][tick - 1] for name in run.trace.keys()]


@needs_copies
def test_arrival_has_the_events_of_its_last_ticks_only(core: SessionCore) -> None:
    done = core.go_to(core.branch.latest - 10)
    assert done.first_tick >= done.tick - 100
    assert done.events
    assert all(one.time_us // 1000 >= done.first_tick for one in done.events)
    assert all(one.time_us // 1000 >= done.first_tick for one in done.messages)
    assert core.back_to([read_stop("V.RTA.ACS.ACT_POS.X > 1000")]) is None


@needs_copies
def test_what_is_known_of_a_branch_says_nothing_of_another_one(core: SessionCore) -> None:
    """An input in the past begins a branch, whose ticks are looked at before it is travelled."""
    core.go_to(30)
    core.back()
    core.write({"HLI.OVERRIDE": 10}, "page")
    core.step(20)
    assert core.branch.number == 2
    assert core.happened(0, core.tick).tick == core.tick
    core.back(2)
    assert core.happened(10, 40).tick == 40
