# SPDX-License-Identifier: MIT
"""Decisions on the end of a run after an error: what it still waits for."""

from __future__ import annotations

from support.decided import numbers, perform, reported


def test_the_other_cycles_have_a_tick_after_an_error_with_the_path_at_rest() -> None:
    """RC-505, RC-402: the others run from the next tick on; what they start comes to its end.

    The error of tick 3 finds the path standing. In tick 4 the cycle, which counts to 5 there, moves
    Z by 1 mm: 31.6 ms from rest to rest at 4000 mm/s², 32 ticks, of which tick 35 is the last.
    """
    reacting = """
#RT CYCLE [ID=2 SCOPE=PROG]
V.E.COUNT += 1
$IF ONCE V.E.COUNT == 5
Z[INDP G91 G00 POS=1]
$ENDIF
#RT CYCLE END
"""
    run = perform(f"{reacting}#TIME 0.003\n#RT CYCLE HOLD [ID=9]\nM30")
    assert reported(run, "error", "axis") == [
        "3 error 50858",
        "4 axis Z begun 1",
        "35 axis Z done",
    ]
    assert (run.state, run.ticks) == ("error", 36)


def test_a_quiet_machine_ends_the_run_in_the_tick_after_the_error() -> None:
    """RC-505: an axis without an end is no reason to go on, nor are spindles that turn."""
    moving = "#RT CYCLE [ID=2 SCOPE=PROG]\n$IF ONCE V.RTG.CYCLES.DIAG_LEVEL > 0\n"
    moving += "Z[INDP DIR=POS FEED=600]\nM3 S100\n$ENDIF\n#RT CYCLE END\n"
    run = perform(f"{moving}#TIME 0.003\n#RT CYCLE HOLD [ID=9]\nM30")
    assert (run.state, run.ticks) == ("error", 5)


def test_a_spindle_that_comes_to_its_position_is_waited_for() -> None:
    """RC-006: as after a program, the run continues until motions that have an end are at rest."""
    turning = "#RT CYCLE [ID=2 SCOPE=PROG]\n$IF ONCE V.RTG.CYCLES.DIAG_LEVEL > 0\n"
    turning += "M3 M19 S60 S.POS=90\n$ENDIF\n#RT CYCLE END\n"
    run = perform(f"{turning}#TIME 0.003\n#RT CYCLE HOLD [ID=9]\nM30")
    assert run.state == "error"
    assert run.ticks == perform(f"{turning}#TIME 0.003\nM30").ticks > 250


def test_after_counts_after_an_error_too() -> None:
    """The machine goes on for ``--after`` after the tick that the cycles have had."""
    run = perform("#RT CYCLE HOLD [ID=9]\nM30", after="5 ms")
    assert (run.state, run.ticks, numbers(run)) == ("error", 7, [50858])


def test_motions_that_never_rest_are_waited_for_a_minute_at_most() -> None:
    """A cycle that moves an axis to and fro after the error ends the run after 60 s."""
    shuttle = """
#RT CYCLE [ID=2 SCOPE=PROG]
$IF EDGE V.RTA.ACS.ACT_POS.Z <= 0
Z[INDP G90 G00 POS=400]
$ENDIF
$IF EDGE V.RTA.ACS.ACT_POS.Z >= 390
Z[INDP G90 G00 POS=-10]
$ENDIF
#RT CYCLE END
"""
    run = perform(f"{shuttle}#RT CYCLE HOLD [ID=9]\nM30", memory_trace=False)
    assert (run.state, run.ticks) == ("error", 60_002)
