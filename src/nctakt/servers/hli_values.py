# SPDX-License-Identifier: MIT
"""The state of channels, axes and spindles by the names of the HLI, for endpoints that need it all.

In: a machine and its catalogue. Out: for each channel, axis and spindle the names of its values
(``hli/layout.py``) and where the session has them.
"""

from __future__ import annotations

from collections.abc import Mapping

from nctakt.base.dataclass import dataclass
from nctakt.hli.layout import AXIS, CHANNEL, LAMPS, PANEL, PREFIX
from nctakt.lists.machine.machine import Machine
from nctakt.run.access.machine_names import prefix_of
from nctakt.servers.catalogue import Catalogue

#: The values of a spindle that the CNC turns.
_SPINDLE = {"speed": "SPEED", "position": "POSITION"}


@dataclass(frozen=True, slots=True)
class Part:
    """A channel, an axis or a spindle: its kind, its name, its channel counted from 1.

    ``names``: the name of each value in the HLI -> that in the session. ``is_linear``: of an axis.
    ``is_known``: whether the CNC turns the spindle itself, so that it knows its values.
    """

    kind: str
    name: str
    channel: int
    names: Mapping[str, str]
    is_linear: bool = True
    is_known: bool = True

    @property
    def key(self) -> tuple[str, int, str]:
        """The key that distinguishes it from the other parts of its machine."""
        return self.kind, self.channel, self.name


def parts_of(machine: Machine, catalogue: Catalogue) -> list[Part]:
    """Return the channels, the axes and the spindles of a machine."""
    channels, axes, spindles = [], [], []
    linear = {axis.name: axis.is_linear for axis in machine.axes}
    for index, channel in enumerate(machine.channels):
        prefix = prefix_of(index) if len(machine.channels) > 1 else ""
        number = index + 1
        names = {entry.name: f"{prefix}{PREFIX}{entry.name.upper()}" for entry in (*LAMPS, *PANEL)}
        names |= {
            entry.name: f"{prefix}{entry.source}" for entry in CHANNEL.entries if entry.source
        }
        channels.append(Part("channel", str(number), number, names))
        for axis in channel.axes:
            own = {
                entry.name: f"{prefix}{axis.name}.{entry.source}"
                for entry in AXIS.entries
                if entry.source
            }
            if all(name in catalogue for name in own.values()):
                axes.append(
                    Part("axis", axis.name, number, own, is_linear=linear.get(axis.name, True))
                )
        for spindle in channel.parameters.spindles:
            own = {key: f"{prefix}{spindle.name}.{path}" for key, path in _SPINDLE.items()}
            is_known = not spindle.plc_controlled
            spindles.append(Part("spindle", spindle.name, number, own, is_known=is_known))
    return [*channels, *axes, *spindles]
