# SPDX-License-Identifier: MIT
"""Technology units of the interface in a PLC's memory: functions waiting for the PLC (ST-763).

A function for an area that a PLC has announced occupies a unit there until a ``done_w``
acknowledges it; without an announcement it acknowledges itself after its time.
"""

from __future__ import annotations

from nctakt.kernel import cells, codes
from nctakt.kernel.axes.spindles import Spindles
from nctakt.kernel.base import arithmetic
from nctakt.kernel.base.arrays import integers
from nctakt.kernel.base.bounds import check_range
from nctakt.kernel.plc.technology_slots import FunctionTable, Hli, Section
from nctakt.kernel.st import kinds, words
from nctakt.kernel.st.context import PlcContext


class UnitBanks:
    """Arrays of units in a memory, and which of their units are taken.

    ``context``: the PLC whose memory it is. A row: address of the first unit, number of units,
    bytes from one to the next, address of the number in use (0: none), area. ``announced``: for
    each area, whether a PLC is there for it; ``since``: the tick whose end it was there at first,
    -1: before the first one, -2: it never was.
    """

    def __init__(
        self,
        context: PlcContext,
        rows: list[tuple[int, int, int, int, int]],
        areas: int,
    ) -> None:
        self.context = context
        self.memory = memoryview(context.memory)
        self.count = len(rows)
        self.area_count = areas
        self.announced = integers(areas + 1)
        self.since = integers(areas + 1)
        for i in range(areas):
            self.since[i] = -2
        self.first = integers(len(rows) + 8)
        self.units = integers(len(rows) + 8)
        self.stride = integers(len(rows) + 8)
        self.used = integers(len(rows) + 8)
        self.area = integers(len(rows) + 8)
        self.taken = integers(cells.TECHNO_UNITS * len(rows) + 8)
        end = context.end
        for i, (first, units, stride, used, area) in enumerate(rows):
            check_range(first, 0, end - units * stride, "first unit")
            check_range(units, 0, cells.TECHNO_UNITS, "number of units")
            check_range(stride, cells.TECHNO_DATA + cells.TECHNO_DATA_BYTES, end, "bytes of a unit")
            check_range(used, 0, end, "number in use")
            check_range(area, 0, areas - 1, "area")
            self.first[i] = first
            self.units[i] = units
            self.stride[i] = stride
            self.used[i] = used
            self.area[i] = area

    def table(self, m: bytearray, h: bytearray, tool: int) -> FunctionTable:
        """Return which units each function has; ``ValueError`` if there are no such units."""
        check_range(tool, 0, self.count - 1, "units of the channel")
        for banks in (m, h):
            check_banks(banks, self.count)
        return FunctionTable(m, h, tool)

    def announce(self, area: int, tick: int) -> None:
        """Announce a PLC for an area from the end of this tick on."""
        if self.since[area] < -1:
            self.since[area] = tick
        self.announced[area] = 1

    def is_announced(self, bank: int) -> int:
        """Return whether a PLC is announced for the area of these units."""
        return 1 if self.announced[self.area[bank]] else 0

    def occupy(self, bank: int) -> int:
        """Occupy a free unit; return its index, -1 without one."""
        for i in range(self.units[bank]):
            if self.taken[bank * cells.TECHNO_UNITS + i] == 0:
                self.taken[bank * cells.TECHNO_UNITS + i] = 1
                self.count_used(bank)
                return i
        return -1

    def at(self, bank: int, unit: int) -> int:
        """Return the address of a unit."""
        return self.first[bank] + unit * self.stride[bank]

    def free(self, bank: int, unit: int) -> None:
        """Clear a unit and free it."""
        self.taken[bank * cells.TECHNO_UNITS + unit] = 0
        size = cells.TECHNO_DATA + cells.TECHNO_DATA_BYTES
        words.fill(self.memory, self.at(bank, unit), size, 0)
        self.count_used(bank)

    def count_used(self, bank: int) -> None:
        """Write the number of units up to the last one in use."""
        count = 0
        for i in range(self.units[bank]):
            if self.taken[bank * cells.TECHNO_UNITS + i]:
                count = i + 1
        if self.used[bank]:
            words.store(self.memory, self.used[bank], kinds.U16, count)

    def ask(self, at: int, kind: int) -> None:
        """Let a unit ask for a function of this kind, after its data."""
        words.store(self.memory, at + cells.TECHNO_DONE, kinds.U8, 0)
        words.store(self.memory, at + cells.TECHNO_TYPE, kinds.U16, kind)
        words.store(self.memory, at + cells.TECHNO_PLEASE, kinds.U8, 1)

    def writer(self, bank: int, unit: int) -> int:
        """Return the statement that has written ``done_w`` last, negative, 0 without one."""
        return -self.context.writer_of(self.at(bank, unit) + cells.TECHNO_DONE)

    def is_done(self, bank: int, unit: int) -> int:
        """Return whether the PLC has set ``done_w``."""
        return words.load(self.memory, self.at(bank, unit) + cells.TECHNO_DONE, kinds.BOOL)


def check_banks(table: bytearray, count: int) -> None:
    """Raise ``ValueError`` if a table names units that are not there."""
    for bank in memoryview(table).cast("q"):
        check_range(bank, 0, count - 1, "units")


class UnitSource:
    """Functions waiting for a PLC, as a chain; the base is the null object at its end."""

    def show(self, tick: int) -> None:
        """Show the waiting functions after a tick, and acknowledge those of unannounced areas."""

    def read_commands(self) -> None:
        """Acknowledge the functions that the PLC has completed."""


class SectionSource(UnitSource):
    """The functions of one section of a channel, and the sources after it.

    ``places``: which of the ``banks`` has the units of each function's area (``UnitBanks.table``);
    ``types``: the synchronisation of each function; those of realtime cycles are MOS.
    """

    def __init__(
        self,
        banks: UnitBanks,
        hli: Hli,
        is_realtime: bool,
        places: FunctionTable,
        types: FunctionTable,
        cycle_time_us: int,
        others: UnitSource,
    ) -> None:
        self.banks = banks
        self.hli = hli
        self.section: Section = hli.realtime if is_realtime else hli.program
        self.is_realtime = is_realtime
        self.places = places
        self.types = types
        self.cycle_time_us = cycle_time_us
        self.others = others
        self.bank = integers(self.section.slot_count)
        self.unit = integers(self.section.slot_count)
        self.serial = integers(self.section.slot_count)
        self.shown_count = 0

    def show(self, tick: int) -> None:
        if self.section.taken_count > 0 or self.shown_count > 0:
            for i in range(self.section.slot_count):
                self.follow(i, tick)
        self.others.show(tick)

    def follow(self, slot: int, tick: int) -> None:
        """Show a function, take its unit back, or acknowledge it for an area without a PLC."""
        is_waiting = self.section.state[slot] == codes.WAITING
        if self.serial[slot]:
            is_same = self.serial[slot] == self.section.serial[slot]
            if is_waiting and is_same and self.banks.is_announced(self.bank[slot]):
                return
            self.banks.free(self.bank[slot], self.unit[slot])
            self.serial[slot] = 0
            self.shown_count -= 1
        if not is_waiting:
            return
        bank = self.places.of(self.section.function[slot])
        if self.banks.is_announced(bank):
            unit = self.banks.occupy(bank)
            if unit >= 0:
                self.bank[slot] = bank
                self.unit[slot] = unit
                self.serial[slot] = self.section.serial[slot]
                self.shown_count += 1
                self.write(self.banks.at(bank, unit), slot)
        elif self.hli.acknowledges_itself and self.section.done[slot] <= tick:
            self.section.state[slot] = codes.ACKNOWLEDGED

    def write(self, at: int, slot: int) -> None:
        """Write a function into a unit."""
        function = self.section.function[slot]
        data = at + cells.TECHNO_DATA
        if function >= codes.FIRST_T:
            words.store(
                self.banks.memory, data + cells.TECHNO_NUMBER, kinds.I32, function - codes.FIRST_T
            )
            self.banks.ask(at, cells.TECHNO_T)
            return
        number = function if function >= 0 else -function - 1
        mode = self.types.of(function)
        if self.is_realtime:
            mode = cells.MOS
        ticks = self.section.done[slot] - self.section.tick[slot]
        words.store(self.banks.memory, data + cells.TECHNO_NUMBER, kinds.U32, number)
        words.store(
            self.banks.memory, data + cells.TECHNO_TIME, kinds.I32, ticks * self.cycle_time_us
        )
        words.store(
            self.banks.memory, data + cells.TECHNO_VALUE, kinds.I32, self.section.value[slot]
        )
        words.store(self.banks.memory, data + cells.TECHNO_MODE, kinds.U32, mode)
        self.banks.ask(at, cells.TECHNO_M if function >= 0 else cells.TECHNO_H)

    def read_commands(self) -> None:
        if self.shown_count > 0:
            for i in range(self.section.slot_count):
                if self.serial[i] and self.banks.is_done(self.bank[i], self.unit[i]):
                    if self.section.serial[i] == self.serial[i]:
                        self.section.state[i] = codes.ACKNOWLEDGED
                        writer = self.banks.writer(self.bank[i], self.unit[i])
                        self.section.answer_source[i] = writer
        self.others.read_commands()


class SpindleSource(UnitSource):
    """The jobs of a channel's spindles that the PLC turns, and the sources after it.

    ``spindle_banks``: int64 for each spindle, the units of its axis, else of its channel.
    """

    def __init__(
        self,
        banks: UnitBanks,
        hli: Hli,
        spindles: Spindles,
        spindle_banks: bytearray,
        others: UnitSource,
    ) -> None:
        self.banks = banks
        self.hli = hli
        self.spindles = spindles
        self.others = others
        self.bank = memoryview(spindle_banks).cast("q")
        check_banks(spindle_banks, banks.count)
        self.unit = integers(spindles.count + 1)
        self.job = integers(spindles.count + 1)

    def show(self, tick: int) -> None:
        for i in range(self.spindles.count):
            self.follow(i, tick)
        self.others.show(tick)

    def follow(self, spindle: int, tick: int) -> None:
        """Show a job, take its unit back, or acknowledge it for an area without a PLC."""
        is_waiting = self.spindles.plc_state[spindle] == codes.WAITING
        bank = self.bank[spindle]
        if self.job[spindle]:
            is_same = self.job[spindle] == self.spindles.job[spindle]
            if is_waiting and is_same and self.banks.is_announced(bank):
                return
            self.banks.free(bank, self.unit[spindle])
            self.job[spindle] = 0
        if not is_waiting:
            return
        if self.banks.is_announced(bank):
            unit = self.banks.occupy(bank)
            if unit >= 0:
                self.unit[spindle] = unit
                self.job[spindle] = self.spindles.job[spindle]
                self.write(self.banks.at(bank, unit), spindle)
        elif self.hli.acknowledges_itself and self.spindles.done_tick[spindle] <= tick:
            self.spindles.plc_state[spindle] = codes.ACKNOWLEDGED

    def speed_of(self, spindle: int) -> float:
        """Return the speed that is commanded, in degrees/s: negative for M4, 0 for M5."""
        function = self.spindles.function[spindle]
        if function == codes.SPINDLE_STOP:
            return 0.0
        speed_v = self.spindles.commanded_v[spindle]
        return 0.0 - speed_v if function == codes.SPINDLE_BACKWARD else speed_v

    def write(self, at: int, spindle: int) -> None:
        """Write a job into a unit."""
        data = at + cells.TECHNO_DATA
        position = self.spindles.commanded_position[spindle] * cells.TECHNO_ANGLE
        speed = self.speed_of(spindle) * cells.TECHNO_ROTATION
        position = arithmetic.round_half_even(position)
        speed = arithmetic.round_half_even(speed)
        words.store(self.banks.memory, data + cells.TECHNO_POSITION, kinds.I32, int(position))
        words.store(self.banks.memory, data + cells.TECHNO_SPEED, kinds.I32, int(speed))
        self.banks.ask(at, cells.TECHNO_S)

    def read_commands(self) -> None:
        for i in range(self.spindles.count):
            if self.job[i] and self.banks.is_done(self.bank[i], self.unit[i]):
                if self.spindles.job[i] == self.job[i]:
                    self.spindles.plc_state[i] = codes.ACKNOWLEDGED
        self.others.read_commands()
