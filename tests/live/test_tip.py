# SPDX-License-Identifier: MIT
"""The path under a transformation: what the page draws is what the engine had in that tick."""

import random
import re
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest
from support.changed_lists import machine_with
from support.page_driving import BROWSER, chromium, opened, served
from support.stepped_machine import DEMO5

from nctakt.run.controller import Controller, NcText

if find_spec("nicegui") is None:  # its import takes long, and only the page's process needs it
    pytest.skip("the live page needs NiceGUI", allow_module_level=True)
playwright = pytest.importorskip("playwright.sync_api", reason="driving a browser needs Playwright")
expect = playwright.expect

pytestmark = BROWSER

PROGRAM = """T1 D1
G00 X0 Y0 Z200
#TRAFO ON
G00 X10 Y10 Z20
G01 X60 A30 F4000
Y40 C90
#TRAFO OFF
M30
"""
TIP = [f"{axis}.MCS.ACT_POS" for axis in "XYZ"]
AXES = [f"{axis}.ACS.ACT_POS" for axis in "XYZ"]
DIRECTION = [f"TOOL.DIRECTION.{axis}" for axis in "XYZ"]

#: Shown numbers have seven digits.
NEAR = {"rel": 1e-6, "abs": 1e-9}


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    with chromium() as browser:
        yield browser


def travelled(page: Any, share: float) -> dict[str, Any]:
    """What the path shows after a click on a place of the scope, which travels there."""
    before = page.evaluate("nctaktRun.run.tick")
    box = page.get_by_test_id("scope").bounding_box()
    x = box["x"] + 50 + share * (box["width"] - 58)
    page.mouse.click(x, box["y"] + box["height"] * 0.7)
    page.wait_for_function("before => nctaktRun.run.tick !== before", arg=before)
    return drawn(page)


def drawn(page: Any) -> dict[str, Any]:
    """What the path shows once it has been drawn."""
    found: dict[str, Any] = page.evaluate(
        "() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame("
        "() => done(nctaktRun.run.drawn))))"
    )
    return found


def test_tip_and_direction_are_the_engines(browser: Any, tmp_path: Path) -> None:
    """At ticks of a random walk; X (key) and the switch show the axes instead, without a tool."""
    path = tmp_path / "part.nc"
    path.write_text(PROGRAM, "utf-8")
    signals = [*TIP, *AXES, *DIRECTION]
    trace = Controller(DEMO5).run(NcText("part.nc", PROGRAM), signals=signals).trace
    with served(str(path), "--machine", str(DEMO5)) as address:
        page = opened(browser, address)
        page.get_by_test_id("speed").click()
        page.get_by_role("option", name="max").click()
        page.get_by_test_id("toggle").click()
        expect(page.get_by_test_id("state")).to_contain_text("ended")
        # The curves come a moment after the state, and a click goes to a tick that they know.
        page.wait_for_function("nctaktRun.run.ticks[0] < 10")
        walk = random.Random(35)
        leaning = 0
        for share in (0.01, *(walk.uniform(0.3, 0.9) for _ in range(5)), 0.5, 0.99):
            shown = travelled(page, share)
            tick = shown["tick"]
            assert shown["names"] == TIP
            assert shown["tool"] == pytest.approx([trace.at(tick, name) for name in TIP], **NEAR)
            expected = [trace.at(tick, name) for name in DIRECTION]
            if any(expected):
                assert shown["direction"] == pytest.approx(expected, **NEAR)
            else:
                assert shown["direction"] is None
            leaning += abs(expected[1]) > 0.01
        assert leaning > 2
        tick = travelled(page, 0.5)["tick"]
        page.evaluate("document.activeElement.blur()")
        page.keyboard.press("x")
        page.wait_for_function("nctaktRun.run.drawn.names[0].includes('ACS')")
        shown = drawn(page)
        assert shown["tool"] == pytest.approx([trace.at(tick, name) for name in AXES], **NEAR)
        assert shown["direction"] is None
        page.get_by_test_id("machine-axes").click()
        page.wait_for_function("nctaktRun.run.drawn.names[0].includes('MCS')")
        page.close()


def test_one_axis_is_a_line(browser: Any, tmp_path: Path) -> None:
    """The position of the only axis is drawn; without a transformation there is no switch."""
    machine = machine_with(tmp_path / "machine")
    channel = machine / "sda_mds1.lis"
    text = re.sub(
        r"^(gruppe\[0\]\.achs_anzahl +)4", r"\g<1>1", channel.read_text("utf-8"), flags=re.M
    )
    channel.write_text(re.sub(r"^gruppe\[0\]\.achse\[[123]\].*\n", "", text, flags=re.M), "utf-8")
    path = tmp_path / "part.nc"
    path.write_text("G01 X20 F6000\nM30\n", "utf-8")
    errors: list[str] = []
    with served(str(path), "--machine", str(machine)) as address:
        page = opened(browser, address)
        page.on("pageerror", lambda error: errors.append(str(error)))
        for _ in range(3):
            page.keyboard.press(".")
        for _ in range(2):  # no other view, no transformation
            page.keyboard.press("v")
            page.keyboard.press("x")
        expect(page.get_by_test_id("clock")).to_contain_text("Tick 2 ")
        expect(page.get_by_test_id("machine-axes")).to_be_hidden()
        page.wait_for_function("nctaktRun.run.tick === 2 && nctaktRun.run.drawn.tool[0] > 0")
        shown = drawn(page)
        assert shown["names"] == ["X.ACS.ACT_POS"]
        assert float(page.get_by_test_id("axis-X").inner_text()) == pytest.approx(
            shown["tool"][0], abs=5e-4
        )
        assert errors == []
        page.close()
