# SPDX-License-Identifier: MIT
"""What a schedule did to a run: when the queue was empty, which threads overflowed.

In: the schedule, events ``starved`` and ``overflow``. Out: ``Starvation`` and ``OverflowCount``;
the lines of all three in the summary.
"""

from __future__ import annotations

from dataclasses import replace

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Language, Span, Text
from nctakt.schedule.findings import us
from nctakt.schedule.open_schedule import RunSchedule
from nctakt.schedule.report import chosen_report
from nctakt.trace.events import Event

#: Starvations that the summary tells one by one.
MOST_TOLD = 6

_LIST = Text(
    "{file}: schedule {schedule}, {block} µs for a block of the decoder",
    "{file}: schedule {schedule}, {block} µs für einen Satz des Dekoders",
)
_ALL = Text(
    "The queue ran empty {count} times, for {ticks} ticks in all",
    "Die Queue lief {count}-mal leer, zusammen {ticks} Takte",
)
_ONCE = Text(
    "The queue ran empty once, for {ticks} ticks", "Die Queue lief einmal leer, {ticks} Takte"
)
_ONE = Text("  {place}: {ticks} from tick {tick} on", "  {place}: {ticks} ab Takt {tick}")
_BEHIND = Text("behind {place}", "hinter {place}")
_START = Text("at the start", "am Anfang")
_FURTHER = Text("  … {count} further", "  … {count} weitere")
_OVERFLOWS = Text(
    "{thread}: {count} overflows, first in tick {tick}",
    "{thread}: {count} Überläufe, zuerst in Takt {tick}",
)
_OVERFLOW = Text("{thread}: 1 overflow, in tick {tick}", "{thread}: 1 Überlauf, in Takt {tick}")


@dataclass(frozen=True, slots=True)
class Starvation:
    """From ``first_tick`` on a channel had nothing to do for so many ticks: the decoder was late.

    ``span`` is the last command that was taken, ``None`` before the first one. ``channel``: its
    number where the machine has more than one, else 0.
    """

    first_tick: int
    ticks: int
    span: Span | None
    channel: int = 0


@dataclass(frozen=True, slots=True)
class OverflowCount:
    """How often a thread was busy when it was due, and in which tick first."""

    thread: str
    count: int
    first_tick: int


class ScheduleStatistics:
    """Gathers both while a run goes on."""

    def __init__(self) -> None:
        self._ended: list[Starvation] = []
        self._open: dict[int, Starvation] = {}
        self._overflows: dict[str, OverflowCount] = {}

    def add(self, event: Event) -> None:
        """An event ``starved`` or ``overflow``."""
        if event.kind == "overflow":
            known = self._overflows.get(event.text, OverflowCount(event.text, 0, event.tick))
            self._overflows[event.text] = replace(known, count=known.count + 1)
        elif event.text == "begun":
            self._open[event.channel] = Starvation(event.tick, 0, event.span, event.channel)
        elif event.channel in self._open:
            self._end(event.channel, event.tick)

    def _end(self, channel: int, tick: int) -> None:
        one = self._open.pop(channel)
        self._ended.append(replace(one, ticks=tick - one.first_tick))

    def starved(self, end_tick: int) -> tuple[Starvation, ...]:
        """All starvations of a run that ends with this tick, in the order of their begins."""
        for channel in list(self._open):
            self._end(channel, end_tick)
        return tuple(sorted(self._ended, key=lambda one: (one.first_tick, one.channel)))

    def overflows(self) -> tuple[OverflowCount, ...]:
        """The threads that overflowed, in the order in which they did so first."""
        return tuple(self._overflows.values())


def schedule_lines(
    schedule: RunSchedule | None,
    starved: tuple[Starvation, ...],
    overflows: tuple[OverflowCount, ...],
    language: Language,
) -> list[str]:
    """What the summary tells: the rules that were chosen, then what came of it."""
    if schedule is None:
        return []
    first = _LIST.get(language).format(
        file=schedule.file, schedule=schedule.model.schedule, block=us(schedule.load.block)
    )
    lines = [first, *chosen_report(schedule.model, language)]
    if starved:
        total = sum(one.ticks for one in starved)
        head = _ONCE if len(starved) == 1 else _ALL
        lines.append(head.get(language).format(count=len(starved), ticks=total))
        lines += [_line(one, language) for one in starved[:MOST_TOLD]]
        if len(starved) > MOST_TOLD:
            lines.append(_FURTHER.get(language).format(count=len(starved) - MOST_TOLD))
    for one in overflows:
        head = _OVERFLOW if one.count == 1 else _OVERFLOWS
        text = head.get(language)
        lines.append(text.format(thread=one.thread, count=one.count, tick=one.first_tick))
    return lines


def _line(one: Starvation, language: Language) -> str:
    place = _START.get(language)
    if one.span is not None:
        place = _BEHIND.get(language).format(place=f"{one.span.file}:{one.span.line}")
    if one.channel:
        place = f"CH{one.channel} {place}"
    return _ONE.get(language).format(place=place, ticks=one.ticks, tick=one.first_tick)
