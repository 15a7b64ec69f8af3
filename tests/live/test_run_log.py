# SPDX-License-Identifier: MIT
"""What the page lists of the past, whatever the session does: travels, branches, late listeners."""

import random
from collections.abc import Iterator

import pytest
from support.random_seeds import seeds_in_parts

from nctakt import NcText, Session
from nctakt.live.run_log import ENOUGH, MAX_LOG, RunLog
from nctakt.live.view import LogRow
from nctakt.results.run import ProgramMessage
from nctakt.session.listening import Listener

#: Events all along the way, a message in the middle, an error at the end; V.E.VALUE adds events.
PROGRAM = """#MSG ["start"]
#RT CYCLE [ID=1 SCOPE=PROG]
  $IF ONCE V.RTA.ACS.ACT_POS.X > 5
    M100
  $ENDIF
  $IF V.E.VALUE > 0.5
    V.E.COUNT += 1
  $ENDIF
#RT CYCLE END
G01 X20 F6000
#MSG ["middle"]
X0
$IF V.E.COUNT > 10
  #ERROR [ID=7 RC=2]
$ENDIF
M30
"""


@pytest.fixture
def session() -> Iterator[Session]:
    with Session(NcText("part.nc", PROGRAM)) as session:
        yield session


def look(log: RunLog, session: Session, listener: Listener) -> None:
    """Take what there is to take, as the page does; then compare with a run of this past alone."""
    frame = listener.take()
    if frame is not None:
        log.note(frame, session.fork)
        assert log.end == session.tick
    if log.lacks_some:
        log.complete(session.happened)
    truth = session.happened(0, session.tick)
    older = len(truth.events) - len(log.events)
    assert log.events == tuple(truth.events)[older:]
    assert log.left_out == truth.left_out + older
    assert min(ENOUGH, len(truth.events)) <= len(log.events) <= MAX_LOG
    assert log.messages == tuple(truth.messages)
    assert list(map(str, log.diagnostics)) == list(map(str, truth.diagnostics))


def act(session: Session, chance: random.Random) -> None:
    """Do something that a user can do."""
    match chance.randrange(6):
        case 0:
            session.step(chance.randrange(1, 200))
        case 1:
            session.run()
        case 2:
            session.go_to(chance.randrange(session.branches[session.branch] + 1))
        case 3:
            session.back(chance.randrange(1, 50))
        case 4:
            session.write({"V.E.VALUE": chance.randrange(2)}, "page")
        case _:
            branch = chance.choice(list(session.branches))
            session.go_to(chance.randrange(session.branches[branch] + 1), branch)


@pytest.mark.nightly
@seeds_in_parts(3, 1, 3)
def test_the_list_is_the_past_of_what_is_shown(seeds: range) -> None:
    """Each event once, of this branch, none after the tick that is shown."""
    for seed in seeds:
        chance = random.Random(seed)
        with (
            Session(NcText("part.nc", PROGRAM)) as session,
            session.listen(rate_hz=1e6) as listener,
        ):
            log = RunLog(session.description.cycle_time_us)
            for _ in range(8):
                for _ in range(chance.randrange(1, 4)):  # a page that is late gets them folded
                    act(session, chance)
                look(log, session, listener)


def test_another_branch_leaves_nothing_behind(session: Session) -> None:
    """An event, a message and an error of a future that was left are not listed any more."""
    log = RunLog(session.description.cycle_time_us)
    with session.listen(rate_hz=1e6) as listener:
        session.write({"V.E.VALUE": 1}, "page")
        assert session.run().run_state == "error"
        look(log, session, listener)
        assert len(log.diagnostics) == 1
        session.go_to(100)
        look(log, session, listener)
        assert log.diagnostics == []
        assert [one.text for one in log.messages if isinstance(one, ProgramMessage)] == ["start"]
        session.write({"V.E.VALUE": 0}, "page")
        session.step(50)
        look(log, session, listener)
        assert max(event.tick for event in log.events) < 150


def test_what_the_session_says_stays(session: Session) -> None:
    """A refusal belongs to no tick."""
    log = RunLog(session.description.cycle_time_us)
    row = LogRow("warning", 0, "refused")
    with session.listen(rate_hz=1e6) as listener:
        session.step(10)
        log.say(row)
        session.go_to(0)
        frame = listener.take()
        assert frame is not None
        log.note(frame, session.fork)
    assert log.messages == (row,)
