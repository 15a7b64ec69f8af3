# SPDX-License-Identifier: MIT
"""The outline of a program: its sections, their labels, and how to reach them.

In: the statements of a text in the order of reading, each with its first line. Out: a
``ProgramText``, which yields the statements of a section from its start or from a label. A short
section is kept in memory; a long one is read again from that line, so that a program may be of any
length.
"""

from __future__ import annotations

from collections.abc import Iterator

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Span
from nctakt.base.line_shift import LineShift
from nctakt.messages import Collector
from nctakt.nc.fast.templates import Templates
from nctakt.nc.parse.parser import StatementReader
from nctakt.nc.source import LineReader, Source
from nctakt.nc.tree import (
    Do,
    For,
    If,
    ProgramStart,
    RealtimeCycle,
    RealtimeLoop,
    Repeat,
    Statement,
    Switch,
    While,
)

#: Maximum number of statements kept in memory; a longer section is read from its text each time.
KEPT_STATEMENTS = 1000


def bodies_of(statement: Statement) -> Iterator[tuple[Statement, ...]]:
    """Yield the branches of a structure in the order of the text; nothing for a block."""
    match statement:
        case If():
            yield statement.body
            for elseif in statement.elseifs:
                yield elseif.body
            yield statement.else_body or ()
        case Switch():
            for case in statement.cases:
                yield case.body
        case For() | While() | Do() | Repeat() | RealtimeLoop():
            yield statement.body


def is_loop(statement: Statement) -> bool:
    """Return whether a structure repeats its body; no jump may enter it."""
    return isinstance(statement, For | While | Do | Repeat | RealtimeLoop)


def labels_in(statement: Statement, in_loop: bool = False) -> Iterator[tuple[str, bool]]:
    """Yield the labels of a statement and of all statements inside it, and whether a loop
    encloses them.
    """
    if statement.head.label is not None:
        yield statement.head.label, in_loop
    in_loop = in_loop or is_loop(statement)
    for body in bodies_of(statement):
        for inner in body:
            yield from labels_in(inner, in_loop)


def leads_to(statement: Statement, label: str) -> bool:
    """Return whether a jump to this label leads to the statement or into it."""
    return any(name == label and not in_loop for name, in_loop in labels_in(statement))


@dataclass(slots=True)
class Labels:
    """The labels of a section.

    ``lines``: label -> first line of the statement that has or contains it; the first one counts.
    ``in_loops``: labels inside loops, which no jump may reach; ``doubled``: labels defined twice.
    """

    lines: dict[str, int] = field(default_factory=dict)
    in_loops: dict[str, None] = field(default_factory=dict)
    doubled: dict[str, None] = field(default_factory=dict)

    @property
    def size(self) -> int:
        """How many there are."""
        return len(self.lines) + len(self.in_loops)

    def add(self, line: int, statement: Statement) -> None:
        """Add those of a statement that begins in ``line``."""
        for label, in_loop in labels_in(statement):
            if label in self.lines or label in self.in_loops:
                self.doubled[label] = None
            elif in_loop:
                self.in_loops[label] = None
            else:
                self.lines[label] = line

    def copy(self) -> Labels:
        """Return a copy that later ones do not change."""
        return Labels(dict(self.lines), dict(self.in_loops), dict(self.doubled))

    def shifted(self, shift: LineShift) -> Labels:
        """Return them for a text with other lines; raises ``ReplacedLine``."""
        lines = {label: shift.line(line) for label, line in self.lines.items()}
        return Labels(lines, self.in_loops, self.doubled)


@dataclass(slots=True)
class Section:
    """The main program of a text, or one of its local subprograms.

    ``kept``: the statements with their first lines, ``None`` if there are too many.
    """

    name: str
    span: Span
    first_line: int
    is_local: bool
    labels: Labels = field(default_factory=Labels)
    kept: list[tuple[int, Statement]] | None = field(default_factory=list)

    def add(self, line: int, statement: Statement) -> None:
        """Append a statement that begins in ``line``."""
        self.labels.add(line, statement)
        if self.kept is not None:
            self.kept.append((line, statement))
            if len(self.kept) > KEPT_STATEMENTS:
                self.kept = None


@dataclass(frozen=True, slots=True)
class Call:
    """A call by a constant name: the name of a file or of a local subprogram."""

    name: str
    span: Span


@dataclass(frozen=True, slots=True)
class SignalUse:
    """A ``#SIGNAL`` or ``#WAIT`` as far as its numbers are constant.

    ``number``: ``None`` if it is computed. ``channels``: receivers or senders, empty for all;
    ``None`` if one is computed. ``is_wait``: of ``#WAIT``; ``line``: its text.
    """

    is_wait: bool
    number: int | None
    channels: tuple[int, ...] | None
    span: Span
    line: str


@dataclass(frozen=True, slots=True)
class AxisUse:
    """A command of the axis exchange as far as its numbers are constant.

    ``fetched``: the logical numbers of axes that it fetches, ``None`` for a computed one.
    ``given_names`` and ``given_numbers``: the axes that it gives; ``gives_others``: all axes but
    the fetched ones. ``names``: the names of the fetched axes with their numbers. ``line``: its
    text.
    """

    fetched: tuple[int | None, ...]
    given_names: tuple[str, ...]
    given_numbers: tuple[int | None, ...]
    gives_others: bool
    names: tuple[tuple[str, int | None], ...]
    span: Span
    line: str


@dataclass(slots=True)
class ProgramText:
    """A checked program file: ``main`` and the local subprograms by name.

    ``cycles``: its definitions of realtime cycles, if its statements are kept; ``calls``: its calls
    of other files by a constant name; ``signals``: those that it sends and waits for;
    ``exchanges``: the axes that it fetches and gives. ``joins_motions``: it may insert chamfers or
    roundings, or splines that fit their neighbours. ``named_programs``: the words whose program
    ``#FILE NAME`` names in it. ``templates``: shapes of statements seen before.
    """

    source: Source
    main: Section
    subprograms: dict[str, Section] = field(default_factory=dict)
    cycles: list[RealtimeCycle] = field(default_factory=list)
    calls: list[Call] = field(default_factory=list)
    signals: list[SignalUse] = field(default_factory=list)
    joins_motions: bool = False
    named_programs: frozenset[str] = frozenset()
    exchanges: list[AxisUse] = field(default_factory=list)
    templates: Templates = field(default_factory=Templates)

    def statements(self, section: Section, label: str | None = None) -> Iterator[Statement]:
        """Return the statements of a section, from the one with or around ``label`` on if given."""
        line = section.first_line if label is None else section.labels.lines[label]
        if section.kept is not None:
            return (statement for begin, statement in section.kept if begin >= line)
        return SectionReader(self.source, section, line, self.templates)


class SectionReader:
    """Iterates over the statements of a section from a line on, read from the text.

    Mistakes found by the check are not reported again. Statements of a known shape are made from
    their templates. Between two statements the caller may consume ``lines``.
    """

    def __init__(self, source: Source, section: Section, line: int, templates: Templates) -> None:
        self.source = source
        self._section = section
        self._templates = templates
        self._statements = StatementReader(source, Collector(), line)

    def __iter__(self) -> Iterator[Statement]:
        return self

    def __next__(self) -> Statement:
        from_template = self._templates.next(self._statements.lines, self.source.file)
        if from_template is not None:
            return from_template
        for begin, statement in self._statements:
            if not isinstance(statement, ProgramStart):
                return statement
            section = self._section
            if begin > section.first_line and (statement.local or section.is_local):
                break
        raise StopIteration

    @property
    def lines(self) -> LineReader | None:
        """The lines that follow; ``None`` while they belong to an open statement."""
        return self._statements.lines
