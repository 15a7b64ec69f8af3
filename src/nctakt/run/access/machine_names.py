# SPDX-License-Identifier: MIT
"""The names of a machine: its variables, signals and operator's values, and their cells.

In: ``Machine``. Out: ``MachineNames``, computed once for a loaded machine, however many controllers
use it. The contents of the cells belong to each controller alone.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from nctakt.decoder.blocks.axes.spindles import names_of
from nctakt.hli.layout import PANEL_CELLS, PanelValue, panel_values, spindle_values
from nctakt.lists.declared.variables import SCALARS
from nctakt.lists.machine.axes_by_number import c_axes, path_axes
from nctakt.lists.machine.machine import ChannelConfiguration, Machine
from nctakt.nc.vocabulary.variables.variable_table import ChannelNames, Layout, NameTable
from nctakt.run.access.named_values import SignalCell

#: Machines whose names are kept.
_KEPT = 8


class MachineNames:
    """Names and cells; ``panels``: the operator's values of each channel by name."""

    def __init__(self, configuration: Machine) -> None:
        self.configuration = configuration
        axes = list(enumerate(configuration.axes))
        linear = frozenset(i for i, axis in axes if axis.is_linear)
        modulo = frozenset(i for i, axis in axes if axis.is_modulo)
        single = frozenset(i for i, axis in axes if axis.enable_single_axis)
        ranges = {i: axis.reachable for i, axis in axes}
        self.layout = Layout(
            [
                ChannelNames(
                    tuple((axis.name, axis.index) for axis in channel.axes),
                    linear,
                    channel.external_variables,
                    channel.channel_variables,
                    names_of(channel.parameters.spindles),
                    modulo,
                    single,
                    ranges,
                    _fetched(configuration),
                    channel.parameters.spindle_names,
                    channel.ignored_variables,
                )
                for channel in configuration.channels
            ],
            len(configuration.axes),
            PANEL_CELLS,
        )
        self.panels: tuple[Mapping[str, PanelValue], ...] = tuple(
            {
                value.name: value
                for value in (
                    *panel_values(self.layout.panel_cell(index)),
                    *spindle_values(self.layout.spindles[index], self.layout.spindle_cell(index)),
                )
            }
            for index in range(len(configuration.channels))
        )
        self._signals: dict[str, SignalCell] = {}
        self._cell_names: dict[int, str] = {}

    def signals(self) -> Mapping[str, SignalCell]:
        """Return all signals; ``CH2.BLOCK`` belongs to the second channel."""
        if not self._signals:
            channels = [
                _signals_of(*own) for own in zip(self.layout.tables, self.panels, strict=True)
            ]
            self._signals.update(channels[0])
            for number, channel in enumerate(channels, 1):
                self._signals.update(
                    (f"{prefix_of(number - 1)}{name}", signal) for name, signal in channel.items()
                )
        return self._signals

    def name_of_cell(self, cell: int) -> str:
        """Return the name of a cell; of a shared cell, in the first channel that has it."""
        if not self._cell_names:
            for names, panel in reversed(list(zip(self.layout.tables, self.panels, strict=True))):
                self._cell_names.update((index, name) for name, index, _ in names.values())
                self._cell_names.update((index, name) for name, index in names.realtime())
                self._cell_names.update((value.cell, value.name) for value in panel.values())
        return self._cell_names[cell]


def _fetched(configuration: Machine) -> dict[int, int]:
    """Return the axes that a channel can have by their logical numbers."""
    return {**path_axes(configuration), **c_axes(configuration)}


def prefix_of(index: int) -> str:
    """Return the prefix of a channel's names on a machine with several, from index 0: ``CH1.``."""
    return f"CH{index + 1}."


def _signals_of(names: NameTable, panel: Mapping[str, PanelValue]) -> dict[str, SignalCell]:
    """Return the signals of a channel."""
    signals = {name: _signal(cell, row.unit, row.type) for name, cell, row in names.signals()}
    for name, cell, type_ in names.values():
        if SCALARS[type_].is_numeric:
            signals[name] = _signal(cell, "", type_)
    for value in panel.values():
        entry = value.entry
        signals[value.name] = _signal(value.cell, entry.unit, entry.type)
    return signals


def _signal(cell: int, unit: str, type_: str) -> SignalCell:
    """Return where a signal of a type is."""
    return SignalCell(cell, unit, type_ != "REAL64", is_boolean=type_ == "BOOLEAN")


_names: list[MachineNames] = []


def names_of_machine(configuration: Machine) -> MachineNames:
    """Return the names of a machine, which is immutable."""
    for names in _names:
        if names.configuration is configuration:
            return names
    names = MachineNames(configuration)
    _names.append(names)
    del _names[:-_KEPT]
    return names


def channel_names(
    configuration: Machine, names: MachineNames
) -> Iterator[tuple[ChannelConfiguration, NameTable, Mapping[str, PanelValue]]]:
    """Yield each channel with its variables and its operator's values."""
    return zip(configuration.channels, names.layout.tables, names.panels, strict=True)
