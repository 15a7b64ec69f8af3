# SPDX-License-Identifier: MIT
"""One program -> its diagnostics, statement by statement.

In: its text. Out: diagnostics of parser, checker, lint and of the expectations in its comments, in
the order of the text, the files that it calls, and its GLOBAL realtime cycles. Only one statement
is in memory at a time, so that a program of any length can be checked.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Span
from nctakt.checking.check_memory import FileMemory, Poll
from nctakt.checking.program_pass import ProgramChannel, ProgramPass
from nctakt.files.access import FileAccess
from nctakt.messages import Collector, diagnostic
from nctakt.messages.programs.program_structure import PROGRAM_ENDS_AS_SUBPROGRAM
from nctakt.nc.check.findings import Findings
from nctakt.nc.inspection import polled
from nctakt.nc.lint.cycle_uses import CycleUse
from nctakt.nc.lint.linter import GlobalCycles
from nctakt.nc.outline import AxisUse, SignalUse
from nctakt.nc.source import Source
from nctakt.run.program_loader import find_program, missing, search_folders
from nctakt.testing.expectations import Script, parse_script


@dataclass(frozen=True, slots=True)
class Checked:
    """The links of a checked program to others: its GLOBAL cycles, the files that it calls.

    ``script``: the expectations in its comments, ``branch_lines``: the lines of its branches.
    ``signals`` and ``exchanges``: the signals and axes it sends, awaits, fetches and gives.
    ``subprogram_end``: a note that it ends as a subprogram, where it may also be a main program.
    ``cycles``: those that it defines and starts. ``is_complete``: it has an end, and all files that
    it calls are there.
    """

    global_cycles: GlobalCycles
    called: tuple[Path, ...]
    subprogram_end: Diagnostic | None
    signals: tuple[SignalUse, ...]
    exchanges: tuple[AxisUse, ...]
    cycles: tuple[CycleUse, ...]
    is_complete: bool
    script: Script
    branch_lines: frozenset[int]
    has_all_files: bool


def check_program(
    source: Source,
    channel: ProgramChannel,
    collector: Collector,
    machine_folder: Path = Path(),
    *,
    access: FileAccess,
    poll: Poll | None = None,
    memory: FileMemory | None = None,
) -> Checked:
    """Check a program with its local subprograms and return its links to others.

    ``access`` admits the files that may be read. ``poll`` is called at regular intervals.
    ``memory``: the state kept of the program. Called files must exist, as well as those that the
    channel list runs with each main program.
    """
    if memory is not None:
        reading = memory.of_channel(channel).read(source, poll)
    else:
        reading = ProgramPass(source, channel)
        reading.inspection.read(polled(poll))
    found = [*reading.of_lint.diagnostics, *reading.inspection.finish()]
    ends = reading.path.subprogram_ends
    if channel.role == "main" or not ends:
        found += reading.of_path.diagnostics
    calls = [(call.name, call.span) for call in reading.inspection.program.calls]
    if channel.role != "called":
        calls += [
            (name, reading.inspection.main) for name in channel.parameters.implicit_programs.names
        ]
    folders = search_folders(source.file, channel.parameters, machine_folder)
    called, lost = _called(calls, folders, access, source)
    found += [item for item in lost if not _has(found, item)]
    marked = None if memory is None else memory.scripts.of(source.lines)
    script = parse_script(source, found, marked)
    found.sort(key=_position)
    collector.diagnostics += found
    note = None
    if channel.role == "either" and ends:
        line, word = source.line_of(ends[-1]), Findings(source, collector).written(ends[-1])
        note = diagnostic(PROGRAM_ENDS_AS_SUBPROGRAM, ends[-1], line, word=word)
    return _checked(reading, tuple(called), note, script, has_all_files=not lost)


def _checked(
    reading: ProgramPass,
    called: tuple[Path, ...],
    subprogram_end: Diagnostic | None,
    script: Script,
    *,
    has_all_files: bool,
) -> Checked:
    """Return the links of a program that has been read to its end."""
    program = reading.inspection.program
    return Checked(
        reading.linter.global_cycles,
        called,
        subprogram_end,
        tuple(program.signals),
        tuple(program.exchanges),
        tuple(reading.linter.cycle_uses),
        reading.inspection.state.has_ended and has_all_files,
        script,
        frozenset(reading.branch_lines),
        has_all_files,
    )


def _called(
    calls: Sequence[tuple[str, Span]], folders: list[Path], access: FileAccess, source: Source
) -> tuple[dict[Path, None], list[Diagnostic]]:
    """Return the files that are called, and the diagnostics of those that are missing."""
    called: dict[Path, None] = {}
    lost: list[Diagnostic] = []
    for name, span in calls:
        path = find_program(name, folders, access)
        if path is not None:
            called[path] = None
        else:
            error = missing(name, folders, access, span, source.line_of(span))
            if not _has(lost, error):
                lost.append(error)
    return called, lost


def _has(found: Sequence[Diagnostic], other: Diagnostic) -> bool:
    """Return whether a message has been found at its position."""
    return any(item.message is other.message and item.span == other.span for item in found)


def _position(diagnostic: Diagnostic) -> tuple[int, int]:
    span = diagnostic.span
    return (span.line, span.column) if span is not None else (0, 0)
