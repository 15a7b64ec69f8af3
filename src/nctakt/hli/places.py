# SPDX-License-Identifier: MIT
"""Where each value of the HLI stands in the image of a machine, byte by byte.

In: the declarations of ``hli/layout.py``, a machine. Out: places of values in their structures, and
``ImageLayout``: places of the structures in the image. A value stands at a multiple of its own
size, as a C compiler puts it; a structure takes a multiple of 8 bytes. What the CNC alone writes
comes first, with the PLC's turn of the lockstep among it; then what the tick latches: the PLC's
commands, and the V.E variables, which both write.
"""

from __future__ import annotations

from collections.abc import Iterator

from nctakt.base.dataclass import dataclass
from nctakt.hli.layout import (
    AXIS,
    CHANNEL,
    COMMAND,
    HEADER,
    LINK,
    SPINDLE,
    SPINDLE_COMMAND,
    TYPE_BYTES,
    UNIT,
    Entry,
    Structure,
)
from nctakt.hli.variables_memory import image_bytes
from nctakt.kernel.plc.technology_slots import SLOT_COUNT
from nctakt.lists.machine.machine import Machine

#: Areas begin at multiples of this: a cache line.
AREA_ALIGNMENT = 64


@dataclass(frozen=True, slots=True)
class PlacedEntry:
    """A value with its first byte in its structure."""

    entry: Entry
    offset: int

    @property
    def size_bytes(self) -> int:
        """Of all its elements."""
        return TYPE_BYTES[self.entry.type] * max(1, self.entry.count)


def entries(structure: Structure) -> Iterator[PlacedEntry]:
    """The values of a structure with their places; not its units."""
    end = 0
    for entry in structure.entries:
        placed = PlacedEntry(entry, _aligned(end, TYPE_BYTES[entry.type]))
        end = placed.offset + placed.size_bytes
        yield placed


def entry(structure: Structure, name: str) -> PlacedEntry:
    """One value of a structure by its name."""
    return next(placed for placed in entries(structure) if placed.entry.name == name)


def unit_offset(structure: Structure, name: str) -> int:
    """The first byte of an array of units in a structure."""
    return _entries_end(structure) + structure.units.index(name) * SLOT_COUNT * size_of(UNIT)


def size_of(structure: Structure) -> int:
    """Bytes of a structure."""
    units = len(structure.units) * SLOT_COUNT
    return _entries_end(structure) + (units * size_of(UNIT) if units else 0)


def _entries_end(structure: Structure) -> int:
    *_, last = entries(structure)
    return _aligned(last.offset + last.size_bytes, 8)


def _aligned(offset: int, alignment: int) -> int:
    return -(-offset // alignment) * alignment


@dataclass(frozen=True, slots=True)
class ImageLayout:
    """The areas of a machine's image: first bytes, and how many structures stand there."""

    channels: int
    axes: int
    spindles: int
    link_offset: int
    channel_offset: int
    axis_offset: int
    spindle_offset: int
    command_offset: int
    spindle_command_offset: int
    ve_offset: int
    ve_size: int

    @property
    def size(self) -> int:
        """Bytes of the whole image."""
        return self.ve_offset + self.ve_size

    def channel(self, index: int) -> int:
        """The first byte of a channel's state."""
        return self.channel_offset + index * size_of(CHANNEL)

    def axis(self, index: int) -> int:
        """The first byte of an axis."""
        return self.axis_offset + index * size_of(AXIS)

    def spindle(self, index: int) -> int:
        """The first byte of a spindle, counted over all channels."""
        return self.spindle_offset + index * size_of(SPINDLE)

    def spindle_command(self, index: int) -> int:
        """The first byte of the PLC's answer for a spindle."""
        return self.spindle_command_offset + index * size_of(SPINDLE_COMMAND)

    def command(self, index: int) -> int:
        """The first byte of what the PLC commands a channel."""
        return self.command_offset + index * size_of(COMMAND)


def image_layout(machine: Machine) -> ImageLayout:
    """The places in the image of a machine."""
    channels, axes = len(machine.channels), len(machine.axes)
    spindles = sum(len(channel.parameters.spindles) for channel in machine.channels)
    link_offset = _aligned(size_of(HEADER), AREA_ALIGNMENT)
    channel_offset = _aligned(link_offset + size_of(LINK), AREA_ALIGNMENT)
    axis_offset = _aligned(channel_offset + channels * size_of(CHANNEL), AREA_ALIGNMENT)
    spindle_offset = _aligned(axis_offset + axes * size_of(AXIS), AREA_ALIGNMENT)
    command_offset = _aligned(spindle_offset + spindles * size_of(SPINDLE), AREA_ALIGNMENT)
    answer_offset = _aligned(command_offset + channels * size_of(COMMAND), AREA_ALIGNMENT)
    return ImageLayout(
        channels,
        axes,
        spindles,
        link_offset,
        channel_offset,
        axis_offset,
        spindle_offset,
        command_offset,
        answer_offset,
        _aligned(answer_offset + spindles * size_of(SPINDLE_COMMAND), AREA_ALIGNMENT),
        image_bytes(machine),
    )
