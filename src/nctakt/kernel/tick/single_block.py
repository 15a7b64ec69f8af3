# SPDX-License-Identifier: MIT
"""Before which commands of a channel's queue single block stops (MO-6, P-CHAN-00015)."""

from __future__ import annotations

from nctakt.kernel import rows
from nctakt.kernel.base import arithmetic
from nctakt.kernel.plc.panel import Panel
from nctakt.kernel.tick.command_queue import CommandQueue


class SingleBlock:
    """Single block of one channel; ``only_motions``: it stops before lines that move."""

    def __init__(self, queue: CommandQueue, panel: Panel) -> None:
        self.queue = queue
        self.path = queue.path
        self.panel = panel
        self.only_motions = False

    def stop_at_motions(self, only_motions: bool) -> None:
        """Let single block stop at all blocks (P-CHAN-00015: 0, 1), or at motions alone (-1)."""
        self.only_motions = only_motions

    def execute(self, row: int) -> None:
        """Have no effect from here on, or again, or stop at other numbers (``#SINGLE STEP``)."""
        resolution = int(self.queue.rows[row + rows.STEP_RESOLUTION])
        if resolution < 0:
            self.panel.lock_step(self.queue.rows[row + rows.STEP_IS_LOCKED] != 0.0)
        else:
            self.panel.step_resolution = resolution

    def permits(self) -> int:
        """Return whether the command at the head of the queue may be taken.

        Commands that only mark their line wait with the first command that does something; at a
        line without one there is no stop.
        """
        head = self.queue.head
        if self.path.continues_block() or not self.is_block(head):
            return 1
        is_started = head <= self.queue.started or self.path.speed_v > 0.0
        row = head % self.queue.capacity * self.queue.width
        kind = int(self.queue.rows[row + rows.KIND])
        if self.is_mark(kind):
            return 1 - self.panel.holds_back(self.line(row), self.leads_to_motion(head), is_started)
        return self.panel.permits_block(self.line(row), self.is_motion(kind), is_started)

    def stops_ahead(self) -> int:
        """Return whether the path stops after its block, not being allowed into the next one."""
        if self.panel.step_resolution == 0:
            return 1
        continues = self.path.continues_block()
        number = max(self.queue.head, self.queue.started + 1)
        while number < self.queue.tail:
            row = number % self.queue.capacity * self.queue.width
            if self.queue.rows[row + rows.KIND] == rows.SEGMENT:
                if not continues:
                    return self.is_block(number)
                continues = self.queue.rows[row + rows.CONTINUES] > 0.0
            elif self.line(row) != self.panel.block_line and self.is_block(number):
                return 1
            number += 1
        return 1

    def is_block(self, number: int) -> int:
        """Return whether single block stops at the line of the command with this number."""
        row = number % self.queue.capacity * self.queue.width
        if self.panel.step_resolution > 0:
            block = self.queue.rows[row + rows.BLOCK_NUMBER]
            if block == 0.0 or arithmetic.modulo(block, self.panel.step_resolution) != 0.0:
                return 0
        line = self.line(row)
        while number < self.queue.tail:
            row = number % self.queue.capacity * self.queue.width
            if self.line(row) != line:
                return 0
            kind = int(self.queue.rows[row + rows.KIND])
            if kind == rows.SEGMENT or not (self.only_motions or self.is_mark(kind)):
                return 1
            number += 1
        return 0

    def leads_to_motion(self, number: int) -> bool:
        """Return whether the first command after the marks, which exists, moves or dwells."""
        while True:
            row = number % self.queue.capacity * self.queue.width
            kind = int(self.queue.rows[row + rows.KIND])
            if not self.is_mark(kind):
                return self.is_motion(kind)
            number += 1

    def line(self, row: int) -> int:
        """Return the line of a command and its file: a number (``base/source_ids.py``)."""
        source = int(self.queue.rows[row + rows.SOURCE])
        return source >> 20

    def is_mark(self, kind: int) -> bool:
        """Return whether commands of this kind only mark their line."""
        return kind in (rows.BLOCK_MARK, rows.WAIT_MARK, rows.MODAL_MARK)

    def is_motion(self, kind: int) -> bool:
        """Return whether commands of this kind move the path or let it dwell."""
        return kind in (rows.SEGMENT, rows.DWELL)
