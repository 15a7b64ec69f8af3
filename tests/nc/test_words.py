# SPDX-License-Identifier: MIT
"""Blocks: what their words become."""

from __future__ import annotations

import pytest
from support.nc_trees import shape, statement, statements

from nctakt.nc.parse.printer import format_expression, format_word
from nctakt.nc.tree import (
    Assignment,
    AxisWord,
    Block,
    BracketCommand,
    Keyword,
    MacroDefinition,
    Number,
    StringLiteral,
    SubprogramCall,
    Variable,
    VariableBlock,
    Word,
)


def words(text: str) -> list[str]:
    """The words of a block as they are printed."""
    block = statement(text)
    assert isinstance(block, Block)
    return [format_word(word) for word in block.words]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("N10G1X1.5Y-2F100", ["G1", "X1.5", "Y-2", "F100"]),
        ("n10 g01 x 1. y - .5", ["G1", "X1", "Y-0.5"]),
        ("X 52525.00", ["X52525"]),
        ("X=1 X1=2 XR=3 XR4", ["X1", "X1=2", "XR=3", "XR=4"]),
        ("XP1YP2", ["X=P1", "Y=P2"]),
        ("XV.L.X YVs.E.A", ["X=V.L.X", "Y=Vs.E.A"]),
        ("X[P1+2] Y[-3]", ["X=P1 + 2", "Y-3"]),
        ("X SIN[30] YATAN2[1,2]", ["X=SIN[30]", "Y=ATAN2[1, 2]"]),
        ("G02 XP10+P20 Y1*2", ["G2", "X=P10 + P20", "Y=1 * 2"]),
        ("TV.P.NR M@P6", ["T=V.P.NR", "M=@P6"]),
        ("M110=130 G129 = 50", ["M110=130", "G129=50"]),
        ("G805[1,P2]", ["G805[1, P2]"]),
        ("G04 3.0", ["G4=3"]),
        ("G4 P1", ["G4=P1"]),
        ("M03 S1000 S.POS314", ["M3", "S1000", "S.POS=314"]),
        ("S2=500", ["S2=500"]),
        ("foo X", ["FOO", "X"]),
        ('G1 "MACRO" X1', ["G1", '"MACRO"', "X1"]),
        ("L", ["L"]),
        ("L=5", ["L=5"]),
    ],
)
def test_words_are_read_with_and_without_blanks(text: str, expected: list[str]) -> None:
    """Words need no blanks, take values in all forms, and do not depend on case."""
    assert words(text) == expected


@pytest.mark.parametrize("text", ["G1 X1.5 Y-2 F100", "G1 X=1.5 Y=-2 F=100", "G1X1.5Y[-2]F[100]"])
def test_the_short_way_gives_the_same_tree_as_the_long_one(text: str) -> None:
    """Plain blocks are read by one pattern per word, to the same nodes."""
    assert shape(statement(text)) == shape(statement("g01x1.5y-2f100"))


def test_each_word_has_its_place() -> None:
    """Spans cover words and values, in plain blocks and in others."""
    for text in ("N10 G01  X-1.5", "N10 G01  X-1.5 foo"):
        block = statement(text)
        assert isinstance(block, Block)
        places = [(word.span.column, word.span.end_column) for word in block.words[:2]]
        assert places == [(5, 8), (10, 15)]
        value = block.words[1].value  # type: ignore[attr-defined]
        assert (value.span.column, value.span.end_column) == (11, 15)
        assert block.span.column == 5


def test_letters_of_axes_make_axis_words() -> None:
    """Names that begin with A B C Q U V W X Y Z may be axes; whether they are is checked later."""
    block = statement("A1 B1 C1 Q1 U1 V1 W1 X1 Y1 Z1 G1 F1 S1 T1 D1 H1 I1 J1 K1 R1 E1")
    assert isinstance(block, Block)
    axes = [word for word in block.words if isinstance(word, AxisWord)]
    assert "".join(axis.name for axis in axes) == "ABCQUVWXYZ"
    assert all(isinstance(word, Word) for word in block.words[10:])


@pytest.mark.parametrize(
    ("text", "name", "items"),
    [
        (
            "Z [INDP ABORTING G01 G90 FEED=500 POS=-9 OFFSET=ALL]",
            "Z",
            [
                ("INDP", None),
                ("ABORTING", None),
                ("G", "1"),
                ("G", "90"),
                ("FEED", "500"),
                ("POS", "-9"),
                ("OFFSET", "ALL"),
            ],
        ),
        ("z[indp dir = pos feed1000]", "Z", [("INDP", None), ("DIR", "pos"), ("FEED", "1000")]),
        (
            "S2[M03 M19 REV=P1*2 S.POS=3]",
            "S2",
            [("M", "3"), ("M", "19"), ("REV", "P1 * 2"), ("S.POS", "3")],
        ),
        ("S[M5]", "S", [("M", "5")]),
        ("X1 [INDP STOP]", "X1", [("INDP", None), ("STOP", None)]),
        ("M17[JUMPS=2]", "M17", [("JUMPS", "2")]),
        ("X[INDP, PV1=3]", "X", [("INDP", None), ("PV1", "3")]),
        ("X[]", "X", []),
    ],
)
def test_bracket_commands_hold_keywords_in_their_order(
    text: str, name: str, items: list[tuple[str, str | None]]
) -> None:
    """``X[INDP …]`` and ``S2[…]``: keywords with or without values, = and blanks are free."""
    block = statement(text)
    assert isinstance(block, Block)
    (command,) = block.words
    assert isinstance(command, BracketCommand)
    assert command.name == name
    found = [
        (item.name, None if item.value is None else format_expression(item.value))
        for item in command.items
        if isinstance(item, Keyword)
    ]
    assert found == items


@pytest.mark.parametrize(
    ("text", "local", "name", "cycle", "keywords"),
    [
        ("L sub.nc", False, "sub.nc", False, []),
        ("LL UP1", True, "UP1", False, []),
        ("LM06", False, "M06", False, []),
        (r"L C:\a b", False, "C:\\a", False, []),
        ('L "a b.nc"', False, "a b.nc", False, []),
        ("L CYCLE [NAME=a.ecy @P1=2]", False, "a.ecy", True, ["@P1"]),
        (r"LL CYCLE[@P1=2 NAME = dir\a.ecy @P2=3]", True, r"dir\a.ecy", True, ["@P1", "@P2"]),
        ("LL cycle", True, "cycle", False, []),
    ],
)
def test_calls_have_a_name_and_keywords(
    text: str, local: bool, name: str, cycle: bool, keywords: list[str]
) -> None:
    """``L``, ``LL`` and ``L CYCLE`` with names as they are written."""
    call = statements(text)[0]
    assert isinstance(call, SubprogramCall)
    assert isinstance(call.name, StringLiteral)
    assert (call.local, call.name.value, call.cycle) == (local, name, cycle)
    assert [item.name for item in call.keywords] == keywords  # type: ignore[union-attr]


def test_a_call_may_be_among_other_words_and_take_its_name_from_a_variable() -> None:
    """``G0 X1 L V.P.NAME M5``: the other words stay with the call."""
    call = statement("G0 X1 L V.P.NAME M5")
    assert isinstance(call, SubprogramCall)
    assert isinstance(call.name, Variable)
    assert [format_word(word) for word in call.words] == ["G0", "X1", "M5"]


@pytest.mark.parametrize("operator", ["=", "+=", "-=", "*=", "/="])
@pytest.mark.parametrize("target", ["P1", "P[P1 + 1]", "@P1", "V.E.A[2].B", "Vs.CH.X"])
def test_assignments(target: str, operator: str) -> None:
    """RC-205: variables and parameters take =, +=, -=, *=, /=."""
    for blank in ("", " "):
        assignment = statement(f"{target}{blank}{operator}{blank}2 * 3")
        assert isinstance(assignment, Assignment)
        assert assignment.operator == operator
        assert format_expression(assignment.target) == target


def test_several_statements_in_one_line_are_statements_of_their_own() -> None:
    """The first of them has the block's head."""
    found = statements("N10 P1=5 P2 = P1+1 X10 Y2 V.L.A")
    assert [type(item) for item in found] == [Assignment, Assignment, Block, VariableBlock]
    assert isinstance(found[0].head.number, Number)
    assert all(item.head.number is None for item in found[1:])


def test_a_bare_variable_is_a_block() -> None:
    """RC-311: ``Vs.E.X`` alone."""
    block = statement("N60 Vs.E.LEVEL_1_A[0].REAL64 ; read")
    assert isinstance(block, VariableBlock)


def test_macros() -> None:
    """``"A" = "text"`` defines a macro, ``"A"`` in a block uses it."""
    definition = statement('"DRILL" = "G1 Z-10"')
    assert isinstance(definition, MacroDefinition)
    assert (definition.name, definition.text) == ("DRILL", "G1 Z-10")
    assert words('"DRILL"') == ['"DRILL"']


@pytest.mark.parametrize(
    ("text", "number", "skip", "label"),
    [
        ("X1", None, None, None),
        ("N10 X1", 10, None, None),
        ("/X1", None, 1, None),
        ("/ N10 X1", 10, 1, None),
        ("/10 N5 X1", 5, 10, None),
        ("N020: X1", 20, None, "N20"),
        ("N0:X1", 0, None, "N0"),
        ("[Label_1] X1", None, None, "LABEL_1"),
        ("N10 [a] X1", 10, None, "A"),
        ("N20:", 20, None, "N20"),
    ],
)
def test_heads(text: str, number: int | None, skip: int | None, label: str | None) -> None:
    """Skip level, block number and label come first; labels do not depend on case."""
    head = statement(text).head
    value = head.number.value if isinstance(head.number, Number) else None
    assert (value, head.skip, head.label) == (number, skip, label)
