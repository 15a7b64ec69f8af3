# SPDX-License-Identifier: MIT
"""The variables of a PLC in Structured Text as symbols, with the types of its text (AD-3).

In: checked and translated programs. Out: ``PlcSymbols``: the variables of programs and lists for
the upload, every part of them by its path, and the bytes of each as the controller lays them out
(ST-330). Pointers, references, interfaces and single bits have no value for clients.
"""

from __future__ import annotations

import itertools
import math
import operator
import struct
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace

from nctakt.base.dataclass import dataclass
from nctakt.kernel.st import kinds
from nctakt.servers.ads.codes import AdsError, Error
from nctakt.servers.ads.data import STRING_TYPE, STRUCTURE_TYPE
from nctakt.servers.ads.types import DataType, Member, Symbol
from nctakt.servers.store import Scalar
from nctakt.st.program import Program
from nctakt.st.types import (
    ArrayType,
    BlockType,
    EnumType,
    InterfaceType,
    Kind,
    PointerType,
    ReferenceType,
    Section,
    Storage,
    StringType,
    StructType,
    Type,
    Variable,
)
from nctakt.translation.layout import kind_of
from nctakt.translation.variables import find_variable

#: The group of the variables of the first PLC; those of the next ones follow.
GROUP, _MAX_PLCS = 0x4060, 16

#: Format of ``struct`` and number of the type in ADS, by how a value lies in memory.
_KINDS: Mapping[int, tuple[str, int]] = {
    kinds.BOOL: ("?", 33),
    kinds.I8: ("b", 16),
    kinds.I16: ("h", 2),
    kinds.I32: ("i", 3),
    kinds.I64: ("q", 20),
    kinds.U8: ("B", 17),
    kinds.U16: ("H", 18),
    kinds.U32: ("I", 19),
    kinds.U64: ("Q", 21),
    kinds.F32: ("f", 4),
    kinds.F64: ("d", 5),
}
_WIDE_STRING_TYPE = 31

#: Maximum number of values in one range of bytes, and of ranges kept.
_MAX_PARTS, _MAX_ITEMS = 5000, 20_000


@dataclass(frozen=True, slots=True)
class _Part:
    """A value within a range of bytes: its path, its type, its offset."""

    path: str
    type: Type
    offset: int


class PlcItem:
    """A variable as bytes; ``is_used``: it was read since somebody set it to false."""

    def __init__(self, parts: Sequence[_Part], size_bytes: int) -> None:
        self.parts = parts
        self.size_bytes = size_bytes
        self.names: tuple[str, ...] = tuple(part.path for part in parts)
        self.is_used = True

    def read(self, values: Mapping[str, Scalar]) -> bytes:
        """Return its bytes; raises ``KeyError`` where a value is missing."""
        self.is_used = True
        data = bytearray(self.size_bytes)
        for part in self.parts:
            found = _bytes_of(part.type, values[part.path])
            data[part.offset : part.offset + len(found)] = found
        return bytes(data)

    def write(self, data: bytes) -> dict[str, Scalar]:
        """Return the values in bytes; raises ``AdsError`` for a value that cannot be written."""
        if len(data) != self.size_bytes:
            raise AdsError(Error.SIZE, f"{len(data)} bytes for {self.size_bytes}")
        if not self.parts:
            raise AdsError(Error.ACCESS, "it has no value that could be written")
        return {
            part.path: _value_of(part, data[part.offset : part.offset + part.type.size])
            for part in self.parts
        }


def _bytes_of(sought: Type, value: Scalar) -> bytes:
    if isinstance(sought, StringType):
        return str(value).encode("utf-16-le" if sought.is_wide else "latin-1", "replace")
    if isinstance(sought, EnumType) and isinstance(value, str):
        name = value.rpartition(".")[2].lower()
        value = sought.values[name].number
    code, _ = _KINDS[kind_of(sought) or kinds.BOOL]
    return struct.pack(f"<{code}", value if code in "fd?" else int(value))


def _value_of(part: _Part, data: bytes) -> Scalar:
    sought = part.type
    if isinstance(sought, StringType):
        text = data.decode("utf-16-le" if sought.is_wide else "latin-1", "replace")
        return text.partition("\0")[0]
    code, _ = _KINDS[kind_of(sought) or kinds.BOOL]
    (value,) = struct.unpack(f"<{code}", data)
    if not math.isfinite(value):
        raise AdsError(Error.PARAMETER, f"{part.path} cannot be {value}")
    found: Scalar = int(value) if code == "?" else value  # tapes have numbers
    return found


class PlcSymbols:
    """The symbols of PLCs; ``named`` keeps a data type, or returns the one of its name."""

    def __init__(self, programs: Sequence[Program], named: Callable[[DataType], DataType]) -> None:
        self._programs = programs[:_MAX_PLCS]
        self._named = named
        self._types: dict[int, DataType] = {}
        self._given: dict[tuple[int, int, int], tuple[str, Type]] = {}
        self._texts: dict[tuple[int, int], int] = {}
        self._items: dict[tuple[int, int, int], PlcItem] = {}

    def all(self) -> Iterator[Symbol]:
        """Yield the variables of programs and lists, without their parts."""
        for number, program in enumerate(self._programs):
            for path in _paths(program):
                found = self._symbol(number, path)
                if found is not None:
                    yield found

    def find(self, name: str) -> Symbol | None:
        """Return the symbol of a path, ``None`` if no PLC has it; raises ``AdsError``."""
        if "#" in name:
            raise AdsError(Error.SYMBOL, f"methods cannot be called: {name[:64]}", "rpc")
        for number in range(len(self._programs)):
            found = self._symbol(number, name)
            if found is not None:
                return found
        return None

    def has_group(self, group: int) -> bool:
        """Return whether this is the group of a PLC."""
        return GROUP <= group < GROUP + len(self._programs)

    def item(self, group: int, offset: int, size_bytes: int) -> PlcItem:
        """Return the bytes of a symbol; raises ``AdsError`` where none of this size begins.

        A text may be read into a longer buffer; of a structure or array the first members alone.
        """
        size_bytes = min(size_bytes, self._texts.get((group, offset), size_bytes))
        key = group, offset, size_bytes
        if key not in self._items:
            path, sought = self._given.get(key) or self._longer(*key)
            parts = list(itertools.islice(_parts(path, sought, 0), _MAX_PARTS + 1))
            parts = [part for part in parts if part.offset < size_bytes]
            if parts and parts[-1].offset + parts[-1].type.size > size_bytes:
                raise AdsError(Error.SIZE, f"{size_bytes} bytes end within {parts[-1].path}")
            if len(parts) > _MAX_PARTS:
                raise AdsError(Error.SIZE, f"{path} has more than {_MAX_PARTS} values")
            if len(self._items) >= _MAX_ITEMS:
                self._items.clear()
            self._items[key] = PlcItem(parts, size_bytes)
        return self._items[key]

    def _longer(self, group: int, offset: int, size_bytes: int) -> tuple[str, Type]:
        """Return the smallest symbol that begins at a place and has more bytes."""
        longer = [
            (size, given)
            for (own, begin, size), given in self._given.items()
            if (own, begin) == (group, offset) and size > size_bytes
        ]
        if not longer or size_bytes <= 0:
            raise AdsError(Error.OFFSET, f"no symbol at {group:#x}, {offset:#x}")
        return min(longer, key=operator.itemgetter(0))[1]

    def padded(self, group: int, offset: int, data: bytes) -> bytes:
        """Return data for a text with zero bytes up to its end; other data unchanged."""
        return data.ljust(self._texts.get((group, offset), 0), b"\0")

    def used_items(self) -> Iterator[PlcItem]:
        """Yield the variables that were read since the last call."""
        for item in self._items.values():
            if item.is_used:
                item.is_used = False
                yield item

    def _symbol(self, number: int, path: str) -> Symbol | None:
        placed = find_variable(self._programs[number], path)
        if placed is None or placed.bit >= 0 or path.startswith("%"):
            return None
        type_ = self._type_of(placed.type)
        group, size = GROUP + number, type_.size_bytes
        self._given.setdefault((group, placed.address, size), (path, placed.type))
        if isinstance(placed.type, StringType):
            self._texts[group, placed.address] = size
        is_writable = not isinstance(placed.type, PointerType | ReferenceType | InterfaceType)
        return Symbol(path, group, placed.address, type_, "", is_writable)

    def _type_of(self, sought: Type) -> DataType:
        """Return the data type of a type; one of the same name that differs gets a number."""
        known = self._types.get(id(sought))
        if known is not None:
            return known
        first = type_ = self._made_type(sought)
        number = 2
        while (found := self._named(type_)) != type_:
            type_ = replace(first, name=f"{first.name}_{number}")
            number += 1
        self._types[id(sought)] = found
        return found

    def _made_type(self, sought: Type) -> DataType:
        size = sought.size
        if isinstance(sought, ArrayType):
            base = self._type_of(sought.element)
            bounds = tuple((low, high - low + 1) for low, high in sought.bounds)
            shown = ",".join(f"{low}..{high}" for low, high in sought.bounds)
            elements = math.prod(count for _, count in bounds)
            name = f"ARRAY [{shown}] OF {base.name}"
            return DataType(name, base.number, size, elements, base.name, (), bounds)
        if isinstance(sought, StringType):
            kind = "WSTRING" if sought.is_wide else "STRING"
            number = _WIDE_STRING_TYPE if sought.is_wide else STRING_TYPE
            return DataType(f"{kind}({sought.length})", number, size)
        if isinstance(sought, BlockType | StructType):
            members = tuple(
                Member(one.name, self._type_of(one.type), one.offset) for one in _members(sought)
            )
            return DataType(sought.name, STRUCTURE_TYPE, size, members=members)
        _, number = _KINDS[kind_of(sought) or kinds.BOOL]
        base_name = sought.base.name if isinstance(sought, EnumType) else ""
        return DataType(sought.name, number, size, base=base_name)


def _paths(program: Program) -> Iterator[str]:
    """Yield the paths of the variables of a program's own lists and programs."""
    for group in program.lists:
        prefix = f"{group.name}." if group.name else ""
        for one in group.variables.values():
            if not group.library and one.storage is Storage.GLOBAL:
                yield f"{prefix}{one.name}"
    for pou in program.pous.values():
        if pou.kind is Kind.PROGRAM and not pou.library:
            for one in pou.members.values():
                if one.section is not Section.IN_OUT:
                    yield f"{pou.name}.{one.name}"


def _members(sought: BlockType | StructType) -> list[Variable]:
    """Return the members that lie within an instance or a structure and have bytes there."""
    if isinstance(sought, BlockType):
        members = sought.pou.members.values()
    else:
        members = sought.members.values()
    return [
        one
        for one in members
        if one.section is not Section.IN_OUT and one.storage is not Storage.GLOBAL and one.bit < 0
    ]


def _parts(path: str, sought: Type, offset: int) -> Iterator[_Part]:
    """Yield all values of a variable by their paths."""
    if isinstance(sought, PointerType | ReferenceType | InterfaceType):
        return
    if isinstance(sought, ArrayType):
        ranges = [range(low, high + 1) for low, high in sought.bounds]
        for number, indices in enumerate(itertools.product(*ranges)):
            element = f"{path}[{','.join(map(str, indices))}]"
            yield from _parts(element, sought.element, offset + number * sought.element.size)
    elif isinstance(sought, BlockType | StructType):
        for one in _members(sought):
            yield from _parts(f"{path}.{one.name}", one.type, offset + one.offset)
    else:
        yield _Part(path, sought, offset)
