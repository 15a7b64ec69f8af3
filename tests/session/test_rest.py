# SPDX-License-Identifier: MIT
"""A session ends where nothing can happen any more by itself, and says what it waits for."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import ExitStack
from typing import Any

import pytest

from nctakt import NcText, Session
from nctakt.session.engine import StepResult

pytestmark = pytest.mark.slow

BLOCKS = "G01 X1 F6000\nG01 X2\nM00\nG01 X3\nM30\n"
CYCLE = """\
#RT CYCLE [ID=1 SCOPE=PROG]
V.E.COUNT += 1
$IF V.E.COUNT > 5000
V.E.VALUE = 1
$ENDIF
#RT CYCLE END
"""


@pytest.fixture
def opened() -> Iterator[Any]:
    """Opens sessions; single block is on unless ``single`` is false."""
    with ExitStack() as files:

        def begin(text: str = BLOCKS, *, single: bool = True, **options: Any) -> Session:
            words = {"set": {"HLI.SINGLE_BLOCK": 1}} if single else {}
            program = NcText("part.nc", text)
            return files.enter_context(Session(program, until="24 h", **{**words, **options}))

        yield begin


def reported(done: StepResult) -> list[tuple[int, str]]:
    """The notes of a slice that nothing happens any more: line and text."""
    return [
        (one.span.line if one.span else 0, one.headline("en"))
        for one in done.diagnostics
        if one.id == 901925
    ]


def test_the_next_block_in_single_block_waits_for_start(opened: Any) -> None:
    """It is in the tick in which single block has stopped; START leads to the next block."""
    session = opened()
    assert session.next_block().blocks[1].line == 1
    done = session.next_block()
    assert done.is_resting
    assert [line for line, _ in reported(done)] == [2]
    assert "START in single block mode" in reported(done)[0][1]
    assert session.read("X.ACS.CMD_POS") == [1.0]
    assert any(event.kind == "paused" and event.tick == done.tick - 1 for event in done.events)
    tick = session.tick
    again = session.next_block()
    assert (again.tick, again.is_resting, len(reported(again))) == (tick, True, 1)
    session.write({"HLI.START": 1})
    assert session.next_block().blocks[1].line == 2


@pytest.mark.nightly
def test_a_run_ends_at_m00_and_in_feed_hold_and_at_an_override_of_0(opened: Any) -> None:
    """In the same tick wherever it is cut: multiples of 1000 where no event shows the stop."""
    session = opened(single=False)
    done = session.run()
    assert done.is_resting
    assert "START after M00" in reported(done)[0][1]
    for name, value, text in (
        ("HLI.FEED_HOLD", 1, "end of the feed hold"),
        ("HLI.OVERRIDE", 0, "an override above 0"),
    ):
        held = opened(single=False)
        held.step(3)
        held.write({name: value})
        done = held.run()
        assert (done.is_resting, done.tick) == (True, 1000)
        assert text in reported(done)[0][1]


def test_what_can_still_happen_is_awaited(opened: Any) -> None:
    """A planned START, a condition over time, a realtime cycle; and a time that was named."""
    planned = opened(at=[("2 s", "HLI.START", 1)])
    planned.next_block()
    assert planned.next_block().blocks[1].line == 2
    assert planned.tick == 2001
    session = opened(CYCLE + BLOCKS)
    session.next_block()
    assert session.next_block().is_resting  # no cycle makes a block current
    assert "fired" in [event.kind for event in session.next_reaction().events]
    timed = opened()
    assert not timed.run("5 s").is_resting
    assert timed.tick == 5000
    assert not timed.run("7 s", until="V.E.COUNT > 0", rests=True).is_resting
    assert timed.run("9 s", rests=True).is_resting
    assert timed.tick == 7000


def test_a_function_that_nobody_acknowledges_is_reported(opened: Any) -> None:
    """Acknowledged by hand; with an automatic acknowledgement it goes on."""
    text = "M111\nG01 X1 F6000\nM30\n"
    session = opened(text, single=False, acknowledges=False)
    done = session.run()
    assert done.is_resting
    assert "the PLC's acknowledgement of M111" in reported(done)[0][1]
    ((channel, entry),) = session.waiting()
    session.acknowledge(channel, entry)
    assert session.run().run_state == "ended"


def test_a_run_that_is_over_waits_for_nothing() -> None:
    """To run on at its end gives no advice to start a program."""
    with Session(NcText("part.nc", "G01 X1 F6000\nM30")) as session:
        for _ in range(3):
            done = session.run()
            assert (done.run_state, done.diagnostics, done.is_resting) == ("ended", (), False)
