# SPDX-License-Identifier: MIT
"""Reasons that hold up the program of a channel, for ``run/causes/wait_reasons.py``."""

from __future__ import annotations

from nctakt.kernel import rows
from nctakt.kernel.path.override import Overrides
from nctakt.kernel.tick.axis_exchange import AxisExchange
from nctakt.kernel.tick.command_execution import CommandExecutor


class WaitReasons:
    """The reasons of one channel, and of which it has warned: each standstill once."""

    def __init__(
        self, executor: CommandExecutor, overrides: Overrides, exchange: AxisExchange
    ) -> None:
        self.executor = executor
        self.exchange = exchange
        self.queue = executor.queue
        self.path = executor.path
        self.overrides = overrides
        self.has_warned_of_wait = False
        self.has_warned_of_spindle = False

    def reason(self) -> tuple[str, int, int]:
        """Word, source and detail of the reason that holds up the program.

        The word is empty where nothing does: the path moves, or a dwell lasts.
        """
        row = self.queue.head % self.queue.capacity * self.queue.width
        queued = (
            int(self.queue.rows[row + rows.SOURCE])
            if self.queue.head < self.queue.tail
            else self.executor.taken_source
        )
        if self.executor.is_stopped or self.executor.is_resetting:
            return ("reset" if self.executor.is_stopped else "", queued, 0)
        if not self.executor.panel.is_running:
            return ("program start" if self.executor.panel.is_armed else "", 0, 0)
        if self.path.speed_v != 0.0:
            return ("", queued, 0)
        if self.executor.panel.backward_motion and self.path.history_size > 0:
            return ("forward", queued, 0)
        if self.executor.panel.is_paused:
            before = (self.queue.head - 1) % self.queue.capacity * self.queue.width
            kind, source = (
                self.queue.rows[before + rows.KIND],
                self.queue.rows[before + rows.SOURCE],
            )
            is_programmed = self.queue.head > 0 and kind == rows.PROGRAM_STOP
            is_programmed = is_programmed and int(source) == self.executor.taken_source
            return (
                "programmed stop" if is_programmed else "single block",
                self.executor.taken_source,
                0,
            )
        if self.path.is_active:
            word, detail = self._of_path()
            return (word, int(self.path.history_rows[self.path.row + rows.SOURCE]), detail)
        signals = self.executor.signals
        if self.queue.head == self.queue.tail and signals.is_decoder_waiting:
            return ("signal", signals.awaited_source, 0)
        if self.exchange.is_waiting:
            missing = self.exchange.missing()
            return ("exchange" if missing else "", self.exchange.source, 0)
        if self.queue.head == self.queue.tail:
            return ("condition" if signals.awaits_tick else "", signals.awaited_source, 0)
        word, detail = self._of_command(row)
        return (word, queued, detail)

    def _of_path(self) -> tuple[str, int]:
        """Word and detail of the reason that holds up the current block of a path at rest."""
        if self.executor.panel.feed_hold:
            return ("feed hold", 0)
        locked = self.path.locked_axis() if self.path.axes.locked_count > 0 else -1
        if locked >= 0:
            return ("release", locked)
        if self.path.is_dwell:
            return ("", 0)
        ignores_override = self.path.history_rows[self.path.row + rows.IGNORES_OVERRIDE] != 0.0
        if self.executor.panel.override_pct == 0.0 and not ignores_override:
            return ("override", 0)
        if self.overrides.cycle_pct == 0.0:
            return ("cycle override", 0)
        spindle = self.resting_spindle()
        return (
            ("spindle turns", self.executor.context.spindles.first_number + spindle - 1)
            if spindle
            else ("", 0)
        )

    def _of_command(self, row: int) -> tuple[str, int]:
        """Word and detail of the reason that holds up the command at the head of the queue."""
        kind = int(self.queue.rows[row + rows.KIND])
        if kind == rows.TECHNOLOGY:
            return ("free place", int(self.queue.rows[row + rows.TECHNOLOGY_FUNCTION]))
        if kind == rows.AWAIT_ACKNOWLEDGE:
            return ("acknowledgement", int(self.queue.rows[row + rows.AWAITED_FUNCTION]))
        if kind in (rows.SPINDLE, rows.AWAIT_SPINDLE):
            spindle = int(self.queue.rows[row + rows.JOB_SPINDLE])
            is_plc = self.executor.context.spindles.has_plc(spindle)
            word = "spindle acknowledged" if is_plc else "spindle"
            return (word, self.executor.context.spindles.first_number + spindle)
        if kind == rows.SPINDLE_AXIS:
            return ("exchange" if self.executor.spindle_exchange.is_stuck() else "", 0)
        if kind == rows.AWAIT_SIGNAL:
            return ("signal" if self.executor.signals.is_stuck() else "", 0)
        if kind == rows.MEASURE_END:
            return ("acknowledgement", self.executor.measuring.edge_probe.function)
        if kind == rows.POSITIONS and self.executor.context.single_axes.request_state(
            self.queue.rows, row
        ):
            return ("axis", self.executor.context.single_axes.requested_axis)
        return ("", 0)

    def resting_spindle(self) -> int:
        """Number, from 1, of the spindle at rest that a path at rest follows; else 0."""
        if not self.path.is_active or self.path.is_dwell or self.path.speed_v != 0.0:
            return 0
        spindle = int(self.path.history_rows[self.path.row + rows.FEED_SPINDLE])
        return (
            spindle if spindle > 0 and self.executor.context.spindles.is_resting(spindle - 1) else 0
        )
