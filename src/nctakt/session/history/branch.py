# SPDX-License-Identifier: MIT
"""Branches of the tape of a session: each with its inputs and its record.

In: inputs, the record of the ticks that were run with them. Out: the inputs from any tick on, the
marks and events of all ticks up to there, whichever branch has them.
"""

from __future__ import annotations

import bisect
from collections.abc import Sequence

from nctakt.base.dataclass import dataclass, field
from nctakt.run.access.inputs import Input
from nctakt.session.history.columns import Necessary
from nctakt.session.history.record import BranchRecord, PastMark
from nctakt.session.stops import EventFilter


@dataclass(slots=True)
class Branch:
    """One course of the inputs.

    It shares the inputs and the record of its ``parent`` before ``first_tick``. ``inputs`` are
    those of this branch, by tick and order; ``latest``: the furthest tick that it has reached.
    """

    number: int
    parent: Branch | None
    first_tick: int
    inputs: list[Input] = field(default_factory=list)
    latest: int = 0
    record: BranchRecord = field(default_factory=BranchRecord)

    def all_inputs(self, before: int | None = None) -> list[Input]:
        """Return its inputs from the start on, up to but without tick ``before``."""
        inherited = [] if self.parent is None else self.parent.all_inputs(self.first_tick)
        inputs = self.inputs
        if before is not None:
            inputs = inputs[: index_of(inputs, before)]
            inherited = [one for one in inherited if one.tick < before]
        return inherited + inputs

    def inputs_from(self, tick: int) -> list[Input]:
        """Return its inputs from a tick on."""
        inputs = self.inputs[index_of(self.inputs, tick) :]
        if self.parent is None or tick >= self.first_tick:
            return inputs
        inherited = self.parent.inputs_from(tick)
        return inherited[: index_of(inherited, self.first_tick)] + inputs

    def shares(self, other: Branch, tick: int) -> bool:
        """Return whether a state of ``other`` before a tick also belongs to this branch."""
        branch: Branch | None = self
        while branch is not None and branch is not other:
            if tick > branch.first_tick:
                return False
            branch = branch.parent
        return branch is other

    def owner(self, tick: int) -> Branch:
        """Return the oldest branch to which a state before a tick belongs."""
        branch = self
        while branch.parent is not None and tick <= branch.first_tick:
            branch = branch.parent
        return branch

    # --- marks and events -----------------------------------------------------------------------

    def marks_between(self, after: int, last: int) -> list[PastMark]:
        """Return the marks after a tick, up to another, except that of the run's end."""
        found: list[PastMark] = []
        if self.parent is not None and after < self.first_tick:
            found = self.parent.marks_between(after, min(last, self.first_tick))
            after = max(after, self.first_tick)
        return found + [mark for mark in self.record.marks_between(after, last) if not mark.is_over]

    def mark_after(self, tick: int) -> PastMark | None:
        """Return the first mark at or after a tick, ``None`` if there is none."""
        if self.parent is not None and tick <= self.first_tick:
            inherited = self.parent.mark_after(tick)
            if inherited is not None and inherited.end <= self.first_tick:
                return inherited
        return self.record.mark_after(tick)

    def mark_at(self, tick: int) -> PastMark | None:
        """Return the last mark at or before a tick, ``None`` if there is none."""
        mark = self.record.mark_at(tick)
        if mark is None and self.parent is not None:
            return self.parent.mark_at(min(tick, self.first_tick))
        return mark

    def mark_before_work(self, work_us: float) -> PastMark | None:
        """Return the last mark up to which the run took at most this long."""
        mark = self.record.mark_before_work(work_us)
        if mark is None and self.parent is not None:
            mark = self.parent.mark_before_work(work_us)
            if mark is not None and mark.tick > self.first_tick:
                return self.parent.mark_at(self.first_tick)
        return mark

    def work_at(self, tick: int) -> float:
        """Return how long the run up to a tick took, in microseconds; estimated between marks."""
        before, after = self.mark_at(tick), self.mark_after(tick)
        first_tick, first_us = (0, 0.0) if before is None else (before.tick, before.work_us)
        if after is None or after.tick <= first_tick:
            return first_us
        share = (tick - first_tick) / (after.tick - first_tick)
        return first_us + share * max(0.0, after.work_us - first_us)

    def last_event(self, requested: EventFilter, before: float) -> int:
        """Return the last tick before another that has such an event, -1 without."""
        found = self.record.last_event(requested, before)
        if found is None and self.parent is not None:
            return self.parent.last_event(requested, min(before, self.first_tick))
        return -1 if found is None else found

    def possible_end(self, needed: Necessary, before: int) -> int:
        """Return the end of the last ticks before ``before`` in which a stop may hold, else 0."""
        found = self.record.columns.possible_end(needed, self.first_tick, before)
        if found is None and self.parent is not None:
            return self.parent.possible_end(needed, min(before, self.first_tick))
        return found or 0

    @property
    def writes_from(self) -> int:
        """The first tick from which on all writes are recorded."""
        inherited = 0 if self.parent is None else self.parent.writes_from
        return max(self.record.columns.writes_from, min(inherited, self.first_tick))

    def ticks_between(self, requested: EventFilter, after: int, before: int) -> list[int]:
        """Return the ticks between two ticks that have such events."""
        found: list[int] = []
        if self.parent is not None and after + 1 < self.first_tick:
            found = self.parent.ticks_between(requested, after, min(before, self.first_tick))
        return found + self.record.ticks_between(requested, after, before)


def index_of(inputs: Sequence[Input], tick: int) -> int:
    """Return the index of the first input of a tick or later, among inputs in order."""
    return bisect.bisect_left(inputs, tick, key=lambda one: one.tick)
