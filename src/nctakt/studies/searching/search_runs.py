# SPDX-License-Identifier: MIT
"""The runs of searches: each point is made once, here or elsewhere, and its row is kept.

In: a runner, a maker of rows for points, a store of rows. Out: rows. The same plan requests the
same points in the same order: so the rows that an earlier call has stored are those of its first
points.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence

from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.commands.studies import OTHER_PLAN
from nctakt.studies.plans.dimension import Value
from nctakt.studies.rows.folder_store import FolderStore
from nctakt.studies.rows.row_store import RowStore
from nctakt.studies.runs.effects import without_effect
from nctakt.studies.runs.row_block import RowBlock
from nctakt.studies.runs.study_runner import Row, StudyRunner

#: A run of a search: its number and its values.
Point = tuple[int, tuple[Value, ...]]

#: Makes the rows of points, in their order.
RowsOfPoints = Callable[[Sequence[Point]], Iterable[Row]]


class SearchRuns:
    """The runs of all searches of a plan; ``points`` and ``rows`` by their numbers.

    ``make``: makes rows elsewhere, by default the runner does. ``store`` keeps each new row and has
    those of an earlier call. ``covers``: runs of ``--cover``, as ``StudyRunner.row_of`` makes them.
    """

    def __init__(
        self,
        runner: StudyRunner,
        store: RowStore | FolderStore | None = None,
        make: RowsOfPoints | None = None,
        *,
        covers: bool = False,
    ) -> None:
        self.runner = runner
        self._covers = covers
        self.points: list[tuple[Value, ...]] = []
        self.rows: list[Row] = []
        self._store = store
        self._make = make or self._rows_of_runner
        stored = () if store is None else store.rows()
        self._earlier = {row["run"]: row for row in stored}

    def _rows_of_runner(self, points: Sequence[Point]) -> Iterator[Row]:
        for number, point in points:
            yield self.runner.row_of(number, point, covers=self._covers)

    def add(self, points: Sequence[tuple[Value, ...]]) -> list[Row]:
        """Make the runs of these points; return their rows."""
        first = len(self.points)
        self.points += points
        numbered = list(enumerate(points, first))
        by_number = {number: self._stored(number, point) for number, point in numbered}
        missing = [one for one in numbered if by_number[one[0]] is None]
        for row in self._make(missing) if missing else ():
            if self._store is not None:
                self._store.add(RowBlock([dict(row)]))  # the search takes counts out of it
            by_number[int(row["run"] or 0)] = row
        rows = [row for row in by_number.values() if row is not None]
        self.rows += rows
        return rows

    def _stored(self, number: int, point: tuple[Value, ...]) -> Row | None:
        """Return the row of an earlier call; ``None`` if it has none of a run with these values.

        Raises ``Failure`` (901309) if a folder has other values: its parts are not changed.
        """
        row = self._earlier.get(number)
        head = self.runner.row_head(number, point)
        if row is None or head.items() <= row.items():
            return row
        if self._store is not None and self._store.folder is not None:
            raise Failure(diagnostic(OTHER_PLAN, folder=self._store.name))
        return None


class Runs:
    """The runs of one search, each point once."""

    def __init__(self, searched: SearchRuns) -> None:
        self._searched = searched
        self._rows: dict[tuple[Value, ...], Row] = {}

    def row(self, point: Sequence[Value]) -> Row:
        """Return the row of a point."""
        return self.all([point])[0]

    def all(self, points: Sequence[Sequence[Value]]) -> list[Row]:
        """Return the rows of points that do not depend on each other."""
        keys = [tuple(point) for point in points]
        new = list(dict.fromkeys(key for key in keys if key not in self._rows))
        if new:
            self._rows.update(zip(new, self._searched.add(new), strict=True))
        return [self._rows[key] for key in keys]

    @property
    def tried(self) -> list[tuple[tuple[Value, ...], Row]]:
        """The points that were tried, each with its row, in the order of the search."""
        return list(self._rows.items())

    @property
    def count(self) -> int:
        """How many runs were made."""
        return len(self._rows)

    def without_effect(self) -> tuple[str, ...]:
        """Return the dimensions that changed nothing."""
        return tuple(without_effect(self._searched.runner.plan, self._rows.values()))
