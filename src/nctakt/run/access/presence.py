# SPDX-License-Identifier: MIT
"""When a PLC that runs in the tick announced itself for the channels and axes (ST-763)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from nctakt.base.dataclass import dataclass
from nctakt.kernel.st.technology import UnitBanks


class Announced(NamedTuple):
    """The tick whose end a PLC was there at first, and the element that says so."""

    tick: int
    path: str


@dataclass(frozen=True, slots=True)
class Presence:
    """What a PLC in the tick may announce itself for.

    ``areas``: the numbers of the areas by the root and index of their pointers.
    """

    banks: UnitBanks
    areas: Mapping[tuple[str, int], int]

    def announced(self, channel: int, axis: int) -> Announced | None:
        """Return when it announced itself for the functions of an axis, or of a channel (-1).

        ``None``: it has not yet. Without an area of the axis they are in that of the channel.
        """
        area = self.areas.get(self._pointer(channel, axis))
        if area is None or self.banks.since[area] < -1:
            return None
        return Announced(self.banks.since[area], self.path(channel, axis))

    def path(self, channel: int, axis: int) -> str:
        """Return the element by which it announces itself for these functions, empty: none."""
        root, index = self._pointer(channel, axis)
        return f"{root}[{index}]^.head.plc_present_w" if (root, index) in self.areas else ""

    def _pointer(self, channel: int, axis: int) -> tuple[str, int]:
        return ("gpAx", axis) if ("gpAx", axis) in self.areas else ("gpCh", channel)
