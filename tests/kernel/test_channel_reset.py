# SPDX-License-Identifier: MIT
"""Reset of a channel (RC-007), and what of it a trace shows."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.insides import machine_of
from support.kernel_rig import ACCELERATION, DEMO

from nctakt.results.trace.sinks import CsvSink
from nctakt.run.controller import Controller, NcText
from nctakt.run.plcs.plc_view import PlcView

CYCLES = """#RT CYCLE [ID=1 SCOPE=GLOBAL]
  $IF ONCE TRUE
    V.E.COUNT_POS += 1
  $ENDIF
  V.E.COUNT += 1
#RT CYCLE END
#RT CYCLE [ID=2 SCOPE=PROG]
  V.E.COUNT_NEG += 1
#RT CYCLE END
"""


def started(text: str, ticks: int) -> Controller:
    """A controller in the midst of a program."""
    controller = Controller(DEMO)
    controller.start(NcText("p.nc", text))
    controller.step(ticks)
    return controller


def test_a_reset_brakes_and_gives_the_program_up() -> None:
    """From 400 mm/s the path is at rest after 100 ticks, 20 mm on; then the channel is ready."""
    controller = started(CYCLES + "G00 X300\nG00 X0\nM30", 100)
    before = float(controller.read("V.RTA.ACS.ACT_POS.X"))
    assert before == pytest.approx(20.0)
    controller.reset()
    assert controller.tick == 200
    assert controller.state == "ready"
    stood = controller.read("V.RTA.ACS.ACT_POS.X")
    assert stood == pytest.approx(before + 400.0**2 / (2 * ACCELERATION))
    assert controller.read("V.RTA.ACS.CMD_POS.X") == stood
    controller.step(50)
    assert controller.read("V.RTA.ACS.ACT_POS.X") == stood


def test_in_a_reset_no_cycle_runs_and_global_ones_keep_their_states() -> None:
    """PROG cycles are gone, GLOBAL ones continue with the same $IF states after the reset."""
    controller = started(CYCLES + "G00 X300\nM30", 100)
    controller.reset()
    names = ("V.E.COUNT", "V.E.COUNT_NEG", "V.E.COUNT_POS")
    assert [controller.read(name) for name in names] == [100, 100, 1]
    controller.step(10)
    assert [controller.read(name) for name in names] == [110, 100, 1]


def test_a_reset_counts_more_than_a_program_end_of_the_same_tick() -> None:
    """The GLOBAL cycle fails in the tick that takes M30; the PLC resets before Python has both."""
    controller = Controller(DEMO)

    class ResetsAtOnce:
        """A PLC with the controller's own reset."""

        done = False

        def cycle(self, hli: PlcView) -> None:
            """After each tick."""
            if hli.error and not self.done:
                self.done = True
                controller.reset()

    text = "#RT CYCLE [ID=1 SCOPE=GLOBAL]\nV.E.COUNT = 1 / V.E.VALUE\n#RT CYCLE END\nM30"
    run = controller.run(NcText("p.nc", text), plc=ResetsAtOnce(), ticks=50)
    assert [error.id for error in run.errors] == [50879]
    assert [event.kind for event in run.events].count("end") == 1
    assert run.state == "reset"


def test_a_reset_at_rest_takes_one_tick() -> None:
    """At least one tick, also where nothing moves."""
    controller = Controller(DEMO)
    controller.reset()
    assert controller.tick == 1
    controller.reset()
    assert controller.tick == 2


@pytest.mark.parametrize("ticks", [1, 5, 32, 33, 60, 200])
def test_the_next_program_begins_where_the_axes_are(ticks: int) -> None:
    """After a reset at any time the following program moves from there, with its own cycles."""
    text = CYCLES + "G00 X1\n#FLUSH WAIT\nM111\nG04 X0.02\nP1 = V.E.VALUE\nG00 X100\nG00 X3\nM30"
    controller = started(text, ticks)
    controller.reset()
    run = controller.run(NcText("q.nc", "#RT CYCLE [ID=2]\n#RT CYCLE END\nG00 X7\nM30"))
    assert run.errors == ()
    assert run.state == "ended"
    assert controller.read("V.RTA.ACS.ACT_POS.X") == 7


def test_a_fault_in_the_tick_of_an_answer_leaves_none_to_the_next_program() -> None:
    """RC-005, RC-505: the flush of a program that has just failed is not answered."""
    text = "G04 X0.01\n#RT CYCLE [ID=1]\nV.E.VALUE = 1 / [V.E.COUNT - 1]\n#RT CYCLE END\n"
    controller = Controller(DEMO)
    controller.write("V.E.COUNT", 1)
    assert controller.run(NcText("p.nc", text + "#FLUSH WAIT\nP1 = V.E.COUNT\nM30")).errors
    controller.reset()
    run = controller.run(NcText("q.nc", "G00 X7\nM30"))
    assert run.state == "ended"
    assert controller.read("V.RTA.ACS.ACT_POS.X") == 7


def test_a_reset_of_a_dwell_and_of_a_wait_for_the_plc() -> None:
    """What waits, waits no longer."""
    for text in ("G04 X10\nM30", "M111\nG00 X1\nM30"):
        controller = Controller(DEMO)
        machine_of(controller).channels[0].hli.acknowledges_itself = False
        controller.start(NcText("p.nc", text))
        controller.step(5)
        controller.reset()
        assert controller.tick == 6
        assert controller.state == "ready"


def test_what_a_reset_ends_is_stamped_with_its_tick(tmp_path: Path) -> None:
    """The tick that latches the reset ends the cycles; no earlier row has their events (RC-001)."""
    controller = Controller(DEMO)
    first = controller.run(NcText("p.nc", CYCLES + "G00 X1\nX[1 / V.E.ASYNC]\nM30"))
    assert first.state == "error"
    assert first.ticks == controller.tick
    file = tmp_path / "trace.csv"
    second = controller.run(NcText("q.nc", "G00 X2\nM30"), sinks=[CsvSink(file)])
    assert second.state == "ended"
    ended = [event for event in second.events if event.kind == "ended"]
    assert [(event.tick, event.text) for event in ended] == [(first.ticks, "2 reset")]
    rows = file.read_text("utf-8").splitlines()
    assert rows[1].startswith(f"{first.ticks},")
    assert "ended 2 reset" in rows[1]
    assert sum("ended 2 reset" in row for row in rows) == 1


def test_an_error_stops_the_channel_until_a_reset() -> None:
    """In error state nothing is taken from the queue; GLOBAL cycles run on (RC-505)."""
    controller = started(
        CYCLES + "#RT CYCLE\nV.E.VALUE = 1 / V.E.ASYNC\n#RT CYCLE END\nG00 X9\nM30", 50
    )
    assert controller.state == "error"
    assert controller.read("V.E.COUNT") == 50
    assert controller.read("V.RTA.ACS.ACT_POS.X") == 0
    controller.reset()
    assert controller.state == "ready"


def test_a_program_that_starts_while_another_runs_resets_first() -> None:
    """RC-007: the path brakes to a standstill, the rest is dropped, then the new program begins."""
    controller = Controller()
    controller.start(NcText("first.nc", "G00 X100\nM30"))
    controller.step(10)
    controller.start(NcText("second.nc", "G00 X0\nM30"))
    controller.step(300)
    assert controller.state == "ready"
    assert controller.read("V.RTA.ACS.ACT_POS.X") == 0.0
    assert controller.diagnostics == []
