# SPDX-License-Identifier: MIT
"""Expressions in loops: computed as planned from the second time on, with the same results."""

from __future__ import annotations

import pytest

from nctakt.decoder.values import plans
from nctakt.decoder.values.plans import Plans
from nctakt.run.controller import Controller, NcText

VALUES = ("0", "1.5", "-7", "0.1", "100")
EXPRESSIONS = (
    "[V.P.A + V.P.B] * 3 - P1 / 7",
    "V.P.A * V.P.A + V.P.B ** 2",
    "SIN[V.P.A] * COS[30 * V.P.B] + ATAN2[V.P.A, P1 + 1]",
    "V.P.A < V.P.B && NOT[V.P.A == 1.5] || P1 > 2",
    "V.P.A == V.P.B",
    "1 / [P1 + 1] + SQRT[ABS[V.P.A]]",
    "V.P.LIST[P1] + V.P.LIST[2 - P1]",
    "V.P.A MOD 3 + INT[V.P.B] - PI",
    "P[1] + 2",
    "V.E.VALUE - V.P.A",
)
VARIABLES = "#VAR\nV.P.A = 0\nV.P.B = 0\nV.P.LIST[3] = [1, 2, 4]\n#ENDVAR\n"


def messages(text: str) -> list[str]:
    """What a program says, and the numbers and places of its diagnostics."""
    run = Controller().run(NcText("p.nc", text), memory_trace=False)
    return [message.text for message in run.messages] + [
        f"{one.id} {one.span}" for one in run.diagnostics
    ]


def in_loop(expression: str) -> str:
    """The expression with different values, evaluated by one statement again and again."""
    cases = "".join(
        f"$CASE {i}\nV.P.A = {a}\nV.P.B = {b}\n$BREAK\n"
        for i, (a, b) in enumerate(zip(VALUES, reversed(VALUES), strict=True))
    )
    return (
        f"{VARIABLES}$FOR P2 = 0, 4, 1\n$SWITCH P2\n{cases}$ENDSWITCH\nP1 = P2 MOD 3\n"
        f'#MSG ["%.17g", {expression}]\n$ENDFOR\nM30\n'
    )


def unrolled(expression: str) -> str:
    """The same in statements that are evaluated once each."""
    lines = "".join(
        f'V.P.A = {a}\nV.P.B = {b}\nP1 = {i % 3}\n#MSG ["%.17g", {expression}]\n'
        for i, (a, b) in enumerate(zip(VALUES, reversed(VALUES), strict=True))
    )
    return f"{VARIABLES}{lines}M30\n"


@pytest.mark.parametrize("expression", EXPRESSIONS)
def test_a_loop_computes_what_single_blocks_compute(expression: str) -> None:
    """Values are equal to the last digit, whichever way they were computed."""
    found = messages(in_loop(expression))
    assert len(found) == len(VALUES)
    assert found == messages(unrolled(expression))


@pytest.mark.slow
def test_few_plans_are_as_good_as_many(monkeypatch: pytest.MonkeyPatch) -> None:
    """What was forgotten is replanned."""
    expected = [messages(in_loop(one)) for one in EXPRESSIONS]
    monkeypatch.setattr(plans, "MAX_PLANS", 3)
    assert [messages(in_loop(one)) for one in EXPRESSIONS] == expected


def test_a_fault_after_an_operator_is_reported_in_a_loop_as_outside() -> None:
    """Both sides of ``&&`` are computed by the decoder; the fault has its place in both ways."""
    body = 'P1 = P1 - 1\n$IF P1 != 0 && 1 / P1 > 0\n#MSG ["%g", P1]\n$ENDIF\n'
    found = messages(f"P1 = 4\n$FOR P2 = 0, 3, 1\n{body}$ENDFOR\nM30\n")
    assert found == ["3", "2", "1", "20396 p.nc:4:13"]
    assert [one.split()[0] for one in messages(f"P1 = 4\n{body * 4}M30\n")] == [
        "3",
        "2",
        "1",
        "20396",
    ]


@pytest.mark.parametrize(
    ("expression", "number"), [("1 / P1", 20396), ("SQRT[P1 - 1]", 20398), ("10 ** P3", 21739)]
)
def test_a_fault_of_a_later_pass_has_its_place(expression: str, number: int) -> None:
    """Division, a wrong argument, no finite value: reported at their place, in any pass."""
    body = f"P3 = P3 * 20\nP1 = P1 - 1\nP4 = {expression}\n"
    found = messages(f"P1 = 3\nP3 = 1\n$FOR P2 = 0, 3, 1\n{body}$ENDFOR\nM30\n")
    assert len(found) == 1
    assert found[0].startswith(f"{number} p.nc:6:")


def test_a_variable_may_become_a_text() -> None:
    """A variable of the program's own that is made anew as a text is compared as one."""
    text = (
        '#VAR\nV.P.T = 5\n#ENDVAR\n$FOR P1 = 0, 3, 1\n$IF P1 == 2\n#DELETE V.P.T\nV.P.T = "5"\n'
        '$ENDIF\n$IF IS_STRING[V.P.T]\n#MSG ["%s", V.P.T]\n$ELSE\n#MSG ["%g", V.P.T + 1]\n$ENDIF\n'
        "$ENDFOR\nM30\n"
    )
    assert messages(text) == ["6", "6", "5", "5"]


def test_an_expression_is_planned_when_it_comes_again() -> None:
    """Blocks that are decoded once need no plan."""
    from nctakt.base.diagnostics import Span  # noqa: PLC0415
    from nctakt.nc.tree import Number  # noqa: PLC0415

    number = Number(Span("p.nc", 1, 1, 2), 2.0)
    made = Plans()
    assert made.of(number) is None
    plan = made.of(number)
    assert plan is not None
    assert plan.node is not None
    assert plan.node.measure(made.context) == 2.0
