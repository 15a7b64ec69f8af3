# SPDX-License-Identifier: MIT
"""Commands to spindles, of the main program and of realtime cycles (RC-404).

Direction and speed of the main program are modal for each spindle; the default is M5. A new speed
alone is a job with the active direction. The channel list decides when a job of a block is output
and awaited (``spindel[i].m3_synch`` …); a CNC spindle turns regardless, a PLC spindle receives only
jobs that are output.
"""

from __future__ import annotations

import math
from collections.abc import Generator, Mapping, Sequence
from dataclasses import replace

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import NOTHING, Span
from nctakt.base.misspelling import nearest
from nctakt.decoder.blocks.axes.cutting_speed import CuttingSpeeds
from nctakt.decoder.blocks.axes.gear_changes import GearChanges
from nctakt.decoder.blocks.technology_output import BlockFunction, process_ticks
from nctakt.decoder.state.queued.commands import Answer, Command
from nctakt.decoder.state.queued.spindle_commands import AwaitSpindle, SpindleAxis, SpindleJob
from nctakt.decoder.values.expressions import ExpressionBuilder
from nctakt.decoder.values.fusing import Operand, constant
from nctakt.decoder.values.overrides import override_factor
from nctakt.decoder.values.variables import Values
from nctakt.kernel.cycles.instructions import Statement
from nctakt.kernel.cycles.spindle_commands import CommandSpindle
from nctakt.lists.machine.channel_configuration import Spindle
from nctakt.messages.axes.axis_exchange import EXCHANGE_IN_SEARCH
from nctakt.messages.axes.c_axis import SPINDLE_IS_C_AXIS
from nctakt.messages.axes.couplings import (
    MAIN_SPINDLE_AS_SLAVE,
    NOT_WHILE_COUPLED,
    SLAVE_PROGRAMMED,
)
from nctakt.messages.axes.spindles import (
    DWELL_WITHOUT_SPINDLE,
    INVALID_SPINDLE_SPEED,
    M19_WITHOUT_SPEED,
    MAIN_SPINDLE_IN_USE,
    NO_SUCH_SPINDLE,
    SPINDLE_AXIS_LIST_MISSING,
    SPINDLE_OF_PLC_HAS_NO_AXIS,
    SPINDLE_SPEED_LIMITED,
    SPINDLE_WITHOUT_AXIS,
    TOOL_SPEED_RANGE,
)
from nctakt.messages.programs.checked_values import INDEX_OUT_OF_RANGE, UNKNOWN_VARIABLE
from nctakt.nc import tree
from nctakt.nc.meaning.axes import main_spindle_command
from nctakt.nc.vocabulary.functions import (
    CLOCKWISE,
    CONSTANT_SPEED,
    COUNTERCLOCKWISE,
    CUTTING_SPEED,
    GEAR_STEP,
    NO_SPINDLE_OVERRIDE,
    SPINDLE_LIMIT,
    SPINDLE_POSITION,
    SPINDLE_STOP,
)
from nctakt.nc.vocabulary.spindle_commands import PUTAX, SpindleCommand
from nctakt.nc.vocabulary.variables.resolution import path_text
from nctakt.nc.vocabulary.variables.spindle_variables import OF_MAIN_SPINDLE
from nctakt.nc.vocabulary.variables.system_variables import SystemVariable

#: Degrees per second of a revolution per minute.
DEGREES_PER_S = 6.0

#: G functions that decide the meaning of S.
SPEED_FUNCTIONS = frozenset(
    (CUTTING_SPEED, CONSTANT_SPEED, SPINDLE_LIMIT, GEAR_STEP, NO_SPINDLE_OVERRIDE)
)

_DIRECTIONS = {CLOCKWISE: 1, COUNTERCLOCKWISE: -1}


@dataclass(slots=True)
class _Modal:
    """The modal words of a spindle: direction, revolutions per minute, degrees of M19.

    ``factor``: the override of the program (``S[OVERRIDE SPEED_FACT=50]``).
    """

    function: int = SPINDLE_STOP
    speed: float = 0.0
    position: float = 0.0
    factor: float = 1.0

    @property
    def turning_speed(self) -> float:
        """The speed with the override of the program; 0 without M3 or M4."""
        return self.speed * self.factor if self.function in _DIRECTIONS else 0.0


@dataclass(slots=True)
class SpindleWords:
    """The commands to spindles of one program."""

    values: Values
    cutting: CuttingSpeeds
    gears: GearChanges
    modal: dict[int, _Modal] = field(default_factory=dict)
    dwell_turns: float = 0.0
    _loads_gear: bool = False
    _ignores_override: bool = False

    def __post_init__(self) -> None:
        self.values.spindle_value = self.value
        self.values.state.main_spindle = main_of(self.values.environment.parameters.spindles)

    def value(self, variable: tree.Variable, system: SystemVariable) -> float:
        """Return V.SPDL or V.SPDL_PROG; raises ``DecodeError`` for an unknown spindle."""
        spindles = self.values.environment.parameters.spindles
        if system.subject == "NBR_IN_CHANNEL":
            return float(len(spindles))
        index = self._index_of(variable, system)
        modal = self.modal.get(index, _Modal())
        if system.subject in OF_MAIN_SPINDLE and index != self.values.state.main_spindle:
            return 0.0
        match system.subject:
            case "LOG_AX_NR":
                return float(spindles[index].logical_number)
            case "PLC_CONTROL":
                return float(spindles[index].plc_controlled)
            case "SPEED":
                return modal.speed
            case "MOVE_CMD":
                return float(modal.function)
            case "POSITION":
                return modal.position
            case "MAX_SPEED":
                return self.cutting.limit
            case "CONST_CUT_SPEED":
                return self.cutting.surface
        return self.dwell_turns

    def _index_of(self, variable: tree.Variable, system: SystemVariable) -> int:
        environment = self.values.environment
        names = names_of(environment.parameters.spindles)
        if system.element is not None:
            index = int(self.values.constant_value(system.element) or 0)
            if not 0 <= index < len(names):
                self.values.fail(
                    INDEX_OUT_OF_RANGE,
                    system.element.span,
                    variable=path_text(variable),
                    index=index,
                    count=len(names),
                )
            return index
        index = index_of(self.values, system.axis)
        if index < 0:
            near = nearest(system.axis, environment.parameters.spindle_names) or NOTHING
            name = path_text(variable)
            self.values.fail(
                UNKNOWN_VARIABLE, variable.span, name=name, nearest=near, declared=NOTHING
            )
        return index

    def choose_main(self, statement: tree.HashCommand, number: int) -> Generator[Command, Answer]:
        """Execute ``#MAIN SPINDLE``: another spindle takes S, M3 … M5, M19, G95 and G96."""
        command = main_spindle_command(statement)
        assert command is not None
        spindles = self.values.environment.parameters.spindles
        if self.cutting.is_active:
            self.values.fail(MAIN_SPINDLE_IN_USE, statement.span, word="G96")
        if command.number is None:
            index = index_of(self.values, command.name) if command.name else main_of(spindles)
        else:
            value = yield from self.values.evaluate(command.number, number)
            numbers = [spindle.logical_number for spindle in spindles]
            if value not in numbers:
                known = ", ".join(map(str, numbers))
                self.values.fail(NO_SUCH_SPINDLE, statement.span, spindle=f"{value:g}", known=known)
            index = numbers.index(int(value))
        master = self.values.state.couplings.master_of_spindle(index)
        if master >= 0:
            names = {"slave": spindles[index].name, "master": spindles[master].name}
            self.values.fail(MAIN_SPINDLE_AS_SLAVE, statement.span, **names)
        self.values.state.main_spindle = index

    def is_concerned(self, numbers: Mapping[int, Span]) -> bool:
        """Return whether a block has G96, G97 or G196."""
        return not SPEED_FUNCTIONS.isdisjoint(numbers)

    def change_gear(
        self, words: list[tree.BlockWord], commands: Sequence[SpindleCommand], number: int
    ) -> Generator[Command, Answer, list[tree.BlockWord]]:
        """Process M40 … M45; return the other words. A turning spindle turns on afterwards."""
        others = []
        for word in words:
            stage = self.gears.stage_of(word)
            if not stage:
                others.append(word)
                continue
            index, _ = find(self.values, "", word.span)
            is_changed = yield from self.gears.change(index, stage, word.span, number)
            modal = self.modal.get(index, _Modal())
            is_commanded = any(index_of(self.values, one.name) == index for one in commands)
            if is_changed and modal.function in _DIRECTIONS and not is_commanded:
                source = self.values.environment.source_id(word.span)
                speed_v = DEGREES_PER_S * modal.turning_speed
                yield SpindleJob(source, number, index, modal.function, speed_v, 0.0, 0, 0)
        return others

    def speed_functions(
        self, numbers: Mapping[int, Span], number: int
    ) -> Generator[Command, Answer]:
        """Process G96, G97 and G196 of a block, before its S."""
        self.cutting.sets_limit = False
        self._loads_gear = GEAR_STEP in numbers
        self._ignores_override = NO_SPINDLE_OVERRIDE in numbers
        found = SPEED_FUNCTIONS.intersection(numbers) - {GEAR_STEP, NO_SPINDLE_OVERRIDE}
        if found:
            span = numbers[min(found)]
            index, _ = find(self.values, "", span)
            if CUTTING_SPEED in found and self.values.state.couplings.spindles(index):
                self.values.fail(NOT_WHILE_COUPLED, span, command="G96", other="#AX LINK")
            yield from self.cutting.functions(numbers, index, span, number)

    def exchange(self, command: SpindleCommand, number: int) -> Generator[Command, Answer]:
        """Make a spindle at rest give up its axis, or take it back."""
        (word,) = command.exchanges
        name, span = f"{command.name}[{word}]", command.span
        state = self.values.state
        index, spindle = _listed(self.values, command.name, span)
        if spindle.plc_controlled:
            self.values.fail(SPINDLE_OF_PLC_HAS_NO_AXIS, span, command=name, spindle=spindle.name)
        if state.couplings.spindles(index) or state.couplings.master_of_spindle(index) >= 0:
            self.values.fail(NOT_WHILE_COUPLED, span, command=name, other="#AX LINK")
        if state.is_searching:
            self.values.fail(EXCHANGE_IN_SEARCH, span, command=name)
        source = self.values.environment.source_id(span)
        if word == PUTAX:
            yield AwaitSpindle(source, number, index)
            state.spindles_without_axis.add(index)
        else:
            state.spindles_without_axis.discard(index)
        yield SpindleAxis(source, number, index, word == PUTAX)

    def functions(
        self, command: SpindleCommand, number: int
    ) -> Generator[Command, Answer, list[BlockFunction]]:
        """Return the job of a command as a function of the block; empty if there is none."""
        index, spindle = self._spindle(command)
        master = self.values.state.couplings.master_of_spindle(index)
        if master >= 0:
            name = self.values.environment.parameters.spindles[master].name
            self.values.fail(SLAVE_PROGRAMMED, command.span, axis=spindle.name, master=name)
        modal = self.modal.setdefault(index, _Modal())
        is_main = index == self.values.state.main_spindle
        if command.override is not None:
            modal.factor = yield from override_factor(self.values, command.override, number)
            if modal.function == SPINDLE_STOP:
                return []
        if is_main:
            self.cutting.factor = modal.factor
        if command.speed is not None:
            is_other_value = yield from self._take_speed(command, index, command.speed, number)
            if is_other_value and not command.functions:
                return []
        if is_main and self.cutting.is_active and self.cutting.surface > 0.0:
            start, speed = self.cutting.start(index, command.span, number)
            modal.speed = speed / modal.factor
            yield start
        position = 0.0
        if command.position is not None:
            position = yield from self.values.evaluate(command.position, number)
            modal.position = position
        key = self._change_function(modal, command)
        if not key:
            return []
        function = SPINDLE_POSITION if key == "m19" else modal.function
        speed = 0.0 if function == SPINDLE_STOP else modal.speed * modal.factor
        if function in _DIRECTIONS:
            check_tool_range(self.values, index, speed, command.span)
        command.ignores_override = command.ignores_override or self._ignores_override
        job = (function, speed, position, _direction(command))
        functions = self._job(command, number, (index, spindle, key), job)
        for slave in self.values.state.couplings.spindles(index):
            follower = self.values.environment.parameters.spindles[slave]
            if function in _DIRECTIONS:
                if command.speed is not None:
                    warn_of_speed(self.values, slave, speed, command.span)
                check_tool_range(self.values, slave, speed, command.span)
            self.modal[slave] = replace(modal)
            functions += self._job(command, number, (slave, follower, key), job)
        return functions

    def _take_speed(
        self, command: SpindleCommand, index: int, expression: tree.Expression, number: int
    ) -> Generator[Command, Answer, bool]:
        """Take over the value of S; return whether it is a gear step or limit, and no speed."""
        modal, span = self.modal[index], expression.span
        is_main = index == self.values.state.main_spindle
        speed = yield from self._speed(expression, number)
        if self._ignores_override and not command.name and not command.functions:
            return False  # the value is required by the form of the block only (208171531)
        if self._loads_gear:
            is_turning = modal.function in _DIRECTIONS
            yield from self.gears.load(index, speed, span, number, turns=is_turning)
            return True
        if is_main and self.cutting.sets_limit:
            yield from self.cutting.set_limit(speed, index, span, number)
            return True
        if is_main and self.cutting.is_active:
            self.cutting.surface = speed
            return False
        modal.speed = speed
        stage = self.gears.chosen(index, speed, span) if is_main else 0
        if stage:
            yield from self.gears.change(index, stage, span, number)
        warn_of_speed(self.values, index, modal.speed, span)
        return False

    def _change_function(self, modal: _Modal, command: SpindleCommand) -> str:
        """Make the function of a command modal; return the key of its job, "" if there is none."""
        if SPINDLE_POSITION in command.functions:
            modal.function = SPINDLE_STOP
            if modal.speed <= 0.0:
                self.values.fail(M19_WITHOUT_SPEED, command.span)
            return "m19"
        if command.functions:
            modal.function = command.functions[0]
            return f"m{modal.function}"
        return "" if modal.function == SPINDLE_STOP else "s"

    def dwell_s(self, block: tree.Block, number: int) -> Generator[Command, Answer, float | None]:
        """Return the dwell time in s of ``G04 S10``, revolutions of the main spindle."""
        for word in filter(is_revolutions, block.words):
            assert isinstance(word, tree.Word)
            assert word.value is not None
            count = yield from self.values.evaluate(word.value, number)
            self.dwell_turns = count
            return self.revolutions_s(count, word.span)
        return None

    def revolutions_s(self, count: float, span: Span) -> float:
        """Return the time in s of ``count`` revolutions of the main spindle at its programmed
        speed.
        """
        modal = self.modal.get(self.values.state.main_spindle)
        if modal is not None and modal.turning_speed > 0.0:
            return 60.0 * count / modal.turning_speed
        self.values.fail(DWELL_WITHOUT_SPINDLE, span)

    def _job(
        self,
        command: SpindleCommand,
        number: int,
        target: tuple[int, Spindle, str],
        job: tuple[int, float, float, int],
    ) -> list[BlockFunction]:
        index, spindle, key = target
        function, speed, position, direction = job
        output_function = spindle.functions[key]
        if spindle.plc_controlled and output_function.synchronisation == "NO_SYNCH":
            return []
        synchronisation = (
            "MOS"
            if output_function.synchronisation == "NO_SYNCH"
            else output_function.synchronisation
        )
        ticks = process_ticks(output_function, self.values.environment.cycle_time_us)
        source = self.values.environment.source_id(command.span)
        speed_v = DEGREES_PER_S * speed
        output = SpindleJob(
            source,
            number,
            index,
            function,
            speed_v,
            position,
            direction,
            ticks,
            command.ignores_override,
        )
        return [BlockFunction(synchronisation, output, AwaitSpindle(source, number, index))]

    def _speed(self, expression: tree.Expression, number: int) -> Generator[Command, Answer, float]:
        value = yield from self.values.evaluate(expression, number)
        if value < 0.0:
            self.values.fail(INVALID_SPINDLE_SPEED, expression.span, value=value)
        return value

    def _spindle(self, command: SpindleCommand) -> tuple[int, Spindle]:
        return find(self.values, command.name, command.span)


def is_revolutions(word: tree.BlockWord) -> bool:
    """Return whether a word of a block with G04 is its time in revolutions."""
    return isinstance(word, tree.Word) and word.name == "S"


def main_of(spindles: Sequence[Spindle]) -> int:
    """Return the index of the main spindle of the channel list (P-CHAN-00051); -1 without one."""
    return next((index for index, spindle in enumerate(spindles) if spindle.is_main), -1)


def index_of(values: Values, name: str) -> int:
    """Return the index of a spindle by its name in the program; -1 for an unknown one.

    The name of the main spindle, or no name, means the one selected by ``#MAIN SPINDLE``; the
    others have their names in the channel list (P-CHAN-00007).
    """
    spindles = values.environment.parameters.spindles
    listed_main = main_of(spindles)
    if not name or (listed_main >= 0 and name == spindles[listed_main].name):
        return values.state.main_spindle
    for index, spindle in enumerate(spindles):
        if name in (spindle.name, spindle.list_name):
            return index
    return -1


def find(values: Values, name: str, span: Span) -> tuple[int, Spindle]:
    """Return index and configuration of the spindle with this name; empty: the main spindle.

    It has its axis.
    """
    index, spindle = _listed(values, name, span)
    if index in values.state.spindles_without_axis:
        values.fail(SPINDLE_WITHOUT_AXIS, span, spindle=spindle.name)
    return index, spindle


def _listed(values: Values, name: str, span: Span) -> tuple[int, Spindle]:
    """Return index and configuration of a spindle whose axis does not belong to the path."""
    index = index_of(values, name)
    assert index >= 0, name
    spindle = values.environment.parameters.spindles[index]
    if not spindle.plc_controlled and index not in values.environment.spindle_gears:
        values.fail(
            SPINDLE_AXIS_LIST_MISSING, span, spindle=spindle.name, logical=spindle.logical_number
        )
    # The C axis is made of the main spindle of the list.
    c_axis = values.environment.places.c_axis_name if spindle.is_main else ""
    if c_axis:
        values.fail(SPINDLE_IS_C_AXIS, span, spindle=spindle.name, axis=c_axis)
    return index, spindle


def check_tool_range(values: Values, index: int, speed: float, span: Span) -> None:
    """Check that a speed in 1/min is one of the tool in the spindle (P-AXIS-00474)."""
    gears = values.environment.spindle_gears.get(index)
    if gears is None or not gears.checks_tool or speed == 0.0:
        return
    low, high = (limit / DEGREES_PER_S for limit in gears.tool_range)
    if speed < low or speed > (high or math.inf):
        name = values.environment.parameters.spindles[index].name
        values.fail(TOOL_SPEED_RANGE, span, spindle=name, speed=speed, low=low, high=high)


def warn_of_speed(values: Values, index: int, speed: float, span: Span) -> None:
    """Warn if the requested speed in 1/min exceeds the limit of the spindle (P-AXIS-00212)."""
    gears = values.environment.spindle_gears.get(index)
    limit = math.inf if gears is None else gears.gear.speed_v
    if speed * DEGREES_PER_S <= limit * (1.0 + 1e-9):
        return
    name = values.environment.parameters.spindles[index].name
    values.warn(SPINDLE_SPEED_LIMITED, span, spindle=name, limit=limit / DEGREES_PER_S, speed=speed)


def cycle_statement(
    values: Values, builder: ExpressionBuilder, command: SpindleCommand, cost: int
) -> Statement:
    """Return the instruction of a checked command in a realtime cycle."""
    index, spindle = find(values, command.name, command.span)
    function = next(
        (choice for choice in (SPINDLE_POSITION, SPINDLE_STOP) if choice in command.functions), 0
    )
    function = function or next(turn for turn in command.functions if turn in _DIRECTIONS)
    ticks = process_ticks(spindle.functions[f"m{function}"], values.environment.cycle_time_us)
    speed = _built(builder, command.speed)
    if command.speed is not None and speed.constant is not None:
        warn_of_speed(values, index, speed.constant, command.speed.span)
    position = _built(builder, command.position)
    source = values.environment.source_id(command.span)
    return CommandSpindle(
        index, function, speed.node, position.node, _direction(command), ticks, source, cost
    )


def _direction(command: SpindleCommand) -> int:
    """Return 1 for M3, -1 for M4; 0 if a command has neither."""
    turns = (_DIRECTIONS[turn] for turn in command.functions if turn in _DIRECTIONS)
    return next(turns, 0)


def _built(builder: ExpressionBuilder, expression: tree.Expression | None) -> Operand:
    return constant(0.0) if expression is None else builder.build(expression)


def names_of(spindles: Sequence[Spindle]) -> tuple[str, ...]:
    """Return the names of the spindles in programs."""
    return tuple(spindle.name for spindle in spindles)
