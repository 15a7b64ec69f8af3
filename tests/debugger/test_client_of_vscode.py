# SPDX-License-Identifier: MIT
"""The client of VS Code drives the debugger: each kind of breakpoint, steps, time travel."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.slow

FOLDER = Path(__file__).parent

ADAPTER = """\
import sys
from nctakt.cli import main
sys.exit(main(["dap"]))
"""

PROGRAM = """\
#RT CYCLE [ID=1 SCOPE=PROG]
  V.E.VALUE = 1
  $IF V.RTA.ACS.ACT_POS.X > 5 && V.E.COUNT < 1
    V.E.COUNT = V.E.COUNT + 1
    V.E.TRIGGER = 1
  $ENDIF
#RT CYCLE END
; the path
G01 X10 F6000
G01 X20
#MSG ["there"]
G04 X0.01
M100
G04 X0.01
M30
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the client, as the registry has it."""
    if shutil.which("node") is None or shutil.which("npm") is None:
        pytest.skip("node and npm are not installed")
    path = tmp_path_factory.mktemp("node")
    shutil.copy(FOLDER / "package.json", path)
    shutil.copy(FOLDER / "drive.js", path)
    words = ["npm", "install", "--no-audit", "--no-fund", "--no-package-lock", "--ignore-scripts"]
    try:
        done = subprocess.run(words, cwd=path, capture_output=True, timeout=60, check=False)
    except subprocess.TimeoutExpired:
        pytest.skip("npm cannot install the client of VS Code here")
    if done.returncode:
        pytest.skip("npm cannot install the client of VS Code here")
    return path


@pytest.mark.nightly
def test_the_client_of_vscode_debugs_a_program(folder: Path) -> None:
    (folder / "adapter.py").write_text(ADAPTER, "utf-8")
    (folder / "part.nc").write_text(PROGRAM, "utf-8")
    words = ["node", "drive.js", sys.executable, "adapter.py", str(folder / "part.nc")]
    done = subprocess.run(
        words, cwd=folder, capture_output=True, text=True, timeout=120, check=False
    )
    assert done.returncode == 0, done.stdout + done.stderr
    assert len(done.stdout.splitlines()) == 4
