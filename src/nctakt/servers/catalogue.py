# SPDX-License-Identifier: MIT
"""The values of a machine by name: kind of each, and whether clients may write it.

In: ``MachineNames``. Out: ``Value`` for each signal, V.E and V.CH variable, value of the HLI, and
V.RTG and V.RTA variable of each channel. Names are found in any case of letters; ``CH2.V.E.X``
belongs to the second channel.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text
from nctakt.base.failure import Failure
from nctakt.base.misspelling import nearest
from nctakt.lists.declared.variables import SCALARS
from nctakt.messages import diagnostic
from nctakt.messages.commands.inputs import MISSPELLED_MACHINE_VARIABLE, UNKNOWN_MACHINE_VARIABLE
from nctakt.nc.vocabulary.variables.cells import leaf_cells
from nctakt.nc.vocabulary.variables.variable_table import NotFound
from nctakt.run.access.machine_names import MachineNames, prefix_of


@dataclass(frozen=True, slots=True)
class Value:
    """A value by its name in the session; ``type``: as in variables lists.

    ``channel``: number of its channel, from 1. ``size_bytes``: of a text, with its zero byte.
    """

    name: str
    type: str
    unit: str
    channel: int
    is_writable: bool
    size_bytes: int = 0

    @property
    def is_text(self) -> bool:
        """Whether it is a character string."""
        return not SCALARS[self.type].is_numeric


class Catalogue:
    """All values of a machine; ``values``: by the names that the session knows."""

    def __init__(self, names: MachineNames) -> None:
        self.names = names
        self.values: dict[str, Value] = {}
        count = len(names.layout.tables)
        for index in range(count):
            prefixes = ["", prefix_of(0)] if index == 0 else [prefix_of(index)]
            for value in self._of_channel(index):
                for prefix in prefixes[: 1 if count == 1 else None]:
                    name = f"{prefix}{value.name}"
                    self.values[name] = Value(
                        name,
                        value.type,
                        value.unit,
                        value.channel,
                        value.is_writable,
                        value.size_bytes,
                    )
        self._by_upper: Mapping[str, Value] = {
            name.upper(): value for name, value in self.values.items()
        }

    def _of_channel(self, index: int) -> Iterator[Value]:
        """Yield the values of a channel, counted from 0, by their names without it."""
        table, number = self.names.layout.tables[index], index + 1
        units = {name: row.unit for name, _, row in table.signals()}
        for name, _, row in table.signals():
            yield Value(name, row.type, row.unit, number, False)
        for panel in self.names.panels[index].values():
            entry = panel.entry
            yield Value(panel.name, entry.type, entry.unit, number, panel.is_command)
        for name, _ in table.realtime():
            found = table.resolve_text(name)
            assert not isinstance(found, NotFound)
            yield Value(name, found[0].type, units.get(_signal_of(name), ""), number, False)
        channel = self.names.configuration.channels[index]
        for family, variables in (
            ("E", channel.external_variables),
            ("CH", channel.channel_variables),
        ):
            for variable in variables:
                node = variable.node
                for path, leaf, _ in leaf_cells(node, f"V.{family}.{variable.name}", 0):
                    size = 0 if SCALARS[leaf.type].is_numeric else leaf.size_bytes
                    yield Value(path, leaf.type, "", number, True, size)

    def find(self, name: str) -> Value:
        """Return the value of this name, in any case; raises ``Failure`` for an unknown one."""
        found = self._by_upper.get(name.upper())
        if found is not None:
            return found
        near = nearest(name, self.values)
        raise Failure(
            diagnostic(MISSPELLED_MACHINE_VARIABLE, name=name, nearest=near)
            if near
            else diagnostic(UNKNOWN_MACHINE_VARIABLE, name=name, plc=Text("", ""))
        )

    def __contains__(self, name: str) -> bool:
        return name.upper() in self._by_upper


def _signal_of(name: str) -> str:
    """Return the signal that a variable shows: ``X.ACS.ACT_POS`` for ``V.RTA.ACS.ACT_POS.X``."""
    family, path = name.split(".", 2)[1:]
    if family == "RTG":
        return path
    path, _, axis = path.rpartition(".")
    return f"{axis}.{path}"
