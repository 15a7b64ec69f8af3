# SPDX-License-Identifier: MIT
"""The live page in a browser: Chromium, driven by Playwright, from the first tick to the end."""

import json
import re
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest
from support.page_driving import BROWSER, chromium, opened, served

from nctakt.cli import main

if find_spec("nicegui") is None:  # its import takes long, and only the page's process needs it
    pytest.skip("the live page needs NiceGUI", allow_module_level=True)
playwright = pytest.importorskip("playwright.sync_api", reason="driving a browser needs Playwright")
expect = playwright.expect

pytestmark = BROWSER

PROGRAM = """#RT CYCLE [ID=1 SCOPE=PROG]
  $IF EDGE V.E.VALUE > 0.5
    V.E.COUNT += 1
  $ENDIF
#RT CYCLE END
G01 X20 F6000
M7
G01 X0
M30
"""


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    with chromium() as browser:
        yield browser


def written(folder: Path, text: str = PROGRAM, name: str = "part.nc") -> Path:
    """A program in a file."""
    path = folder / name
    path.write_text(text, "utf-8")
    return path


def test_a_person_at_the_page(browser: Any, tmp_path: Path) -> None:
    """Step, set a variable, see the reaction, travel, run, acknowledge, pause, make a mistake.

    What was lived through is on a tape after it.
    """
    path, tape = written(tmp_path), tmp_path / "page.tape"
    with served(str(path), "--acknowledge", "--record", str(tape)) as address:
        page = opened(browser, address)
        foreign: list[str] = []
        own = (address, "data:", "blob:", address.replace("http", "ws"))
        page.on(
            "request",
            lambda request: None if request.url.startswith(own) else foreign.append(request.url),
        )
        page.reload()
        clock, state = page.get_by_test_id("clock"), page.get_by_test_id("state")
        count = page.get_by_test_id("variable-V.E.COUNT")
        expect(clock).to_contain_text("before tick 0 ")

        page.get_by_test_id("tick").click()
        expect(clock).to_contain_text("Tick 0 ")
        page.get_by_test_id("variable-V.E.VALUE").fill("1")
        page.get_by_test_id("variable-V.E.VALUE").press("Enter")
        expect(page.get_by_text("V.E.VALUE = 1: ")).to_be_visible()
        page.get_by_test_id("reaction").click()
        expect(clock).to_contain_text("Tick 1 ")
        expect(count).to_have_value("1")
        expect(page.locator(".cm-line.nc-true")).to_have_count(1)
        expect(page.locator(".nc-inline")).to_have_text("true in tick 1: 1 > 0.5 · ran 1×")
        page.locator(".nc-inline").click()
        expect(page.get_by_test_id("why")).to_contain_text("ran: V.E.COUNT += 1")

        page.get_by_test_id("home").click()
        expect(clock).to_contain_text("before tick 0 ")
        expect(count).to_have_value("0")

        page.get_by_test_id("toggle").click()
        function = page.get_by_test_id("waiting").get_by_text("M7")
        expect(function).to_be_visible()
        page.get_by_test_id("toggle").click()
        expect(state).to_have_text("paused")
        function.click()
        page.get_by_test_id("toggle").click()
        expect(state).to_have_text(re.compile("^ended"))
        expect(function).to_have_count(0)

        page.locator(".cm-content").click()
        page.keyboard.press("Control+Home")
        page.keyboard.type("G999 ")
        page.get_by_test_id("tab-findings").click()
        expect(page.get_by_test_id("findings")).to_contain_text("20797")
        expect(page.locator(".cm-content .nc-error").first).to_be_visible()
        assert path.read_text("utf-8") == PROGRAM
        assert foreign == []
        page.close()
    assert '"ack",' in tape.read_text("utf-8")
    assert main(["replay", str(tape), "--quiet"]) == 0


@pytest.mark.nightly
def test_slide_and_travel(browser: Any, tmp_path: Path) -> None:
    """A slider makes a reaction fire while the run plays; it is in the scope; a click travels."""
    path = written(tmp_path, PROGRAM.replace("M7", "G04 X600"))
    with served(str(path), "--lang", "de") as address:
        page = opened(browser, address)
        page.get_by_test_id("toggle").click()
        expect(page.get_by_test_id("state")).to_have_text("läuft")
        slider = page.get_by_test_id("slider-V.E.VALUE").bounding_box()
        page.mouse.click(slider["x"] + slider["width"] * 0.6, slider["y"] + slider["height"] / 2)
        expect(page.get_by_test_id("variable-V.E.COUNT")).to_have_value("1")
        page.wait_for_function("nctaktRun.run.marks.some(([, kind]) => kind === 'fired')")
        page.get_by_test_id("toggle").click()
        expect(page.get_by_test_id("state")).to_have_text("angehalten")
        page.wait_for_function("nctaktRun.run.ticks.at(-1) === nctaktRun.run.latest")
        latest = page.evaluate("nctaktRun.run.latest")

        scope = page.get_by_test_id("scope").bounding_box()
        middle = scope["y"] + scope["height"] / 2
        page.mouse.click(scope["x"] + scope["width"] * 0.5, middle)
        page.wait_for_function("nctaktRun.run.tick < nctaktRun.run.latest")
        tick = page.evaluate("nctaktRun.run.tick")
        assert 0.2 * latest < tick < 0.8 * latest
        expect(page.get_by_test_id("clock")).to_contain_text(f"Takt {tick} ")
        page.mouse.wheel(0, -400)
        page.wait_for_function("nctaktRun.run.detail !== null")
        assert page.evaluate("nctaktRun.run.to - nctaktRun.run.from") < latest
        page.keyboard.press("End")
        expect(page.get_by_test_id("clock")).to_contain_text(f"Takt {latest} ")
        page.close()


@pytest.mark.nightly
def test_stops_and_automatic_acknowledgement(browser: Any, tmp_path: Path) -> None:
    """A click on a line number stops there; functions are acknowledged after a delay in ticks."""
    path = written(tmp_path)
    with served(str(path), "--acknowledge") as address:
        page = opened(browser, address)
        page.locator(".cm-lineNumbers .cm-gutterElement").get_by_text("8", exact=True).click()
        expect(page.locator(".nc-stop")).to_have_count(1)
        page.get_by_test_id("acknowledging").click()
        page.get_by_role("option", name="automatic").click()
        expect(page.get_by_test_id("delay")).to_be_visible()
        page.get_by_test_id("speed").click()
        page.get_by_role("option", name="max").click()
        page.get_by_test_id("toggle").click()
        expect(page.get_by_text(re.compile("Stopped: line .*:8"))).to_be_visible()
        page.wait_for_function("nctaktRun.run.marks.some(([, , label]) => label === 'M7')")
        handed, stood = page.evaluate(
            "[nctaktRun.run.marks.find(([, , label]) => label === 'M7')[0], nctaktRun.run.tick]"
        )
        assert stood - handed in range(100, 104)
        page.get_by_test_id("tab-stops").click()
        page.get_by_test_id("new-stop").fill("V.E.")
        page.get_by_test_id("new-stop").press("Enter")
        expect(page.locator(".q-notification").get_by_text(re.compile(r"^\d+: "))).to_be_visible()
        page.close()


@pytest.mark.nightly
def test_two_browsers_and_one_pen(browser: Any, tmp_path: Path) -> None:
    """The second one watches until it takes control; when it is closed, the first one commands."""
    path = written(tmp_path)
    with served(str(path)) as address:
        first, second = opened(browser, address), opened(browser, address)
        second.get_by_test_id("tick").click()
        expect(second.get_by_text("Another browser has control.")).to_be_visible()
        expect(second.get_by_test_id("clock")).to_contain_text("before tick 0 ")
        second.get_by_test_id("control").click()
        second.get_by_test_id("tick").click()
        for page in (first, second):
            expect(page.get_by_test_id("clock")).to_contain_text("Tick 0 ")
        second.close()
        expect(first.get_by_test_id("clock")).to_contain_text("Tick 0 ")
        for _ in range(200):
            first.get_by_test_id("tick").click()
            if "Tick 0 " not in first.get_by_test_id("clock").inner_text():
                break
            first.wait_for_timeout(100)
        expect(first.get_by_test_id("clock")).to_contain_text(re.compile("Tick [1-9]"))
        first.close()


@pytest.mark.nightly
def test_what_one_browser_saves_the_other_one_shows(browser: Any, tmp_path: Path) -> None:
    """One with its own changes keeps them, and does not write over what was saved."""
    path = written(tmp_path)
    with served(str(path)) as address:
        first, second = opened(browser, address), opened(browser, address)
        first.locator(".cm-content").get_by_text("X20").click()
        first.keyboard.press("End")
        first.keyboard.type("0")
        first.wait_for_timeout(500)
        first.keyboard.press("Control+s")
        expect(second.locator(".cm-content")).to_contain_text("F60000")
        expect(second.get_by_text("not saved")).to_have_count(0)
        expect(first.get_by_test_id("clock")).not_to_contain_text("before tick 0 ")
        second.locator(".cm-content").get_by_text("X20").click()
        second.keyboard.press("End")
        second.keyboard.type("1")
        first.keyboard.type("2")
        first.wait_for_timeout(500)
        first.keyboard.press("Control+s")
        expect(second.get_by_test_id("load")).to_be_visible()
        second.get_by_test_id("control").click()
        second.keyboard.press("Control+s")
        expect(second.locator(".q-notification").get_by_text("901162")).to_be_visible()
        assert "F600002" in path.read_text("utf-8")
        for page in (first, second):
            page.close()


#: Types into the editor of a page, whose server does not hear of it yet.
_TYPE_UNHEARD = """() => {
  const component = getElement(Number(document.querySelector("[data-testid=editor]").id.slice(1)));
  component.emitting = false;
  component.editor.dispatch({ changes: { from: 0, insert: "N7 " } });
  component.emitting = true;
}"""


@pytest.mark.nightly
def test_what_somebody_types_stays(browser: Any, tmp_path: Path) -> None:
    """Another browser saves before the server has heard of it; another program is shown."""
    path, other = written(tmp_path), written(tmp_path, "G01 X7 F6000\nM30\n", "other.nc")
    with served(str(path), str(other)) as address:
        first, second = opened(browser, address), opened(browser, address)
        second.wait_for_function("globalThis.nctaktEditor && document.querySelector('.cm-content')")
        second.evaluate(_TYPE_UNHEARD)
        first.locator(".cm-content").get_by_text("X20").click()
        first.keyboard.press("End")
        first.keyboard.type("0")
        first.keyboard.press("Control+s")
        expect(first.get_by_test_id("state")).to_have_text(re.compile("^ended"))
        expect(second.get_by_test_id("load")).to_be_visible()
        expect(second.locator(".cm-content")).to_contain_text("N7 #RT CYCLE")
        assert "F60000" in path.read_text("utf-8")
        second.close()

        first.locator(".cm-content").get_by_text("F60000").click()
        first.keyboard.press("End")
        first.keyboard.type("9")
        expect(first.get_by_text("not saved")).to_be_visible()
        for name, text in (("other.nc", "G01 X7"), ("part.nc", "F600009")):
            first.get_by_test_id("file").click()
            first.get_by_role("option", name=name).click()
            expect(first.locator(".cm-content")).to_contain_text(text)
        expect(first.get_by_text("not saved")).to_be_visible()
        assert "F600009" not in path.read_text("utf-8")
        first.close()


@pytest.mark.nightly
def test_the_path_to_come(browser: Any, tmp_path: Path) -> None:
    """Before the first tick the path is drawn, with its reactions; anew when an input changes.

    Where a PLC in Python decides what comes, the page says so.
    """
    program = PROGRAM.replace("V.E.VALUE > 0.5", "V.RTA.ACS.ACT_POS.X > 5 && V.E.VALUE < 1")
    path = written(tmp_path, program)
    with served(str(path)) as address:
        page = opened(browser, address)
        page.wait_for_function("nctaktRun.run.future?.reason === 'over'")
        future = page.evaluate("nctaktRun.run.future")
        assert page.evaluate("nctaktRun.run.latest") == -1
        places = future["columns"][future["names"].index("X.ACS.ACT_POS")]
        assert (max(places), places[-1]) == (20, 0)
        assert [line for *_, line, _ in future["marks"]] == [2]
        page.get_by_test_id("variable-V.E.VALUE").fill("1")
        page.get_by_test_id("variable-V.E.VALUE").press("Enter")
        page.wait_for_function("nctaktRun.run.future?.marks.length === 0")
        page.close()
    plc = written(tmp_path, "class Cell:\n    def cycle(self, hli):\n        pass\n", "cell.py")
    with served(str(path), "--plc", str(plc)) as address:
        page = opened(browser, address)
        expect(page.get_by_test_id("future")).to_contain_text("What comes is not known")
        page.close()


@pytest.mark.nightly
def test_branches_of_the_tape(browser: Any, tmp_path: Path) -> None:
    """An input in the past begins another branch; it is named, compared, the first taken up."""
    path = written(tmp_path)
    with served(str(path)) as address:
        page = opened(browser, address)
        clock = page.get_by_test_id("clock")
        for tick in (0, 1, 2):
            page.keyboard.press(".")
            expect(clock).to_contain_text(f"Tick {tick} ")
        page.keyboard.press(",")
        expect(clock).to_contain_text("Tick 1 ")
        page.get_by_test_id("variable-V.E.VALUE").fill("1")
        page.get_by_test_id("variable-V.E.VALUE").press("Enter")
        page.keyboard.press("Escape")
        expect(clock).to_contain_text("Branch 2")
        page.keyboard.press(".")
        expect(clock).to_contain_text("Tick 2 ")
        page.keyboard.press("6")
        second = page.get_by_test_id("branch-2")
        expect(second).to_contain_text("leaves 1 at tick 2")
        second.get_by_role("textbox").fill("with a value")
        second.get_by_role("textbox").press("Enter")
        page.get_by_test_id("compare-1").click()
        difference = page.get_by_test_id("difference")
        expect(difference).to_contain_text("differ first in tick 2")
        expect(difference).to_contain_text("V.E.VALUE: 1 / 0")
        page.get_by_test_id("take_up-1").click()
        expect(clock).to_contain_text("Branch 1")
        expect(second.get_by_role("textbox")).to_have_value("with a value")
        page.close()


@pytest.mark.nightly
def test_what_is_saved_from_the_page(browser: Any, tmp_path: Path) -> None:
    """The tape of the branch, and a trace with a row for each of its ticks."""
    path = written(tmp_path)
    with served(str(path)) as address:
        page = opened(browser, address)
        for tick in (0, 1, 2):
            page.keyboard.press(".")
            expect(page.get_by_test_id("clock")).to_contain_text(f"Tick {tick} ")
        for kind in ("tape", "csv"):
            page.get_by_test_id("save-run").click()
            with page.expect_download() as fetched:
                page.get_by_test_id(f"save-{kind}").click()
            fetched.value.save_as(tmp_path / fetched.value.suggested_filename)
        rows = (tmp_path / "part.csv").read_text("utf-8").splitlines()
        assert [row.partition(",")[0] for row in rows] == ["tick", "0", "1", "2"]
        assert '"tape"' in (tmp_path / "part.tape").read_text("utf-8")
        page.close()


@pytest.mark.nightly
def test_a_press_is_answered_first(browser: Any, tmp_path: Path) -> None:
    """From the press of the button on nothing is drawn before the pause, or for a moment only."""
    path = written(tmp_path, PROGRAM.replace("M7", "G04 X3600"))
    with served(str(path)) as address:
        page = opened(browser, address)
        page.get_by_test_id("toggle").click()
        page.wait_for_function("nctaktRun.run.isPlaying && nctaktRun.run.tick > 50")
        drawn = page.evaluate("""async () => {
          const states = [], stop = nctaktRun.listen(() => states.push(nctaktRun.run.isPlaying));
          document.querySelector("[data-testid=toggle]")
            .dispatchEvent(new PointerEvent("pointerdown", { bubbles: true }));
          await new Promise((resolve) => { setTimeout(resolve, 100); });
          const held = states.length;
          await new Promise((resolve) => { setTimeout(resolve, 2000); });
          const after = states.length;
          document.querySelector("[data-testid=toggle]")
            .dispatchEvent(new PointerEvent("pointerdown", { bubbles: true }));
          states.length = 0;
          document.querySelector("[data-testid=toggle]").click();
          while (!states.includes(false)) await new Promise(requestAnimationFrame);
          stop();
          return [held, after];
        }""")
        assert drawn[0] == 0 < drawn[1]
        page.close()


@pytest.mark.nightly
def test_two_ticks_are_compared(browser: Any, tmp_path: Path) -> None:
    """A tick is marked by key; a stretch is selected by Shift and dragging, and shown alone."""
    path = written(tmp_path)
    with served(str(path)) as address:
        page = opened(browser, address)
        page.get_by_test_id("speed").click()
        page.get_by_role("option", name="max").click()
        page.keyboard.press("Escape")
        page.get_by_test_id("toggle").click()
        expect(page.get_by_test_id("state")).to_have_text(re.compile("^ended"))
        page.wait_for_function("nctaktRun.run.ticks.at(-1) === nctaktRun.run.latest")
        page.wait_for_function("nctaktRun.run.ticks[0] === 0")
        page.keyboard.press("m")
        page.wait_for_function("nctaktRun.run.anchor === nctaktRun.run.latest")
        scope = page.get_by_test_id("scope").bounding_box()
        middle = scope["y"] + scope["height"] / 2
        page.keyboard.down("Shift")
        page.mouse.move(scope["x"] + scope["width"] * 0.4, middle)
        page.mouse.down()
        page.mouse.move(scope["x"] + scope["width"] * 0.6, middle, steps=4)
        page.mouse.up()
        page.keyboard.up("Shift")
        anchor, head = page.evaluate("[nctaktRun.run.anchor, nctaktRun.run.head]")
        assert 0 < anchor < head < page.evaluate("nctaktRun.run.latest")
        page.get_by_test_id("zoom_in").click()
        assert page.evaluate("[nctaktRun.run.from, nctaktRun.run.to]") == [anchor, head]
        page.close()


@pytest.mark.nightly
def test_keys_do_all(browser: Any, tmp_path: Path) -> None:
    """Ticks, blocks, the panel, the lists and the help by keys alone."""
    path = written(tmp_path)
    with served(str(path)) as address:
        page = opened(browser, address)
        clock = page.get_by_test_id("clock")
        page.keyboard.press(".")
        expect(clock).to_contain_text("Tick 0 ")
        page.keyboard.press(",")
        expect(clock).to_contain_text("before tick 0 ")
        page.keyboard.press("PageDown")
        expect(page.get_by_text("HLI.OVERRIDE = 95")).to_be_visible()
        page.keyboard.press("b")
        expect(clock).not_to_contain_text("tick 0 ")
        expect(page.get_by_test_id("percent")).to_have_text("95 %")
        page.keyboard.press("h")
        page.keyboard.press(".")
        expect(page.get_by_test_id("hold")).to_have_attribute("aria-checked", "true")
        page.keyboard.press("3")
        expect(page.get_by_test_id("events")).to_contain_text("cycle started 1")
        page.keyboard.press("?")
        expect(page.get_by_text("Back to the last reaction")).to_be_visible()
        page.close()


@pytest.mark.nightly
def test_a_program_that_changes_on_disk(browser: Any, tmp_path: Path) -> None:
    """It is reported, the run continues with the old text, and the new one can be loaded."""
    path = written(tmp_path)
    with served(str(path)) as address:
        page = opened(browser, address)
        path.write_text(PROGRAM.replace("X20", "X30"), "utf-8")
        expect(page.get_by_test_id("load")).to_be_visible()
        page.get_by_test_id("tick").click()
        expect(page.get_by_test_id("clock")).to_contain_text("Tick 0 ")
        page.get_by_test_id("load").click()
        expect(page.locator(".cm-content")).to_contain_text("X30")
        expect(page.get_by_test_id("clock")).to_contain_text("before tick 0 ")
        page.close()


@pytest.mark.nightly
def test_a_plc_that_is_saved(browser: Any, tmp_path: Path) -> None:
    """It is reported; the run restarts with the new text, and what is typed here stays.

    Of a text with a mistake the mistake is reported, and the run stays as it was. What the PLC
    keeps goes on from run to run (ST-406): its cycle is due in the first tick of each.
    """
    path, plc, kept = written(tmp_path), tmp_path / "cell.st", tmp_path / "kept.json"
    text = "PROGRAM MAIN\nVAR RETAIN\n    n : INT;\nEND_VAR\nn := n + 1;\nEND_PROGRAM\n"
    plc.write_text(text, "utf-8")
    with served(str(path), "--plc", str(plc), "--retain", str(kept)) as address:
        page = opened(browser, address)
        page.get_by_test_id("tick").click()
        expect(page.get_by_test_id("clock")).to_contain_text("Tick 0 ")
        expect(page.get_by_test_id("load")).to_be_hidden()
        plc.write_text(text.replace("n + 1", "m + 1"), "utf-8")
        expect(page.get_by_text("PLC changed on disk")).to_be_visible()
        page.get_by_test_id("load").click()
        expect(page.get_by_text("m is not declared").first).to_be_visible()
        expect(page.get_by_test_id("clock")).to_contain_text("Tick 0 ")
        plc.write_text(text.replace("n + 1", "n + 2"), "utf-8")
        page.get_by_test_id("load").click()
        expect(page.get_by_test_id("clock")).to_contain_text("before tick 0 ")
        expect(page.get_by_test_id("load")).to_be_hidden()
        assert json.loads(kept.read_text("utf-8")) == {"MAIN.n": 1}
        page.get_by_test_id("tick").click()
        expect(page.get_by_test_id("clock")).to_contain_text("Tick 0 ")
        page.close()
    assert json.loads(kept.read_text("utf-8")) == {"MAIN.n": 1 + 2}


@pytest.mark.nightly
@pytest.mark.parametrize(("width", "height"), [(1280, 800), (820, 1180)])
def test_nothing_is_cut_off(browser: Any, tmp_path: Path, width: int, height: int) -> None:
    """On a laptop and on a tablet: no scroll bar of the page, every part has room."""
    path = written(tmp_path)
    with served(str(path), "--lang", "de") as address:
        page = opened(browser, address, width, height)
        assert page.evaluate("document.documentElement.scrollWidth") <= width
        for name in ("editor", "scope", "path", "waiting", "override", "findings", "help"):
            box = page.get_by_test_id(name).bounding_box()
            assert box["x"] >= 0, name
            assert box["x"] + box["width"] <= width, name
            assert box["y"] + box["height"] <= height, name
        for name in ("editor", "scope", "path"):
            assert page.get_by_test_id(name).bounding_box()["height"] > 140, name
        page.close()


def test_all_conditions_have_lanes(browser: Any, tmp_path: Path) -> None:
    """Of eight conditions, six are shown; wheel, keys and the program's pointer show the others."""
    branches = "".join(f"  $IF V.E.VALUE > {one}\n    M100\n  $ENDIF\n" for one in range(8))
    text = f"#RT CYCLE [ID=1 SCOPE=PROG]\n{branches}#RT CYCLE END\nG01 X20 F6000\nM30\n"
    with served(str(written(tmp_path, text))) as address:
        page = opened(browser, address)
        page.wait_for_function("nctaktRun.run.conditions.length === 8")
        first = "nctaktRun.run.firstLane"
        assert page.evaluate(first) == 0
        for key, lane in (("j", 1), ("j", 2), ("j", 2), ("k", 1)):
            page.keyboard.press(key)
            page.wait_for_timeout(300)
            page.wait_for_function(f"{first} === {lane}")
        scope = page.get_by_test_id("scope").bounding_box()
        page.mouse.move(scope["x"] + 200, scope["y"] + 60)
        page.mouse.wheel(0, -100)
        page.wait_for_function(f"{first} === 0")
        page.locator(".cm-line").nth(22).hover()
        page.wait_for_function(f"{first} === 2")
        page.close()


def test_conditions_are_filtered(browser: Any, tmp_path: Path) -> None:
    """By keyboard; the filter is still there when the page is reloaded, not in another tab."""
    branches = "".join(f"  $IF V.E.VALUE > {one}\n    M100\n  $ENDIF\n" for one in range(8))
    text = f"#RT CYCLE [ID=1 SCOPE=PROG]\n{branches}#RT CYCLE END\nG01 X20 F6000\nM30\n"
    with served(str(written(tmp_path, text))) as address:
        page = opened(browser, address)
        lanes = "nctaktRun.run.lanesShown.map((one) => nctaktRun.run.conditions[one]).join()"
        page.wait_for_function(f"{lanes} === '2,5,8,11,14,17,20,23'")
        page.keyboard.press("f")
        expect(page.get_by_test_id("lanes-filter")).to_be_focused()
        page.keyboard.type("5-14 value")
        page.wait_for_function(f"{lanes} === '5,8,11,14'")
        expect(page.get_by_test_id("lanes-fitting")).to_have_text("4/8")
        page.keyboard.press("Escape")
        expect(page.get_by_test_id("lanes-filter")).not_to_be_focused()
        page.reload()
        expect(page.get_by_test_id("lanes-filter")).to_have_value("5-14 value")
        page.wait_for_function(f"{lanes} === '5,8,11,14'")
        other = opened(browser, address)
        other.wait_for_function("nctaktRun.run.lanesShown.length === 8")
        other.close()
        page.get_by_test_id("lanes-filter").fill("#2")
        page.wait_for_function("nctaktRun.run.lanesShown.length === 0")
        page.get_by_test_id("lanes-filter").fill("")
        page.wait_for_function("nctaktRun.run.lanesShown.length === 8")
        page.close()


def test_lines_in_view_are_coloured(browser: Any, tmp_path: Path) -> None:
    """As the language server colours them; also what is typed, and where one scrolls to."""
    text = PROGRAM.replace("M7\n", "(first)\n" + "G01 X1\n" * 3000 + "(last)\n")
    with served(str(written(tmp_path, text))) as address:
        page = opened(browser, address)
        expect(page.locator(".nc-t-macro").first).to_have_text("#RT CYCLE")
        variable = page.locator(".cm-line .nc-t-variable.nc-t-realtime").first
        expect(variable).to_have_text("V.E.VALUE")
        expect(page.locator(".nc-t-comment")).to_have_text("(first)")
        page.locator(".cm-content").click()
        page.keyboard.press("Control+End")
        expect(page.locator(".nc-t-comment", has_text="(last)")).to_be_visible()
        page.keyboard.type("(typed)")
        expect(page.locator(".nc-t-comment", has_text="(typed)")).to_be_visible()
        page.close()
