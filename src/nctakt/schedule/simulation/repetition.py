# SPDX-License-Identifier: MIT
"""Finds out that a schedule repeats itself, and counts the rest of it.

In: the state at the start of each hyperperiod. Out: how many cycles need no simulation, their
numbers added. Only for models without chance, where equal states have equal futures. One state is
kept, a newer one after 1, 2, 4, 8 … hyperperiods (Brent), so that memory is constant.
"""

from __future__ import annotations

from typing import Protocol

from nctakt.schedule.model import Model
from nctakt.schedule.simulation.counters import Counters
from nctakt.schedule.simulation.results import Snapshot


class RepeatingState(Protocol):
    """The part of the scheduler's state that shows a repetition and can be moved in time."""

    @property
    def hyperperiod(self) -> int:
        """Return the number of cycles after which all periods begin together again."""

    @property
    def model(self) -> Model:
        """The threads and processors of the schedule."""

    @property
    def counters(self) -> Counters:
        """The numbers counted so far."""

    def key(self, now: int) -> tuple[object, ...]:
        """Return the state that decides the future, relative to the time ``now`` in ns."""

    def shift(self, distance: int) -> None:
        """Move all pending times by ``distance`` ns."""


class Repetition:
    """Looks for a state of the schedule that has occurred before."""

    def __init__(self) -> None:
        #: After how many cycles the schedule repeats, and from which cycle on, once that is known.
        self.period: int | None = None
        self.begin: int | None = None
        self._first: tuple[object, ...] | None = None
        self._kept: tuple[object, ...] | None = None
        self._cycle = 0
        self._numbers: Snapshot | None = None
        self._patience = 1
        self._seen = 0

    def note_start(self, state: RepeatingState, now: int) -> None:
        """Keep the state at the start of the first cycle, too: the schedule may come back to it."""
        self._first = state.key(now)

    def cycles_to_skip(self, state: RepeatingState, cycle: int, cycles: int, now: int) -> int:
        """Count and return the remaining cycles that are whole repetitions."""
        if self.period is not None or cycle % state.hyperperiod:
            return 0
        key = state.key(now)
        if key == self._kept and self._numbers is not None:
            self.begin = 0 if key == self._first else self._cycle
            self.period = cycle - self._cycle
            times = (cycles - cycle) // self.period
            state.counters.repeat(self._numbers, times)
            skipped = times * self.period
            state.shift(skipped * state.model.train.distance)
            return skipped
        self._seen += 1
        if self._kept is None or self._seen == self._patience:
            self._kept, self._cycle = key, cycle
            self._numbers = state.counters.snapshot()
            self._patience, self._seen = 2 * self._patience, 0
        return 0
