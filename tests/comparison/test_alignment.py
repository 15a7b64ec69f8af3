# SPDX-License-Identifier: MIT
"""Offset and drift of a log (LG-701 … LG-704), and what deviations are."""

from __future__ import annotations

from collections.abc import Sequence

import numpy
import pytest
from support.random_seeds import by_night

from nctakt.base.diagnostics import Span
from nctakt.base.unit_factors import factor_between
from nctakt.comparison.alignment import Alignment, Curve, align, placed
from nctakt.comparison.delays import BlockDelays
from nctakt.comparison.deviations import deviation_of
from nctakt.comparison.log import LogColumn, Samples
from nctakt.comparison.mapping import Pair, Tolerance, suggestion
from nctakt.results.trace.events import Event
from nctakt.results.trace.sinks import Signal

COLUMN = LogColumn("a", "", 1, 0)


def wandering(seconds: float, seed: int) -> Curve:
    """A curve of 1 ms that moves to and fro without repeating itself."""
    random = numpy.random.default_rng(seed)
    targets = numpy.cumsum(random.uniform(-20.0, 20.0, int(seconds * 2) + 2))
    return Curve(
        1000.0, numpy.interp(numpy.arange(0, seconds, 0.001) * 2, range(len(targets)), targets)
    )


def logged(
    curve: Curve, step_us: float, offset_us: float, drift: float, gain: float = 1.0
) -> Samples:
    """What a log of a curve holds, from a second before it to a second after it."""
    stamps = numpy.arange(offset_us - 1e6, offset_us + curve.end_us * (1 + drift) + 1e6, step_us)
    noise = numpy.random.default_rng(7).normal(0.0, 0.002, len(stamps))
    return Samples(stamps, gain * curve.at((stamps - offset_us) / (1.0 + drift)) + noise)


@pytest.mark.parametrize(("step_us", "gain"), [(2000.0, 1.0), (10_000.0, 1.0), (2000.0, 1.001)])
def test_offset_and_drift_are_found(step_us: float, gain: float) -> None:
    """LG-702: within 0.001 ms and 0.1 ppm of 40 ppm; gain is reported and affects neither."""
    curve = wandering(120.0, 1)
    found = align([(logged(curve, step_us, 12_345_678.0, 40e-6, gain), curve)])
    assert found.reason is None
    assert found.offset_us == pytest.approx(12_345_678.0, abs=5.0)
    assert found.drift * 1e6 == pytest.approx(40.0, abs=0.1)
    assert found.gain == pytest.approx(gain, abs=5e-5)


def test_a_rest_says_nothing_about_a_drift() -> None:
    """LG-704: 100 mm in 1.02 s with ramps in the run, in 1 s without any in the log; then 99 s.

    The motion takes 1 s of 100: that it differs is no drift of 2 %.
    """
    times_s = numpy.arange(0.0, 100.0, 0.001)
    ramps = numpy.minimum(times_s, 1.02 - times_s) / 0.02
    run = numpy.cumsum(100.0 * numpy.clip(ramps, 0.0, 1.0)) * 0.001
    log = Samples(1e6 * times_s, numpy.minimum(100.0 * times_s, 100.0))
    found = align([(log, Curve(1000.0, run))])
    assert found.reason is None
    assert found.drift == 0.0


def test_a_short_log_has_no_drift() -> None:
    """LG-704: in 20 s a drift of some ppm cannot be known."""
    curve = wandering(20.0, 2)
    found = align([(logged(curve, 2000.0, -500_000.0, 0.0), curve)])
    assert found.drift == 0.0
    assert found.offset_us == pytest.approx(-500_000.0, abs=2.0)


def stepped(
    curve: Curve, drift: float, noise: float, late: Sequence[tuple[float, float]]
) -> Samples:
    """A log at 2 ms that begins 3 s before the run, and is at times of it for this many µs."""
    end = 3e6 + (curve.end_us + sum(length for _, length in late)) * (1.0 + drift) + 1e6
    stamps = numpy.arange(0.0, end, 2000.0)
    times = (stamps - 3e6) / (1.0 + drift)
    for time_us, length in late:
        times = numpy.where(times > time_us, numpy.maximum(times - length, time_us), times)
    values = curve.at(times) + numpy.random.default_rng(7).normal(0.0, noise, len(times))
    return Samples(stamps, values)


@pytest.mark.parametrize("noise", [by_night(0.0), 0.01])
@pytest.mark.parametrize("drift", [0.0, 40e-6, by_night(-15e-6)])
@pytest.mark.parametrize(
    "late",
    [
        [(60e6, 1000.0)],
        [(60e6, 30_000.0)],
        [(60e6, 1e6)],
        [(30e6, 20_000.0), (75e6, 400_000.0), (90e6, 5000.0)],
    ],
)
def test_a_step_in_time_is_no_slope(
    late: Sequence[tuple[float, float]], drift: float, noise: float
) -> None:
    """LG-701, LG-706: delays in 120 s of motion are no drift, and the drift beside them is found.

    The log begins 3 s before the run; 1 ms late from the middle on would else be some 12 ppm.
    """
    curve = wandering(120.0, 1)
    found = align([(stepped(curve, drift, noise, late), curve)])
    assert found.reason is None
    assert not found.is_uncertain
    assert found.drift * 1e6 == pytest.approx(drift * 1e6, abs=0.3)
    assert (found.drift == 0.0) == (drift == 0.0)
    assert found.offset_us == pytest.approx(3e6, abs=10.0)


@pytest.mark.parametrize("wrong_us", [0.0, 300.0, -20_000.0])
@pytest.mark.parametrize("late", [[], [(60e6, 30_000.0)]])
@pytest.mark.parametrize(("drift", "noise"), [(40e-6, 0.01), (-15e-6, 0.0), (0.0, 0.01)])
def test_a_drift_is_found_beside_a_given_place(
    drift: float, noise: float, late: Sequence[tuple[float, float]], wrong_us: float
) -> None:
    """LG-701: the stamp of 50 s of the run, 3 s + 50 s · (1 + drift), is given, exact or not.

    The drift does not depend on how exact it is, and the log lies where it is said to lie.
    """
    curve = wandering(120.0, 1)
    stamp_us = 3e6 + 50e6 * (1.0 + drift) + wrong_us
    found = placed([(stepped(curve, drift, noise, late), curve)], stamp_us, 50e6, None)
    assert found.drift * 1e6 == pytest.approx(drift * 1e6, abs=0.3)
    assert (found.drift == 0.0) == (drift == 0.0)
    assert float(found.run_times(numpy.array([stamp_us]))[0]) == pytest.approx(50e6, abs=1e-3)


def test_a_given_drift_is_not_searched() -> None:
    """With 40 ppm said, the begin is that of 40 ppm; with 0 said, that of the best fit without."""
    curve = wandering(120.0, 1)
    pairs = [(stepped(curve, 40e-6, 0.0, []), curve)]
    reported, none = align(pairs, 40e-6), align(pairs, 0.0)
    assert (reported.drift, none.drift) == (40e-6, 0.0)
    assert reported.offset_us == pytest.approx(3e6, abs=1.0)
    assert 3e6 + 1000.0 < none.offset_us < 3e6 + 4000.0  # 40 ppm of 120 s are 4.8 ms at its end
    assert placed(pairs, 3e6, 0.0, 1e-5) == Alignment(3e6, 1e-5)


def test_nothing_that_moves_has_a_drift() -> None:
    """LG-704: the log lies where it is given to, at the same speed."""
    still = Samples(numpy.arange(5.0) * 1000.0, numpy.zeros(5))
    assert placed([(still, Curve(1000.0, numpy.zeros(5)))], 7.0, 2.0, None) == Alignment(5.0)
    assert placed([], 7.0, 2.0, None) == Alignment(5.0)


def test_another_speed_is_no_drift() -> None:
    """LG-704: a log that is slower by half a per cent has no clock of its own: 5000 ppm."""
    curve = wandering(120.0, 1)
    found = align([(stepped(curve, 5e-3, 0.0, []), curve)])
    assert found.drift == 0.0


def test_what_cannot_be_aligned_says_why() -> None:
    """LG-704: nothing moves, nothing fits, and two offsets fit equally well."""
    still = Curve(1000.0, numpy.zeros(5000))
    assert "nothing moves" in str(align([(logged(still, 2000.0, 0.0, 0.0), still)]).reason)
    one, other = wandering(20.0, 3), wandering(20.0, 4)
    assert "correlation" in str(align([(logged(one, 2000.0, 0.0, 0.0), other)]).reason)
    move = numpy.interp(numpy.arange(4000), [0, 1000, 1200, 2000, 2200], [0, 0, 10, 10, 0])
    twice = numpy.concatenate([move, move])
    log = Samples(numpy.arange(8000) * 1000.0, twice)
    assert "two offsets" in str(align([(log, Curve(1000.0, move))]).reason)


def test_deviations_by_hand() -> None:
    """Log minus run at the log's stamps; a single sample beyond is no exceedance (LG-706)."""
    curve = Curve(1000.0, numpy.arange(6.0))
    times = numpy.array([-500.0, 500.0, 1500.0, 2500.0, 3500.0, 4500.0, 9000.0])
    values = numpy.array([9.0, 1.5, 1.5, 2.75, 3.75, 4.5, 9.0])
    pair = Pair(Signal("X", "mm"), COLUMN, 1.0, 0.0, None, False)
    found = deviation_of(pair, Samples(times, values), curve, Alignment(0.0), Tolerance(0.2))
    assert found is not None
    assert (found.samples, found.greatest, found.greatest_us) == (5, 1.0, 500)
    assert (found.first_us, found.beyond) == (2500, 2)
    assert found.mean == pytest.approx(0.3)
    assert found.rms == pytest.approx((1.125 / 5) ** 0.5)


@pytest.mark.parametrize(
    ("text", "beyond"),
    [
        ("0.2", 4),
        ("4%", 4),  # of a span of 5 mm
        ("30%", 2),
        ("1ticks", 2),  # at 2.5 ms the run has 1 to 4 within a tick around, at 3.5 ms 2 to 5
        ("0.9 + 1ticks", 2),
        ("1+1ticks", 0),
        ("2ticks", 1),  # 3.5 ms is alone then
    ],
)
def test_tolerances_of_each_kind_by_hand(text: str, beyond: int) -> None:
    """In the signal's unit, in % of its span, earlier or later (LG-706)."""
    curve = Curve(1000.0, numpy.arange(6.0))
    times = numpy.array([500.0, 1500.0, 2500.0, 3500.0, 4500.0])
    values = numpy.array([1.5, 2.5, 5.0, 6.0, 4.5])
    pair = Pair(Signal("X", "mm"), COLUMN, 1.0, 0.0, None, False)
    tolerance = Tolerance.of(text)
    found = deviation_of(pair, Samples(times, values), curve, Alignment(0.0), tolerance)
    assert found is not None
    assert found.greatest == 2.5
    assert found.beyond == (0 if beyond < 2 else beyond)


NO_TOLERANCES = ("", "-1", "wide", "1 mm", "+2ticks", "1%%", "2%2", "1ticks+2", "1e999", "1.2.3")


@pytest.mark.parametrize("text", NO_TOLERANCES)
def test_what_is_no_tolerance(text: str) -> None:
    """Signs, units, infinite numbers, parts in another order."""
    with pytest.raises(ValueError):
        Tolerance.of(text)


def test_edges_of_truths_may_jitter_by_a_sample() -> None:
    """LG-706: the log sees the edge one sample late; two samples late count."""
    curve = Curve(1000.0, numpy.array([0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 1.0]))
    pair = Pair(Signal("B", "", integral=True), COLUMN, 1.0, 0.0, None, False)
    times = numpy.arange(7) * 1000.0
    for late, beyond in ((1, 0), (2, 2)):
        values = (numpy.arange(7) >= 2 + late).astype(float)
        found = deviation_of(pair, Samples(times, values), curve, Alignment(0.0), Tolerance())
        assert found is not None
        assert found.beyond == beyond


def test_names_that_look_like_a_signal() -> None:
    """Words of both languages; quantities that a run does not have are none."""
    axes = ["X", "Y", "A"]
    for name, signal in (
        ("Axis X ActPos", "X.ACS.ACT_POS"), ("MAIN.fbAxisX.SetPos", "X.ACS.CMD_POS"),
        ("Y_Istwert", "Y.ACS.ACT_POS"), ("Y Sollposition", ""), ("X_act", "X.ACS.ACT_POS"),
        ("Axis X ActVelo", ""), ("X following error pos", ""), ("Spindle Speed", "S.SPEED"),
        ("path feed", "PATH.SPEED"), ("XY pos", ""), ("position", ""),
    ):  # fmt: skip
        assert suggestion(name, axes) == signal, name


def test_units() -> None:
    """How many of the signal's unit one of the log's is; the micro sign has two characters."""
    assert factor_between("\u03bcm", "mm") == factor_between("µm", "mm") == pytest.approx(0.001)
    assert factor_between("mm/min", "mm/s") == pytest.approx(1 / 60)
    assert factor_between("rpm", "1/min") == 1.0
    assert factor_between("bar", "mm") is None


def test_where_a_log_becomes_late() -> None:
    """LG-706: 3 ms from the second block on, 1 ms less from the third; a still one says nothing."""
    ticks = numpy.arange(4000.0)
    curve = Curve(1000.0, numpy.interp(ticks, [0, 1000, 1500, 4000], [0.0, 100.0, 100.0, 350.0]))
    stamps = numpy.arange(0.0, 3.9e6, 2000.0)
    late = numpy.select([stamps < 1e6, stamps < 2.5e6], [0.0, 3000.0], 2000.0)
    noise = numpy.random.default_rng(5).normal(0.0, 0.001, len(stamps))
    log = Samples(stamps, curve.at(stamps - late) + noise)
    spans = [Span("part.nc", line, 1, 2) for line in (1, 2, 3, 4)]
    begins = (0, 1_000_000, 1_500_000, 2_500_000)
    blocks = [
        Event(time // 1000, time, "block", "", span)
        for time, span in zip(begins, spans, strict=True)
    ]
    gathered = BlockDelays(blocks, 1000, is_scaled=False)
    pair = Pair(Signal("X", "mm"), COLUMN, 1.0, 0.0, None, False)
    deviation_of(pair, log, curve, Alignment(0.0), None, delays=gathered)
    found = gathered.found()
    assert [(one.block, round(one.jump_us / 100.0)) for one in found] == [
        (spans[2], 30), (spans[3], -10),
    ]  # fmt: skip


def test_delays_do_not_depend_on_stretches() -> None:
    """LG-706: of a log with a gain, block by block what lies about the block's mean counts."""
    ticks = numpy.arange(4000.0)
    curve = Curve(1000.0, 50.0 * numpy.sin(ticks / 150.0))
    stamps = numpy.arange(2000.0, 3.9e6, 2000.0)
    late = numpy.where(stamps < 2e6, 0.0, 4000.0)
    differences = 1.02 * curve.at(stamps - late) + 3.0 - curve.at(stamps)
    slopes, values = curve.slope_at(stamps), curve.at(stamps)
    blocks = [
        Event(time // 1000, time, "block", "", Span("part.nc", time // 1_000_000 + 1, 1, 2))
        for time in (0, 1_000_000, 2_000_000, 3_000_000)
    ]
    found = []
    for length in (len(stamps), 700, 3):
        gathered = BlockDelays(blocks, 1000, is_scaled=True)
        for begin in range(0, len(stamps), length):
            part = slice(begin, begin + length)
            gathered.add(stamps[part], differences[part], slopes[part], values[part])
        gathered.end_signal()
        found.append([(one.time_us, one.jump_us) for one in gathered.found()])
    assert [time for time, _ in found[0]] == [2_000_000]
    assert found[0][0][1] == pytest.approx(4000.0, rel=0.1)
    for other in found[1:]:
        assert [one for pair in other for one in pair] == pytest.approx(
            [one for pair in found[0] for one in pair], rel=1e-9
        )


@pytest.mark.parametrize(("moving", "reported"), [(4, []), (5, [1000.0])])
def test_a_block_in_which_little_moves_tells_nothing(moving: int, reported: list[float]) -> None:
    """LG-706: six signals that move for four samples of a dwell are not 24 samples that move."""
    blocks = [Event(tick, 1000 * tick, "block", "", None) for tick in (0, 100)]
    gathered = BlockDelays(blocks, 1000, is_scaled=False)
    slopes = numpy.repeat([1.0, 0.0], [100 + moving, 100 - moving])
    late = numpy.repeat([0.0, 1000.0], 100)  # by 1 ms from the second block on
    for _ in range(6):
        gathered.add(numpy.arange(200) * 1000.0, -slopes * late, slopes, numpy.cumsum(slopes))
        gathered.end_signal()
    assert [one.jump_us for one in gathered.found()] == pytest.approx(reported)


@pytest.mark.parametrize("samples", [1, 25])
@pytest.mark.parametrize(("apart", "reported"), [(700.0, [600.0]), (1000.0, [])])
def test_samples_within_a_tick_say_what_one_says(
    samples: int, apart: float, reported: list[float]
) -> None:
    """LG-706: 600 µs later and ± ``apart`` from tick to tick, 100 ticks before and after.

    The square of each error is 100 · apart² / 99 / 100, so that five errors of the jump are
    497 µs or 711 µs, however many samples a tick has.
    """
    blocks = [Event(tick, 1000 * tick, "block", "", None) for tick in (0, 100)]
    ticks = numpy.arange(200 * samples) // samples
    times = numpy.arange(200 * samples) * (1000.0 / samples)
    late = numpy.where(ticks < 100, 0.0, 600.0) + numpy.where(ticks % 2, apart, -apart)
    slopes = numpy.ones(len(times))
    gathered = BlockDelays(blocks, 1000, is_scaled=False)
    gathered.add(times, -slopes * late, slopes, times)
    gathered.end_signal()
    assert [one.jump_us for one in gathered.found()] == pytest.approx(reported)


@pytest.mark.parametrize(("late_us", "reported"), [(0.0, []), (900.0, [900.0])])
def test_a_gain_is_no_delay_where_the_speed_follows_the_position(
    late_us: float, reported: list[float]
) -> None:
    """LG-706: 1 % too far, and later from the second block on; both are distinguished.

    The axis only accelerates, so that where it is farther it is faster, too.
    """
    blocks = [Event(tick, 1000 * tick, "block", "", None) for tick in (0, 100)]
    tick = numpy.arange(200.0)
    speed = 1.0 + tick % 100
    place = numpy.cumsum(speed)
    differences = 0.01 * place - speed * numpy.where(tick < 100, 0.0, late_us)
    gathered = BlockDelays(blocks, 1000, is_scaled=True)
    gathered.add(tick * 1000.0, differences, speed, place)
    gathered.end_signal()
    assert [one.jump_us for one in gathered.found()] == pytest.approx(reported)


def test_at_a_constant_speed_a_log_with_a_bias_is_late_nowhere() -> None:
    """LG-702: there a delay and a bias are one, so that no block has one."""
    blocks = [Event(tick, 1000 * tick, "block", "", None) for tick in (0, 100)]
    slopes, places = numpy.ones(200), numpy.arange(200.0)
    gathered = BlockDelays(blocks, 1000, is_scaled=True)
    gathered.add(places * 1000.0, numpy.repeat([0.0, -900.0], 100), slopes, places)
    gathered.end_signal()
    assert gathered.found() == []
