# SPDX-License-Identifier: MIT
"""The live image of the HLI: one memory with the packed V.E variables in it.

In: a running controller (``Controller.interface_image``). Out: its HLI in memory of this process or
in named shared memory; the layout is that of ``nctakt.hli``. The V.E variables have one section for
GLOBAL and one for each channel; V.CH is in none of them. Writes of the PLC count from the next tick
on; results of a tick are in the image at its end (``kernel/plc/interface_image.py``).
"""

from __future__ import annotations

import contextlib
import os
import struct
import weakref
from collections.abc import Iterator, Sequence
from types import TracebackType
from typing import TYPE_CHECKING

from nctakt.base.diagnostics import Text
from nctakt.base.failure import Failure
from nctakt.base.python_process import start_resource_tracker
from nctakt.hli.layout import (
    AXIS,
    CHANNEL,
    COMMAND,
    HEADER,
    LAMPS,
    LINK,
    MAGIC,
    PANEL,
    SPINDLE,
    SPINDLE_COMMAND,
    SPINDLE_OVERRIDE,
    VERSION,
    Structure,
)
from nctakt.hli.places import (
    ImageLayout,
    PlacedEntry,
    entries,
    entry,
    image_layout,
    size_of,
    unit_offset,
)
from nctakt.hli.variable_names import describe_names
from nctakt.hli.variables_memory import Section, sections
from nctakt.kernel.cells import IDENTIFIER_PROGRAM, POS_RT
from nctakt.kernel.cells import SPINDLE_OVERRIDE as OVERRIDE_CELL
from nctakt.kernel.kernel import Kernel
from nctakt.kernel.plc.image_bytes import ImageBytes
from nctakt.kernel.plc.image_slots import SectionUnits, SpindleUnits, Units
from nctakt.kernel.plc.interface_image import KINDS
from nctakt.kernel.tick.channel import Channel
from nctakt.lists.machine.channel_configuration import Spindle
from nctakt.lists.machine.external.variables_layout import fields, pack_of
from nctakt.lists.machine.machine import Machine
from nctakt.messages import diagnostic
from nctakt.messages.machines.memory import (
    HLI_IMAGE_EXISTS,
    SHARED_MEMORY_EXISTS,
    SHARED_MEMORY_IN_USE,
    SHARED_MEMORY_NOT_AVAILABLE,
)
from nctakt.nc.vocabulary.variables.cells import CELL_BYTES
from nctakt.nc.vocabulary.variables.realtime_variables import SPINDLE_VALUES
from nctakt.nc.vocabulary.variables.variable_table import Layout
from nctakt.run.access.image_inputs import ImageInputs
from nctakt.run.technology_tables import types_of

if TYPE_CHECKING:
    from multiprocessing.shared_memory import SharedMemory

#: A row of ``kernel.plc.interface_image``: byte, kind, cell, bytes, whether the PLC may write it,
#: how many of its units one of the cell is.
_Row = tuple[int, int, int, int, bool, float]


class SharedImage:
    """The live image of a controller; also a context manager.

    ``memory``: all its bytes, at the offsets of ``layout``; ``external``: the bytes of the V.E
    variables, of which ``section`` returns those of one scope; ``inputs``: the PLC's writes since
    the latest tick. ``name``: the name of the shared memory, ``None`` without. Closing releases the
    views and removes the shared memory; this happens at the latest with the end of the controller,
    and by Python's resource tracker if the process is killed.
    """

    def __init__(
        self,
        machine: Machine,
        kernel: Kernel,
        channels: Sequence[Channel],
        cells: Layout,
        name: str | None = None,
    ) -> None:
        """``channels``: those of the realtime part; ``cells``: the layout of its memory."""
        if kernel.image.is_attached:
            raise Failure(diagnostic(HLI_IMAGE_EXISTS))
        self.name = name
        self.layout = layout = image_layout(machine)
        self._sections = sections(machine)
        shared = None if name is None else _create(name, layout.size)
        buffer = memoryview(bytearray(layout.size)) if shared is None else shared.buf
        assert buffer is not None
        self.memory = buffer[: layout.size]
        self.external = self.memory[layout.ve_offset :]
        _put_header(self.memory, layout, machine)
        published = memoryview(bytearray(layout.size))
        shown = ImageBytes(self.memory, published)
        pack = pack_of(machine.startup.member_alignment)
        kernel.image.attach(
            shown,
            [*_hli_rows(layout, cells), *_external_rows(layout, self._sections, pack, cells)],
            _units(channels, shown, layout, machine),
            entry(HEADER, "sequence").offset,
            layout.command_offset,
            kernel.tick,
        )
        self._put_header_value("ready", 1)
        self.inputs = ImageInputs(layout, self._sections, self.memory, published)
        self._resources = _Resources(kernel, (self.inputs, self.external, self.memory), shared)
        self._last_resort = weakref.finalize(self, self._resources.give_up)

    def section(self, channel: int = 0) -> memoryview:
        """Return the writable bytes of the V.E variables of a channel; 0: those of GLOBAL.

        Release them before the image is closed.
        """
        section = self._sections[channel]
        return self.external[section.offset : section.offset + section.size_bytes]

    # --- the handshake --------------------------------------------------------------------------

    @property
    def plc_is_present(self) -> bool:
        """Whether a PLC reports its presence: ``plc_present`` of the first channel."""
        offset = self.layout.command(0) + entry(COMMAND, "plc_present").offset
        return self.memory[offset] != 0

    @property
    def plc_process(self) -> int:
        """The ID of the PLC's process as the PLC reports it, 0 without a report."""
        offset = self.layout.link_offset + entry(LINK, "process").offset
        return int(struct.unpack_from("=Q", self.memory, offset)[0])

    def announce_lockstep(self) -> None:
        """Inform the PLC that the CNC waits for it after each tick."""
        self._put_header_value("lockstep", 1)

    def hand_over(self) -> None:
        """Give the turn to the PLC."""
        offset = entry(HEADER, "turn").offset
        (turn,) = struct.unpack_from("=Q", self.memory, offset)
        struct.pack_into("=Q", self.memory, offset, turn + 1)

    @property
    def is_handed_back(self) -> bool:
        """Whether the PLC has answered since ``hand_over``."""
        offset = self.layout.link_offset + entry(LINK, "turn").offset
        (ours,) = struct.unpack_from("=Q", self.memory, entry(HEADER, "turn").offset)
        (theirs,) = struct.unpack_from("=Q", self.memory, offset)
        return bool(ours == theirs)

    def _put_header_value(self, name: str, value: int) -> None:
        struct.pack_into("=I", self.memory, entry(HEADER, name).offset, value)

    # --- the end --------------------------------------------------------------------------------

    @property
    def is_closed(self) -> bool:
        """Whether it is detached from the controller."""
        return self._resources.kernel is None

    def close(self) -> None:
        """Detach the image from the controller; a closed image stays closed.

        Raises ``Failure`` (900348) while views of the shared memory exist: release them and close
        it again. From the first attempt on the shared memory cannot be opened any more.
        """
        self._resources.close()
        self._last_resort.detach()

    def __enter__(self) -> SharedImage:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        self.close()


class _Resources:
    """The resources of an image, released in the right order: kernel, views, shared memory."""

    def __init__(
        self,
        kernel: Kernel,
        views: tuple[ImageInputs, memoryview, memoryview],
        shared: SharedMemory | None,
    ) -> None:
        self.kernel: Kernel | None = kernel
        self._views = views
        self._shared = shared

    def close(self) -> None:
        """Release everything still held; raises ``Failure`` (900348)."""
        if self.kernel is not None:
            struct.pack_into("=I", self._views[-1], entry(HEADER, "ready").offset, 0)
            self.kernel.image.detach()
            self.kernel = None
            if self._shared is not None:
                self._shared.unlink()
        try:
            for view in self._views:
                view.release()
            if self._shared is not None:
                self._shared.close()
        except BufferError as error:
            raise Failure(diagnostic(SHARED_MEMORY_IN_USE)) from error
        self._shared = None

    def give_up(self) -> None:
        """Finalizer: close without raising."""
        with contextlib.suppress(Failure):
            self.close()


def _put_header(memory: memoryview, layout: ImageLayout, machine: Machine) -> None:
    """Write the constant values: the header, names and numbers of axes and spindles."""
    values = {
        "version": VERSION,
        "size": layout.size,
        "cycle_time_us": machine.cycle_time_us,
        "channels": layout.channels,
        "channel_offset": layout.channel_offset,
        "channel_size": size_of(CHANNEL),
        "axes": layout.axes,
        "axis_offset": layout.axis_offset,
        "axis_size": size_of(AXIS),
        "spindles": layout.spindles,
        "spindle_offset": layout.spindle_offset,
        "spindle_size": size_of(SPINDLE),
        "spindle_command_offset": layout.spindle_command_offset,
        "spindle_command_size": size_of(SPINDLE_COMMAND),
        "command_offset": layout.command_offset,
        "command_size": size_of(COMMAND),
        "link_offset": layout.link_offset,
        "ve_offset": layout.ve_offset,
        "ve_size": layout.ve_size,
        "names_offset": layout.names_offset,
        "names_size": layout.names_size,
    }
    for name, value in values.items():
        struct.pack_into("=I", memory, entry(HEADER, name).offset, value)
    struct.pack_into("=Q", memory, entry(HEADER, "process").offset, os.getpid())
    memory[layout.names_offset : layout.names_offset + layout.names_size] = describe_names(machine)
    memory[: len(MAGIC)] = MAGIC
    for index, axis in enumerate(machine.axes):
        _put_name(memory, AXIS, layout.axis(index), axis.name)
        _put_number(memory, AXIS, layout.axis(index), "logical", axis.logical_number)
    for index, (channel, spindle) in enumerate(_spindles(machine)):
        offset = layout.spindle(index)
        _put_name(memory, SPINDLE, offset, spindle.name)
        _put_number(memory, SPINDLE, offset, "logical", spindle.logical_number)
        _put_number(memory, SPINDLE, offset, "channel", channel)
        _put_number(memory, SPINDLE, offset, "plc_controlled", int(spindle.plc_controlled))


def _spindles(machine: Machine) -> Iterator[tuple[int, Spindle]]:
    """Yield each spindle of the machine with the number of its channel."""
    for channel in machine.channels:
        for spindle in channel.parameters.spindles:
            yield channel.number, spindle


def _put_name(memory: memoryview, structure: Structure, first: int, name: str) -> None:
    placed = entry(structure, "name")
    characters = name.encode("cp1252", "replace")[: placed.size_bytes - 1]
    offset = first + placed.offset
    memory[offset : offset + len(characters)] = characters


def _put_number(
    memory: memoryview, structure: Structure, first: int, name: str, value: int
) -> None:
    placed = entry(structure, name)
    code = "=H" if placed.size_bytes == 2 else "=I"
    struct.pack_into(code, memory, first + placed.offset, value)


def _hli_rows(layout: ImageLayout, cells: Layout) -> Iterator[_Row]:
    """Yield the rows of the states of channels and axes and of the PLC's commands."""
    for index in range(layout.channels):
        for placed in entries(CHANNEL):
            if placed.entry in LAMPS:
                cell = cells.panel_cell(index) + len(PANEL) + LAMPS.index(placed.entry)
            else:
                cell = cells.channel_value(index, placed.entry.source)
            yield _row(placed, layout.channel(index), cell, False)
        for placed in entries(COMMAND):
            if placed.entry in PANEL:
                cell = cells.panel_cell(index) + PANEL.index(placed.entry)
                yield _row(placed, layout.command(index), cell, True)
    for index in range(layout.axes):
        for placed in entries(AXIS):
            if placed.entry.source:
                cell = cells.axis_value(index, placed.entry.source)
                yield _row(placed, layout.axis(index), cell, False)
    for index in range(layout.spindles):
        first = cells.spindle_cell(0) + len(SPINDLE_VALUES) * index
        for column, value in enumerate(SPINDLE_VALUES):
            for placed in entries(SPINDLE):
                if placed.entry.source == value.path:
                    yield _row(placed, layout.spindle(index), first + column, False)
        placed = entry(SPINDLE_COMMAND, SPINDLE_OVERRIDE.name)
        yield _row(placed, layout.spindle_command(index), first + OVERRIDE_CELL, True)


def _row(placed: PlacedEntry, first: int, cell: int, is_input: bool) -> _Row:
    """Return the row of a value in a structure that begins at ``first``."""
    value = placed.entry
    kind, offset = KINDS[value.image_type], first + placed.offset
    return offset, kind, cell, placed.size_bytes, is_input, value.factor


def _external_rows(
    layout: ImageLayout, parts: Sequence[Section], pack: int, cells: Layout
) -> Iterator[_Row]:
    """Yield the rows of all numbers and strings of the V.E variables."""
    for section in parts:
        for placed in section.placed:
            cell = cells.external[(section.channel, placed.variable.name)]
            for field in fields(placed, pack):
                for index in range(max(1, field.count)):
                    offset = section.offset + field.offset + index * field.size_bytes
                    kind, at = KINDS[field.type], layout.ve_offset + offset
                    yield at, kind, cell, field.size_bytes, True, 1.0
                    cell += -(-field.size_bytes // CELL_BYTES)


def _units(
    channels: Sequence[Channel],
    shown: ImageBytes,
    layout: ImageLayout,
    machine: Machine,
) -> Units:
    """Return the waiting functions and spindle jobs, those of the last channel first."""
    units = Units()
    cycle_time_us = machine.cycle_time_us
    for index, channel in reversed(list(enumerate(channels))):
        hli, spindles = channel.hli, channel.context.spindles
        units = SpindleUnits(
            spindles,
            shown,
            layout.spindle(spindles.first_number) + entry(SPINDLE, "job").offset,
            size_of(SPINDLE),
            layout.spindle_command(spindles.first_number)
            + entry(SPINDLE_COMMAND, "ack_job").offset,
            size_of(SPINDLE_COMMAND),
            cycle_time_us,
            units,
        )
        types = types_of(machine.channels[index].parameters)
        for section, name, identifier in (
            (hli.realtime, "realtime", POS_RT),
            (hli.program, "program", IDENTIFIER_PROGRAM),
        ):
            units = SectionUnits(
                section,
                shown,
                layout.channel(index) + unit_offset(CHANNEL, name),
                layout.command(index) + entry(COMMAND, f"ack_{name}").offset,
                cycle_time_us,
                identifier,
                types,
                units,
            )
    return units


def _create(name: str, size: int) -> SharedMemory:
    """Return new shared memory, all zero.

    Python's resource tracker knows names of ASCII without colon and line end; it would refuse
    others after their creation.
    """
    from multiprocessing.shared_memory import SharedMemory  # noqa: PLC0415 - most runs have none

    if not (name.isascii() and name.isprintable()) or ":" in name:
        reason = Text("only ASCII characters, without colon", "nur ASCII-Zeichen ohne Doppelpunkt")
        raise Failure(diagnostic(SHARED_MEMORY_NOT_AVAILABLE, name=repr(name), reason=reason))
    start_resource_tracker()
    try:
        return SharedMemory(name, create=True, size=size)
    except FileExistsError as error:
        raise Failure(diagnostic(SHARED_MEMORY_EXISTS, name=name)) from error
    except (OSError, ValueError) as error:
        raise Failure(
            diagnostic(SHARED_MEMORY_NOT_AVAILABLE, name=name, reason=str(error))
        ) from error
