# SPDX-License-Identifier: MIT
"""Reads and checks a program's text once from start to end -> its outline and all its mistakes.

In: a ``Source``. Out: ``ProgramText`` and the diagnostics of parser and checker in the order of the
text. At most one statement is in memory at a time, so a program of any length can be checked.

Long programs come from CAM systems: blocks of letters and numbers in few shapes. The check of such
a block depends on its letters and on the numbers of its functions, never on the values of its axis
words; a shape without mistakes is therefore checked only once. The same holds for statements whose
check is decided by their shape (``shape_checks.py``).
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

from nctakt.base.diagnostics import Diagnostic, Message, Severity, Span
from nctakt.base.text import close_names
from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.messages import Collector
from nctakt.messages.checked_blocks import NOT_NC_TEXT
from nctakt.messages.program_structure import (
    DUPLICATE_LABEL,
    DUPLICATE_LOCAL_SUBPROGRAM,
    JUMP_INTO_LOOP,
    UNKNOWN_LABEL,
    UNKNOWN_LOCAL_SUBPROGRAM,
)
from nctakt.nc.check.branches import realtime_cycles
from nctakt.nc.check.checker import Checker, Role, ends
from nctakt.nc.fast.plain_lines import PlainScanner, shape_code
from nctakt.nc.fast.shapes import Shape
from nctakt.nc.outline import ProgramText, Section, labels_in
from nctakt.nc.parse.parser import StatementReader, sections
from nctakt.nc.source import Source
from nctakt.nc.tree import (
    AxisWord,
    Block,
    Number,
    ProgramStart,
    Statement,
    StringLiteral,
    SubprogramCall,
    Word,
)
from nctakt.nc.vocabulary.functions import ENDS, PLAIN_MOTIONS, PROGRAM_ENDS
from nctakt.nc.vocabulary.variable_table import NameTable

#: Words whose values do not matter for the check.
_FREE_WORDS = ("F",)

#: Statements between two calls of ``poll``.
STATEMENTS_PER_POLL = 1000

PlainShape = tuple[str | float, ...]


class Watcher(Protocol):
    """Observer of the statements that are checked."""

    @property
    def sees_each_block(self) -> bool:
        """Whether it is called with plain blocks whose shape has been checked before, too."""

    def section(self, *, is_main: bool) -> None:
        """Called when a main program or subprogram begins."""

    def statement(self, statement: Statement) -> None:
        """Called with each statement that may run."""


def inspect(
    source: Source,
    names: NameTable,
    channel: ChannelParameters,
    collector: Collector,
    *,
    role: Role = "main",
    watcher: Watcher | None = None,
    poll: Callable[[], None] | None = None,
) -> ProgramText:
    """Read and check a program with its local subprograms, each up to its end.

    ``role``: whether M17 or M30 ends it. Behind the end only the targets of jumps are checked.
    ``poll`` is called at regular intervals.
    """
    unsorted = Collector()
    checker = Checker(source, names, channel, unsorted)
    sequel = _ProgramInspector(source, checker, plain_scanner(channel), unsorted, role, watcher)
    statements = StatementReader(source, unsorted)
    for count, (line, section, statement) in enumerate(sections(source, statements, unsorted)):
        if poll is not None and count % STATEMENTS_PER_POLL == 0:
            poll()
        sequel.take(line, section, statement)
        sequel.skip_known(statements, poll)
    program = sequel.finish()
    unsorted.diagnostics.sort(key=_position)
    collector.diagnostics += _named(_without_redundant(unsorted.diagnostics))
    return program


def plain_scanner(channel: ChannelParameters) -> PlainScanner:
    """Return the scanner of plain blocks of a channel; axes with the name of a spindle are left
    out.
    """
    spindles = [spindle.name for spindle in channel.spindles]
    return PlainScanner(["" if axis.name in spindles else axis.name for axis in channel.axes])


def _without_redundant(diagnostics: list[Diagnostic]) -> list[Diagnostic]:
    """Return the diagnostics without "not NC text" where another one explains the same line."""
    explained_lines = {
        diagnostic.span.line
        for diagnostic in diagnostics
        if diagnostic.span is not None and diagnostic.message is not NOT_NC_TEXT
    }
    return [
        diagnostic
        for diagnostic in diagnostics
        if diagnostic.message is not NOT_NC_TEXT
        or diagnostic.span is None
        or diagnostic.span.line not in explained_lines
    ]


def _named(diagnostics: list[Diagnostic]) -> list[Diagnostic]:
    """Return the diagnostics, with slips of newcomers in place of general errors."""
    if not any(item.message.severity is Severity.ERROR for item in diagnostics):
        return diagnostics
    from nctakt.nc.slips.naming import name_slips  # noqa: PLC0415 - only after a mistake

    return name_slips(diagnostics)


class _ProgramInspector:
    """Checks statement by statement up to the end of each section."""

    def __init__(
        self,
        source: Source,
        checker: Checker,
        scanner: PlainScanner,
        collector: Collector,
        role: Role,
        watcher: Watcher | None,
    ) -> None:
        main = Section("", Span(source.file, 1, 1, 2), 1, False)
        self._program = ProgramText(source, main)
        self._section: Section | None = main
        self._number = 0
        self._source = source
        self._checker = checker
        self._scanner = scanner
        self._watcher = watcher
        self._sees_each_block = watcher is not None and watcher.sees_each_block
        self._collector = collector
        self._found = collector.diagnostics
        self._role = role
        self._ended = False
        self._empty = True
        self._in_order: dict[PlainShape, None] = {}
        self._plain_in_order: set[int] = set()
        self._local_calls: list[SubprogramCall] = []
        #: The next statement: its line, its shape, and the number of diagnostics before it.
        self._new: tuple[int, Shape, int] | None = None

    def take(self, line: int, number: int, statement: Statement) -> None:
        """Add and check the next statement; ``number`` is its section."""
        if isinstance(statement, ProgramStart):
            self._begin(line, number, statement)
            return
        if self._section is None:
            return
        if number == 0 and self._empty:
            self._section.first_line = line
            self._begin_check()
        self._empty = False
        self._section.add(line, statement)
        if not self._is_checked(statement):
            return
        if isinstance(statement, Block):
            self._block(statement)
        else:
            self._check(statement)
        self._remember(line)

    def skip_known(
        self, statements: StatementReader, poll: Callable[[], None] | None = None
    ) -> None:
        """Skip lines of known valid shapes while statements are not kept.

        ``poll`` is called for each group of lines.
        """
        self._new = None
        if self._section is None or self._section.kept is not None or self._sees_each_block:
            return
        lines = statements.lines
        templates = self._program.templates
        while lines is not None and lines.more():
            if poll is not None and lines.index == 0:
                poll()
            lines.index = self._scanner.skip_known(lines.group, lines.index, self._plain_in_order)
            if self._watcher is not None and lines.index < len(lines.group):
                return
            first = lines.index
            lines.index = templates.skip_known(lines.group, first)
            if lines.index == first < len(lines.group):
                shape = templates.scanner.shape
                if shape is not None:
                    self._new = (lines.number, shape, len(self._found))
                return

    def _remember(self, line: int) -> None:
        """Mark the shape of the statement just checked as valid if nothing was found."""
        if self._new is None:
            return
        begin, shape, count = self._new
        if begin == line and count == len(self._found):
            self._program.templates.mark_valid(shape)

    def _begin(self, line: int, number: int, start: ProgramStart) -> None:
        self._end_section()
        self._number = number
        self._section = None
        if number == 0:
            self._section = self._program.main = Section(start.name, start.span, line, False)
        elif number > 0:
            self._section = Section(start.name, start.span, line, True)
            first = self._program.subprograms.setdefault(start.name, self._section)
            if first is not self._section:
                self._report(
                    DUPLICATE_LOCAL_SUBPROGRAM, start.span, name=start.name, line=first.span.line
                )
        self._empty = False
        if self._section is not None:
            self._begin_check()

    def _begin_check(self) -> None:
        self._checker.begin("called" if self._number > 0 else self._role)
        self._ended = False
        if self._watcher is not None:
            self._watcher.section(is_main=self._number == 0)

    # --- statements ------------------------------------------------------------------------------

    def _block(self, block: Block) -> None:
        shape = _shape(block)
        if shape in self._in_order:
            if self._watcher is not None and self._sees_each_block:
                self._watcher.statement(block)
            return
        before = len(self._found)
        self._check(block)
        is_main = self._number == 0 and self._role == "main"
        numbers = PROGRAM_ENDS if is_main else ENDS
        self._ended = ends(block, numbers)
        if shape is not None and len(self._found) == before:
            self._in_order[shape] = None
            self._plain_in_order.add(shape_code(shape))

    def _is_checked(self, statement: Statement) -> bool:
        """Return whether the statement can run: before the end of its section, or reached by a
        jump.
        """
        if self._ended and any(label in self._checker.targets for label, _ in labels_in(statement)):
            self._ended = False
        return not self._ended

    def _check(self, statement: Statement) -> None:
        self._checker.statement(statement)
        self._program.cycles += realtime_cycles((statement,))
        for call in self._checker.take_calls():
            if call.local:
                self._local_calls.append(call)
            else:
                self._program.calls.append(call)
        if self._watcher is not None:
            self._watcher.statement(statement)

    # --- what only the end of a section or of the text shows --------------------------------------

    def _end_section(self) -> None:
        section = self._section
        if section is None:
            return
        for label, spans in self._checker.targets.items():
            for span in spans:
                if label in section.doubled:
                    self._report(DUPLICATE_LABEL, span, label=label)
                elif label in section.loop_labels:
                    self._report(JUMP_INTO_LOOP, span, label=label)
                elif label not in section.labels:
                    near = close_names(label, section.labels, 0.0)
                    self._report(UNKNOWN_LABEL, span, label=label, nearest=near[0] if near else "–")
        self._checker.targets = {}

    def finish(self) -> ProgramText:
        """End the text; return the program after the checks of labels and local calls."""
        self._end_section()
        subprograms = self._program.subprograms
        for call in self._local_calls:
            assert isinstance(call.name, StringLiteral)
            name = call.name.value
            if name not in subprograms:
                near = close_names(name, subprograms, 0.0)
                self._report(
                    UNKNOWN_LOCAL_SUBPROGRAM, call.span, name=name, nearest=near[0] if near else "–"
                )
        return self._program

    def _report(self, message: Message, span: Span, **values: object) -> None:
        self._collector.report(message, span, self._source.line_of(span), **values)


def _shape(block: Block) -> PlainShape | None:
    """Return all that the check of a plain block depends on; ``None`` if it depends on more.

    G functions change the meaning of later blocks, M functions may end the program, and a block
    number may be computed: only blocks of axis words, F above 0, G00 and G01 have a shape.
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
        if word.name == "F" and word.value.value <= 0.0:
            return None
        if word.name not in _FREE_WORDS:
            if word.name != "G" or word.value.value not in PLAIN_MOTIONS:
                return None
            shape.append(word.value.value)
    return tuple(shape)


def _position(diagnostic: Diagnostic) -> tuple[int, int]:
    span = diagnostic.span
    return (span.line, span.column) if span is not None else (0, 0)
