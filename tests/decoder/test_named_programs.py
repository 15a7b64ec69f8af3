# SPDX-License-Identifier: MIT
"""#FILE NAME names the programs of M6, G80 … G89 and G800 … G839 until the end of the program."""

from __future__ import annotations

from pathlib import Path

import pytest

from nctakt.results.run import ProgramMessage, Run
from nctakt.run.controller import Controller


def run(folder: Path, text: str, said: list[str]) -> Run:
    """A program beside ``drill.nc``, ``change.nc`` and ``inner.nc``; what it says."""
    (folder / "drill.nc").write_text('#MSG ["drill %d", @P1]\nM17\n')
    (folder / "change.nc").write_text('#MSG ["change"]\nM17\n')
    (folder / "inner.nc").write_text("G80 [3]\nM17\n")
    (folder / "main.nc").write_text(text + "M30\n")

    def listen(message: ProgramMessage) -> None:
        said.append(message.text)

    return Controller().run(folder / "main.nc", on_message=listen)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ('#FILE NAME [G80="drill.nc"]\nG80 [1]\nG80 [2]\n', ["drill 1", "drill 2"]),
        ('#FILENAME[ G80 "drill.nc" G815="change.nc" ]\nG815\nG80 [1]\n', ["change", "drill 1"]),
        ('#FILE NAME [M6="change.nc"]\nT1 M6\n', ["change"]),
        ('#FILE NAME [G80="drill.nc"]\nL inner.nc\n', ["drill 3"]),
        ('#FILE NAME [G80="drill.nc"]\n#FILE NAME [G80="change.nc"]\nG80\n', ["change"]),
        ('#FILE NAME [G81="change.nc"]\nP1=81\nG[P1]\n', ["change"]),
        ('#FILE NAME [G81="change.nc"]\n"HOLE" = "G81"\n"HOLE"\n', ["change"]),
    ],
)
def test_a_named_program_runs_at_its_word(tmp_path: Path, text: str, expected: list[str]) -> None:
    """Also in called programs, by a computed number and by a macro; the last name counts."""
    said: list[str] = []
    result = run(tmp_path, text, said)
    assert result.errors == ()
    assert said == expected


@pytest.mark.parametrize(
    ("text", "number", "line"),
    [
        ("G80\n", 20131, 1),
        ('G80\n#FILE NAME [G80="drill.nc"]\n', 20131, 1),
        ('$IF V.A.ABS.X > 5\n#FILE NAME [G80="drill.nc"]\n$ENDIF\nG80 [1]\n', 20131, 4),
        ('#FILE NAME [G80="lost.nc"]\nG80\n', 20369, 2),
        ('#FILE NAME [G01="drill.nc"]\n', 21220, 1),
        ("#FILE NAME [G80]\n", 21220, 1),
        ("#FILE NAME [G80=5]\n", 21460, 1),
    ],
)
def test_what_names_no_program_is_refused(
    tmp_path: Path, text: str, number: int, line: int
) -> None:
    """A word without a program; a missing file; a word that calls none; no text."""
    errors = run(tmp_path, text, []).errors
    assert [(error.id, error.span.line) for error in errors if error.span] == [(number, line)]


def test_the_names_end_with_the_program(tmp_path: Path) -> None:
    """The next program has those of the channel list again."""
    controller = Controller()
    (tmp_path / "drill.nc").write_text("M17\n")
    first, second = tmp_path / "first.nc", tmp_path / "second.nc"
    first.write_text('#FILE NAME [G80="drill.nc"]\nG80\nM30\n')
    second.write_text("G80\nM30\n")
    assert controller.run(first).errors == ()
    assert [error.id for error in controller.run(second).errors] == [20131]
