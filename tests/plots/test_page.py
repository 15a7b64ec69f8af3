# SPDX-License-Identifier: MIT
"""The interactive page in a browser: it draws, zooms, shows values and places."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from support.browsers import browser_page
from support.runs_to_draw import drawn

pytestmark = pytest.mark.slow


def test_the_page_draws_and_answers(tmp_path: Path) -> None:
    """No error, no request; cursor, tooltip, zoom, legend, space, dark."""
    drawn().plot(tmp_path / "part.html")
    with browser_page() as (page, errors):
        requests: list[str] = []
        page.on("request", lambda request: requests.append(request.url))
        page.goto((tmp_path / "part.html").as_uri())
        page.wait_for_timeout(300)
        first = pixels(page, "time")
        assert max(first[:3]) > 0  # something is drawn
        left, top, width = box(page)
        page.mouse.move(left + 132 + 0.4 * (width - 132 - 216), top + 300)
        page.wait_for_timeout(100)
        values = page.locator(".legend b").all_inner_texts()
        assert values and all(value for value in values)
        page.mouse.move(left + 300, top + 32)  # the lane of the blocks
        page.wait_for_timeout(100)
        assert "N10 G00 X20 Y5" in page.inner_text("#tip")
        page.mouse.wheel(0, -600)
        page.wait_for_timeout(100)
        assert pixels(page, "time") != first
        page.click("text=whole run")
        page.click(".legend button >> nth=0")
        assert page.get_attribute(".legend button >> nth=0", "aria-pressed") == "false"
        flat = pixels(page, "path")
        page.click(".switch")
        page.wait_for_timeout(100)
        assert pixels(page, "path") != flat
        page.click("[title='light or dark']")
        assert page.evaluate("document.documentElement.dataset.theme") == "dark"
        assert (errors, len(requests)) == ([], 1)


def test_the_arrow_keys_move_the_cursor_by_a_tick(tmp_path: Path) -> None:
    """After a click, which holds it; Escape lets it go."""
    drawn().plot(tmp_path / "part.html", signals=["X.ACS.ACT_POS"])
    with browser_page() as (page, errors):
        page.goto((tmp_path / "part.html").as_uri())
        left, top, _ = box(page)
        page.mouse.click(left + 400, top + 60)
        before = page.inner_text(".legend b")
        page.locator(".part:has(#time)").focus()
        page.keyboard.press("ArrowRight")
        page.wait_for_timeout(100)
        assert page.inner_text(".legend b") != before
        page.keyboard.press("Escape")
        page.wait_for_timeout(100)
        assert page.inner_text(".legend b") == ""
        assert errors == []


def box(page: Any) -> tuple[float, float, float]:
    """Left, top and width of the drawing over time."""
    bounds = page.locator("#time").bounding_box()
    return bounds["x"], bounds["y"], bounds["width"]


def pixels(page: Any, canvas: str) -> list[int]:
    """A sum of the pixels of a drawing by colour."""
    script = """name => {
      const canvas = document.getElementById(name);
      const data = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
      const sums = [0, 0, 0, 0];
      for (let i = 0; i < data.length; i += 1) sums[i % 4] += data[i];
      return sums;
    }"""
    found: list[int] = page.evaluate(script, canvas)
    return found
