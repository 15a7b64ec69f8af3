# SPDX-License-Identifier: MIT
"""What is shown of a word: the facts of the machine's lists, and what a cycle sees forever."""

from __future__ import annotations

import pytest

pytest.importorskip("pygls", reason="the language server needs pygls (extra editor)")

from lsprotocol.types import MarkupContent, Position

from nctakt.editor.display.hints import inlay_hints
from nctakt.editor.display.hover import hover
from nctakt.editor.document import Document
from nctakt.editor.workspace import Workspace

PROGRAM = """\
%MAIN
#VAR
V.P.SIZE = 10
#ENDVAR
#RT CYCLE [ID=7 SCOPE=PROG]
  $IF EDGE V.RTA.ACS.ACT_POS.X > V.P.SIZE
    M100
  $ENDIF
#RT CYCLE END
G01 X30 A10 F1000 S2000 M3 M10
M30
"""
WORK = Workspace()


def shown(line: int, word: str) -> str:
    lines = PROGRAM.split("\n")
    document = Document("untitled:1", None, "1", "nctakt", 0, lines)
    machine = WORK.machine_of(document).machine
    place = Position(line, lines[line].index(word))
    found = hover(document, place, machine, (), "en")
    assert found is not None
    assert isinstance(found.contents, MarkupContent)
    return found.contents.value


@pytest.mark.parametrize(
    ("line", "word", "expected"),
    [
        (9, "X30", ("linear axis", "Software limits: -10000 … 10000 mm", "30000 mm/min")),
        (9, "A10", ("rotary axis", "Modulo range: 0 … 360 °", "Logical number: 4")),
        (9, "F1000", ("F1 means: 1 mm/min with G94", "At program start: 1000 mm/min")),
        (9, "S2000", ("spindle", "Highest speed: 6000 1/min")),
        (9, "M3", ("spindle clockwise", "Synchronisation: MOS")),
        (9, "M10", ("Synchronisation: MVS_SVS: output and waiting", "Process time: none")),
        (6, "M100", ("Synchronisation: MOS: output without waiting",)),
        (0, "%MAIN", ("name of a program",)),
    ],
)
def test_words_show_what_the_lists_say(line: int, word: str, expected: tuple[str, ...]) -> None:
    """Axes (P-AXIS-00018, 00177, 00178), feed (P-CHAN-00108), synchronisation (P-CHAN-00041)."""
    for part in expected:
        assert part in shown(line, word)


@pytest.mark.parametrize(
    ("text", "index", "first", "area"),
    [
        ("G01 X10 F1000", 5, "**X**", (4, 7)),
        ("G01 X10 F1000", 6, "**X**", (4, 7)),
        ("G01 X10 F1000", 7, "**X**", (4, 7)),
        ("G01 X10 F1000", 10, "**F**", (8, 13)),
        ("G01 X-2.5 Y3", 5, "**X**", (4, 9)),
        ("G01 X-2.5 Y3", 7, "**X**", (4, 9)),
        ("G01 X10 T12", 10, "**T**", (8, 11)),
    ],
)
def test_the_value_of_a_word_shows_the_word(
    text: str, index: int, first: str, area: tuple[int, int]
) -> None:
    """The pointer is on the digits more often than on the letter."""
    document = Document("untitled:1", None, "1", "nctakt", 0, [text, "M30", ""])
    machine = WORK.machine_of(document).machine
    found = hover(document, Position(0, index), machine, (), "en")
    assert found is not None
    assert isinstance(found.contents, MarkupContent)
    assert found.contents.value.startswith(first)
    assert found.range is not None
    assert (found.range.start.character, found.range.end.character) == area


@pytest.mark.parametrize(
    ("text", "index"), [("P1 = 10", 6), ("$IF 10 > P1", 5), ("G01 X[3+10]", 9)]
)
def test_other_numbers_show_nothing(text: str, index: int) -> None:
    """A number in an expression is not the value of a word."""
    document = Document("untitled:1", None, "1", "nctakt", 0, [text, "M30", ""])
    machine = WORK.machine_of(document).machine
    assert hover(document, Position(0, index), machine, (), "en") is None


def test_frozen_variables_of_the_program_show_their_value() -> None:
    """A cycle sees a V.P variable as it is when the cycle is defined (RC-302)."""
    document = Document("untitled:1", None, "1", "nctakt", 0, PROGRAM.split("\n"))
    machine = WORK.machine_of(document).machine
    hints = inlay_hints(document, WORK.check(document), machine.names, range(12), "en")
    assert (5, " = 10") in [(hint.position.line, hint.label) for hint in hints]
