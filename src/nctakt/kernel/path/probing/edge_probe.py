# SPDX-License-Identifier: MIT
"""Measuring the edge joint within a block (G108): where a strip begins, and where it is cut.

The block is armed. The probe of the HLI reports that it has found the edge: from there the path
continues by a residual path, brakes to a standstill, outputs the block's function, and continues to
the end of the block once the PLC has acknowledged it. V.RTG.MEAS_DELTA is the distance from there
to the end of the block.
"""

from __future__ import annotations

from nctakt.kernel import codes, rows
from nctakt.kernel.base.bounds import check_cells
from nctakt.kernel.base.record import Record
from nctakt.kernel.path.path import Path
from nctakt.kernel.plc.technology_slots import Hli


class EdgeProbe:
    """Measuring of the edge joint in one channel (G108).

    ``phase``: ``codes.NOT_MEASURING`` … ``cell`` is that of V.RTG.MEAS_DELTA.
    """

    def __init__(self, path: Path, hli: Hli, record: Record, memory: bytearray, cell: int) -> None:
        check_cells(cell, 1, memory)
        self.path = path
        self.hli = hli
        self.record = record
        self.cells = memoryview(memory).cast("d")
        self.cell = cell
        self.phase = codes.NOT_MEASURING
        self.source = 0
        self.function = 0
        self.ticks = 0
        self.has_value = False
        self.value = 0
        self.residual_d = 0.0
        self.joint_d = 0.0

    def arm(self, source: int, queue: memoryview[float], row: int) -> None:
        """Measure in the next block as the command at ``row`` says."""
        self.phase = codes.SEEKS_EDGE
        self.source = source
        self.function = int(queue[row + rows.MEASURE_FUNCTION])
        self.ticks = int(queue[row + rows.MEASURE_TICKS])
        self.residual_d = queue[row + rows.MEASURE_RESIDUAL]
        self.has_value = queue[row + rows.MEASURE_HAS_VALUE] != 0.0
        self.value = int(queue[row + rows.MEASURE_VALUE])

    def clear(self) -> None:
        """Stop measuring."""
        self.phase = codes.NOT_MEASURING

    def watch(self, tick: int) -> int:
        """Watch a tick before the path's increment; return 1 if the path has to brake."""
        if self.phase == codes.SEEKS_EDGE and self.hli.panel.probe:
            self.joint_d = self.path.covered_length() + self.residual_d
            self.cells[self.cell] = self.path.distance_to_go() - self.residual_d
            self.record.event(rows.EVENT_PROBED, self.source, 0, self.cells[self.cell])
            self.phase = codes.FOUND_EDGE
        rest_d = self.joint_d - self.path.covered_length()
        if self.phase == codes.FOUND_EDGE and self.path.braking_distance() >= rest_d:
            self.phase = codes.BRAKES_FOR_JOINT
        if self.phase == codes.BRAKES_FOR_JOINT and self.path.speed_v == 0.0:
            self.put_out(tick)
        if self.phase == codes.AWAITS_FUNCTION and not self.hli.program.is_waiting(self.function):
            self.phase = codes.NOT_MEASURING
        return 1 if self.phase in (codes.BRAKES_FOR_JOINT, codes.AWAITS_FUNCTION) else 0

    def put_out(self, tick: int) -> None:
        """Issue the function to the PLC as soon as a slot is free."""
        if self.hli.program.issue(self.function, tick, self.ticks) > 0:
            self.hli.program.give_value(self.value)
            self.record.event(
                rows.EVENT_TECHNOLOGY, self.source, self.has_value, self.function, self.value
            )
            self.phase = codes.AWAITS_FUNCTION

    def finish(self, tick: int) -> int:
        """Finish the block: 1 done, 0 the function still waits, -1 no edge was found."""
        if self.phase == codes.SEEKS_EDGE:
            self.phase = codes.NOT_MEASURING
            return -1
        if self.phase in (codes.FOUND_EDGE, codes.BRAKES_FOR_JOINT):
            self.put_out(tick)
        if self.phase == codes.AWAITS_FUNCTION and not self.hli.program.is_waiting(self.function):
            self.phase = codes.NOT_MEASURING
        return 1 if self.phase == codes.NOT_MEASURING else 0
