# SPDX-License-Identifier: MIT
"""The calls that the libraries of pythonfmu and pythonfmu3 make inside an FMU of nctakt.

In: FMI's calls by their Python names. Out: those of a ``Cell``; its exceptions become a message in
the importer's log and a status.
"""

from __future__ import annotations

import ctypes
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple

from nctakt.base.diagnostics import Severity
from nctakt.base.failure import Failure
from nctakt.fmu.cell import Cell
from nctakt.fmu.cell_state import CellState, state_from_bytes, state_to_bytes

OK, WARNING, ERROR = 0, 1, 3


class LogEntry(NamedTuple):
    """A message for the importer's log, as the libraries read it."""

    status: int
    category: str
    msg: str
    debug: bool = False


class StepResult(NamedTuple):
    """The answer to a step, as the library of FMI 3.0 reads it; that of FMI 2.0 asks for truth."""

    status: int
    terminateSimulation: bool = False

    def __bool__(self) -> bool:
        """Whether the step is done."""
        return self.status == OK


class Slave:
    """One instance; ``resources``: the folder of the FMU's resources."""

    def __init__(self, *, instance_name: str, resources: str, **_: object) -> None:
        self._name = instance_name
        self._log: list[LogEntry] = []
        self._cell = Cell(Path(resources))

    def _get_log_queue(self) -> list[LogEntry]:
        return self._log

    def setup_experiment(self, start_time: float, *_: object) -> None:
        """Take the importer's time at the begin."""
        self._cell.begin_at(start_time)

    def enter_initialization_mode(self) -> None:
        """Do nothing: the machine is before its first tick."""

    def exit_initialization_mode(self) -> None:
        """Do nothing."""

    def do_step(self, current_time: float, step_size: float) -> StepResult:
        """Run the ticks of a step."""
        status = OK
        try:
            self._cell.step(current_time, step_size)
        except Failure as failure:
            status = ERROR
            self._log += [
                LogEntry(ERROR, "logStatusError", one.render()) for one in failure.diagnostics
            ]
            print(failure, file=sys.stderr)  # FMI 2.0 has no text for a discarded step
        for one in self._cell.news():
            is_error = one.severity is Severity.ERROR
            self._log.append(LogEntry(WARNING if is_error else OK, "logAll", one.render()))
        return StepResult(status)

    def terminate(self) -> None:
        """Give up the run."""
        self._cell.close()

    def _get_fmu_state(self) -> CellState:
        return self._cell.state()

    def _set_fmu_state(self, state: CellState | Failure) -> None:
        try:
            if isinstance(state, Failure):
                raise state
            self._cell.put_back(state)
        except Failure as failure:
            raise self._refusal(failure) from failure

    def _refusal(self, failure: Failure) -> RuntimeError:
        """Return the text that the libraries show for a failure.

        They release their hold on an instance when it raises, and once more at its end.
        """
        for held in (self, type(self), self._log):
            ctypes.pythonapi.Py_IncRef(ctypes.py_object(held))
        return RuntimeError(str(failure))

    _fmu_state_to_bytes = staticmethod(state_to_bytes)

    @staticmethod
    def _fmu_state_from_bytes(data: bytes) -> CellState | Failure:
        """Return a state, or why there is none: without an instance nothing may be raised."""
        try:
            return state_from_bytes(data)
        except Failure as failure:
            return failure

    def _get(self, references: Sequence[int]) -> list[Any]:
        return self._cell.get(references)

    def _set(self, references: Sequence[int], values: Sequence[Any]) -> None:
        try:
            self._cell.set(references, values)
        except Failure as failure:
            raise self._refusal(failure) from failure

    def _get_truths(self, references: Sequence[int]) -> list[bool]:
        return [bool(value) for value in self._cell.get(references)]

    get_real = get_float64 = _get
    set_real = set_float64 = set_boolean = _set
    get_boolean = _get_truths


class Fmi2Slave(Slave):
    """The same; the library of FMI 2.0 finds the class of an FMU by a base of this name."""


class Fmi3Slave(Slave):
    """The same; the library of FMI 3.0 finds the class of an FMU by a base of this name."""
