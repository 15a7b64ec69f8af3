# SPDX-License-Identifier: MIT
"""Axes that follow others: pairs of a slave and its master (``#AX LINK``, gantries of the lists).

The command of a slave is its position when the pair began, plus a factor times the distance its
master has moved since then. The pairs of the lists come first and are computed last, since their
masters may be slaves of a program.
"""

from __future__ import annotations

import math

from nctakt.kernel.base.arrays import doubles, integers
from nctakt.kernel.base.bounds import check_index, check_size


class Couplings:
    """The ``count`` pairs of a machine, of which ``fixed_count`` come from its lists.

    ``closed``: axes that accept no independent motion. ``watched_count``: pairs whose actual
    positions are compared; ``allowed_d``: how far they may differ, 0: no limit.
    """

    def __init__(self, axis_count: int) -> None:
        check_size(axis_count, "number of axes")
        self.axis_count = axis_count
        self.count = 0
        self.fixed_count = 0
        self.watched_count = 0
        self.slave = integers(axis_count)
        self.master = integers(axis_count)
        self.factor = doubles(axis_count)
        self.slave_begin = doubles(axis_count)
        self.master_begin = doubles(axis_count)
        self.allowed_d = doubles(axis_count)
        self.closed = integers(axis_count)

    def pair_of(self, slave: int) -> int:
        """Return the number of the pair in which an axis is the slave, -1 for none."""
        for k in range(self.count):
            if self.slave[k] == slave:
                return k
        return -1

    def couple(
        self,
        slave: int,
        master: int,
        factor: float,
        allowed_d: float,
        slave_position: float,
        master_position: float,
    ) -> None:
        """Let an axis follow another from these positions on, in place of any earlier master."""
        self.uncouple(slave)
        k = self.count
        self.slave[k] = slave
        self.master[k] = master
        self.factor[k] = factor
        self.allowed_d[k] = allowed_d
        self.slave_begin[k] = slave_position
        self.master_begin[k] = master_position
        self.count += 1
        self.close_axes()

    def uncouple(self, slave: int) -> None:
        """Stop an axis from following another; pairs of the lists stay."""
        k = self.pair_of(slave)
        if k < self.fixed_count:
            return
        self.count -= 1
        last = self.count
        self.slave[k] = self.slave[last]
        self.master[k] = self.master[last]
        self.factor[k] = self.factor[last]
        self.allowed_d[k] = self.allowed_d[last]
        self.slave_begin[k] = self.slave_begin[last]
        self.master_begin[k] = self.master_begin[last]
        self.close_axes()

    def close_axes(self) -> None:
        """Note which axes accept no independent motion, and which pairs are watched."""
        for i in range(self.axis_count):
            self.closed[i] = 0
        self.watched_count = 0
        for k in range(self.count):
            self.closed[self.slave[k]] = 1
            if k >= self.fixed_count:
                self.closed[self.master[k]] = 1
            if self.allowed_d[k] > 0.0:
                self.watched_count += 1

    def follow(self, k: int, master_position: float) -> float:
        """Return where the slave of pair ``k`` is when its master is at a position."""
        return self.slave_begin[k] + self.factor[k] * (master_position - self.master_begin[k])

    def is_askew(self, k: int, slave_position: float, master_position: float) -> int:
        """Return whether two actual positions differ by more than is allowed."""
        if self.allowed_d[k] == 0.0:
            return 0
        difference = slave_position - self.follow(k, master_position)
        return 1 if math.fabs(difference) > self.allowed_d[k] else 0

    # --- Python's side --------------------------------------------------------------------------

    def check(self, slave: int, master: int) -> None:
        """Raise ``ValueError`` if an axis cannot follow another."""
        check_index(slave, self.axis_count, "axis")
        check_index(master, self.axis_count, "axis")
        if slave == master or 0 <= self.pair_of(slave) < self.fixed_count:
            raise ValueError(f"axis {slave} cannot follow axis {master}")

    def fix(self, slave: int, master: int, allowed_d: float, offset: float) -> None:
        """Let an axis follow another forever, ``offset`` away from it; before the first tick."""
        self.check(slave, master)
        self.fixed_count += 1
        self.couple(slave, master, 1.0, allowed_d, offset, 0.0)
