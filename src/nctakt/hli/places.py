# SPDX-License-Identifier: MIT
"""The offsets of the HLI's values in the image of a machine, in bytes.

In: the declarations of ``hli/layout.py``, a machine. Out: offsets of values in their structures,
and ``ImageLayout``: offsets of the structures in the image. The offset of a value is a multiple of
its size, as a C compiler aligns it; the size of a structure is a multiple of 8 bytes. The values
that only the CNC writes come first, with the PLC's turn of the lockstep among them, and the names
of the V.E variables; then the values that the tick latches: the PLC's commands, and the V.E
variables, which both write.
"""

from __future__ import annotations

from functools import cache

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
from nctakt.hli.variable_names import describe_names
from nctakt.hli.variables_memory import image_bytes
from nctakt.kernel.plc.technology_slots import SLOT_COUNT
from nctakt.lists.machine.machine import Machine

#: Alignment of the areas in bytes: a cache line.
AREA_ALIGNMENT = 64


@dataclass(frozen=True, slots=True)
class PlacedEntry:
    """A value and its offset in its structure, in bytes."""

    entry: Entry
    offset: int

    @property
    def size_bytes(self) -> int:
        """The size of all its elements."""
        return TYPE_BYTES[self.entry.image_type] * max(1, self.entry.count)


@cache
def entries(structure: Structure) -> tuple[PlacedEntry, ...]:
    """Return the values of a structure with their offsets, without its units."""
    end = 0
    found = []
    for entry in structure.entries:
        placed = PlacedEntry(entry, _aligned(end, TYPE_BYTES[entry.image_type]))
        end = placed.offset + placed.size_bytes
        found.append(placed)
    return tuple(found)


@cache
def entry(structure: Structure, name: str) -> PlacedEntry:
    """Return the value of a structure with this name, the short one or that in the image."""
    return next(
        placed for placed in entries(structure) if name in (placed.entry.name, placed.entry.member)
    )


@cache
def unit_offset(structure: Structure, name: str) -> int:
    """Return the offset of an array of units in a structure."""
    return _entries_end(structure) + structure.units.index(name) * SLOT_COUNT * size_of(UNIT)


@cache
def size_of(structure: Structure) -> int:
    """Return the size of a structure in bytes."""
    units = len(structure.units) * SLOT_COUNT
    return _entries_end(structure) + (units * size_of(UNIT) if units else 0)


def _entries_end(structure: Structure) -> int:
    *_, last = entries(structure)
    return _aligned(last.offset + last.size_bytes, 8)


def padding_of(structure: Structure) -> int:
    """Return the bytes after the last value of a structure, up to a multiple of 8."""
    *_, last = entries(structure)
    return -(last.offset + last.size_bytes) % 8


def _aligned(offset: int, alignment: int) -> int:
    return -(-offset // alignment) * alignment


@dataclass(frozen=True, slots=True)
class ImageLayout:
    """The areas of a machine's image: their offsets in bytes and the number of structures."""

    channels: int
    axes: int
    spindles: int
    link_offset: int
    channel_offset: int
    axis_offset: int
    spindle_offset: int
    names_offset: int
    names_size: int
    command_offset: int
    spindle_command_offset: int
    ve_offset: int
    ve_size: int

    @property
    def size(self) -> int:
        """The size of the whole image in bytes."""
        return self.ve_offset + self.ve_size

    def channel(self, index: int) -> int:
        """Return the offset of a channel's state."""
        return self.channel_offset + index * size_of(CHANNEL)

    def axis(self, index: int) -> int:
        """Return the offset of an axis."""
        return self.axis_offset + index * size_of(AXIS)

    def spindle(self, index: int) -> int:
        """Return the offset of a spindle, counted over all channels."""
        return self.spindle_offset + index * size_of(SPINDLE)

    def spindle_command(self, index: int) -> int:
        """Return the offset of the PLC's answer for a spindle."""
        return self.spindle_command_offset + index * size_of(SPINDLE_COMMAND)

    def command(self, index: int) -> int:
        """Return the offset of the PLC's commands for a channel."""
        return self.command_offset + index * size_of(COMMAND)


def image_layout(machine: Machine) -> ImageLayout:
    """Return the layout of a machine's image."""
    channels, axes = len(machine.channels), len(machine.axes)
    spindles = sum(len(channel.parameters.spindles) for channel in machine.channels)
    link_offset = _aligned(size_of(HEADER), AREA_ALIGNMENT)
    channel_offset = _aligned(link_offset + size_of(LINK), AREA_ALIGNMENT)
    axis_offset = _aligned(channel_offset + channels * size_of(CHANNEL), AREA_ALIGNMENT)
    spindle_offset = _aligned(axis_offset + axes * size_of(AXIS), AREA_ALIGNMENT)
    names_offset = _aligned(spindle_offset + spindles * size_of(SPINDLE), AREA_ALIGNMENT)
    names_size = len(describe_names(machine))
    command_offset = _aligned(names_offset + names_size, AREA_ALIGNMENT)
    answer_offset = _aligned(command_offset + channels * size_of(COMMAND), AREA_ALIGNMENT)
    return ImageLayout(
        channels,
        axes,
        spindles,
        link_offset,
        channel_offset,
        axis_offset,
        spindle_offset,
        names_offset,
        names_size,
        command_offset,
        answer_offset,
        _aligned(answer_offset + spindles * size_of(SPINDLE_COMMAND), AREA_ALIGNMENT),
        image_bytes(machine),
    )
