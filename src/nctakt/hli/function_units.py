# SPDX-License-Identifier: MIT
"""Technology units of the interface: M, H, S and T functions that wait for the PLC.

In: the functions that wait. Out: the bytes of ``techno_unit_std_sync`` and
``techno_unit_late_sync`` with ``please_rw`` and ``done_w``, and which function a written ``done_w``
acknowledges. Functions of realtime cycles, whose section no public source names, come in
``techno_unit_late_sync``.
"""

from __future__ import annotations

import re
import struct
from collections.abc import Callable, Sequence

from nctakt.hli import table
from nctakt.hli.plc_entries import SpindleEntry, TechnologyEntry
from nctakt.lists.declared.technology_functions import SYNCHRONISATIONS

#: What waits for the PLC.
Waiting = TechnologyEntry | SpindleEntry

STANDARD, LATE = "techno_unit_std_sync", "techno_unit_late_sync"
_USED = {STANDARD: "used_units_std_sync_r", LATE: "used_units_late_sync_r"}
_UNIT = re.compile(rf"({STANDARD}|{LATE})\[(\d+)\]\.(please_rw|done_w)")
#: Kinds of functions (HLI_INTF_…); 3: of a spindle.
_TYPES = {"M": 1, "H": 2, "T": 4}
_SPINDLE = 3
_PLEASE, _DONE, _TYPE, _DATA = 0, 1, 2, 8
_DATA_BYTES = 40
#: Units of the interface in a revolution per minute: 0.001°/s; in a degree: 0.0001°.
_SPEED, _ANGLE = 6000, 10_000


def is_unit(path: str) -> bool:
    """Return whether an element belongs to the technology units, or counts them."""
    return path.startswith((STANDARD, LATE)) or path in _USED.values()


class FunctionUnits:
    """The units of one area; ``put``: writes a number to an element of it.

    ``takes``: whether a function is one of this area.
    """

    def __init__(
        self,
        root: str,
        memory: bytearray,
        put: Callable[[str, float], None],
        takes: Callable[[Waiting], bool],
    ) -> None:
        self._memory = memory
        self._put = put
        self._takes = takes
        self._units: dict[tuple[str, int], Waiting] = {}
        arrays = {one.name: one for one in table.structure(table.ROOTS[root]).members}
        self._arrays = {name: arrays[name] for name in (STANDARD, LATE)}
        self._used = {name: path for name, path in _USED.items() if path in arrays}

    def show(self, waiting: Sequence[Waiting]) -> None:
        """Show the functions that wait; each keeps its unit until it is acknowledged."""
        own = {_identity(entry): entry for entry in waiting if self._takes(entry)}
        for key, entry in list(self._units.items()):
            if _identity(entry) not in own:
                del self._units[key]
                first = self._first(*key)
                self._memory[first : first + _DATA + _DATA_BYTES] = bytes(_DATA + _DATA_BYTES)
        shown = {_identity(entry) for entry in self._units.values()}
        for identity, entry in own.items():
            if identity not in shown:
                self._add(entry)
        for name, path in self._used.items():
            indices = [index for array, index in self._units if array == name]
            self._put(path, max(indices, default=-1) + 1)

    def _first(self, array: str, index: int) -> int:
        member = self._arrays[array]
        size = member.type.size_bytes // member.type.count
        return member.offset + index * size

    def _add(self, entry: Waiting) -> None:
        is_late = isinstance(entry, TechnologyEntry) and entry.is_realtime
        array = LATE if is_late else STANDARD
        count = self._arrays[array].type.count
        index = next((i for i in range(count) if (array, i) not in self._units), None)
        if index is None:
            return  # as many as there are units wait already; it comes when one is free
        self._units[array, index] = entry
        first = self._first(array, index)
        self._memory[first + _PLEASE], self._memory[first + _DONE] = 1, 0
        kind, data = _record(entry)
        struct.pack_into("<H", self._memory, first + _TYPE, kind)
        self._memory[first + _DATA : first + _DATA + _DATA_BYTES] = data.ljust(_DATA_BYTES, b"\0")

    def acknowledged(self, path: str) -> Waiting | None:
        """Return the function that a TRUE in ``done_w`` acknowledges; ``None``: none."""
        match = _UNIT.fullmatch(path)
        if match is None or match[3] != "done_w":
            return None
        return self._units.get((match[1], int(match[2])))


def _identity(entry: Waiting) -> tuple[object, int]:
    return entry.key, entry.serial


def _record(entry: Waiting) -> tuple[int, bytes]:
    """Return the kind of a function, and its data as the PLC reads them."""
    if isinstance(entry, SpindleEntry):
        position, speed = round(entry.position * _ANGLE), round(entry.speed * _SPEED)
        return _SPINDLE, struct.pack("<iiI", position, speed, 0)
    if entry.letter == "T":
        return _TYPES["T"], struct.pack("<i", entry.number)
    mode = SYNCHRONISATIONS.get(entry.synchronisation) or 0
    data = struct.pack(
        "<IiIIiHHIi",
        entry.number,
        round(entry.process_time_us),
        0,
        0,
        entry.value,
        0,
        0,
        mode,
        0,
    )
    return _TYPES[entry.letter], data
