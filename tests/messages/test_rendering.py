# SPDX-License-Identifier: MIT
"""How the values of a message are shown: numbers, texts in two languages, what there is not."""

from __future__ import annotations

import pytest

from nctakt.base.diagnostics import NOTHING, Span, number_text
from nctakt.base.source_ids import statement_span
from nctakt.messages import diagnostic
from nctakt.messages.path.motion import INVALID_CONTOUR_DEVIATION
from nctakt.messages.programs.checked_blocks import UNKNOWN_COMMAND, UNKNOWN_WORD
from nctakt.messages.programs.checked_values import UNKNOWN_VARIABLE
from nctakt.messages.programs.nc_text import VALUE_EXPECTED
from nctakt.nc.parse.expressions import END_OF_BLOCK


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (2.0, "2"),
        (-0.0, "0"),
        (0.1 + 0.2, "0.3"),
        (99.5, "99.5"),
        (1 / 3, "0.333333333333"),
        (4294967295.0, "4294967295"),
    ],
)
def test_numbers_are_written_as_a_reader_writes_them(value: float, text: str) -> None:
    """No ``.0``, no digits that only rounding has made."""
    assert number_text(value) == text
    assert (
        diagnostic(INVALID_CONTOUR_DEVIATION, value=value).text()
        == f"the deviation {text} for contouring must be above 0"
    )


def test_the_end_of_a_block_has_its_words_in_both_languages() -> None:
    """No token of the parser."""
    found = diagnostic(VALUE_EXPECTED, found=END_OF_BLOCK)
    assert found.text("en") == "a value is missing before the end of the block"
    assert found.text("de") == "vor dem Satzende fehlt ein Wert"


def test_a_remedy_does_not_ask_for_nothing() -> None:
    """Where no name is similar, or a list is empty, the sentence about it is left out."""
    found = diagnostic(UNKNOWN_WORD, word="Q", axes="X, Y", nearest=NOTHING)
    assert found.remedy("en") == "Axes of the channel: X, Y"
    found = diagnostic(UNKNOWN_VARIABLE, name="V.G.Q", nearest=NOTHING, declared=NOTHING)
    assert found.remedy("de") == "Groß- und Kleinschreibung zählt."
    found = diagnostic(UNKNOWN_COMMAND, word="#Q", nearest=NOTHING)
    assert found.remedy("en") == "Check the spelling; no known name is clearly meant."
    assert diagnostic(UNKNOWN_COMMAND, word="#Q", nearest="#P").remedy("en") == "Did you mean #P?"


@pytest.mark.parametrize(
    ("line", "column", "covered"),
    [
        ("  #ERROR [ID=1 PV1=P1] ; told", 3, "#ERROR [ID=1 PV1=P1]"),
        ('#ERROR [ID=1 PM1="a;(b"] (told)', 1, '#ERROR [ID=1 PM1="a;(b"]'),
        ("V.E.COUNT = 1 / P1 ; told", 1, "V.E.COUNT = 1 / P1"),
        ("V.E.LIST[V.E.COUNT] = 2", 10, "V.E.COUNT"),
        ("$IF V.E.LIST[P[2]] > 3", 1, "$IF V.E.LIST[P[2]] > 3"),
        ("  M100 H7", 3, "M100"),
        ("  M100 H7", 8, "H7"),
        ("X10", 4, ""),
    ],
)
def test_a_place_of_the_realtime_part_covers_its_statement(
    line: str, column: int, covered: str
) -> None:
    """Events know where something begins; the caret shows all of it."""
    span = Span("p.nc", 1, column, column + 1)
    found = statement_span(span, line)
    assert found is not None
    assert line[found.column - 1 : found.end_column - 1] == covered
    assert found.column == column
