# SPDX-License-Identifier: MIT
"""Standard functions and conversions -> nodes (ST-307, ST-711 … ST-715, ST-721)."""

from __future__ import annotations

from collections.abc import Callable as Function

from nctakt.kernel.st import kinds
from nctakt.kernel.st.blocks_of_bytes import CompareBytes, FillBytes, MoveBytes
from nctakt.kernel.st.reals import (
    ExtremeReal,
    FunctionOfReal,
    FunctionOfTwo,
    Real,
    SelectReal,
)
from nctakt.kernel.st.texts import (
    ChangeString,
    FindString,
    LengthOfString,
    PartOfString,
    StringPart,
)
from nctakt.kernel.st.wholes import (
    AbsoluteWhole,
    CompareWhole,
    CycleTime,
    ExtremeWhole,
    MoveBits,
    SelectWhole,
    Whole,
    WholeConstant,
)
from nctakt.st.tree import Call, CallKind
from nctakt.st.types import ArrayType, Expression, StringType
from nctakt.translation.body import CannotRunError, value_type
from nctakt.translation.conversions import Conversions
from nctakt.translation.layout import is_real, is_unsigned

_OF_REAL = {
    "SQRT": kinds.SQRT, "LN": kinds.LN, "LOG": kinds.LOG, "EXP": kinds.EXP, "SIN": kinds.SIN,
    "COS": kinds.COS, "TAN": kinds.TAN, "ASIN": kinds.ASIN, "ACOS": kinds.ACOS,
    "ATAN": kinds.ATAN, "FLOOR": kinds.FLOOR, "CEIL": kinds.CEIL, "FRAC": kinds.FRAC,
    "LTRUNC": kinds.LTRUNC,
}  # fmt: skip
_OF_TWO = {
    "EXPT": kinds.EXPT, "ATAN2": kinds.ATAN2, "LMOD": kinds.LMOD, "MODABS": kinds.MODABS,
}  # fmt: skip
_MOVES = {
    "SHL": kinds.SHIFT_LEFT, "SHR": kinds.SHIFT_RIGHT, "ROL": kinds.ROTATE_LEFT,
    "ROR": kinds.ROTATE_RIGHT,
}  # fmt: skip

Node = Whole | Real | StringPart


class BuiltIns(Conversions):
    """The functions that every program has."""

    def built_in(self, call: Call) -> Node:
        if call.kind is CallKind.CONVERSION:
            return self.conversion(call)
        name, operands = call.function, call.operands
        if call.kind is CallKind.FUNCTION and call.target is not None:
            name, operands = call.target.name.upper(), in_order(call)
        if name in _OF_REAL:
            return self.of_result(call, FunctionOfReal(_OF_REAL[name], self.real(operands[0])))
        if name in _OF_TWO:
            left, right = self.real(operands[0]), self.real(operands[1])
            return self.of_result(call, FunctionOfTwo(_OF_TWO[name], left, right))
        if name in _MOVES:
            bits = 8 * value_type(operands[0]).size
            return MoveBits(self.whole(operands[0]), self.whole(operands[1]), _MOVES[name], bits)
        build = _BUILDERS.get(name)
        if build is None:
            raise CannotRunError(call, name)
        return build(self, call, operands)

    def of_result(self, call: Call, node: Real) -> Real:
        """Return a function's value, rounded if its type is REAL."""
        found = value_type(call)
        return self.rounded(node, found) if is_real(found) else node

    def kept_text(self) -> int:
        """Return where the frame keeps a text."""
        return self.frame.take(kinds.TEXT_BYTES)

    def chosen(self, call: Call, truth: Whole, otherwise: Expression, chosen: Expression) -> Node:
        """Return one of two values; only that one is evaluated (ST-713)."""
        found = value_type(call)
        if isinstance(found, StringType):
            one, other = self.text(chosen), self.text(otherwise)
            location = SelectWhole(truth, other.address, one.address)
            return StringPart(location, min(one.capacity, other.capacity))
        if is_real(found):
            return SelectReal(truth, self.real(otherwise), self.real(chosen))
        return SelectWhole(truth, self.whole(otherwise), self.whole(chosen))


def in_order(call: Call) -> list[Expression]:
    """Return the operands of a standard function in the order of its parameters."""
    given = {id(parameter): value for parameter, value in call.bound}
    found: list[Expression] = []
    for one in call.target.parameters if call.target is not None else []:
        value = given.get(id(one), one.initial)
        if value is None:
            raise CannotRunError(
                call, f"{call.target.name if call.target else ''} without {one.name}"
            )
        found.append(value)
    return found


def _absolute(body: BuiltIns, call: Call, operands: list[Expression]) -> Node:
    if is_real(value_type(operands[0])):
        return FunctionOfReal(kinds.ABS, body.real(operands[0]))
    node = body.whole(operands[0])
    return node if is_unsigned(value_type(operands[0])) else AbsoluteWhole(node)


def _extreme(is_maximum: bool) -> Function[[BuiltIns, Call, list[Expression]], Node]:
    def build(body: BuiltIns, call: Call, operands: list[Expression]) -> Node:
        found = value_type(call)
        if is_real(found):
            real = body.real(operands[0])
            for one in operands[1:]:
                real = ExtremeReal(real, body.real(one), is_maximum)
            return real
        if isinstance(found, StringType):
            raise CannotRunError(call, f"{call.function} of texts")
        node = body.whole(operands[0])
        for one in operands[1:]:
            node = ExtremeWhole(node, body.whole(one), is_unsigned(found), is_maximum)
        return node

    return build


def _limit(body: BuiltIns, call: Call, operands: list[Expression]) -> Node:
    low, value, high = operands
    found = value_type(call)
    if is_real(found):
        inner = ExtremeReal(body.real(value), body.real(low), True)
        return ExtremeReal(inner, body.real(high), False)
    unsigned = is_unsigned(found)
    node = ExtremeWhole(body.whole(value), body.whole(low), unsigned, True)
    return ExtremeWhole(node, body.whole(high), unsigned, False)


def _select(body: BuiltIns, call: Call, operands: list[Expression]) -> Node:
    return body.chosen(call, body.whole(operands[0]), operands[1], operands[2])


def _multiplex(body: BuiltIns, call: Call, operands: list[Expression]) -> Node:
    number, *values = operands
    found = value_type(call)
    if isinstance(found, StringType):
        raise CannotRunError(call, "MUX of texts")
    if is_real(found):
        real = body.real(values[-1])
        for location in range(len(values) - 2, -1, -1):
            truth = CompareWhole(body.whole(number), WholeConstant(location), kinds.EQUAL)
            real = SelectReal(truth, real, body.real(values[location]))
        return real
    node = body.whole(values[-1])
    for location in range(len(values) - 2, -1, -1):
        truth = CompareWhole(body.whole(number), WholeConstant(location), kinds.EQUAL)
        node = SelectWhole(truth, node, body.whole(values[location]))
    return node


def _move(body: BuiltIns, call: Call, operands: list[Expression]) -> Node:
    found = value_type(call)
    if isinstance(found, StringType):
        return body.text(operands[0])
    return body.real(operands[0]) if is_real(found) else body.whole(operands[0])


def _length(body: BuiltIns, call: Call, operands: list[Expression]) -> Node:
    return LengthOfString(body.text(operands[0]))


def _find(body: BuiltIns, call: Call, operands: list[Expression]) -> Node:
    return FindString(body.text(operands[0]), body.text(operands[1]))


def _part(function: int) -> Function[[BuiltIns, Call, list[Expression]], Node]:
    def build(body: BuiltIns, call: Call, operands: list[Expression]) -> Node:
        kept = body.kept_text()
        text, length = body.text(operands[0]), body.whole(operands[1])
        position = body.whole(operands[2]) if len(operands) > 2 else Whole()
        node = PartOfString(text, length, position, function, kept)
        return StringPart(node, kinds.MAX_TEXT)

    return build


def _change(function: int) -> Function[[BuiltIns, Call, list[Expression]], Node]:
    def build(body: BuiltIns, call: Call, operands: list[Expression]) -> Node:
        kept = body.kept_text()
        text = body.text(operands[0])
        inserted = StringPart(WholeConstant(body.layout.literal(b"\0")), 0)
        length: Whole = Whole()
        position: Whole = Whole()
        if function == kinds.DELETE:
            length, position = body.whole(operands[1]), body.whole(operands[2])
        else:
            inserted = body.text(operands[1])
        if function == kinds.INSERT:
            position = body.whole(operands[2])
        if function == kinds.REPLACE:
            length, position = body.whole(operands[2]), body.whole(operands[3])
        node = ChangeString(text, inserted, length, position, function, kept)
        return StringPart(node, kinds.MAX_TEXT)

    return build


def _time(unit: int) -> Function[[BuiltIns, Call, list[Expression]], Node]:
    def build(body: BuiltIns, call: Call, operands: list[Expression]) -> Node:
        return body.cut(CycleTime(unit), value_type(call))

    return build


def _address(body: BuiltIns, call: Call, operands: list[Expression]) -> Node:
    return body.pointer_of(operands[0])


def _bound(is_upper: bool) -> Function[[BuiltIns, Call, list[Expression]], Node]:
    def build(body: BuiltIns, call: Call, operands: list[Expression]) -> Node:
        found, dimension = value_type(operands[0]), operands[1].value
        if not isinstance(found, ArrayType) or not isinstance(dimension, int):
            raise CannotRunError(call, f"{call.function} of a computed dimension")
        if not found.is_open:
            return WholeConstant(found.bounds[dimension - 1][is_upper])
        return body.open_bound(operands[0], dimension - 1, is_upper)

    return build


def _is_valid_reference(body: BuiltIns, call: Call, operands: list[Expression]) -> Node:
    slot = body.pointer_of(operands[0])
    return CompareWhole(slot, WholeConstant(0), kinds.NOT_EQUAL)


def _move_bytes(body: BuiltIns, call: Call, operands: list[Expression]) -> Node:
    return MoveBytes(*(body.whole(one) for one in operands))


def _fill_bytes(body: BuiltIns, call: Call, operands: list[Expression]) -> Node:
    return FillBytes(*(body.whole(one) for one in operands))


def _compare_bytes(body: BuiltIns, call: Call, operands: list[Expression]) -> Node:
    return CompareBytes(*(body.whole(one) for one in operands))


_BUILDERS: dict[str, Function[[BuiltIns, Call, list[Expression]], Node]] = {
    "ABS": _absolute,
    "ADR": _address,
    "CONCAT": _change(kinds.CONCAT),
    "DELETE": _change(kinds.DELETE),
    "FIND": _find,
    "INSERT": _change(kinds.INSERT),
    "LEFT": _part(kinds.LEFT),
    "LEN": _length,
    "LIMIT": _limit,
    "LOWER_BOUND": _bound(False),
    "LTIME": _time(1),
    "MAX": _extreme(True),
    "MEMCMP": _compare_bytes,
    "MEMCPY": _move_bytes,
    "MEMMOVE": _move_bytes,
    "MEMSET": _fill_bytes,
    "MID": _part(kinds.MID),
    "MIN": _extreme(False),
    "MOVE": _move,
    "MUX": _multiplex,
    "REPLACE": _change(kinds.REPLACE),
    "RIGHT": _part(kinds.RIGHT),
    "SEL": _select,
    "TIME": _time(1000000),
    "UPPER_BOUND": _bound(True),
    "__ISVALIDREF": _is_valid_reference,
}
#: The functions that are translated, in upper case.
KNOWN = frozenset({*_BUILDERS, *_OF_REAL, *_OF_TWO, *_MOVES})
