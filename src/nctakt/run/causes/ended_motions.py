# SPDX-License-Identifier: MIT
"""Motions that were given up because their realtime cycle has ended (RC-110).

In: events of the realtime part, as they come. Out: a note for each place of a program whose motion
has stopped before its target because of the default of END_ACTION.
"""

from __future__ import annotations

from collections.abc import Iterator

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Text
from nctakt.base.source_ids import statement_span
from nctakt.kernel import rows
from nctakt.lists.machine.axis_configuration import AxisType
from nctakt.messages import diagnostic
from nctakt.messages.axes.axis_motions import MOTION_ENDED_WITH_CYCLE
from nctakt.results.trace.chunks import EventChunk
from nctakt.results.trace.events import Event
from nctakt.run.realtime.assembly import AssembledMachine

#: Events that are looked at, in their order within a tick: a cycle ends, then its motions.
EVENTS = frozenset(
    (
        rows.EVENT_ENDED,
        rows.EVENT_AXIS_BEGUN,
        rows.EVENT_AXIS_ENDLESS,
        rows.EVENT_AXIS_OSCILLATES,
        rows.EVENT_AXIS_ENDED,
        rows.EVENT_AXIS_CHANGED,
    )
)

#: Those of motions that begin.
_BEGINNINGS = (rows.EVENT_AXIS_BEGUN, rows.EVENT_AXIS_ENDLESS, rows.EVENT_AXIS_OSCILLATES)

#: An axis that is nearer to its target when it stops, in mm or degrees, has reached it.
SMALLEST_DISTANCE = 1e-6

#: How a cycle ends in silence; of an error or a reset the user knows already.
_HOW = {
    rows.ENDED_BY_SCOPE: Text("ended", "endete"),
    rows.ENDED_BY_DELETE: Text("was deleted", "wurde gelöscht"),
}
_STOPPED = Text("stopped {distance} before its target", "hielt {distance} vor ihrem Ziel an")
_ENDLESS = Text("stopped during an endless motion", "hielt während einer Endlosbewegung an")
_WAITING = Text("did not begin its waiting motion", "begann ihre wartende Bewegung nicht")


@dataclass(frozen=True, slots=True)
class _GivenUp:
    """A motion that brakes: the event that gave it up, and how its cycle has ended."""

    event: Event
    how: Text
    is_endless: bool


class EndedMotions:
    """Follows the axes of a machine from a cycle's end to the standstill."""

    def __init__(self, machine: AssembledMachine) -> None:
        self._machine = machine
        self._tick = -1
        self._ends: dict[int, int] = {}
        self._braking: dict[int, _GivenUp] = {}
        self._noted: set[str] = set()

    def add(self, events: EventChunk) -> Iterator[Diagnostic]:
        """Yield a note for each motion that these events end, once for each place."""
        for number, (tick, kind, _, _, subject, a, b, c) in enumerate(events.cells()):
            if kind == rows.EVENT_ENDED:
                if tick != self._tick:
                    self._tick, self._ends = int(tick), {}
                self._ends[int(subject)] = int(a)
            elif kind in _BEGINNINGS:
                self._braking.pop(int(a), None)  # another motion has taken over
            elif kind == rows.EVENT_AXIS_ENDED and c != rows.NOT_WITH_CYCLE:
                yield from self._give_up(events[number], int(subject), int(a), int(c))
            elif kind == rows.EVENT_AXIS_CHANGED and b == rows.MOTION_STOPPED:
                yield from self._stop(int(a), c)

    def _give_up(self, event: Event, serial: int, axis: int, why: int) -> Iterator[Diagnostic]:
        """Remember a motion that its cycle has aborted; a waiting motion has nothing to brake."""
        how = _HOW.get(self._ends.get(serial, -1)) if event.tick == self._tick else None
        if how is None or self._machine.registry.is_abort_meant(serial):
            return
        if why == rows.WITH_CYCLE_WAITING:
            yield from self._note(event, axis, _WAITING, how)
        else:
            self._braking[axis] = _GivenUp(event, how, why == rows.WITH_CYCLE_ENDLESS)

    def _stop(self, axis: int, distance: float) -> Iterator[Diagnostic]:
        """Report where a motion aborted by its cycle has stopped."""
        given_up = self._braking.pop(axis, None)
        if given_up is None:
            return
        what = _ENDLESS
        if not given_up.is_endless:
            is_linear = self._machine.configuration.axes[axis].type is AxisType.LINEAR
            if abs(distance) < SMALLEST_DISTANCE:
                return
            shown = f"{abs(distance):.4g}{' mm' if is_linear else '°'}"
            what = Text(_STOPPED.en.format(distance=shown), _STOPPED.de.format(distance=shown))
        yield from self._note(given_up.event, axis, what, given_up.how)

    def _note(self, event: Event, axis: int, what: Text, how: Text) -> Iterator[Diagnostic]:
        key = f"{event.span} {self._machine.registry.axis(axis)}"
        if key in self._noted:
            return
        self._noted.add(key)
        line = "" if event.span is None else self._machine.files.line_at(event.span)
        yield diagnostic(
            MOTION_ENDED_WITH_CYCLE,
            statement_span(event.span, line),
            line,
            axis=self._machine.registry.axis(axis),
            what=what,
            cycle=event.cycle,
            how=how,
        )
