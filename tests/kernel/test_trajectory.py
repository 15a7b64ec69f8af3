# SPDX-License-Identifier: MIT
"""The motion of one axis in closed form (MO-11): by hand, within its limits, against an oracle.

The oracle is ``ruckig``, where it is installed: another implementation of time-optimal motions with
limited jerk. Plain Python takes a tenth of the cases.
"""

from __future__ import annotations

import importlib
import importlib.util
import itertools
import math
import random
from dataclasses import dataclass
from typing import Any

import pytest

from nctakt.base.mode import is_compiled
from nctakt.kernel.axes.trajectory import Trajectories

TICK_T = 0.001
CASES = 10_000 if is_compiled() else 1_000

needs_ruckig = pytest.mark.skipif(
    importlib.util.find_spec("ruckig") is None, reason="the oracle ruckig is not installed"
)


@dataclass(frozen=True, slots=True)
class Case:
    """A start, a way and limits; jerk 0 is a trapezoid."""

    distance: float
    v: float
    a: float
    top: float
    rise: float
    jerk: float


def random_case(chance: random.Random, plans: Trajectories, *, jerky: bool = True) -> Case:
    """Any state, speeds up to twice the limit; often a way near the one that braking takes."""
    top = 10 ** chance.uniform(0, 3)
    rise = 10 ** chance.uniform(1, 4.5)
    jerk = rise / 10 ** chance.uniform(-3.3, 0) if jerky else 0.0
    v = chance.uniform(-top, top) * chance.choice((0, 1, 1, 2))
    a = chance.uniform(-rise, rise) * chance.choice((0, 1)) if jerky else 0.0
    distance = chance.choice((-1, 1)) * 10 ** chance.uniform(-4, 3.5)
    if chance.random() < 0.3:
        stopping_t = plans.prepare_speed(0.0, v, a, rise, jerk)
        distance = plans.at(stopping_t)[0] + chance.choice((-1, 1)) * 10 ** chance.uniform(-6, 1)
    return Case(distance, v, a, top, rise, jerk)


def plan(plans: Trajectories, case: Case) -> float:
    return plans.prepare_distance(case.distance, case.v, case.a, case.top, case.rise, case.jerk)


# --- by hand -----------------------------------------------------------------------------------


def test_a_trapezoid_by_hand() -> None:
    """100 mm at 50 mm/s, 500 mm/s²: 0.1 s and 2.5 mm to accelerate, 95 mm in 1.9 s, 0.1 s."""
    plans = Trajectories(1)
    assert plans.prepare_distance(100.0, 0.0, 0.0, 50.0, 500.0, 0.0) == pytest.approx(2.1)
    assert plans.at(0.05) == pytest.approx((0.625, 25.0, 500.0))
    assert plans.at(1.1) == pytest.approx((52.5, 50.0, 0.0))
    assert plans.at(2.05) == pytest.approx((99.375, 25.0, -500.0))
    assert plans.at(2.1) == pytest.approx((100.0, 0.0, 0.0))


def test_a_trapezoid_that_turns_round() -> None:
    """At 20 mm/s away from the target, 100 mm/s²: 0.2 s and 2 mm to stop.

    Then 27 mm from rest to rest with a highest speed of 51.96 mm/s: 2·√(27/100) s.
    """
    plans = Trajectories(1)
    found = plans.prepare_distance(-25.0, 20.0, 0.0, 100.0, 100.0, 0.0)
    assert found == pytest.approx(0.2 + 2 * math.sqrt(0.27))
    assert plans.at(0.2)[0] == pytest.approx(2.0)


def test_seven_phases_by_hand() -> None:
    """100 mm at 50 mm/s, 500 mm/s², 5000 mm/s³: ramps of 0.1 s, no constant acceleration.

    The acceleration builds up and fades in 0.1 s each, 50 mm/s after 0.2 s and 5 mm; 90 mm at
    50 mm/s take 1.8 s; 0.2 s to brake. At 0.1 s: 5000/6·0.001 mm, 25 mm/s, 500 mm/s².
    """
    plans = Trajectories(1)
    assert plans.prepare_distance(100.0, 0.0, 0.0, 50.0, 500.0, 5000.0) == pytest.approx(2.2)
    assert plans.at(0.1) == pytest.approx((5.0 / 6.0, 25.0, 500.0))
    assert plans.at(0.2) == pytest.approx((5.0, 50.0, 0.0))
    assert plans.at(2.0) == pytest.approx((95.0, 50.0, 0.0))
    assert plans.at(2.1) == pytest.approx((100.0 - 5.0 / 6.0, 25.0, -500.0))


def test_a_constant_acceleration_between_ramps() -> None:
    """To 100 mm/s with 500 mm/s² and 5000 mm/s³: 0.1 s up, 0.1 s constant, 0.1 s down."""
    plans = Trajectories(1)
    assert plans.prepare_speed(100.0, 0.0, 0.0, 500.0, 5000.0) == pytest.approx(0.3)
    assert plans.at(0.15) == pytest.approx((5.0 / 6.0 + 25.0 * 0.05 + 250.0 * 0.0025, 50.0, 500.0))
    assert plans.at(0.3) == pytest.approx((15.0, 100.0, 0.0))
    assert plans.at(1.3) == pytest.approx((115.0, 100.0, 0.0))


def test_a_short_way_with_jerk_only() -> None:
    """Four ramps of t each cover 2·j·t³: 16 mm with 1000 mm/s³ take four times 0.2 s."""
    plans = Trajectories(1)
    assert plans.prepare_distance(16.0, 0.0, 0.0, 500.0, 4000.0, 1000.0) == pytest.approx(0.8)
    assert plans.at(0.4) == pytest.approx((8.0, 40.0, 0.0), abs=1e-6)


def test_no_travel_takes_no_time() -> None:
    """A target where the axis is at rest."""
    plans = Trajectories(1)
    assert plans.prepare_distance(0.0, 0.0, 0.0, 500.0, 4000.0, 0.0) == 0.0
    assert plans.prepare_distance(0.0, 0.0, 0.0, 500.0, 4000.0, 80_000.0) == 0.0


# --- properties --------------------------------------------------------------------------------


def assert_within_limits(plans: Trajectories, case: Case, duration_t: float) -> None:
    """Speed, acceleration and jerk between some instants, no step, the end where it should be.

    What the start exceeds already may be exceeded until it is braked.
    """
    highest = max(case.top, abs(case.v))
    if case.jerk:
        highest = max(highest, abs(case.v + case.a * abs(case.a) / (2 * case.jerk)))
    ticks = min(max(8, math.ceil(duration_t / TICK_T)), 120)
    step_t = duration_t / ticks
    before = (0.0, case.v, case.a)
    for k in range(1, ticks + 1):
        now = plans.at(k * step_t)
        assert abs(now[1]) <= highest * (1 + 1e-9) + 1e-6
        assert abs(now[2]) <= case.rise * (1 + 1e-9)
        assert abs(now[1] - before[1]) <= case.rise * step_t * (1 + 1e-6) + 1e-6
        assert abs(now[0] - before[0]) <= highest * step_t * (1 + 1e-6) + 1e-9
        if case.jerk:
            assert abs(now[2] - before[2]) <= case.jerk * step_t * (1 + 1e-6) + 1e-5 * case.rise
        before = now
    assert before[0] == pytest.approx(case.distance, rel=1e-9, abs=1e-8)
    assert abs(before[1]) <= 1e-6


@pytest.mark.parametrize("jerky", [False, True])
def test_limits_hold_in_every_tick_of_random_motions(jerky: bool) -> None:
    """MO-1, MO-11: from any state to any target."""
    plans = Trajectories(1)
    chance = random.Random(20_251_121)
    for _ in range(CASES // 4):
        case = random_case(chance, plans, jerky=jerky)
        assert_within_limits(plans, case, plan(plans, case))


def test_a_plan_anew_in_every_tick_keeps_the_first_one() -> None:
    """Bellman: planning anew from the state of now changes neither arrival nor limits."""
    plans = Trajectories(1)
    chance = random.Random(4)
    for _ in range(CASES // 200):
        case = random_case(chance, plans)
        first_t = plan(plans, case)
        ticks = 40
        place, v, a = 0.0, case.v, case.a
        for k in range(ticks):
            rest = Case(case.distance - place, v, a, case.top, case.rise, case.jerk)
            left_t = plan(plans, rest)
            assert left_t <= first_t * (ticks - k) / ticks + 1e-3 * first_t + 2 * TICK_T
            way, v, a = plans.at(first_t / ticks)
            place += way
        assert place == pytest.approx(case.distance, rel=1e-6, abs=1e-5)


def test_a_plan_anew_in_every_tick_of_braking_keeps_its_end() -> None:
    """MO-2, MO-11: what rounding leaves of speed and way while the axis brakes is not made more.

    Where acceleration only had to fade, rounding could ask for a second peak: the root of it.
    """
    plans = Trajectories(1)
    for way in range(20, 60):
        rest, v, a, k = float(way), 0.0, 0.0, 0
        first_t = plans.prepare_distance(rest, v, a, 100.0, 1000.0, 20_000.0)
        while (left_t := plans.prepare_distance(rest, v, a, 100.0, 1000.0, 20_000.0)) > TICK_T:
            assert k * TICK_T + left_t == pytest.approx(first_t, abs=1e-12)
            covered, v, a = plans.at(TICK_T)
            rest -= covered
            k += 1


def test_speeds_are_reached_within_the_limits() -> None:
    """Velocity motion and stop: from any state to any speed, the last speed exact."""
    plans = Trajectories(1)
    chance = random.Random(11)
    for jerky, _ in itertools.product((False, True), range(CASES // 10)):
        case = random_case(chance, plans, jerky=jerky)
        end = chance.uniform(-case.top, case.top) * chance.choice((0, 1))
        duration_t = plans.prepare_speed(end, case.v, case.a, case.rise, case.jerk)
        before = (0.0, case.v, case.a)
        for k in range(1, 41):
            now = plans.at(duration_t * k / 40)
            assert abs(now[2]) <= case.rise * (1 + 1e-9)
            step = abs(now[1] - before[1])
            assert step <= case.rise * duration_t / 40 * (1 + 1e-6) + 1e-6
            before = now
        assert plans.at(duration_t + 1.0)[1] == end


# --- the oracle --------------------------------------------------------------------------------


def oracle_duration_t(ruckig: Any, case: Case) -> float | None:
    """How long ruckig takes; ``None`` where it finds nothing."""
    wanted = ruckig.InputParameter(1)
    wanted.current_position, wanted.target_position = [0.0], [case.distance]
    wanted.current_velocity, wanted.current_acceleration = [case.v], [case.a]
    wanted.max_velocity, wanted.max_acceleration = [case.top], [case.rise]
    wanted.max_jerk = [case.jerk]
    found = ruckig.Trajectory(1)
    try:
        ruckig.Ruckig(1).calculate(wanted, found)
    except ruckig.RuckigError:
        return None
    return float(found.duration)


def test_a_way_that_just_misses_the_top_speed_takes_its_time() -> None:
    """MO-11: up to 3 mm/s and down again, one bit less than the way that this takes: 24.2 ms."""
    plans = Trajectories(1)
    duration_t = plans.prepare_distance(
        0.03628432967805994, 0.0, 0.0, 3.0, 4101.6212198957655, 82032.42439791533
    )
    assert duration_t == pytest.approx(4 * math.sqrt(3.0 / 82032.42439791533))


@needs_ruckig
def test_no_motion_is_longer_than_the_oracles() -> None:
    """Not over 1 % + 2 ticks longer than ruckig, from any state; ruckig fails in a few cases."""
    ruckig = importlib.import_module("ruckig")
    plans = Trajectories(1)
    chance = random.Random(4711)
    compared = 0
    for _ in range(CASES):
        case = random_case(chance, plans)
        duration_t = plan(plans, case)
        other_t = oracle_duration_t(ruckig, case)
        if other_t is not None:
            compared += 1
            assert duration_t <= 1.01 * other_t + 2 * TICK_T, case
    assert compared > 0.98 * CASES
