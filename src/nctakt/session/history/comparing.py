# SPDX-License-Identifier: MIT
"""Where two branches of a session differ first.

In: two branches, each with a controller at a tick before they fork. Out: the first tick after which
one of their signals differs.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from nctakt.base.dataclass import dataclass
from nctakt.session.history.branch import Branch
from nctakt.session.process.process_pool import RemoteEngine

#: Ticks that are compared at once: at first, and at most.
_FIRST_PART, _LARGEST_PART = 16, 1024


@dataclass(frozen=True, slots=True)
class BranchDifference:
    """Two branches that are the same before tick ``fork``, and have both run up to tick ``end``.

    ``tick``: the first tick after which signals differ, ``None`` if there is none before ``end``.
    ``signals``: their names and values in both.
    """

    fork: int
    end: int
    tick: int | None = None
    signals: tuple[tuple[str, float, float], ...] = ()


def fork_of(one: Branch, other: Branch) -> int:
    """Return the tick before which two branches are the same."""
    bounds: dict[int, int] = {}
    branch: Branch | None = one
    bound = one.latest
    while branch is not None:
        bounds[branch.number] = bound
        bound, branch = min(bound, branch.first_tick), branch.parent
    branch, bound = other, other.latest
    while branch is not None and branch.number not in bounds:
        bound, branch = min(bound, branch.first_tick), branch.parent
    return 0 if branch is None else min(bound, bounds[branch.number])


def first_difference(
    engines: tuple[RemoteEngine, RemoteEngine],
    end: int,
    signals: Sequence[str],
    poll: Callable[[], None],
) -> BranchDifference:
    """Run two controllers from where they are up to a tick, or to where a signal differs.

    ``poll`` is called meanwhile, and may end it by an exception.
    """
    fork = tick = engines[0].tick
    names, width, part = list(signals), len(signals), _FIRST_PART
    while tick < end:
        bound = min(tick + part, end)
        one, other = (engine.ask("look", bound, names, 1) for engine in engines)
        for row in range(bound - tick) if one != other else ():
            begin, stop = 8 * width * row, 8 * width * (row + 1)
            values = (memoryview(cells[begin:stop]).cast("d") for cells in (one, other))
            differing = tuple(
                cell for cell in zip(names, *values, strict=False) if not _is_same(*cell[1:])
            )
            if differing or len(one) < stop or len(other) < stop:
                return BranchDifference(fork, end, tick + row, differing)
        tick, part = bound, min(2 * part, _LARGEST_PART)
        poll()
    return BranchDifference(fork, end)


def _is_same(one: float, other: float) -> bool:
    """Return whether two values are equal, or both no numbers."""
    return one == other or (math.isnan(one) and math.isnan(other))
