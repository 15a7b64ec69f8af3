# SPDX-License-Identifier: MIT
"""A channel's side of the signals: its commands in the tick, and the waits of its decoder.

A decoder waits between two ticks; ``Channel.needs_python`` asks ``decoder_state`` then.
"""

from __future__ import annotations

from nctakt.kernel import codes, rows
from nctakt.kernel.base.bounds import check_range
from nctakt.kernel.base.record import Record
from nctakt.kernel.tick.command_queue import CommandQueue
from nctakt.kernel.tick.signals import SignalBoard


class ChannelSignals:
    """The signals of the channel ``number``, from 1.

    ``is_decoder_waiting``: for the signal of ``awaited_number``. ``blocked_since``: the tick in
    which the ``#WAIT SYN`` at the head of the queue had to wait first, -1 if none does. ``named``:
    the number in events, 0 on a machine with one channel.
    """

    def __init__(
        self, board: SignalBoard, number: int, queue: CommandQueue, record: Record
    ) -> None:
        check_range(number, 1, codes.MAX_SIGNAL_CHANNEL, "channel")
        self.board = board
        self.number = number
        self.named = 0
        self.queue = queue
        self.record = record
        self.is_decoder_waiting = False
        self.awaited_number = 0
        self.awaited_senders = 0
        self.may_overtake = False
        self.awaited_source = 0
        self.waiting_since = 0
        self.blocked_since = -1
        self.awaits_tick = False

    # --- Python's side, between two ticks -------------------------------------------------------

    def send(
        self,
        source: int,
        tick: int,
        number: int,
        receivers: int,
        remaining: int,
        mask: int,
        values: bytearray,
    ) -> bool:
        """Send a signal of the decoder before ``tick``; return whether there was room for it."""
        numbers = memoryview(values).cast("d")
        check_range(len(numbers), codes.SIGNAL_VALUES, codes.SIGNAL_VALUES, "number of values")
        is_sent = self.board.send(
            number, self.number, receivers, remaining, 0, tick, mask, numbers, 0
        )
        if is_sent:
            self.record_event(
                tick, rows.EVENT_SIGNAL_SENT, source, number, receivers, remaining, 0.0
            )
        return bool(is_sent)

    def remove(self, low: int, high: int, receivers: int, is_range: bool) -> None:
        """Remove signals for the decoder."""
        self.board.remove(low, high, receivers, is_range)

    def await_signal(
        self, source: int, tick: int, number: int, senders: int, may_overtake: bool
    ) -> None:
        """Let the decoder wait for a signal from ``tick`` on."""
        self.is_decoder_waiting = True
        self.awaited_number = number
        self.awaited_senders = senders
        self.may_overtake = may_overtake
        self.awaited_source = source
        self.waiting_since = tick
        if self.board.state(number, self.number, senders, may_overtake) != codes.SIGNAL_THERE:
            self.board.has_waited = True
            self.record_event(tick, rows.EVENT_SIGNAL_AWAITED, source, number, senders, 0.0, 0.0)

    def accept(self, tick: int) -> tuple[float, ...]:
        """Take the signal that the decoder waits for: mask of the values received, and values.

        In place of the mask -1 where another signal has to be taken before, and its number.
        """
        self.is_decoder_waiting = False
        number, senders = self.awaited_number, self.awaited_senders
        if (
            self.board.state(number, self.number, senders, self.may_overtake)
            == codes.SIGNAL_OVERTAKES
        ):
            return (-1.0, float(self.board.blocking))
        return self.taken(self.awaited_source, tick, number, senders)

    def read(
        self, source: int, tick: int, number: int, senders: int, may_overtake: bool
    ) -> tuple[float, ...]:
        """Take a signal for the decoder if it is there, as ``accept``; empty if it is not."""
        state = self.board.state(number, self.number, senders, may_overtake)
        if state == codes.SIGNAL_OVERTAKES:
            return (-1.0, float(self.board.blocking))
        return self.taken(source, tick, number, senders) if state == codes.SIGNAL_THERE else ()

    def taken(self, source: int, tick: int, number: int, senders: int) -> tuple[float, ...]:
        """Take the signals, which are there; return the mask of their values, and the values."""
        board = self.board
        board.take(number, self.number, senders)
        sender, sent = float(board.taken_sender), float(board.taken_tick)
        self.record_event(tick, rows.EVENT_SIGNAL_TAKEN, source, number, sender, sent, 0.0)
        values = [board.received[i] for i in range(codes.SIGNAL_VALUES)]
        return (float(board.received_mask), *values)

    def record_event(
        self, tick: int, kind: int, source: int, number: int, a: float, b: float, c: float
    ) -> None:
        """Record an event of the decoder in the coming tick."""
        self.record.tick = tick
        self.record.channel = self.named
        self.record.event_between_ticks(kind, source, number, a, b, c)

    def await_tick(self, source: int) -> None:
        """Let the decoder wait until another tick has begun."""
        self.awaits_tick = True
        self.awaited_source = source

    def awaited(self) -> tuple[int, int, int, int]:
        """Return number, senders, source and first tick of the awaited signal; number 0: none.

        A ``#WAIT SYN`` comes before the decoder, which is ahead of it.
        """
        if self.is_stuck():
            row = self.queue.command(self.queue.head)
            number, senders = int(row[rows.AWAITED_SIGNAL]), int(row[rows.AWAITED_SENDERS])
            return (number, senders, int(row[rows.SOURCE]), self.blocked_since)
        if self.is_decoder_waiting and self.queue.head == self.queue.tail:
            waiting = (self.awaited_number, self.awaited_senders, self.awaited_source)
            return (*waiting, self.waiting_since)
        return (0, 0, 0, 0)

    def give_up(self) -> None:
        """Let the decoder wait no more: its program is given up."""
        self.is_decoder_waiting = False
        self.awaits_tick = False

    # --- in the tick ----------------------------------------------------------------------------

    def decoder_state(self) -> int:
        """Return whether the signals that the decoder waits for are there."""
        return self.board.state(
            self.awaited_number, self.number, self.awaited_senders, self.may_overtake
        )

    def is_stuck(self) -> int:
        """Return whether the ``#WAIT SYN`` at the head of the queue still finds no signal."""
        if self.blocked_since < 0 or self.queue.head == self.queue.tail:
            return 0
        row = self.queue.head_row()
        if self.queue.rows[row + rows.KIND] != rows.AWAIT_SIGNAL:
            return 0
        number = int(self.queue.rows[row + rows.AWAITED_SIGNAL])
        senders = int(self.queue.rows[row + rows.AWAITED_SENDERS])
        may_overtake = int(self.queue.rows[row + rows.AWAITED_OVERTAKES])
        state = self.board.state(number, self.number, senders, may_overtake)
        return 1 if state == codes.SIGNAL_ABSENT else 0

    def execute(self, tick: int, row: int, kind: int) -> int:
        """Carry out a command at ``row``; 0: it waits; else the number of an error, or 1."""
        if kind == rows.AWAIT_SIGNAL:
            return self.execute_wait(tick, row)
        if kind == rows.SIGNAL:
            return self.execute_send(tick, row)
        self.board.remove(
            int(self.queue.rows[row + rows.REMOVED_LOW]),
            int(self.queue.rows[row + rows.REMOVED_HIGH]),
            int(self.queue.rows[row + rows.REMOVED_RECEIVERS]),
            self.queue.rows[row + rows.REMOVED_IS_RANGE] != 0.0,
        )
        return 1

    def execute_send(self, tick: int, row: int) -> int:
        """Send a signal; return 250001 if there is no room for it."""
        number = int(self.queue.rows[row + rows.SIGNAL_NUMBER])
        receivers = int(self.queue.rows[row + rows.SIGNAL_RECEIVERS])
        remaining = int(self.queue.rows[row + rows.SIGNAL_COUNT])
        mask = int(self.queue.rows[row + rows.SIGNAL_MASK])
        source = int(self.queue.rows[row + rows.SOURCE])
        if not self.board.send(
            number,
            self.number,
            receivers,
            remaining,
            1,
            tick,
            mask,
            self.queue.rows,
            row + rows.SIGNAL_FIRST_VALUE,
        ):
            return 250001
        self.record.event(rows.EVENT_SIGNAL_SENT, source, number, receivers, remaining, 1.0)
        return 1

    def execute_wait(self, tick: int, row: int) -> int:
        """Take the signals that are waited for; 0 if one is absent, 250002 if one overtakes."""
        number = int(self.queue.rows[row + rows.AWAITED_SIGNAL])
        senders = int(self.queue.rows[row + rows.AWAITED_SENDERS])
        may_overtake = int(self.queue.rows[row + rows.AWAITED_OVERTAKES])
        source = int(self.queue.rows[row + rows.SOURCE])
        state = self.board.state(number, self.number, senders, may_overtake)
        if state == codes.SIGNAL_OVERTAKES:
            return 250002
        if state == codes.SIGNAL_ABSENT:
            if self.blocked_since < 0:
                self.blocked_since = tick
                self.board.has_waited = True
                self.record.event(rows.EVENT_SIGNAL_AWAITED, source, number, senders, 0.0, 1.0)
            return 0
        self.board.take(number, self.number, senders)
        sender, sent = self.board.taken_sender, self.board.taken_tick
        self.record.event(rows.EVENT_SIGNAL_TAKEN, source, number, sender, sent, 1.0)
        self.blocked_since = -1
        return 1

    def reset(self) -> None:
        """Wait no more, and remove the signals that are addressed to the channel (RC-007)."""
        self.is_decoder_waiting = False
        self.awaits_tick = False
        self.blocked_since = -1
        self.board.clear(self.number)
