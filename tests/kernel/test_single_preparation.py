# SPDX-License-Identifier: MIT
"""Single decisions of the preparation of segments (MO-1, MO-3), each against a formula.

What is called here cannot be seen from Python where it is compiled: the tests run in plain mode.
"""

from __future__ import annotations

import math

import pytest
from kernel_rig import Rig

from nctakt.base import mode
from nctakt.kernel import rows
from nctakt.kernel.path.lookahead import LookAhead
from nctakt.kernel.path.segment_limits import SegmentLimits

pytestmark = pytest.mark.skipif(mode.is_compiled(), reason="compiled methods cannot be called")

#: Acceleration of each axis, mm/s², and the length of a tick, s.
LIMIT_A = 1000.0
TICK_T = 0.001


def look_ahead(axes: int = 2) -> LookAhead:
    """A preparation of axes that are all alike."""
    made = LookAhead(axes, 1000, 10, 1.0)
    for axis in range(axes):
        made.limits.limit(axis, True, (500.0, 500.0), (LIMIT_A, LIMIT_A))
    return made


def segments(count: int, axes: int = 2) -> memoryview[float]:
    """Rows of ``count`` segments."""
    return memoryview(bytearray(8 * count * rows.segment_width(axes))).cast("d")


@pytest.mark.parametrize(
    ("distance", "seconds"),
    [
        (100.0, 100.0 / 10.0 + 2.5),
        (25.0, 5.0),
        (20.0, 20.0 / 8.827782 + 8.827782 / 5.0 + 0.5),
        (1.0, 4.0 * (0.5 / 10.0) ** (1.0 / 3.0)),
    ],
)
def test_the_time_from_rest_to_rest_with_a_limited_jerk(distance: float, seconds: float) -> None:
    """10 mm/s, 5 mm/s², 10 mm/s³: with a cruise, just without, without full speed, without full
    acceleration.
    """
    time = SegmentLimits(2, 1000, 1.0).rest_to_rest_time(distance, 10.0, 5.0, 10.0)
    assert time == pytest.approx(seconds, rel=1e-6)


@pytest.mark.parametrize(("speed", "seconds"), [(1.0, 100.0 + 2.0 * math.sqrt(0.1)), (2.5, 41.0)])
def test_a_speed_below_full_acceleration_is_reached_without_it(
    speed: float, seconds: float
) -> None:
    """Up to a²/j the ramp takes 2·√(v/j)."""
    time = SegmentLimits(2, 1000, 1.0).rest_to_rest_time(100.0, speed, 5.0, 10.0)
    assert time == pytest.approx(seconds)


def test_between_short_segments_a_corner_uses_its_reserve_and_no_more() -> None:
    """70 % of the acceleration for a step that repeats on each 0.02 mm, 20 times within a tick."""
    ahead = look_ahead()
    row = rows.segment_width(2)
    both = segments(2)
    for at in (0, row):
        both[at + rows.LENGTH] = 0.02
        both[at + rows.SPEED] = both[at + rows.MAX_SPEED] = 500.0
        both[at + rows.ACCELERATION] = LIMIT_A
    ahead.corner.steps[0] = 0.01
    ahead.pass_corner(both, 0, row)
    assert both[rows.CORNER_SPEED] == pytest.approx(math.sqrt(0.7 * LIMIT_A / 0.01 * 0.02))
    assert ahead.corner.shares[0] == pytest.approx(0.7)
    assert ahead.corner.shares[1] == 0.0


def test_the_reserve_of_a_corner_reaches_a_tick_far() -> None:
    """v·T + a·T², on either side; the axis of the step keeps what the step leaves."""
    ahead = look_ahead()
    row = segments(1)
    row[rows.LENGTH] = 10.0
    row[rows.ACCELERATION] = LIMIT_A
    ahead.corner.shares[0] = 0.25
    ahead.corner.leaving[0] = -0.5
    ahead.corner.entering[0] = 1.0
    ahead.reserve_zone(row, 0, 1, 100.0, 0.25)
    ahead.reserve_zone(row, 0, 0, 50.0, 0.25)
    assert row[rows.EXIT_LENGTH] == 100.0 * TICK_T + LIMIT_A * TICK_T * TICK_T
    assert row[rows.ENTRY_LENGTH] == 50.0 * TICK_T + LIMIT_A * TICK_T * TICK_T
    assert row[rows.EXIT_ACCELERATION] == LIMIT_A
    assert row[rows.ENTRY_ACCELERATION] == 0.75 * LIMIT_A


def test_a_short_segment_keeps_the_reserve_all_along() -> None:
    """Less than three times the reserve: nothing of it is outside."""
    ahead = look_ahead()
    row = segments(1)
    row[rows.LENGTH] = 0.3
    for column in (rows.ACCELERATION, rows.ENTRY_ACCELERATION, rows.EXIT_ACCELERATION):
        row[column] = LIMIT_A
    ahead.corner.shares[0] = 0.25
    ahead.corner.leaving[0] = 1.0
    ahead.reserve_zone(row, 0, 1, 100.0, 0.25)
    assert row[rows.ACCELERATION] == row[rows.EXIT_ACCELERATION] == 0.75 * LIMIT_A
    assert row[rows.ENTRY_ACCELERATION] == 0.75 * LIMIT_A
    assert row[rows.EXIT_LENGTH] == 0.0


def test_on_a_helix_only_the_part_in_the_plane_is_turned() -> None:
    """The centripetal part is (v·p)²/r: 80 mm/s of 100 in the plane, on a radius of 10 mm."""
    ahead = look_ahead(3)
    ahead.limits.limit(2, True, (500.0, 500.0), (1e6, 1e6))
    row = segments(1, 3)
    row[rows.SHAPE] = rows.ARC
    row[rows.ARC_SECOND_AXIS] = 1.0
    row[rows.ARC_ANGLE] = 360.0 / math.pi  # 20 mm along the arc
    row[rows.START] = 10.0
    row[rows.START + 3], row[rows.START + 4] = 10.0 * math.cos(2.0), 10.0 * math.sin(2.0)
    row[rows.START + 5] = 15.0
    row[rows.SPEED] = 50.0
    part = 0.8
    share = (50.0 * part) ** 2 / (10.0 * LIMIT_A)
    assert ahead.limits.measure_arc(row, 0) == pytest.approx(share)
    assert row[rows.LENGTH] == pytest.approx(25.0)
    limit_a = LIMIT_A * math.sqrt(1.0 - share * share) / part
    assert row[rows.ACCELERATION] == pytest.approx(limit_a)


def test_a_rapid_motion_goes_at_its_programmed_override() -> None:
    """MO-4: what its axes can do, times the override of its row; no other row is touched."""
    queue = Rig().channel.queue
    zeros = [0.0] * queue.path.count
    for number in range(2):
        pace = [0.5 if number else 0.0] + [0.0] * (rows.PACE_WIDTH - 1)
        start, target = [100.0 * number, *zeros[1:]], [100.0 * (number + 1), *zeros[1:]]
        queue.put_segment(0, 0, start, target, rows.RAPID_MOTION, 0.0, True, 0.0, False, None, pace)
    assert queue.command(0)[rows.SPEED] == 500.0
    assert queue.command(1)[rows.SPEED] == 250.0
