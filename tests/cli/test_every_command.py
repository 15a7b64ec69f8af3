# SPDX-License-Identifier: MIT
"""What all subcommands have in common: help, exit codes, times, JSON, quiet runs, limits."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import click
import pytest
from support.command_table import command_of, commands

from nctakt.cli import group, main

pytestmark = pytest.mark.slow

Captured = pytest.CaptureFixture[str]


PART = """\
#RT CYCLE [ID = 1 SCOPE = PROG]
$IF EDGE V.E.TRIGGER == 1
M100
$ENDIF
#RT CYCLE END
#MSG ["hello"]
G04 0.01
M30
"""


@pytest.fixture
def part(tmp_path: Path) -> str:
    """A program of some ticks."""
    path = tmp_path / "part.nc"
    path.write_text(PART, "utf-8")
    return str(path)


@pytest.mark.parametrize("words", list(commands(group)), ids=" ".join)
def test_each_command_has_a_short_help_option_and_tells_its_exit_codes(
    words: list[str], capsys: Captured
) -> None:
    """``-h`` is ``--help``; each help says what the exit codes mean."""
    assert main([*words, "--help"]) == 0
    text = capsys.readouterr().out
    assert main([*words, "-h"]) == 0
    assert capsys.readouterr().out == text
    assert "-h, --help" in text
    assert "Exit codes: 0 " in text
    assert " 2 wrong usage" in " ".join(text.split("Exit codes:")[1].split())


@pytest.mark.parametrize(
    "words",
    ["--lang de --help", "schedule --help --lang de", "--lang de run --help"],
)
def test_help_is_german_wherever_the_language_is_given(words: str, capsys: Captured) -> None:
    """``--lang`` before a subcommand counts for the subcommand; values have German names."""
    assert main(words.split()) == 0
    text = capsys.readouterr().out
    assert text.startswith("Aufruf: nctakt ")
    assert "FILE" not in text
    assert "FOLDER" not in text


def test_a_language_before_the_subcommand_is_that_of_its_messages(
    monkeypatch: pytest.MonkeyPatch, capsys: Captured
) -> None:
    """It wins over the environment; the subcommand's own wins over it."""
    monkeypatch.setenv("NCTAKT_LANGUAGE", "en")
    assert main(["--lang", "de", "run", "nowhere.nc"]) == 2
    assert "Fehler 900500" in capsys.readouterr().err
    assert main(["--lang", "de", "run", "nowhere.nc", "--lang", "en"]) == 2
    assert "error 900500" in capsys.readouterr().err


def test_an_option_has_the_same_words_everywhere() -> None:
    """Values of the same kind have the same name, and no option shows click's own."""
    shown = {
        parameter.make_metavar(click.Context(group))
        for words in commands(group)
        for parameter in command_of(words).params
        if isinstance(parameter, click.Option) and not parameter.is_flag
    }
    assert shown.isdisjoint({"INTEGER RANGE", "FLOAT RANGE", "INTEGER", "DIR", "PATH", "COUNT"})


@pytest.mark.parametrize("command", ["run", "disassemble", "why"])
def test_results_as_one_object(command: str, part: str, capsys: Captured) -> None:
    """The same keys in every language; nothing else on either stream."""
    assert main([command, part, "--format", "json", "--at", "2h", "V.E.TRIGGER=1"]) == 0
    captured = capsys.readouterr()
    document = json.loads(captured.out)
    assert captured.err == ""
    assert (document["state"], document["ticks"]) == ("ended", 11)
    assert document["messages"][0]["text"] == "hello"
    assert [one["id"] for one in document["diagnostics"]] == [901007]
    assert main([command, part, "--format", "json", "--lang", "de"]) == 0
    german = json.loads(capsys.readouterr().out)
    assert german.keys() == document.keys()
    if command == "why":
        assert document["why"]["cycles"][0]["name"] == "1"
        assert main([command, part, "--format", "json", "--state", "5ms"]) == 0
        assert json.loads(capsys.readouterr().out)["state_at_tick"][0].startswith("tick 5")
    if command == "disassemble":
        assert document["listing"][0]["lines"][0].startswith("Realtime cycle 1")


def test_explanations_as_one_object(capsys: Captured) -> None:
    """Articles by word; what is unknown is a diagnostic."""
    assert main(["explain", "RC-105", "@@@", "--format", "json"]) == 2
    document = json.loads(capsys.readouterr().out)
    assert [one["word"] for one in document["words"]] == ["RC-105", "@@@"]
    assert document["words"][0]["articles"][0]["name"] == "RC-105"
    assert [one["id"] for one in document["diagnostics"]] == [900570]


@pytest.mark.parametrize("command", ["run", "disassemble", "why", "coverage"])
def test_a_limit_fails_where_that_is_asked_for(command: str, part: str, capsys: Captured) -> None:
    """Exit code 0 at a limit, 1 with ``--limit-fails`` and 901016."""
    assert main([command, part, "--ticks", "5"]) == 0
    assert "901016" not in capsys.readouterr().err
    assert main([command, part, "--ticks", "5", "--limit-fails"]) == 1
    assert "901016" in capsys.readouterr().err
    assert main([command, part, "--ticks", "50", "--limit-fails"]) == 0


def test_a_question_about_a_time_is_no_limit(part: str, capsys: Captured) -> None:
    """``why --state`` ends the run itself."""
    assert main(["why", part, "--state", "5ms", "--limit-fails"]) == 0
    assert capsys.readouterr().err == ""


@pytest.mark.parametrize("command", ["run", "disassemble", "why", "coverage"])
def test_quiet_leaves_notes_out(command: str, part: str, capsys: Captured) -> None:
    """No warning of a value that came too late, except for ``run``, which keeps warnings."""
    assert main([command, part, "--at", "2h", "V.E.TRIGGER=1", "--quiet"]) == 0
    reported = capsys.readouterr().err
    assert ("901007" in reported) == (command == "run")


def test_a_new_machine_is_written_quietly(tmp_path: Path, capsys: Captured) -> None:
    """``new --quiet`` says nothing."""
    assert main(["new", str(tmp_path / "machine"), "--quiet"]) == 0
    assert capsys.readouterr() == ("", "")


def test_a_folder_instead_of_a_program_says_what_it_is_for(
    tmp_path: Path, capsys: Captured
) -> None:
    """901015 with ``--machine`` and the folder."""
    assert main(["run", str(tmp_path)]) == 2
    assert f"nctakt run part.nc --machine {tmp_path}" in capsys.readouterr().err


@pytest.mark.parametrize(
    "words",
    [
        ("run", "PART", "--until", "1h", "--after", "0h", "--at", "0.0000001h", "V.E.TRIGGER=1"),
        ("why", "PART", "--state", "0h"),
        ("schedule", "simulate", "RTCONF", "--duration", "0.0001h"),
        ("schedule", "show", "RTCONF", "--hal-timer", "0.5ms"),
        ("schedule", "show", "RTCONF", "--hal-timer", "500"),
    ],
    ids=" ".join,
)
def test_each_time_takes_the_same_units(words: tuple[str, ...], part: str) -> None:
    """From µs to hours."""
    rtconf = Path(__file__).parents[2] / "examples" / "schedule" / "rtconf.lis"
    given = [{"PART": part, "RTCONF": str(rtconf)}.get(word, word) for word in words]
    assert main(given) == 0


@pytest.mark.parametrize("time", ["5 ticks", "fast", "-1ms"])
def test_a_timer_period_that_is_no_time_is_reported(time: str, capsys: Captured) -> None:
    """900510; a number of ticks, whose length the period decides, as well."""
    rtconf = Path(__file__).parents[2] / "examples" / "schedule" / "rtconf.lis"
    assert main(["schedule", "show", str(rtconf), "--hal-timer", time]) == 2
    assert "error 900510" in capsys.readouterr().err


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_completion_is_there_for_shells(shell: str) -> None:
    """As docs/running.md says; subcommands and options are completed."""
    environment = {**os.environ, "_NCTAKT_COMPLETE": f"{shell}_source"}
    command = [sys.executable, "-m", "nctakt"]
    shown = subprocess.run(
        command, env=environment, capture_output=True, text=True, check=False, timeout=60
    )
    assert "_NCTAKT_COMPLETE" in shown.stdout
    environment |= {
        "_NCTAKT_COMPLETE": "bash_complete",
        "COMP_WORDS": "nctakt run --limit",
        "COMP_CWORD": "2",
    }
    shown = subprocess.run(
        command, env=environment, capture_output=True, text=True, check=False, timeout=60
    )
    assert "--limit-fails" in shown.stdout
