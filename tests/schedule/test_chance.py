# SPDX-License-Identifier: MIT
"""Random numbers of schedules: those that Python gives for the same seed."""

from __future__ import annotations

import random

from hypothesis import example, given
from hypothesis import strategies as st

from nctakt.schedule.simulation.chance import Chance

RANGES = st.tuples(st.integers(-(2**40), 2**40), st.integers(0, 2**43))


@given(st.integers(), st.lists(RANGES, min_size=1, max_size=20))
@example(0, [(0, 0), (0, 2**31), (0, 2**32 - 1), (0, 2**32), (5, 2**43)])
def test_numbers_are_those_of_python(seed: int, ranges: list[tuple[int, int]]) -> None:
    """Whatever is drawn in whatever order: a seed means the same schedule in each version."""
    chance, python = Chance(seed), random.Random(seed)
    for low, more in ranges:
        assert chance.randint(low, low + more) == python.randint(low, low + more)


def test_more_than_one_block() -> None:
    """Blocks follow each other without a gap."""
    chance, python = Chance(3), random.Random(3)
    for _ in range(10_000):
        assert chance.randint(0, 999_999) == python.randint(0, 999_999)
