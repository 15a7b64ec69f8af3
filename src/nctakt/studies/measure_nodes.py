# SPDX-License-Identifier: MIT
"""The parts of a measure: each computes its value from a run."""

from __future__ import annotations

import operator
from collections.abc import Callable, Iterator, Sequence
from types import MappingProxyType
from typing import Literal, Protocol

from nctakt.base.dataclass import dataclass
from nctakt.lists.format.times import Time
from nctakt.studies.outcome import NotMeasuredError, Outcome

Number = float | str

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

_ARITHMETIC: dict[str, Callable[[float, float], float]] = {
    "+": operator.add,
    "-": operator.sub,
    "*": operator.mul,
    "/": operator.truediv,
}


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
            return self.constant.us(outcome.cycle_time_us) / 1e6
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
            return outcome.duration
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

    def holds(self, value: float) -> bool:
        """Return whether it holds for a value of the signal."""
        return bool(COMPARISONS[self.word](value, self.limit))

    def times(self, outcome: Outcome) -> list[float]:
        """Return the times at which it becomes true; 0 if it is true from the begin on."""
        was_true = False
        times = []
        for tick, value in enumerate(outcome.values(self.name)):
            is_true = self.holds(value)
            if is_true and not was_true:
                times.append(tick * outcome.run.cycle_time_us / 1e6)
            was_true = is_true
        return times

    def signals(self) -> Iterator[str]:
        """Yield its signal."""
        yield self.name


@dataclass(frozen=True, slots=True)
class Event:
    """An event of NC comments: ``fired``, ``function``, ``message``, ``error``, ``ended``."""

    kind: str
    name: str = ""
    line: int | None = None

    def times(self, outcome: Outcome) -> list[float]:
        """Return the times of its occurrences in seconds."""
        queries = outcome.queries
        if self.kind == "ended":
            return [outcome.duration] if outcome.run.state == "ended" else []
        if self.kind == "fired":
            return queries.find("", ("fired",), "", line=self.line, cycle=self.name or None).times
        if self.kind == "message":
            return queries.message(self.name).times
        if self.kind == "function":
            return queries.function(self.name).times
        return queries.find("", ("error", "user_error", "warning", "notice"), self.name).times

    def count(self, outcome: Outcome) -> int:
        """Return how often it happened; an error of the decoder has no tick and counts as well."""
        if self.kind in ("error", "warning"):
            numbers = [one.id for one in outcome.run.diagnostics]
            return numbers.count(int(self.name))
        return len(self.times(outcome))

    def signals(self) -> Iterator[str]:
        """Yield nothing."""
        yield from ()


AnyEvent = Condition | Event


def _first(times: Sequence[float]) -> float:
    if not times:
        raise NotMeasuredError
    return times[0]


@dataclass(frozen=True, slots=True)
class TimeOf:
    """The time of the first or last occurrence of an event, in seconds."""

    event: AnyEvent
    is_last: bool = False

    def value(self, outcome: Outcome) -> Number:
        """Return the time; raises ``NotMeasuredError`` if it did not happen."""
        times = self.event.times(outcome)
        return _first(times[-1:] if self.is_last else times)

    def signals(self) -> Iterator[str]:
        """Yield those of the event."""
        return self.event.signals()


@dataclass(frozen=True, slots=True)
class TimeBetween:
    """The time from the first occurrence of an event to the next one of another, in seconds."""

    first: AnyEvent
    second: AnyEvent

    def value(self, outcome: Outcome) -> Number:
        """Return the time; raises ``NotMeasuredError`` if one of them did not happen."""
        begin = _first(self.first.times(outcome))
        return _first([time for time in self.second.times(outcome) if time >= begin]) - begin

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
        return len(self.event.times(outcome))

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
    at: Node | AnyEvent | None

    def value(self, outcome: Outcome) -> Number:
        """Return the value; raises ``NotMeasuredError`` if the event did not happen."""
        if self.at is None:
            return outcome.values(self.name)[-1]
        if isinstance(self.at, Condition | Event):
            return outcome.value_at(self.name, _first(self.at.times(outcome)))
        return outcome.value_at(self.name, float(self.at.value(outcome)))

    def signals(self) -> Iterator[str]:
        """Yield its signal and those of the event."""
        yield self.name
        if self.at is not None:
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
        return _ARITHMETIC[self.word](left, right)

    def signals(self) -> Iterator[str]:
        """Yield those of both values."""
        yield from self.left.signals()
        yield from self.right.signals()


def _compare(word: str, left: Number, right: Number) -> bool:
    """Return the result; texts are only equal or not."""
    if isinstance(left, str) != isinstance(right, str):
        raise NotMeasuredError
    return bool(COMPARISONS[word](left, right))


@dataclass(frozen=True, slots=True)
class Order:
    """Whether the first occurrence of an event comes before that of another."""

    first: AnyEvent
    second: AnyEvent

    def value(self, outcome: Outcome) -> Number:
        """Return 1 or 0; raises ``NotMeasuredError`` if the first one did not happen."""
        first, second = _first(self.first.times(outcome)), self.second.times(outcome)
        return BOOLEAN[not second or first < second[0]]

    def signals(self) -> Iterator[str]:
        """Yield those of both events."""
        yield from self.first.signals()
        yield from self.second.signals()


@dataclass(frozen=True, slots=True)
class Reaction:
    """A condition that has to become true within a time after an event.

    ``after`` ``None``: after the injection of an each-tick study, else after the begin of the run.
    """

    condition: Condition
    limit: Time
    after: AnyEvent | None

    def begin(self, outcome: Outcome) -> float:
        """Return the time from which on it counts; raises ``NotMeasuredError``."""
        if self.after is not None:
            return _first(self.after.times(outcome))
        return outcome.injected or 0.0

    def reaction_time(self, outcome: Outcome) -> float:
        """Return the time until the condition holds, in seconds; raises ``NotMeasuredError``."""
        begin = self.begin(outcome)
        values = outcome.values(self.condition.name)
        first = -(-round(begin * 1e6) // outcome.run.cycle_time_us)
        for tick in range(first, len(values)):
            if self.condition.holds(values[tick]):
                return round(tick * outcome.run.cycle_time_us - begin * 1e6) / 1e6
        raise NotMeasuredError

    def value(self, outcome: Outcome) -> Number:
        """Return 1 or 0; raises ``NotMeasuredError`` if the condition does not become true."""
        limit = self.limit.us(outcome.run.cycle_time_us) / 1e6
        return BOOLEAN[self.reaction_time(outcome) <= limit]

    def signals(self) -> Iterator[str]:
        """Yield those of the condition and the event."""
        yield from self.condition.signals()
        if self.after is not None:
            yield from self.after.signals()


def reaction_time(reaction: Reaction, outcome: Outcome) -> float | None:
    """Return the time that a reaction took, in seconds; ``None`` if it did not come."""
    try:
        return reaction.reaction_time(outcome)
    except NotMeasuredError:
        return None


def as_text(value: Number | None) -> str:
    """Return a value as results show it."""
    if value is None:
        return "–"
    return value if isinstance(value, str) else f"{value:.9g}"
