# SPDX-License-Identifier: MIT
"""docs/checking.md, findings.md and ci.md: what they show is what the command does."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from nctakt.base.diagnostics import Message
from nctakt.checking.inputs import PROGRAM_SUFFIXES
from nctakt.cli import main
from nctakt.messages.catalogue import messages_of
from nctakt.messages.programs import lints

DOCUMENTS = Path(__file__).parents[2] / "docs"
TEXT = "".join(
    (DOCUMENTS / name).read_text("utf-8") for name in ("checking.md", "findings.md", "ci.md")
)
_FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def blocks(language: str, text: str = TEXT) -> list[str]:
    """The fenced blocks of a language, ``""``: of none."""
    return [body for found, body in _FENCE.findall(text) if found == language]


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The command runs in its own folder."""
    monkeypatch.chdir(tmp_path)


def test_the_output_is_that_of_the_command(capsys: pytest.CaptureFixture[str]) -> None:
    """The program at the top has the findings below it, letter by letter."""
    program, output = blocks("")
    Path("watch.nc").write_text(program, encoding="utf-8")
    assert main(["check", "watch.nc"]) == 1
    assert capsys.readouterr().out == output


def test_the_german_output_is_that_of_the_command(capsys: pytest.CaptureFixture[str]) -> None:
    """The same program, with the findings in German."""
    program, output = blocks("", (DOCUMENTS / "checking.de.md").read_text("utf-8"))
    Path("watch.nc").write_text(program, encoding="utf-8")
    assert main(["check", "watch.nc", "--lang", "de"]) == 1
    assert capsys.readouterr().out == output


def test_each_finding_beyond_errors_has_its_row() -> None:
    """All of them, with their severity; and errors of a run that a check can foresee."""
    declared = {one.id: one for one in vars(lints).values() if isinstance(one, Message)}
    rows = re.findall(r"^\| (\d+) \| (\w+) \|", TEXT, re.MULTILINE)
    numbers = [int(number) for number, _ in rows]
    assert sorted(set(numbers)) == sorted(numbers)
    assert declared.keys() <= set(numbers)
    for number, severity in rows:
        messages = [declared[int(number)]] if int(number) in declared else messages_of(int(number))
        assert severity in [one.severity.label("en") for one in messages]


def test_the_suffixes_of_programs_are_named() -> None:
    """All that folders are searched for."""
    assert [suffix for suffix in PROGRAM_SUFFIXES if f"`{suffix}`" not in TEXT] == []


def test_the_python_runs(capsys: pytest.CaptureFixture[str]) -> None:
    """As it is, on a folder with a program."""
    Path("programs").mkdir()
    Path("programs/bad.nc").write_text("Q1\n", encoding="utf-8")
    (code,) = blocks("python")
    exec(compile(code, "checking.md", "exec"), {})
    assert "programs/bad.nc:1:1: error 20797" in capsys.readouterr().out
