# SPDX-License-Identifier: MIT
"""``nctakt.check``: findings from Python, without a run."""

from __future__ import annotations

from pathlib import Path

from nctakt import Diagnostic, NcText, check


def test_a_text_is_checked() -> None:
    """An unknown word is an error at its place; a program in order has no finding."""
    (found,) = check(NcText("part.nc", "N10 G01 XX\nM30"))
    assert isinstance(found, Diagnostic)
    assert found.span is not None
    assert (found.span.file, found.span.line) == ("part.nc", 1)
    assert check(NcText("part.nc", "G01 X100 F6000\nM30")) == []


def test_a_file_that_is_missing_is_a_finding(tmp_path: Path) -> None:
    """900500, as on the command line."""
    assert [found.id for found in check(tmp_path / "none.nc")] == [900500]
