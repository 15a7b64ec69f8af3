# SPDX-License-Identifier: MIT
"""The interface of a machine as bytes, for a PLC or HMI at ``gpCh``, ``gpAx`` …

In: the table of the interface, a machine, values of its session. Out: the bytes of any range, laid
out according to the table, and the meaning of a write: values of the session, a selected program.
Writes without effect are kept, so that their writer reads them again. The content follows from
values and writes, and not from earlier reads: so it is the same whenever a run is repeated.

Control units act for an area whose ``plc_present_w`` is set, while their ``enable_w`` is TRUE: then
``command_w`` counts, else the HMI's request. The operation mode manager takes the transition of
``command_w`` when its semaphore is set, and clears it. An axis moves only with its three releases
while a PLC is there for it.
"""

from __future__ import annotations

import math
import struct
from bisect import bisect_left
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import field
from functools import cache, partial
from typing import TypeGuard, cast

from nctakt.base.dataclass import dataclass
from nctakt.base.version import __version__
from nctakt.hli import table
from nctakt.hli.function_units import FunctionUnits, Placed, Waiting, is_unit
from nctakt.hli.plc_entries import SpindleEntry
from nctakt.hli.table import ACTS, MANAGED, UNSERVED, DataType, Element, Tie
from nctakt.kernel import cells
from nctakt.lists.machine.axis_configuration import AxisType
from nctakt.lists.machine.machine import Machine
from nctakt.nc.vocabulary.variables import strings

Scalar = float | bool | str

#: Prefixes of the names of values without a signal, such as the waiting functions of a channel.
ASKED = "?"

#: Formats of ``struct`` of the elementary types.
FORMATS: Mapping[str, str] = {
    "BOOL": "B",
    "BYTE": "B",
    "USINT": "B",
    "INT": "h",
    "UINT": "H",
    "WORD": "H",
    "DINT": "i",
    "UDINT": "I",
    "LREAL": "d",
}

#: Kinds of axes (P-AXIS-00018).
AXIS_TYPES = {AxisType.LINEAR: 1, AxisType.ROTARY: 2, AxisType.SPINDLE: 4}

#: The kind of a simulated drive (HLI_DRIVE_SIMULATION).
_SIMULATED = 4

#: The mode of operation that is simulated, and its states (HLI_IMCM_…).
STANDBY, AUTOMATIC = 1, cells.MODE_AUTOMATIC
DESELECTED, SELECTED, READY = cells.MODE_DESELECTED, cells.MODE_SELECTED, cells.MODE_READY
ACTIVE, HOLD, ERROR = cells.MODE_ACTIVE, cells.MODE_HOLD, cells.MODE_ERROR
RESETTING = cells.MODE_RESETTING

_MODE_NAMES = ("STATE", "PAUSED", "FEED_HOLD", "ARMED")
MODE = "channel_mc_control.mode_and_state"
ERROR_FLAG = "mc_error.semaphor_rw"
_ERROR_NAMES = ("ERROR", "ERROR_SERIAL")

#: The releases of an axis, in the order in which the table has them.
RELEASES = tuple(
    f"lr_mc_control.{name}" for name in ("release_feedhold", "drive_on", "torque_permission")
)

#: The initial commands of control units that do not start at 0.
_INITIAL = {"HLI.OVERRIDE": 100.0, "OVERRIDE": 100.0, "HLI.SEARCH_PASS": 1.0}


class NotWritable(Exception):
    """A write that is refused: ``reason``.

    ``is_size``: for its length; ``is_of_cnc``: because the CNC writes it; ``number``: for this
    number, which the element ``slot`` does not take.
    """

    def __init__(
        self,
        reason: str,
        *,
        is_size: bool = False,
        is_of_cnc: bool = False,
        number: float | None = None,
        slot: Slot | None = None,
    ) -> None:
        super().__init__(reason)
        self.reason = reason
        self.is_size = is_size
        self.is_of_cnc = is_of_cnc
        self.number = number
        self.slot = slot


@dataclass(frozen=True, slots=True)
class Written:
    """The meaning of a write: values of the session, programs to select by channel from 1.

    ``known``: the elements that have no effect here; ``waiting``: the control units that act only
    when their area has ``plc_present_w``, and they have ``enable_w``. ``acknowledged``: functions.
    ``locked``: axes by their index, and whether their releases are missing now. ``refused``:
    semaphores of transitions that are not simulated, which are cleared.
    """

    values: dict[str, Scalar] = field(default_factory=dict)
    programs: list[tuple[int, str]] = field(default_factory=list)
    known: list[str] = field(default_factory=list)
    waiting: list[str] = field(default_factory=list)
    acknowledged: list[tuple[int, Waiting]] = field(default_factory=list)
    locked: dict[int, bool] = field(default_factory=dict)
    refused: list[str] = field(default_factory=list)


@dataclass(frozen=True, slots=True)
class Slot:
    """A number, text or array of bytes in an area; ``path``: after the pointer."""

    path: str
    offset: int
    element: Element

    @property
    def type(self) -> DataType:
        """Its type."""
        return self.element.type

    @property
    def end(self) -> int:
        """The offset of the byte after it."""
        return self.offset + self.type.size_bytes

    @property
    def is_number(self) -> bool:
        """Whether it is a number, and no text or array of bytes."""
        return self.type.name in FORMATS

    @property
    def unit(self) -> str:
        """The path of the structure that it is in: of its control unit."""
        return self.path.rpartition(".")[0]

    @property
    def code(self) -> str:
        """Its format of ``struct``."""
        return FORMATS.get(self.type.name, f"{self.type.size_bytes}s")

    def value_of(self, data: bytes) -> float | str:
        """Return the number or text in its bytes."""
        if not self.is_number:
            return strings.decode(data)
        (value,) = struct.unpack(f"<{self.code}", data)
        return float(value) if self.code == "d" else int(value)

    def bytes_of(self, value: Scalar) -> bytes:
        """Return a number or text as its bytes, within the bounds of its type."""
        return struct.pack(f"<{self.code}", _packed(self, value))

    @property
    def is_commanded(self) -> bool:
        """Whether the PLC writes it and it belongs to a control unit that acts."""
        is_command = self.path.endswith((".command_w", ".enable_w"))
        return is_command and self.element.effect == ACTS and not self.is_of_watchdog

    @property
    def is_of_watchdog(self) -> bool:
        """Whether it belongs to the sign of life of the PLC, which has no ``command_w``."""
        return self.element.row is not None and self.element.row.handshake == "alive"


#: Gives the number that a slot shows, from values of the session.
_Show = Callable[[Mapping[str, Scalar]], float]


@cache
def slots(root: str) -> Mapping[str, Slot]:
    """Return all slots of a pointer by their paths, in the order of their bytes."""
    found = {}
    for leaf in table.root(root).leaves():
        path = leaf.path.partition("^.")[2]
        found[path] = Slot(path, leaf.offset, leaf)
    return found


@cache
def _in_order(root: str) -> tuple[tuple[Slot, ...], tuple[int, ...]]:
    """Return the slots of a pointer, and where each begins."""
    found = tuple(slots(root).values())
    return found, tuple(slot.offset for slot in found)


@cache
def _with_values(root: str) -> tuple[Slot, ...]:
    """Return the slots of a pointer that may show a value of the session, or begin with one."""
    return tuple(
        slot
        for slot in slots(root).values()
        if _is_of_session(slot.element.tie)
        or slot.path == ERROR_FLAG
        or slot.path.startswith(f"{MODE}.state_r.")
        or slot.unit in RELEASES
    )


@cache
def _with_facts(root: str) -> tuple[tuple[Slot, str], ...]:
    """Return the slots of a pointer that hold facts about the machine, and their names."""
    ties = ((slot, slot.element.tie) for slot in slots(root).values())
    return tuple((slot, tie.name) for slot, tie in ties if tie is not None and tie.kind == "fact")


def _is_of_session(tie: Tie | None) -> TypeGuard[Tie]:
    """Return whether a tie leads to a value of the session."""
    return tie is not None and tie.kind not in ("fact", UNSERVED) and tie.name not in MANAGED


class AreaShape:
    """The target of one pointer, such as ``gpCh[0]``, and its content.

    ``prefix``: that of the names of its channel in the session. ``axes``: the names of a channel's
    axes, or that of the axis itself. ``spindle``: the spindle that the axis turns; empty: none.
    ``channel``: number of the channel whose functions it shows; 0: none. ``elsewhere``: axes and
    spindles whose functions are at their own pointers.
    """

    def __init__(
        self,
        root: str,
        index: int,
        prefix: str,
        axes: Sequence[str] = (),
        spindle: str = "",
        channel: int = 0,
        elsewhere: frozenset[str] = frozenset(),
    ) -> None:
        self.root = root
        self.index = index
        self.prefix = prefix
        self.axes = axes
        self.spindle = spindle
        self.channel = channel
        self.elsewhere = elsewhere
        self.size_bytes = table.root(root).type.size_bytes

    @property
    def name(self) -> str:
        """The pointer: ``gpCh[0]^``."""
        return table.root(self.root, self.index).path

    def session_name(self, element: Element) -> str:
        """Return the value of the session that an element shows or sets; empty for none."""
        tie = element.tie
        if not _is_of_session(tie):
            return ""
        if tie.for_spindles:
            if not self.spindle:
                return ""
            if tie.kind == ACTS:
                return f"{self.prefix}HLI.{self.spindle}.{tie.name}".upper()
            return f"{self.prefix}{self.spindle}.{tie.name}"
        if self.root == "gpCh" and "coord_r" not in element.path:
            return f"{self.prefix}{tie.name}"
        number = element.indices[0] if self.root == "gpCh" else 0
        return f"{self.prefix}{self.axes[number]}.{tie.name}" if number < len(self.axes) else ""

    def named(self, name: str) -> str:
        """Return a value of the session by its name without channel and axis; empty: none."""
        if self.root != "gpAx":
            return f"{self.prefix}{name}"
        return f"{self.prefix}{self.axes[0]}.{name}" if self.axes else ""

    def between(self, offset: int, end: int) -> Sequence[Slot]:
        """Return the slots that begin within a range."""
        found, starts = _in_order(self.root)
        return found[bisect_left(starts, offset) : bisect_left(starts, end)]

    def begins(self, offset: int) -> bool:
        """Return whether a slot begins at an offset."""
        return bool(self.between(offset, offset + 1))

    def fits(self, offset: int, size: int) -> bool:
        """Return whether a range can be read: it is not the mere beginning of a number."""
        found = self.between(offset, offset + size)
        if not found or offset + size > self.size_bytes:
            return False
        return len(found) > 1 or not found[0].is_number or found[0].end <= offset + size

    def hides(self, offset: int, size: int) -> str:
        """Return the path of a single requested element without a value here; else nothing."""
        found = self.between(offset, offset + size)
        if len(found) != 1:
            return ""
        slot, tie = found[0], found[0].element.tie
        is_missing = tie is not None and (tie.kind == UNSERVED or tie.for_spindles)
        if is_missing and slot.element.by == "CNC" and not self.session_name(slot.element):
            return f"{self.name}.{slot.path}"
        return ""

    def checked(self, offset: int, data: bytes) -> tuple[Sequence[Slot], bytes]:
        """Return the slots that bytes are for, and the bytes of all of them.

        Bytes may be missing at the end of a text, and after the last number of a structure. Raises
        ``NotWritable``.
        """
        end = offset + len(data)
        touched = self.between(offset, end)
        if not touched or touched[0].offset != offset or end > self.size_bytes:
            raise NotWritable(f"{len(data)} bytes do not fit there", is_size=True)
        last = touched[-1]
        if last.end > end:
            if not last.type.is_text and not last.element.name.startswith("fill_up"):
                raise NotWritable(f"{last.path} is cut off", is_size=True)
            data += bytes(last.end - end)
        for slot in touched:
            if slot.element.by == "CNC":
                raise NotWritable(f"{self.name}.{slot.path} is written by the CNC", is_of_cnc=True)
            part = data[slot.offset - offset : slot.end - offset]
            if slot.code == "d" and not math.isfinite(*struct.unpack("<d", part)):
                raise NotWritable(f"{self.name}.{slot.path} takes finite numbers only")
            if slot.is_commanded and not slot.element.is_enable:
                self.check_command(slot, slot.value_of(part))
        return touched, data

    def check_command(self, slot: Slot, number: float | str) -> None:
        """Raise ``NotWritable`` for a number that a control unit does not take."""
        tie = slot.element.tie
        if tie is not None and not isinstance(number, str) and not tie.takes(number):
            reason = f"{self.name}.{slot.path} does not take {number:g}"
            raise NotWritable(reason, number=number, slot=slot)


class Area:
    """The bytes of one pointer's target: written and shown values."""

    def __init__(self, shape: AreaShape) -> None:
        self.shape = shape
        self.memory = bytearray(shape.size_bytes)
        self._shown: dict[int, tuple[Slot, tuple[str, ...], _Show]] = {}
        self._read_error = 0.0
        self._has_script = False
        root = shape.root
        present = "plc_present_w" if root == "gpPform" else "head.plc_present_w"
        self._present = slots(root)[present]
        self.mode_names = tuple(map(self._panel, _MODE_NAMES))
        self.error_names = tuple(map(self._panel, _ERROR_NAMES))
        self._functions = f"{ASKED}{shape.channel}.functions" if shape.channel else ""
        self._units: FunctionUnits | None = None
        if shape.channel:
            has_spindle = root == "gpAx" and bool(shape.spindle)
            self._units = FunctionUnits(
                root, self.memory, self._put_number, self._takes, has_spindle=has_spindle
            )
        for slot in _with_values(root):
            self._prepare(slot)

    def _takes(self, entry: Waiting) -> bool:
        """Return whether a function is shown here: those of axes and spindles at theirs."""
        name = entry.spindle if isinstance(entry, SpindleEntry) else entry.axis
        shape = self.shape
        if shape.root == "gpCh":
            return name not in shape.elsewhere
        return bool(name) and name in (shape.spindle, *shape.axes)

    def _put_number(self, path: str, number: float) -> None:
        self._put(self._slot(path), number)

    @property
    def name(self) -> str:
        """The pointer: ``gpCh[0]^``."""
        return self.shape.name

    def _panel(self, name: str) -> str:
        """Return the name in the session of an operator's value."""
        return f"{self.shape.prefix}HLI.{name}"

    def announce(self) -> None:
        """Announce a PLC in Python for this area, which need not do so itself.

        Of its axis only the releases count whose units it has enabled.
        """
        self._has_script = True

    def publish(self, facts: Mapping[str, Scalar], inside: str = "") -> None:
        """Keep facts about the machine by the names of their ties, in the slots below a path."""
        for slot, name in _with_facts(self.shape.root):
            is_own = slot.path.startswith(inside) if inside else "coord_r" not in slot.path
            if is_own and name in facts:
                self._put(slot, facts[name])

    # --- display --------------------------------------------------------------------------------

    def _prepare(self, slot: Slot) -> None:
        """Note the content of a slot, or keep the initial values of a control unit."""
        tie, name = slot.element.tie, self.shape.session_name(slot.element)
        if slot.path.startswith(f"{MODE}.state_r."):
            number = self._mode_state if slot.path.endswith(".state") else _automatic
            self._shown[slot.offset] = slot, self.mode_names, number
        elif slot.path == ERROR_FLAG:
            self._shown[slot.offset] = slot, self.error_names, self._is_error_new
        elif slot.unit in RELEASES and slot.path.endswith(("request_r", "state_r")):
            self._shown[slot.offset] = slot, (), partial(self._released, slot)
        elif tie is not None and name and not slot.is_commanded:
            self._shown[slot.offset] = slot, (name,), self._number(slot, tie, name)
        elif tie is not None and name and not slot.element.is_enable:
            self._put(slot, _INITIAL.get(tie.name, 0.0) * tie.factor)

    def _number(self, slot: Slot, tie: Tie, name: str) -> _Show:
        """Return a function for the number of a slot that shows one value."""
        shown = tie.shown
        if not slot.path.endswith(".request_r"):
            return lambda values: shown(float(values[name]))

        def requested(values: Mapping[str, Scalar]) -> float:
            is_kept = self._is_decided(slot.unit)
            return self._get(slot) if is_kept else shown(float(values[name]))

        return requested

    def _is_there(self) -> bool:
        """Return whether a PLC is announced for this area."""
        return self._has_script or self._get(self._present) != 0.0

    def _is_decided(self, unit: str) -> bool:
        """Return whether the PLC decides about a control unit."""
        return self._get(self._slot(f"{unit}.enable_w")) != 0.0 and self._is_there()

    def _released(self, slot: Slot, values: Mapping[str, Scalar]) -> float:
        """Return a release in force; as a request: that of the HMI, which always asks for it."""
        return 1.0 if slot.path.endswith("request_r") else float(self._is_released(slot.unit))

    def _is_released(self, unit: str) -> bool:
        """Return whether an axis has one of its releases."""
        enable, command = (self._slot(f"{unit}.{one}") for one in ("enable_w", "command_w"))
        if not self._get(self._present) and (not self._has_script or not self._get(enable)):
            return True  # there is no PLC, or a script that leaves it out
        return bool(self._get(enable) and self._get(command))

    def _mode_state(self, values: Mapping[str, Scalar]) -> float:
        """Return the state of the automatic mode."""
        state, is_paused, is_held, is_armed = (values[name] for name in self.mode_names)
        if state in (2, 3):
            return ERROR if state == 2 else RESETTING
        if state == 1:
            return HOLD if is_held or is_paused else ACTIVE
        return READY if is_armed else SELECTED

    def _is_error_new(self, values: Mapping[str, Scalar]) -> float:
        error, serial = (float(values[name]) for name in self.error_names)
        return float(error != 0.0 and serial != self._read_error)

    def shown_numbers(self) -> Iterator[tuple[Slot, str, Tie]]:
        """Yield the numbers that show one value of the session as it is, and that value."""
        for slot, names, _ in self._shown.values():
            tie = slot.element.tie
            is_plain = tie is not None and tie.kind != "fact" and tie.name not in MANAGED
            if is_plain and tie is not None and slot.element.by == "CNC" and len(names) == 1:
                if slot.is_number and not slot.path.endswith(".request_r"):
                    yield slot, names[0], tie

    def control_units(self) -> Iterator[tuple[str, str, Tie, bool]]:
        """Yield path, value, tie of each control unit that acts; whether by its edge."""
        for slot in _with_values(self.shape.root):
            element = slot.element
            name = self.shape.session_name(element)
            if slot.is_commanded and not element.is_enable and name and slot.unit not in RELEASES:
                if element.tie is not None and element.row is not None:
                    yield slot.unit, name, element.tie, element.row.handshake == "edge"

    @property
    def present(self) -> Slot:
        """The element by which a PLC announces itself for the area."""
        return self._present

    # --- bytes ----------------------------------------------------------------------------------

    def _slot(self, path: str) -> Slot:
        return slots(self.shape.root)[path]

    def _put(self, slot: Slot, value: Scalar) -> None:
        struct.pack_into(f"<{slot.code}", self.memory, slot.offset, _packed(slot, value))

    def _get(self, slot: Slot) -> float:
        (value,) = struct.unpack_from(f"<{slot.code}", self.memory, slot.offset)
        return float(value)

    def _show(self, slot: Slot, values: Mapping[str, Scalar]) -> None:
        """Put the content of a slot into the memory."""
        shown = self._shown.get(slot.offset)
        if shown is not None:
            self._put(slot, shown[2](values))

    def _show_functions(self, values: Mapping[str, Scalar]) -> None:
        """Put the functions that wait into their units."""
        if self._units is not None:
            self._units.show(cast("Sequence[Placed]", values[self._functions]))

    def read(self, offset: int, size: int, values: Mapping[str, Scalar]) -> bytes:
        """Return a range of bytes; raises ``KeyError`` for a value that is not there."""
        found = self.shape.between(offset, offset + size)
        self._show(self._present, values)
        if any(is_unit(slot.path) for slot in found):
            self._show_functions(values)
        for slot in found:
            self._show(slot, values)
        return bytes(self.memory[offset : offset + size])

    # --- writing --------------------------------------------------------------------------------

    def check(
        self, offset: int, data: bytes, values: Mapping[str, Scalar], *, stays: bool = False
    ) -> None:
        """Raise ``NotWritable`` for bytes that ``write`` would not take now.

        ``stays``: they stay in the memory, for the check of bytes written with them.
        """
        touched, data = self.shape.checked(offset, data)
        is_mode = any(slot.path.startswith(MODE) for slot in touched)
        if not is_mode and not stays:
            return
        self._show(self._present, values)
        kept = bytes(self.memory)
        is_taken = False
        try:
            self.memory[offset : offset + len(data)] = data
            if is_mode:
                self.take_transition(Written(), values)
            is_taken = stays
        finally:
            if not is_taken:
                self.memory[:] = kept

    def write(self, offset: int, data: bytes, values: Mapping[str, Scalar]) -> Written:
        """Take bytes, and return their meaning. Raises ``NotWritable``."""
        self.check(offset, data, values)
        touched, data = self.shape.checked(offset, data)
        self._show(self._present, values)
        if any(is_unit(slot.path) for slot in touched):
            self._show_functions(values)
        before = {slot.path: self._get(slot) for slot in touched if slot.is_number}
        self.memory[offset : offset + len(data)] = data
        written = Written()
        for slot in touched:
            self._take(slot, before.get(slot.path, 0.0), written, values)
        if any(slot.path.startswith(MODE) or slot is self._present for slot in touched):
            try:
                self.take_transition(written, values)
            except NotWritable:  # it was there before the PLC
                written.refused.append(f"{self.name}.{MODE}.command_semaphor_rw")
        if any(slot.unit in RELEASES or slot is self._present for slot in touched):
            if self.shape.root == "gpAx":
                is_locked = not all(map(self._is_released, RELEASES))
                written.locked[self.shape.index] = is_locked
        return written

    def _take(
        self, slot: Slot, before: float, written: Written, values: Mapping[str, Scalar]
    ) -> None:
        """Let one written slot have its effect; ``before``: its number before."""
        tie, name = slot.element.tie, self.shape.session_name(slot.element)
        if slot.path == ERROR_FLAG:
            if self._get(slot) == 0.0:
                self._read_error = float(values[self.error_names[1]])
        elif slot.path.startswith(MODE) or slot.unit in RELEASES:
            pass
        elif is_unit(slot.path):
            entry = None if self._units is None else self._units.write(slot.path, self._get(slot))
            if entry is not None:
                written.acknowledged.append((self.shape.channel, entry))
        elif slot.is_commanded and name:
            was_decided = slot.element.is_enable and bool(before) and self._is_there()
            self._settle(slot, before, written, values, was_decided=was_decided)
        elif tie is not None and name:
            written.values[name] = tie.commanded(self._get(slot))
        elif slot is not self._present and not slot.element.name.startswith("fill_up"):
            written.known.append(f"{self.name}.{slot.path}")
        if slot is self._present and bool(before) != bool(self._get(slot)):
            for switch in self._enabled():
                self._settle(switch, before, written, values, was_decided=bool(before))

    def _enabled(self) -> Iterator[Slot]:
        """Yield the switches of the control units that are enabled."""
        for slot in _with_values(self.shape.root):
            is_switch = slot.is_commanded and slot.element.is_enable
            if is_switch and self.shape.session_name(slot.element) and self._get(slot):
                yield slot

    def _settle(
        self,
        slot: Slot,
        before: float,
        written: Written,
        values: Mapping[str, Scalar],
        *,
        was_decided: bool,
    ) -> None:
        """Let a control unit act after a write to ``slot``, whose number was ``before``.

        ``was_decided``: until now the PLC has decided about it.
        """
        unit = slot.unit
        command, request = (self._slot(f"{unit}.{one}") for one in ("command_w", "request_r"))
        tie, row = command.element.tie, command.element.row
        name = self.shape.session_name(slot.element)
        if tie is None or row is None:
            return
        is_edge = row.handshake == "edge"
        number = self._get(command)
        if self._is_decided(unit):
            if is_edge:
                if slot is command and number and not before:
                    written.values[name] = 1.0
                return
            if slot.element.is_enable and not before:
                self._put(request, tie.shown(float(values[name])))
            written.values[name] = tie.commanded(number)
        elif was_decided and not is_edge:
            written.values[name] = tie.commanded(self._get(request))
        elif slot is command or self._get(slot):
            written.waiting.append(f"{self.name}.{unit}")

    def ask(self, unit: str, number: float, values: Mapping[str, Scalar]) -> Written:
        """Let the HMI ask a control unit for something.

        While the PLC decides, ``request_r`` shows it, without further effect.
        """
        self._show(self._present, values)
        command = self._slot(f"{unit}.command_w")
        self.shape.check_command(command, number)
        tie, name = command.element.tie, self.shape.session_name(command.element)
        self._put(self._slot(f"{unit}.request_r"), number)
        if tie is None or not name:
            return Written(known=[f"{self.name}.{unit}"])
        return Written() if self._is_decided(unit) else Written({name: tie.commanded(number)})

    # --- operation mode manager -----------------------------------------------------------------

    def take_transition(self, written: Written, values: Mapping[str, Scalar]) -> None:
        """Take the transition that the PLC commands, where its semaphore is set."""
        if self.shape.root != "gpCh":
            return
        semaphore = self._slot(f"{MODE}.command_semaphor_rw")
        if not self._get(semaphore):
            return
        if not self._is_decided(MODE):
            written.waiting.append(f"{self.name}.{MODE}")
            return
        self._put(semaphore, 0.0)
        mode, state = (
            int(self._get(self._slot(f"{MODE}.command_w.{one}"))) for one in ("to_mode", "to_state")
        )
        text = self._slot(f"{MODE}.command_w.parameter")
        program = strings.decode(self.memory[text.offset : text.end])
        written_now = self.go_to(mode, state, program, values)
        written.values.update(written_now.values)
        written.programs.extend(written_now.programs)

    def begin(self, program: str, values: Mapping[str, Scalar]) -> Written:
        """Select a program and press START, as the job of a client orders it.

        While another one runs, only the selection is written, which is refused then.
        """
        written = Written(programs=[(self.shape.index + 1, program)])
        if self._mode_state(values) not in (ACTIVE, HOLD):
            written.values[self._panel("START")] = 1.0
        return written

    def go_to(self, mode: int, state: int, program: str, values: Mapping[str, Scalar]) -> Written:
        """Go to a state of the automatic mode, through all states between.

        ``program`` is selected on the way to READY. Raises ``NotWritable`` for another mode and for
        an invalid target (HLI_IMCM_…).
        """
        if mode not in (0, STANDBY, AUTOMATIC):
            raise NotWritable(f"mode {mode} is not simulated; automatic mode is {AUTOMATIC}")
        if state not in (DESELECTED, SELECTED, READY, ACTIVE, HOLD, RESETTING):
            raise NotWritable(f"state {state} is no target")
        now = self._mode_state(values)
        written = Written()
        if program and state in (READY, ACTIVE) and now not in (ACTIVE, HOLD):
            written.programs.append((self.shape.index + 1, program))
        hold, start, reset = map(self._panel, ("FEED_HOLD", "START", "RESET"))
        if state == ACTIVE:
            written.values.update({hold: 0.0, start: 1.0})
        elif state == HOLD:
            written.values[hold] = 1.0
        elif state != READY and (state == RESETTING or now != SELECTED):
            written.values.update({hold: 0.0, reset: 1.0})
        return written


def _automatic(values: Mapping[str, Scalar]) -> float:
    """Return the mode of operation that is simulated."""
    return AUTOMATIC


def _packed(slot: Slot, value: Scalar) -> float | bytes:
    """Return a value as ``struct`` takes it for a slot, within the bounds of its type."""
    size = slot.type.size_bytes
    if not slot.is_number:
        return strings.encode(str(value)[: size - 1], size)
    number = float(value)
    if slot.code == "d":
        return number
    if not math.isfinite(number):
        return 0
    bits = 8 * size
    if slot.code.isupper():
        return min(max(round(number), 0), (1 << bits) - 1)
    return min(max(round(number), -(1 << (bits - 1))), (1 << (bits - 1)) - 1)


def shapes(machine: Machine, prefixes: Sequence[str]) -> dict[str, list[AreaShape]]:
    """Return the targets of all pointers; ``prefixes``: of each channel's names."""
    listed = {axis.logical_number for axis in machine.axes}
    turned: dict[int, tuple[str, str, int]] = {}
    moved: dict[int, tuple[str, int]] = {}
    channels: list[AreaShape] = []
    for prefix, channel in zip(prefixes, machine.channels, strict=True):
        number = len(channels) + 1
        names = [axis.name for axis in channel.axes]
        spindles = channel.parameters.spindles
        elsewhere = {*names, *(one.name for one in spindles if one.logical_number in listed)}
        moved |= {axis.index: (prefix, number) for axis in channel.axes}
        for spindle in spindles:
            turned.setdefault(spindle.logical_number, (prefix, spindle.name, number))
        channels.append(
            AreaShape(
                "gpCh", number - 1, prefix, names, channel=number, elsewhere=frozenset(elsewhere)
            )
        )
    axes = []
    for index, axis in enumerate(machine.axes):
        prefix, name, number = turned.get(axis.logical_number, ("", "", 0))
        owner, channel_number = moved.get(index, (prefix, number))
        names = [axis.name] if index in moved else []
        axes.append(AreaShape("gpAx", index, owner, names, name, channel_number))
    return {"gpPform": [AreaShape("gpPform", 0, "")], "gpCh": channels, "gpAx": axes}


def areas(machine: Machine, prefixes: Sequence[str]) -> dict[str, list[Area]]:
    """Return all areas of a machine by their pointers; ``prefixes``: of each channel's names."""
    found = {
        root: [Area(shape) for shape in all_] for root, all_ in shapes(machine, prefixes).items()
    }
    found["gpPform"][0].publish({"version": __version__})
    for area, channel in zip(found["gpCh"], machine.channels, strict=True):
        size = area.shape.size_bytes
        area.publish({"version": __version__, "size": size, "channel": area.shape.channel})
        for at, axis in enumerate(channel.axes):
            facts: dict[str, Scalar] = {"name": axis.name, "logical": axis.logical_number}
            facts["type"] = AXIS_TYPES[machine.axes[axis.index].type]
            area.publish(facts, f"bahn_state.coord_r[{at}].")
    for area, listed in zip(found["gpAx"], machine.axes, strict=True):
        facts = {"logical": listed.logical_number, "type": AXIS_TYPES[listed.type]}
        area.publish({**facts, "drive": _SIMULATED, "spindle": bool(area.shape.spindle)})
    return found
