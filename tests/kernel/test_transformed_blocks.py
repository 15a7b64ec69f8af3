# SPDX-License-Identifier: MIT
"""Blocks under a transformation: every kind of kinematic, arcs, poles, switches, an operator.

MO-1, MO-5 … MO-8: the axes keep their limits in every tick whatever the operator does, the tool is
where the product of the matrices says, and the axes end where they end without the operator.
"""

from __future__ import annotations

import numpy as np
import pytest
from support.five_axis_limits import broken_limits, positions
from support.five_axis_programs import NAMES
from support.random_operator import Operator
from support.random_seeds import seeds_in_parts
from support.transformed_programs import machine, tip, transformed_program

from nctakt.results.run import Run
from nctakt.run.access.stimuli import Stimulus
from nctakt.run.controller import Controller, NcText

SIGNALS = [
    *(f"{name}.ACS.ACT_POS" for name in NAMES),
    "BLOCK",
    *(f"{name}.MCS.ACT_POS" for name in "XYZ"),
    *(f"{name}.PCS.ACT_POS" for name in "XYZ"),
]
#: Where the axes are at first; numbers that binary fractions do not hold.
START = "N1 G00 X12.3456 Y-7.7777 Z33.3333 C17.1717 A-13.1313\n"
#: Messages of blocks that a random program cannot have: a pole, an axis at its limit.
REFUSED = {901619, 120002, 120003}


def run_of(text: str, operator: Operator | None = None, *at: Stimulus) -> Run:
    """The run of a program on ``machine()``, with the trace of ``SIGNALS``."""
    return Controller(machine()).run(
        NcText("t.nc", text), plc=operator, at=at, ticks=200_000, signals=SIGNALS
    )


def messages(run: Run) -> set[int]:
    return {one.id for one in run.diagnostics}


def signals(run: Run, *names: str) -> np.ndarray:
    assert run.trace is not None
    return np.array([run.trace[name] for name in names]).T


def check(run: Run, kinematic: int, has_jerk_limit: bool) -> list[str]:
    """What is wrong with a run: limits of the axes, the tip that is shown."""
    places = positions(run)
    found = broken_limits(places, has_jerk_limit)
    ticks = np.flatnonzero(signals(run, "BLOCK")[:, 0] >= 10)[:-1][::17]
    shown = signals(run, *(f"{name}.MCS.ACT_POS" for name in "XYZ"))
    for tick in ticks:
        off = np.abs(tip(places[tick], kinematic) - shown[tick]).max()
        if off > 1e-9:
            found.append(f"tick {tick}: the tip is shown {off:.3g} mm off")
    return found


@seeds_in_parts(compiled=24, plain=1, part=6)
def test_every_kind_of_kinematic_keeps_the_limits_of_the_axes(seeds: range) -> None:
    for seed in seeds:
        program = transformed_program(seed)
        run = run_of(program.text)
        if not messages(run) & REFUSED:
            assert not run.diagnostics, (seed, [str(one) for one in run.diagnostics])
        found = check(run, program.kinematic, program.has_jerk_limit)
        assert not found, (seed, found)


@seeds_in_parts(compiled=8, plain=1, part=4)
def test_an_operator_changes_neither_limits_nor_the_end(seeds: range) -> None:
    for seed in seeds:
        program = transformed_program(seed)
        quiet = run_of(program.text)
        if quiet.diagnostics:
            continue
        run = run_of(program.text, Operator(seed, "override hold back single"))
        found = check(run, program.kinematic, program.has_jerk_limit)
        assert not found, (seed, found)
        assert np.abs(positions(run)[-1] - positions(quiet)[-1]).max() < 1e-9, seed


@pytest.mark.parametrize("kinematic", range(1, 7))
def test_switching_off_moves_no_axis_and_the_next_block_starts_there(kinematic: int) -> None:
    for between in ("", "N4 G01 X50 Y10 F5000\n"):
        text = f"{START}N3 #TRAFO [{kinematic}]\n{between}N5 #TRAFO OFF\nN6 G00 X1 Y2 Z3\nM30"
        run = run_of(text)
        assert not run.diagnostics
        assert list(positions(run)[-1][:3]) == [1.0, 2.0, 3.0]


@pytest.mark.parametrize("kinematic", (1, 2, 3, 4))
def test_straight_motion_starts_where_the_axes_are(kinematic: int) -> None:
    text = f"""{START}N3 #TRAFO [{kinematic}]
N4 #PTP ON
N5 G00 X50 Y20 Z-50 C90 A30
N6 #PTP OFF
N7 G01 X60 F4000
M30"""
    run = run_of(text)
    assert not run.diagnostics
    assert np.abs(tip(positions(run)[-1], kinematic) - [60.0, 20.0, -50.0]).max() < 1e-9
    assert not broken_limits(positions(run), False)


def test_a_block_through_a_pole_is_refused_at_its_place() -> None:
    run = run_of(f"{START}N2 G00 C0 A0\nN3 #TRAFO [5]\nN4 G01 C30 A20 F5000\nM30")
    assert messages(run) == {901619}
    assert str(run.diagnostics[0].span) == "t.nc:4:4"
    assert "axis C" in str(run.diagnostics[0])


def test_beside_a_pole_the_block_slows_down() -> None:
    """The tool's direction passes the axis C at a hundredth of a degree."""
    run = run_of(f"{START}N2 G00 C0 A10\nN3 #TRAFO [6]\nN4 G01 A0.01 C0 F5000\nM30")
    assert not run.diagnostics
    places = positions(run)
    assert not broken_limits(places, False)


def test_a_way_outside_the_limits_is_found_between_its_ends() -> None:
    """The tool turns by 180° about C, which takes X beyond 10 m in the middle of the block."""
    run = run_of("N1 G00 X9900 Y0 Z0 C0 A60\nN2 #TRAFO [1]\nN3 G01 C180 F5000\nM30")
    assert messages(run) == {120002}


def test_reset_drops_the_transformation_with_the_next_program() -> None:
    controller = Controller(machine())
    text = f"{START}N2 #TRAFO [1]\nN3 G01 X90 C50 F500\nN4 X0\nM30"
    run = controller.run(
        NcText("t.nc", text), at=[Stimulus("2 s", "HLI.RESET", 1.0)], signals=SIGNALS, ticks=9000
    )
    places = positions(run)
    assert np.abs(tip(places[-1], 1) - signals(run, "X.MCS.ACT_POS")[-1][0])[0] < 1e-9
    again = controller.run(NcText("t.nc", "N1 G91 G01 X1 F1000\nM30"), signals=SIGNALS, ticks=9000)
    assert not again.diagnostics
    end = positions(again)[-1]
    assert end[0] == pytest.approx(places[-1][0] + 1.0, abs=1e-9)
    assert signals(again, "X.MCS.ACT_POS")[-1][0] == end[0]


def test_another_tool_moves_the_tip_with_the_next_position() -> None:
    """Tool 1 has 100 mm, tool 2 has 80 mm."""
    text = f"""D1
{START}N2 #TRAFO [1]
N3 G01 X50 Y10 Z-100 F5000 C20
N4 D2
N5 X50 Y10 Z-100 C30 A20
M30"""
    run = run_of(text)
    places = positions(run)
    blocks = signals(run, "BLOCK")[:, 0]
    assert np.abs(tip(places[blocks == 3][-2], 1, 100.0)[0] - 50.0) < 1.0
    assert np.abs(tip(places[-1], 1, 80.0) - [50.0, 10.0, -100.0]).max() < 1e-9
    assert not broken_limits(places, False)


def test_zero_offsets_and_turned_systems_act_on_the_tip() -> None:
    """G54 of demo5 and #CS: the programmed place is that of the tip in the turned system."""
    text = f"""{START}N2 #TRAFO [2]
#CS ON [10,20,-30,0,0,90]
N10 G01 X5 Y6 Z-20 F5000 C10 A5
M30"""
    run = run_of(text)
    assert not run.diagnostics
    assert np.abs(tip(positions(run)[-1], 2) - [10 - 6, 20 + 5, -50]).max() < 1e-9
    pcs = signals(run, *(f"{name}.PCS.ACT_POS" for name in "XYZ"))[-1]
    assert np.abs(pcs - [5, 6, -20]).max() < 1e-9


def test_realtime_cycles_see_that_axis_and_tip_differ() -> None:
    """RC-304: V.RTA.ACS is the axis, V.RTA.MCS and V.RTA.PCS are the tip."""
    text = f"""{START}N2 #TRAFO [1]
#RT CYCLE [ID=1 SCOPE=PROG]
$IF ONCE V.RTA.MCS.ACT_POS.X > 100 && V.RTA.ACS.ACT_POS.X < 100
M100
$ENDIF
#RT CYCLE END
N10 G01 X120 F3000
M30"""
    run = run_of(text)
    assert not run.diagnostics
    fired = [event.tick for event in run.events if event.kind == "fired"]
    passed = np.flatnonzero(signals(run, "X.MCS.ACT_POS")[:, 0] > 100.0)
    assert len(fired) == 1
    assert fired[0] == passed[0] + 1
    assert positions(run)[fired[0]][0] < 100.0
