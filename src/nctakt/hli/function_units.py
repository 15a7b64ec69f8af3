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
from nctakt.kernel import cells
from nctakt.lists.declared.technology_functions import SYNCHRONISATIONS

#: Functions waiting for the PLC.
Waiting = TechnologyEntry | SpindleEntry

#: A function that waits, and the unit of its area that the realtime part has given it.
Placed = tuple[Waiting, int]

#: The array and index of a unit; the key that distinguishes a function from an earlier one.
_UnitKey = tuple[str, int]
_Identity = tuple[tuple[str, int], int]

STANDARD, LATE = "techno_unit_std_sync", "techno_unit_late_sync"
USED = {STANDARD: "used_units_std_sync_r", LATE: "used_units_late_sync_r"}
_UNIT = re.compile(rf"({STANDARD}|{LATE})\[(\d+)\]\.(please_rw|done_w)")
#: Kinds of functions (HLI_INTF_…); 3: of a spindle.
_TYPES = {"M": cells.TECHNO_M, "H": cells.TECHNO_H, "T": cells.TECHNO_T}
_SPINDLE = cells.TECHNO_S
_PLEASE, _DONE, _TYPE = cells.TECHNO_PLEASE, cells.TECHNO_DONE, cells.TECHNO_TYPE
_DATA, _DATA_BYTES = cells.TECHNO_DATA, cells.TECHNO_DATA_BYTES
#: Units of the interface in a revolution per minute: 0.001°/s; in a degree: 0.0001°.
_SPEED, _ANGLE = 6 * cells.TECHNO_ROTATION, cells.TECHNO_ANGLE


def is_unit(path: str) -> bool:
    """Return whether an element belongs to the technology units, or counts them."""
    return path.startswith((STANDARD, LATE)) or path in USED.values()


class FunctionUnits:
    """The units of one area; ``put``: writes a number to an element of it.

    ``takes``: whether a function is one of this area. ``has_spindle``: the first unit is that of
    the jobs of a spindle. The content follows from the waiting functions and the PLC's writes,
    whether or not anybody has read it meanwhile.
    """

    def __init__(
        self,
        root: str,
        memory: bytearray,
        put: Callable[[str, float], None],
        takes: Callable[[Waiting], bool],
        *,
        has_spindle: bool,
    ) -> None:
        self._memory = memory
        self._put = put
        self._takes = takes
        self._spindles = int(has_spindle)
        self._units: dict[_UnitKey, Waiting] = {}
        self._read: dict[_UnitKey, _Identity] = {}
        self._done: dict[_UnitKey, _Identity] = {}
        arrays = {one.name: one for one in table.structure(table.ROOTS[root]).members}
        self._arrays = {name: arrays[name] for name in (STANDARD, LATE)}
        self._used = {name: path for name, path in USED.items() if path in arrays}

    def show(self, waiting: Sequence[Placed]) -> None:
        """Show the functions that wait; each keeps its unit until it is acknowledged."""
        placed = self._placed([one for one in waiting if self._takes(one[0])])
        for unit_key in {*self._units, *placed}:
            self._show_unit(unit_key, placed.get(unit_key))
        self._units = placed
        for name, path in self._used.items():
            indices = [index for array, index in placed if array == name]
            self._put(path, max(indices, default=-1) + 1)

    def _placed(self, waiting: Sequence[Placed]) -> dict[_UnitKey, Waiting]:
        """Return the functions by their units; a function whose unit is taken gets a free one."""
        found: dict[_UnitKey, Waiting] = {}
        left: list[tuple[str, Waiting]] = []
        for entry, unit in waiting:
            if isinstance(entry, SpindleEntry):
                last = self._arrays[STANDARD].type.count - 1
                unit_key = STANDARD, 0 if self._spindles else last - unit
            elif entry.is_realtime:
                unit_key = LATE, unit
            else:
                unit_key = STANDARD, unit + self._spindles
            if unit_key[1] < self._arrays[unit_key[0]].type.count and unit_key not in found:
                found[unit_key] = entry
            else:
                left.append((unit_key[0], entry))
        for array, entry in left:
            count = self._arrays[array].type.count
            index = next((i for i in range(count) if (array, i) not in found), None)
            if index is not None:  # otherwise all units are waiting; it comes when one is free
                found[array, index] = entry
        return found

    def _show_unit(self, unit_key: _UnitKey, entry: Waiting | None) -> None:
        member = self._arrays[unit_key[0]]
        first = member.offset + unit_key[1] * (member.type.size_bytes // member.type.count)
        self._memory[first : first + _DATA + _DATA_BYTES] = bytes(_DATA + _DATA_BYTES)
        if entry is None:
            return
        identity = _identity(entry)
        self._memory[first + _PLEASE] = self._read.get(unit_key) != identity
        self._memory[first + _DONE] = self._done.get(unit_key) == identity
        kind, data = _record(entry)
        struct.pack_into("<H", self._memory, first + _TYPE, kind)
        self._memory[first + _DATA : first + _DATA + _DATA_BYTES] = data.ljust(_DATA_BYTES, b"\0")

    def write(self, path: str, number: float) -> Waiting | None:
        """Take the PLC's writes into a shown unit; return the acknowledged function."""
        match = _UNIT.fullmatch(path)
        unit_key = ("", 0) if match is None else (match[1], int(match[2]))
        entry = self._units.get(unit_key)
        if match is None or entry is None:
            return None  # nothing waits there: stale, or made up
        kept = self._done if match[3] == "done_w" else self._read
        if bool(number) == (kept is self._done):
            kept[unit_key] = _identity(entry)
        else:
            kept.pop(unit_key, None)
        return entry if kept is self._done and number else None


def _identity(entry: Waiting) -> _Identity:
    return entry.key, entry.serial


def _record(entry: Waiting) -> tuple[int, bytes]:
    """Return the kind of a function, and its data as the PLC reads them."""
    if isinstance(entry, SpindleEntry):
        sign = {4: -1, 5: 0}.get(entry.function, 1)
        position, speed = round(entry.position * _ANGLE), round(sign * entry.speed * _SPEED)
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
