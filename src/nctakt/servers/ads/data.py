# SPDX-License-Identifier: MIT
"""Values of the session <-> the bytes of ADS: little-endian, laid out as a PLC sees them.

In: the names of values with their types and offsets. Out: ``Item``, which reads the bytes of all of
them from the latest values, and takes them apart again.
"""

from __future__ import annotations

import math
import struct
from collections.abc import Callable, Mapping, Sequence
from operator import itemgetter
from typing import Any, Protocol

from nctakt.base.dataclass import dataclass
from nctakt.lists.declared.variables import SCALARS
from nctakt.nc.vocabulary.variables import strings
from nctakt.servers.ads.codes import AdsError, Error
from nctakt.servers.store import Scalar

#: Format of ``struct``, number of the type in ADS, and its name in a PLC, of each numeric type.
NUMERIC = {
    "BOOLEAN": ("B", 33, "BOOL"),
    "SGN08": ("b", 16, "SINT"),
    "UNS08": ("B", 17, "USINT"),
    "SGN16": ("h", 2, "INT"),
    "UNS16": ("H", 18, "UINT"),
    "SGN32": ("i", 3, "DINT"),
    "UNS32": ("I", 19, "UDINT"),
    "REAL64": ("d", 5, "LREAL"),
}

#: Number of the type of texts and of structures.
STRING_TYPE, STRUCTURE_TYPE = 30, 65


@dataclass(frozen=True, slots=True)
class Leaf:
    """A number or text in bytes: the value of the session, its type, its offset."""

    name: str
    type: str
    offset: int
    size_bytes: int
    is_writable: bool

    @property
    def code(self) -> str:
        """Its format of ``struct``."""
        return NUMERIC[self.type][0] if self.type in NUMERIC else f"{self.size_bytes}s"


class Item:
    """Bytes of one or several values, from ``leaves`` whose offsets count from the first byte.

    ``is_used``: it was read since somebody has set it to false.
    """

    __slots__ = (
        "_bytes",
        "_convert",
        "_get",
        "_pack",
        "_seen",
        "is_used",
        "leaves",
        "names",
        "size_bytes",
    )

    def __init__(self, leaves: Sequence[Leaf], size_bytes: int) -> None:
        self.leaves = tuple(leaves)
        self.size_bytes = size_bytes
        self.names = tuple(leaf.name for leaf in leaves)
        codes = []
        end = 0
        for leaf in leaves:
            codes.append("x" * (leaf.offset - end) + leaf.code)
            end = leaf.offset + leaf.size_bytes
        codes.append("x" * (size_bytes - end))
        self._pack = struct.Struct("<" + "".join(codes)).pack
        self._get: Callable[[Mapping[str, Scalar]], Any] = itemgetter(*self.names)
        types = {leaf.type for leaf in leaves}
        if types == {"REAL64"}:
            self._convert: Callable[[Any], Any] = _same
        elif "REAL64" not in types and all(one in NUMERIC for one in types):
            self._convert = _integers
        else:
            converters = tuple(_converter(leaf) for leaf in leaves)
            self._convert = lambda values: [
                convert(value) for convert, value in zip(converters, values, strict=True)
            ]
        self._seen: object = None
        self.is_used = True
        self._bytes = b""

    def read(self, values: Mapping[str, Scalar]) -> bytes:
        """Return the bytes of the values; they are kept for the next reader of the same.

        Raises ``KeyError`` where one of them is missing.
        """
        if values is self._seen:
            return self._bytes
        got = self._get(values) if len(self.names) > 1 else (self._get(values),)
        try:
            packed = self._pack(*self._convert(got))
        except (struct.error, ValueError, OverflowError):  # beyond its type, or no number
            packed = self._pack(*map(_clamped, self.leaves, got))
        self._seen, self._bytes, self.is_used = values, packed, True
        return packed

    def write(self, data: bytes) -> dict[str, Scalar]:
        """Return the values in bytes; raises ``AdsError`` for a value that cannot be written."""
        if len(data) != self.size_bytes:
            raise AdsError(Error.SIZE, f"{len(data)} bytes for {self.size_bytes}")
        found: dict[str, Scalar] = {}
        for leaf in self.leaves:
            if not leaf.is_writable:
                raise AdsError(Error.ACCESS, f"{leaf.name} cannot be written")
            (value,) = struct.unpack_from(f"<{leaf.code}", data, leaf.offset)
            if isinstance(value, bytes):
                value = _text(leaf, value)
            elif not math.isfinite(value):
                raise AdsError(Error.PARAMETER, f"{leaf.name} cannot be {value}")
            found[leaf.name] = value
        return found


class Fixed:
    """Bytes that never change, and cannot be written."""

    names: tuple[str, ...] = ()

    def __init__(self, data: bytes) -> None:
        self.size_bytes = len(data)
        self._data = data

    def read(self, values: Mapping[str, Scalar]) -> bytes:
        """Return the bytes."""
        return self._data

    def write(self, data: bytes) -> dict[str, Scalar]:
        """Raise ``AdsError``: it cannot be written."""
        raise AdsError(Error.ACCESS, "it cannot be written")


class Scaled:
    """A value of the session in another unit: ``factor`` times the value, as ``type``."""

    def __init__(self, name: str, type_: str, factor: float, is_writable: bool) -> None:
        self.names: tuple[str, ...] = (name,)
        self._leaf = Leaf(name, type_, 0, struct.calcsize(f"<{NUMERIC[type_][0]}"), is_writable)
        self.size_bytes = self._leaf.size_bytes
        self._factor = factor

    def read(self, values: Mapping[str, Scalar]) -> bytes:
        """Return the bytes of the value; raises ``KeyError`` where it is missing."""
        value = float(values[self._leaf.name]) * self._factor
        if self._leaf.type != "REAL64" and math.isfinite(value):
            value = round(value)
        return struct.pack(f"<{self._leaf.code}", _clamped(self._leaf, value))

    def write(self, data: bytes) -> dict[str, Scalar]:
        """Return the value in bytes; raises ``AdsError`` if it cannot be written."""
        found = Item([self._leaf], self.size_bytes).write(data)
        return {name: float(value) / self._factor for name, value in found.items()}


class Readable(Protocol):
    """A readable and perhaps writable item; ``names``: the values of the session in it."""

    names: tuple[str, ...]
    size_bytes: int

    def read(self, values: Mapping[str, Scalar]) -> bytes:
        """Return its bytes; raises ``KeyError`` where a value is missing."""

    def write(self, data: bytes) -> dict[str, Scalar]:
        """Return the values in bytes; raises ``AdsError`` if one cannot be written."""


def _same(values: Any) -> Any:
    return values


def _integers(values: Any) -> Any:
    return map(int, values)


def _converter(leaf: Leaf) -> Callable[[Any], Any]:
    if leaf.type == "REAL64":
        return float
    if leaf.type in NUMERIC:
        return int
    return lambda text: strings.encode(text, leaf.size_bytes)


def _clamped(leaf: Leaf, value: Any) -> Any:
    """Return a value within its type; 0 for an integer that is no number."""
    if leaf.type not in NUMERIC or leaf.type == "REAL64":
        return _converter(leaf)(value)
    scalar = SCALARS[leaf.type]
    return 0 if math.isnan(value) else int(min(max(value, scalar.low), scalar.high))


def _text(leaf: Leaf, data: bytes) -> str:
    text = strings.decode(data)
    wrong = strings.misfit(leaf.name, leaf.type, leaf.size_bytes, text)
    if wrong is not None:
        raise AdsError(Error.PARAMETER, f"{leaf.name} cannot hold this text")
    return text
