# SPDX-License-Identifier: MIT
"""A kinematic chain in mm and degrees -> the row of its map (``kernel.kinematics``).

A chain is described with all axes at 0, in the coordinate system of the workpiece; its joints go
from the workpiece to the tool.
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.base.dataclass import dataclass
from nctakt.kernel.base import arithmetic
from nctakt.kernel.kinematics import map_rows
from nctakt.lists.machine.transformations.kinematics import Vector

X: Vector = (1.0, 0.0, 0.0)
Y: Vector = (0.0, 1.0, 0.0)
Z: Vector = (0.0, 0.0, 1.0)
DIRECTIONS = {"A": X, "B": Y, "C": Z}
ORIGIN: Vector = (0.0, 0.0, 0.0)


@dataclass(frozen=True, slots=True)
class Joint:
    """A joint; ``axis``: its place in the channel. The direction has the length 1."""

    axis: int
    is_rotary: bool
    direction: Vector
    point: Vector = ORIGIN


@dataclass(frozen=True, slots=True)
class ProgrammedAngles:
    """Two angles of an ideal chain: the places that they are programmed at, and their axes."""

    first: int
    second: int
    first_direction: Vector
    second_direction: Vector


@dataclass(frozen=True, slots=True)
class Chain:
    """A kinematic chain.

    ``tool``: the place of the holder; ``tool_direction``: from the tip to the clamp. ``angles``:
    the words programmed for the tool's direction; ``has_vector``: a vector is programmed; neither:
    the positions of the rotary axes. ``linkage``: see ``UniversalKinematic``. ``uses_length``:
    whether the tool's length counts.
    """

    joints: tuple[Joint, ...]
    tool: Vector = ORIGIN
    tool_direction: Vector = Z
    angles: ProgrammedAngles | None = None
    has_vector: bool = False
    linkage: tuple[Vector, ...] = ()
    uses_length: bool = True

    @property
    def rotary(self) -> tuple[Joint, ...]:
        """The rotary joints, from the workpiece to the tool."""
        return tuple(joint for joint in self.joints if joint.is_rotary)


def cross(left: Vector, right: Vector) -> Vector:
    """Return the cross product of two vectors."""
    return (
        left[1] * right[2] - left[2] * right[1],
        left[2] * right[0] - left[0] * right[2],
        left[0] * right[1] - left[1] * right[0],
    )


def dot(left: Vector, right: Vector) -> float:
    """Return the scalar product of two vectors."""
    return left[0] * right[0] + left[1] * right[1] + left[2] * right[2]


def unit(vector: Vector) -> Vector:
    """Return a vector of length 1 in a direction."""
    size = arithmetic.square_root(dot(vector, vector))
    return vector[0] / size, vector[1] / size, vector[2] / size


def inverse(rows: Sequence[Vector]) -> tuple[Vector, ...]:
    """Return the inverse of a regular matrix, by its rows."""
    first, second, third = rows
    columns = cross(second, third), cross(third, first), cross(first, second)
    whole = dot(first, columns[0])
    return tuple(
        (columns[0][i] / whole, columns[1][i] / whole, columns[2][i] / whole) for i in range(3)
    )


def map_values(chain: Chain, members: Sequence[int], tool_length: float) -> list[float]:
    """Return the row of a chain's map.

    ``members``: the machine's numbers of the channel's axes; ``tool_length`` in mm, with its
    additions.
    """
    row = [0.0] * map_rows.MAP_WIDTH
    row[map_rows.SLOT] = members[0]
    row[map_rows.AXIS_COUNT] = len(members)
    length = tool_length if chain.uses_length else 0.0
    for i in range(3):
        row[map_rows.TOOL + i] = chain.tool[i] - length * chain.tool_direction[i]
        row[map_rows.TOOL_DIRECTION + i] = chain.tool_direction[i]
    _put_joints(row, chain, members)
    _put_programming(row, chain)
    return row


def _put_joints(row: list[float], chain: Chain, members: Sequence[int]) -> None:
    rotary: list[int] = []
    for k, joint in enumerate(chain.joints):
        column = map_rows.JOINTS + k * map_rows.JOINT_WIDTH
        row[column + map_rows.JOINT_AXIS] = joint.axis
        row[column + map_rows.JOINT_MEMBER] = members[joint.axis]
        row[column + map_rows.JOINT_IS_ROTARY] = joint.is_rotary
        for i in range(3):
            row[column + map_rows.JOINT_DIRECTION + i] = joint.direction[i]
            row[column + map_rows.JOINT_POINT + i] = joint.point[i]
        if joint.is_rotary:
            rotary.append(column)
    linear = [k for k, joint in enumerate(chain.joints) if not joint.is_rotary]
    is_split = linear[-1] - linear[0] == len(linear) - 1
    row[map_rows.JOINT_COUNT] = len(chain.joints)
    row[map_rows.LEADING_COUNT] = linear[0]
    row[map_rows.TRAILING_FIRST] = linear[-1] + 1
    row[map_rows.IS_SPLIT] = is_split
    if len(rotary) == 2:
        row[map_rows.FIRST_JOINT], row[map_rows.SECOND_JOINT] = rotary
    _put_matrix(row, chain, is_split)


def _put_matrix(row: list[float], chain: Chain, is_split: bool) -> None:
    """Put the offset from the linear axes to the linear joints, and if split to the motion."""
    matrix = chain.linkage[:3] or (X, Y, Z)
    shift = chain.linkage[3] if chain.linkage else ORIGIN
    if is_split:
        joints = {joint.axis: joint.direction for joint in chain.joints if not joint.is_rotary}
        directions = [(joints[0][i], joints[1][i], joints[2][i]) for i in range(3)]
        columns = [(matrix[0][j], matrix[1][j], matrix[2][j]) for j in range(3)]
        shift = dot(directions[0], shift), dot(directions[1], shift), dot(directions[2], shift)
        matrix = tuple(
            (dot(line, columns[0]), dot(line, columns[1]), dot(line, columns[2]))
            for line in directions
        )
    back = inverse(matrix)
    for i in range(3):
        row[map_rows.SHIFT + i] = shift[i]
        for j in range(3):
            row[map_rows.MATRIX + 3 * i + j] = matrix[i][j]
            row[map_rows.INVERSE + 3 * i + j] = back[i][j]


def _put_programming(row: list[float], chain: Chain) -> None:
    if chain.has_vector:
        row[map_rows.PROGRAMMING] = map_rows.VECTOR
    elif chain.angles is not None:
        row[map_rows.PROGRAMMING] = map_rows.TWO_ANGLES
        row[map_rows.FIRST_PLACE] = chain.angles.first
        row[map_rows.SECOND_PLACE] = chain.angles.second
        for i in range(3):
            row[map_rows.FIRST_DIRECTION + i] = chain.angles.first_direction[i]
            row[map_rows.SECOND_DIRECTION + i] = chain.angles.second_direction[i]
