# SPDX-License-Identifier: MIT
"""A search finds all events of a branch whose line has a text, while the session goes on."""

from __future__ import annotations

import random
import threading
import time
from collections.abc import Iterator

import pytest
from support.random_seeds import seeds_in_parts

from nctakt import Controller, NcText, Session
from nctakt.base.diagnostics import Language
from nctakt.results.trace.event_words import MAX_SOUGHT, SoughtEvents, event_text
from nctakt.results.trace.events import Event
from nctakt.session.history.event_search import EventSearch

#: Two axes, writes in many ticks, functions, messages; V.E.VALUE adds events.
PROGRAM = """#RT CYCLE [ID=1 SCOPE=PROG]
  $IF V.RTA.ACS.ACT_POS.X > 5
    V.E.COUNT += 1
  $ENDIF
  $IF EDGE V.E.VALUE > 0.5
    V.E.FLAG = 1
    M100
  $ENDIF
#RT CYCLE END
$FOR P1 = 1, 12, 1
  G01 X10 F6000
  #MSG ["part %d" P1]
  X0
  M7
$ENDFOR
M30
"""

TEXTS = ("m7", "REACTION", "part 1", "v.e.count 2", "17", "100  written", "M100", "block", "zzz")


@pytest.fixture
def session() -> Iterator[Session]:
    with Session(NcText("part.nc", PROGRAM)) as session:
        yield session


def filtered(events: list[Event], text: str, language: Language = "en") -> list[Event]:
    """The events whose line contains a text, by a loop over all of them."""
    sought = " ".join(text.casefold().split())
    lines = (" ".join(event_text(one, language).casefold().split()) for one in events)
    return [one for one, line in zip(events, lines, strict=True) if sought in line]


def all_events(session: Session) -> list[Event]:
    """All events of the branch, a few ticks at a time."""
    found: list[Event] = []
    for first in range(0, session.branches[session.branch], 500):
        events, left_out = session.events(first, first + 500)
        assert not left_out
        found += events
    return found


def backward(search: EventSearch, end: int, sought: SoughtEvents) -> tuple[list[Event], int]:
    """All that is found before a tick, and how many are left out."""
    events: list[Event] = []
    left_out, begin = 0, end
    for found in search.before(end, sought):
        if found is not None:
            assert found.end == begin
            begin = found.first
            events[:0] = found.events
            left_out += found.left_out
    assert begin == 0
    return events, left_out


def forward(search: EventSearch, first: int, sought: SoughtEvents) -> tuple[list[Event], int]:
    """All that is found from a tick on, and how many are left out."""
    events: list[Event] = []
    left_out = 0
    for found in search.since(first, sought):
        if found is None:
            continue
        assert found.first == first
        first = found.end
        events += found.events
        left_out += found.left_out
        if found.end == found.first:
            break
    assert first == search.latest
    return events, left_out


def test_it_finds_what_a_run_has(session: Session) -> None:
    """The run's own events, filtered, are those that a search back, or on, finds."""
    session.run()
    events = list(Controller().run(NcText("part.nc", PROGRAM), blocks=True).events)
    assert events == all_events(session)
    search = session.event_search()
    for text in TEXTS:
        wanted = filtered(events, text)
        assert bool(wanted) is (text not in ("M100", "zzz")), text
        for find, at in ((backward, search.latest), (forward, 0)):
            assert find(search, at, SoughtEvents(text, "en", 100_000)) == (wanted, 0), text


def test_it_knows_the_words_of_both_languages(session: Session) -> None:
    """What a page in German calls a reaction is found there by that name, and only there."""
    session.run()
    search, events = session.event_search(), all_events(session)
    german = SoughtEvents("reaktion", "de", 100_000)
    found, _ = backward(search, search.latest, german)
    assert found == filtered(events, "Reaktion", "de")
    assert {one.kind for one in found} == {"fired"}
    assert backward(search, search.latest, SoughtEvents("reaktion", "en", 9)) == ([], 0)


@pytest.mark.parametrize("count", [1, 7, 1000])
def test_what_it_keeps_is_bounded(session: Session, count: int) -> None:
    """Of more events the latest of each stretch are kept, or the first, and the others counted."""
    session.run()
    search, wanted = session.event_search(), filtered(all_events(session), "written")
    assert len(wanted) > 1000
    for find, at in ((backward, search.latest), (forward, 0)):
        for is_latest in (True, False):
            sought = SoughtEvents("written", "en", count, is_latest)
            found, left_out = find(search, at, sought)
            assert len(found) + left_out == len(wanted)
    latest = next(filter(None, search.before(search.latest, SoughtEvents("written", "en", count))))
    assert list(latest.events) == wanted[-len(latest.events) :]
    first = next(filter(None, search.since(0, SoughtEvents("written", "en", count, False))))
    assert list(first.events) == wanted[: len(first.events)]


def test_a_text_has_at_most_so_many_characters(session: Session) -> None:
    """Characters beyond that are not looked at."""
    session.run()
    search = session.event_search()
    name = "x" * MAX_SOUGHT
    assert backward(search, search.latest, SoughtEvents(name, "en", 9)) == ([], 0)
    spaces = "m7" + " " * MAX_SOUGHT + "zzz"
    assert backward(search, search.latest, SoughtEvents(spaces, "en", 99))[0]


def test_new_events_are_found_as_they_come(session: Session) -> None:
    """A search that has come to the latest tick goes on with the branch, inputs and all."""
    session.step(300)
    steps = session.event_search().since(0, SoughtEvents("", "en", 100_000))
    found: list[Event] = []
    for _ in range(8):
        session.step(97)
        session.write({"V.E.VALUE": session.tick % 2}, "page")
        for step in steps:
            if step is not None:
                found += step.events
                if step.end == step.first:
                    break
    session.step(1)
    for step in steps:
        if step is not None:
            found += step.events
            if step.end == step.first:
                break
    assert found == all_events(session)
    assert any(one.kind == "M" for one in found)


def test_the_session_goes_on_meanwhile() -> None:
    """While a long past is searched, the session plays, pauses, travels and begins a branch."""
    text = PROGRAM.replace("1, 12, 1", "1, 700, 1")
    with Session(NcText("part.nc", text)) as session:
        session.run("120 s")
        search = session.event_search()
        found: list[Event] = []

        def work() -> None:
            found.extend(backward(search, 120_000, SoughtEvents("part 7", "en", 100_000))[0])

        thread = threading.Thread(target=work)
        thread.start()
        longest_s = 0.0
        while thread.is_alive():
            for act in (session.play, session.pause, lambda: session.go_to(session.tick - 50)):
                begin_s = time.monotonic()
                act()
                longest_s = max(longest_s, time.monotonic() - begin_s)
            session.write({"V.E.VALUE": 1}, "page")
        thread.join()
        assert search.branch == 1
        assert session.branch > 1
        assert longest_s < 2.0
        session.go_to(120_000, 1)
        messages = [one.text for one in session.happened(0, 120_000).messages]
        assert [one.text for one in found] == [one for one in messages if "part 7" in one]


@pytest.mark.nightly
@seeds_in_parts(3, 1, 3)
def test_any_branch_and_any_text(seeds: range) -> None:
    """After any travels and branches, a search of the branch is its events, filtered."""
    for seed in seeds:
        chance = random.Random(seed)
        with Session(NcText("part.nc", PROGRAM)) as session:
            for _ in range(12):
                match chance.randrange(4):
                    case 0 | 1:
                        session.step(chance.randrange(1, 200))
                    case 2:
                        branch = chance.choice(list(session.branches))
                        session.go_to(chance.randrange(session.branches[branch] + 1), branch)
                    case _:
                        session.write({"V.E.VALUE": chance.randrange(3)}, "page")
                        session.step(1)
            text, branch = chance.choice(TEXTS), session.branch
            search, events = session.event_search(), all_events(session)
            assert search.branch == branch
            sought = SoughtEvents(text, "en", 100_000)
            at = chance.randrange(search.latest + 1)
            before = [one for one in events if one.tick < at]
            assert backward(search, at, sought)[0] == filtered(before, text), seed
            assert forward(search, at, sought)[0] == filtered(events[len(before) :], text), seed
