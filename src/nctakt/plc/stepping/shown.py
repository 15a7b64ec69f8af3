# SPDX-License-Identifier: MIT
"""Values of a PLC as Structured Text writes them, structures and arrays as trees.

In: places in the memory. Out: texts, names of enumerations, and children of a value. Unreadable
values are shown as such, and have no children.
"""

from __future__ import annotations

import struct
from collections.abc import Iterator, Sequence
from itertools import islice

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text
from nctakt.base.failure import Failure
from nctakt.kernel.st import kinds
from nctakt.plc.stepping.places import Place, Places
from nctakt.results.trace.events import number_text
from nctakt.st.types import (
    ArrayType,
    BlockType,
    Elementary,
    EnumType,
    Family,
    InterfaceType,
    PointerType,
    ReferenceType,
    StringType,
    StructType,
    Type,
)
from nctakt.translation.layout import is_real, kind_of

#: Values that the line of a structure or an array shows.
_PREVIEWED = 3
_NULL = "null"
_OF_CALL = Text(
    "it is local to a call, which ends with this cycle",
    "es ist lokal in einem Aufruf, der mit diesem Zyklus endet",
)
_BIT = Text("it is a single bit", "es ist ein einzelnes Bit")
_PARTS = Text("it has parts, which can", "es hat Teile, die sich setzen lassen")
_NAMELESS = Text("no variable of the PLC is there", "dort ist keine Variable der SPS")
#: Why a value that is computed cannot be set.
COMPUTED = Text("it is computed", "es ist berechnet")


@dataclass(frozen=True, slots=True)
class PlcValue:
    """A variable at a location in a cycle.

    ``path``: by which it can be asked for again; ``settable``: its global path where it can be set
    from outside, else empty, and ``fixed``: why not. ``count``: how many values are below it, of
    which ``indexed`` says whether they are elements.
    """

    name: str
    path: str
    type: str
    text: str
    settable: str = ""
    fixed: Text | None = None
    count: int = 0
    indexed: bool = False


class Shown:
    """Shows the values of places."""

    def __init__(self, places: Places) -> None:
        self._places = places

    def value(self, name: str, location: Place, depth: int = 0) -> PlcValue:
        """Return kind and value of a variable; if it refers to nothing, the text says so."""
        try:
            target = self._followed(location)
        except Failure as failure:
            return PlcValue(
                name, location.path, location.type.name, f"({failure.diagnostics[0].text()})"
            )
        count = self._count(target)
        return PlcValue(
            name,
            location.path,
            location.type.name,
            self._text(location, target, depth),
            *self._settable(target),
            count,
            isinstance(target.type, ArrayType),
        )

    def _followed(self, location: Place) -> Place:
        """Return the target of a reference or an interface variable; null stays null."""
        if isinstance(location.type, ReferenceType | InterfaceType):
            if not self._bits(location, 8):
                return location
        location = self._places.referred(location)
        return (
            self._places.instance(location)
            if isinstance(location.type, InterfaceType)
            else location
        )

    def _settable(self, location: Place) -> tuple[str, Text | None]:
        """Return the path by which a value can be set from outside, else why it cannot."""
        if location.is_of_call:
            return "", _OF_CALL
        if location.bit >= 0:
            return "", _BIT
        if isinstance(location.type, BlockType | StructType | ArrayType):
            return "", _PARTS
        path = self._places.path_of(location.address, location.type)
        return (path, None) if path else ("", _NAMELESS)

    # --- below a value

    def below(self, location: Place, first: int, count: int) -> list[PlcValue]:
        """Return members, elements, or a pointer's target: ``count`` of them from one on."""
        location = self._followed(location)
        if isinstance(location.type, PointerType):
            pointed = self._places.pointed(location)
            return [self.value(f"{location.path.rpartition('.')[2]}^", pointed)]
        found = islice(self._inside(location), first, first + count)
        return [self.value(name, one) for name, one in found]

    def _inside(self, location: Place) -> Iterator[tuple[str, Place]]:
        if isinstance(location.type, ArrayType):
            yield from self.elements(location)
        else:
            yield from self._places.members(location)

    def elements(self, location: Place) -> Iterator[tuple[str, Place]]:
        """Yield the elements of an array by their indices."""
        if isinstance(location.type, ArrayType):
            for number in range(location.type.element_count if location.type.bounds else 0):
                indices = _indices(number, location.type.bounds)
                if indices is None:
                    return
                element = self._places.element(location, indices)
                if element is not None:
                    yield f"[{','.join(map(str, indices))}]", element

    def _count(self, location: Place) -> int:
        sought = location.type
        if isinstance(sought, ArrayType):
            count = 1
            for low, high in sought.bounds:
                count *= max(high - low + 1, 0)
            return count
        if isinstance(sought, BlockType):
            return len(sought.pou.members)
        if isinstance(sought, StructType):
            return len(sought.members)
        is_set = isinstance(sought, PointerType) and sought.target is not None
        return 1 if is_set and sought.name != "THIS" and self._bits(location, 8) else 0

    # --- texts

    def _text(self, location: Place, target: Place, depth: int) -> str:
        sought = target.type
        if isinstance(sought, BlockType | StructType | ArrayType):
            parts = [] if depth else self._preview(target)
            more = ", …" if self._count(target) > len(parts) and parts else ""
            head = f"[{self._count(target)}] " if isinstance(sought, ArrayType) else ""
            shown = f"{head}{', '.join(parts)}{more}".strip()
            if isinstance(location.type, InterfaceType):
                path = self._places.path_of(target.address, sought) or sought.name
                return f"{path}: {shown}" if shown else path
            return shown or "…"
        return self.scalar(target)

    def _preview(self, location: Place) -> list[str]:
        found = []
        for name, one in islice(self._inside(location), _PREVIEWED):
            text = self.value(name, one, 1).text
            found.append(text if isinstance(location.type, ArrayType) else f"{name} {text}")
        return found

    def _bits(self, location: Place, size: int) -> int:
        return int.from_bytes(self._places.context.peek(location.address, size), "little")

    def scalar(self, location: Place) -> str:
        """Return the text of a value without parts."""
        sought = location.type
        data = self._places.context.peek(location.address, max(sought.size, 1))
        if isinstance(sought, StringType):
            return _quoted(data, sought)
        if is_real(sought):
            value = struct.unpack("<f" if sought.size == 4 else "<d", data)[0]
            return number_text(value)
        kind = kind_of(sought)
        if kind is None:
            return data.hex(" ")
        number = int.from_bytes(data, "little", signed=kinds.I8 <= kind <= kinds.I64)
        if location.bit >= 0:
            return "TRUE" if number >> location.bit & 1 else "FALSE"
        if isinstance(sought, PointerType | ReferenceType | InterfaceType):
            return self._pointer(number, sought)
        return whole_text(sought, number)

    def _pointer(self, number: int, sought: Type) -> str:
        if not number:
            return _NULL
        target = getattr(sought, "target", None)
        path = None if target is None else self._places.path_of(number, target)
        return f"16#{number:X}" if path is None else f"16#{number:X} → {path}"


def whole_text(sought: Type, number: int) -> str:
    """Return a truth, an item of an enumeration, a duration, a date or a whole number."""
    if isinstance(sought, EnumType):
        names = [one.name for one in sought.values.values() if one.number == number]
        return f"{sought.name}.{names[0]}" if names else str(number)
    if not isinstance(sought, Elementary):
        return str(number)
    if sought.family is Family.BOOL:
        return "TRUE" if number else "FALSE"
    if sought.family is Family.DURATION:
        return f"T#{number}ms" if sought.size == 4 else f"LTIME#{number}ns"
    if sought.family is Family.DATE:
        return _date(sought.name.upper(), number)
    return str(number)


def _date(name: str, number: int) -> str:
    if name in ("TOD", "TIME_OF_DAY"):
        seconds, rest = divmod(number, 1000)
        clock = f"{seconds // 3600:02}:{seconds // 60 % 60:02}:{seconds % 60:02}.{rest:03}"
        return f"TOD#{clock}"
    days, seconds = divmod(number, 86_400)
    day = "-".join(f"{part:02}" for part in _civil(days))
    if name == "DATE":
        return f"D#{day}"
    return f"DT#{day}-{seconds // 3600:02}:{seconds // 60 % 60:02}:{seconds % 60:02}"


def _civil(days: int) -> tuple[int, int, int]:
    """Return year, month and day of a number of days since 1970-01-01."""
    # Counted from 1 March of the year 0, so that the leap day ends a year.
    era, day = divmod(days + 719_468, 146_097)
    year = (day - day // 1460 + day // 36_524 - day // 146_096) // 365
    day -= 365 * year + year // 4 - year // 100
    month = (5 * day + 2) // 153
    day -= (153 * month + 2) // 5 - 1
    month += 3 if month < 10 else -9
    return year + 400 * era + (month <= 2), month, day


def _quoted(data: bytes, sought: StringType) -> str:
    if sought.is_wide:
        return f'"{data.decode("utf-16-le", "replace").partition(chr(0))[0]}"'
    return f"'{data.partition(bytes(1))[0].decode('latin-1')}'"


def _indices(number: int, bounds: Sequence[tuple[int, int]]) -> list[int] | None:
    """Return the indices of an element by its number, ``None`` after the last one."""
    found: list[int] = []
    for low, high in reversed(bounds):
        number, index = divmod(number, max(high - low + 1, 1))
        found.append(low + index)
    return None if number else found[::-1]
