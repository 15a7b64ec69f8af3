# SPDX-License-Identifier: MIT
"""How many random programs, lists or texts a test makes, and from which seeds.

``NCTAKT_SEEDS=100000`` makes as many of each kind, from ``NCTAKT_FIRST_SEED`` on (0). Else each
test says how many: fewer where the modules run as plain Python, which takes longer and gives the
same results.
"""

from __future__ import annotations

import os
from typing import Any

import pytest

from nctakt.base.mode import is_compiled

FIRST = int(os.environ.get("NCTAKT_FIRST_SEED", "0"))
MANY = os.environ.get("NCTAKT_SEEDS", "")


def each_seed(compiled: int, plain: int) -> pytest.MarkDecorator:
    """Run a test once for each ``seed``; it is slow, which ``scripts/test --quick`` leaves out."""
    values = [pytest.param(seed, marks=pytest.mark.slow) for seed in all_seeds(compiled, plain)]
    return pytest.mark.parametrize("seed", values)


def seeds_in_parts(compiled: int, plain: int, part: int) -> pytest.MarkDecorator:
    """Run a test for ranges of ``part`` ``seeds``, so that several processes share them."""
    seeds = all_seeds(compiled, plain)
    parts = [seeds[first : first + part] for first in range(0, len(seeds), part)]
    values = [pytest.param(one, id=str(one.start), marks=pytest.mark.slow) for one in parts]
    return pytest.mark.parametrize("seeds", values)


def all_seeds(compiled: int, plain: int) -> range:
    """Return the seeds of one kind."""
    return range(FIRST, FIRST + int(MANY or (compiled if is_compiled() else plain)))


def by_night(value: object) -> Any:
    """Return a parameter that is tried each night, since the others find nearly as much."""
    return pytest.param(value, marks=pytest.mark.nightly)


def examples(count: int) -> int:
    """Return how many examples a test of hypothesis makes that makes ``count`` by default."""
    return int(MANY or count)
