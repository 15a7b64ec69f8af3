# SPDX-License-Identifier: MIT
"""The time of a channel's decoder, where a schedule gives it (P-RTCF-00012, ``task_rnd``).

Blocks are decoded one after another while there is time. The last one is evaluated as it begins;
what it yields is held until its time is paid, maybe ticks later. Time that nobody needs is lost.
"""

from __future__ import annotations


class DecodeBudget:
    """``block_ns``: what one block takes. All times in ns."""

    def __init__(self, block_ns: int) -> None:
        self._block_ns = block_ns
        self._left_ns = 0
        self._ran = False

    def grant(self, time_ns: int) -> None:
        """So much time has the decoder had since the tick before."""
        self._left_ns = min(self._left_ns, 0) + time_ns
        self._ran = time_ns > 0

    def spend(self, blocks: int) -> None:
        """So many blocks were begun."""
        self._left_ns -= blocks * self._block_ns

    def forgive(self) -> None:
        """Another program begins: what the one before owed is over with it."""
        self._left_ns = max(self._left_ns, 0)

    @property
    def is_paid(self) -> bool:
        """Whether all blocks that were begun are decoded."""
        return self._left_ns >= 0

    @property
    def can_begin(self) -> bool:
        """Whether the decoder can begin another block now."""
        return self._ran and self._left_ns >= 0
