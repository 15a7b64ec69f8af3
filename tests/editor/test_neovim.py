# SPDX-License-Identifier: MIT
"""The language server in Neovim: findings, a remedy, format."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from support.editor_client import ENVIRONMENT

pytestmark = pytest.mark.slow

NEOVIM = shutil.which("nvim")


@pytest.mark.skipif(NEOVIM is None, reason="Neovim is not installed")
def test_neovim_shows_findings_applies_a_remedy_and_formats(tmp_path: Path) -> None:
    """A program with a decimal comma is corrected and formatted by the editor alone."""
    program = tmp_path / "part.nc"
    program.write_text("g01 x1,5 f1000 ; go\nm30\n")
    script = Path(__file__).with_name("neovim.lua")
    command = f"{sys.executable} -m nctakt lsp"
    done = subprocess.run(
        [str(NEOVIM), "--clean", "--headless", "-n", str(program), "-c", f"luafile {script}"],
        cwd=tmp_path,
        env={**ENVIRONMENT, "NCTAKT_LSP": command, "XDG_STATE_HOME": str(tmp_path)},
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
        stdin=subprocess.DEVNULL,
    )
    assert "finding 0 5 1,5 is not a number" in done.stdout, done.stderr
    assert "action Write 1.5" in done.stdout, done.stderr
    assert program.read_text() == "G01 X1.5 F1000 ; go\nM30\n", done.stderr
