# SPDX-License-Identifier: MIT
"""Two rotary axes that turn the tool into a direction: the angles of both, near present ones.

Two angles a, b turn a direction t about the axes p and q into u = R(p, a)·R(q, b)·t. The component
of u along p determines b except for its sign, and with b known, only a turn about p is left. If the
tool lies along p (the pole), any a will do: the present one stays.
"""

from __future__ import annotations

from nctakt.kernel.base import arithmetic
from nctakt.kernel.kinematics import map_rows

#: Sine of the angle to the first axis below which the tool lies along it.
POLE = 1e-12
#: Squared sine that rounding may miss of a direction at the limit of the reach.
ROUNDING = 1e-13


class Orientation:
    """Solves for two angles.

    ``first`` and ``second`` hold them, ``other_first`` and ``other_second`` the other solution;
    ``x``, ``y``, ``z`` a vector.
    """

    def __init__(self) -> None:
        self.first = 0.0
        self.second = 0.0
        self.other_first = 0.0
        self.other_second = 0.0
        self.x = 0.0
        self.y = 0.0
        self.z = 0.0

    def start(self, values: memoryview[float], column: int) -> None:
        """Take the vector in three columns."""
        self.x = values[column]
        self.y = values[column + map_rows.Y]
        self.z = values[column + map_rows.Z]

    def turn(self, values: memoryview[float], column: int, angle: float) -> None:
        """Turn the vector about the direction in three columns."""
        a = values[column]
        b = values[column + map_rows.Y]
        c = values[column + map_rows.Z]
        cosine = arithmetic.cosine(angle)
        sine = arithmetic.sine(angle)
        x = self.x
        y = self.y
        z = self.z
        along = (a * x + b * y + c * z) * (1.0 - cosine)
        self.x = x * cosine + (b * z - c * y) * sine + a * along
        self.y = y * cosine + (c * x - a * z) * sine + b * along
        self.z = z * cosine + (a * y - b * x) * sine + c * along

    def normalise(self) -> int:
        """Give the vector the length 1; return 0 if it is zero or not finite."""
        size = arithmetic.square_root(self.x * self.x + self.y * self.y + self.z * self.z)
        if not 1e-150 < size < 1e150:
            return 0
        self.x /= size
        self.y /= size
        self.z /= size
        return 1

    def solve(
        self,
        values: memoryview[float],
        p: int,
        q: int,
        t: int,
        near_first: float,
        near_second: float,
    ) -> int:
        """Settle the angles about the directions at ``p`` and ``q`` that turn the one at ``t``.

        Return ``REACHED`` or ``OUT_OF_REACH``.
        """
        u_x = self.x
        u_y = self.y
        u_z = self.z
        # cross product of p and u: its length is the sine of the angle between them
        n_x = values[p + map_rows.Y] * u_z - values[p + map_rows.Z] * u_y
        n_y = values[p + map_rows.Z] * u_x - values[p] * u_z
        n_z = values[p] * u_y - values[p + map_rows.Y] * u_x
        sine2 = n_x * n_x + n_y * n_y + n_z * n_z
        c = values[p] * u_x + values[p + map_rows.Y] * u_y + values[p + map_rows.Z] * u_z
        g = product(values, p, q)
        h = product(values, q, t)
        e = product(values, p, t)
        m_x = (
            values[q + map_rows.Y] * values[t + map_rows.Z]
            - values[q + map_rows.Z] * values[t + map_rows.Y]
        )
        m_y = values[q + map_rows.Z] * values[t] - values[q] * values[t + map_rows.Z]
        m_z = values[q] * values[t + map_rows.Y] - values[q + map_rows.Y] * values[t]
        ordinate = values[p] * m_x + values[p + map_rows.Y] * m_y + values[p + map_rows.Z] * m_z
        abscissa = e - g * h
        # squared sine of the second angle's distance from its middle, accurate near either pole
        if c >= 0.0:
            rest = sine2 - (g - h) * (g - h) - 2.0 * g * h * sine2 / (1.0 + c)
        else:
            rest = sine2 - (g + h) * (g + h) + 2.0 * g * h * sine2 / (1.0 - c)
        if rest < 0.0 - ROUNDING:
            return map_rows.OUT_OF_REACH
        middle = 0.0
        if ordinate != 0.0 or abscissa != 0.0:
            middle = arithmetic.arc_tangent_2(ordinate, abscissa)
        aside = 0.0
        if rest > 0.0:
            aside = arithmetic.arc_tangent_2(arithmetic.square_root(rest), c - g * h)
        elif c - g * h < 0.0:
            aside = 180.0
        self.other_second = nearest(middle - aside, near_second)
        self.other_first = self.turn_onto(
            values, p, q, t, self.other_second, u_x, u_y, u_z, near_first
        )
        self.second = nearest(middle + aside, near_second)
        self.first = self.turn_onto(values, p, q, t, self.second, u_x, u_y, u_z, near_first)
        self.prefer_nearer(near_first, near_second)
        return map_rows.REACHED

    def prefer_nearer(self, near_first: float, near_second: float) -> None:
        """Exchange the solutions if the other one is nearer."""
        if distance(self.other_first, near_first) + distance(self.other_second, near_second) < (
            distance(self.first, near_first) + distance(self.second, near_second)
        ):
            angle = self.first
            self.first = self.other_first
            self.other_first = angle
            angle = self.second
            self.second = self.other_second
            self.other_second = angle

    def turn_onto(
        self,
        values: memoryview[float],
        p: int,
        q: int,
        t: int,
        angle: float,
        u_x: float,
        u_y: float,
        u_z: float,
        near: float,
    ) -> float:
        """Return the angle about ``p`` that leads R(q, angle)·t to u; at the pole ``near``."""
        self.start(values, t)
        self.turn(values, q, angle)
        a = values[p]
        b = values[p + map_rows.Y]
        c = values[p + map_rows.Z]
        # both vectors across p, as cross products with it
        w_x = b * self.z - c * self.y
        w_y = c * self.x - a * self.z
        w_z = a * self.y - b * self.x
        if w_x * w_x + w_y * w_y + w_z * w_z < POLE * POLE:
            return near
        v_x = b * u_z - c * u_y
        v_y = c * u_x - a * u_z
        v_z = a * u_y - b * u_x
        if v_x * v_x + v_y * v_y + v_z * v_z < POLE * POLE:
            return near
        ordinate = a * (w_y * v_z - w_z * v_y)
        ordinate += b * (w_z * v_x - w_x * v_z) + c * (w_x * v_y - w_y * v_x)
        return nearest(arithmetic.arc_tangent_2(ordinate, w_x * v_x + w_y * v_y + w_z * v_z), near)


def product(values: memoryview[float], p: int, q: int) -> float:
    """Return the scalar product of the directions at ``p`` and ``q``."""
    return (
        values[p] * values[q]
        + values[p + map_rows.Y] * values[q + map_rows.Y]
        + values[p + map_rows.Z] * values[q + map_rows.Z]
    )


def nearest(angle: float, near: float) -> float:
    """Return ``angle`` turned by whole turns to where it is nearest to ``near``."""
    return angle + 360.0 * arithmetic.floor((near - angle) / 360.0 + 0.5)


def distance(angle: float, near: float) -> float:
    """Return by how much two angles differ."""
    return angle - near if angle >= near else near - angle
