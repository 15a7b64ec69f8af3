# SPDX-License-Identifier: MIT
"""Reads and checks a program's text once from start to end -> its outline and all its mistakes.

In: a ``Source``. Out: ``ProgramText`` and the diagnostics of parser and checker in the order of the
text. At most one statement is in memory at a time, so a program of any length can be checked.

``Inspection`` can stop between two statements and continue from the state there, so that an editor
rereads only part of a program after a change.

Long programs come from CAM systems: blocks of letters and numbers in few shapes. The check of such
a block depends on its letters and on the numbers of its functions, never on the values of its axis
words; a shape without mistakes is therefore checked only once. The same holds for statements whose
check is decided by their shape (``shape_checks.py``).
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from typing import Protocol

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import NOTHING, Diagnostic, Message, Severity, Span
from nctakt.base.line_shift import LineShift
from nctakt.base.misspelling import nearest
from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.messages import Collector
from nctakt.messages.programs.checked_blocks import NOT_NC_TEXT
from nctakt.messages.programs.program_structure import (
    DUPLICATE_LABEL,
    DUPLICATE_LOCAL_SUBPROGRAM,
    JUMP_INTO_LOOP,
    UNKNOWN_LABEL,
    UNKNOWN_LOCAL_SUBPROGRAM,
)
from nctakt.nc.check.checker import Checker, CheckerState, Role, ends
from nctakt.nc.check.cycles.branches import realtime_cycles
from nctakt.nc.fast.plain_lines import PlainScanner
from nctakt.nc.fast.shapes import Shape
from nctakt.nc.outline import Call, Labels, ProgramText, Section, labels_in
from nctakt.nc.parse.parser import CounterState, ReaderState, SectionCounter, StatementReader
from nctakt.nc.plain_shapes import PlainShapes, plain_shape
from nctakt.nc.source import Source
from nctakt.nc.tree import (
    Block,
    ProgramStart,
    Statement,
    StringLiteral,
)
from nctakt.nc.vocabulary.functions import ENDS, PROGRAM_ENDS
from nctakt.nc.vocabulary.variables.variable_table import NameTable

#: A label that is the number of a block; any other is a name in brackets.
_BLOCK_NUMBER = re.compile(r"N\d+")
#: Lines between two calls of ``poll``.
LINES_PER_POLL = 10_000

#: Statements between two pauses of a check.
STATEMENTS_PER_PAUSE = 50


#: Called with the number of the next line; returns the line of the next call, 0 to stop there.
Pause = Callable[[int], int]


class Watcher(Protocol):
    """Observer of the statements that are checked."""

    @property
    def sees_next_block(self) -> bool:
        """Whether it is called with a plain block whose shape has been checked before, too."""

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
    poll: Callable[[], None] | None = None,
    named_programs: Iterable[str] = (),
) -> ProgramText:
    """Read and check a program with its local subprograms, each up to its end.

    ``role``: whether M17 or M30 ends it. After the end only the targets of jumps are checked.
    ``poll`` is called at regular intervals. ``named_programs``: the words whose program callers
    have named by ``#FILE NAME``.
    """
    inspection = Inspection(source, names, channel, role, named_programs=named_programs)
    inspection.read(polled(poll))
    collector.diagnostics += inspection.finish()
    return inspection.program


def polled(poll: Callable[[], None] | None) -> Pause:
    """Return a pause that calls ``poll`` at regular intervals."""

    def pause(line: int) -> int:
        if poll is not None:
            poll()
        return line + LINES_PER_POLL

    return pause


def plain_scanner(channel: ChannelParameters, axes: Iterable[str]) -> PlainScanner:
    """Return the scanner of plain blocks of a channel with these ``axes``; those with the name of
    a spindle are left out.
    """
    spindles = channel.spindle_names
    return PlainScanner(["" if name in spindles else name for name in axes])


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


@dataclass(frozen=True, slots=True)
class InspectionState:
    """The state of an ``Inspection`` between two statements.

    ``main``: where the main program begins with ``%``. ``subprograms``: where local subprograms
    begin, by name. ``number``: of the section, ``labels``: its labels, ``None`` in one that never
    runs. ``is_empty``: nothing has been read; ``has_ended``: the section's end has been reached.
    """

    reader: ReaderState
    counter: CounterState
    main: Span | None
    subprograms: Mapping[str, Span]
    number: int
    labels: Labels | None
    is_empty: bool
    has_ended: bool
    checker: CheckerState

    @property
    def size(self) -> int:
        """How many values are in it."""
        labels = 0 if self.labels is None else self.labels.size
        return labels + len(self.subprograms) + self.checker.size

    def shifted(self, shift: LineShift) -> InspectionState:
        """Return it for a text with other lines; raises ``ReplacedLine``."""
        return replace(
            self,
            main=None if self.main is None else shift.span(self.main),
            subprograms={name: shift.span(span) for name, span in self.subprograms.items()},
            labels=None if self.labels is None else self.labels.shifted(shift),
            checker=self.checker.shifted(shift),
        )


class Inspection:
    """Checks statement by statement up to the end of each section.

    ``program`` has all sections only if the whole text was read. ``keeps_statements``: it will run,
    so that short sections and realtime cycles are kept. ``shapes``: those that another text of the
    channel has shown to be valid. ``found``: the mistakes in the order of discovery.
    """

    def __init__(
        self,
        source: Source,
        names: NameTable,
        channel: ChannelParameters,
        role: Role = "main",
        watcher: Watcher | None = None,
        shapes: PlainShapes | None = None,
        *,
        keeps_statements: bool = True,
        named_programs: Iterable[str] = (),
    ) -> None:
        self._collector = Collector()
        self.found = self._collector.diagnostics
        self._source = source
        self._checker = Checker(source, names, channel, self._collector, named_programs)
        self._scanner = plain_scanner(channel, [axis.name for axis in channel.axes])
        self._role = role
        self._watcher = watcher
        self._keeps = keeps_statements
        self._shapes = PlainShapes() if shapes is None else shapes
        main = self._new_section("", Span(source.file, 1, 1, 2), 1, is_local=False)
        self.program = ProgramText(source, main)
        self._section: Section | None = main
        self._main: Span | None = None
        self._subprograms: dict[str, Span] = {}
        self._number = 0
        self._has_ended = False
        self._is_empty = True
        self.local_calls: list[Call] = []
        self._statements = StatementReader(source, self._collector)
        self._counter = SectionCounter(source, self._collector)
        #: The next statement: its line, its shape, and the number of diagnostics before it.
        self._new: tuple[int, Shape, int] | None = None

    def _new_section(self, name: str, span: Span, line: int, *, is_local: bool) -> Section:
        section = Section(name, span, line, is_local)
        if not self._keeps:
            section.kept = None
        return section

    @property
    def main(self) -> Span:
        """Where the main program begins."""
        return self.program.main.span if self._main is None else self._main

    @property
    def state(self) -> InspectionState:
        """State that the check of later statements depends on; only in a pause of ``read``."""
        section = self._section
        return InspectionState(
            self._statements.state,
            self._counter.state,
            self._main,
            dict(self._subprograms),
            self._number,
            None if section is None else section.labels.copy(),
            self._is_empty,
            self._has_ended,
            self._checker.state,
        )

    def resume(self, state: InspectionState, line: int) -> None:
        """Continue from a state before a line."""
        self._statements = StatementReader(self._source, self._collector, line)
        self._statements.resume(state.reader)
        self._counter.state = state.counter
        self._main = state.main
        self._subprograms = dict(state.subprograms)
        self._number = state.number
        self._section = None
        if state.labels is not None:
            self._section = self.program.main
            self._section.labels = state.labels.copy()
        self._is_empty = state.is_empty
        self._has_ended = state.has_ended
        self._checker.resume(state.checker)

    def read(self, pause: Pause) -> None:
        """Read and check up to the end, or until ``pause`` ends it between two statements.

        ``pause`` is called before the first statement, and then after the line that it returned,
        or after ``STATEMENTS_PER_PAUSE`` statements. It returns 0 to end.
        """
        stop, since_pause = 0, STATEMENTS_PER_PAUSE
        while True:
            self._skip_known(stop)
            lines = self._statements.lines
            if lines is not None and lines.more():
                while lines.number >= stop or since_pause >= STATEMENTS_PER_PAUSE:
                    stop, since_pause = pause(lines.number), 0
                    if not stop:
                        return
                    self._skip_known(stop)
                    if not lines.more():
                        break
            following = next(self._statements, None)
            if following is None:
                return
            line, statement = following
            number = self._counter.of(statement)
            if number is not None:
                self._take(line, number, statement)
            since_pause += 1

    def _take(self, line: int, number: int, statement: Statement) -> None:
        """Add and check the next statement; ``number`` is its section."""
        if isinstance(statement, ProgramStart):
            self._begin(line, number, statement)
            return
        if self._section is None:
            return
        if number == 0 and self._is_empty:
            if self._keeps:
                self._section.first_line = line
            self._begin_check()
        self._is_empty = False
        self._section.add(line, statement)
        if not self._is_checked(statement):
            return
        if isinstance(statement, Block):
            self._block(statement)
        else:
            self._check(statement)
        self._remember(line)

    def _skip_known(self, stop: int) -> None:
        """Skip lines of known valid shapes, up to line ``stop``, while statements are not kept."""
        self._new = None
        lines = self._statements.lines
        if lines is None or self._is_empty:
            return
        if self._section is None or self._section.kept is not None:
            return
        watcher = self._watcher
        if watcher is not None and watcher.sees_next_block:
            return
        templates = self.program.templates
        while lines.more():
            end = min(len(lines.group), lines.index + max(0, stop - lines.number))
            codes = self._shapes.codes
            lines.index = self._scanner.skip_known(lines.group, lines.index, end, codes)
            if lines.number >= stop or (watcher is not None and lines.index < end):
                return
            if watcher is not None:
                continue
            first = lines.index
            lines.index = templates.skip_known(lines.group, first)
            if lines.index == first < len(lines.group):
                shape = templates.scanner.shape
                if shape is not None:
                    self._new = (lines.number, shape, len(self.found))
                return

    def _remember(self, line: int) -> None:
        """Mark the shape of the statement just checked as valid if nothing was found."""
        if self._new is None:
            return
        begin, shape, count = self._new
        if begin == line and count == len(self.found):
            self.program.templates.mark_valid(shape)

    def _begin(self, line: int, number: int, start: ProgramStart) -> None:
        self._end_section()
        self._number = number
        self._section = None
        if number == 0:
            self._main = start.span
            self._section = self._new_section(start.name, start.span, line, is_local=False)
            self.program.main = self._section
        elif number > 0:
            self._section = self._new_section(start.name, start.span, line, is_local=True)
            if start.name not in self._subprograms:
                self._subprograms[start.name] = start.span
                self.program.subprograms[start.name] = self._section
            else:
                first = self._subprograms[start.name].line
                self._report(DUPLICATE_LOCAL_SUBPROGRAM, start.span, name=start.name, line=first)
        self._is_empty = False
        if self._section is not None:
            self._begin_check()

    def _begin_check(self) -> None:
        self._checker.begin("called" if self._number > 0 else self._role)
        self._has_ended = False
        if self._watcher is not None:
            self._watcher.section(is_main=self._number == 0)

    # --- statements ------------------------------------------------------------------------------

    def _block(self, block: Block) -> None:
        shape = plain_shape(block)
        if shape in self._shapes:
            if self._watcher is not None and self._watcher.sees_next_block:
                self._watcher.statement(block)
            return
        before = len(self.found)
        self._check(block)
        is_main = self._number == 0 and self._role == "main"
        numbers = PROGRAM_ENDS if is_main else ENDS
        self._has_ended = ends(block, numbers)
        if shape is not None and len(self.found) == before and not self._checker.has_fetched(shape):
            self._shapes.add(shape)

    def _is_checked(self, statement: Statement) -> bool:
        """Return whether the statement can run: before the end of its section, or reached by a
        jump.
        """
        if self._has_ended and any(
            label in self._checker.targets for label, _ in labels_in(statement)
        ):
            self._has_ended = False
        return not self._has_ended

    def _check(self, statement: Statement) -> None:
        self._checker.statement(statement)
        if self._keeps:
            self.program.cycles += realtime_cycles((statement,))
        for call in self._checker.take_calls():
            assert isinstance(call.name, StringLiteral)
            calls = self.local_calls if call.local else self.program.calls
            calls.append(Call(call.name.value, call.span))
        self.program.signals += self._checker.take_signals()
        self.program.joins_motions |= self._checker.joins_motions
        self.program.named_programs |= self._checker.named_programs
        self.program.exchanges += self._checker.take_exchanges()
        if self._watcher is not None:
            self._watcher.statement(statement)

    # --- findings at the end of a section or of the text ------------------------------------------

    def _end_section(self) -> None:
        section = self._section
        if section is None:
            return
        labels = section.labels
        for label, spans in self._checker.targets.items():
            for span in spans:
                if label in labels.doubled:
                    self._report(DUPLICATE_LABEL, span, label=label)
                elif label in labels.in_loops:
                    self._report(JUMP_INTO_LOOP, span, label=label)
                elif label not in labels.lines:
                    near = nearest(label, labels.lines) or NOTHING
                    form = f"{label}:" if _BLOCK_NUMBER.fullmatch(label) else f"[{label}]"
                    self._report(UNKNOWN_LABEL, span, label=label, nearest=near, form=form)
        self._checker.targets = {}

    def finish(self) -> list[Diagnostic]:
        """End the text; return all its mistakes in their order, with those of labels and calls.

        ``found`` is unchanged.
        """
        count = len(self.found)
        self._end_section()
        for call in self.local_calls:
            if call.name not in self._subprograms:
                near = nearest(call.name, self._subprograms) or NOTHING
                self._report(UNKNOWN_LOCAL_SUBPROGRAM, call.span, name=call.name, nearest=near)
        found = sorted(self.found, key=_position)
        del self.found[count:]
        return _named(_without_redundant(found))

    def _report(self, message: Message, span: Span, **values: object) -> None:
        self._collector.report(message, span, self._source.line_of(span), **values)


def _position(diagnostic: Diagnostic) -> tuple[int, int]:
    span = diagnostic.span
    return (span.line, span.column) if span is not None else (0, 0)
