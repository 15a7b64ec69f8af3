# SPDX-License-Identifier: MIT
"""The signals between channels: sent and not yet used up.

``SignalBoard`` belongs to all channels of a machine. A signal is addressed to one channel or to all
(a broadcast, receiver 0). Channels count from 1; several of them are a mask, channel 3 as bit 3.
"""

from __future__ import annotations

from nctakt.kernel import codes
from nctakt.kernel.base.arrays import doubles, integers


def names_channel(mask: int, channel: int) -> int:
    """Return whether a mask names a channel; no channel, 0, is named by an empty mask."""
    if channel == 0:
        return 1 if mask == 0 else 0
    return (mask >> channel) & 1


class SignalBoard:
    """All open signals in the order in which they were sent.

    ``received``, ``received_mask``: values of the signals that were taken last, and which of them
    arrived; ``taken_sender``, ``taken_tick``: sender and tick of the last one of them.
    ``blocking``: the number of the signal ahead of the requested one. ``has_waited``: a channel has
    had to wait.
    """

    def __init__(self) -> None:
        self.count = 0
        self.number = integers(codes.SIGNAL_CAPACITY)
        self.sender = integers(codes.SIGNAL_CAPACITY)
        self.receiver = integers(codes.SIGNAL_CAPACITY)
        self.remaining = integers(codes.SIGNAL_CAPACITY)
        self.level = integers(codes.SIGNAL_CAPACITY)
        self.tick = integers(codes.SIGNAL_CAPACITY)
        self.mask = integers(codes.SIGNAL_CAPACITY)
        self.values = doubles(codes.SIGNAL_VALUES * codes.SIGNAL_CAPACITY)
        self.received = doubles(codes.SIGNAL_VALUES)
        self.received_mask = 0
        self.taken_sender = 0
        self.taken_tick = 0
        self.blocking = 0
        self.has_waited = False

    def send(
        self,
        number: int,
        sender: int,
        receivers: int,
        remaining: int,
        level: int,
        tick: int,
        mask: int,
        values: memoryview[float],
        first: int,
    ) -> int:
        """Add a signal for each of the receivers, or a broadcast; return 0 if there is no room.

        ``level``: 1 of a signal sent in the order of the blocks, 0 of one sent by the decoder. The
        values are in ``values`` from ``first`` on.
        """
        if receivers == 0:
            return self.add(number, sender, 0, remaining, level, tick, mask, values, first)
        for channel in range(1, codes.MAX_SIGNAL_CHANNEL + 1):
            if (receivers >> channel) & 1:
                if not self.add(
                    number, sender, channel, remaining, level, tick, mask, values, first
                ):
                    return 0
        return 1

    def add(
        self,
        number: int,
        sender: int,
        receiver: int,
        remaining: int,
        level: int,
        tick: int,
        mask: int,
        values: memoryview[float],
        first: int,
    ) -> int:
        """Add one signal; return 0 if there is no room."""
        if self.count >= codes.SIGNAL_CAPACITY:
            return 0
        slot = self.count
        self.number[slot] = number
        self.sender[slot] = sender
        self.receiver[slot] = receiver
        self.remaining[slot] = remaining
        self.level[slot] = level
        self.tick[slot] = tick
        self.mask[slot] = mask
        for i in range(codes.SIGNAL_VALUES):
            self.values[codes.SIGNAL_VALUES * slot + i] = values[first + i]
        self.count += 1
        return 1

    def state(self, number: int, receiver: int, senders: int, may_overtake: int) -> int:
        """Return whether all signals of this number that a channel waits for are there.

        ``senders`` 0: a broadcast. Signals of one sender to one channel are taken in the order in
        which they were sent, unless ``may_overtake``.
        """
        if senders == 0:
            is_there = self.find(number, receiver, 0) >= 0
            return codes.SIGNAL_THERE if is_there else codes.SIGNAL_ABSENT
        result = codes.SIGNAL_THERE
        for channel in range(1, codes.MAX_SIGNAL_CHANNEL + 1):
            if (senders >> channel) & 1:
                slot = self.find(number, receiver, channel)
                if slot < 0:
                    result = codes.SIGNAL_ABSENT
                elif not may_overtake and self.is_overtaking(slot):
                    return codes.SIGNAL_OVERTAKES
        return result

    def find(self, number: int, receiver: int, sender: int) -> int:
        """Return the slot of the oldest signal that fits, -1 without one."""
        for slot in range(self.count):
            if self.number[slot] == number:
                if sender == 0:
                    if self.receiver[slot] == 0:
                        return slot
                elif self.receiver[slot] == receiver and self.sender[slot] == sender:
                    return slot
        return -1

    def is_overtaking(self, slot: int) -> int:
        """Return whether another signal of the same channels and level was sent before."""
        for other in range(slot):
            if (
                self.receiver[other] == self.receiver[slot]
                and self.sender[other] == self.sender[slot]
                and self.level[other] == self.level[slot]
                and self.number[other] != self.number[slot]
            ):
                self.blocking = self.number[other]
                return 1
        return 0

    def take(self, number: int, receiver: int, senders: int) -> None:
        """Use up one signal of each sender, which are all there."""
        self.received_mask = 0
        for channel in range(codes.MAX_SIGNAL_CHANNEL + 1):
            is_asked = names_channel(senders, channel)
            if is_asked:
                slot = self.find(number, receiver, channel)
                if slot >= 0:
                    self.use(slot)

    def use(self, slot: int) -> None:
        """Take the values of a signal, and count it as used once more."""
        for i in range(codes.SIGNAL_VALUES):
            if (self.mask[slot] >> i) & 1:
                self.received[i] = self.values[codes.SIGNAL_VALUES * slot + i]
        self.received_mask |= self.mask[slot]
        self.taken_sender = self.sender[slot]
        self.taken_tick = self.tick[slot]
        if self.remaining[slot] > 0:
            self.remaining[slot] -= 1
            if self.remaining[slot] == 0:
                self.drop(slot)

    def drop(self, slot: int) -> None:
        """Remove one signal; the others keep their order."""
        self.count -= 1
        for i in range(slot, self.count):
            following = i + 1
            self.number[i] = self.number[following]
            self.sender[i] = self.sender[following]
            self.receiver[i] = self.receiver[following]
            self.remaining[i] = self.remaining[following]
            self.level[i] = self.level[following]
            self.tick[i] = self.tick[following]
            self.mask[i] = self.mask[following]
            first = codes.SIGNAL_VALUES * i
            for k in range(codes.SIGNAL_VALUES):
                self.values[first + k] = self.values[first + codes.SIGNAL_VALUES + k]

    def remove(self, low: int, high: int, receivers: int, is_range: int) -> None:
        """Remove the oldest signal of this number, or all of a range of numbers.

        ``receivers`` 0: broadcasts; else those that are addressed to these channels.
        """
        for channel in range(codes.MAX_SIGNAL_CHANNEL + 1):
            is_asked = names_channel(receivers, channel)
            slot = 0
            while is_asked and slot < self.count:
                is_numbered = low <= self.number[slot] and self.number[slot] <= high
                if self.receiver[slot] == channel and is_numbered:
                    self.drop(slot)
                    if not is_range:
                        break
                else:
                    slot += 1

    def clear(self, receiver: int) -> None:
        """Remove the signals that are addressed to a channel."""
        slot = 0
        while slot < self.count:
            if self.receiver[slot] == receiver:
                self.drop(slot)
            else:
                slot += 1

    def open_signals(self) -> list[tuple[int, int, int, int]]:
        """Return number, sender, receiver (0: all) and tick of the open signals."""
        return [
            (self.number[i], self.sender[i], self.receiver[i], self.tick[i])
            for i in range(self.count)
        ]
