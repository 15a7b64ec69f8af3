# SPDX-License-Identifier: MIT
"""The values of an image of the HLI by the names of its structures.

In: the bytes of an image that another process has made. Out: values read and written, and rows that
fit together although the CNC keeps writing. Nothing in the bytes is trusted: a header that does not
fit this version is a ``Failure``.
"""

from __future__ import annotations

import struct
from collections.abc import Callable
from functools import cache
from typing import TypeVar

from nctakt.base.diagnostics import NOTHING, Text
from nctakt.base.failure import Failure
from nctakt.base.misspelling import nearest
from nctakt.hli.layout import (
    AXIS,
    CHANNEL,
    COMMAND,
    DIFFERENCES,
    HEADER,
    LINK,
    MAGIC,
    SPINDLE,
    SPINDLE_COMMAND,
    VERSION,
    Structure,
)
from nctakt.hli.places import PlacedEntry, entries, size_of
from nctakt.hli.variable_names import NamedVariable, read_names
from nctakt.lists.declared.variables import SCALARS
from nctakt.messages import diagnostic
from nctakt.messages.plcs.hli_connection import (
    HLI_CNC_WRITES_ON,
    HLI_LAYOUT_DIFFERS,
    HLI_VERSION_DIFFERS,
    NOT_AN_HLI,
)
from nctakt.messages.plcs.plc import UNKNOWN_HLI_VALUE
from nctakt.nc.vocabulary.variables import strings

_Result = TypeVar("_Result")

#: The codes of ``struct`` for the types of values.
_CODES = {
    "BOOLEAN": "=B",
    "SGN08": "=b",
    "UNS08": "=B",
    "SGN16": "=h",
    "UNS16": "=H",
    "SGN32": "=i",
    "UNS32": "=I",
    "UNS64": "=Q",
    "REAL64": "=d",
}
#: The types of V.E variables that hold a text.
TEXT_TYPES = ("STRING", "VSTRING")

#: Attempts to read while the CNC does not write; each tick writes for some microseconds only.
_MAX_ATTEMPTS = 1_000_000

#: The arrays of structures: the name of their number in the header, and of their offset and size.
_ARRAYS = {
    CHANNEL.name: ("channels", "channel", CHANNEL),
    COMMAND.name: ("channels", "command", COMMAND),
    AXIS.name: ("axes", "axis", AXIS),
    SPINDLE.name: ("spindles", "spindle", SPINDLE),
    SPINDLE_COMMAND.name: ("spindles", "spindle_command", SPINDLE_COMMAND),
}


class ImageAccess:
    """Reads and writes one image; ``name`` is that of its shared memory.

    Raises ``Failure`` if the bytes are not an image of this version.
    """

    def __init__(self, name: str, memory: memoryview) -> None:
        self.name = name
        self._memory = memory
        if len(memory) < size_of(HEADER) or bytes(memory[: len(MAGIC)]) != MAGIC:
            raise Failure(diagnostic(NOT_AN_HLI, name=name))
        version = self.number(HEADER, 0, "version")
        if version != VERSION:
            raise Failure(
                diagnostic(
                    HLI_VERSION_DIFFERS,
                    name=name,
                    version=version,
                    own=VERSION,
                    differences=_differences(int(version)),
                )
            )
        if self.number(HEADER, 0, "size") > len(memory):  # missing parts cannot be accessed
            raise self._layout_differs("size")
        for count, prefix, structure in _ARRAYS.values():
            self._check_array(count, prefix, structure)
        self._check_area("link_offset", size_of(LINK))
        self._check_area("ve_offset", int(self.number(HEADER, 0, "ve_size")))
        self.variables = self._read_variables()

    def _check_array(self, count: str, prefix: str, structure: Structure) -> None:
        """Check that an array of structures has their size and lies within the image."""
        if self.number(HEADER, 0, f"{prefix}_size") != size_of(structure):
            raise self._layout_differs(structure.name)
        self._check_area(
            f"{prefix}_offset", int(self.number(HEADER, 0, count)) * size_of(structure)
        )

    def _check_area(self, name: str, size: int) -> None:
        if self.number(HEADER, 0, name) + size > len(self._memory):
            raise self._layout_differs(name)

    def _layout_differs(self, part: str) -> Failure:
        return Failure(diagnostic(HLI_LAYOUT_DIFFERS, name=self.name, part=part))

    def _read_variables(self) -> dict[str, NamedVariable]:
        """Return the V.E variables of the image."""
        first, size = (int(self.number(HEADER, 0, f"names_{part}")) for part in ("offset", "size"))
        end = int(self.number(HEADER, 0, "ve_size"))
        try:
            variables = read_names(bytes(self._memory[first : first + size]))
        except ValueError as error:
            raise self._layout_differs("names_offset") from error
        for variable in variables.values():
            is_known = variable.type in _CODES or variable.type in TEXT_TYPES
            if not is_known or variable.offset < 0 or variable.end > end:
                raise self._layout_differs(variable.name)
        return variables

    # --- structures -----------------------------------------------------------------------------

    def offset(self, structure: Structure, index: int = 0) -> int:
        """Return the offset of the header, the link, or the structure of this index."""
        if structure is HEADER:
            return 0
        if structure is LINK:
            return int(self.number(HEADER, 0, "link_offset"))
        _, prefix, _ = _ARRAYS[structure.name]
        first = int(self.number(HEADER, 0, f"{prefix}_offset"))
        return first + index * size_of(structure)

    def number(self, structure: Structure, first: int, name: str, element: int = 0) -> float:
        """Return a number of the structure at the offset ``first``, in the session's unit."""
        placed = _placed(structure, name)
        number = self.number_at(placed.entry.image_type, first + placed.offset, element)
        return number if placed.entry.factor == 1.0 else number / placed.entry.factor

    def put_number(
        self, structure: Structure, first: int, name: str, value: float, element: int = 0
    ) -> None:
        """Write a number of the structure at the offset ``first``."""
        placed = _placed(structure, name)
        type_, factor = placed.entry.image_type, placed.entry.factor
        if factor != 1.0:
            value = min(float(round(value * factor)), SCALARS[type_].high)
        self.put_number_at(type_, first + placed.offset, value, element)

    def text(self, structure: Structure, first: int, name: str) -> str:
        """Return a text of the structure at the offset ``first``."""
        placed = _placed(structure, name)
        return self.text_at(first + placed.offset, placed.size_bytes)

    # --- bytes ----------------------------------------------------------------------------------

    def number_at(self, type_: str, offset: int, element: int = 0) -> float:
        """Return the number of a type at an offset, or that element of an array there."""
        code = _CODES[type_]
        (value,) = struct.unpack_from(code, self._memory, offset + element * struct.calcsize(code))
        return float(value) if type_ == "REAL64" else int(value)

    def put_number_at(self, type_: str, offset: int, value: float, element: int = 0) -> None:
        """Write a number of a type, which has been checked."""
        code = _CODES[type_]
        whole = value if type_ == "REAL64" else int(value)
        struct.pack_into(code, self._memory, offset + element * struct.calcsize(code), whole)

    def text_at(self, offset: int, size_bytes: int) -> str:
        """Return the text at an offset."""
        return strings.decode(self._memory[offset : offset + size_bytes])

    def put_bytes(self, offset: int, data: bytes) -> None:
        """Write bytes at an offset."""
        self._memory[offset : offset + len(data)] = data

    def consistent(self, read: Callable[[], _Result]) -> _Result:
        """Return the result of ``read`` while the CNC does not write.

        Raises ``Failure`` if the CNC never ends writing: its process was killed in the middle.
        """
        clock = _placed(HEADER, "sequence").offset
        for _ in range(_MAX_ATTEMPTS):
            before = self.number_at("UNS64", clock)
            if int(before) % 2 == 0:
                result = read()
                if self.number_at("UNS64", clock) == before:
                    return result
        raise Failure(diagnostic(HLI_CNC_WRITES_ON, name=self.name))

    def release(self) -> None:
        """Let go of the bytes."""
        self._memory.release()


def _differences(version: int) -> Text:
    """Return the changes between a version and this one."""
    low, high = sorted((version, VERSION))
    found = [said for one, said in DIFFERENCES.items() if low < one <= high]
    if len(found) < high - low:
        found.append(Text("the rest is not known here", "das Übrige ist hier nicht bekannt"))
    return Text("; ".join(one.en for one in found), "; ".join(one.de for one in found))


@cache
def _placed(structure: Structure, name: str) -> PlacedEntry:
    """Return a value of a structure; raises ``Failure`` (901012) for an unknown name."""
    placed = {one.entry.name: one for one in entries(structure)}
    placed |= {one.entry.member: one for one in entries(structure)}
    if name not in placed:
        near = nearest(name, placed) or NOTHING
        raise Failure(
            diagnostic(UNKNOWN_HLI_VALUE, name=name, nearest=near, known=", ".join(placed))
        )
    return placed[name]
