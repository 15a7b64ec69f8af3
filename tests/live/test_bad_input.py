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

from nctakt.live.drawings import MAX_UNDER_WAY, Drawings
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
    """It is told that it is gone; the run goes on, and what cannot be loaded is refused by name."""
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


def test_a_browser_that_does_not_draw_is_behind() -> None:
    """It gets nothing more until it has drawn; what no server has sent is no answer."""
    drawings = Drawings.__new__(Drawings)
    drawings._number, drawings._drawn = MAX_UNDER_WAY, 0
    for answer in (None, "1", 0, MAX_UNDER_WAY + 1):
        drawings.note_drawn(SimpleNamespace(args=answer))
        assert drawings.are_behind
    drawings.note_drawn(SimpleNamespace(args=1))
    assert not drawings.are_behind
