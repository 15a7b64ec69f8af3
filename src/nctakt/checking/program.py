# SPDX-License-Identifier: MIT
"""One program -> its diagnostics, statement by statement.

In: its text. Out: diagnostics of parser, checker, lint and of the expectations in its comments, in
the order of the text, the files that it calls, and its GLOBAL realtime cycles. Only one statement
is in memory at a time, so that a program of any length can be checked.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from types import MappingProxyType

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Span
from nctakt.checking.path_checker import MAX_LINES, PathChecker
from nctakt.files.access import FileAccess
from nctakt.lists.declared.tools import Tool
from nctakt.lists.machine.axis_configuration import AxisConfiguration
from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.messages import Collector, diagnostic
from nctakt.messages.program_structure import PROGRAM_ENDS_AS_SUBPROGRAM
from nctakt.nc.check.blocks import Role
from nctakt.nc.check.branches import branch_outlines
from nctakt.nc.check.findings import Findings
from nctakt.nc.inspection import inspect
from nctakt.nc.lint.linter import GlobalCycles, Linter
from nctakt.nc.lint.realtime_cycles import StepLimits
from nctakt.nc.source import Source
from nctakt.nc.tree import Statement, StringLiteral
from nctakt.nc.vocabulary.variable_table import NameTable
from nctakt.run.program_loader import find_program, missing, search_folders
from nctakt.testing.expectations import impossible_firings, parse_script


@dataclass(frozen=True, slots=True)
class Checked:
    """The links of a checked program to others: its GLOBAL cycles, the files that it calls.

    ``subprogram_end``: a note that it ends as a subprogram, where it may also be a main program.
    """

    global_cycles: GlobalCycles
    called: tuple[Path, ...]
    subprogram_end: Diagnostic | None


@dataclass(frozen=True, slots=True)
class _Watchers:
    """The linter and the checker of the path, which see the same statements."""

    linter: Linter
    path: PathChecker
    sees_each_block: bool

    def section(self, *, is_main: bool) -> None:
        """Begin a main program or a subprogram."""
        self.linter.section()
        self.path.section(is_main=is_main)

    def statement(self, statement: Statement) -> None:
        """Visit a statement; the path of a long program is not followed."""
        self.linter.statement(statement)
        if self.sees_each_block:
            self.path.statement(statement)


def check_program(
    source: Source,
    names: NameTable,
    channel: ChannelParameters,
    limits: StepLimits,
    collector: Collector,
    machine_folder: Path = Path(),
    *,
    access: FileAccess,
    tools: Mapping[int, Tool],
    role: Role = "either",
    axes: Mapping[str, AxisConfiguration] = MappingProxyType({}),
    is_shifted: bool = False,
    poll: Callable[[], None] | None = None,
) -> Checked:
    """Check a program with its local subprograms and return its links to others.

    ``access`` admits the files that may be read. ``tools``, ``axes``: those of the channel.
    ``is_shifted``: offsets act from the start. ``role``: ``called`` if it is only called by others.
    ``poll`` is called at regular intervals.
    Called files must exist, as well as those that the channel list runs with each main program.
    """
    program_diagnostics = Collector()
    linter = Linter(source, names, limits, program_diagnostics, tools, channel.tool_selection)
    of_path = Collector()
    path_checker = PathChecker(
        channel, axes, Findings(source, of_path), begins=role != "called", is_shifted=is_shifted
    )
    watcher = _Watchers(linter, path_checker, sees_each_block=len(source.lines) <= MAX_LINES)
    program = inspect(
        source, names, channel, program_diagnostics, role=role, watcher=watcher, poll=poll
    )
    if role == "main" or path_checker.subprogram_end is None:
        program_diagnostics.diagnostics += of_path.diagnostics
    calls: list[tuple[str, Span]] = []
    for call in program.calls:
        assert isinstance(call.name, StringLiteral)
        calls.append((call.name.value, call.span))
    if role != "called":
        calls += [(name, program.main.span) for name in channel.implicit_programs.names]
    folders = search_folders(source.file, channel, machine_folder)
    called: dict[Path, None] = {}
    for name, span in calls:
        path = find_program(name, folders, access)
        if path is None:
            line = source.line_of(span)
            program_diagnostics.diagnostics.append(missing(name, folders, access, span, line))
        else:
            called[path] = None
    of_comments = program_diagnostics.diagnostics
    script = parse_script(source, of_comments)
    if not calls:  # a line may be one of a called file
        branches = [branch for cycle in program.cycles for branch in branch_outlines(cycle)]
        of_comments += impossible_firings(script, source, {one.span.line for one in branches})
    program_diagnostics.diagnostics.sort(key=_position)
    collector.diagnostics += program_diagnostics.diagnostics
    end, note = path_checker.subprogram_end, None
    if role == "either" and end is not None:
        line, word = source.line_of(end.span), Findings(source, collector).written(end.span)
        note = diagnostic(PROGRAM_ENDS_AS_SUBPROGRAM, end.span, line, word=word)
    return Checked(linter.global_cycles, tuple(called), note)


def _position(diagnostic: Diagnostic) -> tuple[int, int]:
    span = diagnostic.span
    return (span.line, span.column) if span is not None else (0, 0)
