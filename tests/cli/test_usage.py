# SPDX-License-Identifier: MIT
"""Words that the command line does not know: number and remedy, in both languages."""

from __future__ import annotations

from pathlib import Path

import pytest

from nctakt.base.version import __version__
from nctakt.cli import main


@pytest.mark.parametrize(
    ("words", "headline", "remedy"),
    [
        (
            "run --ticks abc",
            "error 900908: abc is not a valid value for --ticks",
            "a whole number from 1 on",
        ),
        ("run --ticks 0", "error 900908: 0 is not a valid value for --ticks", "nctakt run --help"),
        ("run p.nc --tickz 3", "error 900907: unknown option --tickz", "Did you mean --ticks?"),
        ("run p.nc --qqqq", "error 900907: unknown option --qqqq", "nctakt run --help"),
        ("run p.nc --ticks", "error 900911: the value after --ticks is missing", "--help"),
        ("rum p.nc", "error 900912: unknown command rum", "Did you mean run?"),
        ("ru p.nc", "error 900912: unknown command ru", "Did you mean run?"),
        ("run p.nc --helpp", "error 900907: unknown option --helpp", "Did you mean --help?"),
        (
            "check a --format xml",
            "error 900908: xml is not a valid value for --format",
            "json, github",
        ),
        ("coverage x --fail-under 101", "900908: 101", "a number from 0 to 100"),
        ("new", "error 900910: FOLDER is missing", "nctakt new --help"),
        ("new a b", "error 900909:", "nctakt new --help"),
        ("schedule shw", "error 900912: unknown command shw", "Did you mean show?"),
        ("explain --lang fr", "error 900908: fr is not a valid value for --lang", "one of en, de"),
        (
            "run --ticks abc --lang de",
            "Fehler 900908: abc ist kein gültiger Wert",
            "eine ganze Zahl ab 1",
        ),
        (
            "why --lang=de --lime 3",
            "Fehler 900907: unbekannte Option --lime",
            "War --line gemeint?",
        ),
    ],
)
def test_words_that_cannot_be_used(
    words: str, headline: str, remedy: str, capsys: pytest.CaptureFixture[str]
) -> None:
    """Exit code 2, nothing on standard output, one mistake."""
    assert main(words.split()) == 2
    shown = capsys.readouterr()
    first, second = shown.err.splitlines()
    assert headline in first
    assert remedy in second
    assert "–" not in shown.err
    assert shown.out == ""


@pytest.mark.parametrize(
    ("words", "option"),
    [
        ("run p.nc --trace a.csv --trace b.mf4", "--trace"),
        ("run p.nc --ticks 5 --quiet --ticks=5", "--ticks"),
        ("run p.nc --compiled --plain", "--compiled/--plain"),
        ("run p.nc --root a --root b", "--root"),
        ("compare log.csv p.nc --offset 1s --offset 2s", "--offset"),
        ("serve p.nc --live --live 127.0.0.1:1", "--live"),
        ("schedule show --format json a --format text", "--format"),
        ("--lang en --lang de check p.nc", "--lang"),
        ("run examples/crossing.nc --set V.E.COUNT=1 --set V.E.COUNT=2", "--set V.E.COUNT"),
        ("compare log.csv p.nc --tolerance 1 --tolerance 2%", "--tolerance"),
        ("compare log.csv p.nc --tolerance X=1 --tolerance X=2", "--tolerance X"),
    ],
)
def test_no_word_replaces_another_one_in_silence(
    words: str, option: str, capsys: pytest.CaptureFixture[str]
) -> None:
    """902953 for each option that says a single thing; exit code 2, before anything is done."""
    assert main(words.split()) == 2
    first = capsys.readouterr().err.splitlines()[0]
    assert first.endswith(
        f"902953: {option} is given more than once; only the last value would count"
    )


def test_words_that_may_come_again(capsys: pytest.CaptureFixture[str]) -> None:
    """Switches say the same again, --lang of a group is that of its commands, help comes first."""
    program = "examples/crossing.nc"
    values = ["--set", "V.E.COUNT=1", "--at", "1ms", "V.E.COUNT=1", "--at", "1ms", "V.E.COUNT=2"]
    assert (
        main(["--lang", "de", "run", program, "--quiet", "--quiet", *values, "--lang", "en"]) == 0
    )
    assert main(["run", "--help", "--trace", "a", "--trace", "b"]) == 0
    assert "902953" not in capsys.readouterr().err


def test_without_words_the_help_is_shown(capsys: pytest.CaptureFixture[str]) -> None:
    """It is no mistake that has a remedy."""
    assert main([]) == 2
    assert "Usage" in capsys.readouterr().err


def test_without_a_subcommand_the_path_names_the_files_of_the_folder(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Five commands with a program and the lists that lie there; exit code 2."""
    (tmp_path / "lists").mkdir()
    (tmp_path / "lists" / "hochlauf.lis").write_text("", "utf-8")
    (tmp_path / "saw.nc").write_text("M30\n", "utf-8")
    monkeypatch.chdir(tmp_path)
    assert main([]) == 2
    shown = capsys.readouterr().err
    machine = "saw.nc --machine lists"
    for command in ("check lists", f"run {machine}", f"live {machine} --open", "init --ci"):
        assert f"  nctakt {command}" in shown
    assert f"  nctakt why {machine}" in shown


def test_help_is_in_german(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """By ``--lang de``, before or after ``--help``, and by a German locale."""
    assert main(["check", "--help", "--lang", "de"]) == 0
    german = capsys.readouterr().out
    assert "Rückgabewerte: 0 kein Fehler" in german
    assert "Sprache der Texte" in german
    monkeypatch.setenv("LANG", "de_DE.UTF-8")
    monkeypatch.delenv("LC_ALL", raising=False)
    monkeypatch.delenv("LC_MESSAGES", raising=False)
    assert main(["check", "--help"]) == 0
    assert capsys.readouterr().out == german


def test_the_version_with_what_a_report_needs(capsys: pytest.CaptureFixture[str]) -> None:
    """Version, Python, platform, what is compiled, libraries and extras."""
    assert main(["--version", "--verbose"]) == 0
    shown = capsys.readouterr().out
    for part in (f"nctakt {__version__}", "Python 3.", "realtime part: ", "click ", "extra live: "):
        assert part in shown


@pytest.mark.parametrize("words", ["run part.nc --plot", "schedule simulate --load"])
def test_a_missing_value_names_the_help_of_its_command(
    words: str, capsys: pytest.CaptureFixture[str]
) -> None:
    """900911 points to the help of the subcommand, not to that of nctakt."""
    assert main(words.split()) == 2
    command = words.partition(" -")[0].removesuffix(" part.nc")
    assert f"More: nctakt {command} --help" in capsys.readouterr().err


@pytest.mark.parametrize(
    "words",
    [
        "run nowhere.nc",
        "check nowhere.nc",
        "replay nowhere.tape",
        "schedule show nowhere.lis",
        "run --nothing",
    ],
)
def test_messages_have_the_language_of_the_locale(
    words: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """As help has; NCTAKT_LANGUAGE and --lang say otherwise."""
    monkeypatch.setenv("LC_ALL", "de_DE.UTF-8")
    main(words.split())
    assert "Fehler" in "".join(capsys.readouterr())
    main([*words.split(), "--lang", "en"])
    assert "error" in "".join(capsys.readouterr())
    monkeypatch.setenv("NCTAKT_LANGUAGE", "en")
    main(words.split())
    assert "error" in "".join(capsys.readouterr())


def test_a_project_names_another_language_than_the_locale(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Its file is nearer than the locale."""
    (tmp_path / "nctakt.toml").write_text('language = "en"\n', "utf-8")
    (tmp_path / "part.nc").write_text("G01 X1 F0\nM30\n", "utf-8")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("LC_ALL", "de_DE.UTF-8")
    assert main(["run", "part.nc"]) == 1
    assert "error 20176" in capsys.readouterr().err
