# SPDX-License-Identifier: MIT
"""One coordinate's profile: limits kept, end reached, no time lost (MO-1, MO-2, MO-5)."""

from __future__ import annotations

import math

import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st
from support.random_seeds import examples

from nctakt.kernel.path.trapezoid_profile import TrapezoidProfile

often = settings(max_examples=examples(300), deadline=None, derandomize=True, database=None)

lengths = st.floats(1e-4, 1e4)
some_speeds = st.one_of(st.just(0.0), st.floats(1e-3, 600.0))
limits = st.floats(1e-2, 600.0)
accelerations = st.floats(1.0, 20_000.0)


def planned(
    length: float, start: float, end: float, limit: float, slope: float
) -> TrapezoidProfile:
    """A profile with this plan."""
    profile = TrapezoidProfile()
    profile.prepare(length, start, end, limit, slope)
    return profile


def samples(duration: float, count: int = 200) -> list[float]:
    """Times from 0 to the end."""
    return [duration * i / count for i in range(count + 1)]


def assert_is_a_motion(profile: TrapezoidProfile, slope: float, highest: float) -> None:
    """Continuous, forward, with the speed as its slope, within the limits."""
    times = samples(profile.duration_t)
    at = [profile.at(time) for time in times]
    tolerance = 1e-9 * (1.0 + profile.length_d)
    fuzz = 1e-9 * (1.0 + highest) + 1e-15 * slope * profile.duration_t
    for (x0, v0), (x1, v1), t0, t1 in zip(at, at[1:], times, times[1:], strict=False):
        step = t1 - t0
        assert abs(v1 - v0) <= slope * step + fuzz
        assert -fuzz <= v1 <= highest + fuzz
        assert x1 >= x0 - tolerance
        # Within one sample the mean speed lies between its bounds.
        assert (min(v0, v1) - slope * step) * step <= x1 - x0 + tolerance
        assert x1 - x0 <= (max(v0, v1) + slope * step) * step + tolerance


@often
@given(lengths, some_speeds, some_speeds, limits, accelerations)
def test_a_profile_keeps_its_limits_and_reaches_its_end(
    length: float, start: float, end: float, limit: float, slope: float
) -> None:
    """From any speed the way is covered exactly, with no more speed and slope than allowed."""
    assume(start <= limit)
    assume(start * start - min(end, limit) ** 2 <= 2.0 * slope * length * 0.999)
    profile = planned(length, start, end, limit, slope)
    assert profile.at(0.0) == (0.0, start)
    covered, speed = profile.at(profile.duration_t)
    assert covered == pytest.approx(length, rel=1e-9, abs=1e-9)
    assert speed == pytest.approx(profile.end_v, abs=1e-6 * (1.0 + limit))
    assert profile.end_v <= min(end, limit)
    assert_is_a_motion(profile, slope, limit)


def shortest(length: float, start: float, end: float, limit: float, slope: float) -> float:
    """The optimum: as fast as the limit, or as the way allows, in between."""
    peak = math.sqrt((2 * slope * length + start * start + end * end) / 2)
    if peak <= limit:
        return (2 * peak - start - end) / slope
    changing = (2 * limit * limit - start * start - end * end) / (2 * slope)
    return (2 * limit - start - end) / slope + (length - changing) / limit


@often
@given(lengths, some_speeds, some_speeds, limits, accelerations)
@example(1.0, 0.0, 0.0, 500.0, 4000.0)
@example(300.0, 0.0, 0.0, 500.0, 4000.0)
def test_no_profile_is_faster(
    length: float, start: float, end: float, limit: float, slope: float
) -> None:
    """The duration is the analytic optimum, far better than the 1 % of MO-2."""
    assume(max(start, end) <= limit)
    assume(abs(start * start - end * end) <= 2.0 * slope * length * 0.999)
    profile = planned(length, start, end, limit, slope)
    assert profile.end_v == end
    expected = shortest(length, start, end, limit, slope)
    assert profile.duration_t == pytest.approx(expected, rel=1e-9, abs=1e-12)


@often
@given(lengths, some_speeds, limits, accelerations)
def test_an_end_speed_that_cannot_be_gained_is_lowered(
    length: float, start: float, limit: float, slope: float
) -> None:
    """On a way too short to accelerate the end is passed with what was gained, no way too far."""
    assume(start <= limit)
    profile = planned(length, start, 1e4, 1e4, slope)
    assert profile.end_v == pytest.approx(min(1e4, math.sqrt(start**2 + 2 * slope * length)))
    covered, _ = profile.at(profile.duration_t)
    assert covered == pytest.approx(length, rel=1e-9, abs=1e-9)
    assert_is_a_motion(profile, slope, 1e4)


@often
@given(lengths, limits, limits, accelerations)
def test_a_stop_on_a_short_rest_goes_on_after_its_end(
    length: float, start: float, end: float, slope: float
) -> None:
    """With a limit of 0 the path brakes at its slope, and passes the end where it must (MO-6)."""
    rest = start * start - 2.0 * slope * length
    assume(rest <= end * end)
    profile = planned(length, start, end, 0.0, slope)
    if rest < 0.0:
        assert profile.is_endless
        stop = start * start / (2.0 * slope)
        covered, speed = profile.at(start / slope + 1.0)
        assert covered == pytest.approx(stop, rel=1e-9)
        assert speed == 0.0
        assert covered <= length * (1 + 1e-12)
    else:
        assert not profile.is_endless
        assert profile.end_v == pytest.approx(math.sqrt(rest), abs=1e-6)
        assert profile.at(profile.duration_t)[0] == pytest.approx(length, rel=1e-9, abs=1e-9)
        assert_is_a_motion(profile, slope * (1 + 1e-6), start)


@often
@given(some_speeds, some_speeds, limits)
def test_no_travel_takes_no_time(start: float, end: float, limit: float) -> None:
    """A rest of nothing, or less by a rounding, ends at once, also from a standstill."""
    for length in (0.0, -1e-17):
        profile = planned(length, start, end, limit, 4000.0)
        assert profile.duration_t == 0.0
        assert not profile.is_endless
        assert profile.end_v == min(start, end)


changes = st.lists(
    st.tuples(st.floats(1e-4, 0.2), st.one_of(st.just(0.0), st.floats(0.1, 600.0))),
    min_size=1,
    max_size=12,
)


@pytest.mark.slow
@often
@given(lengths, changes, accelerations, st.one_of(st.just(0.0), limits))
def test_a_new_limit_at_any_time_changes_nothing_but_what_follows(
    length: float, steps: list[tuple[float, float]], slope: float, end: float
) -> None:
    """Replanned with any limit, position and speed go on without a step to the end (MO-5)."""
    covered, speed = 0.0, 0.0
    highest = max(limit for _, limit in steps) + 1.0
    profile = TrapezoidProfile()
    for time, limit in [*steps, (math.inf, highest)]:
        profile.prepare(length - covered, speed, end, limit, slope)
        assert profile.at(0.0) == (0.0, speed)
        if not profile.is_endless:
            assert_is_a_motion(profile, slope * (1 + 1e-6), max(highest, speed))
        lasting = min(time, profile.duration_t) if not profile.is_endless else time
        way, speed = profile.at(lasting)
        covered += way
        assert covered <= length * (1 + 1e-9) + 1e-9
        assert -1e-6 <= speed <= highest + 1e-6
        if not profile.is_endless and lasting == profile.duration_t:
            break
        speed = max(speed, 0.0)
    assert covered == pytest.approx(length, rel=1e-6)
    assert speed <= max(end, 1e-3) * (1 + 1e-6)
