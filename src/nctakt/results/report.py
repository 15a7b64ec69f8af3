# SPDX-License-Identifier: MIT
"""The diagnosis data of the realtime cycles as text (manual chapter 5, RC-601 … RC-603).

In: the events of a run, of which the newest of each level are kept. Out: the text with header,
rule, note and the columns timestamp, level and message, in English or German, up to the level that
V.RTG.CYCLES.DIAG_LEVEL has when the text is made. Timestamps are microseconds of controller time.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from dataclasses import replace

from nctakt.base.diagnostics import Diagnostic, Language, Text
from nctakt.kernel import rows
from nctakt.messages import diagnostic
from nctakt.messages.programs.diagnosis import LOG_MANAGER_CAPACITY, LOG_MANAGER_INITIALISED
from nctakt.results.diagnosis_lines import (
    ACTION_ROWS,
    OTHER_ROWS,
    Level,
    Line,
    levels_of,
    line_of,
    management_line,
)
from nctakt.results.trace.chunks import EventChunk
from nctakt.results.trace.events import Event
from nctakt.results.trace.sinks import TraceHeader

#: Maximum number of lines kept of each level; each further line pushes out the oldest of its level.
DIAGNOSIS_CAPACITY = 1000

_TITLE = Text(
    "PATH : REALTIME CYCLES DIAGNOSIS DATA CHANNEL NO.: {channel}",
    "BAHN : ECHTZEIT-ZYKLEN DIAGNOSE DATEN KANAL-NR.: {channel}",
)
_NOTE = Text(
    "Note:\nMessages may be hidden here. The documentation of the realtime cycles says how "
    "to\ninfluence the diagnosis: by V.RTG.CYCLES.DIAG_LEVEL.",
    "Hinweis:\nHier koennen Nachrichten ausgeblendet sein. Die Dokumentation der Echtzeit-Zyklen "
    "sagt,\nwie sich die Diagnose beeinflussen laesst: durch V.RTG.CYCLES.DIAG_LEVEL.",
)
_PUSHED_OUT = Text(
    "The newest {capacity} messages of each level are kept; older ones: {count}",
    "Die neuesten {capacity} Nachrichten jedes Levels sind vorhanden; aeltere: {count}",
)
_HEADS = (
    Text("Timestamp", "Zeitstempel"),
    Text("Level", "Level"),
    Text("Message", "Nachricht"),
)
_WIDTH = 63
_COLUMNS = "{:<12}{:<8}{}"


class DiagnosisReport:
    """Gathers the diagnosis data of one channel: the newest ``capacity`` lines of each level."""

    def __init__(self, channel: int = 1, capacity: int = DIAGNOSIS_CAPACITY) -> None:
        assert capacity > 0
        self.channel = channel
        self._capacity = capacity
        self._kept: dict[Level, deque[tuple[int, Event | Line]]] = {
            level: deque(maxlen=capacity) for level in Level
        }
        self._counts = dict.fromkeys(Level, 0)
        self._next = 0

    def initialised(self, time_us: int, count: int) -> None:
        """Add the lines that the manager of the realtime cycles is set up with ``count`` cycles."""
        for message in (
            diagnostic(LOG_MANAGER_INITIALISED),
            diagnostic(LOG_MANAGER_CAPACITY, count=count),
        ):
            self._append(Level.INFO, self._next, management_line(time_us, message))
            self._next += 1

    def add(self, events: Sequence[Event]) -> None:
        """Keep the events that come from realtime cycles or from their manager."""
        indexes: Sequence[int] = range(len(events))
        kept = events
        if isinstance(events, EventChunk):
            indexes, kept = self._newest(events)
        for index, event in zip(indexes, kept, strict=True):
            if event.channel not in (0, self.channel):
                continue
            for level in levels_of(event):
                self._append(level, self._next + index, event)
        self._next += len(events)

    def lines(self, level_limit: float) -> list[Line]:
        """Return the lines kept up to this level, in the order of their events."""
        kept = [
            (index, level, entry)
            for level in Level
            if level <= level_limit
            for index, entry in self._kept[level]
        ]
        kept.sort(key=lambda item: item[:2])
        return [
            entry if isinstance(entry, Line) else line_of(self._local(entry), level)
            for _, level, entry in kept
        ]

    def _local(self, event: Event) -> Event:
        """Return an event with the cycle's name in its channel, which the title names."""
        return replace(event, cycle=event.cycle.removeprefix(f"{self.channel}:"))

    def _local_detail(self, found: Diagnostic) -> Diagnostic:
        """Return a diagnostic with the cycle's name in its channel."""
        if "cycle" not in found.values:
            return found
        cycle = str(found.values["cycle"]).removeprefix(f"{self.channel}:")
        return replace(found, values={**found.values, "cycle": cycle})

    def render(
        self, level_limit: float, language: Language = "en", details: Sequence[Diagnostic] = ()
    ) -> str:
        """Return the diagnosis data up to this level as text with a final line end.

        ``details`` are the diagnostics of the run: they have the texts of the errors, of which an
        event holds only the number.
        """
        details = [self._local_detail(found) for found in details]
        title = _TITLE.get(language).format(channel=self.channel)
        text = [title, "=" * _WIDTH, "", _NOTE.get(language)]
        shown = [level for level in Level if level <= level_limit]
        pushed_out = sum(self._counts[level] - len(self._kept[level]) for level in shown)
        if pushed_out:
            note = _PUSHED_OUT.get(language)
            text.append(note.format(capacity=self._capacity, count=pushed_out))
        heads = _COLUMNS.format(*(head.get(language) for head in _HEADS))
        text += ["", heads, "-" * _WIDTH]
        text += [
            _COLUMNS.format(line.time_us, line.level.name, line.text(language, details))
            for line in self.lines(level_limit)
        ]
        return "\n".join(text) + "\n"

    def _append(self, level: Level, index: int, entry: Event | Line) -> None:
        self._kept[level].append((index, entry))
        self._counts[level] += 1

    def _newest(self, chunk: EventChunk) -> tuple[list[int], Sequence[Event]]:
        """Return the indices of the events of a chunk to be kept, and the events.

        Of actions these are as many as are kept; the others are counted, and never decoded.
        """
        kinds, subjects = chunk.column(rows.EVENT_KIND), chunk.column(rows.EVENT_SUBJECT)
        channels = chunk.column(rows.EVENT_CHANNEL)
        actions = [
            index
            for index, (kind, subject, channel) in enumerate(
                zip(kinds, subjects, channels, strict=True)
            )
            if kind in ACTION_ROWS and subject and channel in (0, self.channel)
        ]
        indexes = [index for index, kind in enumerate(kinds) if kind in OTHER_ROWS]
        indexes = sorted(indexes + actions[-self._capacity :])
        self._counts[Level.ACTION] += max(0, len(actions) - self._capacity)
        return indexes, chunk.select(indexes)


class DiagnosisSink:
    """A sink that keeps the events of a run for its diagnosis data."""

    def __init__(self, report: DiagnosisReport) -> None:
        self.report = report

    def open(self, header: TraceHeader) -> None:
        """Do nothing: the events suffice."""

    def events(self, events: Sequence[Event]) -> None:
        """Keep these events."""
        self.report.add(events)

    def close(self) -> None:
        """Do nothing: the report stays."""
