# SPDX-License-Identifier: MIT
"""Which block realtime cycles with scope BLOCK belong to (RC-105).

It is the next block of the program that takes at least one tick: by a motion, by a dwell, or
because something in it has to wait. A wait and a motion on one line are one block. Blocks that take
no tick are passed over, with a notice for each.
"""

from __future__ import annotations

from nctakt.kernel import codes, rows
from nctakt.kernel.base.record import Record
from nctakt.kernel.cycles.cycles import CycleManager
from nctakt.kernel.tick.command_queue import CommandQueue


class BlockScope:
    """The block that BLOCK cycles run in, as a place in the queue and a line of the program.

    ``lingers``: the path is not in it, but a command at the head of the queue waits, or has waited.
    """

    def __init__(self, manager: CycleManager, record: Record) -> None:
        self.manager = manager
        self.record = record
        self.serial = 0
        self.position = -1
        self.source = 0
        self.has_moved = False
        self.lingers = False
        self.passed_source = 0

    def leave(self, commands: CommandQueue) -> None:
        """End the cycles whose block is over: neither the path nor the next command is in it."""
        self.lingers = False
        if self.manager.in_block_count == 0:
            return
        serial = commands.path.block_serial()
        if serial == 0 and self.holds_next(commands):
            self.lingers = True
            serial = self.serial
        self.manager.leave_blocks(serial)

    def holds_next(self, commands: CommandQueue) -> int:
        """Return whether the command at the head of the queue belongs to the block.

        On its line, a second motion, or the command with which it began, begins the next one.
        """
        if commands.head >= commands.tail:
            return 0
        row = commands.head_row()
        source = int(commands.rows[row + rows.SOURCE])
        if source >> 20 != self.source >> 20:
            return 0
        if commands.head == self.position:
            return 1
        kind = int(commands.rows[row + rows.KIND])
        if kind in (rows.SEGMENT, rows.DWELL):
            return 0 if self.has_moved else 1
        return 0 if source == self.source else 1

    def wait(self, commands: CommandQueue) -> None:
        """The command at the head of the queue waits: its block is that of armed cycles."""
        if self.manager.armed_count == 0:
            return
        row = commands.head_row()
        if self.is_wait(int(commands.rows[row + rows.KIND])):
            self.enter(commands, row, codes.WAITING_BLOCK)
            self.has_moved = False
            self.lingers = True

    def is_wait(self, kind: int) -> int:
        """Return whether a command that waits is part of a block.

        Commands that manage cycles, the program's end and position requests are not.
        """
        if kind in (rows.TECHNOLOGY, rows.AWAIT_ACKNOWLEDGE, rows.MEASURE_END):
            return 1
        return 1 if kind in (rows.SPINDLE, rows.AWAIT_SPINDLE, rows.FLUSH, rows.READ) else 0

    def move(self, commands: CommandQueue, row: int, serial: int) -> None:
        """Note a motion or dwell, with its ``serial`` on the path or ``codes.BLOCK_IS_OVER``."""
        if self.lingers:
            self.manager.change_block(codes.WAITING_BLOCK, serial)
            self.serial = serial
        elif self.manager.armed_count > 0:
            self.enter(commands, row, serial)
        self.has_moved = True
        self.lingers = False

    def enter(self, commands: CommandQueue, row: int, serial: int) -> None:
        """Let armed cycles run in this block from now on."""
        self.position = commands.head
        self.source = int(commands.rows[row + rows.SOURCE])
        self.serial = serial
        self.report_passed(self.source)
        self.manager.enter_block(serial)

    def pass_over(self, kind: int, source: int) -> None:
        """Note a command that takes no time; report its block once that has ended, too."""
        if self.manager.armed_count == 0:
            self.passed_source = 0
        elif self.is_content(kind):
            self.report_passed(source)
            self.passed_source = source

    def report_passed(self, source: int) -> None:
        """Report that the block passed over last has ended, unless ``source`` is in it (901049)."""
        if self.passed_source != 0 and self.passed_source >> 20 != source >> 20:
            self.record.event(rows.EVENT_NOTICE, self.passed_source, 0, 901049)
        self.passed_source = 0

    def is_content(self, kind: int) -> int:
        """Return whether a command that takes no time belongs to a block of the program."""
        if kind in (rows.TECHNOLOGY, rows.SPINDLE, rows.TIMER, rows.MESSAGE, rows.USER_ERROR):
            return 1
        if kind in (rows.WRITE_VARIABLE, rows.WRITE_TEXT, rows.EMPTY_BLOCK):
            return 1
        if kind == rows.SET_TRANSFORMATION:
            return 1
        return 1 if kind in (rows.SET_OFFSET, rows.SET_ORIGIN, rows.SET_TURN) else 0
