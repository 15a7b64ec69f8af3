# SPDX-License-Identifier: MIT
"""Conditions on the course of a signal say what Python's comparisons say, value by value."""

from __future__ import annotations

from array import array
from math import inf, nan

import pytest

from nctakt.results.run import Run
from nctakt.studies.measuring.measure_nodes import COMPARISONS, Condition
from nctakt.studies.measuring.outcome import Outcome

#: Both sides of each limit, the limit itself twice, and what is no number.
VALUES = (1.0, 2.0, nan, 2.0, 3.0, 3.0, nan, -inf, 2.0, inf, -0.0, 0.0)


class Given(Outcome):
    """An outcome whose signal has these values."""

    def __init__(self, first: int) -> None:
        super().__init__(Run((), 1000, 0, len(VALUES), "ended"))
        self._first = first

    def course(self, name: str) -> tuple[array[float], int]:
        """Return them, from their first tick on."""
        return array("d", VALUES[self._first :]), self._first


@pytest.mark.parametrize("limit", [2.0, nan, inf, 0.0])
@pytest.mark.parametrize("word", COMPARISONS)
def test_courses_are_compared_as_values_are(word: str, limit: float) -> None:
    """The first tick in which a condition holds, from each tick on, and each time it begins to."""
    condition = Condition("X", word, limit)
    held = [COMPARISONS[word](value, limit) for value in VALUES]
    for begin in range(len(VALUES) + 2):
        found = next((tick for tick in range(begin, len(VALUES)) if held[tick]), None)
        assert condition.first_tick(Given(0), begin) == found
        if begin >= 4:
            assert condition.first_tick(Given(4), begin) == found
    begun = [tick for tick, one in enumerate(held) if one and not (tick and held[tick - 1])]
    assert condition.times_us(Given(0)) == [tick * 1000 for tick in begun]
