# SPDX-License-Identifier: MIT
"""Runs one after another, each as on a new controller, without building one anew.

In: a machine. Out: the result of each run. Between two runs the realtime part is put back to its
snapshot of start-up, and programs are not read and checked again.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from types import TracebackType
from typing import Protocol, Self, Unpack

from nctakt.base.diagnostics import Diagnostic
from nctakt.lists.machine.machine import Machine
from nctakt.results.run import Run
from nctakt.run.options import RunKeywords, check_keywords
from nctakt.run.program_loader import AnyProgram, LoadedProgram, NcText, ProgramErrors
from nctakt.run.program_run import ProgramRun
from nctakt.run.realtime_part import RealtimePart
from nctakt.run.realtime_parts import RealtimeParts

_Program = str | Path | NcText


class OneController(Protocol):
    """What a run needs of a controller."""

    diagnostics: list[Diagnostic]

    def load(self, program: _Program, channel: int = 1) -> LoadedProgram:
        """Read and check a program; raises ``Failure``."""

    def begin(
        self,
        programs: Mapping[int, Sequence[AnyProgram]],
        *,
        statistics: bool = True,
        **given: Unpack[RunKeywords],
    ) -> ProgramRun:
        """Return a run before its first tick."""


class ReusableController:
    """Makes runs of one machine, each from start-up on: nothing lives on from run to run.

    A program is read and checked when it runs first; what changes in its files afterwards is not
    seen. ``new`` returns a controller with a realtime part.
    """

    def __init__(self, machine: Machine, new: Callable[[RealtimePart], OneController]) -> None:
        self._machine = machine
        self._new = new
        self._parts = RealtimeParts()
        self._loaded: dict[tuple[int, _Program], LoadedProgram] = {}

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._parts = RealtimeParts()
        self._loaded.clear()

    def run(
        self,
        *programs: _Program,
        channels: Mapping[int, Sequence[_Program]] | None = None,
        **options: Unpack[RunKeywords],
    ) -> Run:
        """Run programs on a machine as at start-up; options and failures as ``Controller.run``."""
        check_keywords("ReusableController.run", "python", options)
        lent = self._parts.lend(self._machine)
        controller = self._new(lent.part)
        loaded = {
            channel: tuple(self._program(controller, program, channel) for program in of_channel)
            for channel, of_channel in {1: programs, **(channels or {})}.items()
        }
        run = controller.begin(loaded, **options)
        try:
            run.advance()
        except KeyboardInterrupt:
            run.interrupt()
        finally:
            run.close()
        result = run.result()
        lent.give_back()
        return result

    def _program(self, controller: OneController, program: _Program, channel: int) -> AnyProgram:
        """Return a program as it was checked; one with errors as it is: its run reports them."""
        key = channel, program
        if key not in self._loaded:
            count = len(controller.diagnostics)
            try:
                self._loaded[key] = controller.load(program, channel)
            except ProgramErrors:
                del controller.diagnostics[count:]
                return program
        return self._loaded[key]
