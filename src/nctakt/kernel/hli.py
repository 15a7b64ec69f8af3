# SPDX-License-Identifier: MIT
# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
# cython: initializedcheck=False, nonecheck=False, annotation_typing=False
"""The interface image between CNC and PLC: technology functions and their acknowledgement.

The realtime section (POS_RT) takes what realtime cycles command, in order, in the same tick, and
never waits: no free slot is an error (RC-403). The main program's functions go through a section
of their own, whose acknowledgement the program may wait for. What the PLC answers in tick n counts
from tick n+1: ``latch`` at the start of a tick moves the answers into force. Without a scripted PLC
the default one acknowledges everything in the tick in which it appears.
"""

from __future__ import annotations

#: Slots of the realtime section, P: a number of ours, no source gives one (RC-403).
SLOT_COUNT = 20

FREE = 0
WAITING = 1
ACKNOWLEDGED = 2


class Hli:
    """One channel's image.

    A technology function is named by its number; an H function by its negative number - 1, so that
    one number holds both and M0 differs from H0.
    """

    def __init__(self, slot_count: int = SLOT_COUNT) -> None:
        self.slot_count = slot_count
        self.slot_state = memoryview(bytearray(8 * slot_count)).cast("q")
        self.slot_function = memoryview(bytearray(8 * slot_count)).cast("q")
        self.slot_sequence = memoryview(bytearray(8 * slot_count)).cast("q")
        self.slot_tick = memoryview(bytearray(8 * slot_count)).cast("q")
        self.issued_in_tick = 0
        self.program_state = FREE
        self.program_function = 0
        self.waiting_count = 0
        self.acknowledges_itself = True
        self.operator_override_pct = 100.0
        self.feed_hold = False

    def latch(self) -> None:
        """Start of a tick: what the PLC has acknowledged is free from now on."""
        self.issued_in_tick = 0
        if self.waiting_count == 0:
            return
        if self.program_state == 2:
            self.program_state = 0
            self.waiting_count -= 1
        for i in range(self.slot_count):
            if self.slot_state[i] == 2:
                self.slot_state[i] = 0
                self.waiting_count -= 1

    def issue(self, function: int, tick: int) -> int:
        """Put a function of a realtime cycle into the image: its number within the tick.

        0 where the section holds no more in one tick (50943), -1 where no slot is free (50942).
        """
        if self.issued_in_tick >= self.slot_count:
            return 0
        slot = -1
        for i in range(self.slot_count):
            if self.slot_state[i] == 0:
                slot = i
                break
        if slot < 0:
            return -1
        self.issued_in_tick += 1
        self.waiting_count += 1
        self.slot_state[slot] = 1
        self.slot_function[slot] = function
        self.slot_sequence[slot] = self.issued_in_tick
        self.slot_tick[slot] = tick
        return self.issued_in_tick

    def issue_program(self, function: int) -> int:
        """Put a function of the main program into the image; 0 while the one before it waits."""
        if self.program_state != 0:
            return 0
        self.program_state = 1
        self.program_function = function
        self.waiting_count += 1
        return 1

    def run_default_plc(self) -> None:
        """The PLC phase of a tick, where no script plays the PLC: acknowledge everything."""
        if self.waiting_count == 0 or not self.acknowledges_itself:
            return
        if self.program_state == 1:
            self.program_state = 2
        for i in range(self.slot_count):
            if self.slot_state[i] == 1:
                self.slot_state[i] = 2

    def entries(self) -> list[tuple[int, int, int, int]]:
        """The realtime section's waiting functions: (slot, function, number in its tick, tick)."""
        found = [
            (
                i,
                self.slot_function[i],
                self.slot_sequence[i],
                self.slot_tick[i],
            )
            for i in range(self.slot_count)
            if self.slot_state[i] == 1
        ]
        found.sort(key=lambda entry: (entry[3], entry[2]))
        return found

    def acknowledge(self, slot: int) -> None:
        """The PLC has taken the function of this slot."""
        assert 0 <= slot < self.slot_count
        if self.slot_state[slot] == 1:
            self.slot_state[slot] = 2

    def acknowledge_program(self) -> None:
        """The PLC has taken the main program's function."""
        if self.program_state == 1:
            self.program_state = 2

    def clear(self) -> None:
        """Reset: nothing waits any more."""
        for i in range(self.slot_count):
            self.slot_state[i] = 0
        self.program_state = 0
        self.waiting_count = 0
