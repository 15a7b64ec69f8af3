# SPDX-License-Identifier: MIT
"""A structure that is not closed, or badly begun, hides no other finding of the program."""

from __future__ import annotations

import pytest

from nctakt.checking.check import check_files
from nctakt.lists.machine.files import DEMO_FOLDER
from nctakt.lists.machine.machine import load_machine
from nctakt.run.program_loader import NcText
from nctakt.run.realtime.assembly import AssembledMachine

#: Each line but those of M30 and the structures has a finding.
REST = """\
P2 = V.E.NIX
G01 X1 F1000
G999
$IF V.E.NIX > 3
  V.E.NIX = 1
$ENDIF
#RT CYCLE [ID=2 SCOPE=GLOBAL]
  $IF V.RTA.ACS.ACT_POS.X == 3
    M100
  $ENDIF
#RT CYCLE END
$GOTO N77
LL NIX
"""


@pytest.fixture(scope="module")
def machine() -> AssembledMachine:
    return AssembledMachine(load_machine(DEMO_FOLDER))


def findings(text: str, machine: AssembledMachine) -> list[str]:
    found = check_files([NcText("part.nc", f"%MAIN\n{text}M30\n")], machine).findings
    return [item.diagnostic.text() for item in found]


@pytest.mark.parametrize(
    ("opening", "errors"),
    [
        ("$IF P1 > 3\n", 1),
        ("#IF P1 > 3\n", 1),
        ("$WHILE P1 > 3\n", 1),
        ("$FOR P1 = 1, 2, 1\n", 1),
        ("$DO\n", 1),
        ("$REPEAT\n", 1),
        ("$SWITCH P1\n", 2),
        ("$SWITCH P1\n$CASE 1\n", 1),
        ("#RT WHILE\n", 1),
        ("#VAR\n", 2),
        ("#RT CYCLE [ID=7 SCOPE=PROG]\n", 1),
        ("#RT CYCLE [ID=7 SCOPE=PROG]\n  $IF V.E.COUNT > 1\n    M100\n", 4),
        ("$ENDIF\n", 1),
        ("$CASE 1\n", 1),
        ("#RT CYCLE END\n", 1),
        ("#ENDVAR\n", 1),
        ("#COMMENT END\n", 1),
    ],
)
def test_a_structure_error_hides_no_other_finding(
    opening: str, errors: int, machine: AssembledMachine
) -> None:
    """``errors``: the messages about the structure itself. An open cycle ends before the first
    statement that none can have (RC-201); a definition after an open ``$IF`` is reported as
    well."""
    before = findings(REST, machine)
    after = findings(opening + REST, machine)
    missing = [text for text in before if text not in after]
    assert not missing
    assert len(after) <= len(before) + errors


def test_a_structure_before_the_first_case_is_reported(machine: AssembledMachine) -> None:
    """It would not run: between ``$SWITCH`` and ``$CASE`` nothing is allowed (grammar.txt)."""
    text = "P1 = 1\n$SWITCH P1\n$IF P1 > 3\nX1\n$ENDIF\nX2\n$CASE 1\nX3\n$ENDSWITCH\n"
    assert [item[:30] for item in findings(text, machine)] == ["there must be no statement bet"]


def test_a_missing_label_is_shown_as_it_would_be_written(machine: AssembledMachine) -> None:
    """20840: the number of a block with a colon, any other name in brackets."""
    text = "%MAIN\n$GOTO N77\n$GOTO [HEER]\n[HERE] X1\nM30\n"
    found = check_files([NcText("part.nc", text)], machine).findings
    assert [item.diagnostic.remedy() for item in found] == [
        "Write N77: before a block of the same program.",
        "Did you mean HERE? Write [HEER] before a block of the same program.",
    ]
