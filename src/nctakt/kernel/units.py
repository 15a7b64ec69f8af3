# SPDX-License-Identifier: MIT
# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
# cython: initializedcheck=False, nonecheck=False, annotation_typing=False, auto_pickle=False
"""Technology functions in the image of the HLI: the slots of sections as a PLC sees them.

A unit takes 32 bytes (``UNIT`` in ``hli/layout.py``). Its serial says which function it holds, 0
none; it is written last. The PLC acknowledges by writing the serial into its own place of the slot,
so that each byte has one writer.
"""

from __future__ import annotations

from nctakt.kernel.hli import Section


class Units:
    """The sections of all channels as a chain, since the tick cannot walk through a list.

    The base is the null object at the chain's end.
    """

    def latch(self) -> None:
        """Take over what the PLC has acknowledged."""

    def publish(self) -> None:
        """Show the slots that have changed."""


class SectionUnits(Units):
    """The units of one section, and those behind it.

    ``first``: the first byte of the units in the image, ``acknowledged``: of the PLC's serials;
    ``published`` are the bytes of the image that the tick knows.
    """

    def __init__(
        self,
        section: Section,
        image: memoryview,
        published: memoryview,
        first: int,
        acknowledged: int,
        cycle_time_us: int,
        others: Units,
    ) -> None:
        self.section = section
        self.halves = image.cast("i")
        self.words = image.cast("q")
        self.published = published.cast("i")
        self.first = first // 4
        self.acknowledged = acknowledged // 4
        self.cycle_time_us = cycle_time_us
        self.others = others
        self.version = -1

    def latch(self) -> None:
        for i in range(self.section.slot_count):
            serial = self.halves[self.acknowledged + i]
            self.published[self.acknowledged + i] = serial
            if self.section.state[i] == 1 and self.section.serial[i] == serial:
                self.section.state[i] = 2
        self.others.latch()

    def publish(self) -> None:
        if self.version != self.section.version:
            self.version = self.section.version
            for i in range(self.section.slot_count):
                self.put(i)
        self.others.publish()

    def put(self, slot: int) -> None:
        """Write one slot."""
        first = self.first + 8 * slot
        if self.section.state[slot] == 0:
            self.halves[first] = 0
            return
        function = self.section.function[slot]
        word = (first + 4) >> 1
        self.halves[first + 1] = 1 if function >= 0 else 2
        self.halves[first + 2] = function if function >= 0 else -function - 1
        self.halves[first + 3] = self.section.sequence[slot]
        self.words[word] = self.section.tick[slot] * self.cycle_time_us
        ticks = self.section.done[slot] - self.section.tick[slot]
        self.words[word + 1] = ticks * self.cycle_time_us
        self.halves[first] = self.section.serial[slot]
