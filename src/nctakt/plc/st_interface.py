# SPDX-License-Identifier: MIT
"""The interface of a machine in the memory of a PLC in Structured Text (ST-761 … ST-764).

In: a machine, which pointers a translated program uses. Out: the initial bytes that these pointers
lead to, and the objects that keep them equal to the machine in each tick (``kernel.st.interface``).
Offsets come from the table of the interface (``hli.table``), meanings from
``hli.interface_memory``.
"""

from __future__ import annotations

import struct
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Diagnostic
from nctakt.hli import table
from nctakt.hli.function_units import LATE, STANDARD, USED
from nctakt.hli.interface_memory import (
    ERROR_FLAG,
    MODE,
    RELEASES,
    Area,
    NotWritable,
    Written,
    areas,
    slots,
)
from nctakt.hli.table import Tie
from nctakt.hli.variables_memory import sections
from nctakt.kernel.plc.image_bytes import ImageBytes
from nctakt.kernel.plc.image_slots import Units
from nctakt.kernel.plc.interface_image import KINDS, InterfaceImage
from nctakt.kernel.st import kinds
from nctakt.kernel.st.context import PlcContext
from nctakt.kernel.st.interface import (
    AxisReleases,
    ChannelRecords,
    CncInterface,
    ControlUnits,
    ShownValues,
)
from nctakt.kernel.st.technology import SectionSource, SpindleSource, UnitBanks, UnitSource
from nctakt.lists.machine.external.variables_layout import fields, pack_of
from nctakt.messages import diagnostic
from nctakt.messages.plcs.hli_table import NO_SUCH_TRANSITION
from nctakt.nc.vocabulary.variables.cells import CELL_BYTES
from nctakt.run.access.machine_names import prefix_of
from nctakt.run.access.presence import Presence
from nctakt.run.technology_tables import axes_of, types_of

if TYPE_CHECKING:
    from nctakt.run.realtime.assembly import AssembledMachine

#: Alignment of the areas, in bytes.
_ALIGNMENT = 64
#: The flag of a commanded transition.
_SEMAPHORE = "command_semaphor_rw"
#: Bytes of the clock before the V.E variables.
_CLOCK = 16

_KINDS = {
    "BOOL": kinds.BOOL, "BYTE": kinds.U8, "USINT": kinds.U8, "INT": kinds.I16, "UINT": kinds.U16,
    "WORD": kinds.U16, "DINT": kinds.I32, "UDINT": kinds.U32, "LREAL": kinds.F64,
}  # fmt: skip


@dataclass(slots=True)
class _Placed:
    """An area, and its address."""

    area: Area
    address: int

    def at(self, path: str) -> int:
        """Return the address of an element."""
        return self.address + slots(self.area.shape.root)[path].offset


@dataclass(slots=True)
class StInterface:
    """The interface of a machine for one program.

    ``begin``: its address in the program's memory. ``pointers``: the addresses that the pointers
    get, by root and index. ``content``: the bytes as they begin.
    """

    begin: int
    roots: Collection[str]
    placed: list[_Placed] = field(default_factory=list)
    pointers: dict[tuple[str, int], int] = field(default_factory=dict)
    content: bytearray = field(default_factory=bytearray)
    variables: int = 0

    def go_on(self, machine: AssembledMachine, context: PlcContext) -> Iterator[Diagnostic]:
        """Execute the operation mode transitions commanded by the PLC; yield mistakes.

        They are no inputs: a run that is repeated has them from its PLC.
        """
        signals = machine.signals()
        for one in self.placed:
            if (
                one.area.shape.root != "gpCh"
                or not context.peek(one.at(f"{MODE}.{_SEMAPHORE}"), 1)[0]
            ):
                continue
            one.area.memory[:] = context.peek(one.address, len(one.area.memory))
            one.area.announce()
            written = Written()
            values = {name: float(machine.cells[signals[name][0]]) for name in one.area.mode_names}
            try:
                one.area.take_transition(written, values)
            except NotWritable:
                path = f"{one.area.name}.{MODE}.command_w"
                yield replace(diagnostic(NO_SUCH_TRANSITION, path=path), is_lenient=True)
            context.poke(one.at(f"{MODE}.{_SEMAPHORE}"), b"\0")
            for channel, program in written.programs:
                if machine.inputs.on_select is not None:
                    machine.inputs.on_select(channel - 1, program)
            for name, value in written.values.items():
                machine.kernel.posted.post(signals[name][0], float(value))


def lay_out(machine: AssembledMachine, begin: int, roots: Collection[str]) -> StInterface:
    """Return the interface of a machine for the pointers that a program uses."""
    found = StInterface(begin, roots)
    count = len(machine.channels)
    prefixes = [prefix_of(index) if count > 1 else "" for index in range(count)]
    for root, group in areas(machine.configuration, prefixes).items():
        for area in group if is_used(root, roots) else ():
            address = _append(found, bytes(area.memory))
            found.placed.append(_Placed(area, address))
            found.pointers[root, area.shape.index] = address
    if "gpVECh" in roots or "gpVEGlob" in roots:
        parts = sections(machine.configuration)
        size = max(part.offset + part.size_bytes for part in parts)
        clock = _append(found, bytes(_CLOCK))
        found.variables = clock + _CLOCK
        _append(found, bytes(max(size, 1)))
        for part in parts:
            key = ("gpVECh", part.channel - 1) if part.channel else ("gpVEGlob", 0)
            found.pointers[key] = found.variables + part.offset
    return found


def names_of(machine: AssembledMachine, found: StInterface) -> dict[int, str]:
    """Return the names of the interface's elements by their addresses."""
    names = {}
    for one in found.placed:
        for path, slot in slots(one.area.shape.root).items():
            names[one.address + slot.offset] = f"{one.area.name}.{path}"
    if found.variables:
        pack = pack_of(machine.configuration.startup.member_alignment)
        several = len(machine.channels) > 1
        for part in sections(machine.configuration):
            prefix = prefix_of(part.channel - 1) if several and part.channel else ""
            for placed in part.placed:
                for item in fields(placed, pack):
                    for index in range(max(1, item.count)):
                        at = found.variables + part.offset + item.offset + index * item.size_bytes
                        element = f"[{index}]" if item.count else ""
                        names[at] = f"{prefix}V.E.{item.path}{element}"
    return names


def is_used(root: str, roots: Collection[str]) -> bool:
    """Return whether an area exists: channels and axes together, which share functions."""
    together = ("gpCh", "gpAx")
    return root in roots or (root in together and any(one in roots for one in together))


def _append(found: StInterface, content: bytes) -> int:
    """Append an area; return its address."""
    address = found.begin + len(found.content)
    found.content += content
    alignment = 16 if len(content) == _CLOCK else _ALIGNMENT
    found.content += bytes(-len(found.content) % alignment)
    return address


def connect(
    machine: AssembledMachine, found: StInterface, context: PlcContext, memory: bytearray
) -> CncInterface:
    """Return the object that keeps the interface in a program's memory equal to the machine."""
    signals = {name: found.cell for name, found in machine.signals().items()}
    places = [one for one in found.placed if one.area.shape.root != "gpPform"]
    values = _shown(found.placed, signals, memory, machine.memory)
    banks, bank_numbers = _banks(places, context)
    shapes = [one.area.shape for one in places]
    numbers = {(shape.root, shape.index): number for number, shape in enumerate(shapes)}
    machine.access.presences.append(Presence(banks, numbers))
    units = ControlUnits(values, banks, list(_units(places, signals)))
    sources: UnitSource = UnitSource()
    for index in range(len(machine.channels) if places else 0):
        machine.channels[index].hli.is_divided = True
        sources = _sources(machine, index, banks, bank_numbers, sources)
    records = ChannelRecords(values, banks, list(_records(places, signals)))
    releases = AxisReleases(values, machine.axes, list(_releases(places)))
    presence = [_presence(one, signals) for one in places]
    image = _variables(machine, found, memory)
    return CncInterface(values, units, banks, sources, records, releases, presence, image)


def _shown(
    placed: Sequence[_Placed],
    signals: Mapping[str, int],
    memory: bytearray,
    machine: bytearray,
) -> ShownValues:
    rows: list[tuple[int, int, int, int, float]] = []
    tables: list[list[float]] = []
    for one in placed:
        for slot, name, tie in one.area.shown_numbers():
            if name not in signals:
                continue
            how, operand = _rule(tie, tables)
            kind = _KINDS[slot.type.name]
            rows.append((one.address + slot.offset, kind, signals[name], how, operand))
    return ShownValues(memory, machine, rows, tables)


def _rule(tie: Tie, tables: list[list[float]]) -> tuple[int, float]:
    """Return how a tie shows a value, with its operand."""
    if tie.equal is not None:
        return kinds.EQUALS, float(tie.equal)
    if tie.unequal is not None:
        return kinds.DIFFERS, float(tie.unequal)
    if tie.numbers is not None:
        numbers = [float(tie.numbers.get(i, 0)) for i in range(kinds.MAPPED_NUMBERS)]
        if numbers not in tables:
            tables.append(numbers)
        return kinds.MAPPED, float(tables.index(numbers))
    return kinds.SCALED, float(tie.factor)


def _units(
    places: Sequence[_Placed], signals: Mapping[str, int]
) -> Iterator[tuple[int, int, int, int, int, float, int, bool]]:
    """Yield the control units that act."""
    for number, one in enumerate(places):
        for unit, name, tie, is_edge in one.area.control_units():
            if name in signals:
                enable, command, request = (
                    one.at(f"{unit}.{member}") for member in ("enable_w", "command_w", "request_r")
                )
                kind = _KINDS[slots(one.area.shape.root)[f"{unit}.command_w"].type.name]
                cell, factor = signals[name], float(tie.factor)
                yield enable, command, request, kind, cell, factor, number, is_edge


def _presence(one: _Placed, signals: Mapping[str, int]) -> tuple[int, int]:
    """Return where a PLC announces itself for an area, and the cell that says so to all."""
    slot = one.area.present
    name = one.area.shape.session_name(slot.element)
    return one.address + slot.offset, signals.get(name, -1)


def _records(places: Sequence[_Placed], signals: Mapping[str, int]) -> Iterator[tuple[int, ...]]:
    """Yield mode and error of each channel."""
    for number, one in enumerate(places):
        if one.area.shape.root == "gpCh":
            shown = (
                signals[one.area.shape.named(f"HLI.{name}")]
                for name in ("STATE", "PAUSED", "FEED_HOLD", "ARMED", "ERROR", "ERROR_SERIAL")
            )
            yield (
                one.at(f"{MODE}.state_r.mode"),
                one.at(f"{MODE}.state_r.state"),
                one.at(f"{MODE}.command_semaphor_rw"),
                one.at(f"{MODE}.enable_w"),
                one.at(ERROR_FLAG),
                *shown,
                number,
            )


def _releases(places: Sequence[_Placed]) -> Iterator[tuple[int, ...]]:
    """Yield the releases of each axis."""
    for one in places:
        if one.area.shape.root == "gpAx":
            switches = (
                one.at(f"{unit}.{member}")
                for unit in RELEASES
                for member in ("enable_w", "command_w")
            )
            yield one.area.shape.index, one.address + one.area.present.offset, *switches


# --- technology functions -------------------------------------------------------------------------

_BankNumbers = dict[tuple[str, int, str], int]


def _banks(places: Sequence[_Placed], context: PlcContext) -> tuple[UnitBanks, _BankNumbers]:
    """Return the units of all areas, and the number of each array by root, index and name."""
    rows: list[tuple[int, int, int, int, int]] = []
    numbers: _BankNumbers = {}
    for number, one in enumerate(places):
        area = one.area
        members = {
            member.name: member for member in table.structure(table.ROOTS[area.shape.root]).members
        }
        for name in (STANDARD, LATE):
            member, used = members[name], members.get(USED[name])
            count = member.type.count
            in_use = 0 if used is None else one.address + used.offset
            numbers[area.shape.root, area.shape.index, name] = len(rows)
            stride = member.type.size_bytes // count
            rows.append((one.address + member.offset, count, stride, in_use, number))
    return UnitBanks(context, rows, len(places)), numbers


def _sources(
    machine: AssembledMachine,
    index: int,
    banks: UnitBanks,
    numbers: _BankNumbers,
    others: UnitSource,
) -> UnitSource:
    """Return the functions and spindle jobs of a channel, and those of the other ones."""
    own, channel = machine.assembled[index], machine.channels[index]
    parameters = own.parameters
    axis_index = {axis.logical_number: i for i, axis in enumerate(machine.configuration.axes)}

    def bank(logical: int, name: str) -> int:
        """Return the units of an axis, else of the channel."""
        found = numbers.get(("gpAx", axis_index.get(logical, -1), name))
        return numbers.get(("gpCh", index, name), 0) if found is None else found

    def banks_of(functions: bytearray, name: str) -> bytearray:
        logical = memoryview(functions).cast("q")
        return bytearray(struct.pack(f"={len(logical)}q", *(bank(one, name) for one in logical)))

    m_axes, h_axes = (
        axes_of(functions, own.configuration)
        for functions in (parameters.m_functions, parameters.h_functions)
    )
    types = types_of(parameters)
    for is_realtime, name in ((True, LATE), (False, STANDARD)):
        others = SectionSource(
            banks,
            channel.hli,
            is_realtime,
            banks.table(banks_of(m_axes, name), banks_of(h_axes, name), bank(0, name)),
            types,
            machine.configuration.cycle_time_us,
            others,
        )
    spindles = channel.context.spindles
    jobs = [bank(one.logical_number, STANDARD) for one in parameters.spindles]
    jobs += [0] * (spindles.count - len(jobs))
    return SpindleSource(
        banks, channel.hli, spindles, bytearray(struct.pack(f"={len(jobs)}q", *jobs)), others
    )


# --- V.E ------------------------------------------------------------------------------------------


def _variables(machine: AssembledMachine, found: StInterface, memory: bytearray) -> InterfaceImage:
    """Return the image of the V.E variables, attached if the program uses them."""
    image = InterfaceImage(machine.memory, machine.record)
    image.report_to(machine.kernel.image)
    if not found.variables:
        return image
    rows = []
    pack = pack_of(machine.configuration.startup.member_alignment)
    end = 0
    for part in sections(machine.configuration):
        for placed in part.placed:
            cell = machine.layout.external[part.channel, placed.variable.name]
            for one in fields(placed, pack):
                for index in range(max(1, one.count)):
                    offset = _CLOCK + part.offset + one.offset + index * one.size_bytes
                    end = max(end, offset + one.size_bytes)
                    rows.append((offset, KINDS[one.type], cell, one.size_bytes, True, 1.0))
                    cell += -(-one.size_bytes // CELL_BYTES)
    begin = found.variables - _CLOCK
    size = max(-(-end // 8) * 8, _CLOCK)
    shown = ImageBytes(memoryview(memory)[begin : begin + size], memoryview(bytearray(size)))
    image.attach(shown, rows, Units(), 0, _CLOCK, machine.kernel.tick)
    return image
