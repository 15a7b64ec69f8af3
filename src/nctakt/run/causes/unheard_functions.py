# SPDX-License-Identifier: MIT
"""Functions and motions that a PLC missed because it announced itself too late, or never (ST-763).

In: events of the realtime part, as they come, and when PLCs in the tick announced themselves. Out:
a note for each place of a program whose function or spindle job acknowledged itself before that, or
whose axis moved without the releases of the PLC.
"""

from __future__ import annotations

from collections.abc import Iterator

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Span
from nctakt.base.source_ids import statement_span
from nctakt.decoder.blocks.technology_output import AWAITED, process_ticks
from nctakt.hli.function_codes import function_name, function_of
from nctakt.kernel import rows
from nctakt.lists.declared.technology_functions import TechnologyFunction
from nctakt.messages import diagnostic
from nctakt.messages.plcs.plc import FUNCTION_BEFORE_PLC, FUNCTION_WITHOUT_PLC, MOTION_BEFORE_PLC
from nctakt.results.trace.chunks import EventChunk
from nctakt.results.trace.events import Event
from nctakt.run.access.presence import Announced
from nctakt.run.realtime.assembly import AssembledMachine
from nctakt.run.technology_tables import logical_axes

#: An axis begins an independent motion.
_MOTIONS = (rows.EVENT_AXIS_BEGUN, rows.EVENT_AXIS_ENDLESS, rows.EVENT_AXIS_OSCILLATES)

#: Events that are looked at: functions of programs, motions of single axes, jobs of spindles.
EVENTS = frozenset((rows.EVENT_TECHNOLOGY, rows.EVENT_SPINDLE, *_MOTIONS))

#: Functions that are remembered, at most: the PLC may never announce itself.
_MAX_NOTED = 1000

#: The dwell that is proposed is a multiple of this, in µs.
_DWELL_US = 10_000


@dataclass(frozen=True, slots=True)
class _Output:
    """A function or job that acknowledged itself in a tick, unless a PLC was there for its area.

    ``is_motion``: an axis that began to move in that tick, without a PLC that releases it.
    """

    event: Event
    name: str
    channel: int
    axis: int
    done_tick: int
    is_motion: bool = False


class UnheardFunctions:
    """Follows the functions of programs until a PLC has announced itself for their areas."""

    def __init__(self, machine: AssembledMachine) -> None:
        self._machine = machine
        self._open: dict[str, _Output] = {}
        self._noted: set[str] = set()
        self._spindles = [
            (index, spindle)
            for index, channel in enumerate(machine.configuration.channels)
            for spindle in channel.parameters.spindles
        ]

    def add(self, events: EventChunk) -> None:
        """Remember those of these events for which no PLC was announced."""
        kinds, subjects = events.column(rows.EVENT_KIND), events.column(rows.EVENT_A)
        functions = events.column(rows.EVENT_B)
        for number, kind in enumerate(kinds):
            if kind == rows.EVENT_TECHNOLOGY:
                self._output(events[number], int(subjects[number]))
            elif kind == rows.EVENT_SPINDLE:
                self._job(events[number], int(subjects[number]), int(functions[number]))
            elif kind in _MOTIONS:
                self._motion(events[number], int(subjects[number]))

    def notes(self) -> Iterator[Diagnostic]:
        """Yield a note for each event whose PLC has announced itself since."""
        for key, output in list(self._open.items()):
            announced = self._announced(output)
            if announced is not None:
                del self._open[key]
                if output.done_tick <= announced.tick:
                    yield self._note(output, announced)

    def last_notes(self) -> Iterator[Diagnostic]:
        """Yield a note for each area that no PLC has announced until the run's end.

        It is about the first function; that an axis moves without releases is usual then.
        """
        named: set[str] = set()
        for output in self._open.values():
            path = self._path(output)
            if path and path not in named and not output.is_motion:
                named.add(path)
                span, line = self._statement(output)
                yield diagnostic(FUNCTION_WITHOUT_PLC, span, line, function=output.name, path=path)

    def _output(self, event: Event, code: int) -> None:
        index = max(event.channel - 1, 0)
        function = self._function(index, code)
        if function is not None and function.synchronisation in AWAITED:
            axis = self._axis(index, function)
            self._await_answer(event, function_name(code), index, axis, function)

    def _job(self, event: Event, number: int, code: int) -> None:
        """Remember a job of a spindle that the PLC turns."""
        index, spindle = self._spindles[number]
        if spindle.plc_controlled:
            axis = self._axis_index(spindle.logical_number)
            name = f"{spindle.name} M{code}"
            self._await_answer(event, name, index, axis, spindle.functions[f"m{code}"])

    def _motion(self, event: Event, axis: int) -> None:
        """Remember a motion that no PLC has commanded."""
        if event.span is not None:
            name = self._machine.registry.axis(axis)
            self._keep(_Output(event, name, -1, axis, event.tick, is_motion=True))

    def _await_answer(
        self, event: Event, name: str, channel: int, axis: int, function: TechnologyFunction
    ) -> None:
        if self._machine.channels[channel].hli.acknowledges_itself:
            ticks = process_ticks(function, self._machine.configuration.cycle_time_us)
            self._keep(_Output(event, name, channel, axis, event.tick + ticks))

    def _keep(self, output: _Output) -> None:
        announced = self._announced(output)
        key = f"{output.name} {output.event.span}"
        has_listener = announced is not None and announced.tick < output.done_tick
        if not has_listener and key not in self._noted and len(self._noted) < _MAX_NOTED:
            self._noted.add(key)
            self._open[key] = output

    def _axis(self, channel: int, function: TechnologyFunction) -> int:
        """Return the index of the axis that a function is for, -1: the channel."""
        configuration = self._machine.assembled[channel].configuration
        return self._axis_index(logical_axes(configuration).get(function.axis_name, 0))

    def _axis_index(self, logical: int) -> int:
        """Return the index of an axis by its logical number, -1: there is none."""
        axes = enumerate(self._machine.configuration.axes)
        return next((index for index, one in axes if one.logical_number == logical), -1)

    def _function(self, channel: int, code: int) -> TechnologyFunction | None:
        """Return a function's entry in the channel list; ``None`` without one."""
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

    def _path(self, output: _Output) -> str:
        """Return the element that would announce a PLC for a function's area, empty without one."""
        presences = self._machine.access.presences
        found = (one.path(output.channel, output.axis) for one in presences)
        return next((one for one in found if one), "")

    def _statement(self, output: _Output) -> tuple[Span | None, str]:
        span = output.event.span
        line = "" if span is None else self._machine.files.line_at(span)
        return statement_span(span, line), line

    def _note(self, output: _Output, announced: Announced) -> Diagnostic:
        span, line = self._statement(output)
        wait_us = (announced.tick + 1) * self._machine.configuration.cycle_time_us
        dwell = f"{(wait_us // _DWELL_US + 1) * _DWELL_US / 1e6:g}"
        path, tick = announced.path, announced.tick
        if output.is_motion:
            axis = output.name
            return diagnostic(
                MOTION_BEFORE_PLC, span, line, axis=axis, path=path, tick=tick, dwell=dwell
            )
        return diagnostic(
            FUNCTION_BEFORE_PLC, span, line, function=output.name, path=path, tick=tick, dwell=dwell
        )
