# SPDX-License-Identifier: MIT
"""Variables that the main program writes, in addition to those that it reads (``evaluation.py``).

An asynchronous variable is written at once; a synchronous one and every V.RT* variable through the
queue (RC-308).
"""

from __future__ import annotations

from collections.abc import Generator

from nctakt.base.diagnostics import Span
from nctakt.decoder.state.queued.commands import (
    WAIT_WRITE,
    Answer,
    Command,
    Flush,
    ReadRealtime,
    WriteVariable,
)
from nctakt.decoder.state.queued.packing import write_text
from nctakt.decoder.values.evaluation import Evaluator
from nctakt.kernel.base import arithmetic
from nctakt.lists.declared.variables import SCALARS
from nctakt.lists.machine.external.variables import Node
from nctakt.messages.machines.memory import TEXT_INSTEAD_OF_NUMBER
from nctakt.messages.programs.decoder import VALUE_OUTSIDE_TYPE_RANGE
from nctakt.nc import tree
from nctakt.nc.fast.templates import TemplateExpression, to_tree
from nctakt.nc.vocabulary.variables import strings
from nctakt.nc.vocabulary.variables.cells import CELL_BYTES, leaf_cells
from nctakt.nc.vocabulary.variables.resolution import (
    as_array,
    indices_of,
    is_program_variable,
    path_text,
    resolve_aggregate,
)
from nctakt.nc.vocabulary.variables.system_variables import SYSTEM_FAMILIES, is_whole_offset
from nctakt.nc.vocabulary.variables.variable_table import Aggregate, Location

Evaluation = Generator[Command, Answer, float]

#: Operations whose fault is a wrong argument of a function (21241).
_FUNCTIONS = frozenset(
    ("SQRT", "EXP", "DEXP", "LN", "LOG", "SIN", "COS", "TAN", "COT", "ASIN", "ACOS", "ATAN2", "INV")
)


class Values(Evaluator):
    """Evaluates expressions of one program and writes its variables."""

    def assign(self, statement: tree.Assignment, number: int) -> Generator[Command, Answer]:
        """Execute ``target operator value``, including structures and arrays (RC-310)."""
        value = statement.value
        if isinstance(statement.target, TemplateExpression):
            at_once = self._immediate_result(statement)
            if at_once is not None and self._store_in_template(statement.target, at_once):
                return
        if isinstance(value, TemplateExpression) and statement.operator == "=":
            result = yield from self.evaluate_any(value, number)
            yield from self.store(statement.target, result, number)
            return
        value = to_tree(value)
        if isinstance(value, tree.Variable) and is_whole_offset(value):
            assert isinstance(statement.target, tree.Variable)
            for index in (*indices_of(statement.target), *indices_of(value)):
                yield from self._fetch(index, number)
            source = self.environment.source_id(statement.span)
            yield from self.system.copy_offset(statement.target, value, source, number)
            return
        if isinstance(value, tree.ArrayLiteral):
            target = as_array(to_tree(statement.target))
            assert isinstance(target, tree.Variable)
            items = yield from self.program_values.items(value, number, self.evaluate_any)
            self.program_values.fill(target, items)
            return
        if isinstance(value, tree.Variable):
            aggregate = resolve_aggregate(value, self.environment.names)
            if isinstance(aggregate, Aggregate):
                yield from self._copy(statement.target, value, aggregate, number)
                return
        if statement.operator != "=":
            read = to_tree(statement.target)
            value = tree.Binary(statement.span, statement.operator[0], read, value)
        result = yield from self.evaluate_any(value, number)
        yield from self.store(statement.target, result, number)

    def _immediate_result(self, statement: tree.Assignment) -> float | None:
        """Return the number to assign if it is known without evaluation, else ``None``."""
        value = self.constant_value(statement.value)
        if value is None or statement.operator == "=":
            return value
        before = self.constant_value(statement.target)
        if before is None:
            return None
        match statement.operator:
            case "+=":
                result = before + value
            case "-=":
                result = before - value
            case "*=":
                result = before * value
            case _:
                return None
        return result if arithmetic.is_finite(result) else None

    def store(
        self, target: tree.Variable | tree.Parameter, value: float | str, number: int
    ) -> Generator[Command, Answer]:
        """Assign a value to a variable, at once or through the queue."""
        if isinstance(target, TemplateExpression):
            if self._store_in_template(target, value):
                return
            target = to_tree(target)
        if isinstance(target, tree.Parameter):
            yield from self._fetch(target.index, number)
            if target.call:
                self._argument(target)
                self.state.call_stack.arguments[self._parameter(target)] = value
                return
            if isinstance(value, str):
                self.fail(TEXT_INSTEAD_OF_NUMBER, target.span, name="P")
            self.state.parameters[self._single(target)] = value
            return
        if is_program_variable(target):
            for index in indices_of(target):
                yield from self._fetch(index, number)
            self.program_values.write(target, value)
            return
        if target.family in SYSTEM_FAMILIES:
            yield from self._write_system(target, value, number)
            return
        location = self.locate(target)
        cell = yield from self._target_cell(target, location, number)
        stored = self.convert(value, location, target.span)
        source = self.environment.source_id(target.span)
        is_realtime = location.family in ("RTG", "RTA")
        if is_realtime:
            self.check_flush_allowed(path_text(target), target.span)
            yield Flush(source, number, True, WAIT_WRITE, cell)
        if location.synchronous or target.synchronous:
            yield from self._send(cell, stored, source, number, is_realtime)
        else:
            self._store_now(cell, stored)

    def _store_in_template(self, target: TemplateExpression, value: float | str) -> bool:
        """Assign a number to a program variable; return false if its tree is needed."""
        if isinstance(value, str):
            return False
        return bool(self._template_evaluator.write(self._plans.of_template(target.template), value))

    def _write_system(
        self, target: tree.Variable, value: float | str, number: int
    ) -> Generator[Command, Answer]:
        """Assign to V.G: the active tool, zero offsets."""
        system = self.system_of(target)
        if isinstance(value, str):
            self.fail(TEXT_INSTEAD_OF_NUMBER, target.span, name=path_text(target))
        for index in indices_of(target):
            yield from self._fetch(index, number)
        if system.subject == "KIN_PARAM" and system.number is None:
            self.tool.write_kinematic_parameter(target, system, value, self._index)
            return
        if system.kind == "tool":
            yield from self.tool.write(target, system, value, self._index, number)
            return
        if system.kind == "tool life":
            yield from self.tool.write_life(system.subject, value, target.span, number)
            return
        source = self.environment.source_id(target.span)
        yield from self.system.write(target, system, value, source, number)

    def _target_cell(
        self, variable: tree.Variable, location: Location | Aggregate, number: int
    ) -> Generator[Command, Answer, int]:
        """Return the cell of an assigned variable after fetching its indices."""
        for index in indices_of(variable):
            yield from self._fetch(index, number)
        return self.cell(variable, location)

    def _send(
        self, cell: int, value: float | bytes, source: int, number: int, is_reported: bool
    ) -> Generator[Command, Answer]:
        """Send a value through the queue."""
        if isinstance(value, bytes):
            axis_count = len(self.environment.axes)
            yield from write_text(source, number, cell, value, axis_count)
        else:
            yield WriteVariable(source, number, cell, value, is_reported)

    def _store_now(self, cell: int, value: float | bytes) -> None:
        """Store a value in memory at once."""
        if isinstance(value, bytes):
            strings.write(self.environment.memory, cell, value)
        else:
            self.environment.cells[cell] = value

    def _copy(
        self,
        target: tree.Variable | tree.Parameter,
        source: tree.Variable,
        aggregate: Aggregate,
        number: int,
    ) -> Generator[Command, Answer]:
        """Copy a structure or array member by member, each synchronous or not (RC-308).

        All members are of the same moment: a synchronous one empties the channel once.
        """
        assert isinstance(target, tree.Variable)
        destination = resolve_aggregate(target, self.environment.names)
        assert isinstance(destination, Aggregate), target
        first_source = yield from self._target_cell(source, aggregate, number)
        first_target = yield from self._target_cell(target, destination, number)
        from_ = list(leaf_cells(aggregate.node, aggregate.name, first_source))
        if source.synchronous or any(leaf.synchronous for _, leaf, _ in from_):
            self.check_flush_allowed(path_text(source), source.span)
            yield ReadRealtime(self.environment.source_id(source.span), number, first_source)
        values = [self._raw(cell, leaf) for _, leaf, cell in from_]
        to = leaf_cells(destination.node, destination.name, first_target)
        for value, (_, leaf, cell) in zip(values, to, strict=True):
            if leaf.synchronous or target.synchronous:
                at = self.environment.source_id(target.span)
                yield from self._send(cell, value, at, number, False)
            else:
                self._store_now(cell, value)

    def _raw(self, cell: int, leaf: Node) -> float | bytes:
        """Return the value of a member as stored in memory."""
        if SCALARS[leaf.type].is_numeric:
            return self.environment.cells[cell]
        first = cell * CELL_BYTES
        return bytes(self.environment.memory[first : first + leaf.size_bytes])

    def convert(self, value: float | str, location: Location, span: Span) -> float | bytes:
        """Return the value converted to the variable's type (RC-307); raises ``DecodeError``."""
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
                VALUE_OUTSIDE_TYPE_RANGE,
                span,
                name=location.name,
                value=int(value),
                low=scalar.low,
                high=scalar.high,
            )
        return value
