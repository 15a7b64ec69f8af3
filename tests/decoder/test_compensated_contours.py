# SPDX-License-Identifier: MIT
"""Random contours with lines and arcs: the tool stays beside them (MO-9).

Contours go once around 0, 0, corner by corner, so that places narrower than the tool lie between
neighbours, where they are reported (90019, 90038, 90017); a contour without an error is passed at
the tool's radius.
"""

from __future__ import annotations

from itertools import pairwise
from math import cos, dist, radians, sin
from random import Random

import pytest
from support.compensated import Point, Way, decoded, distance, places, reported, way
from support.random_seeds import each_seed

#: How far from a contour the tool may be off: rounding, and corners that are none (0.01°).
TOLERANCE_MM = 2e-6

CONTOUR_ERRORS = (90019, 90038, 90017)


def contour(random: Random) -> list[tuple[str, Point]]:
    """Blocks around 0, 0 with their ends; the first one is a line."""
    corners = []
    count = random.randint(5, 12)
    for number in range(count):
        angle = radians(360 * (number + random.uniform(-0.3, 0.3)) / count)
        far = random.uniform(40, 90)
        corners.append((round(far * cos(angle), 3), round(far * sin(angle), 3)))
    blocks = [(f"G01 X{corners[0][0]} Y{corners[0][1]}", corners[0])]
    for before, (x, y) in zip(corners, [*corners[1:], corners[0]], strict=True):
        chord = dist(before, (x, y))
        kind = random.choice(("G01", "G01", "G02", "G03"))
        radius = "" if kind == "G01" else f" R{chord * random.uniform(0.6, 3):.3f}"
        blocks.append((f"{kind} X{x} Y{y}{radius}", (x, y)))
    return blocks if random.random() < 0.5 else turned_back(blocks)


def turned_back(blocks: list[tuple[str, Point]]) -> list[tuple[str, Point]]:
    """The same contour the other way round."""
    ends = [end for _, end in blocks]
    back = [(f"G01 X{ends[-1][0]} Y{ends[-1][1]}", ends[-1])]
    for (text, _), end in zip(reversed(blocks), reversed(ends[:-1]), strict=False):
        words = text.split()
        words[0] = {"G01": "G01", "G02": "G03", "G03": "G02"}[words[0]]
        words[1:3] = [f"X{end[0]}", f"Y{end[1]}"]
        back.append((" ".join(words), end))
    return back


def ways_of(
    blocks: list[tuple[str, Point]], words: str, patch: pytest.MonkeyPatch
) -> tuple[list[Way], list[int], list[int]]:
    """The ways of a contour, their blocks' numbers, and the numbers of errors."""
    start, end = blocks[0][1], blocks[-1][1]
    lines = [f"F600000 G01 X{start[0] * 1.5} Y{start[1] * 1.5}", words]
    lines += [f"N{number} {text}" for number, (text, _) in enumerate(blocks)]
    lines += ["G40", f"G01 X{end[0] * 1.5} Y{end[1] * 1.5}", ""]
    segments, errors = decoded("\n".join(lines), patch)
    kept = [one for one in segments[1:-1] if one.number]
    return [way(one) for one in kept], [one.number for one in kept], errors


@each_seed(20, 5)
def test_the_tool_stays_at_its_radius(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Nowhere nearer than the radius, and just so far beside each line and arc."""
    random = Random(seed)
    blocks = contour(random)
    radius = random.choice((0.5, 1, 2, 4))
    side = random.choice(("G41", "G42"))
    corners = random.choice(("G25", "G26"))
    programmed, _, errors = ways_of(blocks, "", monkeypatch)
    assert errors == []
    words = f"V.G.WZ_AKT.R = {radius}\n{side} {corners}"
    ways, numbers, errors = ways_of(blocks, words, monkeypatch)
    if errors:
        assert errors[0] in CONTOUR_ERRORS
        return
    assert len(set(numbers)) == len(programmed)
    for one, other in pairwise(ways):
        assert dist(one[1], other[0]) < 1e-9
    for one, number in zip(ways, numbers, strict=True):
        own = programmed[number - 1]
        # where the contour closes nothing joins its begin and end
        first, last = number == len(programmed), len(programmed) - (number == 1)
        for place in places(one):
            nearest = min(distance(place, other) for other in programmed[first:last])
            assert nearest > radius - TOLERANCE_MM, (number, place)
        beside = distance(places(one)[10], own)
        if corners == "G26":
            assert abs(beside - radius) < TOLERANCE_MM, (number, one)


def test_many_contours_fit(monkeypatch: pytest.MonkeyPatch) -> None:
    """The test above would say little if all of its contours were refused."""
    fitting = 0
    for seed in range(20):
        random = Random(seed)
        words = "V.G.WZ_AKT.R = 1\nG41 G26"
        fitting += not ways_of(contour(random), words, monkeypatch)[2]
    assert fitting > 10


def open_contour(random: Random) -> list[Point]:
    """Corners of lines that do not come near each other but at their ends, after an angle of 0."""
    corners = []
    count = random.randint(3, 9)
    for number in range(count):
        angle = radians(300 * (number + random.uniform(-0.2, 0.2)) / count)
        far = random.uniform(40, 90)
        corners.append((round(far * cos(angle), 3), round(far * sin(angle), 3)))
    return corners


def nearest_to(place: Point, lines: list[tuple[Point, Point]]) -> float:
    """How far a place is from the nearest of some lines."""
    return min(distance(place, (start, end, None, 0.0)) for start, end in lines)


@each_seed(20, 5)
def test_the_way_to_an_open_contour_and_from_it(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Reported where it crosses the path beside another part (901964), and only where it cuts."""
    random = Random(seed)
    corners = open_contour(random)
    radius = random.choice((1.0, 2.0, 4.0))
    begin, end = (
        (random.uniform(-120, 120), random.uniform(-120, 120)),
        (random.uniform(-120, 120), random.uniform(-120, 120)),
    )
    lines = [f"V.G.WZ_AKT.R = {radius}", f"F600000 G01 X{begin[0]:.3f} Y{begin[1]:.3f}"]
    lines += [random.choice(("G41", "G42")), *(f"N1 X{x} Y{y}" for x, y in corners)]
    lines += ["G40", f"N2 X{end[0]:.3f} Y{end[1]:.3f}", ""]
    segments, errors, warnings = reported("\n".join(lines), monkeypatch)
    if errors:
        return
    parts = list(pairwise(corners))
    ways = [way(one) for one in segments]
    to, away = ways[1], ways[-1]
    distances = [nearest_to(place, parts[1:]) for place in places(to, 2000)]
    distances += [nearest_to(place, parts[:-1]) for place in places(away, 2000)]
    if 901964 in warnings:
        assert min(distances) < radius - 1e-6
    left = radius if lines[2] == "G41" else -radius
    for lead, others in ((to, parts[1:]), (away, parts[:-1])):
        if any(crosses(lead, part, left) for part in others):
            assert {901964, 900950} & set(warnings)


def crosses(lead: Way, part: tuple[Point, Point], left: float) -> bool:
    """Whether a way leads across the path beside a line, far from the corners at its ends."""
    (x, y), (x_2, y_2) = lead[:2]
    (u, v), (u_2, v_2) = part
    size = dist(*part)
    along = ((u_2 - u) / size, (v_2 - v) / size)
    beside = (u - along[1] * left, v + along[0] * left)

    def place(one: Point) -> Point:
        off = (one[0] - beside[0], one[1] - beside[1])
        return (
            off[0] * along[0] + off[1] * along[1],
            off[1] * along[0] - off[0] * along[1],
        )

    (begin, low), (end, high) = place((x, y)), place((x_2, y_2))
    if low * high >= 0.0:
        return False
    at = begin + (end - begin) * low / (low - high)
    return 8.0 * abs(left) < at < size - 8.0 * abs(left)
