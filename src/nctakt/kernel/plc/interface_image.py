# SPDX-License-Identifier: MIT
"""The image of the HLI that a PLC sees, kept equal to the cells of the memory (RC-301).

A table maps variables to bytes (``hli/positions.py``, and for the packed V.E
``lists/machine/external/variables_layout.py``). ``latch`` takes over what the PLC has written where
writing is allowed: bytes that differ from those published last. ``publish`` writes the variables
that have changed since, the slots of technology functions (``image_slots.py``) and the clock.
Numbers have the byte order of the processor. A REAL64 that is not finite is refused: the variable
keeps its value, the image gets it back, and the first time of each variable is reported (21820,
21821).
"""

from __future__ import annotations

from nctakt.kernel import cells, codes, rows
from nctakt.kernel.base import arithmetic
from nctakt.kernel.base.arrays import doubles, integers
from nctakt.kernel.base.bounds import check_index, check_range
from nctakt.kernel.base.record import Record
from nctakt.kernel.plc.image_slots import Units

#: Kinds of entries by the names of their types; STRING and VSTRING are bytes.
KINDS = {
    "BOOLEAN": codes.IMAGE_BOOLEAN,
    "SGN08": codes.IMAGE_SGN08,
    "UNS08": codes.IMAGE_UNS08,
    "SGN16": codes.IMAGE_SGN16,
    "UNS16": codes.IMAGE_UNS16,
    "SGN32": codes.IMAGE_SGN32,
    "UNS32": codes.IMAGE_UNS32,
    "REAL64": codes.IMAGE_REAL64,
    "STRING": codes.IMAGE_STRING,
    "VSTRING": codes.IMAGE_STRING,
}


class InterfaceImage:
    """The image of one machine; while no image is attached it costs nothing."""

    def __init__(self, memory: bytearray, record: Record) -> None:
        self.cells = memoryview(memory).cast("d")
        self.words = memoryview(memory).cast("q")
        self.characters = memoryview(memory)
        self.record = record
        scratch = memoryview(bytearray(8))
        self.scratch = scratch
        self.as_signed_8 = scratch.cast("b")
        self.as_signed_16 = scratch.cast("h")
        self.as_unsigned_16 = scratch.cast("H")
        self.as_signed_32 = scratch.cast("i")
        self.as_unsigned_32 = scratch.cast("I")
        self.as_real = scratch.cast("d")
        self.refused_capacity = 2 * len(self.words)
        self.refused_cells = integers(self.refused_capacity)
        self.refused_count = 0
        self.refused_reported = 0
        self.reports_to = self
        self.detach()

    # --- Python's side, between two runs --------------------------------------------------------

    def attach(
        self,
        image: memoryview,
        published: memoryview,
        table: list[tuple[int, int, int, int, bool, float]],
        units: Units,
        clock: int,
        first_input: int,
        ticks: int,
    ) -> None:
        """Show the variables of ``table`` and the ``units`` in ``image``, as they are
        now.

        ``image``: writable bytes, a multiple of 8, ``published``: as many of ours. A row
        of the table: first byte, kind, first cell, bytes of the variable, whether the PLC may write
        it, how many of its units one of the cell's is. ``clock``: the first byte of sequence and
        tick; ``first_input``: from there on the PLC writes; ``ticks``: how many have been run.
        """
        count = len(table)
        check_range(len(published), len(image), len(image), "length of the published image")
        check_range(clock, 0, len(image) - 16, "byte of the clock")
        check_range(first_input, 0, len(image), "first byte of the inputs")
        self.check_table(table, len(image))
        self.image = image
        self.image_words = image.cast("q")
        self.published = published
        self.published_words = published.cast("q")
        self.units = units
        self.clock_word = clock // 8
        self.first_input_word = first_input // 8
        self.hold_table(table)
        self.count = count
        self.event_bound = sum(
            1 for _, kind, _, _, is_input, _ in table if is_input and kind == codes.IMAGE_REAL64
        )
        self.word_count = len(image) // 8
        self.publish(ticks)
        self.is_attached = True

    def check_table(self, table: list[tuple[int, int, int, int, bool, float]], length: int) -> None:
        """Raise ``ValueError`` if a variable exceeds an image of ``length`` bytes or the cells."""
        for offset, kind, cell, size, _, factor in table:
            if not factor > 0.0:
                raise ValueError(f"a factor of {factor}")
            check_range(offset, 0, length - size, "byte of a variable")
            check_range(kind, codes.IMAGE_BOOLEAN, codes.IMAGE_STRING, "kind of a variable")
            max_size = length if kind == codes.IMAGE_STRING else len(self.scratch)
            check_range(size, 1, max_size, "bytes of a variable")
            check_range(cell, 0, len(self.cells) - -(-size // 8), "cell of a variable")

    def hold_table(self, table: list[tuple[int, int, int, int, bool, float]]) -> None:
        """Hold the variables of a table, each with a shadow of its cells, all of them stale."""
        count = len(table)
        self.is_input = integers(count + 1)
        self.factor = doubles(count + 1)
        self.is_scaled = integers(count + 1)
        self.offset = integers(count + 1)
        self.kind = integers(count + 1)
        self.cell = integers(count + 1)
        self.size = integers(count + 1)
        self.cell_count = integers(count + 1)
        self.first_shadow = integers(count + 1)
        self.is_stale = integers(count + 1)
        self.was_refused = integers(count + 1)
        shadows = sum(-(-size // 8) for _, _, _, size, _, _ in table)
        self.shadow = integers(shadows + 1)
        self.shadowed_cell = integers(shadows + 1)
        self.shadowed_entry = integers(shadows + 1)
        self.shadow_count = 0
        self.stale_count = count
        for i, (offset, kind, cell, size, is_input, factor) in enumerate(table):
            self.is_input[i] = is_input
            self.factor[i] = factor
            self.is_scaled[i] = bool(factor - 1.0)
            self.offset[i] = offset
            self.kind[i] = kind
            self.cell[i] = cell
            self.size[i] = size
            self.first_shadow[i] = self.shadow_count
            self.cell_count[i] = -(-size // 8)
            self.is_stale[i] = 1
            for further in range(-(-size // 8)):
                self.shadowed_cell[self.shadow_count] = cell + further
                self.shadowed_entry[self.shadow_count] = i
                self.shadow_count += 1

    def detach(self) -> None:
        """Forget the image; nothing holds its bytes any longer."""
        nothing = memoryview(bytearray(8))
        self.is_attached = False
        self.count = 0
        self.shadow_count = 0
        self.stale_count = 0
        self.event_bound = 0
        self.word_count = 0
        self.clock_word = 0
        self.first_input_word = 0
        self.units = Units()
        self.is_input = nothing.cast("q")
        self.factor = nothing.cast("d")
        self.is_scaled = nothing.cast("q")
        self.image = nothing
        self.image_words = nothing.cast("q")
        self.published = nothing
        self.published_words = nothing.cast("q")
        self.offset = nothing.cast("q")
        self.kind = nothing.cast("q")
        self.cell = nothing.cast("q")
        self.size = nothing.cast("q")
        self.cell_count = nothing.cast("q")
        self.first_shadow = nothing.cast("q")
        self.is_stale = nothing.cast("q")
        self.was_refused = nothing.cast("q")
        self.shadow = nothing.cast("q")
        self.shadowed_cell = nothing.cast("q")
        self.shadowed_entry = nothing.cast("q")

    def report_to(self, image: InterfaceImage) -> None:
        """Let another image keep track of refused values, in the same order."""
        self.reports_to = image

    def next_refused(self) -> int:
        """Cell of the next 900346 not asked for yet, in the order of the events."""
        check_index(self.refused_reported, self.refused_count, "refused value")
        cell = self.refused_cells[self.refused_reported % self.refused_capacity]
        self.refused_reported += 1
        return cell

    def note_refused(self, cell: int) -> None:
        """Keep the cell of a refused value until it is asked for."""
        slot = self.refused_count
        while slot >= self.refused_capacity:
            slot -= self.refused_capacity
        self.refused_cells[slot] = cell
        self.refused_count += 1

    # --- the tick -------------------------------------------------------------------------------

    def latch(self) -> None:
        """Take over the bytes that were written into the image since it was published."""
        if self.is_as_published():
            return
        self.units.latch()
        for i in range(self.count):
            if self.is_input[i] and self.has_changed(i):
                if self.kind[i] == codes.IMAGE_STRING:
                    self.take_string(i)
                else:
                    self.take_number(i)

    def is_as_published(self) -> int:
        """Return whether no byte has changed that the PLC writes."""
        for i in range(self.first_input_word, self.word_count):
            if self.image_words[i] != self.published_words[i]:
                return 0
        return 1

    def has_changed(self, entry: int) -> int:
        """Return whether a byte of this variable has changed."""
        first = self.offset[entry]
        for i in range(first, first + self.size[entry]):
            if self.image[i] != self.published[i]:
                return 1
        return 0

    def take_string(self, entry: int) -> None:
        """Copy a string into the memory."""
        first = self.offset[entry]
        character = 8 * self.cell[entry]
        for i in range(self.size[entry]):
            self.characters[character + i] = self.published[first + i] = self.image[first + i]
        self.remember(entry)

    def take_number(self, entry: int) -> None:
        """Convert a number into its cell; truth values become 0 or 1."""
        first = self.offset[entry]
        cell = self.cell[entry]
        for i in range(self.size[entry]):
            # read once only: the other process may be writing
            self.scratch[i] = self.published[first + i] = self.image[first + i]
        value = self.number(int(self.kind[entry]))
        if value - value != 0.0:
            self.refuse(entry, value)
            return
        self.cells[cell] = value / self.factor[entry]
        self.remember(entry)
        if self.kind[entry] == codes.IMAGE_BOOLEAN and self.scratch[0] > 1:
            self.mark_stale(entry)

    def refuse(self, entry: int, value: float) -> None:
        """Refuse an infinite number (21820) or NaN (21821), and report it once."""
        self.mark_stale(entry)
        if self.was_refused[entry] == 0:
            self.was_refused[entry] = 1
            self.event_bound -= 1
            self.reports_to.note_refused(self.cell[entry])
            self.record.event(rows.EVENT_ERROR, 0, 0, 21820 if value == value else 21821)

    def number(self, kind: int) -> float:
        """Number in the scratch bytes."""
        if kind == codes.IMAGE_BOOLEAN:
            return 1.0 if self.scratch[0] else 0.0
        if kind == codes.IMAGE_SGN08:
            return self.as_signed_8[0]
        if kind == codes.IMAGE_UNS08:
            return self.scratch[0]
        if kind == codes.IMAGE_SGN16:
            return self.as_signed_16[0]
        if kind == codes.IMAGE_UNS16:
            return self.as_unsigned_16[0]
        if kind == codes.IMAGE_SGN32:
            return self.as_signed_32[0]
        if kind == codes.IMAGE_UNS32:
            return self.as_unsigned_32[0]
        return self.as_real[0]

    def remember(self, entry: int) -> None:
        """Note the contents of the variable's cells, which are in the image now."""
        first = self.first_shadow[entry]
        cell = self.cell[entry]
        for i in range(self.cell_count[entry]):
            self.shadow[first + i] = self.words[cell + i]

    def mark_stale(self, entry: int) -> None:
        """Mark a variable to be written although its cell is unchanged."""
        if self.is_stale[entry] == 0:
            self.is_stale[entry] = 1
            self.stale_count += 1

    def publish(self, ticks: int) -> None:
        """Write all changes since the image was last published; ``ticks`` have run so far.

        The sequence is odd meanwhile.
        """
        self.image_words[self.clock_word + cells.CLOCK_SEQUENCE] += 1
        self.units.publish()
        self.publish_cells()
        self.image_words[self.clock_word + cells.CLOCK_TICK] = ticks
        self.image_words[self.clock_word + cells.CLOCK_SEQUENCE] += 1

    def publish_cells(self) -> None:
        """Write the variables that have changed or are marked."""
        for i in range(self.shadow_count):
            if self.words[self.shadowed_cell[i]] != self.shadow[i]:
                self.put(self.shadowed_entry[i])
        if self.stale_count > 0:
            for i in range(self.count):
                if self.is_stale[i]:
                    self.put(i)

    def put(self, entry: int) -> None:
        """Write a variable into the image."""
        self.remember(entry)
        if self.is_stale[entry]:
            self.is_stale[entry] = 0
            self.stale_count -= 1
        if self.kind[entry] == codes.IMAGE_STRING:
            self.put_string(entry)
        else:
            self.put_number(entry)

    def put_string(self, entry: int) -> None:
        """Copy a string into the image."""
        first = self.offset[entry]
        character = 8 * self.cell[entry]
        for i in range(self.size[entry]):
            self.image[first + i] = self.published[first + i] = self.characters[character + i]

    def put_number(self, entry: int) -> None:
        """Convert a number into the image; cells of integers contain values that fit their type.

        In another unit it is rounded and bounded.
        """
        first = self.offset[entry]
        value = self.cells[self.cell[entry]]
        if self.is_scaled[entry]:
            value = arithmetic.round_half_even(value * self.factor[entry])
            if self.kind[entry] == codes.IMAGE_UNS16:
                value = min(max(value, 0.0), 65535.0)
            else:
                value = min(max(value, -2147483648.0), 2147483647.0)
        self.set_number(int(self.kind[entry]), value)
        for i in range(self.size[entry]):
            self.image[first + i] = self.published[first + i] = self.scratch[i]

    def set_number(self, kind: int, value: float) -> None:
        """Put a number into the scratch bytes."""
        if kind == codes.IMAGE_SGN08:
            self.as_signed_8[0] = int(value)
        elif kind in (codes.IMAGE_BOOLEAN, codes.IMAGE_UNS08):
            self.scratch[0] = int(value)
        elif kind == codes.IMAGE_SGN16:
            self.as_signed_16[0] = int(value)
        elif kind == codes.IMAGE_UNS16:
            self.as_unsigned_16[0] = int(value)
        elif kind == codes.IMAGE_SGN32:
            self.as_signed_32[0] = int(value)
        elif kind == codes.IMAGE_UNS32:
            # the bits of a signed number: a long of 32 bits can hold no larger ones
            if value > 2147483647.0:
                value -= 4294967296.0
            self.as_signed_32[0] = int(value)
        else:
            self.as_real[0] = value
