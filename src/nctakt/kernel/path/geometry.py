# SPDX-License-Identifier: MIT
"""The geometry of a segment: positions after a distance, and stages.

A segment is a row over ``count`` axes (``rows.py``) that begins at ``row``, in the channel's queue
and in the path's history.

The stages of a segment, each with separate limits: entry zone, middle, exit zone, curve. In the
zones the path keeps acceleration in reserve for the step in speed at the corner. The curve is a
parabola, so that an axis changes its speed evenly on it; its length counts at the speed that the
path has at its two ends.

A rounding is a separate segment between two lines with a jerk limit: its direction changes as a
parabola up to the middle, then as its mirror image, so that an axis changes its acceleration evenly
and has none but the path's at either end. Its length counts as that of the curve.
"""

from __future__ import annotations

from nctakt.kernel import codes, rows
from nctakt.kernel.base import arithmetic
from nctakt.kernel.path import cubic


def total_length(segments: memoryview[float], row: int) -> float:
    """Length of all stages, in mm (degrees where only rotary axes move)."""
    return segments[row + rows.LENGTH] + segments[row + rows.CURVE_HALF]


def length_with_rounding(segments: memoryview[float], row: int) -> float:
    """Length of all stages and of the rounding that follows."""
    return total_length(segments, row) + segments[row + rows.ROUNDING_LENGTH]


def end_column(segments: memoryview[float], row: int, count: int) -> int:
    """Column of the positions at the end of all stages: target, or end of the curve."""
    target = row + rows.START + count
    return target + count if segments[row + rows.CURVE_HALF] > 0.0 else target


def pieces(segments: memoryview[float], row: int) -> int:
    """Number of pieces of an arc whose limits go by its angle; 0: no such arc."""
    return int(segments[row + rows.ARC_PIECES])


def moves_axis(segments: memoryview[float], row: int, count: int, i: int) -> int:
    """Return whether a segment, or the curve after it, moves its axis ``i``."""
    start = row + rows.START + i
    target = start + count
    if segments[start] != segments[target]:
        return 1
    if segments[row + rows.SHAPE] == rows.ARC:
        if segments[row + rows.ARC_FIRST_AXIS] == i or segments[row + rows.ARC_SECOND_AXIS] == i:
            return 1
    curve_end = target + count
    if segments[row + rows.CURVE_HALF] > 0.0 and segments[curve_end] != segments[target]:
        return 1
    if segments[row + rows.SHAPE] == rows.ROUNDING:
        return 1 if segments[curve_end + count] != segments[target] else 0
    return cubic.moves_axis(segments, row, count, i) if cubic.is_cubic(segments, row) else 0


def stage_length(segments: memoryview[float], row: int, stage: int) -> float:
    """Length of one stage."""
    if stage == codes.ENTRY_ZONE:
        return segments[row + rows.ENTRY_LENGTH]
    if stage == codes.EXIT_ZONE:
        return segments[row + rows.EXIT_LENGTH]
    if stage == codes.CURVE:
        return 2.0 * segments[row + rows.CURVE_HALF]
    length = (
        segments[row + rows.LENGTH]
        - segments[row + rows.ENTRY_LENGTH]
        - segments[row + rows.EXIT_LENGTH]
    )
    return length - segments[row + rows.CURVE_HALF]


def stage_acceleration(segments: memoryview[float], row: int, stage: int) -> float:
    """Acceleration along the path in a stage, per s²."""
    if stage == codes.ENTRY_ZONE:
        return segments[row + rows.ENTRY_ACCELERATION]
    if stage == codes.EXIT_ZONE:
        return segments[row + rows.EXIT_ACCELERATION]
    if stage == codes.CURVE:
        return segments[row + rows.CURVE_ACCELERATION]
    return segments[row + rows.ACCELERATION]


def entry_speed(
    segments: memoryview[float], row: int, stage: int, end_v: float, limit_v: float
) -> float:
    """The highest speed at the begin of ``stage`` from which ``end_v`` is reached at the end."""
    speed2 = end_v * end_v
    if segments[row + rows.CURVE_HALF] > 0.0 and stage <= codes.CURVE:
        curve_v = min(limit_v, segments[row + rows.CURVE_SPEED])
        gained2 = 4.0 * segments[row + rows.CURVE_HALF] * segments[row + rows.CURVE_ACCELERATION]
        speed2 = min(speed2 + gained2, curve_v * curve_v)
    if stage <= codes.EXIT_ZONE:
        speed2 += 2.0 * segments[row + rows.EXIT_LENGTH] * segments[row + rows.EXIT_ACCELERATION]
    if stage <= codes.MIDDLE:
        speed2 += (
            2.0 * stage_length(segments, row, codes.MIDDLE) * segments[row + rows.ACCELERATION]
        )
    if stage == codes.ENTRY_ZONE:
        speed2 += 2.0 * segments[row + rows.ENTRY_LENGTH] * segments[row + rows.ENTRY_ACCELERATION]
    return min(arithmetic.square_root(speed2), limit_v)


def locate(
    segments: memoryview[float], row: int, count: int, distance: float, positions: memoryview[float]
) -> None:
    """Put the position of each axis after ``distance`` into ``positions``; exact at both ends."""
    start = row + rows.START
    target = start + count
    if distance <= 0.0 or distance >= total_length(segments, row):
        end = start if distance <= 0.0 else end_column(segments, row, count)
        for i in range(count):
            positions[i] = segments[end + i]
        return
    if segments[row + rows.CURVE_HALF] > 0.0:
        if distance > segments[row + rows.LENGTH] - segments[row + rows.CURVE_HALF]:
            locate_on_curve(segments, row, count, distance, positions)
            return
    if segments[row + rows.SHAPE] == rows.ROUNDING:
        locate_on_rounding(segments, row, count, distance, positions)
        return
    part = distance / segments[row + rows.LENGTH]
    if segments[row + rows.SHAPE] == rows.CUBIC:
        cubic.locate(segments, row, count, part, positions)
        return
    for i in range(count):
        begin = segments[start + i]
        positions[i] = begin + (segments[target + i] - begin) * part
    if segments[row + rows.SHAPE] == rows.ARC:
        first = int(segments[row + rows.ARC_FIRST_AXIS])
        second = int(segments[row + rows.ARC_SECOND_AXIS])
        angle = segments[row + rows.ARC_ANGLE] * part
        cosine = arithmetic.cosine(angle)
        sine = arithmetic.sine(angle)
        x = segments[start + first] - segments[row + rows.ARC_FIRST_CENTRE]
        y = segments[start + second] - segments[row + rows.ARC_SECOND_CENTRE]
        positions[first] = segments[row + rows.ARC_FIRST_CENTRE] + x * cosine - y * sine
        positions[second] = segments[row + rows.ARC_SECOND_CENTRE] + x * sine + y * cosine


def locate_on_curve(
    segments: memoryview[float], row: int, count: int, distance: float, positions: memoryview[float]
) -> None:
    """``locate`` on the curve: a parabola with the target as its control point."""
    start = row + rows.START
    target = start + count
    curve_end = target + count
    half = segments[row + rows.CURVE_HALF]
    length = segments[row + rows.LENGTH]
    part = (distance - (length - half)) / (2.0 * half)
    for i in range(count):
        corner = segments[target + i]
        before = (segments[start + i] - corner) * half / length
        after = segments[curve_end + i] - corner
        positions[i] = corner + (1.0 - part) * (1.0 - part) * before + part * part * after


def locate_on_rounding(
    segments: memoryview[float], row: int, count: int, distance: float, positions: memoryview[float]
) -> None:
    """``locate`` on a rounding: from its nearer end along the line there, and off it as length³."""
    start = row + rows.START
    target = start + count
    corners = target + count + count
    part = distance / segments[row + rows.LENGTH]
    is_far_half = part > 0.5
    if is_far_half:
        part = 1.0 - part
    off = part * part * part * 1.3333333333333333
    for i in range(count):
        near = segments[start + i]
        far = segments[target + i]
        if is_far_half:
            far = near
            near = segments[target + i]
        corner = segments[corners + i]
        positions[i] = near + 2.0 * part * (corner - near) + off * (near + far - 2.0 * corner)


def tangent(
    segments: memoryview[float], row: int, count: int, at_end: int, directions: memoryview[float]
) -> None:
    """Put each axis' part of the length, at start or target, into ``directions``."""
    start = row + rows.START
    target = start + count
    length = segments[row + rows.LENGTH]
    for i in range(count):
        directions[i] = (segments[target + i] - segments[start + i]) / length
    if segments[row + rows.SHAPE] == rows.ARC:
        first = int(segments[row + rows.ARC_FIRST_AXIS])
        second = int(segments[row + rows.ARC_SECOND_AXIS])
        end = target if at_end else start
        turn = segments[row + rows.ARC_ANGLE] * 0.017453292519943295 / length
        directions[first] = (segments[row + rows.ARC_SECOND_CENTRE] - segments[end + second]) * turn
        directions[second] = (segments[end + first] - segments[row + rows.ARC_FIRST_CENTRE]) * turn


def curvature(
    segments: memoryview[float], row: int, count: int, at_end: int, curvatures: memoryview[float]
) -> None:
    """Put the change of ``tangent`` per length into ``curvatures``: 0 on a line."""
    for i in range(count):
        curvatures[i] = 0.0
    if segments[row + rows.SHAPE] == rows.ARC:
        first = int(segments[row + rows.ARC_FIRST_AXIS])
        second = int(segments[row + rows.ARC_SECOND_AXIS])
        end = row + rows.START + (count if at_end else 0)
        turn = segments[row + rows.ARC_ANGLE] * 0.017453292519943295 / segments[row + rows.LENGTH]
        curvatures[first] = (
            (segments[row + rows.ARC_FIRST_CENTRE] - segments[end + first]) * turn * turn
        )
        curvatures[second] = (
            (segments[row + rows.ARC_SECOND_CENTRE] - segments[end + second]) * turn * turn
        )
