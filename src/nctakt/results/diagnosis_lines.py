# SPDX-License-Identifier: MIT
"""Events -> the lines of the realtime cycles' diagnosis data (manual chapter 5, RC-601 … RC-603).

Each line has a level: 1 errors, 2 warnings, 3 management, 4 actions.
"""

from __future__ import annotations

import enum
from collections.abc import Sequence
from dataclasses import replace

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Language, Span, Text
from nctakt.kernel import rows
from nctakt.messages import diagnostic
from nctakt.messages.catalogue import messages_of
from nctakt.messages.programs.diagnosis import (
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
    LOG_MOTION_STATE,
    LOG_SPINDLE_POSITION,
    LOG_SPINDLE_REACHED,
    LOG_SPINDLE_STOPS,
    LOG_SPINDLE_TURNS,
    LOG_TIMER,
    LOG_TIMER_READ,
    LOG_USER_ERROR,
    LOG_VARIABLE_WRITTEN,
)
from nctakt.results.trace.events import Event
from nctakt.results.user_errors import user_message


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
    "spindle": Level.ACTION,
    "spindle_position": Level.ACTION,
    "spindle_reached": Level.ACTION,
    "timer": Level.ACTION,
    "M": Level.ACTION,
    "H": Level.ACTION,
}
#: Kinds of rows that lines of actions are made of, where a cycle is their subject.
ACTION_ROWS = frozenset(
    (
        rows.EVENT_FIRED,
        rows.EVENT_WRITTEN,
        rows.EVENT_WRITTEN_TEXT,
        rows.EVENT_TECHNOLOGY_RT,
        rows.EVENT_AXIS_BEGUN,
        rows.EVENT_AXIS_ENDLESS,
        rows.EVENT_AXIS_ENDED,
        rows.EVENT_AXIS_CHANGED,
        rows.EVENT_SPINDLE,
        rows.EVENT_SPINDLE_POSITION,
        rows.EVENT_SPINDLE_REACHED,
        rows.EVENT_TIMER,
    )
)
#: Kinds of rows that lines of the other levels are made of.
OTHER_ROWS = frozenset(
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
    "aborted": Text("was aborted", "wurde abgebrochen"),
    "failed": Text("has failed", "ist gescheitert"),
    "held": Text("is put on hold", "wird angehalten"),
    "continued": Text("continues", "wird fortgesetzt"),
    "stopped": Text("has come to a stop", "ist zum Stehen gekommen"),
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


def levels_of(event: Event) -> tuple[Level, ...]:
    """Return the levels of the lines that an event makes; it may make none."""
    if event.kind == "user_error":
        return (_user_level(event), Level.ACTION) if event.cycle else ()
    level = _LEVELS.get(event.kind)
    if level is None or not (event.cycle or level <= Level.WARNING):
        return ()
    return (level,)


def line_of(event: Event, level: Level) -> Line:
    """Return the line of an event at one of its levels."""
    if level > Level.WARNING:
        message = _message(event)
        return Line(event.time_us, level, message.id, message.span, message)
    if event.kind == "user_error":
        number = user_message(int(event.text.split()[1])).id
        return Line(event.time_us, level, number, event.span, None)
    plain = _message_without_parameters(event)
    return Line(event.time_us, level, int(event.text), event.span, plain)


def _user_level(event: Event) -> Level:
    """Return the level of an ``#ERROR``, by its RC."""
    return Level.WARNING if event.text.split()[1] == "0" else Level.ERROR


def management_line(time_us: int, message: Diagnostic) -> Line:
    """Return the line of a message about the manager of the realtime cycles."""
    return Line(time_us, Level.INFO, message.id, message.span, message)


def _message_without_parameters(event: Event) -> Diagnostic | None:
    """Return the message of an event if it needs no parameters, else ``None``."""
    number = int(event.text)
    leading = [message for message in messages_of(number) if number in message.leading]
    if len(leading) != 1 or leading[0].parameters:
        return None
    return replace(diagnostic(leading[0], event.span), number=number)


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


def _spindle_message(event: Event) -> Diagnostic:
    """Return the message about a job of a spindle that a cycle has commanded."""
    spindle, *words = event.text.split(" ")
    cycle = event.cycle
    if event.kind == "spindle_reached":
        return diagnostic(LOG_SPINDLE_REACHED, cycle=cycle, spindle=spindle)
    if event.kind == "spindle_position":
        return diagnostic(LOG_SPINDLE_POSITION, cycle=cycle, spindle=spindle, position=words[0])
    function, speed = words
    if function == "M5":
        return diagnostic(LOG_SPINDLE_STOPS, cycle=cycle, spindle=spindle)
    return diagnostic(
        LOG_SPINDLE_TURNS, cycle=cycle, spindle=spindle, function=function, speed=speed
    )


def _timer_message(event: Event) -> Diagnostic:
    """Return the message about a ``#TIMER`` of a cycle."""
    timer, action, *value = event.text.split(" ")
    if value:
        return diagnostic(LOG_TIMER_READ, cycle=event.cycle, timer=timer, value=value[0])
    return diagnostic(LOG_TIMER, cycle=event.cycle, timer=timer, action=action)


def _message(event: Event) -> Diagnostic:
    words = event.text.split(" ")
    cycle = event.cycle
    match event.kind:
        case "started" | "held" | "continued" | "aborted":
            return diagnostic(_PLAIN[event.kind], cycle=cycle)
        case "ended":
            return diagnostic(_ENDED[words[-1]], cycle=cycle)
        case "created":
            return diagnostic(LOG_CYCLE_CREATED, cycle=cycle, scope=words[-1])
        case "fired":
            return diagnostic(LOG_BRANCH_RUNS, cycle=cycle, line=words[-1])
        case "axis":
            return _axis_message(event)
        case "spindle" | "spindle_position" | "spindle_reached":
            return _spindle_message(event)
        case "timer":
            return _timer_message(event)
        case "user_error":
            return diagnostic(LOG_USER_ERROR, cycle=cycle, id=words[0], rc=words[1])
        case "written":
            variable, value = event.text.split(" ", 1)
            return diagnostic(LOG_VARIABLE_WRITTEN, cycle=cycle, variable=variable, value=value)
        case _:
            function = f"{event.kind}{words[0]}"
            return diagnostic(
                LOG_FUNCTION_OUTPUT, cycle=cycle, function=function, sequence=words[1]
            )
