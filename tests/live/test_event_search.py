# SPDX-License-Identifier: MIT
"""The search of the page finds every event of the branch, while the session lives on."""

import random
import re
import time
from collections.abc import Callable, Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest
from support.page_driving import BROWSER, axe_source, chromium, opened, serious, served
from support.random_seeds import seeds_in_parts

from nctakt import Controller, NcText, Session
from nctakt.live.searching import MAX_KEPT, Search, Searches
from nctakt.results.trace.event_words import event_text
from nctakt.results.trace.events import Event

#: Writes in many ticks, functions, messages: some thousand events.
PROGRAM = """#RT CYCLE [ID=1 SCOPE=PROG]
  $IF V.RTA.ACS.ACT_POS.X > 5
    V.E.COUNT += 1
  $ENDIF
#RT CYCLE END
$FOR P1 = 1, 40, 1
  G01 X10 F6000
  #MSG ["part %d" P1]
  X0
  M7
$ENDFOR
M30
"""


def matching(events: list[Event], text: str) -> list[Event]:
    """The events whose line contains a text."""
    return [one for one in events if text.casefold() in event_text(one, "en").casefold()]


def until(is_so: Callable[[], bool]) -> None:
    """Wait until a condition holds."""
    end_s = time.monotonic() + 60
    while not is_so():
        assert time.monotonic() < end_s
        time.sleep(0.01)


@pytest.fixture
def session() -> Iterator[Session]:
    with Session(NcText("part.nc", PROGRAM)) as session:
        yield session


@pytest.fixture
def searches() -> Iterator[Searches]:
    searches = Searches()
    yield searches
    searches.close()


@pytest.fixture(scope="module")
def events() -> list[Event]:
    return list(Controller().run(NcText("part.nc", PROGRAM), blocks=True).events)


def begun(searches: Searches, session: Session, text: str) -> Search:
    """A search that has begun."""
    search = Search(session, text, "en")
    searches.begin(search)
    return search


def test_all_matches_are_kept_up_to_a_number(
    session: Session, searches: Searches, events: list[Event]
) -> None:
    """A few matches are all there; of many the newest, and from which tick on they are all."""
    session.run()
    few, many = (begun(searches, session, text) for text in ("part 3", "written"))
    until(lambda: few.is_done and many.is_done)
    assert (list(few.events), few.begin) == (matching(events, "part 3"), 0)
    wanted = matching(events, "written")
    assert len(wanted) > MAX_KEPT
    assert list(many.events) == wanted[-MAX_KEPT:]
    assert many.begin == wanted[-MAX_KEPT].tick + 1
    many.turn(is_older=True)
    searches.go_on()
    until(lambda: many.is_done and not many.is_newest)
    assert many.events[-1] == wanted[-MAX_KEPT]
    many.turn(is_older=False)
    searches.go_on()
    until(lambda: many.is_done and many.is_newest)
    assert list(many.events) == wanted[-MAX_KEPT:]


@pytest.mark.parametrize("text", ["part 3", "m7", "written", "V.E.COUNT 1", "zzz", "107"])
def test_previous_and_next(
    session: Session, searches: Searches, events: list[Event], text: str
) -> None:
    """From any tick, the previous and the next match are those of the whole run."""
    session.run()
    chance = random.Random(text)
    ticks = [one.tick for one in matching(events, text)]
    search = begun(searches, session, text)
    for _ in range(30):
        tick = chance.randrange(-1, session.tick + 1)
        for is_back in chance.sample((True, False), 2):
            answer = search.hop(tick, is_back=is_back)
            searches.go_on()
            if is_back:
                wanted = max((one for one in ticks if one < tick), default=None)
            else:
                wanted = min((one for one in ticks if one > tick), default=None)
            assert answer.result(60) == wanted, (tick, is_back)


def test_of_two_wishes_the_later_one_counts(session: Session, searches: Searches) -> None:
    """Who asks again gets the answer to that; the question before is answered with nothing."""
    session.run()
    search = Search(session, "part 3", "en")
    first, second = search.hop(10**6, is_back=True), search.hop(10**6, is_back=True)
    searches.begin(search)
    assert second.result(60) is not None
    assert first.result(60) is None


def test_a_closed_session_ends_the_search(session: Session, searches: Searches) -> None:
    """The search says why it has ended, and who waits for a match gets none."""
    session.run()
    search = begun(searches, session, "part 3")
    until(lambda: search.is_done)
    session.close()
    far = Search(session, "written", "en")
    searches.begin(far)
    until(lambda: far.error is not None)
    assert "901155" in str(far.error)


@pytest.mark.nightly
@seeds_in_parts(2, 1, 2)
def test_new_events_while_the_session_plays(seeds: range) -> None:
    """Whatever plays, pauses and travels: once at rest, the matches are those of the branch."""
    for seed in seeds:
        chance, searches = random.Random(seed), Searches()
        with Session(NcText("part.nc", PROGRAM)) as session:
            search = begun(searches, session, "part")
            for _ in range(12):
                match chance.randrange(3):
                    case 0:
                        session.play(chance.choice((1.0, 10.0, None)))
                        time.sleep(0.05)
                    case 1:
                        session.pause()
                    case _:
                        session.go_to(chance.randrange(session.branches[1] + 1))
            session.pause()
            end = session.branches[1]
            until(lambda one=search, end=end: one.is_done and one.end == end)  # type: ignore[misc]
            session.go_to(session.branches[1])
            wanted = session.happened(0, session.tick).messages
            texts = [one.text for one in search.events if one.kind == "message"]
            assert texts == [one.text for one in wanted]
            searches.close()


# --- in a browser -------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    with chromium() as browser:
        yield browser


def _with_a_browser(test: Any) -> Any:
    """A test that drives a browser, where there is one."""
    missing = find_spec("nicegui") is None or find_spec("playwright") is None
    for mark in (*BROWSER, pytest.mark.skipif(missing, reason="needs NiceGUI and Playwright")):
        test = mark(test)
    return test


def run_to_the_end(page: Any) -> None:
    """Let the page run its program at full speed."""
    page.get_by_test_id("speed").click()
    page.get_by_role("option", name="max", exact=True).click()
    page.get_by_test_id("toggle").click()
    page.wait_for_function(
        "document.querySelector('[data-testid=state]').textContent.startsWith('ended')"
    )


def listed(page: Any) -> list[str]:
    """The texts of the rows of events."""
    return list(page.locator("[data-testid=events] .nc-rows > :first-child").all_text_contents())


@_with_a_browser
def test_search_by_keyboard(browser: Any, tmp_path: Path, events: list[Event]) -> None:
    """Shift+F, a text, Enter: the session goes back from match to match; N and Shift+N continue.

    What is found is announced; axe-core finds nothing serious.
    """
    path = tmp_path / "part.nc"
    path.write_text(PROGRAM, "utf-8")
    with served(str(path)) as address:
        page = opened(browser, address)
        run_to_the_end(page)
        page.keyboard.press("Shift+F")
        page.wait_for_function("document.activeElement.closest('[data-testid=search-events]')")
        page.keyboard.type("part 3")
        announced, clock = page.get_by_test_id("search-announced"), page.get_by_test_id("clock")
        wanted = matching(events, "part 3")
        page.wait_for_function(
            "count => document.querySelectorAll('[data-testid=events] .nc-finding').length"
            " === count",
            arg=len(wanted),
        )
        assert listed(page) == [event_text(one, "en") for one in reversed(wanted)]
        page.wait_for_function(
            "text => document.querySelector('[data-testid=search-announced]').textContent === text",
            arg=f"Found: {len(wanted)}",
        )
        assert announced.get_attribute("role") == "status"
        for keys, index in (("Enter", -1), ("Enter", -2), ("Shift+Enter", -1), ("Enter", -2)):
            page.keyboard.press(keys)
            tick = wanted[index].tick
            page.wait_for_function(
                "text => document.querySelector('[data-testid=clock]').textContent.includes(text)",
                arg=f"Tick {tick} ",
            )
            page.wait_for_selector("[data-testid=events] [aria-current=true]")
            assert announced.text_content() == f"Match in tick {tick}."
        page.keyboard.press("Escape")
        for keys, index in (("N", -3), ("n", -2), ("n", -1), ("n", -1)):
            page.keyboard.press("Shift+N" if keys == "N" else keys)
            page.wait_for_function(
                "text => document.querySelector('[data-testid=clock]').textContent.includes(text)",
                arg=f"Tick {wanted[index].tick} ",
            )
        page.wait_for_function(
            "document.querySelector('[data-testid=search-announced]')"
            ".textContent.startsWith('No match')"
        )
        assert re.search(r"Tick \d", clock.text_content())
        assert serious(page, axe_source(tmp_path)) == []
        page.close()


@_with_a_browser
def test_pages_of_matches_and_signals(browser: Any, tmp_path: Path, events: list[Event]) -> None:
    """Many matches come in pages; a signal whose name contains the text is put into the scope."""
    path = tmp_path / "part.nc"
    path.write_text(PROGRAM, "utf-8")
    with served(str(path), "--lang", "de") as address:
        page = opened(browser, address)
        page.get_by_test_id("tab-events").click()
        field = page.get_by_test_id("search-events")
        field.fill("geschrieben V.E.COUNT")
        page.get_by_test_id("speed").click()
        page.get_by_role("option", name="max", exact=True).click()
        page.get_by_test_id("toggle").click()
        wanted = [one for one in events if one.kind == "written"]
        first = event_text(wanted[-1], "de")
        rows = page.locator("[data-testid=events] .nc-rows > :first-child")
        page.wait_for_function(
            "text => document.querySelector('[data-testid=events] .nc-rows > :first-child')"
            "?.textContent === text",
            arg=first,
        )
        assert rows.count() == 80
        page.get_by_test_id("older_matches").click()
        page.wait_for_function(
            "text => document.querySelector('[data-testid=events] .nc-rows > :first-child')"
            "?.textContent === text",
            arg=event_text(wanted[-81], "de"),
        )
        page.get_by_test_id("newer_matches").click()
        page.wait_for_function(
            "text => document.querySelector('[data-testid=events] .nc-rows > :first-child')"
            "?.textContent === text",
            arg=first,
        )
        field.fill("y.acs.cmd_pos")
        page.get_by_text("Im Oszilloskop zeigen: Y.ACS.CMD_POS").click()
        page.wait_for_function("nctaktRun.run.names.includes('Y.ACS.CMD_POS')")
        page.wait_for_function(
            "text => document.querySelector('[data-testid=search-announced]').textContent === text",
            arg="Kein Ereignis enthält das.",
        )
        field.fill("")
        page.wait_for_function(
            "document.querySelectorAll('[data-testid=events] .nc-finding').length > 70"
        )
        assert page.get_by_test_id("next_match").is_hidden()
        page.close()
