# SPDX-License-Identifier: MIT
"""Expressions and accesses to variables: what can be known before they are evaluated.

In: nodes, in the context of the program or of a realtime cycle. Out: diagnostics. Names and
indices (RC-310), rights (RC-303), writing of asynchronous variables (RC-301), ``Vs.`` for a whole
block (RC-301), texts, structures and lists of values (RC-208), functions (RC-206).
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from difflib import get_close_matches

from nctakt.nc import strings, support
from nctakt.nc.cells import leaf_cells
from nctakt.nc.check_wholes import WholeChecker
from nctakt.nc.findings import Findings
from nctakt.nc.names import Access, Location, NameTable, NotFound, Problem, Whole
from nctakt.nc.operators import CONSTANTS, FUNCTIONS
from nctakt.nc.resolution import (
    indices_of,
    is_text,
    path_text,
    resolve,
    resolve_whole,
    variables_in,
)
from nctakt.nc.support import Answer
from nctakt.nc.syntax import (
    ArrayLiteral,
    Assignment,
    Binary,
    Call,
    Expression,
    Name,
    Number,
    Parameter,
    StringLiteral,
    Unary,
    Variable,
)

_RIGHTS = {Access.NONE: "–", Access.READ: "R", Access.WRITE: "W", Access.BOTH: "R/W"}
#: Families whose variables the variables list declares, with rights of their own.
_DECLARED = ("E", "CH")
_INDEX = re.compile(r"\[\d+\]")


class ValueChecker:
    """Checks expressions and accesses; ``in_cycle``: those of a realtime cycle's body."""

    def __init__(
        self, names: NameTable, axes: Sequence[str], findings: Findings, *, in_cycle: bool
    ) -> None:
        self._names = names
        self._axes = axes
        self._findings = findings
        self._in_cycle = in_cycle
        self._wholes = WholeChecker(self, names, findings, in_cycle=in_cycle)

    # --- expressions -----------------------------------------------------------------------------

    def block(self, *expressions: Expression) -> None:
        """All expressions of one block: their values, and ``Vs.`` in all of them or in none."""
        self.line(*expressions)
        for expression in expressions:
            self.value(expression)

    def line(self, *expressions: Expression) -> None:
        """A variable is synchronous for its whole block or not at all."""
        found: dict[str, list[Variable]] = {}
        for expression in expressions:
            for variable in variables_in(expression):
                if variable.family in _DECLARED:
                    found.setdefault(path_text(variable), []).append(variable)
        for name, variables in found.items():
            if not any(variable.synchronous for variable in variables):
                continue
            if self._is_synchronous(variables[0]):
                continue
            for variable in variables:
                if not variable.synchronous:
                    self._findings.report(900228, variable.span, name=name)

    def _is_synchronous(self, variable: Variable) -> bool:
        """Whether a variable is synchronous by its list; a structure: all that is in it."""
        location = resolve(variable, self._names)
        if isinstance(location, Location):
            return location.synchronous
        whole = resolve_whole(variable, self._names)
        if isinstance(whole, NotFound):
            return True
        return all(leaf.synchronous for _, leaf, _ in leaf_cells(whole.node, "", 0))

    def value(self, expression: Expression) -> None:
        """An expression whose value is needed."""
        match expression:
            case Variable():
                self.read(expression)
            case Parameter():
                self._parameter(expression)
            case Unary():
                self.value(expression.operand)
            case Binary():
                self._binary(expression)
            case Call():
                self._call(expression)
            case Name():
                known = [*FUNCTIONS, *CONSTANTS]
                near = get_close_matches(expression.name, known, 1)
                self._findings.report(
                    900221, expression.span, word=expression.text, nearest=near[0] if near else "–"
                )
            case StringLiteral():
                self._no_number(expression, '"…"')
            case ArrayLiteral():
                self._findings.answer(support.form("[1, 2]"), expression.span)

    def any_value(self, expression: Expression) -> None:
        """An expression whose value may be a number or a text."""
        if self.is_text(expression):
            self.text(expression)
        else:
            self.value(expression)

    def is_text(self, expression: Expression) -> bool:
        """Whether the value of an expression is a text; never in a realtime cycle (21981)."""
        return not self._in_cycle and is_text(expression, self._names)

    def text(self, expression: Expression) -> None:
        """An expression whose value must be a text."""
        if isinstance(expression, StringLiteral):
            return
        if isinstance(expression, Variable) and self.is_text(expression):
            self.read(expression, text=True)
        elif isinstance(expression, Binary) and self.is_text(expression):
            self.text(expression.left)
            self.text(expression.right)
        else:
            written = self._findings.written(expression.span)
            self._findings.report(900342, expression.span, value=written)

    def _binary(self, expression: Binary) -> None:
        """Two numbers, or two texts under ``==`` and ``!=``."""
        left, right = expression.left, expression.right
        if self.is_text(left) or self.is_text(right):
            if expression.operator in ("==", "!="):
                self.text(left)
                self.text(right)
                return
            if expression.operator != "+":
                self._findings.report(900341, expression.span, operator=expression.operator)
                return
        self.value(left)
        self.value(right)

    def _no_number(self, expression: Expression, name: str) -> None:
        """A text where a number is needed; in a realtime cycle it is out of place anywhere."""
        self._findings.report(21981 if self._in_cycle else 900340, expression.span, name=name)

    def _parameter(self, parameter: Parameter) -> None:
        if parameter.call:
            self._findings.answer(support.call_parameter(), parameter.span)
        self.value(parameter.index)
        if self._in_cycle and self._is_live(parameter.index):
            self._findings.report(900227, parameter.span, name="P")

    def _call(self, call: Call) -> None:
        function = FUNCTIONS.get(call.function)
        if function is None:
            near = get_close_matches(call.function, list(FUNCTIONS), 1)
            nearest = near[0] if near else "–"
            self._findings.report(900218, call.span, word=call.function, nearest=nearest)
        elif function.decoder_only:
            self._asks_about_names(call)
            return
        elif not function.minimum <= len(call.arguments) <= function.maximum:
            self._findings.report(
                900219,
                call.span,
                word=call.function,
                expected=function.minimum,
                given=len(call.arguments),
            )
        for argument in call.arguments:
            self.value(argument)

    def _asks_about_names(self, call: Call) -> None:
        if self._in_cycle:
            self._findings.report(900220, call.span, word=call.function)
            return
        entry = support.answer_function(call.function)
        assert entry is not None
        self._findings.answer(entry, call.span)

    # --- variables -------------------------------------------------------------------------------

    def read(self, variable: Variable, *, text: bool = False) -> None:
        """A variable whose value is needed, as a number or as a text."""
        location = self._found(variable)
        if location is None or not self._may(variable, location, Access.READ):
            return
        if not (location.is_numeric or text):
            self._no_number(variable, location.name)
        elif self._in_cycle and not (location.synchronous or variable.synchronous):
            if any(self._is_live(index) for index in indices_of(variable)):
                self._findings.report(900227, variable.span, name=location.name)

    def write(
        self, target: Variable | Parameter, *, compound: bool = False, text: bool = False
    ) -> None:
        """What is assigned to; ``compound``: it is read as well, as in ``+=``."""
        if isinstance(target, Parameter):
            self._parameter(target)
            if self._in_cycle:
                self._asynchronous(target)
            return
        entry = support.answer_family(target.family)
        if self._in_cycle and entry is not None and entry.answer is Answer.REFUSED:
            self._asynchronous(target)
            return
        location = self._found(target)
        if location is None or not self._may(target, location, Access.WRITE):
            return
        if compound and not self._may(target, location, Access.READ):
            return
        if not (location.is_numeric or text):
            self._no_number(target, location.name)
        elif self._in_cycle and not (location.synchronous or target.synchronous):
            self._findings.report(22009, target.span, name=location.name)

    def assignment(self, statement: Assignment) -> None:
        """``target operator value``, texts, structures and lists of values among them."""
        target, value = statement.target, statement.value
        self.line(target, value)
        if isinstance(value, ArrayLiteral):
            self._list_of_values(target, value)
        elif isinstance(value, Variable) and self._wholes.names_one(value):
            self._wholes.copy(statement, value)
        elif isinstance(target, Variable) and self.is_text(target):
            self._assigned_text(statement, target)
        else:
            self.write(target, compound=statement.operator != "=")
            self.value(value)

    def _assigned_text(self, statement: Assignment, target: Variable) -> None:
        """A text is given to a variable, or put behind what it holds."""
        self.write(target, compound=statement.operator != "=", text=True)
        if statement.operator not in ("=", "+="):
            self._findings.report(900341, statement.span, operator=statement.operator[0])
            return
        self.text(statement.value)
        location = resolve(target, self._names)
        if isinstance(statement.value, StringLiteral) and isinstance(location, Location):
            text, size = statement.value.value, location.size_bytes
            wrong = strings.misfit(location.name, location.type, size, text)
            if wrong is not None:
                self._findings.report(wrong[0], statement.value.span, **wrong[1])

    def _list_of_values(self, target: Variable | Parameter, value: ArrayLiteral) -> None:
        if self._in_cycle:
            name = path_text(target) if isinstance(target, Variable) else "P"
            self._findings.report(22001, value.span, name=name)
        else:
            self._findings.answer(support.form("[1, 2]"), value.span)

    def _asynchronous(self, target: Variable | Parameter) -> None:
        name = path_text(target) if isinstance(target, Variable) else "P"
        if isinstance(target, Parameter) and isinstance(target.index, Number):
            name = f"P{target.index.value:g}"
        self._findings.report(22009, target.span, name=name)

    def _found(self, variable: Variable) -> Location | None:
        """The location, or the report why there is none; the indices are checked, too."""
        entry = support.answer_family(variable.family)
        if entry is None:
            nearest = support.nearest_family(variable.family) or "–"
            name = path_text(variable)
            self._findings.report(900213, variable.span, name=name, nearest=nearest)
            return None
        if entry.answer is not Answer.SIMULATED:
            self._findings.answer(entry, variable.span, path_text(variable))
            return None
        for index in indices_of(variable):
            self.value(index)
        found = resolve(variable, self._names)
        if isinstance(found, NotFound):
            self.not_found(variable, found)
            return None
        return found if self.indices_fit(variable, found) else None

    def not_found(self, variable: Variable, found: NotFound) -> None:
        """Report why a variable does not exist."""
        report, span = self._findings.report, variable.span
        match found.reason:
            case Problem.UNKNOWN:
                nearest = (
                    self._with_axis(variable) or self._spelled(variable) or found.nearest or "–"
                )
                report(900213, span, name=path_text(variable), nearest=nearest)
            case Problem.INDICES:
                given = sum(1 for _ in indices_of(variable))
                report(900214, span, name=found.name, expected=found.expected_indices, given=given)
            case Problem.STRUCTURE:
                report(900215, span, name=found.name, member=found.nearest)

    def _with_axis(self, variable: Variable) -> str:
        """``V.RTA.ACS.ACT_POS.X`` where the axis is missing at the end; else nothing."""
        if variable.family == "RTA":
            parts = [(part.name, len(part.indices)) for part in variable.parts]
            for axis in self._axes:
                location = self._names.resolve("RTA", [*parts, (axis, 0)])
                if isinstance(location, Location):
                    return location.name
        return ""

    def _spelled(self, variable: Variable) -> str:
        """The variable that differs in upper and lower case only; else nothing."""
        wanted = path_text(variable).casefold()
        if variable.family in _DECLARED:
            known = (_INDEX.sub("[]", name) for name, _, _ in self._names.values())
            return next((name for name in known if name.casefold() == wanted), "")
        parts = [(part.name.upper(), len(part.indices)) for part in variable.parts]
        found = self._names.resolve(variable.family, parts)
        return found.name if isinstance(found, Location) else ""

    def indices_fit(self, variable: Variable, location: Location | Whole) -> bool:
        """Constant indices inside the array; those that are computed are checked when they are."""
        fits = True
        for index, dimension in zip(indices_of(variable), location.dimensions, strict=True):
            if isinstance(index, Number) and not 0 <= round(index.value) < dimension.count:
                fits = False
                self._findings.report(
                    50929,
                    index.span,
                    variable=location.name,
                    index=round(index.value),
                    count=dimension.count,
                )
        return fits

    def _may(self, variable: Variable, location: Location, wanted: Access) -> bool:
        allowed = location.cycle if self._in_cycle else location.decoder
        if wanted in allowed:
            return True
        if location.family in _DECLARED:
            number = 900216 if wanted is Access.WRITE else 900217
            self._findings.report(number, variable.span, name=location.name)
            return False
        self._findings.report(
            21993,
            variable.span,
            name=location.name,
            access=_RIGHTS[wanted],
            decoder=_RIGHTS[location.decoder],
            cycle=_RIGHTS[location.cycle],
        )
        return False

    def _is_live(self, index: Expression) -> bool:
        """Whether an index holds something that a realtime cycle reads in each tick."""
        for variable in variables_in(index):
            found = resolve(variable, self._names)
            if isinstance(found, Location) and (found.synchronous or variable.synchronous):
                return True
        return False
