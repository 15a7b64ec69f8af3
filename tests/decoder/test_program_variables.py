# SPDX-License-Identifier: MIT
"""Variables that programs make themselves: how long they live, and what ends a program."""

from __future__ import annotations

import pytest

from nctakt.results.run import Run
from nctakt.run.controller import Controller, NcText


def run(*lines: str) -> Run:
    """A program on the demo machine."""
    return Controller().run(NcText("p.nc", "\n".join((*lines, "M30"))))


def said(result: Run) -> list[str]:
    """The texts of all messages."""
    assert result.errors == ()
    return [event.text for event in result.events if event.kind == "message"]


@pytest.mark.parametrize(
    ("lines", "error"),
    [
        (("P1 = V.P.NONE",), 20932),
        (("V.L.NONE = 1",), 20932),
        (("V.P.NONE[1] = 1",), 20932),
        (("V.P.A = 1", "P1 = V.P.A[0]"), 21768),
        (("#VAR", "V.P.A[3]", "#ENDVAR", "V.P.A[3] = 1"), 21928),
        (("#VAR", "V.P.A[3] = [1, 2, 3, 4]", "#ENDVAR"), 20912),
        (("#VAR", "V.P.A[1000][1000]", "#ENDVAR"), 20917),
        (("P1 = 0.5", "#VAR", "V.P.A[P1]", "#ENDVAR"), 20917),
        (("#VAR", "V.P.A[3]", "#ENDVAR", "V.P.A[1] = [1, 2]"), 900317),
        (("#VAR", "V.P.A : SGN08", "#ENDVAR", "V.P.A = 128"), 20847),
        (("#VAR", 'V.P.A : STRING[3] = "text"', "#ENDVAR"), 21462),
        (('V.P.A = "text"', "P1 = V.P.A"), 21461),
        (('V.P.A = "text"', "V.P.A = 1"), 21460),
        (("V.P.A = 1", 'V.P.A = "text"'), 21461),
        (("V.P.A = 1", '$IF V.P.A == "text"', "$ENDIF"), 21460),
        (('P1 = STR_TO_REAL["one"]',), 20396),
        (('P1 = ORD["A", 2]',), 20396),
        (('V.E.TEXT = MID["text", 1, 0]',), 20396),
        (("#RT CYCLE", "V.E.VALUE = V.P.NONE", "#RT CYCLE END"), 20932),
    ],
)
def test_what_only_values_show_ends_the_program(lines: tuple[str, ...], error: int) -> None:
    """Missing variables, elements and types that do not fit, functions without result."""
    assert [one.id for one in run(*lines).errors] == [error]


def test_values_are_those_of_their_types() -> None:
    """RC-307 for own variables; lists inside lists; an array without dimensions."""
    types = ("V.P.A : SGN16 = 2.5", "V.P.B : BOOLEAN = 0.4", "V.P.C = [1, [2, 3]]")
    show = '#MSG ["%g %g %g %g", V.P.A, V.P.B, V.P.C[2], SIZEOF[V.P.C] + SIZEOF[V.P.A]]'
    assert said(run("#VAR", *types, "#ENDVAR", show)) == ["2 0 3 3"]


def test_v_s_outlives_programs_and_resets_and_v_p_does_not() -> None:
    """Facts 2.4."""
    controller = Controller()
    first = controller.run(NcText("a.nc", "V.S.A = 7\nV.P.A = 8\nP5 = 1\nM30\n"))
    controller.reset()
    second = controller.run(NcText("b.nc", '#MSG ["%g %g", V.S.A, EXIST[V.P.A]]\nM30\n'))
    assert first.errors == ()
    assert said(second) == ["7 0"]
    third = controller.run(
        NcText("c.nc", '#DELETE V.S.A, V.S.NONE\n#MSG ["%g", EXIST[V.S.A]]\nM30')
    )
    assert said(third)[-1] == "0"


def test_a_whole_family_is_deleted() -> None:
    """``V.P.`` alone names all of it."""
    show = '#MSG ["%g %g", EXIST[V.P.A], EXIST[V.S.B]]'
    assert said(run("V.P.A = 1", "V.S.B = 2", "#DELETE V.P.", show)) == ["0 1"]


def test_a_loop_counts_with_its_own_variable() -> None:
    """``$FOR`` and ``$SWITCH`` take any writable variable."""
    lines = ("V.P.I = 0", "$FOR V.P.I = 3, 1, -1", '#MSG ["%g", V.P.I]', "$ENDFOR")
    assert said(run(*lines)) == ["3", "2", "1"]
