# SPDX-License-Identifier: MIT
"""The interface image between CNC and PLC: technology functions and their acknowledgement.

The realtime section (POS_RT) takes the functions of realtime cycles, in order, in the same tick,
and never waits: no free slot is an error (RC-403). The main program's functions have a separate
section, for whose slots and acknowledgements the program may wait. The PLC's answers in tick n
count from tick n+1: ``latch`` at the start of a tick puts them into force. Without a scripted PLC
the default one acknowledges each function in the tick in which it appears, or later by the ticks
that the function takes (P-CHAN-00040, P-CHAN-00026).
"""

from __future__ import annotations

from nctakt.kernel import codes
from nctakt.kernel.base.arrays import integers
from nctakt.kernel.base.bounds import check_index, check_size
from nctakt.kernel.base.record import Record
from nctakt.kernel.plc.panel import Panel

#: Slots of a section: nctakt's choice, no source gives a number (RC-403).
SLOT_COUNT = 20


class FunctionTable:
    """A number for each technology function: ``m`` and ``h``, int64 by its number; ``tool``: T."""

    def __init__(self, m: bytearray, h: bytearray, tool: int) -> None:
        self.set(m, h, tool)

    def set(self, m: bytearray, h: bytearray, tool: int) -> None:
        """Set the numbers of all functions."""
        self.m = memoryview(m).cast("q")
        self.h = memoryview(h).cast("q")
        self.m_count = len(self.m)
        self.h_count = len(self.h)
        self.tool = tool

    def of(self, function: int) -> int:
        """Return the number of a function, 0 beyond the tables."""
        if function >= codes.FIRST_T:
            return self.tool
        if function >= 0:
            return self.m[function] if function < self.m_count else 0
        number = -function - 1
        return self.h[number] if number < self.h_count else 0


class Section:
    """Slots for technology functions.

    Each function has a running number (``serial``) and a value for the PLC, 0 unless it is given
    one (``give_value``); ``version`` changes with the slots. A function is named by its code
    (``hli/function_codes.py``). Its ``unit`` is where the interface shows it, in the area of the
    channel or of its axis: the first free one when it comes, until it is acknowledged.
    ``answer_source``: the statement of a PLC in the tick that has acknowledged it, negative, 0
    without one.
    """

    def __init__(self, slot_count: int) -> None:
        check_size(slot_count, "number of slots")
        self.slot_count = slot_count
        self.state = integers(slot_count)
        self.function = integers(slot_count)
        self.sequence = integers(slot_count)
        self.tick = integers(slot_count)
        self.done = integers(slot_count)
        self.serial = integers(slot_count)
        self.value = integers(slot_count)
        self.is_answered = integers(slot_count)
        self.area = integers(slot_count)
        self.unit = integers(slot_count)
        self.areas = FunctionTable(bytearray(8), bytearray(8), 0)
        self.answer_source = integers(slot_count)
        self.last_slot = 0
        self.issued_in_tick = 0
        self.taken_count = 0
        self.issued = 0
        self.version = 0

    def set_areas(self, m: bytearray, h: bytearray) -> None:
        """Set the logical axis that each M and H function is for, 0 the channel, as int64."""
        self.areas.set(m, h, 0)

    def latch(self) -> None:
        """Free the slots that the PLC has acknowledged, at the start of a tick."""
        self.issued_in_tick = 0
        if self.taken_count == 0:
            return
        for i in range(self.slot_count):
            if self.state[i] == codes.ACKNOWLEDGED:
                self.state[i] = codes.FREE
                self.taken_count -= 1
                self.version += 1

    def issue(self, function: int, tick: int, ticks: int) -> int:
        """Put a function that takes ``ticks`` ticks into a free slot; return its number.

        0 where the section holds no more in one tick (50943), -1 where no slot is free (50942).
        """
        if self.issued_in_tick >= self.slot_count:
            return 0
        for i in range(self.slot_count):
            if self.state[i] == codes.FREE:
                self.issued_in_tick += 1
                self.taken_count += 1
                self.version += 1
                self.issued = self.issued + 1 if self.issued < 2147483647 else 1
                self.serial[i] = self.issued
                self.state[i] = codes.WAITING
                self.function[i] = function
                self.sequence[i] = self.issued_in_tick
                self.tick[i] = tick
                self.done[i] = tick + ticks
                self.value[i] = 0
                self.area[i] = self.areas.of(function)
                self.unit[i] = self.free_unit(i)
                self.answer_source[i] = 0
                self.last_slot = i
                return self.issued_in_tick
        return -1

    def free_unit(self, slot: int) -> int:
        """Return the first unit of its area that no other function than that of ``slot`` has."""
        unit = 0
        while self.is_unit_taken(slot, unit):
            unit += 1
        return unit

    def is_unit_taken(self, slot: int, unit: int) -> int:
        """Return whether another function of the same area has this unit."""
        for i in range(self.slot_count):
            if i != slot and self.state[i] != codes.FREE and self.area[i] == self.area[slot]:
                if self.unit[i] == unit:
                    return 1
        return 0

    def give_value(self, value: int) -> None:
        """Give the function that was put in last a value (M110 = 130)."""
        self.value[self.last_slot] = value

    def is_waiting(self, function: int) -> int:
        """Return whether the PLC still has to acknowledge this function."""
        if self.taken_count == 0:
            return 0
        for i in range(self.slot_count):
            if self.state[i] != codes.FREE and self.function[i] == function:
                return 1
        return 0

    def acknowledge_done(self, tick: int) -> None:
        """Acknowledge the functions whose time is over (default PLC)."""
        if self.taken_count == 0:
            return
        for i in range(self.slot_count):
            if self.state[i] == codes.WAITING and self.done[i] <= tick:
                self.state[i] = codes.ACKNOWLEDGED

    def record_answers(self, record: Record, state: int, kind: int, is_realtime: int) -> None:
        """Record an event of ``kind`` for each slot in this state, before it is freed."""
        for i in range(self.slot_count):
            if self.state[i] == state:
                number = self.sequence[i] if is_realtime else 0
                source = self.answer_source[i]
                record.event(kind, source, 0, self.function[i], number, self.tick[i])

    def clear(self) -> None:
        """Free all slots (reset)."""
        for i in range(self.slot_count):
            self.state[i] = codes.FREE
        self.taken_count = 0
        self.version += 1

    def value_of(self, slot: int) -> int:
        """Value of the function in a slot; raise ``ValueError`` for an unknown slot."""
        check_index(slot, self.slot_count, "slot")
        return self.value[slot]

    def unit_of(self, slot: int) -> int:
        """Unit of the function in a slot; raise ``ValueError`` for an unknown slot."""
        check_index(slot, self.slot_count, "slot")
        return self.unit[slot]

    def entries(self) -> list[tuple[int, int, int, int, int]]:
        """Waiting functions, oldest first: (slot, function, number in its tick, tick, serial)."""
        waiting = [
            (i, self.function[i], self.sequence[i], self.tick[i], self.serial[i])
            for i in range(self.slot_count)
            if self.state[i] == codes.WAITING
        ]
        return sorted(waiting, key=_order)

    def answered(self) -> list[tuple[int, int, int, int, int]]:
        """The functions last acknowledged by delays of a PLC, in order and form of ``entries``."""
        found = [
            (i, self.function[i], self.sequence[i], self.tick[i], self.serial[i])
            for i in range(self.slot_count)
            if self.is_answered[i]
        ]
        return sorted(found, key=_order)

    def acknowledge(self, slot: int, serial: int) -> bool:
        """Acknowledge the function of this serial; return whether the slot holds it."""
        check_index(slot, self.slot_count, "slot")
        if self.state[slot] == codes.FREE or self.serial[slot] != serial:
            return False
        self.state[slot] = codes.ACKNOWLEDGED
        return True


def _order(entry: tuple[int, int, int, int, int]) -> tuple[int, int]:
    """Sort key of a waiting function: tick, and number in it."""
    _, _, sequence, tick, _ = entry
    return tick, sequence


class Hli:
    """One channel's image; ``realtime`` is the section POS_RT, ``program`` the main program's.

    ``panel`` is the operator's side. ``is_divided``: a PLC that runs in the tick acknowledges the
    functions of areas that it has not announced (``kernel.st.technology``).
    """

    def __init__(self, panel: Panel, slot_count: int = SLOT_COUNT) -> None:
        self.panel = panel
        self.realtime = Section(slot_count)
        self.program = Section(slot_count)
        self.acknowledges_itself = True
        self.is_divided = False

    def latch(self) -> None:
        """Latch panel and acknowledgements at the start of a tick."""
        self.panel.latch()
        self.realtime.latch()
        self.program.latch()

    def has_default_plc(self) -> int:
        """Return whether no script and no other process plays the PLC."""
        if self.is_divided or self.panel.plc_present:
            return 0
        return 1 if self.acknowledges_itself else 0

    def run_default_plc(self, tick: int) -> None:
        """Run the PLC phase of a tick, if no other PLC is connected."""
        if self.has_default_plc():
            self.realtime.acknowledge_done(tick)
            self.program.acknowledge_done(tick)

    def waiting_count(self) -> int:
        """Number of slots that are not free."""
        return self.realtime.taken_count + self.program.taken_count

    def record_answers(self, record: Record, state: int, kind: int) -> None:
        """Record an event of ``kind`` for each function whose slot is in this state."""
        if self.waiting_count() > 0:
            self.realtime.record_answers(record, state, kind, 1)
            self.program.record_answers(record, state, kind, 0)

    def clear(self) -> None:
        """Free the slots of both sections (reset)."""
        self.realtime.clear()
        self.program.clear()
