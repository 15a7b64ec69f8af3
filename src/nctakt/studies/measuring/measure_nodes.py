# SPDX-License-Identifier: MIT
"""The parts of a measure: each computes its value from a run.

Times are whole microseconds of the run; as values they are exact fractions of seconds, and so are
results computed from them. Rounding to a binary number comes when a result is shown.
"""

from __future__ import annotations

import functools
import operator
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from types import MappingProxyType
from typing import Literal, Protocol

from nctakt.base.dataclass import dataclass
from nctakt.lists.format.times import Time
from nctakt.studies.measuring import courses
from nctakt.studies.measuring.outcome import NotMeasuredError, Outcome
from nctakt.testing.queries import FUNCTION_KINDS, NcRun

#: A value: a number from signals, a count, an exact number, a text.
Number = float | Fraction | str

#: Microseconds in a second.
_SECOND_US = 1_000_000

BOOLEAN = (0.0, 1.0)

COMPARISONS = MappingProxyType(
    {
        "<": operator.lt,
        "<=": operator.le,
        ">": operator.gt,
        ">=": operator.ge,
        "=": operator.eq,
        "==": operator.eq,
        "<>": operator.ne,
        "!=": operator.ne,
    }
)

#: By which values a condition is met: those below its limit, equal to it, above it, no numbers.
_MET_BY = MappingProxyType(
    {
        "<": (True, False, False, False),
        "<=": (True, True, False, False),
        ">": (False, False, True, False),
        ">=": (False, True, True, False),
        "=": (False, True, False, False),
        "==": (False, True, False, False),
        "<>": (True, False, True, True),
        "!=": (True, False, True, True),
    }
)

_ARITHMETIC: dict[str, Callable[[float | Fraction, float | Fraction], float | Fraction]] = {
    "+": operator.add,
    "-": operator.sub,
    "*": operator.mul,
    "/": operator.truediv,
}


@functools.lru_cache(maxsize=1024)  # the runs of a study measure the same times again and again
def seconds(time_us: int) -> Fraction:
    """Return a time as a value, in seconds."""
    return Fraction(time_us, _SECOND_US)


class Node(Protocol):
    """A part of a measure."""

    def value(self, outcome: Outcome) -> Number:
        """Return its value; raises ``NotMeasuredError`` if it has none in this run."""

    def signals(self) -> Iterator[str]:
        """Yield the signals that it reads."""


@dataclass(frozen=True, slots=True)
class Constant:
    """A number, a text, or a time in seconds."""

    constant: Number | Time

    def value(self, outcome: Outcome) -> Number:
        """Return it; a time in seconds."""
        if isinstance(self.constant, Time):
            return seconds(self.constant.us(outcome.cycle_time_us))
        return self.constant

    def signals(self) -> Iterator[str]:
        """Yield nothing."""
        yield from ()


@dataclass(frozen=True, slots=True)
class Property:
    """``duration``, ``ticks`` or ``state`` of the run."""

    name: Literal["duration", "ticks", "state"]

    def value(self, outcome: Outcome) -> Number:
        """Return it; the duration in seconds."""
        if self.name == "duration":
            return seconds(outcome.run.virtual_time_us)
        return outcome.run.ticks if self.name == "ticks" else outcome.run.state

    def signals(self) -> Iterator[str]:
        """Yield nothing."""
        yield from ()


@dataclass(frozen=True, slots=True)
class Condition:
    """A signal compared with a number: an event in the first tick that begins with it."""

    name: str
    word: str
    limit: float

    def first_tick(self, outcome: Outcome, begin: int) -> int | None:
        """Return the first tick from ``begin`` on in which it holds."""
        values, first_tick = outcome.course(self.name)
        begin = max(begin - first_tick, 0)
        found = courses.first(memoryview(values), begin, self.limit, *_MET_BY[self.word])
        return None if found < 0 else first_tick + found

    def times_us(self, outcome: Outcome) -> list[int]:
        """Return the times at which it becomes true; 0 if it is true from the begin on."""
        values, first_tick = outcome.course(self.name)
        found = courses.begins(memoryview(values), self.limit, *_MET_BY[self.word])
        return [(first_tick + tick) * outcome.run.cycle_time_us for tick in found]

    def signals(self) -> Iterator[str]:
        """Yield its signal."""
        yield self.name


@dataclass(frozen=True, slots=True)
class Event:
    """An event of NC comments: ``fired``, ``function``, ``message``, ``error``, ``ended``."""

    kind: str
    name: str = ""
    line: int | None = None

    def times_us(self, outcome: Outcome) -> list[int]:
        """Return the times of its occurrences."""
        if self.kind == "ended":
            return [outcome.run.virtual_time_us] if outcome.run.state == "ended" else []
        if self not in outcome.times_us:
            outcome.times_us[self] = self._found_us(outcome.queries)
        return outcome.times_us[self]

    def _found_us(self, queries: NcRun) -> list[int]:
        if self.kind == "fired":
            return queries.times_us(("fired",), "", line=self.line, cycle=self.name or None)
        if self.kind == "message":
            return queries.times_us(("message",), self.name)
        if self.kind == "function":
            return queries.times_us(FUNCTION_KINDS, self.name)
        return queries.times_us(("error", "user_error", "warning", "notice"), self.name)

    def count(self, outcome: Outcome) -> int:
        """Return how often it happened; an error of the decoder has no tick and counts as well."""
        if self.kind in ("error", "warning"):
            numbers = [one.id for one in outcome.run.diagnostics]
            return numbers.count(int(self.name))
        return len(self.times_us(outcome))

    def signals(self) -> Iterator[str]:
        """Yield nothing."""
        yield from ()


AnyEvent = Condition | Event


def _first(times_us: Sequence[int]) -> int:
    if not times_us:
        raise NotMeasuredError
    return times_us[0]


@dataclass(frozen=True, slots=True)
class TimeOf:
    """The time of the first or last occurrence of an event, in seconds."""

    event: AnyEvent
    is_last: bool = False

    def value(self, outcome: Outcome) -> Number:
        """Return the time; raises ``NotMeasuredError`` if it did not happen."""
        times_us = self.event.times_us(outcome)
        return seconds(_first(times_us[-1:] if self.is_last else times_us))

    def signals(self) -> Iterator[str]:
        """Yield those of the event."""
        return self.event.signals()


@dataclass(frozen=True, slots=True)
class TimeBetween:
    """The time from the first occurrence of an event to the next of another, in seconds."""

    first: AnyEvent
    second: AnyEvent

    def value(self, outcome: Outcome) -> Number:
        """Return the time; raises ``NotMeasuredError`` if one of them did not happen."""
        begin_us = _first(self.first.times_us(outcome))
        end_us = _first([time for time in self.second.times_us(outcome) if time >= begin_us])
        return seconds(end_us - begin_us)

    def signals(self) -> Iterator[str]:
        """Yield those of both events."""
        yield from self.first.signals()
        yield from self.second.signals()


@dataclass(frozen=True, slots=True)
class CountOf:
    """The number of occurrences of an event."""

    event: AnyEvent

    def value(self, outcome: Outcome) -> Number:
        """Return the number."""
        if isinstance(self.event, Event):
            return self.event.count(outcome)
        return len(self.event.times_us(outcome))

    def signals(self) -> Iterator[str]:
        """Yield those of the event."""
        return self.event.signals()


@dataclass(frozen=True, slots=True)
class Extreme:
    """The largest or smallest value of a signal."""

    name: str
    is_max: bool

    def value(self, outcome: Outcome) -> Number:
        """Return the value."""
        values = outcome.values(self.name)
        return max(values) if self.is_max else min(values)

    def signals(self) -> Iterator[str]:
        """Yield its signal."""
        yield self.name


@dataclass(frozen=True, slots=True)
class ValueAt:
    """The value of a signal at the end, at a time, at the first occurrence of an event."""

    name: str
    at: Time | AnyEvent | None

    def value(self, outcome: Outcome) -> Number:
        """Return the value; raises ``NotMeasuredError`` if the event did not happen."""
        if self.at is None:
            return outcome.values(self.name)[-1]
        if isinstance(self.at, Time):
            return outcome.value_at(self.name, self.at.us(outcome.cycle_time_us))
        return outcome.value_at(self.name, _first(self.at.times_us(outcome)))

    def signals(self) -> Iterator[str]:
        """Yield its signal and those of the event."""
        yield self.name
        if isinstance(self.at, Condition | Event):
            yield from self.at.signals()


@dataclass(frozen=True, slots=True)
class Binary:
    """Two values and ``+``, ``-``, ``*``, ``/`` or a comparison between them."""

    word: str
    left: Node
    right: Node

    def value(self, outcome: Outcome) -> Number:
        """Return the result; 1 or 0 of a comparison."""
        left, right = self.left.value(outcome), self.right.value(outcome)
        if self.word in COMPARISONS:
            return BOOLEAN[_compare(self.word, left, right)]
        if isinstance(left, str) or isinstance(right, str):
            raise NotMeasuredError
        return _ARITHMETIC[self.word](*_alike(left, right))

    def signals(self) -> Iterator[str]:
        """Yield those of both values."""
        yield from self.left.signals()
        yield from self.right.signals()


def _compare(word: str, left: Number, right: Number) -> bool:
    """Return the result; texts are only equal or not."""
    if isinstance(left, str) and isinstance(right, str):
        return bool(COMPARISONS[word](left, right))
    if isinstance(left, str) or isinstance(right, str):
        raise NotMeasuredError
    return bool(COMPARISONS[word](*_alike(left, right)))


def _alike(
    left: float | Fraction, right: float | Fraction
) -> tuple[float, float] | tuple[Fraction, Fraction]:
    """Return two numbers in comparable form: exact, or binary if one of them is binary.

    A text such as 0.02 means that number, and compared with a signal the nearest binary number.
    """
    if isinstance(left, float) or isinstance(right, float):
        return float(left), float(right)
    return _exact(left), _exact(right)


def _exact(value: float | Fraction) -> Fraction:
    """Return a whole number or a fraction as a fraction."""
    return value if isinstance(value, Fraction) else Fraction(value)


@dataclass(frozen=True, slots=True)
class Order:
    """Whether the first occurrence of an event comes before that of another."""

    first: AnyEvent
    second: AnyEvent

    def value(self, outcome: Outcome) -> Number:
        """Return 1 or 0; raises ``NotMeasuredError`` if the first one did not happen."""
        first_us, second_us = _first(self.first.times_us(outcome)), self.second.times_us(outcome)
        return BOOLEAN[not second_us or first_us < second_us[0]]

    def signals(self) -> Iterator[str]:
        """Yield those of both events."""
        yield from self.first.signals()
        yield from self.second.signals()


@dataclass(frozen=True, slots=True)
class Reaction:
    """A condition that has to become true within a time after an event.

    ``after`` ``None``: after the injection of an each-tick study, else after the start of the run.
    """

    condition: Condition
    limit: Time
    after: AnyEvent | None

    def begin_us(self, outcome: Outcome) -> int:
        """Return the time from which on it counts; raises ``NotMeasuredError``."""
        if self.after is not None:
            return _first(self.after.times_us(outcome))
        return outcome.injected_us or 0

    def reaction_us(self, outcome: Outcome) -> int:
        """Return the time until the condition holds; raises ``NotMeasuredError``."""
        begin_us, length_us = self.begin_us(outcome), outcome.cycle_time_us
        tick = self.condition.first_tick(outcome, -(-begin_us // length_us))
        if tick is None:
            raise NotMeasuredError
        return tick * length_us - begin_us

    def value(self, outcome: Outcome) -> Number:
        """Return 1 or 0; raises ``NotMeasuredError`` if the condition does not become true."""
        return BOOLEAN[self.reaction_us(outcome) <= self.limit.us(outcome.cycle_time_us)]

    def signals(self) -> Iterator[str]:
        """Yield those of the condition and the event."""
        yield from self.condition.signals()
        if self.after is not None:
            yield from self.after.signals()


def reaction_time(reaction: Reaction, outcome: Outcome) -> float | None:
    """Return the time that a reaction took, in seconds; ``None`` if it did not come."""
    try:
        return float(seconds(reaction.reaction_us(outcome)))
    except NotMeasuredError:
        return None


def found_instead(node: Node, outcome: Outcome) -> list[Number | None]:
    """Return the values that an expectation compares, without literals; ``None``: no value."""
    if isinstance(node, Reaction):
        return [reaction_time(node, outcome)]
    parts: list[Node] = [node]
    if isinstance(node, Binary):
        parts = [one for one in (node.left, node.right) if not isinstance(one, Constant)]
    elif isinstance(node, Order):
        parts = [TimeOf(node.first), TimeOf(node.second)]
    return [_value_of(one, outcome) for one in parts]


def _value_of(node: Node, outcome: Outcome) -> Number | None:
    try:
        return node.value(outcome)
    except (NotMeasuredError, ArithmeticError):
        return None


def as_text(value: Number | None) -> str:
    """Return a value as results show it."""
    if value is None:
        return "–"
    return value if isinstance(value, str) else f"{float(value):.9g}"
