# SPDX-License-Identifier: MIT
"""The decode time that a schedule grants a channel (P-RTCF-00012, ``task_rnd``).

Blocks are decoded in turn while there is time. The last one is evaluated as it begins; its commands
are held until its time has been granted, maybe ticks later. Unused time is lost.
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


class StepBudget(DecodeBudget):
    """A number of commands that the decoder may yield now, regardless of time.

    A decoder on a real clock is granted one command at a time; a tape has the number granted.
    """

    def __init__(self) -> None:
        super().__init__(0)
        self.steps = 0

    def grant(self, time_ns: int) -> None:
        """Allow this number of commands, and no more that were left."""
        self.steps = time_ns

    def spend(self, blocks: int) -> None:
        """Count a command."""
        self.steps -= 1

    def forgive(self) -> None:
        """Allow the next program nothing that was left."""
        self.steps = 0

    @property
    def is_paid(self) -> bool:
        """Whether a command can be queued: always."""
        return True

    @property
    def can_begin(self) -> bool:
        """Whether the decoder may give another command."""
        return self.steps > 0
