# SPDX-License-Identifier: MIT
"""Random expressions in Structured Text, each with what it does in Python.

Each part is a text and a function of its variables: an evaluator that shares nothing
with the translation, written from the rules (ST-302 … 307, ST-501 … 520, ST-711 … 714).
"""

from __future__ import annotations

import math
import operator
import random
import struct
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

Env = dict[str, Any]
Value = Callable[[Env], Any]
SIZES = {8: ("SINT", "USINT", "BYTE"), 16: ("INT", "UINT", "WORD")}
SIZES |= {32: ("DINT", "UDINT", "DWORD"), 64: ("LINT", "ULINT", "LWORD")}
BITS = {name: bits for bits, names in SIZES.items() for name in names}
SIGNED = frozenset(names[0] for names in SIZES.values())
WORDS = frozenset(names[2] for names in SIZES.values())
INTS = tuple(BITS)
REALS = ("REAL", "LREAL")
TEXTS = {"s0": 20, "s1": 5, "s2": 80}
ELEMENTS = 5
CYCLES = 4


class Fault(Exception):
    """What stops a PLC: the number of its message."""


def cut(value: int, kind: str) -> int:
    """A number cut to the width of a type."""
    top = 1 << BITS[kind]
    value %= top
    return value - top if kind in SIGNED and value >= top // 2 else value


def wide(value: int, kind: str) -> int:
    """A number cut to 64 bits, signed as its type is (ST-302)."""
    return cut(value, "LINT" if kind in SIGNED else "ULINT")


def single(value: float) -> float:
    """A number rounded to REAL."""
    try:
        return float(struct.unpack("<f", struct.pack("<f", value))[0])
    except OverflowError:
        return float("inf") if value > 0 else float("-inf")


def valid(value: float) -> float:
    """A result; what is no number stops the PLC (ST-305)."""
    if math.isnan(value):
        raise Fault(902260)
    return value


def common(first: str, second: str) -> str:
    """The type of an operation of two whole numbers (ST-302, ST-303)."""
    names = SIZES[max(BITS[first], BITS[second])]
    if first in SIGNED or second in SIGNED:
        return names[0]
    return names[2] if first in WORDS and second in WORDS else names[1]


@dataclass
class Part:
    """An expression: its text, type, meaning; ``is_constant`` if it names no variable."""

    text: str
    kind: str
    value: Value
    is_constant: bool = False


@dataclass
class Unit:
    """A function or block: its variables by type, how it is declared, what it does."""

    name: str
    kind: str = ""
    variables: dict[str, str] = field(default_factory=dict)
    parameters: list[str] = field(default_factory=list)
    text: str = ""
    run: Callable[[Env], None] | None = None


def quotient(left: int, right: int) -> int:
    """A quotient cut towards zero."""
    if right == 0:
        raise Fault(902265)
    size = abs(left) // abs(right)
    return size if (left < 0) == (right < 0) else -size


def remainder(left: int, right: int) -> int:
    """A remainder with the sign of the dividend."""
    return left - right * quotient(left, right)


ARITHMETIC: dict[str, Callable[[int, int], int]] = {
    "+": operator.add, "-": operator.sub, "*": operator.mul, "AND": operator.and_,
    "OR": operator.or_, "XOR": operator.xor, "/": quotient, "MOD": remainder,
}  # fmt: skip
RELATIONS: dict[str, Callable[[Any, Any], bool]] = {
    "=": operator.eq, "<>": operator.ne, "<": operator.lt, "<=": operator.le, ">": operator.gt,
    ">=": operator.ge,
}  # fmt: skip


def moved(name: str, value: int, count: int, kind: str) -> int:
    """``SHL`` … ``ROR`` at the width of a type (ST-714)."""
    bits = BITS[kind]
    value %= 1 << bits
    if name in ("ROL", "ROR"):
        count %= bits
        count = count if name == "ROL" else -count % bits
        return cut(value << count | value >> (bits - count), kind)
    if not 0 <= count < bits:
        return 0
    return cut(value << count if name == "SHL" else value >> count, kind)


def rounded(value: float, kind: str) -> int:
    """A real number as a whole one: half away from zero; outside it stops the PLC (ST-307)."""
    low, high = (0, 1 << BITS[kind]) if kind not in SIGNED else (0, 0)
    if kind in SIGNED:
        low, high = -(1 << BITS[kind] - 1), 1 << BITS[kind] - 1
    if abs(value) == float("inf"):
        raise Fault(902270)
    size = int(abs(value))
    size += abs(value) - size >= 0.5
    whole = -size if value < 0 else size
    if not low <= whole < high:
        raise Fault(902270)
    return whole


class Expressions:
    """Draws expressions over the variables of a unit."""

    def __init__(self, draw: random.Random) -> None:
        self.draw = draw
        self.unit = Unit("")
        self.functions: list[Unit] = []

    def names(self, *kinds: str) -> list[str]:
        """The variables of some types."""
        return [name for name, kind in self.unit.variables.items() if kind in kinds]

    def variable(self, *kinds: str) -> Part:
        """A variable, or an element of the array."""
        if "DINT" in kinds and "a" in self.unit.variables and self.draw.random() < 0.3:
            return self.element()
        name = self.draw.choice(self.names(*kinds))
        return Part(name, self.unit.variables[name], lambda env: env[name])

    def element(self) -> Part:
        """An element of the array; rarely beyond its bounds."""
        index = self.index()

        def value(env: Env) -> int:
            number = index.value(env)
            if not 0 <= number < ELEMENTS:
                raise Fault(902266)
            found: int = env["a"][number]
            return found

        return Part(f"a[{index.text}]", "DINT", value)

    def index(self) -> Part:
        """An index that mostly fits."""
        inner = self.variable(*(kind for kind in INTS if kind != "DINT"))
        divisor = ELEMENTS if self.draw.random() < 0.98 else ELEMENTS + 1
        return Part(
            f"ABS(TO_LINT({inner.text})) MOD {divisor}",
            "LINT",
            lambda env: remainder(wide(abs(cut(inner.value(env), "LINT")), "LINT"), divisor),
        )

    def literal(self, kind: str) -> Part:
        """A typed literal of a whole number."""
        bits = BITS[kind]
        low, high = (-(1 << bits - 1), (1 << bits - 1) - 1) if kind in SIGNED else (0, 2**bits - 1)
        edges = [low, high, 0, 1, 7, 100, high // 2]
        number = self.draw.choice([*edges, self.draw.randint(low, high)])
        return Part(f"{kind}#{number}", kind, lambda env: number, True)

    def whole(self, depth: int) -> Part:
        """A whole number."""
        if depth <= 0:
            if self.draw.random() < 0.3:
                return self.literal(self.draw.choice(INTS))
            return self.variable(*INTS)
        makers = [
            self.binary, self.binary, self.binary, self.negated, self.inverted, self.shifted,
            self.converted, self.extreme, self.chosen_whole, self.of_text, self.called,
            self.of_real, self.absolute,
        ]  # fmt: skip
        return self.draw.choice(makers)(depth - 1)

    def binary(self, depth: int) -> Part:
        """An operation of two whole numbers."""
        left, right = self.whole(depth), self.whole(depth)
        if left.is_constant:
            left = self.variable(*INTS)
        sign = self.draw.choice(list(ARITHMETIC))
        if sign in ("/", "MOD"):
            right = self.divisor(right)
        kind = common(left.kind, right.kind)
        compute = ARITHMETIC[sign]

        def value(env: Env) -> int:
            first = wide(left.value(env), kind)
            return wide(compute(first, wide(right.value(env), kind)), kind)

        return Part(f"({left.text} {sign} {right.text})", kind, value)

    def divisor(self, part: Part) -> Part:
        """A divisor that is rarely zero: its lowest bit is set."""
        if part.is_constant or self.draw.random() < 0.02:
            part = self.variable(*INTS)
            if self.draw.random() < 0.1:
                return part
        one = f"{part.kind}#1"
        return Part(f"({part.text} OR {one})", part.kind, lambda env: part.value(env) | 1)

    def negated(self, depth: int) -> Part:
        """A minus: the signed type of that size."""
        inner = self.whole(depth)
        if inner.is_constant:
            return inner
        kind = SIZES[BITS[inner.kind]][0]
        return Part(f"(-{inner.text})", kind, lambda env: wide(-inner.value(env), kind))

    def inverted(self, depth: int) -> Part:
        """NOT at the width of the type."""
        inner = self.whole(depth)
        if inner.is_constant:
            return inner
        return Part(
            f"(NOT {inner.text})", inner.kind, lambda env: cut(-1 - inner.value(env), inner.kind)
        )

    def absolute(self, depth: int) -> Part:
        """``ABS``; the least number stays."""
        inner = self.whole(depth)
        return Part(
            f"ABS({inner.text})",
            inner.kind,
            lambda env: wide(abs(inner.value(env)), inner.kind),
            inner.is_constant,
        )

    def shifted(self, depth: int) -> Part:
        """Bits moved by a few, or by too many."""
        name = self.draw.choice(("SHL", "SHR", "ROL", "ROR"))
        inner, count = self.whole(depth), self.draw.choice((0, 1, 3, 7, 8, 15, 31, 63, 64, 70))
        kind = inner.kind
        return Part(
            f"{name}({inner.text}, {count})",
            kind,
            lambda env: moved(name, inner.value(env), count, kind),
        )

    def converted(self, depth: int) -> Part:
        """A conversion between whole numbers: the low bits."""
        inner, kind = self.whole(depth), self.draw.choice(INTS)
        return self.fitted(inner, kind)

    def extreme(self, depth: int) -> Part:
        """``MIN``, ``MAX`` or ``LIMIT``."""
        left, right = self.whole(depth), self.whole(depth)
        kind = common(left.kind, right.kind)
        name, choose = self.draw.choice((("MIN", min), ("MAX", max)))
        return Part(
            f"{name}({left.text}, {right.text})",
            kind,
            lambda env: choose(wide(left.value(env), kind), wide(right.value(env), kind)),
        )

    def chosen_whole(self, depth: int) -> Part:
        """``SEL``: only the chosen side is evaluated."""
        truth, kind = self.truth(depth), self.draw.choice(INTS)
        no, yes = (self.fitted(self.whole(depth), kind) for _ in range(2))
        return Part(
            f"SEL({truth.text}, {no.text}, {yes.text})",
            kind,
            lambda env: yes.value(env) if truth.value(env) else no.value(env),
        )

    def fitted(self, part: Part, kind: str) -> Part:
        """A whole number as one of a type."""
        return Part(
            f"TO_{kind}({part.text})",
            kind,
            lambda env: cut(part.value(env), kind),
            part.is_constant,
        )

    def of_text(self, depth: int) -> Part:
        """The length of a text, or where another one is in it."""
        text, other = self.text(depth), self.text(depth)
        if self.draw.random() < 0.5:
            return Part(f"LEN({text.text})", "INT", lambda env: len(text.value(env)))

        def value(env: Env) -> int:
            first, second = text.value(env), other.value(env)
            return first.find(second) + 1 if second else 0

        return Part(f"FIND({text.text}, {other.text})", "INT", value)

    def of_real(self, depth: int) -> Part:
        """A real number as a whole one; mostly a small one."""
        inner, kind = self.real(depth), self.draw.choice(("DINT", "INT", "LINT", "UDINT", "USINT"))
        if self.draw.random() < 0.9:
            return Part(
                f"TO_{kind}(LIMIT(0.0, {inner.text}, 99.75))",
                kind,
                lambda env: rounded(min(max(inner.value(env), 0.0), 99.75), kind),
            )
        return Part(f"TO_{kind}({inner.text})", kind, lambda env: rounded(inner.value(env), kind))

    def called(self, depth: int) -> Part:
        """A call of a function with values."""
        if not self.functions or self.unit in self.functions:
            return self.variable(*INTS)
        unit = self.draw.choice(self.functions)
        given = [self.fitted(self.whole(depth), unit.variables[one]) for one in unit.parameters]
        shown = ", ".join(part.text for part in given)

        def value(env: Env) -> Any:
            inner = fresh(unit)
            for name, part in zip(unit.parameters, given, strict=True):
                inner[name] = part.value(env)
            assert unit.run is not None
            unit.run(inner)
            return inner[unit.name]

        return Part(f"{unit.name}({shown})", unit.kind, value)

    # --- reals

    def real(self, depth: int) -> Part:
        """A real number."""
        if depth <= 0:
            if self.draw.random() < 0.3:
                number = self.draw.choice((0.5, 1.0, -2.25, 1e10, 0.0, 3.0))
                kind = self.draw.choice(REALS)
                return Part(f"{kind}#{number}", kind, lambda env: number, True)
            return self.variable(*REALS)
        pick = self.draw.random()
        if pick < 0.15:
            inner = self.whole(depth - 1)
            return Part(
                f"TO_LREAL({inner.text})",
                "LREAL",
                lambda env: float(inner.value(env)),
                inner.is_constant,
            )
        if pick < 0.25:
            part = self.real(depth - 1)
            return Part(
                f"ABS({part.text})", part.kind, lambda env: abs(part.value(env)), part.is_constant
            )
        return self.real_operation(depth - 1)

    def real_operation(self, depth: int) -> Part:
        """An operation of two real numbers; REAL is rounded after it (ST-304)."""
        left, right = self.real(depth), self.real(depth)
        if left.is_constant:
            left = self.variable(*REALS)
        sign = self.draw.choice("+-*/")
        if sign == "/" and (right.is_constant or self.draw.random() < 0.98):
            right = self.real_divisor(right)
        kind = "LREAL" if "LREAL" in (left.kind, right.kind) else "REAL"
        compute = {"+": operator.add, "-": operator.sub, "*": operator.mul}.get(sign)

        def value(env: Env) -> float:
            first, second = left.value(env), right.value(env)
            if compute is None:
                if second == 0.0:
                    raise Fault(902265)
                result = first / second
            else:
                result = compute(first, second)
            valid(result)
            return single(result) if kind == "REAL" else result

        return Part(f"({left.text} {sign} {right.text})", kind, value)

    def real_divisor(self, part: Part) -> Part:
        """A divisor that is not zero."""
        inner = self.variable(*REALS) if part.is_constant else part
        rounding = single if inner.kind == "REAL" else float
        return Part(
            f"(ABS({inner.text}) + {inner.kind}#1.0)",
            inner.kind,
            lambda env: rounding(abs(inner.value(env)) + 1.0),
        )

    # --- truths and texts

    def truth(self, depth: int) -> Part:
        """A truth."""
        if depth <= 0:
            return self.variable("BOOL")
        pick = self.draw.random()
        if pick < 0.35:
            return self.relation(self.whole(depth - 1), self.whole(depth - 1))
        if pick < 0.5:
            return self.relation(self.real(depth - 1), self.real(depth - 1))
        if pick < 0.6:
            return self.relation(self.text(depth - 1), self.text(depth - 1))
        if pick < 0.7:
            part = self.variable(*(kind for kind in INTS if kind != "DINT"))
            bit = self.draw.randrange(BITS[part.kind])
            return Part(f"{part.text}.{bit}", "BOOL", lambda env: bool(part.value(env) >> bit & 1))
        if pick < 0.8:
            inner = self.truth(depth - 1)
            return Part(f"(NOT {inner.text})", "BOOL", lambda env: not inner.value(env))
        return self.logical(depth - 1)

    def relation(self, left: Part, right: Part) -> Part:
        """A comparison of values (ST-303)."""
        if left.is_constant and right.is_constant:
            return self.variable("BOOL")
        sign = self.draw.choice(list(RELATIONS))
        compare = RELATIONS[sign]
        return Part(
            f"({left.text} {sign} {right.text})",
            "BOOL",
            lambda env: compare(left.value(env), right.value(env)),
        )

    def logical(self, depth: int) -> Part:
        """A connective; AND_THEN and OR_ELSE stop early (ST-502)."""
        left, right = self.truth(depth), self.truth(depth)
        sign = self.draw.choice(("AND", "OR", "XOR", "AND_THEN", "OR_ELSE"))

        def value(env: Env) -> bool:
            first: bool = left.value(env)
            if (sign == "AND_THEN" and not first) or (sign == "OR_ELSE" and first):
                return first
            second: bool = right.value(env)
            if sign == "XOR":
                return first is not second
            return first and second if sign.startswith("AND") else first or second

        return Part(f"({left.text} {sign} {right.text})", "BOOL", value)

    def text(self, depth: int) -> Part:
        """A text."""
        if depth <= 0:
            if self.draw.random() < 0.4 or not self.names("TEXT"):
                letters = "".join(
                    self.draw.choice("abäz 01") for _ in range(self.draw.randint(0, 6))
                )
                return Part(f"'{letters}'", "TEXT", lambda env: letters, True)
            return self.variable("TEXT")
        first = self.text(depth - 1)
        number, count = (self.fitted(self.whole(depth - 1), "INT") for _ in range(2))
        match self.draw.randrange(5):
            case 0:
                other = self.text(depth - 1)
                return Part(
                    f"CONCAT({first.text}, {other.text})",
                    "TEXT",
                    lambda env: (first.value(env)[:255] + other.value(env))[:255],
                )
            case 1:
                return Part(
                    f"LEFT({first.text}, {count.text})",
                    "TEXT",
                    lambda env: first.value(env)[: max(count.value(env), 0)],
                )
            case 2:
                return Part(
                    f"MID({first.text}, {count.text}, {number.text})",
                    "TEXT",
                    lambda env: part_of(first.value(env), count.value(env), number.value(env)),
                )
            case 3:
                return Part(
                    f"DELETE({first.text}, {count.text}, {number.text})",
                    "TEXT",
                    lambda env: without(first.value(env), count.value(env), number.value(env)),
                )
        return Part(f"TO_STRING({number.text})", "TEXT", lambda env: str(number.value(env)))


def part_of(text: str, count: int, position: int) -> str:
    """``MID``: positions from 1 (ST-711)."""
    first = max(position, 1) - 1
    return text[first : first + max(count, 0)]


def without(text: str, count: int, position: int) -> str:
    """``DELETE``."""
    first = max(position, 1) - 1
    return text[:first] + text[first + max(count, 0) :]


def fresh(unit: Unit) -> Env:
    """The variables of a unit as they begin."""
    zero = {"BOOL": False, "TEXT": "", "REAL": 0.0, "LREAL": 0.0}
    env: Env = {name: zero.get(kind, 0) for name, kind in unit.variables.items()}
    if "a" in env:
        env["a"] = [0] * ELEMENTS
    return env
