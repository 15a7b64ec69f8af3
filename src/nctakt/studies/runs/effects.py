# SPDX-License-Identifier: MIT
"""Which dimensions of a study change nothing.

In: a plan and the rows of its runs. Out: the dimensions for which all runs that differ in them
alone are the same run: same events, same measured values, by the digests. Random points differ in
all dimensions at once: for them some runs are repeated with another value of one dimension.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence

from nctakt.studies.plans.plan import Method, Plan
from nctakt.studies.runs.study_runner import Row, StudyRunner

#: Maximum number of runs remembered for one dimension; beyond that nothing is reported.
MAX_REMEMBERED = 100_000

#: The methods whose points differ in all dimensions at once.
BY_CHANCE: tuple[Method, ...] = ("random", "latin", "sobol")

#: Maximum number of runs repeated for one dimension; most dimensions with an effect need one.
REPEATED = 8


def without_effect(plan: Plan, rows: Iterable[Row]) -> list[str]:
    """Return the names of the dimensions that change nothing; each was compared at least once.

    Runs without a digest, which were not made, are passed over.
    """
    search = _Search(len(plan.dimensions))
    for row in rows:
        digest = row.get("digest")
        if digest:
            search.add(tuple(row.get(one.name) for one in plan.dimensions), str(digest))
            if search.is_over:
                break
    return [one.name for number, one in enumerate(plan.dimensions) if search.is_dead(number)]


def without_shown_effect(
    runner: StudyRunner, rows: Sequence[Row], known: Collection[str]
) -> list[tuple[str, int]]:
    """Return the dimensions that changed nothing where runs were made again for it, and how many.

    Only for random points, and for dimensions for which it is not ``known``. A repeated run has the
    value of the next point.
    """
    plan = runner.plan
    finished = [row for row in rows if row.get("digest")]
    if plan.method not in BY_CHANCE or len(finished) < 2:
        return []
    step = max(1, len(finished) // REPEATED)
    picked = finished[::step][:REPEATED]
    points = [plan.point(int(row["run"] or 0)) for row in picked]
    found: list[tuple[str, int]] = []
    for number, dimension in enumerate(plan.dimensions):
        if dimension.name in known:
            continue
        count = 0
        for index, row in enumerate(picked):
            value = points[(index + 1) % len(points)][number]
            if value == points[index][number]:
                continue
            other = (*points[index][:number], value, *points[index][number + 1 :])
            if runner.row_of(int(row["run"] or 0), other)["digest"] != row["digest"]:
                break
            count += 1
        else:
            found += [(dimension.name, count)] if count else []
    return found


class _Search:
    """Compares runs; where all are the same, no dimension has an effect.

    ``_remembered``: dimension -> values of the others -> one of its values, and the digest.
    """

    def __init__(self, count: int) -> None:
        self._remembered: dict[int, dict[tuple[object, ...], tuple[object, str]]] = {
            number: {} for number in range(count)
        }
        self._compared: set[int] = set()
        self._first: tuple[tuple[object, ...], str] | None = None
        self._varied: set[int] = set()
        self._are_same = True

    @property
    def is_over(self) -> bool:
        """Whether further runs would change nothing."""
        return not self._remembered and not self._are_same

    def is_dead(self, number: int) -> bool:
        """Return whether a dimension has changed nothing."""
        if self._are_same:
            return number in self._varied
        return number in self._remembered and number in self._compared

    def add(self, values: tuple[object, ...], digest: str) -> None:
        """Compare a run with those before."""
        first, first_digest = self._first = self._first or (values, digest)
        self._are_same = self._are_same and digest == first_digest
        for number, value in enumerate(values):
            if value != first[number]:
                self._varied.add(number)
            known = self._remembered.get(number)
            if known is not None and not self._fits(number, known, values, digest):
                del self._remembered[number]

    def _fits(
        self,
        number: int,
        known: dict[tuple[object, ...], tuple[object, str]],
        values: tuple[object, ...],
        digest: str,
    ) -> bool:
        """Note a run; return whether the dimension may still have no effect."""
        others = (*values[:number], *values[number + 1 :])
        value, own_digest = known.setdefault(others, (values[number], digest))
        if value != values[number]:
            self._compared.add(number)
        return digest == own_digest and len(known) <= MAX_REMEMBERED
