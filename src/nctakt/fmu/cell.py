# SPDX-License-Identifier: MIT
"""The inside of an FMU of nctakt: a machine with its program and PLC, step by step.

In: the folder of the FMU's resources, values of inputs, steps. Out: values of signals, messages,
states. Each instance has its own controller. A step is a whole number of ticks.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from nctakt.base.diagnostics import Diagnostic, Severity
from nctakt.base.failure import Failure
from nctakt.files.access import FileAccess
from nctakt.fmu.cell_state import CellInputs, CellState, EventDigest
from nctakt.messages import diagnostic
from nctakt.messages.plcs.fmu import (
    CELL_DOES_OTHERWISE,
    CELL_STATE_OF_ANOTHER,
    CELL_STEP_NOT_POSSIBLE,
)
from nctakt.plc.loading import load_plcs
from nctakt.run.access.inputs import FMU
from nctakt.run.controller import Controller
from nctakt.run.options import RunKeywords
from nctakt.run.plcs.realtime_plc import memories_of
from nctakt.run.tape_words import options_of_words

#: The folder with the users' files, and the file that says how they are run, in the resources.
FILES, CONTENT = "files", "cell.json"

#: Part of a tick that a time of the importer may be off.
_TOLERANCE = 1e-3


class _Started:
    """A run of the files of an FMU, before its first tick; raises ``Failure`` for faulty files."""

    def __init__(self, files: Path, content: dict[str, Any]) -> None:
        words = content["words"]
        machine = words["machine"]
        folder = None if machine is None else files / machine if content["has_lists"] else machine
        self.controller = controller = Controller(folder, None, FileAccess([files]))
        plc = load_plcs([files / name for name in content["plcs"]])
        self._events = EventDigest()
        options: RunKeywords = {
            **options_of_words(words),
            "plc": plc,
            "sinks": [self._events],
            "memory_trace": False,
            "signals": content["variables"],
            "record_writes": False,
            "stays": True,
        }
        programs: dict[int, list[str | Path]] = {1: [files / name for name in words["programs"]]}
        for number, name in words["others"]:
            programs.setdefault(int(number), []).append(files / name)
        self.run = controller.begin(programs, **options)
        self.run.load()
        if any(one.severity is Severity.ERROR for one in controller.diagnostics):
            raise Failure(*controller.diagnostics)
        self.machine = self.run.machine
        self._memories: list[bytearray | memoryview] = [self.machine.memory, *memories_of(plc)]

    def digest(self) -> str:
        """Return the digest of its memory and of its events so far."""
        return self._events.with_memories(self._memories)


class Cell:
    """A machine with its program; raises ``Failure`` if the files do not make one."""

    def __init__(self, resources: Path) -> None:
        self._content = content = json.loads((resources / CONTENT).read_text("utf-8"))
        self._files = resources / FILES
        self._names: Sequence[str] = content["variables"]
        self._inputs = CellInputs()
        self._start_us = 0.0
        self._shown = 0
        self._take(_Started(self._files, content), 0)

    def _take(self, started: _Started, ticks: int) -> None:
        """Continue a run after some ticks."""
        self._started = started
        self._controller, self._run, self._machine = (
            started.controller,
            started.run,
            started.machine,
        )
        self._ticks = ticks
        signals = self._machine.signals()
        self._cells = [None if name not in signals else signals[name].cell for name in self._names]

    def begin_at(self, time_s: float) -> None:
        """Let the importer's time begin here; the machine's begins at 0."""
        self._start_us = time_s * 1e6

    def get(self, references: Sequence[int]) -> list[Any]:
        """Return the values of variables; they count from 1."""
        cells = self._machine.cells
        found: list[Any] = []
        for reference in references:
            cell = self._cells[reference - 1]
            found.append(
                self._machine.read(self._names[reference - 1]) if cell is None else cells[cell]
            )
        return found

    def set(self, references: Sequence[int], values: Sequence[Any]) -> None:
        """Set variables with effect from the next tick; raises ``Failure``."""
        for reference, value in zip(references, values, strict=True):
            self._machine.write(self._names[reference - 1], value, FMU)
            self._inputs.note(self._ticks, reference, value)

    def step(self, time_s: float, step_s: float) -> None:
        """Run the ticks of a communication step; raises ``Failure`` if they are no whole number."""
        cycle_us = self._controller.cycle_time_us
        end = (time_s + step_s) * 1e6 - self._start_us
        ticks = round(end / cycle_us)
        if abs(end / cycle_us - ticks) > _TOLERANCE or ticks <= self._ticks:
            raise Failure(
                diagnostic(
                    CELL_STEP_NOT_POSSIBLE, step=f"{step_s:g} s", tick=f"{cycle_us / 1e6:g} s"
                )
            )
        self._ticks = ticks
        self._run.advance(ticks)

    def news(self) -> Sequence[Diagnostic]:
        """Return the messages since the last call."""
        found = self._controller.diagnostics[self._shown :]
        self._shown += len(found)
        return found

    # --- states ---------------------------------------------------------------------------------

    def state(self) -> CellState:
        """Return the present state."""
        return CellState(
            self._content["token"],
            self._ticks,
            self._start_us,
            self._shown,
            self._started.digest(),
            self._inputs,
            len(self._inputs),
        )

    def put_back(self, state: CellState) -> None:
        """Continue from a state: repeat its run, with the same inputs.

        Raises ``Failure`` for a state of another FMU (902842) and where the run does otherwise than
        before (902843); then nothing has changed.
        """
        if state.token != self._content["token"]:
            raise Failure(diagnostic(CELL_STATE_OF_ANOTHER))
        again = _Started(self._files, self._content)
        for part in state.inputs.parts(state.count):
            for tick, reference, value in part.tolist():
                again.run.advance(int(tick))
                again.machine.write(self._names[int(reference) - 1], value, FMU)
        again.run.advance(state.ticks)
        if again.digest() != state.digest:
            again.run.close()
            plcs = ", ".join(self._content["plcs"]) or "-"
            raise Failure(diagnostic(CELL_DOES_OTHERWISE, ticks=state.ticks, plc=plcs))
        self._run.close()
        self._inputs = CellInputs(state.inputs, state.count)
        self._start_us, self._shown = state.start_us, state.shown
        self._take(again, state.ticks)

    def close(self) -> None:
        """Give up the run."""
        self._run.close()
