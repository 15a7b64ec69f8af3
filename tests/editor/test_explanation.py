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


def test_frozen_variables_of_the_program_show_their_value() -> None:
    """A cycle sees a V.P variable as it is when the cycle is defined (RC-302)."""
    document = Document("untitled:1", None, "1", "nctakt", 0, PROGRAM.split("\n"))
    machine = WORK.machine_of(document).machine
    hints = inlay_hints(document, WORK.check(document), machine.names, range(12), "en")
    assert (5, " = 10") in [(hint.position.line, hint.label) for hint in hints]
