# SPDX-License-Identifier: MIT
"""Independent axes of programs, INDP_SYN and INDP_ASYN: rules SA-1 … SA-10 in
docs/conformance/single-axes.md.

The demo machine: ticks of 1 ms, 4000 mm/s², X, Y, Z at most 500 mm/s, at rest at 0. At 100 mm/s
(FEED=6000) 10 mm take 10/100 + 100/4000 s: 125 ticks, of which the last is 124 after the first;
5 mm take 75 ticks, 20 mm take 225.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
from support.decided import numbers, perform, reported

from nctakt.lists.machine.machine import load_machine
from nctakt.plc import MC_MoveAbsolute, Plc
from nctakt.results.run import Run
from nctakt.run.access.stimuli import Stimulus
from nctakt.run.controller import Controller, NcText
from nctakt.run.plcs.plc_view import PlcView

#: Z to 10 in 125 ticks.
TO_10 = "G90 G01 FEED=6000 POS=10"


def axes(run: Run) -> list[str]:
    """What the axes did, without the number of the tick's event."""
    return reported(run, "axis")


def run_of(*lines: str, **how: Any) -> Run:
    """A program of these lines that ends without an error."""
    run = perform("\n".join((*lines, "M30")), **how)
    assert run.state == "ended", run.diagnostics
    return run


def end(run: Run) -> int:
    """The tick of the program's end."""
    (event,) = (event for event in run.events if event.kind == "end")
    return event.tick


def texts(run: Run) -> list[str]:
    """The messages of a run."""
    return [one.text for one in run.messages]


# --- SA-1: who waits ------------------------------------------------------------------------------


def test_asynchronous_motions_go_on_beside_the_program() -> None:
    """Page 208612235: X needs 125 ticks for each of two blocks; joined, 20 mm take 225."""
    run = run_of(f"Z[INDP_ASYN {TO_10}]", "G01 X10 F6000", "X20")
    assert axes(run) == ["0 axis Z begun 10", "124 axis Z done"]
    assert end(run) == 225


def test_a_block_waits_for_its_synchronous_axes() -> None:
    """5 mm of the path in the same block take 75 ticks, Z 125; then 5 more for 75."""
    run = run_of(f"Z[INDP_SYN {TO_10}] G01 X5 F6000", "X10")
    assert axes(run) == ["0 axis Z begun 10", "124 axis Z done"]
    assert end(run) == 125 + 75


def test_several_axes_of_a_block_begin_together() -> None:
    """The block is over when the slowest synchronous one is: Y for 225 ticks, not A."""
    run = run_of(
        f"Z[INDP_SYN {TO_10}] Y[INDP_SYN G91 G01 FEED=6000 POS=-20] "
        "A[INDP_ASYN G90 G01 FEED=3000 POS=30]",
        '#MSG ["%f %f", V.A.ABS.Z, V.A.ABS.Y]',
    )
    begun = [text for text in axes(run) if "begun" in text]
    assert begun == ["0 axis Z begun 10", "0 axis Y begun -20", "0 axis A begun 30"]
    assert texts(run) == ["10.000000 -20.000000"]
    assert end(run) == 225


def test_wait_indp_waits_for_an_asynchronous_axis() -> None:
    """#WAIT INDP [Z] is answered in tick 124; X takes 75 ticks from 125 on."""
    run = run_of(f"Z[INDP_ASYN {TO_10}]", "#WAIT INDP [Z]", "G01 X5 F6000")
    assert end(run) == 125 + 75


# --- SA-2: speeds ---------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("speed", "ticks"),
    [
        ("G01 FEED=6000", 125),  # 10/100 + 100/4000
        ("FEED 6000", 125),  # the sign = is optional, as G01 is where a speed is given
        ("G01 TIME=2", 2002),  # 5 mm/s: 2 + 5/4000 = 2.00125 s
        ("G01 FEED_MAX_WEIGHT=20", 125),  # 20 % of 500 mm/s
        ("G01 FEED=60000", 100),  # clamped to 500; the peak of 10 mm is 200 mm/s: 2 · 200/4000
        ("G00", 100),
        ("", 100),
    ],
)
def test_speeds_of_an_independent_axis(speed: str, ticks: int) -> None:
    """Page 208612235: FEED, TIME as under G93, FEED_MAX_WEIGHT as under G194."""
    run = run_of(f"Z[INDP_SYN G90 {speed} POS=10]")
    assert axes(run)[-1] == f"{ticks - 1} axis Z done"


def test_inch_and_rotary_axes() -> None:
    """G70: 1 inch at 1 inch/s; rotary axes have degrees whatever the unit is."""
    assert axes(run_of("G70", "Z[INDP_SYN G91 G00 POS=1]"))[0].endswith("Z begun 25.4")
    assert axes(run_of("G70", "A[INDP_SYN G91 G00 POS=1]"))[0].endswith("A begun 1")


def test_a_modulo_axis_goes_the_shorter_way() -> None:
    """As a single axis of a cycle without DIR: 350° is 10° back."""
    run = run_of("A[INDP_SYN G90 G00 POS=350]", "G91 G00 A0", '#MSG ["%f", V.A.ABS.A]')
    assert texts(run) == ["350.000000"]


# --- SA-3: offsets --------------------------------------------------------------------------------


def test_offsets_count_only_where_they_are_included() -> None:
    """Page 208612235: none in the initial state; with INCL_OFFSETS the position is the path's."""
    shown = '#MSG ["%f %f", V.A.ABS.Z, V.A.MCS.Z]'
    lines = ("G92 Z3", "Z[INDP_SYN G90 G00 POS=5]", shown)
    (plain,) = texts(run_of(*lines))
    (included,) = texts(run_of("G92 Z3", "Z[INDP_SYN G90 G00 POS=5 INCL_OFFSETS]", shown))
    (path,) = texts(run_of("G92 Z3", "G00 Z5", shown))
    assert plain != included == path


# --- SA-4: the axis is programmed again -----------------------------------------------------------


def test_a_second_command_waits_for_the_first() -> None:
    """Page 208612235: programming again synchronises; G91 counts from the first target."""
    run = run_of(f"Z[INDP_ASYN {TO_10}]", "Z[INDP_ASYN G91 G01 FEED=6000 POS=10]")
    begun_and_done = ["0 axis Z begun 10", "124 axis Z done"]
    assert axes(run) == [*begun_and_done, "125 axis Z begun 20", "249 axis Z done"]


def test_a_block_of_the_path_waits_for_the_axis() -> None:
    """Z20 begins in tick 125, from 10."""
    run = run_of(f"Z[INDP_ASYN {TO_10}]", "G01 Z20 F6000")
    assert end(run) == 250


# --- SA-5: programs, cycles and the PLC -----------------------------------------------------------


def test_a_command_needs_no_permission_of_the_list() -> None:
    """P-AXIS-00457 is the permission of realtime cycles and the PLC."""
    demo = load_machine(None)
    closed = tuple(replace(axis, enable_single_axis=False) for axis in demo.axes)
    run = run_of(f"Z[INDP_SYN {TO_10}]", controller=Controller(replace(demo, axes=closed)))
    assert axes(run)[-1] == "124 axis Z done"


def test_a_cycle_takes_the_axis_over_and_the_block_waits_for_it() -> None:
    """ABORTING: the last command has the axis; the program reads where it has come to."""
    run = run_of(
        "#RT CYCLE [ID=1 SCOPE=PROG]",
        "$IF ONCE V.RTA.ACS.ACT_POS.Z > 4",
        "Z[INDP G90 G01 FEED=6000 POS=-10]",
        "$ENDIF",
        "#RT CYCLE END",
        f"Z[INDP_SYN {TO_10}]",
        '#MSG ["%f", V.A.ABS.Z]',
        "G01 Z0 F6000",
    )
    assert [text.partition(" ")[2] for text in axes(run)] == [
        "axis Z begun 10",
        "axis Z aborted",
        "axis Z begun -10",
        "axis Z done",
    ]
    assert texts(run) == ["-10.000000"]


class _Mover(Plc):
    """Sends Z to -5 from a tick on."""

    def __init__(self, tick: int) -> None:
        self.tick = tick
        self.block = MC_MoveAbsolute("Z")

    def each_tick(self, hli: PlcView) -> None:
        self.block(hli, execute=hli.tick + 1 >= self.tick, position=-5, velocity=100)


def test_the_plc_takes_the_axis_over() -> None:
    """In tick 50, at 3.75 mm and 100 mm/s; the program goes on when Z is at rest."""
    run = run_of(f"Z[INDP_SYN {TO_10}]", '#MSG ["%f", V.A.ABS.Z]', plc=_Mover(50))
    assert axes(run)[1:3] == ["50 axis Z aborted", "50 axis Z begun -5"]
    assert texts(run) == ["-5.000000"]


def test_the_program_takes_the_axis_over_from_the_plc() -> None:
    """The PLC begins in tick 1, the program in tick 50."""
    run = run_of("G04 0.05", f"Z[INDP_SYN {TO_10}]", plc=_Mover(1))
    assert axes(run) == [
        "1 axis Z begun -5",
        "50 axis Z aborted",
        "50 axis Z begun 10",
        axes(run)[-1],
    ]
    assert axes(run)[-1].endswith("axis Z done")


# --- SA-6: P-CHAN-00451 ---------------------------------------------------------------------------


@pytest.mark.parametrize(("waits", "ticks"), [(False, 75), (True, 125 + 75)])
def test_a_block_that_need_not_move_the_axis(waits: bool, ticks: int) -> None:
    """P-CHAN-00451 = 0: Z10 is where Z is going, so X begins at once; 1: it waits for Z."""
    demo = load_machine(None)
    (channel,) = demo.channels
    parameters = replace(channel.parameters, awaits_idle_axes=waits)
    machine = replace(demo, channels=(replace(channel, parameters=parameters),))
    run = run_of(f"Z[INDP_ASYN {TO_10}]", "G01 X5 Z10 F6000", controller=Controller(machine))
    assert end(run) == ticks
    assert axes(run) == ["0 axis Z begun 10", "124 axis Z done"]


# --- SA-7: override, feed hold, reset -------------------------------------------------------------


def test_the_override_of_the_channel_counts() -> None:
    """P-AXIS-00491 = 0: 50 % of 100 mm/s: 10/50 + 50/4000 s."""
    run = run_of(f"Z[INDP_SYN {TO_10}]", set={"HLI.OVERRIDE": 50.0})
    assert axes(run)[-1] == "212 axis Z done"


def test_the_feed_hold_of_the_channel_stops_the_motion() -> None:
    """P-AXIS-00540 = 0: it brakes from tick 50 on, 25 ticks, and goes on from tick 100."""
    hold = [Stimulus("50 ms", "HLI.FEED_HOLD", 1.0), Stimulus("100 ms", "HLI.FEED_HOLD", 0.0)]
    run = run_of(f"Z[INDP_SYN {TO_10}]", at=hold, signals=["Z.ACS.ACT_POS"])
    assert run.trace is not None
    places = run.trace["Z.ACS.ACT_POS"]
    assert places[80] == places[99] == pytest.approx(5.0)
    # 5 mm from rest to rest: 75 ticks from tick 100 on.
    assert axes(run)[-1] == "174 axis Z done"


def test_a_reset_brakes_the_axis_and_gives_the_motion_up() -> None:
    """RC-007: 25 ticks from 100 mm/s."""
    run = perform(f"Z[INDP_SYN {TO_10}]\nX5\nM30", at=[Stimulus("50 ms", "HLI.RESET", 1.0)])
    assert axes(run)[1:] == ["50 axis Z aborted", "74 axis Z stopped"]


def test_the_end_of_the_program_does_not_wait() -> None:
    """RC-006: the run does."""
    run = run_of(f"Z[INDP_ASYN {TO_10}]")
    assert end(run) == 0
    assert axes(run)[-1] == "124 axis Z done"


# --- SA-8: backward motion, block search ----------------------------------------------------------


def test_nothing_is_walked_back_before_an_independent_motion() -> None:
    """It cannot be executed backwards, as others of the controller; X stays at 20."""
    back = [Stimulus("500 ms", "HLI.BACKWARD_MOTION", 1.0)]
    lines = ("G01 X10 F6000", "X[INDP_SYN G90 G00 POS=20]", "X30 F600", "M30")
    run = Controller().run(
        NcText("p.nc", "\n".join(lines)), signals=["X.ACS.ACT_POS"], at=back, ticks=3000
    )
    assert run.trace is not None
    assert run.trace["X.ACS.ACT_POS"][-1] == 20.0


def test_block_search_counts_independent_motions_among_the_positions() -> None:
    """The state at the block is that of a whole run: Z is sent to 10 on the straight way."""
    lines = ("G00 X5", f"Z[INDP_ASYN {TO_10}]", "X20", '#MSG ["%f %f", V.A.ABS.X, V.A.ABS.Z]')
    assert texts(run_of(*lines, from_line=4)) == texts(run_of(*lines)) == ["20.000000 10.000000"]


# --- SA-9: the path stops before the block --------------------------------------------------------


def test_the_path_stops_where_an_independent_motion_begins() -> None:
    """As page 208621195 says for OSC: two blocks of 5 mm take 75 ticks each, not 125 together."""
    run = run_of("G01 X5 F6000", f"Z[INDP_ASYN {TO_10}] X10")
    assert axes(run)[0] == "75 axis Z begun 10"
    assert end(run) == 150


# --- SA-10: what is refused -----------------------------------------------------------------------


@pytest.mark.parametrize(
    ("lines", "number"),
    [
        ("Z[INDP_ASYN G90 G01 FEED=1000]", 21068),
        ("Z[INDP_ASYN G00 POS=1]", 21068),
        ("Z[INDP_ASYN G90 G91 POS=1]", 21068),
        ("Z[INDP_ASYN G90 G00 G01 FEED=1 POS=1]", 21068),
        ("Z[INDP_ASYN G90 G01 POS=1]", 21068),
        ("Z[INDP_ASYN G90 G00 FEED=1 POS=1]", 21068),
        ("Z[INDP_ASYN G90 FEED=1 TIME=1 POS=1]", 21068),
        ("Z[INDP_ASYN G90 G03 POS=1]", 21068),
        ("Z[INDP_ASYN G90 POS=1 FOO=1]", 21068),
        ("Z[INDP_ASYN G90 POS=1 INCL_OFFSETS=1]", 21068),
        ("Z[INDP_ASYN G90 POS=1 5]", 21068),
        ("Z[G90 INDP_ASYN POS=1]", 21301),
        ("Z[INDP_ASYN=1 G90 POS=1]", 21301),
        ("Z[INDP_ASYN G90 POS=1 POS=2]", 21373),
        ("Z[INDP_ASYN G90 FEED=0 POS=1]", 21375),
        ("Z[INDP_ASYN G90 TIME=0 POS=1]", 21375),
        ("Z[INDP_ASYN G90 FEED_MAX_WEIGHT=101 POS=1]", 21375),
        ("P1 = -1\nZ[INDP_ASYN G90 FEED=P1 POS=1]", 21375),
        ("Z[INDP_ASYN G90 POS]", 900208),
        ("Z[INDP_ASYN G90 POS=1 SLOPE_TYPE=STEP]", 900200),
        ("Z[INDP_ASYN G90 POS=1] Z1", 21072),
        ("G02 X5 I2.5 F100 Y[INDP_ASYN G90 POS=1]", 21072),
        ("Z[INDP_ASYN G90 POS=20000]", 60158),
        ("Z[INDP_ASYN G91 POS=-20000]", 60159),
        ("G99 Z5\nZ[INDP_ASYN G90 POS=6]", 60158),
        ("G41 D1 G01 X10 F500\nZ[INDP_ASYN G90 POS=3]\nX20", 20651),
        ("S[INDP_ASYN G90 POS=3]", 21035),
        ("#RT CYCLE [ID=1 SCOPE=PROG]\nZ[INDP_ASYN G90 POS=3]\n#RT CYCLE END", 22002),
    ],
)
def test_wrong_forms_have_the_numbers_of_the_controller(lines: str, number: int) -> None:
    """Diagnosis pages 253356939 (21068) and 254122891 (21301), errors of independent axes."""
    assert numbers(perform(f"{lines}\nM30"))[-1:] == [number]
