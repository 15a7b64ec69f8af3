# SPDX-License-Identifier: MIT
"""A machine's log on the page: a second, pale curve in the scope, differences marked."""

from __future__ import annotations

from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest
from support.page_driving import BROWSER, chromium, opened, served

from nctakt.run.controller import Controller
from nctakt.studies.plans.faults import FaultyPlc, PlcFaults

if find_spec("nicegui") is None:
    pytest.skip("the live page needs NiceGUI", allow_module_level=True)
pytest.importorskip("playwright.sync_api", reason="driving a browser needs Playwright")

pytestmark = BROWSER

PART = "G01 X20 F6000\nM10\nX0\nM30\n"


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    with chromium() as browser:
        yield browser


def logged(folder: Path) -> tuple[str, str]:
    """The program, and the log of a machine that acknowledges M10 30 ms later, from 1 s on."""
    part, log = folder / "part.nc", folder / "scope.csv"
    part.write_text(PART, "utf-8")
    slow = FaultyPlc(None, PlcFaults({"M10": 30_000}))
    trace = Controller().run(str(part), signals=["X.ACS.ACT_POS"], plc=slow).trace
    assert trace is not None
    rows = (f"{1000 + tick},{trace.at(tick, 'X.ACS.ACT_POS'):.6f}\n" for tick in range(trace.ticks))
    log.write_text("time_ms,Axis X ActPos\n" + "".join(rows), "utf-8")
    return str(part), str(log)


def test_the_log_is_a_pale_curve_over_the_run(browser: Any, tmp_path: Path) -> None:
    """Its points in ticks of the run; the stretch after M10 is marked; red is between both."""
    part, log = logged(tmp_path)
    words = ("--log", log, "--offset", "1s", "--tolerance", "0.05")
    with served(part, *words) as address:
        page = opened(browser, address)
        page.get_by_test_id("speed").click()
        page.get_by_role("option", name="max").click()
        page.get_by_test_id("toggle").click()
        page.wait_for_function("nctaktRun.run.latest > 100 && !nctaktRun.run.isPlaying")
        found = page.evaluate("nctaktRun.run.logged['X.ACS.ACT_POS']")
        assert found["isWhole"] is True
        assert found["ticks"][:3] == [0, 1, 2]
        assert found["values"][0] == 0.002  # the end of the first tick
        (begin, end), *more = found["beyond"]
        assert more == []
        run = Controller().run(part, blocks=True, signals=["X.ACS.ACT_POS"])
        third = [event.tick for event in run.events if event.kind == "block"][2]
        assert third <= begin <= third + 20  # X0 begins to move on ours, not on the machine
        assert end > begin + 100
        red = """() => {
          const canvas = document.querySelector('[data-testid=scope] canvas');
          const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
          let count = 0;
          for (let i = 0; i < data.length; i += 4)
            if (data[i] > 150 && data[i + 1] < 110 && data[i + 2] < 110) count += 1;
          return count;
        }"""
        page.wait_for_function(f"({red})() > 100")
        page.close()


def test_the_legend_has_the_log_until_its_end(browser: Any, tmp_path: Path) -> None:
    """A log at 4 ms whose last sample is before the last tick: its value stays for less than 4 ms.

    Farther away, and beyond a log that ends in the middle, there is none.
    """
    part, log = logged(tmp_path)
    run = Controller().run(part, signals=["X.ACS.ACT_POS"])
    assert run.trace is not None
    last = run.ticks - 1
    whole = [
        f"{1000 + tick},{run.trace.at(tick, 'X.ACS.ACT_POS'):.3f}" for tick in range(run.ticks)
    ]
    ending = whole[(last - 3) % 4 : last - 2 : 4]  # three ticks before the last one
    Path(log).write_text("time_ms,Axis X ActPos\n" + "\n".join(ending), "utf-8")
    listen = """() => {
      window.reported = [];
      const draw = CanvasRenderingContext2D.prototype.fillText;
      CanvasRenderingContext2D.prototype.fillText = function (text, ...where) {
        if (text.startsWith("X ") && !text.includes("…")) window.reported.push(text);
        return draw.call(this, text, ...where);
      };
    }"""
    for rows, has_value in ((ending, True), (ending[:-1], False)):
        Path(log).write_text("time_ms,Axis X ActPos\n" + "\n".join(rows), "utf-8")
        with served(part, "--log", log, "--offset", "1s") as address:
            page = opened(browser, address)
            page.evaluate(listen)
            page.get_by_test_id("speed").click()
            page.get_by_role("option", name="max").click()
            page.get_by_test_id("toggle").click()
            page.wait_for_function(f"nctaktRun.run.tick === {last} && !nctaktRun.run.isPlaying")
            page.evaluate("window.reported.length = 0")
            page.set_viewport_size({"width": 1190, "height": 900})
            page.wait_for_function("window.reported.length > 0")
            assert ("log 0" in page.evaluate("window.reported.at(-1)")) == has_value
            page.close()


def test_a_wrong_log_is_reported_before_the_page(tmp_path: Path, capfd: Any) -> None:
    """902519 with what it has; exit code 2, as of any command with an input that cannot be used."""
    from nctakt.cli import main  # noqa: PLC0415 - only this test is not in a process of its own

    part, log = logged(tmp_path)
    Path(log).write_text("time_ms,pressure\n0,1\n1,2\n", "utf-8")
    assert main(["live", part, "--log", log, "--port", "0"]) == 2
    assert "902519" in capfd.readouterr().err
