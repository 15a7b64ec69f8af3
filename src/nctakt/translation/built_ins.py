# SPDX-License-Identifier: MIT
"""Standard functions and conversions -> nodes (ST-307, ST-711 … ST-715, ST-721)."""

from __future__ import annotations

from collections.abc import Callable as Function

from nctakt.kernel.st import kinds
from nctakt.kernel.st.axis_calls import (
    CommandAxis,
    LookAtAxis,
    MeasureAxis,
    OpenInterface,
    OverrideAxis,
    SwitchAxis,
    TaskNumber,
)
from nctakt.kernel.st.blocks_of_bytes import CompareBytes, FillBytes, MoveBytes
from nctakt.kernel.st.calls import CallerSource
from nctakt.kernel.st.kept import WholeAfter
from nctakt.kernel.st.reals import (
    ExtremeReal,
    FunctionOfReal,
    FunctionOfTwo,
    Real,
    SelectReal,
)
from nctakt.kernel.st.steps import Fail
from nctakt.kernel.st.text.texts import (
    ChangeString,
    ChosenText,
    ExtremeText,
    FindString,
    LengthOfString,
    PartOfString,
    StringPart,
)
from nctakt.kernel.st.wholes import (
    AbsoluteWhole,
    AndThen,
    CompareWhole,
    CycleTime,
    ElementPlace,
    ExtremeWhole,
    LoadAt,
    MoveBits,
    OrElse,
    SelectWhole,
    Whole,
    WholeConstant,
)
from nctakt.st.tree import Call, CallKind
from nctakt.st.types import ArrayType, Expression, InterfaceType, StringType
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
            found = value_type(call)
            count = self.whole(operands[1])
            node = MoveBits(self.whole(operands[0]), count, _MOVES[name], 8 * found.size)
            return node if is_unsigned(found) else self.cut(node, found)
        build = _BUILDERS.get(name)
        if build is None:
            raise CannotRunError(call, name)
        return build(self, call, operands)

    def of_result(self, call: Call, node: Real) -> Real:
        """Return a function's value, rounded if its type is REAL."""
        found = value_type(call)
        return self.rounded(node, found) if is_real(found) else node

    def kept_text(self, unit: int) -> int:
        """Return where the frame keeps a text with characters of ``unit`` bytes."""
        return self.frame.take(unit * kinds.TEXT_BYTES)

    def chosen(self, call: Call, truth: Whole, otherwise: Expression, chosen: Expression) -> Node:
        """Return one of two values; only that one is evaluated (ST-713)."""
        found = value_type(call)
        if isinstance(found, StringType):
            one, other = self.text(chosen), self.text(otherwise)
            return chosen_text(SelectWhole(truth, other.address, one.address), one, other)
        if is_real(found):
            return SelectReal(truth, self.real(otherwise), self.real(chosen))
        return SelectWhole(truth, self.whole(otherwise), self.whole(chosen))


def chosen_text(address: Whole, one: StringPart, other: StringPart) -> StringPart:
    """Return one of two texts, selected by address."""
    return ChosenText(address, max(one.capacity, other.capacity), one.unit)


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
            text = body.text(operands[0])
            for one in operands[1:]:
                other = body.text(one)
                text = chosen_text(ExtremeText(text, other, is_maximum), text, other)
            return text
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
    first, again = body.kept_number(body.whole(number))
    node = _move(body, call, values[-1:])
    for location in range(len(values) - 2, -1, -1):
        asked = again if location else first
        truth = CompareWhole(asked, WholeConstant(location), kinds.EQUAL)
        chosen = _move(body, call, values[location : location + 1])
        if isinstance(node, StringPart) and isinstance(chosen, StringPart):
            node = chosen_text(SelectWhole(truth, node.address, chosen.address), node, chosen)
        elif isinstance(node, Real) and isinstance(chosen, Real):
            node = SelectReal(truth, node, chosen)
        elif isinstance(node, Whole) and isinstance(chosen, Whole):
            node = SelectWhole(truth, node, chosen)
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
        text, length = body.text(operands[0]), body.whole(operands[1])
        position = body.whole(operands[2]) if len(operands) > 2 else Whole()
        kept = body.kept_text(text.unit)
        node = PartOfString(text, length, position, function, kept)
        return StringPart(node, kinds.MAX_TEXT, text.unit)

    return build


def _change(function: int) -> Function[[BuiltIns, Call, list[Expression]], Node]:
    def build(body: BuiltIns, call: Call, operands: list[Expression]) -> Node:
        text = body.text(operands[0])
        kept = body.kept_text(text.unit)
        inserted = StringPart(WholeConstant(body.layout.literal(b"\0")), 0, text.unit)
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
        return StringPart(node, kinds.MAX_TEXT, text.unit)

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
        if not isinstance(found, ArrayType):
            raise CannotRunError(call, f"{call.function} of {found.name}")

        def bound(number: int) -> Whole:
            if not found.is_open:
                return WholeConstant(found.bounds[number][is_upper])
            return body.open_bound(operands[0], number, is_upper)

        count = found.dimensions
        if isinstance(dimension, int) and 1 <= dimension <= count:
            return bound(dimension - 1)
        first, again = body.kept_number(body.whole(operands[1]))
        # An invalid dimension stops the PLC like an index out of range.
        node: Whole = ElementPlace(WholeConstant(0), again, 1, count, 0)
        for number in range(count):
            asked = first if number == count - 1 else again
            is_asked = CompareWhole(asked, WholeConstant(number + 1), kinds.EQUAL)
            node = SelectWhole(is_asked, node, bound(number))
        return node

    return build


def _query(body: BuiltIns, call: Call, operands: list[Expression]) -> Node:
    """``__QUERYINTERFACE``, ``__QUERYPOINTER``: bind the second to the instance of the first."""
    source, target = operands
    found = value_type(target)
    asked: Whole
    if isinstance(value_type(source), InterfaceType):
        asked = body.whole(source)
    else:
        asked = body.pointer_of(source)
    first, again = body.kept_number(asked)
    truth: Whole = CompareWhole(first, WholeConstant(0), kinds.NOT_EQUAL)
    if isinstance(found, InterfaceType):
        is_one: Whole = WholeConstant(0)
        for low, high in body.project.types_of(found):
            number = LoadAt(again, 0, kinds.I64)
            inside = AndThen(
                CompareWhole(number, WholeConstant(low), kinds.GREATER_EQUAL),
                CompareWhole(number, WholeConstant(high), kinds.LESS_EQUAL),
            )
            is_one = OrElse(inside, is_one)
        truth = AndThen(truth, is_one)
    known, kept = body.kept_number(truth)
    bound = SelectWhole(known, WholeConstant(0), again)
    store = body.slot(target).store(bound, call.start, 1, body.layout.data_end)
    return WholeAfter(store, kept)


def _raise(body: BuiltIns, call: Call, operands: list[Expression]) -> Node:
    return WholeAfter(Fail(kinds.RAISED, body.whole(operands[0]), call.start), Whole())


def _is_valid_reference(body: BuiltIns, call: Call, operands: list[Expression]) -> Node:
    slot = body.pointer_of(operands[0])
    return CompareWhole(slot, WholeConstant(0), kinds.NOT_EQUAL)


def _move_bytes(body: BuiltIns, call: Call, operands: list[Expression]) -> Node:
    return MoveBytes(*(body.whole(one) for one in operands))


def _fill_bytes(body: BuiltIns, call: Call, operands: list[Expression]) -> Node:
    return FillBytes(*(body.whole(one) for one in operands))


def _task_number(body: BuiltIns, call: Call, operands: list[Expression]) -> Node:
    return TaskNumber()


def _called_from(body: BuiltIns, call: Call, operands: list[Expression]) -> Node:
    return CallerSource()


def _open_interface(body: BuiltIns, call: Call, operands: list[Expression]) -> Node:
    return OpenInterface()


def _command_axis(body: BuiltIns, call: Call, operands: list[Expression]) -> Node:
    kind, axis, target, speed, mode, direction = operands
    return CommandAxis(
        body.whole(kind), body.whole(axis), body.real(target), body.real(speed), body.whole(mode),
        body.whole(direction),
    )  # fmt: skip


def _switch_axis(is_lock: bool) -> Function[[BuiltIns, Call, list[Expression]], Node]:
    def build(body: BuiltIns, call: Call, operands: list[Expression]) -> Node:
        return SwitchAxis(body.whole(operands[0]), body.whole(operands[1]), is_lock)

    return build


def _override_axis(body: BuiltIns, call: Call, operands: list[Expression]) -> Node:
    return OverrideAxis(body.whole(operands[0]), body.real(operands[1]))


def _look_at_axis(body: BuiltIns, call: Call, operands: list[Expression]) -> Node:
    return LookAtAxis(*(body.whole(one) for one in operands))


def _measure_axis(body: BuiltIns, call: Call, operands: list[Expression]) -> Node:
    return MeasureAxis(*(body.whole(one) for one in operands))


def _compare_bytes(body: BuiltIns, call: Call, operands: list[Expression]) -> Node:
    return CompareBytes(*(body.whole(one) for one in operands))


_BUILDERS: dict[str, Function[[BuiltIns, Call, list[Expression]], Node]] = {
    "ABS": _absolute,
    "ADR": _address,
    "CONCAT": _change(kinds.CONCAT),
    "DELETE": _change(kinds.DELETE),
    "FIND": _find,
    "F_RAISEEXCEPTION": _raise,
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
    "GETCURTASKINDEXEX": _task_number,
    "__AXIS_COMMAND": _command_axis,
    "__AXIS_LOCK": _switch_axis(is_lock=True),
    "__AXIS_LOOK": _look_at_axis,
    "__AXIS_MEASURE": _measure_axis,
    "__AXIS_OVERRIDE": _override_axis,
    "__AXIS_POWER": _switch_axis(is_lock=False),
    "__CALLED_FROM": _called_from,
    "__CNC_OPEN": _open_interface,
    "__ISVALIDREF": _is_valid_reference,
    "__QUERYINTERFACE": _query,
    "__QUERYPOINTER": _query,
}
_BUILDERS |= {
    f"W{name}": _BUILDERS[name]
    for name in ("CONCAT", "DELETE", "FIND", "INSERT", "LEFT", "LEN", "MID", "REPLACE", "RIGHT")
}
#: The functions that are translated, in upper case.
KNOWN = frozenset({*_BUILDERS, *_OF_REAL, *_OF_TWO, *_MOVES})
