# SPDX-License-Identifier: MIT
"""The symbols of a machine: names -> addresses, types and values; the uploads of clients (AD-3).

In: the values of the session, the declarations of V.E. Out: ``SymbolTable``. Symbols are V.E and
V.CH with their structures, arrays and elements, the values of the HLI, the signals of the machine
and the variables of a PLC in Structured Text. Each area has its own group; its variables follow
each other, laid out as a PLC sees them in memory (P-STUP-00145).
"""

from __future__ import annotations

import bisect
from collections.abc import Iterator, Sequence
from dataclasses import replace

from nctakt.hli.table import LIST_NAME
from nctakt.hli.variables_memory import sections
from nctakt.lists.declared.variables import SCALARS
from nctakt.lists.machine.external.variables import Node, Variable, VariableScope
from nctakt.lists.machine.external.variables_layout import element_size, members, pack_of, size_of
from nctakt.lists.machine.machine import Machine
from nctakt.run.access.machine_names import prefix_of
from nctakt.servers.ads.codes import AdsError, Error
from nctakt.servers.ads.data import (
    NUMERIC,
    STRING_TYPE,
    STRUCTURE_TYPE,
    Fixed,
    Item,
    Leaf,
    Readable,
)
from nctakt.servers.ads.interface import CONSTANTS, InterfaceSymbols
from nctakt.servers.ads.plc_symbols import PlcSymbols
from nctakt.servers.ads.types import DataType, Member, Symbol
from nctakt.servers.catalogue import Catalogue, Value
from nctakt.st.program import Program

#: The groups of the areas: variables, values of the HLI, signals, V.E as gpVEGlob and gpVECh.
VARIABLES, HLI, SIGNALS, PACKED = 0x4040, 0x4042, 0x4043, 0x4054

#: Bytes from one section of the packed V.E variables to the next.
_SECTION_STEP = 0x100000

#: Variables begin at multiples of this offset.
_ALIGNMENT = 8

#: Ranges of bytes that are kept at most, and values that they have together.
_MAX_ITEMS = 20_000
MAX_KEPT = 200_000


class SymbolTable:
    """All symbols; ``types``: those of structures and arrays, and of numbers, by name."""

    def __init__(
        self, machine: Machine, catalogue: Catalogue, programs: Sequence[Program] = ()
    ) -> None:
        self._catalogue = catalogue
        self._pack = pack_of(machine.startup.member_alignment)
        self.types: dict[str, DataType] = {}
        self.symbols: dict[str, Symbol] = {}
        self._nodes: dict[str, Node] = {}
        self._leaves: dict[int, list[Leaf]] = {VARIABLES: [], HLI: [], SIGNALS: [], PACKED: []}
        self._ends = dict.fromkeys(self._leaves, 0)
        self._items: dict[tuple[int, int, int], Item] = {}
        self._kept = 0
        self._add_variables(machine)
        for value in catalogue.values.values():
            if not value.name.partition("V.E.")[1] and not value.name.partition("V.CH.")[1]:
                self._add_value(value)
        self._add_packed(machine)
        self.interface = InterfaceSymbols(machine, self._named)
        self.symbols.update((symbol.name, symbol) for symbol in self.interface.all())
        self.plc = PlcSymbols(programs, self._named)
        self.symbols.update((symbol.name, symbol) for symbol in self.plc.all())
        self._starts = {
            group: [leaf.offset for leaf in leaves] for group, leaves in self._leaves.items()
        }
        self._types_by_upper = {name.upper(): type_ for name, type_ in self.types.items()}
        self._by_upper = {name.upper(): symbol for name, symbol in self.symbols.items()}

    # --- content --------------------------------------------------------------------------------

    def _add_variables(self, machine: Machine) -> None:
        is_alone = len(machine.channels) == 1
        shared: dict[str, Variable] = {}
        for index, channel in enumerate(machine.channels):
            prefix = "" if is_alone else prefix_of(index)
            for variable in channel.external_variables:
                if variable.scope is VariableScope.GLOBAL:
                    shared.setdefault(variable.name, variable)
                    if shared[variable.name].node == variable.node:
                        continue
                self._add_variable(variable.node, f"{prefix}V.E.", prefix)
            for variable in channel.channel_variables:
                self._add_variable(variable.node, f"{prefix}V.CH.", prefix)
        for variable in shared.values():
            self._add_variable(variable.node, "V.E.", "")

    def _add_variable(self, node: Node, family: str, prefix: str) -> None:
        group = VARIABLES
        first = -(-self._ends[group] // _ALIGNMENT) * _ALIGNMENT
        name = f"{family}{node.name}"
        for leaf in self._leaves_of(node, name, first):
            if leaf.name in self._catalogue:  # a GLOBAL one that only other channels have
                self._leaves[group].append(leaf)
            else:
                owner = self._owner(leaf.name)
                self._leaves[group].append(replace(leaf, name=owner))
        self._ends[group] = first + size_of(node, self._pack)
        self._add_symbols(node, name, group, first, is_element=False)

    def _add_packed(self, machine: Machine) -> None:
        """Add the V.E variables as the PLC finds them through gpVEGlob and gpVECh."""
        is_alone = len(machine.channels) == 1
        for section in sections(machine):
            first = _SECTION_STEP * section.channel
            prefix = "" if is_alone or not section.channel else prefix_of(section.channel - 1)
            for placed in section.placed:
                name = f"{prefix}V.E.{placed.variable.node.name}"
                for leaf in self._leaves_of(placed.variable.node, name, first + placed.offset):
                    known = leaf.name in self._catalogue
                    owner = leaf.name if known else self._owner(leaf.name)
                    self._leaves[PACKED].append(replace(leaf, name=owner))
            words = -(-section.size_bytes // 4)
            self._ends[PACKED] = first + 4 * words
            name = f"gpVECh[{section.channel - 1}]^" if section.channel else "gpVEGlob^"
            if words:
                base = self._scalar("UNS32", 4)
                type_ = self._named(
                    DataType(
                        f"ARRAY [0..{words - 1}] OF UDINT", base.number, 4 * words, words, base.name
                    )
                )
                full = f"{LIST_NAME}{name}"
                self.symbols[full] = Symbol(full, PACKED, first, type_, "", True)

    def _owner(self, name: str) -> str:
        """Return the name of a GLOBAL variable in the first channel that has it."""
        count = len(self._catalogue.names.layout.tables)
        names = [f"{prefix_of(index)}{name}" for index in range(count)]
        return next(one for one in names if one in self._catalogue)

    def _leaves_of(self, node: Node, name: str, offset: int) -> Iterator[Leaf]:
        size = element_size(node, self._pack)
        for index in range(max(1, node.array_elements)):
            path = f"{name}[{index}]" if node.array_elements else name
            first = offset + index * size
            if not node.members:
                yield Leaf(path, node.type, first, node.size_bytes, is_writable=True)
            for member, at in members(node, self._pack):
                yield from self._leaves_of(member, f"{path}.{member.name}", first + at)

    def _add_symbols(
        self, node: Node, name: str, group: int, offset: int, *, is_element: bool
    ) -> None:
        """Add a variable, its members and its elements."""
        type_ = self._type_of(node)
        self.symbols[name] = Symbol(name, group, offset, type_, "", is_writable=True)
        if node.array_elements:
            single = replace(node, array_elements=0)
            size = element_size(node, self._pack)
            for index in range(node.array_elements):
                element = f"{name}[{index}]"
                self._add_symbols(single, element, group, offset + index * size, is_element=True)
            return
        for member, at in members(node, self._pack):
            path = f"{name}.{member.name}"
            self._add_symbols(member, path, group, offset + at, is_element=is_element)

    def _add_value(self, value: Value) -> None:
        group = HLI if "HLI." in value.name else SIGNALS
        type_ = self._scalar(value.type, max(1, SCALARS[value.type].size_bytes))
        first = -(-self._ends[group] // _ALIGNMENT) * _ALIGNMENT
        leaf = Leaf(value.name, value.type, first, type_.size_bytes, value.is_writable)
        self._leaves[group].append(leaf)
        self._ends[group] = first + type_.size_bytes
        self.symbols[value.name] = Symbol(
            value.name, group, first, type_, value.unit, value.is_writable
        )

    def _type_of(self, node: Node) -> DataType:
        if node.array_elements:
            base = self._type_of(replace(node, array_elements=0))
            return self._named(
                DataType(
                    f"ARRAY [0..{node.array_elements - 1}] OF {base.name}",
                    base.number,
                    size_of(node, self._pack),
                    node.array_elements,
                    base.name,
                )
            )
        if not node.members:
            return self._scalar(node.type, node.size_bytes)
        own = tuple(
            Member(member.name, self._type_of(member), at)
            for member, at in members(node, self._pack)
        )
        size = element_size(node, self._pack)
        type_ = DataType(node.type, STRUCTURE_TYPE, size, members=own)
        number = 2
        while self.types.get(type_.name, type_) != type_:  # another list's type of that name
            type_ = replace(type_, name=f"{node.type}_{number}")
            number += 1
        return self._named(type_)

    def _scalar(self, type_: str, size_bytes: int) -> DataType:
        if type_ in NUMERIC:
            _, number, name = NUMERIC[type_]
            return self._named(DataType(name, number, size_bytes))
        return self._named(DataType(f"STRING({size_bytes - 1})", STRING_TYPE, size_bytes))

    def _named(self, type_: DataType) -> DataType:
        return self.types.setdefault(type_.name, type_)

    # --- finding --------------------------------------------------------------------------------

    def find(self, name: str) -> Symbol:
        """Return the symbol of this name, in any case; raises ``AdsError`` (0x710)."""
        upper = name.upper()
        symbol = self._by_upper.get(upper) or self._by_upper.get(f"{LIST_NAME.upper()}{upper}")
        symbol = symbol or self.plc.find(name) or self.interface.find(name)
        if symbol is None:
            raise AdsError(Error.SYMBOL, f"no symbol {name[:64]}")
        return symbol

    def find_type(self, name: str) -> DataType:
        """Return the data type of this name, in any case; raises ``AdsError`` (0x710)."""
        found = self.types.get(name) or self._types_by_upper.get(name.upper())
        if found is None:
            raise AdsError(Error.SYMBOL, f"no type {name[:64]}")
        return found

    def padded(self, group: int, offset: int, data: bytes) -> bytes:
        """Return data for a text with zero bytes up to its end; other data unchanged."""
        if group not in self._starts:
            return self.plc.padded(group, offset, data)
        index = bisect.bisect_left(self._starts[group], offset)
        leaves = self._leaves[group]
        if index < len(leaves) and leaves[index].offset == offset:
            leaf = leaves[index]
            if leaf.type not in NUMERIC and len(data) < leaf.size_bytes:
                return data.ljust(leaf.size_bytes, b"\0")
        return data

    def has_group(self, group: int) -> bool:
        """Return whether this is the group of an area."""
        owners = self.interface, self.plc
        return group in self._leaves or any(owner.has_group(group) for owner in owners)

    def item(self, group: int, offset: int, size_bytes: int) -> Readable:
        """Return the values of a range of bytes.

        Raises ``AdsError``: 0x703 for an offset where nothing begins, 0x705 for a length that cuts
        through a value.
        """
        if group == CONSTANTS:
            return Fixed(self.interface.constant(offset, size_bytes))
        if self.interface.has_group(group):
            return self.interface.item(group, offset, size_bytes)
        if self.plc.has_group(group):
            return self.plc.item(group, offset, size_bytes)
        key = group, offset, size_bytes
        found = self._items.get(key)
        if found is None:
            found = self._new_item(group, offset, size_bytes)
            cost = len(found.leaves)
            if len(self._items) >= _MAX_ITEMS or self._kept + cost > MAX_KEPT:
                self._items.clear()
                self._kept = 0
            self._items[key] = found
            self._kept += cost
        return found

    def used_items(self) -> list[Readable]:
        """Return the ranges that were read since the last call."""
        used = [item for item in self._items.values() if item.is_used]
        for item in used:
            item.is_used = False
        return [*used, *self.interface.used_items(), *self.plc.used_items()]

    def _new_item(self, group: int, offset: int, size_bytes: int) -> Item:
        starts, leaves = self._starts[group], self._leaves[group]
        first = bisect.bisect_left(starts, offset)
        if first == len(starts) or starts[first] != offset:
            raise AdsError(Error.OFFSET, f"nothing begins at {group:#x}, {offset:#x}")
        if leaves[first].type not in NUMERIC and first + 1 == bisect.bisect_left(
            starts, offset + size_bytes
        ):
            size_bytes = min(size_bytes, leaves[first].size_bytes)  # a buffer longer than the text
        end = offset + size_bytes
        last = bisect.bisect_left(starts, end)
        cut = leaves[last - 1]
        is_cut = cut.offset + cut.size_bytes > end or end > self._ends[group]
        if not size_bytes or is_cut:
            raise AdsError(Error.SIZE, f"{size_bytes} bytes at {group:#x}, {offset:#x}")
        own = [replace(leaf, offset=leaf.offset - offset) for leaf in leaves[first:last]]
        return Item(own, size_bytes)
