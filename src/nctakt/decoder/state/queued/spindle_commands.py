# SPDX-License-Identifier: MIT
"""Commands about spindles."""

from __future__ import annotations

from nctakt.base.dataclass import dataclass
from nctakt.decoder.state.queued.commands import Command
from nctakt.kernel import rows


@dataclass(frozen=True, slots=True)
class SpindleJob(Command):
    """M ``function`` 3, 4, 5 or 19 of a spindle (by its place in the channel).

    Degrees and degrees per second; ``direction`` 0 of M19: the shortest way. ``ticks``: how long a
    spindle of the PLC takes. ``ignores_override``: the operator's override has no effect (G167).
    """

    packed_as = rows.SPINDLE

    spindle: int
    function: int
    speed_v: float
    position: float
    direction: int
    ticks: int
    ignores_override: bool = False


@dataclass(frozen=True, slots=True)
class CuttingSpeed(Command):
    """The surface at the tool gets the speed ``surface_v`` in mm/s; 0: no longer (G96, G97).

    ``axis``: number of the face axis in the machine, ``centre``: where its radius is 0, in mm.
    ``limit_v``: highest speed in degrees per second, 0 for that of the spindle.
    """

    packed_as = rows.CUTTING_SPEED

    spindle: int
    surface_v: float = 0.0
    axis: int = 0
    centre: float = 0.0
    limit_v: float = 0.0


@dataclass(frozen=True, slots=True)
class SpindleLimits(Command):
    """A spindle has these limits of its tool from its next start on (P-TOOL-00013 … 00015).

    ``low_v``: least speed of an endless job, ``high_v``: highest speed, in degrees per second;
    ``acceleration`` in degrees per second². 0: that of the spindle. ``step``: they are those of
    this gear step instead, with ``jerk`` in degrees per second³, 0: unlimited.
    """

    packed_as = rows.SPINDLE_LIMITS

    spindle: int
    low_v: float
    high_v: float
    acceleration: float
    jerk: float = 0.0
    step: int = 0


@dataclass(frozen=True, slots=True)
class SpindleAxis(Command):
    """The spindle gives its axis away, or takes it again (``S[PUTAX]``, ``S[CALLAX]``)."""

    packed_as = rows.SPINDLE_AXIS

    spindle: int
    gives: bool


@dataclass(frozen=True, slots=True)
class AwaitSpindle(Command):
    """Continues when the spindle has reached its speed or position, or the PLC has acknowledged."""

    packed_as = rows.AWAIT_SPINDLE

    spindle: int
