# SPDX-License-Identifier: MIT
"""Where nothing can happen any more in a session unless somebody outside does something.

In: a machine between two ticks, the watched stops. Out: notes on the reasons for which the programs
wait; none while anything can still happen without input.
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.base.diagnostics import Diagnostic, Text
from nctakt.base.source_ids import statement_span
from nctakt.kernel import codes
from nctakt.messages import diagnostic
from nctakt.messages.connections.session import NO_BLOCK_COMES
from nctakt.run.access.inputs import NEVER
from nctakt.run.causes.wait_reasons import awaited
from nctakt.run.realtime.assembly import AssembledMachine
from nctakt.run.tick_loop import TickLoop
from nctakt.session.stops import Kind, StopAt

#: Ticks between two checks, apart from those at which a program has stopped: multiples of it, so
#: that it is the same tick wherever a run is divided.
LOOK_TICKS = 1000

#: At single block and M00.
PAUSED = StopAt("paused")

#: Waits that only the operator can end, and waits that other programs, also waiting, can.
_WAITING = (
    "program start", "programmed stop", "single block", "reset", "feed hold", "override",
    "release",
    "signal", "exchange",
)  # fmt: skip

#: Waits that the PLC ends.
_OF_PLC = ("acknowledgement", "free place", "spindle acknowledged")

#: Kinds of stops that hold by the time alone.
_OF_VALUES: tuple[Kind, ...] = ("condition", "changes", "statement")

#: Blocks, and stops watched along with them.
_OF_PROGRAMS: tuple[Kind, ...] = ("block", "error", "notice", "message", "fault")

_PROGRAM = Text("a program to be selected", "die Anwahl eines Programms")


def rest(
    machine: AssembledMachine, loop: TickLoop, stops: Sequence[StopAt]
) -> tuple[Diagnostic, ...]:
    """Return the waits of all programs if none of the stops can hold without input; else nothing.

    If the stops are blocks, and others that may always occur, realtime cycles and axes may keep
    going: they make no block current.
    """
    if loop.plc is not None or machine.inputs.next_tick < NEVER:
        return ()
    if any(stop.kind in _OF_VALUES for stop in stops):
        return ()
    is_for_blocks = bool(stops) and all(stop.kind in _OF_PROGRAMS for stop in stops)
    if not is_for_blocks and (_has_cycles(machine) or not machine.has_stopped()):
        return ()
    found = []
    for index, channel in enumerate(loop.channels):
        word, source, _ = machine.channels[index].waits.reason()
        if word == "reset" and loop.ends_deadlock:
            return ()  # the error ends the run
        if word in _WAITING or (word in _OF_PLC and loop.has_plc):
            span = machine.files.span(source)
            line = "" if span is None else machine.files.line_at(span)
            text = awaited(machine, index, channel)
            found.append(diagnostic(NO_BLOCK_COMES, statement_span(span, line), line, awaited=text))
        elif word or channel.is_running or channel.result is None:
            return ()
    return tuple(found) or (diagnostic(NO_BLOCK_COMES, awaited=_PROGRAM),)


def _has_cycles(machine: AssembledMachine) -> bool:
    """Return whether a realtime cycle runs in each tick."""
    managers = [channel.manager for channel in machine.channels]
    return any(
        manager.state_of(cycle.slot) == codes.RUNNING
        for manager in managers
        for cycle in manager.loaded
    )
