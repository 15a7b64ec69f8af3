# SPDX-License-Identifier: MIT
"""Findings about one realtime cycle that runs but probably not as intended.

In: a definition, and the known values of parameters before it. Out: warnings and notes, and the
variables that the cycle writes. Frozen values (RC-302), frequencies and nesting (RC-203, RC-204),
overrides (RC-305), M and H functions (RC-403), limits (RC-502, RC-503).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span, Text, number_text
from nctakt.messages.programs.extensions import EXTENSION_USED
from nctakt.messages.programs.lints import (
    ASYNCHRONOUS_CONDITION,
    ASYNCHRONOUS_VALUE,
    AXIS_COMMANDED_EACH_TICK,
    CONDITION_NEVER_CHANGES,
    CONSTANT_CONDITION,
    CYCLE_MAY_EXCEED_DURATION,
    CYCLE_MAY_EXCEED_STEP_LIMIT,
    EXACT_POSITION_COMPARISON,
    FUNCTION_OUTPUT_EACH_TICK,
    IF_EVALUATED_IN_ONE_TICK,
    IF_NOT_EVALUATED_EVERY_TICK,
    INDP_WORD_WITHOUT_EFFECT,
    OVERRIDE_FOR_ONE_TICK,
    POSITION_COMPARED_IN_INCH,
)
from nctakt.nc.check.findings import Findings
from nctakt.nc.lint.conditions import check_bounds
from nctakt.nc.lint.constants import check_constant
from nctakt.nc.lint.reach import check_target
from nctakt.nc.lint.uses import (
    comparisons_in,
    element_name,
    is_override,
    is_position,
    operand_key,
    operands_of,
    targets,
)
from nctakt.nc.meaning.cost import is_live, max_steps
from nctakt.nc.tree import (
    Assignment,
    Binary,
    Block,
    BracketCommand,
    Call,
    Expression,
    If,
    Keyword,
    Parameter,
    RealtimeCycle,
    Statement,
    Timer,
    Unary,
    UserError,
    Variable,
    VariableBlock,
    Word,
)
from nctakt.nc.vocabulary.extensions import (
    BUFFERED_MOTION,
    COMPOUND_ASSIGNMENT,
    COPY_IN_CYCLE,
    SCOPE_LEFT_OUT,
    TEXT_IN_CYCLE,
    Extension,
)
from nctakt.nc.vocabulary.single_axes.axis_commands import (
    DIRECTION_OF_LINEAR_AXIS,
    FEED_BESIDE_RAPID,
    RAPID_BESIDE_ENDLESS_FEED,
    AxisCommand,
    is_axis_command,
    read_axis_command,
)
from nctakt.nc.vocabulary.variables.cells import leaf_cells
from nctakt.nc.vocabulary.variables.resolution import (
    indices_of,
    is_program_variable,
    is_text,
    path_text,
    resolve,
    resolve_aggregate,
)
from nctakt.nc.vocabulary.variables.variable_table import Aggregate, Location, NameTable

_DECLARED = ("E", "CH")
_THEN = Text(
    "the value that it has when the cycle is defined",
    "den Wert, den sie bei der Definition des Zyklus hat",
)
_THOSE = Text(
    "the values that they have when the cycle is defined",
    "die Werte, die sie bei der Definition des Zyklus haben",
)


@dataclass(frozen=True, slots=True)
class StepLimits:
    """Limits of elementary instructions in a tick: P-CHAN-00427, P-CHAN-00425."""

    max_steps: int
    duration_steps: int


@dataclass(frozen=True, slots=True)
class KnownValue:
    """A value that the program has assigned, and the line of the assignment."""

    value: float
    line: int


@dataclass(frozen=True, slots=True)
class _Surrounding:
    """The context of a statement of a cycle.

    ``single``: ONCE or EDGE if that makes the statement run in single ticks. ``skipped``: the
    nearest ``$IF`` is not evaluated in each tick. ``resets``: an enclosing plain branch changes its
    own condition.
    """

    single: str = ""
    once: bool = False
    skipped: bool = False
    resets: bool = False


class CycleLinter:
    """Visits the cycles of one program one by one."""

    def __init__(self, names: NameTable, findings: Findings, limits: StepLimits) -> None:
        self._names = names
        self._findings = findings
        self._limits = limits
        self._values: Mapping[str, KnownValue] = {}
        self._reported: dict[str, None] = {}
        self._is_inch = False

    def cycle(
        self, cycle: RealtimeCycle, values: Mapping[str, KnownValue], *, is_inch: bool
    ) -> dict[str, Variable]:
        """Report findings; return the variables that the cycle writes, by name.

        ``is_inch``: G70 is certainly active at the definition.
        """
        self._values = values
        self._reported = {}
        self._is_inch = is_inch
        if not any(isinstance(item, Keyword) and item.name == "SCOPE" for item in cycle.keywords):
            code = self._findings.text_after(cycle.span)[0].partition(";")[0].upper()
            if "SCOPE" not in code and (cycle.keywords or "=" not in code):
                self._extension(SCOPE_LEFT_OUT, cycle.span)
        self._check_limits(cycle)
        self._all(cycle.body, _Surrounding())
        return {
            element_name(target): target
            for target in targets(cycle.body)
            if isinstance(target, Variable)
        }

    def _extension(self, extension: Extension, span: Span) -> None:
        self._findings.report(
            EXTENSION_USED, span, construct=extension.construct, controller=extension.controller
        )

    def _check_limits(self, cycle: RealtimeCycle) -> None:
        steps = max_steps(cycle.body, self._names)
        for number, limit in (
            (CYCLE_MAY_EXCEED_STEP_LIMIT, self._limits.max_steps),
            (CYCLE_MAY_EXCEED_DURATION, self._limits.duration_steps),
        ):
            if steps > limit:
                self._findings.report(number, cycle.span, steps=steps, limit=limit)

    # --- statements ------------------------------------------------------------------------------

    def _all(self, statements: Sequence[Statement], around: _Surrounding) -> None:
        for statement in statements:
            match statement:
                case If() if not statement.preprocessor:
                    self._if(statement, around)
                case Assignment():
                    self._assignment(statement, around)
                case VariableBlock():
                    self._frozen(statement.variable)
                case Timer() | UserError():
                    for item in statement.keywords:
                        if isinstance(item, Keyword) and item.value is not None:
                            self._frozen(item.value)
                case Block():
                    self._block(statement, around)

    def _if(self, statement: If, around: _Surrounding) -> None:
        if statement.condition.span != statement.span:  # else it is missing, which is reported
            self._condition(statement.condition, statement.frequency or "")
        if statement.frequency is not None:
            self._nesting(statement, around)
            self._all(statement.body, _inside(statement.frequency, around))
            return
        asked = [statement.condition]
        self._branch(statement.body, asked, around)
        for branch in statement.elseifs:
            if branch.condition.span != branch.span:
                self._condition(branch.condition, "")
            asked.append(branch.condition)
            self._branch(branch.body, asked, around)
        self._branch(statement.else_body or (), asked, around)

    def _branch(
        self, body: Sequence[Statement], asked: Sequence[Expression], around: _Surrounding
    ) -> None:
        """Visit a plain branch; note whether it changes its own condition."""
        written = {element_name(target) for target in targets(body) if isinstance(target, Variable)}
        read = {
            element_name(operand)
            for condition in asked
            for operand in operands_of(condition, self._names)
            if isinstance(operand, Variable)
        }
        resets = around.resets or not written.isdisjoint(read)
        self._all(body, replace(around, skipped=True, resets=resets))

    def _nesting(self, statement: If, around: _Surrounding) -> None:
        if around.once:
            self._findings.report(IF_EVALUATED_IN_ONE_TICK, statement.span, word="ONCE")
        elif around.skipped:
            self._findings.report(
                IF_NOT_EVALUATED_EVERY_TICK, statement.span, word=statement.frequency
            )

    def _assignment(self, statement: Assignment, around: _Surrounding) -> None:
        target = statement.target
        if statement.operator not in ("=", "+="):
            self._extension(COMPOUND_ASSIGNMENT, statement.span)
        if is_text(target, self._names) or self._has_text(statement.value):
            self._extension(TEXT_IN_CYCLE, statement.span)
        if isinstance(statement.value, Variable):
            if isinstance(resolve_aggregate(statement.value, self._names), Aggregate):
                self._extension(COPY_IN_CYCLE, statement.span)
        check_constant(statement, self._names, self._findings, in_cycle=True)
        if isinstance(target, Variable):
            for index in indices_of(target):
                self._frozen(index)
            if around.single and is_override(target):
                name = path_text(target)
                self._findings.report(
                    OVERRIDE_FOR_ONE_TICK, target.span, name=name, word=around.single
                )
        self._frozen(statement.value)

    def _has_text(self, expression: Expression) -> bool:
        """Return whether texts are compared in an expression."""
        match expression:
            case Binary():
                sides = (expression.left, expression.right)
                return any(is_text(side, self._names) or self._has_text(side) for side in sides)
            case Unary():
                return self._has_text(expression.operand)
            case Call():
                return any(self._has_text(argument) for argument in expression.arguments)
        return False

    def _block(self, block: Block, around: _Surrounding) -> None:
        """Check the values of commands; the first function of a block represents all."""
        for word in block.words:
            if isinstance(word, BracketCommand) and is_axis_command(word):
                self._axis_command(word, around)
        if around.single or around.resets:
            return
        for word in block.words:
            if isinstance(word, Word) and word.name in ("M", "H"):
                written = self._findings.written(word.span)
                self._findings.report(FUNCTION_OUTPUT_EACH_TICK, word.span, word=written)
                return

    def _axis_command(self, bracket: BracketCommand, around: _Surrounding) -> None:
        """Report a distance or buffered motion that is commanded in each tick (RC-405)."""
        command, wrong = read_axis_command(bracket)
        for expression in command.expressions():
            self._frozen(expression)
        if wrong:
            return
        self._idle_words(bracket, command)
        check_target(command, self._names, self._findings, is_inch=self._is_inch)
        if command.buffered:
            self._extension(BUFFERED_MOTION, _keyword(bracket, "BUFFERED").span)
        if around.single or around.resets:
            return
        if command.kind == "distance" or command.buffered:
            word = "BUFFERED" if command.buffered else "G91"
            self._findings.report(
                AXIS_COMMANDED_EACH_TICK, bracket.span, axis=command.axis, word=word
            )

    def _idle_words(self, bracket: BracketCommand, command: AxisCommand) -> None:
        """Report keywords that the syntax allows and that have no effect (manual 4.5.1)."""
        axis = self._names.axis(command.axis)
        idle = []
        if command.has_idle_feed:
            idle.append(("FEED", "FEED", FEED_BESIDE_RAPID))
        elif command.rapid and command.feed is not None:
            idle.append(("G", "G00", RAPID_BESIDE_ENDLESS_FEED))
        is_choice = command.direction is not None and command.position is not None
        if is_choice and axis is not None and not axis.is_modulo:
            idle.append(("DIR", "DIR", DIRECTION_OF_LINEAR_AXIS))
        for name, word, reason in idle:
            span = _keyword(bracket, name).span
            self._findings.report(INDP_WORD_WITHOUT_EFFECT, span, word=word, reason=reason)

    # --- conditions ------------------------------------------------------------------------------

    def _condition(self, condition: Expression, frequency: str) -> None:
        if self._has_text(condition):
            self._extension(TEXT_IN_CYCLE, condition.span)
        operands = list(operands_of(condition, self._names))
        frozen = [operand for operand in operands if self._is_frozen(operand)]
        if len(frozen) < len(operands) or (frozen and frequency == "ONCE"):
            for operand in frozen:
                self._report_frozen(operand, in_condition=True)
        elif frequency == "ONCE":
            return
        elif frozen:
            self._never_changes(condition, frozen)
        else:
            self._findings.report(CONSTANT_CONDITION, condition.span)
        for comparison in comparisons_in(condition):
            self._compare(comparison)

    def _never_changes(self, condition: Expression, frozen: Sequence[Expression]) -> None:
        names = list(dict.fromkeys(self._name(operand) for operand in frozen))
        seen = _THOSE if len(names) > 1 else self._value(frozen[0])
        self._findings.report(
            CONDITION_NEVER_CHANGES,
            condition.span,
            names=", ".join(names),
            seen=seen,
        )

    def _compare(self, comparison: Binary) -> None:
        left, right = comparison.left, comparison.right
        for operand in (left, right):
            self._unit(operand)
        check_bounds(comparison, self._names, self._findings, is_inch=self._is_inch, in_cycle=True)
        if comparison.operator == "==":
            self._exact(left, right)

    def _unit(self, operand: Expression) -> None:
        """Report a comparison of a linear axis' position in a cycle defined under G70 (manual
        4.5.3).
        """
        if not self._is_inch or not is_position(operand, "ACT_POS", "CUR_POS", "CMD_POS"):
            return
        assert isinstance(operand, Variable)
        axis = self._names.axis(operand.parts[-1].name)
        if axis is not None and axis.is_linear:
            name = path_text(operand)
            self._findings.report(POSITION_COMPARED_IN_INCH, operand.span, name=name)

    def _exact(self, left: Expression, right: Expression) -> None:
        """Report an exact comparison of a moving position with anything but the target position."""
        for position, other in ((left, right), (right, left)):
            if is_position(position, "ACT_POS", "CUR_POS") and not is_position(other, "CMD_POS"):
                assert isinstance(position, Variable)
                self._findings.report(
                    EXACT_POSITION_COMPARISON, position.span, name=path_text(position)
                )
                return

    # --- frozen values ---------------------------------------------------------------------------

    def _frozen(self, expression: Expression) -> None:
        for operand in operands_of(expression, self._names):
            if self._is_frozen(operand):
                self._report_frozen(operand, in_condition=False)
            elif isinstance(operand, Variable):
                self._frozen_members(operand)

    def _frozen_members(self, operand: Variable) -> None:
        """Report the asynchronous members of a structure or array that is copied."""
        whole = resolve_aggregate(operand, self._names)
        if not isinstance(whole, Aggregate) or operand.synchronous:
            return
        for path, leaf, _ in leaf_cells(whole.node, "", 0):
            name = self._name(operand) + path
            if not leaf.synchronous and name not in self._reported:
                self._reported[name] = None
                self._findings.report(ASYNCHRONOUS_VALUE, operand.span, name=name, seen=_THEN)

    def _is_frozen(self, operand: Expression) -> bool:
        if isinstance(operand, Parameter):
            return not operand.call
        if not isinstance(operand, Variable):
            return False
        if is_program_variable(operand):
            return bool(operand.parts)
        if operand.family not in _DECLARED:
            return False
        location = resolve(operand, self._names)
        return isinstance(location, Location) and not is_live(operand, self._names)

    def _report_frozen(self, operand: Expression, *, in_condition: bool) -> None:
        """Report a frozen operand, once per cycle."""
        name = self._name(operand)
        if name in self._reported:
            return
        self._reported[name] = None
        message = (
            ASYNCHRONOUS_CONDITION
            if in_condition and isinstance(operand, Variable) and operand.family in _DECLARED
            else ASYNCHRONOUS_VALUE
        )
        self._findings.report(message, operand.span, name=name, seen=self._value(operand))

    def _name(self, operand: Expression) -> str:
        return " ".join(self._findings.written(operand.span).split())

    def _value(self, operand: Expression) -> Text:
        """Return with which value it is read, where that can be said."""
        assert isinstance(operand, Variable | Parameter)
        known_value = self._values.get(operand_key(operand))
        if known_value is not None:
            value = number_text(known_value.value)
            return Text(
                f"{value}, set in line {known_value.line}", f"{value} aus Zeile {known_value.line}"
            )
        return _THEN


def _keyword(bracket: BracketCommand, name: str) -> Keyword:
    """Return the keyword of this name, which the command has."""
    return next(item for item in bracket.items if isinstance(item, Keyword) and item.name == name)


def _inside(frequency: str, around: _Surrounding) -> _Surrounding:
    if frequency == "ALWAYS":
        return replace(around, skipped=False)
    single = around.single or frequency
    return replace(around, single=single, once=around.once or frequency == "ONCE", skipped=True)
