# SPDX-License-Identifier: MIT
"""Measuring within the blocks of a channel: edge joints (G108), touches of a probe (G100)."""

from __future__ import annotations

from nctakt.kernel import codes
from nctakt.kernel.base.record import Record
from nctakt.kernel.path.path import Path
from nctakt.kernel.path.probing.edge_probe import EdgeProbe
from nctakt.kernel.path.probing.fixed_stops import FixedStops
from nctakt.kernel.path.probing.touch_probe import TouchProbe
from nctakt.kernel.plc.technology_slots import Hli


class Measuring:
    """The probes of one channel; ``cell``: that of V.RTG.MEAS_DELTA."""

    def __init__(
        self,
        path: Path,
        hli: Hli,
        record: Record,
        memory: bytearray,
        cell: int,
        fixed_stops: FixedStops,
    ) -> None:
        self.path = path
        self.edge_probe = EdgeProbe(path, hli, record, memory, cell)
        self.touch_probe = TouchProbe(path, hli.panel, record, fixed_stops)

    def watch(self, tick: int) -> int:
        """Watch a tick before the path's increment; return 1 if the path has to brake."""
        if not self.path.is_active or self.path.is_retracing:
            return 0
        brakes = 0
        if self.edge_probe.phase != codes.NOT_MEASURING:
            brakes = self.edge_probe.watch(tick)
        if self.touch_probe.is_seeking or self.touch_probe.is_braking:
            brakes |= self.touch_probe.watch()
        return brakes

    def clear(self) -> None:
        """Stop measuring."""
        self.edge_probe.clear()
        self.touch_probe.clear()
