# SPDX-License-Identifier: MIT
"""The live page for everyone: names, contrast, keyboard, light and dark, small windows, German."""

from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest
from support.page_driving import BROWSER, PATIENCE_MS, axe_source, chromium, opened, serious, served
from support.stepped_machine import DEMO5

from nctakt.live.texts import WORDS

if find_spec("nicegui") is None:  # its import takes long, and only the page's process needs it
    pytest.skip("the live page needs NiceGUI", allow_module_level=True)
playwright = pytest.importorskip("playwright.sync_api", reason="driving a browser needs Playwright")
expect = playwright.expect

pytestmark = [*BROWSER, pytest.mark.nightly]

PROGRAM = """#RT CYCLE [ID=1 SCOPE=PROG]
  $IF V.RTA.ACS.ACT_POS.X > 5
    V.E.COUNT += 1
  $ENDIF
#RT CYCLE END
G01 X10 F6000
M7
X0 Y0
M30
"""


@pytest.fixture(scope="module")
def axe(tmp_path_factory: pytest.TempPathFactory) -> str:
    """The source of axe-core."""
    return axe_source(tmp_path_factory.mktemp("npm"))


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    with chromium() as browser:
        yield browser


@pytest.fixture(scope="module")
def visit(browser: Any, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    """Opens the German page of a program in a window of a size and a scheme of colours."""
    path = tmp_path_factory.mktemp("part") / "part.nc"
    path.write_text(PROGRAM, "utf-8")
    with served(str(path), "--acknowledge", "--lang", "de") as address:

        def opened(width: int, height: int, scheme: str) -> Any:
            size = {"width": width, "height": height}
            page = browser.new_page(viewport=size, color_scheme=scheme)
            page.set_default_timeout(PATIENCE_MS)
            page.goto(address)
            page.wait_for_function("document.querySelector('[data-testid=clock]')?.textContent")
            page.wait_for_function(
                "globalThis.nctaktRun && document.querySelector('.cm-content')?.ariaLabel"
            )
            return page

        yield opened


def test_axe_finds_nothing_serious(visit: Any, axe: str) -> None:
    """In light and dark, which follow the system while the page is open; in all lists; the help."""
    page = visit(1280, 800, "light")
    page.keyboard.press(".")
    expect(page.locator(".nc-inline")).to_have_count(1)
    assert serious(page, axe) == []
    page.emulate_media(color_scheme="dark")
    expect(page.locator("body.body--dark")).to_have_count(1)
    editor = page.locator(".cm-editor")
    expect(editor).to_have_css("background-color", "rgb(29, 33, 38)")
    for name in ("stops", "messages", "events", "why"):
        page.get_by_test_id(f"tab-{name}").click()
        page.wait_for_timeout(400)  # until the list has slid in
        assert serious(page, axe) == [], name
    page.keyboard.press("?")
    expect(page.get_by_role("dialog")).to_be_visible()
    page.wait_for_timeout(400)
    assert serious(page, axe) == []
    page.close()


def test_axe_finds_nothing_in_colours_filter_and_path(
    browser: Any, axe: str, tmp_path: Path
) -> None:
    """Each kind of token on the backgrounds of lines, the filter, the switch; light and dark."""
    conditions = "".join(f"  $IF V.RTA.ACS.ACT_POS.X > {one}\n  $ENDIF\n" for one in (-1, 900))
    path = tmp_path / "part.nc"
    path.write_text(
        f"%part\nN1 T1 D1 (a comment)\nP1 = 3\n#RT CYCLE [ID=1]\n{conditions}#RT CYCLE END\n"
        '#MSG ["text"]\n#TRAFO ON\nG01 X10 F6000\n#TRAFO OFF\nM30\n',
        "utf-8",
    )
    words = ("--machine", str(DEMO5), "--acknowledge")
    with served(str(path), *words) as address:
        page = opened(browser, address)
        for key in "...":
            page.keyboard.press(key)
        expect(page.locator(".nc-inline")).to_have_count(2)
        kinds = ("class", "label", "comment", "parameter", "operator", "number", "macro", "keyword")
        for kind in (*kinds, "variable", "property", "string", "function"):
            expect(page.locator(f".nc-t-{kind}").first).to_be_visible()
        expect(page.get_by_test_id("machine-axes")).to_be_visible()
        page.keyboard.press("f")
        page.wait_for_function("document.activeElement.matches('input')")
        page.keyboard.type("#1")
        expect(page.get_by_test_id("lanes-fitting")).to_have_text("2/2")
        assert serious(page, axe) == []
        page.emulate_media(color_scheme="dark")
        expect(page.locator("body.body--dark")).to_have_count(1)
        expect(page.locator(".cm-editor")).to_have_css("background-color", "rgb(29, 33, 38)")
        page.wait_for_function("document.getAnimations().length === 0")  # colours change slowly
        assert serious(page, axe) == []
        page.close()


def test_colours_that_somebody_has_chosen_stay(visit: Any) -> None:
    """A press of D is the other one of what is shown, also where that came from the system."""
    page = visit(1280, 800, "dark")
    dark = page.locator("body.body--dark")
    expect(dark).to_have_count(1)
    page.wait_for_timeout(500)  # until the server knows
    page.keyboard.press("d")
    expect(dark).to_have_count(0)
    page.keyboard.press("d")
    expect(dark).to_have_count(1)
    page.close()


@pytest.mark.parametrize(("width", "height"), [(900, 700), (390, 844)])
def test_small_windows(visit: Any, axe: str, width: int, height: int) -> None:
    """Nothing is wider than the window, each part has room; on a phone one is below the other."""
    page = visit(width, height, "light")
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    boxes = {name: page.get_by_test_id(name).bounding_box() for name in ("editor", "scope", "path")}
    for name, box in boxes.items():
        assert box["x"] >= 0, name
        assert box["x"] + box["width"] <= width, name
        assert box["height"] > 140, name
    if width < 620:
        assert boxes["editor"]["y"] < boxes["scope"]["y"] < boxes["path"]["y"]
    else:
        assert page.evaluate("document.documentElement.scrollHeight") <= height
    assert serious(page, axe) == []
    page.close()


@pytest.mark.parametrize(
    ("width", "height", "scheme"),
    [(1280, 800, "dark"), (900, 700, "light"), (390, 844, "light")],
)
def test_axe_finds_nothing_in_what_opens(
    visit: Any, axe: str, width: int, height: int, scheme: str
) -> None:
    """Menus, which Enter opens and Esc closes, the list of a choice, and a tooltip."""
    page = visit(width, height, scheme)
    menu = page.locator(".q-menu")
    for name in ("save-run", "turn"):
        page.get_by_test_id(name).press("Enter")
        expect(menu).to_be_visible()
        page.wait_for_timeout(400)
        assert serious(page, axe) == [], name
        page.keyboard.press("Escape")
        expect(menu).to_have_count(0)
    page.get_by_test_id("speed").click()
    expect(menu).to_be_visible()
    page.wait_for_timeout(400)
    assert serious(page, axe) == []
    page.keyboard.press("Escape")
    expect(menu).to_have_count(0)
    page.get_by_test_id("toggle").hover()
    expect(page.locator(".q-tooltip")).to_have_count(1)  # that of the choice goes
    page.wait_for_timeout(400)
    assert serious(page, axe) == []
    page.close()


def test_all_by_keyboard(visit: Any) -> None:
    """Tab reaches each button and field, and leaves the editor."""
    page = visit(1280, 800, "light")
    page.evaluate("document.activeElement.blur()")
    reached: set[str] = set()
    for _ in range(90):
        page.keyboard.press("Tab")
        reached.add(
            page.evaluate(
                """() => {
                  const active = document.activeElement;
                  const found = active.closest("[data-testid]")?.dataset.testid;
                  return active.closest(".cm-editor") ? "editor" : found ?? active.tagName;
                }"""
            )
        )
    names = ("home", "toggle", "speed", "dark", "help", "file", "save", "editor", "tab-findings")
    names += ("scope", "signals", "turn", "start", "reset", "hold", "override", "search")
    assert [name for name in names if name not in reached] == []
    assert page.evaluate("document.querySelector('.cm-content').textContent").count("\\t") == 0
    page.close()


def test_german_is_complete(visit: Any) -> None:
    """No text, name or tooltip of the page is the English one."""
    page = visit(1280, 800, "light")
    shown = page.evaluate(
        """() => [...document.querySelectorAll("body *")].flatMap((one) =>
          [one.ariaLabel, one.placeholder, one.children.length ? "" : one.textContent]
        ).filter(Boolean)"""
    )
    german = {words[1] for words in WORDS.values()}
    english = {words[0] for words in WORDS.values()} - german
    assert [text for text in shown if text in english] == []
    assert page.evaluate("document.documentElement.lang") == "de"
    page.close()


#: Draws all once more; resolves to the texts of the scope, and how many shapes a row of truth has.
_DRAWN = """async () => {
  const texts = [], pen = CanvasRenderingContext2D.prototype, { fillText, fillRect } = pen;
  const scope = document.querySelector("[data-testid=scope] canvas");
  let shapes = 0;
  pen.fillText = function (...words) {
    if (this.canvas === scope) texts.push(words[0]);
    fillText.apply(this, words);
  };
  pen.fillRect = function (...words) {
    if (this.canvas === scope && this.globalAlpha > 0.19 && this.globalAlpha < 0.21) shapes += 1;
    fillRect.apply(this, words);
  };
  nctaktRun.changed();
  await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
  Object.assign(pen, { fillText, fillRect });
  return [texts, shapes];
}"""


@pytest.mark.parametrize(("width", "height"), [(1280, 800), (900, 700), (390, 844)])
def test_the_scope_has_its_times_in_any_window(
    browser: Any, tmp_path: Path, width: int, height: int
) -> None:
    """At least two numbers on the axis of time; what stays true is one shape without seams."""
    path = tmp_path / "part.nc"
    path.write_text(PROGRAM.replace("V.E.COUNT += 1", "V.E.FLAG = 1"), "utf-8")
    with served(str(path)) as address:
        page = opened(browser, address, width, height)
        page.get_by_test_id("speed").click()
        page.get_by_role("option", name="max").click()
        page.get_by_test_id("toggle").click()
        expect(page.get_by_test_id("state")).to_contain_text("ended")
        page.wait_for_function(
            "nctaktRun.run.ticks[0] === 0 && nctaktRun.run.ticks.at(-1) === nctaktRun.run.latest"
        )
        texts, shapes = page.evaluate(_DRAWN)
        axis = texts[: texts.index("s")]
        numbers = [text for text in axis if text.replace(".", "", 1).isdigit()]
        assert len(numbers) >= 2, texts
        assert "V.E.FLAG TRUE" in texts
        assert shapes == 1
        page.close()
