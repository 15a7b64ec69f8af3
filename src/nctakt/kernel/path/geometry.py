# SPDX-License-Identifier: MIT
"""The geometry of a segment: where the axes are after a way, and which stages the way has.

A segment is a row over ``count`` axes (``rows.py``) that begins at ``base``, in the channel's queue
and in the path's ring.

The stages of the way, each with its own limits: entry zone, middle, exit zone, curve. In the zones
the path keeps acceleration in reserve for the step in speed at the corner. The curve is a parabola,
so that an axis changes its speed evenly on it; its way counts at the speed that the path has at its
two ends.

A rounding is a segment of its own between two lines with a limit of the jerk: its direction changes
as a parabola up to the middle, then as its mirror image, so that an axis changes its acceleration
evenly and has none but the path's at either end. Its way counts as that of the curve.
"""

from __future__ import annotations

from nctakt.kernel import codes, rows
from nctakt.kernel.base import arithmetic


def whole_way(row: memoryview[float], base: int) -> float:
    """The way of all stages."""
    return row[base + rows.LENGTH] + row[base + rows.CURVE_HALF]


def way_with_rounding(row: memoryview[float], base: int) -> float:
    """``whole_way``, with that of the rounding that follows."""
    return whole_way(row, base) + row[base + rows.ROUNDING_LENGTH]


def end_column(row: memoryview[float], base: int, count: int) -> int:
    """Where the positions at the end of all stages stand: the targets, or the curve's end."""
    target = base + rows.START + count
    return target + count if row[base + rows.CURVE_HALF] > 0.0 else target


def pieces(row: memoryview[float], base: int) -> int:
    """Into how many pieces an arc is divided whose limits go by its angle: 0 none, or no arc."""
    return int(row[base + rows.ARC_PIECES])


def moves(row: memoryview[float], base: int, count: int, i: int) -> int:
    """Whether a segment moves its axis ``i``: on its way, or on the curve behind it."""
    start = base + rows.START + i
    target = start + count
    if row[start] != row[target]:
        return 1
    if row[base + rows.SHAPE] == rows.ARC:
        if row[base + rows.ARC_FIRST_AXIS] == i or row[base + rows.ARC_SECOND_AXIS] == i:
            return 1
    curve_end = target + count
    if row[base + rows.CURVE_HALF] > 0.0 and row[curve_end] != row[target]:
        return 1
    if row[base + rows.SHAPE] == rows.ROUNDING:
        return 1 if row[curve_end + count] != row[target] else 0
    return 0


def stage_way(row: memoryview[float], base: int, stage: int) -> float:
    """The way of one stage."""
    if stage == codes.ENTRY_ZONE:
        return row[base + rows.ENTRY_LENGTH]
    if stage == codes.EXIT_ZONE:
        return row[base + rows.EXIT_LENGTH]
    if stage == codes.CURVE:
        return 2.0 * row[base + rows.CURVE_HALF]
    length = row[base + rows.LENGTH] - row[base + rows.ENTRY_LENGTH] - row[base + rows.EXIT_LENGTH]
    return length - row[base + rows.CURVE_HALF]


def stage_acceleration(row: memoryview[float], base: int, stage: int) -> float:
    """The acceleration along the path in a stage."""
    if stage == codes.ENTRY_ZONE:
        return row[base + rows.ENTRY_ACCELERATION]
    if stage == codes.EXIT_ZONE:
        return row[base + rows.EXIT_ACCELERATION]
    if stage == codes.CURVE:
        return row[base + rows.CURVE_ACCELERATION]
    return row[base + rows.ACCELERATION]


def entry_speed(
    row: memoryview[float], base: int, stage: int, end_v: float, limit_v: float
) -> float:
    """The highest speed at the begin of ``stage`` from which ``end_v`` is reached at the end."""
    speed2 = end_v * end_v
    if row[base + rows.CURVE_HALF] > 0.0 and stage <= codes.CURVE:
        curve_v = min(limit_v, row[base + rows.CURVE_SPEED])
        gained2 = 4.0 * row[base + rows.CURVE_HALF] * row[base + rows.CURVE_ACCELERATION]
        speed2 = min(speed2 + gained2, curve_v * curve_v)
    if stage <= codes.EXIT_ZONE:
        speed2 += 2.0 * row[base + rows.EXIT_LENGTH] * row[base + rows.EXIT_ACCELERATION]
    if stage <= codes.MIDDLE:
        speed2 += 2.0 * stage_way(row, base, codes.MIDDLE) * row[base + rows.ACCELERATION]
    if stage == codes.ENTRY_ZONE:
        speed2 += 2.0 * row[base + rows.ENTRY_LENGTH] * row[base + rows.ENTRY_ACCELERATION]
    return min(arithmetic.square_root(speed2), limit_v)


def locate(
    row: memoryview[float], base: int, count: int, way: float, places: memoryview[float]
) -> None:
    """Put where each axis is after ``way`` into ``places``; at both ends bit by bit."""
    start = base + rows.START
    target = start + count
    if way <= 0.0 or way >= whole_way(row, base):
        end = start if way <= 0.0 else end_column(row, base, count)
        for i in range(count):
            places[i] = row[end + i]
        return
    if row[base + rows.CURVE_HALF] > 0.0:
        if way > row[base + rows.LENGTH] - row[base + rows.CURVE_HALF]:
            locate_on_curve(row, base, count, way, places)
            return
    if row[base + rows.SHAPE] == rows.ROUNDING:
        locate_on_rounding(row, base, count, way, places)
        return
    part = way / row[base + rows.LENGTH]
    for i in range(count):
        begin = row[start + i]
        places[i] = begin + (row[target + i] - begin) * part
    if row[base + rows.SHAPE] == rows.ARC:
        first = int(row[base + rows.ARC_FIRST_AXIS])
        second = int(row[base + rows.ARC_SECOND_AXIS])
        angle = row[base + rows.ARC_ANGLE] * part
        cosine = arithmetic.cosine(angle)
        sine = arithmetic.sine(angle)
        x = row[start + first] - row[base + rows.ARC_FIRST_CENTRE]
        y = row[start + second] - row[base + rows.ARC_SECOND_CENTRE]
        places[first] = row[base + rows.ARC_FIRST_CENTRE] + x * cosine - y * sine
        places[second] = row[base + rows.ARC_SECOND_CENTRE] + x * sine + y * cosine


def locate_on_curve(
    row: memoryview[float], base: int, count: int, way: float, places: memoryview[float]
) -> None:
    """``locate`` on the curve: a parabola with the target as its control point."""
    start = base + rows.START
    target = start + count
    curve_end = target + count
    half = row[base + rows.CURVE_HALF]
    length = row[base + rows.LENGTH]
    part = (way - (length - half)) / (2.0 * half)
    for i in range(count):
        corner = row[target + i]
        before = (row[start + i] - corner) * half / length
        behind = row[curve_end + i] - corner
        places[i] = corner + (1.0 - part) * (1.0 - part) * before + part * part * behind


def locate_on_rounding(
    row: memoryview[float], base: int, count: int, way: float, places: memoryview[float]
) -> None:
    """``locate`` on a rounding: from its nearer end along the line there, and off it as way³."""
    start = base + rows.START
    target = start + count
    corners = target + count + count
    part = way / row[base + rows.LENGTH]
    is_behind = part > 0.5
    if is_behind:
        part = 1.0 - part
    off = part * part * part * 1.3333333333333333
    for i in range(count):
        near = row[start + i]
        far = row[target + i]
        if is_behind:
            far = near
            near = row[target + i]
        corner = row[corners + i]
        places[i] = near + 2.0 * part * (corner - near) + off * (near + far - 2.0 * corner)


def direct(
    row: memoryview[float], base: int, count: int, at_end: int, ways: memoryview[float]
) -> None:
    """Put the way of each axis per way of the path, at start or target, into ``ways``."""
    start = base + rows.START
    target = start + count
    length = row[base + rows.LENGTH]
    for i in range(count):
        ways[i] = (row[target + i] - row[start + i]) / length
    if row[base + rows.SHAPE] == rows.ARC:
        first = int(row[base + rows.ARC_FIRST_AXIS])
        second = int(row[base + rows.ARC_SECOND_AXIS])
        end = target if at_end else start
        turn = row[base + rows.ARC_ANGLE] * 0.017453292519943295 / length
        ways[first] = (row[base + rows.ARC_SECOND_CENTRE] - row[end + second]) * turn
        ways[second] = (row[end + first] - row[base + rows.ARC_FIRST_CENTRE]) * turn


def curve(
    row: memoryview[float], base: int, count: int, at_end: int, turns: memoryview[float]
) -> None:
    """Put the change of ``direct`` per way, at start or target, into ``turns``: 0 on a line."""
    for i in range(count):
        turns[i] = 0.0
    if row[base + rows.SHAPE] == rows.ARC:
        first = int(row[base + rows.ARC_FIRST_AXIS])
        second = int(row[base + rows.ARC_SECOND_AXIS])
        end = base + rows.START + (count if at_end else 0)
        turn = row[base + rows.ARC_ANGLE] * 0.017453292519943295 / row[base + rows.LENGTH]
        turns[first] = (row[base + rows.ARC_FIRST_CENTRE] - row[end + first]) * turn * turn
        turns[second] = (row[base + rows.ARC_SECOND_CENTRE] - row[end + second]) * turn * turn
