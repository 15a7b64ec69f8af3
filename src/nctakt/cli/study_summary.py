# SPDX-License-Identifier: MIT
"""The result of a study as text: verdicts, spans of the measures, broken runs, strip."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from nctakt.base.diagnostics import Language
from nctakt.studies.bench import HELD, Row
from nctakt.studies.each_tick import strip
from nctakt.studies.measures import as_text
from nctakt.studies.search import Answer
from nctakt.studies.study import Study, StudyResult

#: Broken runs that are shown.
MAX_SHOWN = 10

_TEXTS = {
    "en": ("runs", "minimum", "maximum", "without a value", "more broken runs"),
    "de": ("Läufe", "Minimum", "Maximum", "ohne Wert", "weitere verletzte Läufe"),
}
_VERDICTS = {
    "en": {"held": "held", "broken": "broken", "failed": "failed", "crashed": "crashed"},
    "de": {
        "held": "erfüllt",
        "broken": "verletzt",
        "failed": "fehlgeschlagen",
        "crashed": "abgestürzt",
    },
}


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
    runs, minimum, maximum, without, more = _TEXTS[language]
    names = _VERDICTS[language]
    counts = ", ".join(f"{count} {names[name]}" for name, count in result.counts.items() if count)
    yield f"{file}: {len(result)} {runs}: {counts}"
    for measure in study.plan.measures:
        values = [value for value in result.column(measure.name) if isinstance(value, float | int)]
        missing = result.missing(measure.name)
        line = f"  {measure.name}"
        if values:
            line += f"  {minimum} {as_text(min(values))}  {maximum} {as_text(max(values))}"
        yield line + (f"  {missing} {without}" if missing else "")
    if study.nominal is not None:
        name = next(one.name for one in study.plan.dimensions if one.is_each_tick)
        yield from strip(result.rows, study.nominal, name)
    shown = [row for row in result.rows if row["verdict"] != HELD]
    for row in shown[:MAX_SHOWN]:
        values_of = ", ".join(f"{one.name} = {row[one.name]}" for one in study.plan.dimensions)
        verdict = names[str(row["verdict"])]
        yield f"{row['run']}: {values_of}: {verdict}: {row['broken']}"
        number = row["run"]
        assert isinstance(number, int)
        yield f"    {command(number)}"
    if len(shown) > MAX_SHOWN:
        yield f"… {len(shown) - MAX_SHOWN} {more}"


def answer_lines(study: Study, answer: Answer, language: Language) -> Iterator[str]:
    """Yield the lines of the answer to a goal."""
    runs = _TEXTS[language][0]
    yield f"{answer.goal.word} {answer.goal.measure} ({answer.runs} {runs})"
    for row in answer.rows:
        yield f"  {_values(study, row, language)}"


def shrunk_lines(study: Study, result: StudyResult, language: Language) -> Iterator[str]:
    """Yield the smallest change that breaks as the first broken run does."""
    number = result.broken[0]["run"]
    assert isinstance(number, int)
    answer = study.shrink(number)
    runs = _TEXTS[language][0]
    values = _values(study, answer.rows[0], language)
    yield f"{_SHRUNK[language]} {number} ({answer.runs} {runs}): {values}"


_SHRUNK = {"en": "smallest change of run", "de": "kleinste Änderung von Lauf"}


def _values(study: Study, row: Row, language: Language) -> str:
    """Return inputs, measures and verdict of a row as a line."""
    plan = study.plan
    names = [*(one.name for one in plan.dimensions), *(one.name for one in plan.measures)]
    values = ", ".join(f"{name} = {as_text(row[name])}" for name in names)
    return f"{values}: {_VERDICTS[language][str(row['verdict'])]}"
