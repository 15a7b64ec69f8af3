# SPDX-License-Identifier: MIT
"""Expressions of the main program that are evaluated again and again: made once, then computed.

In: an expression. Out: its ``Plan``: the variables that it reads, and the same nodes as in realtime
cycles, with a cell for each variable and parameter. Whoever evaluates puts the values of this
moment into the cells. Only expressions of numbers have nodes; what depends on texts or on the
parameters of a call has none.
"""

from __future__ import annotations

from dataclasses import dataclass

from nctakt.decoder.expressions import ExpressionBuilder
from nctakt.decoder.fusing import Built, load
from nctakt.kernel.expressions import Expression
from nctakt.kernel.memory import context_of
from nctakt.nc import syntax
from nctakt.nc.operators import FUNCTIONS
from nctakt.nc.resolution import variables_in

#: Expressions that are remembered; then all are forgotten, so that no program is too long.
MOST_PLANS = 4096

#: Variables and parameters of an expression with nodes.
MOST_LEAVES = 32

Leaf = syntax.Variable | syntax.Parameter


@dataclass(slots=True)
class Plan:
    """How an expression is evaluated.

    ``variables``: all in it, those of indices first. ``leaves``: what its nodes read, in the order
    of the cells. ``node`` is ``None`` where it has to be built anew each time.
    """

    expression: syntax.Expression
    variables: tuple[syntax.Variable, ...]
    leaves: tuple[Leaf, ...]
    node: Expression | None


class Plans:
    """The plans of one program; ``cells`` are those that their nodes read, by ``context``."""

    def __init__(self) -> None:
        memory = bytearray(8 * MOST_LEAVES)
        self.context = context_of(memory)
        self.cells = memoryview(memory).cast("d")
        self._plans: dict[int, Plan | syntax.Expression] = {}
        self._leaves: list[Leaf] = []
        self._builder = ExpressionBuilder(self._leaf)

    def of(self, expression: syntax.Expression) -> Plan | None:
        """The plan of an expression; ``None`` for one that is evaluated for the first time.

        What is asked for is kept alive, so that its identity stays its own.
        """
        known = self._plans.get(id(expression))
        if isinstance(known, Plan):
            return known
        if known is not None:
            plan = self._plans[id(expression)] = self._make(expression)
            return plan
        if len(self._plans) == MOST_PLANS:
            self._plans.clear()
        self._plans[id(expression)] = expression
        return None

    def _make(self, expression: syntax.Expression) -> Plan:
        self._leaves = []
        variables = tuple(variables_in(expression))
        node = None
        if _is_numeric(expression) and len(variables) <= MOST_LEAVES // 2:
            node = self._builder.build(expression).node
        leaves = tuple(self._leaves)
        return Plan(expression, variables, leaves, node if len(leaves) <= MOST_LEAVES else None)

    def _leaf(self, leaf: Leaf) -> Built:
        self._leaves.append(leaf)
        return load(len(self._leaves) - 1)


def _is_numeric(expression: syntax.Expression) -> bool:
    """Whether an expression has nothing but numbers, variables and parameters by their number."""
    match expression:
        case syntax.Number() | syntax.Constant() | syntax.Variable():
            return True
        case syntax.Parameter():
            return not expression.call and isinstance(expression.index, syntax.Number)
        case syntax.Unary():
            return _is_numeric(expression.operand)
        case syntax.Binary():
            return _is_numeric(expression.left) and _is_numeric(expression.right)
        case syntax.Call():
            is_of_numbers = not FUNCTIONS[expression.function].decoder_only
            return is_of_numbers and all(_is_numeric(one) for one in expression.arguments)
    return False
