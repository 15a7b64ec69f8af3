# SPDX-License-Identifier: MIT
"""Which dimensions of a study change nothing.

In: a plan and the rows of its runs. Out: the dimensions for which all runs that differ in them
alone are the same run: same events, same values of all that is measured, by the digests.
"""

from __future__ import annotations

from collections.abc import Iterable

from nctakt.studies.bench import Row
from nctakt.studies.plan import Plan

#: Runs that are remembered for one dimension; of more nothing is said.
MAX_REMEMBERED = 100_000


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
