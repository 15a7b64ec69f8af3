# SPDX-License-Identifier: MIT
"""``nctakt serve --ads`` in its own process, for tests with the clients of others."""

from __future__ import annotations

import json
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

LIMIT_S = 60.0

PROGRAM = """\
#RT CYCLE [ID=1 SCOPE=GLOBAL]
  $IF EDGE V.E.TRIGGER > 0
    V.E.COUNT_POS = V.E.COUNT_POS + 1
  $ENDIF
#RT CYCLE END
G01 X10 F600
M30
"""


def until(holds: Callable[[], bool]) -> None:
    """Wait until something holds."""
    end = time.monotonic() + LIMIT_S
    while not holds():
        assert time.monotonic() < end
        time.sleep(0.005)


class Server:
    """``nctakt serve`` in its own process."""

    def __init__(self, folder: Path, *words: str, text: str = PROGRAM) -> None:
        self.folder = folder
        self.program = folder / "part.nc"
        self.program.write_text(text, "utf-8")
        ready = folder / "ready.json"
        command = [sys.executable, "-m", "nctakt", "serve", str(self.program)]
        self.process = subprocess.Popen(
            [*command, "--ads=127.0.0.1:0", f"--ready-file={ready}", "--quiet", *words],
            cwd=folder,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        until(lambda: ready.exists() or self.process.poll() is not None)
        assert ready.exists(), self.process.communicate()
        address = json.loads(ready.read_text("utf-8"))["addresses"]["ads"]
        self.address, self.net_id = address.split("/")

    def end(self) -> tuple[int, str, str]:
        """End it as a service manager does; exit code and what it has printed."""
        self.process.send_signal(signal.SIGTERM)
        out, error = self.process.communicate(timeout=LIMIT_S)
        return self.process.returncode, out, error


def drive_with_npm(server: Server, script: str, folder: Path) -> None:
    """Let ads-client of npm, installed in a folder, drive a server by a script of the tests."""
    if shutil.which("node") is None or shutil.which("npm") is None:
        pytest.skip("node and npm are not installed")
    for name in ("package.json", script):
        shutil.copy(Path(__file__).parents[1] / "servers" / name, folder)
    words = ["npm", "install", "--no-audit", "--no-fund", "--no-package-lock", "--ignore-scripts"]
    try:
        installed = subprocess.run(words, cwd=folder, capture_output=True, timeout=60, check=False)
    except subprocess.TimeoutExpired:
        pytest.skip("npm cannot install ads-client here")
    if installed.returncode:
        pytest.skip("npm cannot install ads-client here")
    host, port = server.address.split(":")
    driven = ["node", script, host, port, server.net_id]
    done = subprocess.run(
        driven, cwd=folder, capture_output=True, text=True, timeout=120, check=False
    )
    assert done.returncode == 0, done.stdout + done.stderr
