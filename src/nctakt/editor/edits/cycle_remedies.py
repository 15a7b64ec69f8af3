# SPDX-License-Identifier: MIT
"""Findings in realtime cycles -> the edits that remedy them.

In: a document and a finding. Out: titles and edits: separate branches for an ``$IF`` with frequency
(22022), a frequency for a function that each tick would output (900243), independent motion for
words of the path, another place for statements not allowed in a cycle (22002), a parameter for
values that only the decoder has. The cycle is parsed alone; one that cannot be read has no edits.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from lsprotocol.types import TextEdit

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Language, Span, Text
from nctakt.editor.completing.program_names import names_of
from nctakt.editor.document import Document
from nctakt.editor.structures import Structure, every, structures
from nctakt.messages import Collector
from nctakt.messages.programs.checked_cycles import (
    COMMAND_NOT_ALLOWED_IN_CYCLE,
    FREQUENCY_IF_WITH_ELSE,
)
from nctakt.messages.programs.checked_values import QUERY_IN_REALTIME_CYCLE
from nctakt.messages.programs.lints import FUNCTION_OUTPUT_EACH_TICK
from nctakt.nc.parse.lexer import without_comments
from nctakt.nc.parse.parser import parse_program
from nctakt.nc.source import Source
from nctakt.nc.tree import (
    AxisWord,
    Block,
    If,
    Number,
    RealtimeCycle,
    Statement,
    Word,
)
from nctakt.nc.vocabulary.functions import ABSOLUTE, LINE, RAPID, RELATIVE
from nctakt.nc.vocabulary.variables.variable_table import NameTable

_MESSAGES = (
    FREQUENCY_IF_WITH_ELSE,
    FUNCTION_OUTPUT_EACH_TICK,
    COMMAND_NOT_ALLOWED_IN_CYCLE,
    QUERY_IN_REALTIME_CYCLE,
)
_CONDITION = re.compile(r"\$\w+\s*(?:(?:ONCE|EDGE|ALWAYS)\b\s*)?", re.IGNORECASE)
Remedy = tuple[str, list[TextEdit]]

_SECOND_IF = Text("Write a second $IF {word}", "Ein zweites $IF {word} schreiben")
_WITHOUT = Text("Remove {word}", "{word} entfernen")
_EACH_TIME = Text(
    "Output it each time the condition becomes true: $IF EDGE",
    "Ausgeben, sooft die Bedingung wahr wird: $IF EDGE",
)
_FIRST_TIME = Text("Output it the first time only: $IF ONCE", "Nur beim ersten Mal: $IF ONCE")
_ONCE = Text("Output it once: $IF ONCE 1 … $ENDIF", "Einmal ausgeben: $IF ONCE 1 … $ENDIF")
_INDEPENDENT = Text("Move alone: {new}", "Unabhängig fahren: {new}")
_AFTER = Text("Move it to after #RT CYCLE END", "Nach #RT CYCLE END verschieben")
_PARAMETER = Text("Read it before the cycle, into {name}", "Vor dem Zyklus in {name} lesen")
#: G functions of a motion that an independent axis has, too.
_OF_MOTIONS = (RAPID, LINE, ABSOLUTE, RELATIVE)


@dataclass(frozen=True, slots=True)
class _Cycle:
    """A realtime cycle of a document: its tree, whose first line is ``first``, counted from 0."""

    document: Document
    first: int
    last: int
    body: tuple[Statement, ...]

    def text(self, span: Span) -> str:
        """Return the text at a span of the tree."""
        return self.line(span)[span.column - 1 : span.end_column - 1]

    def line(self, span: Span) -> str:
        """Return the line of a span of the tree."""
        return self.document.line(self.first + span.line - 1)

    def replaced(self, start: Span, end: int, text: str) -> TextEdit:
        """Return the edit of the text from the start of a span to an index in its line."""
        number = self.first + start.line - 1
        return TextEdit(self.document.range(number, start.column - 1, end), text)

    def condition(self, span: Span) -> tuple[int, int]:
        """Return where the condition of the control word at a span begins and ends in its line."""
        code = without_comments(self.line(span))
        match = _CONDITION.match(code, span.column - 1)
        begin = span.end_column - 1 if match is None else match.end()
        return begin, len(code.rstrip())

    def indent(self, span: Span) -> str:
        """Return the blanks at the start of a span's line."""
        line = self.line(span)
        return line[: len(line) - len(line.lstrip())]


def cycle_remedies(
    document: Document, item: Diagnostic, names: NameTable, language: Language
) -> Iterator[Remedy]:
    """Yield title and edits of each remedy of a finding in a realtime cycle."""
    span = item.span
    if span is None or item.message not in _MESSAGES:
        return
    cycle = _cycle_at(document, span.line - 1)
    if cycle is None:
        return
    if item.message is FREQUENCY_IF_WITH_ELSE:
        yield from _second_if(cycle, span, language)
    elif item.message is FUNCTION_OUTPUT_EACH_TICK:
        yield from _with_frequency(cycle, span, language)
    elif item.message is COMMAND_NOT_ALLOWED_IN_CYCLE:
        yield from _independent(cycle, span, names, language)
        yield from _after_cycle(cycle, span, language)
    else:
        yield from _into_parameter(cycle, span, language)


def _cycle_at(document: Document, line: int) -> _Cycle | None:
    """Return the realtime cycle around a line, ``None`` if it cannot be read."""
    around = next(
        (
            item
            for item in every(structures(document.lines))
            if item.begin == "#RT CYCLE" and item.is_closed and item.first < line < item.last
        ),
        None,
    )
    if around is None:
        return None
    lines = document.lines[around.first : around.last + 1]
    if any(text.rstrip().endswith("\\") for text in lines):
        return None  # a block of several lines: its columns are not those of one line
    program = parse_program(Source("", lines), Collector())
    cycles = [item for item in program.statements if isinstance(item, RealtimeCycle)]
    if len(cycles) != 1:
        return None
    return _Cycle(document, around.first, around.last, cycles[0].body)


def _branches(
    statements: Sequence[Statement], around: tuple[If, ...] = ()
) -> Iterator[tuple[Statement, tuple[If, ...]]]:
    """Yield each statement with the ``$IF`` structures around it, the outermost first."""
    for statement in statements:
        yield statement, around
        if isinstance(statement, If):
            inside = (*around, statement)
            yield from _branches(statement.body, inside)
            for branch in statement.elseifs:
                yield from _branches(branch.body, inside)
            yield from _branches(statement.else_body or (), inside)


def _is_at(cycle: _Cycle, found: Span, span: Span) -> bool:
    return (cycle.first + found.line, found.column) == (span.line, span.column)


# --- 22022, 900243 -------------------------------------------------------------------------------


def _second_if(cycle: _Cycle, span: Span, language: Language) -> Iterator[Remedy]:
    """Yield separate branches, and the same without frequency, for ``$IF EDGE … $ELSE``."""
    for statement, _ in _branches(cycle.body):
        if not isinstance(statement, If) or statement.frequency is None:
            continue
        spans = [branch.span for branch in statement.elseifs]
        spans += [statement.else_span] if statement.else_span is not None else []
        if not any(_is_at(cycle, other, span) for other in spans):
            continue
        word = statement.frequency
        yield _SECOND_IF.get(language).format(word=word), _divided(cycle, statement, word)
        edits = [_frequency(cycle, statement, "")]
        edits += [
            cycle.replaced(branch.span, cycle.condition(branch.span)[0], "$ELSEIF ")
            for branch in statement.elseifs
            if branch.frequency is not None
        ]
        yield _WITHOUT.get(language).format(word=word), edits


def _divided(cycle: _Cycle, statement: If, word: str) -> list[TextEdit]:
    """Return the edits that give each branch a separate ``$IF`` with a frequency.

    A later branch asks whether the earlier conditions are false, as ``$ELSE`` does.
    """
    indent = cycle.indent(statement.span)
    false = [f"NOT [{_asked(cycle, statement.span)}]"]
    edits = [_frequency(cycle, statement, word)] if statement.frequency != word else []
    for branch in statement.elseifs:
        condition = _asked(cycle, branch.span)
        asked = " && ".join([*false, f"[{condition}]"])
        text = f"$ENDIF\n{indent}$IF {word} {asked}"
        edits.append(cycle.replaced(branch.span, cycle.condition(branch.span)[1], text))
        false.append(f"NOT [{condition}]")
    if statement.else_span is not None:
        text = f"$ENDIF\n{indent}$IF {word} {' && '.join(false)}"
        edits.append(cycle.replaced(statement.else_span, statement.else_span.end_column - 1, text))
    return edits


def _frequency(cycle: _Cycle, statement: If, word: str) -> TextEdit:
    """Return the edit that gives an ``$IF`` a frequency; empty: none."""
    text = f"$IF {word} " if word else "$IF "
    return cycle.replaced(statement.span, cycle.condition(statement.span)[0], text)


def _asked(cycle: _Cycle, span: Span) -> str:
    """Return the condition of the control word at a span."""
    return cycle.line(span)[slice(*cycle.condition(span))]


def _with_frequency(cycle: _Cycle, span: Span, language: Language) -> Iterator[Remedy]:
    """Yield a frequency for the ``$IF`` around a function, or an ``$IF ONCE 1`` around it."""
    for statement, around in _branches(cycle.body):
        if not isinstance(statement, Block):
            continue
        if not any(_is_at(cycle, word.span, span) for word in statement.words):
            continue
        if len(around) == 1:
            for title, word in ((_EACH_TIME, "EDGE"), (_FIRST_TIME, "ONCE")):
                yield title.get(language), _divided(cycle, around[0], word)
        elif not around:
            line = span.line - 1
            text = cycle.document.line(line)
            indent = cycle.indent(statement.span)
            new = f"{indent}$IF ONCE 1\n{indent}  {text.strip()}\n{indent}$ENDIF"
            edit = TextEdit(cycle.document.whole_lines(line, line), new)
            yield _ONCE.get(language), [edit]


# --- 22002 ---------------------------------------------------------------------------------------


def _independent(
    cycle: _Cycle, span: Span, names: NameTable, language: Language
) -> Iterator[Remedy]:
    """Yield the independent motions that replace a block of the path (RC-405)."""
    for statement, _ in _branches(cycle.body):
        if not isinstance(statement, Block):
            continue
        if not any(_is_at(cycle, word.span, span) for word in statement.words):
            continue
        new = _motions(cycle, statement, names)
        if new:
            edit = cycle.replaced(
                statement.words[0].span, statement.words[-1].span.end_column - 1, new
            )
            yield _INDEPENDENT.get(language).format(new=new), [edit]


def _motions(cycle: _Cycle, block: Block, names: NameTable) -> str:
    """Return a block as independent motions; empty if it has other words or lacks the feed."""
    functions: set[int] = set()
    feed = ""
    targets: list[tuple[str, str]] = []
    for word in block.words:
        axis = names.axis(word.name) if isinstance(word, AxisWord) else None
        if isinstance(word, AxisWord) and word.value is not None:
            if axis is None or not axis.moves_alone:
                return ""
            targets.append((word.name, _value(cycle, word)))
        elif isinstance(word, Word) and word.name == "F" and word.value is not None:
            feed = _value(cycle, word)
        elif isinstance(word, Word) and word.name == "G" and isinstance(word.value, Number):
            functions.add(int(word.value.value))
        else:
            return ""
    is_line = LINE in functions or (bool(feed) and RAPID not in functions)
    if not functions <= set(_OF_MOTIONS) or {RAPID, LINE} <= functions or not targets:
        return ""
    if is_line and not feed:
        return ""
    dimension = "G91" if RELATIVE in functions else "G90"
    speed = f"G01 FEED={feed}" if is_line else "G00"
    return " ".join(f"{name}[INDP {dimension} {speed} POS={value}]" for name, value in targets)


def _value(cycle: _Cycle, word: Word | AxisWord) -> str:
    """Return the value of a word as written."""
    return cycle.text(word.span)[len(word.name) :].lstrip().removeprefix("=").strip()


def _after_cycle(cycle: _Cycle, span: Span, language: Language) -> Iterator[Remedy]:
    """Yield the move of a statement of the cycle's top-level body to after the cycle."""
    document = cycle.document
    if not any(
        cycle.first + statement.span.line == span.line
        for statement, around in _branches(cycle.body)
        if not around
    ):
        return
    moved = next(
        (
            item
            for item in every(structures(document.lines[cycle.first + 1 : cycle.last]))
            if cycle.first + 1 + item.first == span.line - 1
        ),
        Structure("", span.line - 1, span.line - 1, is_closed=True),
    )
    first = span.line - 1
    last = first + moved.last - moved.first
    if not moved.is_closed:
        return
    lines = document.lines[first : last + 1]
    shallow = min(len(line) - len(line.lstrip()) for line in lines if line.strip())
    end = document.whole_lines(cycle.last, cycle.last).end
    removed = document.whole_lines(first, last)
    removed.end = document.whole_lines(last + 1, last + 1).start
    yield (
        _AFTER.get(language),
        [
            TextEdit(removed, ""),
            TextEdit(type(removed)(end, end), "".join(f"\n{line[shallow:]}" for line in lines)),
        ],
    )


def _into_parameter(cycle: _Cycle, span: Span, language: Language) -> Iterator[Remedy]:
    """Yield the assignment of a query to a free parameter before the cycle."""
    document = cycle.document
    used = names_of(document, -1, "parameter", any_use=True)
    number = 1 + max((int(name[1:]) for name in used), default=0)
    line = without_comments(document.line(span.line - 1))
    start = span.column - 1
    end = _end_of_call(line, span.end_column - 1)
    if not end:
        return
    opening = document.line(cycle.first)
    indent = opening[: len(opening) - len(opening.lstrip())]
    edits = [
        TextEdit(document.range(cycle.first, 0, 0), f"{indent}P{number} = {line[start:end]}\n"),
        TextEdit(document.range(span.line - 1, start, end), f"P{number}"),
    ]
    yield _PARAMETER.get(language).format(name=f"P{number}"), edits


def _end_of_call(line: str, name_end: int) -> int:
    """Return the index after the bracket that closes a call; 0 without one in its line."""
    depth = 0
    for index in range(name_end, len(line)):
        depth += {"[": 1, "]": -1}.get(line[index], 0)
        if line[index] == "]" and depth == 0:
            return index + 1
    return 0
