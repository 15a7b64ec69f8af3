# SPDX-License-Identifier: MIT
"""Successive runs, each as on a new controller, without building one.

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
from nctakt.run.beginning import Beginning, Beginnings, in_common, may_share, varied
from nctakt.run.options import RunKeywords, check_keywords
from nctakt.run.program_loader import AnyProgram, LoadedProgram, NcText, ProgramErrors
from nctakt.run.program_run import ProgramRun
from nctakt.run.realtime.realtime_part import RealtimePart
from nctakt.run.realtime.realtime_parts import RealtimeParts

_Program = str | Path | NcText


def _result(run: ProgramRun) -> Run:
    """Continue to the end of a run and return its result; Ctrl-C ends it where it is."""
    try:
        run.advance()
    except KeyboardInterrupt:
        run.interrupt()
    finally:
        run.close()
    return run.result()


class OneController(Protocol):
    """The part of a controller that a run needs."""

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
    """Makes runs of one machine, each from start-up on: nothing is carried over from run to run.

    A program is read and checked when it first runs; later changes in its files are not seen.
    ``new`` returns a controller with a realtime part.
    """

    def __init__(self, machine: Machine, new: Callable[[RealtimePart], OneController]) -> None:
        self._machine = machine
        self._new = new
        self._parts = RealtimeParts()
        self._beginnings: Beginnings[OneController] = Beginnings()
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
        self._beginnings = Beginnings()
        self._loaded.clear()

    def run(
        self,
        *programs: _Program,
        channels: Mapping[int, Sequence[_Program]] | None = None,
        **options: Unpack[RunKeywords],
    ) -> Run:
        """Run programs on a machine as at start-up; options and failures as ``Controller.run``."""
        check_keywords("ReusableController.run", "python", options)
        begun = self._begun_again(programs, options) if not channels else None
        if begun is not None:
            beginning, run = begun
            try:
                return _result(run)
            finally:
                beginning.give_back()
        lent = self._parts.lend(self._machine)
        controller = self._new(lent.part)
        loaded = {
            channel: tuple(self._program(controller, program, channel) for program in of_channel)
            for channel, of_channel in {1: programs, **(channels or {})}.items()
        }
        result = _result(controller.begin(loaded, **options))
        lent.give_back()
        return result

    def _begun_again(
        self, programs: Sequence[_Program], options: RunKeywords
    ) -> tuple[Beginning[OneController], ProgramRun] | None:
        """Begin a run where others of this program have begun, if that is possible."""
        loaded = self._loaded.get((1, programs[0])) if len(programs) == 1 else None
        if not isinstance(loaded, LoadedProgram) or not may_share(options):
            return None
        try:
            common = programs[0], in_common(options)
        except TypeError:
            return None
        beginning = self._beginnings.of(
            common,
            lambda: Beginning(
                self._new, self._parts.lend(self._machine), loaded, options, keeps_results=True
            ),
        )
        run = None if beginning is None else beginning.begin(varied(options))
        return None if beginning is None or run is None else (beginning, run)

    def _program(self, controller: OneController, program: _Program, channel: int) -> AnyProgram:
        """Return a program as checked; one with errors unchanged: its run reports them."""
        key = channel, program
        if key not in self._loaded:
            count = len(controller.diagnostics)
            try:
                self._loaded[key] = controller.load(program, channel)
            except ProgramErrors:
                del controller.diagnostics[count:]
                return program
        return self._loaded[key]
