# SPDX-License-Identifier: MIT
"""Functions that a PLC did not get because it announced itself only later (ST-763).

In: events of the realtime part, as they come, and when PLCs in the tick announced themselves. Out:
a note for each place of a program whose function acknowledged itself before that.
"""

from __future__ import annotations

from collections.abc import Iterator

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic
from nctakt.base.source_ids import statement_span
from nctakt.decoder.blocks.technology_output import AWAITED, process_ticks
from nctakt.hli.function_codes import function_name, function_of
from nctakt.kernel import rows
from nctakt.lists.declared.technology_functions import TechnologyFunction
from nctakt.messages import diagnostic
from nctakt.messages.plcs.plc import FUNCTION_BEFORE_PLC
from nctakt.run.access.presence import Announced
from nctakt.run.realtime.assembly import AssembledMachine
from nctakt.run.technology_tables import logical_axes
from nctakt.trace.chunks import EventChunk
from nctakt.trace.events import Event

#: Events that are looked at: a program outputs a function.
EVENTS = frozenset((rows.EVENT_TECHNOLOGY,))

#: Functions that are remembered, at most: the PLC may never announce itself.
_MAX_NOTED = 1000

#: The dwell that is proposed is a multiple of this, in µs.
_DWELL_US = 10_000


@dataclass(frozen=True, slots=True)
class _Output:
    """A function that acknowledged itself in a tick, unless a PLC was there for its area."""

    event: Event
    name: str
    channel: int
    axis: int
    done_tick: int


class UnheardFunctions:
    """Follows the functions of programs until a PLC has announced itself for their areas."""

    def __init__(self, machine: AssembledMachine) -> None:
        self._machine = machine
        self._open: dict[str, _Output] = {}
        self._noted: set[str] = set()

    def add(self, events: EventChunk) -> None:
        """Remember the functions among these events that no PLC was there for."""
        kinds, functions = events.column(rows.EVENT_KIND), events.column(rows.EVENT_A)
        for event, kind, function in zip(events, kinds, functions, strict=True):
            if kind == rows.EVENT_TECHNOLOGY:
                self._output(event, int(function))

    def notes(self) -> Iterator[Diagnostic]:
        """Yield a note for each function whose PLC has announced itself since."""
        for key, output in list(self._open.items()):
            announced = self._announced(output)
            if announced is not None:
                del self._open[key]
                if output.done_tick <= announced.tick:
                    yield self._note(output, announced)

    def _output(self, event: Event, code: int) -> None:
        index = max(event.channel - 1, 0)
        function = self._function(index, code)
        if function is None or function.synchronisation not in AWAITED:
            return
        if not self._machine.channels[index].hli.acknowledges_itself:
            return
        ticks = process_ticks(function, self._machine.configuration.cycle_time_us)
        axis = self._axis(index, function)
        output = _Output(event, function_name(code), index, axis, event.tick + ticks)
        announced = self._announced(output)
        key = f"{output.name} {event.span}"
        is_heard = announced is not None and announced.tick < output.done_tick
        if not is_heard and key not in self._noted and len(self._noted) < _MAX_NOTED:
            self._noted.add(key)
            self._open[key] = output

    def _axis(self, channel: int, function: TechnologyFunction) -> int:
        """Return the index of the axis that a function is for, -1: the channel."""
        machine = self._machine
        logical = logical_axes(machine.assembled[channel].configuration).get(function.axis_name)
        axes = enumerate(machine.configuration.axes)
        return next((index for index, one in axes if one.logical_number == logical), -1)

    def _function(self, channel: int, code: int) -> TechnologyFunction | None:
        """Return what the channel list says of a function; ``None``: nothing."""
        parameters = self._machine.assembled[channel].parameters
        letter, number = function_of(code)
        if letter == "T":
            return parameters.tool_selection.output
        functions = parameters.m_functions if letter == "M" else parameters.h_functions
        return functions.get(number)

    def _announced(self, output: _Output) -> Announced | None:
        """Return when a PLC announced itself first for the area of a function."""
        presences = self._machine.access.presences
        found = [one.announced(output.channel, output.axis) for one in presences]
        return min((one for one in found if one is not None), default=None)

    def _note(self, output: _Output, announced: Announced) -> Diagnostic:
        span = output.event.span
        line = "" if span is None else self._machine.files.line_at(span)
        wait_us = (announced.tick + 1) * self._machine.configuration.cycle_time_us
        dwell = (wait_us // _DWELL_US + 1) * _DWELL_US / 1e6
        return diagnostic(
            FUNCTION_BEFORE_PLC,
            statement_span(span, line),
            line,
            function=output.name,
            path=announced.path,
            tick=announced.tick,
            dwell=f"{dwell:g}",
        )
