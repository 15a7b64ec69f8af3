# SPDX-License-Identifier: MIT
"""The image of the HLI that a PLC sees, kept equal to the cells of the memory (RC-301).

A table maps variables to bytes (``hli/positions.py``, and for the packed V.E
``lists/machine/external/variables_layout.py``). ``latch`` takes over what the PLC has written where
writing is allowed: bytes that differ from those published last. ``publish`` writes the variables
that have changed since, the slots of technology functions (``image_slots.py``) and the clock. A
REAL64 that is not finite is refused: the variable keeps its value, the image gets it back, and the
first time of each variable is reported (21820, 21821).
"""

from __future__ import annotations

from nctakt.kernel import cells, codes, rows
from nctakt.kernel.base import arithmetic
from nctakt.kernel.base.arrays import doubles, integers
from nctakt.kernel.base.bounds import check_index, check_range
from nctakt.kernel.base.record import Record
from nctakt.kernel.plc.image_bytes import ImageBytes, NumberBytes
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


#: A variable of an image: first byte, kind, first cell, bytes, whether the PLC may write it, how
#: many of its units one of the cell's is.
ImageRow = tuple[int, int, int, int, bool, float]


class ImageTable:
    """The variables of an image, each with a shadow: the content of its cells that the image has.

    A variable that is stale is written although its cell is unchanged; at first all are.
    """

    def __init__(self, memory: bytearray, rows: list[ImageRow], length: int) -> None:
        """Raise ``ValueError`` if a variable exceeds ``length`` bytes of image or the cells."""
        self.words = memoryview(memory).cast("q")
        self.check(rows, length)
        count = len(rows)
        self.count = count
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
        shadows = sum(-(-size // 8) for _, _, _, size, _, _ in rows)
        self.shadow = integers(shadows + 1)
        self.shadowed_cell = integers(shadows + 1)
        self.shadowed_entry = integers(shadows + 1)
        self.shadow_count = 0
        self.stale_count = count
        for i, (offset, kind, cell, size, is_input, factor) in enumerate(rows):
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

    def check(self, rows: list[ImageRow], length: int) -> None:
        """Raise ``ValueError`` if a variable exceeds an image of ``length`` bytes or the cells."""
        for offset, kind, cell, size, _, factor in rows:
            if not factor > 0.0:
                raise ValueError(f"a factor of {factor}")
            check_range(offset, 0, length - size, "byte of a variable")
            check_range(kind, codes.IMAGE_BOOLEAN, codes.IMAGE_STRING, "kind of a variable")
            max_size = length if kind == codes.IMAGE_STRING else 8
            check_range(size, 1, max_size, "bytes of a variable")
            check_range(cell, 0, len(self.words) - -(-size // 8), "cell of a variable")

    def next_changed(self, first: int) -> int:
        """Return the next shadow from ``first`` on that differs from its cell, else their count."""
        for i in range(first, self.shadow_count):
            if self.words[self.shadowed_cell[i]] != self.shadow[i]:
                return i
        return self.shadow_count

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

    def mark_written(self, entry: int) -> None:
        """Note that the variable is being written."""
        self.remember(entry)
        if self.is_stale[entry]:
            self.is_stale[entry] = 0
            self.stale_count -= 1


class RefusedValues:
    """The cells of refused values until they are asked for, in the order of the events."""

    def __init__(self, capacity: int) -> None:
        self.capacity = capacity
        self.cells = integers(capacity)
        self.count = 0
        self.reported = 0

    def next_cell(self) -> int:
        """Return the cell of the next value not asked for yet."""
        check_index(self.reported, self.count, "refused value")
        cell = self.cells[self.reported % self.capacity]
        self.reported += 1
        return cell

    def note(self, cell: int) -> None:
        """Keep the cell of a refused value until it is asked for."""
        slot = self.count
        while slot >= self.capacity:
            slot -= self.capacity
        self.cells[slot] = cell
        self.count += 1


class InterfaceImage:
    """The image of one machine; while no image is attached it costs nothing."""

    def __init__(self, memory: bytearray, record: Record) -> None:
        self.cells = memoryview(memory).cast("d")
        self.characters = memoryview(memory)
        self.memory = memory
        self.record = record
        self.number = NumberBytes()
        self.refused = RefusedValues(2 * len(self.cells))
        self.detach()

    # --- Python's side, between two runs --------------------------------------------------------

    def attach(
        self,
        shown: ImageBytes,
        rows: list[ImageRow],
        units: Units,
        clock: int,
        first_input: int,
        ticks: int,
    ) -> None:
        """Show the variables of ``rows`` and the ``units`` in an image, as they are now.

        ``clock``: the first byte of sequence and tick; ``first_input``: from there on the PLC
        writes; ``ticks``: how many have been run.
        """
        check_range(clock, 0, shown.count - 16, "byte of the clock")
        check_range(first_input, 0, shown.count, "first byte of the inputs")
        self.table = ImageTable(self.memory, rows, shown.count)
        self.bytes = shown
        self.units = units
        self.clock_word = clock // 8
        self.first_input_word = first_input // 8
        self.was_refused = integers(len(rows) + 1)
        self.event_bound = sum(
            1 for _, kind, _, _, is_input, _ in rows if is_input and kind == codes.IMAGE_REAL64
        )
        self.word_count = shown.count // 8
        self.publish(ticks)
        self.is_attached = True

    def detach(self) -> None:
        """Forget the image; nothing holds its bytes any longer."""
        nothing = memoryview(bytearray(8))
        self.is_attached = False
        self.event_bound = 0
        self.word_count = 0
        self.clock_word = 0
        self.first_input_word = 0
        self.units = Units()
        self.table = ImageTable(self.memory, [], 0)
        self.was_refused = integers(1)
        self.bytes = ImageBytes(nothing, nothing)

    def report_to(self, image: InterfaceImage) -> None:
        """Let another image keep track of refused values, in the same order."""
        self.refused = image.refused

    def next_refused(self) -> int:
        """Cell of the next refused value not asked for yet, in the order of the events."""
        return self.refused.next_cell()

    # --- the tick -------------------------------------------------------------------------------

    def latch(self) -> None:
        """Take over the bytes that were written into the image since it was published."""
        if self.is_as_published():
            return
        self.units.latch()
        for i in range(self.table.count):
            if self.table.is_input[i] and self.has_changed(i):
                if self.table.kind[i] == codes.IMAGE_STRING:
                    self.take_string(i)
                else:
                    self.take_number(i)

    def is_as_published(self) -> int:
        """Return whether no byte has changed that the PLC writes."""
        for i in range(self.first_input_word, self.word_count):
            if self.bytes.words[i] != self.bytes.published_words[i]:
                return 0
        return 1

    def has_changed(self, entry: int) -> int:
        """Return whether a byte of this variable has changed."""
        first = self.table.offset[entry]
        for i in range(first, first + self.table.size[entry]):
            if self.bytes.image[i] != self.bytes.published[i]:
                return 1
        return 0

    def take_string(self, entry: int) -> None:
        """Copy a string into the memory."""
        first = self.table.offset[entry]
        character = 8 * self.table.cell[entry]
        for i in range(self.table.size[entry]):
            self.bytes.published[first + i] = self.bytes.image[first + i]
            self.characters[character + i] = self.bytes.published[first + i]
        self.table.remember(entry)

    def take_number(self, entry: int) -> None:
        """Convert a number into its cell; truth values become 0 or 1."""
        first = self.table.offset[entry]
        cell = self.table.cell[entry]
        for i in range(self.table.size[entry]):
            # read once only: the other process may be writing
            self.number.scratch[i] = self.bytes.image[first + i]
            self.bytes.published[first + i] = self.number.scratch[i]
        value = self.number.value(int(self.table.kind[entry]))
        if value - value != 0.0:
            self.refuse(entry, value)
            return
        self.cells[cell] = value / self.table.factor[entry]
        self.table.remember(entry)
        if self.table.kind[entry] == codes.IMAGE_BOOLEAN and self.number.scratch[0] > 1:
            self.table.mark_stale(entry)

    def refuse(self, entry: int, value: float) -> None:
        """Refuse an infinite number (21820) or NaN (21821), and report it once."""
        self.table.mark_stale(entry)
        if self.was_refused[entry] == 0:
            self.was_refused[entry] = 1
            self.event_bound -= 1
            self.refused.note(self.table.cell[entry])
            self.record.event(rows.EVENT_ERROR, 0, 0, 21820 if value == value else 21821)

    def publish(self, ticks: int) -> None:
        """Write all changes since the image was last published; ``ticks`` have run so far.

        The sequence is odd meanwhile.
        """
        self.bytes.words[self.clock_word + cells.CLOCK_SEQUENCE] += 1
        self.units.publish()
        self.publish_cells()
        self.bytes.words[self.clock_word + cells.CLOCK_TICK] = ticks
        self.bytes.words[self.clock_word + cells.CLOCK_SEQUENCE] += 1

    def publish_cells(self) -> None:
        """Write the variables that have changed or are marked."""
        i = self.table.next_changed(0)
        while i < self.table.shadow_count:
            self.put(self.table.shadowed_entry[i])
            i = self.table.next_changed(i + 1)
        if self.table.stale_count > 0:
            for i in range(self.table.count):
                if self.table.is_stale[i]:
                    self.put(i)

    def put(self, entry: int) -> None:
        """Write a variable into the image."""
        self.table.mark_written(entry)
        if self.table.kind[entry] == codes.IMAGE_STRING:
            self.put_string(entry)
        else:
            self.put_number(entry)

    def put_string(self, entry: int) -> None:
        """Copy a string into the image."""
        first = self.table.offset[entry]
        character = 8 * self.table.cell[entry]
        for i in range(self.table.size[entry]):
            self.bytes.published[first + i] = self.characters[character + i]
            self.bytes.image[first + i] = self.bytes.published[first + i]

    def put_number(self, entry: int) -> None:
        """Convert a number into the image; cells of integers contain values that fit their type.

        In another unit it is rounded and bounded.
        """
        value = self.cells[self.table.cell[entry]]
        if self.table.is_scaled[entry]:
            value = arithmetic.round_half_even(value * self.table.factor[entry])
            if self.table.kind[entry] == codes.IMAGE_UNS16:
                value = min(max(value, 0.0), 65535.0)
            else:
                value = min(max(value, -2147483648.0), 2147483647.0)
        self.number.put(int(self.table.kind[entry]), value)
        self.bytes.put(self.table.offset[entry], self.number, self.table.size[entry])
