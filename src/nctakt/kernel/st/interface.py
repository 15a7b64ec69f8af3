# SPDX-License-Identifier: MIT
"""The interface between CNC and PLC in a PLC's own memory (ST-761 … ST-764).

Before the tasks of a tick run, ``show`` writes the state of the CNC; after them ``read_commands``
reads the PLC's commands, which ``latch`` and ``guard`` put into force at the start of the next tick
(RC-002). Tables map bytes to cells of the machine.
"""

from __future__ import annotations

from nctakt.kernel import cells, codes
from nctakt.kernel.axes.axes import Axes
from nctakt.kernel.base import arithmetic
from nctakt.kernel.base.arrays import doubles, integers
from nctakt.kernel.base.bounds import check_range
from nctakt.kernel.plc.interface_image import InterfaceImage
from nctakt.kernel.st import kinds, words
from nctakt.kernel.st.technology import UnitBanks, UnitSource

#: Bounds of whole numbers in memory by their kinds.
_LOW = (0.0, -128.0, -32768.0, -2147483648.0, -9.2e18, 0.0, 0.0, 0.0, 0.0)
_HIGH = (1.0, 127.0, 32767.0, 2147483647.0, 9.2e18, 255.0, 65535.0, 4294967295.0, 9.2e18)


class CncSide:
    """Base of the interface, and null object: the PLC uses none."""

    def latch(self) -> None:
        """Take over the variables that the PLC has written, before other inputs."""

    def guard(self) -> None:
        """Put commands into force; requests of others that the PLC decides about wait."""

    def event_bound(self) -> int:
        """Highest number of events in a tick."""
        return 0

    def follow(self, tick: int) -> None:
        """Follow the functions that wait, after a tick."""

    def show(self, tick: int) -> None:
        """Write what the CNC shows, before the tasks of a tick run."""

    def read_commands(self) -> int:
        """Read the PLC's commands; return whether Python has something to do for them."""
        return 0

    def leave(self) -> None:
        """Continue without the PLC, which has stopped."""


class ShownValues:
    """Numbers in memory that show cells: address, kind, cell, how, operand.

    ``how``: ``kinds.SCALED`` by the operand, ``EQUALS`` or ``DIFFERS`` from it, ``MAPPED`` by the
    table of this number.
    """

    def __init__(
        self,
        memory: bytearray,
        machine: bytearray,
        rows: list[tuple[int, int, int, int, float]],
        tables: list[list[float]],
    ) -> None:
        self.memory = memoryview(memory)
        self.cells = memoryview(machine).cast("d")
        self.count = len(rows)
        self.address = integers(len(rows) + 8)
        self.kind = integers(len(rows) + 8)
        self.cell = integers(len(rows) + 8)
        self.how = integers(len(rows) + 8)
        self.operand = doubles(len(rows) + 8)
        self.low = doubles(kinds.F64)
        self.high = doubles(kinds.F64)
        size = kinds.MAPPED_NUMBERS
        self.table = doubles(size * len(tables) + 8)
        for i, (low, high) in enumerate(zip(_LOW, _HIGH, strict=True)):
            self.low[i] = low
            self.high[i] = high
        for i, numbers in enumerate(tables):
            check_range(len(numbers), 0, size, "numbers of a table")
            for k, number in enumerate(numbers):
                self.table[i * size + k] = number
        for i, (address, kind, cell, how, operand) in enumerate(rows):
            check_range(address, 0, len(memory) - kinds.SLACK, "address")
            check_range(kind, kinds.BOOL, kinds.F64, "kind")
            check_range(cell, 0, len(self.cells) - 1, "cell")
            check_range(how, kinds.SCALED, kinds.MAPPED, "how")
            if how == kinds.MAPPED:
                check_range(int(operand), 0, len(tables) - 1, "table")
            self.address[i] = address
            self.kind[i] = kind
            self.cell[i] = cell
            self.how[i] = how
            self.operand[i] = operand

    def show(self) -> None:
        """Write all of them."""
        for i in range(self.count):
            self.put(self.address[i], int(self.kind[i]), self.number(i))

    def number(self, entry: int) -> float:
        """Return the number that an entry shows."""
        value = self.cells[self.cell[entry]]
        how = self.how[entry]
        operand = self.operand[entry]
        if how == kinds.SCALED:
            return value * operand
        if how == kinds.EQUALS:
            return 1.0 if value == operand else 0.0
        if how == kinds.DIFFERS:
            return 1.0 if value != operand else 0.0
        number = int(value)
        if number < 0 or number >= kinds.MAPPED_NUMBERS:
            return 0.0
        table = int(operand)
        return self.table[table * kinds.MAPPED_NUMBERS + number]

    def put(self, address: int, kind: int, value: float) -> None:
        """Write a number, within the bounds of its type, rounded half to even (ST-764)."""
        if kind >= kinds.F32:
            words.store_real(self.memory, address, kind, value)
            return
        if value - value != 0.0:
            value = 0.0
        value = arithmetic.round_half_even(value)
        value = min(max(value, self.low[kind]), self.high[kind])
        number = int(value)
        words.store(self.memory, address, kind, number)


class ControlUnits:
    """Control units: the PLC's commands, and requests of others meanwhile (ST-762).

    A row: addresses of ``enable_w``, ``command_w``, ``request_r``, kind of the values, cell,
    factor, area, whether it acts by its edge. While the PLC decides, its command holds, and what
    others write into the cell becomes the request.
    """

    def __init__(
        self,
        values: ShownValues,
        banks: UnitBanks,
        rows: list[tuple[int, int, int, int, int, float, int, bool]],
    ) -> None:
        self.values = values
        self.banks = banks
        self.count = len(rows)
        self.enable = integers(len(rows) + 8)
        self.command = integers(len(rows) + 8)
        self.request = integers(len(rows) + 8)
        self.kind = integers(len(rows) + 8)
        self.cell = integers(len(rows) + 8)
        self.factor = doubles(len(rows) + 8)
        self.area = integers(len(rows) + 8)
        self.is_edge = integers(len(rows) + 8)
        self.is_decided = integers(len(rows) + 8)
        self.is_released = integers(len(rows) + 8)
        self.is_pressed = integers(len(rows) + 8)
        self.was_commanded = integers(len(rows) + 8)
        self.requested = doubles(len(rows) + 8)
        self.commanded = doubles(len(rows) + 8)
        end = len(self.values.memory) - kinds.SLACK
        for i, (enable, command, request, kind, cell, factor, area, is_edge) in enumerate(rows):
            for address in (enable, command, request):
                check_range(address, 0, end, "address")
            check_range(kind, kinds.BOOL, kinds.U64, "kind")
            check_range(cell, 0, len(self.values.cells) - 1, "cell")
            check_range(area, 0, banks.area_count - 1, "area")
            self.enable[i] = enable
            self.command[i] = command
            self.request[i] = request
            self.kind[i] = kind
            self.cell[i] = cell
            self.factor[i] = factor
            self.area[i] = area
            self.is_edge[i] = is_edge

    def guard(self) -> None:
        """Put the commands into their cells, after what others have written there."""
        for i in range(self.count):
            cell = self.cell[i]
            if self.is_edge[i]:
                self.press(i)
            elif self.is_decided[i]:
                if self.is_decided[i] == kinds.COMMANDED:  # it decides from this tick on
                    self.is_decided[i] = kinds.IN_FORCE
                    self.requested[i] = self.values.cells[cell]
                elif self.values.cells[cell] != self.commanded[i]:
                    self.requested[i] = self.values.cells[cell]
                self.values.cells[cell] = self.commanded[i]
            elif self.is_released[i]:
                self.is_released[i] = 0
                self.values.cells[cell] = self.requested[i]

    def press(self, unit: int) -> None:
        """Press a key for the PLC; presses of others only show while it decides."""
        cell = self.cell[unit]
        if self.is_decided[unit] and self.values.cells[cell] != 0.0 and not self.was_pressed(unit):
            self.values.cells[cell] = 0.0
            self.requested[unit] = 1.0
        if self.is_pressed[unit] == kinds.COMMANDED:
            self.is_pressed[unit] = kinds.IN_FORCE
            self.values.cells[cell] = 1.0
        elif self.values.cells[cell] == 0.0:
            self.is_pressed[unit] = kinds.NOT_COMMANDED

    def was_pressed(self, unit: int) -> int:
        """Return whether the PLC itself has pressed a key that has not been accepted yet."""
        return 1 if self.is_pressed[unit] == kinds.IN_FORCE else 0

    def show(self) -> None:
        """Show the requests of others."""
        for i in range(self.count):
            requested = self.requested[i]
            if not self.is_edge[i] and not self.is_decided[i]:
                requested = self.values.cells[self.cell[i]]
            self.values.put(self.request[i], int(self.kind[i]), requested * self.factor[i])
            if self.is_edge[i]:
                self.requested[i] = 0.0

    def read_commands(self) -> None:
        """Look at the commands after the PLC's tasks."""
        for i in range(self.count):
            is_set = words.load(self.values.memory, self.enable[i], kinds.BOOL)
            number = words.load(self.values.memory, self.command[i], int(self.kind[i]))
            decides = is_set != 0 and self.banks.announced[self.area[i]] != 0
            if self.is_edge[i]:
                if decides and number and not self.was_commanded[i]:
                    self.is_pressed[i] = kinds.COMMANDED
                self.was_commanded[i] = number
                self.is_decided[i] = decides
            elif decides:
                if self.is_decided[i] == kinds.NOT_COMMANDED:
                    self.is_decided[i] = kinds.COMMANDED
                self.commanded[i] = number / self.factor[i]
            else:
                if self.is_decided[i] == kinds.IN_FORCE:
                    self.is_released[i] = 1
                self.is_decided[i] = kinds.NOT_COMMANDED


class ChannelRecords:
    """Mode, error and commanded transitions of the channels (``hli.interface_memory``).

    A row: addresses of mode, state, semaphore of the transition, its ``enable_w`` and semaphore of
    the error; cells of state, pause, feed hold, selected program, error and its number in the run;
    area.
    """

    def __init__(
        self,
        values: ShownValues,
        banks: UnitBanks,
        rows: list[tuple[int, ...]],
    ) -> None:
        self.values = values
        self.banks = banks
        self.count = len(rows)
        self.places = integers(kinds.RECORD_WIDTH * len(rows) + 8)
        self.read_error = doubles(len(rows) + 8)
        end = len(self.values.memory) - kinds.SLACK
        for i, row in enumerate(rows):
            check_range(len(row), kinds.RECORD_WIDTH, kinds.RECORD_WIDTH, "numbers of a row")
            for k, number in enumerate(row):
                is_address = k < kinds.RECORD_STATE_CELL
                check_range(number, 0, end if is_address else len(self.values.cells) - 1, "row")
                self.places[i * kinds.RECORD_WIDTH + k] = number
            check_range(row[kinds.RECORD_AREA], 0, banks.area_count - 1, "area")

    def at(self, record: int, what: int) -> int:
        """Return a number of a row."""
        return self.places[record * kinds.RECORD_WIDTH + what]

    def cell(self, record: int, what: int) -> float:
        """Return the value of a cell of a row."""
        return self.values.cells[self.at(record, what)]

    def show(self) -> None:
        """Show modes, states and new errors."""
        for i in range(self.count):
            mode = self.at(i, kinds.RECORD_MODE)
            words.store(self.values.memory, mode, kinds.U32, cells.MODE_AUTOMATIC)
            state = self.at(i, kinds.RECORD_STATE)
            words.store(self.values.memory, state, kinds.U32, self.state_of(i))
            has_error = self.cell(i, kinds.RECORD_ERROR_CELL) != 0.0
            is_new = has_error and self.cell(i, kinds.RECORD_SERIAL_CELL) != self.read_error[i]
            at = self.at(i, kinds.RECORD_ERROR)
            words.store(self.values.memory, at, kinds.BOOL, 1 if is_new else 0)

    def state_of(self, record: int) -> int:
        """Return the state of the automatic mode."""
        state = self.cell(record, kinds.RECORD_STATE_CELL)
        if state == codes.CHANNEL_ERROR:
            return cells.MODE_ERROR
        if state == codes.CHANNEL_RESET:
            return cells.MODE_RESETTING
        if state == codes.CHANNEL_RUNNING:
            is_held = self.cell(record, kinds.RECORD_HOLD_CELL) != 0.0
            if is_held or self.cell(record, kinds.RECORD_PAUSED_CELL) != 0.0:
                return cells.MODE_HOLD
            return cells.MODE_ACTIVE
        is_armed = self.cell(record, kinds.RECORD_ARMED_CELL) != 0.0
        return cells.MODE_READY if is_armed else cells.MODE_SELECTED

    def read_commands(self) -> int:
        """Note the errors that were read; return whether a transition is commanded."""
        is_commanded = 0
        for i in range(self.count):
            at = self.at(i, kinds.RECORD_ERROR)
            if words.load(self.values.memory, at, kinds.BOOL) == 0:
                self.read_error[i] = self.cell(i, kinds.RECORD_SERIAL_CELL)
            if self.is_commanded(i):
                is_commanded = 1
        return is_commanded

    def is_commanded(self, record: int) -> int:
        """Return whether the PLC commands a transition that it decides about."""
        if self.banks.announced[self.at(record, kinds.RECORD_AREA)] == 0:
            return 0
        enable = self.at(record, kinds.RECORD_ENABLE)
        if words.load(self.values.memory, enable, kinds.BOOL) == 0:
            return 0
        return words.load(self.values.memory, self.at(record, kinds.RECORD_SEMAPHORE), kinds.BOOL)


class AxisReleases:
    """The releases that axes need from a PLC announced for them (ST-762).

    A row: index of the axis, address of ``plc_present_w``, then addresses of ``enable_w`` and
    ``command_w`` of each release.
    """

    def __init__(self, values: ShownValues, axes: Axes, rows: list[tuple[int, ...]]) -> None:
        self.values = values
        self.axes = axes
        self.count = len(rows)
        self.places = integers(kinds.RELEASE_WIDTH * len(rows) + 8)
        self.is_locked = integers(len(rows) + 8)
        end = len(self.values.memory) - kinds.SLACK
        for i, row in enumerate(rows):
            check_range(len(row), kinds.RELEASE_WIDTH, kinds.RELEASE_WIDTH, "numbers of a row")
            check_range(row[0], 0, axes.count - 1, "axis")
            for k, number in enumerate(row):
                check_range(number, 0, end, "row")
                self.places[i * kinds.RELEASE_WIDTH + k] = number

    def flag(self, row: int, what: int) -> int:
        """Return a flag of a row."""
        at = self.places[row * kinds.RELEASE_WIDTH + what]
        return words.load(self.values.memory, at, kinds.BOOL)

    def read_commands(self) -> None:
        """Lock the axes without a release from the next tick on; the others continue."""
        for i in range(self.count):
            is_locked = 0
            if self.flag(i, 1):
                for k in range(2, kinds.RELEASE_WIDTH):
                    if not self.flag(i, k):
                        is_locked = 1
            if is_locked != self.is_locked[i]:
                axis = self.places[i * kinds.RELEASE_WIDTH]
                self.axes.locked_count += is_locked - self.axes.locked[axis]
                self.axes.locked[axis] = is_locked
                self.axes.override_version += 1
                self.is_locked[i] = is_locked


class CncInterface(CncSide):
    """The interface of one PLC.

    ``records``: mode and error of each channel. ``presence``: rows of the address of
    ``plc_present_w`` of each area, and of the cell that a PLC of another kind announces it by (-1:
    none). ``variables``: images of V.E in the memory.
    """

    def __init__(
        self,
        values: ShownValues,
        units: ControlUnits,
        banks: UnitBanks,
        sources: UnitSource,
        records: ChannelRecords,
        releases: AxisReleases,
        presence: list[tuple[int, int]],
        variables: InterfaceImage,
    ) -> None:
        check_range(len(presence), banks.area_count, banks.area_count, "number of areas")
        self.values = values
        self.units = units
        self.banks = banks
        self.sources = sources
        self.records = records
        self.releases = releases
        self.variables = variables
        self.tick = -1
        self.count = len(presence)
        self.present = integers(len(presence) + 8)
        self.present_cell = integers(len(presence) + 8)
        self.own = integers(len(presence) + 8)
        self.published = integers(len(presence) + 8)
        for i, (address, cell) in enumerate(presence):
            check_range(address, 0, len(self.values.memory) - kinds.SLACK, "address")
            check_range(cell, -1, len(self.values.cells) - 1, "cell")
            self.present[i] = address
            self.present_cell[i] = cell

    def latch(self) -> None:
        if self.variables.is_attached:
            self.variables.latch()
        for i in range(self.count):
            cell = self.present_cell[i]
            if cell >= 0 and self.own[i] != self.published[i]:
                self.values.cells[cell] = self.own[i]
                self.published[i] = self.own[i]

    def guard(self) -> None:
        for i in range(self.count):
            cell = self.present_cell[i]
            if self.own[i] != 0 or (cell >= 0 and self.values.cells[cell] != 0.0):
                self.banks.announce(i, self.tick)
            else:
                self.banks.announced[i] = 0
        self.units.guard()

    def event_bound(self) -> int:
        return self.variables.event_bound

    def follow(self, tick: int) -> None:
        self.tick = tick
        self.sources.show(tick)

    def show(self, tick: int) -> None:
        if self.variables.is_attached:
            self.variables.publish(tick + 1)
        self.values.show()
        self.units.show()
        self.records.show()

    def read_commands(self) -> int:
        for i in range(self.count):
            self.own[i] = words.load(self.values.memory, self.present[i], kinds.BOOL)
            if self.own[i]:
                self.banks.announce(i, self.tick)
        self.sources.read_commands()
        self.units.read_commands()
        self.releases.read_commands()
        return self.records.read_commands()

    def leave(self) -> None:
        for i in range(self.count):
            words.store(self.values.memory, self.present[i], kinds.BOOL, 0)
            self.banks.announced[i] = 0
        self.read_commands()
