# SPDX-License-Identifier: MIT
"""Error events and notices of the realtime part -> diagnostics with their spans."""

from __future__ import annotations

import re
from dataclasses import replace

from nctakt.base.diagnostics import NOTHING, Diagnostic, Text
from nctakt.base.source_ids import statement_span
from nctakt.hli.function_codes import function_name
from nctakt.kernel import codes
from nctakt.kernel.cycles.expressions import OPERATIONS
from nctakt.lists.declared.variables import SCALARS
from nctakt.messages import diagnostic
from nctakt.messages.axis_exchange import CYCLE_AXIS_NOT_IN_CHANNEL
from nctakt.messages.axis_motions import (
    AXIS_IN_ERROR_STATE,
    AXIS_IN_INDEPENDENT_MOTION,
    AXIS_MOVED_BY_PATH,
    AXIS_NOT_AT_BLOCK_START,
    BUFFERED_MOTION_WAITING,
    INDP_TARGET_OUTSIDE_LIMITS,
    MOTION_ENDED_BY_LIMIT,
)
from nctakt.messages.backward import (
    BACKWARD_AT_HISTORY_START,
    BACKWARD_WITHOUT_HISTORY,
    EDGE_NOT_FOUND,
)
from nctakt.messages.checked_axes import (
    INDEPENDENT_MOTION_NOT_PERMITTED,
    INDEPENDENT_MOTION_REFUSED,
)
from nctakt.messages.checked_values import CYCLE_INDEX_OUT_OF_RANGE
from nctakt.messages.couplings import COUPLED_AXIS_MOVES_ALONE, GANTRY_ASKEW
from nctakt.messages.feed import WAITING_FOR_MAIN_SPINDLE
from nctakt.messages.fixed_stops import FIXED_STOP_NOT_FOUND
from nctakt.messages.measuring import NO_PROBE_SIGNAL, PROBE_PRESSED
from nctakt.messages.memory import PLC_VALUE_NOT_FINITE
from nctakt.messages.plc import CHANNEL_BEING_RESET
from nctakt.messages.realtime import (
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
from nctakt.messages.signals import SIGNAL_OUT_OF_ORDER, TOO_MANY_SIGNALS
from nctakt.messages.spindles import (
    CYCLE_ACTIONS_FULL,
    INVALID_SPINDLE_SPEED,
    M19_SPEED_ZERO,
    SPINDLE_BUSY,
    SPINDLE_JOB_HELD,
)
from nctakt.messages.threads import (
    TAP_SPINDLE_TURNING,
    THREAD_CHAIN_TOO_FAST,
    THREAD_LOST,
    THREAD_REVERSED,
    THREAD_SPINDLE_STOPPED,
    THREAD_TOO_FAST,
    THREAD_TOO_SHORT,
    THREAD_WAY_TOO_SHORT,
)
from nctakt.messages.user_errors import INVALID_USER_ERROR_ID, INVALID_USER_ERROR_RC
from nctakt.nc.vocabulary.axis_commands import REFUSALS
from nctakt.run.assembly import AssembledMachine
from nctakt.trace.events import Event, number_text

#: What the realtime part reports, by the numbers that lead.
_MESSAGES = {
    number: message
    for message in (
        AXIS_IN_ERROR_STATE,
        AXIS_IN_INDEPENDENT_MOTION,
        AXIS_MOVED_BY_PATH,
        AXIS_NOT_AT_BLOCK_START,
        BACKWARD_AT_HISTORY_START,
        CYCLE_AXIS_NOT_IN_CHANNEL,
        BACKWARD_WITHOUT_HISTORY,
        BLOCK_CYCLE_NEVER_RAN,
        BLOCK_PASSED_OVER,
        BUFFERED_MOTION_WAITING,
        CHANNEL_BEING_RESET,
        CONTINUE_WITHOUT_EFFECT,
        COUPLED_AXIS_MOVES_ALONE,
        CYCLES_EXCEED_DURATION,
        CYCLES_EXCEED_STEP_LIMIT,
        CYCLE_ACTIONS_FULL,
        CYCLE_ID_IN_USE,
        CYCLE_INDEX_OUT_OF_RANGE,
        CYCLE_MEMORY_FULL,
        CYCLE_OPERATION_WITHOUT_RESULT,
        CYCLE_TOO_LARGE,
        CYCLE_VALUE_OUT_OF_RANGE,
        EDGE_NOT_FOUND,
        FIXED_STOP_NOT_FOUND,
        GANTRY_ASKEW,
        HOLD_WITHOUT_EFFECT,
        INDEPENDENT_MOTION_NOT_PERMITTED,
        INDEPENDENT_MOTION_REFUSED,
        INDP_TARGET_OUTSIDE_LIMITS,
        INVALID_SPINDLE_SPEED,
        INVALID_USER_ERROR_ID,
        INVALID_USER_ERROR_RC,
        M19_SPEED_ZERO,
        MOTION_ENDED_BY_LIMIT,
        NO_CYCLE_TO_DELETE,
        NO_PROBE_SIGNAL,
        PLC_INTERFACE_FULL,
        PLC_VALUE_NOT_FINITE,
        PROBE_PRESSED,
        SPINDLE_BUSY,
        SIGNAL_OUT_OF_ORDER,
        SPINDLE_JOB_HELD,
        TAP_SPINDLE_TURNING,
        THREAD_CHAIN_TOO_FAST,
        THREAD_LOST,
        THREAD_REVERSED,
        THREAD_SPINDLE_STOPPED,
        THREAD_TOO_FAST,
        THREAD_TOO_SHORT,
        THREAD_WAY_TOO_SHORT,
        TOO_MANY_CYCLES,
        TOO_MANY_FUNCTIONS_IN_TICK,
        TOO_MANY_SIGNALS,
        UNKNOWN_CYCLE_ID,
        UNKNOWN_CYCLE_TIMER,
        WAITING_FOR_MAIN_SPINDLE,
    )
    for number in message.leading
}

#: The motions of an axis that the path cannot have.
_OWN_MOTIONS = {
    codes.MOVES_STILL: Text(
        "which is in an independent motion", "die gerade eine unabhängige Bewegung ausführt"
    ),
    codes.MOVES_ENDLESSLY: Text(
        "which is moving endlessly beside the path", "die endlos neben der Bahn fährt"
    ),
    codes.IS_HELD: Text("whose motion is on hold", "deren Bewegung angehalten ist"),
}


def realtime_diagnostic(event: Event, machine: AssembledMachine) -> Diagnostic:
    """Return the diagnostic of an error or warning of a cycle, of the path or of the PLC's image.

    The values come from the context of the cycle at fault, which keeps them until the next tick.
    """
    number = int(event.text)
    index = max(event.channel - 1, 0)
    channel = machine.channels[index]
    context = channel.context
    a, b = context.fault_a, context.fault_b
    cycle = event.cycle
    values: dict[str, object]
    message = _MESSAGES[number]
    match message.id:
        case CYCLE_OPERATION_WITHOUT_RESULT.id:
            values = {"cycle": cycle, "operation": OPERATIONS.get(int(a), "=")}
        case CYCLE_VALUE_OUT_OF_RANGE.id:
            name = machine.registry.variable(int(a))
            location = machine.assembled[index].names.resolve_text(name)
            assert isinstance(location, tuple)
            scalar = SCALARS[location[0].type]
            values = {
                "variable": name,
                "value": number_text(b),
                "low": scalar.low,
                "high": scalar.high,
            }
        case CYCLE_INDEX_OUT_OF_RANGE.id:
            values = {"variable": _array(event, machine), "index": number_text(a), "count": int(b)}
        case PLC_INTERFACE_FULL.id | TOO_MANY_FUNCTIONS_IN_TICK.id:
            values = {"function": function_name(a), "slots": int(b)}
        case CYCLES_EXCEED_STEP_LIMIT.id | CYCLES_EXCEED_DURATION.id:
            values = {"cycle": cycle, "steps": int(a), "limit": int(b)}
        case UNKNOWN_CYCLE_ID.id | CYCLE_ID_IN_USE.id:
            values = {"id": int(channel.executor.error_detail)}
        case CYCLE_MEMORY_FULL.id | CYCLE_TOO_LARGE.id:
            manager = channel.manager
            free = manager.memory_limit - manager.memory_used
            values = {"needed": int(channel.executor.error_detail), "free": free}
        case SIGNAL_OUT_OF_ORDER.id:
            values = {"id": int(channel.executor.error_detail)}
        case TOO_MANY_SIGNALS.id:
            values = {"count": codes.SIGNAL_CAPACITY}
        case TOO_MANY_CYCLES.id:
            values = {"count": channel.manager.capacity}
        case INDEPENDENT_MOTION_REFUSED.id:
            values = {"axis": machine.registry.axis(int(a)), "reason": REFUSALS[int(b)]}
        case FIXED_STOP_NOT_FOUND.id | AXIS_NOT_AT_BLOCK_START.id | AXIS_IN_INDEPENDENT_MOTION.id:
            values = {"axis": machine.registry.axis(int(channel.executor.error_detail))}
            if message is AXIS_IN_INDEPENDENT_MOTION:
                values["motion"] = _OWN_MOTIONS[channel.executor.axis_state]
        case (
            SPINDLE_JOB_HELD.id
            | TAP_SPINDLE_TURNING.id
            | THREAD_CHAIN_TOO_FAST.id
            | THREAD_LOST.id
            | THREAD_REVERSED.id
            | THREAD_SPINDLE_STOPPED.id
            | THREAD_TOO_FAST.id
            | THREAD_WAY_TOO_SHORT.id
        ):
            values = {"spindle": machine.registry.spindle(int(channel.executor.error_detail))}
        case UNKNOWN_CYCLE_TIMER.id:
            values = {"timer": int(a)}
        case PLC_VALUE_NOT_FINITE.id:
            variable = machine.registry.variable(machine.kernel.image.next_refused())
            values = {"variable": variable, "value": _INFINITE if number == message.id else "NaN"}
        case SPINDLE_BUSY.id:
            values = {"spindle": machine.registry.spindle(int(a))}
        case CYCLE_ACTIONS_FULL.id:
            values = {"cycle": cycle, "used": _used_slots(int(a)), "open": int(a) or NOTHING}
        case (
            M19_SPEED_ZERO.id
            | WAITING_FOR_MAIN_SPINDLE.id
            | BACKWARD_WITHOUT_HISTORY.id
            | BACKWARD_AT_HISTORY_START.id
            | EDGE_NOT_FOUND.id
            | PROBE_PRESSED.id
            | NO_PROBE_SIGNAL.id
            | NO_CYCLE_TO_DELETE.id
            | HOLD_WITHOUT_EFFECT.id
            | CONTINUE_WITHOUT_EFFECT.id
            | BLOCK_CYCLE_NEVER_RAN.id
            | BLOCK_PASSED_OVER.id
            | THREAD_TOO_SHORT.id
        ):
            values = {}
        case INVALID_USER_ERROR_ID.id | INVALID_USER_ERROR_RC.id | INVALID_SPINDLE_SPEED.id:
            values = {"value": number_text(a)}
        case (
            INDEPENDENT_MOTION_NOT_PERMITTED.id
            | AXIS_MOVED_BY_PATH.id
            | AXIS_IN_ERROR_STATE.id
            | BUFFERED_MOTION_WAITING.id
            | CHANNEL_BEING_RESET.id
            | COUPLED_AXIS_MOVES_ALONE.id
            | CYCLE_AXIS_NOT_IN_CHANNEL.id
            | GANTRY_ASKEW.id
        ):
            values = {"axis": machine.registry.axis(int(a))}
        case INDP_TARGET_OUTSIDE_LIMITS.id:
            low, high = machine.single_axes.limits_of(int(a))
            values = {
                "axis": machine.registry.axis(int(a)),
                "target": number_text(b),
                "low": number_text(low),
                "high": number_text(high),
            }
        case MOTION_ENDED_BY_LIMIT.id:
            values = {"axis": machine.registry.axis(machine.single_axes.next_failed())}
        case _:
            raise AssertionError(number)
    line = "" if event.span is None else machine.files.line_at(event.span)
    found = diagnostic(message, statement_span(event.span, line), line, **values)
    return replace(found, number=number)


_INFINITE = Text("an infinite number", "eine unendliche Zahl")


def _used_slots(count: int) -> Text:
    """Return the use of the slots for actions (P-CHAN-00480) of a cycle without a free one."""
    if count == 0:
        return Text("it has no slots for actions at all", "er hat gar keine Plätze für Aktionen")
    if count == 1:
        return Text("an action is open in its only slot", "sein einziger Platz ist belegt")
    return Text(f"actions are open in all {count} slots", f"alle {count} Plätze sind belegt")


def _array(event: Event, machine: AssembledMachine) -> str:
    """Return the array whose index stands at the position of the event."""
    assert event.span is not None
    before = machine.files.line_at(event.span)[: event.span.column - 1]
    match = re.search(r"[\w.\]\[]+(?=\[\s*$)", before)
    return match[0] if match else before.strip()
