# SPDX-License-Identifier: MIT
"""What is decided about moving to a fixed stop (MO-12): docs/conformance/measuring.md."""

from __future__ import annotations

from dataclasses import replace

import pytest
from support.decided import numbers, perform, reported

from nctakt.lists.machine.machine import load_machine
from nctakt.run.controller import Controller

ON = "X[FIXED_STOP ON"


def machine(**obstacles: float) -> Controller:
    """The demo machine with obstacles in the way of these axes, in mm."""
    demo = load_machine(None)
    axes = tuple(replace(axis, obstacle=obstacles.get(axis.name, 0.0)) for axis in demo.axes)
    return Controller(replace(demo, axes=axes))


def test_an_axis_that_finds_no_stop_is_an_error_unless_it_may() -> None:
    """No obstacle on the way: 50886 after the block; with ERR_NOT_DETECTED=0 it goes on."""
    run = perform(f"G01 X10 F6000 {ON}]\nG00 X20\nM30")
    assert run.state == "error"
    assert numbers(run) == [50886]
    run = perform(f"G01 X10 F6000 {ON} ERR_NOT_DETECTED=0]\nG00 X20 X[FIXED_STOP OFF]\nM30")
    assert run.state == "ended"
    assert reported(run, "fixed_stop") == []


def test_without_monitoring_an_obstacle_only_holds_the_axis() -> None:
    """The actual position stays at it, the command goes on; nothing is reported."""
    controller = machine(X=50.0)
    run = perform("G01 X60 F6000\nM30", controller)
    assert run.state == "ended"
    assert controller.read("V.RTA.ACS.ACT_POS.X") == 60.0
    assert controller.read("V.RTA.ACS.CUR_POS.X") == 50.0


def test_an_obstacle_below_zero_holds_the_other_way() -> None:
    """Its sign shows the side; the position of the stop stays after the block."""
    controller = machine(X=-20.0)
    run = perform(f"G01 X-40 F6000 {ON}]\nV.E.VALUE = V.RTA.FIXED_STOP.ACS.POS.X\nM30", controller)
    assert run.state == "ended"
    assert controller.read("V.E.VALUE") == -20.0


def test_all_monitored_axes_have_to_find_their_stop() -> None:
    """X at 20 alone does not stop the path, Y at 30 after it does."""
    controller = machine(X=20.0, Y=30.0)
    run = perform(f"G01 X80 Y80 F6000 {ON}] Y[FIXED_STOP ON]\nM30", controller)
    assert [text.split(" ", 1)[1] for text in reported(run, "fixed_stop")] == [
        "fixed_stop X 20",
        "fixed_stop Y 30",
    ]
    assert 32.0 < float(controller.read("V.RTA.ACS.ACT_POS.Y")) < 34.0


def test_start_and_end_bound_the_part_of_the_way() -> None:
    """Up to 60 % of the path nothing is monitored, and nothing after 40 %."""
    late = perform(f"G01 X100 F6000 {ON} START=60]\nM30", machine(X=50.0))
    early = perform(f"G01 X100 F6000 {ON}]\nM30", machine(X=50.0))
    assert int(reported(late, "fixed_stop")[0].split()[0]) - int(
        reported(early, "fixed_stop")[0].split()[0]
    ) == pytest.approx(80, abs=1)
    never = perform(f"G01 X100 F6000 {ON} END=40]\nM30", machine(X=50.0))
    assert numbers(never) == [50886]


def test_monitoring_ends_with_the_program_and_with_a_reset() -> None:
    """ACTIVE is taken back."""
    controller = machine(X=50.0)
    perform(f"G01 X100 F6000 {ON}]\nM30", controller)
    assert controller.read("V.RTA.FIXED_STOP.ACTIVE.X") is False
    perform(f"G01 X100 F6000 {ON}]\nG04 1\nM30", controller, ticks=600)
    assert controller.read("V.RTA.FIXED_STOP.ACTIVE.X") is True
    controller.reset()
    assert controller.read("V.RTA.FIXED_STOP.ACTIVE.X") is False


@pytest.mark.parametrize(
    ("block", "number"),
    [
        ("X10 Y[FIXED_STOP ON]", 21966),
        ("X10 X[FIXED_STOP ON START=50 END=40]", 21968),
        ("X10 X[FIXED_STOP ON START=10 END=200]", 21968),
        ("X10 X[FIXED_STOP AT=5]", 900706),
    ],
)
def test_what_cannot_be_monitored(block: str, number: int) -> None:
    """No motion of the axis, no part of the way, no such word."""
    run = perform(f"G01 F6000 {block}\nM30")
    assert run.state == "error"
    assert numbers(run) == [number]


@pytest.mark.parametrize(
    ("blocks", "number", "line"),
    [
        ("G01 Y5 F6000\nX40\nM30", 21967, 3),
        ("X[FIXED_STOP OFF] Y5\nX40\nM30", None, 0),
        ("X40 X[FIXED_STOP OFF]\nX30\nM30", None, 0),
        ("X40 X[FIXED_STOP ON]\nM30", 21969, 2),
        ("#CHANNEL INIT [ACTPOS]\nM30", 21964, 2),
        ("#CHANNEL INIT [CMDPOS]\nM30", None, 0),
        ("X40 X[FIXED_STOP OFF]\n#CHANNEL INIT [ACTPOS]\nM30", None, 0),
    ],
)
def test_an_axis_at_its_stop_is_left_with_off(blocks: str, number: int | None, line: int) -> None:
    """It cannot be moved, monitored or asked for its actual position before."""
    run = perform(f"G01 X100 F6000 {ON}]\n{blocks}", machine(X=50.0))
    assert [(one.id, one.span and one.span.line) for one in run.errors] == (
        [] if number is None else [(number, line)]
    )


def test_many_plain_lines_do_not_move_an_axis_at_its_stop() -> None:
    """The short way for plain lines is closed while an axis is monitored."""
    lines = "".join(f"Y{n}\n" for n in range(1200))
    run = perform(f"G01 X100 F6000 {ON}]\n{lines}X40\nM30", machine(X=50.0))
    assert numbers(run) == [21967]


def test_a_stop_needs_the_history_of_the_path() -> None:
    """P-STUP-00033 = 0: 50881."""
    demo = load_machine(None)
    channels = tuple(
        replace(one, startup=replace(one.startup, backward_memory_bytes=0)) for one in demo.channels
    )
    run = perform(f"G01 X100 F6000 {ON}]\nM30", Controller(replace(demo, channels=channels)))
    assert numbers(run) == [50881]
