# SPDX-License-Identifier: MIT
"""A controller that is stepped shows what its ticks have done."""

from __future__ import annotations

from typing import Any

import pytest

from nctakt import Controller, Failure, NcText, Plc, on
from nctakt.results.run import Step

PROGRAM = NcText(
    "p.nc",
    """\
#RT CYCLE [ID=1 SCOPE=PROG]
  $IF ONCE V.E.VALUE > 0.5
    M100
  $ENDIF
#RT CYCLE END
G04 X0.05
#MSG ["done"]
M101
M30
""",
)


def kinds(step: Step) -> list[str]:
    return [event.kind for event in step.events]


def test_a_step_returns_what_its_ticks_have_done() -> None:
    controller = Controller()
    controller.start(PROGRAM)
    first = controller.step()
    assert (first.first_tick, first.ticks, first.state) == (0, 1, "running")
    assert "created" in kinds(first)
    quiet = controller.step(10)
    assert quiet.events == ()
    assert repr(quiet) == "<10 ticks from 1, running: nothing>"
    controller.write("V.E.VALUE", 1)
    (fired, *_) = controller.step().events
    assert (fired.kind, fired.tick) == ("fired", 11)
    rest = controller.step(100)
    assert [message.text for message in rest.messages] == ["done"]
    assert [function.name for function in rest.technology] == ["M101"]
    assert rest.state == "ready"


def test_a_started_program_takes_values_at_times_of_its_own() -> None:
    controller = Controller()
    controller.step(7)
    controller.start(PROGRAM, set={"V.E.COUNT": 3}, at=[("20 ms", "V.E.VALUE", 1)])
    assert controller.read("V.E.COUNT") == 3
    step = controller.step(100)
    assert [event.tick for event in step.events if event.kind == "fired"] == [27]


def test_a_started_program_has_a_plc() -> None:
    class Slow(Plc):
        @on("M101")
        def wait(self, hli: object, function: object) -> None:
            self.seen = True

    plc = Slow()
    controller = Controller()
    controller.start(PROGRAM, plc=plc)
    controller.step(200)
    assert plc.seen


def test_errors_of_a_step_are_its_diagnostics() -> None:
    controller = Controller()
    controller.start(NcText("p.nc", "P1 = V.E.VALUE\nP2 = 1 / P1\nM30"))
    (found,) = controller.step(5).diagnostics
    assert "20396" in str(found)
    assert controller.step(5).diagnostics == ()


@pytest.mark.parametrize(
    "options",
    [{"set": {"V.E.VALU": 1}}, {"at": [("1 s", "V.E.VALU", 1)]}, {"at": [("1 x", "", 1)]}],
)
def test_wrong_values_are_reported_before_a_program_begins(options: dict[str, Any]) -> None:
    controller = Controller()
    with pytest.raises(Failure):
        controller.start(PROGRAM, **options)
    assert controller.state == "ready"
