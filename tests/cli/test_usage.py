# SPDX-License-Identifier: MIT
"""Words that the command line does not know: told by number, with a remedy, in both languages."""

from __future__ import annotations

import pytest

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


def test_without_words_the_help_is_shown(capsys: pytest.CaptureFixture[str]) -> None:
    """It is no mistake that has a remedy."""
    assert main([]) == 2
    assert "Usage" in capsys.readouterr().err
