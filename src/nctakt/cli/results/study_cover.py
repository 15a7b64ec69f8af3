# SPDX-License-Identifier: MIT
"""Output of ``nctakt study --cover``: the branches, and the run that first reached each."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from nctakt.base.diagnostics import Language, Text
from nctakt.results.coverage_text import CoverageText
from nctakt.studies.measuring.measures import as_text
from nctakt.studies.searching.cover import FirstRun, Reached
from nctakt.studies.study import Study

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
