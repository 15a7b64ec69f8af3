# SPDX-License-Identifier: MIT
"""Evaluation of template expressions from the numbers of an occurrence, without a tree.

In: a ``TemplateExpression`` of ``nc/fast/templates.py``. Out: its value, or ``None``; then its tree
is evaluated, which reports any mistake. A template is built once, of the same nodes as in realtime
cycles, with a cell for each number, variable and parameter. Variables are looked up again only
after declarations and deletions.
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.decoder.state.program_variables import Scopes
from nctakt.kernel.cycles.context import Context
from nctakt.kernel.cycles.expressions import Expression
from nctakt.nc.fast.recipes import Occurrence

#: Maximum number of numbers, variables and parameters of a template.
MAX_CELLS = 64


class TemplatePlan:
    """The node of a template and the sources of its cells.

    ``number_indices`` and ``signs``: numbers of the occurrence. ``names``: family and path of
    variables. ``parameters``: P1, P2, … ``node``: ``None`` if the template cannot be evaluated.
    """

    def __init__(
        self,
        node: Expression | None,
        number_indices: Sequence[int],
        signs: Sequence[float],
        names: Sequence[tuple[str, str]],
        parameters: Sequence[int],
    ) -> None:
        self.node = node
        self.number_indices = list(number_indices)
        self.signs = list(signs)
        self.names = list(names)
        self.parameters = list(parameters)
        #: The values of the variables, looked up at this count of ``Scopes.changes``, and
        #: whether all of them are REAL64.
        self.values: list[list[float | str]] = []
        self.changes = -1
        self.is_real = False

    def find(self, scopes: Scopes) -> int:
        """Look the variables up; return 0 if one does not exist or has elements, or a parameter."""
        self.values = []
        self.changes = -1
        self.is_real = True
        for family, path in self.names:
            variable = scopes.find(family, path)
            if variable is None or variable.dimensions:
                return 0
            self.is_real = self.is_real and variable.type == "REAL64"
            self.values.append(variable.values)
        for number in self.parameters:
            if scopes.is_array(number):
                return 0
        self.changes = scopes.changes
        return 1


class TemplateEvaluator:
    """Evaluates templates with the ``scopes`` and ``parameters`` of a program."""

    def __init__(
        self,
        context: Context,
        memory: bytearray,
        scopes: Scopes,
        parameters: dict[int, float],
    ) -> None:
        self.context = context
        self.cells = memoryview(memory).cast("d")
        self.scopes = scopes
        self.parameters = parameters

    def value(self, plan: TemplatePlan, occurrence: Occurrence) -> float | None:
        """Return the value of a template in an occurrence; ``None`` if its tree must be
        evaluated.
        """
        if plan.node is None:
            return None
        if plan.changes != self.scopes.changes and plan.find(self.scopes) == 0:
            return None
        cell = 0
        for i in range(len(plan.number_indices)):
            self.cells[cell] = occurrence.numbers[plan.number_indices[i]] * plan.signs[i]
            cell += 1
        for values in plan.values:
            value = values[0]
            if isinstance(value, str):
                return None
            self.cells[cell] = value
            cell += 1
        for number in plan.parameters:
            self.cells[cell] = self.parameters.get(number, 0.0)
            cell += 1
        context = self.context
        context.fault = 0
        result = plan.node.value(context)
        if context.fault or result - result != 0.0:
            return None
        return result

    def write(self, plan: TemplatePlan, value: float) -> int:
        """Assign to the variable or parameter of a template; return 0 if its tree is needed."""
        if not (plan.parameters or plan.names):
            return 0
        if plan.changes != self.scopes.changes and plan.find(self.scopes) == 0:
            return 0
        if plan.parameters:
            self.parameters[plan.parameters[0]] = value
            return 1
        if not plan.is_real:
            return 0
        plan.values[0][0] = value
        return 1
