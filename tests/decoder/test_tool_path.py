# SPDX-License-Identifier: MIT
"""Random contours beside which the tool is led: nowhere nearer than its radius (MO-9).

The oracle is brute force: places on the way of the tool's centre, and how far each line and arc of
the contour is from them. Contours go once around 0, 0, with corners so near to each other that a
tool may not fit between those that are not neighbours. Where a contour closes nothing joins its
begin and end: there, its first and its last motions are not asked for.
"""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from itertools import pairwise
from math import cos, dist, hypot, radians, sin
from random import Random

import pytest
from support.compensated import Point, Way, distance, places

from nctakt.decoder.contour.rows import ARC, GAP, NOTHING, REACH
from nctakt.decoder.contour.tool_path import ToolPath
from nctakt.decoder.state.geometry.arcs import arc_of_radius

pytestmark = pytest.mark.slow

#: How far from a contour the tool may be off: rounding, and corners that are none (0.01°).
TOLERANCE_MM = 2e-6

#: Contours of each kind; ten thousand are some minutes.
CONTOURS = int(os.environ.get("NCTAKT_CONTOURS", "500"))


@dataclass
class Passed:
    """What the tool does beside a contour; ``damages``: pairs of motions whose ways cross."""

    ways: list[tuple[int, Way]] = field(default_factory=list)
    damages: list[tuple[int, int]] = field(default_factory=list)
    misfits: list[int] = field(default_factory=list)


def corners(random: Random) -> list[Point]:
    """Corners around 0, 0: some far apart, some in small steps, some in a narrow groove."""
    found: list[Point] = []
    count = random.randint(4, 9)
    for number in range(count):
        angle = 360 * (number + random.uniform(-0.3, 0.3)) / count
        far = random.uniform(30, 90)
        kind = random.choice(("corner", "corner", "steps", "groove"))
        if number in (0, count - 1):
            kind = "corner"
        ways = [far]
        if kind == "steps":
            ways = [far + random.uniform(-2, 2) for _ in range(random.randint(2, 6))]
        elif kind == "groove":
            ways = [far, far - random.uniform(3, 20), far + random.uniform(-3, 3)]
        for way in ways:
            angle += random.uniform(0.3, 4)
            x, y = way * cos(radians(angle)), way * sin(radians(angle))
            found.append((round(x, 3), round(y, 3)))
    return found


def contour(random: Random) -> list[Way]:
    """Lines and arcs from corner to corner, in one sense or the other."""
    places_ = corners(random)
    places_.append(places_[0])
    if random.random() < 0.5:
        places_.reverse()
    only_lines = random.random() < 0.5
    ways: list[Way] = []
    for start, end in pairwise(places_):
        chord = dist(start, end)
        kind = "line" if only_lines else random.choice(("line", "line", "left", "right"))
        if chord < 0.01:
            continue
        if kind == "line":
            ways.append((start, end, None, 0.0))
            continue
        radius = chord * random.uniform(0.6, 3)
        arc = arc_of_radius([*start], [*end], (0, 1), radius, kind == "right")
        ways.append((start, end, (arc.centre_first, arc.centre_second), arc.angle))
    return ways


def passed(ways: list[Way], distance_: float, by_arc: bool, masks: bool) -> Passed:
    """Lead the tool beside a contour, from beside its start to beside its end."""
    tool = ToolPath()
    tool.side = 1.0 if distance_ > 0 else -1.0
    tool.masks = masks
    tool.set_corners(by_arc, True)
    result = Passed()
    for number, (start, end, centre, angle) in enumerate(ways, start=1):
        if centre is None:
            tool.line(*start, *end, distance_, distance_, True)
        elif not tool.arc(*start, *end, distance_, *centre, angle) and not masks:
            result.misfits.append(number)
            return result
        if number == 1:
            tool.begin(*start, True)
        elif not tool.add():
            result.misfits.append(number - 1)
            return result
        taken(tool, result, number - 1 - (REACH if masks else 0))
    if not tool.close(False):
        result.misfits.append(len(ways))
    taken(tool, result, len(ways))
    return result


def taken(tool: ToolPath, result: Passed, last: int) -> None:
    """What is known up to this motion."""
    if tool.crossed:
        result.damages.append((tool.crossed, tool.crossing))
        tool.crossed = 0
    begun = result.ways[-1][0] if result.ways else 1
    for number in range(begun, last + 1):
        while (shape := tool.take(number)) != NOTHING:
            if shape == GAP:
                result.misfits.append(number)
                continue
            piece = tool.taken()
            way: Way = ((piece[0], piece[1]), (piece[2], piece[3]), None, 0.0)
            if shape == ARC:
                way = (way[0], way[1], (piece[5], piece[6]), piece[7])
            result.ways.append((number, way))
            if tool.crossed:
                result.damages.append((tool.crossed, tool.crossing))
                tool.crossed = 0


def crosses_itself(ways: list[Way]) -> bool:
    """Whether the contour itself does, as lines of a few places of each motion."""
    chain = [place for way in ways for place in places(way, 8)[:-1]]
    lines = list(zip(chain, [*chain[1:], chain[0]], strict=True))
    for number, (start, end) in enumerate(lines):
        for start_2, end_2 in lines[number + 2 : len(lines) - (number == 0)]:
            if (
                _side(start, end, start_2) * _side(start, end, end_2) < 0
                and _side(start_2, end_2, start) * _side(start_2, end_2, end) < 0
            ):
                return True
    return False


def _side(start: Point, end: Point, place: Point) -> float:
    x, y = end[0] - start[0], end[1] - start[1]
    return x * (place[1] - start[1]) - y * (place[0] - start[0])


def nearest(ways: list[Way], result: Passed, radius: float) -> tuple[float, int, int]:
    """The least distance from the contour less the radius; of which motion, from which one."""
    minimum = (1e9, 0, 0)
    count = len(ways)
    for number, one in result.ways[1:]:
        for place in places(one, 24):
            for other, way in enumerate(ways, start=1):
                if abs(number - other) > count - 4:
                    continue
                off = distance(place, way) - radius
                if off < minimum[0]:
                    minimum = (off, number, other)
    return minimum


def chosen(seed: int) -> tuple[list[Way], float, bool]:
    """A contour, the tool's distance, whether it goes around corners in arcs."""
    random = Random(seed)
    ways = contour(random)
    radius = random.choice((0.5, 1, 2, 4, 7))
    return ways, radius * random.choice((1, -1)), random.random() < 0.5


def tolerance(ways: list[Way], radius: float) -> float:
    """Where the contour goes back along itself, or by 0.01° less, the tool goes around its end."""
    for one, other in pairwise(ways):
        before, corner = places(one, 1000)[-2:]
        behind = places(other, 1000)[1]
        x, y = corner[0] - before[0], corner[1] - before[1]
        x_2, y_2 = behind[0] - corner[0], behind[1] - corner[1]
        if x * x_2 + y * y_2 < -0.9999 * hypot(x, y) * hypot(x_2, y_2):
            return TOLERANCE_MM + 2e-4 * radius
    return TOLERANCE_MM


@pytest.mark.parametrize("part", range(10))
def test_where_nothing_is_reported_the_tool_is_nowhere_too_near(part: int) -> None:
    """Neither a motion that does not fit nor a crossing: then no place is damaged."""
    fitting = 0
    for seed in range(part, CONTOURS, 10):
        ways, tool, by_arc = chosen(seed)
        result = passed(ways, tool, by_arc, masks=False)
        if result.misfits or result.damages:
            continue
        off, *where = nearest(ways, result, abs(tool))
        assert off > -tolerance(ways, abs(tool)) or crosses_itself(ways), (seed, off, where)
        fitting += 1
    assert fitting > CONTOURS // 10 // 10


@pytest.mark.parametrize("part", range(10))
def test_what_is_left_out_is_not_damaged(part: int) -> None:
    """G141: more contours are passed than without, and what is passed keeps the distance."""
    fitting = without = 0
    for seed in range(part, CONTOURS, 10):
        ways, tool, by_arc = chosen(seed)
        result = passed(ways, tool, by_arc, masks=True)
        bare = passed(ways, tool, by_arc, masks=False)
        without += not bare.misfits and not bare.damages
        if result.misfits or result.damages:
            continue
        check(seed, ways, result, tool)
        fitting += 1
    assert fitting > without > 0


def check(seed: int, ways: list[Way], result: Passed, tool: float) -> None:
    """The tool is nowhere nearer to the contour than its radius."""
    off, *where = nearest(ways, result, abs(tool))
    assert off > -tolerance(ways, abs(tool)) or crosses_itself(ways), (seed, off, where)


@pytest.mark.parametrize(
    ("seed", "by_arc"),
    [
        # a motion that does not fit lies between two that meet on what its corners cut off
        (1483, True),
        (8158, True),
        # the crossing is up to rounding where an arc begins
        (7115, True),
        # the path leads back past a loop that was left out
        (3735, False),
        (7401, False),
        (7735, False),
        (9821, False),
        (9829, False),
    ],
)
def test_the_tool_is_led_along_what_neighbours_cut_off(seed: int, by_arc: bool) -> None:
    """G141: what a corner or a loop cuts off may be way again after a motion left out."""
    ways, tool, _ = chosen(seed)
    result = passed(ways, tool, by_arc, masks=True)
    assert not result.misfits and not result.damages
    check(seed, ways, result, tool)


@pytest.mark.parametrize(("seed", "by_arc"), [(5776, False), (15133, True), (15133, False)])
def test_where_arcs_smaller_than_the_tool_are_cut_it_is_reported(seed: int, by_arc: bool) -> None:
    """G141: no way leads beside such arcs; several one after the other may still be damaged."""
    ways, tool, _ = chosen(seed)
    result = passed(ways, tool, by_arc, masks=True)
    assert not result.misfits
    assert result.damages
    assert nearest(ways, result, abs(tool))[0] < -0.3


@pytest.mark.parametrize("masks", [False, True])
def test_the_way_is_in_one_piece(masks: bool) -> None:
    """Each piece begins where the one before it has ended."""
    for seed in range(100):
        ways, tool, by_arc = chosen(seed)
        result = passed(ways, tool, by_arc, masks)
        if result.misfits:
            continue
        for (_, one), (_, other) in pairwise(result.ways):
            assert dist(one[1], other[0]) < 1e-9, seed
