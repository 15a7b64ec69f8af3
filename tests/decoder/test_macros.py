# SPDX-License-Identifier: MIT
"""Macros whose text cannot be used: reported at the block that uses them."""

from __future__ import annotations

import pytest

from nctakt.run.controller import Controller, NcText


@pytest.mark.parametrize(
    ("text", "error"),
    [
        ('"A"', 20619),
        ('"a" = "X1"\n"A"', 20619),
        ('"A" = "X1 :::"\n"A"', 20797),
        ('"A" = "Q1"\n"A"', 20797),
        ('"A" = "G200"\nX1 "A"', 900200),
        ('"A" = "V.P.X"\n"A"', 20932),
    ],
)
def test_a_macro_that_cannot_be_used_ends_the_program(text: str, error: int) -> None:
    """Facts 2.1: case counts; the text is checked like any other."""
    run = Controller().run(NcText("p.nc", text + "\nM30\n"))
    (found,) = run.errors
    assert found.id == error
    assert found.span is not None
    assert found.span.line == text.count("\n") + 1
    assert found.render("de")


@pytest.mark.parametrize(
    ("text", "error", "line"),
    [
        ('"A" = "COS["\nX["A" + 1]', 900101, 2),
        ('"A" = "1 2"\nX["A" + 1]', 20797, 2),
        ('"A" = "FOO"\nX["A" + 1]', 20392, 2),
        ('"A" = "V.P.NONE"\nX["A" + 1]', 20932, 2),
        ('"A" = "1 / 0"\nX["A" + 1]', 20396, 2),
        ('"A" = "1 + \\"A\\""\nX["A" + 1]', 900848, 2),
        ('"A" = "\\"A\\""\n"A"', 900848, 2),
        ('X["A" + 1]\n"A" = "1"', 21461, 1),
        ('LL SUB\nX["B" + 1]\nM30\n%L SUB\nM17', 20619, 2),
        ('LL SUB\nM30\n%L SUB\nX=P1*"B"\nM17', 20619, 4),
        ('#RT CYCLE [ID=1]\nV.E.VALUE = 2 * "B"\n#RT CYCLE END', 21981, 2),
        (
            'LL SUB\n#RT CYCLE [ID=1]\nV.E.VALUE = 2 * "B"\n#RT CYCLE END\nM30\n%L SUB\nM17',
            20619,
            3,
        ),
    ],
)
def test_a_macro_that_is_no_term_ends_the_program(text: str, error: int, line: int) -> None:
    """Facts 2.1: in expressions whole terms only; any other text is reported at once."""
    run = Controller().run(NcText("p.nc", text + "\nM30\n"))
    (found,) = run.errors
    assert found.span is not None
    assert (found.id, found.span.line) == (error, line)
    assert found.render("de")


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ('"A" = "2 + 1"\nP1 = 2 * "A"', "6"),
        ('"A" = "2"\nP1 = "A"', "2"),
        ('"A" = "2"\nV.P.T = "A"\nP1 = IS_STRING[V.P.T]', "1"),
        ('"A" = "2"\nV.P.T = "A" + "B"\nP1 = V.P.T == "AB"', "1"),
        ('"A" = "2"\nP1 = LEN["A" + "B"]', "2"),
        ('"A" = "2"\n#VAR\nV.P.F[3] = [1, 2, 3]\n#ENDVAR\nP1 = V.P.F["A"]', "3"),
        ('"A" = "2"\nP["A" - 1] = 7', "7"),
        ('"A" = "2"\n$FOR P1 = "A", "A" * 2, "A"\n$ENDFOR', "6"),
        ('"A" = "2"\n$SWITCH 2\n$CASE "A"\nP1 = 5\n$ENDSWITCH', "5"),
        ('"A" = "2"\n$FOR P2 = 1, 2, 1\nP1 = P1 + "A"\n"A" = "10"\n$ENDFOR', "12"),
        ('"A" = "V.P.X"\n$FOR P2 = 1, 3, 1\nV.P.X = P2\nP1 = P1 + "A"\n$ENDFOR', "6"),
        ('LL SUB\nP1 = 1 + "B"\n#MSG ["%g", P1]\nM30\n%L SUB\n"B" = "4"\nM17', "5"),
    ],
)
def test_where_a_text_is_a_macro(text: str, shown: str) -> None:
    """A macro where a number is needed, a text where one is allowed; the latest one counts."""
    run = Controller().run(NcText("p.nc", text + '\n#MSG ["%g", P1]\nM30\n'))
    assert not run.errors, run.errors
    assert [event.text for event in run.events if event.kind == "message"] == [shown]


def test_what_is_wrong_in_a_macro_is_named() -> None:
    """The message shows the word of the macro's text; the place is the block that uses it."""
    run = Controller().run(NcText("p.nc", '"A" = "X1 Q17"\n"A" Y1\nM30\n'))
    (found,) = run.errors
    assert found.text("en").startswith("unknown word Q17: ")
    assert found.source_line == '"A" Y1'


def nested(depth: int, glue: str) -> str:
    """Macros that have the one before twice in their texts: 2 ** ``depth`` times the first."""
    lines = ['"M0" = "1"']
    for level in range(1, depth + 1):
        inner = f'\\"M{level - 1}\\"'
        lines.append(f'"M{level}" = "{inner}{glue}{inner}"')
    return "\n".join(lines)


@pytest.mark.parametrize(
    ("text", "error", "column"),
    [
        ('"A" = "\\"A\\" \\"A\\""\nX1 "A"', 900849, 4),
        ('"A" = "\\"B\\" \\"B\\""\n"B" = "\\"A\\""\n"A"', 900848, 1),
        ('"A" = "\\"B\\""\n"B" = "\\"A\\""\nX1 "A"', 900848, 4),
        (nested(19, " ") + '\n"M19"', 900849, 1),
        (nested(19, "+") + '\nX["M19"]', 900849, 3),
        (nested(25, "+") + '\nX["M25"]', 900848, 3),
        ('"A" = "' + "X1 " * 1300 + '"\n' + '"A" ' * 6, 900849, 21),
    ],
)
def test_macros_do_not_grow_without_bound(text: str, error: int, column: int) -> None:
    """Depth and text of one block have bounds, reported at the macro; the run ends by itself."""
    run = Controller().run(NcText("p.nc", text + "\nM30\n"), ticks=5)
    (found,) = run.errors
    assert found.id == error
    assert found.span is not None
    assert (found.span.line, found.span.column) == (text.count("\n") + 1, column)


def test_macros_within_their_bounds_are_what_they_stand_for() -> None:
    """Twenty inside each other; texts up to 20000 characters."""
    chain = ['"M1" = "X7"', *(f'"M{n}" = "\\"M{n - 1}\\""' for n in range(2, 21))]
    run = Controller().run(NcText("p.nc", "\n".join(["G00", *chain, '"M20"', "M30"])))
    assert run.state == "ended"
    assert run.trace is not None
    assert run.trace["X.ACS.CUR_POS"][-1] == 7.0
    uses = '"A" ' * 5
    text = f'G00\n"A" = "{" " * 3_900}"\n{uses}X1\nM30'
    assert Controller().run(NcText("p.nc", text)).state == "ended"
