# SPDX-License-Identifier: MIT
"""Single decisions of the speed on an arc whose limits go by its angle (MO-1, MO-2).

What is called here cannot be seen from Python where it is compiled: the tests run in plain mode.
"""

from __future__ import annotations

import math
from random import Random

import pytest

from nctakt.base import mode
from nctakt.kernel import rows
from nctakt.kernel.path.arc_speed import ArcSpeed
from nctakt.kernel.path.trapezoid_profile import TrapezoidProfile

pytestmark = pytest.mark.skipif(mode.is_compiled(), reason="compiled methods cannot be called")

LIMIT_V, LIMIT_A, RADIUS, PIECES = 500.0, 1000.0, 20.0, 12


def quarter() -> ArcSpeed:
    """A quarter of a circle of 20 mm from +X on, of two axes that are alike."""
    arc = ArcSpeed(2, TrapezoidProfile())
    for axis in range(2):
        arc.max_v[axis], arc.max_a[axis] = LIMIT_V, LIMIT_A
    row = memoryview(bytearray(8 * rows.segment_width(2))).cast("d")
    row[rows.SHAPE] = rows.ARC
    row[rows.ARC_SECOND_AXIS] = 1.0
    row[rows.ARC_ANGLE] = 90.0
    row[rows.ARC_PIECES] = PIECES
    row[rows.LENGTH] = RADIUS * math.pi / 2.0
    row[rows.START] = RADIUS
    row[rows.START + 3] = RADIUS
    arc.begin(row, 0)
    return arc


def test_the_borders_of_the_pieces_lie_on_the_circle() -> None:
    """The parts of both axes turn with the angle; their change points to the centre."""
    arc = quarter()
    for j in range(PIECES + 1):
        turn = arc.ends[j] / RADIUS
        assert arc.first_parts[j] == pytest.approx(-math.sin(turn), abs=1e-12)
        assert arc.second_parts[j] == pytest.approx(math.cos(turn), abs=1e-12)
        assert arc.first_curvatures[j] == pytest.approx(-math.cos(turn) / RADIUS, abs=1e-12)
        assert arc.second_curvatures[j] == pytest.approx(-math.sin(turn) / RADIUS, abs=1e-12)
    assert arc.ends[PIECES] == pytest.approx(RADIUS * math.pi / 2.0)


def test_a_survey_is_made_anew_for_each_pair_of_speeds() -> None:
    """The highest speed at the end and the wanted one each count; braking adds up backwards."""
    arc = quarter()
    for pair in ((100.0, 50.0), (100.0, 30.0), (80.0, 30.0), (80.0, 90.0), (0.0, 0.0)):
        arc.survey(*pair)
        fresh = quarter()
        fresh.survey(*pair)
        assert list(arc.highs) == list(fresh.highs)
        assert list(arc.lows) == list(fresh.lows)
        assert arc.highs[PIECES] == min(pair[0] ** 2, arc.caps[PIECES - 1])
        assert arc.lows[PIECES] == min(min(pair) ** 2, arc.caps[PIECES - 1])
        assert all(low <= high for low, high in zip(arc.lows, arc.highs, strict=True))


@pytest.mark.parametrize("seed", range(200))
def test_a_plan_fills_the_piece_within_its_limits(seed: int) -> None:
    """From any speed that can be kept: the ramps and the cruise are as long as what is left, no
    ramp is steeper than the axes allow, and the end is one from which the rest can be braked.
    """
    random = Random(seed)
    arc = quarter()
    arc.survey(random.choice([0.0, 40.0, 120.0]), random.choice([0.0, 20.0, 120.0]))
    stage = random.randrange(PIECES)
    length_d = arc.ends[stage + 1] - arc.ends[stage]
    rest_d = length_d * random.choice([1.0, random.random()])
    highest2 = arc.highs[stage + 1]
    highest2 += 2.0 * rest_d * arc.rate(stage, highest2, 2.0 * rest_d, -1.0)
    start_v = math.sqrt(min(highest2, arc.caps[stage])) * random.choice([0.0, 0.3, 0.9, 1.0])
    limit_v = random.choice([10.0, 60.0, 500.0])
    arc.plan(stage, rest_d, start_v, limit_v)
    profile = arc.profile
    assert profile.position(profile.duration_t) == pytest.approx(rest_d, rel=1e-9)
    last_t = profile.duration_t - profile.first_t - profile.cruise_t
    last_d = 0.5 * (profile.cruise_v + profile.end_v) * last_t
    assert profile.first_d + profile.cruise_d + last_d == pytest.approx(rest_d, rel=1e-9)
    assert profile.end_v**2 <= arc.highs[stage + 1] * (1.0 + 1e-6)
    for ramp_a, from_v, to_v in (
        (profile.first_a, start_v, profile.cruise_v),
        (-profile.last_a, profile.cruise_v, profile.end_v),
    ):
        side = 1.0 if ramp_a > 0.0 else -1.0
        limit_a = min(arc.rate(stage, v * v, 0.0, side) for v in (from_v, to_v))
        assert abs(ramp_a) <= max(limit_a, 1e-6) / arc.keeps[stage] + 1e-6
    top_v = max(start_v, math.sqrt(min(limit_v**2, arc.caps[stage])))
    assert max(profile.cruise_v, profile.end_v) <= top_v * (1.0 + 1e-9)


def test_on_half_a_piece_the_speed_rises_as_far_as_it_can_be_braked() -> None:
    """From rest to rest: both ramps as steep as the arc allows, no cruise between them."""
    arc = quarter()
    arc.survey(0.0, 0.0)
    stage = PIECES - 1
    rest_d = 0.5 * (arc.ends[stage + 1] - arc.ends[stage])
    arc.plan(stage, rest_d, 0.0, 500.0)
    first_a, last_a = (arc.rate(stage, 0.0, 0.0, side) for side in (1.0, -1.0))
    top_v2 = 2.0 * rest_d * first_a * last_a / (first_a + last_a)
    assert arc.profile.cruise_v**2 <= top_v2 * (1.0 + 1e-9)
    assert arc.profile.cruise_v**2 >= 0.8 * top_v2
    assert arc.profile.cruise_d == pytest.approx(0.0, abs=1e-9)
    assert arc.profile.end_v == 0.0


def test_above_its_limit_the_path_brakes_to_it_at_once() -> None:
    """An override that has fallen: a ramp to the limit, then the limit, where nothing ends."""
    arc = quarter()
    arc.survey(500.0, 500.0)
    stage, rest_d = 6, arc.ends[7] - arc.ends[6]
    arc.plan(stage, rest_d, 50.0, 48.0)
    rate = min(arc.rate(stage, v * v, 0.0, -1.0) for v in (50.0, 48.0))
    assert arc.profile.first_d == pytest.approx(0.5 * (50.0**2 - 48.0**2) / rate)
    assert (arc.profile.cruise_v, arc.profile.end_v) == (pytest.approx(48.0), pytest.approx(48.0))
    arc.plan(stage, 0.01, 50.0, 10.0)
    assert arc.profile.cruise_d == pytest.approx(0.0, abs=1e-12)
    assert 49.0 < arc.profile.end_v < 50.0
