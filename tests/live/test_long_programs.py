# SPDX-License-Identifier: MIT
"""A program of a million lines on the page: its lines come by request, each at its place.

What the browser shows is compared with the file and with a session of it.
"""

import random
import re
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest
from support.page_driving import BROWSER, chromium, opened, served

from nctakt import Session
from nctakt.live.document import MAX_EDITED_LINES
from nctakt.live.words import line_found

if find_spec("nicegui") is None:  # its import takes long, and only the page's process needs it
    pytest.skip("the live page needs NiceGUI", allow_module_level=True)
playwright = pytest.importorskip("playwright.sync_api", reason="driving a browser needs Playwright")
expect = playwright.expect

pytestmark = BROWSER

LINES = 1_000_000

#: What is at the lines in view that have come: their numbers and texts.
IN_VIEW = """() => {
  const { id } = document.querySelector("[data-testid=editor]");
  const view = getElement(Number(id.slice(1))).editor;
  const room = view.scrollDOM.getBoundingClientRect(), found = [];
  for (const line of view.contentDOM.querySelectorAll(".cm-line")) {
    const { top, bottom } = line.getBoundingClientRect();
    if (top < room.top - 1 || bottom > room.bottom + 1) continue;
    const { number, text } = view.state.doc.lineAt(view.posAtDOM(line));
    found.push([number, text, line.textContent, line.className]);
  }
  return found;
}"""

#: Whether all lines in view have come; there are no empty ones in the program.
HAVE_COME = f"""() => {{
  const lines = ({IN_VIEW})();
  return lines.length > 5 && lines.every(([, text]) => text);
}}"""

#: In how many of twenty looks, while it plays, the block is marked in view among lines that have
#: all come.
LOOKS = f"""async () => {{
  let seen = 0;
  for (let look = 0; look < 20; look += 1) {{
    await new Promise((done) => setTimeout(done, 50));
    const lines = ({IN_VIEW})();
    seen += lines.length > 5 && lines.every(([, text]) => text)
      && lines.some(([,,, name]) => name.includes("nc-block"));
  }}
  return [seen, nctaktRun.run.isPlaying];
}}"""


@pytest.fixture(scope="module")
def long(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A program of a million lines, none like the one before; one is named SOUGHT."""
    path = tmp_path_factory.mktemp("long") / "long.nc"
    lines = ["#RT CYCLE [ID=1 SCOPE=PROG]", "  $IF V.RTA.ACS.ACT_POS.X > 50", "    V.E.COUNT += 1"]
    lines += ["  $ENDIF", "#RT CYCLE END"]
    lines += [f"N{number} G01 X{number % 7} Y{number % 5} F60000" for number in range(6, LINES)]
    lines[700_000 - 1] += " (Sought)"
    path.write_text("\n".join([*lines, "M30", ""]), "utf-8")
    return path


@pytest.fixture(scope="module")
def page(long: Path) -> Iterator[Any]:
    with chromium() as browser, served(str(long)) as address:
        page = opened(browser, address)
        page.wait_for_function("globalThis.nctaktEditor?.isLong")
        yield page
        page.close()


def compare(page: Any, lines: list[str]) -> list[list[Any]]:
    """The lines in view are those of the file at their numbers."""
    page.wait_for_function(HAVE_COME)
    shown: list[list[Any]] = page.evaluate(IN_VIEW)
    for number, text, seen, _ in shown:
        assert text == lines[number - 1]
        assert seen.startswith(text)
    numbers = page.locator(".cm-lineNumbers .cm-gutterElement").all_inner_texts()
    assert {str(number) for number, *_ in shown} <= set(numbers)
    return shown


def test_a_line_is_found_by_number_or_text() -> None:
    """The next one after a line, then from the start; regardless of case."""
    lines = ["G01 X1", "g01 x2", "M30", ""]
    assert [line_found(lines, "G01 X", after) for after in (0, 1, 2)] == [1, 2, 1]
    assert [line_found(lines, wish, 0) for wish in ("3", "5", "0", "x9", "m30")] == [3, 0, 0, 0, 3]


@pytest.mark.nightly
def test_lines_are_where_they_are_in_the_file(page: Any, long: Path) -> None:
    """At random places, by scrolling and by search; colours are those of the language server."""
    lines = long.read_text("utf-8").splitlines()
    assert len(lines) > MAX_EDITED_LINES
    expect(page.get_by_test_id("length")).to_have_text("1,000,000 lines, not edited here")
    chance = random.Random(5)
    for _ in range(6):
        share = chance.random()
        page.evaluate(
            "share => { const scroller = document.querySelector('.cm-scroller');"
            " scroller.scrollTop = share * scroller.scrollHeight; }",
            share,
        )
        page.wait_for_timeout(200)
        shown = compare(page, lines)
        assert abs(shown[0][0] / LINES - share) < 0.01
    for wish, line in (("700000", 700_000), ("sought", 700_000), ("N999999 ", 999_999), ("1", 1)):
        page.get_by_test_id("find").fill(wish)
        page.get_by_test_id("find").press("Enter")
        page.wait_for_function(f"({IN_VIEW})().some(([number]) => number === {line})")
        compare(page, lines)
    expect(page.locator(".cm-line").first.locator(".nc-t-macro").first).to_have_text("#RT CYCLE")
    page.get_by_test_id("find").fill("no such line")
    page.get_by_test_id("find").press("Enter")
    expect(page.get_by_text("No line has no such line")).to_be_visible()


@pytest.mark.nightly
def test_a_long_program_is_not_edited(page: Any, long: Path) -> None:
    """Typing does nothing; what has not come cannot be copied; Ctrl+F looks in the whole file."""
    page.locator(".cm-content").click()
    page.keyboard.type("G999 ")
    page.keyboard.press("Control+a")
    page.keyboard.press("Control+c")
    expect(page.get_by_text("Only lines in view can be copied")).to_be_visible()
    page.keyboard.press("Control+f")
    expect(page.get_by_test_id("find")).to_be_focused()
    assert page.evaluate("document.querySelector('.cm-content').getAttribute('aria-readonly')")
    assert "G999" not in page.locator(".cm-content").inner_text()
    page.keyboard.press("Escape")


@pytest.mark.nightly
def test_the_running_block_and_stops_in_a_million_lines(page: Any, long: Path) -> None:
    """The block is in view while it plays and after travel; a stop is at its line."""
    lines = long.read_text("utf-8").splitlines()
    page.get_by_test_id("speed").click()
    page.get_by_role("option", name="max").click()
    page.get_by_test_id("toggle").click()
    page.wait_for_function("nctaktRun.run.block > 20000")
    page.wait_for_function("document.querySelector('.cm-line.nc-block')")
    page.get_by_test_id("toggle").click()
    page.wait_for_function("!nctaktRun.run.isPlaying")
    with Session(long, until="100000000 ticks") as session:
        for share in (None, 0.3, 0.8):
            if share is not None:
                before = page.evaluate("nctaktRun.run.tick")
                scope = page.get_by_test_id("scope").bounding_box()
                x = scope["x"] + 60 + share * (scope["width"] - 80)
                page.mouse.click(x, scope["y"] + scope["height"] / 2)
                page.wait_for_function("before => nctaktRun.run.tick !== before", arg=before)
            page.wait_for_function(f"({IN_VIEW})().some(([,,, name]) => name.includes('nc-block'))")
            shown = compare(page, lines)
            tick = page.evaluate("nctaktRun.run.tick")
            if session.branches[1] <= tick:
                session.step(tick + 1 - session.branches[1])
            session.go_to(tick + 1)
            (block,) = (number for number, _, _, name in shown if "nc-block" in name)
            assert block == session.latest.blocks[1].line
    gutter = page.locator(".cm-lineNumbers .cm-gutterElement")
    gutter.get_by_text(str(block + 2), exact=True).click()
    expect(page.locator(".cm-lineNumbers .nc-stopped")).to_have_text(str(block + 2))
    page.get_by_test_id("toggle").click()
    expect(page.get_by_text(re.compile(f"Stopped: line .*:{block + 2}"))).to_be_visible()
    page.wait_for_function(f"nctaktRun.run.block === {block + 2}")


def test_a_fast_block_is_in_view_while_it_plays(page: Any, tmp_path: Path) -> None:
    """A thousand blocks a second: the lines come with the mark, not by a request after it."""
    moves = [f"N{number} X{number * 0.01:.2f}" for number in range(MAX_EDITED_LINES + 10_000)]
    path = tmp_path / "cam.nc"
    path.write_text("\n".join(["G01 F6000", *moves, "M30", ""]), "utf-8")
    with served(str(path)) as address:
        other = opened(page.context.browser, address)
        other.wait_for_function("globalThis.nctaktEditor?.isLong")
        other.get_by_test_id("toggle").click()
        other.wait_for_function("nctaktRun.run.block > 200")
        seen, is_playing = other.evaluate(LOOKS)
        other.close()
    assert is_playing
    assert seen >= 15


@pytest.mark.nightly
def test_words_are_explained_in_a_long_program(page: Any) -> None:
    """By keyboard, at the cursor, as in a short one."""
    page.get_by_test_id("find").fill("700000")
    page.get_by_test_id("find").press("Enter")
    page.wait_for_function(f"({IN_VIEW})().some(([number]) => number === 700000)")
    page.wait_for_function(HAVE_COME)
    page.keyboard.press("Escape")
    page.keyboard.press("e")
    expect(page.locator(".cm-content").first).to_be_focused()
    for _ in range(8):
        page.keyboard.press("ArrowRight")
    page.keyboard.press("F1")
    expect(page.locator(".nc-tip-here")).to_contain_text("G01")
    page.keyboard.press("Escape")
    expect(page.locator(".nc-tip-here")).to_have_count(0)


def test_lines_that_are_there_are_not_asked_for_again(page: Any) -> None:
    """At a place that somebody scrolls to, the browser asks once."""
    page.evaluate(
        "() => { const emit = emitEvent; globalThis.asked = 0;"
        " globalThis.emitEvent = (name, ...words) => {"
        " if (name === 'nctakt_lines') globalThis.asked += 1; return emit(name, ...words); };"
        " document.querySelector('.cm-scroller').scrollTop = 400000; }"
    )
    page.wait_for_function("globalThis.asked > 0")
    page.wait_for_function(HAVE_COME)
    page.wait_for_timeout(800)
    assert page.evaluate("globalThis.asked") == 1


def test_a_program_begins_to_show_before_the_page_is_built(page: Any, long: Path) -> None:
    """Its first lines are in the page itself, without a script, and give way to the editor."""
    begun = page.context.browser.new_page()
    begun.route("**/nicegui.js", lambda _: None)  # no answer: nothing is built
    begun.goto(page.url, wait_until="commit")
    outset = begun.locator(".nc-outset pre")
    expect(outset).to_be_visible()
    assert outset.text_content().splitlines() == long.read_text("utf-8").splitlines()[:60]
    begun.close()
    expect(page.locator(".nc-outset")).to_be_hidden()
