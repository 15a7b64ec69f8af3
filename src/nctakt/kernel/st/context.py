# SPDX-License-Identifier: MIT
"""The view of running PLC code: its memory, current frame and instance, its bounds, its fault.

The memory is one block of bytes: ``NULL_BYTES`` that no pointer reaches, data, the stack of calls,
literals, the interface to the CNC, and ``SLACK`` bytes more, so that an access by a small fixed
offset needs no check (ST-001). A pointer is an offset in it; 0 is null.
"""

from __future__ import annotations

from nctakt.kernel.base.arrays import doubles, integers
from nctakt.kernel.base.bounds import check_range
from nctakt.kernel.st import kinds
from nctakt.kernel.st.observing import notes
from nctakt.kernel.st.observing.notes import Notes
from nctakt.kernel.st.outside import Outside


class PlcContext:
    """One running PLC project; ``outside`` gives its calls access to the machine.

    ``interface`` is where the interface begins, which code may write; it may not write literals.
    Below ``plain_end`` a write only changes bytes: no check, no notification.

    ``frame`` is the address of the running routine's variables, ``top`` the first byte of the stack
    that is free, ``instance`` the block that is called, ``passing`` the address where a call's
    arguments go and its results come from. ``steps`` counts the elementary instructions of the
    cycle of ``task``, up to ``max_steps`` (ST-830); ``now`` is the cycle's time in ns (ST-804).
    ``instruction_ns``: how long an instruction takes, 0: no time; ``overrun_task`` is the number of
    a task whose cycle took too long, ``overrun_ns`` how long, 0 where nothing is to be reported.
    ``source_base`` moves its sources in events, where those of several PLCs differ. ``caller`` is
    the source of the latest call of a test's function; ``counts`` says how often conditions and
    bodies ran, ``near_left``, ``near_right`` and ``distances`` how near comparisons came to the
    result they never had; below 0: no value. ``seen_left`` and ``seen_right`` are the sides of the
    latest comparison. ``notes`` keeps what led to changes while somebody wants to know
    (``is_noting``). ``fault`` is the number of the message for the fault that stopped the PLC, 0
    without one, with its source, its values and the calls that led to it (ST-560).
    """

    def __init__(
        self, memory: bytearray, stack: int, stack_end: int, interface: int | None = None
    ) -> None:
        check_range(stack_end, kinds.NULL_BYTES, len(memory) - kinds.SLACK, "end of the stack")
        check_range(stack, kinds.NULL_BYTES, stack_end, "stack")
        self.memory = memoryview(memory)
        self.task = 0
        self.stack = stack
        self.stack_end = stack_end
        self.end = len(memory) - kinds.SLACK
        self.interface = self.end if interface is None else interface
        check_range(self.interface, stack_end, self.end, "interface")
        self.plain_end = stack_end
        self.outside = Outside()
        self.notes = Notes(0)
        self.is_noting = False
        self.writers = integers((self.end - self.interface) + 8)
        self.frame = stack
        self.top = stack
        self.instance = stack
        self.passing = stack
        self.depth = 0
        self.caller = 0
        self.now = 0
        self.steps = 0
        self.max_steps = 1000000
        self.instruction_ns = 0
        self.source_base = 0
        self.overrun_task = 0
        self.overrun_ns = 0
        self.fault = 0
        self.fault_source = 0
        self.fault_a = 0
        self.fault_b = 0
        self.fault_frame = 0
        self.fault_instance = 0
        self.trail = integers(kinds.TRAIL_WIDTH * (kinds.MAX_DEPTH + 2))
        self.trail_length = 0
        self.count_end = 0
        self.counts = integers(1)
        self.near_left = doubles(1)
        self.near_right = doubles(1)
        self.distances = doubles(1)
        self.seen_left = 0.0
        self.seen_right = 0.0
        self.stops_at_invalid = True
        self.wraps_conversions = False

    def keep_counts(self, size: int) -> None:
        """Count the runs of ``size`` conditions and bodies from now on."""
        check_range(size, 0, kinds.MAX_COUNTS, "counts")
        self.counts = integers(size + 1)
        self.near_left = doubles(size + 1)
        self.near_right = doubles(size + 1)
        self.distances = doubles(size + 1)
        for number in range(size):
            self.distances[number] = -1.0
        self.count_end = size

    def keep_notes(self) -> Notes:
        """Note what leads to changes from now on; return the notes."""
        self.notes = Notes(len(self.memory))
        self.is_noting = True
        self.plain_end = 0
        return self.notes

    def wrote(self, at: int, kind: int, source: int) -> None:
        """Note that a statement has written a value; one of the interface is watched from now."""
        if at >= self.interface and self.notes.watched[at] == 0:
            self.notes.discover(self.memory, at, kind)
        self.notes.note(self.memory, at, notes.width(kind), source, self.now)

    def wrote_target(self, at: int, kind: int, source: int) -> None:
        """Note that a statement has written a value at ``plain_end`` or above."""
        if at >= self.interface:
            self.note_writer(at, source)
        if self.is_noting:
            self.wrote(at, kind, source)

    def wrote_bytes(self, at: int, size: int, source: int) -> None:
        """Note that a statement has written bytes."""
        self.notes.note(self.memory, at, size, source, self.now)

    def count(self, number: int) -> None:
        """Count a condition or a body, if it is counted at all."""
        if number < self.count_end:
            self.counts[number] += 1

    def approach(self, number: int, truth: int) -> None:
        """Note how near a comparison came to the result it never had: its sides, their distance.

        ``number``: that of its being true.
        """
        self.note_near(number + 1 if truth else number, self.seen_left, self.seen_right)

    def note_near(self, missed: int, left: float, right: float) -> None:
        """Note how far two values are apart, if that is nearer than before.

        ``missed``: the number of the count for equal sides, if they were ever equal.
        """
        if missed >= self.count_end or self.counts[missed] != 0:
            return
        distance = left - right
        if distance < 0.0:
            distance = -distance
        known = self.distances[missed]
        if distance >= 0.0 and (known < 0.0 or distance < known):
            self.near_left[missed] = left
            self.near_right[missed] = right
            self.distances[missed] = distance

    def begin(self, now: int) -> None:
        """Begin a cycle: no instruction is counted yet, no call is open."""
        self.now = now
        self.steps = 0
        self.frame = self.stack
        self.top = self.stack
        self.depth = 0
        self.notes.begin()

    def fail(self, message: int, a: int, b: int) -> None:
        """Note the first fault; the statement adds its source."""
        if self.fault == 0:
            self.fault = message
            self.fault_source = 0
            self.fault_a = a
            self.fault_b = b
            self.fault_frame = self.frame
            self.fault_instance = self.instance
            self.trail_length = 0

    def stop_at(self, source: int) -> int:
        """Complete a fault by the statement's source, unless it has one; return that it stops."""
        if self.fault_source == 0:
            self.fault_source = source
        return kinds.STOPS

    def over_budget(self, source: int) -> int:
        """Note that the cycle has used up its instructions (ST-830); return that it stops."""
        self.fail(kinds.BUDGET, self.max_steps, 0)
        return self.stop_at(source)

    def note_call(self, source: int) -> None:
        """Note a call on the way to the fault, from the innermost one on, with its caller."""
        if self.trail_length <= kinds.TRAIL_WIDTH * kinds.MAX_DEPTH:
            self.trail[self.trail_length] = source
            self.trail_length += 1
            self.trail[self.trail_length] = self.instance
            self.trail_length += 1
            self.trail[self.trail_length] = self.frame
            self.trail_length += 1

    def checked(self, address: int, size: int) -> int:
        """Return the address of ``size`` bytes; else note that it is null or outside (ST-315)."""
        if address < kinds.NULL_BYTES or size < 0 or address > self.end - size:
            self.fail(kinds.PLACE, address, size)
            return self.stack
        return address

    def checked_target(self, address: int, size: int) -> int:
        """Return the address of ``size`` bytes that may be written; else note a fault."""
        if address < kinds.NULL_BYTES or size < 0 or address > self.stack_end - size:
            if size < 0 or address < self.interface or address > self.end - size:
                self.fail(kinds.PLACE, address, size)
                return self.stack
        return address

    def note_writer(self, address: int, source: int) -> None:
        """Note which statement has written a byte of the interface last."""
        if address < self.end:
            self.writers[address - self.interface] = source

    def writer_of(self, address: int) -> int:
        """Return the source of the statement that has written a byte last, 0 without one.

        It is moved by ``source_base``, so that the statements of several PLCs differ.
        """
        if address < self.interface or address >= self.end:
            return 0
        source = self.writers[address - self.interface]
        return source + self.source_base if source else 0

    def poke(self, address: int, data: bytes) -> None:
        """Write bytes into the data or the interface, between two ticks."""
        check_range(address, kinds.NULL_BYTES, self.end - len(data), "address")
        for i, byte in enumerate(data):
            self.memory[address + i] = byte

    def peek(self, address: int, size: int) -> bytes:
        """Return bytes of the memory."""
        check_range(size, 0, self.end, "size")
        check_range(address, 0, self.end - size, "address")
        return bytes(self.memory[address : address + size])

    def dump(self) -> bytes:
        """Return the memory that code can reach."""
        return bytes(self.memory[: self.end])
