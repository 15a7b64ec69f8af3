# SPDX-License-Identifier: MIT
"""Error events and notices of the realtime part -> diagnostics with their spans."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import NOTHING, Diagnostic, Message, Text
from nctakt.base.source_ids import statement_span
from nctakt.hli.function_codes import function_name
from nctakt.kernel import codes
from nctakt.kernel.cycles.expressions import OPERATIONS
from nctakt.kernel.tick.channel import Channel
from nctakt.lists.declared.variables import SCALARS
from nctakt.messages import diagnostic
from nctakt.messages.axes.axis_exchange import CYCLE_AXIS_NOT_IN_CHANNEL
from nctakt.messages.axes.axis_motions import (
    AXIS_IN_ERROR_STATE,
    AXIS_IN_INDEPENDENT_MOTION,
    AXIS_MOVED_BY_PATH,
    AXIS_NOT_AT_BLOCK_START,
    BUFFERED_MOTION_WAITING,
    INDP_TARGET_OUTSIDE_LIMITS,
    MOTION_ENDED_BY_LIMIT,
)
from nctakt.messages.axes.couplings import COUPLED_AXIS_MOVES_ALONE, GANTRY_ASKEW
from nctakt.messages.axes.spindles import (
    CYCLE_ACTIONS_FULL,
    INVALID_SPINDLE_SPEED,
    M19_SPEED_ZERO,
    SPINDLE_BUSY,
    SPINDLE_JOB_HELD,
    SPINDLE_TURNS_IN_EXCHANGE,
)
from nctakt.messages.machines.memory import PLC_VALUE_NOT_FINITE
from nctakt.messages.path.backward import (
    BACKWARD_AT_HISTORY_START,
    BACKWARD_WITHOUT_HISTORY,
    EDGE_NOT_FOUND,
)
from nctakt.messages.path.feed import WAITING_FOR_MAIN_SPINDLE
from nctakt.messages.path.fixed_stops import FIXED_STOP_NOT_FOUND
from nctakt.messages.path.measuring import NO_PROBE_SIGNAL, PROBE_PRESSED
from nctakt.messages.path.threads import (
    TAP_SPINDLE_TURNING,
    THREAD_CHAIN_TOO_FAST,
    THREAD_LOST,
    THREAD_REVERSED,
    THREAD_SPINDLE_STOPPED,
    THREAD_TOO_FAST,
    THREAD_TOO_SHORT,
    THREAD_WAY_TOO_SHORT,
)
from nctakt.messages.plcs.plc import CHANNEL_BEING_RESET, PLC_SILENT
from nctakt.messages.programs.checked_axes import (
    INDEPENDENT_MOTION_NOT_PERMITTED,
    INDEPENDENT_MOTION_REFUSED,
)
from nctakt.messages.programs.checked_values import CYCLE_INDEX_OUT_OF_RANGE
from nctakt.messages.programs.realtime import (
    BLOCK_CYCLE_NEVER_RAN,
    BLOCK_PASSED_OVER,
    CONTINUE_WITHOUT_EFFECT,
    CYCLE_ID_IN_USE,
    CYCLE_MEMORY_FULL,
    CYCLE_OPERATION_WITHOUT_RESULT,
    CYCLE_TOO_LARGE,
    CYCLE_VALUE_OUT_OF_RANGE,
    CYCLES_EXCEED_DURATION,
    CYCLES_EXCEED_STEP_LIMIT,
    HOLD_WITHOUT_EFFECT,
    NO_CYCLE_TO_DELETE,
    PLC_INTERFACE_FULL,
    TOO_MANY_CYCLES,
    TOO_MANY_FUNCTIONS_IN_TICK,
    UNKNOWN_CYCLE_ID,
    UNKNOWN_CYCLE_TIMER,
)
from nctakt.messages.programs.signals import SIGNAL_OUT_OF_ORDER, TOO_MANY_SIGNALS
from nctakt.messages.programs.user_errors import INVALID_USER_ERROR_ID, INVALID_USER_ERROR_RC
from nctakt.nc.vocabulary.single_axes.axis_commands import REFUSALS
from nctakt.results.trace.events import Event, number_text
from nctakt.run.realtime.assembly import AssembledMachine

#: The motions of an axis that the path cannot have.
_OWN_MOTIONS = {
    codes.AXIS_MOVES: Text(
        "which is in an independent motion", "die gerade eine unabhängige Bewegung ausführt"
    ),
    codes.AXIS_MOVES_ENDLESSLY: Text(
        "which is moving endlessly beside the path", "die endlos neben der Bahn fährt"
    ),
    codes.AXIS_HELD: Text("whose motion is on hold", "deren Bewegung angehalten ist"),
}


_INFINITE = Text("an infinite number", "eine unendliche Zahl")


@dataclass(frozen=True, slots=True)
class _Report:
    """An error or warning of the realtime part, with the data for its values.

    ``a``, ``b``: values kept until the next tick by the context of the cycle at fault. ``detail``:
    a value kept by the execution of commands.
    """

    event: Event
    machine: AssembledMachine
    number: int
    message: Message
    channel: Channel
    a: float
    b: float
    detail: float


_Values = dict[str, object]


def _without_values(_: _Report) -> _Values:
    return {}


def _axis_of_cycle(report: _Report) -> _Values:
    return {"axis": report.machine.registry.axis(int(report.a))}


def _axis_of_path(report: _Report) -> _Values:
    return {"axis": report.machine.registry.axis(int(report.detail))}


def _moving_axis(report: _Report) -> _Values:
    return _axis_of_path(report) | {"motion": _OWN_MOTIONS[report.channel.executor.axis_state]}


def _refused_axis(report: _Report) -> _Values:
    return _axis_of_cycle(report) | {"reason": REFUSALS[int(report.b)]}


def _target_outside(report: _Report) -> _Values:
    low, high = map(number_text, report.machine.single_axes.limits_of(int(report.a)))
    return _axis_of_cycle(report) | {"target": number_text(report.b), "low": low, "high": high}


def _axis_at_limit(report: _Report) -> _Values:
    return {"axis": report.machine.registry.axis(report.machine.single_axes.next_failed())}


def _spindle_of_cycle(report: _Report) -> _Values:
    return {"spindle": report.machine.registry.spindle(int(report.a))}


def _spindle_of_path(report: _Report) -> _Values:
    return {"spindle": report.machine.registry.spindle(int(report.detail))}


def _operation(report: _Report) -> _Values:
    return {"cycle": report.event.cycle, "operation": OPERATIONS.get(int(report.a), "=")}


def _assigned_value(report: _Report) -> _Values:
    name = report.machine.registry.variable(int(report.a))
    index = max(report.event.channel - 1, 0)
    location = report.machine.assembled[index].names.resolve_text(name)
    assert isinstance(location, tuple)
    scalar = SCALARS[location[0].type]
    value = number_text(report.b)
    return {"variable": name, "value": value, "low": scalar.low, "high": scalar.high}


def _array(event: Event, machine: AssembledMachine) -> str:
    """Return the array whose index is at the position of the event."""
    assert event.span is not None
    before = machine.files.line_at(event.span)[: event.span.column - 1]
    match = re.search(r"[\w.\]\[]+(?=\[\s*$)", before)
    return match[0] if match else before.strip()


def _array_index(report: _Report) -> _Values:
    variable = _array(report.event, report.machine)
    return {"variable": variable, "index": number_text(report.a), "count": int(report.b)}


def _function(report: _Report) -> _Values:
    return {"function": function_name(report.a), "slots": int(report.b)}


def _step_limit(report: _Report) -> _Values:
    return {"cycle": report.event.cycle, "steps": int(report.a), "limit": int(report.b)}


def _id(report: _Report) -> _Values:
    return {"id": int(report.detail)}


def _memory(report: _Report) -> _Values:
    manager = report.channel.manager
    return {"needed": int(report.detail), "free": manager.memory_limit - manager.memory_used}


def _refused_variable(report: _Report) -> _Values:
    machine, message = report.machine, report.message
    variable = machine.registry.variable(machine.kernel.image.next_refused())
    return {"variable": variable, "value": _INFINITE if report.number == message.id else "NaN"}


def _used_slots(count: int) -> Text:
    """Return the use of the slots for actions (P-CHAN-00480) of a cycle without a free one."""
    if count == 0:
        return Text("it has no slots for actions at all", "er hat gar keine Plätze für Aktionen")
    if count == 1:
        return Text("an action is open in its only slot", "sein einziger Platz ist belegt")
    return Text(f"actions are open in all {count} slots", f"alle {count} Plätze sind belegt")


def _open_actions(report: _Report) -> _Values:
    count = int(report.a)
    return {"cycle": report.event.cycle, "used": _used_slots(count), "open": count or NOTHING}


def _faulty_value(report: _Report) -> _Values:
    return {"value": number_text(report.a)}


#: Messages of the realtime part, each with the function that returns the values of its parameters.
_VALUES: dict[Message, Callable[[_Report], _Values]] = {
    CYCLE_OPERATION_WITHOUT_RESULT: _operation,
    CYCLE_VALUE_OUT_OF_RANGE: _assigned_value,
    CYCLE_INDEX_OUT_OF_RANGE: _array_index,
    INDEPENDENT_MOTION_REFUSED: _refused_axis,
    AXIS_IN_INDEPENDENT_MOTION: _moving_axis,
    INDP_TARGET_OUTSIDE_LIMITS: _target_outside,
    MOTION_ENDED_BY_LIMIT: _axis_at_limit,
    SPINDLE_BUSY: _spindle_of_cycle,
    PLC_VALUE_NOT_FINITE: _refused_variable,
    CYCLE_ACTIONS_FULL: _open_actions,
    TOO_MANY_SIGNALS: lambda _: {"count": codes.SIGNAL_CAPACITY},
    TOO_MANY_CYCLES: lambda report: {"count": report.channel.manager.capacity},
    UNKNOWN_CYCLE_TIMER: lambda report: {"timer": int(report.a)},
    **dict.fromkeys((PLC_INTERFACE_FULL, TOO_MANY_FUNCTIONS_IN_TICK), _function),
    **dict.fromkeys((CYCLES_EXCEED_STEP_LIMIT, CYCLES_EXCEED_DURATION), _step_limit),
    **dict.fromkeys((UNKNOWN_CYCLE_ID, CYCLE_ID_IN_USE, SIGNAL_OUT_OF_ORDER), _id),
    **dict.fromkeys((CYCLE_MEMORY_FULL, CYCLE_TOO_LARGE), _memory),
    **dict.fromkeys((FIXED_STOP_NOT_FOUND, AXIS_NOT_AT_BLOCK_START), _axis_of_path),
    **dict.fromkeys(
        (INVALID_USER_ERROR_ID, INVALID_USER_ERROR_RC, INVALID_SPINDLE_SPEED), _faulty_value
    ),
    **dict.fromkeys(
        (
            SPINDLE_JOB_HELD,
            SPINDLE_TURNS_IN_EXCHANGE,
            TAP_SPINDLE_TURNING,
            THREAD_CHAIN_TOO_FAST,
            THREAD_LOST,
            THREAD_REVERSED,
            THREAD_SPINDLE_STOPPED,
            THREAD_TOO_FAST,
            THREAD_WAY_TOO_SHORT,
        ),
        _spindle_of_path,
    ),
    **dict.fromkeys(
        (
            INDEPENDENT_MOTION_NOT_PERMITTED,
            AXIS_MOVED_BY_PATH,
            AXIS_IN_ERROR_STATE,
            BUFFERED_MOTION_WAITING,
            CHANNEL_BEING_RESET,
            COUPLED_AXIS_MOVES_ALONE,
            CYCLE_AXIS_NOT_IN_CHANNEL,
            GANTRY_ASKEW,
        ),
        _axis_of_cycle,
    ),
    **dict.fromkeys(
        (
            M19_SPEED_ZERO,
            WAITING_FOR_MAIN_SPINDLE,
            BACKWARD_WITHOUT_HISTORY,
            BACKWARD_AT_HISTORY_START,
            EDGE_NOT_FOUND,
            PROBE_PRESSED,
            NO_PROBE_SIGNAL,
            PLC_SILENT,
            NO_CYCLE_TO_DELETE,
            HOLD_WITHOUT_EFFECT,
            CONTINUE_WITHOUT_EFFECT,
            BLOCK_CYCLE_NEVER_RAN,
            BLOCK_PASSED_OVER,
            THREAD_TOO_SHORT,
        ),
        _without_values,
    ),
}
#: The same messages by the numbers that lead.
_MESSAGES = {number: message for message in _VALUES for number in message.leading}


def realtime_diagnostic(event: Event, machine: AssembledMachine) -> Diagnostic:
    """Return the diagnostic of an error or warning of a cycle, of the path or of the PLC's image.

    The values come from the context of the cycle at fault, which keeps them until the next tick.
    """
    number = int(event.text)
    message = _MESSAGES[number]
    channel = machine.channels[max(event.channel - 1, 0)]
    context, detail = channel.context, channel.executor.error_detail
    report = _Report(
        event, machine, number, message, channel, context.fault_a, context.fault_b, detail
    )
    values = _VALUES[message](report)
    line = "" if event.span is None else machine.files.line_at(event.span)
    found = diagnostic(message, statement_span(event.span, line), line, **values)
    return replace(found, number=number)
