# SPDX-License-Identifier: MIT
"""NC text -> tree.

In: a ``Source``. Out: its statements one by one, read no further than needed (``parse``), or the
whole program (``parse_program``). Each mistake is a diagnostic, and reading continues with the next
block. The parser accepts a little more than is valid: the checker knows which words and commands
exist and where they are allowed. The grammar as text: ``grammar.txt``.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from nctakt.base.diagnostics import Diagnostic, Span
from nctakt.messages import Collector
from nctakt.messages.programs.nc_text import (
    NAME_EXPECTED,
    ONLY_DECLARATIONS_IN_VAR,
    PROGRAM_EMPTY,
    SECOND_MAIN_PROGRAM,
)
from nctakt.nc.parse.block_head import parse_head, parse_program_start
from nctakt.nc.parse.block_words import begins_with_word, parse_content
from nctakt.nc.parse.controls import control_line, hash_line
from nctakt.nc.parse.expressions import (
    EQUALS,
    OPENING,
    expected,
    parse_expression,
    parse_list,
    parse_target,
    parse_variable,
    unreadable,
)
from nctakt.nc.parse.lexer import BlockError, BlockText, Lexer
from nctakt.nc.parse.open_structures import VariablesFrame
from nctakt.nc.parse.structure_stack import StackState, StructureStack
from nctakt.nc.source import LineReader, Source
from nctakt.nc.tree import (
    NO_HEAD,
    PARAMETER_ARRAYS,
    Block,
    Declaration,
    Expression,
    Head,
    Number,
    Program,
    ProgramStart,
    Statement,
    Subprogram,
    Variable,
    Word,
)
from nctakt.nc.vocabulary.functions import ENDS
from nctakt.nc.vocabulary.variables.resolution import as_array

#: A line of ``#VAR``.
_DECLARED = re.compile(r"V[.S]|P\d", re.IGNORECASE)

#: State of a ``StatementReader`` between two statements: whether all lines were empty, and that of
#: its structures.
ReaderState = tuple[bool, StackState]

#: State of a ``SectionCounter``: the section, the subprograms so far, whether the main program has
#: begun.
CounterState = tuple[int, int, bool]


_QUOTED = re.compile(r'"[^"]*"?')
_COLON = re.compile(r"\s*:")
_TYPE = re.compile(r"\s*([^\W\d]\w*)")


def parse(source: Source, collector: Collector) -> Iterator[Statement]:
    """Yield the statements of a source; diagnostics in the order of discovery.

    A structure is one statement, yielded when it is closed. Lines are read on demand.
    """
    for _, statement in StatementReader(source, collector):
        yield statement


class StatementReader:
    """Iterates over the statements from a line on, each with its first line.

    ``first_line`` is the first line of a statement, so that no structure is open there. Between two
    statements the caller may consume ``lines``.
    """

    def __init__(self, source: Source, collector: Collector, first_line: int = 1) -> None:
        self._structures = StructureStack(collector)
        self._lexer = Lexer(source, collector, first_line)
        self._statements = self._read(source, collector, first_line)
        self._given = 0
        self._is_empty = True

    def __iter__(self) -> Iterator[tuple[int, Statement]]:
        return self

    def __next__(self) -> tuple[int, Statement]:
        return next(self._statements)

    @property
    def lines(self) -> LineReader | None:
        """The lines that follow; ``None`` while they belong to an open statement."""
        structures = self._structures
        is_between = structures.top is None and self._given == len(structures.ready)
        return self._lexer.lines if is_between and self._lexer.is_between else None

    @property
    def state(self) -> ReaderState:
        """State that the reading of later statements depends on, while ``lines`` is there."""
        return self._is_empty, self._structures.state

    def resume(self, state: ReaderState) -> None:
        """Continue from a state, before the first statement."""
        self._is_empty, structures = state
        self._structures.resume(structures)

    def _read(
        self, source: Source, collector: Collector, first_line: int
    ) -> Iterator[tuple[int, Statement]]:
        structures = self._structures
        begin = first_line
        for text in self._lexer.blocks():
            self._is_empty = False
            if structures.top is None:
                begin = text.line_number
            _block(text, self._lexer, structures)
            if structures.ready:
                yield from self._ready(begin)
                structures.ready.clear()
        structures.close_all()
        yield from self._ready(begin)
        if self._is_empty and not collector.has_errors:
            span = Span(source.file, 1, 1, 2)
            collector.report(PROGRAM_EMPTY, span, source.line_of(span))

    def _ready(self, begin: int) -> Iterator[tuple[int, Statement]]:
        """Yield the finished statements and count them."""
        self._given = 0
        for statement in self._structures.ready:
            self._given += 1
            yield begin, statement


def parse_program(source: Source, collector: Collector) -> Program:
    """Return the whole program; diagnostics in the order of the text."""
    found_errors = Collector()
    program = _assemble(source, StatementReader(source, found_errors), found_errors)
    found_errors.diagnostics.sort(key=_position)
    collector.diagnostics += found_errors.diagnostics
    return program


def _position(diagnostic: Diagnostic) -> tuple[int, int]:
    span = diagnostic.span
    return (span.line, span.column) if span is not None else (0, 0)


def _block(text: BlockText, lexer: Lexer, structures: StructureStack) -> None:
    """Add one block to the structures, or report why it cannot be read."""
    head = NO_HEAD
    try:
        head = parse_head(text)
        start = text.skip_blanks()
        first = text.text[start : start + 1]
        if isinstance(structures.top, VariablesFrame):
            if _declaration_line(text, first, head, lexer, structures):
                return
        if first == "$":
            control_line(text, head, structures)
        elif first == "#" and not begins_with_word(text):
            hash_line(text, head, structures)
        elif first == "%":
            _program_start(text, structures)
        else:
            _content(text, head, structures)
        if not text.at_end():
            raise unreadable(text)
    except BlockError as error:
        structures.add_unreadable(text, head, error)


def _content(text: BlockText, head: Head, structures: StructureStack) -> None:
    statements = parse_content(text, head)
    for statement in statements:
        structures.add_block(statement, text)
    if "M" in text.text or "m" in text.text:
        if any(_is_program_end(statement) for statement in statements):
            structures.end_program()


def _is_program_end(statement: Statement) -> bool:
    return (
        isinstance(statement, Block)
        and statement.head.skip is None
        and any(
            isinstance(word, Word)
            and word.name == "M"
            and isinstance(word.value, Number)
            and word.value.value in ENDS
            for word in statement.words
        )
    )


def _program_start(text: BlockText, structures: StructureStack) -> None:
    start = parse_program_start(text)
    structures.begin_program()
    structures.add(start)


def _declaration_line(
    text: BlockText, first: str, head: Head, lexer: Lexer, structures: StructureStack
) -> bool:
    """Read a line inside ``#VAR``; return false if it does not belong there.

    A second consecutive line that declares nothing shows that ``#ENDVAR`` is missing.
    """
    frame = structures.top
    assert isinstance(frame, VariablesFrame)
    if first == "#" and text.text[text.pos + 1 :].lstrip().upper().startswith(
        ("ENDVAR", "END VAR", "END_VAR", "COMMENT")
    ):
        return False
    if first in ("#", "$", "%") or (frame.failed_lines and not _declares(text)):
        structures.give_up()
        return False
    text = whole_declaration(text, lexer)
    try:
        frame.declarations.append(parse_declaration(text, head))
        frame.failed_lines = 0
    except BlockError as error:
        frame.failed_lines += error.message is ONLY_DECLARATIONS_IN_VAR
        structures.block_error(text, error)
    return True


def _declares(text: BlockText) -> bool:
    return _DECLARED.match(text.text, text.pos) is not None


# --- the program ---------------------------------------------------------------------------------


class SectionCounter:
    """Numbers the sections of a text: 0 is the main program, 1 … its local subprograms.

    Section -1 never runs. A section begins with its ``%`` line: ``%L name`` a subprogram, the first
    other one the main program, unless that has begun without a ``%`` line. Inside the main program
    a further ``%`` line is a comment; after a subprogram it begins a program that never runs, with
    a warning.
    """

    def __init__(self, source: Source, collector: Collector) -> None:
        self._source = source
        self._collector = collector
        self.state: CounterState = (0, 0, False)

    def of(self, statement: Statement) -> int | None:
        """Return the section of the next statement, ``None`` for a ``%`` line that is a comment."""
        section, subprograms, begun = self.state
        if not isinstance(statement, ProgramStart):
            begun = begun or section == 0
        elif statement.local:
            subprograms += 1
            section = subprograms
        elif not begun:
            section, begun = 0, True
        elif section == 0:
            return None
        else:
            line = self._source.line_of(statement.span)
            self._collector.report(SECOND_MAIN_PROGRAM, statement.span, line, name=statement.name)
            section = -1
        self.state = section, subprograms, begun
        return section


def _assemble(
    source: Source, statements: Iterator[tuple[int, Statement]], collector: Collector
) -> Program:
    """Return main program and local subprograms."""
    name = ""
    bodies: dict[int, list[Statement]] = {0: []}
    starts: dict[int, ProgramStart] = {}
    counter = SectionCounter(source, collector)
    for _, statement in statements:
        section = counter.of(statement)
        if section is None:
            continue
        if not isinstance(statement, ProgramStart):
            bodies.setdefault(section, []).append(statement)
        elif section == 0:
            name = statement.name
        elif section > 0:
            starts[section] = statement
    subprograms = tuple(
        Subprogram(start.span, start.name, tuple(bodies.get(section, ())))
        for section, start in starts.items()
    )
    return Program(source, name, tuple(bodies[0]), subprograms)


def whole_declaration(text: BlockText, lexer: Lexer) -> BlockText:
    """Return the text extended by the lines that its open brackets need."""
    while _is_open(text.text):
        longer = lexer.extend(text)
        if longer is None:
            return text
        longer.pos = text.pos
        text = longer
    return text


def _is_open(content: str) -> bool:
    without_texts = _QUOTED.sub("", content)
    return without_texts.count("[") > without_texts.count("]")


def parse_declaration(text: BlockText, head: Head) -> Declaration:
    """Return one declaration; raises ``BlockError`` 900116 for anything else."""
    start = text.skip_blanks()
    variable = parse_variable(text) or _parameter(text)
    if variable is None:
        raise _no_declaration(text)
    type_name: str | None = None
    size: Expression | None = None
    initial: Expression | None = None
    is_typed = variable.family != PARAMETER_ARRAYS
    if is_typed and text.match(_COLON) is not None:
        match = text.match(_TYPE)
        if match is None:
            raise expected(text, NAME_EXPECTED)
        type_name = match[1].upper()
        if text.looking_at(OPENING) is not None:
            size = parse_list(text)[0].node
    if text.match(EQUALS) is not None:
        initial = parse_expression(text)
    span = text.span(start, text.pos)
    if not text.at_end():
        raise unreadable(text)
    return Declaration(span, head, variable, type_name, size, initial)


def _parameter(text: BlockText) -> Variable | None:
    """Return ``P10`` or ``P10[3]`` as an array with these dimensions, ``None`` for another text."""
    target = parse_target(text)
    found = None if target is None else as_array(target)
    return found if isinstance(found, Variable) else None


def _no_declaration(text: BlockText) -> BlockError:
    start = text.pos
    end = start + len(text.text[start:].split("\n", 1)[0].rstrip())
    return BlockError(ONLY_DECLARATIONS_IN_VAR, start, max(end, start + 1))
