# SPDX-License-Identifier: MIT
"""What happened in a tick: the realtime part's event rows -> ``Event`` objects with text.

In: rows of ``EVENT_WIDTH`` float64 (``kernel/base/record.py``) and ``EventNames``, which knows what
the numbers stand for. Out: events in the order of their occurrence. A chunk of rows is decoded when
it is looked at, not before: a run that nobody asks for its events pays nothing for them.
"""

from __future__ import annotations

import struct
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Protocol, overload

from nctakt.base.diagnostics import Severity, Span
from nctakt.kernel.base import record
from nctakt.messages.catalogue import catalogue
from nctakt.nc.check.user_errors import KEYWORDS

_ROW = struct.Struct(f"={record.EVENT_WIDTH}d")

_SCOPES = ("BLOCK", "PROG", "GLOBAL")
#: Why the channel is emptied, by number.
_WAITS = ("flush", "read", "positions", "write")
_ENDED_BY = {
    record.ENDED_BY_SCOPE: "scope",
    record.ENDED_BY_DELETE: "delete",
    record.ENDED_BY_RESET: "reset",
    record.ENDED_BY_ERROR: "error",
}
_LOOPS = {
    record.LOOP_BEGUN: "begun",
    record.LOOP_SKIPPED: "skipped",
    record.LOOP_LEFT: "left",
}
_RETRACED = {
    record.RETRACE_BACKWARD: "backward",
    record.RETRACE_FORWARD: "forward",
    record.RETRACE_START: "start",
    record.RETRACE_FRONT: "front",
}
_MOTION_ENDED = {
    record.MOTION_DONE: "done",
    record.MOTION_ABORTED: "aborted",
    record.MOTION_FAILED: "failed",
}
_MOTION_CHANGED = {
    record.MOTION_HELD: "held",
    record.MOTION_CONTINUED: "continued",
    record.MOTION_STOPPED: "stopped",
}


@dataclass(frozen=True, slots=True)
class Event:
    """One thing that happened in tick ``tick``, which begins at ``time_us``.

    ``kind`` is a word, ``text`` its particulars (``fired``, ``17 line 5``). ``span`` is the
    place in a program that it comes from. ``cycle`` is the realtime cycle it comes from: its
    programmed ID, or ``#1`` for the first cycle without ID; empty for the path, the decoder and the
    manager. ``channel`` is the number of its channel where the machine has more than one, else 0;
    cycles are called ``2:17`` there.
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
        """What tells the channel in front of an event's text, ``CH2``, where there are several."""
        return f"CH{self.channel} " if self.channel else ""


class EventNames(Protocol):
    """What the numbers in event rows stand for; stays valid for as long as events are looked at."""

    def cycle(self, serial: int) -> str:
        """The programmed ID of the cycle with this serial number, or ``#1`` without one."""

    def variable(self, cell: int) -> str:
        """The name of the variable in a memory cell."""

    def axis(self, index: int) -> str:
        """The name of an axis."""

    def message(self, number: int) -> str:
        """The text of the message with this number."""

    def variable_text(self, number: int) -> str:
        """The text of a variable whose value was frozen."""

    def spindle(self, number: int) -> str:
        """The name of a spindle of the channel."""

    def user_text(self, number: int) -> str:
        """A text that is told with a user error."""

    def program(self, number: int) -> str:
        """The file name of a program."""

    def thread(self, number: int) -> str:
        """The name of a thread of the schedule."""

    def place(self, source: int) -> Span | None:
        """The place of a source number."""


def number_text(value: float) -> str:
    """A number as short as it can be written without loss; whole numbers without ``.0``."""
    return repr(value + 0.0).removesuffix(".0")


class EventDecoder:
    """Turns event rows into events; ``cycle_time_us`` is the length of a tick."""

    def __init__(self, cycle_time_us: int, names: EventNames) -> None:
        self._cycle_time_us = cycle_time_us
        self._names = names
        self._places: dict[int, Span | None] = {}
        self._makers: dict[int, Callable[[int, int, float, float], tuple[str, str]]] = {
            record.CREATED: self._created,
            record.STARTED: self._plain("started"),
            record.HELD: self._plain("held"),
            record.CONTINUED: self._plain("continued"),
            record.ABORTED: self._plain("aborted"),
            record.ENDED: self._ended,
            record.WRITTEN: self._written,
            record.TECHNOLOGY: self._technology,
            record.MESSAGE: self._message,
            record.ERROR: self._error,
            record.PROGRAM_END: self._program_end,
            record.NOTICE: self._notice,
            record.FROZEN: self._frozen,
            record.SPINDLE: self._spindle,
            record.SPINDLE_REACHED: self._spindle_reached,
            record.SPINDLE_POSITION: self._spindle_position,
            record.USER_ERROR: self._user_error,
            record.USER_VALUE: self._user_value,
            record.USER_TEXT: self._user_text,
            record.AXIS_BEGUN: self._axis_begun,
            record.AXIS_ENDED: self._axis_ended,
            record.AXIS_CHANGED: self._axis_changed,
            record.RETRACED: self._retraced,
            record.PROBED: self._probed,
            record.FIXED_STOP: self._fixed_stop,
            record.LOOP: self._loop,
            record.BLOCK: self._block,
            record.WAIT: self._wait,
            record.STARVED: self._starved,
            record.FED: self._fed,
            record.OVERFLOW: self._overflow,
        }

    def decode(self, data: bytes | memoryview) -> list[Event]:
        """The events of rows that ``Record.take_events`` gave."""
        return [self._event(*row) for row in _ROW.iter_unpack(data)]

    def _event(
        self, tick: float, code: float, source: float, subject: float, a: float, b: float
    ) -> Event:
        channel, kind = divmod(int(code), record.CHANNEL_CODE_WIDTH)
        number, serial = int(tick), int(subject)
        time_us = number * self._cycle_time_us
        span = self._place(int(source))
        if kind == record.FIRED:
            word, text = self._fired(serial, span)
        elif kind == record.PAUSED:
            word, text = "paused", _line_text(span)
        elif kind == record.TECHNOLOGY_RT:
            word, text = self._technology_rt(a, b, time_us)
        else:
            word, text = self._makers[kind](kind, serial, a, b)
        cycle = self._names.cycle(serial) if serial and kind not in _WITHOUT_CYCLE else ""
        return Event(number, time_us, word, text, span, cycle, channel)

    def _place(self, source: int) -> Span | None:
        """Few places make many events: each is looked up once."""
        if source not in self._places:
            self._places[source] = self._names.place(source)
        return self._places[source]

    def _plain(self, word: str) -> Callable[[int, int, float, float], tuple[str, str]]:
        return lambda _kind, serial, _a, _b: (word, self._names.cycle(serial))

    def _created(self, _kind: int, serial: int, scope: float, _b: float) -> tuple[str, str]:
        return "created", f"{self._names.cycle(serial)} {_SCOPES[int(scope)]}"

    def _ended(self, _kind: int, serial: int, reason: float, _b: float) -> tuple[str, str]:
        return "ended", f"{self._names.cycle(serial)} {_ENDED_BY[int(reason)]}"

    def _fired(self, serial: int, span: Span | None) -> tuple[str, str]:
        return "fired", f"{self._names.cycle(serial)} {_line_text(span)}"

    def _written(self, _kind: int, _serial: int, cell: float, value: float) -> tuple[str, str]:
        return "written", f"{self._names.variable(int(cell))} {number_text(value)}"

    def _technology_rt(self, number: float, sequence: float, time_us: int) -> tuple[str, str]:
        letter, value = _function(number)
        return letter, f"{value} {int(sequence)} {time_us}"

    def _technology(
        self, _kind: int, has_value: int, function: float, value: float
    ) -> tuple[str, str]:
        letter, number = _function(function)
        return "output", f"{letter} {number}" + (f" = {int(value)}" if has_value else "")

    def _message(self, _kind: int, number: int, _a: float, _b: float) -> tuple[str, str]:
        return "message", self._names.message(number)

    def _error(self, _kind: int, _serial: int, number: float, _b: float) -> tuple[str, str]:
        return _severity_word(int(number)), str(int(number))

    def _notice(self, _kind: int, _serial: int, number: float, _b: float) -> tuple[str, str]:
        return "notice", str(int(number))

    def _axis_begun(self, _kind: int, _serial: int, axis: float, target: float) -> tuple[str, str]:
        if axis < 0:
            direction = "positive" if target > 0 else "negative"
            return "axis", f"{self._names.axis(-1 - int(axis))} begun {direction}"
        return "axis", f"{self._names.axis(int(axis))} begun {number_text(target)}"

    def _axis_ended(self, _kind: int, _serial: int, axis: float, how: float) -> tuple[str, str]:
        return "axis", f"{self._names.axis(int(axis))} {_MOTION_ENDED[int(how)]}"

    def _axis_changed(self, _kind: int, _serial: int, axis: float, what: float) -> tuple[str, str]:
        return "axis", f"{self._names.axis(int(axis))} {_MOTION_CHANGED[int(what)]}"

    def _frozen(self, _kind: int, _serial: int, number: float, value: float) -> tuple[str, str]:
        return "frozen", f"{self._names.variable_text(int(number))} {number_text(value)}"

    def _spindle(self, _kind: int, _serial: int, job: float, rpm: float) -> tuple[str, str]:
        spindle, function = divmod(int(job), 100)
        return "spindle", f"{self._names.spindle(spindle)} M{function} {number_text(rpm)}"

    def _spindle_reached(
        self, _kind: int, _serial: int, number: float, _b: float
    ) -> tuple[str, str]:
        return "spindle_reached", self._names.spindle(int(number))

    def _spindle_position(
        self, _kind: int, _serial: int, number: float, position: float
    ) -> tuple[str, str]:
        return "spindle_position", f"{self._names.spindle(int(number))} {number_text(position)}"

    def _user_error(self, _kind: int, _serial: int, number: float, rc: float) -> tuple[str, str]:
        return "user_error", f"{int(number)} {int(rc)}"

    def _user_value(self, _kind: int, _serial: int, code: float, value: float) -> tuple[str, str]:
        return "user_value", f"{KEYWORDS[int(code)]} {number_text(value)}"

    def _user_text(self, _kind: int, _serial: int, code: float, text: float) -> tuple[str, str]:
        return "user_value", f"{KEYWORDS[int(code)]} {self._names.user_text(int(text))}"

    def _block(self, _kind: int, number: int, decoded: float, _b: float) -> tuple[str, str]:
        return "block", f"{number} decoded {int(decoded)}"

    def _retraced(self, _kind: int, how: int, _a: float, _b: float) -> tuple[str, str]:
        return "retrace", _RETRACED[how]

    def _fixed_stop(
        self, _kind: int, _serial: int, axis: float, position: float
    ) -> tuple[str, str]:
        return "fixed_stop", f"{self._names.axis(int(axis))} {number_text(position)}"

    def _probed(self, _kind: int, _serial: int, delta: float, _b: float) -> tuple[str, str]:
        return "probe", number_text(delta)

    def _loop(self, _kind: int, how: int, _a: float, _b: float) -> tuple[str, str]:
        return "loop", _LOOPS[how]

    def _wait(self, _kind: int, reason: int, cell: float, _b: float) -> tuple[str, str]:
        word = _WAITS[reason]
        return "waits", f"{word} {self._names.variable(int(cell))}" if cell else word

    def _starved(self, _kind: int, _serial: int, _a: float, _b: float) -> tuple[str, str]:
        return "starved", "begun"

    def _fed(self, _kind: int, ticks: int, _a: float, _b: float) -> tuple[str, str]:
        return "starved", f"ended {ticks}"

    def _overflow(self, _kind: int, number: int, _a: float, _b: float) -> tuple[str, str]:
        return "overflow", self._names.thread(number)

    def _program_end(self, _kind: int, number: int, _a: float, _b: float) -> tuple[str, str]:
        return "end", self._names.program(number)


#: Kinds whose subject is not the serial number of a cycle.
_WITHOUT_CYCLE = (
    record.MESSAGE,
    record.PROGRAM_END,
    record.TECHNOLOGY,
    record.BLOCK,
    record.WAIT,
    record.FED,
    record.OVERFLOW,
    record.RETRACED,
    record.LOOP,
)


def _function(code: float) -> tuple[str, int]:
    """Letter and number of a technology function; H functions are coded -number - 1."""
    number = int(code)
    return ("H", -number - 1) if number < 0 else ("M", number)


def _line_text(span: Span | None) -> str:
    return f"line {0 if span is None else span.line}"


def _severity_word(number: int) -> str:
    message = catalogue().get(number)
    is_warning = message is not None and message.severity is not Severity.ERROR
    return "warning" if is_warning else "error"


class EventChunk(Sequence[Event]):
    """Events of some consecutive ticks, decoded when they are first looked at."""

    def __init__(self, decoder: EventDecoder, data: bytes) -> None:
        self._decoder = decoder
        self._data = data
        self._events: list[Event] | None = None

    def __len__(self) -> int:
        return len(self._data) // _ROW.size

    def __iter__(self) -> Iterator[Event]:
        return iter(self._decoded())

    @overload
    def __getitem__(self, index: int) -> Event: ...

    @overload
    def __getitem__(self, index: slice) -> Sequence[Event]: ...

    def __getitem__(self, index: int | slice) -> Event | Sequence[Event]:
        return self._decoded()[index]

    def subjects(self) -> Iterator[int]:
        """The number that each event is about: of a cycle, a message or a program."""
        return (int(row[3]) for row in _ROW.iter_unpack(self._data))

    def _decoded(self) -> list[Event]:
        if self._events is None:
            self._events = self._decoder.decode(self._data)
        return self._events
