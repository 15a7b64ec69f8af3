# SPDX-License-Identifier: MIT
"""What one controller keeps from run to run, and how long a run lasts (RC-001, RC-006, RC-309)."""

from __future__ import annotations

from nctakt.run.controller import Controller, NcText

GLOBAL = "#RT CYCLE [ID = 1 SCOPE = GLOBAL]\nV.CH.Total += 1\n#RT CYCLE END\n#TIME 0.002\nM30"


def test_ticks_count_on_and_channel_variables_live_until_the_restart() -> None:
    """RC-001, RC-107, RC-309: tick n belongs to the controller, not to the run."""
    controller = Controller()
    first = controller.run(NcText("first.nc", GLOBAL))
    assert (first.first_tick, first.ticks) == (0, 3)
    second = controller.run(NcText("second.nc", "#TIME 0.002\nM30"), signals=["V.CH.Total"])
    assert (second.first_tick, second.ticks) == (3, 3)
    assert [f"{event.tick} {event}" for event in second.events] == [
        "3 written V.CH.Total 4",
        "4 written V.CH.Total 5",
        "5 end second.nc",
        "5 written V.CH.Total 6",
    ]
    assert second.trace is not None
    assert list(second.trace["V.CH.Total"]) == [4, 5, 6]
    assert Controller().read("V.CH.Total") == 0


def test_a_run_ends_with_its_motions_and_lasts_as_long_as_asked_for() -> None:
    """RC-006: the last tick is that of M30, or this many ticks after it."""
    text = NcText("move.nc", "G00 X0.1\nM30")
    assert Controller().run(text).ticks == 11
    assert Controller().run(text, after="5 ms").ticks == 16
    assert Controller().run(text, after="4.001 ms").ticks == 16


def test_a_run_that_is_reset_goes_on_for_as_long_as_asked_for() -> None:
    """RC-007, RC-107: ``after`` counts after a reset as well; GLOBAL cycles run in it.

    The reset is latched in tick 5; in it no cycle runs. Five ticks follow.
    """
    text = NcText("reset.nc", GLOBAL.replace("0.002", "1"))
    for after, ticks, count in (("0 ms", 6, 5), ("5 ms", 11, 10)):
        controller = Controller()
        run = controller.run(text, at=[("5 ms", "HLI.RESET", 1)], after=after)
        assert (run.state, run.ticks) == ("reset", ticks)
        assert controller.read("V.CH.Total") == count
