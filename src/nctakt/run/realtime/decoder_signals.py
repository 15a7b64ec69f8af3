# SPDX-License-Identifier: MIT
"""The signals of a channel's decoder: sent, taken and removed between two ticks."""

from __future__ import annotations

import struct
from collections.abc import Sequence

from nctakt.kernel.kernel import Kernel
from nctakt.kernel.tick.channel import Channel


class SignalsOfChannel:
    """The signals of the channel with this index, from 0 (``DecoderSignals``)."""

    def __init__(self, kernel: Kernel, channels: Sequence[Channel], index: int) -> None:
        self._kernel = kernel
        self._signals = channels[index].signals
        self.channel_count = len(channels)

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
        data = bytearray(struct.pack(f"={len(values)}d", *values))
        return self._signals.send(source, self._kernel.tick, signal, receivers, count, mask, data)

    def remove(self, low: int, high: int, receivers: int, *, is_range: bool) -> None:
        """Remove the oldest signal of this number, or all of a range."""
        self._signals.remove(low, high, receivers, is_range)

    def read(self, source: int, signal: int, senders: int) -> tuple[float, ...]:
        """Take a signal: the mask of its values and the values; empty if it is not there."""
        return self._signals.read(source, self._kernel.tick, signal, senders, False)
