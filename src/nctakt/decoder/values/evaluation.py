# SPDX-License-Identifier: MIT
"""Evaluation at decode time: expressions, and variables that the main program reads.

An asynchronous variable is read at once; a synchronous one and every V.RT* variable through the
channel, which waits until the path has stopped (RC-308).
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence
from functools import cached_property
from typing import NoReturn

from nctakt.base.diagnostics import NOTHING, Message, Span
from nctakt.decoder.state.axis_places import AxisNotInChannelError
from nctakt.decoder.state.environment import DecodeError, DecoderEnvironment
from nctakt.decoder.state.modal_state import ModalState
from nctakt.decoder.state.program_variables import VariableError
from nctakt.decoder.state.queued.commands import (
    Answer,
    Command,
    ReadRealtime,
)
from nctakt.decoder.state.tools import ActiveTool
from nctakt.decoder.values.expressions import ExpressionBuilder
from nctakt.decoder.values.fusing import Operand, constant
from nctakt.decoder.values.plans import Leaf, Plan, Plans
from nctakt.decoder.values.program_values import ProgramValues
from nctakt.decoder.values.system_values import SystemValues
from nctakt.decoder.values.template_plans import TemplateEvaluator
from nctakt.kernel.base import arithmetic
from nctakt.kernel.cycles.context import Context, empty_context
from nctakt.kernel.cycles.expressions import OPERATIONS
from nctakt.messages import diagnostic
from nctakt.messages.machines.memory import NUMBER_INSTEAD_OF_TEXT, TEXT_INSTEAD_OF_NUMBER
from nctakt.messages.programs.block_search import READ_DURING_SEARCH
from nctakt.messages.programs.checked_values import INDEX_OUT_OF_RANGE
from nctakt.messages.programs.decoder import (
    ARGUMENT_OUT_OF_RANGE,
    CALL_PARAMETER_MISSING,
    OPERATION_WITHOUT_RESULT,
    RESULT_TOO_LARGE,
    UNKNOWN_MACRO,
)
from nctakt.messages.programs.lints import FLUSH_DURING_COMPENSATION
from nctakt.nc import tree
from nctakt.nc.fast.templates import TemplateExpression, to_tree
from nctakt.nc.vocabulary.operators import FUNCTIONS
from nctakt.nc.vocabulary.variables import strings
from nctakt.nc.vocabulary.variables.resolution import (
    as_array,
    bare_name,
    indices_of,
    is_program_variable,
    is_text,
    path_text,
    resolve,
    resolve_aggregate,
    variables_in,
)
from nctakt.nc.vocabulary.variables.system_variables import (
    SYSTEM_FAMILIES,
    TIMERS,
    SystemVariable,
    is_decoder_data,
    system_variable,
)
from nctakt.nc.vocabulary.variables.variable_table import Aggregate, Location

Evaluation = Generator[Command, Answer, float]

#: Operations whose fault is an invalid argument of a function (21241).
_FUNCTIONS = frozenset(
    ("SQRT", "EXP", "DEXP", "LN", "LOG", "SIN", "COS", "TAN", "COT", "ASIN", "ACOS", "ATAN2", "INV")
)


#: The command that empties the channel by itself.
EXPLICIT_FLUSH = "#FLUSH"


class Evaluator:
    """Evaluates expressions of one program."""

    def __init__(self, environment: DecoderEnvironment, state: ModalState) -> None:
        self.environment = environment
        self.state = state
        self._fetched: dict[int, float | str] = {}
        self._read_in_search: set[Span] = set()
        self._builder = ExpressionBuilder(
            self._leaf, self._compare_texts, self._query_number, macro=self.no_macro
        )
        self.program_values = ProgramValues(state.call_stack, self._index, self.fail)
        self._plans = Plans()
        self._template_evaluator = TemplateEvaluator(
            self._plans.context, self._plans.memory, state.call_stack.scopes, state.parameters
        )
        self.spindle_value: Callable[[tree.Variable, SystemVariable], float] = self._no_spindle
        self.tool = ActiveTool(environment, state, self.fail)
        self.system = SystemValues(environment, state, self.fail, self._index)

    @cached_property
    def _context(self) -> Context:
        """The context of expressions evaluated as trees, created on first use."""
        return empty_context()

    # --- reading --------------------------------------------------------------------------------

    def constant_value(self, expression: tree.Expression) -> float | None:
        """Return the value of an expression that needs no evaluation, else ``None``."""
        if isinstance(expression, TemplateExpression):
            return self._template_evaluator.value(
                self._plans.of_template(expression.template), expression.occurrence
            )
        return expression.value if isinstance(expression, tree.Number) else None

    def evaluate(self, expression: tree.Expression, number: int) -> Evaluation:
        """Return the value of an expression; synchronous variables empty the channel first.

        ``number``: the N word of the block. Raises ``DecodeError`` if there is no value.
        """
        value = self.constant_value(expression)
        if value is not None:
            return value
        expression = to_tree(expression)
        plan = self._plans.of(expression)
        yield from self._fetch(expression, number, plan)
        value = self._computed(expression, plan)
        self._fetched.clear()
        return value

    def evaluate_any(
        self, expression: tree.Expression, number: int
    ) -> Generator[Command, Answer, float | str]:
        """Return the value of an expression, a number or a text; raises ``DecodeError``."""
        if isinstance(expression, tree.StringLiteral):
            return expression.value
        value = self.constant_value(expression)
        if value is not None:
            return value
        expression = to_tree(expression)
        if not self._is_text(expression):
            return (yield from self.evaluate(expression, number))
        yield from self._fetch(expression, number)
        text = self._text(expression)
        self._fetched.clear()
        return text

    def _text(self, expression: tree.Expression) -> str:
        """Return the value of an expression that must be a text."""
        if isinstance(expression, tree.StringLiteral):
            return expression.value
        if isinstance(expression, tree.Binary):
            return self._text(expression.left) + self._text(expression.right)
        value: float | str
        if isinstance(expression, tree.Parameter):
            value = self._argument(expression)
        elif isinstance(expression, tree.Call):
            value = self._query(expression)
        elif isinstance(expression, tree.Variable):
            value = self._fetched[id(expression)]
        else:
            value = self._compute(expression)
        if not isinstance(value, str):
            self.fail(NUMBER_INSTEAD_OF_TEXT, expression.span, value=value)
        return value

    def _is_text(self, expression: tree.Expression) -> bool:
        """Return whether the current value of an expression is a text."""
        if isinstance(expression, tree.Parameter) and expression.call:
            return isinstance(self._argument(expression), str)
        if isinstance(expression, tree.Variable) and is_program_variable(expression):
            return self.program_values.is_text(expression)
        if isinstance(expression, tree.Binary) and expression.operator == "+":
            return self._is_text(expression.left) or self._is_text(expression.right)
        return is_text(expression, self.environment.names)

    def _query_number(self, call: tree.Call) -> Operand | None:
        """Return the numeric result of a function of names or texts, ``None`` for other
        functions.
        """
        if not FUNCTIONS[call.function].decoder_only:
            return None
        value = self._query(call)
        if isinstance(value, str):
            self.fail(TEXT_INSTEAD_OF_NUMBER, call.span, name=call.function)
        return constant(value)

    def _query(self, call: tree.Call) -> float | str:
        function = FUNCTIONS[call.function]
        first = call.arguments[0]
        match call.function:
            case "EXIST":
                return 1.0 if self._exists(first) else 0.0
            case "SIZEOF":
                dimension = self._compute(call.arguments[1]) if len(call.arguments) > 1 else 1.0
                return float(self._size(first, round(dimension)))
            case "IS_STRING" | "IS_NUMBER":
                return 1.0 if self._is_text(first) == (call.function == "IS_STRING") else 0.0
        values: list[float | str] = []
        for kind, argument in zip(function.arguments, call.arguments, strict=False):
            values.append(self._text(argument) if kind == "T" else self._compute(argument))
        return self.program_values.function(call, values)

    def _exists(self, asked: tree.Expression) -> bool:
        """Return whether a variable, an M or H function of the list, or a call parameter exists."""
        if isinstance(asked, tree.Parameter):
            if not asked.call:
                number = self._parameter(asked)
                is_array = self.state.call_stack.scopes.is_array(number)
                return is_array or number in self.state.parameters
            return self._parameter(asked) in self.state.call_stack.arguments
        if isinstance(asked, tree.Name):
            parameters = self.environment.parameters
            m, h = parameters.m_functions, parameters.h_functions
            return int(asked.name[1:]) in (m if asked.name[0] == "M" else h)
        assert isinstance(asked, tree.Variable)
        if is_program_variable(asked):
            return self.program_values.exists(asked)
        names = self.environment.names
        location = resolve(asked, names)
        if not isinstance(location, Location):
            return isinstance(resolve_aggregate(asked, names), Aggregate)
        counts = zip(indices_of(asked), location.dimensions, strict=True)
        return all(0 <= self._index(index) < dimension.count for index, dimension in counts)

    def _size(self, asked: tree.Expression, dimension: int) -> int:
        """Return the number of elements of an array in a dimension; arrays of lists have one."""
        asked = as_array(asked)
        assert isinstance(asked, tree.Variable)
        if is_program_variable(asked):
            return self.program_values.size(asked, dimension)
        aggregate = resolve_aggregate(asked, self.environment.names)
        is_first = isinstance(aggregate, Aggregate) and dimension == 1
        return aggregate.node.array_elements if is_first and isinstance(aggregate, Aggregate) else 0

    def declare(self, declaration: tree.Declaration, number: int) -> Generator[Command, Answer]:
        """Declare the variable of a line of ``#VAR``."""
        variable, initial = declaration.variable, declaration.initial
        if variable.family == tree.PARAMETER_ARRAYS:
            parameter = int(bare_name(variable))
            if not (indices_of(variable) or isinstance(initial, tree.ArrayLiteral)):
                value = 0.0
                if initial is not None:
                    value = yield from self.evaluate(initial, number)
                self.program_values.delete(variable)
                self.state.parameters[parameter] = value
                return
            self.state.parameters.pop(parameter, None)
        yield from self.program_values.declare(
            declaration, number, self.evaluate, self.evaluate_any
        )

    def _argument(self, parameter: tree.Parameter) -> float | str:
        """Return the argument @P1, @P2, … of the innermost cycle; raises ``DecodeError`` 20925."""
        number = self._parameter(parameter)
        value = self.state.call_stack.arguments.get(number)
        if value is None:
            self.fail(CALL_PARAMETER_MISSING, parameter.span, name=f"@P{number}")
        return value

    def _compare_texts(self, comparison: tree.Binary) -> Operand | None:
        """Return the result of comparing two texts, ``None`` for numbers."""
        if not (self._is_text(comparison.left) or self._is_text(comparison.right)):
            return None
        is_equal = self._text(comparison.left) == self._text(comparison.right)
        return constant(1.0 if is_equal == (comparison.operator == "==") else 0.0)

    def evaluate_now(self, expression: tree.Expression) -> float:
        """Return the value with the current values of all variables, including synchronous ones."""
        for variable in variables_in(expression):
            self._fetched[id(variable)] = self._read_now(variable)
        value = self._compute(expression)
        self._fetched.clear()
        return value

    def text_now(self, variable: tree.Variable) -> str | None:
        """Return the current text of a variable, ``None`` for a number."""
        for each in variables_in(variable):
            self._fetched[id(each)] = self._read_now(each)
        value = self._fetched[id(variable)]
        self._fetched.clear()
        return value if isinstance(value, str) else None

    def cell_now(self, variable: tree.Variable, location: Location | Aggregate) -> int:
        """Return the cell of a variable for the current values of its indices."""
        for index in indices_of(variable):
            for each in variables_in(index):
                self._fetched[id(each)] = self._read_now(each)
        cell = self.cell(variable, location)
        self._fetched.clear()
        return cell

    def _compute(self, expression: tree.Expression) -> float:
        return self._computed(expression, self._plans.of(expression))

    def _computed(self, expression: tree.Expression, plan: Plan | None) -> float:
        """Return the value of an expression with fetched variables, by its plan if it is numeric.

        A fault is found by evaluating the tree again, which locates and reports it.
        """
        if plan is not None and plan.node is not None and self._load(plan.leaves):
            context = self._plans.context
            context.fault = 0
            value = plan.node.measure(context)
            if not context.fault and arithmetic.is_finite(value):
                return value
        context = self._context
        context.fault = 0
        value = self._builder.build(expression).node.measure(context)
        if context.fault:
            operation = OPERATIONS[int(context.fault_a)]
            id_ = ARGUMENT_OUT_OF_RANGE if operation in _FUNCTIONS else OPERATION_WITHOUT_RESULT
            self.fail(id_, expression.span, operation=operation)
        if not arithmetic.is_finite(value):
            self.fail(RESULT_TOO_LARGE, expression.span)
        return value

    def _load(self, leaves: Sequence[Leaf]) -> bool:
        """Load the values of leaves into the cells of the plans; return false for a text."""
        cells = self._plans.cells
        parameters = self.state.parameters
        for cell, leaf in enumerate(leaves):
            if isinstance(leaf, tree.Variable):
                value = self._fetched[id(leaf)]
                if isinstance(value, str):
                    return False
                cells[cell] = value
            else:
                cells[cell] = parameters.get(self._single(leaf), 0.0)
        return True

    def _fetch(
        self, expression: tree.Expression, number: int, plan: Plan | None = None
    ) -> Generator[Command, Answer]:
        """Fetch the values of all variables of an expression, innermost indices first."""
        for variable in plan.variables if plan is not None else variables_in(expression):
            if is_decoder_data(variable):
                if variable.family == "A":
                    yield from self._flush_before(variable, number)
                self._fetched[id(variable)] = self._read_now(variable)
                continue
            location = self.locate(variable)
            if not (location.synchronous or variable.synchronous):
                self._fetched[id(variable)] = self._read_now(variable)
                continue
            cell = self.cell(variable, location)
            self.check_flush_allowed(path_text(variable), variable.span)
            source = self.environment.source_id(variable.span)
            if variable.family in ("RTA", "RTG"):
                self._note_search(variable)
            answer = yield ReadRealtime(source, number, cell)
            assert isinstance(answer, float)
            # the answer is from the last tick, so the memory still holds the same value
            self._fetched[id(variable)] = self._value_in(cell, location)

    def _leaf(self, node: tree.Variable | tree.Parameter) -> Operand:
        if isinstance(node, tree.Variable):
            value = self._fetched[id(node)]
            if isinstance(value, str):
                self.fail(TEXT_INSTEAD_OF_NUMBER, node.span, name=path_text(node))
            return constant(value)
        if node.call:
            argument = self._argument(node)
            if isinstance(argument, str):
                self.fail(TEXT_INSTEAD_OF_NUMBER, node.span, name="@P")
            return constant(argument)
        return constant(self.state.parameters.get(self._single(node), 0.0))

    def no_macro(self, text: tree.StringLiteral) -> NoReturn:
        """Report a text where a number is needed as an undefined macro."""
        self.fail(UNKNOWN_MACRO, text.span, name=text.value, nearest="–")

    def _parameter(self, node: tree.Parameter) -> int:
        if isinstance(node.index, tree.Number):
            return int(node.index.value)
        return int(self._index(node.index))

    def _single(self, node: tree.Parameter) -> int:
        """Return the number of a P parameter; raises ``DecodeError`` for an array."""
        number = self._parameter(node)
        try:
            self.state.call_stack.scopes.check_single(number)
        except VariableError as error:
            self.fail(error.message, node.span, **error.values)
        return number

    def _index(self, index: tree.Expression) -> float:
        """Return the rounded value of an index; raises ``DecodeError`` for a fault."""
        return arithmetic.round_half_even(self._compute(index))

    def _read_now(self, variable: tree.Variable) -> float | str:
        if is_program_variable(variable):
            return self.program_values.read(variable)
        if variable.family in SYSTEM_FAMILIES:
            return self._system(variable)
        location = self.locate(variable)
        return self._value_in(self.cell(variable, location), location)

    def _no_spindle(self, variable: tree.Variable, system: SystemVariable) -> float:
        """Raise ``AssertionError``: no words of spindles were decoded."""
        raise AssertionError(variable, system)

    def _system(self, variable: tree.Variable) -> float:
        """Return the value of a V.G or V.A variable."""
        environment = self.environment
        system = self.system_of(variable)
        if system.kind == "timer":
            assert system.number is not None
            number = self._index(system.number)
            if not 0 <= number < TIMERS:
                self.fail(
                    INDEX_OUT_OF_RANGE,
                    system.number.span,
                    variable="V.G.TIMER",
                    index=int(number),
                    count=TIMERS,
                )
            return environment.controller_data.timers.read(int(number))
        if system.kind == "spindle":
            return self.spindle_value(variable, system)
        if system.kind == "tool life":
            return environment.controller_data.tool_life_factors[system.subject]
        if system.kind == "tool":
            return self.tool.read(variable, system, self._index)
        return self.system.read(variable, system)

    def system_of(self, variable: tree.Variable) -> SystemVariable:
        """Return the meaning of a V.G or V.A variable that the checker knows.

        Raise ``AxisNotInChannelError`` where the channel does not have the axis now.
        """
        system = system_variable(variable, tuple(self.environment.axis_numbers))
        if system is None:
            raise AxisNotInChannelError(variable.parts[-1].name)
        return system

    def _flush_before(self, variable: tree.Variable, number: int) -> Generator[Command, Answer]:
        """Empty the channel before a variable that shows a present position."""
        system = system_variable(variable, tuple(self.environment.axis_numbers))
        if system is not None and system.waits:
            cell = self.system.cell(variable, system)
            self.check_flush_allowed(path_text(variable), variable.span)
            self._note_search(variable)
            yield ReadRealtime(self.environment.source_id(variable.span), number, cell)

    def _note_search(self, variable: tree.Variable) -> None:
        """Warn, once, of a value that block search reads before the motions that make it."""
        if self.state.is_searching and variable.span not in self._read_in_search:
            self._read_in_search.add(variable.span)
            self.warn(READ_DURING_SEARCH, variable.span, variable=path_text(variable))

    def _value_in(self, cell: int, location: Location) -> float | str:
        """Return the current value in memory."""
        if not location.is_numeric:
            return strings.read(self.environment.memory, cell, location.size_bytes)
        return self._in_unit(self.environment.cells[cell], location)

    def _in_unit(self, value: float, location: Location) -> float:
        return value / self.state.length_unit_mm if location.is_length else value

    def locate(self, variable: tree.Variable) -> Location:
        """Return the location of a variable that the checker has found to exist."""
        location = resolve(variable, self.environment.names)
        assert isinstance(location, Location), variable
        return location

    def cell(self, variable: tree.Variable, location: Location | Aggregate) -> int:
        """Return the cell of a variable for the current values of its indices; 50929 outside."""
        cell = location.cell
        for index, dimension in zip(indices_of(variable), location.dimensions, strict=True):
            number = self._index(index)
            if not 0 <= number < dimension.count:
                self.fail(
                    INDEX_OUT_OF_RANGE,
                    index.span,
                    variable=location.name,
                    index=int(number),
                    count=dimension.count,
                )
            cell += int(number) * dimension.stride
        return cell

    def check_flush_allowed(self, command: str, span: Span) -> None:
        """Raise ``DecodeError`` 20651 while compensation or a spline is active, because these
        cannot wait (RC-308).
        """
        word = self.state.path.compensation.word if self.state.path.compensation.side else ""
        if not word and self.state.path.hsc.is_on and command == EXPLICIT_FLUSH:
            word = "#HSC ON"
        if not word and self.state.shapes.spline.is_on:
            word = "#SPLINE ON"
        if word:
            variable = command if command.upper().startswith(("V.", "VS.")) else NOTHING
            self.fail(
                FLUSH_DURING_COMPENSATION, span, command=command, word=word, variable=variable
            )

    def warn(self, message: Message, span: Span, **values: object) -> None:
        """Report a warning at ``span``."""
        line = self.environment.line_text(span)
        self.environment.warn(diagnostic(message, span, line, **values))

    def fail(self, message: Message, span: Span, **values: object) -> NoReturn:
        """Raise ``DecodeError`` with this message."""
        raise DecodeError(diagnostic(message, span, self.environment.line_text(span), **values))
