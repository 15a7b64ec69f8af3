# SPDX-License-Identifier: MIT
"""The gear steps of a spindle, and which one is active."""

from __future__ import annotations

from collections.abc import Mapping

from nctakt.base.dataclass import dataclass


@dataclass(frozen=True, slots=True)
class SpindleGear:
    """The limits of one gear step: degrees per second (highest, rapid), per s², per s³ (0: none).

    ``change_position``: where the spindle stands while the step is left, in degrees.
    """

    speed_v: float
    rapid_v: float
    acceleration: float
    jerk: float
    change_position: float


@dataclass(slots=True)
class SpindleGears:
    """The gear steps of a spindle by number; ``active``: after start-up that of P-AXIS-00079."""

    steps: Mapping[int, SpindleGear]
    active: int

    @property
    def gear(self) -> SpindleGear:
        """The active gear step."""
        return self.steps[self.active]
