# SPDX-License-Identifier: MIT
"""The diagnosis data of the realtime cycles as text (manual chapter 5, RC-601 … RC-603).

In: the events of a run, of which the newest of each level are kept. Out: the text with header,
rule, note and the columns timestamp, level and message, in English or German, up to the level that
V.RTG.CYCLES.DIAG_LEVEL has when the text is made. Timestamps are microseconds of controller time.
"""

from __future__ import annotations

import enum
from collections import deque
from collections.abc import Sequence

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Language, Span, Text
from nctakt.kernel import rows
from nctakt.messages import diagnostic
from nctakt.messages.catalogue import catalogue
from nctakt.messages.diagnosis import (
    LOG_AXIS_MOVES,
    LOG_AXIS_MOVES_ENDLESSLY,
    LOG_BRANCH_RUNS,
    LOG_CYCLE_ABORTED,
    LOG_CYCLE_CONTINUED,
    LOG_CYCLE_CREATED,
    LOG_CYCLE_DELETED,
    LOG_CYCLE_ENDED_BY_ERROR,
    LOG_CYCLE_ENDED_BY_RESET,
    LOG_CYCLE_ENDED_WITH_SCOPE,
    LOG_CYCLE_HELD,
    LOG_CYCLE_STARTED,
    LOG_FUNCTION_OUTPUT,
    LOG_MANAGER_CAPACITY,
    LOG_MANAGER_INITIALISED,
    LOG_MOTION_STATE,
    LOG_VARIABLE_WRITTEN,
)
from nctakt.results.user_errors import user_message
from nctakt.trace.chunks import EventChunk
from nctakt.trace.events import Event
from nctakt.trace.sinks import TraceHeader

#: Maximum number of lines kept of each level; each further line pushes out the oldest of its level.
DIAGNOSIS_CAPACITY = 1000

_TITLE = Text(
    "PATH : REALTIME CYCLES DIAGNOSIS DATA CHANNEL NO.: {channel}",
    "BAHN : ECHTZEIT-ZYKLEN DIAGNOSE DATEN KANAL-NR.: {channel}",
)
_NOTE = Text(
    "Note:\nMessages may be missing here. The documentation of the realtime cycles tells how "
    "to\ninfluence the diagnosis: by V.RTG.CYCLES.DIAG_LEVEL.",
    "Hinweis:\nHier koennen Nachrichten fehlen. Wie sich die Diagnose beeinflussen laesst, "
    "sagt\ndie Dokumentation der Echtzeit-Zyklen: durch V.RTG.CYCLES.DIAG_LEVEL.",
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


class Level(enum.IntEnum):
    """The level of a line; V.RTG.CYCLES.DIAG_LEVEL admits lines up to its value."""

    ERROR = 1
    WARNING = 2
    INFO = 3
    ACTION = 4


_LEVELS = {
    "error": Level.ERROR,
    "warning": Level.WARNING,
    "notice": Level.WARNING,
    "created": Level.INFO,
    "started": Level.INFO,
    "held": Level.INFO,
    "continued": Level.INFO,
    "aborted": Level.INFO,
    "ended": Level.INFO,
    "fired": Level.ACTION,
    "written": Level.ACTION,
    "axis": Level.ACTION,
    "M": Level.ACTION,
    "H": Level.ACTION,
}
#: Kinds of rows that lines of actions are made of, where a cycle is their subject.
_ACTION_ROWS = frozenset(
    (
        rows.EVENT_FIRED,
        rows.EVENT_WRITTEN,
        rows.EVENT_TECHNOLOGY_RT,
        rows.EVENT_AXIS_BEGUN,
        rows.EVENT_AXIS_ENDLESS,
        rows.EVENT_AXIS_ENDED,
        rows.EVENT_AXIS_CHANGED,
    )
)
#: Kinds of rows that lines of the other levels are made of.
_OTHER_ROWS = frozenset(
    (
        rows.EVENT_CREATED,
        rows.EVENT_STARTED,
        rows.EVENT_HELD,
        rows.EVENT_CONTINUED,
        rows.EVENT_ABORTED,
        rows.EVENT_ENDED,
        rows.EVENT_ERROR,
        rows.EVENT_NOTICE,
        rows.EVENT_USER_ERROR,
    )
)
_PLAIN = {
    "started": LOG_CYCLE_STARTED,
    "held": LOG_CYCLE_HELD,
    "continued": LOG_CYCLE_CONTINUED,
    "aborted": LOG_CYCLE_ABORTED,
}
_MOTIONS = {
    "done": Text("is done", "ist beendet"),
    "aborted": Text("was given up", "wurde abgebrochen"),
    "failed": Text("has failed", "ist gescheitert"),
    "held": Text("is put on hold", "wird angehalten"),
    "continued": Text("goes on", "geht weiter"),
    "stopped": Text("has come to a stand", "ist zum Stehen gekommen"),
}
_DIRECTIONS = {
    "positive": Text("positive", "positiver"),
    "negative": Text("negative", "negativer"),
}
_ENDED = {
    "scope": LOG_CYCLE_ENDED_WITH_SCOPE,
    "delete": LOG_CYCLE_DELETED,
    "reset": LOG_CYCLE_ENDED_BY_RESET,
    "error": LOG_CYCLE_ENDED_BY_ERROR,
}


@dataclass(frozen=True, slots=True)
class Line:
    """A line of the diagnosis data: time, level, number and position of the message.

    ``message`` is ``None`` for an error or warning whose parameters are not part of the event.
    """

    time_us: int
    level: Level
    number: int
    span: Span | None
    message: Diagnostic | None

    def text(self, language: Language, details: Sequence[Diagnostic]) -> str:
        """Return the message; an error's text is found in ``details`` by number and position."""
        if self.level > Level.WARNING:
            assert self.message is not None
            return self.message.text(language)
        for candidate in (self.message, *details):
            if (
                candidate is not None
                and candidate.id == self.number
                and self._is_at(candidate.span)
            ):
                return f"{self.number}: {candidate.text(language)}"
        return str(self.number)

    def _is_at(self, span: Span | None) -> bool:
        if span is None or self.span is None:
            return span is self.span
        return (span.file, span.line) == (self.span.file, self.span.line)


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
            self._append(Level.INFO, self._next, _info(time_us, message))
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
            level = _level(event)
            if level is not None:
                self._append(level, self._next + index, event)
        self._next += len(events)

    def lines(self, level_limit: float) -> list[Line]:
        """Return the lines kept up to this level, in the order of their events."""
        kept = [entry for level in Level if level <= level_limit for entry in self._kept[level]]
        kept.sort(key=lambda entry: entry[0])
        return [one if isinstance(one, Line) else _line(one) for _, one in kept]

    def render(
        self, level_limit: float, language: Language = "en", details: Sequence[Diagnostic] = ()
    ) -> str:
        """Return the diagnosis data up to this level as text with a final line end.

        ``details`` are the diagnostics of the run: they have the texts of the errors, of which an
        event holds only the number.
        """
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

    def _append(self, level: Level, index: int, one: Event | Line) -> None:
        self._kept[level].append((index, one))
        self._counts[level] += 1

    def _newest(self, chunk: EventChunk) -> tuple[list[int], Sequence[Event]]:
        """Return the indexes of what is to be kept of a chunk, and its events.

        Of actions these are as many as are kept; the others are counted, and never decoded.
        """
        kinds, subjects = chunk.column(rows.EVENT_KIND), chunk.column(rows.EVENT_SUBJECT)
        channels = chunk.column(rows.EVENT_CHANNEL)
        actions = [
            index
            for index, (kind, subject, channel) in enumerate(
                zip(kinds, subjects, channels, strict=True)
            )
            if kind in _ACTION_ROWS and subject and channel in (0, self.channel)
        ]
        indexes = [index for index, kind in enumerate(kinds) if kind in _OTHER_ROWS]
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

    def rows(self, first_tick: int, rows: memoryview[float], width: int) -> None:
        """Do nothing: diagnosis data come from events."""

    def close(self) -> None:
        """Do nothing: the report stays."""


def _level(event: Event) -> Level | None:
    """Return the level of an event, ``None`` if it makes no line."""
    if event.kind == "user_error":
        return _user_level(event) if event.cycle else None
    level = _LEVELS.get(event.kind)
    return level if event.cycle or level in (Level.ERROR, Level.WARNING) else None


def _line(event: Event) -> Line:
    """Return the line of an event that has a level."""
    level = _level(event)
    assert level is not None
    if event.kind == "user_error":
        message = user_message(int(event.text.split()[1]))
        return Line(event.time_us, level, message.id, event.span, None)
    if level <= Level.WARNING:
        return Line(
            event.time_us, level, int(event.text), event.span, _message_without_parameters(event)
        )
    return _info(event.time_us, _message(event), level)


def _user_level(event: Event) -> Level:
    """Return the level of an ``#ERROR``, by its RC."""
    return Level.WARNING if event.text.split()[1] == "0" else Level.ERROR


def _info(time_us: int, message: Diagnostic, level: Level = Level.INFO) -> Line:
    return Line(time_us, level, message.id, message.span, message)


def _message_without_parameters(event: Event) -> Diagnostic | None:
    """Return the message of an event if it needs no parameters, else ``None``."""
    message = catalogue().get(int(event.text))
    if message is None or message.parameters:
        return None
    return diagnostic(message, event.span)


def _axis_message(event: Event) -> Diagnostic:
    """Return the message about a motion that a cycle has commanded."""
    axis, word, *target = event.text.split(" ")
    if word in _MOTIONS:
        state = _MOTIONS[word]
        return diagnostic(LOG_MOTION_STATE, cycle=event.cycle, axis=axis, state=state)
    if target[0] in _DIRECTIONS:
        direction = _DIRECTIONS[target[0]]
        return diagnostic(
            LOG_AXIS_MOVES_ENDLESSLY,
            cycle=event.cycle,
            axis=axis,
            direction=direction,
        )
    return diagnostic(LOG_AXIS_MOVES, cycle=event.cycle, axis=axis, position=target[0])


def _message(event: Event) -> Diagnostic:
    words = event.text.split(" ")
    cycle = event.cycle
    if event.kind in _PLAIN:
        return diagnostic(_PLAIN[event.kind], cycle=cycle)
    if event.kind == "ended":
        return diagnostic(_ENDED[words[-1]], cycle=cycle)
    if event.kind == "created":
        return diagnostic(LOG_CYCLE_CREATED, cycle=cycle, scope=words[-1])
    if event.kind == "fired":
        return diagnostic(LOG_BRANCH_RUNS, cycle=cycle, line=words[-1])
    if event.kind == "axis":
        return _axis_message(event)
    if event.kind == "written":
        variable, value = event.text.rsplit(" ", 1)
        return diagnostic(LOG_VARIABLE_WRITTEN, cycle=cycle, variable=variable, value=value)
    function = f"{event.kind}{words[0]}"
    return diagnostic(LOG_FUNCTION_OUTPUT, cycle=cycle, function=function, sequence=words[1])
