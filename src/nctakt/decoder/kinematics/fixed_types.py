# SPDX-License-Identifier: MIT
"""Types of kinematics -> chains, by the published meaning of their parameters.

Type 91, the universal kinematic, names its chain itself. Each fixed type is walked from the
workpiece to the tool: distances, rotary axes, the tool. HDi is ``param[i - 1]``. The channel's axes
are X Y Z and the rotary axes of the type in its order. Signs that no source settles are those of
plain geometry (docs/conformance/transformations.md): a distance from the tool towards the machine
is positive along the axis, an angle is positive by the right hand.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from nctakt.decoder.kinematics.chain import (
    DIRECTIONS,
    ORIGIN,
    Chain,
    Joint,
    ProgrammedAngles,
    X,
    Y,
    Z,
    unit,
)
from nctakt.kernel.base import arithmetic
from nctakt.lists.machine.transformations.kinematics import (
    CLASSIC_MODES,
    POINT_VECTOR,
    UniversalKinematic,
    Vector,
)

#: The rotary axes begin at this place of the channel.
_FIRST_ROTARY = 3
_UNITS = 10_000.0
#: HD13 of type 90 -> the rotary axes of the head.
_TUBE_HEADS = {0: "AB", 1: "BA", 2: "CA", 4: "CB"}


class Parameters:
    """HD1 … of a kinematic in mm or degrees."""

    def __init__(self, values: Mapping[int, float]) -> None:
        self._values = values

    def __call__(self, number: int) -> float:
        """Return HD ``number``."""
        return self._values.get(number - 1, 0.0) / _UNITS

    def sign(self, number: int) -> float:
        """Return the direction of a rotary axis: -1 where the parameter is negative."""
        return -1.0 if self(number) < 0.0 else 1.0


class Walk:
    """The chain along a machine with all axes at 0: position, rotation, joints."""

    def __init__(self) -> None:
        self.joints: list[Joint] = []
        self.position = ORIGIN
        self.rows: tuple[Vector, Vector, Vector] = (X, Y, Z)

    def linear(self) -> Walk:
        """Pass the three linear axes."""
        self.joints += [Joint(i, False, direction) for i, direction in enumerate((X, Y, Z))]
        return self

    def move(self, x: float, y: float, z: float) -> Walk:
        """Go a distance in the present directions."""
        step = self._turned((x, y, z))
        x, y, z = self.position
        self.position = x + step[0], y + step[1], z + step[2]
        return self

    def rotary(self, index: int, direction: Vector, sign: float = 1.0, offset: float = 0.0) -> Walk:
        """Pass a rotary axis whose zero is ``offset`` degrees off; it turns by ``sign``."""
        x, y, z = self._turned(direction)
        turned = sign * x, sign * y, sign * z
        self.joints.append(Joint(_FIRST_ROTARY + index, True, turned, self.position))
        self._turn(direction, sign * offset)
        return self

    def tool(self, direction: Vector = Z, *, uses_length: bool = True) -> Chain:
        """Return the chain with its tool here."""
        return Chain(
            tuple(self.joints),
            self.position,
            self._turned(direction),
            uses_length=uses_length,
        )

    def _turned(self, vector: Vector) -> Vector:
        first, second, third = self.rows
        x, y, z = vector
        return (
            first[0] * x + first[1] * y + first[2] * z,
            second[0] * x + second[1] * y + second[2] * z,
            third[0] * x + third[1] * y + third[2] * z,
        )

    def _turn(self, axis: Vector, angle: float) -> None:
        """Turn the following parts about an axis."""
        columns = [self._turned(_rotated(column, axis, angle)) for column in (X, Y, Z)]
        first, second, third = columns
        self.rows = (
            (first[0], second[0], third[0]),
            (first[1], second[1], third[1]),
            (first[2], second[2], third[2]),
        )


def _rotated(vector: Vector, axis: Vector, angle: float) -> Vector:
    """Return a vector turned about an axis of length 1."""
    cosine, sine = arithmetic.cosine(angle), arithmetic.sine(angle)
    (x, y, z), (a, b, c) = vector, axis
    along = (a * x + b * y + c * z) * (1.0 - cosine)
    return (
        x * cosine + (b * z - c * y) * sine + a * along,
        y * cosine + (c * x - a * z) * sine + b * along,
        z * cosine + (a * y - b * x) * sine + c * along,
    )


def _head_ca(hd: Parameters) -> Chain:
    """Type 9: head C A."""
    walk = Walk().linear().move(hd(7), hd(8), 0.0).rotary(0, Z, offset=hd(4))
    walk.move(hd(6), hd(5), -hd(2)).rotary(1, X, offset=hd(3))
    return walk.move(0.0, hd(9), -hd(1)).tool()


def _saw_head(hd: Parameters) -> Chain:
    """Type 10: saw head C A; the blade's axis is Y."""
    walk = Walk().linear().move(hd(7), hd(8), 0.0).rotary(0, Z, offset=hd(5))
    walk.move(0.0, 0.0, -hd(3)).rotary(1, X, offset=hd(4))
    return walk.move(0.0, -hd(2), 0.0).tool(Y)


def _head_ba(hd: Parameters) -> Chain:
    """Type 16: head B A."""
    walk = Walk().linear().rotary(0, Y, hd.sign(10), hd(8))
    walk.move(hd(2), hd(3), -hd(4)).rotary(1, X, hd.sign(9), hd(7))
    return walk.move(hd(5), hd(6), -hd(1)).tool()


def _table_xy_head_ab(hd: Parameters) -> Chain:
    """Type 22: X Y in the table, head A B."""
    walk = Walk().linear().rotary(0, X, hd.sign(4)).rotary(1, Y, hd.sign(5))
    return walk.move(0.0, 0.0, -hd(1)).tool()


def _table_b_tool_a(hd: Parameters) -> Chain:
    """Type 23: X Y B in the table, A in the tool; the channel's axes are X Y Z A B."""
    walk = Walk().move(0.0, 0.0, -hd(2)).rotary(1, Y, -hd.sign(5))
    walk.move(0.0, 0.0, hd(2)).linear().rotary(0, X, hd.sign(4))
    return walk.move(0.0, 0.0, -hd(1)).tool()


def _tool_a(hd: Parameters) -> Chain:
    """Type 30: A in the tool."""
    walk = Walk().linear().move(-hd(6), -hd(7), -hd(8)).rotary(0, X, hd.sign(4), hd(5))
    return walk.move(-hd(2), -hd(3), -hd(1)).tool()


def _oblique_head(hd: Parameters) -> Chain:
    """Type 33: oblique head C A whose axes meet in the tool's tip; C and A are those of a head CA.

    The axis A is at the angle HD3 to C: at 90° along X.
    """
    oblique = arithmetic.sine(hd(3)), 0.0, arithmetic.cosine(hd(3))
    walk = Walk().linear().move(hd(4), hd(5), hd(6))
    walk.rotary(0, Z, offset=180.0 if hd(7) != 0.0 else 0.0).rotary(1, oblique)
    chain = walk.tool(uses_length=False)
    angles = ProgrammedAngles(_FIRST_ROTARY, _FIRST_ROTARY + 1, Z, X)
    return Chain(chain.joints, chain.tool, chain.tool_direction, angles, uses_length=False)


def _table_c(hd: Parameters) -> Chain:
    """Type 34: X and C in the table."""
    walk = Walk().move(hd(2), hd(3), 0.0).rotary(0, Z, -1.0)
    return walk.move(-hd(2), -hd(3), 0.0).linear().tool()


def _tube_head(hd: Parameters) -> Chain:
    """Type 90: heads for tubes, two rotary axes by HD13."""
    letters = _TUBE_HEADS[round(hd(13) * _UNITS)]
    first, second = (DIRECTIONS[letter] for letter in letters)
    walk = Walk().linear().move(hd(7) - hd(4), hd(8) - hd(5), hd(9) - hd(6))
    walk.rotary(0, first, hd.sign(15), hd(17)).move(hd(4), hd(5), hd(6))
    walk.rotary(1, second, hd.sign(16), hd(18))
    return walk.move(hd(2), hd(3), -hd(1)).tool()


FIXED_TYPES: Mapping[int, Callable[[Parameters], Chain]] = {
    9: _head_ca,
    10: _saw_head,
    16: _head_ba,
    22: _table_xy_head_ab,
    23: _table_b_tool_a,
    30: _tool_a,
    33: _oblique_head,
    34: _table_c,
    90: _tube_head,
}


def has_tube_head(values: Mapping[int, float]) -> bool:
    """Return whether HD13 names a head of type 90 whose geometry is published."""
    return values.get(12, 0.0) in _TUBE_HEADS


def fixed_chain(type_: int, values: Mapping[int, float]) -> Chain:
    """Return the chain of a fixed type with its parameters in the units of the lists."""
    return FIXED_TYPES[type_](Parameters(values))


def universal_chain(kinematic: UniversalKinematic, axis_names: Sequence[str]) -> Chain:
    """Return the chain of a kinematic of type 91; ``axis_names``: those of the channel's axes."""
    joints = tuple(
        Joint(index, axis.is_rotary, unit(axis.direction), axis.point)
        for index in kinematic.chain
        for axis in (kinematic.axes[index],)
    )
    return Chain(
        joints,
        kinematic.zero_position,
        unit(kinematic.zero_orientation),
        programmed_angles(kinematic, axis_names),
        kinematic.programming_mode == POINT_VECTOR,
        kinematic.linkage,
    )


def programmed_angles(
    kinematic: UniversalKinematic, axis_names: Sequence[str]
) -> ProgrammedAngles | None:
    """Return the words programmed for the tool's direction; ``None``: the rotary axes themselves.

    The angles are those of the rotary axes whose names begin with the letters of the mode; without
    such names they go by the index of the axis.
    """
    letters = CLASSIC_MODES.get(kinematic.programming_mode, "")
    rotary = sorted(kinematic.rotary)
    if kinematic.is_rtcp or not letters or len(rotary) < 2:
        return None
    places = {axis_names[index][:1].upper(): index for index in rotary}
    if sorted(places) == sorted(letters):
        rotary = [places[letter] for letter in letters]
    first, second = (DIRECTIONS[letter] for letter in letters)
    return ProgrammedAngles(rotary[0], rotary[1], first, second)
