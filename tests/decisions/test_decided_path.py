# SPDX-License-Identifier: MIT
"""Decisions on the path: feed, units, limits, what an error leaves."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from support.decided import left, numbers, perform
from support.insides import machine_of

import nctakt
from nctakt.run.controller import Controller, NcText
from nctakt.run.plcs.plc_view import PlcView

DEMO = Path(nctakt.__file__).parent / "machines" / "demo"


def ticks_of(program: str) -> int:
    """Ticks that a program takes before its end."""
    run = perform(program)
    assert run.state == "ended", run.diagnostics
    return run.ticks - 1


def test_the_feed_goes_along_the_linear_axes() -> None:
    """MO-4: X3 Y4 is 5 mm at 5 mm/s, A turns along with it; alone, A is fed in degrees.

    Each axis accelerates with 4000 mm/s² at most: on this diagonal that is 5000 mm/s², and the
    motion takes 1001 ms, 1001.25 ms for one axis.
    """
    assert ticks_of("G01 X3 Y4 F300\nM30") == 1001
    assert ticks_of("G01 X3 Y4 A1 F300\nM30") == 1001
    assert ticks_of("G01 X5 F300\nM30") == 1002
    assert ticks_of("G01 A5 F300\nM30") == 1002


def test_feed_is_in_inches_under_g70() -> None:
    """F10 under G70 is 254 mm/min, positions are inches, whatever P-CHAN-00108 says of F."""
    assert ticks_of("G70\nG01 X1 F10\nM30") == ticks_of("G01 X25.4 F254\nM30")
    assert left("G70\nG01 X2 F10000\nM30", "V.RTA.ACS.ACT_POS.X") == 50.8


def test_a_feed_block_needs_a_feed() -> None:
    """MO-17: none before a motion is 20008; what was prepared before it is finished."""
    controller = Controller()
    run = perform("G00 X1\nG93 G01 X2\nM30", controller)
    assert numbers(run) == [20008]
    assert controller.read("V.RTA.ACS.ACT_POS.X") == 1.0


@pytest.mark.parametrize("words", ["F0", "F-1", "FP1", "G93 F0", "G95 M3 S100 F0", "G70 F0"])
def test_a_feed_is_above_0_when_it_is_programmed(words: str) -> None:
    """20176, whether a motion needs it or not."""
    assert numbers(perform(f"P1 = 0\nG00 X1\n{words}\nM30")) == [20176]


def test_more_feed_than_the_axes_can_do_is_limited() -> None:
    """MO-17: F beyond the axes' speed is no error."""
    assert ticks_of("G01 X100 F999999\nM30") == ticks_of("G00 X100\nM30")


def test_g00_ends_with_an_exact_stop_where_the_channel_says_so() -> None:
    """P-CHAN-00235 is 1: two G00 of 1 mm in one line take twice 32 ticks, one of 2 mm takes 45."""
    assert ticks_of("G00 X1\nG00 X2\nM30") == 64
    assert ticks_of("G00 X2\nM30") == 45


def test_commands_keep_the_software_limits_whatever_their_tolerance(tmp_path: Path) -> None:
    """P-AXIS-00179 of 1 mm: X begins 0.5 mm beyond its limit in silence, and goes to 0.5 … 20."""
    machine = tmp_path / "machine"
    shutil.copytree(DEMO, machine)
    file = machine / "achs_mds1.lis"
    limits = "kenngr.swe_neg 5000\nkenngr.swe_pos 200000\nkenngr.swe_toleranz 10000\n"
    file.write_text(limits + file.read_text("utf-8"), "utf-8")
    controller = Controller(machine)
    assert not controller.diagnostics
    assert numbers(perform("G00 X20\nX0.5\nM30", controller)) == []
    assert numbers(perform("G00 X20.001\nM30", Controller(machine))) == [120002]
    assert numbers(perform("G00 X0.4\nM30", Controller(machine))) == [120003]


def test_a_modulo_axis_shows_positions_in_its_range() -> None:
    """A725 turns twice and 5° (2014 + 90 ticks at 360 °/s), and shows 5°; A-5 shows 355°."""
    assert left("G00 A725\nM30", "V.RTA.ACS.ACT_POS.A") == 5.0
    assert left("G00 A-5\nM30", "V.RTA.ACS.ACT_POS.A") == 355.0
    assert ticks_of("G00 A725\nM30") == 2104


def test_a_target_beyond_a_software_limit_gives_the_program_up() -> None:
    """120002 when the block is decoded; the axis stays where the block before has put it."""
    controller = Controller()
    run = perform("G00 X2\nG91\nG00 X9999\nM30", controller)
    assert (run.state, numbers(run)) == ("error", [120002])
    assert controller.read("V.RTA.ACS.ACT_POS.X") == 2.0
    assert left("G00 X10000\nM30", "V.RTA.ACS.ACT_POS.X") == 10000.0


def test_the_speed_of_a_row_is_that_at_the_end_of_its_tick() -> None:
    """PATH.SPEED after the first tick of a motion is 4 mm/s: 4000 mm/s² for a millisecond."""
    run = perform("G00 X100\nM30", signals=["PATH.SPEED"])
    assert run.trace is not None
    assert run.trace.at(0, "PATH.SPEED") == pytest.approx(4.0)
    assert run.trace.at(324, "PATH.SPEED") == 0.0


class _Operator:
    """Sets the operator's override, and holds the feed, at ticks."""

    def __init__(self, **at: tuple[int, float]) -> None:
        self.at = at

    def cycle(self, hli: PlcView) -> None:
        hli.acknowledge_all()
        if "override" in self.at and hli.tick == self.at["override"][0]:
            hli.override_pct = self.at["override"][1]
        if "hold" in self.at:
            hli.feed_hold = self.at["hold"][0] <= hli.tick < self.at["hold"][1]


def test_the_override_is_a_product_with_a_bound() -> None:
    """RC-305: operator times CYCLE, not above P-CHAN-00056 (100 % here); TOTAL is what acted."""
    cycle = "#RT CYCLE [SCOPE=PROG]\nV.RTG.OVERRIDE.VEL.CYCLE = 50\n#RT CYCLE END\n"
    names = ["OVERRIDE.VEL.TOTAL"]
    halved = perform(cycle + "G00 X10\nM30", plc=_Operator(override=(2, 50.0)), signals=names)
    bound = perform("G00 X10\nM30", plc=_Operator(override=(2, 250.0)), signals=names)
    assert halved.trace is not None
    assert bound.trace is not None
    assert [halved.trace.at(tick, names[0]) for tick in (2, 3)] == [50.0, 25.0]
    assert bound.trace.at(3, names[0]) == 100.0


def test_feed_hold_stops_on_the_path_and_goes_on() -> None:
    """MO-6: held at 400 mm/s X is after 100 ticks, 20 mm on; then the way is finished."""
    run = perform(
        "G00 X300\nM30", plc=_Operator(hold=(99, 300.0)), signals=["X.ACS.ACT_POS", "PATH.SPEED"]
    )
    assert run.state == "ended"
    assert run.trace is not None
    assert run.trace.at(99, "X.ACS.ACT_POS") == pytest.approx(20.0)
    assert run.trace.at(199, "X.ACS.ACT_POS") == pytest.approx(40.0)
    assert run.trace.at(300, "PATH.SPEED") == 0.0
    assert run.trace["X.ACS.ACT_POS"].max() == 300.0


def test_after_an_error_nothing_is_taken_until_a_reset() -> None:
    """RC-505: a dwell does not go on, the run ends a tick after the error; a program resets."""
    controller = Controller()
    run = perform("#RT CYCLE START [ID=9]\n#TIME 5\nM30", controller)
    assert (run.state, run.ticks, controller.state) == ("error", 2, "error")
    controller.start(NcText("next.nc", "#TIME 0.001\nM30"))
    controller.step(3)
    assert controller.state == "ready"


def test_a_skipped_block_runs() -> None:
    """Skip levels are off: ``/`` and ``/3`` before a block have no effect."""
    assert left("/ G00 X1\n/3 G91 X1\nM30", "V.RTA.ACS.ACT_POS.X") == 2.0


def test_a_dwell_is_in_seconds_however_it_is_written() -> None:
    """``G04 X0.003``, ``G04 0.003`` and ``#TIME 0.003`` are three ticks; −1 is 20017."""
    for dwell in ("G04 X0.003", "G04 0.003", "#TIME 0.003"):
        assert ticks_of(f"{dwell}\nM30") == 3, dwell
    assert numbers(perform("#TIME -1\nM30")) == [20017]


def test_the_path_never_jumps() -> None:
    """RC-409: a segment that does not start where the axes are is 900420, and nothing moves."""
    controller = Controller()
    controller.start(NcText("part.nc", "#TIME 0.01\nG00 X1\nM30"))
    controller.step(2)
    machine_of(controller).axes.set_position(0, 7.0)
    controller.step(20)
    assert (controller.state, controller.read("V.RTA.ACS.ACT_POS.X")) == ("error", 7.0)
    assert [found.message.id for found in controller.diagnostics] == [900420]
