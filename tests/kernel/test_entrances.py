# SPDX-License-Identifier: MIT
"""What Python hands to the realtime part is checked there: no number reaches memory unseen."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest
from support.insides import loop_of
from support.kernel_rig import DEMO, Rig

from nctakt.base.failure import Failure
from nctakt.kernel import codes, rows
from nctakt.kernel.axes.axes import Axes
from nctakt.kernel.axes.coordinates import Offsets
from nctakt.kernel.axes.spindles import Spindles
from nctakt.kernel.axes.trajectory import Trajectories
from nctakt.kernel.base.record import Record
from nctakt.kernel.base.timers import Timers
from nctakt.kernel.cycles.cycles import CycleManager
from nctakt.kernel.cycles.expressions import Constant, Index, Load, LoadElement
from nctakt.kernel.cycles.instructions import AssignElement, AssignReal
from nctakt.kernel.path.path import Path as KernelPath
from nctakt.kernel.path.probing.edge_probe import EdgeProbe
from nctakt.kernel.plc.image_bytes import ImageBytes
from nctakt.kernel.plc.image_slots import SectionUnits, SpindleUnits, Units
from nctakt.kernel.plc.panel import Panel
from nctakt.kernel.plc.technology_slots import FunctionTable, Hli, Section
from nctakt.kernel.tick.channel import LOW_WATER
from nctakt.run.controller import Controller
from nctakt.run.queue_feeder import HIGH_WATER
from nctakt.run.tick_loop import TICKS_AT_ONCE

#: Further than any table of the machine, before its begin, and beyond integers of 64 bits.
WRONG = (-1, 10**6, -(10**9), 1 << 62, -(1 << 63), 10**30, float("nan"))

_Entrance = Callable[[Rig, int], object]

#: Each entrance with one number from outside, all other numbers in order.
ENTRANCES: dict[str, _Entrance] = {
    "axes.shift axis": lambda rig, n: rig.machine.axes.shift(n, 0, 1.0),
    "axes.shift kind": lambda rig, n: rig.machine.axes.shift(0, n, 1.0),
    "axes.set_modulo": lambda rig, n: rig.machine.axes.set_modulo(n, 0.0, 360.0),
    "axes.set_stop": lambda rig, n: rig.machine.axes.set_stop(n, 1.0),
    "axes.set_lag": lambda rig, n: rig.machine.axes.set_lag(n, 0.5, 0.5),
    "axes.set_override": lambda rig, n: rig.machine.axes.set_override(n, 0, 100.0),
    "axes.place": lambda rig, n: rig.machine.axes.set_position(n, 1.0),
    "offsets.of": lambda rig, n: rig.machine.axes.offsets.of(n, 127),
    "single_axes.configure": lambda rig, n: rig.machine.single_axes.configure(
        n, low=0.0, high=1.0, speed=1.0, acceleration=1.0, jerk=0.0
    ),
    "single_axes.assign_to_channel": lambda rig, n: rig.machine.single_axes.assign_to_channel(n),
    "single_axes.absolute axis": lambda rig, n: rig.machine.single_axes.absolute(
        n, 1.0, 1.0, 0, 0, 1
    ),
    "single_axes.absolute mode": lambda rig, n: rig.machine.single_axes.absolute(
        0, 1.0, 1.0, n, 0, 1
    ),
    "single_axes.relative": lambda rig, n: rig.machine.single_axes.relative(n, 1.0, 1.0, 0, 1),
    "single_axes.velocity": lambda rig, n: rig.machine.single_axes.velocity(n, 1.0, 1, 0, 1),
    "single_axes.halt": lambda rig, n: rig.machine.single_axes.halt(n, 1),
    "single_axes.clear": lambda rig, n: rig.machine.single_axes.clear(n),
    "single_axes.state_of": lambda rig, n: rig.machine.single_axes.state_of(n),
    "single_axes.present_owner": lambda rig, n: rig.machine.single_axes.present_owner(n),
    "single_axes.arrived_owner": lambda rig, n: rig.machine.single_axes.arrived_owner(n),
    "single_axes.fault_of": lambda rig, n: rig.machine.single_axes.fault_of(n),
    "single_axes.at_speed": lambda rig, n: rig.machine.single_axes.at_speed(n),
    "single_axes.moves": lambda rig, n: rig.machine.single_axes.moves(n),
    "spindles.configure": lambda rig, n: rig.channel.context.spindles.configure(
        n, plc=False, speed=1.0, acceleration=1.0
    ),
    "spindles.has_plc": lambda rig, n: rig.channel.context.spindles.has_plc(n),
    "spindles.acknowledge": lambda rig, n: rig.channel.context.spindles.acknowledge(n, 1),
    "requests.post kind": lambda rig, n: rig.machine.kernel.requests.post(n, 0, 0.0, 1.0, 0, 0),
    "requests.post axis": lambda rig, n: rig.machine.kernel.requests.post(1, n, 0.0, 1.0, 0, 0),
    "requests.answer_to": lambda rig, n: rig.machine.kernel.requests.answer_to(n),
    "requests.is_active": lambda rig, n: rig.machine.kernel.requests.is_active(n, 1_000_000),
    "requests.has_arrived": lambda rig, n: rig.machine.kernel.requests.has_arrived(n, 1_000_000),
    "section.acknowledge": lambda rig, n: rig.channel.hli.realtime.acknowledge(n, 1),
    "section.value_of": lambda rig, n: rig.channel.hli.program.value_of(n),
    "panel.put": lambda rig, n: rig.channel.panel.put(n, 1.0),
    "kernel.posted.post": lambda rig, n: rig.machine.kernel.posted.post(n, 1.0),
    "kernel.posted.post_bytes": lambda rig, n: rig.machine.kernel.posted.post_bytes(n, bytes(16)),
    "record.select": lambda rig, n: rig.machine.record.select([0, n]),
    "manager.state_of": lambda rig, n: rig.channel.manager.state_of(n),
    "path.segment_row": lambda rig, n: rig.channel.path.segment_row(n),
    "path members": lambda rig, n: KernelPath(rig.machine.axes, [0, n], 1000),
    "queue.row": lambda rig, n: rig.channel.queue.command(n),
    "put cell": lambda rig, n: put(rig, rows.WRITE_VARIABLE, n, 1.0, 0),
    "put read": lambda rig, n: put(rig, rows.READ, 1, n),
    "put text": lambda rig, n: put(rig, rows.WRITE_TEXT, n, 0, 1, 1, 65),
    "put text first": lambda rig, n: put(rig, rows.WRITE_TEXT, 0, n, 1, 1, 65),
    "put text count": lambda rig, n: put(rig, rows.WRITE_TEXT, 0, 0, n, 1, 65),
    "put text zeros": lambda rig, n: put(rig, rows.WRITE_TEXT, 0, 0, 1, n, 65),
    "put character": lambda rig, n: put(rig, rows.WRITE_TEXT, 0, 0, 1, 1, n),
    "put slot": lambda rig, n: put(rig, rows.DEFINE_CYCLE, n, 1),
    "put timer": lambda rig, n: put(rig, rows.TIMER, n, 0),
    "put spindle": lambda rig, n: put(rig, rows.SPINDLE, n, 3, 1.0, 0.0, 1, 0),
    "put awaited spindle": lambda rig, n: put(rig, rows.AWAIT_SPINDLE, n),
    "put fixed stop": lambda rig, n: put(rig, rows.FIXED_STOP, n, 1, 1, 1, 0, 1, 1),
    "put offset axis": lambda rig, n: put(rig, rows.SET_OFFSET, n, 0, 1.0),
    "put offset kind": lambda rig, n: put(rig, rows.SET_OFFSET, 0, n, 1.0),
    "put origin": lambda rig, n: put(rig, rows.SET_ORIGIN, n, 1.0),
    "put turn first": lambda rig, n: put(rig, rows.SET_TURN, n),
    "put turn second": lambda rig, n: put(rig, rows.SET_TURN, 0, n, 1, *[0.0] * 9),
    "put turn third": lambda rig, n: put(rig, rows.SET_TURN, 0, 1, n, *[0.0] * 9),
    "put positions": lambda rig, n: put(rig, rows.POSITIONS, 1, n, 0),
    "put positions axis": lambda rig, n: put(rig, rows.POSITIONS, 1, 1, n),
    "ahead.limit": lambda rig, n: rig.channel.queue.look_ahead.limits.limit(
        n, True, (1.0, 1.0), (1.0, 1.0)
    ),
    "ahead.limit_slope": lambda rig, n: rig.channel.queue.look_ahead.limits.limit_slope(
        n, (1.0, 1.0), (1.0, 1.0)
    ),
}


def put(rig: Rig, kind: int, *arguments: float) -> None:
    """Hand a command to the channel as the decoder does."""
    rig.channel.put([kind, 0, 0, *arguments])


@pytest.mark.parametrize("name", ENTRANCES)
def test_a_number_out_of_its_range_is_refused(name: str) -> None:
    """Each entrance, before, after and far from its table; nothing is read or written."""
    rig = Rig()
    before = bytes(rig.machine.memory)
    for number in WRONG:
        with pytest.raises((ValueError, OverflowError), match="is not in"):
            ENTRANCES[name](rig, number)  # type: ignore[arg-type]
    assert bytes(rig.machine.memory) == before


#: Constructors with one number from outside: a first cell, a size, a member, a byte of the image.
CONSTRUCTORS: dict[str, _Entrance] = {
    "Axes first": lambda rig, n: Axes(bytearray(800), n, 2),
    "Axes count": lambda rig, n: Axes(bytearray(800), 0, n),
    "Offsets": lambda rig, n: Offsets(n),
    "Trajectories": lambda rig, n: Trajectories(n),
    "Spindles first": lambda rig, n: Spindles(bytearray(800), n, 2, rig.machine.record, 1000),
    "Spindles count": lambda rig, n: Spindles(bytearray(800), 0, n, rig.machine.record, 1000),
    "Timers": lambda rig, n: Timers(bytearray(2000), n, 1000),
    "Record rows": lambda rig, n: Record(bytearray(800), row_capacity=n),
    "Record events": lambda rig, n: Record(bytearray(800), event_capacity=n),
    "Record probes": lambda rig, n: Record(bytearray(800), probe_capacity=n),
    "Panel": lambda rig, n: Panel(bytearray(800), n),
    "Section": lambda rig, n: Section(n),
    "Hli": lambda rig, n: Hli(rig.channel.hli.panel, n),
    "KernelPath member": lambda rig, n: KernelPath(rig.machine.axes, [n], 1000),
    "KernelPath history": lambda rig, n: KernelPath(rig.machine.axes, [0], 1000, n),
    "EdgeProbe": lambda rig, n: EdgeProbe(
        rig.channel.path, rig.channel.hli, rig.machine.record, bytearray(800), n
    ),
    "CycleManager": lambda rig, n: CycleManager(rig.machine.record, rig.machine.single_axes, 0, n),
    "SectionUnits first": lambda rig, n: units_of(rig, n, 0),
    "SectionUnits acknowledged": lambda rig, n: units_of(rig, 0, n),
    "Load cell": lambda rig, n: Load(n, 4),
    "Index stride": lambda rig, n: Index(Constant(0.0), n, 1, None, 0, 0),
    "Index count": lambda rig, n: Index(Constant(0.0), 1, n, None, 0, 0),
    "SpindleUnits job": lambda rig, n: jobs_of(rig, n, 64, 0, 8),
    "SpindleUnits size": lambda rig, n: jobs_of(rig, 0, n, 0, 8),
    "SpindleUnits answer": lambda rig, n: jobs_of(rig, 0, 64, n, 8),
    "SpindleUnits answer size": lambda rig, n: jobs_of(rig, 0, 64, 0, n),
}


def test_an_element_lies_in_the_memory_of_its_variable() -> None:
    """The highest index of all dimensions together, of what is read and of what is written."""
    inner = Index(Constant(0.0), 1, 3, None, 0, 0)
    outer = Index(Constant(0.0), 3, 2, inner, 0, 0)
    assert (inner.span, outer.span) == (2, 5)
    LoadElement(Load(4, 10), outer)
    AssignElement(outer, AssignReal(Load(4, 10), Constant(1.0), 0, 1), 0, 1)
    with pytest.raises(ValueError, match="index 5 is not in"):
        LoadElement(Load(5, 10), outer)
    with pytest.raises(ValueError, match="index 5 is not in"):
        AssignElement(outer, AssignReal(Load(5, 10), Constant(1.0), 0, 1), 0, 1)


def jobs_of(rig: Rig, job: int, size: int, answer: int, answer_size: int) -> SpindleUnits:
    """Jobs of the channel's spindles in an image of 64 KiB."""
    image = memoryview(bytearray(1 << 16))
    spindles = rig.channel.context.spindles
    shown = ImageBytes(image, image)
    return SpindleUnits(spindles, shown, job, size, answer, answer_size, 1000, Units())


def units_of(rig: Rig, first: int, acknowledged: int) -> SectionUnits:
    """Units of a section in an image of 64 KiB."""
    image = memoryview(bytearray(1 << 16))
    shown, types = ImageBytes(image, image), FunctionTable(bytearray(8), bytearray(8), 0)
    section = rig.channel.hli.program
    return SectionUnits(section, shown, first, acknowledged, 1000, 1, types, Units())


@pytest.mark.parametrize("name", CONSTRUCTORS)
def test_an_object_that_would_leave_its_memory_is_not_made(name: str) -> None:
    """Sizes and first cells; a size that no memory has is no attempt to reserve it."""
    rig = Rig()
    sizes = (-1, -(10**9), 1 << 62, -(1 << 63), 10**30)
    for number in sizes:
        with pytest.raises((ValueError, OverflowError)):
            CONSTRUCTORS[name](rig, number)


@pytest.mark.parametrize("value", [float("nan"), float("inf"), -float("inf")])
def test_a_motion_to_nowhere_is_refused(value: float) -> None:
    """Positions, distances and speeds are finite."""
    rig = Rig()
    with pytest.raises(ValueError, match="not a finite number"):
        rig.machine.kernel.requests.post(1, 0, value, 1.0, 0, 0)
    with pytest.raises(ValueError, match="not a finite number"):
        rig.machine.single_axes.relative(0, 1.0, value, 0, 1)


def test_a_command_longer_than_a_row_is_refused() -> None:
    """The next command would lose its begin, and the last one would leave the queue."""
    rig = Rig()
    with pytest.raises(ValueError, match="length of a command"):
        rig.channel.queue.put([1.0] * (rig.channel.queue.width + 1))
    with pytest.raises(ValueError, match="length of a command"):
        rig.channel.queue.put([])


@pytest.mark.parametrize(
    "kind", [0, rows.SEGMENT, max(rows.COMMANDS) + 1, -1, math.nan, math.inf, None]
)
def test_a_command_of_no_kind_is_refused(kind: int) -> None:
    """None of them would be taken, or it would be taken for another one."""
    rig = Rig()
    with pytest.raises(ValueError, match="is not a kind of command"):
        put(rig, kind, 1, 1)
    with pytest.raises(ValueError, match="is not a kind of command"):
        rig.channel.put([])


@pytest.mark.parametrize("kind", range(rows.DWELL, rows.EMPTY_BLOCK + 1))
def test_a_command_without_its_columns_is_refused(kind: int) -> None:
    """The queue would fill them up with zeros, which are indices, too."""
    with pytest.raises(ValueError, match=r"length of a command|is not a kind of command"):
        Rig().channel.put([kind])


@pytest.mark.parametrize("nothing", [None, "1", b"2", [], 1j])
def test_a_command_of_other_things_is_refused(nothing: object) -> None:
    """None, texts and the like are no numbers, in any column."""
    for column in range(3):
        arguments: list[object] = [1, 1.0, 0]
        arguments[column] = nothing
        with pytest.raises((TypeError, ValueError)):
            put(Rig(), rows.WRITE_VARIABLE, *arguments)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="is not a kind of command"):
        Rig().channel.put(None)  # type: ignore[arg-type]


def test_more_ticks_than_an_integer_holds_are_no_end_in_the_past() -> None:
    """The tick is an integer of 64 bits; the run ends for another reason, here the empty queue."""
    rig = Rig()
    rig.run(3)
    rig.channel.feed.decoder_open = True
    assert rig.machine.kernel.run((1 << 63) - 1) == codes.REFILL
    rig.channel.feed.decoder_open = False
    assert rig.machine.kernel.run(-1) == codes.DONE
    assert rig.machine.kernel.tick == 3


def test_a_bytes_value_of_half_a_cell_is_refused() -> None:
    """A string fills whole cells."""
    with pytest.raises(TypeError):
        Rig().machine.kernel.posted.post_bytes(0, b"123")


def test_rows_of_an_image_that_leave_it_are_refused() -> None:
    """Byte, kind, cell, size and factor of each variable."""
    machine = Rig().machine
    kernel, count = machine.kernel, len(machine.memory) // 8
    units = kernel.image.units if hasattr(kernel.image, "units") else None
    for row in (
        (64, 7, 0, 8, True, 1.0),
        (-8, 7, 0, 8, True, 1.0),
        (0, 9, 0, 8, True, 1.0),
        (0, 7, -1, 8, True, 1.0),
        (0, 7, 10**9, 8, True, 1.0),
        (0, 7, count, 8, True, 1.0),
        (0, 8, count - 1, 9, True, 1.0),
        (0, 7, 0, 9, True, 1.0),
        (0, 8, 0, 65, True, 1.0),
    ):
        shown = ImageBytes(memoryview(bytearray(64)), memoryview(bytearray(64)))
        with pytest.raises(ValueError, match="is not in"):
            kernel.image.attach(shown, [row], units, 0, 16, 0)
    for factor in (0.0, -1.0, float("nan")):
        with pytest.raises(ValueError, match="a factor of"):
            row = (0, 7, 0, 8, True, factor)
            kernel.image.attach(shown, [row], units, 0, 16, 0)
    assert not kernel.image.is_attached


def test_what_no_tick_has_given_cannot_be_taken() -> None:
    """An answer, a program's end, a RESET, a refused value."""
    rig = Rig()
    for take in (
        rig.channel.take_answer,
        rig.channel.accept_end,
        rig.channel.panel.accept_reset,
        rig.machine.kernel.image.next_refused,
    ):
        with pytest.raises(ValueError):
            take()


def test_the_queue_is_refilled_beyond_its_low_water() -> None:
    """Else it would be asked for more at once."""
    assert DEMO is not None
    assert LOW_WATER < HIGH_WATER


def test_steps_are_whole_numbers_of_ticks() -> None:
    """Half a tick would never be over; time does not go back."""
    controller = Controller()
    for ticks in (1.5, float("nan"), "3", None, -1):
        with pytest.raises(Failure, match="901186"):
            controller.step(ticks)  # type: ignore[arg-type]
    assert controller.tick == 0


def test_a_long_way_of_idle_ticks_can_be_interrupted() -> None:
    """Nothing is recorded and nothing waits; still Python gets its turn, and with it Ctrl-C."""
    controller = Controller()
    assert not loop_of(controller).advance(1 << 60)
    assert 0 < controller.tick <= TICKS_AT_ONCE


def test_python_reaches_no_queue_and_no_statement() -> None:
    """Rows of commands and statements of cycles come from the decoder, which has checked them.

    No public attribute of a controller leads to the objects that take them.
    """
    hidden = {"CommandQueue", "CycleManager", "RealtimeCycle", "CommandExecutor", "Channel"}
    controller = Controller()
    waiting: list[object] = [controller]
    seen: dict[int, object] = {}
    while waiting:
        one = waiting.pop()
        if id(one) in seen:
            continue
        seen[id(one)] = one
        is_kernel = type(one).__module__.startswith("nctakt.kernel")
        assert not (is_kernel and type(one).__name__ in hidden), type(one)
        if not type(one).__module__.startswith("nctakt.") or isinstance(one, type):
            continue
        names = [name for name in dir(one) if not name.startswith("_")]
        waiting += [value for name in names if not callable(value := getattr(one, name, None))]
    assert "PlcView" in {type(one).__name__ for one in seen.values()}
