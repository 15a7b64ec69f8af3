# SPDX-License-Identifier: MIT
"""Expressions and accesses to variables, checked before they are evaluated.

In: nodes, in the context of the program or of a realtime cycle. Out: diagnostics. Names and indices
(RC-310), rights (RC-303), writing of asynchronous variables (RC-301), ``Vs.`` for a whole block
(RC-301), texts, structures and lists of values (RC-208), functions (RC-206).
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import zip_longest

from nctakt.base.diagnostics import NOTHING, number_text
from nctakt.base.misspelling import nearest
from nctakt.messages.machines.memory import (
    NUMBER_INSTEAD_OF_TEXT,
    OPERATOR_WITH_TEXT,
    TEXT_INSTEAD_OF_NUMBER,
)
from nctakt.messages.programs.checked_cycles import (
    ASYNCHRONOUS_WRITE_IN_CYCLE,
    TEXT_IN_REALTIME_CYCLE,
    TEXT_OF_ANOTHER_LENGTH,
    VALUE_LIST_IN_CYCLE,
)
from nctakt.messages.programs.checked_values import (
    ACCESS_NOT_DEFINED,
    ASYNCHRONOUS_INDEX,
    CYCLE_INDEX_OUT_OF_RANGE,
    INDEX_OUT_OF_RANGE,
    INVALID_EXIST_ARGUMENT,
    MIXED_SYNCHRONOUS_ACCESS,
    NOT_A_VALUE,
    QUERY_IN_REALTIME_CYCLE,
    TOO_MANY_INDICES,
    UNKNOWN_EXPRESSION_FUNCTION,
    VARIABLE_READ_ONLY,
    VARIABLE_WRITE_ONLY,
    WRONG_ARGUMENT_COUNT,
)
from nctakt.nc.check.aggregates import AggregateChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.check.missing_names import MissingNames
from nctakt.nc.meaning.cost import is_live
from nctakt.nc.tree import (
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
from nctakt.nc.vocabulary import support_level
from nctakt.nc.vocabulary.entries import Support
from nctakt.nc.vocabulary.operators import FUNCTIONS
from nctakt.nc.vocabulary.variables import strings
from nctakt.nc.vocabulary.variables.cells import leaf_cells
from nctakt.nc.vocabulary.variables.realtime_variables import Access
from nctakt.nc.vocabulary.variables.resolution import (
    as_array,
    indices_of,
    is_program_variable,
    is_text,
    may_be_text,
    path_text,
    resolve,
    resolve_aggregate,
    variables_in,
)
from nctakt.nc.vocabulary.variables.system_variables import is_whole_offset, system_variable
from nctakt.nc.vocabulary.variables.variable_table import (
    DECLARED,
    Aggregate,
    Location,
    NameTable,
    NotFound,
)

_RIGHTS = {Access.NONE: "–", Access.READ: "R", Access.WRITE: "W", Access.BOTH: "R/W"}
_M_FUNCTION = re.compile(r"[MH]\d{1,5}")


#: Maximum number of indices of a program variable.
MAX_DIMENSIONS = 4


class ValueChecker:
    """Checks expressions and accesses; ``in_cycle``: those of a realtime cycle's body."""

    def __init__(
        self, names: NameTable, axes: Sequence[str], findings: Findings, *, in_cycle: bool
    ) -> None:
        self._names = names
        self.axes = axes
        self._missing = MissingNames(names, axes, findings)
        self._findings = findings
        self._in_cycle = in_cycle
        self._aggregates = AggregateChecker(self, names, findings, in_cycle=in_cycle)

    # --- expressions -----------------------------------------------------------------------------

    def block(self, *expressions: Expression) -> None:
        """Check all expressions of one block: their values, and the consistent use of ``Vs.``."""
        self.line(*expressions)
        for expression in expressions:
            self.value(expression)

    def line(self, *expressions: Expression) -> None:
        """Report a variable that is used with and without ``Vs.`` in one block."""
        by_name: dict[str, list[Variable]] = {}
        for expression in expressions:
            for variable in variables_in(expression):
                if variable.family in DECLARED:
                    by_name.setdefault(path_text(variable), []).append(variable)
        for name, variables in by_name.items():
            if not any(variable.synchronous for variable in variables):
                continue
            if self._is_synchronous(variables[0]):
                continue
            for variable in variables:
                if not variable.synchronous:
                    self._findings.report(MIXED_SYNCHRONOUS_ACCESS, variable.span, name=name)

    def _is_synchronous(self, variable: Variable) -> bool:
        """Return whether a variable, or every member of a structure, is synchronous by its list."""
        location = resolve(variable, self._names)
        if isinstance(location, Location):
            return location.synchronous
        whole = resolve_aggregate(variable, self._names)
        if isinstance(whole, NotFound):
            return True
        return all(leaf.synchronous for _, leaf, _ in leaf_cells(whole.node, "", 0))

    def value(self, expression: Expression) -> None:
        """Check an expression whose value must be a number."""
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
                if self.is_text(expression):
                    self._no_number(expression, expression.function)
            case Name():
                near = self._missing.nearest_value(expression.name) or NOTHING
                self._findings.report(
                    NOT_A_VALUE, expression.span, word=expression.text, nearest=near
                )
            case StringLiteral():
                self._no_number(expression, '"…"')
            case ArrayLiteral():
                self._findings.report_support(support_level.form("[1, 2]"), expression.span)

    def any_value(self, expression: Expression) -> None:
        """Check an expression whose value may be a number or a text."""
        if self.is_text(expression):
            self.text(expression)
        else:
            self.value(expression)

    def is_text(self, expression: Expression) -> bool:
        """Return whether the value of an expression is a text."""
        return is_text(expression, self._names)

    def text(self, expression: Expression) -> None:
        """Check an expression whose value must be a text."""
        if isinstance(expression, StringLiteral):
            return
        if self._in_cycle and isinstance(expression, Binary) and self.is_text(expression):
            self._no_number(expression, self._findings.written(expression.span))
        elif isinstance(expression, Call) and self.is_text(expression):
            self._call(expression)
        elif may_be_text(expression):
            self.value(expression)
        elif isinstance(expression, Variable) and self.is_text(expression):
            self.read(expression, text=True)
        elif isinstance(expression, Binary) and self.is_text(expression):
            self.text(expression.left)
            self.text(expression.right)
        else:
            written = self._findings.written(expression.span)
            self._findings.report(NUMBER_INSTEAD_OF_TEXT, expression.span, value=written)

    def _binary(self, expression: Binary) -> None:
        """Check two numbers, or two texts under ``==`` and ``!=``."""
        left, right = expression.left, expression.right
        if self.is_text(left) or self.is_text(right):
            if expression.operator in ("==", "!="):
                self.text(left)
                self.text(right)
                return
            if expression.operator != "+" and not self._in_cycle:
                self._findings.report(
                    OPERATOR_WITH_TEXT, expression.span, operator=expression.operator
                )
                return
        self.value(left)
        self.value(right)

    def _no_number(self, expression: Expression, name: str) -> None:
        """Report a text where a number is needed; a realtime cycle only compares and assigns
        texts.
        """
        self._findings.report(
            TEXT_IN_REALTIME_CYCLE if self._in_cycle else TEXT_INSTEAD_OF_NUMBER,
            expression.span,
            name=name,
        )

    def _parameter(self, parameter: Parameter) -> None:
        if parameter.call:
            self._findings.report_support(support_level.call_parameter(), parameter.span)
        self.value(parameter.index)
        if self._in_cycle and self._is_live(parameter.index):
            self._findings.report(ASYNCHRONOUS_INDEX, parameter.span, name="P")

    def _call(self, call: Call) -> None:
        function = FUNCTIONS.get(call.function)
        if function is None:
            near = nearest(call.function, FUNCTIONS) or NOTHING
            self._findings.report(
                UNKNOWN_EXPRESSION_FUNCTION, call.span, word=call.function, nearest=near
            )
        elif function.decoder_only and self._in_cycle:
            self._findings.report(QUERY_IN_REALTIME_CYCLE, call.span, word=call.function)
            return
        elif not function.minimum <= len(call.arguments) <= function.maximum:
            self._findings.report(
                WRONG_ARGUMENT_COUNT,
                call.span,
                word=call.function,
                expected=function.minimum,
                given=len(call.arguments),
            )
        kinds = "" if function is None else function.arguments
        for kind, argument in zip_longest(kinds[: len(call.arguments)], call.arguments):
            self._argument(kind, argument)

    def _argument(self, kind: str | None, argument: Expression) -> None:
        """Check an argument of this kind (``operators.Function``)."""
        if kind == "T":
            self.text(argument)
        elif kind == "V":
            self.any_value(argument)
        elif kind == "A":
            self._asked(argument)
        else:
            self.value(argument)

    def _asked(self, argument: Expression) -> None:
        """Check a name that need not exist; its indices are checked."""
        if isinstance(argument, Variable):
            for index in indices_of(argument):
                self.value(index)
        elif isinstance(argument, Parameter):
            self.value(argument.index)
        elif not isinstance(argument, Name) or _M_FUNCTION.fullmatch(argument.name) is None:
            written = self._findings.written(argument.span)
            self._findings.report(INVALID_EXIST_ARGUMENT, argument.span, word=written)

    # --- variables -------------------------------------------------------------------------------

    def read(self, variable: Variable, *, text: bool = False) -> None:
        """Check a variable that is read, as a number or as a text."""
        if is_program_variable(variable):
            self._program_variable(variable)
            return
        system = system_variable(variable, self.axes)
        if system is not None:
            self._missing.report_spindle(variable, system)
            for index in system.indices:
                self.value(index)
            return
        location = self._found(variable)
        if location is None or not self._may(variable, location, Access.READ):
            return
        if not (location.is_numeric or text):
            self._no_number(variable, location.name)
        elif self._in_cycle and not (location.synchronous or variable.synchronous):
            if any(self._is_live(index) for index in indices_of(variable)):
                self._findings.report(ASYNCHRONOUS_INDEX, variable.span, name=location.name)

    def write(
        self, target: Variable | Parameter, *, compound: bool = False, text: bool = False
    ) -> None:
        """Check the target of an assignment; ``compound``: it is read as well, as in ``+=``."""
        if isinstance(target, Parameter):
            self._parameter(target)
            if self._in_cycle:
                self._asynchronous(target)
            return
        if is_program_variable(target):
            if self._in_cycle:
                self._asynchronous(target)
            else:
                self._program_variable(target)
            return
        entry = support_level.variable_family(target.family)
        if self._in_cycle and entry is not None and entry.support is Support.REFUSED:
            self._asynchronous(target)
            return
        system = system_variable(target, self.axes)
        if system is not None:
            if not system.is_writable:
                name = path_text(target)
                self._findings.report(VARIABLE_READ_ONLY, target.span, name=name)
            return
        location = self._found(target)
        if location is None or not self._may(target, location, Access.WRITE):
            return
        if compound and not self._may(target, location, Access.READ):
            return
        if not (location.is_numeric or text):
            self._no_number(target, location.name)
        elif self._in_cycle and not (location.synchronous or target.synchronous):
            self._findings.report(ASYNCHRONOUS_WRITE_IN_CYCLE, target.span, name=location.name)

    def _program_variable(self, variable: Variable) -> None:
        """Check V.P, V.S, V.L, V.CYC, which come into being only at run time."""
        for index in indices_of(variable):
            self.value(index)
        if not variable.parts:
            self._missing.unknown(variable)
        elif sum(1 for _ in indices_of(variable)) > MAX_DIMENSIONS:
            name = path_text(variable)
            self._findings.report(
                TOO_MANY_INDICES, variable.span, name=name, maximum=MAX_DIMENSIONS
            )

    def assignment(self, statement: Assignment) -> None:
        """Check ``target operator value``, including texts, structures and lists of values."""
        target, value = statement.target, statement.value
        self.line(target, value)
        if isinstance(value, ArrayLiteral):
            self._list_of_values(target, value)
        elif self._copies_offsets(statement):
            for index in (*indices_of(target), *indices_of(value)):  # type: ignore[arg-type]
                self.value(index)
        elif isinstance(value, Variable) and self._aggregates.is_aggregate(value):
            self._aggregates.copy(statement, value)
        elif isinstance(target, Variable) and self.is_text(target):
            self._assigned_text(statement, target)
        else:
            self.write(target, compound=statement.operator != "=")
            if may_be_text(target) and self.is_text(value):
                if statement.operator not in ("=", "+="):
                    operator = statement.operator[0]
                    self._findings.report(OPERATOR_WITH_TEXT, statement.span, operator=operator)
                self.text(value)
            else:
                self.value(value)

    def _copies_offsets(self, statement: Assignment) -> bool:
        """Return whether a program copies the zero offset of all axes."""
        sides = (statement.target, statement.value)
        is_copy = all(isinstance(side, Variable) and is_whole_offset(side) for side in sides)
        return is_copy and statement.operator == "=" and not self._in_cycle

    def _assigned_text(self, statement: Assignment, target: Variable) -> None:
        """Check a text that is assigned or appended to a variable."""
        if self._in_cycle and statement.operator != "=":
            self._no_number(target, path_text(target))
            return
        self.write(target, compound=statement.operator != "=", text=True)
        if statement.operator not in ("=", "+="):
            self._findings.report(
                OPERATOR_WITH_TEXT, statement.span, operator=statement.operator[0]
            )
            return
        self.text(statement.value)
        location = resolve(target, self._names)
        if isinstance(statement.value, StringLiteral) and isinstance(location, Location):
            text, size = statement.value.value, location.size_bytes
            wrong = strings.misfit(location.name, location.type, size, text)
            if wrong is not None:
                self._findings.report(wrong[0], statement.value.span, **wrong[1])
        if self._in_cycle and isinstance(statement.value, Variable):
            self._same_length(location, statement.value)

    def _same_length(self, target: Location | NotFound, value: Variable) -> None:
        """Report a live string of another length than the variable that it is assigned to."""
        source = resolve(value, self._names)
        if not isinstance(target, Location) or not isinstance(source, Location):
            return
        if source.is_numeric or not (source.synchronous or value.synchronous):
            return
        if source.size_bytes != target.size_bytes:
            self._findings.report(
                TEXT_OF_ANOTHER_LENGTH,
                value.span,
                name=target.name,
                size=target.size_bytes,
                value=source.name,
                other=source.size_bytes,
            )

    def _list_of_values(self, target: Variable | Parameter, value: ArrayLiteral) -> None:
        if self._in_cycle:
            name = path_text(target) if isinstance(target, Variable) else "P"
            self._findings.report(VALUE_LIST_IN_CYCLE, value.span, name=name)
        elif isinstance(array := as_array(target), Variable) and is_program_variable(array):
            self._program_variable(array)
            self.list_items(value)
        else:
            self._findings.report_support(support_level.form("[1, 2]"), value.span)

    def list_items(self, value: ArrayLiteral) -> None:
        """Check the values of a list and of lists inside it."""
        for item in value.items:
            if isinstance(item, ArrayLiteral):
                self.list_items(item)
            else:
                self.any_value(item)

    def _asynchronous(self, target: Variable | Parameter) -> None:
        name = path_text(target) if isinstance(target, Variable) else "P"
        if isinstance(target, Parameter) and isinstance(target.index, Number):
            name = f"P{number_text(target.index.value)}"
        self._findings.report(ASYNCHRONOUS_WRITE_IN_CYCLE, target.span, name=name)

    def _found(self, variable: Variable) -> Location | None:
        """Return the location of a variable and check its indices; report it if there is none."""
        entry = support_level.variable(variable)
        if entry is None:
            self._missing.unknown(variable, support_level.nearest_family(variable.family))
            return None
        if entry.support is not Support.SIMULATED:
            if not self._missing.report_axis(variable):
                near = self._missing.nearest_system_variable(variable)
                self._findings.report_support(entry, variable.span, path_text(variable), near)
            return None
        for index in indices_of(variable):
            self.value(index)
        location = resolve(variable, self._names)
        if isinstance(location, NotFound):
            self.not_found(variable, location)
            return None
        return location if self.indices_fit(variable, location) else None

    def not_found(self, variable: Variable, missing: NotFound) -> None:
        """Report why a variable does not exist."""
        self._missing.report(variable, missing)

    def indices_fit(self, variable: Variable, location: Location | Aggregate) -> bool:
        """Return whether constant indices are inside the array; report those that are not."""
        fits = True
        for index, dimension in zip(indices_of(variable), location.dimensions, strict=True):
            if isinstance(index, Number) and not 0 <= round(index.value) < dimension.count:
                fits = False
                self._findings.report(
                    CYCLE_INDEX_OUT_OF_RANGE if self._in_cycle else INDEX_OUT_OF_RANGE,
                    index.span,
                    variable=location.name,
                    index=round(index.value),
                    count=dimension.count,
                )
        return fits

    def _may(self, variable: Variable, location: Location, access: Access) -> bool:
        allowed = location.cycle if self._in_cycle else location.decoder
        if access in allowed:
            return True
        if location.family in DECLARED:
            number = VARIABLE_READ_ONLY if access is Access.WRITE else VARIABLE_WRITE_ONLY
            self._findings.report(number, variable.span, name=location.name)
            return False
        self._findings.report(
            ACCESS_NOT_DEFINED,
            variable.span,
            name=location.name,
            access=_RIGHTS[access],
            decoder=_RIGHTS[location.decoder],
            cycle=_RIGHTS[location.cycle],
        )
        return False

    def _is_live(self, index: Expression) -> bool:
        """Return whether an index contains a variable that a realtime cycle reads in each tick."""
        return any(is_live(variable, self._names) for variable in variables_in(index))
