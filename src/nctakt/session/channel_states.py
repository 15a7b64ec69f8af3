# SPDX-License-Identifier: MIT
"""What channels and their spindles have been commanded, beside the values that have a name."""

from __future__ import annotations

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text
from nctakt.run.assembly import AssembledMachine
from nctakt.run.wait_reasons import awaited


@dataclass(frozen=True, slots=True)
class SpindleState:
    """The latest job of a spindle: its M function (3, 4, 5, 19; 0: none yet) and its speed.

    ``speed`` in 1/min, negative backward. ``is_open``: it has not been reached yet.
    """

    name: str
    function: int
    speed: float
    is_open: bool


@dataclass(frozen=True, slots=True)
class ChannelState:
    """A channel: the programmed speed of its current segment in mm/s (0: none), its spindles.

    ``awaited``: what its program waits for, ``None`` while it is at work.
    """

    programmed_mm_s: float
    spindles: tuple[SpindleState, ...]
    awaited: Text | None = None


def channel_states(machine: AssembledMachine) -> tuple[ChannelState, ...]:
    """Return the state of each channel."""
    found = []
    for channel, assembled in zip(machine.channels, machine.assembled, strict=True):
        spindles = []
        for index, spindle in enumerate(assembled.parameters.spindles):
            function, speed_v, is_open = channel.context.spindles.latest_job(index)
            spindles.append(SpindleState(spindle.name, function, speed_v / 6.0, is_open))
        programmed_v = channel.path.programmed_speed()
        reason = awaited(machine, assembled.index)
        found.append(ChannelState(programmed_v, tuple(spindles), reason))
    return tuple(found)
