# SPDX-License-Identifier: MIT
"""Spindles that a program cannot turn."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

import nctakt
from nctakt.run.controller import Controller, NcText

DEMO = Path(nctakt.__file__).parent / "machines" / "demo"


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("S2[M3 REV=100]\nM30", 1),
        ("#RT CYCLE\nS2[M3 REV=100]\n#RT CYCLE END\nG04 X0.01\nM30", 2),
    ],
)
def test_a_spindle_without_an_axis_list_cannot_turn(text: str, line: int, tmp_path: Path) -> None:
    """50397 in the program and in a cycle, after 20312 of the channel list."""
    shutil.copytree(DEMO, tmp_path / "machine")
    file = tmp_path / "machine" / "sda_mds1.lis"
    lines = file.read_text("utf-8").splitlines()
    lines = [
        "spindel[1].log_achs_nr 77" if "[1].log_achs_nr" in one and "spindel" in one else one
        for one in lines
    ]
    file.write_text("\n".join([*lines, ""]), "utf-8")
    found = Controller(tmp_path / "machine").run(NcText("p.nc", text)).errors
    assert [error.id for error in found] == [20312, 50397]
    assert found[1].span is not None
    assert found[1].span.line == line
