# SPDX-License-Identifier: MIT
"""A browser without a window, where one is installed."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import pytest

WIDTH, HEIGHT = 1280, 1400


@contextmanager
def browser_page() -> Iterator[tuple[Any, list[str]]]:
    """A page of Chromium and the errors that it reports; skips without playwright or Chromium."""
    reason = "the Python package playwright is not installed"
    module = pytest.importorskip("playwright.sync_api", reason=reason)
    program = shutil.which("chromium") or shutil.which("google-chrome")
    if program is None:
        pytest.skip("Chromium is not installed")
    errors: list[str] = []
    with module.sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=program, args=["--no-sandbox"])
        page = browser.new_page(viewport={"width": WIDTH, "height": HEIGHT})
        page.on("pageerror", lambda error: errors.append(str(error)))
        page.on(
            "console",
            lambda message: errors.append(message.text) if message.type == "error" else None,
        )
        try:
            yield page, errors
        finally:
            browser.close()
