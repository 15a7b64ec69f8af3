# SPDX-License-Identifier: MIT
"""One program -> everything that can be told of it, statement by statement.

In: its text. Out: diagnostics of parser, checker and lint in the order of the text, and what it
does with GLOBAL realtime cycles. No more than one statement is in memory at a time, so a program of
any length can be checked.
"""

from __future__ import annotations

from pathlib import Path

from nctakt.diagnostics import Diagnostic
from nctakt.lists.channel_configuration import ChannelParameters
from nctakt.loading import find_program, missing, search_folders
from nctakt.messages import Collector
from nctakt.nc.inspection import inspect
from nctakt.nc.lint import GlobalCycles, Linter
from nctakt.nc.lint_cycle import Budget
from nctakt.nc.names import NameTable
from nctakt.nc.source import Source
from nctakt.nc.syntax import StringLiteral


def check_program(
    source: Source,
    names: NameTable,
    channel: ChannelParameters,
    budget: Budget,
    collector: Collector,
    machine_folder: Path = Path(),
) -> GlobalCycles:
    """Check a program with its local subprograms, each up to its end.

    Whether it is a main program or is called by others nobody knows; the files that it calls
    itself have to be there.
    """
    found = Collector()
    linter = Linter(source, names, budget, found)
    program = inspect(source, names, channel, found, role="either", watcher=linter)
    for call in program.calls:
        assert isinstance(call.name, StringLiteral)
        folders = search_folders(source.file, channel, machine_folder)
        if find_program(call.name.value, folders) is None:
            line = source.line_of(call.span)
            found.diagnostics.append(missing(call.name.value, folders, call.span, line))
    found.diagnostics.sort(key=_place)
    collector.diagnostics += found.diagnostics
    return linter.global_cycles


def _place(diagnostic: Diagnostic) -> tuple[int, int]:
    span = diagnostic.span
    return (span.line, span.column) if span is not None else (0, 0)
