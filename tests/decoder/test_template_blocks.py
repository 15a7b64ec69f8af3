# SPDX-License-Identifier: MIT
"""Statements made from templates: the same commands, events and diagnostics as from the parser.

Every program is checked and decoded in both ways, as a long one that is read from its text: once
with templates (``nc/fast/templates.py``) and forms (``decoder/values/template_plans.py``), once all
by parser and tree.
"""

from __future__ import annotations

import random

import pytest
from support.decoded_rows import rows
from support.random_seeds import each_seed

from nctakt.base.mode import is_compiled
from nctakt.decoder.values.evaluation import Evaluator
from nctakt.nc import outline
from nctakt.nc.fast.templates import TemplateExpression, Templates
from nctakt.nc.tree import Expression
from nctakt.run.controller import Controller, NcText

#: Rows of the queue that are compared at most: some programs never end.
MAX_ROWS = 3000

#: Ordinary statements; ``#`` represents a number.
STATEMENTS = (
    "V.P.A = V.P.A + #",
    "V.P.A = SIN[# * V.P.A] - [V.L.B - #] / 2",
    "V.L.B = V.P.A",
    "V.L.B += #",
    "V.P.N = # * V.P.A ; an integer",
    "V.P.NEW = #\nV.P.NEW = V.P.NEW * #",
    "P1 = P1 + #",
    "P2 = V.P.A / P1",
    "N# G01 X[V.P.A + #] Y=V.L.B F[3000 + P1]",
    "X[0.1 * V.P.A] Z# M100",
    "G90 X# Y[# - P1] (comment #)",
    "G91 X[P1 / 100]\nG90",
    "$IF V.P.A > #\nX#\nV.P.A = #\n$ELSE\nY# F[# + 100]\n$ENDIF",
    "$IF V.P.A == V.L.B || NOT[P1 < #]\n\nP1 = #\n$ENDIF",
    "$FOR P2 = 0, 2, 1\nX[P2 + #]\n$ENDFOR",
    "$FOR V.P.I = 3, 1, -1\nV.P.S = V.P.I * #\nX=V.P.S\n$ENDFOR",
    "$WHILE P1 < 3\nP1 = P1 + 1\nX[P1 + #]\n$ENDWHILE",
    "$SWITCH V.P.I\n$CASE 2\nX#\n$BREAK\n$DEFAULT\nY#\n$ENDSWITCH",
    "$REPEAT\nP1 = P1 + #\n$UNTIL P1 > 2",
    "G02 X# Y5 R[200 + P1]\nG01",
    "/2 X[# + P1]",
    "V.P.F[1] = #\nX=V.P.F[1]",
    "V.E.COUNT = #",
    "LL SUB",
    "G04 0.01",
    "M[99 + P1 / P1] X[# + P1]",
    '"NAME" = "V.P.A + 1"\nX["NAME" / 2]',
    "V.P.A -= #",
    "V.L.B *= 0.5",
    "X# Y#",
    "#VAR\nV.L.C = 1\n#ENDVAR\nX[V.L.C + #]",
    "#DELETE V.P.NEW",
    "N40: X#",
)
#: What goes wrong, or means something else, only where values are looked at.
STRANGE = (
    "V.P.A = 5 / [V.P.A - V.P.A]",
    "V.P.A = SQRT[-#]",
    "X[99999 + P1]",
    "V.P.NOWHERE = V.P.MISSING + #",
    'V.P.T = "text"\nV.P.A = V.P.T\nX[V.P.A + #]',
    'V.P.A = "text"',
    "V.P.N = 99999999999 * #",
    "V.P.F = # + P1",
    "X=V.P.F",
    "P1 = LN[P1 - 1000]",
    "$FOR P1 = 1, 2, 0\nX#\n$BREAK\n$ENDFOR",
    "F[P1 - P1]\nX[# + 1]",
    "V.S.KEPT = # + 1\n#DELETE V.S.\nV.P.A = V.S.KEPT",
)
#: Structures, with statements between their lines.
STRUCTURES = (
    ("$IF V.P.A > #", "$ELSE", "$ENDIF"),
    ("$IF P1 < #", "$ELSEIF V.P.A < # && P1 > 1", "$ENDIF"),
    ("$FOR P2 = 1, 2, 1", "$ENDFOR"),
    ("$FOR V.P.I = 1, 3, 1", "$IF V.P.I > 1\n$BREAK\n$ENDIF", "$ENDFOR"),
    ("$SWITCH P1\n$CASE 1", "$BREAK\n$CASE 2", "$DEFAULT", "$ENDSWITCH"),
    ("V.P.I = 0\n$WHILE V.P.I < 2", "V.P.I = V.P.I + 1\n$ENDWHILE"),
)
HEAD = """\
#VAR
V.P.A = 1
V.P.I = 0
V.P.S = 0
V.P.N : SGN32 = 0
V.P.F[4] = [1, 2, 3, 4]
V.L.B = 2
#ENDVAR
P1 = 1
G01 F6000"""


def filled(chance: random.Random, statement: str) -> str:
    """The statement with numbers."""
    if statement.startswith("#"):
        return statement.replace("+ #", f"+ {chance.randrange(1, 9)}")
    parts = statement.split("#")
    text = parts[0]
    for part in parts[1:]:
        value = chance.choice((str(chance.randrange(60)), f"{chance.uniform(0, 60):.2f}"))
        text += (value.split(".")[0] if text.endswith("N") else value) + part
    return text


def content(seed: int) -> str:
    """A program in which some statements come again and again."""
    chance = random.Random(seed)
    chosen = chance.choices(STATEMENTS, k=chance.randrange(2, 10))
    if chance.random() < 0.4:
        chosen.append(chance.choice(STRANGE))
    lines = [HEAD]
    simple = [one for one in chosen if "\n#" not in one and "N40" not in one]
    for _ in range(chance.randrange(20, 70)):
        if simple and chance.random() < 0.2:
            first, *others = chance.choice(STRUCTURES)
            lines.append(filled(chance, first))
            for other in others:
                bodies = chance.choices(simple, k=chance.randrange(3))
                lines += (filled(chance, one) for one in bodies)
                lines.append(filled(chance, other))
        else:
            lines.append(filled(chance, chance.choice(chosen)))
    lines += ["M30", "%L SUB", "X[V.P.A * 2]", "V.L.B = 5", "X[V.L.B + 1]", "M17"]
    text = "\n".join(lines)
    first = text.find("N40:")
    return text[: first + 4] + text[first + 4 :].replace("N40:", "N41") if first >= 0 else text


@pytest.fixture(autouse=True)
def long(monkeypatch: pytest.MonkeyPatch) -> None:
    """Every program is a long one."""
    monkeypatch.setattr(outline, "KEPT_STATEMENTS", 0)


def by_parser(monkeypatch: pytest.MonkeyPatch) -> None:
    """Each statement is read and checked."""
    monkeypatch.setattr(Templates, "next", lambda _self, _lines, _file: None)
    monkeypatch.setattr(Templates, "skip_known", lambda _self, _lines, index: index)


@each_seed(10, 3)
def test_both_ways_give_the_same_commands(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Random programs: the rows of the queue are equal to the bit, and so are the diagnostics."""
    text = content(seed)
    short = rows(text, MAX_ROWS)
    by_parser(monkeypatch)
    assert rows(text, MAX_ROWS) == short


@pytest.mark.slow
@pytest.mark.skipif(not is_compiled(), reason="the same in both modes")
def test_many_random_programs_run_and_are_full_of_forms(monkeypatch: pytest.MonkeyPatch) -> None:
    """The comparison is worth something: most expressions are computed by their form."""
    known = [0, 0]
    ask = Evaluator.constant_value

    def count(self: Evaluator, expression: Expression) -> float | None:
        value = ask(self, expression)
        if isinstance(expression, TemplateExpression):
            known[value is None] += 1
        return value

    monkeypatch.setattr(Evaluator, "constant_value", count)
    found = [rows(content(seed), MAX_ROWS) for seed in range(30)]
    assert sum(len(one) > 20 for one, _ in found) > 10
    assert known[0] > 1000
    assert 5 < known[1] < 0.3 * known[0]


@each_seed(12, 3)
def test_both_ways_run_the_same(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Whole runs: trace, events with their places, diagnostics, messages."""
    text = content(2000 + seed)
    found = []
    for _ in range(2):
        run = Controller().run(NcText("p.nc", text), ticks=3000, skip=(2,))
        assert run.trace is not None
        found.append((run.state, run.ticks, run.diagnostics, list(run.trace.events), run.messages))
        by_parser(monkeypatch)
    assert found[0] == found[1]


def test_a_jump_back_finds_the_forms_again(monkeypatch: pytest.MonkeyPatch) -> None:
    """After each ``$GOTO`` the text is reread; templates and forms stay."""
    lines = [HEAD, *(f"X[P1 + {i}]" for i in range(1, 30)), "N50: P1 = P1 + 1"]
    lines += [*(f"Y[P1 * {i}]" for i in range(1, 30)), "$IF P1 < 5 $GOTO N50", "M30"]
    text = "\n".join(lines)
    short = rows(text, MAX_ROWS)
    assert short[1] == []
    assert len(short[0]) > 140
    by_parser(monkeypatch)
    assert rows(text, MAX_ROWS) == short


def test_a_mistake_is_reported_at_its_own_place() -> None:
    """20396 in the tenth statement of a shape, with the its own columns numbers."""
    lines = [HEAD, *(f"N{10**i} V.P.A = {i} / [{8 - i} * V.P.I + 1]" for i in range(8))]
    lines += ["V.P.I = -1", "N123456 V.P.A = 12345 / [1 * V.P.I + 1]", "M30"]
    (found,) = rows("\n".join(lines))[1]
    assert (found.id, str(found.span)) == (20396, "p.nc:20:23")
    assert found.source_line == lines[-2]
