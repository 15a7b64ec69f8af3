# SPDX-License-Identifier: MIT
"""Random expressions: cycle, decoder and an evaluator of this file's own agree (RC-206, RC-207).

An expression is made as a tree and written with as few brackets as the table of RC-206 allows, so
that a wrong precedence gives another value.
"""

from __future__ import annotations

import math
import random
from dataclasses import dataclass

import pytest
from support.random_seeds import each_seed

from nctakt.run.controller import Controller, NcText

#: From strong to weak; ``**`` associates right, the others left.
LEVELS = (
    ("**",),
    ("sign",),
    ("*", "/", "MOD"),
    ("+", "-"),
    ("==", "!=", "<", "<=", ">", ">="),
    ("&",),
    ("^",),
    ("|",),
    ("&&",),
    ("XOR",),
    ("||",),
)
RANK = {name: len(LEVELS) - index for index, level in enumerate(LEVELS) for name in level}
FUNCTIONS = ("ABS", "SQR", "SQRT", "SIN", "COS", "INT", "ROUND", "CEIL", "FLOOR", "LN", "ASIN")
VALUES = {"VALUE": 2.5, "VALUE2": -3.0, "COUNT": 4.0, "TRIGGER": 0.0, "CONDITION": 1.0}


@dataclass(frozen=True, slots=True)
class Node:
    """An operator or function with its operands, a number or a variable with none."""

    name: str
    operands: tuple[Node, ...] = ()


class FaultError(Exception):
    """There is no such value."""


def tree(chance: random.Random, depth: int) -> Node:
    """A random expression."""
    kind = chance.random()
    if depth == 0 or kind < 0.15:
        return Node(chance.choice(("0", "1", "2", "3", "7", "0.5", "1.5", *VALUES)))
    if kind < 0.25:
        return Node(chance.choice(FUNCTIONS), (tree(chance, depth - 1),))
    if kind < 0.35:
        return Node(chance.choice(("sign", "NOT")), (tree(chance, depth - 1),))
    operator = chance.choice([name for level in LEVELS for name in level if name != "sign"])
    return Node(operator, (tree(chance, depth - 1), tree(chance, depth - 1)))


def written(node: Node, variable: str) -> str:
    """The text, with brackets where RC-206 needs them; ``variable`` is how values are named."""
    if not node.operands:
        return variable.format(node.name) if node.name in VALUES else node.name
    if node.name in FUNCTIONS:
        return f"{node.name}[{written(node.operands[0], variable)}]"
    if node.name in ("sign", "NOT"):
        inside = bracketed(node.operands[0], RANK["sign"], variable)
        return f"{'-' if node.name == 'sign' else 'NOT'} {inside}"
    rank, right = RANK[node.name], node.name == "**"
    left_text = bracketed(node.operands[0], rank + right, variable)
    right_text = bracketed(node.operands[1], rank + (not right), variable)
    return f"{left_text} {node.name} {right_text}"


def bracketed(node: Node, rank: int, variable: str) -> str:
    """The text of an operand that has to bind at least as strong as ``rank``."""
    text = written(node, variable)
    own = RANK["sign"] if node.name == "NOT" else RANK.get(node.name, len(LEVELS) + 1)
    return text if own >= rank or not node.operands else f"[{text}]"


def true(value: float) -> bool:
    """RC-202."""
    return abs(value) >= 0.5


def apply(name: str, x: float) -> float:
    """The value of a function or of an operator with one operand."""
    if (name == "SQRT" and x < 0) or (name == "LN" and x <= 0) or (name == "ASIN" and abs(x) > 1):
        raise FaultError
    match name:
        case "sign":
            return -x
        case "NOT":
            return float(not true(x))
        case "SQR":
            return x * x
        case "SIN":
            return math.sin(math.radians(x))
        case "COS":
            return math.cos(math.radians(x))
        case "ASIN":
            return math.degrees(math.asin(x))
        case "INT":
            return float(math.trunc(x))
        case "LN":
            return math.log(x)
        case "SQRT":
            return math.sqrt(x)
        case "ABS":
            return abs(x)
    return float({"ROUND": round, "CEIL": math.ceil, "FLOOR": math.floor}[name](x))


def combine(name: str, x: float, y: float) -> float:
    """The value of an operator with two operands."""
    if (name in ("/", "MOD") and y == 0) or (name == "**" and x == 0 and y < 0):
        raise FaultError
    if name == "**" and x < 0 and y != math.floor(y):
        raise FaultError
    match name:
        case "+":
            return x + y
        case "-":
            return x - y
        case "*":
            return x * y
        case "/":
            return x / y
        case "MOD":
            return math.fmod(x, y)
        case "**":
            return math.pow(x, y)
        case "&":
            return float(round(x) & round(y))
        case "|":
            return float(round(x) | round(y))
        case "^":
            return float(round(x) ^ round(y))
        case "&&":
            return float(true(x) and true(y))
        case "||":
            return float(true(x) or true(y))
        case "XOR":
            return float(true(x) != true(y))
    holds = {"==": x == y, "!=": x != y, "<": x < y, "<=": x <= y, ">": x > y, ">=": x >= y}
    return float(holds[name])


def value(node: Node) -> float:
    """What the expression is, by the rules; both sides of each operator are evaluated."""
    if not node.operands:
        return VALUES[node.name] if node.name in VALUES else float(node.name)
    operands = [value(operand) for operand in node.operands]
    result = apply(node.name, *operands) if len(operands) == 1 else combine(node.name, *operands)
    # near a step of ROUND or of a comparison two correct sines may differ
    if abs(result) > 1e9 or (node.name in ("SIN", "COS", "LN", "ASIN", "**", "/", "MOD")):
        result = guarded(result)
    return result


class UnclearError(Exception):
    """A value that two correct evaluators may see differently."""


def guarded(result: float) -> float:
    """The value, if it is not near a half, nor large."""
    doubled = result * 2
    if abs(result) > 1e9 or (doubled != round(doubled) and abs(doubled - round(doubled)) < 1e-6):
        raise UnclearError
    return result


@each_seed(40, 12)
def test_cycle_decoder_and_evaluator_agree(seed: int) -> None:
    """RC-206, RC-207: the value, or that there is none."""
    chance = random.Random(seed)
    node = tree(chance, 4)
    expected: float | None
    try:
        expected = value(node)
    except FaultError:
        expected = None
    except (UnclearError, OverflowError):
        return
    cycle = f"#RT CYCLE [ID = 1]\nV.E.VALUE1 = {written(node, 'V.E.{}')}\n#RT CYCLE END\nM30"
    names = {name: f"P{number}" for number, name in enumerate(VALUES, 1)}
    lines = [f"{names[name]} = {number}" for name, number in VALUES.items()]
    text = written(node, "<{}>")
    for name, parameter in names.items():
        text = text.replace(f"<{name}>", parameter)
    program = "\n".join([*lines, f'#MSG ["%.12g", {text}]', "M30"])
    initial = {f"V.E.{name}": number for name, number in VALUES.items()}
    in_cycle = Controller().run(NcText("c.nc", cycle), set=initial, signals=["V.E.VALUE1"])
    in_program = Controller().run(NcText("p.nc", program))
    if expected is None:
        assert [error.id for error in in_cycle.errors] == [50879], cycle
        assert in_program.errors, program
        return
    assert in_cycle.errors == in_program.errors == (), cycle
    assert in_cycle.trace is not None
    assert in_cycle.trace.at(0, "V.E.VALUE1") == pytest.approx(expected, rel=1e-9, abs=1e-9), cycle
    reported = float(in_program.messages[0].text)
    assert reported == pytest.approx(expected, rel=1e-9, abs=1e-9), program
