# SPDX-License-Identifier: MIT
"""What the tests of decisions share: a program as text, reports of a run, its final state."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from nctakt.lists.machine.machine import Machine, load_machine
from nctakt.results.run import Run
from nctakt.run.controller import Controller, NcText


def machine(**limits: int) -> Machine:
    """The demo machine with other limits of realtime cycles (``RealtimeCycleLimits``)."""
    demo = load_machine(None)
    (channel,) = demo.channels
    cycles = replace(channel.parameters.realtime_cycles, **limits)
    parameters = replace(channel.parameters, realtime_cycles=cycles)
    return replace(demo, channels=(replace(channel, parameters=parameters),))


def perform(program: str, controller: Controller | None = None, **settings: Any) -> Run:
    """Run the text of a program on the demo machine."""
    settings.setdefault("signals", ["X.ACS.ACT_POS"])
    return (controller or Controller()).run(NcText("part.nc", program), **settings)


def reported(run: Run, *kinds: str) -> list[str]:
    """The events of these kinds, of all kinds without any: ``<tick> <kind> <text>``."""
    return [f"{event.tick} {event}" for event in run.events if not kinds or event.kind in kinds]


def numbers(run: Run) -> list[int]:
    """The numbers of a run's diagnostics."""
    return [found.id for found in run.diagnostics]


def left(program: str, name: str, **settings: Any) -> float | bool | str:
    """The value of a variable after a program without errors."""
    controller = Controller()
    run = perform(program, controller, **settings)
    assert run.state == "ended", run.diagnostics
    return controller.read(name)
