# SPDX-License-Identifier: MIT
"""The software limits that the path of a program has to keep."""

from __future__ import annotations

from nctakt.base.dataclass import dataclass, field
from nctakt.lists.machine.axis_configuration import AxisConfiguration


@dataclass(slots=True)
class LimitsOfProgram:
    """Software limits in mm or degrees, by axis index; ``programmed``: those of G98 and G99."""

    programmed: dict[int, tuple[float, float]] = field(default_factory=dict)

    def of(self, axis: AxisConfiguration, index: int) -> tuple[float, float]:
        """Return the limits of an axis in force: those of the program, else of its list."""
        listed = (axis.software_limit_low, axis.software_limit_high)
        return self.programmed.get(index, listed) if self.programmed else listed
