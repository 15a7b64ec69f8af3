# SPDX-License-Identifier: MIT
"""The operator's side: START, RESET, single block, feed hold, override (MO-6, RC-002, RC-007)."""

from __future__ import annotations

import pytest
from support.kernel_rig import DEMO, RAPID, Rig, assert_within_limits

from nctakt.base.failure import Failure
from nctakt.kernel import cells
from nctakt.run.access.stimuli import Stimulus
from nctakt.run.controller import Controller, NcText
from nctakt.run.plcs.plc_view import PlcView

MOVES = NcText("p.nc", "N10 G00 X10\nN20 G00 X20\nM30")


def test_single_block_stops_at_the_end_of_a_block_that_others_pass() -> None:
    """A block end at 100 mm/s becomes a stop, bit for bit at its end; START continues (MO-6)."""
    rig = Rig()
    panel = rig.channel.panel
    panel.begin_program()
    panel.put(cells.PANEL_SINGLE_BLOCK, 1.0)
    rig.segment(10.0, speed=100.0, end_speed=100.0, exact_stop=False)
    rig.segment(10.0, speed=100.0)
    rig.run(200)
    assert panel.is_paused
    assert rig.x[-1] == rig.x[-50] == 10.0
    panel.put(cells.PANEL_START, 1.0)
    rig.run(200)
    assert not panel.is_paused
    assert rig.x[-1] == 20.0
    assert_within_limits(rig.x, 100.0)


def test_single_block_that_comes_too_late_stops_at_the_next_end() -> None:
    """At 400 mm/s 20 mm are needed to stop: with 5 left the block after this one stops."""
    rig = Rig()
    panel = rig.channel.panel
    panel.begin_program()
    rig.segment(60.0, speed=400.0, end_speed=400.0, exact_stop=False)
    rig.segment(60.0, speed=400.0, end_speed=400.0, exact_stop=False)
    rig.segment(60.0, speed=400.0)
    while rig.x[-1:] < [55.0]:
        rig.run(1)
    panel.put(cells.PANEL_SINGLE_BLOCK, 1.0)
    rig.run(500)
    assert panel.is_paused
    assert rig.x[-1] == 120.0
    assert_within_limits(rig.x, RAPID)


def test_single_block_switched_off_in_time_passes_the_end() -> None:
    """Off again before the block has braked: it passes its end with its speed."""
    rig = Rig()
    panel = rig.channel.panel
    panel.begin_program()
    panel.put(cells.PANEL_SINGLE_BLOCK, 1.0)
    rig.segment(60.0, speed=100.0, end_speed=100.0, exact_stop=False)
    rig.segment(60.0, speed=100.0)
    rig.run(300)
    panel.put(cells.PANEL_SINGLE_BLOCK, 0.0)
    ticks = 300 + rig.run_to_the_end()
    assert not panel.is_paused
    assert rig.x[-1] == 120.0
    assert_within_limits(rig.x, 100.0)
    assert ticks == 1225  # 25 ms up, 117.5 mm at 100 mm/s, 25 ms down


def test_a_loop_over_one_block_stops_each_time() -> None:
    """A line that moves again is another block."""
    text = "G91\n$FOR P1 = 1, 3, 1\nX1\n$ENDFOR\nM30"
    run = Controller(DEMO).run(
        NcText("p.nc", text),
        set={"HLI.SINGLE_BLOCK": 1.0},
        at=[Stimulus(time, "HLI.START", 1.0) for time in ("100 ms", "200 ms")],
    )
    assert [str(event) for event in run.events if event.kind == "paused"] == [
        "paused line 3",
        "paused line 3",
    ]


def test_a_reset_of_the_operator_ends_a_run() -> None:
    """The run says so; further programs are not begun; the path has braked (RC-007)."""
    controller = Controller(DEMO)
    run = controller.run(MOVES, MOVES, at=[Stimulus("50 ms", "HLI.RESET", 1.0)])
    assert run.state == "reset"
    assert run.errors == ()
    assert run.ticks == 100
    assert controller.read("V.RTA.ACS.ACT_POS.X") == pytest.approx(10.0)
    assert (controller.state, controller.hli.state) == ("ready", "reset")
    assert controller.run(MOVES).state == "ended"


def test_start_runs_the_selected_programs_one_after_the_other() -> None:
    """Each program of a run waits for its own START; a START while one runs is dropped."""
    controller = Controller(DEMO)
    run = controller.run(
        MOVES,
        NcText("q.nc", "G00 X0\nM30"),
        wait_for_start=True,
        at=[Stimulus(time, "HLI.START", 1.0) for time in (0, "100 ms", "300 ms")],
    )
    assert run.state == "ended"
    ends = [(event.tick, event.text) for event in run.events if event.kind == "end"]
    assert ends == [(201, "p.nc"), (301 + 142, "q.nc")]


def test_nobody_presses_start_and_nothing_begins() -> None:
    """The run ends at its limit; the channel is ready, the lamp has shown that it waits."""
    controller = Controller(DEMO)
    run = controller.run(MOVES, wait_for_start=True, ticks=50, signals=["HLI.ARMED", "HLI.STATE"])
    assert run.state == "limit"
    assert run.trace is not None
    assert run.trace["HLI.ARMED"].tolist() == [1.0] * 50
    assert run.trace["HLI.STATE"].tolist() == [0.0] * 50
    assert not controller.hli.is_armed


class Recovery:
    """A PLC that answers an error with RESET, and sets what the program lacked."""

    def __init__(self) -> None:
        self.seen: list[tuple[int, str, int]] = []

    def cycle(self, hli: PlcView) -> None:
        """Press START when a program waits, RESET when the channel is in error."""
        if not self.seen or self.seen[-1][1:] != (hli.state, hli.error):
            self.seen.append((hli.tick, hli.state, hli.error))
        if hli.is_armed:
            hli.start()
        elif hli.state == "error":
            hli.write("V.E.VALUE", 2.0)
            hli.reset()


def test_a_plc_resets_an_error_and_starts_again() -> None:
    """Error, RESET, START: the program runs anew, with the value that the PLC has set."""
    text = "#RT CYCLE\n$IF ONCE V.E.VALUE == 1\nV.E.COUNT = 1 / [V.E.VALUE - 1]\n$ENDIF\n"
    text += "#RT CYCLE END\nG00 X1\nM30"
    plc = Recovery()
    controller = Controller(DEMO)
    run = controller.run(NcText("p.nc", text), plc=plc, wait_for_start=True, set={"V.E.VALUE": 1.0})
    assert run.state == "ended"
    (error,) = run.errors
    assert plc.seen == [
        (0, "ready", 0),  # START: the next tick latches it
        (2, "error", error.id),
        (3, "reset", 0),
        (4, "ready", 0),
        (6, "running", 0),
    ]


def test_the_panel_by_name() -> None:
    """``HLI.`` values are read and written like variables; lamps and unknown ones are refused."""
    controller = Controller(DEMO)
    controller.write("HLI.OVERRIDE", 40)
    assert controller.read("HLI.OVERRIDE") == 40.0
    controller.step(1)
    assert controller.read("hli.override") == 40.0
    assert controller.read("V.RTG.OVERRIDE.VEL.TOTAL") == 40.0
    for name, value, number in (
        ("HLI.STATE", 1.0, 900542),
        ("HLI.OVERIDE", 1.0, 900541),
        ("HLI.OVERRIDE", -1.0, 20847),
        ("HLI.FEED_HOLD", 2.0, None),
        ("HLI.OVERRIDE", "fast", 900543),
        ("HLI.OVERRIDE", float("nan"), 50893),
    ):
        if number is None:
            controller.write(name, value)
            assert controller.read(name) is True
            continue
        with pytest.raises(Failure) as caught:
            controller.write(name, value)
        assert caught.value.diagnostics[0].id == number


def test_tick_by_tick_with_start_and_reset() -> None:
    """``select``, ``hli.start`` and ``hli.reset`` on a controller that is stepped."""
    controller = Controller(DEMO)
    controller.select(MOVES)
    controller.step(10)
    assert (controller.hli.is_armed, controller.state) == (True, "ready")
    controller.hli.start()
    controller.step(1)
    assert (controller.hli.is_armed, controller.state) == (False, "running")
    controller.step(50)
    assert controller.read("V.RTA.ACS.ACT_POS.X") == pytest.approx(5.0)
    controller.hli.reset()
    controller.step(60)
    assert controller.state == "ready"
    assert controller.read("V.RTA.ACS.ACT_POS.X") == pytest.approx(10.0)


def test_an_array_as_a_whole_is_refused_with_its_first_element() -> None:
    """Only single values are written; the nearest name is not another variable (900541)."""
    with pytest.raises(Failure) as raised:
        Controller(DEMO).write("V.E.LIST", 3)
    assert raised.value.diagnostics[0].id == 900541
    assert "V.E.LIST[0]" in raised.value.diagnostics[0].remedy("en")
