# SPDX-License-Identifier: MIT
"""Paths of several channels and rows of truth values: the page has what a run of them has."""

import random
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest
from support.page_driving import BROWSER, chromium, opened, served

from nctakt.cli.demo import MACHINE
from nctakt.run.controller import Controller

if find_spec("nicegui") is None:  # its import takes long, and only the page's process needs it
    pytest.skip("the live page needs NiceGUI", allow_module_level=True)
playwright = pytest.importorskip("playwright.sync_api", reason="driving a browser needs Playwright")
expect = playwright.expect

pytestmark = BROWSER

MILL = """#RT CYCLE [ID=1 SCOPE=PROG]
  $IF EDGE V.RTA.ACS.ACT_POS.X > 5 && V.E.AREA_FREE == TRUE
    V.E.PARTS += 1
  $ENDIF
#RT CYCLE END
G01 X20 F6000
G00 X0 Z10
M30
"""
LOADER = "G01 U30 F6000\nG00 U10\nM30\n"
X, Z, U, FREE = "X.ACS.ACT_POS", "Z.ACS.ACT_POS", "CH2.U.ACS.ACT_POS", "V.E.AREA_FREE"
AT = ("4 ms", FREE, 1)
RAPID = ("PATH.RAPID", "CH2.PATH.RAPID")


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    with chromium() as browser:
        yield browser


def test_paths_of_channels_and_rows_of_truth_values(browser: Any, tmp_path: Path) -> None:
    """Before the first tick, at its ticks to come; then where both channels are."""
    files = {"mill": tmp_path / "mill.nc", "loader": tmp_path / "loader.nc"}
    files["mill"].write_text(MILL, "utf-8")
    files["loader"].write_text(LOADER, "utf-8")
    controller = Controller(MACHINE)
    signals = [X, Z, U, FREE, *RAPID]
    run = controller.run(files["mill"], channels={2: [files["loader"]]}, signals=signals, at=[AT])
    trace = run.trace
    words = (
        "--channel",
        "2",
        str(files["loader"]),
        "--machine",
        str(MACHINE),
        "--at",
        "4ms",
        f"{FREE}=1",
    )
    with served(str(files["mill"]), *words) as address:
        page = opened(browser, address)
        page.wait_for_function("nctaktRun.run.future?.reason === 'over'")
        future = page.evaluate("nctaktRun.run.future")
        columns = dict(zip(future["names"], future["columns"], strict=True))
        for name in (X, Z, U, *RAPID):
            expected = [trace.at(tick, name) for tick in future["ticks"]]
            assert columns[name] == pytest.approx(expected, rel=1e-6, abs=1e-9), name
        assert [mark[1:] for mark in future["marks"]] == [["fired", "1:1:2", 2, 1]]
        expect(page.locator(".nc-key.channel_line")).to_have_text(["Channel 1", "Channel 2"])
        walk = random.Random(35)
        for _ in range(4):
            for _ in range(walk.randrange(1, 4)):
                page.keyboard.press(".")
            page.keyboard.press(walk.choice("bB"))
            page.wait_for_timeout(400)
            page.wait_for_function(
                "nctaktRun.run.drawn.tick === nctaktRun.run.tick && nctaktRun.run.tick >= 0"
            )
            shown = page.evaluate(
                "[nctaktRun.run.drawn, nctaktRun.run.names, nctaktRun.run.now,"
                " nctaktRun.run.booleans]"
            )
            drawn, names, now, booleans = shown
            (other,) = drawn["others"]
            assert other["channel"] == 2
            at = drawn["tick"]
            assert other["point"] == pytest.approx([trace.at(at, U), 0, 0], rel=1e-6, abs=1e-9)
            place = names.index(FREE)
            assert (booleans[place], now[place]) == (True, trace.at(at, FREE))
            assert booleans[names.index(X)] is False
        page.close()


def test_a_channel_without_variables_says_so(browser: Any) -> None:
    """Nothing has been searched for: that no variable has a name would be no answer."""
    folder = Path(__file__).parents[2] / "examples" / "channels"
    words = ("--channel", "2", str(folder / "unload.nc"), "--machine", str(folder / "machine"))
    with served(str(folder / "load.nc"), *words) as address:
        page = opened(browser, address)
        expect(page.get_by_text("This channel has no V.E variables.")).to_be_visible()
        page.close()
