# SPDX-License-Identifier: MIT
"""Where what stands in a program: its sections, the labels in them, and the way to any of both.

In: the statements of a text as they are read, each with the line in which it begins. Out: a
``ProgramText``, which gives the statements of a section from its start or from a label on. A short
section is kept; a long one is read again from that line, so that no program is too long.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from nctakt.base.diagnostics import Span
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
    SubprogramCall,
    Switch,
    While,
)

#: Statements of a section that are kept; a longer section is read from its text each time.
KEPT_STATEMENTS = 1000


def bodies_of(statement: Statement) -> Iterator[tuple[Statement, ...]]:
    """The branches of a structure in the order of the text; nothing for a block."""
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
    """Whether a structure repeats its body: no jump leads into it."""
    return isinstance(statement, For | While | Do | Repeat | RealtimeLoop)


def labels_in(statement: Statement, in_loop: bool = False) -> Iterator[tuple[str, bool]]:
    """The labels of a statement and of all that is inside it, and whether a loop is around them."""
    if statement.head.label is not None:
        yield statement.head.label, in_loop
    in_loop = in_loop or is_loop(statement)
    for body in bodies_of(statement):
        for inner in body:
            yield from labels_in(inner, in_loop)


def leads_to(statement: Statement, label: str) -> bool:
    """Whether a jump to this label leads to the statement or into it."""
    return any(name == label and not in_loop for name, in_loop in labels_in(statement))


@dataclass(slots=True)
class Section:
    """The main program of a text, or one of its local subprograms.

    ``labels``: where the statement begins that a label stands at or in; the first one counts.
    ``loop_labels``: those that no jump may lead to; ``doubled``: those that stand twice.
    """

    name: str
    span: Span
    first_line: int
    is_local: bool
    labels: dict[str, int] = field(default_factory=dict)
    loop_labels: dict[str, None] = field(default_factory=dict)
    doubled: dict[str, None] = field(default_factory=dict)
    kept: list[tuple[int, Statement]] | None = field(default_factory=list)

    def add(self, line: int, statement: Statement) -> None:
        """The next statement, which begins in ``line``."""
        for label, in_loop in labels_in(statement):
            if label in self.labels or label in self.loop_labels:
                self.doubled[label] = None
            elif in_loop:
                self.loop_labels[label] = None
            else:
                self.labels[label] = line
        if self.kept is not None:
            self.kept.append((line, statement))
            if len(self.kept) > KEPT_STATEMENTS:
                self.kept = None


@dataclass(slots=True)
class ProgramText:
    """A checked program file: ``main`` and the local subprograms by name.

    ``cycles``: the definitions of realtime cycles in it; ``calls``: the calls of other files by a
    constant name; ``templates``: shapes of its statements that came before.
    """

    source: Source
    main: Section
    subprograms: dict[str, Section] = field(default_factory=dict)
    cycles: list[RealtimeCycle] = field(default_factory=list)
    calls: list[SubprogramCall] = field(default_factory=list)
    templates: Templates = field(default_factory=Templates)

    def statements(self, section: Section, label: str | None = None) -> Iterator[Statement]:
        """The statements of a section; from the one on that a label stands at or in."""
        line = section.first_line if label is None else section.labels[label]
        if section.kept is not None:
            return (statement for begin, statement in section.kept if begin >= line)
        return SectionReader(self.source, section, line, self.templates)


class SectionReader:
    """The statements of a section from a line on, read from the text.

    What was found when the text was checked is not told again. Statements of shapes that came
    before are made from their templates. Between two statements others may take lines (``lines``).
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
        """The lines that come next, unless they belong to what has been begun."""
        return self._statements.lines
