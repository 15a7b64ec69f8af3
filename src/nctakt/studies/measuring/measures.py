# SPDX-License-Identifier: MIT
"""Measures and expectations of a study: texts -> values and verdicts of a run.

The words are those of the expectations in NC comments (``nctakt.testing.expectations``)::

    time of M100                       the first one, in seconds; last M100: the last one
    time of (X > 200)                  the first tick that begins with it
    time from fired 17 to message "done"
    count of fired 17 line 5           how often
    max X, min PATH.SPEED              of the whole run
    X at end, X at 20 ms, X at M100    a value
    duration, ticks, state             of the run

    late < 20 ms                       a measure by its name, or any text above
    X < 50 within 100 ms               it becomes true; within 100 ms after M100
    M100 before M101                   the order of their first occurrences
    M100 once, X = 200.25 at 463ms     as in NC comments
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from pathlib import Path

from nctakt.base.dataclass import dataclass
from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.commands.studies import INVALID_MEASURE, INVALID_STUDY_EXPECTATION
from nctakt.studies.measuring.measure_nodes import (
    BOOLEAN,
    Condition,
    Event,
    Node,
    Order,
    Reaction,
    as_text,
    found_instead,
)
from nctakt.studies.measuring.measure_text import NotAMeasureError, Reader
from nctakt.studies.measuring.outcome import NotMeasuredError, Outcome
from nctakt.studies.measuring.python_measure import PythonMeasure
from nctakt.testing import expectations
from nctakt.testing.verdict import differences

#: Maximum number of actual values reported for a broken expectation.
MAX_FOUND = 3

#: The start of a line that reports them.
_FOUND = "    + "

#: A value of a measure; ``None``: it has none in this run.
MeasuredValue = float | str | None


@dataclass(frozen=True, slots=True)
class Measure:
    """A measure by its name: ``node`` computes it, ``text`` is what the user wrote."""

    name: str
    text: str
    node: Node

    def value(self, outcome: Outcome) -> MeasuredValue:
        """Return its value, ``None`` if it has none in this run."""
        try:
            return self.measured(outcome)
        except NotMeasuredError:
            return None

    def measured(self, outcome: Outcome) -> float | str:
        """Return its value; raises ``NotMeasuredError`` with the reason, if there is one."""
        try:
            value = self.node.value(outcome)
            if isinstance(value, Fraction):
                value = float(value)
        except ArithmeticError as error:
            raise NotMeasuredError(str(error)) from error
        if isinstance(value, float) and not math.isfinite(value):
            raise NotMeasuredError(f"the result is {value}")
        return value

    def check(self) -> None:
        """Raise ``Failure`` (901306) for a Python function that is not there."""
        if isinstance(self.node, PythonMeasure):
            problem = self.node.problem()
            if problem is not None:
                raise Failure(diagnostic(INVALID_MEASURE, text=self.text, reason=problem))


@dataclass(frozen=True, slots=True)
class Expectation:
    """A condition that each run of a study has to meet: a comparison, or one of NC comments."""

    text: str
    node: Node | None
    written: expectations.Expectation | None = None

    def is_met(self, outcome: Outcome) -> bool:
        """Return whether the run meets it; a measure without a value meets nothing."""
        if self.node is None:
            return not self._differences(outcome)
        try:
            return self.node.value(outcome) == BOOLEAN[True]
        except (NotMeasuredError, ArithmeticError):
            return False

    def broken(self, outcome: Outcome) -> str:
        """Return its text with the actual values in a run that does not meet it."""
        if self.node is not None:
            found = [as_text(value) for value in found_instead(self.node, outcome)]
        else:
            lines = "\n".join(self._differences(outcome)).splitlines()
            found = [line.removeprefix(_FOUND) for line in lines if line.startswith(_FOUND)]
        left = ["…"] if len(found) > MAX_FOUND else []
        return f"{self.text} ({', '.join([*found[:MAX_FOUND], *left])})"

    def _differences(self, outcome: Outcome) -> list[str]:
        """Return how a run differs from an expectation of NC comments, as texts."""
        assert self.written is not None
        wrong = differences(outcome.queries, [self.written], "")
        return [text for text in wrong if text.startswith(f":{self.written.line}: ")]

    @property
    def is_about_injection(self) -> bool:
        """Whether it is about the time after the injection of an each-tick study."""
        return self.reaction is not None and self.reaction.after is None

    @property
    def reaction(self) -> Reaction | None:
        """Its reaction, if it is of the form ``CONDITION within TIME``."""
        return self.node if isinstance(self.node, Reaction) else None

    @property
    def signals(self) -> Sequence[str]:
        """The names of the signals that it reads."""
        if self.node is not None:
            return tuple(self.node.signals())
        assert self.written is not None
        return (self.written.name,) if self.written.kind == "value" else ()


def read_measure(
    name: str,
    text: str,
    known: Mapping[str, Node],
    folder: Path = Path(),
    words: type[Reader] = Reader,
) -> Measure:
    """Return the measure of a text; ``known``: those that it may name, ``words``: its language.

    ``python FILE.py:FUNCTION`` calls a function with the run's queries (``NcRun``); the file is
    relative to ``folder``. Raises ``Failure`` (901306).
    """
    word, _, rest = text.strip().partition(" ")
    if word == "python":
        file, colon, function = rest.strip().rpartition(":")
        if not colon or not function.isidentifier():
            raise Failure(diagnostic(INVALID_MEASURE, text=text, reason="python FILE.py:FUNCTION"))
        return Measure(name, text, PythonMeasure(folder / file, function))
    try:
        return Measure(name, text, words(text, known).measure())
    except NotAMeasureError as error:
        raise Failure(diagnostic(INVALID_MEASURE, text=text, reason=error.reason)) from error


def function_measure(name: str, function: Callable[..., MeasuredValue]) -> Measure:
    """Return the measure that a Python function computes of the run's queries (``NcRun``)."""
    return Measure(name, function.__qualname__, PythonMeasure(Path(), "", function))


def read_expectation(
    text: str, known: Mapping[str, Node], words: type[Reader] = Reader
) -> Expectation:
    """Return the expectation of a text; raises ``Failure`` (901307).

    In the language of programs (``words``) it may be one of NC comments as well.
    """
    try:
        return Expectation(text, words(text, known).expectation())
    except NotAMeasureError as error:
        reason = error.reason
    try:
        if not words.is_of_program:
            raise Failure(diagnostic(INVALID_STUDY_EXPECTATION, text=text, reason=reason))
        return Expectation(text, None, expectations.read_expectation(text))
    except Failure as failure:
        message = diagnostic(INVALID_STUDY_EXPECTATION, text=text, reason=reason)
        raise Failure(message) from failure


__all__ = [
    "Condition", "Event", "Expectation", "Measure", "MeasuredValue", "Order", "Reaction",
    "as_text", "function_measure", "read_expectation", "read_measure",
]  # fmt: skip
