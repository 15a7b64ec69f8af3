# SPDX-License-Identifier: MIT
"""The window after an injection: from when on its expectations are decided, and by which values.

In: the expectations ``CONDITION within TIME`` of a plan, and the time of an injection. Out: the
ticks at which a run is looked at, whether it is decided there, and its outcome. Who looks at a run
does so at the same ticks after the injection, however it was made: so its row is the same.
"""

from __future__ import annotations

from array import array
from collections.abc import Iterator, Mapping, Sequence
from typing import overload

from nctakt.base.dataclass import dataclass
from nctakt.results.run import Run
from nctakt.studies.measuring.measure_nodes import Reaction
from nctakt.studies.measuring.outcome import Outcome
from nctakt.testing.verdict import signal_of

#: Ticks between two looks at a run, counted from its injection on.
LOOK_TICKS = 64


@dataclass(frozen=True, slots=True)
class Injection:
    """An injection at ``time_us``: ``tick`` takes it, before ``end`` its run is decided."""

    time_us: int
    tick: int
    end: int
    cycle_time_us: int
    reactions: tuple[Reaction, ...]

    def looks(self) -> Iterator[int]:
        """Yield the ticks at which the run is inspected; the last one is ``end``."""
        yield from range(self.tick + LOOK_TICKS, self.end, LOOK_TICKS)
        yield self.end

    def is_decided(self, outcome: Outcome) -> bool:
        """Return whether each condition has come, or is too late by now."""
        return all(self._is_over(reaction, outcome) for reaction in self.reactions)

    def _is_over(self, reaction: Reaction, outcome: Outcome) -> bool:
        limit_us = self.time_us + reaction.limit.us(self.cycle_time_us)
        values = outcome.values(reaction.condition.name)
        if (len(values) - 1) * self.cycle_time_us > limit_us:
            return True
        return reaction.condition.first_tick(outcome, self.tick) is not None


class ValuesFrom(Sequence[float]):
    """Values by their tick, of which those before the tick ``first`` are not there."""

    def __init__(self, first: int, values: Sequence[float]) -> None:
        self._first = first
        self._values = values

    def __len__(self) -> int:
        return self._first + len(self._values)

    @overload
    def __getitem__(self, index: int) -> float: ...

    @overload
    def __getitem__(self, index: slice) -> Sequence[float]: ...

    def __getitem__(self, index: int | slice) -> float | Sequence[float]:
        if isinstance(index, slice) or index < self._first:
            raise IndexError(index)
        return self._values[index - self._first]


class WindowOutcome(Outcome):
    """The outcome of a run that is known from its injection on.

    ``rows``: the values of ``signals`` at the begin of the injection's tick, then those of each
    tick from it on.
    """

    def __init__(
        self,
        run: Run,
        injection: Injection,
        signals: Sequence[str],
        rows: array[float],
    ) -> None:
        super().__init__(run, injection.time_us)
        self._injection = injection
        self._signals = signals
        self._rows = rows
        self._found: dict[str, array[float]] = {}

    def values(self, name: str) -> Sequence[float]:
        """Return the values of a signal from the injection on."""
        values, first_tick = self.course(name)
        return ValuesFrom(first_tick, values)

    def course(self, name: str) -> tuple[array[float], int]:
        """Return the values of a signal from the injection on, and its tick."""
        if name not in self._found:
            number = self._signals.index(signal_of(self.queries, name))
            self._found[name] = self._rows[number :: len(self._signals)]
        return self._found[name], self._injection.tick


def decided_run(ticks: int, cycle_time_us: int, before: Mapping[str, float]) -> Run:
    """Return the result of a run that was left after this many ticks, as far as rows name it."""
    return Run((), cycle_time_us, 0, ticks, "interrupted", before=before)
