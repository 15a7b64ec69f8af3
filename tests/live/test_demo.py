# SPDX-License-Identifier: MIT
"""``nctakt demo`` (docs/live.md): the tour of the cell, by keyboard, in both languages."""

import re
from collections.abc import Iterator
from importlib.util import find_spec
from typing import Any

import pytest
from support.page_driving import BROWSER, chromium, opened, served

from nctakt.base.diagnostics import Language
from nctakt.cli import main
from nctakt.cli.demo import AREA, CELL, MACHINE, STIMULI
from nctakt.live.parts.tour import reach_step
from nctakt.live.texts import Texts
from nctakt.session.session import Session

if find_spec("nicegui") is None:  # its import takes long, and only the page needs it
    pytest.skip("the live page needs NiceGUI", allow_module_level=True)
playwright = pytest.importorskip("playwright.sync_api", reason="driving a browser needs Playwright")
expect = playwright.expect

pytestmark = BROWSER

#: The tick in which Z passes 160 mm: the linear axes of the mill are in it at 160.2 mm.
ASKED = 3688


def test_the_gate_stays_shut_while_somebody_stands_there(capsys: Any) -> None:
    """The cell of the tour: with its inputs M8 waits forever, without them the program ends."""
    words = ["run", str(CELL / "mill.nc"), "--channel", "2", str(CELL / "loader.nc")]
    words += ["--machine", str(MACHINE), "--plc", str(CELL / "cell.st"), "--until", "8s"]
    words += ["--set", f"{AREA}=1"]
    assert main(words) == 0
    assert "M100      realtime cycle  1      tick 3688" in capsys.readouterr().out
    assert main([*words, *(word for one in STIMULI for word in ("--at", *one))]) == 0
    reported = capsys.readouterr()
    assert "M100" not in reported.out
    assert "waiting for the PLC's acknowledgement of M8" in reported.err


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    with chromium() as browser:
        yield browser


def is_whole_or_hidden(page: Any) -> bool:
    """Whether the hint in the scope's title is all there, or not at all: never cut."""
    hint = page.get_by_test_id("scope-hint")
    own, room = hint.bounding_box(), hint.locator("..").bounding_box()
    is_whole = own["x"] + own["width"] <= room["x"] + room["width"] + 1
    return bool(own["y"] >= room["y"] + room["height"] or (is_whole and own["y"] < room["y"] + 4))


@pytest.mark.parametrize("language", ["en", "de"])
def test_the_tour_by_keyboard(browser: Any, language: Language) -> None:
    """Six steps with Enter: what the tour says is what the session has, and the gate opens."""
    texts = Texts(language)
    with served("--lang", language, command=("demo", "--no-open")) as address:
        page = opened(browser, address)
        words, clock = page.get_by_test_id("tour-text"), page.get_by_test_id("clock")
        expect(words).to_have_text(texts["tour_cell"])
        expect(page.get_by_test_id("tour_next")).to_be_focused()
        assert is_whole_or_hidden(page)
        for name in ("run", "still"):
            page.keyboard.press("Enter")
            expect(words).to_have_text(texts[f"tour_{name}"])
        expect(page.get_by_test_id("waiting")).to_contain_text("M8")
        page.keyboard.press("Enter")
        expect(words).to_have_text(texts["tour_why"].format(line=5, tick=ASKED))
        expect(page.get_by_test_id("why")).to_contain_text("0 == 1")
        page.keyboard.press("Enter")
        expect(words).to_have_text(texts["tour_past"].format(tick=ASKED))
        expect(clock).to_contain_text(f" {ASKED} ")
        page.keyboard.press("Enter")
        expect(words).to_have_text(texts["tour_change"].format(tick=ASKED))
        expect(page.get_by_test_id("state")).to_have_text(re.compile(texts["ended"]))
        expect(page.get_by_test_id("branch-2")).to_be_visible()
        expect(page.get_by_test_id("variable-V.E.PARTS")).to_have_value("1")
        page.get_by_test_id("tour_again").press("Enter")
        expect(words).to_have_text(texts["tour_cell"])
        expect(clock).to_contain_text(texts["before_first"])
        page.close()


def test_a_changed_program_is_not_the_tours() -> None:
    """Where the question has another answer, the tour says so instead of telling of another run."""
    program = CELL / "mill.nc"
    with Session(
        channels={1: [program], 2: [CELL / "loader.nc"]},
        machine=MACHINE,
        plc=CELL / "cell.st",
        set={AREA: 1},
    ) as session:
        assert reach_step(session, str(program), 5, "why") is None
