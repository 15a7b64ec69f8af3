# SPDX-License-Identifier: MIT
"""Elements of the interface by the paths of the controller, for a PLC in Python.

In: ``gpCh[0]^.bahn_mc_control.override.command_w`` and values in the units of the table. Out: the
present values, and what a write means: an operator's value, a program that is selected. A PLC in
Python is announced on all channels and axes by itself.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple, Protocol

from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.hli import table
from nctakt.hli.checked_values import number_of
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
from nctakt.lists.machine.machine import Machine
from nctakt.messages import diagnostic
from nctakt.messages.hli_table import (
    NO_SUCH_TRANSITION,
    PATH_HAS_NO_EFFECT,
    PATH_IS_STRUCTURE,
    PATH_NOT_SERVED,
    PATH_OF_NO_CHANNEL,
    PATH_READ_ONLY,
    UNIT_NOT_ENABLED,
)
from nctakt.messages.inputs import VALUE_NOT_OF_TYPE
from nctakt.run.inputs import Inputs
from nctakt.run.machine_names import SignalCell, prefix_of

#: Paths whose elements are kept; there are as many spellings of them as one likes.
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


class RunningMachine(Protocol):
    """What the interface needs of a machine (``AssembledMachine``)."""

    configuration: Machine
    cells: Any
    inputs: Inputs
    report: Callable[[Diagnostic], None]

    def signals(self) -> Mapping[str, SignalCell]:
        """Return the cells of all signals."""

    def read(self, name: str) -> Scalar:
        """Return a value by its name; a written one before it is latched."""

    def write(self, name: str, value: Scalar, source: str) -> None:
        """Write a value by its name."""


class _Found(NamedTuple):
    area: Area
    slot: Slot


class _Values(Mapping[str, Scalar]):
    """The values of the session as an area asks for them, from the cells of the machine."""

    def __init__(self, machine: RunningMachine) -> None:
        self._machine = machine
        self._signals = machine.signals()

    def __getitem__(self, name: str) -> Scalar:
        if "HLI." in name:
            return self._machine.read(name)  # what was written counts before it is latched
        cell, _, _ = self._signals[name]
        return float(self._machine.cells[cell])

    def __iter__(self) -> Iterator[str]:
        return iter(self._signals)

    def __len__(self) -> int:
        return len(self._signals)


class InterfaceAccess:
    """The interface of a machine by paths; one for all who play its PLC in Python."""

    def __init__(self, machine: RunningMachine, count: int) -> None:
        self._machine = machine
        prefixes = [prefix_of(index) if count > 1 else "" for index in range(count)]
        self._areas = areas(machine.configuration, prefixes)
        self._values = _Values(machine)
        self._found: dict[str, _Found] = {}
        self._reported: set[str] = set()
        for found in self._areas.values():
            for area in found:
                area.announce()

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
        """Return the present value of an element; raises ``Failure`` for what is none."""
        area, slot = self._find(path)
        is_asked = any(name.startswith(ASKED) for name in area.names(slot.offset, 1))
        if is_asked or area.hides(slot.offset, slot.type.size_bytes):
            raise Failure(diagnostic(PATH_NOT_SERVED, path=path))
        data = area.read(slot.offset, slot.type.size_bytes, self._values)
        value = slot.value_of(data)
        return value != 0 if slot.type.name == "BOOL" else value

    def put(self, path: str, value: Scalar, source: str) -> None:
        """Write an element, with effect from the next tick on.

        Raises ``Failure`` for a path that the CNC writes and for a wrong value. What has no effect
        is told once, as a note.
        """
        area, slot = self._find(path)
        if slot.element.by == "CNC":
            raise Failure(diagnostic(PATH_READ_ONLY, path=path))
        if any(name.startswith(ASKED) for name in area.needed(slot.offset, 1)):
            raise Failure(diagnostic(PATH_NOT_SERVED, path=path))
        type_ = slot.type.name
        if isinstance(value, str) != slot.type.is_text:
            raise Failure(diagnostic(VALUE_NOT_OF_TYPE, name=path, type=type_, value=value))
        if not isinstance(value, str):
            value = number_of(path, _TYPES[type_], float(value))
        try:
            written = area.write(slot.offset, slot.bytes_of(value), self._values)
        except NotWritable:
            raise Failure(diagnostic(NO_SUCH_TRANSITION, path=path)) from None
        self._let_act(written, source)

    def _let_act(self, written: Written, source: str) -> None:
        for channel, program in written.programs:
            self._machine.inputs.select(channel - 1, program, source)
        for name, value in written.values.items():
            self._machine.write(name, value, source)
        for path in self._new(written.known):
            self._machine.report(diagnostic(PATH_HAS_NO_EFFECT, path=path))
        for path in self._new(written.waiting):
            self._machine.report(diagnostic(UNIT_NOT_ENABLED, path=path))

    def _new(self, paths: Sequence[str]) -> Iterator[str]:
        """Yield the paths that have not been reported yet."""
        for path in paths:
            if path not in self._reported:
                self._reported.add(path)
                yield path
