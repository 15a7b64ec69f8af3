# SPDX-License-Identifier: MIT
"""The differences between the expectations and a run, each with its position, line by line.

``-`` marks the expected result, ``+`` the actual one.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from nctakt.base.diagnostics import NOTHING, Diagnostic, Severity, Text
from nctakt.base.failure import Failure
from nctakt.base.misspelling import nearest_item
from nctakt.lists.format.times import Time
from nctakt.messages import diagnostic
from nctakt.messages.commands.command_line import RUN_NOT_ENDED
from nctakt.messages.commands.inputs import UNKNOWN_ITEM
from nctakt.results.trace.events import number_text
from nctakt.testing.expectations import Expectation
from nctakt.testing.language import language_of_tests, rendered
from nctakt.testing.queries import NcRun, Occurrences

_UNEXPECTED = Text("unexpected error", "unerwarteter Fehler")


def differences(
    run: NcRun,
    expectations: Sequence[Expectation],
    file: str,
    *,
    is_limited: bool = True,
    folder: Path = Path(),
) -> Iterator[str]:
    """Yield a text for each unmet expectation and for each unexpected error.

    One more if the run reached its limit (901016) and none was given (``is_limited``); ``folder``:
    where the logs are that they name.
    """
    for expectation in expectations:
        head = f"{file}:{expectation.line}: expect: {expectation.text}"
        try:
            wrong = _wrong(run, expectation, folder)
        except Failure as failure:
            yield rendered(expectation.placed(failure))
            continue
        if wrong:
            expected = f"- {_in_words_of_events(run, expectation)}"
            lines = (expected, *(f"+ {line}" for line in wrong))
            yield "\n".join((head, *(f"    {line}" for line in lines)))
    numbers = [(error.number, error.about) for error in expectations if error.kind == "error"]
    if run.run.state == "limit" and not is_limited:
        message = diagnostic(RUN_NOT_ENDED, time=str(Time(run.run.virtual_time_us)))
        yield f"{file}: {message.render(language_of_tests())}"
    for error in run.run.errors:
        line = None if error.span is None else error.span.line
        named = {(number, at) for number in (error.id, *error.also) for at in (line, None)}
        if named.isdisjoint(numbers):
            language = language_of_tests()
            yield f"{error.render(language)}\n    {_UNEXPECTED.get(language)}"


def _wrong(run: NcRun, expectation: Expectation, folder: Path) -> list[str]:
    """Return the actual result; empty if the expectation is met."""
    if expectation.kind == "log":
        # comparing takes numpy and more, and most tests have no log
        from nctakt.testing.log_expectations import wrong_beside_log  # noqa: PLC0415

        return wrong_beside_log(run, signal_of(run, expectation.name), expectation, folder)
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
    if abs(value - _expected_number(run, expectation)) <= expectation.within:
        return []
    shown = run.labels(expectation.name).get(int(value), number_text(value))
    return [f"{expectation.name} = {shown}"]


def _expected_number(run: NcRun, expectation: Expectation) -> float:
    """Return the expected number, for an item of an enumeration that of the item.

    Raises ``Failure`` (902631) for an item that the signal's type does not have.
    """
    name, item = expectation.name, expectation.item.lower()
    if not item:
        return expectation.number
    labels = run.labels(name)
    for number, label in labels.items():
        if item in (label.lower(), label.lower().rpartition(".")[2]):
            return number
    known = ", ".join(labels.values()) or NOTHING
    near = nearest_item(expectation.item, labels.values()) or NOTHING
    raise Failure(
        diagnostic(UNKNOWN_ITEM, name=name, item=expectation.item, known=known, nearest=near)
    )


def _value_time(run: NcRun, expectation: Expectation) -> Time:
    if not expectation.at:
        return Time(run.run.virtual_time_us)
    return Time(expectation.at[0].us(run.run.cycle_time_us))


def signal_of(run: NcRun, name: str) -> str:
    """Return the signal of a name: an axis means its command position."""
    return f"{name}.ACS.ACT_POS" if run.has_axis(name) else name


def _wrong_error(diagnostics: Sequence[Diagnostic], expectation: Expectation) -> list[str]:
    severity = Severity.ERROR if expectation.name == "error" else Severity.WARNING
    alike = [diagnostic for diagnostic in diagnostics if diagnostic.severity is severity]
    matching = [
        diagnostic
        for diagnostic in alike
        if expectation.number in (diagnostic.id, *diagnostic.also)
    ]
    if expectation.about is not None:
        matching = [
            diagnostic
            for diagnostic in matching
            if diagnostic.span and diagnostic.span.line == expectation.about
        ]
    if expectation.count == 0:
        return [diagnostic.headline() for diagnostic in matching]
    if matching and expectation.count in (None, len(matching)):
        return []
    lines = [(diagnostic.span.line if diagnostic.span else "-", diagnostic) for diagnostic in alike]
    language = language_of_tests()
    return [f"line {line}: {found.id} {found.text(language)}" for line, found in lines] or ["none"]


def _wrong_times(run: NcRun, expectation: Expectation) -> list[str]:
    occurrences = _occurrences(run, expectation)
    times_us = [one.at_us for one in occurrences]
    length_us = run.run.cycle_time_us
    expected_us = sorted(time.us(length_us) for time in expectation.at)
    if expectation.before is not None:
        times_us = [time for time in times_us if time < expectation.before.us(length_us)]
    if expectation.after is not None:
        times_us = [time for time in times_us if time > expectation.after.us(length_us)]
    count = len(times_us)
    if (count > 0 if expectation.count is None else count == expectation.count) and (
        not expected_us or times_us == expected_us
    ):
        return []
    return [str(time) for time in occurrences] or [repr(occurrences).strip("<>")]


def _occurrences(run: NcRun, expectation: Expectation) -> Occurrences:
    name, line = expectation.name, expectation.about
    if expectation.kind == "fired":
        return run.fired(cycle=name or None, line=line)
    if expectation.kind == "message":
        return run.message(name)
    return run.function(name, line=line)


def _in_words_of_events(run: NcRun, expectation: Expectation) -> str:
    """Return the expectation in the words in which events are shown."""
    length_us = run.run.cycle_time_us
    if expectation.kind == "value":
        at = _value_time(run, expectation)
        return f"{expectation.name} = {expectation.item or number_text(expectation.number)} at {at}"
    if expectation.kind == "log":
        return expectation.text
    words = {"function": expectation.name, "error": f"{expectation.number:.0f}"}
    subject = words.get(expectation.kind, f"{expectation.kind} {expectation.name}".strip())
    parts = [subject, *(_when(time, length_us) for time in expectation.at)]
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
