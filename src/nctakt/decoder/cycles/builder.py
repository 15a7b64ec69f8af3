# SPDX-License-Identifier: MIT
"""A checked realtime cycle -> the tree that runs in the tick (RC-2xx, RC-302, RC-403, RC-501).

Synchronous variables become loads and stores; asynchronous ones are read once and become constants
(``frozen``). The unit of length is the one active at the definition (RC-410).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import cast

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Span
from nctakt.decoder.axis_limits import feed_unit
from nctakt.decoder.blocks.axes.spindles import cycle_statement
from nctakt.decoder.blocks.technology_output import process_ticks
from nctakt.decoder.blocks.user_errors import parts
from nctakt.decoder.cycles.memory_budget import memory_bytes
from nctakt.decoder.cycles.texts import TextBuilder
from nctakt.decoder.values.expressions import ExpressionBuilder
from nctakt.decoder.values.fusing import Operand, constant, load
from nctakt.decoder.values.variables import Values
from nctakt.hli.function_codes import code_of
from nctakt.kernel import codes
from nctakt.kernel.cycles import actions, branches, expressions, fused, instructions, user_errors
from nctakt.kernel.cycles.branches import Branch, Reaction
from nctakt.kernel.cycles.conditions import Combination, Condition
from nctakt.kernel.cycles.cycles import RealtimeCycle
from nctakt.kernel.cycles.expressions import Constant, Expression
from nctakt.kernel.cycles.instructions import Statement, Watched
from nctakt.lists.declared.variables import SCALARS
from nctakt.lists.machine.axis_configuration import AxisConfiguration
from nctakt.messages.programs.checked_values import CYCLE_INDEX_OUT_OF_RANGE
from nctakt.nc import tree
from nctakt.nc.meaning.cost import command_steps, condition_steps, max_steps, word_steps
from nctakt.nc.parse.printer import format_expression
from nctakt.nc.vocabulary.single_axes.axis_commands import (
    DIRECTIONS,
    OFFSETS,
    AxisCommand,
    AxisTraits,
    read_axis_command,
)
from nctakt.nc.vocabulary.spindle_commands import split
from nctakt.nc.vocabulary.variables.system_variables import is_decoder_data
from nctakt.nc.vocabulary.variables.variable_table import Aggregate, Location

SCOPES = {"BLOCK": codes.BLOCK_SCOPE, "PROG": codes.PROG_SCOPE, "GLOBAL": codes.GLOBAL_SCOPE}

#: Numbers of the actions of ``#TIMER`` in ``kernel/base/timers.py``.
TIMER_ACTIONS = {"START": 1, "STOP": 2, "READ": 3, "CLEAR": 4}

#: Events that a cycle can record in a tick besides those of its statements.
_OWN_EVENTS = 3

_REACTIONS = {
    "ONCE": branches.IfOnce,
    "EDGE": branches.IfEdge,
    "ALWAYS": branches.IfAlways,
}


@dataclass(frozen=True, slots=True)
class FrozenValue:
    """An asynchronous variable that became a constant: text, value, span."""

    name: str
    value: float | str
    span: Span


@dataclass(frozen=True, slots=True)
class CycleBranch:
    """A branch of a cycle: span, frequency, and the node that counts its firings."""

    span: Span
    frequency: str
    node: Reaction


@dataclass(slots=True)
class CycleDefinition:
    """A built cycle, for results, listings and diagnosis data.

    ``axes``: those that its single-axis commands name. ``steps``: elementary instructions of each
    access to a text or structure. ``watched``: statements at which a session can stop.
    """

    serial: int
    identity: int
    scope: str
    span: Span
    cycle: RealtimeCycle
    statement: tree.RealtimeCycle
    reactions: list[CycleBranch] = field(default_factory=list)
    frozen: tuple[FrozenValue, ...] = ()
    axes: tuple[str, ...] = ()
    steps: Mapping[Span, int] = field(default_factory=dict)
    watched: Sequence[tuple[Span, Watched]] = ()


def _kind_of(location: Location) -> type[instructions.Assignment]:
    """The assignment to a variable of this name and type."""
    scalar = SCALARS[location.type]
    if location.name.startswith(("V.RTG.OVERRIDE", "V.RTA.OVERRIDE")):
        return instructions.AssignOverride
    if scalar.name == "BOOLEAN":
        return instructions.AssignBoolean
    return instructions.AssignInteger if scalar.is_integer else instructions.AssignReal


#: Probe rows that a condition can record in a tick: a change, and the begins of two series.
_PROBES_OF_A_CONDITION = 3


class CycleBuilder:
    """Builds one cycle; ``first_probe``: its number in the probe rows.

    The numbers after it belong to its conditions, ``$ELSE`` included. ``is_repeatable``: the result
    depends on the statement and the units alone, and nothing is reported or registered.
    """

    def __init__(self, values: Values, first_probe: int) -> None:
        self._values = values
        self._source_id = values.environment.source_id
        self._names = values.environment.names
        self._cell_count = len(values.environment.cells)
        self._texts = TextBuilder(values, self._index, self._keep)
        self._builder = ExpressionBuilder(
            self._leaf, compare_texts=self._texts.compare, macro=values.no_macro
        )
        self._actions = ActionBuilder(values, self._builder)
        self.is_repeatable = True
        self._conditions = 0
        self._statements = 0
        self._first_probe = first_probe
        self._reactions: list[CycleBranch] = []
        self._frozen: list[FrozenValue] = []
        self._watched: list[tuple[Span, Watched]] = []

    def build(
        self, statement: tree.RealtimeCycle, serial: int, identity: int, scope: str
    ) -> CycleDefinition:
        """Return the cycle of a definition."""
        body = self._sequence(statement.body)
        events = self._statements + self._texts.events + _OWN_EVENTS
        slots = self._values.environment.parameters.realtime_cycles.buffers
        size = memory_bytes(statement, slots)
        probes = 1 + _PROBES_OF_A_CONDITION * self._conditions
        self.is_repeatable = self.is_repeatable and not self._frozen and not self._texts.steps
        cycle = RealtimeCycle(body, serial, events, probes, size)
        cycle.probe = self._first_probe
        return CycleDefinition(
            serial,
            identity,
            scope,
            statement.span,
            cycle,
            statement,
            sorted(self._reactions, key=lambda reaction: reaction.span),
            self._distinct_frozen(),
            tuple(self._actions.axes),
            self._texts.steps,
            tuple(self._watched),
        )

    def _distinct_frozen(self) -> tuple[FrozenValue, ...]:
        """Return the frozen values in the order of the text; members in theirs."""
        accesses = {(frozen.span, frozen.name): frozen for frozen in self._frozen}
        return tuple(sorted(accesses.values(), key=lambda frozen: frozen.span))

    # --- statements -----------------------------------------------------------------------------

    def _sequence(self, statements: Sequence[tree.Statement]) -> Statement:
        built: list[Statement] = []
        for statement in statements:
            own = self._statement(statement)
            if self._values.environment.marks_blocks and not isinstance(statement, tree.If):
                watched = instructions.Watched(instructions.sequence(own))
                self._watched.append((statement.span, watched))
                own = [watched]
            built += own
        return instructions.sequence(built)

    def _statement(self, statement: tree.Statement) -> list[Statement]:
        self._statements += 1
        match statement:
            case tree.Assignment():
                return [self._assignment(statement)]
            case tree.If():
                return [self._if(statement)]
            case tree.Block():
                return self._technology(statement)
            case tree.Timer():
                return [self._timer(statement)]
            case tree.UserError():
                return [self._user_error(statement)]
            case tree.VariableBlock():
                built = self._builder.build(statement.variable)
                source = self._source_id(statement.span)
                return [instructions.Read(built.node, source, self._cost(statement))]
        raise AssertionError(statement)

    def _technology(self, block: tree.Block) -> list[Statement]:
        """The M and H functions and single-axis commands of a block, in their order (RC-403)."""
        environment = self._values.environment
        built: list[Statement] = []
        commands, words = split(block.words, environment.parameters.spindle_names)
        for command in commands:
            cost = command_steps(command, self._names)
            built.append(cycle_statement(self._values, self._builder, command, cost))
        self._statements += len(commands)
        self.is_repeatable = self.is_repeatable and not commands
        for word in words:
            if isinstance(word, tree.BracketCommand):
                built.append(self._actions.build(word))
                continue
            assert isinstance(word, tree.Word)
            assert isinstance(word.value, tree.Number)
            number = int(word.value.value)
            parameter = environment.parameters.function(word.name, number)
            ticks = process_ticks(parameter, environment.cycle_time_us)
            function = code_of(word.name, number)
            built.append(
                instructions.IssueTechnology(function, ticks, self._source_id(word.span), 1)
            )
        self._statements += len(built)
        return built

    def _timer(self, timer: tree.Timer) -> Statement:
        """``#TIMER`` of a cycle; timer 0 without ID (RC-401)."""
        identity: tree.Expression = tree.Number(timer.span, 0.0)
        for keyword in timer.keywords:
            assert isinstance(keyword, tree.Keyword)
            assert keyword.value is not None
            identity = keyword.value
        built = self._builder.build(identity)
        source = self._source_id(timer.span)
        action = TIMER_ACTIONS[timer.action]
        return instructions.CommandTimer(action, built.node, source, self._cost(timer))

    def _user_error(self, error: tree.UserError) -> Statement:
        """``#ERROR`` of a cycle (RC-402)."""
        self.is_repeatable = False
        error_parts = parts(error)
        identity = self._builder.build(error_parts.identity).node
        reaction = self._builder.build(error_parts.reaction).node
        values = user_errors.UserValue()
        for code, value in reversed(error_parts.values):
            if isinstance(value, tree.StringLiteral):
                text = self._values.environment.text_id(value.value)
                values = user_errors.TextValue(code, text, values)
            else:
                values = user_errors.NumberValue(code, self._builder.build(value).node, values)
        self._statements += len(error_parts.values)
        source = self._source_id(error.span)
        return user_errors.RaiseUserError(identity, reaction, values, source, self._cost(error))

    def _cost(self, statement: tree.Statement) -> int:
        return max_steps((statement,), self._names)

    def _if(self, statement: tree.If) -> Statement:
        frequency = statement.frequency
        if frequency is not None:
            node = self._condition(self._builder.condition(statement.condition))
            cost = condition_steps(statement.condition, self._names)
            body = self._sequence(statement.body)
            source = self._source_id(statement.span)
            reaction = _REACTIONS[frequency](node, body, source, cost)
            self._reactions.append(CycleBranch(statement.span, frequency, reaction))
            return reaction
        alternatives = [self._branch(statement.span, statement.condition, statement.body)]
        for elseif in statement.elseifs:
            alternatives.append(self._branch(elseif.span, elseif.condition, elseif.body))
        if statement.else_body is not None:
            alternatives.append(self._otherwise(statement))
        return branches.branches(alternatives)

    def _branch(
        self, span: Span, condition: tree.Expression, body: Sequence[tree.Statement]
    ) -> Branch:
        node = self._condition(self._builder.condition(condition))
        cost = condition_steps(condition, self._names)
        branch = Branch(node, self._sequence(body), self._source_id(span), cost)
        self._reactions.append(CycleBranch(span, "", branch))
        self._statements += 1
        return branch

    def _otherwise(self, statement: tree.If) -> Branch:
        """``$ELSE``: a branch that is always taken; it costs nothing itself."""
        assert statement.else_body is not None
        assert statement.else_span is not None
        body = self._sequence(statement.else_body)
        condition = self._condition(Condition())
        branch = Branch(condition, body, self._source_id(statement.else_span), 0)
        self._reactions.append(CycleBranch(statement.else_span, "", branch))
        self._statements += 1
        return branch

    def _condition(self, node: Condition) -> Condition:
        self._conditions += 1
        node.probe = self._first_probe + self._conditions
        if isinstance(node, Combination):
            self._condition(node.first)
            self._condition(node.second)
        return node

    def _assignment(self, statement: tree.Assignment) -> Statement:
        assert isinstance(statement.target, tree.Variable)
        source, cost = self._source_id(statement.span), self._cost(statement)
        copied = self._texts.assignment(statement, source, cost)
        if copied is not None:
            return copied
        location = self._values.locate(statement.target)
        value = self._builder.build(statement.value)
        if statement.operator != "=":
            target = self._builder.build(statement.target)
            if (
                statement.operator == "+="
                and target.load is not None
                and _kind_of(location) is instructions.AssignReal
            ):
                return instructions.AddToReal(target.load, value.node, source, cost)
            value = self._builder.combine(statement.operator[0], target, value)
        return self._store(statement.target, location, value, source, cost)

    def _store(
        self, target: tree.Variable, location: Location, value: Operand, source: int, cost: int
    ) -> Statement:
        scalar = SCALARS[location.type]
        cell, index = self._index(target, location)
        variable = expressions.Load(cell, self._cell_count)
        kind = _kind_of(location)
        assignment: instructions.Assignment
        if issubclass(kind, instructions.BoundedAssignment):
            assignment = kind(variable, value.node, scalar.low, scalar.high, source, cost)
        else:
            assignment = kind(variable, value.node, source, cost)
        if index is None:
            return assignment
        return instructions.AssignElement(index, assignment, source, cost)

    # --- variables ------------------------------------------------------------------------------

    def _leaf(self, node: tree.Variable | tree.Parameter) -> Operand:
        if isinstance(node, tree.Parameter):
            return self._freeze(node)
        if is_decoder_data(node):
            return self._freeze(node)
        location = self._values.locate(node)
        if not (location.synchronous or node.synchronous):
            return self._freeze(node)
        return self._load(node)

    def _load(self, node: tree.Variable) -> Operand:
        """The variable's value in the tick, in the unit of length of the definition."""
        location = self._values.locate(node)
        cell, index = self._index(node, location)
        built = load(cell, self._cell_count)
        if index is not None and built.load is not None:
            built = Operand(expressions.LoadElement(built.load, index))
        unit = self._values.state.length_unit_mm
        if location.is_length and unit != 1.0:
            return Operand(fused.DivideExpressionConstant(built.node, unit))
        return built

    def _freeze(self, node: tree.Variable | tree.Parameter) -> Operand:
        """An asynchronous value: the present one, a constant from now on."""
        value = self._values.evaluate_now(node)
        self._frozen.append(FrozenValue(format_expression(node), value, node.span))
        return constant(value)

    def _keep(self, name: str, value: float | str, span: Span) -> None:
        """List an asynchronous value that is a constant from now on."""
        self._frozen.append(FrozenValue(name, value, span))

    def _index(
        self, variable: tree.Variable, location: Location | Aggregate
    ) -> tuple[int, expressions.Index | None]:
        """Cell and computed part of an array access; constant indices are in the cell."""
        cell = location.cell
        further: expressions.Index | None = None
        indices = [index for part in variable.parts for index in part.indices]
        for index, dimension in reversed(list(zip(indices, location.dimensions, strict=True))):
            built = self._builder.build(index)
            if built.constant is not None and 0 <= round(built.constant) < dimension.count:
                cell += round(built.constant) * dimension.stride
                continue
            further = expressions.Index(
                built.node,
                dimension.stride,
                dimension.count,
                further,
                self._source_id(index.span),
                CYCLE_INDEX_OUT_OF_RANGE.number_of({"variable": location.name}),
            )
        return cell, further


@dataclass(frozen=True, slots=True)
class CyclePlace:
    """Where in a run a cycle is defined: its serial number, the first of its probes, its names."""

    serial: int
    first_probe: int
    identity: int
    scope: str


def built_cycle(values: Values, statement: tree.RealtimeCycle, at: CyclePlace) -> CycleDefinition:
    """Return the cycle of a definition: a kept one if building it would give the same."""
    environment, state = values.environment, values.state
    kept = environment.kept_cycles
    key = (
        id(statement), id(environment.names), environment.source_id(statement.span),
        at.serial, at.first_probe, at.identity, at.scope,
        state.length_unit_mm, state.inch,
    )  # fmt: skip
    found = None if kept is None else kept.find(key)
    if isinstance(found, tuple):
        return cast("CycleDefinition", found[0])
    builder = CycleBuilder(values, at.first_probe)
    built = builder.build(statement, at.serial, at.identity, at.scope)
    if kept is not None and builder.is_repeatable:
        # The definition holds its statement; the names, which the key has as well, are next to it.
        kept.keep(key, (built, environment.names), built.cycle)
    return built


# --- commands to single axes ----------------------------------------------------------------------


class ActionBuilder:
    """Builds the single-axis commands of a cycle (RC-405 … RC-410); ``axes``: those that it names.

    Units are those of the cycle's definition: positions and feeds of linear axes in mm or inch,
    feeds per minute, in the unit of P-CHAN-00108 under G71. Rotary axes: degrees, degrees per
    minute.
    """

    def __init__(self, values: Values, expressions: ExpressionBuilder) -> None:
        self._environment = values.environment
        self._state = values.state
        self._expressions = expressions
        self._feeds: dict[str, actions.FeedMemory] = {}
        self.axes: dict[str, None] = {}

    def build(self, bracket: tree.BracketCommand) -> Statement:
        """Return the statement of one command."""
        command, wrong = read_axis_command(bracket)
        assert not wrong, wrong
        self.axes[command.axis] = None
        source = self._environment.source_id(bracket.span)
        cost = word_steps(bracket, self._environment.names)
        nature = self._environment.names.axis(command.axis)
        assert nature is not None
        if command.stops:
            return actions.StopAxis(nature.number, source, cost)
        speed = self._speed(command)
        direction, has_direction = self._direction(command, nature)
        moving = (nature.number, speed, direction, has_direction, command.buffered, source, cost)
        if command.position is None:
            return actions.RunAxis(*moving)
        position = self._expressions.build(command.position).node
        offsets = 0
        if command.offset:
            offsets = (
                codes.ALL_OFFSETS if command.offset == "ALL" else 1 << OFFSETS.index(command.offset)
            )
        unit = self._state.length_unit_mm if nature.is_linear else 1.0
        target = actions.AxisTarget(position, unit, bool(command.absolute), offsets)
        return actions.MoveAxis(*moving, target)

    def _speed(self, command: AxisCommand) -> actions.Speed:
        """Return the speed: FEED of this command, of an earlier one with G01, or the rapid
        speed.
        """
        axis = self._axis(command.axis)
        memory = self._feeds.setdefault(command.axis, actions.FeedMemory())
        if command.feed is not None and not command.has_idle_feed:
            expression = self._expressions.build(command.feed).node
            listed_mm_min = self._environment.parameters.program_start.feed_unit_mm_min
            unit = feed_unit(axis, self._state, listed_mm_min)
            return actions.Feed(axis.max_speed, memory, expression, unit)
        if command.rapid is False:
            return actions.EarlierFeed(axis.max_speed, memory)
        return actions.Speed(axis.rapid_speed, memory)

    def _direction(self, command: AxisCommand, traits: AxisTraits) -> tuple[Expression, bool]:
        """DIR and whether it counts: for a motion to a position, only on a modulo axis."""
        direction = command.direction
        if direction is None or (command.position is not None and not traits.is_modulo):
            return Constant(0.0), False
        if isinstance(direction, tree.Name):
            return Constant(DIRECTIONS[direction.name]), True
        return self._expressions.build(direction).node, True

    def _axis(self, name: str) -> AxisConfiguration:
        return self._environment.axes[self._environment.axis_numbers[name]]
