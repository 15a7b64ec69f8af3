# SPDX-License-Identifier: MIT
"""The pictures in the documents are those that the commands below them draw."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest

from nctakt.cli import main

ROOT = Path(__file__).parent.parent.parent
COMMANDS = re.findall(
    r"^`nctakt (schedule simulate .+ --plot docs/pictures/.+\.svg)`$",
    (ROOT / "docs" / "schedule.md").read_text("utf-8"),
    re.M,
)


@pytest.mark.parametrize("command", COMMANDS)
def test_picture_is_current(command: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The command draws the picture that is in the document."""
    monkeypatch.chdir(ROOT)
    *words, picture = shlex.split(command)
    assert main([*words, str(tmp_path / "a.svg")]) == 0
    assert (tmp_path / "a.svg").read_text("utf-8") == (ROOT / picture).read_text("utf-8")


def test_document_has_pictures() -> None:
    """Both pictures have their command."""
    assert len(COMMANDS) == 2
