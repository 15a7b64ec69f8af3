# SPDX-License-Identifier: MIT
"""M and H functions that go out before the path comes to them (P-CHAN-00041, P-CHAN-00070).

The place of such a function in the queue is where the path is synchronised with it. It goes out in
the first tick at whose start the distance or time up to there is no longer than its lead, as far
ahead as commands are queued, but not before the function preceding it in the program, unless there
is no distance between them.
"""

from __future__ import annotations

import math

from nctakt.kernel import codes, rows
from nctakt.kernel.base.record import Record
from nctakt.kernel.path import geometry
from nctakt.kernel.plc.technology_slots import Hli
from nctakt.kernel.tick.command_queue import CommandQueue


class EarlyOutputs:
    """Looks along the queue for functions that are due.

    ``travel_d``: mm from the path to the command; ``travel_t``: their time, at the feeds that are
    programmed, with the override. ``last_v``, ``last_a``, ``end_v``: speed, acceleration and
    planned end speed of the last segment up to there.
    """

    def __init__(self, queue: CommandQueue, hli: Hli, record: Record) -> None:
        self.queue = queue
        self.path = queue.path
        self.hli = hli
        self.record = record
        self.travel_d = 0.0
        self.travel_t = 0.0
        self.last_v = 0.0
        self.last_a = 0.0
        self.end_v = 0.0

    def put_out(self, tick: int) -> None:
        """Put out the functions due in this tick, in the order of the program."""
        if self.path.is_active and self.path.is_dwell:
            return
        self.begin_travel()
        is_open = 1
        closed_d = -1.0
        has_more = 0
        position = max(self.queue.head, self.queue.started + 1)
        while position < self.queue.tail:
            row = position % self.queue.capacity * self.queue.width
            kind = int(self.queue.rows[row + rows.KIND])
            if kind == rows.SEGMENT:
                length_d = geometry.total_length(self.queue.rows, row)
                self.go_on(self.queue.rows, row, length_d)
            elif kind == rows.TECHNOLOGY and self.queue.rows[row + rows.TECHNOLOGY_LEAD] > 0.0:
                has_more = 1
                if not (is_open or self.travel_d == closed_d):
                    return
                if not self.is_due(row) or not self.issue(tick, row):
                    is_open = 0
                    closed_d = self.travel_d
            elif not rows.is_transparent(kind) and kind != rows.AWAIT_ACKNOWLEDGE:
                is_open = 0
                closed_d = -1.0
            position += 1
        self.queue.has_early = has_more > 0

    def begin_travel(self) -> None:
        """Begin with the rest of the path's current segment."""
        self.travel_d = 0.0
        self.travel_t = 0.0
        self.last_v = 0.0
        self.last_a = 0.0
        self.end_v = 0.0
        if self.path.is_active:
            row = self.path.row
            rest_d = geometry.total_length(self.path.history_rows, row) - self.path.covered_d
            self.go_on(self.path.history_rows, row, max(0.0, rest_d))

    def go_on(self, segments: memoryview[float], row: int, length_d: float) -> None:
        """Add a segment, or the rest of it, to the distance."""
        factor = self.path.common_factor
        if segments[row + rows.IGNORES_OVERRIDE] > 0.0:
            factor = self.path.unoverridden_factor
        self.last_v = min(segments[row + rows.SPEED] * factor, segments[row + rows.MAX_SPEED])
        self.last_a = segments[row + rows.ACCELERATION]
        self.end_v = min(segments[row + rows.END_SPEED], self.last_v)
        self.travel_d += length_d
        self.travel_t += length_d / self.last_v if self.last_v > 0.0 else 1e30

    def is_due(self, row: int) -> int:
        """Return whether the lead of the function at ``row`` covers the distance up to it."""
        lead = self.queue.rows[row + rows.TECHNOLOGY_LEAD]
        kind = int(self.queue.rows[row + rows.TECHNOLOGY_LEAD_KIND])
        if kind == codes.LEAD_DISTANCE:
            return 1 if self.travel_d <= lead else 0
        end_v = 0.0 if kind == codes.LEAD_TIME_TO_REST else self.end_v
        return 1 if self.time_to(end_v) <= lead else 0

    def time_to(self, end_v: float) -> float:
        """Return the time of the distance, in s, with a ramp to ``end_v`` at its end."""
        change_v = self.last_v - end_v
        if change_v <= 0.0 or self.last_a <= 0.0:
            return self.travel_t
        ramp_d = change_v * (self.last_v + end_v) / (2.0 * self.last_a)
        if self.travel_d < ramp_d:
            start_v = math.sqrt(end_v * end_v + 2.0 * self.last_a * self.travel_d)
            return (start_v - end_v) / self.last_a
        return self.travel_t + change_v * change_v / (2.0 * self.last_a * self.last_v)

    def issue(self, tick: int, row: int) -> int:
        """Put a function out; return 0 if it has to wait.

        It waits for a free slot, and until the same function is acknowledged.
        """
        function = int(self.queue.rows[row + rows.TECHNOLOGY_FUNCTION])
        if self.hli.program.is_waiting(function):
            return 0
        if not self.issue_at_its_place(tick, row):
            return 0
        self.queue.rows[row + rows.TECHNOLOGY_LEAD] = codes.LEAD_IS_OVER
        return 1

    def issue_at_its_place(self, tick: int, row: int) -> int:
        """Put out the function at ``row`` unless it is; return 0 while no slot is free."""
        if self.queue.rows[row + rows.TECHNOLOGY_LEAD] == codes.LEAD_IS_OVER:
            return 1
        function = int(self.queue.rows[row + rows.TECHNOLOGY_FUNCTION])
        ticks = int(self.queue.rows[row + rows.TECHNOLOGY_TICKS])
        if self.hli.program.issue(function, tick, ticks) <= 0:
            return 0
        value = int(self.queue.rows[row + rows.TECHNOLOGY_VALUE])
        self.hli.program.give_value(value)
        has_value = self.queue.rows[row + rows.TECHNOLOGY_HAS_VALUE] != 0.0
        source = int(self.queue.rows[row + rows.SOURCE])
        self.record.event(rows.EVENT_TECHNOLOGY, source, has_value, function, value)
        return 1
