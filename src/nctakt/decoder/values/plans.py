# SPDX-License-Identifier: MIT
"""Plans of repeated expressions of the main program: built once, then evaluated.

In: an expression. Out: its ``Plan``: the variables that it reads, and the same nodes as in realtime
cycles, with a cell for each variable and parameter; the evaluator loads the current values into the
cells. Only numeric expressions have nodes; those with texts or call parameters have none. The
numbers of a template have cells, too (``template_plans.py``).
"""

from __future__ import annotations

from nctakt.base.dataclass import dataclass
from nctakt.decoder.values.expressions import ExpressionBuilder
from nctakt.decoder.values.fusing import Operand, constant, load
from nctakt.decoder.values.template_plans import MAX_CELLS, TemplatePlan
from nctakt.kernel.cycles.context import context_of
from nctakt.kernel.cycles.expressions import Expression
from nctakt.nc import tree
from nctakt.nc.fast.recipes import NumberRecipe
from nctakt.nc.fast.templates import ExpressionTemplate
from nctakt.nc.vocabulary.operators import FUNCTIONS
from nctakt.nc.vocabulary.variables.resolution import bare_name, variables_in

#: Maximum number of remembered expressions; then all are forgotten.
MAX_PLANS = 4096

#: Maximum number of variables and parameters of an expression with nodes.
MAX_LEAVES = 32

#: Cells of the memory of all plans.
_CELLS = max(MAX_LEAVES, MAX_CELLS)

Leaf = tree.Variable | tree.Parameter


@dataclass(slots=True)
class Plan:
    """How an expression is evaluated.

    ``variables``: all variables in it, those of indices first. ``leaves``: the operands of its
    nodes in the order of the cells. ``node``: ``None`` if it must be built for each evaluation.
    """

    expression: tree.Expression
    variables: tuple[tree.Variable, ...]
    leaves: tuple[Leaf, ...]
    node: Expression | None


class Plans:
    """The plans of one program; their nodes read ``cells`` through ``context``."""

    def __init__(self) -> None:
        self.memory = bytearray(8 * _CELLS)
        self.context = context_of(self.memory)
        self.cells = memoryview(self.memory).cast("d")
        self._plans: dict[int, Plan | tree.Expression] = {}
        self._template_plans: dict[ExpressionTemplate, TemplatePlan] = {}
        self._leaves: list[Leaf] = []
        self._builder = ExpressionBuilder(self._leaf)

    def of(self, expression: tree.Expression) -> Plan | None:
        """Return the plan of an expression; ``None`` at its first evaluation.

        The expression is kept alive, because plans are found by its identity.
        """
        remembered = self._plans.get(id(expression))
        if isinstance(remembered, Plan):
            return remembered
        if remembered is not None:
            plan = self._plans[id(expression)] = self._make(expression)
            return plan
        if len(self._plans) == MAX_PLANS:
            self._plans.clear()
        self._plans[id(expression)] = expression
        return None

    def _make(self, expression: tree.Expression) -> Plan:
        self._leaves = []
        variables = tuple(variables_in(expression))
        node = None
        if _is_numeric(expression) and len(variables) <= MAX_LEAVES // 2:
            node = self._builder.build(expression).node
        leaves = tuple(self._leaves)
        return Plan(expression, variables, leaves, node if len(leaves) <= MAX_LEAVES else None)

    def of_template(self, template: ExpressionTemplate) -> TemplatePlan:
        """Return the plan of a template."""
        plan = self._template_plans.get(template)
        if plan is None:
            if len(self._template_plans) == MAX_PLANS:
                self._template_plans.clear()
            plan = self._template_plans[template] = plan_of_template(template)
        return plan

    def _leaf(self, leaf: Leaf) -> Operand:
        self._leaves.append(leaf)
        return _operand(len(self._leaves) - 1)


def _operand(cell: int) -> Operand:
    """Return the operand of a cell; the node of a plan with too many of them is not kept."""
    return load(min(cell, _CELLS - 1), _CELLS)


def plan_of_template(template: ExpressionTemplate) -> TemplatePlan:
    """Return the plan of a template; its cells hold numbers, then variables, then parameters."""
    numbers: dict[NumberRecipe, None] = {}
    names: dict[tuple[str, str], None] = {}
    parameters: dict[int, None] = {}

    def number(node: tree.Number) -> Operand:
        value = template.numbers.get(node.span)
        if value is None:
            return constant(node.value)
        numbers[value] = None
        return _operand(list(numbers).index(value))

    def leaf(node: Leaf) -> Operand:
        if isinstance(node, tree.Variable):
            name = (node.family, bare_name(node))
            names[name] = None
            return _operand(len(numbers) + list(names).index(name))
        assert isinstance(node.index, tree.Number)
        parameter = int(node.index.value)
        parameters[parameter] = None
        return _operand(len(numbers) + len(names) + list(parameters).index(parameter))

    builder = ExpressionBuilder(leaf, number=number)
    builder.build(template.tree)  # collects numbers, names and parameters
    node = builder.build(template.tree).node
    count = len(numbers) + len(names) + len(parameters)
    return TemplatePlan(
        node if count <= MAX_CELLS else None,
        [number.index for number in numbers],
        [number.sign for number in numbers],
        list(names),
        list(parameters),
    )


def _is_numeric(expression: tree.Expression) -> bool:
    """Return whether an expression consists of numbers, variables and parameters with constant
    index.
    """
    match expression:
        case tree.Number() | tree.Constant() | tree.Variable():
            return True
        case tree.Parameter():
            return not expression.call and isinstance(expression.index, tree.Number)
        case tree.Unary():
            return _is_numeric(expression.operand)
        case tree.Binary():
            return _is_numeric(expression.left) and _is_numeric(expression.right)
        case tree.Call():
            is_of_numbers = not FUNCTIONS[expression.function].decoder_only
            return is_of_numbers and all(_is_numeric(argument) for argument in expression.arguments)
    return False
