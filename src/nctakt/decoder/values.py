# SPDX-License-Identifier: MIT
"""Values at decode time: expressions, variables read and written by the main program.

An asynchronous variable is read and written at once; a synchronous one and every V.RT* variable
through the channel: a read waits until the path stands, a write travels in the queue (RC-308).
"""

from __future__ import annotations

from collections.abc import Generator
from typing import NoReturn

from nctakt.decoder.commands import (
    Answer,
    Command,
    Flush,
    ReadRealtime,
    WriteVariable,
    write_text,
)
from nctakt.decoder.expressions import Built, ExpressionBuilder, constant
from nctakt.decoder.state import ModalState
from nctakt.decoder.surroundings import DecodeError, Surroundings
from nctakt.diagnostics import Span
from nctakt.kernel import arithmetic
from nctakt.kernel.expressions import OPERATIONS
from nctakt.kernel.memory import empty_context
from nctakt.lists.variable_tree import Node
from nctakt.lists.variables import SCALARS
from nctakt.messages import diagnostic
from nctakt.nc import strings, syntax
from nctakt.nc.cells import CELL_BYTES, leaf_cells
from nctakt.nc.names import Location, Whole
from nctakt.nc.resolution import indices_of, is_text, resolve, resolve_whole, variables_in

Decoding = Generator[Command, Answer, float]

#: Operations whose fault is a wrong argument of a function (21241).
_FUNCTIONS = frozenset(
    ("SQRT", "EXP", "DEXP", "LN", "LOG", "SIN", "COS", "TAN", "COT", "ASIN", "ACOS", "ATAN2", "INV")
)


class Values:
    """Evaluates expressions of one program and writes its variables."""

    def __init__(self, surroundings: Surroundings, state: ModalState) -> None:
        self.surroundings = surroundings
        self.state = state
        self._fetched: dict[int, float | str] = {}
        self._builder = ExpressionBuilder(self._leaf, self._compare_texts)
        self._context = empty_context()

    # --- reading --------------------------------------------------------------------------------

    def evaluate(self, expression: syntax.Expression, number: int) -> Decoding:
        """The value of an expression; synchronous variables in it empty the channel first.

        ``number`` is the N word of the block. Raises ``DecodeError`` where there is no value.
        """
        if isinstance(expression, syntax.Number):
            return expression.value
        yield from self._fetch(expression, number)
        value = self._compute(expression)
        self._fetched.clear()
        return value

    def evaluate_any(
        self, expression: syntax.Expression, number: int
    ) -> Generator[Command, Answer, float | str]:
        """As ``evaluate``; the value may be a text."""
        if not self._is_text(expression):
            return (yield from self.evaluate(expression, number))
        yield from self._fetch(expression, number)
        text = self._text(expression)
        self._fetched.clear()
        return text

    def _text(self, expression: syntax.Expression) -> str:
        """The value of an expression whose value is a text."""
        if isinstance(expression, syntax.StringLiteral):
            return expression.value
        if isinstance(expression, syntax.Binary):
            return self._text(expression.left) + self._text(expression.right)
        if isinstance(expression, syntax.Parameter):
            value = self._argument(expression)
        else:
            value = self._fetched[id(expression)]
        if not isinstance(value, str):
            self.fail(900342, expression.span, value=value)
        return value

    def _is_text(self, expression: syntax.Expression) -> bool:
        """Whether the value of an expression is a text now."""
        if isinstance(expression, syntax.Parameter) and expression.call:
            return isinstance(self._argument(expression), str)
        if isinstance(expression, syntax.Binary) and expression.operator == "+":
            return self._is_text(expression.left) or self._is_text(expression.right)
        return is_text(expression, self.surroundings.names)

    def _argument(self, parameter: syntax.Parameter) -> float | str:
        """What the call of the innermost cycle has handed over as @P1, @P2, …"""
        number = self._parameter(parameter)
        value = self.state.levels.arguments.get(number)
        if value is None:
            self.fail(900312, parameter.span, name=f"@P{number}")
        return value

    def _compare_texts(self, comparison: syntax.Binary) -> Built | None:
        """Two texts are equal when all their characters are."""
        if not self._is_text(comparison.left):
            return None
        is_equal = self._text(comparison.left) == self._text(comparison.right)
        return constant(1.0 if is_equal == (comparison.operator == "==") else 0.0)

    def evaluate_now(self, expression: syntax.Expression) -> float:
        """The value with what every variable holds at this moment, synchronous ones too."""
        for variable in variables_in(expression):
            self._fetched[id(variable)] = self._read_now(variable)
        value = self._compute(expression)
        self._fetched.clear()
        return value

    def _compute(self, expression: syntax.Expression) -> float:
        context = self._context
        context.fault = 0
        value = self._builder.build(expression).node.measure(context)
        if context.fault:
            operation = OPERATIONS[int(context.fault_a)]
            id_ = 21241 if operation in _FUNCTIONS else 900300
            self.fail(id_, expression.span, operation=operation)
        if not arithmetic.is_finite(value):
            self.fail(900301, expression.span)
        return value

    def _fetch(self, expression: syntax.Expression, number: int) -> Generator[Command, Answer]:
        """Get the values of all variables of an expression, innermost indices first."""
        for variable in variables_in(expression):
            location = self.locate(variable)
            if not (location.synchronous or variable.synchronous):
                self._fetched[id(variable)] = self._read_now(variable)
                continue
            cell = self.cell(variable, location)
            source = self.surroundings.place(variable.span)
            answer = yield ReadRealtime(source, number, cell)
            assert isinstance(answer, float)
            # the answer is of the tick that ran last, so the memory still holds what it was
            self._fetched[id(variable)] = self._value_in(cell, location)

    def _leaf(self, node: syntax.Variable | syntax.Parameter) -> Built:
        if isinstance(node, syntax.Variable):
            value = self._fetched[id(node)]
            assert isinstance(value, float)
            return constant(value)
        if node.call:
            argument = self._argument(node)
            if isinstance(argument, str):
                self.fail(900340, node.span, name="@P")
            return constant(argument)
        return constant(self.state.parameters.get(self._parameter(node), 0.0))

    def _parameter(self, node: syntax.Parameter) -> int:
        if isinstance(node.index, syntax.Number):
            return int(node.index.value)
        return int(self._index(node.index))

    def _index(self, index: syntax.Expression) -> float:
        """The number of an element; a fault in its expression gives the program up."""
        return arithmetic.round_half_even(self._compute(index))

    def _read_now(self, variable: syntax.Variable) -> float | str:
        location = self.locate(variable)
        return self._value_in(self.cell(variable, location), location)

    def _value_in(self, cell: int, location: Location) -> float | str:
        """What the memory holds in this moment."""
        if not location.is_numeric:
            return strings.read(self.surroundings.memory, cell, location.size_bytes)
        return self._in_unit(self.surroundings.cells[cell], location)

    def _in_unit(self, value: float, location: Location) -> float:
        return value / self.state.length_unit_mm if location.is_length else value

    def locate(self, variable: syntax.Variable) -> Location:
        """Where a variable lives; the checker has seen that it exists."""
        found = resolve(variable, self.surroundings.names)
        assert isinstance(found, Location), variable
        return found

    def cell(self, variable: syntax.Variable, location: Location | Whole) -> int:
        """The cell of a variable with the values that its indices have now (50929 outside)."""
        cell = location.cell
        for index, dimension in zip(indices_of(variable), location.dimensions, strict=True):
            number = self._index(index)
            if not 0 <= number < dimension.count:
                self.fail(
                    50929,
                    index.span,
                    variable=location.name,
                    index=int(number),
                    count=dimension.count,
                )
            cell += int(number) * dimension.stride
        return cell

    # --- writing --------------------------------------------------------------------------------

    def assign(self, statement: syntax.Assignment, number: int) -> Generator[Command, Answer]:
        """``target operator value``; structures and arrays as wholes (RC-310)."""
        value = statement.value
        if isinstance(value, syntax.Variable):
            found = resolve_whole(value, self.surroundings.names)
            if isinstance(found, Whole):
                yield from self._copy(statement.target, value, found, number)
                return
        if statement.operator != "=":
            value = syntax.Binary(
                statement.span, statement.operator[0], statement.target, statement.value
            )
        result = yield from self.evaluate_any(value, number)
        yield from self.store(statement.target, result, number)

    def store(
        self, target: syntax.Variable | syntax.Parameter, value: float | str, number: int
    ) -> Generator[Command, Answer]:
        """Give a variable a value, at once or through the queue."""
        if isinstance(target, syntax.Parameter):
            yield from self._fetch(target.index, number)
            if target.call:
                self._argument(target)
                self.state.levels.arguments[self._parameter(target)] = value
                return
            if isinstance(value, str):
                self.fail(900340, target.span, name="P")
            self.state.parameters[self._parameter(target)] = value
            return
        location = self.locate(target)
        cell = yield from self._place(target, location, number)
        stored = self.convert(value, location, target.span)
        source = self.surroundings.place(target.span)
        is_realtime = location.family in ("RTG", "RTA")
        if is_realtime:
            yield Flush(source, number, True)
        if location.synchronous or target.synchronous:
            yield from self._send(cell, stored, source, number, is_realtime)
        else:
            self._put(cell, stored)

    def _place(
        self, variable: syntax.Variable, found: Location | Whole, number: int
    ) -> Generator[Command, Answer, int]:
        """The cell of a variable that is written; what its indices need is read first."""
        for index in indices_of(variable):
            yield from self._fetch(index, number)
        return self.cell(variable, found)

    def _send(
        self, cell: int, value: float | bytes, source: int, number: int, is_told: bool
    ) -> Generator[Command, Answer]:
        """A value on its way through the queue."""
        if isinstance(value, bytes):
            axis_count = len(self.surroundings.axes)
            yield from write_text(source, number, cell, value, axis_count)
        else:
            yield WriteVariable(source, number, cell, value, is_told)

    def _put(self, cell: int, value: float | bytes) -> None:
        """A value that is there at once."""
        if isinstance(value, bytes):
            strings.write(self.surroundings.memory, cell, value)
        else:
            self.surroundings.cells[cell] = value

    def _copy(
        self,
        target: syntax.Variable | syntax.Parameter,
        source: syntax.Variable,
        found: Whole,
        number: int,
    ) -> Generator[Command, Answer]:
        """Copy a structure or array, member by member as each is synchronous or not (RC-308).

        All members are those of one moment: a synchronous one empties the channel, once.
        """
        assert isinstance(target, syntax.Variable)
        wanted = resolve_whole(target, self.surroundings.names)
        assert isinstance(wanted, Whole), target
        first = yield from self._place(source, found, number)
        place = yield from self._place(target, wanted, number)
        from_ = list(leaf_cells(found.node, found.name, first))
        if source.synchronous or any(leaf.synchronous for _, leaf, _ in from_):
            yield ReadRealtime(self.surroundings.place(source.span), number, first)
        values = [self._raw(cell, leaf) for _, leaf, cell in from_]
        to = leaf_cells(wanted.node, wanted.name, place)
        for value, (_, leaf, cell) in zip(values, to, strict=True):
            if leaf.synchronous or target.synchronous:
                at = self.surroundings.place(target.span)
                yield from self._send(cell, value, at, number, False)
            else:
                self._put(cell, value)

    def _raw(self, cell: int, leaf: Node) -> float | bytes:
        """A member's value as the memory holds it."""
        if SCALARS[leaf.type].is_numeric:
            return self.surroundings.cells[cell]
        first = cell * CELL_BYTES
        return bytes(self.surroundings.memory[first : first + leaf.size_bytes])

    def convert(self, value: float | str, location: Location, span: Span) -> float | bytes:
        """The value as the variable's type takes it (RC-307)."""
        if isinstance(value, str):
            size = location.size_bytes
            wrong = strings.misfit(location.name, location.type, size, value)
            if wrong is not None:
                self.fail(wrong[0], span, **wrong[1])
            return strings.encode(value, size)
        return self._number(value, location, span)

    def _number(self, value: float, location: Location, span: Span) -> float:
        if location.type == "BOOLEAN":
            return 1.0 if arithmetic.is_true(value) else 0.0
        if location.is_length:
            value *= self.state.length_unit_mm
        scalar = SCALARS[location.type]
        if not scalar.is_integer:
            return value
        value = arithmetic.round_half_even(value)
        if not scalar.low <= value <= scalar.high:
            self.fail(
                50892,
                span,
                variable=location.name,
                value=int(value),
                low=scalar.low,
                high=scalar.high,
            )
        return value

    def fail(self, id_: int, span: Span, **values: object) -> NoReturn:
        """Give the program up."""
        raise DecodeError(diagnostic(id_, span, self.surroundings.line(span), **values))
