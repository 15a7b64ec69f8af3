# SPDX-License-Identifier: MIT
"""Axes and spindles that follow others: the groups of ``#AX LINK``, and those that are active.

The tick moves a slave (``kernel/axes/couplings.py``); segments leave it where the decoder has seen
it last.
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.base.dataclass import dataclass, field
from nctakt.decoder.state.queued.commands import Command
from nctakt.kernel import rows


@dataclass(frozen=True, slots=True)
class CoupledPair:
    """A pair of a group: numbers of axes in the machine, or indices of the channel's spindles.

    ``allowed_d``: mm or degrees that their actual positions may differ, 0: no limit.
    """

    slave: int
    master: int
    factor: float = 1.0
    allowed_d: float = 0.0
    is_spindle: bool = False

    @property
    def members(self) -> tuple[tuple[bool, int], tuple[bool, int]]:
        """Slave and master, each with whether it is a spindle."""
        return (self.is_spindle, self.slave), (self.is_spindle, self.master)

    @property
    def axes(self) -> tuple[int, ...]:
        """Both numbers of axes; nothing for spindles."""
        return () if self.is_spindle else (self.slave, self.master)


@dataclass(frozen=True, slots=True)
class CoupledPlaces:
    """Two axes of the channel by their places, and where they were when they were coupled."""

    slave: int
    master: int
    factor: float
    slave_begin: float
    master_begin: float

    def position(self, master: float) -> float:
        """Return where the slave is when the master is at a position, as in the tick."""
        return self.slave_begin + self.factor * (master - self.master_begin)


@dataclass(slots=True)
class ActiveCouplings:
    """The active groups of a program in their order, with their pairs, and pairs of axes."""

    groups: dict[int, tuple[CoupledPair, ...]] = field(default_factory=dict)
    places: dict[int, tuple[CoupledPlaces, ...]] = field(default_factory=dict)

    @property
    def of_axes(self) -> list[CoupledPlaces]:
        """All pairs of axes."""
        return [pair for pairs in self.places.values() for pair in pairs]

    def master_of(self, slot: int) -> int:
        """Return the place of the master that an axis follows; -1 for none."""
        return next((pair.master for pair in self.of_axes if pair.slave == slot), -1)

    def spindles(self, master: int) -> list[int]:
        """Return the spindles that follow a spindle."""
        return [one.slave for one in self._of_spindles() if one.master == master]

    def master_of_spindle(self, slave: int) -> int:
        """Return the spindle that a spindle follows; -1 for none."""
        return next((one.master for one in self._of_spindles() if one.slave == slave), -1)

    def _of_spindles(self) -> list[CoupledPair]:
        return [one for group in self.groups.values() for one in group if one.is_spindle]

    def positions(self, positions: Sequence[float]) -> Sequence[float]:
        """Return positions of all axes, with slaves where they follow their masters."""
        if not self.places:
            return positions
        shown = list(positions)
        for pair in self.of_axes:
            shown[pair.slave] = pair.position(positions[pair.master])
        return shown


@dataclass(slots=True)
class KeptCouplings:
    """State that outlives a program: the defined groups, and those that were active.

    ``last``: the group that is active or was so last. ``after_reset``, ``after_end``: whether the
    next program couples again the group coupled then (P-CHAN-00104, 00105).
    """

    groups: dict[int, tuple[CoupledPair, ...]]
    after_reset: bool
    after_end: bool
    last: int = 0
    active: list[int] = field(default_factory=list)
    left: list[int] = field(default_factory=list)

    def enable(self, group: int) -> None:
        """Note a group that is active from here on."""
        self.active.append(group)
        self.last = group

    def disable(self, group: int) -> None:
        """Note a group that is active no more."""
        self.active.remove(group)

    def end_program(self) -> None:
        """Note the groups that are active at the end of a program."""
        self.left = list(self.active) if self.after_end else []

    def take_restored(self) -> list[int]:
        """Return the groups that a program is to couple at its start."""
        left, self.left = self.left, []
        if self.active:  # a reset has ended the program before
            left = self.active if self.after_reset else []
            self.active = []
        return left


@dataclass(frozen=True, slots=True)
class Couple(Command):
    """An axis follows another from here on; ``master``: -1 for none. Numbers in the machine.

    ``allowed_d``: mm or degrees that their actual positions may differ, 0: any way.
    """

    packed_as = rows.COUPLE

    slave: int
    master: int
    factor: float = 1.0
    allowed_d: float = 0.0
