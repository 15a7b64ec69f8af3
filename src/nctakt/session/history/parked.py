# SPDX-License-Identifier: MIT
"""The parked controllers of a session.

In: controllers at ticks of branches. Out: the nearest one to any moment; unneeded ones are closed.
"""

from __future__ import annotations

from nctakt.base.dataclass import dataclass
from nctakt.session.history.branch import Branch
from nctakt.session.history.parking import MAX_PARKED, surplus
from nctakt.session.process.process_pool import RemoteEngine


@dataclass(frozen=True, slots=True)
class Parked:
    """A controller before a tick of a branch; ``work_us``: how long the run up to there took."""

    branch: Branch
    tick: int
    work_us: float
    engine: RemoteEngine


class ParkedControllers:
    """All parked controllers; ``filler``: one on its way to where another is missing.

    ``candidate``: one not confirmed yet. ``capacity``: how many are kept.
    """

    def __init__(self, capacity: int = MAX_PARKED) -> None:
        self._capacity = capacity
        self._parked: list[Parked] = []
        self.filler: Parked | None = None
        self.candidate: Parked | None = None

    def __len__(self) -> int:
        return len(self._parked)

    def add(self, parked: Parked) -> None:
        """Keep a controller."""
        self._parked.append(parked)
        self._parked.sort(key=lambda one: (one.work_us, one.tick, one.branch.number))

    def thin_out(self, present_us: float) -> None:
        """Close those that are too close together, seen from a present."""
        works = [one.work_us for one in self._parked]
        for index in reversed(surplus(works, present_us, self._capacity)):
            self._parked.pop(index).engine.close()

    def before(self, branch: Branch, tick: int) -> list[Parked]:
        """Return those at or before a tick of a branch, by tick."""
        usable = [
            one for one in self._parked if one.tick <= tick and branch.shares(one.branch, one.tick)
        ]
        return sorted(usable, key=lambda one: one.tick)

    def nearest(self, branch: Branch, tick: int) -> Parked | None:
        """Return the last controller at or before a tick of a branch."""
        return next(reversed(self.before(branch, tick)), None)

    def before_by(self, branch: Branch, tick: int, work_us: float) -> Parked | None:
        """Return the last one that is some work before a tick of a branch, else the first."""
        latest_us = branch.work_at(tick) - work_us
        before = self.before(branch, tick)
        far = [one for one in before if one.work_us <= latest_us]
        return next(iter(far[-1:] or before), None)

    def keep_candidate(self, present_us: float) -> None:
        """Park the candidate, which is right, seen from a present."""
        if self.candidate is not None:
            self.add(self.candidate)
            self.candidate = None
            self.thin_out(present_us)

    def give_up_candidate(self) -> None:
        """Close the candidate."""
        if self.candidate is not None:
            self.candidate.engine.close()
            self.candidate = None

    def give_up_filler(self) -> None:
        """Close the filler."""
        if self.filler is not None:
            self.filler.engine.close()
            self.filler = None

    def close(self) -> None:
        """Close all of them."""
        self.give_up_filler()
        self.give_up_candidate()
        for parked in self._parked:
            parked.engine.close()
        self._parked.clear()
