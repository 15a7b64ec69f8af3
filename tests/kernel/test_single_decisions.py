# SPDX-License-Identifier: MIT
"""Single decisions of the path that whole runs seldom depend on, each by itself.

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
from nctakt.kernel.axes import spindles
from nctakt.kernel.axes.axes import Axes
from nctakt.kernel.axes.single_axes import SingleAxes
from nctakt.kernel.base.record import Record
from nctakt.kernel.cycles.context import context_of
from nctakt.kernel.cycles.expressions import Expression
from nctakt.kernel.path.arc_speed import ArcSpeed
from nctakt.kernel.path.backward import BackwardMotion
from nctakt.kernel.path.history import History
from nctakt.kernel.path.path import Path as KernelPath
from nctakt.kernel.path.trapezoid_profile import TrapezoidProfile
from nctakt.kernel.tick.loop_body import LoopBody
from nctakt.kernel.tick.stops import Happens

pytestmark = pytest.mark.skipif(mode.is_compiled(), reason="compiled methods cannot be called")


@pytest.mark.parametrize(("stage", "end_v"), [(1, 5.0), (2, 3.0), (0, 7.0)])
def test_at_the_border_of_a_piece_the_next_border_gives_the_speed(stage: int, end_v: float) -> None:
    """Nothing is left of the piece: at most the speed from which what follows can be kept."""
    arc = ArcSpeed(2, TrapezoidProfile())
    arc.pieces = 3
    for border, speed in enumerate((9.0, 7.0, 5.0, 3.0)):
        arc.highs[border] = speed * speed
    for piece in range(3):
        arc.caps[piece] = 1e6
    arc.plan(stage, 0.0, 8.0, 100.0)
    assert arc.profile.end_v == end_v


@pytest.mark.parametrize("keep", [1.0, 0.5])
@pytest.mark.parametrize(("parts", "cap_v"), [((0.5, 0.0), 20.0), ((0.0, 0.25), 80.0)])
def test_an_axis_keeps_its_share_of_the_speed_on_an_arc(
    keep: float, parts: tuple[float, float], cap_v: float
) -> None:
    """10 mm/s and 20 mm/s by the axis' part of the way, times the share that is kept."""
    arc = ArcSpeed(2, TrapezoidProfile())
    arc.max_v[0], arc.max_v[1] = 10.0, 20.0
    arc.first_parts[4], arc.second_parts[4] = parts
    assert arc.cap_at(4, 0, 1, keep) == pytest.approx((cap_v * keep) ** 2)


def walk(*, number: int, is_front_over: bool, kind: int) -> Any:
    """A walk over a history whose latest segment is number 7, and what it asks of the path."""
    history_rows = [0.0] * 200
    history_rows[100 + rows.KIND] = kind
    path = SimpleNamespace(
        oldest=3,
        is_front_over=is_front_over,
        front=100,
        history_rows=history_rows,
        direction=1,
        row_of=lambda _number: 0,
        refusal=lambda _row, _queue: 900420,
    )
    return SimpleNamespace(path=path, front_number=7, number=number)


@pytest.mark.parametrize(
    ("number", "is_front_over", "kind", "message"),
    [
        (2, True, rows.SEGMENT, -1),
        (7, True, rows.SEGMENT, 0),
        (7, False, rows.DWELL, 0),
        (7, False, rows.SEGMENT, 900420),
        (6, True, rows.DWELL, 900420),
        (3, False, rows.SEGMENT, 900420),
    ],
)
def test_a_walk_is_at_its_front_without_asking(
    number: int, is_front_over: bool, kind: int, message: int
) -> None:
    """A front that is over, or a dwell, moves nothing: only there no axis can be in the way."""
    history = walk(number=number, is_front_over=is_front_over, kind=kind)
    assert BackwardMotion.refusal_into(history, number) == message


def test_the_goal_of_a_walk_is_in_its_row() -> None:
    """Each column of the goal holds its own value: length, speed, kind, acceleration, jerk."""
    history: Any = SimpleNamespace(
        number=5,
        stretch=[0] * 4,
        stretch_end=-1,
        max_stretch=4,
        path=SimpleNamespace(direction=-1),
        goal=SimpleNamespace(distance_d=12.0, speed_v=34.0, kind=rows.EXEMPT_FEED_GOAL),
        limit_a=56.0,
        limit_j=78.0,
        rounding_a=1e300,
        goal_row=[0.0] * 200,
        neighbour=lambda number, direction: number + direction,
        passing_speed=lambda number, _other: 1.0 if number > 4 else 0.0,
        found=[],
    )
    history.find_goal = history.found.append
    History.survey(history, 1)
    assert (history.stretch[:2], history.stretch_end, history.found) == ([5, 4], 4, [2])
    expected = {
        rows.JERK: 78.0,
        rows.GOAL_LENGTH: 12.0,
        rows.GOAL_SPEED: 34.0,
        rows.GOAL_ACCELERATION: 1e300,
        rows.GOAL_JERK: 1e300,
        rows.GOAL_KIND: rows.EXEMPT_FEED_GOAL,
        rows.CARRIED_ACCELERATION: 56.0,
        rows.CARRIED_JERK: 78.0,
    }
    written = {column: value for column, value in enumerate(history.goal_row) if value}
    assert written == expected
    history.rounding_a = 3.0
    History.survey(history, 1)
    assert history.goal_row[rows.ROUNDING_LENGTH] == 1.0


def test_a_record_has_no_room_after_its_last_row() -> None:
    """Rows, events and probes each end the room; nothing is lost."""
    record = Record(bytearray(80), row_capacity=2, event_capacity=3, probe_capacity=4)
    record.select([0])
    assert record.has_room(3, 4) == 1
    assert record.has_room(4, 0) == 0
    assert record.has_room(0, 5) == 0
    record.take_row()
    assert record.has_room(0, 0) == 1
    record.take_row()
    assert record.has_room(0, 0) == 0


def test_a_reduced_record_keeps_lowest_and_highest_values() -> None:
    """With those before the first tick; what was once no number stays none until it is taken."""
    memory = bytearray(24)
    values = memoryview(memory).cast("d")
    record = Record(memory, row_capacity=4)
    record.select([0, 2], reduced=True)
    for first, third in ((3.0, -1.0), (1.0, math.nan), (2.0, 5.0)):
        values[0], values[2] = first, third
        record.take_row()
    assert record.row_count == 3
    lowest, lost, highest, gone = memoryview(record.take_extent()).cast("d")
    assert (lowest, highest) == (0.0, 3.0)
    assert math.isnan(lost)
    assert math.isnan(gone)
    assert record.row_count == 0
    values[0] = 7.0
    record.take_row()
    assert memoryview(record.take_extent()).cast("d").tolist() == [2.0, 5.0, 7.0, 5.0]


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_drive_lags_alike_in_both_directions(sign: float) -> None:
    """MO-11: kept · lag + gained · step; less than a nanometre is none."""
    axes = Axes(bytearray(8 * cells.AXIS_CELLS), 0, 1)
    axes.set_lag(0, 0.5, 2.0)
    axes.command[0] = sign
    axes.follow()
    assert axes.lag_d[0] == 2.0 * sign
    axes.follow()
    assert axes.lag_d[0] == 1.0 * sign
    axes.drive_d[0] = sign * 1.8e-9
    axes.follow()
    assert axes.lag_d[0] == 0.0


def test_a_pass_of_a_loop_begins_where_the_one_before_has_ended() -> None:
    """The start of the first segment becomes the target of the last one, dwells left out."""
    width = rows.START + 8
    body = LoopBody(width)
    for kind, start in ((rows.SEGMENT, 10.0), (rows.SEGMENT, 20.0), (rows.DWELL, 30.0)):
        row = memoryview(bytearray(8 * width)).cast("d")
        row[rows.KIND] = kind
        for column in range(8):
            row[rows.START + column] = start + column
        body.append(row, 0)
    body.end(2, True)
    assert [body.rows[rows.START + i] for i in range(3)] == [22.0, 23.0, 12.0]


def test_a_record_grows_only_while_it_is_empty() -> None:
    """What was recorded and not taken yet is not lost."""
    record = Record(bytearray(80), event_capacity=2, probe_capacity=2)
    record.reserve(5, 6)
    assert record.has_room(10, 12) == 1
    record.event(rows.EVENT_NOTICE, 1, 2, 3)
    record.reserve(50, 2)
    assert record.has_room(10, 0) == 0
    taken = memoryview(record.take_events()).cast("d")
    assert taken[rows.EVENT_SOURCE] == 1.0


def test_an_event_that_was_taken_is_none_of_this_tick() -> None:
    """A stop looks only at events that the record still has."""
    record = Record(bytearray(80), event_capacity=1)
    record.tick = 5
    record.event(rows.EVENT_NOTICE, 1, 2, 3)
    context = context_of(bytearray(80))
    context.tick = 5
    wide = [-1e300] * rows.EVENT_WIDTH, [1e300] * rows.EVENT_WIDTH
    stop = Happens(1 << rows.EVENT_NOTICE, *wide, Expression(), 1)
    assert stop.holds(context, record) == 1
    record.take_events()
    assert stop.holds(context, record) == 0


def test_the_fault_of_an_axis_is_taken_once() -> None:
    """Its channel reports it; the PLC still reads it (``fault_of``)."""
    axes = SingleAxes(Axes(bytearray(8 * cells.AXIS_CELLS), 0, 1), Record(bytearray(80)), 1000)
    axes.faults.message[0] = 1702
    axes.faults.open_count = 1
    assert [axes.faults.take(0), axes.faults.take(0)] == [1702, 0]
    assert (axes.faults.open_count, axes.fault_of(0)) == (0, 1702)


def test_a_position_of_a_spindle_is_below_360_degrees() -> None:
    """Rounding leads just below a revolution to 360; it is the begin of the next one."""
    assert [spindles.wrapped(angle) for angle in (0.0, 360.0, -90.0, 725.0)] == [
        0.0,
        0.0,
        270.0,
        5.0,
    ]
    assert spindles.wrapped(-1e-17) == 0.0


def test_axes_that_fail_in_one_tick_are_reported_in_their_order() -> None:
    """Each error event has its axis."""
    memory = bytearray(8 * 3 * cells.AXIS_CELLS)
    axes = SingleAxes(Axes(memory, 0, 3), Record(bytearray(80)), 1000)
    for axis in (2, 0, 1):
        axes.fail(axis, 1702)
    assert [axes.next_failed() for _ in range(3)] == [2, 0, 1]


@pytest.mark.parametrize(
    ("kind", "is_retracing", "is_front_over", "promised"),
    [
        (rows.SEGMENT, False, False, 12.0),
        (rows.SEGMENT, True, False, 12.0),
        (rows.SEGMENT, False, True, 12.0),
        (rows.SEGMENT, True, True, 0.0),
        (rows.DWELL, False, False, 0.0),
    ],
)
def test_only_a_segment_that_still_lies_ahead_promises_a_speed(
    kind: int, is_retracing: bool, is_front_over: bool, promised: float
) -> None:
    """The newest segment, unless the path walks back from its end."""
    history_rows = [0.0] * 200
    history_rows[100 + rows.KIND] = kind
    history_rows[100 + rows.END_SPEED] = 12.0
    path: Any = SimpleNamespace(
        history_rows=history_rows,
        front=100,
        is_retracing=is_retracing,
        is_front_over=is_front_over,
    )
    assert KernelPath.promised_speed(path, rows.END_SPEED) == promised


@pytest.mark.parametrize(
    ("continues", "rounding_d", "rest_d", "stands"),
    [
        (0.0, 0.0, 1.0, 1),
        (1.0, 0.0, 10.0, 0),
        (1.0, 0.0, 9.0, 1),
        (1.0, 1.0, 4.0, 0),
        (1.0, 1.0, 3.9, 1),
    ],
)
def test_single_block_stops_in_a_block_that_has_no_room_to_stop_in(
    continues: float, rounding_d: float, rest_d: float, stands: int
) -> None:
    """The rest of the block is just enough, or not; before a rounding by its own limits."""
    row = [0.0] * 200
    row[rows.CONTINUES] = continues
    row[rows.REMAINING_LENGTH] = rest_d
    row[rows.CARRIED_ACCELERATION], row[rows.CARRIED_JERK] = 100.0, 200.0
    row[rows.ROUNDING_LENGTH], row[rows.GOAL_SPEED] = rounding_d, 2.0
    row[rows.ROUNDING_ACCELERATION], row[rows.ROUNDING_JERK] = 30.0, 40.0
    lengths = {(5.0, 0.0, 100.0, 200.0): 10.0, (2.0, 0.0, 30.0, 40.0): 4.0}
    course = SimpleNamespace(stopping_d=lambda *values: lengths[values])
    path: Any = SimpleNamespace(
        row=0, history_rows=row, speed_v=3.0, jerk_profile=SimpleNamespace(course=course)
    )
    assert KernelPath.stops_in_single_block(path, 5.0) == stands


def test_more_is_decoded_only_below_the_low_water() -> None:
    """Commands that take time count; with as many as the mark there are enough."""
    rig = Rig()
    rig.channel.feed.decoder_open = True
    rig.channel.feed.low_water = 2
    rig.dwell(10)
    assert rig.channel.needs_python() == codes.REFILL
    rig.dwell(10)
    assert rig.channel.needs_python() == codes.DONE


@pytest.mark.parametrize(
    ("begin", "end", "way"), [(350.0, 10.0, 20.0), (10.0, 350.0, -20.0), (0.0, 90.0, 90.0)]
)
def test_a_modulo_axis_lags_on_the_shorter_way(begin: float, end: float, way: float) -> None:
    """MO-11: over the end of its range, too; another axis has only one way."""
    axes = Axes(bytearray(8 * 2 * cells.AXIS_CELLS), 0, 2)
    axes.set_modulo(0, 0.0, 360.0)
    assert axes.distance(0, begin, end) == way
    assert axes.distance(1, begin, end) == end - begin


@pytest.mark.parametrize(("mode", "message"), [(codes.ABORTING, 0), (codes.BUFFERED, 1)])
def test_a_distance_counts_from_where_its_motion_begins(mode: int, message: int) -> None:
    """From the commanded position where it takes over, from the goal where it waits (RC-409)."""
    rig = Rig()
    axes = rig.machine.single_axes
    high = axes.limits.high[0]
    assert axes.absolute(0, high - 10.0, 100.0, codes.PRESENT, codes.ABORTING, 1) == 0
    rig.run(2)
    assert (axes.relative(0, high - 20.0, 100.0, mode, 1) != 0) == bool(message)
