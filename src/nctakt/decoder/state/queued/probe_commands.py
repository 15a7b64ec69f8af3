# SPDX-License-Identifier: MIT
"""The commands of a block that measures with a touch probe (G100)."""

from __future__ import annotations

from nctakt.base.dataclass import dataclass
from nctakt.decoder.state.queued.commands import Command, PositionRequest
from nctakt.kernel import rows


@dataclass(frozen=True, slots=True)
class Touch(Command):
    """The next motion measures with a touch probe (G100).

    ``part``: share of its length where a simulated probe touches, below 0: nowhere; ``ticks``:
    after how many ticks, below 0: never. ``level``: the value of HLI.PROBE that is the signal.
    ``continues``: the motion continues to its target. ``needed``: a missing signal is an error.
    ``may_be_pressed``: the probe may be pressed where the motion begins.
    """

    packed_as = rows.TOUCH

    part: float
    ticks: int
    level: int
    continues: bool
    needed: bool
    may_be_pressed: bool


@dataclass(frozen=True, slots=True)
class TouchEnd(Command):
    """The motion that measures with a touch probe is over."""

    packed_as = rows.TOUCH_END


@dataclass(frozen=True, slots=True)
class MeasurementRequest(PositionRequest):
    """As a position request; the answer begins with whether the probe has touched.

    Then come the positions as programmed ones, those of the axes at the signal, and these as
    programmed ones.
    """
