# SPDX-License-Identifier: MIT
"""Effects of a schedule on a run: times of an empty queue, overflows of threads.

In: the schedule, events ``starved`` and ``overflow``. Out: ``Starvation`` and ``OverflowCount``;
the lines of all three in the summary.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Language, Span, Text
from nctakt.results.trace.events import Event

if TYPE_CHECKING:
    from nctakt.schedule.open_schedule import RunSchedule

#: Maximum number of starvations that the summary lists one by one.
MAX_STARVATIONS = 6

_LIST = Text(
    "{file}: schedule {schedule}, {block} µs of decoding per block",
    "{file}: schedule {schedule}, {block} µs Dekodierzeit je Satz",
)
_ALL = Text(
    "The queue ran empty {count} times, for {ticks} ticks in total",
    "Die Queue lief {count}-mal leer, zusammen {ticks} Takte",
)
_ONCE = Text(
    "The queue ran empty once, for {ticks} ticks", "Die Queue lief einmal leer, {ticks} Takte"
)
_ONE = Text("  {position}: {ticks} from tick {tick}", "  {position}: {ticks} ab Takt {tick}")
_BEHIND = Text("after {position}", "nach {position}")
_START = Text("at the start", "am Anfang")
_FURTHER = Text("  … {count} more", "  … {count} weitere")
_OVERFLOWS = Text(
    "{thread}: {count} overflows, first in tick {tick}",
    "{thread}: {count} Überläufe, zuerst in Takt {tick}",
)
_OVERFLOW = Text("{thread}: 1 overflow, in tick {tick}", "{thread}: 1 Überlauf, in Takt {tick}")


@dataclass(frozen=True, slots=True)
class Starvation:
    """A time in which a channel had no commands, since the decoder was late.

    It begins at ``first_tick`` and takes ``ticks`` ticks. ``span`` is the last executed command,
    ``None`` before the first one. ``channel``: its number on a machine with several, else 0.
    """

    first_tick: int
    ticks: int
    span: Span | None
    channel: int = 0


@dataclass(frozen=True, slots=True)
class OverflowCount:
    """The number of activations that found a thread busy, and the tick of the first one."""

    thread: str
    count: int
    first_tick: int


class ScheduleStatistics:
    """Gathers starvations and overflows during a run."""

    def __init__(self) -> None:
        self._ended: list[Starvation] = []
        self._open: dict[int, Starvation] = {}
        self._overflows: dict[str, OverflowCount] = {}

    def add(self, event: Event) -> None:
        """Add an event ``starved``, ``fed`` or ``overflow``."""
        if event.kind == "overflow":
            count = self._overflows.get(event.text, OverflowCount(event.text, 0, event.tick))
            self._overflows[event.text] = replace(count, count=count.count + 1)
        elif event.text == "begun":
            self._open[event.channel] = Starvation(event.tick, 0, event.span, event.channel)
        elif event.channel in self._open:
            self._end(event.channel, event.tick)

    def _end(self, channel: int, tick: int) -> None:
        starvation = self._open.pop(channel)
        self._ended.append(replace(starvation, ticks=tick - starvation.first_tick))

    def starved(self, end_tick: int) -> tuple[Starvation, ...]:
        """Return all starvations of a run that ends at this tick, in the order of their begins."""
        for channel in list(self._open):
            self._end(channel, end_tick)
        return tuple(
            sorted(self._ended, key=lambda starvation: (starvation.first_tick, starvation.channel))
        )

    def overflows(self) -> tuple[OverflowCount, ...]:
        """Return the threads that overflowed, in the order of their first overflows."""
        return tuple(self._overflows.values())


def schedule_lines(
    schedule: RunSchedule | None,
    starved: tuple[Starvation, ...],
    overflows: tuple[OverflowCount, ...],
    language: Language,
) -> list[str]:
    """Return the lines of the summary: the rules of the schedule, then its effects."""
    if schedule is None:
        return []
    from nctakt.schedule.analysis.findings import us  # noqa: PLC0415 - few runs have a schedule
    from nctakt.schedule.reports.report import chosen_report  # noqa: PLC0415 - as above

    first = _LIST.get(language).format(
        file=schedule.file, schedule=schedule.model.schedule, block=us(schedule.load.block)
    )
    lines = [first, *chosen_report(schedule.model, language)]
    if starved:
        total = sum(item.ticks for item in starved)
        head = _ONCE if len(starved) == 1 else _ALL
        lines.append(head.get(language).format(count=len(starved), ticks=total))
        lines += [_line(item, language) for item in starved[:MAX_STARVATIONS]]
        if len(starved) > MAX_STARVATIONS:
            lines.append(_FURTHER.get(language).format(count=len(starved) - MAX_STARVATIONS))
    for item in overflows:
        head = _OVERFLOW if item.count == 1 else _OVERFLOWS
        text = head.get(language)
        lines.append(text.format(thread=item.thread, count=item.count, tick=item.first_tick))
    return lines


def _line(starvation: Starvation, language: Language) -> str:
    position = _START.get(language)
    if starvation.span is not None:
        position = _BEHIND.get(language).format(
            position=f"{starvation.span.file}:{starvation.span.line}"
        )
    if starvation.channel:
        position = f"CH{starvation.channel} {position}"
    return _ONE.get(language).format(
        position=position, ticks=starvation.ticks, tick=starvation.first_tick
    )
