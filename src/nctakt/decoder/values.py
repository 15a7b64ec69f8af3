# SPDX-License-Identifier: MIT
"""Values at decode time: expressions, variables read and written by the main program.

An asynchronous variable is read and written at once; a synchronous one and every V.RT* variable
through the channel: a read waits until the path stands, a write travels in the queue (RC-308).
"""

from __future__ import annotations

from collections.abc import Generator
from typing import NoReturn

from nctakt.decoder.commands import Answer, Command, Flush, ReadRealtime, WriteVariable
from nctakt.decoder.expressions import Built, ExpressionBuilder, constant
from nctakt.decoder.state import ModalState
from nctakt.decoder.surroundings import DecodeError, Surroundings
from nctakt.diagnostics import Span
from nctakt.kernel import arithmetic
from nctakt.kernel.expressions import OPERATIONS
from nctakt.kernel.memory import empty_context
from nctakt.lists.variables import SCALARS
from nctakt.messages import diagnostic
from nctakt.nc import syntax
from nctakt.nc.names import Location
from nctakt.nc.resolution import resolve, variables_in

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
        self._fetched: dict[int, float] = {}
        self._builder = ExpressionBuilder(self._leaf)
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
            self._fetched[id(variable)] = self._in_unit(answer, location)

    def _leaf(self, node: syntax.Variable | syntax.Parameter) -> Built:
        if isinstance(node, syntax.Variable):
            return constant(self._fetched[id(node)])
        return constant(self.state.parameters.get(self._parameter(node), 0.0))

    def _parameter(self, node: syntax.Parameter) -> int:
        if isinstance(node.index, syntax.Number):
            return int(node.index.value)
        return int(self._index(node.index))

    def _index(self, index: syntax.Expression) -> float:
        """The number of an element; a fault in its expression gives the program up."""
        return arithmetic.round_half_even(self._compute(index))

    def _read_now(self, variable: syntax.Variable) -> float:
        location = self.locate(variable)
        return self._in_unit(self.surroundings.cells[self.cell(variable, location)], location)

    def _in_unit(self, value: float, location: Location) -> float:
        return value / self.state.length_unit_mm if location.is_length else value

    def locate(self, variable: syntax.Variable) -> Location:
        """Where a variable lives; the checker has seen that it exists."""
        found = resolve(variable, self.surroundings.names)
        assert isinstance(found, Location), variable
        return found

    def cell(self, variable: syntax.Variable, location: Location) -> int:
        """The cell of a variable with the values that its indices have now (50929 outside)."""
        cell = location.cell
        indices = [index for part in variable.parts for index in part.indices]
        for index, dimension in zip(indices, location.dimensions, strict=True):
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
        """``target operator value``."""
        value = statement.value
        if statement.operator != "=":
            value = syntax.Binary(
                statement.span, statement.operator[0], statement.target, statement.value
            )
        result = yield from self.evaluate(value, number)
        yield from self.store(statement.target, result, number)

    def store(
        self, target: syntax.Variable | syntax.Parameter, value: float, number: int
    ) -> Generator[Command, Answer]:
        """Give a variable a value, at once or through the queue."""
        if isinstance(target, syntax.Parameter):
            yield from self._fetch(target.index, number)
            self.state.parameters[self._parameter(target)] = value
            return
        location = self.locate(target)
        for part in target.parts:
            for index in part.indices:
                yield from self._fetch(index, number)
        cell = self.cell(target, location)
        value = self.convert(value, location, target.span)
        source = self.surroundings.place(target.span)
        is_realtime = location.family in ("RTG", "RTA")
        if is_realtime:
            yield Flush(source, number, True)
        if location.synchronous or target.synchronous:
            yield WriteVariable(source, number, cell, value, is_realtime)
        else:
            self.surroundings.cells[cell] = value

    def convert(self, value: float, location: Location, span: Span) -> float:
        """The value as the variable's type takes it (RC-307)."""
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
                50892, span, variable=location.name, value=value, low=scalar.low, high=scalar.high
            )
        return value

    def fail(self, id_: int, span: Span, **values: object) -> NoReturn:
        """Give the program up."""
        raise DecodeError(diagnostic(id_, span, self.surroundings.line(span), **values))
