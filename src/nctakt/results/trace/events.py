# SPDX-License-Identifier: MIT
"""Events of a tick: the realtime part's event rows -> ``Event`` objects with text.

In: event rows of the realtime part (``kernel/rows.py``) and ``EventNames``, the names for their
numbers. Out: events in the order of their occurrence.
"""

from __future__ import annotations

import struct
from collections.abc import Callable
from math import isnan
from typing import Protocol

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Severity, Span
from nctakt.hli.function_codes import function_of
from nctakt.kernel import codes, rows
from nctakt.messages.catalogue import messages_of
from nctakt.nc.meaning.words import ERROR_KEYWORDS
from nctakt.nc.vocabulary.variables.strings import decode

ROW = struct.Struct(f"={rows.EVENT_WIDTH}d")

_SCOPES = ("BLOCK", "PROG", "GLOBAL")
#: Why the channel is emptied, by number.
_WAITS = ("flush", "read", "positions", "write")
_ENDED_BY = {
    rows.ENDED_BY_SCOPE: "scope",
    rows.ENDED_BY_DELETE: "delete",
    rows.ENDED_BY_RESET: "reset",
    rows.ENDED_BY_ERROR: "error",
}
_EXCHANGES = {
    codes.AXIS_AWAITED: "awaited",
    codes.AXIS_TAKEN: "taken",
    codes.AXIS_GIVEN: "given",
}
_TIMER_ACTIONS = {
    codes.TIMER_START: "START",
    codes.TIMER_STOP: "STOP",
    codes.TIMER_READ: "READ",
    codes.TIMER_CLEAR: "CLEAR",
}
_LOOPS = {
    rows.LOOP_BEGUN: "begun",
    rows.LOOP_SKIPPED: "skipped",
    rows.LOOP_LEFT: "left",
}
_RETRACED = {
    rows.RETRACE_BACKWARD: "backward",
    rows.RETRACE_FORWARD: "forward",
    rows.RETRACE_START: "start",
    rows.RETRACE_FRONT: "front",
}
_MOTION_ENDED = {
    rows.MOTION_DONE: "done",
    rows.MOTION_ABORTED: "aborted",
    rows.MOTION_FAILED: "failed",
}
_MOTION_CHANGED = {
    rows.MOTION_HELD: "held",
    rows.MOTION_CONTINUED: "continued",
    rows.MOTION_STOPPED: "stopped",
}


#: A decoder, subject and arguments of an event -> its kind and text.
Maker = Callable[["EventDecoder", int, float, float, float], tuple[str, str]]


@dataclass(frozen=True, slots=True)
class Event:
    """An event in tick ``tick``, which begins at ``time_us``.

    ``kind`` is a word, ``text`` gives the details (``fired``, ``17 line 5``). ``span`` is its
    position in a program. ``cycle`` is the realtime cycle that caused it: its programmed ID, or
    ``#1`` for the first cycle without ID; empty for the path, the decoder and the manager.
    ``channel`` is the number of its channel on a machine with several channels, else 0; cycles are
    called ``2:17`` there.
    """

    tick: int
    time_us: int
    kind: str
    text: str
    span: Span | None = None
    cycle: str = ""
    channel: int = 0

    def __str__(self) -> str:
        return f"{self.prefix}{self.kind} {self.text}"

    @property
    def prefix(self) -> str:
        """The channel before the event's text, ``CH2``; empty on a machine with one."""
        return f"CH{self.channel} " if self.channel else ""


class EventNames(Protocol):
    """The names for the numbers in event rows; valid for as long as events are read."""

    def cycle(self, serial: int) -> str:
        """Return the programmed ID of the cycle with this serial number, or ``#1`` without one."""

    def variable(self, cell: int) -> str:
        """Return the name of the variable in a memory cell."""

    def axis(self, index: int) -> str:
        """Return the name of an axis."""

    def message(self, number: int) -> str:
        """Return the text of the message with this number."""

    def variable_text(self, number: int) -> str:
        """Return the text of a variable whose value was frozen."""

    def spindle(self, number: int) -> str:
        """Return the name of a spindle of the channel."""

    def user_text(self, number: int) -> str:
        """Return a text that is reported with a user error."""

    def program(self, number: int) -> str:
        """Return the file name of a program."""

    def thread(self, number: int) -> str:
        """Return the name of a thread of the schedule."""

    def span(self, source: int) -> Span | None:
        """Return the position with this source id, ``None`` without one."""


def number_text(value: float) -> str:
    """Return a number as short as it can be written without loss; whole numbers without ``.0``."""
    return repr(value + 0.0).removesuffix(".0")


def value_text(value: float | str) -> str:
    """Return a number as ``number_text``, a text between quotes."""
    return f'"{value}"' if isinstance(value, str) else number_text(value)


class EventDecoder:
    """Turns event rows into events; ``cycle_time_us`` is the length of a tick."""

    def __init__(self, cycle_time_us: int, names: EventNames) -> None:
        self.cycle_time_us = cycle_time_us
        self.names = names
        self._spans: dict[int, Span | None] = {}

    def decode(self, data: bytes | memoryview) -> list[Event]:
        """Return the events of rows from ``Record.take_events``."""
        return [self._event(*row) for row in ROW.iter_unpack(data)]

    def _event(
        self,
        tick: float,
        kind_number: float,
        channel: float,
        source: float,
        subject: float,
        a: float,
        b: float,
        c: float,
    ) -> Event:
        number, kind, serial = int(tick), int(kind_number), int(subject)
        time_us = number * self.cycle_time_us
        span = self._span(int(source))
        if kind == rows.EVENT_FIRED:
            word, text = self._fired(serial, span)
        elif kind == rows.EVENT_PAUSED:
            word, text = "paused", _line_text(span)
        elif kind == rows.EVENT_TECHNOLOGY_RT:
            word, text = self._technology_rt(a, b, time_us)
        else:
            word, text = _MAKERS[kind](self, serial, a, b, c)
        cycle = self.names.cycle(serial) if serial and kind not in _WITHOUT_CYCLE else ""
        return Event(number, time_us, word, text, span, cycle, int(channel))

    def _span(self, source: int) -> Span | None:
        """Return the position of a source id; each is looked up only once."""
        if source not in self._spans:
            self._spans[source] = self.names.span(source)
        return self._spans[source]

    def _created(self, serial: int, scope: float, _b: float, _c: float) -> tuple[str, str]:
        return "created", f"{self.names.cycle(serial)} {_SCOPES[int(scope)]}"

    def _ended(self, serial: int, reason: float, _b: float, _c: float) -> tuple[str, str]:
        return "ended", f"{self.names.cycle(serial)} {_ENDED_BY[int(reason)]}"

    def _fired(self, serial: int, span: Span | None) -> tuple[str, str]:
        return "fired", f"{self.names.cycle(serial)} {_line_text(span)}"

    def _written(self, _serial: int, cell: float, value: float, _c: float) -> tuple[str, str]:
        return "written", f"{self.names.variable(int(cell))} {number_text(value)}"

    def _written_text(
        self, _serial: int, cell_of_part: float, left: float, right: float
    ) -> tuple[str, str]:
        parts, cell = divmod(int(cell_of_part), rows.TEXT_PART)
        text = "".join(_characters(int(half)) for half in (left, right))
        before, after = "…" if parts > 1 else "", "…" if parts % 2 else ""
        return "written", f'{self.names.variable(cell)} "{before}{text}{after}"'

    def _technology_rt(self, number: float, sequence: float, time_us: int) -> tuple[str, str]:
        letter, value = function_of(number)
        return letter, f"{value} {int(sequence)} {time_us}"

    def _technology(
        self, has_value: int, function: float, value: float, _c: float
    ) -> tuple[str, str]:
        letter, number = function_of(function)
        return "output", f"{letter} {number}" + (f" = {int(value)}" if has_value else "")

    def _message(self, number: int, _a: float, _b: float, _c: float) -> tuple[str, str]:
        return "message", self.names.message(number)

    def _error(self, _serial: int, number: float, _b: float, _c: float) -> tuple[str, str]:
        return _severity_word(int(number)), str(int(number))

    def _notice(self, _serial: int, number: float, _b: float, _c: float) -> tuple[str, str]:
        return "notice", str(int(number))

    def _axis_begun(self, _serial: int, axis: float, target: float, _c: float) -> tuple[str, str]:
        return "axis", f"{self.names.axis(int(axis))} begun {number_text(target)}"

    def _axis_endless(
        self, _serial: int, axis: float, direction: float, _c: float
    ) -> tuple[str, str]:
        word = "positive" if direction > 0 else "negative"
        return "axis", f"{self.names.axis(int(axis))} begun {word}"

    def _axis_oscillates(
        self, _serial: int, axis: float, first: float, second: float
    ) -> tuple[str, str]:
        between = f"{number_text(first)} {number_text(second)}"
        return "axis", f"{self.names.axis(int(axis))} begun oscillating {between}"

    def _axis_ended(self, _serial: int, axis: float, how: float, _c: float) -> tuple[str, str]:
        return "axis", f"{self.names.axis(int(axis))} {_MOTION_ENDED[int(how)]}"

    def _axis_changed(self, _serial: int, axis: float, what: float, _c: float) -> tuple[str, str]:
        return "axis", f"{self.names.axis(int(axis))} {_MOTION_CHANGED[int(what)]}"

    def _frozen(self, _serial: int, number: float, value: float, _c: float) -> tuple[str, str]:
        name = self.names.variable_text(int(number))
        return "frozen", f"{name} {number_text(value)}" if not isnan(value) else name

    def _spindle(
        self, _serial: int, spindle: float, function: float, rpm: float
    ) -> tuple[str, str]:
        name = self.names.spindle(int(spindle))
        return "spindle", f"{name} M{int(function)} {number_text(rpm)}"

    def _spindle_reached(
        self, _serial: int, number: float, _b: float, _c: float
    ) -> tuple[str, str]:
        return "spindle_reached", self.names.spindle(int(number))

    def _spindle_position(
        self, _serial: int, number: float, position: float, _c: float
    ) -> tuple[str, str]:
        return "spindle_position", f"{self.names.spindle(int(number))} {number_text(position)}"

    def _user_error(self, _serial: int, number: float, rc: float, _c: float) -> tuple[str, str]:
        return "user_error", f"{int(number)} {int(rc)}"

    def _user_value(self, _serial: int, code: float, value: float, _c: float) -> tuple[str, str]:
        return "user_value", f"{ERROR_KEYWORDS[int(code)]} {number_text(value)}"

    def _user_text(self, _serial: int, code: float, text: float, _c: float) -> tuple[str, str]:
        return "user_value", f"{ERROR_KEYWORDS[int(code)]} {self.names.user_text(int(text))}"

    def _block(self, number: int, decoded: float, _b: float, _c: float) -> tuple[str, str]:
        return "block", f"{number} decoded {int(decoded)}"

    def _retraced(self, how: int, _a: float, _b: float, _c: float) -> tuple[str, str]:
        return "retrace", _RETRACED[how]

    def _fixed_stop(self, _serial: int, axis: float, position: float, _c: float) -> tuple[str, str]:
        return "fixed_stop", f"{self.names.axis(int(axis))} {number_text(position)}"

    def _probed(self, _serial: int, delta: float, _b: float, _c: float) -> tuple[str, str]:
        return "probe", number_text(delta)

    def _touched(self, _serial: int, covered: float, _b: float, _c: float) -> tuple[str, str]:
        return "touch", number_text(covered)

    def _loop(self, how: int, _a: float, _b: float, _c: float) -> tuple[str, str]:
        return "loop", _LOOPS[how]

    def _wait(self, reason: int, cell: float, _b: float, _c: float) -> tuple[str, str]:
        word = _WAITS[reason]
        return "waits", f"{word} {self.names.variable(int(cell))}" if cell else word

    def _starved(self, _serial: int, _a: float, _b: float, _c: float) -> tuple[str, str]:
        return "starved", "begun"

    def _fed(self, ticks: int, _a: float, _b: float, _c: float) -> tuple[str, str]:
        return "starved", f"ended {ticks}"

    def _overflow(self, number: int, _a: float, _b: float, _c: float) -> tuple[str, str]:
        return "overflow", self.names.thread(number)

    def _timer(
        self, _serial: int, timer: float, action: float, latched_ms: float
    ) -> tuple[str, str]:
        value = f" {number_text(latched_ms)}" if action == codes.TIMER_READ else ""
        return "timer", f"{int(timer)} {_TIMER_ACTIONS[int(action)]}{value}"

    def _signal_sent(
        self, number: int, receivers: float, _count: float, _level: float
    ) -> tuple[str, str]:
        return "signal", f"{number} sent {channels_text(int(receivers))}"

    def _signal_awaited(
        self, number: int, senders: float, _b: float, level: float
    ) -> tuple[str, str]:
        return "signal", f"{number} awaited {channels_text(int(senders))}{_by(level)}"

    def _signal_taken(
        self, number: int, sender: float, tick: float, level: float
    ) -> tuple[str, str]:
        sent_us = int(tick) * self.cycle_time_us
        return "signal", f"{number} taken CH{int(sender)} {sent_us}{_by(level)}"

    def _axis_exchanged(
        self, axis: int, what: float, holder: float, spindle: float
    ) -> tuple[str, str]:
        word = _EXCHANGES[int(what)]
        from_channel = f" CH{int(holder)}" if holder else ""
        name = self.names.spindle(int(spindle) - 1) if spindle else self.names.axis(axis)
        return "exchange", f"{name} {word}{from_channel}"

    def _tool_life(
        self, tool: int, _basic: float, seconds: float, distance: float
    ) -> tuple[str, str]:
        name = self.names.user_text(tool) if tool >= 0 else "0"
        return "tool_life", f"{name} {number_text(seconds)} {number_text(distance)}"

    def _program_end(self, number: int, _a: float, _b: float, _c: float) -> tuple[str, str]:
        return "end", self.names.program(number)


def _plain(word: str) -> Maker:
    """Return a decoder for events of a cycle without details."""
    return lambda decoder, serial, _a, _b, _c: (word, decoder.names.cycle(serial))


def _answered(word: str) -> Maker:
    """Return a decoder for answers to technology functions, with the time of the output."""

    def make(
        decoder: EventDecoder, _serial: int, function: float, sequence: float, tick: float
    ) -> tuple[str, str]:
        letter, number = function_of(function)
        output_us = int(tick) * decoder.cycle_time_us
        return word, f"{letter} {number} {int(sequence)} {output_us}"

    return make


#: Kinds of events whose text needs no more than their row.
_MAKERS: dict[int, Maker] = {
    rows.EVENT_CREATED: EventDecoder._created,
    rows.EVENT_STARTED: _plain("started"),
    rows.EVENT_HELD: _plain("held"),
    rows.EVENT_CONTINUED: _plain("continued"),
    rows.EVENT_ABORTED: _plain("aborted"),
    rows.EVENT_ENDED: EventDecoder._ended,
    rows.EVENT_WRITTEN: EventDecoder._written,
    rows.EVENT_WRITTEN_TEXT: EventDecoder._written_text,
    rows.EVENT_TECHNOLOGY: EventDecoder._technology,
    rows.EVENT_MESSAGE: EventDecoder._message,
    rows.EVENT_ERROR: EventDecoder._error,
    rows.EVENT_PROGRAM_END: EventDecoder._program_end,
    rows.EVENT_NOTICE: EventDecoder._notice,
    rows.EVENT_FROZEN: EventDecoder._frozen,
    rows.EVENT_SPINDLE: EventDecoder._spindle,
    rows.EVENT_SPINDLE_REACHED: EventDecoder._spindle_reached,
    rows.EVENT_SPINDLE_POSITION: EventDecoder._spindle_position,
    rows.EVENT_USER_ERROR: EventDecoder._user_error,
    rows.EVENT_USER_VALUE: EventDecoder._user_value,
    rows.EVENT_USER_TEXT: EventDecoder._user_text,
    rows.EVENT_AXIS_BEGUN: EventDecoder._axis_begun,
    rows.EVENT_AXIS_ENDLESS: EventDecoder._axis_endless,
    rows.EVENT_AXIS_OSCILLATES: EventDecoder._axis_oscillates,
    rows.EVENT_AXIS_ENDED: EventDecoder._axis_ended,
    rows.EVENT_AXIS_CHANGED: EventDecoder._axis_changed,
    rows.EVENT_RETRACED: EventDecoder._retraced,
    rows.EVENT_PROBED: EventDecoder._probed,
    rows.EVENT_TOUCHED: EventDecoder._touched,
    rows.EVENT_FIXED_STOP: EventDecoder._fixed_stop,
    rows.EVENT_LOOP: EventDecoder._loop,
    rows.EVENT_BLOCK: EventDecoder._block,
    rows.EVENT_WAIT: EventDecoder._wait,
    rows.EVENT_STARVED: EventDecoder._starved,
    rows.EVENT_FED: EventDecoder._fed,
    rows.EVENT_OVERFLOW: EventDecoder._overflow,
    rows.EVENT_TIMER: EventDecoder._timer,
    rows.EVENT_ACKNOWLEDGED: _answered("acknowledged"),
    rows.EVENT_DROPPED: _answered("dropped"),
    rows.EVENT_SIGNAL_SENT: EventDecoder._signal_sent,
    rows.EVENT_SIGNAL_AWAITED: EventDecoder._signal_awaited,
    rows.EVENT_SIGNAL_TAKEN: EventDecoder._signal_taken,
    rows.EVENT_AXIS_EXCHANGED: EventDecoder._axis_exchanged,
    rows.EVENT_TOOL_LIFE: EventDecoder._tool_life,
}

#: Kinds whose subject is not the serial number of a cycle.
_WITHOUT_CYCLE = (
    rows.EVENT_MESSAGE,
    rows.EVENT_PROGRAM_END,
    rows.EVENT_TECHNOLOGY,
    rows.EVENT_BLOCK,
    rows.EVENT_WAIT,
    rows.EVENT_FED,
    rows.EVENT_OVERFLOW,
    rows.EVENT_RETRACED,
    rows.EVENT_LOOP,
    rows.EVENT_SIGNAL_SENT,
    rows.EVENT_SIGNAL_AWAITED,
    rows.EVENT_SIGNAL_TAKEN,
    rows.EVENT_AXIS_EXCHANGED,
    rows.EVENT_TOOL_LIFE,
)


def channels_of(mask: int) -> list[int]:
    """Return the channels of a mask (``kernel/tick/signals.py``); none for a broadcast."""
    return [channel for channel in range(1, codes.MAX_SIGNAL_CHANNEL + 1) if mask >> channel & 1]


def channels_text(mask: int) -> str:
    """Return the channels of a mask: ``CH2 CH3``, ``all`` for a broadcast."""
    return " ".join(f"CH{channel}" for channel in channels_of(mask)) or "all"


def _by(level: float) -> str:
    """Return who waits, where it is not the interpolator."""
    return "" if level else " decoder"


def _characters(number: int) -> str:
    """Return the characters of a part of a text, packed as a number to the base 256."""
    return decode(number.to_bytes(rows.TEXT_HALF, "big").lstrip(b"\0"))


def _line_text(span: Span | None) -> str:
    return f"line {0 if span is None else span.line}"


def _severity_word(number: int) -> str:
    severities = [one.severity for one in messages_of(number) if number in one.leading]
    return "warning" if severities and max(severities) < Severity.ERROR else "error"
