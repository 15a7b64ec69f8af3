# SPDX-License-Identifier: MIT
"""``nctakt study`` with a plan that searches: its runs as rows, here or on a cluster."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, TypeVar

from nctakt.cli.results.study_commands import named_values
from nctakt.studies.plans.dimension import Value
from nctakt.studies.rows.folder_store import FolderStore
from nctakt.studies.rows.row_store import RowStore
from nctakt.studies.searching.search_runs import SearchRuns
from nctakt.studies.study import Study, StudyResult

_T = TypeVar("_T")


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
