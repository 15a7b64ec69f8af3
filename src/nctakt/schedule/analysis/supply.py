# SPDX-License-Identifier: MIT
"""The time that suspendable threads can have on a processor that runs Windows.

In: ``Model``. Out: bounds over all phases and jitter that the model leaves open. A cycle of length
L has min(A, L) for suspendable threads, A being the distance from its NC interrupt to the point of
suspension (``suspension_point``). Times in ns.
"""

from __future__ import annotations

from math import gcd

from nctakt.base.dataclass import dataclass
from nctakt.lists.declared.rtconf import InterruptSource
from nctakt.schedule.model import Model


@dataclass(frozen=True, slots=True)
class Offsets:
    """The distance from the NC interrupt to the suspension: least and greatest, in ns.

    ``earliest_phase`` and ``latest_phase`` are the phases that have them, in ns; ``None`` if the
    phase is known or any phase has them.
    """

    earliest: int
    latest: int
    earliest_phase: int | None = None
    latest_phase: int | None = None


def suspension_offsets(model: Model) -> Offsets:
    """Return the bounds of the distance from the NC interrupt to the suspension."""
    before = model.cycle - model.windows
    if before <= 0:
        return Offsets(0, 0)
    if model.source is InterruptSource.TIMER:
        return Offsets(before, before)
    step = 1 if model.train.jitter else gcd(model.train.distance, model.slice)
    counts_ticks = model.rules.suspension == "ticks"
    if model.train.jitter or (not model.train.is_phase_known and step == 1):
        spread = model.slice - 1
        return (
            Offsets(before - spread, before) if counts_ticks else Offsets(before, before + spread)
        )
    if not model.train.is_phase_known:
        return _over_all_phases(before, step, model.slice, counts_ticks=counts_ticks)
    # The NC interrupts fall on the phase after a timer interrupt, and on all steps from it on.
    spread = model.slice - step
    if counts_ticks:
        latest = before - model.train.phase % step
        return Offsets(latest - spread, latest)
    earliest = before + -(model.train.phase + before) % step
    return Offsets(earliest, earliest + spread)


def _over_all_phases(before: int, step: int, slice_: int, *, counts_ticks: bool) -> Offsets:
    """Return the bounds where NC interrupts come in steps after an unknown phase."""
    if counts_ticks:
        return Offsets(before - slice_ + 1, before, step - 1, 0)
    return Offsets(before, before + slice_ - 1, -before % step, (1 - before) % step)


class Supply:
    """The time that suspendable threads can have from an NC interrupt on."""

    def __init__(self, model: Model, offsets: Offsets) -> None:
        self._distance = model.train.distance
        self._spread = 2 * model.train.jitter
        self._earliest = offsets.earliest
        self._latest = offsets.latest

    @property
    def min_per_cycle(self) -> int:
        """The minimum supply in a cycle of the mean length, in ns."""
        return min(self._earliest, self._distance)

    def moment(self, amount: int) -> int:
        """Return the latest time in ns by which ``amount`` ns (> 0) are supplied; some must be."""
        cycles = self._max_cycles_below(amount)
        return amount + self._longest_loss(cycles)

    def maximum(self, length: int) -> int:
        """Return the maximum supply within ``length``, both in ns."""
        cycles, rest = divmod(length + self._spread, self._distance)
        return min(length, cycles * self._latest + min(rest, self._latest))

    def _lengths(self, cycles: int) -> tuple[int, int, int]:
        """Return the numbers of long, short and usual cycles among ``cycles`` that alternate.

        Two long cycles never follow each other without a short one between them, nor two short ones
        without a long one. The loss of a cycle is convex in its length, so nothing loses more.
        """
        maximum = (cycles + 1) // 2
        return maximum, max(0, maximum - 1), cycles - 2 * maximum + 1 if cycles else 0

    def _longest_loss(self, cycles: int) -> int:
        """Return the most that as many whole cycles keep from suspendable threads."""
        long, short, usual = self._lengths(cycles)
        return (
            long * self._loss(self._distance + self._spread)
            + short * self._loss(self._distance - self._spread)
            + usual * self._loss(self._distance)
        )

    def _loss(self, length: int) -> int:
        return max(0, length - self._earliest)

    def _min(self, cycles: int) -> int:
        """Return the least time of as many whole cycles."""
        short, long, usual = self._lengths(cycles)
        return (
            long * min(self._earliest, self._distance + self._spread)
            + short * min(self._earliest, self._distance - self._spread)
            + usual * self.min_per_cycle
        )

    def _max_cycles_below(self, amount: int) -> int:
        """Return how many whole cycles can have less than ``amount``, at most."""
        shortest, longest = self._distance - self._spread, self._distance + self._spread
        of_two = min(self._earliest, shortest) + min(self._earliest, longest)
        cycles = 2 * ((amount - 1) // of_two)
        while self._min(cycles + 1) < amount:
            cycles += 1
        return cycles
