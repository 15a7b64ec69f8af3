# SPDX-License-Identifier: MIT
"""``nctakt study``: the command that shows a run of it, and the rows of a search.

In: a study and its rows. Out: a command for each number of a run; with ``--record`` the tapes of
the failed runs, and of those that a report shows.
"""

from __future__ import annotations

import contextlib
import itertools
import shlex
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any, TypeVar

from nctakt.run.options import accepted_by, command_words
from nctakt.studies.plans.dimension import Value
from nctakt.studies.report import MAX_ROWS, ShownRuns
from nctakt.studies.rows.folder_store import FolderStore
from nctakt.studies.rows.row_store import RowStore
from nctakt.studies.runs.study_runner import FAILED, PASSED
from nctakt.studies.searching.search_runs import SearchRuns
from nctakt.studies.study import Study, StudyResult

#: The most tapes of one study.
MAX_TAPES = 100

#: Options of ``nctakt study`` that decide which runs there are, besides those of the run.
_OPTIONS = ("each_tick", "sample")


_T = TypeVar("_T")


def commands_of(
    study: Study, result: StudyResult, file: str, words: dict[str, Any]
) -> Callable[[int], str]:
    """Return the command of each run; write tapes of the failed ones with ``--record``.

    Raises ``Failure`` for files that cannot be written.
    """
    recorded: dict[int, str] = {}
    if words["record"] is not None:
        folder = Path(words["record"])
        for number in _numbers(result, has_report=words["report"] is not None):
            recorded[number] = study.record(number, folder / f"run-{number}.tape")

    def command(number: int) -> str:
        return recorded.get(number) or study.command(number) or _again(file, words, number)

    return command


def _numbers(result: StudyResult, *, has_report: bool) -> Iterator[int]:
    """Yield the numbers of the runs that have a tape: extreme ones of a report, failed ones."""
    extreme = result.extreme_runs if has_report else ()
    failed = (int(row["run"] or 0) for row in result.rows if row["verdict"] == FAILED)
    others = (number for number in failed if number not in extreme)
    return itertools.islice(itertools.chain(extreme, others), MAX_TAPES)


def picture_of(study: Study, words: dict[str, Any]) -> Callable[[int], bytes | None] | None:
    """Return what draws a run of a study for its report; ``None`` for a schedule."""
    if study.plan.is_schedule:
        return None
    return lambda number: study.picture(number, words["language"])


def shown_rows(study: Study, result: StudyResult, file: str, words: dict[str, Any]) -> ShownRuns:
    """Return what a page says of runs of which only the rows are known, as ``commands_of``.

    The runs of a search have no number in the plan: their values say which they are.
    """
    commands = commands_of(study, result, file, words)
    points = _points(study, result)

    def command(number: int) -> str:
        point = points[number]
        if number < len(study) and tuple(study.plan.point(number)) == point:
            return commands(number)
        return study.command(point) or named_values(study, point)

    draws = not study.plan.is_schedule
    picture = (lambda number: study.picture(points[number], words["language"])) if draws else None
    return ShownRuns(command, picture)


def _points(study: Study, result: StudyResult) -> dict[int, tuple[Value, ...]]:
    """Return the values of the runs that a page shows, by their numbers."""
    extreme, failed = frozenset(result.extreme_runs), 0
    found: dict[int, tuple[Value, ...]] = {}
    for row in result.rows:
        number = int(row["run"] or 0)
        has_failed = row["verdict"] != PASSED and failed < MAX_ROWS
        failed += has_failed
        if has_failed or number in extreme:
            found[number] = tuple(one.of_shown(row[one.name] or 0) for one in study.plan.dimensions)
    return found


def named_values(study: Study, point: Sequence[Value]) -> str:
    """Return the values of a run that no command makes."""
    pairs = zip(study.plan.dimensions, point, strict=True)
    return ", ".join(f"{one.name} = {one.shown(value)}" for one, value in pairs)


def _again(file: str, words: dict[str, Any], number: int) -> str:
    """Return the words that make one run of the study alone, and its tape."""
    parts = ["nctakt", "study", file]
    for name in _OPTIONS:
        if words[name] is not None:
            parts += [f"--{name.replace('_', '-')}", str(words[name])]
    for row in accepted_by("study"):
        if "plan" in row.front_ends:
            parts += command_words(row, words[row.word])
    for text in words["expect"]:
        parts += ["--expect", text]
    return shlex.join([*parts, "--only", str(number), "--record", words["record"] or "tapes"])


def search_with_rows(
    study: Study,
    store: RowStore | FolderStore | None,
    words: dict[str, Any],
    search: Callable[[SearchRuns], _T],
) -> _T:
    """Return what a search finds; write the rows of its runs with ``--out``, with ``--report`` too.

    Raises ``Failure`` as the search, and for files that cannot be written.
    """
    covers = words["cover"]
    with contextlib.ExitStack() as at_the_end:
        make = None
        if words["scheduler"] is not None:
            from nctakt.studies.workers.cluster import points_of_cluster  # noqa: PLC0415 - an extra

            uploads = [Path(name) for name in words["upload"]]
            cluster = points_of_cluster(study.plan, words["scheduler"], uploads, covers=covers)
            make = at_the_end.enter_context(cluster)
        searched = SearchRuns(study.runner, store, make, covers=covers)
        found = search(searched)
    result = StudyResult(study.plan, searched.rows, study.nominal, study.runner.units)
    if store is not None and store.folder is None:
        result.save(words["out"])
    if words["report"] is not None:
        from nctakt.files.output import write_file  # noqa: PLC0415 - few studies have one

        page = result.report(
            words["language"],
            lambda number: _command(study, searched.points[number]),
            lambda number: study.picture(searched.points[number], words["language"]),
        )
        write_file(words["report"], page)
    return found


def _command(study: Study, point: Sequence[Value]) -> str:
    """Return the command of a run of the search, else its values: it has no number in the plan."""
    return study.command(point) or named_values(study, point)
