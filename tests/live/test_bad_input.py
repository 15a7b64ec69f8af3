# SPDX-License-Identifier: MIT
"""What must not harm the page: files that are gone, floods, browsers that do not draw.

Nothing that the page shows then is false, it can be used, and what it holds is bounded.
"""

import re
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from support.page_driving import BROWSER, chromium, opened, served

from nctakt.live.document import MAX_EDITED_LINES
from nctakt.live.drawings import MAX_UNDER_WAY, Drawings, _Sent
from nctakt.live.track import MAX_BLOCKS, MAX_MARKS, MAX_ROWS, MAX_SAMPLES

if find_spec("nicegui") is None:  # its import takes long, and only the page's process needs it
    pytest.skip("the live page needs NiceGUI", allow_module_level=True)
playwright = pytest.importorskip("playwright.sync_api", reason="driving a browser needs Playwright")
expect = playwright.expect

pytestmark = BROWSER

#: A program that never ends, whose branch fires in every second tick.
FLOOD = """#RT CYCLE [ID=1 SCOPE=PROG]
  $IF V.E.COUNT == 0
    V.E.COUNT = 1
  $ELSE
    V.E.COUNT = 0
  $ENDIF
#RT CYCLE END
$WHILE 1 == 1
  G01 X20 F6000
  X0
$ENDWHILE
M30
"""

SHORT = "G01 X20 F6000\nM30\n"


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    with chromium() as browser:
        yield browser


def written(folder: Path, text: str) -> Path:
    """A program in a file."""
    path = folder / "part.nc"
    path.write_text(text, "utf-8")
    return path


def choose_max(page: Any) -> None:
    """Let the run be as fast as it can."""
    page.get_by_test_id("speed").click()
    page.get_by_role("option", name="max").click()


@pytest.mark.nightly
def test_a_file_that_is_deleted(browser: Any, tmp_path: Path) -> None:
    """The browser is informed; the run continues, and what cannot be loaded is refused by name."""
    path = written(tmp_path, SHORT)
    with served(str(path)) as address:
        page = opened(browser, address)
        path.unlink()
        expect(page.get_by_text("gone from disk")).to_be_visible()
        page.get_by_test_id("tick").click()
        expect(page.get_by_test_id("clock")).to_contain_text("Tick 0 ")
        page.get_by_test_id("load").click()
        expect(page.get_by_text(re.compile("9005.*part.nc")).first).to_be_visible()
        expect(page.get_by_test_id("clock")).to_contain_text("Tick 0 ")
        path.write_text(SHORT, "utf-8")
        expect(page.get_by_test_id("load")).to_be_hidden()
        page.close()


def test_a_flood_without_end(browser: Any, tmp_path: Path) -> None:
    """Some 10^5 events a second: bounded on both sides, counted where left out, and it pauses."""
    with served(str(written(tmp_path, FLOOD))) as address:
        page = opened(browser, address)
        page.get_by_test_id("tab-events").click()
        choose_max(page)
        page.get_by_test_id("toggle").click()
        page.wait_for_function("nctaktRun.run.tick > 200000")
        page.get_by_test_id("toggle").click()
        expect(page.get_by_test_id("state")).to_have_text("paused")
        tick = page.evaluate("nctaktRun.run.tick")
        sizes = page.evaluate(
            "['ticks', 'marks', 'blocks', 'lanes'].map((n) => nctaktRun.run[n].length)"
        )
        for size, bound in zip(sizes, (MAX_ROWS, MAX_MARKS, MAX_BLOCKS, MAX_SAMPLES), strict=True):
            assert size <= bound
        rows = page.get_by_test_id("events").locator(".nc-finding > .nc-rows > :first-child")
        expect(rows.first).to_contain_text(re.compile(rf"^{tick} |^{tick - 1} "))
        texts = rows.all_inner_texts()
        assert len(texts) <= 81
        assert re.search(r"left out", texts[-1])
        ran = page.locator(".nc-inline").first.inner_text()
        page.get_by_test_id("tick").click()
        expect(page.get_by_test_id("clock")).to_contain_text(f"Tick {tick + 1} ")
        # it fires in the ticks 0, 2, 4 …
        assert ran.endswith(f"ran {tick // 2 + 1}×")
        page.close()


@pytest.mark.nightly
def test_a_long_file_that_is_replaced_or_deleted(browser: Any, tmp_path: Path) -> None:
    """It stays as it was opened until it is reloaded, as another long one or a short one."""
    long = [f"G01 X{number % 2} F6000" for number in range(MAX_EDITED_LINES + 5)]
    other = [line.replace("X", "Y") for line in [*long, "M30"]]
    path = written(tmp_path, "\n".join(long) + "\n")
    with served(str(path)) as address:
        page = opened(browser, address)
        first = page.locator(".cm-line").first
        length, load = page.get_by_test_id("length"), page.get_by_test_id("load")
        expect(first).to_have_text(long[0])
        path.write_text("\n".join(other) + "\n", "utf-8")
        expect(page.get_by_text("changed on disk")).to_be_visible()
        expect(first).to_have_text(long[0])
        page.get_by_test_id("find").fill(str(MAX_EDITED_LINES))
        page.get_by_test_id("find").press("Enter")
        expect(page.locator(".cm-line").get_by_text(long[MAX_EDITED_LINES]).first).to_be_visible()
        load.click()
        expect(length).to_contain_text(f"{len(other):,} lines")
        expect(page.locator(".cm-line").get_by_text("Y1").first).to_be_visible()
        path.unlink()
        expect(page.get_by_text("gone from disk")).to_be_visible()
        page.get_by_test_id("find").fill("1")
        page.get_by_test_id("find").press("Enter")
        expect(first).to_have_text(other[0])
        path.write_text(SHORT, "utf-8")
        load.click()
        expect(length).to_be_hidden()
        expect(first).to_have_text("G01 X20 F6000")
        page.locator(".cm-content").click()
        page.keyboard.type("G999 ")
        expect(page.get_by_text("● not saved")).to_be_visible()
        page.close()


@pytest.mark.nightly
def test_a_browser_that_sleeps(browser: Any, tmp_path: Path) -> None:
    """Its connection ends; awake it shows the session as it is, and what was written unsaved."""
    path = written(tmp_path, FLOOD)
    with served(str(path)) as address:
        page, other = opened(browser, address), opened(browser, address)
        page.locator(".cm-content").click()
        page.keyboard.press("Control+Home")
        page.keyboard.type("; written, not saved")
        page.keyboard.press("Enter")
        expect(page.get_by_text("● not saved")).to_be_visible()
        page.evaluate("globalThis.isOld = true")
        link = page.context.new_cdp_session(page)
        link.send("Debugger.enable")
        link.send("Debugger.pause")
        other.wait_for_timeout(12_000)  # longer than the server waits for a sign of life
        for _ in range(200):  # it has given up control, once its place is free
            other.get_by_test_id("control").click()
            other.get_by_test_id("tick").click()
            if "before" not in other.get_by_test_id("clock").inner_text():
                break
            other.wait_for_timeout(100)
        expect(other.get_by_test_id("clock")).to_contain_text("Tick ")
        other.get_by_test_id("home").click()
        expect(other.get_by_test_id("clock")).to_contain_text("before tick 0 ")
        link.send("Debugger.resume")
        link.send("Debugger.disable")
        page.wait_for_function("!globalThis.isOld")
        expect(page.get_by_test_id("clock")).to_contain_text("before tick 0 ")
        expect(page.locator(".cm-line").first).to_contain_text("; written, not saved")
        expect(page.get_by_text("● not saved")).to_be_visible()
        assert path.read_text("utf-8") == FLOOD
        page.close()
        other.close()


def test_what_is_not_saved_outlives_the_page(browser: Any, tmp_path: Path) -> None:
    """It is there when the page is reloaded; what is saved is not, nor what is no text."""
    path = written(tmp_path, SHORT)
    with served(str(path)) as address:
        page = opened(browser, address)
        first = page.locator(".cm-line").first
        expect(first).to_have_text("G01 X20 F6000")
        page.locator(".cm-content").click()
        page.keyboard.press("Control+Home")
        page.keyboard.type("; mine")
        expect(page.get_by_text("● not saved")).to_be_visible()
        page.reload()
        expect(first).to_have_text("; mineG01 X20 F6000")
        expect(page.get_by_text("● not saved")).to_be_visible()
        page.locator(".cm-content").click()
        page.keyboard.press("Control+s")
        expect(page.get_by_text("● not saved")).to_be_hidden()
        assert path.read_text("utf-8") == f"; mine{SHORT}"
        page.wait_for_function("Object.keys(sessionStorage).every((name) => !/draft/.test(name))")
        page.evaluate("sessionStorage.setItem('nctakt draft x', '[1, {}]')")
        page.reload()
        expect(first).to_have_text("; mineG01 X20 F6000")
        page.close()


@pytest.mark.nightly
def test_two_browsers_and_two_branches(browser: Any, tmp_path: Path) -> None:
    """Each writes in the past; both show the same branch, with its curves, marks and variables."""
    with served(str(written(tmp_path, FLOOD))) as address:
        pages = opened(browser, address), opened(browser, address)
        for number, page in enumerate((*pages, *pages), 2):
            page.get_by_test_id("control").click()
            page.get_by_test_id("home").click()
            expect(page.get_by_test_id("clock")).to_contain_text("before tick 0 ")
            page.get_by_test_id("tick").click()
            page.get_by_test_id("tick").click()
            page.get_by_test_id("back_tick").click()
            expect(page.get_by_test_id("clock")).to_contain_text("Tick 0 ")
            field = page.get_by_test_id("variable-V.E.VALUE")
            field.fill(str(number))
            field.press("Enter")
            page.get_by_test_id("tick").click()
            for one in pages:
                clock = one.get_by_test_id("clock")
                expect(clock).to_contain_text(re.compile(f"Tick 1 .*Branch {number}"))
                expect(one.get_by_test_id("variable-V.E.VALUE")).to_have_value(str(number))
                one.wait_for_function("nctaktRun.run.ticks.at(-1) === 1")
            known = [one.evaluate("[nctaktRun.run.columns, nctaktRun.run.marks]") for one in pages]
            assert known[0] == known[1]
        for page in pages:
            page.close()


def test_a_browser_that_does_not_draw_is_behind() -> None:
    """Until it has drawn, it gets no more than that a run has stopped; unsent data does not count.

    Once it has drawn what was missing it is looked at again at once.
    """
    looks: list[bool] = []
    drawings = Drawings.__new__(Drawings)
    drawings._go_on = lambda: looks.append(drawings.are_behind)
    drawings._shared = SimpleNamespace(snapshot=SimpleNamespace(is_playing=True))
    drawings._sent = _Sent({"isPlaying": True}, number=MAX_UNDER_WAY)
    for answer in (None, "1", 0, MAX_UNDER_WAY + 1):
        drawings.note_drawn(SimpleNamespace(args=answer))
        assert drawings.are_behind
    assert looks == []
    drawings._shared.snapshot.is_playing = False
    assert not drawings.are_behind
    drawings._sent.content = {"isPlaying": False}
    drawings._sent.number = MAX_UNDER_WAY + 1
    assert drawings.are_behind
    drawings._shared.snapshot.is_playing = True
    assert drawings.are_behind
    drawings._shared.snapshot.is_playing = False
    drawings.note_drawn(SimpleNamespace(args=2))
    assert looks == [False]
