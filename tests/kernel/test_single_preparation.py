# SPDX-License-Identifier: MIT
"""Single decisions of the preparation of segments (MO-1, MO-3), each against a formula.

What is called here cannot be seen from Python where it is compiled: the tests run in plain mode.
"""

from __future__ import annotations

import math
from types import SimpleNamespace
from typing import Any

import pytest
from support.kernel_rig import Rig

from nctakt.base import mode
from nctakt.kernel import rows
from nctakt.kernel.path import arc_limits
from nctakt.kernel.path.goal import Goal
from nctakt.kernel.path.jerk_profile import JerkProfile
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
    time = arc_limits.rest_to_rest_time(distance, 10.0, 5.0, 10.0)
    assert time == pytest.approx(seconds, rel=1e-6)


@pytest.mark.parametrize(("speed", "seconds"), [(1.0, 100.0 + 2.0 * math.sqrt(0.1)), (2.5, 41.0)])
def test_a_speed_below_full_acceleration_is_reached_without_it(
    speed: float, seconds: float
) -> None:
    """Up to a²/j the ramp takes 2·√(v/j)."""
    time = arc_limits.rest_to_rest_time(100.0, speed, 5.0, 10.0)
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
    assert ahead.limits.measure(row, 0) == pytest.approx(share)
    assert row[rows.LENGTH] == pytest.approx(25.0)
    limit_a = LIMIT_A * math.sqrt(1.0 - share * share) / part
    assert row[rows.ACCELERATION] == pytest.approx(limit_a)


def test_a_rapid_motion_goes_at_its_programmed_override() -> None:
    """MO-4: what its axes can do, times the override of its row; no other row is touched."""
    queue = Rig().channel.queue
    zeros = [0.0] * queue.path.count
    for number in range(2):
        pace = [0.5 if number else 0.0] + [0.0] * (rows.FEED_MODIFIER_WIDTH - 1)
        start, target = [100.0 * number, *zeros[1:]], [100.0 * (number + 1), *zeros[1:]]
        queue.put_segment(0, 0, start, target, rows.RAPID_MOTION, 0.0, True, 0.0, False, None, pace)
    assert queue.command(0)[rows.SPEED] == 500.0
    assert queue.command(1)[rows.SPEED] == 250.0


def test_on_an_arc_the_reserve_is_taken_beside_the_centripetal_part() -> None:
    """a·√(((1-s)² - c²) / (1 - c²)), with the share s of the corner and c of the circle."""
    ahead = look_ahead()
    row = segments(1)
    row[rows.SHAPE] = rows.ARC
    row[rows.LENGTH] = 10.0
    row[rows.ACCELERATION] = LIMIT_A
    ahead.corner.centripetal_share, ahead.corner.last_centripetal_share = 0.6, 0.3
    for at_end, share, column in (
        (0, 0.6, rows.ENTRY_ACCELERATION),
        (1, 0.3, rows.EXIT_ACCELERATION),
    ):
        ahead.reserve_zone(row, 0, at_end, 50.0, 0.2)
        left2 = (0.64 - share * share) / (1.0 - share * share)
        assert row[column] == pytest.approx(LIMIT_A * math.sqrt(left2))


@pytest.mark.parametrize(
    ("over_v", "over_max_v", "keeps"), [(0.0, 0.0, 1), (1e-9, 0.0, 0), (0.0, 1e-9, 0)]
)
def test_a_promise_is_kept_to_the_last_bit(over_v: float, over_max_v: float, keeps: int) -> None:
    """The current segment may end with just the speed that the next one can still brake from."""
    ahead = look_ahead()
    ahead.resize(8)
    both = segments(2)
    row = rows.segment_width(2)
    both[row + rows.PREDECESSOR] = 1.0
    both[row + rows.LENGTH] = 0.02
    both[row + rows.ACCELERATION] = LIMIT_A
    both[row + rows.SPEED], both[row + rows.MAX_SPEED] = 5.0, 500.0
    entry_v, max_entry_v = 5.0, math.sqrt(2.0 * LIMIT_A * 0.02)
    assert max_entry_v > entry_v
    result = ahead.spread(both, 1, 1, entry_v + over_v, max_entry_v + over_max_v)
    assert result == keeps


def test_the_look_ahead_goes_back_until_both_speeds_stay() -> None:
    """The highest speed at an end rises where the one under the feed is as before."""
    ahead = look_ahead()
    ahead.resize(8)
    four = segments(4)
    width = rows.segment_width(2)
    for number in range(4):
        row = number * width
        four[row + rows.PREDECESSOR] = 1.0 if number else 0.0
        four[row + rows.LENGTH] = 0.02
        four[row + rows.ACCELERATION] = LIMIT_A
        four[row + rows.SPEED], four[row + rows.MAX_SPEED] = 5.0, 500.0
        four[row + rows.CORNER_SPEED] = 1e300
        four[row + rows.END_SPEED] = 5.0
        four[row + rows.MAX_END_SPEED] = 5.0
    assert ahead.spread(four, 3, 0, -1.0, -1.0) == 1
    ends = [four[number * width + rows.MAX_END_SPEED] for number in range(3)]
    assert ends == pytest.approx([math.sqrt(2.0 * LIMIT_A * 0.02 * n) for n in (3, 2, 1)])
    assert [four[number * width + rows.END_SPEED] for number in range(3)] == [5.0] * 3


def test_an_override_above_one_may_drive_an_arc_faster_than_its_feed() -> None:
    """P-CHAN-00056: at most ``max_factor`` times the feed, with a limit of the jerk, too."""
    limits = SegmentLimits(2, 1000, 2.0)
    for axis in range(2):
        limits.limit(axis, True, (500.0, 500.0), (LIMIT_A, LIMIT_A))
        limits.limit_slope(axis, (LIMIT_A, LIMIT_A), (1e5, 1e5))
    row = segments(1)
    row[rows.SHAPE] = rows.ARC
    row[rows.HAS_JERK_LIMIT] = 1.0
    row[rows.ARC_SECOND_AXIS] = 1.0
    row[rows.ARC_ANGLE] = 180.0
    row[rows.START], row[rows.START + 2] = 50.0, -50.0
    row[rows.SPEED] = 10.0
    limits.measure(row, 0)
    assert row[rows.LENGTH] == pytest.approx(50.0 * math.pi)
    assert row[rows.MAX_SPEED] == pytest.approx(20.0)
    assert row[rows.JERK] <= 1e5


def jerk_limited(axes: int = 2) -> LookAhead:
    """A preparation of axes with a limit of the jerk."""
    ahead = look_ahead(axes)
    for axis in range(axes):
        ahead.limits.limit_slope(axis, (LIMIT_A, LIMIT_A), (1e5, 1e5))
    return ahead


@pytest.mark.parametrize(("is_rounded", "speed"), [(True, 50.0), (False, 1e300)])
def test_a_straight_segment_after_a_rounding_takes_three_ticks(
    is_rounded: bool, speed: float
) -> None:
    """0.15 mm in 3 ms; without a rounding nothing limits the speed where nothing turns."""
    ahead = jerk_limited()
    both = segments(2)
    row = rows.segment_width(2)
    for at in (0, row):
        both[at + rows.LENGTH] = 0.15
        both[at + rows.SPEED] = both[at + rows.MAX_SPEED] = 100.0
        both[at + rows.ACCELERATION], both[at + rows.JERK] = LIMIT_A, 1e5
    ahead.corner.entering[0] = ahead.corner.leaving[0] = 1.0
    ahead.corner.set_steps()
    ahead.corner.last_is_rounded = is_rounded
    ahead.jerk.join(both, 0, row)
    assert both[rows.CORNER_SPEED] == pytest.approx(speed)


def test_from_a_line_into_an_arc_the_jerk_of_the_step_is_used_up() -> None:
    """v²/r begins within a tick: it takes v²/r·(3/4 + share of the shortest segment)/T of it."""
    ahead = jerk_limited()
    both = segments(2)
    row = rows.segment_width(2)
    for at in (0, row):
        both[at + rows.LENGTH] = 20.0
        both[at + rows.SPEED] = both[at + rows.MAX_SPEED] = 100.0
        both[at + rows.ACCELERATION], both[at + rows.JERK] = LIMIT_A, 1e5
    both[rows.SPEED] = 300.0
    both[row + rows.SHAPE] = rows.ARC
    both[row + rows.ARC_SECOND_AXIS] = 1.0
    both[row + rows.ARC_SECOND_CENTRE] = 200.0
    both[row + rows.ARC_ANGLE] = math.degrees(0.1)
    both[row + rows.START + 2] = 200.0 * math.sin(0.1)
    both[row + rows.START + 3] = 200.0 * (1.0 - math.cos(0.1))
    ahead.corner.entering[0] = ahead.corner.leaving[0] = 1.0
    ahead.corner.set_steps()
    ahead.jerk.join(both, 0, row)
    max_a = 1e5 * TICK_T * 0.7
    assert both[rows.CORNER_SPEED] == pytest.approx(math.sqrt(max_a * 200.0 / 0.75), rel=0.01)
    speed = ahead.corner.corner_v
    assert speed == 100.0
    turn_a = speed * speed / 200.0 * (0.75 + speed * TICK_T / 20.0)
    assert ahead.corner.turns[1] == pytest.approx(turn_a / TICK_T)
    assert ahead.corner.turns[0] == ahead.corner.shares[1] == 0.0
    assert both[rows.JERK] == 1e5


@pytest.mark.parametrize(
    ("feeds", "exempt", "corner_v", "moved"),
    [
        ((100.0, 60.0), (0, 0), 1e300, (60.0, rows.FEED_GOAL)),
        ((60.0, 100.0), (0, 0), 1e300, None),
        ((60.0, 100.0), (1, 1), 1e300, None),
        ((60.0, 100.0), (0, 1), 1e300, (100.0, rows.EXEMPT_FEED_GOAL)),
        ((60.0, 100.0), (1, 0), 1e300, (100.0, rows.FEED_GOAL)),
        ((100.0, 60.0), (0, 0), 20.0, (20.0, rows.LIMIT_GOAL)),
        ((60.0, 100.0), (0, 0), 20.0, (20.0, rows.LIMIT_GOAL)),
    ],
)
def test_what_slows_the_path_before_a_segment(
    feeds: tuple[float, float],
    exempt: tuple[int, int],
    corner_v: float,
    moved: tuple[float, int] | None,
) -> None:
    """A lower feed, one of another override (G166), a corner; none where the braking for the goal
    ahead has begun by then.
    """
    ahead = jerk_limited()
    both = segments(2)
    row = rows.segment_width(2)
    for at, feed, is_exempt in zip((0, row), feeds, exempt, strict=True):
        both[at + rows.SPEED] = feed
        both[at + rows.MAX_SPEED] = 500.0
        both[at + rows.IGNORES_OVERRIDE] = is_exempt
    found: list[tuple[float, int]] = []
    goal: Any = SimpleNamespace(
        distance_d=0.5,
        braking_distance=lambda _speed: 1.0,
        safe_speed=lambda speed: speed,
        move=lambda speed, kind: found.append((speed, kind)),
    )
    ahead.jerk.slow_before(goal, both, 0, row, corner_v)
    assert found == []
    goal.distance_d = 1000.0
    ahead.jerk.slow_before(goal, both, 0, row, corner_v)
    assert found == ([] if moved is None else [moved])


def test_a_rounding_has_the_pace_of_the_segment_before_it() -> None:
    """Its block, its feed, twice the half; both lines are shortened and meet it."""
    ahead = jerk_limited()
    both = segments(2)
    row = rows.segment_width(2)
    for at, feed in ((0, 30.0), (row, 70.0)):
        both[at + rows.SPEED] = feed
        both[at + rows.SOURCE] = feed + 1.0
        both[at + rows.BLOCK_NUMBER] = feed + 2.0
        both[at + rows.LENGTH] = 10.0
    both[rows.SPEED_OVERRIDE] = 0.5
    both[row + rows.START] = 10.0
    ahead.corner.leaving[0], ahead.corner.entering[1] = 1.0, 1.0
    rounding = ahead.rounding.row
    ahead.rounding.put_rounding(both, 0, row, 2.0)
    assert [rounding[one] for one in (rows.SPEED, rows.SOURCE, rows.BLOCK_NUMBER)] == [30, 31, 32]
    assert (rounding[rows.LENGTH], rounding[rows.SPEED_OVERRIDE]) == (4.0, 0.5)
    assert [rounding[rows.START + i] for i in range(4)] == [8.0, 0.0, 10.0, 2.0]
    assert [both[rows.LENGTH], both[row + rows.LENGTH]] == [8.0, 8.0]
    assert [both[row + rows.START + i] for i in range(2)] == [10.0, 2.0]
    assert both[rows.CONTINUES] == 1.0


@pytest.mark.parametrize(
    ("speed", "saves", "made"), [(0.0, 1, 0), (50.0, 0, 0), (50.0, 1, 1), (0.0, 0, 0)]
)
def test_a_rounding_is_made_where_it_fits_and_saves_time(
    speed: float, saves: int, made: int
) -> None:
    """Neither a corner that is passed as fast nor one that a stop passes sooner has one."""
    ahead = jerk_limited()
    rounding: Any = ahead.rounding
    both = segments(2)
    row = rows.segment_width(2)
    both[row + rows.JERK] = 1e5
    ahead.corner.last_deviation = 0.1
    rounding.rounding_half = lambda *_: 1.0
    rounding.rounding_speed = lambda *_: speed
    rounding.saves_time = lambda *_: saves
    assert rounding.round(both, 0, row, 3) == made
    assert both[row + rows.PREDECESSOR] == 3.0 * made
    both[rows.SHAPE] = rows.ARC
    assert rounding.round(both, 0, row, 3) == 0


def test_a_rounding_that_is_taken_back_leaves_both_segments_as_they_were() -> None:
    """Each column of both, but for the command that the second one continues."""
    ahead = jerk_limited()
    rounding: Any = ahead.rounding
    both = segments(2)
    row = rows.segment_width(2)
    both[row + rows.JERK] = 1e5
    for column in (rows.LENGTH, rows.SPEED, rows.ACCELERATION, rows.START, rows.START + 3):
        both[column], both[row + column] = 10.0 + column, 200.0 + column
    kept = list(both)
    ahead.corner.last_deviation = 0.1
    rounding.rounding_half = rounding.rounding_speed = rounding.saves_time = lambda *_: 1.0
    rounding.limit_rounding = lambda *_: None
    rounding.put_rounding = lambda *_: None
    assert rounding.round(both, 0, row, 3) == 1
    for i in range(2 * row):
        both[i] = -1.0
    rounding.restore(both, 0, row)
    kept[row + rows.PREDECESSOR] = 3.0
    assert list(both) == kept


def test_on_a_rounding_the_turn_takes_its_part_of_acceleration_and_jerk() -> None:
    """v²·step/half and v³·step/half² of the axis, each with 2 % left over."""
    ahead = jerk_limited()
    both = segments(2)
    row = rows.segment_width(2)
    for at in (0, row):
        both[at + rows.ACCELERATION], both[at + rows.JERK] = 1e9, 1e9
    ahead.corner.steps[0] = 0.5
    ahead.corner.leaving[0], ahead.corner.entering[0] = 1.0, 0.5
    ahead.rounding.limit_rounding(both, 0, row, 4.0, 20.0)
    left_a = 0.98 * (LIMIT_A - 20.0**2 * 0.5 / 4.0)
    left_j = 0.5 * 0.98 * (1e5 - 20.0**3 * 0.5 / 16.0)
    turning_a = left_j * 4.0 / (3.0 * 20.0 * 0.5)
    assert ahead.rounding.row[rows.ACCELERATION] == pytest.approx(min(left_a, turning_a))
    assert ahead.rounding.row[rows.JERK] == pytest.approx(left_j)
    assert ahead.rounding.row[rows.MAX_SPEED] == 20.0


def travelled(speed: float, target_v: float, limit_a: float, limit_j: float) -> float:
    """Length in mm of a change of speed without acceleration at both ends: the mean speed long."""
    change = abs(target_v - speed)
    time = change / limit_a + limit_a / limit_j
    if change < limit_a * limit_a / limit_j:
        time = 2.0 * math.sqrt(change / limit_j)
    return 0.5 * (speed + target_v) * time


@pytest.mark.parametrize("speed", [10.0, 12.0, 30.0, 200.0])
@pytest.mark.parametrize("carried_a", [0.0, 50.0, 1e6])
def test_slowing_begins_when_the_acceleration_has_faded(speed: float, carried_a: float) -> None:
    """What fades lasts a/j, at most from a standstill; then an S-curve down to the goal's speed."""
    goal = Goal()
    goal.distance_d, goal.speed_v, goal.acceleration_a, goal.jerk_j = 0.0, 10.0, 100.0, 1000.0
    goal.carried_a, goal.carried_j = carried_a, 500.0
    time = min(carried_a / 500.0, math.sqrt(2.0 * speed / 500.0))
    fading_d = speed * time - 500.0 * time**3 / 6.0
    expected = fading_d + travelled(speed, 10.0, 100.0, 1000.0) if speed > 10.0 else 0.0
    assert goal.slowing_distance(speed) == pytest.approx(expected)


@pytest.mark.parametrize(
    ("start_a", "speed_v", "fading_j"),
    [
        (0.0, 10.0, 0.0),
        (-100.0, 10.0, 0.0),
        (-100.0, 2.0, 2500.0),
        (-100.0, 0.0, 77.0),
        (100.0, 40.0, 0.0),
        (100.0, 46.0, 77.0),
    ],
)
def test_an_acceleration_fades_in_time(start_a: float, speed_v: float, fading_j: float) -> None:
    """a²/2j of speed: down to a standstill with just the jerk that it takes, up to the limit with
    that of the segment.
    """
    profile: Any = JerkProfile(TICK_T)
    profile.own_j = 77.0
    profile.acceleration_a = start_a
    planned: list[tuple[float, ...]] = []

    def plan_passing(*values: float) -> int:
        planned.append(values)
        return 1

    profile.course = SimpleNamespace(plan_passing=plan_passing)
    assert profile.head_for(5.0, 1.0, speed_v, 50.0, 300.0, 1000.0) == 1
    assert planned == [(0, 5.0, speed_v, start_a, 50.0, 1.0, 300.0, 1000.0, fading_j)]
