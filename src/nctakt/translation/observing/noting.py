# SPDX-License-Identifier: MIT
"""The notes about a PLC program while somebody wants to know why it acted (ST-840).

In: a checked program. Out: a row for each operand and each condition of its own code, for its
calls, and for assignments to results; ``kernel.st.observing.notes`` keeps their values. They are
found by the identity of the node in the tree.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Literal

from nctakt.base.dataclass import dataclass
from nctakt.st import tree
from nctakt.st.program import Program
from nctakt.st.types import Callable, Expression, Node, Statement, Variable
from nctakt.translation.observing.units import own_units

NoteKind = Literal["condition", "operand", "selector", "pass", "result", "call"]
_RELATIONS = (
    tree.Operator.EQUAL, tree.Operator.UNEQUAL, tree.Operator.LESS, tree.Operator.LESS_EQUAL,
    tree.Operator.GREATER, tree.Operator.GREATER_EQUAL,
)  # fmt: skip


@dataclass(frozen=True, slots=True)
class NoteRow:
    """Kinds of the values of a row: a part of the text; a condition's statement begins at it."""

    kind: NoteKind
    node: Node


class NoteRows:
    """All rows of a program."""

    def __init__(self, program: Program) -> None:
        self.rows: list[NoteRow] = []
        self.by_identity: dict[int, int] = {}
        self.units: set[int] = set()
        #: Counters of FOR loops, which change without a separate statement.
        self.counters: set[int] = set()
        #: Where statements end, by where they begin.
        self.ends: dict[int, int] = {}
        for called, _ in own_units(program):
            self.units.add(id(called))
            self._walk(called.body, called)

    def add(self, kind: NoteKind, node: Node) -> int:
        """Return the row of a node, a new one if it has none."""
        found = self.by_identity.get(id(node))
        if found is None:
            found = self.by_identity[id(node)] = len(self.rows)
            self.rows.append(NoteRow(kind, node))
        return found

    def add_call(self, node: Node) -> int:
        """Return a new row for a call: its node may have one as an operand."""
        self.rows.append(NoteRow("call", node))
        return len(self.rows) - 1

    def _walk(self, body: Sequence[Statement], called: Callable) -> None:
        for one in body:
            if isinstance(one, tree.Assignment | tree.CallStatement):
                self.ends[one.start] = one.end
            for kind, expression in _expressions(one):
                self._condition(kind, expression)
            if isinstance(one, tree.For) and isinstance(one.counter, tree.Name | tree.Member):
                if isinstance(one.counter.target, Variable):
                    self.counters.add(id(one.counter.target))
            for inner in bodies_of(one):
                self._walk(inner, called)

    def _condition(self, kind: NoteKind, expression: Expression) -> None:
        """Assign rows to a condition and its operands; constants have none."""
        for operand in _operands(expression):
            if operand is not expression:
                self.add("operand", operand)
        if expression.value is None:
            self.add(kind, expression)


def _expressions(statement: Statement) -> Iterator[tuple[NoteKind, Expression]]:
    """Yield the expressions by which a statement decides, or that it assigns."""
    match statement:
        case tree.If(branches=branches):
            for branch in branches:
                yield "condition", branch.condition
        case tree.Case(selector=selector):
            yield "selector", selector
        case tree.While(condition=condition) | tree.Repeat(condition=condition):
            yield "condition", condition
        case tree.Assignment(value=value) if not isinstance(value, tree.AssignmentExpression):
            yield "operand", value


def bodies_of(statement: Statement) -> Iterator[Sequence[Statement]]:
    """Yield the lists of statements within a statement."""
    match statement:
        case tree.If():
            yield from (branch.body for branch in statement.branches)
            yield statement.otherwise
        case tree.Case():
            yield from (branch.body for branch in statement.branches)
            yield statement.otherwise
        case tree.For() | tree.While() | tree.Repeat():
            yield statement.body


def leaves_early(statement: Statement) -> bool:
    """Return whether an ``IF`` or ``CASE`` may leave, so that it decides about later statements."""
    if isinstance(statement, tree.Exit | tree.Continue | tree.Return):
        return True
    if not isinstance(statement, tree.If | tree.Case):
        return False
    return any(leaves_early(one) for body in bodies_of(statement) for one in body)


def is_comparison(expression: Expression) -> bool:
    """Return whether an expression compares two values."""
    return isinstance(expression, tree.Binary) and expression.operator in _RELATIONS


def _operands(expression: Expression) -> Iterator[Expression]:
    """Yield the operands that decide: sides of comparisons, and operands of AND, OR, NOT."""
    if expression.value is not None:
        return
    if is_comparison(expression) and isinstance(expression, tree.Binary):
        for side in (expression.left, expression.right):
            if side.value is None:
                yield side
    elif isinstance(expression, tree.Binary):
        yield from _operands(expression.left)
        yield from _operands(expression.right)
    elif isinstance(expression, tree.Unary):
        yield from _operands(expression.operand)
    else:
        yield expression
