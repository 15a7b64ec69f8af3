# SPDX-License-Identifier: MIT
"""Whole numbers, truths and places: trees of objects that compute 64 bits (ST-002, ST-302).

``value(context)`` returns a signed number; unsigned values have the same bits. A truth is 0 or 1,
an address is an offset in the memory. After a fault, noted in the context, it returns 0; the
statement above sees it and stores nothing. Operands are evaluated from left to right (ST-502).
"""

from __future__ import annotations

from nctakt.kernel.base.bounds import check_range
from nctakt.kernel.st import kinds, leaves, words
from nctakt.kernel.st.context import PlcContext


class Whole:
    """Base of all nodes with a whole value, and null object: zero."""

    def value(self, context: PlcContext) -> int:
        """Evaluate the node."""
        return 0

    def measure(self, context: PlcContext) -> int:
        """Evaluate the node for Python's side."""
        return self.value(context)


class WholeConstant(Whole):
    """A number that is known before the run; also the address of a global or of a literal."""

    def __init__(self, number: int) -> None:
        check_range(number, -(1 << 63), (1 << 63) - 1, "constant")
        self.leaf = kinds.CONSTANT
        self.offset = number

    def value(self, context: PlcContext) -> int:
        return self.offset


class LoadFixed(Whole):
    """A variable of data at a fixed address before ``end``."""

    def __init__(self, at: int, kind: int, end: int) -> None:
        check_range(at, kinds.NULL_BYTES, end, "address")
        self.leaf = kinds.IN_DATA
        self.offset = at
        self.kind = kind

    def value(self, context: PlcContext) -> int:
        return words.load(context.memory, self.offset, self.kind)


class LoadFrame(Whole):
    """A variable of the running routine."""

    def __init__(self, offset: int, kind: int) -> None:
        check_range(offset, 0, kinds.SLACK - 8, "offset")
        self.leaf = kinds.IN_FRAME
        self.offset = offset
        self.kind = kind

    def value(self, context: PlcContext) -> int:
        return words.load(context.memory, context.frame + self.offset, self.kind)


class LoadInstance(Whole):
    """A variable of the block that is called."""

    def __init__(self, offset: int, kind: int) -> None:
        check_range(offset, 0, kinds.SLACK - 8, "offset")
        self.leaf = kinds.IN_INSTANCE
        self.offset = offset
        self.kind = kind

    def value(self, context: PlcContext) -> int:
        return words.load(context.memory, context.instance + self.offset, self.kind)


class LoadAt(Whole):
    """A variable ``offset`` bytes past a computed address."""

    def __init__(self, address: Whole, offset: int, kind: int) -> None:
        check_range(offset, 0, kinds.MAX_MEMORY, "offset")
        self.address = address
        self.offset = offset
        self.kind = kind

    def value(self, context: PlcContext) -> int:
        at = leaves.place_of(self.address, context) + self.offset
        if at < kinds.NULL_BYTES or at > context.end:
            context.fail(kinds.PLACE, at, 0)
            return 0
        return words.load(context.memory, at, self.kind)


class FramePlace(Whole):
    """The address of a variable of the running routine."""

    def __init__(self, offset: int) -> None:
        self.leaf = kinds.FRAME_PLACE
        self.offset = offset

    def value(self, context: PlcContext) -> int:
        return context.frame + self.offset


class InstancePlace(Whole):
    """The address of a variable of the block that is called; THIS with offset 0 (ST-602)."""

    def __init__(self, offset: int) -> None:
        self.leaf = kinds.INSTANCE_PLACE
        self.offset = offset

    def value(self, context: PlcContext) -> int:
        return context.instance + self.offset


class PassingPlace(Whole):
    """The address where a call's argument goes, or its result comes from."""

    def __init__(self, offset: int) -> None:
        self.offset = offset

    def value(self, context: PlcContext) -> int:
        return context.passing + self.offset


class MemberPlace(Whole):
    """A fixed number of bytes past an address."""

    def __init__(self, address: Whole, offset: int) -> None:
        self.address = address
        self.offset = offset

    def value(self, context: PlcContext) -> int:
        return leaves.place_of(self.address, context) + self.offset


class PointedPlace(Whole):
    """Where a pointer or a reference points: ``size`` bytes within the memory (ST-315, ST-316)."""

    def __init__(self, pointer: Whole, size: int) -> None:
        check_range(size, 0, kinds.MAX_MEMORY, "size")
        self.pointer = pointer
        self.size = size

    def value(self, context: PlcContext) -> int:
        return context.checked(leaves.value_of(self.pointer, context), self.size)


class ElementPlace(Whole):
    """An element of an array whose first one is ``lowest``; 902266 outside it (ST-311).

    ``is_near``: address and index are evaluated without a call.
    """

    def __init__(self, address: Whole, index: Whole, lowest: int, count: int, stride: int) -> None:
        check_range(count, 0, kinds.MAX_MEMORY, "count")
        check_range(stride, 0, kinds.MAX_MEMORY, "stride")
        self.address = address
        self.index = index
        self.lowest = lowest
        self.count = count
        self.stride = stride
        self.offset = 0
        self.is_near = leaves.is_near_place(address) and leaves.is_near(index)

    def value(self, context: PlcContext) -> int:
        address = leaves.place_of(self.address, context)
        index = leaves.value_of(self.index, context)
        number = words.subtract(index, self.lowest)
        if number < 0 or number >= self.count:
            context.fail(kinds.INDEX, index, self.lowest * kinds.BOUND + self.count)
            return address
        return address + number * self.stride


class LoadElement(ElementPlace):
    """An element of an array, or a part of it ``offset`` bytes past its begin."""

    def __init__(
        self,
        address: Whole,
        index: Whole,
        lowest: int,
        count: int,
        stride: int,
        offset: int,
        kind: int,
    ) -> None:
        check_range(offset, 0, kinds.MAX_MEMORY, "offset")
        super().__init__(address, index, lowest, count, stride)
        self.offset = offset
        self.kind = kind

    def value(self, context: PlcContext) -> int:
        if self.is_near:
            at = leaves.near_element(self, context)
            if kinds.NULL_BYTES <= at <= context.end:
                return words.load(context.memory, at, self.kind)
        return self.far_value(context)

    def far_value(self, context: PlcContext) -> int:
        """Evaluate the node where operands are computed, or note the fault."""
        at = leaves.place_of(self.address, context) + self.offset
        index = leaves.value_of(self.index, context)
        number = words.subtract(index, self.lowest)
        if number < 0 or number >= self.count:
            context.fail(kinds.INDEX, index, self.lowest * kinds.BOUND + self.count)
            return 0
        at += number * self.stride
        if at < kinds.NULL_BYTES or at > context.end:
            context.fail(kinds.PLACE, at, 0)
            return 0
        return words.load(context.memory, at, self.kind)


class OpenElementPlace(Whole):
    """An element of a dimension whose bounds are at an address, each a DINT (``ARRAY[*]``)."""

    def __init__(self, address: Whole, bounds: Whole, index: Whole, stride: Whole) -> None:
        self.address = address
        self.bounds = bounds
        self.index = index
        self.stride = stride

    def value(self, context: PlcContext) -> int:
        address = leaves.place_of(self.address, context)
        bounds = context.checked(leaves.place_of(self.bounds, context), 8)
        index = leaves.value_of(self.index, context)
        lowest = words.load(context.memory, bounds, kinds.I32)
        highest = words.load(context.memory, bounds + 4, kinds.I32)
        if index < lowest or index > highest:
            context.fail(kinds.INDEX, index, lowest * kinds.BOUND + highest - lowest + 1)
            return address
        return words.add(
            address,
            words.multiply(words.subtract(index, lowest), leaves.value_of(self.stride, context)),
        )


class UnaryWhole(Whole):
    """Base of a node with one operand."""

    def __init__(self, operand: Whole) -> None:
        self.operand = operand


class BinaryWhole(Whole):
    """Base of a node with two operands."""

    def __init__(self, left: Whole, right: Whole) -> None:
        self.left = left
        self.right = right


class AddWhole(BinaryWhole):
    """``+``."""

    def value(self, context: PlcContext) -> int:
        left = leaves.value_of(self.left, context)
        return words.add(left, leaves.value_of(self.right, context))


class SubtractWhole(BinaryWhole):
    """``-``."""

    def value(self, context: PlcContext) -> int:
        left = leaves.value_of(self.left, context)
        return words.subtract(left, leaves.value_of(self.right, context))


class MultiplyWhole(BinaryWhole):
    """``*``."""

    def value(self, context: PlcContext) -> int:
        left = leaves.value_of(self.left, context)
        return words.multiply(left, leaves.value_of(self.right, context))


class DivideWhole(Whole):
    """``/`` and ``MOD``; 902265 for a zero divisor (ST-503)."""

    def __init__(self, left: Whole, right: Whole, is_unsigned: bool, is_modulo: bool) -> None:
        self.left = left
        self.right = right
        self.is_unsigned = is_unsigned
        self.is_modulo = is_modulo

    def value(self, context: PlcContext) -> int:
        left = leaves.value_of(self.left, context)
        right = leaves.value_of(self.right, context)
        if right == 0:
            context.fail(kinds.DIVISION, left, 0)
            return 0
        if self.is_unsigned:
            if self.is_modulo:
                return words.modulo_unsigned(left, right)
            return words.divide_unsigned(left, right)
        return words.modulo(left, right) if self.is_modulo else words.divide(left, right)


class NegateWhole(UnaryWhole):
    """``-`` of one operand."""

    def value(self, context: PlcContext) -> int:
        return words.subtract(0, leaves.value_of(self.operand, context))


class AbsoluteWhole(UnaryWhole):
    """``ABS``; the least number stays (ST-712)."""

    def value(self, context: PlcContext) -> int:
        value = leaves.value_of(self.operand, context)
        return words.subtract(0, value) if value < 0 else value


class AndBits(BinaryWhole):
    """``AND`` of bits or truths; both sides are evaluated (ST-502)."""

    def value(self, context: PlcContext) -> int:
        left = leaves.value_of(self.left, context)
        return left & leaves.value_of(self.right, context)


class OrBits(BinaryWhole):
    """``OR`` of bits or truths."""

    def value(self, context: PlcContext) -> int:
        left = leaves.value_of(self.left, context)
        return left | leaves.value_of(self.right, context)


class XorBits(BinaryWhole):
    """``XOR`` of bits or truths."""

    def value(self, context: PlcContext) -> int:
        left = leaves.value_of(self.left, context)
        return left ^ leaves.value_of(self.right, context)


class NotBits(Whole):
    """``NOT`` of the bits that a kind has."""

    def __init__(self, operand: Whole, kind: int) -> None:
        self.operand = operand
        self.kind = kind

    def value(self, context: PlcContext) -> int:
        return words.wrap(-1 - leaves.value_of(self.operand, context), self.kind)


class NotTruth(UnaryWhole):
    """``NOT`` of a truth."""

    def value(self, context: PlcContext) -> int:
        return 1 if leaves.value_of(self.operand, context) == 0 else 0


class AndThen(BinaryWhole):
    """``AND_THEN``: the right side only if the left one holds."""

    def value(self, context: PlcContext) -> int:
        if leaves.value_of(self.left, context) == 0 or context.fault:
            return 0
        return leaves.value_of(self.right, context)


class OrElse(BinaryWhole):
    """``OR_ELSE``: the right side only if the left one does not hold."""

    def value(self, context: PlcContext) -> int:
        if leaves.value_of(self.left, context) or context.fault:
            return 1
        return leaves.value_of(self.right, context)


def holds(relation: int, left: int, right: int) -> int:
    """Return whether a relation of two signed numbers holds."""
    if relation == kinds.EQUAL:
        return 1 if left == right else 0
    if relation == kinds.NOT_EQUAL:
        return 1 if left != right else 0
    if relation == kinds.LESS:
        return 1 if left < right else 0
    if relation == kinds.LESS_EQUAL:
        return 1 if left <= right else 0
    if relation == kinds.GREATER:
        return 1 if left > right else 0
    return 1 if left >= right else 0


class CompareWhole(Whole):
    """A relation of two signed numbers."""

    def __init__(self, left: Whole, right: Whole, relation: int) -> None:
        self.left = left
        self.right = right
        self.relation = relation

    def value(self, context: PlcContext) -> int:
        left = leaves.value_of(self.left, context)
        return holds(self.relation, left, leaves.value_of(self.right, context))


class CompareUnsigned(Whole):
    """A relation of values of which at least one is unsigned: values count, not bits (ST-303)."""

    def __init__(
        self, left: Whole, right: Whole, relation: int, is_left: bool, is_right: bool
    ) -> None:
        self.left = left
        self.right = right
        self.relation = relation
        self.is_left = is_left
        self.is_right = is_right

    def value(self, context: PlcContext) -> int:
        left = leaves.value_of(self.left, context)
        right = leaves.value_of(self.right, context)
        left_part = (1 if left < 0 else 0) if self.is_left else (-1 if left < 0 else 0)
        right_part = (1 if right < 0 else 0) if self.is_right else (-1 if right < 0 else 0)
        if left_part != right_part:
            return holds(self.relation, left_part, right_part)
        return holds(self.relation, left, right)


class WrapWhole(Whole):
    """A number cut to the width of a kind (ST-302, ST-307)."""

    def __init__(self, operand: Whole, kind: int) -> None:
        self.operand = operand
        self.kind = kind

    def value(self, context: PlcContext) -> int:
        return words.wrap(leaves.value_of(self.operand, context), self.kind)


class SelectWhole(Whole):
    """``SEL``: only the chosen side is evaluated (ST-713)."""

    def __init__(self, condition: Whole, otherwise: Whole, chosen: Whole) -> None:
        self.condition = condition
        self.otherwise = otherwise
        self.chosen = chosen

    def value(self, context: PlcContext) -> int:
        if leaves.value_of(self.condition, context):
            return leaves.value_of(self.chosen, context)
        return leaves.value_of(self.otherwise, context)


class ExtremeWhole(Whole):
    """``MIN`` or ``MAX`` of two numbers."""

    def __init__(self, left: Whole, right: Whole, is_unsigned: bool, is_maximum: bool) -> None:
        self.left = left
        self.right = right
        self.is_unsigned = is_unsigned
        self.is_maximum = is_maximum

    def value(self, context: PlcContext) -> int:
        left = leaves.value_of(self.left, context)
        right = leaves.value_of(self.right, context)
        is_less = left < right
        if self.is_unsigned and (left < 0) != (right < 0):
            is_less = right < 0
        if self.is_maximum:
            return right if is_less else left
        return left if is_less else right


class MoveBits(Whole):
    """``SHL``, ``SHR``, ``ROL``, ``ROR`` of an operand of ``bits`` bits (ST-714)."""

    def __init__(self, operand: Whole, count: Whole, operation: int, bits: int) -> None:
        check_range(bits, 1, 64, "bits")
        self.operand = operand
        self.count = count
        self.operation = operation
        self.bits = bits
        self.mask = (1 << bits) - 1 if bits < 64 else -1

    def value(self, context: PlcContext) -> int:
        value = leaves.value_of(self.operand, context) & self.mask
        count = leaves.value_of(self.count, context)
        if self.operation >= kinds.ROTATE_LEFT:
            count = words.modulo(count, self.bits)
            if count < 0:
                count += self.bits
            if count == 0:
                return value
            if self.operation == kinds.ROTATE_RIGHT:
                count = self.bits - count
            low = words.shift_right(value, self.bits - count)
            return (words.shift_left(value, count) | low) & self.mask
        if count < 0 or count >= self.bits:
            return 0
        if self.operation == kinds.SHIFT_LEFT:
            return words.shift_left(value, count) & self.mask
        return words.shift_right(value, count)


class CycleTime(Whole):
    """The time of the cycle in units of ``unit`` ns (ST-715, ST-804)."""

    def __init__(self, unit: int) -> None:
        check_range(unit, 1, 1 << 62, "unit")
        self.unit = unit

    def value(self, context: PlcContext) -> int:
        return words.divide(context.now, self.unit)
