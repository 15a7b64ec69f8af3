# SPDX-License-Identifier: MIT
"""Texts and structures of a realtime cycle -> the nodes that compare and copy them.

In: checked comparisons and assignments. Out: nodes of ``kernel/cycles/texts.py``, ``None`` for
numbers. As with numbers, synchronous texts are read in each tick, asynchronous ones have their
value at the definition (RC-302).
"""

from __future__ import annotations

from collections.abc import Callable

from nctakt.base.diagnostics import Span
from nctakt.decoder.values.fusing import Operand, constant
from nctakt.decoder.values.variables import Values
from nctakt.kernel import rows
from nctakt.kernel.cycles.expressions import Expression
from nctakt.kernel.cycles.instructions import Statement
from nctakt.kernel.cycles.texts import AssignText, CellRange, CompareTexts, Copy, Text
from nctakt.messages.machines.memory import NUMBER_INSTEAD_OF_TEXT, TEXT_INSTEAD_OF_NUMBER
from nctakt.nc import tree
from nctakt.nc.parse.printer import format_expression
from nctakt.nc.vocabulary.variables import strings
from nctakt.nc.vocabulary.variables.cells import CELL_BYTES, cells_of, leaf_cells
from nctakt.nc.vocabulary.variables.resolution import (
    is_program_variable,
    path_text,
    resolve,
    resolve_aggregate,
)
from nctakt.nc.vocabulary.variables.variable_table import Aggregate, Location

#: Characters in an event of a text that was written.
_PART = 2 * rows.TEXT_HALF

#: First cell and computed part of an access to an array.
Index = Callable[[tree.Variable, Location | Aggregate], tuple[int, Expression | None]]


class TextBuilder:
    """Builds the text operations of one cycle.

    ``index`` returns where a variable is; ``freeze`` takes name, value and place of an asynchronous
    variable and keeps its value at the definition. ``events``: number of events beyond one each
    that the statements can record in a tick; ``steps``: elementary instructions of accesses in each
    tick.
    """

    def __init__(
        self, values: Values, index: Index, freeze: Callable[[str, float | str, Span], None]
    ) -> None:
        self._values = values
        self._names = values.environment.names
        self._index = index
        self._freeze = freeze
        self.events = 0
        self.steps: dict[Span, int] = {}

    def compare(self, comparison: tree.Binary) -> Operand | None:
        """Return the node of ``==`` or ``!=`` between texts, ``None`` between numbers."""
        if not (self._is_text(comparison.left) or self._is_text(comparison.right)):
            return None
        is_equal = comparison.operator == "=="
        left, right = self._known(comparison.left), self._known(comparison.right)
        if left is not None and right is not None:
            return constant(1.0 if (left == right) == is_equal else 0.0)
        texts = [
            self._live(side) if known is None else self._constant(known)
            for side, known in ((comparison.left, left), (comparison.right, right))
        ]
        return Operand(CompareTexts(texts[0], texts[1], is_equal))

    def assignment(self, statement: tree.Assignment, source: int, cost: int) -> Statement | None:
        """Return the assignment of a text, structure or array, ``None`` for a number."""
        target = statement.target
        assert isinstance(target, tree.Variable)
        if isinstance(statement.value, tree.Variable):
            whole = resolve_aggregate(statement.value, self._names)
            if isinstance(whole, Aggregate):
                return self._copy(target, statement.value, whole, source, cost)
        location = self._values.locate(target)
        if location.is_numeric:
            if self._is_text(statement.value):
                name = path_text(target)
                self._values.fail(TEXT_INSTEAD_OF_NUMBER, statement.value.span, name=name)
            return None
        known = self._known(statement.value)
        size = location.size_bytes
        if known is None:
            text = self._live(statement.value)
        else:
            data = self._values.convert(known, location, statement.value.span)
            assert isinstance(data, bytes)
            text = _constant(data)
        self.events += -(-size // _PART)
        return AssignText(self._at(target, location), text, source, cost)

    def _copy(
        self, target: tree.Variable, value: tree.Variable, whole: Aggregate, source: int, cost: int
    ) -> Statement:
        """Return the copy of a structure or array."""
        destination = resolve_aggregate(target, self._names)
        assert isinstance(destination, Aggregate)
        memory = self._values.environment.memory
        leaves: list[tuple[int, int, bool]] = []
        for _, leaf, cell in leaf_cells(whole.node, "", 0):
            is_text = leaf.type in ("STRING", "VSTRING")
            size = leaf.size_bytes if is_text else 0
            leaves.append((cell, size, leaf.synchronous or value.synchronous))
            self.events += -(-size // _PART) if is_text else 1
        count = cells_of(whole.node)
        frozen = bytearray(CELL_BYTES * count)
        if not all(is_live for _, _, is_live in leaves):
            first = CELL_BYTES * self._values.cell_now(value, whole)
            frozen[:] = self._values.environment.memory[first : first + len(frozen)]
            self._freeze_members(value, whole, frozen)
        return Copy(
            self._cell_range(target, destination, count),
            self._cell_range(value, whole, count),
            memory,
            memoryview(frozen),
            leaves,
            source,
            cost,
        )

    def _freeze_members(self, value: tree.Variable, whole: Aggregate, data: bytearray) -> None:
        """List each member of a copy that keeps its value of the definition (RC-302)."""
        if value.synchronous:
            return
        numbers = memoryview(data).cast("d")
        for name, leaf, cell in leaf_cells(whole.node, format_expression(value), 0):
            if leaf.synchronous:
                continue
            if leaf.type in ("STRING", "VSTRING"):
                first = CELL_BYTES * cell
                text = strings.decode(data[first : first + leaf.size_bytes])
                self._freeze(name, text, value.span)
            else:
                self._freeze(name, numbers[cell], value.span)

    def _is_text(self, expression: tree.Expression) -> bool:
        if isinstance(expression, tree.StringLiteral):
            return True
        if not isinstance(expression, tree.Variable):
            return False
        if is_program_variable(expression):
            return self._values.program_values.is_text(expression)
        location = resolve(expression, self._names)
        return isinstance(location, Location) and not location.is_numeric

    def _known(self, expression: tree.Expression) -> str | None:
        """Return a text that does not change any more, ``None`` for one that is live."""
        if not self._is_text(expression):
            written = format_expression(expression)
            self._values.fail(NUMBER_INSTEAD_OF_TEXT, expression.span, value=written)
        if isinstance(expression, tree.StringLiteral):
            return expression.value
        assert isinstance(expression, tree.Variable)
        if not is_program_variable(expression):
            location = self._values.locate(expression)
            if location.synchronous or expression.synchronous:
                return None
        text = self._values.text_now(expression)
        assert text is not None
        self._freeze(format_expression(expression), text, expression.span)
        return text

    def _live(self, expression: tree.Expression) -> Text:
        assert isinstance(expression, tree.Variable)
        return self._at(expression, self._values.locate(expression))

    def _at(self, variable: tree.Variable, location: Location) -> Text:
        """Return the text of a variable."""
        count = -(-location.size_bytes // CELL_BYTES)
        memory = self._values.environment.memory
        return Text(memory, self._cell_range(variable, location, count), location.size_bytes)

    def _cell_range(
        self, variable: tree.Variable, location: Location | Aggregate, count: int
    ) -> CellRange:
        self.steps[variable.span] = count
        cell, index = self._index(variable, location)
        memory = self._values.environment.memory
        span = count
        if index is not None:
            span += sum(
                (dimension.count - 1) * dimension.stride for dimension in location.dimensions
            )
            span -= cell - location.cell
        return CellRange(memory, cell, span, index or Expression())

    def _constant(self, text: str) -> Text:
        return _constant(strings.encode(text, len(text) + 1))


def _constant(data: bytes) -> Text:
    """Return a text in its own memory."""
    memory = memoryview(bytearray(data.ljust(CELL_BYTES * (len(data) // CELL_BYTES + 1), b"\0")))
    return Text(memory, CellRange(memory, 0, len(memory) // CELL_BYTES, Expression()), len(data))
