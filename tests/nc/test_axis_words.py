# SPDX-License-Identifier: MIT
"""Words of single-axis brackets that are known and refused: page 5252363631026771979 lists them."""

from __future__ import annotations

import pytest
from support.decided import perform

from nctakt.cli import main
from nctakt.reference.topics import explain

WORDS = {
    "DIST_CTRL": "X[DIST_CTRL ON]",
    "LIFT": "X[LIFT DOWN=1]",
    "LIFT_START": "X[LIFT_START DOWN=1]",
    "LIFT_END": "X[LIFT_END]",
    "POLY": "X[POLY]",
    "COMP": "X[COMP OFF]",
    "DYNAMIC": "X[DYNAMIC ON]",
    "SYNC": "X[SYNC IN]",
    "CALLAX": "X[CALLAX]",
    "PUTAX": "X[PUTAX]",
    "M7": "X[M7]",
    "FEED_LINK": "S[FEED_LINK ON]",
    "SLOPE_TYPE": "X[INDP_SYN G90 POS=1 SLOPE_TYPE=STEP]",
    "ACC_WEIGHT": "X[INDP_SYN G90 POS=1 RAPID_ACC_WEIGHT=50]",
    "DRY_RUN": "X[INDP_SYN G90 POS=1 DRY_RUN]",
    "M": "X[INDP_SYN G90 POS=1 M7]",
    "G100": "X[INDP_SYN G90 G100 FEED=1 POS=1]",
}


@pytest.mark.parametrize("word", WORDS)
def test_each_is_refused_by_name_with_what_to_do_instead(word: str) -> None:
    """Not as an unknown command; the remedy is that of its row."""
    found = perform(f"{WORDS[word]}\nM30").diagnostics[0]
    assert found.id == 900200
    assert word in found.text()
    assert "Remove it" not in found.remedy()


@pytest.mark.parametrize("word", [*(word for word in WORDS if "INDP" not in WORDS[word]), "OSC"])
def test_explain_finds_each_as_it_is_written(word: str) -> None:
    """In any bracket, with what follows the word."""
    articles = explain(WORDS.get(word, f"X[{word} ON]"))
    assert any(f"[{word}" in article.name for article in articles), articles


@pytest.mark.parametrize(
    ("word", "form"),
    [
        ("INCL_OFFSETS", "X[INDP_SYN …]"),
        ("FEED_MAX_WEIGHT", "X[INDP_ASYN …]"),
        ("1ST_POS", "X[OSC …]"),
        ("NBR_OSC", "X[OSC …]"),
        ("RAPID_ACC_WEIGHT", "X[INDP_SYN ACC_WEIGHT]"),
    ],
)
def test_explain_finds_the_bracket_of_a_keyword(
    word: str, form: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["explain", word]) == 0
    assert form in capsys.readouterr().out


def test_what_follows_a_refused_word_of_a_spindle_belongs_to_it() -> None:
    """One error, not one more for ON."""
    found = perform("S[FEED_LINK ON]\nM30").diagnostics
    assert [one.id for one in found] == [900200]


def test_a_value_of_an_exchange_of_a_spindle_is_one_too_many() -> None:
    found = perform("S[PUTAX=1]\nM30").diagnostics
    assert [one.id for one in found] == [21035]
    assert "S[PUTAX]?" in found[0].remedy()


@pytest.mark.parametrize("second", ["X[INDP_SYN G90 POS=2]", "X[OSC OFF]"])
def test_a_block_commands_an_axis_beside_the_path_once(second: str) -> None:
    """As a word of an axis of the path; two axes are no mistake."""
    run = perform(f"X[INDP_ASYN G90 POS=1] {second}\nM30")
    assert [one.id for one in run.diagnostics] == [20203]
    assert perform("X[INDP_ASYN G90 POS=1] Y[INDP_SYN G90 POS=2]\nM30").diagnostics == ()
