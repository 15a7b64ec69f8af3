# SPDX-License-Identifier: MIT
"""Resets, tick by tick (RC-007): what moves, which cycles are left, which ticks they miss."""

from __future__ import annotations

import pytest

from nctakt.run.controller import Controller, NcText

PROGRAM = """
#RT CYCLE [ID = 1 SCOPE = GLOBAL]
  V.E.COUNT += 1
  $IF ONCE V.E.TRIGGER == 0
    V.E.COUNT_POS += 1
  $ENDIF
  $IF ALWAYS V.E.TRIGGER == 0
    V.E.COUNT_NEG += 1
  $ENDIF
#RT CYCLE END
#RT CYCLE [ID = 2 SCOPE = PROG]
  V.E.VALUE += 1
#RT CYCLE END
#RT CYCLE [ID = 3 SCOPE = BLOCK]
  V.E.VALUE1 += 1
#RT CYCLE END
N10 G00 X100
M30
"""


def started(ticks: int) -> Controller:
    """A controller that has run this many ticks of the program."""
    controller = Controller()
    controller.start(NcText("part.nc", PROGRAM))
    controller.step(ticks)
    return controller


def values(controller: Controller) -> list[float]:
    """How often the GLOBAL, the PROG and the BLOCK cycle have run."""
    return [float(controller.read(f"V.E.{name}")) for name in ("COUNT", "VALUE", "VALUE1")]


def test_a_reset_brakes_on_the_path_and_no_cycle_runs_in_it() -> None:
    """RC-007, MO-6: 20 mm after 100 ticks at 400 mm/s; it is 100 ticks later at 40 mm."""
    controller = started(100)
    assert controller.read("V.RTA.ACS.ACT_POS.X") == pytest.approx(20, abs=1e-9)
    assert values(controller) == [100, 100, 100]
    controller.reset()
    assert controller.tick == 200
    assert controller.state == "ready"
    assert controller.read("V.RTA.ACS.ACT_POS.X") == pytest.approx(40, abs=1e-9)
    assert values(controller) == [100, 100, 100]


def test_a_reset_deletes_block_and_prog_cycles_and_keeps_global_ones() -> None:
    """RC-007: the GLOBAL cycle runs on after the reset with its ``$IF`` states."""
    controller = started(100)
    controller.write("V.E.TRIGGER", 1)
    controller.reset()
    controller.step(3)
    assert values(controller) == [103, 100, 100]
    assert controller.read("V.E.COUNT_POS") == 1  # ONCE has had its turn
    assert controller.read("V.E.COUNT_NEG") == 103  # ALWAYS is still latched
    assert controller.read("V.RTA.ACS.ACT_POS.X") == pytest.approx(40, abs=1e-9)


def test_a_reset_at_rest_takes_a_tick_without_cycles() -> None:
    """RC-007: at least one tick, in which the GLOBAL cycle does not run."""
    controller = started(400)
    assert controller.state == "ready"
    assert values(controller) == [400, 325, 325]
    controller.reset()
    assert controller.tick == 401
    assert values(controller) == [400, 325, 325]
    controller.step()
    assert values(controller) == [401, 325, 325]


def test_ids_are_free_after_a_reset() -> None:
    """RC-007, RC-108: IDs of PROG and BLOCK cycles may be used again, that of a GLOBAL one not."""
    controller = started(10)
    controller.reset()
    controller.start(NcText("again.nc", PROGRAM.replace("ID = 1 ", "ID = 4 ")))
    controller.step(5)
    assert controller.state == "running"
    controller.reset()
    controller.start(NcText("part.nc", PROGRAM))
    controller.step()
    assert controller.state == "error"


def test_a_reset_ends_the_error_state() -> None:
    """RC-007, RC-505: after a fault the channel is in error until it is reset."""
    controller = Controller()
    text = "#RT CYCLE [ID = 1 SCOPE = GLOBAL]\nV.E.COUNT += 1\n#RT CYCLE END\n"
    text += "#RT CYCLE [ID = 2]\nV.E.VALUE = 1 / V.E.VALUE1\n#RT CYCLE END\n#TIME 0.010\nM30\n"
    controller.start(NcText("fault.nc", text))
    controller.step(2)
    assert controller.state == "error"
    assert controller.read("V.E.COUNT") == 2
    controller.reset()
    assert controller.state == "ready"
    assert controller.read("V.E.COUNT") == 2
    controller.start(NcText("next.nc", "N10 G00 X0.1\nM30\n"))
    controller.step(11)
    assert controller.state == "ready"
    assert controller.read("V.RTA.ACS.ACT_POS.X") == pytest.approx(0.1, abs=1e-9)
