# SPDX-License-Identifier: MIT
"""Programs that have once broken a limit, found by random ones and cut down (MO-1)."""

from __future__ import annotations

import pytest
from support.motion_checks import assert_smooth, blocks, positions, run_of

from nctakt.run.access.stimuli import Stimulus


def test_a_corner_takes_of_each_axis_of_an_arc_what_it_uses_of_it() -> None:
    """MO-1: what Y lends to the corner may be more than all that Z can do, and concerns Y only.

    The arc's jerk was not reduced at all then: 1.21 of the limit.
    """
    text = """#SLOPE [TYPE=TRAPEZ]
    N10 G19 G00 Y-10.942750230 Z1.274826402
    N20 G01 Y-8.008180599 Z-42.243683190 F6000
    #OVERRIDE [FEED_FACT=30]
    N30 G03 Y36.988727314 Z-180.740727910 J2874.848778326 K857.463994437
    M30"""
    assert_smooth(3, run_of(3, text))


@pytest.mark.parametrize("switch", ["HLI.SINGLE_BLOCK", "HLI.FEED_HOLD"])
def test_a_stop_that_is_taken_back_while_the_path_brakes_for_it(switch: str) -> None:
    """MO-1, MO-6: braking to a standstill takes less way than braking to a slow corner after it.

    Single block was to stop the path at the end of N20; switched off, the corner was passed faster
    than it may. Now the path stops there and continues.
    """
    text = """#SLOPE [TYPE=TRAPEZ]
    N10 G01 X3.006 Y-0.051 F40000
    N20 X7.364 Y-0.045
    N30 X8.292 Y-0.046 Z0.111
    M30"""
    for on in range(40, 140, 20):
        for off in range(on + 12, on + 60, 10):
            stimuli = [
                Stimulus(f"{on} ms", switch, 1.0),
                Stimulus(f"{off} ms", switch, 0.0),
                Stimulus("600 ms", "HLI.START", 1.0),
            ]
            assert_smooth(0, run_of(0, text, stimuli))


@pytest.mark.parametrize(("feed", "braking"), [(5500, 196), (6000, 180), (9000, 120), (9000, 136)])
def test_single_block_that_was_taken_back_long_ago_does_not_count(feed: int, braking: int) -> None:
    """MO-1: switched on and off in N10, it is over when the path brakes for the bend after N10.

    The override changes the limit in every tick then. Rounding had it that the path came 2e-8 mm
    too far; so it was to stand before the bend after all, for which there was no room, and came
    onto the bend braking, with 1.006 of the jerk.
    """
    text = f"""#SLOPE [TYPE=TRAPEZ]
    #CONTOUR MODE [DEV PATH_DEV=0.1]
    G261
    N10 G01 X20 F{feed}
    N20 X38 Y4.5
    M30"""
    stimuli = [
        Stimulus("30 ms", "HLI.SINGLE_BLOCK", 1.0),
        Stimulus("35 ms", "HLI.SINGLE_BLOCK", 0.0),
        *(Stimulus(f"{braking + i} ms", "HLI.OVERRIDE", 100.0 - i % 9) for i in range(60)),
        Stimulus("600 ms", "HLI.OVERRIDE", 100.0),
    ]
    assert_smooth(0, run_of(0, text, stimuli))


@pytest.mark.parametrize("every", [2, 5])
def test_a_hold_while_single_block_stops_the_path_before_a_bend(every: int) -> None:
    """MO-1, MO-6: held again and again while it brakes for the end of N10, the path stops there.

    Rounding had it that the stop came 1e-14 mm too late; the path was to come to the bend with a
    lesser speed, and the one whose way is as long was far too high: 2.2 of the jerk.
    """
    text = """#SLOPE [TYPE=TRAPEZ]
    #CONTOUR MODE [DEV PATH_DEV=0.05]
    G261
    N10 G01 X6 F9000
    N20 X9 Y3
    M30"""
    for hold in range(66, 90, 4):
        stimuli = [Stimulus("10 ms", "HLI.SINGLE_BLOCK", 1.0)]
        for tick in range(hold, hold + 60, 2 * every):
            stimuli.append(Stimulus(f"{tick} ms", "HLI.FEED_HOLD", 1.0))
            stimuli.append(Stimulus(f"{tick + every} ms", "HLI.FEED_HOLD", 0.0))
        stimuli.append(Stimulus("600 ms", "HLI.SINGLE_BLOCK", 0.0))
        stimuli.append(Stimulus("600 ms", "HLI.START", 1.0))
        assert_smooth(0, run_of(0, text, stimuli))


def test_the_block_of_a_tick_is_the_one_in_which_it_ends() -> None:
    """MO-7: backward as forward, and where the path turns at a border between two blocks."""
    text = "N10 G01 X10 F6000\nN20 X20\nM30"
    for back in (113, 150, 170):
        stimuli = [
            Stimulus(f"{back} ms", "HLI.BACKWARD_MOTION", 1.0),
            Stimulus(f"{back + 110} ms", "HLI.BACKWARD_MOTION", 0.0),
        ]
        run = run_of(0, text, stimuli)
        x, number = positions(run)[:, 0], blocks(run)
        assert (number[x < 10.0] == 10).all()
        assert (number[x > 10.0] == 20).all()


def test_a_turn_beside_what_rounding_leaves_of_a_linear_way() -> None:
    """MO-1, MO-4: 4.5e-10 mm are no way; A keeps its limits, which it broke 7.7 times over."""
    text = """#SLOPE [TYPE=TRAPEZ]
    N10 G00 X143.462210424 Y165.520230114 A16.672991674
    N20 X143.462210415 A9.760338500
    N30 G01 X143.462210424 A16 F6000
    M30"""
    for number in range(4):
        assert_smooth(number, run_of(number, text))


def test_held_at_an_end_of_an_arc_the_axes_stay_there_bit_by_bit() -> None:
    """MO-1, MO-7: walked back to the end of N10 and held, X and Y are what N10 has programmed."""
    text = """N10 G60 G03 X0.093921770 Y-0.098728620 I0.004356384 J-0.089894504 F6000
    N20 G01 X5
    M30"""
    stimuli = [
        Stimulus("50 ms", "HLI.BACKWARD_MOTION", 1.0),
        Stimulus("100 ms", "HLI.SINGLE_BLOCK", 1.0),
        Stimulus("300 ms", "HLI.FEED_HOLD", 1.0),
        Stimulus("310 ms", "HLI.START", 1.0),
        Stimulus("500 ms", "HLI.BACKWARD_MOTION", 0.0),
        Stimulus("500 ms", "HLI.SINGLE_BLOCK", 0.0),
        Stimulus("500 ms", "HLI.FEED_HOLD", 0.0),
    ]
    places = positions(run_of(0, text, stimuli))
    assert (places[300:499, 0] == 0.093921770).all()
    assert (places[300:499, 1] == -0.098728620).all()
