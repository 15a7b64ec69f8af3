# SPDX-License-Identifier: MIT
"""The interface as the controller names it: ``gpCh[0]^…``, ``gpAx[0]^…``, as symbols (AD-3).

In: the table of the interface, a machine. Out: symbols by their paths, with and without
``HLI_Global_Variables.``, and the bytes of any range of an area, which the session keeps. A range
may begin anywhere where an element begins; a structure may be read and written from its first byte
to any of its elements.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

from nctakt.base.failure import Failure
from nctakt.hli import table
from nctakt.hli.interface_memory import AreaShape, NotWritable, shapes
from nctakt.hli.table import LIST_NAME, Element
from nctakt.lists.machine.machine import Machine
from nctakt.run.access.interface_access import range_name
from nctakt.run.access.machine_names import prefix_of
from nctakt.servers.ads.codes import AdsError, Error
from nctakt.servers.ads.data import STRING_TYPE, STRUCTURE_TYPE
from nctakt.servers.ads.types import DataType, Member, Symbol
from nctakt.servers.store import Scalar

#: The groups of the areas, and of the constants of the PLC's library.
GROUPS: Mapping[str, int] = {"gpPform": 0x4050, "gpCh": 0x4051, "gpAx": 0x4052}
CONSTANTS = 0x4053

#: Prefix of a constant's name in PLC programs.
_CONSTANT_LIST = "HLI_GLOBAL_CONSTANTS."

#: Bytes from one area of a group to the next.
_STEP = 0x100000

#: Ranges of bytes that are kept at most.
_MAX_ITEMS = 20_000

#: Numbers of the types of a PLC in ADS.
_NUMBERS: Mapping[str, int] = {
    "BOOL": 33,
    "BYTE": 17,
    "USINT": 17,
    "INT": 2,
    "UINT": 18,
    "WORD": 18,
    "DINT": 3,
    "UDINT": 19,
    "LREAL": 5,
}


class InterfaceItem:
    """A range of bytes of an area; ``is_used``: it was read since somebody set it to false."""

    __slots__ = ("_area", "_offset", "is_used", "names", "size_bytes")

    def __init__(self, area: AreaShape, offset: int, size_bytes: int) -> None:
        self._area = area
        self._offset = offset
        self.size_bytes = size_bytes
        self.names: tuple[str, ...] = (range_name(area.name, offset, size_bytes),)
        self.is_used = True

    def read(self, values: Mapping[str, Scalar]) -> bytes:
        """Return its bytes; raises ``KeyError`` where they are missing."""
        self.is_used = True
        return bytes.fromhex(str(values[self.names[0]]))

    def write(self, data: bytes) -> dict[str, Scalar]:
        """Return the values to write, by name; raises ``AdsError``."""
        try:
            self._area.checked(self._offset, data)
        except NotWritable as refused:
            code = Error.SIZE if refused.is_size else Error.ACCESS
            raise AdsError(code, refused.reason) from None
        return {self.names[0]: data.hex()}


class InterfaceSymbols:
    """The symbols of the interface of a machine; ``areas``: their bytes."""

    def __init__(self, machine: Machine, name_type: Callable[[DataType], DataType]) -> None:
        count = len(machine.channels)
        prefixes = [prefix_of(index) if count > 1 else "" for index in range(count)]
        self.areas = shapes(machine, prefixes)
        self._name_type = name_type
        self._roots = {group: root for root, group in GROUPS.items()}
        self._items: dict[tuple[int, int, int], InterfaceItem] = {}
        self._constants = [one for one in table.constants().values() if one.value is not None]
        self._places = {one.name.upper(): at for at, one in enumerate(self._constants)}

    # --- symbols --------------------------------------------------------------------------------

    def all(self) -> Iterator[Symbol]:
        """Yield the symbols that are uploaded: the elements of all areas, and the constants.

        Elements without a value here are left out.
        """
        for root, found in self.areas.items():
            elements = [_whole(one) for one in table.patterns().values() if _is_listed(one, root)]
            for area in found:
                for element in elements:
                    if not area.hides(element.offset, element.type.size_bytes):
                        yield self._symbol(element, area)
        for one in self._constants:
            yield self._constant(one.name)

    def find(self, name: str) -> Symbol | None:
        """Return the symbol of a path or constant, in any case; ``None`` for another name.

        Raises ``AdsError`` for a path that the interface or the machine does not have.
        """
        upper = name.upper()
        plain = upper.removeprefix(LIST_NAME.upper())
        if upper.startswith(_CONSTANT_LIST) or upper in self._places:
            constant = upper.removeprefix(_CONSTANT_LIST)
            if constant not in self._places:
                raise AdsError(Error.SYMBOL, f"no constant {name[:64]}")
            return self._constant(self._constants[self._places[constant]].name)
        if not plain.startswith(("GPPFORM", "GPCH", "GPAX", "PMC", "PAC", "PPLATFORM")):
            return None
        try:
            element = table.find(name)
        except Failure as failure:
            raise AdsError(Error.SYMBOL, str(failure.diagnostics[0].text("en"))) from None
        found = self.areas[element.root]
        if element.index >= len(found):
            raise AdsError(Error.SYMBOL, f"there is no {element.root}[{element.index}]")
        return self._symbol(element, found[element.index])

    def _symbol(self, element: Element, area: AreaShape) -> Symbol:
        path = element.path.partition("^")[2]
        return Symbol(
            f"{LIST_NAME}{area.name}{path}",
            GROUPS[area.root],
            _STEP * area.index + element.offset,
            self._type(element.type),
            element.unit,
            element.by != "CNC",
        )

    def _constant(self, name: str) -> Symbol:
        at = self._places[name.upper()]
        type_ = self._name_type(DataType("DINT", _NUMBERS["DINT"], 4))
        return Symbol(f"HLI_Global_Constants.{name}", CONSTANTS, 4 * at, type_, "", False)

    def _type(self, type_: table.DataType) -> DataType:
        """Return a type as clients upload it."""
        if type_.base is not None:
            base = self._type(type_.base)
            name = f"ARRAY [{type_.low}..{type_.low + type_.count - 1}] OF {base.name}"
            return self._name_type(
                DataType(name, base.number, type_.size_bytes, type_.count, base.name)
            )
        if type_.members:
            members = tuple(Member(m.name, self._type(m.type), m.offset) for m in type_.members)
            found = DataType(type_.name, STRUCTURE_TYPE, type_.size_bytes, members=members)
            return self._name_type(found)
        number = _NUMBERS.get(type_.name, STRING_TYPE)
        return self._name_type(DataType(type_.name, number, type_.size_bytes))

    # --- bytes ----------------------------------------------------------------------------------

    def has_group(self, group: int) -> bool:
        """Return whether this is the group of an area or of the constants."""
        return group in self._roots or group == CONSTANTS

    def item(self, group: int, offset: int, size: int) -> InterfaceItem:
        """Return a range of bytes; raises ``AdsError`` (0x703, 0x705)."""
        key = group, offset, size
        found = self._items.get(key)
        if found is None:
            if len(self._items) >= _MAX_ITEMS:
                self._items.clear()
            found = self._items[key] = self._new_item(group, offset, size)
        return found

    def _new_item(self, group: int, offset: int, size: int) -> InterfaceItem:
        index, start = divmod(offset, _STEP)
        found = self.areas[self._roots[group]]
        if index >= len(found) or not found[index].begins(start):
            raise AdsError(Error.OFFSET, f"nothing begins at {group:#x}, {offset:#x}")
        area = found[index]
        if not area.fits(start, size):
            raise AdsError(Error.SIZE, f"{size} bytes at {group:#x}, {offset:#x}")
        hidden = area.hides(start, size)
        if hidden:
            raise AdsError(Error.SERVICE, f"{hidden}: there is no value here")
        return InterfaceItem(area, start, size)

    def constant(self, offset: int, size: int) -> bytes:
        """Return the bytes of a constant; raises ``AdsError``."""
        at, rest = divmod(offset, 4)
        if rest or at >= len(self._constants):
            raise AdsError(Error.OFFSET, f"no constant at {offset:#x}")
        value = self._constants[at].value
        assert value is not None
        if size < 4:
            raise AdsError(Error.SIZE, f"{size} bytes are too few")
        return value.to_bytes(4, "little", signed=True)

    def used_items(self) -> list[InterfaceItem]:
        """Return the ranges that were read since the last call."""
        used = [item for item in self._items.values() if item.is_used]
        for item in used:
            item.is_used = False
        return used


def _whole(element: Element) -> Element:
    """Return the array that begins with an element; any other element unchanged."""
    return table.find(element.path[:-3]) if element.path.endswith("[0]") else element


def _is_listed(element: Element, root: str) -> bool:
    """Return whether an element of the table is listed: it has a separate row."""
    return element.root == root and element.row is not None and element.inner is None
