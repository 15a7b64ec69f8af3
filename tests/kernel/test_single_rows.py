# SPDX-License-Identifier: MIT
"""Single columns and signs that whole runs seldom depend on, each by itself (MO-1 … MO-5).

What is called here cannot be seen from Python where it is compiled: the tests run in plain mode.
"""

from __future__ import annotations

import math
from types import SimpleNamespace
from typing import Any

import pytest
from support.kernel_rig import Rig

from nctakt.base import mode
from nctakt.kernel import cells, codes, rows
from nctakt.kernel.axes import plan_rows
from nctakt.kernel.axes.trajectory import Trajectories
from nctakt.kernel.base import arithmetic
from nctakt.kernel.path import arc_limits, geometry
from nctakt.kernel.path.arc_limits import ArcLimits
from nctakt.kernel.path.arc_speed import ArcSpeed
from nctakt.kernel.path.backward import BackwardMotion
from nctakt.kernel.path.history import History
from nctakt.kernel.path.jerk_lookahead import JerkLookAhead
from nctakt.kernel.path.jerk_profile import JerkProfile
from nctakt.kernel.path.override import Overrides
from nctakt.kernel.path.path import Path as KernelPath
from nctakt.kernel.path.segment_limits import SegmentLimits
from nctakt.kernel.plc.interface_image import InterfaceImage
from nctakt.kernel.tick.command_queue import CommandQueue
from nctakt.kernel.tick.single_block import SingleBlock
from nctakt.kernel.tick.stops import Turns
from nctakt.kernel.tick.wait_reasons import WaitReasons

pytestmark = pytest.mark.skipif(mode.is_compiled(), reason="compiled methods cannot be called")


def memory(*values: float) -> memoryview[float]:
    """Values as the realtime part has them."""
    made = memoryview(bytearray(8 * len(values))).cast("d")
    for i, value in enumerate(values):
        made[i] = value
    return made


def queued(rig: Rig) -> list[float]:
    """The newest command of the queue."""
    queue = rig.channel.queue
    begin = (queue.tail - 1) % queue.capacity * queue.width
    return list(queue.rows[begin : begin + queue.width])


@pytest.mark.parametrize("exact_stop", [False, True])
@pytest.mark.parametrize("deviation", [0.0, 0.25])
def test_a_line_without_objects_is_the_same_command(deviation: float, exact_stop: bool) -> None:
    """Each column of it: the fast way and the slow way put one segment after another."""
    slow, fast = Rig(), Rig()
    start, target = (1.0, 2.0, 3.0, 4.0), (11.0, 22.0, 3.0, 4.0)
    for i, (begin, end) in enumerate(((start, target), (target, start))):
        word = (77 << 20) + i
        slow.channel.queue.put_segment(
            word, 10 + i, begin, end, rows.FEED_MOTION, 50.0, exact_stop, deviation, False, None
        )
        fast.channel.queue.put_line(
            word,
            10 + i,
            memory(*begin),
            memory(*end),
            rows.FEED_MOTION,
            50.0,
            int(exact_stop),
            deviation,
            0,
        )
        assert queued(fast) == queued(slow)
        assert queued(fast)[rows.DEVIATION] == deviation
        assert (queued(fast)[rows.SOURCE], queued(fast)[rows.BLOCK_NUMBER]) == (word, 10 + i)


@pytest.mark.parametrize(("fading_j", "jerk_j"), [(50.0, -50.0), (0.0, 20.0)])
def test_the_acceleration_of_a_start_fades_first_where_it_is_to(
    fading_j: float, jerk_j: float
) -> None:
    """From 5 mm/s² on with the jerk that is given, or at once with what the plan needs."""
    plans = Trajectories(1)
    assert plans.plan_passing(0, 500.0, 10.0, 5.0, 50.0, 20.0, 10.0, 20.0, fading_j) == 1
    assert plans.rows[plan_rows.PLAN_PHASES + plan_rows.PHASE_ACCELERATION] == 5.0
    assert plans.rows[plan_rows.PLAN_PHASES + plan_rows.PHASE_JERK] == pytest.approx(jerk_j)


@pytest.mark.parametrize(("first", "last", "top2"), [(3.0, 0.0, 0.1), (0.0, 3.0, 0.1)])
def test_without_one_ramp_the_highest_speed_is_that_of_its_border(
    first: float, last: float, top2: float
) -> None:
    """Bit for bit: 3 times 0.1 divided by 3 is more than 0.1."""
    assert 3.0 * 0.1 / 3.0 > 0.1
    arc: Any = SimpleNamespace(
        lows=[0.0, top2 if last == 0.0 else 0.01],
        change=lambda _stage, _speed2, _limit2, _width, side: first if side > 0.0 else last,
        followed=[],
    )
    arc.follow = lambda *values: arc.followed.append(values)
    start_v = 0.1 if last == 0.0 else math.sqrt(top2)
    ArcSpeed.speed_up(arc, 0, 100.0, start_v, 9.0)
    assert arc.followed[0][3] == (top2 if last == 0.0 else start_v * start_v)


def test_the_highest_speed_at_an_end_of_an_arc_is_that_of_its_piece() -> None:
    """The first one at its begin, the last one at its end; what lies after is an older arc's."""
    limits: Any = SimpleNamespace(pieces=3, caps=[4.0, 9.0, 16.0, 25.0, 36.0])
    assert ArcLimits.end_cap(limits, 0) == 2.0
    assert ArcLimits.end_cap(limits, 1) == 4.0


@pytest.mark.parametrize(("begin", "end"), [(0.0, 15.0), (5.0, 20.0), (20.0, 5.0), (-5.0, 10.0)])
def test_a_helix_rises_from_where_it_starts(begin: float, end: float) -> None:
    """20 mm in the plane and 15 mm along the third axis, wherever that is."""
    limits = SegmentLimits(3, 1000, 1.0)
    for axis in range(3):
        limits.limit(axis, True, (500.0, 500.0), (1000.0, 1000.0))
    row = memory(*[0.0] * rows.segment_width(3))
    row[rows.SHAPE] = rows.ARC
    row[rows.ARC_SECOND_AXIS] = 1.0
    row[rows.ARC_ANGLE] = 360.0 / math.pi
    row[rows.START] = 10.0
    row[rows.START + 3], row[rows.START + 4] = 10.0 * math.cos(2.0), 10.0 * math.sin(2.0)
    row[rows.START + 2], row[rows.START + 5] = begin, end
    row[rows.SPEED] = 50.0
    limits.measure(row, 0)
    assert row[rows.LENGTH] == pytest.approx(25.0)


def test_the_radius_of_an_arc_is_that_of_its_own_axes() -> None:
    """In the plane of the second and the third axis, with a limit of the jerk."""
    found = []
    for plane in ((0, 1), (1, 2)):
        limits = SegmentLimits(3, 1000, 1.0)
        for axis in range(3):
            limits.limit(axis, True, (500.0, 500.0), (1000.0, 1000.0))
            limits.limit_slope(axis, (1000.0, 1000.0), (10_000.0, 10_000.0))
        row = memory(*[0.0] * rows.segment_width(3))
        row[rows.SHAPE] = rows.ARC
        row[rows.ARC_FIRST_AXIS], row[rows.ARC_SECOND_AXIS] = plane
        row[rows.ARC_FIRST_CENTRE], row[rows.ARC_SECOND_CENTRE] = 3.0, 4.0
        row[rows.ARC_ANGLE] = 90.0
        row[rows.START + plane[0]], row[rows.START + plane[1]] = 13.0, 4.0
        row[rows.START + 3 + plane[0]], row[rows.START + 3 + plane[1]] = 3.0, 14.0
        row[rows.LENGTH] = 10.0 * math.pi / 2.0
        row[rows.SPEED] = row[rows.MAX_SPEED] = 400.0
        row[rows.ACCELERATION], row[rows.JERK] = 1000.0, 10_000.0
        unused = memory(0.0, 0.0, 0.0)
        limits.limit_jerk_on_arc(row, 0, unused, unused)
        found.append([row[column] for column in (rows.MAX_SPEED, rows.ACCELERATION, rows.JERK)])
    assert found[0] == found[1]
    assert 0.0 < found[0][0] < 100.0


@pytest.mark.parametrize(("factor", "end_v"), [(0.5, 10.0), (1.0, 10.0), (1.2, 12.0), (2.0, 15.0)])
def test_an_override_above_one_lets_the_end_of_a_block_grow(factor: float, end_v: float) -> None:
    """MO-5: as far as the axes allow; below 100 % the next segment has its own speed."""
    row = [0.0] * 200
    row[rows.END_SPEED], row[rows.MAX_END_SPEED] = 10.0, 15.0
    path: Any = SimpleNamespace(history_rows=row, row=0, factor=factor, is_single=False)
    assert KernelPath.block_end_speed(path, 1.0, 1000.0) == end_v


@pytest.mark.parametrize(("spindle_v", "factor"), [(1800.0, 0.5), (-1800.0, 0.5), (0.0, 0.0)])
def test_a_feed_per_revolution_follows_its_spindle(spindle_v: float, factor: float) -> None:
    """G95: in either direction; without a spindle only the override counts."""
    row = memory(*[0.0] * 200)
    row[rows.SPEED_OVERRIDE] = 1.0
    row[rows.FEED_SPINDLE_SPEED] = 3600.0
    spindles = SimpleNamespace(speed_v=[99.0, spindle_v])
    overrides: Any = SimpleNamespace(
        parts=lambda _ignores: 100.0, max_pct=200.0, context=SimpleNamespace(spindles=spindles)
    )
    assert Overrides.factor(overrides, row, 0) == 1.0
    row[rows.FEED_SPINDLE] = 2.0
    assert Overrides.factor(overrides, row, 0) == factor


@pytest.mark.parametrize("degrees", [45.0, -45.0, 405.0])
def test_the_sine_of_45_degrees_is_the_one_of_small_angles(degrees: float) -> None:
    """Both series meet there; sine and cosine keep theirs, so a pinned bit is the same forever."""
    assert math.fabs(arithmetic.sine(degrees)) == 0.7071067811865475
    assert arithmetic.cosine(degrees) == 0.7071067811865476


def test_a_written_variable_is_reported_with_its_place() -> None:
    """RC-308: the place, the cell and the value of the command; the cell has the value."""
    rig = Rig()
    rig.machine.record.records_writes = True
    rig.channel.put([rows.WRITE_VARIABLE, 0, 0, 40, 0.0, 0])
    rig.channel.put([rows.WRITE_VARIABLE, 12345, 0, 41, 2.5, 1])
    rig.machine.reserve()
    rig.machine.kernel.run(1)
    found = memoryview(rig.machine.record.take_events()).cast("d").tolist()
    columns = (rows.EVENT_KIND, rows.EVENT_SOURCE, rows.EVENT_A, rows.EVENT_B)
    assert [found[column] for column in columns] == [rows.EVENT_WRITTEN, 12345, 41, 2.5]


@pytest.mark.parametrize("kind", [rows.PROGRAM_STOP, rows.GIVE_UP, rows.MEASURE_END])
def test_what_ends_takes_no_time_of_the_queue_along(kind: int) -> None:
    """Commands that take time are counted as they come and as they go."""
    rig = Rig()
    rig.channel.put([kind, 0, 0, 0, *[0] * 4])
    assert rig.channel.queue.timed_count == 1
    rig.machine.reserve()
    rig.machine.kernel.run(1)
    assert rig.channel.queue.timed_count == 0


@pytest.mark.parametrize("length", [0.4, 1.0, 2.0])
def test_a_short_way_from_rest_to_rest(length: float) -> None:
    """Four equal phases of jerk 10 mm/s³: each takes the third root of half the way by the jerk."""
    time = arc_limits.rest_to_rest_time(length, 10.0, 5.0, 10.0)
    assert time == pytest.approx(4.0 * (length / 20.0) ** (1.0 / 3.0))


def test_from_each_stage_on_the_speed_grows_as_far_as_it_can_be_braked() -> None:
    """2·a·d of the stage and of all after it; the acceleration of each is its own."""
    row = memory(*[0.0] * 200)
    row[rows.LENGTH] = 10.0
    row[rows.ENTRY_LENGTH], row[rows.ENTRY_ACCELERATION] = 2.0, 5.0
    row[rows.EXIT_LENGTH], row[rows.EXIT_ACCELERATION] = 3.0, 7.0
    row[rows.ACCELERATION] = 11.0
    squares = {codes.ENTRY_ZONE: 9.0 + 42.0 + 110.0 + 20.0, codes.MIDDLE: 9.0 + 42.0 + 110.0}
    squares |= {codes.EXIT_ZONE: 9.0 + 42.0, codes.CURVE: 9.0}
    for stage, square in squares.items():
        assert geometry.entry_speed(row, 0, stage, 3.0, 1e3) == pytest.approx(math.sqrt(square))


def test_the_length_of_a_walk_is_that_of_its_stages_added_up() -> None:
    """Bit for bit where it goes by a trapezoid, whatever the segments next to it are."""
    row = memory(*[1.0] * 100, *[0.0] * 200)
    row[100 + rows.LENGTH] = 0.9
    row[100 + rows.ENTRY_LENGTH] = row[100 + rows.EXIT_LENGTH] = 0.2
    walk: Any = SimpleNamespace(path=SimpleNamespace(history_rows=row, row=100))
    assert BackwardMotion.length(walk) == 0.2 + (0.9 - 0.2 - 0.2) + 0.2 != 0.9
    row[100 + rows.JERK] = 1.0
    assert BackwardMotion.length(walk) == 0.9


@pytest.mark.parametrize(("change", "keeps"), [(-1, 0), (0, 1), (1, 1)])
def test_a_promise_is_broken_by_less_acceleration_or_jerk(change: int, keeps: int) -> None:
    """Some segment after the current one has less by now, or none has."""
    both = memory(*[0.0] * 400)
    both[200 + rows.PREDECESSOR] = 1.0
    both[rows.PREDECESSOR] = 1.0
    ahead: Any = SimpleNamespace(
        capacity=2,
        width=200,
        blocks=10,
        limits=SimpleNamespace(stop_at_end=lambda *_: None, speed_of=lambda *_: 1.0),
        goal=SimpleNamespace(load=lambda *_: None, store=lambda *_: 1),
        carry_back=lambda *_: None,
        take_over=lambda *_: change,
        slow_before=lambda *_: None,
        is_far=lambda *_: 0,
    )
    assert JerkLookAhead.spread(ahead, both, 3, 2, 1) == keeps


@pytest.mark.parametrize(("rounding_d", "is_in_time"), [(0.0, False), (1.0, True)])
def test_an_acceleration_settles_before_a_rounding_only(
    rounding_d: float, is_in_time: bool
) -> None:
    """Elsewhere the path stops after the segment where it cannot stop on it."""
    row = memory(*[0.0] * 200)
    row[rows.ROUNDING_LENGTH] = rounding_d
    called: list[str] = []
    profile: Any = SimpleNamespace(
        can_stop=lambda *_: 0,
        fade_by_end=lambda *_: called.append("fade"),
        head_for=lambda *_: called.append("head"),
    )
    JerkProfile.plan(profile, row, 0, 1.0, 10.0, 0.0, 1.0, 0)
    assert called == ["fade" if is_in_time else "head"]


@pytest.mark.parametrize("waits", [True, False])
def test_only_a_read_is_answered_with_a_cell(waits: bool) -> None:
    """A synchronous read by the value of its cell, a flush by 0."""
    rig = Rig()
    rig.channel.put([rows.WRITE_VARIABLE, 0, 0, 40, 2.5, 0])
    rig.channel.put([rows.READ, 0, 0, 1, 40] if waits else [rows.FLUSH, 0, 0, 1, 40])
    rig.machine.reserve()
    rig.machine.kernel.run(2)
    assert rig.channel.take_answer() == (2.5 if waits else 0.0)


@pytest.mark.parametrize(
    ("before", "now", "truth", "holds"),
    [
        (codes.UNKNOWN, codes.TRUE, codes.TRUE, 1),
        (codes.UNKNOWN, codes.FALSE, codes.FALSE, 0),
        (codes.TRUE, codes.FALSE, codes.FALSE, 1),
        (codes.FALSE, codes.TRUE, codes.TRUE, 1),
        (codes.FALSE, codes.FALSE, codes.FALSE, 0),
        (codes.TRUE, codes.FALSE, codes.TRUE, 0),
    ],
)
def test_a_condition_turns_where_it_was_otherwise_before(
    before: int, now: int, truth: int, holds: int
) -> None:
    """One that is false when it is first evaluated has not turned, one that is true has."""
    stop: Any = SimpleNamespace(previous=before, truth=truth, condition=SimpleNamespace(truth=now))
    nobody: Any = None
    assert Turns.holds(stop, nobody, nobody) == holds
    assert stop.previous == now


@pytest.mark.parametrize(("jerk", "more"), [(0.0, 0.0), (200.0, 8.0 * 50.0 / 200.0)])
def test_a_braking_distance_counts_from_the_highest_speed(jerk: float, more: float) -> None:
    """8 mm/s of its axes, though 20 are programmed: v²/2a, v·a/j and three ticks."""
    row = [0.0] * 400
    row[200 + rows.SPEED], row[200 + rows.MAX_SPEED] = 20.0, 8.0
    row[200 + rows.ACCELERATION], row[200 + rows.JERK] = 50.0, jerk
    queue: Any = SimpleNamespace(
        rows=row,
        look_ahead=SimpleNamespace(limits=SimpleNamespace(max_factor=2.0)),
        path=SimpleNamespace(cycle_time_t=0.001),
    )
    expected = 8.0 * (4.0 / 50.0 + 0.003) + more
    assert CommandQueue.braking_distance_in(queue, 200) == pytest.approx(expected)


@pytest.mark.parametrize(("length", "carried_a"), [(1.5, 30.0), (0.5, 7.0)])
def test_on_the_way_back_an_acceleration_fades_before_a_rounding(
    length: float, carried_a: float
) -> None:
    """10 mm/s · 30 mm/s² / 300 mm/s³ is 1 mm: a shorter segment has the rounding's limits."""
    row = [0.0] * 400
    row[rows.ACCELERATION], row[rows.JERK] = 500.0, 5000.0
    row[200 + rows.LENGTH], row[200 + rows.SPEED] = length, 10.0
    history: Any = SimpleNamespace(
        path=SimpleNamespace(history_rows=row),
        look_ahead=SimpleNamespace(limits=SimpleNamespace(speed_of=lambda speed, _max: speed)),
        goal=SimpleNamespace(),
        limit_a=30.0,
        limit_j=300.0,
        rounding_a=7.0,
        rounding_j=70.0,
    )
    History.take_over(history, 0, 200)
    assert (history.goal.carried_a, history.goal.carried_j) == (carried_a, 10.0 * carried_a)


@pytest.mark.parametrize(("kind", "word"), [(rows.POSITIONS, "axis"), (rows.FLUSH, "")])
def test_only_a_position_request_waits_for_axes(kind: int, word: str) -> None:
    """Another command's columns mean something else."""
    row = [0.0] * 100
    row[rows.KIND] = kind
    single_axes = SimpleNamespace(request_state=lambda *_: 1, requested_axis=2)
    waits: Any = SimpleNamespace(
        queue=SimpleNamespace(rows=row),
        executor=SimpleNamespace(context=SimpleNamespace(single_axes=single_axes)),
    )
    assert WaitReasons._of_command(waits, 0) == (word, 2 if word else 0)


@pytest.mark.parametrize(("jerk", "more"), [(0.0, 0.0), (200.0, 6.0 * 50.0 / 200.0)])
def test_braking_from_now_on_takes_longer_with_a_limit_of_the_jerk(
    jerk: float, more: float
) -> None:
    """v²/2a, and v·a/j until the acceleration is there and gone."""
    row = [0.0] * 200
    row[rows.ACCELERATION], row[rows.JERK] = 50.0, jerk
    path: Any = SimpleNamespace(history_rows=row, row=0, speed_v=6.0)
    assert KernelPath.braking_distance(path) == pytest.approx(36.0 / 100.0 + more)


@pytest.mark.parametrize(("words", "is_same"), [([1, 2], 1), ([1, 3], 0), ([5, 6], 0)])
def test_any_word_that_a_plc_has_changed_is_noticed(words: list[int], is_same: int) -> None:
    """One of them or all of them; what the CNC writes before them does not count."""
    shown = SimpleNamespace(words=[9, *words], published_words=[0, 1, 2])
    image: Any = SimpleNamespace(first_input_word=1, word_count=3, bytes=shown)
    assert InterfaceImage.is_as_published(image) == is_same


@pytest.mark.parametrize("name", ["feed_hold", "single_block", "backward_motion", "probe"])
def test_a_key_of_the_panel_is_down_where_its_cell_is_not_zero(name: str) -> None:
    """Each key has its own cell, and 0 there means that nobody presses it."""
    rig = Rig()
    panel = rig.channel.panel
    cell = panel.first_cell + getattr(cells, f"PANEL_{name.upper()}")
    for value in (0.0, 1.0, 0.0):
        panel.cells[cell] = value
        panel.latch()
        assert bool(getattr(panel, name)) == (value != 0.0)


@pytest.mark.parametrize(
    ("head", "started", "speed_v", "is_started"),
    [
        (3, 5, 0.0, True),
        (5, 5, 0.0, True),
        (6, 5, 0.0, False),
        (6, 5, 1.0, True),
        (0, -1, 0.0, False),
    ],
)
def test_what_the_path_has_begun_is_not_held_back(
    head: int, started: int, speed_v: float, is_started: bool
) -> None:
    """MO-6: single block stops before what lies after the newest segment that has begun."""
    asked: list[bool] = []

    def permits_block(_line: int, _moves: bool, started: bool) -> int:
        asked.append(started)
        return 1

    path = SimpleNamespace(speed_v=speed_v, continues_block=lambda: 0)
    command = [float(rows.SEGMENT), *[0.0] * rows.ARGUMENTS]
    queue: Any = SimpleNamespace(
        rows=command, head=head, tail=head + 1, started=started, path=path, capacity=1, width=0
    )
    panel: Any = SimpleNamespace(permits_block=permits_block, step_resolution=0)
    assert SingleBlock(queue, panel).permits() == 1
    assert asked == [is_started]


@pytest.mark.parametrize(("factor", "end_v"), [(0.5, 10.0), (1.2, 12.0), (2.0, 15.0)])
def test_an_override_above_one_lets_the_end_of_an_arc_grow(factor: float, end_v: float) -> None:
    """MO-5: as far as the axes allow."""
    surveyed: list[tuple[float, float]] = []
    arc: Any = SimpleNamespace(
        prepared_v=10.0,
        max_end_v=15.0,
        next_feed_v=0.0,
        survey=lambda *speeds: surveyed.append(speeds),
    )
    ArcSpeed.look_ahead(arc, 0, 1.0, 5.0, factor, factor, -1.0)
    assert surveyed == [(15.0, end_v)]


def test_only_a_function_that_was_put_out_is_waited_for() -> None:
    """RC-403: another one may wait at the same time."""
    rig = Rig()
    section = rig.channel.hli.program
    assert section.issue(100, 0, 1000) > 0
    assert section.is_waiting(100) == 1
    assert section.is_waiting(101) == 0
