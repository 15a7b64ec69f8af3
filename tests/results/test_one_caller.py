# SPDX-License-Identifier: MIT
"""A controller is run by one thread at a time; a second one is reported (901005)."""

from __future__ import annotations

import threading
from collections.abc import Callable

import pytest

from nctakt.base.failure import Failure
from nctakt.run.controller import Controller, NcText
from nctakt.run.plcs.plc_view import PlcView

PART = NcText("p.nc", "G04 X0.010\nM30\n")

CALLS: dict[str, Callable[[Controller], object]] = {
    "step": lambda controller: controller.step(5),
    "run": lambda controller: controller.run(PART),
    "reset": lambda controller: controller.reset(),
    "start": lambda controller: controller.start(PART),
    "select": lambda controller: controller.select(PART),
}


@pytest.mark.parametrize("call", CALLS)
def test_a_second_thread_is_reported_and_no_tick_is_lost(call: str) -> None:
    """While one thread is in the middle of a run, whatever another one asks for."""
    controller = Controller()
    inside, over = threading.Event(), threading.Event()
    reported: list[int] = []

    class Waits:
        """A PLC that stays in its first cycle until the other thread has tried."""

        def cycle(self, hli: PlcView) -> None:
            inside.set()
            assert over.wait(60)
            hli.acknowledge_all()

    def other() -> None:
        assert inside.wait(60)
        try:
            CALLS[call](controller)
        except Failure as failure:
            reported.extend(one.id for one in failure.diagnostics)
        over.set()

    thread = threading.Thread(target=other)
    thread.start()
    run = controller.run(PART, plc=Waits())
    thread.join(60)
    assert reported == [901005]
    assert (run.state, run.ticks) == ("ended", Controller().run(PART).ticks)


def test_a_controller_is_free_again_after_a_failure() -> None:
    """What was refused or has failed leaves nothing behind."""
    controller = Controller()
    with pytest.raises(Failure):
        controller.run(PART, set={"V.E.NONE": 1.0})
    controller.step(2)
    assert controller.tick == 2


def test_each_thread_may_have_its_own_controller() -> None:
    """They do not know of each other."""
    ticks: list[int] = []
    threads = [
        threading.Thread(target=lambda: ticks.append(Controller().run(PART).ticks))
        for _ in range(3)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(60)
    assert ticks == [Controller().run(PART).ticks] * 3
