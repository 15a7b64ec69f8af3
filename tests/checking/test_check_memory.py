# SPDX-License-Identifier: MIT
"""A check that continues from known states finds exactly what a fresh one finds."""

from __future__ import annotations

import random
from collections.abc import Callable

import pytest
from support.random_seeds import each_seed

from nctakt.checking import check_memory
from nctakt.checking.check import CheckResult, check_files
from nctakt.checking.check_memory import CheckMemory
from nctakt.checking.path_checker import MAX_LINES
from nctakt.checking.program_pass import ProgramPass
from nctakt.lists.machine.machine import load_machine
from nctakt.nc import inspection
from nctakt.run.program_loader import NcText
from nctakt.run.realtime.assembly import AssembledMachine

EDITS = 30

#: Lines that open, close and depend on what other lines say.
LINES = r"""
N10 G01 X10 Y20 F1000|G02 X10 Y10|G02 X5 Y5 I2 J2|X1 Y2|X3|G00 Z5|G90|G91|G70|G71|G41 D1|G40
[MARK]|N20: G01 X1|$GOTO [MARK]|$GOTO N20|M30|M17|%main|%L one|%L two|LL one|L sub.nc
P1 = 5|P2 = P1 + 1|V.P.A = 3|#VAR|V.P.A : UNS32|#ENDVAR|$IF P1 > 2|$ELSE|$ENDIF|$FOR P1 = 1, 3, 1
$ENDFOR|$WHILE P1 < 3|$ENDWHILE|#RT CYCLE [ID=1 SCOPE=PROG]|  $IF EDGE V.RTA.ACS.ACT_POS.X > P1
    M100|  $ENDIF|  V.E.COUNT = V.E.COUNT + 1|#RT CYCLE END|#RT CYCLE [ID=2 SCOPE=GLOBAL]
#RT CYCLE DELETE [ID=1]|#RT CYCLE DELETE [ID=P1]|#FLUSH|; comment|; nctakt: ignore 900243 why
; expect: M100|; expct: M100|( a comment|#COMMENT BEGIN|#COMMENT END|G01 X=P1 \| Y10|R5|T1 D1|T99
#MSG ["a %d", P1]|#CONTOUR MODE [PTP]|#SLOPE [TYPE=1]|"mac" = "G01 X10"|"mac"|G01 X1 Q1|D99
#CALL AX [W1, 3, 5]|G01 W1=5|#PUT AX [Y]|#WAIT [ID=1 CH=1]
G01 X 99999|$IF P1 = 2|S1000 M3|$BREAK|$SWITCH P1|$CASE 1|$ENDSWITCH|#INIT V.E|V.E.COUNT = 2|foo
""".strip().replace("\n", "|").split("|")  # fmt: skip


class Cancelled(Exception):
    pass


@pytest.fixture(scope="module")
def machine() -> AssembledMachine:
    return AssembledMachine(load_machine(None))


def findings(result: CheckResult) -> list[tuple[object, ...]]:
    return [
        (item.file, item.channels, item.diagnostic.render("en"), item.diagnostic.span)
        for item in result.findings
    ]


def check(
    lines: list[str],
    machine: AssembledMachine,
    memory: CheckMemory | None = None,
    poll: Callable[[], None] | None = None,
) -> list[tuple[object, ...]]:
    text = NcText("part.nc", "\n".join(lines))
    return findings(check_files([text], machine, memory=memory, poll=poll))


def edit(lines: list[str], chance: random.Random) -> None:
    first = chance.randrange(len(lines) + 1)
    count = chance.choice((0, 1, 1, 2, 5))
    lines[first : first + count] = chance.choices(LINES, k=chance.choice((0, 1, 1, 1, 2, 3)))
    if len(lines) > 60:
        del lines[chance.randrange(len(lines)) :][:10]


@each_seed(40, 20)
def test_random_edits_find_what_a_fresh_check_finds(
    seed: int, machine: AssembledMachine, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Each edit of a program, and each check that is cancelled between, leave nothing behind."""
    chance = random.Random(seed)
    monkeypatch.setattr(inspection, "STATEMENTS_PER_PAUSE", chance.choice((1, 2, 5)))
    monkeypatch.setattr(check_memory, "SECTION_LINES", chance.choice((1, 3, 10)))
    monkeypatch.setattr(check_memory, "_MIN_LINES", chance.choice((0, 0, 5)))
    lines = chance.choices(LINES, k=chance.randrange(40))
    memory = CheckMemory()

    def poll() -> None:
        if chance.random() < 0.02:
            raise Cancelled

    for number in range(EDITS):
        try:
            found = check(lines, machine, memory, poll)
        except Cancelled:
            found = None
        if found is not None and number % 4 == seed % 4:
            assert found == check(lines, machine), "\n".join(lines)
        edit(lines, chance)


def test_the_limit_of_a_followed_path_is_crossed_by_an_edit(machine: AssembledMachine) -> None:
    """A program that gets too long, or short enough, to be followed is reread."""
    lines = [f"G01 X{number % 7}" for number in range(MAX_LINES - 1)]
    lines.append("G00 X99999")
    memory = CheckMemory()
    assert any("99999" in str(item[2]) for item in check(lines, machine, memory))
    for change in (lambda: lines.insert(3, "X1"), lambda: lines.pop(0)):
        change()
        assert check(lines, machine, memory) == check(lines, machine)


def test_a_keystroke_reads_its_section_only(
    machine: AssembledMachine, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Statements after the next place with the same state are not visited again."""
    lines: list[str] = []
    for number in range(200):
        lines += [f"P1 = {number}", f"#RT CYCLE [ID={number + 1} SCOPE=PROG]"]
        lines += ["  $IF V.RTA.ACS.ACT_POS.X > 3", "    M100", "  $ENDIF", "#RT CYCLE END"]
    memory = CheckMemory()
    check(lines, machine, memory)
    visited: list[int] = []
    visit = ProgramPass.statement

    def noted(reading: ProgramPass, statement: inspection.Statement) -> None:
        visited.append(statement.span.line)
        visit(reading, statement)

    monkeypatch.setattr(ProgramPass, "statement", noted)
    lines[600] = "P1 = 7"
    check(lines, machine, memory)
    assert 601 in visited
    assert len(visited) < 150
    visited.clear()
    lines.insert(601, "M100")
    check(lines, machine, memory)
    assert 602 in visited
    assert len(visited) < 150
    visited.clear()
    check(lines, machine, memory)
    assert not visited


def test_an_arc_ends_at_a_plain_block_in_a_long_program(machine: AssembledMachine) -> None:
    """A block of a known shape ends G02 all the same: no missing centre is reported after it."""
    lines = ["G01 X1 Y1 F100", *["X1 Y1"] * MAX_LINES]
    lines += ["G02 X2 Y2 I1 J0", "G01 X3 Y3", "X4 Y4 Z1", "M30"]
    assert not [item for item in check(lines, machine) if "centre" in str(item[2])]
