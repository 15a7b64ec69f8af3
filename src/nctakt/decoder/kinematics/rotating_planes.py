# SPDX-License-Identifier: MIT
"""The face of a turned part and its cylinder (``#FACE``, ``#CYL``) -> the rows of their maps."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from nctakt.base.dataclass import dataclass
from nctakt.kernel.kinematics import map_rows

_DEGREES_PER_RADIAN = 57.29577951308232


@dataclass(frozen=True, slots=True)
class RotatingPlane:
    """A plane that turns with a rotary axis; axes by their places in the channel.

    ``axes``: those that form it, in the order of the command; one of them is ``rotary``.
    ``radial``: the axis that leads to the axis of rotation, and is in the plane (``#FACE``); ``-1``
    on a cylinder. ``radius``: that of the cylinder in mm. ``zero_angle``: of the rotary axis where
    0 is on the cylinder. ``beside``: the tool's offset across the radial axis' line, in mm.
    ``command``: as written.
    """

    command: str
    axes: tuple[int, int]
    rotary: int
    radial: int = -1
    radius: float = 0.0
    zero_angle: float = 0.0
    beside: float = 0.0

    @property
    def mapped(self) -> tuple[int, ...]:
        """The axes whose positions differ from the programmed ones."""
        return (self.rotary,) if self.radial < 0 else (self.radial, self.rotary)


def map_values(
    plane: RotatingPlane, members: Sequence[int], tool: Mapping[int, float]
) -> list[float]:
    """Return the row of a plane's map; ``tool``: the offsets of the tool by axis, in mm."""
    row = [0.0] * map_rows.MAP_WIDTH
    row[map_rows.SLOT] = members[0]
    row[map_rows.AXIS_COUNT] = len(members)
    row[map_rows.JOINT_COUNT] = len(plane.mapped)
    row[map_rows.SECOND_PLACE] = plane.rotary
    for k, axis in enumerate(plane.mapped):
        column = map_rows.JOINTS + k * map_rows.JOINT_WIDTH
        row[column + map_rows.JOINT_AXIS] = axis
        row[column + map_rows.JOINT_MEMBER] = members[axis]
        row[column + map_rows.JOINT_IS_ROTARY] = axis == plane.rotary
    if plane.radial < 0:
        row[map_rows.PROGRAMMING] = map_rows.LATERAL
        row[map_rows.MATRIX] = _DEGREES_PER_RADIAN / plane.radius
        row[map_rows.SHIFT] = plane.zero_angle
    else:
        row[map_rows.PROGRAMMING] = map_rows.FACE_PLANE
        row[map_rows.FIRST_PLACE] = plane.radial
        row[map_rows.TOOL] = tool.get(plane.radial, 0.0)
        row[map_rows.TOOL + map_rows.Y] = plane.beside
    return row
