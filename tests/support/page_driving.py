# SPDX-License-Identifier: MIT
"""``nctakt live`` in its own process, with Chromium as its browser."""

import contextlib
import os
import shutil
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from support.published_model import installed

CHROMIUM = shutil.which("chromium")

#: How long a page may take for anything, in ms: the machine may be busy with other things.
PATIENCE_MS = 60_000

#: Marks of tests that drive a browser.
BROWSER = [
    pytest.mark.slow,
    pytest.mark.skipif(
        CHROMIUM is None or sys.platform != "linux",
        reason="driving a browser needs Chromium on Linux",
    ),
]


@contextlib.contextmanager
def served(
    *words: str, errors: Path | None = None, command: tuple[str, ...] = ("live",)
) -> Iterator[str]:
    """``nctakt live`` in its own process; its address. Its reports go to ``errors``.

    ``command``: another one that serves the page, such as ``demo``.
    """
    environment = {name: value for name, value in os.environ.items() if "PYTEST" not in name}
    call = [sys.executable, "-m", "nctakt", *command, *words, "--port", "0"]
    with (
        (errors or Path(os.devnull)).open("w", encoding="utf-8") as reported,
        subprocess.Popen(
            call, stdout=subprocess.PIPE, stderr=reported, encoding="utf-8", env=environment
        ) as process,
    ):
        try:
            assert process.stdout is not None
            yield process.stdout.readline().strip()
        finally:
            process.send_signal(signal.SIGINT)
            with contextlib.suppress(subprocess.TimeoutExpired):
                process.wait(60)
            process.kill()


@contextlib.contextmanager
def chromium() -> Iterator[Any]:
    """A browser without a window; its errors are the test's."""
    playwright = pytest.importorskip(
        "playwright.sync_api", reason="driving a browser needs Playwright"
    )
    playwright.expect.set_options(timeout=PATIENCE_MS)
    with (
        playwright.sync_playwright() as driver,
        contextlib.closing(
            driver.chromium.launch(executable_path=CHROMIUM, args=["--no-sandbox"])
        ) as browser,
    ):
        yield browser


def opened(browser: Any, address: str, width: int = 1280, height: int = 800) -> Any:
    """A page at an address, once it shows where the session is."""
    page = browser.new_page(viewport={"width": width, "height": height})
    page.set_default_timeout(PATIENCE_MS)
    page.goto(address)
    page.wait_for_function("document.querySelector('[data-testid=clock]')?.textContent")
    return page


def axe_source(folder: Path) -> str:
    """Return the source of axe-core; skip the test where npm cannot fetch it."""
    modules = installed("axe-core", folder)
    return (modules / "axe-core" / "axe.min.js").read_text("utf-8")


def serious(page: Any, axe: str) -> list[str]:
    """What axe-core finds serious or critical."""
    page.evaluate(axe)
    # without its own requests for style sheets, during which the library shows a bar
    options = "{ resultTypes: ['violations'], preload: false }"
    found = page.evaluate(f"axe.run(document, {options})")
    return [
        f"{one['id']}: {node['html'][:120]} {node['failureSummary'][:200]}"
        for one in found["violations"]
        if one["impact"] in ("serious", "critical")
        for node in one["nodes"]
    ]
