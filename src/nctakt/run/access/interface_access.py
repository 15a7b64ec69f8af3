# SPDX-License-Identifier: MIT
"""The interface by the paths of the controller, for PLCs in Python and for clients.

In: ``gpCh[0]^.bahn_mc_control.override.command_w`` and values in the units of the table, or ranges
of bytes. Out: the present values, and the meaning of a write: an operator's value, a selected
program. A PLC in Python is announced on all channels and axes automatically, from its first write
on.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any, NamedTuple, Protocol, TypeVar, cast

from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.hli import table
from nctakt.hli.checked_values import number_of
from nctakt.hli.function_units import Placed
from nctakt.hli.interface_memory import (
    ASKED,
    Area,
    NotWritable,
    Scalar,
    Slot,
    Written,
    areas,
    slots,
)
from nctakt.hli.plc_entries import SpindleEntry
from nctakt.lists.machine.machine import Machine
from nctakt.messages import diagnostic
from nctakt.messages.commands.inputs import VALUE_NOT_OF_TYPE
from nctakt.messages.plcs.hli_table import (
    NO_SUCH_BYTES,
    NO_SUCH_TRANSITION,
    NUMBER_NOT_TAKEN,
    PATH_HAS_NO_EFFECT,
    PATH_IS_STRUCTURE,
    PATH_NOT_SERVED,
    PATH_OF_NO_CHANNEL,
    PATH_READ_ONLY,
    TRANSITION_DROPPED,
    UNIT_NOT_ENABLED,
)
from nctakt.run.access.inputs import PLC, Inputs
from nctakt.run.access.machine_names import prefix_of
from nctakt.run.access.named_values import SignalCell
from nctakt.run.access.zero_offset_access import ChannelOffsets, ZeroOffsetAccess, is_zero_offset

_T = TypeVar("_T")

#: Maximum number of paths whose elements are kept; they can be spelled in any number of ways.
_MAX_KEPT = 10_000

#: The elementary types and the types of variables with the same range.
_TYPES: Mapping[str, str] = {
    "BOOL": "BOOLEAN",
    "BYTE": "UNS08",
    "USINT": "UNS08",
    "INT": "SGN16",
    "UINT": "UNS16",
    "WORD": "UNS16",
    "DINT": "SGN32",
    "UDINT": "UNS32",
    "LREAL": "REAL64",
}


#: A range of bytes by name: ``gpCh[0]^:96+6``; its value is their hexadecimal digits.
_RANGE = re.compile(r"(gpPform|gpCh|gpAx)(?:\[(\d+)\])?\^:(\d+)\+(\d+)")

#: Prefixes of the names of control units for requests of the HMI, and of bytes without effect that
#: are only read back.
ASK, KEPT = "ask ", "kept ^"

#: Prefix of the names of channels that a client orders to run a program file.
JOB = "job "

#: Bytes without an effect that are kept at most, and the digits of each.
_MAX_KEPT_NAMES, _MAX_DIGITS = 5000, 8192


#: Characters of the name of a program at most.
_MAX_FILE_NAME = 255


class RunningMachine(Protocol):
    """The part of a machine that the interface needs (``AssembledMachine``)."""

    configuration: Machine
    cells: Any
    inputs: Inputs
    report: Callable[[Diagnostic], None]

    @property
    def assembled(self) -> Sequence[ChannelOffsets]:
        """The channels with their zero offsets."""

    def signals(self) -> Mapping[str, SignalCell]:
        """Return the cells of all signals."""

    def read(self, name: str) -> Scalar:
        """Return a value by its name; a written value even before it is latched."""

    def write(self, name: str, value: Scalar, source: str) -> None:
        """Write a value by its name."""

    def waiting_functions(self, channel: int) -> Sequence[Placed]:
        """Return entries waiting for the PLC of a channel, each with its unit of the interface."""

    def lock_axis(self, index: int, is_locked: bool) -> None:
        """Take an axis its releases, or give them to it."""


class _Found(NamedTuple):
    area: Area
    slot: Slot


class _Values(Mapping[str, Scalar]):
    """The values of the session as an area asks for them, from the cells of the machine."""

    def __init__(self, machine: RunningMachine) -> None:
        self._machine = machine
        self._signals = machine.signals()

    def __getitem__(self, name: str) -> Scalar:
        if name.startswith(ASKED):  # the functions of a channel, which are no signal
            number = name.removeprefix(ASKED).partition(".")[0]
            return cast("Scalar", self._machine.waiting_functions(int(number) - 1))
        if "HLI." in name:
            return self._machine.read(name)  # a written value counts before it is latched
        return float(self._machine.cells[self._signals[name].cell])

    def __iter__(self) -> Iterator[str]:
        return iter(self._signals)

    def __len__(self) -> int:
        return len(self._signals)


def range_name(pointer: str, offset: int, size: int) -> str:
    """Return the name of a range of bytes that a pointer such as ``gpCh[0]^`` leads to."""
    return f"{pointer}:{offset}+{size}"


class InterfaceAccess:
    """The interface of a machine by paths and by ranges of bytes; shared by all who act as its PLC.

    It is state of the run: a write into it is an input like any other, and is on the tape under the
    name used for it.
    """

    def __init__(self, machine: RunningMachine, count: int) -> None:
        self._machine = machine
        prefixes = [prefix_of(index) if count > 1 else "" for index in range(count)]
        self._areas = areas(machine.configuration, prefixes)
        self._values = _Values(machine)
        self._found: dict[str, _Found] = {}
        self._kept: dict[str, str] = {}
        self._zero_offsets = ZeroOffsetAccess(dict(enumerate(machine.assembled, 1)))
        self._reported: set[str] = set()
        self._is_draft = False

    def _announce(self) -> None:
        """Announce a PLC in Python on all channels and axes."""
        for found in self._areas.values():
            for area in found:
                area.announce()

    # --- names ----------------------------------------------------------------------------------

    def read(self, name: str) -> Scalar:
        """Return an element, a range of bytes, or a kept value; raises ``Failure``."""
        if name.startswith(KEPT):
            return self._kept.get(name, "")
        if name.startswith(JOB):
            return ""
        if is_zero_offset(name):
            return self._zero_offsets.read(name)
        if name.startswith(ASK):
            return self.get(f"{name.removeprefix(ASK)}.request_r")
        match = _RANGE.fullmatch(name)
        if match is None:
            return self.get(name)
        area, offset, size = self._range(name, match)
        return area.read(offset, size, self._values).hex()

    def check(self, name: str, value: Scalar) -> None:
        """Raise ``Failure`` for a name or value that ``write`` would not take now."""
        if name.startswith(KEPT):
            self._digits(name, value)
        elif name.startswith(JOB):
            self._job(name, value)
        elif is_zero_offset(name):
            self._zero_offsets.check(name, value)
        elif name.startswith(ASK):
            self._asked(name, value)
        else:
            area, offset, data = self._bytes(name, value)
            stays = self._is_draft
            self._refusing(name, lambda: area.check(offset, data, self._values, stays=stays))

    @contextmanager
    def draft(self) -> Iterator[None]:
        """Make each checked write known to the later checks, up to the end."""
        all_ = [area for found in self._areas.values() for area in found]
        kept = [bytes(area.memory) for area in all_]
        self._is_draft = True
        try:
            yield
        finally:
            self._is_draft = False
            for area, memory in zip(all_, kept, strict=True):
                area.memory[:] = memory

    def write(self, name: str, value: Scalar, source: str) -> None:
        """Write an element or a range of bytes, or ask a control unit; raises ``Failure``.

        Its effect counts from the next tick on. A write without effect is reported once, as a note.
        """
        if source.partition(" ")[0] == PLC:
            self._announce()
        if name.startswith(KEPT):
            digits = self._digits(name, value)
            if name in self._kept or len(self._kept) < _MAX_KEPT_NAMES:
                self._kept[name] = digits
        elif name.startswith(JOB):
            area, program = self._job(name, value)
            self._let_act(area.begin(program, self._values), source)
        elif is_zero_offset(name):
            self._zero_offsets.write(name, value)
        elif name.startswith(ASK):
            found, number = self._asked(name, value)
            self._let_act(found.area.ask(found.slot.unit, number, self._values), source)
        else:
            area, offset, data = self._bytes(name, value)
            written = self._refusing(name, lambda: area.write(offset, data, self._values))
            self._let_act(written, source)

    def _refusing(self, name: str, act: Callable[[], _T]) -> _T:
        try:
            return act()
        except NotWritable as refused:
            found = diagnostic(NO_SUCH_TRANSITION, path=name)
            if refused.is_of_cnc:
                found = diagnostic(PATH_READ_ONLY, path=name)
            elif refused.slot is not None and refused.slot.element.tie is not None:
                known = refused.slot.element.tie.taken
                found = diagnostic(NUMBER_NOT_TAKEN, path=name, value=refused.number, known=known)
            raise Failure(found) from None

    def _digits(self, name: str, value: Scalar) -> str:
        is_short = isinstance(value, str) and len(value) <= _MAX_DIGITS and len(name) <= 256
        if not is_short or not _is_hexadecimal(str(value)):
            raise Failure(diagnostic(VALUE_NOT_OF_TYPE, name=name, type="STRING", value=value))
        return str(value)

    def _asked(self, name: str, value: Scalar) -> tuple[_Found, float]:
        found = self._find(f"{name.removeprefix(ASK)}.command_w")
        type_ = _TYPES.get(found.slot.type.name)
        if type_ is None or isinstance(value, str):
            shown = found.slot.type.name
            raise Failure(diagnostic(VALUE_NOT_OF_TYPE, name=name, type=shown, value=value))
        number = number_of(name, type_, float(value))
        self._refusing(name, lambda: found.area.shape.check_command(found.slot, number))
        return found, number

    def _job(self, name: str, value: Scalar) -> tuple[Area, str]:
        """Return the channel that a job is for, and its program; raises ``Failure``."""
        found = self._find(f"{name.removeprefix(JOB)}.head.plc_present_w")
        if not isinstance(value, str) or not value or len(value) > _MAX_FILE_NAME:
            shown = f"STRING({_MAX_FILE_NAME})"
            raise Failure(diagnostic(VALUE_NOT_OF_TYPE, name=name, type=shown, value=value))
        return found.area, value

    def _range(self, name: str, match: re.Match[str]) -> tuple[Area, int, int]:
        """Return the area, offset and size of a range; raises ``Failure``."""
        known, index = self._areas[match[1]], int(match[2] or 0)
        if index >= len(known):
            raise Failure(diagnostic(PATH_OF_NO_CHANNEL, path=name, count=len(known)))
        area, offset, size = known[index], int(match[3]), int(match[4])
        if not area.shape.begins(offset) or not area.shape.fits(offset, size):
            raise Failure(diagnostic(NO_SUCH_BYTES, path=name, size=area.shape.size_bytes))
        return area, offset, size

    def _bytes(self, name: str, value: Scalar) -> tuple[Area, int, bytes]:
        """Return where a name is, and the bytes of a value for it; raises ``Failure``."""
        match = _RANGE.fullmatch(name)
        if match is None:
            return self._element_bytes(name, value)
        area, offset, size = self._range(name, match)
        if not isinstance(value, str) or len(value) != 2 * size or not _is_hexadecimal(value):
            type_ = f"{2 * size} hexadecimal digits"
            raise Failure(diagnostic(VALUE_NOT_OF_TYPE, name=name, type=type_, value=value))
        return area, offset, bytes.fromhex(value)

    def _element_bytes(self, path: str, value: Scalar) -> tuple[Area, int, bytes]:
        area, slot = self._find(path)
        if slot.element.by == "CNC":
            raise Failure(diagnostic(PATH_READ_ONLY, path=path))
        type_ = slot.type.name
        if isinstance(value, str) != slot.type.is_text:
            raise Failure(diagnostic(VALUE_NOT_OF_TYPE, name=path, type=type_, value=value))
        if not isinstance(value, str):
            value = number_of(path, _TYPES[type_], float(value))
        return area, slot.offset, slot.bytes_of(value)

    def _find(self, path: str) -> _Found:
        found = self._found.get(path)
        if found is None:
            element = table.find(path)
            known = self._areas.get(element.root, ())
            if element.index >= len(known):
                count = len(known)
                raise Failure(diagnostic(PATH_OF_NO_CHANNEL, path=path, count=count))
            if not element.type.is_elementary:
                members = ", ".join(one.name for one in element.type.members) or "[0]"
                raise Failure(diagnostic(PATH_IS_STRUCTURE, path=path, members=members))
            inside = element.path.partition("^.")[2]
            found = _Found(known[element.index], slots(element.root)[inside])
            if len(self._found) < _MAX_KEPT:
                self._found[path] = found
        return found

    def get(self, path: str) -> Scalar:
        """Return the present value of an element; raises ``Failure`` for anything else."""
        area, slot = self._find(path)
        if area.shape.hides(slot.offset, slot.type.size_bytes):
            raise Failure(diagnostic(PATH_NOT_SERVED, path=path))
        data = area.read(slot.offset, slot.type.size_bytes, self._values)
        value = slot.value_of(data)
        return value != 0 if slot.type.name == "BOOL" else value

    # --- effects of writes ----------------------------------------------------------------------

    def _let_act(self, written: Written, source: str) -> None:
        for channel, program in written.programs:
            self._machine.inputs.select(channel - 1, program, source)
        for name, value in written.values.items():
            self._machine.write(name, value, source)
        for index, is_locked in written.locked.items():
            self._machine.lock_axis(index, is_locked)
        for channel, entry in written.acknowledged:
            if isinstance(entry, SpindleEntry):
                self._machine.inputs.acknowledge_spindle(
                    channel - 1, entry.index, entry.serial, entry.name
                )
            else:
                self._machine.inputs.acknowledge(
                    channel - 1, entry.is_realtime, entry.slot, entry.serial, entry.name
                )
        for message, paths in (
            (PATH_HAS_NO_EFFECT, written.known),
            (UNIT_NOT_ENABLED, written.waiting),
            (TRANSITION_DROPPED, written.refused),
        ):
            for path in self._new(paths):
                self._machine.report(diagnostic(message, path=path))

    def _new(self, paths: Sequence[str]) -> Iterator[str]:
        """Yield the paths that have not been reported yet."""
        for path in paths:
            if path not in self._reported:
                self._reported.add(path)
                yield path


def _is_hexadecimal(text: str) -> bool:
    return re.fullmatch(r"(?:[0-9a-f]{2})*", text) is not None
