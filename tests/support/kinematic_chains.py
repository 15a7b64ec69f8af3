# SPDX-License-Identifier: MIT
"""Random chains and poses, and what they are as products of 4×4 matrices."""

from __future__ import annotations

import math
import random
from collections.abc import Sequence

import numpy as np

from nctakt.decoder.kinematics.chain import (
    DIRECTIONS,
    Chain,
    Joint,
    ProgrammedAngles,
    Vector,
    X,
    Y,
    Z,
    map_values,
    unit,
)
from nctakt.kernel.kinematics import map_rows
from nctakt.kernel.kinematics.maps import KinematicMaps

AXES = 8


def doubles(values: Sequence[float]) -> memoryview:
    """Return values as the realtime part wants them, with room for all axes."""
    row = memoryview(bytearray(8 * AXES)).cast("d")
    for i, value in enumerate(values):
        row[i] = value
    return row


class Map:
    """The map of one chain, over lists."""

    def __init__(
        self, chain: Chain, length: float = 0.0, axis_count: int = 6, second: Chain | None = None
    ) -> None:
        self.maps = KinematicMaps(AXES)
        row = map_values(chain, range(axis_count), length)
        if second is not None:
            further = map_values(second, range(axis_count), 0.0)
            row[map_rows.SECOND_STEP] = self.maps.add(further)
        self.number = self.maps.add(row)
        self.axis_count = axis_count

    def forward(self, positions: Sequence[float], near: Sequence[float] = ()) -> list[float]:
        """Return the tool's positions."""
        results = doubles([])
        self.maps.forward(self.number, doubles(positions), doubles(near), results)
        return list(results)[: self.axis_count]

    def inverse(self, positions: Sequence[float], near: Sequence[float]) -> list[float]:
        """Return the axes' positions."""
        results = doubles([])
        assert self.answer(positions, near, results) == 0
        return list(results)[: self.axis_count]

    def answer(
        self, positions: Sequence[float], near: Sequence[float], results: memoryview | None = None
    ) -> int:
        """Return what ``inverse`` answers."""
        where = doubles([]) if results is None else results
        return self.maps.inverse(self.number, doubles(positions), doubles(near), where)

    def direction(self, positions: Sequence[float]) -> list[float]:
        """Return the tool's direction."""
        results = doubles([])
        self.maps.direction(self.number, doubles(positions), results)
        return list(results)[:3]


def motion(joint: Joint, position: float, moved: Sequence[float]) -> np.ndarray:
    """Return the 4×4 matrix of a joint; ``moved``: the ways of the linear joints by place."""
    matrix = np.eye(4)
    direction = np.array(joint.direction)
    if not joint.is_rotary:
        matrix[:3, 3] = direction * moved[joint.axis]
        return matrix
    a = math.radians(position)
    d_x, d_y, d_z = joint.direction
    skew = np.array([[0, -d_z, d_y], [d_z, 0, -d_x], [-d_y, d_x, 0]])
    rotation = np.eye(3) + math.sin(a) * skew + (1 - math.cos(a)) * (skew @ skew)
    point = np.array(joint.point)
    matrix[:3, :3] = rotation
    matrix[:3, 3] = point - rotation @ point
    return matrix


def pose(chain: Chain, length: float, positions: Sequence[float]) -> tuple[np.ndarray, np.ndarray]:
    """Return the tip and the direction of the tool by the product of matrices."""
    moved = np.array(positions[:3])
    if chain.linkage:
        moved = np.array(chain.linkage[:3]) @ moved + np.array(chain.linkage[3])
    whole = np.eye(4)
    for joint in chain.joints:
        whole = whole @ motion(joint, positions[joint.axis], moved)
    direction = np.array(chain.tool_direction)
    tip = np.array(chain.tool) - length * direction
    return (whole @ np.append(tip, 1.0))[:3], whole[:3, :3] @ direction


def classic_direction(letters: str, first: float, second: float) -> np.ndarray:
    """Return the tool's direction of an ideal chain of two rotary axes."""
    joints = [Joint(3 + i, True, DIRECTIONS[letter]) for i, letter in enumerate(letters)]
    whole = motion(joints[0], first, ()) @ motion(joints[1], second, ())
    return whole[:3, :3] @ np.array(DIRECTIONS[letters[0]])


def random_direction(numbers: random.Random) -> Vector:
    """Return a direction of length 1."""
    while True:
        x, y, z = (numbers.uniform(-1.0, 1.0) for _ in range(3))
        if 0.01 < x * x + y * y + z * z <= 1.0:
            return unit((x, y, z))


def random_linear(numbers: random.Random) -> tuple[Vector, Vector, Vector]:
    """Return three directions that are far from one plane; often those of the machine."""
    if numbers.random() < 0.5:
        return X, Y, Z
    while True:
        rows = tuple(random_direction(numbers) for _ in range(3))
        if abs(np.linalg.det(np.array(rows))) > 0.3:
            return rows[0], rows[1], rows[2]


def random_chain(numbers: random.Random, rotary_count: int) -> Chain:
    """Return a chain with its joints in any order (RTCP)."""
    reach = 500.0

    def point() -> Vector:
        x, y, z = (numbers.uniform(-reach, reach) for _ in range(3))
        return x, y, z

    joints = [Joint(i, False, direction) for i, direction in enumerate(random_linear(numbers))]
    for i in range(rotary_count):
        direction = numbers.choice([X, Y, Z, random_direction(numbers)])
        joints.append(Joint(3 + i, True, direction, point()))
    numbers.shuffle(joints)
    linkage: tuple[Vector, ...] = ()
    if numbers.random() < 0.2:
        linkage = (*random_linear(numbers), point())
    return Chain(tuple(joints), point(), random_direction(numbers), linkage=linkage)


def pointed_chain(numbers: random.Random) -> Chain:
    """Return a chain whose two rotary axes both turn the tool."""
    while True:
        chain = random_chain(numbers, 2)
        first, second = (np.array(joint.direction) for joint in chain.rotary)
        tool = np.array(chain.tool_direction)
        if abs(first @ second) < 0.9 and abs(second @ tool) < 0.9:
            return chain


def with_angles(chain: Chain, letters: str) -> Chain:
    """Return the chain with programmed angles of an ideal one (complete)."""
    angles = ProgrammedAngles(3, 4, DIRECTIONS[letters[0]], DIRECTIONS[letters[1]])
    return Chain(chain.joints, chain.tool, chain.tool_direction, angles, False, chain.linkage)


def with_vector(chain: Chain) -> Chain:
    """Return the chain with a programmed vector (complete)."""
    return Chain(chain.joints, chain.tool, chain.tool_direction, None, True, chain.linkage)
