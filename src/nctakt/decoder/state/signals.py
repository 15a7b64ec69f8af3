# SPDX-License-Identifier: MIT
"""The signals between channels as a decoder reaches them, at once and not in the tick."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol


class DecoderSignals(Protocol):
    """The signals of one channel; channels are masks as in ``kernel/tick/signals.py``.

    ``channel_count``: the number of channels of the machine.
    """

    channel_count: int

    def send(
        self,
        source: int,
        signal: int,
        receivers: int,
        count: int,
        mask: int,
        values: Sequence[float],
    ) -> bool:
        """Send a signal; return whether there was room for it."""

    def remove(self, low: int, high: int, receivers: int, *, is_range: bool) -> None:
        """Remove the oldest signal of this number, or all of a range."""

    def read(self, source: int, signal: int, senders: int) -> tuple[float, ...]:
        """Take a signal: the mask of its values and the values; empty if it is not there.

        -1 in place of the mask, and its number, if another one has to be taken before.
        """
