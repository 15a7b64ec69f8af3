# SPDX-License-Identifier: MIT
"""The diagnosis data of the realtime cycles as text (manual chapter 5, RC-601 … RC-603).

In: events, each with the value of V.RTG.CYCLES.DIAG_LEVEL at its time, which decides whether it
becomes a line. Out: the text with header, rule, note and the columns timestamp, level and message,
in English or German. Timestamps are microseconds of controller time.
"""

from __future__ import annotations

import enum
from collections import deque
from collections.abc import Sequence

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Language, Span, Text
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
from nctakt.trace.events import Event
from nctakt.trace.sinks import TraceHeader

#: Maximum number of lines kept; each further line pushes out the oldest.
DIAGNOSIS_CAPACITY = 1000

#: The value of V.RTG.CYCLES.DIAG_LEVEL after a start of the controller.
DEFAULT_LEVEL = 3

_LEVEL_VARIABLE = "V.RTG.CYCLES.DIAG_LEVEL "

_TITLE = Text(
    "PATH : REALTIME CYCLES DIAGNOSIS DATA CHANNEL NO.: {channel}",
    "BAHN : ECHTZEIT-ZYKLEN DIAGNOSE DATEN KANAL-NR.: {channel}",
)
_NOTE = Text(
    "Note:\nV.RTG.CYCLES.DIAG_LEVEL decides which messages are listed here.",
    "Hinweis:\nV.RTG.CYCLES.DIAG_LEVEL bestimmt, welche Nachrichten hier stehen.",
)
_PUSHED_OUT = Text(
    "Older messages that are no longer kept: {count}",
    "Aeltere, nicht mehr vorhandene Nachrichten: {count}",
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
    """Gathers the diagnosis data of one channel, the newest ``capacity`` lines."""

    def __init__(self, channel: int = 1, capacity: int = DIAGNOSIS_CAPACITY) -> None:
        assert capacity > 0
        self.channel = channel
        self._lines: deque[Line] = deque(maxlen=capacity)
        self._pushed_out = 0

    @property
    def lines(self) -> tuple[Line, ...]:
        """The lines that are kept, the oldest first."""
        return tuple(self._lines)

    def initialised(self, time_us: int, count: int, level_limit: float = DEFAULT_LEVEL) -> None:
        """Add the line that the manager of the realtime cycles is set up with ``count`` cycles."""
        if level_limit >= Level.INFO:
            self._append(_info(time_us, diagnostic(LOG_MANAGER_INITIALISED)))
            self._append(_info(time_us, diagnostic(LOG_MANAGER_CAPACITY, count=count)))

    def add(self, event: Event, level_limit: float) -> None:
        """Add a line for ``event`` if its level is at most ``level_limit``.

        ``level_limit`` is V.RTG.CYCLES.DIAG_LEVEL at the time of the event. Events that do not
        come from realtime cycles or their manager add no line.
        """
        level = _user_level(event) if event.kind == "user_error" else _LEVELS.get(event.kind)
        if level is None or level > level_limit:
            return
        if event.kind == "user_error":
            message = user_message(int(event.text.split()[1]))
            self._append(Line(event.time_us, level, message.id, event.span, None))
        elif level <= Level.WARNING:
            known = _message_without_parameters(event)
            self._append(Line(event.time_us, level, int(event.text), event.span, known))
        elif event.cycle:
            self._append(_info(event.time_us, _message(event), level))

    def render(self, language: Language = "en", details: Sequence[Diagnostic] = ()) -> str:
        """Return the diagnosis data as text with a final line end.

        ``details`` are the diagnostics of the run: they have the texts of the errors, of which an
        event holds only the number.
        """
        title = _TITLE.get(language).format(channel=self.channel)
        text = [title, "=" * _WIDTH, "", _NOTE.get(language)]
        if self._pushed_out:
            text.append(_PUSHED_OUT.get(language).format(count=self._pushed_out))
        heads = _COLUMNS.format(*(head.get(language) for head in _HEADS))
        text += ["", heads, "-" * _WIDTH]
        text += [
            _COLUMNS.format(line.time_us, line.level.name, line.text(language, details))
            for line in self._lines
        ]
        return "\n".join(text) + "\n"

    def _append(self, line: Line) -> None:
        if len(self._lines) == self._lines.maxlen:
            self._pushed_out += 1
        self._lines.append(line)


class DiagnosisSink:
    """A sink that adds the events of a run to its diagnosis data.

    ``level`` is V.RTG.CYCLES.DIAG_LEVEL at the begin of the run; events report its changes.
    """

    def __init__(self, report: DiagnosisReport, level: float = DEFAULT_LEVEL) -> None:
        self.report = report
        self._level = level

    def open(self, header: TraceHeader) -> None:
        """Do nothing: the events suffice."""

    def events(self, events: Sequence[Event]) -> None:
        """Add lines for these events."""
        for event in events:
            if event.channel not in (0, self.report.channel):
                continue
            self.report.add(event, self._level)
            if event.kind == "written" and event.text.startswith(_LEVEL_VARIABLE):
                self._level = float(event.text.removeprefix(_LEVEL_VARIABLE))

    def rows(self, first_tick: int, rows: memoryview[float], width: int) -> None:
        """Do nothing: diagnosis data come from events."""

    def close(self) -> None:
        """Do nothing: the report stays."""


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
