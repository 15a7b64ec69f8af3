# SPDX-License-Identifier: MIT
"""Statements made from templates: the same trees and diagnostics as from the parser.

Real and invented programs, piece by piece, are repeated with other numbers, comments and slips of
the pen, so that many of their lines have shapes that came before.
"""

from __future__ import annotations

import dataclasses
import random
import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest
from support.check_machine import demo_channel
from support.insides import remembered
from support.random_seeds import each_seed

from nctakt.base.diagnostics import Diagnostic
from nctakt.messages import Collector
from nctakt.nc import outline
from nctakt.nc.fast import templates
from nctakt.nc.fast.shapes import ShapeScanner
from nctakt.nc.fast.templates import TemplateExpression, Templates
from nctakt.nc.inspection import inspect
from nctakt.nc.parse.parser import StatementReader
from nctakt.nc.source import Source
from nctakt.nc.tree import Statement

NUMBERS = re.compile(r"\d+\.?\d*|\.\d+")
PROGRAMS = sorted(Path(__file__).parent.glob("*.nc"))

#: Ordinary statements, as programs that are made by programs have them.
ORDINARY = (
    "N10 V.P.A = V.P.A + 2.5",
    "V.L.B = SIN[3 * V.P.A] - [V.P.A - 1] ** 2 (a (nested) comment)",
    "P1 = P1 + 1\nP[2] = -3.5",
    "N20 G01 X[V.P.R * COS[V.P.A]] Y=V.P.R Z-1.5 F[3000 + P1] ; comment",
    "$IF V.P.A > 3 && P1 < 5\nX10 Y20\n$ELSEIF V.P.A == 2\n\nX[P1 * 2]\n$ELSE\nZ=-P1\n$ENDIF",
    "$FOR P2 = 0, 10, 2\nX[P2 + 5] (one)\n$FOR V.P.I = 1, 2, 1\nY5\n$ENDFOR\n$ENDFOR",
    "$WHILE V.P.A < 10\nV.P.A += 1\n$IF V.P.A > 5\n$BREAK\n$ENDIF\n$ENDWHILE",
    "$SWITCH P1\n$CASE 1\nX1\n$BREAK\n$CASE 2\nX2\n$DEFAULT\nX3\n$ENDSWITCH",
    "$REPEAT\nX5\n$UNTIL V.P.A > 2",
    "$DO\nP1 = 3\n$ENDDO P1 < 2",
    "/2 N30 G1 X1 Y.5 M100 (on)",
    "G01X10Y20F500",
    "X1 Y 2 Z 3. F 100",
    "V.P.F[1] = 5\nV.P.F[1][2] = V.P.F[3].B + 2",
    "V.E.COUNT = 5 + V.E.COUNT",
    "G04 X0.5\nG04 2",
    "G02 X5 Y5 I2.5 J-2.5",
    "LL SUB\nL CYCLE [NAME=x.nc @P1=5]",
    "N40: X4\n$GOTO N40\n[END] X2\n$IF P1 > 3 $GOTO [END]",
    '#MSG ["%d", 5]\n"NAME" = "X1"',
    "X10 V.P.A = 5",
    "S1000 M3 T5 D1 H3",
    "X1=10 Y[20]",
    "#TIME 0.5",
    "G90 G54\nG159=2",
    "X[INDP POS=10 FEED=100]",
    "V.P.A = V.P.B == 1",
    "$IF 1\nX2\n$ENDIF",
    "X=@P1 + 2",
)
#: Structures, with statements between their lines.
STRUCTURES = (
    ("$IF V.P.A > 3", "$ENDIF"),
    ("N5 $IF P1 < 2", "$ELSEIF P1 == 3 (or)", "$ELSE", "$ENDIF"),
    ("$IF 0", "$ELSE", "$ENDIF"),
    ("$WHILE 0", "$ENDWHILE"),
    ("$WHILE P1 < 3", "$BREAK", "$ENDWHILE"),
    ("$IF P1 > 2", "$BREAK\n$CONTINUE", "$ENDIF"),
    ("$FOR P2 = 0, 10, 2", "$CONTINUE", "$ENDFOR"),
    ("$SWITCH P1", "$CASE 1", "$BREAK\n$CASE 2", "$DEFAULT", "$ENDSWITCH"),
    ("$SWITCH P1\n$CASE 1", "$BREAK\n$CASE 2", "$DEFAULT", "$ENDSWITCH"),
    ("$REPEAT", "$UNTIL P1 > 3"),
)
STRANGE = (
    ("#RT CYCLE", "#RT CYCLE END"),
    ("#VAR", "#ENDVAR"),
    ("$IF P1 > 2", "$ENDFOR"),
)
SLIPS = '[]()=$:;.,-+*/NXVPG0123 "#%\\'


def again(chance: random.Random, line: str) -> str:
    """The line with other numbers, mostly of the same shape."""

    def number(found: re.Match[str]) -> str:
        forms = (
            found[0],
            found[0],
            str(chance.randrange(1, 3000)),
            f"{chance.uniform(0, 200):.{chance.randrange(4)}f}",
            f".{chance.randrange(100)}",
            f"{chance.randrange(50)}.",
            "0",
        )
        return chance.choice(forms) if chance.random() < 0.7 else found[0]

    if chance.random() < 0.7:
        line = NUMBERS.sub(number, line)
    if chance.random() < 0.1:
        line = line.replace(" ", f" (c{chance.randrange(100)}) ", 1)
    if chance.random() < 0.04 and line:
        place = chance.randrange(len(line))
        line = line[:place] + chance.choice(SLIPS) + line[place + chance.randrange(2) :]
    return line


def program(seed: int) -> list[str]:
    """A piece of a program, or structures in no order, with other numbers each time."""
    chance = random.Random(seed)
    if seed % 2:
        text = chance.choice(PROGRAMS).read_text("utf-8", errors="replace").split("\n")
        begin = chance.randrange(len(text))
        piece = text[begin : begin + chance.randrange(1, 30)]
    elif seed % 4:
        chosen = chance.choices(ORDINARY, k=chance.randrange(1, 8))
        piece = "\n".join(chosen).split("\n")
    else:
        chosen = chance.choices(ORDINARY, k=3)
        lines = [line for _ in range(50) for line in nested(chance, chosen, 0)]
        return [again(chance, line) for line in lines]
    return [again(chance, line) for _ in range(8) for line in piece]


def nested(chance: random.Random, statements: Sequence[str], depth: int) -> list[str]:
    """A statement, or a structure with others inside it."""
    if depth == 3 or chance.random() < 0.5:
        return chance.choice(statements).split("\n")
    first, *others = chance.choice(STRANGE if chance.random() < 0.02 else STRUCTURES)
    lines = first.split("\n")
    for other in others:
        for _ in range(chance.randrange(3)):
            lines += nested(chance, statements, depth + 1)
        lines += other.split("\n")
    return lines


def to_tree(value: Any) -> Any:
    """A tree as the parser gives it, as names and values, so that -0 is not 0."""
    if isinstance(value, TemplateExpression):
        assert value.span == value.tree.span
        return to_tree(value.tree)
    if isinstance(value, tuple):
        return tuple(to_tree(one) for one in value)
    if not dataclasses.is_dataclass(value):
        return repr(value)
    fields = ((one.name, to_tree(getattr(value, one.name))) for one in dataclasses.fields(value))
    return (type(value).__name__, *fields)


def by_templates(source: Source) -> tuple[list[Statement], int]:
    """The statements, those of known shapes made from their templates, and how many are."""
    known, made = Templates(), 0
    found = []
    statements = StatementReader(source, Collector())
    while True:
        statement = known.next(statements.lines, source.file)
        made += statement is not None
        if statement is None:
            read = next(statements, None)
            if read is None:
                return found, made
            statement = read[1]
        found.append(statement)


@each_seed(40, 12)
def test_templates_make_what_the_parser_gives(seed: int) -> None:
    """All nodes with all their places, to the sign of a zero."""
    source = Source("p.nc", program(seed))
    parsed = [statement for _, statement in StatementReader(source, Collector())]
    found, _ = by_templates(source)
    assert [to_tree(one) for one in found] == [to_tree(one) for one in parsed]


def test_most_ordinary_statements_are_made_from_templates() -> None:
    """The comparison is worth something."""
    for first, minimum in ((2, 0.2), (0, 0.05)):  # statements one by one, structures
        seeds = range(first, 80, 4)
        found = [by_templates(Source("p.nc", program(seed))) for seed in seeds]
        assert sum(made for _, made in found) > minimum * sum(len(all_) for all_, _ in found)


def checked(lines: list[str]) -> list[Diagnostic]:
    """What a check of the program finds."""
    channel = demo_channel()
    collector = Collector()
    inspect(Source("p.nc", lines), channel.names, channel.parameters, collector)
    return collector.diagnostics


@each_seed(40, 12)
def test_shapes_in_order_hide_no_mistake(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each diagnostic of a program is found, whether its shapes were in order before or not."""
    monkeypatch.setattr(outline, "KEPT_STATEMENTS", 0)
    lines = program(1000 + seed)
    found = checked(lines)
    monkeypatch.setattr(Templates, "skip_known", lambda _self, _lines, index: index)
    assert checked(lines) == found


def test_shapes_in_order_are_not_checked_again(monkeypatch: pytest.MonkeyPatch) -> None:
    """Each statement is checked twice, then its shape is known; the first of all three times."""
    monkeypatch.setattr(outline, "KEPT_STATEMENTS", 0)
    lines = [f"$IF P1 > {i}\nG01 X{i} F[{i} * P1]\n$ENDIF\nP1 = {i}" for i in range(1, 50)]
    passed = 0
    skip_known = Templates.skip_known

    def count(self: Templates, group: list[str], index: int) -> int:
        nonlocal passed
        end = skip_known(self, group, index)
        passed += end - index
        return end

    monkeypatch.setattr(Templates, "skip_known", count)
    assert checked("\n".join(lines).split("\n")) == []
    assert passed == 4 * len(lines) - (3 * 3 + 2 * 1)


@pytest.mark.parametrize(
    ("line", "shape"),
    [
        ("X10 Y-2.5", b"X\1 Y-\1"),
        ("X0 Y0.0", b"X0 Y0.0"),
        ("G01 M100 T5 P1=3", b"G01 M100 T5 P1=\1"),
        ("N10 V.P.A1[2][P3] = 4 ; five", b"N\1 V.P.A1[2][P3] = \1 "),
        ("X(one)1", b"X\2\1"),
        ("X1=5 Y2", b"X1=\1 Y\1"),
        ("/2 X/3", b"/2 X/\1"),
        ("X[SIN[3] + ATAN2[4, 5]]", b"X[SIN[\1] + ATAN2[\1, \1]]"),
        ("", b""),
        ("  (comment) ; another", b""),
        ("N10.5 X1", None),
        ("N10: X1", None),
        ('"A" = "B"', None),
        ("#FLUSH", None),
        ("X1.5.5", None),
        ("X1234567890.123456", None),
        ("X1 \\", None),
        ("%L SUB", None),
        ("X1 \xe4", None),
        ("X1 ; \0", None),
        ("X" * 201, None),
        ("X1 " * 25, None),
    ],
)
def test_the_shape_of_a_line(line: str, shape: bytes | None) -> None:
    """Values are left out, what a number selects stays; what is for the parser alone has none."""
    scanner = ShapeScanner()
    count = scanner.read([line], 0)
    found = scanner.shape.key if scanner.shape is not None else b""
    assert (found if count else None) == shape


def test_a_structure_has_the_shape_of_its_own_lines() -> None:
    """One that goes on after the lines at hand has none, nor has an end without begin."""
    scanner = ShapeScanner()
    lines = ["$IF P1 > 2", "", "X4", "$FOR P1 = 1, 2, 1", "Y1", "$ENDFOR", "$ELSE", "$ENDIF", "X2"]
    assert scanner.read(lines, 0) == 8
    shape = scanner.shape
    assert shape is not None
    assert (shape.key, shape.numbers) == (b"$IF P1 > \1\n\3\n$ELSE\n$ENDIF", [2.0])
    assert shape.lines == [0, -1, 6, 7]
    ((block, loop),) = shape.runs
    assert (block.key, block.lines, block.numbers, block.ends) == (b"X\1", [2], [4.0], [2])
    assert (loop.key, loop.lines) == (b"$FOR P1 = \1, \1, \1\n\3\n$ENDFOR", [3, -1, 5])
    assert [[one.numbers for one in run] for run in loop.runs] == [[[1.0]]]
    assert scanner.read(lines[:7], 0) == 0
    assert scanner.read(["$ENDIF"], 0) == 0
    assert scanner.read(["$IF P1 > 2 $GOTO [END]", "X1"], 0) == 1
    assert scanner.read(["$IF P1 > 2"] * 22 + ["$ENDIF"] * 22, 0) == 0
    assert scanner.read(["$IF P1 > 2"] * 20 + ["$ENDIF"] * 20, 0) == 40


def test_what_is_not_looked_at_does_not_count_as_in_order(monkeypatch: pytest.MonkeyPatch) -> None:
    """After a condition that is never true nothing is checked; elsewhere the same is a mistake."""
    monkeypatch.setattr(outline, "KEPT_STATEMENTS", 0)
    dead = ["$IF 0", "X1 Q5", "$ENDIF", "$WHILE FALSE", "X1 Q5", "$ENDWHILE"] * 5
    found = checked([*dead, "X2 Q3"])
    assert [(one.id, one.span and one.span.line) for one in found] == [(20797, 31)]


def test_what_leaves_a_loop_is_in_order_only_inside_one(monkeypatch: pytest.MonkeyPatch) -> None:
    """20243, whether the branch came in loops before or not."""
    monkeypatch.setattr(outline, "KEPT_STATEMENTS", 0)
    branch = ["$IF P1 > 2", "$BREAK", "$ENDIF"]
    found = checked([*(["$WHILE P1 < 5", *branch, "$ENDWHILE"] * 5), *branch])
    assert [(one.id, one.span and one.span.line) for one in found] == [(20243, 27)]


def test_not_more_shapes_are_remembered_than_there_is_room_for(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """When too many shapes came all of them are forgotten, and found anew."""
    monkeypatch.setattr(templates, "MAX_SHAPE_CHARACTERS", 100)
    known = Templates()
    for number in range(1, 100):
        key = f"G{number} X\1".encode()
        assert known.of(key) is None
        assert known.of(key) is not None
        seen, made = remembered(known)
        assert sum(map(len, seen)) <= 100
        assert made <= len(seen)
