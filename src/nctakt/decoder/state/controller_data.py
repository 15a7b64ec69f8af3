# SPDX-License-Identifier: MIT
"""Data of the controller that outlive a program: the timers of V.G and the variables of V.S.

Timers of the main program count at decode time, or with SYN in the tick (in a bank separate from
that of the realtime cycles); READ latches V.G.TIMER.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from nctakt.decoder.state.couplings import CoupledPair, KeptCouplings
from nctakt.decoder.state.program_variables import Variables
from nctakt.kernel import cells
from nctakt.kernel.axes.single_axes import SingleAxes
from nctakt.kernel.base.timers import Timers
from nctakt.kernel.tick.channel import Channel
from nctakt.lists.declared.tools import Tool
from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.lists.machine.machine import Machine

#: Size in bytes of the latched values of the timers with SYN.
TIMER_BYTES = 8 * cells.TIMERS


class ProgramTimers:
    """The timers of ``#TIMER``, shared by all channels.

    ``latched``: the memory of those that count in the tick; ``tick`` returns the current tick.
    """

    def __init__(self, latched: bytearray, tick: Callable[[], int], cycle_time_us: int) -> None:
        self._synchronous = memoryview(latched).cast("d")
        self._tick = tick
        self._cycle_time_us = cycle_time_us
        self._values = [0.0] * cells.TIMERS
        self._counted = [0] * cells.TIMERS
        self._started: dict[int, int] = {}

    def command(self, action: str, timer: int) -> None:
        """Execute ``#TIMER`` without SYN, at decode time."""
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
        """Copy the value that ``#TIMER READ SYN`` has latched in the tick."""
        self._values[timer] = self._synchronous[timer]

    def read(self, timer: int) -> float:
        """Return V.G.TIMER[timer] in ms."""
        return self._values[timer]


class ControllerData:
    """The data that programs of one channel share.

    ``kept``: V.S, kept until the next start-up. ``references``: which axes are homed, and where.
    ``limited_axes``: numbers in the machine of those with software limits of a program. ``tools``:
    tools of the list that programs have changed (V.G.WZ[5].R), by number. ``tool_life_factors``:
    V.TLM. ``couplings``: groups of coupled axes. ``feed_forward``: axis -> its share where programs
    have changed it, of all channels.
    """

    def __init__(
        self,
        timers: ProgramTimers,
        couplings: KeptCouplings,
        feed_forward: dict[int, float],
        references: SingleAxes,
    ) -> None:
        self.timers = timers
        self.couplings = couplings
        self.feed_forward = feed_forward
        self.kept: Variables = {}
        self.references = references
        self.limited_axes: set[int] = set()
        self.tools: dict[int, Tool] = {}
        self.tool_life_factors = {"TIME_FACT": 1.0, "DIST_FACT": 1.0}

    def follow_tool_life(self, time_factor: float, distance_factor: float) -> None:
        """Begin a program with the factors that count in the tick: a reset takes those ahead."""
        self.tool_life_factors = {"TIME_FACT": time_factor, "DIST_FACT": distance_factor}


def controller_data(
    configuration: Machine,
    channels: Sequence[Channel],
    tick: Callable[[], int],
    references: SingleAxes,
) -> list[ControllerData]:
    """Return the controller's data for each channel; all share the timers."""
    latched = bytearray(TIMER_BYTES)
    counting = Timers(latched, 0, configuration.cycle_time_us)
    timers = ProgramTimers(latched, tick, configuration.cycle_time_us)
    data = []
    shares: dict[int, float] = {}
    for channel, listed in zip(channels, configuration.channels, strict=True):
        channel.executor.program_timers = counting
        couplings = _couplings(configuration, listed.parameters)
        data.append(ControllerData(timers, couplings, shares, references))
    return data


def _couplings(configuration: Machine, parameters: ChannelParameters) -> KeptCouplings:
    """Return the groups at start-up: 0 with those pairs of the list whose axes exist."""
    listed = parameters.couplings
    if not listed.pairs:
        return KeptCouplings({}, listed.after_reset, listed.after_end)
    axes = {axis.logical_number: index for index, axis in enumerate(configuration.axes)}
    spindles = {one.logical_number: index for index, one in enumerate(parameters.spindles)}
    pairs = []
    for pair in listed.pairs:
        numbers = spindles if pair.is_spindle else axes
        if pair.slave in numbers and pair.master in numbers:
            slave, master = numbers[pair.slave], numbers[pair.master]
            pairs.append(CoupledPair(slave, master, is_spindle=pair.is_spindle))
    groups = {0: tuple(pairs)} if pairs else {}
    return KeptCouplings(groups, listed.after_reset, listed.after_end)
