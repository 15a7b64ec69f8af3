# SPDX-License-Identifier: MIT
"""Units that wait for a PLC in the image of the HLI: M and H functions, jobs of its spindles.

A unit (``cells.UNIT_SERIAL`` …) is defined as ``UNIT`` in ``hli/layout.py``. Its serial, written
last, identifies the function in it, 0: none. The PLC acknowledges by writing the serial into its
part of the slot, so that each byte has one writer. A spindle's job goes the same way, in
``SPINDLE`` and ``SPINDLE_COMMAND``.
"""

from __future__ import annotations

from nctakt.kernel import cells, codes
from nctakt.kernel.axes.spindles import Spindles
from nctakt.kernel.base.bounds import check_range
from nctakt.kernel.plc.image_bytes import ImageBytes
from nctakt.kernel.plc.technology_slots import FunctionTable, Section


class Units:
    """The sections of all channels as a chain, since the tick cannot walk through a list.

    The base is the null object at the chain's end.
    """

    def latch(self) -> None:
        """Take over the PLC's acknowledgements."""

    def publish(self) -> None:
        """Show the slots that have changed."""


class SectionUnits(Units):
    """The units of one section, and those after it.

    ``first``: the first byte of the units in the image, ``acknowledged``: of the PLC's serials;
    ``identifier``: ``cells.POS_RT`` for functions of realtime cycles. ``types``: the bits of each
    function's synchronisation type, which counts for the program's functions.
    """

    def __init__(
        self,
        section: Section,
        shown: ImageBytes,
        first: int,
        acknowledged: int,
        cycle_time_us: int,
        identifier: int,
        types: FunctionTable,
        others: Units,
    ) -> None:
        units = 4 * cells.UNIT_WIDTH * section.slot_count
        check_range(first, 0, shown.count - units, "first byte")
        check_range(acknowledged, 0, shown.count - 4 * section.slot_count, "first byte")
        self.section = section
        self.identifier = identifier
        self.types = types
        self.shown = shown
        self.first = first // 4
        self.acknowledged = acknowledged // 4
        self.cycle_time_us = cycle_time_us
        self.others = others
        self.version = -1

    def latch(self) -> None:
        for i in range(self.section.slot_count):
            serial = self.shown.halves[self.acknowledged + i]
            self.shown.published_halves[self.acknowledged + i] = serial
            if self.section.state[i] == codes.WAITING and self.section.serial[i] == serial:
                self.section.state[i] = codes.ACKNOWLEDGED
        self.others.latch()

    def publish(self) -> None:
        if self.version != self.section.version:
            self.version = self.section.version
            for i in range(self.section.slot_count):
                self.put(i)
        self.others.publish()

    def put(self, slot: int) -> None:
        """Write one slot."""
        first = self.first + cells.UNIT_WIDTH * slot
        if self.section.state[slot] == codes.FREE:
            self.shown.halves[first + cells.UNIT_SERIAL] = 0
            return
        function = self.section.function[slot]
        word = (first + cells.UNIT_TIMES) >> 1
        synchronisation = cells.MOS
        if function >= codes.FIRST_T:
            self.shown.halves[first + cells.UNIT_LETTER] = cells.LETTER_T
            self.shown.halves[first + cells.UNIT_NUMBER] = function - codes.FIRST_T
            synchronisation = self.types.of(function)
        elif function >= 0:
            self.shown.halves[first + cells.UNIT_LETTER] = cells.LETTER_M
            self.shown.halves[first + cells.UNIT_NUMBER] = function
            if self.identifier != cells.POS_RT:
                synchronisation = self.types.of(function)
        else:
            number = -function - 1
            self.shown.halves[first + cells.UNIT_LETTER] = cells.LETTER_H
            self.shown.halves[first + cells.UNIT_NUMBER] = number
            if self.identifier != cells.POS_RT:
                synchronisation = self.types.of(function)
        self.shown.halves[first + cells.UNIT_AXIS] = self.section.area[slot]
        self.shown.halves[first + cells.UNIT_IDENTIFIER] = self.identifier
        self.shown.halves[first + cells.UNIT_SYNCHRONISATION] = synchronisation
        self.shown.halves[first + cells.UNIT_SEQUENCE] = self.section.sequence[slot]
        self.shown.halves[first + cells.UNIT_VALUE] = self.section.value[slot]
        self.shown.words[word + cells.IMAGE_TIME] = self.section.tick[slot] * self.cycle_time_us
        ticks = self.section.done[slot] - self.section.tick[slot]
        self.shown.words[word + cells.IMAGE_DURATION] = ticks * self.cycle_time_us
        self.shown.halves[first + cells.UNIT_SERIAL] = self.section.serial[slot]


class SpindleUnits(Units):
    """The jobs of a channel's PLC spindles, and the units after them.

    ``job``: the byte of the first spindle's ``job`` in the image, ``acknowledged`` that of its
    ``ack_job``; the next ones are ``size`` and ``answer_size`` bytes further.
    """

    def __init__(
        self,
        spindles: Spindles,
        shown: ImageBytes,
        job: int,
        size: int,
        acknowledged: int,
        answer_size: int,
        cycle_time_us: int,
        others: Units,
    ) -> None:
        last = max(0, spindles.count - 1)
        job_bytes = 4 * cells.SPINDLE_JOB_TIMES + 8 * (cells.IMAGE_POSITION + 1)
        for stride in (size, answer_size):
            check_range(stride, 0, shown.count, "size")
        check_range(job, 0, shown.count - last * size - job_bytes, "first byte")
        check_range(acknowledged, 0, shown.count - last * answer_size - 4, "first byte")
        self.spindles = spindles
        self.shown = shown
        self.job = job // 4
        self.stride = size // 4
        self.acknowledged = acknowledged // 4
        self.answer_stride = answer_size // 4
        self.cycle_time_us = cycle_time_us
        self.others = others
        self.version = -1

    def latch(self) -> None:
        for i in range(self.spindles.count):
            answer = self.acknowledged + self.answer_stride * i
            serial = self.shown.halves[answer]
            self.shown.published_halves[answer] = serial
            if self.spindles.plc_state[i] == codes.WAITING and self.spindles.job[i] == serial:
                self.spindles.plc_state[i] = codes.ACKNOWLEDGED
        self.others.latch()

    def publish(self) -> None:
        if self.version != self.spindles.version:
            self.version = self.spindles.version
            for i in range(self.spindles.count):
                self.put(i)
        self.others.publish()

    def put(self, i: int) -> None:
        """Write the job of one spindle."""
        first = self.job + self.stride * i
        if self.spindles.plc_state[i] == codes.FREE:
            self.shown.halves[first + cells.SPINDLE_JOB] = 0
            return
        self.shown.halves[first + cells.SPINDLE_JOB_FUNCTION] = self.spindles.function[i]
        direction = self.spindles.direction[i]
        if direction < 0:
            direction = cells.SPINDLE_JOB_BACKWARD
        self.shown.halves[first + cells.SPINDLE_JOB_DIRECTION] = direction
        word = (first + cells.SPINDLE_JOB_TIMES) >> 1
        self.shown.words[word + cells.IMAGE_TIME] = self.spindles.taken_tick[i] * self.cycle_time_us
        ticks = self.spindles.done_tick[i] - self.spindles.taken_tick[i]
        self.shown.words[word + cells.IMAGE_DURATION] = ticks * self.cycle_time_us
        self.shown.reals[word + cells.IMAGE_SPEED] = self.spindles.commanded_v[i] / 6.0
        self.shown.reals[word + cells.IMAGE_POSITION] = self.spindles.commanded_position[i]
        self.shown.halves[first + cells.SPINDLE_JOB] = self.spindles.job[i]
