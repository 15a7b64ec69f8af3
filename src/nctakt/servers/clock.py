# SPDX-License-Identifier: MIT
"""The times of ticks: the same in all protocols.

In: the moment at which a tick begins, once. Out: the UTC of any tick, and the ticks of a UTC.
"""

from __future__ import annotations

import time
from datetime import UTC, datetime, timedelta

#: 100 ns from 1601, where FILETIME and the times of OPC UA begin, to 1970.
FILETIME_1970 = 116_444_736_000_000_000

_EPOCH = datetime(1970, 1, 1, tzinfo=UTC)
_MICROSECOND = timedelta(microseconds=1)


class MachineClock:
    """The UTC of ticks: that of tick 0, and the cycle times since then."""

    def __init__(self, cycle_time_us: int) -> None:
        self.cycle_time_us = cycle_time_us
        self.begin(0)

    def begin(self, tick: int) -> None:
        """Let a tick begin now, at a whole millisecond: clients round finer times."""
        now_us = time.time_ns() // 1_000_000 * 1000
        self._begin_us = now_us - tick * self.cycle_time_us

    def unix_us(self, tick: int) -> int:
        """Return the time at which a tick begins, in microseconds since 1970."""
        return self._begin_us + tick * self.cycle_time_us

    def filetime(self, tick: int) -> int:
        """Return the time at which a tick begins as FILETIME, the unit of ADS and OPC UA."""
        return FILETIME_1970 + self.unix_us(tick) * 10

    def time(self, tick: int) -> datetime:
        """Return the time at which a tick begins."""
        return _EPOCH + timedelta(microseconds=self.unix_us(tick))

    def text(self, tick: int) -> str:
        """Return the time at which a tick begins, as ISO 8601 with microseconds and ``Z``."""
        return self.time(tick).strftime("%Y-%m-%dT%H:%M:%S.%fZ")

    def tick_at(self, moment: datetime, *, is_end: bool = False) -> int:
        """Return the first tick at a time or later, of an end the last one; below 0: before all."""
        distance_us = (moment - _EPOCH) // _MICROSECOND - self._begin_us
        if is_end:
            return distance_us // self.cycle_time_us
        return -(-distance_us // self.cycle_time_us)
