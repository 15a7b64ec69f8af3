# SPDX-License-Identifier: MIT
"""Each argument of a packed command is in the column that has its name."""

from __future__ import annotations

import ast
import importlib
import pkgutil
import sys
from collections.abc import Iterator
from dataclasses import is_dataclass
from pathlib import Path

import pytest

import nctakt.decoder
from nctakt.decoder.state.queued import commands
from nctakt.decoder.state.queued.axis_commands import (
    EndOscillation,
    Home,
    MoveAlone,
    Oscillate,
    Refer,
    SetSoftwareLimits,
)
from nctakt.decoder.state.queued.commands import Command
from nctakt.decoder.state.queued.packing import has_own_arguments, pack
from nctakt.decoder.state.queued.probe_commands import Touch, TouchEnd
from nctakt.decoder.state.queued.spindle_commands import (
    AwaitSpindle,
    CuttingSpeed,
    SpindleAxis,
    SpindleJob,
    SpindleLimits,
)
from nctakt.decoder.state.queued.start_block import SingleStep
from nctakt.decoder.state.queued.tool_life import SetToolLife, ToolLifeFactors
from nctakt.kernel import codes, rows

SOURCE, NUMBER, REFERENCE = 901, 902, 903

#: Command without source and number, its kind and what is in the columns of that kind. No two
#: values of a command are equal, but for those that are 0 or 1.
CASES: list[tuple[type[Command], dict[str, object], int, dict[int, float]]] = [
    (commands.Dwell, {"ticks": 11}, rows.DWELL, {rows.DWELL_TICKS: 11}),
    (
        commands.LoadCycle,
        {"cycle": None, "identity": 11, "scope": 12, "definition_only": False},
        rows.DEFINE_CYCLE,
        {rows.CYCLE_SLOT: REFERENCE, rows.CYCLE_STARTS: 1},
    ),
    (
        commands.CycleControl,
        {"action": 11, "identity": 12},
        rows.CONTROL_CYCLE,
        {rows.CONTROL_ACTION: 11, rows.CONTROL_IDENTITY: 12},
    ),
    (
        commands.TechnologyOutput,
        {"function": 11, "ticks": 12, "value": 13, "lead": 0.5, "lead_kind": 2},
        rows.TECHNOLOGY,
        {
            rows.TECHNOLOGY_FUNCTION: 11,
            rows.TECHNOLOGY_TICKS: 12,
            rows.TECHNOLOGY_HAS_VALUE: 1,
            rows.TECHNOLOGY_VALUE: 13,
            rows.TECHNOLOGY_LEAD: 0.5,
            rows.TECHNOLOGY_LEAD_KIND: 2,
        },
    ),
    (
        commands.TechnologyOutput,
        {"function": 11, "ticks": 12},
        rows.TECHNOLOGY,
        {rows.TECHNOLOGY_HAS_VALUE: 0, rows.TECHNOLOGY_VALUE: 0},
    ),
    (
        commands.AwaitAcknowledge,
        {"function": 11},
        rows.AWAIT_ACKNOWLEDGE,
        {rows.AWAITED_FUNCTION: 11},
    ),
    (
        SpindleJob,
        {
            "spindle": 11,
            "function": 12,
            "speed_v": 13.0,
            "position": 14.0,
            "direction": 15,
            "ticks": 16,
        },
        rows.SPINDLE,
        {
            rows.JOB_SPINDLE: 11,
            rows.JOB_FUNCTION: 12,
            rows.JOB_SPEED: 13,
            rows.JOB_POSITION: 14,
            rows.JOB_DIRECTION: 15,
            rows.JOB_TICKS: 16,
        },
    ),
    (AwaitSpindle, {"spindle": 11}, rows.AWAIT_SPINDLE, {rows.JOB_SPINDLE: 11}),
    (
        commands.WriteVariable,
        {"cell": 11, "value": 12.0, "is_reported": True},
        rows.WRITE_VARIABLE,
        {rows.VARIABLE_CELL: 11, rows.VARIABLE_VALUE: 12, rows.VARIABLE_IS_REPORTED: 1},
    ),
    (
        commands.WriteText,
        {"cell": 11, "first": 12, "data": b"AB", "zeros": 13},
        rows.WRITE_TEXT,
        {
            rows.TEXT_CELL: 11,
            rows.TEXT_FIRST: 12,
            rows.TEXT_COUNT: 2,
            rows.TEXT_ZEROS: 13,
            rows.TEXT_CHARACTERS: ord("A"),
            rows.TEXT_CHARACTERS + 1: ord("B"),
        },
    ),
    (commands.UserMessage, {"text": "T"}, rows.MESSAGE, {rows.MESSAGE_TEXT: REFERENCE}),
    (
        commands.SetOffset,
        {"axis": 11, "kind": 12, "value": 13.0},
        rows.SET_OFFSET,
        {rows.OFFSET_AXIS: 11, rows.OFFSET_KIND: 12, rows.OFFSET_VALUE: 13},
    ),
    (
        commands.SetOrigin,
        {"axis": 11, "value": 12.0},
        rows.SET_ORIGIN,
        {rows.ORIGIN_AXIS: 11, rows.ORIGIN_VALUE: 12},
    ),
    (
        commands.SetTransformation,
        {"map_number": 11, "of_segments": 12},
        rows.SET_TRANSFORMATION,
        {rows.TRANSFORMATION_NUMBER: 11, rows.TRANSFORMATION_OF_SEGMENTS: 12},
    ),
    (
        commands.SetTurn,
        {"axes": (11, 12, 14), "matrix": (21.0, 22.0, 23.0, 24.0, 25.0, 26.0, 27.0, 28.0, 29.0)},
        rows.SET_TURN,
        {
            rows.TURN_FIRST: 11,
            rows.TURN_SECOND: 13,
            rows.TURN_THIRD: 15,
            rows.TURN_MATRIX: 21,
            rows.TURN_MATRIX + 8: 29,
        },
    ),
    (
        commands.Freeze,
        {"serial": 11, "name": "N", "value": 12.0},
        rows.FREEZE,
        {rows.FROZEN_CYCLE: 11, rows.FROZEN_NAME: REFERENCE, rows.FROZEN_VALUE: 12},
    ),
    (
        commands.UserErrorReport,
        {"identity": 11, "reaction": 12},
        rows.USER_ERROR,
        {rows.ERROR_IDENTITY: 11, rows.ERROR_REACTION: 12},
    ),
    (
        commands.UserErrorValue,
        {"code": 11, "value": 12.0},
        rows.USER_VALUE,
        {rows.VALUE_KEYWORD: 11, rows.VALUE_NUMBER: 12},
    ),
    (
        commands.UserErrorText,
        {"code": 11, "text": 12},
        rows.USER_TEXT,
        {rows.USER_TEXT_KEYWORD: 11, rows.USER_TEXT_NUMBER: 12},
    ),
    (commands.UserErrorStop, {"reaction": 11}, rows.USER_STOP, {rows.STOP_REACTION: 11}),
    (commands.Flush, {"waits": True}, rows.FLUSH, {rows.IS_ANSWERED: 1}),
    (commands.ReadRealtime, {"cell": 11}, rows.READ, {rows.IS_ANSWERED: 1, rows.READ_CELL: 11}),
    (
        commands.PositionRequest,
        {"axes": (11, 12)},
        rows.POSITIONS,
        {
            rows.IS_ANSWERED: 1,
            rows.POSITIONS_COUNT: 2,
            rows.POSITIONS_AXES: 11,
            rows.POSITIONS_AXES + 1: 12,
        },
    ),
    (
        commands.BlockMark,
        {"calls": 11, "depth": 12},
        rows.BLOCK_MARK,
        {rows.MARK_TICK: REFERENCE, rows.MARK_CALLS: 11, rows.MARK_DEPTH: 12},
    ),
    (
        commands.WaitMark,
        {"reason": 11, "cell": 12},
        rows.WAIT_MARK,
        {rows.WAIT_REASON: 11, rows.WAIT_CELL: 12},
    ),
    (
        commands.ProgramTimer,
        {"timer": 11, "action": 12},
        rows.TIMER,
        {rows.TIMER_NUMBER: 11, rows.TIMER_ACTION: 12},
    ),
    (
        commands.FixedStop,
        {
            "axis": 11,
            "is_on": True,
            "limit": 12.0,
            "ticks": 13,
            "begin": 14.0,
            "end": 15.0,
            "needed": True,
        },
        rows.FIXED_STOP,
        {
            rows.FIXED_STOP_AXIS: 11,
            rows.FIXED_STOP_IS_ON: 1,
            rows.FIXED_STOP_LIMIT: 12,
            rows.FIXED_STOP_TICKS: 13,
            rows.FIXED_STOP_FROM: 14,
            rows.FIXED_STOP_TO: 15,
            rows.FIXED_STOP_IS_NEEDED: 1,
        },
    ),
    (commands.FixedStopEnd, {}, rows.FIXED_STOP_END, {}),
    (
        commands.Measure,
        {"function": 11, "ticks": 12, "residual": 13.0, "value": 14},
        rows.MEASURE,
        {
            rows.MEASURE_FUNCTION: 11,
            rows.MEASURE_TICKS: 12,
            rows.MEASURE_RESIDUAL: 13,
            rows.MEASURE_HAS_VALUE: 1,
            rows.MEASURE_VALUE: 14,
        },
    ),
    (commands.MeasureEnd, {}, rows.MEASURE_END, {}),
    (
        Touch,
        {
            "part": 0.25,
            "ticks": -1,
            "level": 1,
            "continues": False,
            "needed": True,
            "may_be_pressed": False,
        },
        rows.TOUCH,
        {
            rows.TOUCH_PART: 0.25,
            rows.TOUCH_TICKS: -1,
            rows.TOUCH_LEVEL: 1,
            rows.TOUCH_CONTINUES: 0,
            rows.TOUCH_IS_NEEDED: 1,
            rows.TOUCH_MAY_BE_PRESSED: 0,
        },
    ),
    (TouchEnd, {}, rows.TOUCH_END, {}),
    (
        Home,
        {"axis": 2, "distance": -0.5, "speed": 10.0},
        rows.HOME,
        {rows.HOMED_AXIS: 2, rows.HOMING_DISTANCE: -0.5, rows.HOMING_SPEED: 10.0},
    ),
    (
        Refer,
        {"axis": 2, "position": 7.5},
        rows.REFER,
        {rows.HOMED_AXIS: 2, rows.HOMING_DISTANCE: 7.5},
    ),
    (
        SingleStep,
        {"is_disabled": True},
        rows.SINGLE_STEP,
        {rows.STEP_IS_LOCKED: 1, rows.STEP_RESOLUTION: -1},
    ),
    (SingleStep, {"resolution": 10}, rows.SINGLE_STEP, {rows.STEP_RESOLUTION: 10}),
    (
        SetToolLife,
        {"action": 3, "tool": 4, "basic": 5, "time": 6.0, "distance": 7.0},
        rows.TOOL_LIFE,
        {
            rows.LIFE_ACTION: 3,
            rows.LIFE_TOOL: 4,
            rows.LIFE_BASIC: 5,
            rows.LIFE_TIME: 6.0,
            rows.LIFE_DISTANCE: 7.0,
        },
    ),
    (
        ToolLifeFactors,
        {"time": 2.0, "distance": 3.0},
        rows.TOOL_LIFE,
        {
            rows.LIFE_ACTION: codes.LIFE_FACTORS,
            rows.LIFE_TIME: 2.0,
            rows.LIFE_DISTANCE: 3.0,
        },
    ),
    (
        MoveAlone,
        {"axis": 2, "value": 5.0, "speed": 10.0, "is_relative": True},
        rows.MOVE_ALONE,
        {
            rows.ALONE_AXIS: 2,
            rows.ALONE_VALUE: 5.0,
            rows.ALONE_SPEED: 10.0,
            rows.ALONE_IS_RELATIVE: 1,
        },
    ),
    (
        Oscillate,
        {
            "axis": 2,
            "first": -5.0,
            "second": 5.0,
            "stroke": 10.0,
            "speed": 100.0,
            "first_ticks": 50,
            "second_ticks": 60,
            "count": -1,
        },
        rows.OSCILLATE,
        {
            rows.SWUNG_AXIS: 2,
            rows.SWING_FIRST: -5.0,
            rows.SWING_SECOND: 5.0,
            rows.SWING_STROKE: 10.0,
            rows.SWING_SPEED: 100.0,
            rows.SWING_FIRST_TICKS: 50,
            rows.SWING_SECOND_TICKS: 60,
            rows.SWING_COUNT: -1,
        },
    ),
    (
        EndOscillation,
        {"axis": 2, "how": 1, "speed": 50.0},
        rows.END_OSCILLATION,
        {rows.ENDED_AXIS: 2, rows.ENDED_HOW: 1, rows.ENDED_SPEED: 50.0},
    ),
    (
        SetSoftwareLimits,
        {"axis": 2, "low": -7.5, "high": 8.5},
        rows.SOFTWARE_LIMITS,
        {rows.LIMITED_AXIS: 2, rows.LIMIT_LOW: -7.5, rows.LIMIT_HIGH: 8.5},
    ),
    (commands.ClearHistory, {}, rows.CLEAR_HISTORY, {}),
    (commands.EmptyBlock, {}, rows.EMPTY_BLOCK, {}),
    (
        CuttingSpeed,
        {"spindle": 1, "surface_v": 2000.0, "axis": 2, "centre": 5.0, "limit_v": 9000.0},
        rows.CUTTING_SPEED,
        {
            rows.CUTTING_SPINDLE: 1,
            rows.CUTTING_SURFACE: 2000.0,
            rows.CUTTING_AXIS: 2,
            rows.CUTTING_CENTRE: 5.0,
            rows.CUTTING_LIMIT: 9000.0,
        },
    ),
    (
        SpindleLimits,
        {"spindle": 1, "low_v": 2.0, "high_v": 3.0, "acceleration": 4.0, "jerk": 5.0} | {"step": 2},
        rows.SPINDLE_LIMITS,
        {
            rows.LIMITED_SPINDLE: 1,
            rows.LIMITED_LOW: 2.0,
            rows.LIMITED_HIGH: 3.0,
            rows.LIMITED_ACCELERATION: 4.0,
            rows.LIMITED_JERK: 5.0,
            rows.LIMITED_BY_GEAR: 2,
        },
    ),
    (
        SpindleAxis,
        {"spindle": 2, "gives": True},
        rows.SPINDLE_AXIS,
        {rows.GIVING_SPINDLE: 2, rows.GIVES_AXIS: 1},
    ),
    (commands.LoopBegin, {}, rows.LOOP_BEGIN, {}),
    (commands.LoopPass, {}, rows.LOOP_PASS, {}),
    (commands.LoopEnd, {}, rows.LOOP_END, {rows.IS_ANSWERED: 1}),
    (commands.ProgramEnd, {}, rows.PROGRAM_END, {rows.PROGRAM_NUMBER: REFERENCE}),
    (
        commands.ProgramStop,
        {"is_optional": True},
        rows.PROGRAM_STOP,
        {rows.STOP_IS_OPTIONAL: 1},
    ),
    (commands.GiveUp, {"message": 11}, rows.GIVE_UP, {rows.GIVE_UP_MESSAGE: 11}),
    (
        commands.SendSignal,
        {"signal": 5, "receivers": 6, "count": 2, "mask": 3, "values": (1.5, 2.5) + 10 * (0.0,)},
        rows.SIGNAL,
        {
            rows.SIGNAL_NUMBER: 5,
            rows.SIGNAL_RECEIVERS: 6,
            rows.SIGNAL_COUNT: 2,
            rows.SIGNAL_MASK: 3,
            rows.SIGNAL_FIRST_VALUE: 1.5,
            rows.SIGNAL_FIRST_VALUE + 1: 2.5,
            rows.SIGNAL_FIRST_VALUE + 11: 0.0,
        },
    ),
    (
        commands.AwaitSignal,
        {"signal": 5, "senders": 4, "overtakes": True},
        rows.AWAIT_SIGNAL,
        {rows.AWAITED_SIGNAL: 5, rows.AWAITED_SENDERS: 4, rows.AWAITED_OVERTAKES: 1},
    ),
    (
        commands.RemoveSignals,
        {"low": 5, "high": 9, "receivers": 4, "is_range": True},
        rows.REMOVE_SIGNAL,
        {
            rows.REMOVED_LOW: 5,
            rows.REMOVED_HIGH: 9,
            rows.REMOVED_RECEIVERS: 4,
            rows.REMOVED_IS_RANGE: 1,
        },
    ),
]


@pytest.mark.parametrize(
    ("command", "arguments", "kind", "columns"),
    CASES,
    ids=[f"{case[0].__name__}-{number}" for number, case in enumerate(CASES)],
)
def test_arguments_are_in_their_columns(
    command: type[Command], arguments: dict[str, object], kind: int, columns: dict[int, float]
) -> None:
    row = pack(command(SOURCE, NUMBER, **arguments), REFERENCE)
    head = {rows.KIND: kind, rows.SOURCE: SOURCE, rows.BLOCK_NUMBER: NUMBER}
    expected = head | columns
    assert {column: row[column] for column in expected} == expected


def command_types() -> list[type[Command]]:
    """All commands of the decoder, from all of its modules."""
    for module in pkgutil.walk_packages(nctakt.decoder.__path__, "nctakt.decoder."):
        importlib.import_module(module.name)
    # A dataclass with slots is made anew: what it was made of is a subclass, too.
    found = {one.__qualname__: one for one in every_subclass(Command) if is_dataclass(one)}
    return [found[name] for name in sorted(found)]


def every_subclass(kind: type[Command]) -> Iterator[type[Command]]:
    """The classes derived from a command, and those derived from them."""
    for derived in kind.__subclasses__():
        if derived is getattr(sys.modules[derived.__module__], derived.__name__, None):
            yield derived
        yield from every_subclass(derived)


QUEUED = [one for one in command_types() if one.packed_as not in (0, rows.SEGMENT)]


@pytest.mark.parametrize("command", QUEUED, ids=lambda one: one.__name__)
def test_the_fields_of_a_command_are_the_columns_of_its_kind(command: type[Command]) -> None:
    """One column for each field; a command with other arguments has a case above."""
    if has_own_arguments(command):
        assert any(issubclass(command, case[0]) for case in CASES)
        return
    columns = rows.COMMANDS[command.packed_as].columns
    fields = list(command.__match_args__)[2:]
    values = dict(zip(fields, range(11, 11 + len(fields)), strict=True))
    row = pack(command(SOURCE, NUMBER, **values), REFERENCE)
    assert row == [command.packed_as, SOURCE, NUMBER, *values.values()]
    assert len(fields) == len(columns)


def test_each_kind_is_packed_from_a_command() -> None:
    """Nothing is declared that no command of the decoder becomes."""
    assert {one.packed_as for one in QUEUED} == {*rows.COMMANDS} - {rows.SEGMENT}


def test_a_name_of_several_kinds_is_one_column() -> None:
    """``IS_ANSWERED`` and the like: a second declaration would change the first."""
    places: dict[str, set[int]] = {}
    for node in ast.walk(ast.parse(Path(rows.__file__).read_text("utf-8"))):
        if isinstance(node, ast.Assign) and ast.unparse(node.value).startswith("_command("):
            assert isinstance(node.targets[0], ast.Tuple)
            for place, target in enumerate(node.targets[0].elts):
                places.setdefault(ast.unparse(target), set()).add(place)
    assert len(places) > len(rows.COMMANDS)
    assert [name for name, found in places.items() if len(found) > 1] == []


@pytest.mark.parametrize("kind", rows.COMMANDS)
def test_predicates_are_those_of_the_record(kind: int) -> None:
    """What compiled code has in line comes from the same sets."""
    record = rows.COMMANDS[kind]
    assert rows.is_timed(kind) == record.is_timed
    assert rows.is_transparent(kind) == record.is_transparent
