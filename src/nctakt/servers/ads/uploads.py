# SPDX-License-Identifier: MIT
"""Symbols and data types as clients upload them: their entries in bytes (AD-3).

In: a symbol or a type. Out: its entry, and all entries in sequence.
"""

from __future__ import annotations

from collections.abc import Iterator
from struct import pack

from nctakt.nc.vocabulary.variables import strings
from nctakt.servers.ads.data import STRING_TYPE, STRUCTURE_TYPE
from nctakt.servers.ads.symbols import SymbolTable
from nctakt.servers.ads.types import DataType, Symbol

_READ_ONLY = 0x0020
_TYPE, _TYPE_ITEM = 0x0001, 0x0002
_VERSION = 1


def _names(*texts: str) -> tuple[list[int], bytes]:
    """Return the lengths of texts, and the texts, each with its zero byte."""
    parts = [strings.encode(text, len(text) + 1) for text in texts]
    return [len(part) - 1 for part in parts], b"".join(parts)


def symbol_entry(symbol: Symbol) -> bytes:
    """Return the entry of a symbol; its unit is its comment."""
    type_ = symbol.type
    lengths, names = _names(symbol.name, type_.name, symbol.unit)
    flags = 0 if symbol.is_writable else _READ_ONLY
    body = pack(
        "<IIIIHH3H",
        symbol.group,
        symbol.offset,
        type_.size_bytes,
        type_.number,
        flags,
        len(type_.dimensions),
        *lengths,
    )
    bounds = b"".join(pack("<iI", *one) for one in type_.dimensions)
    entry = body + names + bounds
    return pack("<I", len(entry) + 4) + entry


def handle_description(symbol: Symbol) -> bytes:
    """Return the data after a handle for clients that leave room: size and type of its symbol."""
    (length,), name = _names(symbol.type.name)
    return pack("<IIH", symbol.type.size_bytes, 0, length) + name


def type_entry(type_: DataType, name: str = "", offset: int = 0) -> bytes:
    """Return the entry of a data type; with a name that of a member at an offset."""
    is_plain = not type_.members and not type_.elements
    own, base = (name, type_.name) if name else (type_.name, type_.base)
    if not name and is_plain and type_.number != STRING_TYPE:
        base = ""
    lengths, names = _names(own, base, "")
    own_members = () if name else type_.members
    number = STRUCTURE_TYPE if type_.members else type_.number
    body = pack(
        "<IIIIIII3HHH",
        _VERSION,
        0,
        0,
        type_.size_bytes,
        offset,
        number,
        _TYPE_ITEM if name else _TYPE,
        *lengths,
        len(type_.dimensions),
        len(own_members),
    )
    bounds = b"".join(pack("<iI", *one) for one in type_.dimensions)
    inner = b"".join(type_entry(one.type, one.name, one.offset) for one in own_members)
    entry = body + names + bounds + inner
    return pack("<I", len(entry) + 4) + entry


class Uploads:
    """The uploads of clients, made on the first request."""

    def __init__(self, table: SymbolTable) -> None:
        self._table = table
        self._entries: dict[str, bytes] = {}

    def _made_once(self, name: str, entries: Iterator[bytes]) -> bytes:
        if name not in self._entries:
            self._entries[name] = b"".join(entries)
        return self._entries[name]

    @property
    def symbols(self) -> bytes:
        """The entries of all symbols."""
        return self._made_once("symbols", map(symbol_entry, self._table.symbols.values()))

    @property
    def types(self) -> bytes:
        """The entries of all data types."""
        return self._made_once("types", map(type_entry, self._table.types.values()))

    def info(self) -> bytes:
        """Return the number and the size of all symbols."""
        return pack("<II", len(self._table.symbols), len(self.symbols))

    def info_2(self) -> bytes:
        """Return number and size of all symbols and types; nothing else is there."""
        types = len(self._table.types), len(self.types)
        return self.info() + pack("<IIII", *types, 0, 0)
