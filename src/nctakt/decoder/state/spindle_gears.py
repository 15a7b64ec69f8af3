# SPDX-License-Identifier: MIT
"""The gear steps of a spindle, and the active one."""

from __future__ import annotations

from collections.abc import Mapping

from nctakt.base.dataclass import dataclass


@dataclass(frozen=True, slots=True)
class SpindleGear:
    """The limits of one gear step: degrees per second (highest, rapid), per s², per s³ (0: none).

    ``change_position``: where the spindle is while the step is left, in degrees.
    """

    speed_v: float
    rapid_v: float
    acceleration: float
    jerk: float
    change_position: float


@dataclass(slots=True)
class SpindleGears:
    """The gear steps of a spindle by number; ``active``: after start-up that of P-AXIS-00079.

    ``tool_range``: least and highest speed of the tool in it, in degrees per second, 0: none;
    ``checks_tool``: a speed beyond them is an error (P-AXIS-00474).
    """

    steps: Mapping[int, SpindleGear]
    active: int
    checks_tool: bool = False
    tool_range: tuple[float, float] = (0.0, 0.0)

    @property
    def gear(self) -> SpindleGear:
        """The active gear step."""
        return self.steps[self.active]
