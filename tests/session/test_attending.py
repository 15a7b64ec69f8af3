# SPDX-License-Identifier: MIT
"""Sessions: acknowledgements after a delay, what a page shows of a tick, why reactions fired."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from nctakt import NcText
from nctakt.session import Session
from nctakt.session.listening import Listener

pytestmark = pytest.mark.slow

PROGRAM = """\
#RT CYCLE [ID=1 SCOPE=PROG]
  $IF EDGE V.RTA.ACS.ACT_POS.X > 5
    V.E.COUNT += 1
  $ENDIF
#RT CYCLE END
G01 X10 F6000
M100
G01 X0
M30
"""


@pytest.fixture
def session() -> Iterator[Session]:
    with Session(NcText("p.nc", PROGRAM), acknowledges=False) as session:
        yield session


def test_functions_are_acknowledged_after_a_delay(session: Session) -> None:
    """In the tick that the delay names; the tape holds it, and going back changes nothing."""
    session.acknowledge_after(7)
    end = session.run().tick
    (handed,) = [event for event in session.events(0, end)[0] if event.kind == "output"]
    answers = [one for one in session.tape() if one.source == "automatic"]
    assert [one.tick for one in answers] == [handed.tick + 7]
    session.go_to(handed.tick)
    assert session.run().tick == end
    assert session.branches == {1: end}
    assert [one for one in session.tape() if one.source == "automatic"] == answers


def test_the_delay_can_begin_while_a_function_waits(session: Session) -> None:
    """Its time has passed, so it is acknowledged at once; none begins before a tick."""
    session.run("0.15 s")
    assert [entry.name for _, entry in session.state_view().waiting] == ["M100"]
    session.acknowledge_after(7)
    session.step(2)
    assert session.state_view().waiting == ()
    with pytest.raises(ValueError, match="0"):
        session.acknowledge_after(0)


def test_a_glance_is_of_one_tick(session: Session) -> None:
    """Values, cycles and what waits; the decoder is ahead of the path."""
    session.step(20)
    state_view = session.state_view("X.ACS.ACT_POS", "V.E.COUNT")
    assert state_view.values == tuple(session.read("X.ACS.ACT_POS", "V.E.COUNT"))
    assert state_view.cycles == tuple(session.cycles())
    assert session.latest.blocks[1].line == 6
    assert session.latest.decoding[1].line == 9


def test_events_of_the_past(session: Session) -> None:
    """Those of the ticks that are asked for, and the session stays."""
    session.run("0.5 s")
    tick = session.tick
    events, left_out = session.events(1, tick)
    assert [event.kind for event in events if event.kind in ("fired", "output")] == [
        "fired",
        "output",
    ]
    assert (left_out, session.tick) == (0, tick)


def test_why(session: Session) -> None:
    """The report of ``nctakt why``, of the session's own past."""
    session.run("0.15 s")
    text = session.why().select(line=2).render_at(session.tick - 1)
    assert "true since tick" in text


def test_who_is_woken_waits_no_longer_for_a_frame() -> None:
    """A command that changes what there is to see must not wait until a frame is due."""
    listener = Listener((), 20.0)
    listener.wake()
    assert listener.take(600.0) is None
