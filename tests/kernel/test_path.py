# SPDX-License-Identifier: MIT
"""The path over its segments: time carried over, overrides, holds, resets (MO-1 … MO-6, MO-14)."""

from __future__ import annotations

import itertools
import math
import random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.insides import loop_of
from support.kernel_rig import ACCELERATION, DEMO, RAPID, TICK_T, Rig, assert_within_limits
from support.random_seeds import examples

from nctakt.kernel import cells, codes, rows
from nctakt.run.controller import Controller, NcText

often = settings(max_examples=examples(60), deadline=None, derandomize=True, database=None)


def trapezoid(length: float, time: float, speed: float = RAPID) -> float:
    """The way after a time on a straight line from rest to rest, worked out by hand."""
    peak = min(speed, math.sqrt(ACCELERATION * length))
    ramp = peak / ACCELERATION
    cruise = (length - peak * ramp) / peak
    if time <= ramp:
        return ACCELERATION * time * time / 2
    if time <= ramp + cruise:
        return peak * ramp / 2 + peak * (time - ramp)
    left = 2 * ramp + cruise - time
    return length - ACCELERATION * left * left / 2


def duration(length: float, speed: float = RAPID) -> float:
    """How long that takes."""
    peak = min(speed, math.sqrt(ACCELERATION * length))
    return peak / ACCELERATION + length / peak


@pytest.mark.nightly
@pytest.mark.slow
@often
@given(st.floats(0.001, 200.0), st.sampled_from(["G00", "G01 F6000", "G01 F600", "G01 F30000"]))
def test_a_move_takes_its_duration_rounded_up(length: float, motion: str) -> None:
    """ceil(D/T) ticks, the profile at i·T after each, the programmed value at the end (MO-14)."""
    length = round(length, 4)
    speed = RAPID if motion == "G00" else float(motion.rpartition("F")[2]) / 60
    run = Controller(DEMO).run(
        NcText("p.nc", f"{motion} X{length:.4f}\nM30"), signals=["X.ACS.ACT_POS"]
    )
    exact = duration(length, speed) / TICK_T
    assert run.ticks - 1 == math.ceil(exact - 1e-6)
    assert run.trace is not None
    found = run.trace["X.ACS.ACT_POS"]
    assert found[run.ticks - 2] == length
    for tick in range(run.ticks - 2):
        expected = trapezoid(length, (tick + 1) * TICK_T, speed)
        assert found[tick] == pytest.approx(expected, abs=1e-9)


cuts = st.lists(st.floats(0.0005, 0.9995), min_size=1, max_size=12, unique=True)


@pytest.mark.slow
@often
@given(st.floats(0.5, 120.0), cuts, st.floats(5.0, 500.0))
def test_segments_without_stop_lose_no_time(
    length: float, parts: list[float], speed: float
) -> None:
    """A line in pieces, however short, moves tick by tick as the whole line does (RC-003)."""
    rig = Rig()
    places = [0.0, *sorted(part * length for part in parts), length]
    for place, following in itertools.pairwise(places):
        at_end = min(
            speed,
            math.sqrt(2 * ACCELERATION * following),
            math.sqrt(2 * ACCELERATION * (length - following)),
        )
        is_last = following == length
        rig.segment(
            following - place,
            speed=speed,
            end_speed=0.0 if is_last else at_end,
            exact_stop=is_last,
        )
    rig.run_to_the_end()
    ticks = rig.x.index(rig.end) + 1
    assert ticks == math.ceil(duration(length, speed) / TICK_T - 1e-6)
    for tick, found in enumerate(rig.x[: ticks - 1]):
        assert found == pytest.approx(trapezoid(length, (tick + 1) * TICK_T, speed), abs=1e-9)
    assert rig.x[-1] == rig.end


def winding_path(rig: Rig, chance: random.Random, count: int) -> float:
    """Segments that pass their ends with speeds that their neighbours allow; the highest speed."""
    lengths = [chance.choice((0.02, 0.3, 2.0, 9.0)) * (0.5 + chance.random()) for _ in range(count)]
    wanted = [chance.uniform(20.0, 400.0) for _ in range(count)]
    ends = [0.0] * (count + 1)
    for i in range(1, count):
        ends[i] = min(wanted[i - 1], wanted[i], chance.uniform(10.0, 500.0))
    for i in range(count - 1, 0, -1):
        ends[i] = min(ends[i], math.sqrt(ends[i + 1] ** 2 + 2 * ACCELERATION * lengths[i]))
    for i in range(count):
        rig.segment(
            lengths[i],
            speed=wanted[i],
            end_speed=ends[i + 1],
            exact_stop=i == count - 1,
        )
    return max(wanted)


@pytest.mark.parametrize("seed", range(12))
def test_overrides_and_holds_never_break_a_limit(seed: int) -> None:
    """Override and feed hold in any tick, over block ends too: no step in speed, the end exact."""
    chance = random.Random(seed)
    rig = Rig()
    highest = winding_path(rig, chance, 25)
    while rig.channel.queue.queued() or rig.channel.path.is_active:
        rig.run(chance.randint(1, 30))
        if len(rig.x) < 1500:
            rig.channel.panel.put(
                cells.PANEL_OVERRIDE, chance.choice((0.0, 3.0, 50.0, 100.0, 120.0))
            )
            rig.channel.panel.put(cells.PANEL_FEED_HOLD, chance.random() < 0.3)
        else:
            rig.channel.panel.put(cells.PANEL_OVERRIDE, 100.0)
            rig.channel.panel.put(cells.PANEL_FEED_HOLD, False)
        assert len(rig.x) < 20_000
    rig.run(1)
    assert_within_limits(rig.x, highest * 1.2)
    assert rig.x[-1] == rig.end


def test_an_override_step_acts_in_its_tick_within_the_acceleration() -> None:
    """50 % in mid-move: 4 mm/s less in each tick from then on, until half the speed (MO-5)."""
    rig = Rig()
    rig.segment(300.0)
    rig.run(200)
    rig.channel.panel.put(cells.PANEL_OVERRIDE, 50.0)
    rig.run(100)
    found = [
        (after - before) / TICK_T for before, after in zip(rig.x[198:], rig.x[199:], strict=False)
    ]
    assert found[0] == pytest.approx(500.0)
    for tick in range(1, 63):
        expected = max(500.0 - 4.0 * tick + 2.0, 250.0)
        assert found[tick] == pytest.approx(expected, abs=0.51 if tick == 63 else 1e-6)
    assert found[-1] == pytest.approx(250.0)
    rig.run_to_the_end()
    assert rig.x[-1] == 300.0


@pytest.mark.parametrize("seed", range(6))
def test_overrides_of_cycles_keep_the_limits(seed: int) -> None:
    """A cycle that writes another override at each of some positions: no step in speed (MO-5)."""
    chance = random.Random(seed)
    branches = "".join(
        f"$IF V.RTA.ACS.ACT_POS.X > {chance.uniform(0, 100):.3f}\n"
        f"V.RTG.OVERRIDE.VEL.CYCLE = {chance.choice((1, 5, 20, 50, 80, 110))}\n$ENDIF\n"
        for _ in range(6)
    )
    text = f"#RT CYCLE\n{branches}#RT CYCLE END\nG00 X100\nM30"
    run = Controller(DEMO).run(NcText("p.nc", text), signals=["X.ACS.ACT_POS"], ticks=100_000)
    assert run.state == "ended"
    assert run.trace is not None
    assert_within_limits(run.trace["X.ACS.ACT_POS"].tolist(), RAPID)
    assert run.trace.at(run.ticks - 1, "X.ACS.ACT_POS") == 100.0


def test_a_block_end_is_passed_with_the_override_that_holds() -> None:
    """At 50 % a block that passes its end with 100 mm/s passes it with 50: no jump there."""
    rig = Rig()
    rig.channel.panel.put(cells.PANEL_OVERRIDE, 50.0)
    rig.segment(10.0, speed=100.0, end_speed=100.0, exact_stop=False)
    rig.segment(10.0, speed=100.0)
    rig.run_to_the_end()
    assert_within_limits(rig.x, 50.0)


def test_an_override_step_after_a_block_end_counts_the_carried_time_once() -> None:
    """In the tick after a passed block end a new limit goes on from where the axes are."""
    rig = Rig()
    rig.segment(1.05, speed=100.0, end_speed=91.0, exact_stop=False)
    rig.segment(20.0, speed=100.0)
    while rig.channel.path.serial < 2:
        rig.run(1)
    rig.channel.panel.put(cells.PANEL_OVERRIDE, 90.0)
    rig.run_to_the_end()
    assert_within_limits(rig.x, 100.0)


def test_feed_hold_stops_over_block_ends_and_goes_on() -> None:
    """Held 0.4 mm before a block end at 400 mm/s: 20 mm of braking, over five blocks (MO-6)."""
    rig = Rig()
    rig.segment(60.0, speed=400.0, end_speed=400.0, exact_stop=False)
    for _ in range(8):
        rig.segment(5.0, speed=400.0, end_speed=400.0, exact_stop=False)
    rig.segment(60.0, speed=400.0)
    while rig.x[-1:] < [59.6]:
        rig.run(1)
    held_at = rig.x[-1]
    rig.channel.panel.put(cells.PANEL_FEED_HOLD, True)
    rig.run(150)
    assert rig.x[-1] == pytest.approx(held_at + 400.0**2 / (2 * ACCELERATION), abs=1e-6)
    assert rig.x[-1] == rig.x[-2]
    rig.channel.panel.put(cells.PANEL_FEED_HOLD, False)
    rig.run_to_the_end()
    assert rig.x[-1] == rig.end
    assert_within_limits(rig.x, 400.0)


def test_hold_in_a_dwell_stops_its_count() -> None:
    """A dwell of ten ticks, held for seven, takes seventeen."""
    rig = Rig()
    rig.dwell(10)
    rig.run(4)
    rig.channel.panel.put(cells.PANEL_FEED_HOLD, True)
    rig.run(7)
    rig.channel.panel.put(cells.PANEL_FEED_HOLD, False)
    assert rig.run_to_the_end() == 6


def test_a_reset_brakes_on_the_path_over_block_ends() -> None:
    """A reset gives the rest up where the path is at rest, 31.25 mm after the reset (RC-007)."""
    rig = Rig()
    rig.segment(100.0, end_speed=500.0, exact_stop=False)
    for _ in range(30):
        rig.segment(3.0, end_speed=500.0, exact_stop=False)
    rig.segment(100.0)
    while rig.x[-1:] < [99.0]:
        rig.run(1)
    reset_at = rig.x[-1]
    rig.channel.request_reset()
    ticks = 0
    while rig.channel.executor.is_resetting:
        rig.run(1)
        ticks += 1
    assert ticks == 125
    assert rig.x[-1] == pytest.approx(reset_at + 500.0**2 / (2 * ACCELERATION), abs=1e-6)
    assert_within_limits(rig.x)
    assert rig.channel.queue.queued() == 0
    assert rig.channel.queue.timed_count == 0


def test_commands_between_passed_blocks_are_taken_in_the_next_tick() -> None:
    """A flush after blocks of which several pass in one tick waits for the last (RC-003)."""
    rig = Rig()
    rig.segment(20.0, speed=100.0, end_speed=100.0, exact_stop=False)
    for _ in range(6):
        rig.segment(0.03, speed=100.0, end_speed=100.0, exact_stop=False)
    rig.segment(20.0, speed=100.0)
    rig.flush()
    rig.segment(1.0)
    rig.run_to_the_end()
    assert rig.x[-1] == rig.end
    assert_within_limits(rig.x)


def test_a_block_cycle_before_a_passed_block_runs_with_it() -> None:
    """The cycle is taken in the tick after the block end, and runs while the block is current."""
    rig = Rig()
    rig.segment(10.0, speed=100.0, end_speed=100.0, exact_stop=False)
    made = rig.cycle(codes.BLOCK_SCOPE)
    rig.segment(10.0, speed=100.0)
    begins = None
    for tick in range(400):
        if not rig.channel.queue.queued() and not rig.channel.path.is_active:
            break
        rig.run(1)
        if begins is None and rig.channel.path.serial == 2:
            begins = tick
    assert begins is not None
    assert made.runs == tick - 1 - begins


def test_a_block_cycle_before_a_block_within_a_tick_runs_once() -> None:
    """A block blended away inside one tick gives one run in the next tick (RC-105)."""
    rig = Rig()
    rig.segment(10.0, speed=100.0, end_speed=100.0, exact_stop=False)
    made = rig.cycle(codes.BLOCK_SCOPE)
    rig.segment(0.01, speed=100.0, end_speed=100.0, exact_stop=False)
    rig.segment(10.0, speed=100.0)
    rig.run_to_the_end()
    rig.run(1)
    assert made.runs == 1
    assert rig.channel.manager.running_count == 0


def test_a_segment_that_does_not_start_at_the_axes_is_refused() -> None:
    """The path never jumps: an error instead (RC-409)."""
    rig = Rig()
    rig.segment(1.0)
    rig.end += 0.5
    rig.segment(1.0)
    rig.run(60)
    assert rig.channel.executor.error_pending
    assert rig.x[-1] == 1.0


def test_used_segments_stay_in_the_ring() -> None:
    """The latest segments can be looked up when the path has left them, the last one first."""
    controller = Controller()
    controller.run(NcText("part.nc", "G00 X1\nG00 X3\nG00 X3 Y4\nM30"))
    path = loop_of(controller).channels[0].channel.path
    assert path.used == 3
    assert [path.segment_row(back)[rows.LENGTH] for back in range(3)] == [4.0, 2.0, 1.0]
