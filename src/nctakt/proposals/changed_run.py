# SPDX-License-Identifier: MIT
"""A run of a program with a single change."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Protocol

from nctakt.base.failure import Failure
from nctakt.files.access import FileAccess
from nctakt.lists.machine.machine import Machine
from nctakt.proposals.changes import Change
from nctakt.results.run import Run
from nctakt.run.controller import Controller
from nctakt.run.options import RunKeywords
from nctakt.schedule.open_schedule import RunSchedule
from nctakt.studies.plans.changed_lists import changed_machine
from nctakt.studies.plans.faults import FaultyPlc, PlcFaults


class RunRequest(Protocol):
    """A run: programs of channel 1 and of others, options, a PLC and an FMU."""

    @property
    def programs(self) -> Sequence[Any]:
        """Those of channel 1."""

    @property
    def channels(self) -> Mapping[int, Sequence[Any]]:
        """Those of the others, by number."""

    @property
    def options(self) -> RunKeywords:
        """The options of ``Controller.run``."""

    @property
    def signals(self) -> tuple[str, ...] | None:
        """The signals that are recorded."""

    @property
    def plc(self) -> Any:
        """The PLC, not yet used."""

    @property
    def fmu(self) -> Any:
        """The FMU, not yet used."""


def changed_run(
    machine: Machine,
    schedule: RunSchedule | None,
    access: FileAccess,
    request: RunRequest,
    change: Change,
    value: float,
) -> Run | None:
    """Return the run with a value of a change; ``None`` if it is not possible."""
    plc = request.plc
    given: dict[str, float | str] = dict(request.options["set"] or {})
    try:
        match change.kind:
            case "variable":
                given[change.target] = value
            case "parameter":
                machine = changed_machine(
                    machine, {(change.target, owner): value for owner in change.of}
                )
            case "function":
                plc = FaultyPlc(plc, PlcFaults({change.target: value}))
        keywords: RunKeywords = {
            **request.options,
            "set": given,
            "plc": plc,
            "fmu": request.fmu,
            "signals": request.signals,
            "memory_trace": True,
        }
        controller = Controller(machine, schedule, access)
        return controller.run(*request.programs, channels=request.channels, **keywords)
    except Failure:
        return None
