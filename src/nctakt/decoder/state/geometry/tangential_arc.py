# SPDX-License-Identifier: MIT
"""The arc that leads to a compensated contour, or from it, as a tangent (G05, MO-9).

Its centre lies where the perpendicular bisector of its ends meets the line from the end of the
contour to the tool.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from nctakt.decoder.contour import rows

#: A position this near to the tangent is led to along a straight line, mm.
ON_TANGENT_MM = 1e-6


class Tangent(NamedTuple):
    """A motion to the contour (``leads_to``) or from it.

    ``corner``: where the contour begins or ends; ``side``: 1 where the tool is left of it, -1
    right.
    """

    corner: tuple[float, float]
    side: float
    leads_to: bool

    def arc(self, piece: tuple[float, ...]) -> tuple[tuple[float, ...], float]:
        """Return the arc that takes the place of a straight piece, and its length in mm.

        A piece along the tangent stays straight.
        """
        start, end = (piece[0], piece[1]), (piece[2], piece[3])
        beside, other = (end, start) if self.leads_to else (start, end)
        across = (beside[0] - self.corner[0], beside[1] - self.corner[1])
        chord = (other[0] - beside[0], other[1] - beside[1])
        product = chord[0] * across[0] + chord[1] * across[1]
        if abs(product) <= ON_TANGENT_MM * math.hypot(*across):
            return piece, math.hypot(*chord)
        share = 0.5 * (chord[0] * chord[0] + chord[1] * chord[1]) / product
        centre = (beside[0] + share * across[0], beside[1] + share * across[1])
        from_angle = math.atan2(start[1] - centre[1], start[0] - centre[0])
        to_angle = math.atan2(end[1] - centre[1], end[0] - centre[0])
        turn = (to_angle - from_angle) % math.tau
        if (share > 0.0) is not (self.side > 0.0):
            turn -= math.tau
        length = abs(turn) * math.dist(start, centre)
        return (*start, *end, float(rows.ARC), *centre, math.degrees(turn)), length
