# SPDX-License-Identifier: MIT
"""The PLC on the page, in Chromium: files next to the program, values, stops, steps, by keys alone.

The task runs each 10 ms, so in ticks 0, 10 … of the demo machine.
"""

from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest
from support.page_driving import BROWSER, axe_source, chromium, opened, serious, served
from support.plc_text import pou_file

if find_spec("nicegui") is None:  # its import takes long, and only the page's process needs it
    pytest.skip("the live page needs NiceGUI", allow_module_level=True)
playwright = pytest.importorskip("playwright.sync_api", reason="driving a browser needs Playwright")
expect = playwright.expect

pytestmark = [*BROWSER, pytest.mark.nightly]

MAIN = pou_file(
    "MAIN",
    "PROGRAM MAIN\nVAR\n    n : INT; // cycles so far\n    fbGate : FB_Gate;\nEND_VAR",
    "n := n + 1;\nfbGate.Tick(n);\nfbGate(bGo := n > 2);",
)
GATE = pou_file(
    "FB_Gate",
    "FUNCTION_BLOCK FB_Gate\nVAR_INPUT\n    bGo : BOOL;\nEND_VAR\nVAR\n    nCount : INT;\nEND_VAR",
    "IF bGo THEN\n    nCount := nCount + 1;\nEND_IF",
    '<Method Name="Tick" Id="{1}"><Declaration><![CDATA[METHOD Tick\nVAR_INPUT\n    nBy : INT;\n'
    "END_VAR]]></Declaration><Implementation><ST><![CDATA[nCount := nCount + nBy;]]></ST>"
    "</Implementation></Method>\n",
)
PROJECT = (
    '<Project xmlns="http://schemas.microsoft.com/developer/msbuild/2003"><ItemGroup>'
    '<Compile Include="MAIN.TcPOU" /><Compile Include="FB_Gate.TcPOU" /></ItemGroup></Project>'
)


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    with chromium() as browser:
        yield browser


@pytest.fixture(name="part")
def _part(tmp_path: Path) -> Path:
    (tmp_path / "MAIN.TcPOU").write_text(MAIN, "utf-8")
    (tmp_path / "FB_Gate.TcPOU").write_text(GATE, "utf-8")
    (tmp_path / "Cell.plcproj").write_text(PROJECT, "utf-8")
    path = tmp_path / "part.nc"
    path.write_text("G01 X20 F1000\nM30\n", "utf-8")
    return path


def test_steps_values_and_stops_by_keys(browser: Any, part: Path) -> None:
    """Into a call, with the values of its line; back out; a stop at the cursor; a condition."""
    with served(str(part), "--plc", str(part.parent / "Cell.plcproj")) as address:
        page = opened(browser, address)
        block, lines = page.locator(".nc-plc-line.nc-block"), page.get_by_test_id("plc-lines")
        expect(lines).to_be_hidden()
        page.keyboard.press("i")
        expect(block).to_contain_text("n := n + 1;n = 0")
        expect(page.get_by_test_id("plc-standing")).to_contain_text("MAIN, implementation line 1")
        page.keyboard.press("i")
        expect(block).to_contain_text("fbGate.Tick(n);n = 1")
        page.keyboard.press("i")
        expect(block).to_contain_text("nCount := nCount + nBy;nCount = 0 · nBy = 1")
        expect(block).to_be_in_viewport()
        expect(page.get_by_test_id("file")).to_have_value("FB_Gate.TcPOU")
        page.keyboard.press("U")
        expect(block).to_contain_text("fbGate.Tick(n);")
        page.keyboard.press("o")
        expect(block).to_contain_text("fbGate(bGo := n > 2);")
        page.keyboard.press("e")
        expect(lines).to_be_focused()
        page.keyboard.press("F9")
        expect(page.locator(".nc-stopped .nc-plc-number")).to_have_text("3")
        page.keyboard.press(".")
        expect(block).to_have_count(0)
        page.keyboard.press("c")
        stop = page.get_by_test_id("new-stop")
        expect(stop).to_be_focused()
        expect(stop).to_have_value("statement MAIN.TcPOU:11 if ")
        page.keyboard.type("n > 2")
        page.keyboard.press("Enter")
        page.keyboard.press("Escape")
        remove = page.get_by_role("button", name="Remove: statement MAIN.TcPOU:11", exact=True)
        remove.click()
        expect(remove).to_have_count(0)
        page.keyboard.press(" ")
        expect(page.get_by_test_id("clock")).to_contain_text("Tick 20 ")
        expect(block).to_contain_text("fbGate(bGo := n > 2);n = 3")
        page.keyboard.press("t")
        expect(page.get_by_test_id("file")).to_have_value("FB_Gate.TcPOU")
        page.keyboard.press("t")
        expect(lines).to_be_hidden()
        expect(page.locator(".cm-content")).to_contain_text("G01 X20")
        page.close()


def test_values_of_an_instance(browser: Any, part: Path) -> None:
    """After a tick the values are those of an instance; what lives in a call has none."""
    with served(str(part), "--plc", str(part.parent / "Cell.plcproj")) as address:
        page = opened(browser, address)
        page.keyboard.press(".")
        expect(page.get_by_test_id("clock")).to_contain_text("Tick 0 ")
        for _ in range(2):
            page.keyboard.press("t")
        expect(page.get_by_test_id("plc_instance")).to_have_value("MAIN.fbGate")
        beside = page.locator(".nc-plc-value")
        expect(beside).to_have_text(
            ["bGo = FALSE", "nCount = 1", "bGo = FALSE"] + ["nCount = 1"] * 2
        )
        page.close()


def test_structures_unfold_and_names_are_explained_by_keys(browser: Any, part: Path) -> None:
    """The tree of the cursor's line, its values in the next tick; F1 has type and comment."""
    with served(str(part), "--plc", str(part.parent / "Cell.plcproj")) as address:
        page = opened(browser, address)
        block, tree = page.locator(".nc-plc-line.nc-block"), page.get_by_test_id("plc-tree")
        for line in ("n := n + 1;", "fbGate.Tick(n);", "nCount := nCount + nBy;"):
            page.keyboard.press("i")
            expect(block).to_contain_text(line)
        expect(tree).to_have_count(0)
        page.keyboard.press("U")
        page.keyboard.press("o")
        expect(block).to_contain_text("fbGate(bGo := n > 2);")
        rows = tree.get_by_role("treeitem")
        expect(rows).to_have_text(["▸fbGate = bGo FALSE, nCount 1", "n = 1"])
        page.keyboard.press("e")
        page.keyboard.press("Enter")
        expect(tree).to_be_focused()
        page.keyboard.press("ArrowRight")
        unfolded = ["▾fbGate = bGo FALSE, nCount 1", "bGo = FALSE", "nCount = 1", "n = 1"]
        expect(rows).to_have_text(unfolded)
        expect(rows.first).to_have_attribute("aria-expanded", "true")
        page.keyboard.press("e")
        page.keyboard.press("F1")
        reported = page.get_by_test_id("plc-tip")
        expect(reported).to_contain_text("VAR fbGate : FB_Gate;")
        expect(reported).to_contain_text("INT")
        page.keyboard.press("Escape")
        expect(reported).to_be_hidden()
        page.locator(".nc-plc-text", has_text="n : INT").hover(position={"x": 35, "y": 8})
        expect(reported).to_contain_text("VAR n : INT;")
        expect(reported).to_contain_text("cycles so far")
        page.keyboard.press(".")
        expect(rows.nth(2)).to_have_text("nCount = 1")
        rows.first.click()
        expect(rows).to_have_count(2)
        page.close()


def test_a_text_is_changed_and_saved_by_keys(browser: Any, part: Path) -> None:
    """Nothing else of the file changes; the run restarts; another writer is not overwritten."""
    main = part.parent / "MAIN.TcPOU"
    main.write_bytes(MAIN.replace("\n", "\r\n").encode())
    with served(str(part), "--plc", str(part.parent / "Cell.plcproj")) as address:
        page = opened(browser, address)
        block, edit = page.locator(".nc-plc-line.nc-block"), page.get_by_test_id("plc-edit")
        page.keyboard.press("i")
        expect(block).to_contain_text("n := n + 1;n = 0")
        page.keyboard.press("F2")
        expect(edit.locator(".cm-content")).to_be_focused()
        expect(edit).to_contain_text("n := n + 1;")
        page.keyboard.press("Control+Home")
        page.keyboard.type("n := n + 40; // <more>\n")
        expect(page.get_by_text("not saved")).to_be_visible()
        page.keyboard.press("Control+s")
        expect(edit).to_be_hidden()
        wanted = MAIN.replace("n := n + 1;", "n := n + 40; // <more>\nn := n + 1;")
        assert main.read_bytes() == wanted.replace("\n", "\r\n").encode()
        page.keyboard.press("Escape")
        expect(page.get_by_test_id("plc-lines")).to_contain_text("n := n + 40;")
        page.get_by_test_id("plc_edit").click()
        expect(edit).to_be_visible()
        main.write_bytes(MAIN.encode())
        page.keyboard.type(" ")
        page.keyboard.press("Control+s")
        expect(page.get_by_text("901162")).to_be_visible()
        assert main.read_bytes() == MAIN.encode()
        page.close()


def test_findings_while_a_text_is_typed(browser: Any, part: Path) -> None:
    """Underlined, with a tooltip, listed with the line of the file, which a click shows."""
    with served(str(part), "--plc", str(part.parent / "Cell.plcproj")) as address:
        page = opened(browser, address)
        edit, found = page.get_by_test_id("plc-edit"), page.get_by_test_id("findings")
        page.keyboard.press("i")
        expect(page.locator(".nc-plc-line.nc-block")).to_be_visible()
        page.keyboard.press("F2")
        expect(edit.locator(".cm-content")).to_be_focused()
        page.keyboard.press("Control+Home")
        page.keyboard.type("m := 1;\n")
        mark = edit.locator(".nc-error")
        expect(mark).to_have_text("m")
        expect(found.locator(".nc-finding")).to_have_count(1)
        expect(found).to_contain_text("MAIN.TcPOU:")
        mark.hover()
        expect(page.locator(".nc-tip-finding")).to_contain_text("m")
        found.locator(".nc-finding").click()
        expect(edit.locator(".cm-activeLine")).to_have_text("m := 1;")
        page.keyboard.press("Control+Home")
        page.keyboard.press("Delete")
        page.keyboard.type("n")
        expect(mark).to_have_count(0)
        expect(found.locator(".nc-finding.error")).to_have_count(0)
        page.keyboard.press("F2")
        page.close()


def test_events_and_answers_lead_to_lines_of_the_plc(browser: Any) -> None:
    """M7 is acknowledged by a statement; why shows what that has written, and names others."""
    folder = Path(__file__).parents[2] / "examples" / "coolant"
    words = ("--plc", str(folder / "cell.st"), "--set", "MAIN.bPressure=1")
    with served(str(folder / "part.nc"), *words) as address:
        page = opened(browser, address)
        page.get_by_test_id("tab-stops").click()
        page.get_by_test_id("new-stop").fill("V.RTA.ACS.ACT_POS.X > 1")
        page.keyboard.press("Enter")
        page.keyboard.press("Escape")
        page.keyboard.press(" ")
        expect(page.get_by_text("V.RTA.ACS.ACT_POS.X > 1").nth(1)).to_be_visible()
        page.keyboard.press("3")
        row = page.get_by_test_id("events").locator(".acknowledged")
        expect(row).to_contain_text("cell.st:")
        row.click()
        expect(page.get_by_test_id("file")).to_have_value("cell.st")
        cursor = page.locator(".nc-plc-cursor")
        expect(cursor).to_contain_text("done_w := TRUE")
        page.keyboard.press("F8")
        answer = page.get_by_test_id("why")
        expect(answer).to_contain_text("techno_unit_std_sync[0].done_w")
        page.get_by_test_id("why-place").nth(1).click()
        expect(cursor).not_to_contain_text("done_w := TRUE")
        page.close()


def test_axe_finds_nothing_serious_in_the_plc(
    browser: Any, part: Path, tmp_path_factory: pytest.TempPathFactory
) -> None:
    """In light and dark, in German; the parts that are shown only there have names."""
    axe = axe_source(tmp_path_factory.mktemp("npm"))
    with served(str(part), "--plc", str(part.parent / "Cell.plcproj"), "--lang", "de") as address:
        page = opened(browser, address)
        for _ in range(3):
            page.keyboard.press("i")
        expect(page.get_by_test_id("plc-standing")).to_contain_text("vor der markierten Zeile")
        block = page.locator(".nc-plc-line.nc-block")
        expect(block).to_contain_text("nCount := nCount + nBy;")
        page.keyboard.press("U")
        page.keyboard.press("o")
        expect(block).to_contain_text("fbGate(bGo := n > 2);")
        expect(page.get_by_test_id("plc-tree")).to_be_visible()
        page.wait_for_timeout(400)
        assert serious(page, axe) == []
        page.keyboard.press("e")
        page.keyboard.press("F9")
        expect(page.locator(".nc-stopped")).to_have_count(1)
        page.keyboard.press("Home")
        page.keyboard.press("ArrowDown")
        page.keyboard.press("F1")
        expect(page.get_by_test_id("plc-tip")).to_contain_text("PROGRAM MAIN")
        page.wait_for_timeout(400)
        assert serious(page, axe) == []
        page.emulate_media(color_scheme="dark")
        expect(page.locator("body.body--dark")).to_have_count(1)
        page.wait_for_timeout(400)
        assert serious(page, axe) == []
        page.close()
