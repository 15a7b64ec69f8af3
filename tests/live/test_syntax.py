# SPDX-License-Identifier: MIT
"""The colours of the program on the page: the tokens of the language server, for lines in view."""

from nctakt.live.syntax import MAX_CHARACTERS, MAX_LINES, Syntax

PROGRAM = """P1 = 200
#RT CYCLE [ID=7]
  $IF EDGE V.RTA.ACS.ACT_POS.X > P1
    M100
#RT CYCLE END
G01 X300 (a)
#COMMENT BEGIN
G01 X1
#COMMENT END"""

SYNTAX = Syntax(frozenset())


def coloured(text: str, first: int, last: int) -> list[list[tuple[str, str]]]:
    """The texts of tokens with their classes, by lines."""
    return [
        [(line[start:end], name.replace("nc-t-", "")) for start, end, name in tokens]
        for line, tokens in SYNTAX.shown(text.split("\n"), first, last)
    ]


def test_lines_in_view_have_their_tokens() -> None:
    """Inside of a realtime cycle what is read and done in each tick says so; then as outside."""
    assert coloured(PROGRAM, 3, 6) == [
        [
            ("$IF", "keyword"),
            ("EDGE", "keyword"),
            ("V.RTA.ACS.ACT_POS.X", "variable realtime"),
            (">", "operator"),
            ("P1", "parameter"),
        ],
        [("M100", "function realtime")],
        [("#RT CYCLE END", "macro")],
        [("G01", "function"), ("X", "property"), ("300", "number"), ("(a)", "comment")],
    ]


def test_a_comment_of_several_lines_is_one() -> None:
    """Also where its first line is not in view."""
    assert coloured(PROGRAM, 8, 8) == [[("G01 X1", "comment")]]


def test_columns_are_those_of_browsers() -> None:
    """A sign outside of the basic plane has two units of UTF-16."""
    ((_, tokens),) = SYNTAX.shown(["(\U0001f529) G01"], 1, 1)
    assert tokens == [(0, 4, "nc-t-comment"), (5, 8, "nc-t-function")]


def test_what_is_asked_for_is_bounded() -> None:
    """Lines that are not there, too many of them, long ones; a million lines."""
    assert SYNTAX.shown(["G01"], 5, 9) == SYNTAX.shown(["G01"], 3, 1) == []
    assert SYNTAX.shown(["G01"], -5, 1) == [("G01", [(0, 3, "nc-t-function")])]
    long = "X1" * MAX_CHARACTERS
    ((text, tokens),) = SYNTAX.shown([long], 1, 1)
    assert text == long
    assert tokens[-1][1] <= MAX_CHARACTERS
    many = ["G01 X1"] * 1_000_000
    assert len(SYNTAX.shown(many, 999_000, 1_000_000)) == MAX_LINES
