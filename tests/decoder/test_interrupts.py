# SPDX-License-Identifier: MIT
"""A run can be interrupted while its program is read and decoded, not only between two ticks."""

from __future__ import annotations

import pytest

from nctakt.run.controller import Controller, NcText


class Interrupt:
    """Presses Ctrl-C when it is asked the n-th time."""

    def __init__(self, after: int) -> None:
        self.left = after
        self.ticks: list[int] = []

    def __call__(self, tick: int, _limit: int | None) -> None:
        self.ticks.append(tick)
        self.left -= 1
        if self.left == 0:
            raise KeyboardInterrupt


@pytest.mark.parametrize(
    "text",
    [
        "$FOR P1 = 1, 90000, 1\nP2 = P2 + 1\n$ENDFOR\nM30\n",
        "$WHILE 1\nV.E.VALUE = 1\n$ENDWHILE\nM30\n",
        "LL SUB\nM30\n%L SUB\n$WHILE 1\nP1 = P1 + 1\n$ENDWHILE\nM17\n",
    ],
)
def test_ctrl_c_acts_inside_the_decoder(text: str) -> None:
    """No tick has been run, and none is."""
    interrupt = Interrupt(3)
    run = Controller().run(NcText("p.nc", text), on_progress=interrupt)
    assert (run.state, run.ticks) == ("interrupted", 0)
    assert interrupt.ticks == [0, 0, 0]


def test_ctrl_c_acts_while_a_program_is_read() -> None:
    """Before its first tick, and before all of it has been checked."""
    text = '#MSG ["a"]\nP1 = P1 * 2\n' * 4000 + "QQQ\nM30\n"
    run = Controller().run(NcText("p.nc", text), on_progress=Interrupt(2))
    assert (run.state, run.ticks, run.errors) == ("interrupted", 0, ())


def test_a_controller_runs_on_after_an_interrupt() -> None:
    """What was broken off is reset by the next run."""
    controller = Controller()
    endless = NcText("p.nc", "$WHILE 1\nP1 = P1 + 1\n$ENDWHILE\nM30\n")
    assert controller.run(endless, on_progress=Interrupt(2)).state == "interrupted"
    assert controller.run(NcText("q.nc", "G00 X1\nM30\n")).state == "ended"


@pytest.mark.parametrize("ticks", [1, 5])
def test_a_loop_that_never_takes_time_ends_whatever_the_limit_of_ticks(ticks: int) -> None:
    """The bound of blocks without time holds before the first tick (900303)."""
    run = Controller().run(NcText("p.nc", "$WHILE 1\nP1 = P1 + 1\n$ENDWHILE\nM30\n"), ticks=ticks)
    assert [one.id for one in run.errors] == [900303]
