# SPDX-License-Identifier: MIT
"""Percentiles and histograms of responses."""

from __future__ import annotations

import random
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st
from support.schedule_examples import EXAMPLE_1, TIGHT, load_text, make

from nctakt.schedule.simulation.counters import Counters
from nctakt.schedule.simulation.responses import PERCENTILES_PER_MILLE, ResponseCounts
from nctakt.schedule.simulation.simulate import simulate

US = 1000


def counted(values: list[int]) -> ResponseCounts:
    """The counts of values that are all distinguished."""
    return ResponseCounts(1, tuple((one, values.count(one)) for one in sorted(set(values))))


@given(st.lists(st.integers(0, 50), min_size=1, max_size=200))
def test_percentiles(values: list[int]) -> None:
    """At least this many jobs have that response or a shorter one, and no less would do."""
    responses = counted(values)
    assert responses.total == len(values)
    for share in PERCENTILES_PER_MILLE:
        found = responses.percentile(share)
        assert found in values
        assert sum(one <= found for one in values) * 1000 >= share * len(values)
        assert sum(one < found for one in values) * 1000 < share * len(values)


@given(st.lists(st.integers(0, 100_000), min_size=1, max_size=200), st.integers(1, 30))
def test_bars(values: list[int], maximum: int) -> None:
    """Each value lies in one bar, bars follow each other, and there are not too many."""
    bars = counted(values).bars(maximum)
    assert 1 <= len(bars) <= max(2, maximum)
    for low, high, count in bars:
        assert count == sum(low <= one < high for one in values)
    assert all(one[1] == other[0] for one, other in pairwise(bars))
    assert sum(count for _, _, count in bars) == len(values)


def test_nothing_finished() -> None:
    """No job, no percentile and no bar."""
    assert ResponseCounts().percentile(500) is None
    assert ResponseCounts().bars(10) == []


def test_responses_of_the_example() -> None:
    """S1: COM answers after 5450 and 3450 µs in turn, MMI_DRIVER always after 3400."""
    tasks = simulate(make(EXAMPLE_1, load_text(TIGHT))[0], 600).tasks
    assert tasks[3].responses == ResponseCounts(1, ((3450 * US, 100), (5450 * US, 100)))
    assert tasks[2].responses == ResponseCounts(1, ((3400 * US, 200),))
    assert tasks[3].responses.percentile(500) == 3450 * US
    assert tasks[3].responses.percentile(990) == 5450 * US


@pytest.mark.parametrize("count", [4096, 4097, 30_000])
def test_many_different_responses(count: int) -> None:
    """More than can be distinguished: neighbours count together, and no percentile is too short."""
    model, _ = make(EXAMPLE_1, load_text(TIGHT))
    counters = Counters(model)
    chance = random.Random(count)
    values = chance.sample(range(1_000_000, 9_000_000), count)
    for value in values:
        counters.finish(0, value)
    responses = counters.task_numbers([None] * len(model.tasks))[0].responses
    assert responses.total == count
    assert (responses.resolution == 1) is (count == 4096)
    for share in PERCENTILES_PER_MILLE:
        exact = counted_percentile(values, share)
        found = responses.percentile(share)
        assert found is not None and exact <= found < exact + responses.resolution


def counted_percentile(values: list[int], share: int) -> int:
    """The percentile of a list."""
    return sorted(values)[-(-len(values) * share // 1000) - 1]
