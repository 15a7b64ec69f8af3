# SPDX-License-Identifier: MIT
"""Commanded state of channels and their spindles, apart from values that have a name."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text
from nctakt.decoder.state.queued.in_force import InForce
from nctakt.kernel import codes
from nctakt.run.causes.wait_reasons import awaited
from nctakt.run.realtime.assembly import AssembledMachine

if TYPE_CHECKING:
    from nctakt.run.channel_run import ChannelRun

_ZERO_OFFSETS = 1 << codes.ZERO_OFFSET | 1 << codes.ADD_ZERO_OFFSET


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

    ``awaited``: the reason for which its program waits, ``None`` while it is working. ``in_force``:
    the functions and the tool of its current block, ``None`` before the first one.
    ``zero_offsets``: of each axis in mm or degrees, G54 … and G92 together.
    """

    programmed_mm_s: float
    spindles: tuple[SpindleState, ...]
    in_force: InForce | None = None
    zero_offsets: tuple[float, ...] = ()
    awaited: Text | None = None


def channel_states(
    machine: AssembledMachine, runs: Sequence[ChannelRun]
) -> tuple[ChannelState, ...]:
    """Return the state of each channel, whose programs are those of ``runs``."""
    found = []
    for channel, assembled, run in zip(machine.channels, machine.assembled, runs, strict=True):
        spindles = []
        for index, spindle in enumerate(assembled.parameters.spindles):
            function, speed_v, is_open = channel.context.spindles.latest_job(index)
            spindles.append(SpindleState(spindle.name, function, speed_v / 6.0, is_open))
        in_force = machine.registry.modal(channel.executor.modal)
        zero_offsets = tuple(
            machine.axes.offsets.of(axis, _ZERO_OFFSETS) for axis in assembled.members
        )
        programmed_v = channel.path.programmed_speed()
        reason = awaited(machine, assembled.index, run)
        found.append(ChannelState(programmed_v, tuple(spindles), in_force, zero_offsets, reason))
    return tuple(found)
