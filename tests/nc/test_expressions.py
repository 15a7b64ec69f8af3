# SPDX-License-Identifier: MIT
"""Expressions: precedence, brackets, operands, limits."""

from __future__ import annotations

import pytest
from support.nc_trees import expression, grouped, numbers, shape

from nctakt.nc.parse.expressions import EXPRESSION_DEPTH
from nctakt.nc.tree import (
    ArrayLiteral,
    Constant,
    Name,
    Number,
    Parameter,
    StringLiteral,
    Variable,
)
from nctakt.nc.vocabulary.operators import FUNCTIONS, INFIX, PREFIX


@pytest.mark.parametrize(
    ("text", "meaning"),
    [
        ("1 + 2 * 3", "(1 + (2 * 3))"),
        ("1 - 2 - 3", "((1 - 2) - 3)"),
        ("8 / 4 / 2", "((8 / 4) / 2)"),
        ("11 MOD 3 * 2", "((11 MOD 3) * 2)"),
        ("2 ** 3 ** 2", "(2 ** (3 ** 2))"),
        ("-2 ** 2", "(- (2 ** 2))"),
        ("2 ** -1 ** 2", "(2 ** (- (1 ** 2)))"),
        ("2 ** -1 * 3", "((2 ** -1) * 3)"),
        ("NOT 1 == 2", "((NOT 1) == 2)"),
        ("NOT[1 == 2]", "(NOT (1 == 2))"),
        ("NOT NOT 1", "(NOT (NOT 1))"),
        ("1 + 2 < 3 & 4 == 4", "(((1 + 2) < 3) & (4 == 4))"),
        ("1 | 2 ^ 3 & 4", "(1 | (2 ^ (3 & 4)))"),
        ("1 | 2 && 3 | 4", "((1 | 2) && (3 | 4))"),
        ("1 || 2 XOR 3 && 4", "(1 || (2 XOR (3 && 4)))"),
        ("1 && 2 XOR 3 || 4", "(((1 && 2) XOR 3) || 4)"),
        ("[1 + 2] * 3", "((1 + 2) * 3)"),
        ("7 * 5 < 12 * SIN[30]", "((7 * 5) < (12 * SIN(30)))"),
        ("sqrt [ 33 ]", "SQRT(33)"),
        ("ATAN2[1, 2 + 3]", "ATAN2(1, (2 + 3))"),
        ("1 - -2", "(1 - -2)"),
        ("- - 2", "2"),
        ("+2", "2"),
        ("1+-+2", "(1 + -2)"),
        ("11mod3", "(11 MOD 3)"),
        ("5 xor 3", "(5 XOR 3)"),
        (".5 + 1.", "(0.5 + 1)"),
    ],
)
def test_operators_bind_by_the_table_of_rc_206(text: str, meaning: str) -> None:
    """RC-206: precedence from ``**`` down to ``||``; binary left, ``**`` right associative."""
    assert grouped(expression(text)) == meaning


def test_each_infix_operator_binds_stronger_than_the_next_of_the_table() -> None:
    """RC-206: for each pair of operators the precedence of the table decides."""
    for first, left in INFIX.items():
        for second, right in INFIX.items():
            text = grouped(expression(f"1 {first} 2 {second} 3"))
            together = left.precedence > right.precedence or (
                left.precedence == right.precedence and not left.right_associative
            )
            expected = f"((1 {first} 2) {second} 3)" if together else f"(1 {first} (2 {second} 3))"
            assert text == expected


def test_the_table_has_what_the_language_has() -> None:
    """The functions and operators of the manual's list are in the table, with arity and texts."""
    assert set(PREFIX) == {"-", "NOT"}
    assert len(INFIX) == 18
    assert FUNCTIONS["ATAN2"].minimum == 2
    assert FUNCTIONS["EXIST"].decoder_only
    for function in FUNCTIONS.values():
        assert 1 <= function.minimum <= function.maximum
        assert function.meaning.en
        assert function.meaning.de


def test_a_sign_before_a_number_is_part_of_it() -> None:
    """A negative constant is one node, so it costs no instruction (RC-501)."""
    value = expression("-2.5")
    assert isinstance(value, Number)
    assert value.value == -2.5
    assert (value.span.column, value.span.end_column) == (6, 10)


@pytest.mark.parametrize("text", ["TRUE", "true", "False", "PI", "pi"])
def test_constants_do_not_depend_on_case(text: str) -> None:
    """``TRUE``, ``FALSE`` and ``PI`` are constants in any case."""
    value = expression(text)
    assert isinstance(value, Constant)
    assert value.name == text.upper()


def test_variables_keep_their_path_with_indices_and_synchronisation() -> None:
    """``Vs.`` forces synchronous access; each part of the path keeps its indices."""
    value = expression("Vs.e.Outer[1][P2].inner_2")
    assert isinstance(value, Variable)
    assert (value.family, value.synchronous) == ("E", True)
    assert [(part.name, len(part.indices)) for part in value.parts] == [
        ("Outer", 2),
        ("inner_2", 0),
    ]
    assert [part.span.column for part in value.parts] == [11, 24]


def test_a_sign_may_begin_a_part_of_a_name() -> None:
    """``V.A.+SWE_MDS.Z``: a sign inside a name."""
    value = expression("V.A.+SWE_MDS.Z-1")
    assert shape(value)[1] == ("operator", "-")
    variable = value.left  # type: ignore[attr-defined]
    assert [part.name for part in variable.parts] == ["+SWE_MDS", "Z"]


def test_parameters_have_a_number_or_an_expression() -> None:
    """``P1``, ``P[P1+1]``, and ``@P1`` for parameters of a call."""
    for text, call in (("P12", False), ("P[P1+1]", False), ("@P3", True), ("p7", False)):
        value = expression(text)
        assert isinstance(value, Parameter)
        assert value.call is call


def test_texts_names_and_lists_are_values() -> None:
    """Texts between quotes, bare words and lists may be assigned."""
    assert isinstance(expression('"a; b (c) // d"'), StringLiteral)
    name = expression("report.txt")
    assert isinstance(name, Name)
    assert (name.name, name.text) == ("REPORT.TXT", "report.txt")
    values = expression("[1, [2, 3], 4]")
    assert isinstance(values, ArrayLiteral)
    assert len(values.items) == 3


@pytest.mark.parametrize("depth", [EXPRESSION_DEPTH - 1, EXPRESSION_DEPTH])
@pytest.mark.parametrize(
    ("before", "inner", "after"),
    [("[", "1", "]"), ("SIN[", "1", "]"), ("1 + [", "1", "]"), ("V.E.A[", "1", "]")],
)
def test_expressions_nest_up_to_the_limit(before: str, inner: str, after: str, depth: int) -> None:
    """Brackets, functions and indices may be nested up to the named limit."""
    depth = depth if before == "[" else depth - 1
    assert numbers(f"P1 = {before * depth}{inner}{after * depth}") == []


@pytest.mark.parametrize(
    "text",
    [
        "[" * (EXPRESSION_DEPTH + 1) + "1" + "]" * (EXPRESSION_DEPTH + 1),
        "SIN[" * EXPRESSION_DEPTH + "1" + "]" * EXPRESSION_DEPTH,
        "V.E.A[" * EXPRESSION_DEPTH + "1" + "]" * EXPRESSION_DEPTH,
        "P[" * EXPRESSION_DEPTH + "1" + "]" * EXPRESSION_DEPTH,
        "1 " + "+ 1 " * EXPRESSION_DEPTH,
        "1 " + "** 1 " * EXPRESSION_DEPTH,
        "NOT " * EXPRESSION_DEPTH + "1",
        "-" * EXPRESSION_DEPTH + "P1",
        "[1, " * (EXPRESSION_DEPTH + 1) + "1" + "]" * (EXPRESSION_DEPTH + 1),
        "[" * 1900 + "1" + "]" * 1900,
        "1" + "+1" * 1900,
    ],
)
def test_an_expression_beyond_the_limit_is_50861(text: str) -> None:
    """20386: neither brackets nor chains of operators make a tree higher than the limit."""
    assert numbers(f"P1 = {text}") == [20386]


def test_a_chain_of_operators_may_have_as_many_operands_as_the_limit() -> None:
    """A sum is as high as it has operators; the limit counts its nodes."""
    assert numbers("P1 = 1" + "+1" * (EXPRESSION_DEPTH - 1)) == []


def test_a_number_beyond_float64_is_reported() -> None:
    """900119: a literal that no float64 holds, wherever it is."""
    digits = "9" * 400
    assert numbers(f"P1 = {digits}") == [900119]
    assert numbers(f"G0 X{digits}") == [900119]
    assert numbers(f"N{digits} G0") == [900119]
    assert numbers(f"P{digits} = 1") == [900119]


def test_brackets_of_keywords_nest_up_to_the_limit() -> None:
    """20386 also for keywords with their own brackets."""
    limit = EXPRESSION_DEPTH
    assert numbers("#FOO " + "[A" * limit + "]" * limit) == []
    assert numbers("#FOO " + "[A" * (limit + 2) + "]" * (limit + 2)) == [20386]
