# SPDX-License-Identifier: MIT
"""The geometry of a segment: where the axes are after a way, and which stages the way has.

A segment is a row of float64 over ``count`` axes, in the channel's queue and in the path's ring:

====== =============================================================================
0 … 3  kind, source ID, block number, way from start to target
4 … 6  programmed speed, highest speed, acceleration
7, 8   end speed, exact stop: 1, or below 0: the block goes on with the next segment (in the path's
       ring -1 less what ``Path.leave_rest`` tells)
9      shape: 0 line, 1 arc, 2 bend: a curve that rounds a corner with a limit of the jerk
10     jerk, 0: speed is a trapezoid
11     the highest speed at which its end may be passed
12 …   start of each axis, then target of each axis, then from ``t = 12 + 2 * count`` on:
t      way of the entry zone, of the exit zone
t + 2  acceleration in the entry zone, in the exit zone
t + 4  half the way of the curve that rounds the corner at the target (0: none)
t + 5  highest speed and acceleration on this curve; with a jerk, where a bend follows: its way, and
       acceleration and jerk on it (t + 5 … 7)
t + 7  arc: the plane's first and second axis, centre in them, angle in degrees
t + 12 programmed speed of the next segment (0: none; below 0: the operator's override has no effect
       on it), end speed without regard to feeds
t + 14 how many commands before it the segment stands that it continues (0: none)
t + 15 with a jerk: way from its end to the place that the path has to slow down for, the speed
       there, acceleration and jerk on this way (``jerk_lookahead.py``)
t + 19 with a jerk: acceleration and jerk that the segments behind it allow on it, and whether the
       speed at t + 16 is a feed: 1, or 2 where the operator's override has no effect on it
t + 17 without a jerk, on an arc whose limits go by its angle: number of pieces (0: there is one
       acceleration for all of it), share of the acceleration that corners use at its begin, at
       its end, all along (``arc_limits.py``), speed at which it is walked backward
t + 22 with a curve: where it ends, each axis; bend: the corner that it rounds
last 4 pace, all 0 without one: programmed override as a factor, whether the operator's has no
       effect, spindle whose speed its feed follows, counted from 1, and that speed in degrees/s
====== =============================================================================

The stages of the way, each with its own limits: 0 entry zone, 1 middle, 2 exit zone, 3 curve. In
the zones the path keeps acceleration in reserve for the step in speed at the corner. The curve is
a parabola, so that an axis changes its speed evenly on it; its way counts at the speed that the
path has at its two ends.

A bend is a segment of its own between two lines with a limit of the jerk: its direction changes as
a parabola up to the middle, then as its mirror image, so that an axis changes its acceleration
evenly and has none but the path's at either end. Its way counts as that of the curve.
"""

from __future__ import annotations

from nctakt.kernel.base import arithmetic

#: Numbers in front of, and behind, the positions of a segment.
HEAD_WIDTH = 12
TAIL_WIDTH = 26


def width(count: int) -> int:
    """How many numbers a segment over so many axes has."""
    return HEAD_WIDTH + TAIL_WIDTH + 3 * count


def whole_way(row: memoryview[float], base: int, count: int) -> float:
    """The way of all stages."""
    return row[base + 3] + row[base + 12 + 2 * count + 4]


def way_with_bend(row: memoryview[float], base: int, count: int) -> float:
    """``whole_way``, with that of the bend that follows."""
    way = whole_way(row, base, count)
    return way + row[base + 17 + 2 * count] if row[base + 10] > 0.0 else way


def end_place(row: memoryview[float], base: int, count: int) -> int:
    """Where the positions at the end of all stages stand: the targets, or the curve's end."""
    place = base + 12 + count
    return place + count + 22 if row[place + count + 4] > 0.0 else place


def pieces(row: memoryview[float], base: int, count: int) -> int:
    """Into how many pieces an arc is divided whose limits go by its angle: 0 none, or no arc."""
    return int(row[base + 12 + 2 * count + 17]) if row[base + 10] == 0.0 else 0


def leaves_operator(row: memoryview[float], base: int, count: int) -> int:
    """Whether the operator's override has no effect on a segment (G166)."""
    return 1 if row[base + 35 + 3 * count] > 0.0 else 0


def moves(row: memoryview[float], base: int, count: int, i: int) -> int:
    """Whether a segment moves its axis ``i``: on its way, or on the curve behind it."""
    tail = base + 12 + 2 * count
    target = row[base + 12 + count + i]
    if row[base + 12 + i] != target:
        return 1
    if row[base + 9] == 1.0 and (row[tail + 7] == i or row[tail + 8] == i):
        return 1
    has_curve = row[tail + 4] > 0.0 or row[base + 9] == 2.0
    return 1 if has_curve and row[tail + 22 + i] != target else 0


def stage_way(row: memoryview[float], base: int, count: int, stage: int) -> float:
    """The way of one stage."""
    tail = base + 12 + 2 * count
    if stage == 0:
        return row[tail]
    if stage == 2:
        return row[tail + 1]
    if stage == 3:
        return 2.0 * row[tail + 4]
    return row[base + 3] - row[tail] - row[tail + 1] - row[tail + 4]


def stage_acceleration(row: memoryview[float], base: int, count: int, stage: int) -> float:
    """The acceleration along the path in a stage."""
    tail = base + 12 + 2 * count
    if stage == 0:
        return row[tail + 2]
    if stage == 2:
        return row[tail + 3]
    if stage == 3:
        return row[tail + 6]
    return row[base + 6]


def entry_speed(
    row: memoryview[float], base: int, count: int, stage: int, end_v: float, limit_v: float
) -> float:
    """The highest speed at the begin of ``stage`` from which ``end_v`` is reached at the end."""
    tail = base + 12 + 2 * count
    speed2 = end_v * end_v
    if row[tail + 4] > 0.0 and stage <= 3:
        curve_v = min(limit_v, row[tail + 5])
        speed2 = min(speed2 + 4.0 * row[tail + 4] * row[tail + 6], curve_v * curve_v)
    if stage <= 2:
        speed2 += 2.0 * row[tail + 1] * row[tail + 3]
    if stage <= 1:
        way = row[base + 3] - row[tail] - row[tail + 1] - row[tail + 4]
        speed2 += 2.0 * way * row[base + 6]
    if stage == 0:
        speed2 += 2.0 * row[tail] * row[tail + 2]
    return min(arithmetic.square_root(speed2), limit_v)


def locate(
    row: memoryview[float], base: int, count: int, way: float, places: memoryview[float]
) -> None:
    """Put where each axis is after ``way`` into ``places``; at both ends bit by bit."""
    tail = base + 12 + 2 * count
    if way <= 0.0 or way >= whole_way(row, base, count):
        end = base + 12 if way <= 0.0 else end_place(row, base, count)
        for i in range(count):
            places[i] = row[end + i]
        return
    if row[tail + 4] > 0.0 and way > row[base + 3] - row[tail + 4]:
        locate_on_curve(row, base, count, way, places)
        return
    if row[base + 9] == 2.0:
        locate_on_bend(row, base, count, way, places)
        return
    part = way / row[base + 3]
    for i in range(count):
        start = row[base + 12 + i]
        places[i] = start + (row[base + 12 + count + i] - start) * part
    if row[base + 9] == 1.0:
        first = int(row[tail + 7])
        second = int(row[tail + 8])
        angle = row[tail + 11] * part
        cosine = arithmetic.cosine(angle)
        sine = arithmetic.sine(angle)
        x = row[base + 12 + first] - row[tail + 9]
        y = row[base + 12 + second] - row[tail + 10]
        places[first] = row[tail + 9] + x * cosine - y * sine
        places[second] = row[tail + 10] + x * sine + y * cosine


def locate_on_curve(
    row: memoryview[float], base: int, count: int, way: float, places: memoryview[float]
) -> None:
    """``locate`` on the curve: a parabola with the target as its control point."""
    tail = base + 12 + 2 * count
    half = row[tail + 4]
    length = row[base + 3]
    part = (way - (length - half)) / (2.0 * half)
    for i in range(count):
        corner = row[base + 12 + count + i]
        before = (row[base + 12 + i] - corner) * half / length
        behind = row[tail + 22 + i] - corner
        places[i] = corner + (1.0 - part) * (1.0 - part) * before + part * part * behind


def locate_on_bend(
    row: memoryview[float], base: int, count: int, way: float, places: memoryview[float]
) -> None:
    """``locate`` on a bend: from its nearer end along the line there, and off it as way³."""
    part = way / row[base + 3]
    is_behind = part > 0.5
    if is_behind:
        part = 1.0 - part
    off = part * part * part * 1.3333333333333333
    for i in range(count):
        near = row[base + 12 + i]
        far = row[base + 12 + count + i]
        if is_behind:
            far = near
            near = row[base + 12 + count + i]
        corner = row[base + 34 + 2 * count + i]
        places[i] = near + 2.0 * part * (corner - near) + off * (near + far - 2.0 * corner)


def direct(
    row: memoryview[float], base: int, count: int, at_end: int, ways: memoryview[float]
) -> None:
    """Put the way of each axis per way of the path, at start or target, into ``ways``."""
    length = row[base + 3]
    for i in range(count):
        ways[i] = (row[base + 12 + count + i] - row[base + 12 + i]) / length
    if row[base + 9] == 1.0:
        tail = base + 12 + 2 * count
        first = int(row[tail + 7])
        second = int(row[tail + 8])
        place = base + 12 + (count if at_end else 0)
        turn = row[tail + 11] * 0.017453292519943295 / length
        ways[first] = (row[tail + 10] - row[place + second]) * turn
        ways[second] = (row[place + first] - row[tail + 9]) * turn


def curve(
    row: memoryview[float], base: int, count: int, at_end: int, turns: memoryview[float]
) -> None:
    """Put the change of ``direct`` per way, at start or target, into ``turns``: 0 on a line."""
    for i in range(count):
        turns[i] = 0.0
    if row[base + 9] == 1.0:
        tail = base + 12 + 2 * count
        first = int(row[tail + 7])
        second = int(row[tail + 8])
        place = base + 12 + (count if at_end else 0)
        turn = row[tail + 11] * 0.017453292519943295 / row[base + 3]
        turns[first] = (row[tail + 9] - row[place + first]) * turn * turn
        turns[second] = (row[tail + 10] - row[place + second]) * turn * turn
