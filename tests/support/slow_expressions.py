# SPDX-License-Identifier: MIT
"""Expressions as trees of tuples: how they are written, what they are worth, what they cost.

The second opinion on RC-202, RC-206, RC-207 and RC-501: slow, obvious, and ignorant of how nctakt
parses, folds and fuses. Only the functions of angles, roots and logarithms are shared with it; they
have their own tests.

A tree is ``("number", text)``, ``("list", index tree)``, ``("frozen", k)``, ``("unary", op, a)``,
``("binary", op, a, b)`` or ``("call", name, a, …)``.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from hypothesis import strategies as st

from nctakt.kernel.base import arithmetic

Tree = tuple[Any, ...]

#: RC-206: how strongly operators bind; one number, one rank.
PRECEDENCE = {
    "**": 12,
    "*": 10,
    "/": 10,
    "MOD": 10,
    "+": 9,
    "-": 9,
    "==": 8,
    "!=": 8,
    ">=": 8,
    "<=": 8,
    "<": 8,
    ">": 8,
    "&": 7,
    "^": 6,
    "|": 5,
    "&&": 4,
    "XOR": 3,
    "||": 2,
}
UNARY_PRECEDENCE = 11
LEAF_PRECEDENCE = 99

FUNCTIONS = {
    "ABS": abs,
    "SQR": lambda a: a * a,
    "SQRT": arithmetic.square_root,
    "EXP": arithmetic.exponential,
    "LN": arithmetic.natural_logarithm,
    "DEXP": arithmetic.decimal_exponential,
    "LOG": arithmetic.decimal_logarithm,
    "SIN": arithmetic.sine,
    "COS": arithmetic.cosine,
    "TAN": arithmetic.tangent,
    "COT": arithmetic.cotangent,
    "ASIN": arithmetic.arc_sine,
    "ACOS": arithmetic.arc_cosine,
    "ATAN": arithmetic.arc_tangent,
    "ACOT": arithmetic.arc_cotangent,
    "INT": arithmetic.truncate,
    "FRACT": arithmetic.fraction,
    "ROUND": arithmetic.round_half_even,
    "CEIL": arithmetic.ceiling,
    "FLOOR": arithmetic.floor,
    "INV": arithmetic.bit_invert,
}

#: Functions that have no result for some operands; others pass on what is not finite.
PARTIAL = ("SQRT", "EXP", "LN", "DEXP", "LOG", "SIN", "COS", "TAN", "COT", "ASIN", "ACOS", "INV")


class FaultError(Exception):
    """An operation without result; ``operation`` is its symbol, ``=`` for what is not finite."""

    def __init__(self, operation: str) -> None:
        super().__init__(operation)
        self.operation = operation


def value_of(tree: Tree, numbers: Sequence[float]) -> float:
    """What a tree is worth; ``numbers`` are the elements of the list. Raises ``FaultError``."""
    match tree:
        case ("number", text):
            return float(text)
        case ("frozen", k):
            return numbers[k]
        case ("list", index):
            return numbers[round(value_of(index, numbers))]
        case ("unary", "-", a):
            return 0.0 - value_of(a, numbers)
        case ("unary", "NOT", a):
            return 0.0 if abs(value_of(a, numbers)) >= 0.5 else 1.0
        case ("call", "ATAN2", a, b):
            y, x = value_of(a, numbers), value_of(b, numbers)
            return checked(arithmetic.arc_tangent_2(y, x), "ATAN2")
        case ("call", name, a):
            result = FUNCTIONS[name](value_of(a, numbers))
            return checked(result, name) if name in PARTIAL else result
        case ("binary", operator, a, b):
            return binary(operator, value_of(a, numbers), value_of(b, numbers))
    raise AssertionError(tree)


def checked(result: float, operation: str) -> float:
    """A result that is not NaN."""
    if math.isnan(result):
        raise FaultError(operation)
    return result


def binary(operator: str, left: float, right: float) -> float:
    """``left operator right``."""
    truth = (abs(left) >= 0.5, abs(right) >= 0.5)
    match operator:
        case "+":
            return left + right
        case "-":
            return left - right
        case "*":
            return left * right
        case "/":
            return checked(arithmetic.divide(left, right), operator)
        case "MOD":
            return checked(arithmetic.modulo(left, right), operator)
        case "**":
            return checked(arithmetic.power(left, right), operator)
        case "==":
            return float(left == right)
        case "!=":
            return float(left != right)
        case "<":
            return float(left < right)
        case "<=":
            return float(left <= right)
        case ">":
            return float(left > right)
        case ">=":
            return float(left >= right)
        case "&&":
            return float(truth[0] and truth[1])
        case "||":
            return float(truth[0] or truth[1])
        case "XOR":
            return float(truth[0] is not truth[1])
    if not (abs(left) < 2**53 and abs(right) < 2**53):
        raise FaultError(operator)
    a, b = round(left), round(right)
    return float({"&": a & b, "|": a | b, "^": a ^ b}[operator])


def result_of(tree: Tree, numbers: Sequence[float]) -> float:
    """``value_of`` where the value is used: it must be finite."""
    value = value_of(tree, numbers)
    if not math.isfinite(value):
        raise FaultError("=")
    return value


def cost_of(tree: Tree) -> int:
    """RC-501: each operator, function and variable access is one, numbers are free, -5 too."""
    if is_number(tree):
        return 0
    match tree:
        case ("frozen", _):
            return 1
        case ("list", index):
            return 1 + cost_of(index)
        case ("unary", _, a):
            return 1 + cost_of(a)
        case ("call", _, *arguments):
            return 1 + sum(map(cost_of, arguments))
        case ("binary", _, a, b):
            return 1 + cost_of(a) + cost_of(b)
    raise AssertionError(tree)


def is_number(tree: Tree) -> bool:
    """Whether a tree is a number as it is written, with its signs."""
    return tree[0] == "number" or (tree[:2] == ("unary", "-") and is_number(tree[2]))


# --- text ---------------------------------------------------------------------------------------


def text_of(tree: Tree) -> str:
    """The tree as NC text, with no more brackets than precedence asks for."""
    match tree:
        case ("number", text):
            return text
        case ("frozen", k):
            return f"P{k + 1}"
        case ("list", index):
            return f"V.E.LIST[{text_of(index)}]"
        case ("unary", operator, a):
            return f"{operator} {bracketed(a, UNARY_PRECEDENCE)}"
        case ("call", name, *arguments):
            return f"{name}[{', '.join(map(text_of, arguments))}]"
        case ("binary", operator, a, b):
            rank = PRECEDENCE[operator]
            associates_right = operator == "**"
            left = bracketed(a, rank + 1 if associates_right else rank)
            if b[0] == "unary":
                return f"{left} {operator} {text_of(b)}"
            return f"{left} {operator} {bracketed(b, rank if associates_right else rank + 1)}"
    raise AssertionError(tree)


def bracketed(tree: Tree, minimum: int) -> str:
    """The text, in brackets where its operator binds weaker than ``least``."""
    return f"[{text_of(tree)}]" if rank_of(tree) < minimum else text_of(tree)


def rank_of(tree: Tree) -> int:
    """How strongly the outermost operator binds."""
    if tree[0] == "binary":
        return PRECEDENCE[tree[1]]
    return UNARY_PRECEDENCE if tree[0] == "unary" else LEAF_PRECEDENCE


# --- random trees -------------------------------------------------------------------------------

NUMBERS = 10

texts = st.one_of(
    st.integers(0, 12).map(str),
    st.sampled_from(["0.5", "0.49", "30", "45", "90", "180", "1.5", "2.5", "1000000", ".25", "3."]),
    st.decimals(0, 1000, places=3).map(lambda number: f"{number:f}"),
)
number_leaves = texts.map(lambda text: ("number", text))
list_leaves = st.integers(0, NUMBERS - 1).map(lambda k: ("list", ("number", str(k))))
frozen_leaves = st.integers(0, NUMBERS - 1).map(lambda k: ("frozen", k))


def element(leaf: Tree) -> Tree:
    """An element whose index is computed from a leaf and never outside the list."""
    whole = ("call", "ABS", ("call", "INT", leaf))
    return ("list", ("binary", "MOD", whole, ("number", str(NUMBERS))))


def trees(leaves: st.SearchStrategy[Tree], size: int = 12) -> st.SearchStrategy[Tree]:
    """Random expressions over these leaves."""

    def extend(inner: st.SearchStrategy[Tree]) -> st.SearchStrategy[Tree]:
        return st.one_of(
            st.tuples(st.just("binary"), st.sampled_from(sorted(PRECEDENCE)), inner, inner),
            st.tuples(st.just("unary"), st.sampled_from(["-", "NOT"]), inner),
            st.tuples(st.just("call"), st.sampled_from(sorted(FUNCTIONS)), inner),
            st.tuples(st.just("call"), st.just("ATAN2"), inner, inner),
        )

    return st.recursive(leaves, extend, max_leaves=size)


synchronous_leaves = st.one_of(list_leaves, number_leaves, list_leaves.map(element))
all_leaves = st.one_of(synchronous_leaves, frozen_leaves)

values = st.lists(
    st.one_of(
        st.floats(allow_nan=False, allow_infinity=False),
        st.floats(-1000, 1000),
        st.integers(-20, 20).map(float),
        st.sampled_from([0.5, -0.5, 1e300, -1e300, 1e-300, 9007199254740992.0, 2.5, 90.0]),
    ),
    min_size=NUMBERS,
    max_size=NUMBERS,
)
