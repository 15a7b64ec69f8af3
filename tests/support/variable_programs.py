# SPDX-License-Identifier: MIT
"""Programs of some lines, run on a machine of some variables."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from nctakt.lists.machine import machine as machines
from nctakt.results.run import Run
from nctakt.run.controller import Controller, NcText
from support.variable_machines import machine_with


@dataclass
class Machine:
    """A controller that programs are run on."""

    controller: Controller

    def run(self, text: str, *, initial: Mapping[str, float | str] | None = None) -> Run:
        """Run one program to its end."""
        for name, value in (initial or {}).items():
            self.controller.write(name, value)
        if initial:
            self.controller.step(1)
        source = NcText("p.nc", text)
        return self.controller.run(source, ticks=self.controller.tick + 2000, record_writes=True)

    def value(self, name: str) -> float | bool | str:
        """What a variable holds."""
        return self.controller.read(name)


def demo() -> Machine:
    """The demo machine."""
    return Machine(Controller())


def machine(tmp_path: Path, variables: str, alignment: int = 8) -> Machine:
    """A machine with these variables."""
    configuration: machines.Machine = machine_with(tmp_path, variables, alignment)
    return Machine(Controller(configuration))


def errors(run: Run) -> list[int]:
    """The numbers of a run's diagnostics."""
    return [one.id for one in run.diagnostics if one.id != 900201]


def messages(run: Run) -> list[str]:
    """What the program said."""
    return [event.text for event in run.events if event.kind == "message"]
