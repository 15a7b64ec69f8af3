# SPDX-License-Identifier: MIT
"""Range checks for the rows of kinematic maps: the ticks read them without a check."""

from __future__ import annotations

from nctakt.kernel.base.bounds import check_finite, check_range
from nctakt.kernel.kinematics import map_rows


def check_map(row: list[float], axis_count: int) -> None:
    """Raise ``ValueError`` unless every index of a map is in range and every number finite."""
    for value in row:
        check_finite(value, "number of a map")
    check_column(row, map_rows.SLOT, 0, axis_count - 1)
    check_column(row, map_rows.AXIS_COUNT, map_rows.VECTOR_X, axis_count)
    check_column(row, map_rows.PROGRAMMING, map_rows.MACHINE_ANGLES, map_rows.LATERAL)
    if row[map_rows.PROGRAMMING] == map_rows.VECTOR:
        check_column(row, map_rows.AXIS_COUNT, map_rows.VECTOR_Z + 1, axis_count)
    places = int(row[map_rows.AXIS_COUNT])
    is_chain = row[map_rows.PROGRAMMING] < map_rows.FACE_PLANE
    fewest = map_rows.VECTOR_X if is_chain else 1
    check_column(row, map_rows.JOINT_COUNT, fewest, map_rows.MAX_JOINTS)
    count = int(row[map_rows.JOINT_COUNT])
    check_column(row, map_rows.LEADING_COUNT, 0, count)
    check_column(row, map_rows.TRAILING_FIRST, 0, count)
    check_column(row, map_rows.FIRST_PLACE, 0, places - 1)
    check_column(row, map_rows.SECOND_PLACE, 0, places - 1)
    check_column(row, map_rows.FIRST_JOINT, 0, map_rows.MAP_WIDTH - map_rows.JOINT_WIDTH)
    check_column(row, map_rows.SECOND_JOINT, 0, map_rows.MAP_WIDTH - map_rows.JOINT_WIDTH)
    for k in range(count):
        joint = map_rows.JOINTS + k * map_rows.JOINT_WIDTH
        check_column(row, joint + map_rows.JOINT_MEMBER, 0, axis_count - 1)
        last = places - 1 if row[joint + map_rows.JOINT_IS_ROTARY] else map_rows.Z
        check_column(row, joint + map_rows.JOINT_AXIS, 0, last)


def check_column(row: list[float], column: int, low: int, high: int) -> None:
    """Raise ``ValueError`` unless a column of a map is an integer in ``low`` … ``high``."""
    check_range(int(row[column]), low, high, "number of a map")
