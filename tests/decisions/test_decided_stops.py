# SPDX-License-Identifier: MIT
"""Decisions on M00 and M01: the program waits for START (facts 2.6, MO-6)."""

from __future__ import annotations

from support.decided import perform, reported

from nctakt.run.access.stimuli import Stimulus
from nctakt.run.controller import Controller


def test_m00_waits_after_the_functions_of_its_block() -> None:
    """A function that goes out after the motion (MNS_SNS) does so before the program stops."""
    run = perform("N10 M00 M113 G00 X1\nM30", ticks=200)
    assert reported(run) == ["32 output M 113", "33 paused line 1"]
    assert run.state == "limit"


def test_m00_stops_a_path_that_others_pass_with_speed() -> None:
    """Rounding on: the path is at X10 exactly, and goes on from there (MO-1)."""
    start = Stimulus("500 ms", "HLI.START", 1.0)
    program = "G261\n#CONTOUR MODE [DEV PATH_DEV=1]\nG01 F6000 X10\nM01\nX10 Y10\nM30"
    controller = Controller()
    controller.hli.optional_stop = True
    assert controller.hli.optional_stop
    run = perform(program, controller, at=[start], signals=["X.ACS.ACT_POS", "Y.ACS.ACT_POS"])
    assert run.state == "ended"
    assert run.trace is not None
    assert run.trace["X.ACS.ACT_POS"][499] == 10.0
    assert run.trace["Y.ACS.ACT_POS"][499] == 0.0
    assert reported(run, "paused", "end")[1].startswith("6")


def test_a_reset_gives_up_a_program_that_m00_has_stopped() -> None:
    """RESET is taken while the program waits; a START after it finds nothing (RC-007)."""
    stimuli = [Stimulus("10 ms", "HLI.RESET", 1.0), Stimulus("20 ms", "HLI.START", 1.0)]
    controller = Controller()
    run = perform("M00\nG00 X10\nM30", controller, at=stimuli)
    assert reported(run) == ["0 paused line 1"]
    assert controller.read("V.RTA.ACS.ACT_POS.X") == 0.0
    assert not controller.hli.is_paused


def test_m00_and_the_end_of_the_program_in_one_block() -> None:
    """The stop comes first, whatever the order of the words."""
    run = perform("M30 M00", at=[Stimulus("5 ms", "HLI.START", 1.0)])
    assert reported(run) == ["0 paused line 1", "5 end part.nc"]
