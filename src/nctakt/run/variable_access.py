# SPDX-License-Identifier: MIT
"""Variables by name, for the access from outside of programs: API, command line, scripted PLC.

In: names such as ``V.E.LIST[3]`` and values. Out: the present values, and writes that the next tick
latches (RC-002). Values are checked at once (RC-307); an invalid one is a ``Failure``.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic
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
from nctakt.lists.format import arguments
from nctakt.messages import diagnostic
from nctakt.messages.folders import UNKNOWN_CHANNEL
from nctakt.messages.inputs import (
    MISSPELLED_MACHINE_VARIABLE,
    UNKNOWN_MACHINE_VARIABLE,
    VALUE_NOT_OF_TYPE,
    VARIABLE_NOT_SETTABLE,
)
from nctakt.nc.vocabulary import strings
from nctakt.nc.vocabulary.cells import CELL_BYTES
from nctakt.nc.vocabulary.variable_table import Location, NameTable, NotFound


@dataclass(frozen=True, slots=True)
class Write:
    """A checked value for the cells from ``cell`` on."""

    cell: int
    value: float | bytes


class VariableAccess:
    """The variables of all channels, with the writes that wait for the next tick.

    ``CH2.V.E.X`` is that of the second channel; a name without a channel is one of the first.
    ``panels`` are the operator's values of each channel, ``remarks`` further diagnostics about an
    unknown name.
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
        self._bytes = memoryview(memory)
        self._cells = self._bytes.cast("d")
        self._kernel = kernel
        self._remarks = remarks
        self._pending: dict[int, float | bytes] = {}

    def _find(self, name: str) -> tuple[Location, int]:
        prefix, number, path = split_channel(name)
        names = self._names[self._index(number)]
        location = names.resolve_text(path)
        if isinstance(location, NotFound):
            near = location.nearest or nearest(path, (other for other, _, _ in names.values()))
            raise Failure(_unknown(name, prefix, near), *self._remarks)
        return location

    def _find_panel(self, name: str) -> PanelValue | None:
        """Return the operator's value of this name; ``None`` for a variable."""
        prefix, number, path = split_channel(name)
        upper = path.strip().upper()
        if not upper.startswith(PREFIX):
            return None
        panel = self._panels[self._index(number)]
        value = panel.get(upper)
        if value is None:
            raise Failure(_unknown(name, prefix, nearest(upper, panel)))
        return value

    def _index(self, number: int) -> int:
        if not 0 < number <= len(self._names):
            raise Failure(diagnostic(UNKNOWN_CHANNEL, channel=number, count=len(self._names)))
        return number - 1

    def cell_of(self, name: str) -> tuple[int, bool]:
        """Return the cell of a variable, and whether it is a text; raises ``Failure``."""
        location, cell = self._find(name)
        return cell, not location.is_numeric

    def read(self, name: str) -> float | bool | str:
        """Return the value of a variable; a written value is returned before it is latched."""
        shown = self._find_panel(arguments.text("name", name))
        if shown is not None:
            value = self._pending.get(shown.cell, self._cells[shown.cell])
            assert isinstance(value, float)
            return value != 0.0 if shown.entry.type == "BOOLEAN" else value
        location, cell = self._find(name)
        pending = self._pending.get(cell)
        if not location.is_numeric:
            if isinstance(pending, bytes):
                return strings.decode(pending)
            return strings.read(self._bytes, cell, location.size_bytes)
        value = pending if isinstance(pending, float) else self._cells[cell]
        return value != 0.0 if location.type == "BOOLEAN" else value

    def check(self, name: str, value: float | bool | str) -> Write:
        """Return the converted value; raises ``Failure`` for an unknown name and a wrong value."""
        shown = self._find_panel(arguments.text("name", name))
        arguments.number_or_text(name, value)
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

    def write(self, name: str, value: float | bool | str) -> None:
        """Write a variable with effect from the next tick."""
        write = self.check(name, value)
        self._pending[write.cell] = write.value

    def post_writes(self) -> None:
        """Post the writes for the next tick to latch."""
        for cell, value in self._pending.items():
            if isinstance(value, bytes):
                self._kernel.post_bytes(cell, value)
            else:
                self._kernel.post(cell, value)
        self._pending.clear()

    def apply_writes(self) -> None:
        """Apply the writes at once, before the first tick, so that the decoder sees them."""
        for cell, value in self._pending.items():
            if isinstance(value, bytes):
                strings.write(self._bytes, cell, value)
            else:
                self._cells[cell] = value
        self._pending.clear()


def _characters(name: str, location: Location, text: str) -> bytes:
    """Return the bytes of a text, filled up to the end of their last cell."""
    data = characters_of(name, location.type, location.size_bytes, text)
    return data.ljust(-(-len(data) // CELL_BYTES) * CELL_BYTES, b"\0")


def _unknown(name: str, prefix: str, near: str) -> Diagnostic:
    """Return the diagnostic of an unknown name; ``near``: the nearest one, without ``prefix``."""
    if not near:
        return diagnostic(UNKNOWN_MACHINE_VARIABLE, name=name)
    return diagnostic(MISSPELLED_MACHINE_VARIABLE, name=name, nearest=f"{prefix}{near}")
