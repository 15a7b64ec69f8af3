# SPDX-License-Identifier: MIT
"""The editor of the page completes, explains and finds what the language server does.

What the browser shows is compared with the answers of the server's functions; all by keyboard, in
both languages.
"""

import re
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest
from support.page_driving import BROWSER, chromium, opened, served

pytest.importorskip("lsprotocol", reason="the page's editor needs lsprotocol (extra live)")

from lsprotocol.types import MarkupContent, Position

from nctakt.base.diagnostics import Language, Severity
from nctakt.editor.completing.completion import complete
from nctakt.editor.display.hover import hover
from nctakt.editor.document import Document
from nctakt.editor.workspace import Workspace
from nctakt.live.words import TextCursor, completed, explained_word

if find_spec("nicegui") is None:  # its import takes long, and only the page's process needs it
    pytest.skip("the live page needs NiceGUI", allow_module_level=True)
playwright = pytest.importorskip("playwright.sync_api", reason="driving a browser needs Playwright")
expect = playwright.expect

pytestmark = BROWSER

PROGRAM = """P1 = 5
#RT CYCLE [ID=1 SCOPE=PROG]
  $IF EDGE V.RTA.ACS.ACT_POS.X > P1
    V.E.COUNT += 1
  $ENDIF
#RT CYCLE END
G01 X20 F6000
G999 X5
M30
"""
WORK = Workspace()

#: What the list of the completion offers: labels with what is said of them.
OFFERED = """() => [...document.querySelectorAll(".cm-tooltip-autocomplete li")].map((one) => [
  one.querySelector(".cm-completionLabel").textContent,
  one.querySelector(".cm-completionDetail")?.textContent ?? "",
])"""


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    with chromium() as browser:
        yield browser


def document_of(text: str, path: Path) -> Document:
    """The program as it is open in an editor."""
    return Document(path.as_uri(), path, path.as_posix(), "nctakt", 0, text.split("\n"))


def server_offers(document: Document, line: int, language: Language) -> list[list[str]]:
    """What the language server completes at the end of a line, as an editor shows it."""
    written = document.lines[line - 1]
    position = Position(line - 1, len(written))
    machine = WORK.machine_of(document).machine
    found = complete(document, position, machine, language, has_snippets=True)
    shown = []
    for item in found:
        assert item.text_edit is not None
        start = item.text_edit.range.start.character  # type: ignore[union-attr]
        if item.label.casefold().startswith(written[start:].casefold()):
            shown.append([item.label, item.detail or ""])
    return shown


def test_places_are_those_of_browsers() -> None:
    """A sign outside of the basic plane has two units of UTF-16; texts of programs are no HTML."""
    document = document_of("(\U0001f529<b>) G0", Path("part.nc").absolute())
    machine = WORK.machine_of(document).machine
    place = TextCursor("part.nc", document.lines, 1, 10)
    found = completed(place, machine, "en")
    assert {one["start"] for one in found if one["label"].startswith("G0")} == {8}
    lines = ["V.P.A = 1 (<img src=x>)", "P2 = V.P.A"]
    reported = explained_word(TextCursor("part.nc", lines, 2, 7), machine, [], "en")
    assert reported is not None
    assert (reported["from"], reported["to"]) == (5, 10)
    assert "<img" not in reported["html"]
    assert explained_word(TextCursor("part.nc", [""], 1, 0), machine, [], "en") is None


def typed(page: Any, line: int, text: str) -> None:
    """Begin a line before another one with a text."""
    page.keyboard.press("Control+Home")
    for _ in range(line - 1):
        page.keyboard.press("ArrowDown")
    page.keyboard.press("Enter")
    page.keyboard.press("ArrowUp")
    page.keyboard.press("Home")
    page.keyboard.type(text)


@pytest.mark.nightly
@pytest.mark.parametrize("language", ["en", "de"])
def test_completion_is_that_of_the_language_server(
    browser: Any, tmp_path: Path, language: Language
) -> None:
    """In a block, in a condition of a cycle, after ``#``; Enter takes the one that is chosen."""
    path = tmp_path / "part.nc"
    path.write_text(PROGRAM, "utf-8")
    with served(str(path), "--lang", language) as address:
        page = opened(browser, address)
        page.wait_for_function("globalThis.nctaktEditor")
        page.keyboard.press("e")
        for line, text in ((7, "G0"), (4, "$IF V.RTA.ACS."), (7, "#TRAFO"), (4, "#"), (4, "$I")):
            typed(page, line, text)
            lines = PROGRAM.split("\n")
            lines.insert(line - 1, text)
            expected = server_offers(document_of("\n".join(lines), path), line, language)
            assert len(expected) > 1
            # it opens while one types, and when it is asked for
            listed = page.locator(".cm-tooltip-autocomplete")
            expect(listed).to_be_visible()
            page.keyboard.press("Escape")
            expect(listed).to_have_count(0)
            page.keyboard.press("Control+Space")
            expect(listed).to_be_visible()
            offered = page.evaluate(OFFERED)
            assert offered == expected[: len(offered)]  # the library shows the first hundred
            assert len(offered) == min(100, len(expected))
            if text != "$I":
                page.keyboard.press("Escape")
                expect(listed).to_have_count(0)
                expect(page.locator(".cm-content")).to_be_focused()
                for _ in range(len(text)):
                    page.keyboard.press("Backspace")
                page.keyboard.press("Backspace")
                page.keyboard.press("Control+Home")
        labels = [label for label, _ in expected]
        page.wait_for_timeout(200)  # what has just opened takes no key
        for _ in range(labels.index("$IF … $ENDIF")):
            page.keyboard.press("ArrowDown")
        page.keyboard.press("Enter")
        page.keyboard.type("ONCE")  # in place of the first gap
        expect(page.locator(".cm-content")).to_contain_text("$IF ONCE V.RTA.ACS.ACT_POS.X > 0")
        page.close()


@pytest.mark.nightly
@pytest.mark.parametrize("language", ["en", "de"])
def test_explanations_are_those_of_the_language_server(
    browser: Any, tmp_path: Path, language: Language
) -> None:
    """By the pointer, and by F1 at the cursor; Esc closes it, and then leaves the editor."""
    path = tmp_path / "part.nc"
    path.write_text(PROGRAM, "utf-8")
    with served(str(path), "--lang", language) as address:
        page = opened(browser, address)
        page.wait_for_function("globalThis.nctaktEditor")
        document = document_of(PROGRAM, path)
        machine, found = WORK.machine_of(document).machine, WORK.check(document)
        for line, column, shown in ((7, 1, "G01"), (7, 8, "F"), (3, 15, "V.RTA.ACS.ACT_POS.X")):
            expected = hover(document, Position(line - 1, column), machine, found, language)
            assert expected is not None
            assert isinstance(expected.contents, MarkupContent)
            page.keyboard.press("e")
            page.keyboard.press("Control+Home")
            for _ in range(line - 1):
                page.keyboard.press("ArrowDown")
            page.keyboard.press("Home")
            page.keyboard.press("Home")
            for _ in range(column):
                page.keyboard.press("ArrowRight")
            page.keyboard.press("F1")
            reported = page.locator(".nc-tip-here")
            expect(reported).to_be_visible()
            assert words(reported.inner_text()) == words(expected.contents.value)
            assert words(page.locator(".cm-announced").inner_text()) == words(
                expected.contents.value
            )
            page.keyboard.press("Escape")
            expect(reported).to_have_count(0)
            expect(page.locator(".cm-content")).to_be_focused()
            page.keyboard.press("Escape")
            expect(page.locator(".cm-content")).not_to_be_focused()
            page.locator(".cm-content").get_by_text(shown, exact=True).first.hover()
            expect(page.locator(".nc-tip")).to_be_visible()
            assert words(page.locator(".nc-tip").inner_text()) == words(expected.contents.value)
            page.mouse.move(5, 5)
            expect(page.locator(".nc-tip")).to_have_count(0)
        page.close()


def words(text: str) -> str:
    """What a text says, without signs of Markdown and ends of lines."""
    return " ".join(re.sub(r"\*\*|```\w*|^- ", "", text, flags=re.MULTILINE).split())


@pytest.mark.nightly
@pytest.mark.parametrize("language", ["en", "de"])
def test_findings_are_those_of_the_language_server(
    browser: Any, tmp_path: Path, language: Language
) -> None:
    """Underlined where they are; F4 goes to the next one and says its number, text and remedy."""
    path = tmp_path / "part.nc"
    path.write_text(PROGRAM, "utf-8")
    with served(str(path), "--lang", language) as address:
        page = opened(browser, address)
        document = document_of(PROGRAM, path)
        found = [one for one in WORK.check(document) if one.severity > Severity.NOTE]
        assert found
        underlined = page.locator(".cm-content :is(.nc-error, .nc-warning)")
        expect(underlined.first).to_be_visible()
        page.keyboard.press("e")
        page.keyboard.press("Control+Home")
        page.keyboard.press("F4")
        reported = page.locator(".nc-tip-here")
        span = found[0].span
        assert span is not None
        here = [one for one in found if one.span == span]
        expect(reported).to_contain_text(f"{here[0].id}: {here[0].text(language)}")
        expect(reported).to_contain_text(here[0].remedy(language))
        line = PROGRAM.split("\n")[span.line - 1]
        assert "".join(underlined.all_inner_texts()).startswith(
            line[span.column - 1 : span.end_column - 1]
        )
        cursor = "getElement(Number(document.querySelector('[data-testid=editor]').id.slice(1)))"
        position = page.evaluate(f"{cursor}.editor.state.selection.main.head")
        assert position == len("\n".join(PROGRAM.split("\n")[: span.line - 1])) + span.column
        page.close()
