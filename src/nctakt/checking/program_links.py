# SPDX-License-Identifier: MIT
"""What programs need from each other: signals and axes of other channels, realtime cycles.

In: the signals and axes that all checked programs of a machine send, await, fetch and give; the
cycles that each of them defines and starts, and the files it calls. Out: warnings for signals that
none of them sends, for axes of another channel that none of them gives, for cycles that nothing
starts and starts of cycles that nothing defines. A program is judged only where the others are
known: a single program may have partners, a main program needs all files that it calls. Computed
numbers, IDs and calls fit any.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from nctakt.base.dataclass import dataclass
from nctakt.messages import Collector
from nctakt.messages.programs.lints import (
    CYCLE_NEVER_STARTED,
    NO_PROGRAM_GIVES_AXIS,
    NO_PROGRAM_SENDS_SIGNAL,
    STARTED_CYCLE_NOT_DEFINED,
)
from nctakt.nc.lint.cycle_uses import CycleUse
from nctakt.nc.outline import AxisUse, SignalUse


@dataclass(frozen=True, slots=True)
class ProgramUses:
    """The uses of one program in a channel of the machine of this folder.

    ``owners``: logical numbers of axes -> the channel whose list has them; ``own_names``: the axes
    of the channel's list with their numbers. ``is_main``: it may run on its own.
    """

    file: str
    machine: Path
    channel: int
    channel_count: int
    owners: dict[int, int]
    own_names: dict[str, int]
    signals: Sequence[SignalUse]
    exchanges: Sequence[AxisUse]
    is_main: bool


def report_missing_partners(programs: Sequence[ProgramUses], collector: Collector) -> None:
    """Report each signal and axis that a program waits for and that no other sends or gives."""
    for machine in dict.fromkeys(program.machine for program in programs):
        of_machine = [program for program in programs if program.machine == machine]
        mains = dict.fromkeys(program.file for program in of_machine if program.is_main)
        if of_machine[0].channel_count > 1 and len(mains) > 1:
            _report_signals(of_machine, collector)
            _report_axes(of_machine, collector)


def _report_signals(programs: Sequence[ProgramUses], collector: Collector) -> None:
    uses = [use for program in programs for use in program.signals]
    sent = {use.number for use in uses if not use.is_wait}
    for use in uses if None not in sent else ():
        if use.is_wait and use.number is not None and use.number not in sent:
            collector.report(NO_PROGRAM_SENDS_SIGNAL, use.span, use.line, id=use.number)


def _report_axes(programs: Sequence[ProgramUses], collector: Collector) -> None:
    for program in programs:
        for use in program.exchanges:
            for number in use.fetched:
                owner = program.owners.get(number or 0, program.channel)
                if owner == program.channel or number is None:
                    continue
                if not any(_gives(other, number) for other in programs):
                    collector.report(
                        NO_PROGRAM_GIVES_AXIS, use.span, use.line, number=number, channel=owner
                    )


def _gives(program: ProgramUses, number: int) -> bool:
    """Return whether a program may give the axis with a logical number."""
    for use in program.exchanges:
        if use.gives_others and number not in use.fetched:
            return True
        if number in use.given_numbers or None in use.given_numbers:
            return True
        if any(program.own_names.get(name, number) == number for name in use.given_names):
            return True
    return False


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
