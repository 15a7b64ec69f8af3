# SPDX-License-Identifier: MIT
"""The live page in a browser: Chromium, driven by Playwright, from the first tick to the end."""

import contextlib
import os
import re
import shutil
import signal
import subprocess
import sys
import urllib.request
from collections.abc import Iterator
from pathlib import Path

import pytest

pytest.importorskip("nicegui", reason="the live page needs NiceGUI")
playwright = pytest.importorskip("playwright.sync_api", reason="driving a browser needs Playwright")
CHROMIUM = shutil.which("chromium")

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(CHROMIUM is None, reason="driving a browser needs Chromium"),
]

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

#: How long a page may take for anything, in ms: the machine may be busy with other things.
PATIENCE_MS = 60_000


@contextlib.contextmanager
def served(*words: str) -> Iterator[str]:
    """``nctakt live`` in a process of its own; its address."""
    environment = {name: value for name, value in os.environ.items() if "PYTEST" not in name}
    command = [sys.executable, "-m", "nctakt", "live", *words, "--port", "0"]
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, encoding="utf-8", env=environment
    ) as process:
        try:
            assert process.stdout is not None
            yield process.stdout.readline().strip()
        finally:
            process.send_signal(signal.SIGINT)
            with contextlib.suppress(subprocess.TimeoutExpired):
                process.wait(60)
            process.kill()


@pytest.mark.skipif(sys.platform != "linux", reason="driving a browser needs Chromium on Linux")
def test_a_person_at_the_page(tmp_path: Path) -> None:
    """Step, set a variable, see the reaction, travel, run, acknowledge, pause, make a mistake."""
    path = tmp_path / "part.nc"
    path.write_text(PROGRAM, "utf-8")
    with (
        served(str(path), "--acknowledge") as address,
        playwright.sync_playwright() as driver,
        contextlib.closing(
            driver.chromium.launch(executable_path=CHROMIUM, args=["--no-sandbox"])
        ) as browser,
    ):
        expect = playwright.expect
        expect.set_options(timeout=PATIENCE_MS)
        page = browser.new_page(viewport={"width": 1280, "height": 800})
        page.set_default_timeout(PATIENCE_MS)
        foreign: list[str] = []
        page.on(
            "request",
            lambda request: (
                foreign.append(request.url)
                if not request.url.startswith(
                    (address, "data:", "blob:", address.replace("http", "ws"))
                )
                else None
            ),
        )
        with urllib.request.urlopen(address) as answer:  # who only looks takes no pen
            assert answer.status == 200
        page.goto(address)
        clock, state = page.get_by_test_id("clock"), page.get_by_test_id("state")
        count = page.get_by_test_id("variable-V.E.COUNT")
        expect(clock).to_contain_text("Tick 0 ")

        page.get_by_test_id("tick").click()
        expect(clock).to_contain_text("Tick 1 ")
        page.get_by_test_id("variable-V.E.VALUE").fill("1")
        page.get_by_test_id("variable-V.E.VALUE").press("Enter")
        expect(page.get_by_text("V.E.VALUE = 1: ")).to_be_visible()
        page.get_by_test_id("reaction").click()
        expect(clock).to_contain_text("Tick 2 ")
        expect(count).to_have_value("1")
        expect(page.locator(".cm-line.nc-true")).to_have_count(1)
        expect(page.locator(".nc-inline")).to_contain_text("true · 1×")

        page.get_by_test_id("home").click()
        expect(clock).to_contain_text("Tick 0 ")
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
        expect(page.get_by_test_id("findings")).to_contain_text("20797")
        assert path.read_text("utf-8") == PROGRAM
        assert foreign == []
