# SPDX-License-Identifier: MIT
"""The decode time that a schedule grants a channel (P-RTCF-00012, ``task_rnd``).

Blocks are decoded one after another while there is time. The last one is evaluated as it begins;
its commands are held until its time has been granted, maybe ticks later. Unused time is lost.
"""

from __future__ import annotations


class DecodeBudget:
    """The decode time left; ``block_ns``: the time for one block. All times in ns."""

    def __init__(self, block_ns: int) -> None:
        self._block_ns = block_ns
        self._left_ns = 0
        self._ran = False

    def grant(self, time_ns: int) -> None:
        """Add the decode time granted since the previous tick."""
        self._left_ns = min(self._left_ns, 0) + time_ns
        self._ran = time_ns > 0

    def spend(self, blocks: int) -> None:
        """Subtract the time for this number of blocks, which have been begun."""
        self._left_ns -= blocks * self._block_ns

    def forgive(self) -> None:
        """Cancel the debt of the previous program."""
        self._left_ns = max(self._left_ns, 0)

    @property
    def is_paid(self) -> bool:
        """Whether time has been granted for all blocks that were begun."""
        return self._left_ns >= 0

    @property
    def can_begin(self) -> bool:
        """Whether the decoder may begin another block now."""
        return self._ran and self._left_ns >= 0
