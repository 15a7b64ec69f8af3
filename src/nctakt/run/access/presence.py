# SPDX-License-Identifier: MIT
"""When a PLC that runs in the tick announced itself for the channels and axes (ST-763)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from nctakt.base.dataclass import dataclass
from nctakt.kernel.st.technology import UnitBanks


class Announced(NamedTuple):
    """The first tick at whose end a PLC was announced, and the element that announced it."""

    tick: int
    path: str


@dataclass(frozen=True, slots=True)
class Presence:
    """Areas for which a PLC in the tick may announce itself.

    ``areas``: the numbers of the areas by the root and index of their pointers.
    """

    banks: UnitBanks
    areas: Mapping[tuple[str, int], int]

    def announced(self, channel: int, axis: int) -> Announced | None:
        """Return when it announced itself for the functions of an axis, or of a channel (-1).

        ``None``: not yet. Without an area of the axis, that of the channel counts.
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
