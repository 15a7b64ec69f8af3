# SPDX-License-Identifier: MIT
"""Comments that suppress findings: what they take out, and what is reported about them."""

from __future__ import annotations

from pathlib import Path

import pytest

from nctakt.base.text import split_lines
from nctakt.checking.check import check_files
from nctakt.lists.machine.machine import load_machine
from nctakt.run.program_loader import NcText
from nctakt.run.realtime.assembly import AssembledMachine

CYCLE = """\
#RT CYCLE [ID=1 SCOPE=PROG]
  $IF V.RTA.ACS.ACT_POS.X > 5
    M100{behind}
  $ENDIF
#RT CYCLE END
M30
"""


def numbers(text: str) -> list[tuple[int, int]]:
    """Line and number of each finding for the built-in machine."""
    result = check_files([NcText("t.nc", text)], AssembledMachine(load_machine(None)))
    return [
        (item.diagnostic.span.line, item.diagnostic.id)
        for item in result.findings
        if item.diagnostic.span is not None
    ]


@pytest.mark.parametrize(
    ("comment", "left"),
    [
        ("", [(3, 900243)]),
        (" ; nctakt: ignore 900243 the PLC counts them", []),
        (" ; NCTAKT: IGNORE 900243, 900235 both", [(3, 901182)]),
        (" ; nctakt: ignore 900243", [(3, 901183)]),
        (" ; nctakt: ignore 900235 the wrong one", [(3, 900243), (3, 901182)]),
        (" ; nctakt: ingore 900243 misspelt", [(3, 900243), (3, 901185)]),
        (" ; nctakt: ignore 999999 nobody has it", [(3, 900243), (3, 901185)]),
        (" ; nctakt: ignore all", [(3, 900243), (3, 901185)]),
        (" ; nctakt: ignore 900243 reason ; expect: M100", []),
    ],
)
def test_a_comment_suppresses_the_numbers_that_it_names(
    comment: str, left: list[tuple[int, int]]
) -> None:
    """Only the finding of the number in its line goes; a comment without effect is reported."""
    assert numbers(CYCLE.format(behind=comment)) == left


def test_a_comment_on_a_line_of_its_own_is_about_the_next_block() -> None:
    """Empty lines and other comments between them do not count."""
    lines = split_lines(CYCLE.format(behind=""))
    lines[2:2] = ["; nctakt: ignore 900243 the PLC counts them", "", "; more words"]
    assert numbers("\n".join(lines)) == []


def test_an_error_is_never_suppressed() -> None:
    """A program with an error does not run, so the comment is reported instead."""
    found = numbers("G01 X1,5 F100 ; nctakt: ignore 20797 no reason helps\nM30\n")
    assert found == [(1, 20797), (1, 901184)]


def test_a_text_in_quotes_is_no_comment() -> None:
    """Only a comment suppresses."""
    assert numbers('#MSG ["; nctakt: ignore 900243 x"]\nM30\n') == []


@pytest.mark.parametrize(
    ("comment", "left"),
    [
        ("", [1023]),
        (" # nctakt: ignore 1023 the machine has it so", []),
        (" # nctakt: ignore 900008 another number", [1023, 901182]),
    ],
)
def test_in_lists_such_comments_follow_a_hash(
    comment: str, left: list[int], tmp_path: Path
) -> None:
    """The finding of an entry is taken out, and an unused comment reported, as in programs."""
    path = tmp_path / "sda_mds1.lis"
    path.write_text(f"rt_cycles.enable   7{comment}\nrt_cycles.max_duration 500\n")
    result = check_files([path], AssembledMachine(load_machine(None)))
    found = [item.diagnostic.id for item in result.findings]
    assert [number for number in found if number != 900583] == left
