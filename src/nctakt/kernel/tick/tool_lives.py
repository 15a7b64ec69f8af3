# SPDX-License-Identifier: MIT
"""Tool lives of one channel: commands of the program, and reports to the PLC."""

from __future__ import annotations

from nctakt.kernel import codes, rows
from nctakt.kernel.base.record import Record
from nctakt.kernel.plc.panel import Panel
from nctakt.kernel.tick.command_queue import CommandQueue


class ToolLifeReporter:
    """Sends the tool lives that ``life`` has counted, as an event and by lamps of the panel."""

    def __init__(self, queue: CommandQueue, panel: Panel, record: Record) -> None:
        self.queue = queue
        self.life = queue.path.life
        self.panel = panel
        self.record = record
        self.sent = 0
        self.omits_zero = False

    def omit_zero(self, omits_zero: bool) -> None:
        """Send no tool life of 0 s and 0 mm (P-CHAN-00243), or any."""
        self.omits_zero = omits_zero

    def end_tick(self) -> None:
        """Show how much the tool has worked up to the end of a tick."""
        if self.life.has_moved:
            self.life.end_tick()
            self.panel.show_life(self.life.time_t, self.life.distance_d)

    def execute(self, row: int) -> None:
        """Carry out a command: another tool, ``#TOOL LIFE``, or other factors (V.TLM)."""
        action = int(self.queue.rows[row + rows.LIFE_ACTION])
        tool = int(self.queue.rows[row + rows.LIFE_TOOL])
        basic = int(self.queue.rows[row + rows.LIFE_BASIC])
        time = self.queue.rows[row + rows.LIFE_TIME]
        distance = self.queue.rows[row + rows.LIFE_DISTANCE]
        is_ahead = 1 if self.queue.started >= self.queue.head else 0
        before_d = self.life.before(is_ahead)
        if action == codes.LIFE_FACTORS:
            self.life.weigh(time, distance, is_ahead)
        elif action == codes.LIFE_READ:
            self.send(row, tool, basic, before_d)
        elif action == codes.LIFE_DEFINED:
            time_t = time if time >= 0.0 else self.life.time_t
            self.life.go_on(time_t, distance if distance >= 0.0 else before_d, is_ahead)
        else:
            if action == codes.LIFE_SENT:
                self.send(row, self.life.tool, self.life.basic, before_d)
            self.life.go_on(0.0, 0.0, is_ahead)
        if action in (codes.LIFE_SENT, codes.LIFE_BEGUN):
            self.life.tool = tool
            self.life.basic = basic
        self.panel.show_life(self.life.time_t, self.life.distance_d)

    def send(self, row: int, tool: int, basic: int, distance_d: float) -> None:
        """Report the tool life of a tool to the PLC: that of the path, or another."""
        time_t = self.life.time_t
        if self.omits_zero and time_t == 0.0 and distance_d == 0.0:
            return
        self.sent += 1
        source = int(self.queue.rows[row + rows.SOURCE])
        self.record.event(rows.EVENT_TOOL_LIFE, source, tool, basic, time_t, distance_d)
        self.panel.send_life(self.sent, basic, time_t, distance_d)
