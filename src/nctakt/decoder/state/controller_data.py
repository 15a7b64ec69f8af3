# SPDX-License-Identifier: MIT
"""Data of the controller that outlive a program: the timers of V.G, what V.S keeps.

In: which timer. Out: a number. Timers of the main program count at decode
time, or with SYN in the tick (a bank apart from the realtime cycles'); READ latches V.G.TIMER.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from nctakt.decoder.state.program_variables import Variables
from nctakt.kernel import cells
from nctakt.kernel.base.timers import Timers
from nctakt.kernel.tick.channel import Channel
from nctakt.lists.machine.machine import Machine

#: Cells of the bank that counts with SYN, one for what each timer has latched.
TIMER_BYTES = 8 * cells.TIMERS


class ProgramTimers:
    """The timers of ``#TIMER``, the same for all channels.

    ``latched`` is the memory of those that count in the tick; ``tick`` tells the present one.
    """

    def __init__(self, latched: bytearray, tick: Callable[[], int], cycle_time_us: int) -> None:
        self._synchronous = memoryview(latched).cast("d")
        self._tick = tick
        self._cycle_time_us = cycle_time_us
        self._values = [0.0] * cells.TIMERS
        self._counted = [0] * cells.TIMERS
        self._started: dict[int, int] = {}

    def command(self, action: str, timer: int) -> None:
        """``#TIMER`` without SYN, at the moment of decoding."""
        match action:
            case "START":
                self._started.setdefault(timer, self._tick())
            case "STOP":
                self._counted[timer] = self._elapsed(timer)
                self._started.pop(timer, None)
            case "READ":
                self._values[timer] = float(self._elapsed(timer) * self._cycle_time_us // 1000)
            case _:
                self._started.pop(timer, None)
                self._counted[timer] = 0

    def _elapsed(self, timer: int) -> int:
        started = self._started.get(timer)
        return self._counted[timer] + (0 if started is None else self._tick() - started)

    def take_over(self, timer: int) -> None:
        """What ``#TIMER READ SYN`` has latched in the tick."""
        self._values[timer] = self._synchronous[timer]

    def read(self, timer: int) -> float:
        """V.G.TIMER[timer], in ms."""
        return self._values[timer]


class ControllerData:
    """What programs of one channel read.

    ``kept``: V.S, what its programs keep until the next start-up.
    """

    def __init__(self, timers: ProgramTimers) -> None:
        self.timers = timers
        self.kept: Variables = {}


def controller_data(
    configuration: Machine, channels: Sequence[Channel], tick: Callable[[], int]
) -> list[ControllerData]:
    """The controller's data channel by channel; all have the same timers."""
    latched = bytearray(TIMER_BYTES)
    counting = Timers(latched, 0, configuration.cycle_time_us)
    timers = ProgramTimers(latched, tick, configuration.cycle_time_us)
    data = []
    for channel in channels:
        channel.program_timers = counting
        data.append(ControllerData(timers))
    return data
