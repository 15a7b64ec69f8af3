# SPDX-License-Identifier: MIT
"""What the page keeps of branches: what their common ticks had stays, whatever was travelled.

A slow model has, for each branch, what a run of this branch alone has.
"""

import random
import time
from collections.abc import Callable, Iterator

import pytest
from support.random_seeds import seeds_in_parts

from nctakt import NcText, Session
from nctakt.live.parts.explaining import Explainer, bars_of
from nctakt.live.run_log import RunLog
from nctakt.live.shared import SharedSession
from nctakt.live.track import Track, blocks_of, marks_of
from nctakt.session.listening import Listener

FILE = "part.nc"

#: The condition of line 2 is true again and again; V.E.VALUE changes what happens.
PROGRAM = """#RT CYCLE [ID=1 SCOPE=PROG]
  $IF V.RTA.ACS.ACT_POS.X > 5
    V.E.COUNT += 1
  $ENDIF
  $IF EDGE V.E.VALUE > 0.5
    V.E.FLAG = 1
  $ENDIF
#RT CYCLE END
G01 X10 F6000
X0
X10
X0
M30
"""


@pytest.fixture
def session() -> Iterator[Session]:
    with Session(NcText(FILE, PROGRAM)) as session:
        yield session


def test_branches_part_where_an_input_differs(session: Session) -> None:
    """Branch 2 leaves 1 at tick 60, 3 leaves it at tick 20: 2 and 3 are one before tick 20."""
    session.step(100)
    session.go_to(60)
    session.write({"V.E.VALUE": 1}, "page")
    session.step(10)
    session.go_to(20)
    session.write({"V.E.VALUE": 1}, "page")
    session.step(10)
    origins = session.origins
    assert {number: first for number, (_, first) in origins.items()} == {1: 0, 2: 60, 3: 20}
    assert (session.fork(1, 2), session.fork(2, 3), session.fork(3, 1)) == (60, 20, 20)


def noted(log: RunLog, track: Track, session: Session, listener: Listener) -> list[int]:
    """The ticks of the rows that a page keeps which gets a frame now."""
    frame = listener.take()
    assert frame is not None
    log.note(frame, session.fork)
    track.turn_to(frame.branch, session.fork)
    return [row[0] for row in track.rows.entries()]


def test_travel_and_a_write_in_one_frame(session: Session) -> None:
    """The page hears of both at once: of branch 2, what it shares with branch 1 stays."""
    log, track = RunLog(session.description.cycle_time_us), Track()
    with session.listen(rate_hz=1e6) as listener:
        session.step(100)
        track.rows.add((tick, 0.0) for tick in range(100))
        assert noted(log, track, session, listener) == list(range(100))
        session.go_to(60)
        session.write({"V.E.VALUE": 1}, "page")
        session.step(10)
        assert noted(log, track, session, listener) == list(range(60))
        session.go_to(90, 1)
        session.step(1)
        track.rows.add((tick, 0.0) for tick in range(60, 70))
        assert noted(log, track, session, listener) == list(range(60))
        assert log.lacks_some  # the page runs ticks 60 to 89 again for its lists


def act(session: Session, chance: random.Random) -> None:
    """Do something that a user can do."""
    match chance.randrange(5):
        case 0 | 1:
            session.step(chance.randrange(1, 120))
        case 2:
            session.go_to(chance.randrange(session.branches[session.branch] + 1))
        case 3:
            session.write({"V.E.VALUE": chance.randrange(3)}, "page")
        case _:
            branch = chance.choice(list(session.branches))
            session.go_to(chance.randrange(session.branches[branch] + 1), branch)


def samples(session: Session, end: int) -> list[tuple[int, float]]:
    """A row for each tick of this branch up to ``end``, as a page samples them."""
    _, cells = session.look(0, end, ["X.ACS.ACT_POS"], end)
    return list(enumerate(cells.tolist()))


@pytest.mark.nightly
@seeds_in_parts(3, 1, 3)
def test_the_track_is_of_the_branch_that_is_shown(seeds: range) -> None:
    """Rows, marks and blocks are a beginning of what a run of this branch alone has.

    Of two branches, all before the tick at which they part stays.
    """
    for seed in seeds:
        chance = random.Random(seed)
        with (
            Session(NcText(FILE, PROGRAM)) as session,
            session.listen(rate_hz=1e6) as listener,
        ):
            log, track, branch = RunLog(session.description.cycle_time_us), Track(), 1
            for _ in range(8):
                known = track.rows.entries()
                for _ in range(chance.randrange(1, 4)):  # a page that is late gets them folded
                    act(session, chance)
                frame = listener.take()
                if frame is not None:
                    log.note(frame, session.fork)
                    track.turn_to(frame.branch, session.fork)
                    track.note(frame.events, 1, FILE)
                track.turn_to(session.branch, session.fork)
                if frame is None or frame.branch in (branch, session.branch):
                    fork = session.fork(branch, session.branch)
                    shared = [row for row in known if branch == session.branch or row[0] < fork]
                    assert track.rows.entries() == shared
                branch = session.branch
                if session.tick:
                    own = samples(session, session.tick)
                    track.rows.add(own[len(track.rows) :])
                compare_with_a_run(session, track)


def compare_with_a_run(session: Session, track: Track) -> None:
    """What the track has is of this branch, each once and in its order."""
    latest = session.branches[session.branch]
    if latest:
        assert track.rows.entries() == samples(session, latest)[: len(track.rows)]
    events, left_out = session.events(0, latest)
    assert not left_out
    for part, of_run in (
        (track.marks, marks_of(events, FILE)),
        (track.blocks, blocks_of(events, 1, FILE)),
    ):
        assert [one for one in of_run if one in part.entries()] == part.entries()


def exact(bars: dict[str, object]) -> list[dict[str, object]]:
    """The bars of lines as far as they are exact."""
    end, found = bars["end"], []
    assert isinstance(end, int)
    lines = bars["lines"]
    assert isinstance(lines, list)
    for line in lines:
        cut = [[first, min(last, end)] for first, last in line["bars"] if first < end]
        found.append({"line": line["line"], "bars": cut})
    return found


@pytest.mark.nightly
@seeds_in_parts(3, 1, 3)
def test_exact_lanes_are_of_the_branch_that_is_shown(seeds: range) -> None:
    """Up to where they are exact, they are those of a run of this branch up to there alone.

    A report of a past tick makes them no shorter.
    """
    for seed in seeds:
        chance = random.Random(seed)
        explainer = Explainer(lambda: None)
        with Session(NcText(FILE, PROGRAM)) as session:
            for _ in range(8):
                for _ in range(chance.randrange(1, 4)):
                    act(session, chance)
                moment = (1, session.branch, session.tick)
                before = explainer.bars(moment, FILE)["end"]
                if session.tick and chance.random() < 0.7:
                    explainer.report(moment, session)
                    assert explainer.bars(moment, FILE)["end"] >= session.tick
                bars = explainer.bars(moment, FILE)
                assert bars["end"] >= before
                if bars["end"]:
                    alone = bars_of(session.why(bars["end"], session.branch), FILE)
                    assert exact(bars) == exact({"end": bars["end"], "lines": alone})
        explainer.close()


def test_after_travel_lanes_reach_as_far_as_the_curves() -> None:
    """Branch 1 is taken up again at tick 10: its lanes are exact up to its end, tick 300."""

    def opener(_: str | None, __: bool) -> Session:
        return Session(NcText(FILE, PROGRAM))

    shared = SharedSession(opener, FILE, acknowledges=True)
    try:
        session = shared.session
        session.step(300)
        session.go_to(40)
        session.write({"V.E.VALUE": 1}, "page")
        session.step(10)
        shared.do(lambda session: session.go_to(10, 1))
        until(lambda: shared.explainer.bars(shared.moment, FILE)["end"] == 300)
        truth = bars_of(session.why(300, 1), FILE)
        assert shared.explainer.bars(shared.moment, FILE)["lines"] == truth
        assert shared.moment[1:] == (1, 10)
    finally:
        shared.close()


def test_a_branch_taken_up_again_has_all_of_its_past() -> None:
    """An input before the first tick begins branch 2, which has no tick; branch 1 has 300."""

    def opener(_: str | None, __: bool) -> Session:
        return Session(NcText(FILE, PROGRAM))

    shared = SharedSession(opener, FILE, acknowledges=True)
    try:
        track, session = shared.track, shared.session
        shared.do(lambda session: session.step(300))
        marks = marks_of(session.events(0, 300)[0], FILE)
        assert marks
        for _ in range(2):
            until(lambda: track.marks.entries() == marks and len(track.rows) == 300)
            shared.do(lambda session: session.go_to(0))
            shared.do(lambda session: session.write({"V.E.VALUE": 1}, "page"))
            until(lambda: shared.snapshot.branch > 1 and not len(track.rows))
            shared.do(lambda session: session.go_to(300, 1))
            until(lambda: shared.snapshot.branch == 1)
        until(lambda: track.marks.entries() == marks and len(track.rows) == 300)
    finally:
        shared.close()


def until(is_so: Callable[[], bool]) -> None:
    """Wait until a condition holds; pytest's own limit ends a test where it never comes."""
    while not is_so():
        time.sleep(0.02)
