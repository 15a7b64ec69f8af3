# SPDX-License-Identifier: MIT
"""The result of a study as text: verdicts, spans of the measures, failed runs, strip, branches."""

from __future__ import annotations

import itertools
import re
import shlex
from collections.abc import Callable, Iterator
from pathlib import Path

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Language, Text
from nctakt.results.coverage_text import CoverageText
from nctakt.studies.measuring.measures import as_text
from nctakt.studies.plans.verdicts import share_text
from nctakt.studies.runs.each_tick import strip
from nctakt.studies.runs.study_runner import CRASHED, FAILED, PASSED, REFUSED, Row
from nctakt.studies.searching.cover import FirstRun, Reached
from nctakt.studies.searching.search import Answer
from nctakt.studies.study import Study, StudyResult

#: Failed runs that are shown.
MAX_SHOWN = 10

#: Measures that are shown, characters of a failed run's values and of what it did not meet.
MAX_MEASURES, MAX_LENGTH = 10, 200

_TEXTS = {
    "en": (
        "run", "runs", "minimum", "maximum", "without a value", "more failed runs",
        "more measures",
    ),
    "de": (
        "Lauf", "Läufe", "Minimum", "Maximum", "ohne Wert", "weitere nicht bestandene Läufe",
        "weitere Messgrößen",
    ),
}  # fmt: skip
_VERDICTS = {
    "en": {word: word for word in (PASSED, FAILED, REFUSED, CRASHED)},
    "de": {
        PASSED: "bestanden",
        FAILED: "nicht bestanden",
        REFUSED: "nicht möglich",
        CRASHED: "abgestürzt",
    },
}


_ALL_TRIED = Text(
    "all {count} points of the plan were tried",
    "alle {count} Punkte des Plans wurden versucht",
)
_PROVEN = Text(
    "{file}:{line}: cannot be reached, proven for {bounds}",
    "{file}:{line}: nicht erreichbar, bewiesen für {bounds}",
)
_ALWAYS = Text(
    "{file}:{line}: cannot be reached, proven", "{file}:{line}: nicht erreichbar, bewiesen"
)
_BOUNDS = Text("{name} from {low} to {high}", "{name} von {low} bis {high}")


def summary(
    study: Study,
    result: StudyResult,
    file: str,
    command: Callable[[int], str],
    language: Language,
) -> Iterator[str]:
    """Yield the lines of the summary.

    ``file``: the plan or program as the user named it, ``command`` shows a run by its number.
    """
    *_, minimum, maximum, without, more, measures = _TEXTS[language]
    names = _VERDICTS[language]
    verdicts = result.counts
    counts = ", ".join(f"{count} {names[name]}" for name, count in verdicts.items() if count)
    yield f"{file}: {_runs(len(result), language)}{counts and ': '}{counts}"
    if not len(result):
        return
    if study.plan.method in ("random", "latin", "sobol"):
        yield f"  {names[PASSED]}: {share_text(verdicts[PASSED], len(result))}"
    spans = spans_of(result)
    for name, span in itertools.islice(spans.items(), MAX_MEASURES):
        line = f"  {name}"
        if span.low is not None and span.high is not None:
            line += f"  {minimum} {as_text(span.low)}  {maximum} {as_text(span.high)}"
        if span.missing:
            line += f"  {span.missing} {without}"
            reason = study.reason(name, span.first_missing)
            line += f" ({span.first_missing}: {reason})" if reason else ""
        yield line
    if len(spans) > MAX_MEASURES:
        yield f"  … {len(spans) - MAX_MEASURES} {measures}"
    if study.nominal is not None:
        name = next(one.name for one in study.plan.dimensions if one.is_each_tick)
        yield from strip(result.rows, study.nominal, name, language)
    for row in result.first_broken(MAX_SHOWN):
        values_of = ", ".join(
            f"{one.name} = {as_text(row[one.name])}" for one in study.plan.dimensions
        )
        verdict = names[str(row["verdict"])]
        yield f"{row['run']}: {_cut(values_of)}: {verdict}: {_cut(str(row['broken']))}"
        number = row["run"]
        assert isinstance(number, int)
        yield f"    {command(number)}"
    left = len(result) - verdicts[PASSED] - MAX_SHOWN
    if left > 0:
        yield f"… {left} {more}"


def _runs(count: int, language: Language) -> str:
    one, several, *_ = _TEXTS[language]
    return f"{count} {one if count == 1 else several}"


def _cut(text: str) -> str:
    """Return the beginning of a text that is too long for a summary."""
    return text if len(text) <= MAX_LENGTH else f"{text[: MAX_LENGTH - 1]}…"


@dataclass(slots=True)
class Span:
    """The least and the greatest number of a measure, and the runs that have no value."""

    low: float | None = None
    high: float | None = None
    missing: int = 0
    first_missing: int = 0


def spans_of(result: StudyResult) -> dict[str, Span]:
    """Return the span of each measure, from one pass over the rows."""
    spans = {measure.name: Span() for measure in result.plan.measures}
    for row in result.rows:
        for name, span in spans.items():
            value = row[name]
            if value is None:
                span.first_missing = span.first_missing if span.missing else int(row["run"] or 0)
                span.missing += 1
            elif not isinstance(value, str):
                span.low = value if span.low is None else min(span.low, value)
                span.high = value if span.high is None else max(span.high, value)
    return spans


def answer_lines(
    study: Study, answer: Answer, file: str, folder: str | None, language: Language
) -> Iterator[str]:
    """Yield the lines of the answer to a goal; write tapes of its runs to a folder, if named.

    ``file``: the plan as the user named it. Raises ``Failure`` for files that cannot be written.
    """
    yield f"{answer.goal.word} {answer.goal.measure} ({_runs(answer.runs, language)})"
    for number, (row, point) in enumerate(zip(answer.rows, answer.points, strict=True)):
        yield f"  {_values(study, row, language)}"
        command = study.command(point)
        if folder is not None and row["verdict"] != REFUSED:
            name = f"{answer.goal.word}-{answer.goal.measure}-{number}.tape"
            command = study.record(point, Path(folder) / re.sub(r"[^\w.-]", "_", name))
        yield f"    {command or shlex.join(['nctakt', 'study', file, '--record', 'tapes'])}"


def shrunk_lines(study: Study, result: StudyResult, language: Language) -> Iterator[str]:
    """Yield the smallest change that fails as the first failed run does."""
    number = result.first_broken(1)[0]["run"]
    assert isinstance(number, int)
    answer = study.shrink(number)
    values = _values(study, answer.rows[0], language)
    yield f"{_SHRUNK[language]} {number} ({_runs(answer.runs, language)}): {values}"


_SHRUNK = {"en": "smallest change of run", "de": "kleinste Änderung von Lauf"}


def _values(study: Study, row: Row, language: Language) -> str:
    """Return inputs, measures and verdict of a row as a line."""
    plan = study.plan
    names = [*(one.name for one in plan.dimensions), *(one.name for one in plan.measures)]
    values = ", ".join(f"{name} = {as_text(row[name])}" for name in names)
    text = f"{values}: {_VERDICTS[language][str(row['verdict'])]}"
    return f"{text}: {row['broken']}" if row["broken"] else text


def cover_lines(
    study: Study, reached: Reached, folder: str | None, language: Language
) -> Iterator[str]:
    """Yield the lines; write tapes of the first runs to a folder, if one is named.

    Raises ``Failure`` for files that cannot be written.
    """
    yield CoverageText(reached.coverage, language).table().rstrip("\n")
    for (file, line, index), decisive in reached.proofs.items():
        cycle = next(c for c in reached.coverage.cycles if (c.file, c.line) == (file, line))
        bounds = ", ".join(
            _BOUNDS.get(language).format(name=name, low=as_text(span.low), high=as_text(span.high))
            for name, span in decisive
        )
        text = _PROVEN if decisive else _ALWAYS
        yield text.get(language).format(file=file, line=cycle.branches[index].line, bounds=bounds)
    if not reached.untried:
        yield _ALL_TRIED.get(language).format(count=reached.coverage.runs + reached.failed)
    for one in reached.first:
        yield f"{one.file}:{one.line}: {_command(study, one, folder)}"


def _command(study: Study, one: FirstRun, folder: str | None) -> str:
    """Return the command that shows a run, or its inputs."""
    if folder is not None:
        name = f"{Path(one.file).stem}-{one.line}.tape"
        return study.record(one.point, Path(folder) / name)
    command = study.command(one.point)
    if command is None and one.number is not None:
        command = f"--only {one.number}"
    named = zip(study.plan.dimensions, one.point, strict=True)
    values = (f"{dimension.name} = {as_text(dimension.shown(value))}" for dimension, value in named)
    return command or ", ".join(values)
