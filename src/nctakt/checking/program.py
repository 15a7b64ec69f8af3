# SPDX-License-Identifier: MIT
"""One program -> everything that can be told of it, statement by statement.

In: its text. Out: diagnostics of parser, checker and lint in the order of the text, and what it
does with GLOBAL realtime cycles. No more than one statement is in memory at a time, so a program of
any length can be checked.
"""

from __future__ import annotations

from nctakt.diagnostics import Diagnostic
from nctakt.lists.channel_configuration import ChannelParameters
from nctakt.messages import Collector
from nctakt.nc.check import PROGRAM_ENDS, SUBPROGRAM_ENDS, Checker, ends
from nctakt.nc.lint import GlobalCycles, Linter
from nctakt.nc.lint_cycle import Budget
from nctakt.nc.names import NameTable
from nctakt.nc.parser import parse, sections
from nctakt.nc.source import Source
from nctakt.nc.syntax import ProgramStart


def check_program(
    source: Source,
    names: NameTable,
    channel: ChannelParameters,
    budget: Budget,
    collector: Collector,
) -> GlobalCycles:
    """Check a program with its local subprograms, each up to its end."""
    found = Collector()
    checker = Checker(source, names, channel, found)
    linter = Linter(source, names, budget, found)
    ended = False
    for section, statement in sections(source, parse(source, found), found):
        if isinstance(statement, ProgramStart):
            linter.section()
            ended = section < 0
        elif not ended:
            in_main = section == 0
            (checker.main_program if in_main else checker.subprogram)((statement,))
            linter.statement(statement)
            ended = ends(statement, PROGRAM_ENDS if in_main else SUBPROGRAM_ENDS)
    found.diagnostics.sort(key=_place)
    collector.diagnostics += found.diagnostics
    return linter.global_cycles


def _place(diagnostic: Diagnostic) -> tuple[int, int]:
    span = diagnostic.span
    return (span.line, span.column) if span is not None else (0, 0)
