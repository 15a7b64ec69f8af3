# SPDX-License-Identifier: MIT
"""Expectations against a run: what is wrong, each with its place, line by line.

``-`` stands in front of what was expected, ``+`` in front of what has happened.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from nctakt.base.diagnostics import Diagnostic, Severity
from nctakt.lists.format.times import Time
from nctakt.testing.expectations import Expectation
from nctakt.testing.queries import NcRun, Occurrences
from nctakt.trace.events import number_text


def differences(run: NcRun, expectations: Sequence[Expectation], file: str) -> Iterator[str]:
    """One text for each expectation that is not met, and for each error that nobody expects."""
    for expectation in expectations:
        wrong = _wrong(run, expectation)
        if wrong:
            expected = f"- {_told(run, expectation)}"
            lines = (expected, *(f"+ {line}" for line in wrong))
            head = f"{file}:{expectation.line}: expect: {expectation.text}"
            yield "\n".join((head, *(f"    {line}" for line in lines)))
    numbers = [(one.number, one.about) for one in expectations if one.kind == "error"]
    for error in run.run.errors:
        line = None if error.span is None else error.span.line
        if (error.id, line) not in numbers and (error.id, None) not in numbers:
            yield f"{error.render()}\n    nobody expects this error"


def _wrong(run: NcRun, expectation: Expectation) -> list[str]:
    """What has happened instead; nothing where the expectation is met."""
    if expectation.kind == "value":
        return _wrong_value(run, expectation)
    if expectation.kind == "ended":
        state = run.run.state
        return [] if state == "ended" else [f"{state} after {Time(run.run.virtual_time_us)}"]
    if expectation.kind == "error":
        return _wrong_error(run.run.diagnostics, expectation)
    return _wrong_times(run, expectation)


def _wrong_value(run: NcRun, expectation: Expectation) -> list[str]:
    value = run.value_at(signal_of(run, expectation.name), _value_time(run, expectation))
    if abs(value - expectation.number) <= expectation.within:
        return []
    return [f"{expectation.name} = {number_text(value)}"]


def _value_time(run: NcRun, expectation: Expectation) -> float:
    if not expectation.at:
        return run.duration
    return expectation.at[0].us(run.run.cycle_time_us) / 1e6


def signal_of(run: NcRun, name: str) -> str:
    """The signal that a name means: an axis stands for its command position."""
    return f"{name}.ACS.ACT_POS" if run.has_axis(name) else name


def _wrong_error(diagnostics: Sequence[Diagnostic], expectation: Expectation) -> list[str]:
    severity = Severity.ERROR if expectation.name == "error" else Severity.WARNING
    alike = [one for one in diagnostics if one.severity is severity]
    found = [one for one in alike if one.id == expectation.number]
    if expectation.about is not None:
        found = [one for one in found if one.span and one.span.line == expectation.about]
    if expectation.count == 0:
        return [one.headline() for one in found]
    if found and expectation.count in (None, len(found)):
        return []
    places = [(one.span.line if one.span else "-", one) for one in alike]
    return [f"line {line}: {one.id} {one.text()}" for line, one in places] or ["none"]


def _wrong_times(run: NcRun, expectation: Expectation) -> list[str]:
    found = _occurrences(run, expectation)
    times_us = [round(one.at * 1e6) for one in found]
    length_us = run.run.cycle_time_us
    wanted = sorted(one.us(length_us) for one in expectation.at)
    if expectation.before is not None:
        times_us = [one for one in times_us if one < expectation.before.us(length_us)]
    if expectation.after is not None:
        times_us = [one for one in times_us if one > expectation.after.us(length_us)]
    count = len(times_us)
    if (count > 0 if expectation.count is None else count == expectation.count) and (
        not wanted or times_us == wanted
    ):
        return []
    return [str(one) for one in found] or [repr(found).strip("<>")]


def _occurrences(run: NcRun, expectation: Expectation) -> Occurrences:
    name, line = expectation.name, expectation.about
    if expectation.kind == "fired":
        return run.fired(cycle=name or None, line=line)
    if expectation.kind == "message":
        return run.message(name)
    return run.function(name, line=line)


def _told(run: NcRun, expectation: Expectation) -> str:
    """The expectation in the words in which what has happened is told."""
    length_us = run.run.cycle_time_us
    if expectation.kind == "value":
        at = Time(round(_value_time(run, expectation) * 1e6))
        return f"{expectation.name} = {number_text(expectation.number)} at {at}"
    words = {"function": expectation.name, "error": f"{expectation.number:.0f}"}
    said = words.get(expectation.kind, f"{expectation.kind} {expectation.name}".strip())
    parts = [said, *(_when(one, length_us) for one in expectation.at)]
    if expectation.before is not None:
        parts.append(f"before {Time(expectation.before.us(length_us))}")
    if expectation.after is not None:
        parts.append(f"after {Time(expectation.after.us(length_us))}")
    if expectation.count is not None:
        parts.append("never" if expectation.count == 0 else f"{expectation.count} times")
    if expectation.about is not None:
        parts.append(f"(line {expectation.about})")
    return " ".join(parts)


def _when(time: Time, length_us: int) -> str:
    time_us = time.us(length_us)
    return f"at {Time(time_us)}, tick {-(-time_us // length_us)}"
