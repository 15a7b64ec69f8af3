# SPDX-License-Identifier: MIT
"""Chamfers and roundings (MO-4): G301, G302, ``#CHR``, ``#CHF``, ``#RND``, ``#FRC``.

Pages 206609163 and 206615051 of the programming manual. Ways are written as they were worked out by
hand: where each one ends, for an arc its centre and angle.
"""

from __future__ import annotations

import math
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st
from support.compensated import decoded, way

from nctakt.decoder.shapes import corners
from nctakt.decoder.state.queued.commands import Segment
from nctakt.kernel import rows
from nctakt.lists.machine.machine import load_machine
from nctakt.run.controller import Controller, NcText

ROOT = 2**0.5


def run_of(text: str, patch: pytest.MonkeyPatch) -> tuple[list[Segment], list[str]]:
    """The motions of a program, and its findings."""
    return decoded("G01 F6000\n" + text, patch)


def ends(text: str, patch: pytest.MonkeyPatch) -> list[object]:
    """Ends of the ways in the plane, arcs with centre and angle, rounded."""
    segments, errors = run_of(text, patch)
    assert errors == []
    found: list[object] = []
    for segment in segments:
        _, end, centre, angle = way(segment, (0, 1))
        rounded = tuple(round(value, 6) + 0.0 for value in end)
        if centre is None:
            found.append(rounded)
        else:
            about = tuple(round(value, 6) + 0.0 for value in centre)
            found.append((rounded, about, round(angle, 6)))
    return found


def test_chamfers_between_lines(monkeypatch: pytest.MonkeyPatch) -> None:
    """I is the distance from the corner to both ends (page 206615051, example 1); it is kept."""
    text = "G91 G01 X80 Y-40\nG301 I40\nX80 Y40\nG301\nX-30 Y40\n"
    leg = 40 / math.hypot(2, 1)
    near = (80 - 2 * leg, -40 + leg)
    far = (80 + 2 * leg, -40 + leg)
    before = (160 - 2 * leg, -leg)
    behind = (160 - 24, 32)
    want = [near, far, before, behind, (130, 40)]
    assert ends(text, monkeypatch) == [
        tuple(round(value, 6) + 0.0 for value in point) for point in want
    ]


def test_chamfers_between_arcs(monkeypatch: pytest.MonkeyPatch) -> None:
    """On arcs I is a chord (page 206615051, example 2)."""
    segments, errors = run_of("G91 G03 X50 Y50 I0 J50\nG301 I30\nG03 X40 Y40 I40 J0\n", monkeypatch)
    assert errors == []
    first, chamfer, last = segments
    assert math.dist(first.target[:2], (50, 50)) == pytest.approx(30)
    assert math.dist(last.start[:2], (50, 50)) == pytest.approx(30)
    assert chamfer.start == first.target
    assert chamfer.target == last.start
    assert math.dist(first.target[:2], (0, 50)) == pytest.approx(50)
    assert math.dist(last.start[:2], (90, 50)) == pytest.approx(40)


def test_roundings_between_lines(monkeypatch: pytest.MonkeyPatch) -> None:
    """An arc that touches both lines; with #RND in the block before the corner."""
    text = "X50\nG302 I10\nY40\nX0 #RND=5\nY0\n"
    assert ends(text, monkeypatch) == [
        (40, 0),
        ((50, 10), (40, 10), 90),
        (50, 40),
        (5, 40),
        ((0, 35), (5, 35), 90),
        (0, 0),
    ]


def test_width_and_length_of_a_chamfer(monkeypatch: pytest.MonkeyPatch) -> None:
    """#CHR is the distance from the corner, #CHF the length of the chamfer."""
    text = "X50 #CHR=10\nY40\nX20 Y10 #CHF=4\nY-20\n"
    side = 2 / math.sin(math.radians(67.5))
    assert ends(text, monkeypatch) == [
        (40, 0),
        (50, 10),
        (50, 40),
        (round(20 + side / ROOT, 6), round(10 + side / ROOT, 6)),
        (20, round(10 - side, 6)),
        (20, -20),
    ]


def test_rounding_beside_an_arc(monkeypatch: pytest.MonkeyPatch) -> None:
    """The centre lies 10 from the line and 40 from that of the arc: x = 50 - √(40² - 10²)."""
    segments, errors = run_of("X50\nG302 I10\nG03 X0 Y50 I-50 J0\n", monkeypatch)
    assert errors == []
    x = math.sqrt(40**2 - 10**2)
    assert segments[0].target[:2] == pytest.approx((x, 0))
    assert segments[1].arc is not None
    assert segments[1].arc[2:4] == pytest.approx((x, 10))
    assert segments[1].target[:2] == pytest.approx((x * 1.25, 12.5))


def test_axes_outside_the_plane_go_along(monkeypatch: pytest.MonkeyPatch) -> None:
    """They keep their part of the way."""
    segments, errors = run_of("X50 Z10\nG301 I10\nY40 Z0\n", monkeypatch)
    assert errors == []
    assert [segment.target[:3] for segment in segments] == [
        pytest.approx((40, 0, 8)),
        pytest.approx((50, 10, 7.5)),
        pytest.approx((50, 40, 0)),
    ]


def test_feeds(monkeypatch: pytest.MonkeyPatch) -> None:
    """#FRC, else E, else F, of the block itself if it has one; rapid beside a rapid motion."""
    text = (
        "X50\nG301 I1\nY50\nG301 F3000\nX0\nG301 #FRC=1200\nY0 E600\nG301\nX50\nG301\nG00 Y50\n"
        "G301\nG01 X0\nM30\n"
    )
    segments, errors = run_of(text, monkeypatch)
    assert errors == []
    feeds = [segment.feed for segment in segments[1::2]]
    assert feeds == [100, 50, 20, 10, 0, 0]
    assert [s.motion for s in segments[9::2]] == [rows.RAPID_MOTION, rows.RAPID_MOTION]


def test_the_tool_goes_beside_a_rounding(monkeypatch: pytest.MonkeyPatch) -> None:
    """The rounding is part of the contour that G41 and G42 compensate (tool 1: radius 5)."""
    text = "D1 G42 X10 Y0\nX50\nG302 I20\nY40\nG301 I10\nX0\nG40 X-20 Y60\n"
    found = ends(text, monkeypatch)
    assert found[1:3] == [(30, -5), ((55, 20), (30, 20), 90)]
    assert all(math.dist((0, 0), point[:2]) > 5 for point in found if len(point) == 2)


def test_a_corner_may_take_a_whole_line(monkeypatch: pytest.MonkeyPatch) -> None:
    """The line is then no motion at all."""
    assert ends("X50\nG301 I10\nY20\nG301\nX0\n", monkeypatch) == [
        (40, 0),
        (50, 10),
        (40, 20),
        (0, 20),
    ]


@pytest.mark.parametrize(
    ("text", "number"),
    [
        ("X50\nG301\nY10\n", 20012),
        ("X50\nG302 I0\nY10\n", 20012),
        ("X50\nP1=0\nG302 I=P1\nY10\n", 20012),
        ("X50\nG301 I-1\nY10\n", 20800),
        ("X50 #RND=-1\nY10\n", 20800),
        ("X50\nP1=-1\nX60 #RND=P1\nY10\n", 20800),
        ("X50\nG301 I1 G302\nY10\n", 20130),
        ("X50 #CHR=1 #RND=1\nY10\n", 20130),
        ("X50\nG301 I60\nY10\n", 901614),
        ("X50\nG301 I20\nY10\n", 901614),
        ("X20 Y-10\nX40\nG301 I30\nX60 Y50\n", 901614),  # page 206615051, example 3
        ("X50\nG301 I10\nY10\nG301 I1\nX0\n", 901614),
        ("X50\nG302 I10\nY10\nG302 I1\nX0\n", 901614),
        ("X50\nG301 I1\nZ10\n", 901615),
        ("X50\nG302 I1\nX0\n", 901616),
        ("X50\nG301 I1 Y10\nX0\n", 901611),
        ("X50 #FRC=100\nY10\n", 901612),
        ("X50\nG95 F1 G301 I1 #FRC=100\nY10\n", 901613),
        ("X50 #RND=1\nG301 I1\nY10\n", 901617),
        ("X50\nG301 I1 #FRC=0\nY10\n", 20176),
    ],
)
def test_mistakes(text: str, number: int) -> None:
    """Each mistake has its number."""
    done = Controller().run(NcText("p.nc", "G01 F6000\n" + text), ticks=20_000)
    assert [found.id for found in done.errors][:1] == [number]


@pytest.mark.parametrize(
    ("text", "number"),
    [
        ("G301 I1\nX50\n", 20351),
        ("X50\n#FLUSH WAIT\nG301 I1\nX50\n", 20351),
        ("X50\nG301 I1\nM30\n", 901610),
        ("X50\nG301 I1\nG41 D1\nY10\nG40 X0\n", 901610),
    ],
)
def test_nothing_is_inserted_without_two_motions(text: str, number: int) -> None:
    """The controller goes on (reaction class 1)."""
    done = Controller().run(NcText("p.nc", "G01 F6000\n" + text), ticks=20_000)
    assert [found.id for found in done.diagnostics] == [number]
    assert done.errors == ()


def test_they_can_be_switched_off() -> None:
    """P-CHAN-00273 makes them errors."""
    demo = load_machine(None)
    (channel,) = demo.channels
    parameters = replace(channel.parameters, allows_corners=False)
    machine = replace(demo, channels=(replace(channel, parameters=parameters),))
    for word, number in (("G301 I1", 21718), ("#CHR=1", 21932)):
        done = Controller(machine).run(NcText("p.nc", f"G01 F6000 X50\n{word}\nY10\n"))
        assert [found.id for found in done.errors] == [number]


@given(
    st.floats(-170, 170).filter(lambda angle: abs(angle) > 5),
    st.sampled_from([-40.0, 0.0, 40.0]),
    st.sampled_from([-40.0, 0.0, 40.0]),
    st.floats(0.1, 3),
)
def test_roundings_touch_both_motions(angle: float, one: float, other: float, size: float) -> None:
    """At their ends they have the directions of the motions; radius 0 represents a line."""
    before = motion(one, is_before=True, direction=0.0)
    behind = motion(other, is_before=False, direction=math.radians(angle))
    sides = (
        corners.Side(before, (0, 1), is_before=True),
        corners.Side(behind, (0, 1), is_before=False),
    )
    found = corners.rounding_centre(*sides, size)
    if found is None:
        return
    centre, left = found
    for side in sides:
        point = side.point_at(side.touch(centre))
        assert math.dist(point, centre) == pytest.approx(size, abs=1e-9)
        if side.turn == 0.0:
            x, y = side.direction
            gap = (centre[0] - side.corner[0]) * -y + (centre[1] - side.corner[1]) * x
            assert gap == pytest.approx(left * size, abs=1e-9)
        else:
            gap = side.radius - math.dist(centre, side.centre)
            assert gap == pytest.approx(math.copysign(size, left * side.turn), abs=1e-9)


def motion(
    radius: float,
    *,
    is_before: bool,
    direction: float,
) -> Segment:
    """A motion with this direction in radians at the corner in (0, 0)."""
    x, y = math.cos(direction), math.sin(direction)
    if radius == 0.0:
        far = (-30 * x, -30 * y) if is_before else (30 * x, 30 * y)
        arc = None
    else:
        centre = (-y * radius, x * radius)
        turn = math.copysign(80.0, radius)
        sign = -1.0 if is_before else 1.0
        a = math.radians(turn) * sign
        u, v = -centre[0], -centre[1]
        far = (
            centre[0] + u * math.cos(a) - v * math.sin(a),
            centre[1] + u * math.sin(a) + v * math.cos(a),
        )
        arc = (0.0, 1.0, *centre, turn)
    start, target = (far, (0.0, 0.0)) if is_before else ((0.0, 0.0), far)
    return Segment(0, 0, start, target, rows.FEED_MOTION, 10.0, False, arc=arc)
