# SPDX-License-Identifier: MIT
"""Variables by name, for the access from outside of programs: API, command line, scripted PLC.

In: names such as ``V.E.LIST[3]`` and values. Out: the present values, and writes that the next tick
latches (RC-002). Values are checked at once (RC-307); an invalid one is a ``Failure``.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import AbstractContextManager, nullcontext

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Text
from nctakt.base.failure import Failure
from nctakt.base.misspelling import nearest
from nctakt.hli.checked_values import (
    characters_of,
    command_number,
    number_of,
    split_channel,
)
from nctakt.hli.layout import PREFIX, PanelValue
from nctakt.kernel.kernel import Kernel
from nctakt.lists.declared.variables import SCALARS
from nctakt.lists.format import arguments
from nctakt.messages import diagnostic
from nctakt.messages.commands.inputs import (
    MISSPELLED_MACHINE_VARIABLE,
    UNKNOWN_MACHINE_VARIABLE,
    VALUE_NOT_OF_TYPE,
    VARIABLE_NOT_SETTABLE,
)
from nctakt.messages.machines.folders import UNKNOWN_CHANNEL
from nctakt.nc.vocabulary.variables import strings
from nctakt.nc.vocabulary.variables.cells import CELL_BYTES
from nctakt.nc.vocabulary.variables.variable_table import Location, NameTable, NotFound
from nctakt.run.access.bound_values import BoundValue, InputNotes
from nctakt.run.access.input_words import API, WRITE
from nctakt.run.access.named_values import (
    NO_SCOPES,
    InterfaceValues,
    NamedValues,
    SignalCell,
    scopes_text,
)
from nctakt.run.access.presence import Presence
from nctakt.run.access.zero_offset_access import is_zero_offset

#: Maximum number of names kept bound; they can be spelled in any number of ways.
_MAX_BOUND = 10_000


@dataclass(frozen=True, slots=True)
class Write:
    """A checked value for the cells from ``cell`` on."""

    cell: int
    value: float | bytes


class VariableAccess:
    """The variables of all channels, with the writes that wait for the next tick.

    ``CH2.V.E.X`` belongs to the second channel; a name without a channel to the first. ``panels``
    are the operator's values of each channel, ``remarks`` further diagnostics about an unknown
    name.
    """

    def __init__(
        self,
        names: Sequence[NameTable],
        panels: Sequence[Mapping[str, PanelValue]],
        memory: bytearray,
        kernel: Kernel,
        remarks: Sequence[Diagnostic] = (),
    ) -> None:
        self._names = names
        self._panels = panels
        self._kernel = kernel
        self._remarks = remarks
        self._bound_values: dict[str, BoundValue] = {}
        #: The variables of a PLC that runs in the tick, by their paths.
        self.named: NamedValues | None = None
        #: Those of them that are signals: their cells, units, and whether they are integers.
        self.named_signals: dict[str, SignalCell] = {}
        #: When PLCs in the tick announced themselves.
        self.presences: list[Presence] = []
        #: The interface by the controller's paths, when it is first used.
        self.interface: Callable[[], InterfaceValues] | None = None
        self.notes = InputNotes(kernel)

    def _find(self, name: str) -> tuple[Location, int]:
        prefix, number, path = split_channel(name)
        names = self._names[self._index(number)]
        location = names.resolve_text(path)
        if isinstance(location, NotFound):
            known = [other for other, _, _ in names.values()]
            element = next((other for other in known if other.startswith(f"{path}[")), "")
            near = location.nearest or element or nearest(path, known)
            meant = f"{prefix}{near}" if near else self._nearest_named(name)
            mistake = None if self.named is None else self.named.mistake(name)
            if mistake is not None:
                raise Failure(mistake)
            raise Failure(_unknown(name, meant, scopes_text(self.named)), *self._remarks)
        return location

    def _nearest_named(self, name: str) -> str:
        """Return the variable of a PLC that a name is meant for, else an empty text."""
        names = () if self.named is None else self.named.names(are_numbers=False)
        return nearest(name, (other for other in names if other != name))

    def _find_panel(self, name: str) -> PanelValue | None:
        """Return the operator's value of this name; ``None`` for a variable."""
        prefix, number, path = split_channel(name)
        upper = path.strip().upper()
        if not upper.startswith(PREFIX):
            return None
        panel = self._panels[self._index(number)]
        value = panel.get(upper)
        if value is None:
            near = nearest(upper, panel)
            raise Failure(_unknown(name, f"{prefix}{near}" if near else "", NO_SCOPES))
        return value

    def _index(self, number: int) -> int:
        if not 0 < number <= len(self._names):
            raise Failure(diagnostic(UNKNOWN_CHANNEL, channel=number, count=len(self._names)))
        return number - 1

    def cell_of(self, name: str) -> tuple[int, bool]:
        """Return the cell of a variable, and whether it is a text; raises ``Failure``."""
        location, cell = self._find(name)
        return cell, not location.is_numeric

    def bind(self, name: str) -> BoundValue:
        """Return the value of this name, for any number of reads and writes; raises ``Failure``."""
        bound = self._bound_values.get(arguments.text("name", name))
        if bound is None:
            bound = self._bind(name)
            if len(self._bound_values) < _MAX_BOUND:
                self._bound_values[name] = bound
        return bound

    def _bind(self, name: str) -> BoundValue:
        shown = self._find_panel(name)
        if shown is not None:
            cell, type_, tie = shown.cell, shown.entry.type, shown.entry.tie
            is_settable = shown.is_command and (tie is None or not tie.taken)
            lowest = SCALARS[type_].low if shown.entry.is_signed else max(0.0, SCALARS[type_].low)
        else:
            location, cell = self._find(name)
            type_, lowest = location.type, SCALARS[location.type].low
            is_settable = location.is_numeric and location.family not in ("RTG", "RTA")
        bounds = (lowest, SCALARS[type_].high) if is_settable else ()
        return BoundValue(self, self._kernel, self.notes, name, API, cell, type_, bounds)

    def read(self, name: str) -> float | bool | str:
        """Return the value of a variable; a written value is returned before it is latched."""
        if is_path(name) and self.interface is not None:
            return self.interface().read(name)
        if self.named is not None and self.named.knows(name):
            return self.named.read(name)
        return self.bind(name).value

    def text_of(self, name: str) -> str:
        """Return the text of a character string; a written text even before it is latched."""
        location, cell = self._find(name)
        cells = -(-location.size_bytes // CELL_BYTES)
        return strings.decode(self._kernel.posted.present_bytes(cell, cells)[: location.size_bytes])

    def draft(self, names: Iterable[str]) -> AbstractContextManager[None]:
        """Let the checks of values written together take each other into account."""
        if self.interface is None or not any(map(is_path, names)):
            return nullcontext()
        return self.interface().draft()

    def check(self, name: str, value: float | bool | str) -> None:
        """Raise ``Failure`` for an unknown name and for a value that it cannot hold."""
        if is_path(name) and self.interface is not None:
            self.interface().check(name, value)
        elif self.named is not None and self.named.knows(name):
            self.named.check(name, value)
        else:
            self.converted(name, value)

    def converted(self, name: str, value: float | bool | str) -> Write:
        """Return the converted value; raises ``Failure`` for an unknown name and a wrong value."""
        shown = self._find_panel(arguments.text("name", name))
        value = arguments.number_or_text(name, value)
        if shown is not None:
            return Write(shown.cell, command_number(shown.name, shown.entry, value))
        location, cell = self._find(name)
        if location.family in ("RTG", "RTA"):
            raise Failure(diagnostic(VARIABLE_NOT_SETTABLE, name=name))
        if isinstance(value, str) == location.is_numeric:
            raise Failure(diagnostic(VALUE_NOT_OF_TYPE, name=name, type=location.type, value=value))
        if isinstance(value, str):
            return Write(cell, _characters(name, location, value))
        return Write(cell, number_of(name, location.type, float(value)))

    def write(self, name: str, value: float | bool | str, source: str = API) -> None:
        """Write a variable with effect from the next tick."""
        if is_path(name) and self.interface is not None:
            self._write_path(self.interface(), name, value, source)
            return
        if self.named is not None and self.named.knows(name):
            self.named.write(name, value)
            noted = int(value) if isinstance(value, bool) else value
            self.notes.add(source, WRITE, name, noted)
            return
        self.bind(name).write(value, source)

    def _write_path(
        self, interface: InterfaceValues, name: str, value: float | bool | str, source: str
    ) -> None:
        """Write an element of the interface: it is the input, and not its consequences."""
        interface.check(name, value)
        self.notes.add(source, WRITE, name, value if isinstance(value, str) else float(value))
        is_listening, self.notes.is_listening = self.notes.is_listening, False
        try:
            interface.write(name, value, source)
        finally:
            self.notes.is_listening = is_listening

    def write_checked(self, name: str, value: float | bool | str) -> None:
        """Write a value that depends on its type; raises ``Failure`` as ``converted``."""
        write = self.converted(name, value)
        if isinstance(write.value, bytes):
            self._kernel.posted.post_bytes(write.cell, write.value)
        else:
            self._kernel.posted.post(write.cell, write.value)

    def apply_writes(self) -> None:
        """Apply the writes at once, before the first tick, so that the decoder sees them."""
        self._kernel.posted.latch()


def is_path(name: str) -> bool:
    """Return whether a name belongs to the interface: a pointer has a caret, or a zero offset."""
    return isinstance(name, str) and ("^" in name or ("[" in name and is_zero_offset(name)))


def _characters(name: str, location: Location, text: str) -> bytes:
    """Return the bytes of a text, filled up to the end of their last cell."""
    data = characters_of(name, location.type, location.size_bytes, text)
    return data.ljust(-(-len(data) // CELL_BYTES) * CELL_BYTES, b"\0")


def _unknown(name: str, near: str, scopes: Text) -> Diagnostic:
    """Return the diagnostic of an unknown name; ``near``: the nearest one, if any is."""
    if not near:
        return diagnostic(UNKNOWN_MACHINE_VARIABLE, name=name, plc=scopes)
    return diagnostic(MISSPELLED_MACHINE_VARIABLE, name=name, nearest=near)
