# SPDX-License-Identifier: MIT
"""Realtime cycles that nothing starts, and starts of cycles that nothing defines.

In: the cycles that each checked program defines and starts, and the files it calls. Out: warnings,
if a main program and everything it calls is known. A computed ID or call may mean any cycle.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from nctakt.base.dataclass import dataclass
from nctakt.messages import Collector
from nctakt.messages.programs.lints import CYCLE_NEVER_STARTED, STARTED_CYCLE_NOT_DEFINED
from nctakt.nc.lint.cycle_uses import CycleUse


@dataclass(frozen=True, slots=True)
class LinkedProgram:
    """A checked program: its cycles and calls; ``is_main``: it is complete and runs by itself.

    ``misses_files``: it calls a file that could not be found.
    """

    path: Path
    called: Sequence[Path]
    cycles: Sequence[CycleUse]
    is_main: bool
    misses_files: bool


def report_unlinked_cycles(programs: Sequence[LinkedProgram], collector: Collector) -> None:
    """Report the cycles of complete programs that nothing starts, and starts of unknown ones."""
    by_path = {program.path: program for program in programs}
    wholes = [_with_called(program, by_path) for program in programs if program.is_main]
    uses = [use for program in programs for use in program.cycles]
    left = {use.identity for use in uses if use.is_definition and use.scope == "GLOBAL"}
    for path, program in by_path.items():
        around = [whole for whole in wholes if path in whole] if program.cycles else []
        if not around or any(one.misses_files for whole in around for one in whole.values()):
            continue
        together = [[use for one in whole.values() for use in one.cycles] for whole in around]
        for use in program.cycles:
            if use.is_deferred and use.scope != "GLOBAL":
                if not any(_starts(use.identity, others) for others in together):
                    collector.report(CYCLE_NEVER_STARTED, use.span, use.line, id=use.identity)
            elif use.is_start and use.identity is not None and use.identity not in left:
                if not any(_defines(use.identity, others) for others in together):
                    collector.report(STARTED_CYCLE_NOT_DEFINED, use.span, use.line, id=use.identity)


def _with_called(
    program: LinkedProgram, by_path: Mapping[Path, LinkedProgram]
) -> dict[Path, LinkedProgram]:
    """Return a program and all that it calls, directly or not."""
    seen: dict[Path, LinkedProgram] = {}
    waiting = [program.path]
    while waiting:
        path = waiting.pop()
        if path not in seen and path in by_path:
            seen[path] = by_path[path]
            waiting += by_path[path].called
    return seen


def _starts(identity: int | None, uses: Sequence[CycleUse]) -> bool:
    started = [use.identity for use in uses if use.is_start]
    return identity is None or identity in started or None in started


def _defines(identity: int, uses: Sequence[CycleUse]) -> bool:
    defined = [use.identity for use in uses if use.is_definition]
    return identity in defined or None in defined
