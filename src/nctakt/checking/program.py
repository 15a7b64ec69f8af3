# SPDX-License-Identifier: MIT
"""One program -> everything that can be told of it, statement by statement.

In: its text. Out: diagnostics of parser, checker and lint in the order of the text, and what it
does with GLOBAL realtime cycles. No more than one statement is in memory at a time, so a program of
any length can be checked.

Long programs come from CAM systems: blocks of letters and numbers, few shapes of them. What is
checked of such a block depends on its letters and on the numbers of its functions, never on how far
its axes go; so a shape that was found in order is not checked again.
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
from nctakt.nc.syntax import AxisWord, Block, Number, ProgramStart, Statement, Word

#: Words whose numbers mean nothing for a check.
_FREE_WORDS = ("F",)

Shape = tuple[str | float, ...]


def check_program(
    source: Source,
    names: NameTable,
    channel: ChannelParameters,
    budget: Budget,
    collector: Collector,
) -> GlobalCycles:
    """Check a program with its local subprograms, each up to its end."""
    found = Collector()
    sequel = _Sequel(
        Checker(source, names, channel, found), Linter(source, names, budget, found), found
    )
    for section, statement in sections(source, parse(source, found), found):
        if isinstance(statement, ProgramStart):
            sequel.begin(section)
        else:
            sequel.check(statement)
    found.diagnostics.sort(key=_place)
    collector.diagnostics += found.diagnostics
    return sequel.linter.global_cycles


class _Sequel:
    """Checks statement after statement up to the end of their section."""

    def __init__(self, checker: Checker, linter: Linter, found: Collector) -> None:
        self.linter = linter
        self._checker = checker
        self._found = found.diagnostics
        self._in_main = True
        self._ended = False
        self._in_order: dict[Shape, None] = {}

    def begin(self, section: int) -> None:
        """A main program (0) or subprogram begins, or what never runs (-1)."""
        self.linter.section()
        self._in_main = section == 0
        self._ended = section < 0

    def check(self, statement: Statement) -> None:
        """The next statement."""
        if self._ended:
            return
        shape = _shape(statement) if isinstance(statement, Block) else None
        if shape in self._in_order:
            return
        before = len(self._found)
        (self._checker.main_program if self._in_main else self._checker.subprogram)((statement,))
        self.linter.statement(statement)
        self._ended = ends(statement, PROGRAM_ENDS if self._in_main else SUBPROGRAM_ENDS)
        if shape is not None and len(self._found) == before:
            self._in_order[shape] = None


def _shape(block: Block) -> Shape | None:
    """What a check of the block depends on; ``None`` where that is more than its words tell.

    G functions change what comes after them, M functions may end the program, and the number of a
    block may be computed: only blocks of axis words, F and G00 to G03 have a shape.
    """
    if block.head.number is not None and not isinstance(block.head.number, Number):
        return None
    shape: list[str | float] = []
    for word in block.words:
        if not isinstance(word, AxisWord | Word) or not isinstance(word.value, Number):
            return None
        shape.append(word.name)
        if isinstance(word, AxisWord):
            continue
        if word.additional is not None or word.arguments:
            return None
        if word.name not in _FREE_WORDS:
            if word.name != "G" or word.value.value > 3:
                return None
            shape.append(word.value.value)
    return tuple(shape)


def _place(diagnostic: Diagnostic) -> tuple[int, int]:
    span = diagnostic.span
    return (span.line, span.column) if span is not None else (0, 0)
