# SPDX-License-Identifier: MIT
"""All channels and axes in lockstep: ``run(n)`` (RC-001, RC-002).

``run`` works without Python objects until n ticks are done or Python has something to do; where it
is interrupted never changes a result. Values from outside are put into an image (``post``) that the
next tick latches at its start.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import cython

from nctakt.kernel import codes, rows
from nctakt.kernel.axes.axes import Axes
from nctakt.kernel.axes.single_axes import SingleAxes
from nctakt.kernel.base.record import Record
from nctakt.kernel.plc.axis_requests import AxisRequests
from nctakt.kernel.plc.interface_image import InterfaceImage
from nctakt.kernel.posted_values import PostedValues
from nctakt.kernel.st.tasks import PlcSide
from nctakt.kernel.tick.channel import Channel
from nctakt.kernel.tick.plc_calls import PlcCalls
from nctakt.kernel.tick.signals import SignalBoard
from nctakt.kernel.tick.stops import Stops

#: Maximum number of ticks of one call, far below the limit of a 64-bit integer.
MAX_TICKS = 1 << 60


class Lane:
    """The channels of the machine as a chain, since the tick cannot walk through a list.

    The base is the null object at the chain's end.
    """

    def needs_python(self) -> int:
        """First reason of a channel to return to Python, else ``codes.DONE``."""
        return codes.DONE

    def activity(self) -> int:
        """Highest activity of a channel: at rest, stuck, at work."""
        return codes.AT_REST

    def event_bound(self) -> int:
        """Highest number of events in a tick."""
        return 0

    def probe_bound(self) -> int:
        """Highest number of probes in a tick."""
        return 0

    def begin_tick(self, tick: int) -> None:
        """Take commands, run the cycles and interpolate the path, channel by channel."""

    def end_tick(self) -> None:
        """Answer waiting commands and publish the outputs, channel by channel."""


class ChannelLane(Lane):
    """One channel and those after it."""

    def __init__(self, channel: Channel, record: Record, number: int, others: Lane) -> None:
        self.channel = channel
        self.record = record
        self.number = number
        self.others = others

    def needs_python(self) -> int:
        reason = self.channel.needs_python()
        return reason if reason else self.others.needs_python()

    def activity(self) -> int:
        own = self.channel.activity()
        return own if own == codes.AT_WORK else max(own, self.others.activity())

    def event_bound(self) -> int:
        return self.channel.event_bound() + self.others.event_bound()

    def probe_bound(self) -> int:
        return self.channel.manager.probes_bound + self.others.probe_bound()

    def begin_tick(self, tick: int) -> None:
        self.record.channel = self.number
        self.channel.begin_tick(tick)
        if self.channel.feed.is_paced:
            self.channel.watch_queue(tick)
        self.channel.executor.run_commands(tick)
        self.channel.run_cycles()
        self.channel.interpolate()
        self.others.begin_tick(tick)

    def end_tick(self) -> None:
        self.record.channel = self.number
        self.channel.end_tick()
        self.others.end_tick()


class Kernel:
    """The realtime part of one machine.

    ``ends_deadlock``: ``run`` returns when each running program waits for another one's signal.
    ``plc``: a PLC in Structured Text. ``calls``: the conditions that a PLC in Python waits for;
    ``is_plc_due``: ``run`` has returned because it is to be called.
    """

    def __init__(
        self,
        memory: bytearray,
        axes: Axes,
        channels: list[Channel],
        record: Record,
        single_axes: SingleAxes,
    ) -> None:
        self.cells = memoryview(memory).cast("d")
        self.posted = PostedValues(memory)
        self.axes = axes
        self.single_axes = single_axes
        self.requests = AxisRequests(single_axes)
        self.record = record
        self.image = InterfaceImage(memory, record)
        self.signals = SignalBoard()
        self.ends_deadlock = False
        lane = Lane()
        for number in range(len(channels), 0, -1):
            named = number if len(channels) > 1 else 0
            channels[number - 1].set_signals(self.signals, number)
            channels[number - 1].signals.named = named
            lane = ChannelLane(channels[number - 1], record, named, lane)
        self.lane = lane
        self.stops = Stops(memory, record)
        self.calls = PlcCalls(channels[0].hli, channels[0].context.spindles)
        self.plc = PlcSide()
        self.is_stopped = False
        self.is_plc_due = False
        self.tick = 0
        axes.publish_all()

    def attach_plc(self, plc: PlcSide) -> None:
        """Let this PLC in Structured Text run in each tick from now on (ST-801)."""
        self.plc = plc

    # --- ticks ----------------------------------------------------------------------------------

    def run(self, ticks: int) -> int:
        """Run up to ``ticks`` ticks; return why it ended, ``codes.DONE`` after all of them.

        ``is_stopped``: whether a stop has ended it early.
        """
        ticks = min(ticks, MAX_TICKS)
        self.is_stopped = False
        self.is_plc_due = False
        if ticks < 2:  # releasing the interpreter takes longer
            return self.loop(ticks)
        with cython.nogil:
            reason = self.loop(ticks)
        return reason

    def run_calling(self, ticks: int, call: Callable[[Any], object], view: object) -> int:
        """Run ticks as ``run``, with this call after each of them.

        After a tick in which Python has something to do, it returns without the call:
        ``is_plc_due``. Exceptions of the call pass through.
        """
        end = self.tick + min(ticks, MAX_TICKS)
        self.is_stopped = False
        while True:
            before = self.tick
            self.is_plc_due = False
            reason = self.loop(1)
            if self.tick == before:
                return reason
            if reason or self.is_stopped or self.record.has_awaited():
                self.is_plc_due = True
                return reason
            call(view)
            if self.tick >= end:
                return codes.DONE

    def reserve(self) -> None:
        """Make the emptied record large enough for a tick of the present load."""
        self.record.reserve(self.event_bound(), self.lane.probe_bound())

    def event_bound(self) -> int:
        """Highest number of events in a tick."""
        posted = self.image.event_bound + self.plc.event_bound() + self.requests.event_bound()
        return self.lane.event_bound() + posted

    def loop(self, ticks: int) -> int:
        """Run ticks without Python objects; return as ``run``."""
        end = self.tick + ticks
        while self.tick < end:
            reason = self.lane.needs_python()
            if reason:
                return reason
            if self.signals.has_waited and self.ends_deadlock:
                if self.lane.activity() == codes.STUCK:
                    return codes.DEADLOCK
            if not self.record.has_room(self.event_bound(), self.lane.probe_bound()):
                return codes.FULL
            self.run_tick()
            if self.stops.is_watching and self.stops.check(self.tick - 1):
                self.is_stopped = True
            if self.calls.is_watching and self.calls_plc():
                break
            if self.is_stopped or self.plc.has_news:
                break
        return self.lane.needs_python()

    def calls_plc(self) -> int:
        """Return whether Python has something to do for the PLC after this tick."""
        if self.calls.is_due(self.tick - 1):
            self.is_plc_due = True
            return 1
        self.calls.answer(self.tick - 1)
        return 1 if self.calls.is_noting and self.calls.answer_count > 0 else 0

    def run_tick(self) -> None:
        """Run one tick: a table of its phases (RC-002)."""
        self.record.tick = self.tick
        self.record.channel = 0
        self.latch_inputs()
        self.axes.begin_tick()
        self.lane.begin_tick(self.tick)
        self.record.channel = 0
        self.single_axes.step()
        self.single_axes.follow_masters()
        if self.axes.has_lag:
            self.axes.follow()
        self.single_axes.watch_slaves()
        self.axes.publish()
        self.lane.end_tick()
        self.record.channel = 0
        if self.image.is_attached:
            self.image.publish(self.tick + 1)
        self.plc.run(self.tick)
        self.record_row()
        self.tick += 1

    def lose_tick(self) -> int:
        """Pass a tick without interpolation (P-RTCF-00011): only time advances."""
        self.record.tick = self.tick
        if self.image.is_attached:
            self.image.publish(self.tick + 1)
        self.plc.run(self.tick)
        self.record_row()
        self.tick += 1
        return codes.DONE

    def note_overflow(self, thread: int) -> None:
        """Record that a thread of the schedule overflows in the coming tick."""
        self.record.tick = self.tick
        self.record.channel = 0
        self.record.event(rows.EVENT_OVERFLOW, 0, thread)

    def latch_inputs(self) -> None:
        """Latch values written by another process, by a PLC in the tick, then the posted values."""
        if self.image.is_attached:
            self.image.latch()
        self.plc.latch()
        if self.posted.count > 0:
            self.posted.latch()
        self.plc.guard()
        self.requests.latch()

    def record_row(self) -> None:
        """Record the trace row of this tick."""
        if self.record.signal_count > 0:
            self.record.take_row()
