# SPDX-License-Identifier: MIT
"""Planes that turn with a rotary axis: the face of a turned part, and its cylinder (MO-8).

On the face the first axis and the rotary axis have a place x, y in mm: the radial axis is at the
distance from the axis of rotation, the rotary axis at the angle. The second column of ``TOOL`` is
the tool's offset across the line of the radial axis, the first its offset along it. On the cylinder
the rotary axis has a length on the surface: the first column of ``MATRIX`` is its degrees per mm,
that of ``SHIFT`` its angle at 0.
"""

from __future__ import annotations

from nctakt.kernel.base import arithmetic
from nctakt.kernel.kinematics import map_rows


def to_plane(
    values: memoryview[float], row: int, positions: memoryview[float], results: memoryview[float]
) -> None:
    """Put the place in the plane into ``results``, from positions of the axes."""
    rotary = int(values[row + map_rows.SECOND_PLACE])
    if values[row + map_rows.PROGRAMMING] == map_rows.LATERAL:
        angle = positions[rotary] - values[row + map_rows.SHIFT]
        results[rotary] = angle / values[row + map_rows.MATRIX]
        return
    radial = int(values[row + map_rows.FIRST_PLACE])
    along = positions[radial] - values[row + map_rows.TOOL]
    beside = values[row + map_rows.TOOL + map_rows.Y]
    cosine = arithmetic.cosine(positions[rotary])
    sine = arithmetic.sine(positions[rotary])
    results[radial] = along * cosine - beside * sine
    results[rotary] = along * sine + beside * cosine


def to_axes(
    values: memoryview[float],
    row: int,
    positions: memoryview[float],
    near: memoryview[float],
    results: memoryview[float],
) -> int:
    """Put the positions of the axes into ``results``; return as ``KinematicMaps.inverse``.

    The rotary axis turns the short way from ``near``; in its centre it stays.
    """
    rotary = int(values[row + map_rows.SECOND_PLACE])
    if values[row + map_rows.PROGRAMMING] == map_rows.LATERAL:
        angle = positions[rotary] * values[row + map_rows.MATRIX]
        results[rotary] = angle + values[row + map_rows.SHIFT]
        return map_rows.REACHED
    radial = int(values[row + map_rows.FIRST_PLACE])
    beside = values[row + map_rows.TOOL + map_rows.Y]
    x = positions[radial]
    y = positions[rotary]
    along2 = x * x + y * y - beside * beside
    if along2 < 0.0:
        return map_rows.OUT_OF_REACH
    along = arithmetic.square_root(along2)
    results[radial] = along + values[row + map_rows.TOOL]
    results[rotary] = near[rotary]
    if x != 0.0 or y != 0.0:
        angle = arithmetic.arc_tangent_2(y, x)
        if beside != 0.0:
            angle -= arithmetic.arc_tangent_2(beside, along)
        turns = arithmetic.floor((near[rotary] - angle) / 360.0 + 0.5)
        results[rotary] = angle + 360.0 * turns
    return map_rows.REACHED
