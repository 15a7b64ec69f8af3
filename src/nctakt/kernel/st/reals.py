# SPDX-License-Identifier: MIT
"""Real numbers: trees of objects that compute in double; REAL is rounded (ST-304, ST-305).

``number(context)`` answers a double. A division by zero and an invalid operation are faults, unless
the task has its floating-point exceptions off: then infinite, or not a number, as IEEE 754 says.
"""

from __future__ import annotations

from nctakt.kernel.base import arithmetic
from nctakt.kernel.base.bounds import check_range
from nctakt.kernel.st import functions, kinds, leaves, real_leaves, words
from nctakt.kernel.st.context import PlcContext
from nctakt.kernel.st.wholes import Whole


class Real:
    """Base of all nodes with a real value, and null object: zero."""

    def number(self, context: PlcContext) -> float:
        """Evaluate the node."""
        return 0.0

    def measure(self, context: PlcContext) -> float:
        """Evaluate the node for Python's side."""
        return self.number(context)


class RealConstant(Real):
    """A number that is known before the run."""

    def __init__(self, constant: float) -> None:
        self.leaf = kinds.CONSTANT
        self.constant = constant

    def number(self, context: PlcContext) -> float:
        return self.constant


class LoadRealFixed(Real):
    """A variable of data at a fixed address before ``end``."""

    def __init__(self, at: int, kind: int, end: int) -> None:
        check_range(at, kinds.NULL_BYTES, end, "address")
        self.leaf = kinds.IN_DATA
        self.offset = at
        self.kind = kind

    def number(self, context: PlcContext) -> float:
        return words.load_real(context.memory, self.offset, self.kind)


class LoadRealFrame(Real):
    """A variable of the running routine."""

    def __init__(self, offset: int, kind: int) -> None:
        check_range(offset, 0, kinds.SLACK - 8, "offset")
        self.leaf = kinds.IN_FRAME
        self.offset = offset
        self.kind = kind

    def number(self, context: PlcContext) -> float:
        return words.load_real(context.memory, context.frame + self.offset, self.kind)


class LoadRealInstance(Real):
    """A variable of the block that is called."""

    def __init__(self, offset: int, kind: int) -> None:
        check_range(offset, 0, kinds.SLACK - 8, "offset")
        self.leaf = kinds.IN_INSTANCE
        self.offset = offset
        self.kind = kind

    def number(self, context: PlcContext) -> float:
        return words.load_real(context.memory, context.instance + self.offset, self.kind)


class LoadRealAt(Real):
    """A variable ``offset`` bytes past a computed address."""

    def __init__(self, address: Whole, offset: int, kind: int) -> None:
        check_range(offset, 0, kinds.MAX_MEMORY, "offset")
        self.address = address
        self.offset = offset
        self.kind = kind

    def number(self, context: PlcContext) -> float:
        at = leaves.place_of(self.address, context) + self.offset
        if at < kinds.NULL_BYTES or at > context.end:
            context.fail(kinds.PLACE, at, 0)
            return 0.0
        return words.load_real(context.memory, at, self.kind)


class UnaryReal(Real):
    """Base of a node with one operand."""

    def __init__(self, operand: Real) -> None:
        self.operand = operand


class BinaryReal(Real):
    """Base of a node with two operands."""

    def __init__(self, left: Real, right: Real) -> None:
        self.left = left
        self.right = right


class AddReal(BinaryReal):
    """``+``."""

    def number(self, context: PlcContext) -> float:
        left = real_leaves.number_of(self.left, context)
        return real_leaves.valid(context, left + real_leaves.number_of(self.right, context))


class SubtractReal(BinaryReal):
    """``-``."""

    def number(self, context: PlcContext) -> float:
        left = real_leaves.number_of(self.left, context)
        return real_leaves.valid(context, left - real_leaves.number_of(self.right, context))


class MultiplyReal(BinaryReal):
    """``*``."""

    def number(self, context: PlcContext) -> float:
        left = real_leaves.number_of(self.left, context)
        return real_leaves.valid(context, left * real_leaves.number_of(self.right, context))


class DivideReal(BinaryReal):
    """``/``; 902265 for a zero divisor."""

    def number(self, context: PlcContext) -> float:
        left = real_leaves.number_of(self.left, context)
        right = real_leaves.number_of(self.right, context)
        if right == 0.0:
            if context.stops_at_invalid:
                context.fail(kinds.DIVISION, 0, 0)
                return 0.0
            return functions.quotient_by_zero(left, right)
        return real_leaves.valid(context, left / right)


class NegateReal(UnaryReal):
    """``-`` of one operand."""

    def number(self, context: PlcContext) -> float:
        return -real_leaves.number_of(self.operand, context)


class RoundToSingle(UnaryReal):
    """A value rounded to REAL."""

    def number(self, context: PlcContext) -> float:
        return words.single(real_leaves.number_of(self.operand, context))


class FunctionOfReal(Real):
    """A function of one number; outside its domain an invalid operation (ST-712)."""

    def __init__(self, function: int, operand: Real) -> None:
        self.function = function
        self.operand = operand

    def number(self, context: PlcContext) -> float:
        operand = real_leaves.number_of(self.operand, context)
        return real_leaves.valid(context, functions.of_real(self.function, operand))


class FunctionOfTwo(Real):
    """A function of two numbers."""

    def __init__(self, function: int, left: Real, right: Real) -> None:
        self.function = function
        self.left = left
        self.right = right

    def number(self, context: PlcContext) -> float:
        left = real_leaves.number_of(self.left, context)
        right = real_leaves.number_of(self.right, context)
        return real_leaves.valid(context, functions.of_two(self.function, left, right))


class ExtremeReal(Real):
    """``MIN`` or ``MAX`` of two numbers."""

    def __init__(self, left: Real, right: Real, is_maximum: bool) -> None:
        self.left = left
        self.right = right
        self.is_maximum = is_maximum

    def number(self, context: PlcContext) -> float:
        left = real_leaves.number_of(self.left, context)
        right = real_leaves.number_of(self.right, context)
        if self.is_maximum:
            return right if left < right else left
        return right if right < left else left


class SelectReal(Real):
    """``SEL``: only the chosen side is evaluated (ST-713)."""

    def __init__(self, condition: Whole, otherwise: Real, chosen: Real) -> None:
        self.condition = condition
        self.otherwise = otherwise
        self.chosen = chosen

    def number(self, context: PlcContext) -> float:
        if leaves.value_of(self.condition, context):
            return real_leaves.number_of(self.chosen, context)
        return real_leaves.number_of(self.otherwise, context)


class RealOfWhole(Real):
    """A whole number as a real one."""

    def __init__(self, operand: Whole, is_unsigned: bool) -> None:
        self.operand = operand
        self.is_unsigned = is_unsigned

    def number(self, context: PlcContext) -> float:
        value = leaves.value_of(self.operand, context)
        if self.is_unsigned and value < 0:
            return words.real_of_unsigned(value)
        return value + 0.0


class CompareReal(Whole):
    """A relation of two real numbers."""

    def __init__(self, left: Real, right: Real, relation: int) -> None:
        self.left = left
        self.right = right
        self.relation = relation

    def value(self, context: PlcContext) -> int:
        left = real_leaves.number_of(self.left, context)
        right = real_leaves.number_of(self.right, context)
        if self.relation == kinds.EQUAL:
            return 1 if left == right else 0
        if self.relation == kinds.NOT_EQUAL:
            return 1 if left != right else 0
        if self.relation == kinds.LESS:
            return 1 if left < right else 0
        if self.relation == kinds.LESS_EQUAL:
            return 1 if left <= right else 0
        if self.relation == kinds.GREATER:
            return 1 if left > right else 0
        return 1 if left >= right else 0


class WholeOfReal(Whole):
    """A real number as a whole one: rounded half away from zero, or cut (ST-307).

    Outside ``lowest`` … ``highest`` of its type 902270, or the low bits where the project says so.
    """

    def __init__(self, operand: Real, kind: int, rounding: int) -> None:
        check_range(kind, kinds.I8, kinds.U64, "kind")
        self.operand = operand
        self.kind = kind
        self.rounding = rounding
        bits = 8 << ((kind - kinds.I8) & 3)
        is_signed = kind <= kinds.I64
        self.lowest = -(2.0 ** (bits - 1)) if is_signed else 0.0
        self.limit = 2.0 ** (bits - 1) if is_signed else 2.0**bits

    def value(self, context: PlcContext) -> int:
        number = real_leaves.number_of(self.operand, context)
        if self.rounding == kinds.NEAREST:
            number = functions.round_half_away(number)
        else:
            number = arithmetic.truncate(number)
        if self.lowest <= number < self.limit:
            return words.unsigned_of_real(number) if self.limit > 1.0e19 else int(number)
        if context.wraps_conversions:
            return words.wrap(functions.low_bits(number), self.kind)
        context.fail(kinds.CONVERSION, 0, 0)
        return 0


class TruthOfReal(Whole):
    """Whether a real number is not zero (ST-307)."""

    def __init__(self, operand: Real) -> None:
        self.operand = operand

    def value(self, context: PlcContext) -> int:
        return 1 if real_leaves.number_of(self.operand, context) != 0.0 else 0
