# SPDX-License-Identifier: MIT
"""Macros: a text in quotes is replaced by NC text, or by a part of an expression.

In: definitions ``"NAME" = "text"``, and blocks that use them. Out: the statements that the block
then is. The text is read and checked when the block is decoded, since only then it is known. Upper
and lower case of names count. Within a text other macros are put between ``\\"`` and ``\\"``.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import partial

from nctakt.base.diagnostics import Span
from nctakt.base.misspelling import nearest
from nctakt.decoder.flow.computed_blocks import check
from nctakt.decoder.state.environment import DecoderEnvironment
from nctakt.decoder.state.tools import Fail
from nctakt.messages.programs.decoder import (
    MACRO_TEXT_TOO_LONG,
    MACROS_NESTED_TOO_DEEP,
    UNKNOWN_MACRO,
)
from nctakt.nc import tree
from nctakt.nc.meaning.macros import MacroExpander, with_span
from nctakt.nc.parse.block_words import parse_content
from nctakt.nc.parse.expressions import parse_expression, unreadable
from nctakt.nc.parse.lexer import BlockError, BlockText, Piece
from nctakt.nc.parse.printer import format_word

#: Macros inside each other.
MAX_MACROS = 20

#: Maximum number of characters from the macros of one statement.
MAX_CHARACTERS = 20_000

#: Maximum number of statements whose meaning is remembered; beyond it all are forgotten.
MAX_REMEMBERED = 4096


class Macros:
    """The macros of one run of a program; ``fail`` aborts it.

    ``named_programs``: the programs that ``#FILE NAME`` has named, by word.
    """

    def __init__(
        self, environment: DecoderEnvironment, fail: Fail, named_programs: Mapping[str, str]
    ) -> None:
        self._environment = environment
        self._fail = fail
        self._named = named_programs
        self._texts: dict[str, str] = {}
        self._expander = MacroExpander(environment.names, self._meaning)
        self._remembered: dict[int, tuple[tree.Statement, tree.Statement]] = {}
        self._depth = 0
        self._characters = 0

    def define(self, definition: tree.MacroDefinition) -> None:
        """A later definition of a name replaces an earlier one."""
        self._texts[definition.name] = definition.text
        self._remembered.clear()

    @property
    def are_defined(self) -> bool:
        """Whether there are any."""
        return bool(self._texts)

    def expand_expressions(self, statement: tree.Statement) -> tree.Statement:
        """The statement with the macros in its expressions replaced."""
        pair = self._remembered.get(id(statement))
        if pair is None:
            self._depth = 0
            self._characters = 0
            changed = self._expander.statement(statement)
            if changed is not statement:
                line = partial(self._environment.line_text, statement.span)
                span, named = statement.span, self._named
                check(self._environment, self._fail, [changed], span, line, named_programs=named)
            if len(self._remembered) == MAX_REMEMBERED:
                self._remembered.clear()
            pair = self._remembered[id(statement)] = (statement, changed)
        return pair[1]

    def _meaning(self, name: tree.StringLiteral) -> tree.Expression | None:
        """The value of a macro in an expression: a whole term."""
        content = self._texts.get(name.value)
        if content is None:
            return None
        self._enter(name.value, name.span)
        self._count(content, name.value, name.span)
        text = BlockText(name.span.file, content, [Piece(0, name.span.line, content)])
        try:
            expression = parse_expression(text)
            if not text.at_end():
                raise unreadable(text)
        except BlockError as error:
            self._fail(error.message, name.span, **error.values)
        meaning = self._expander.number(with_span(expression, name.span))
        self._depth -= 1
        return meaning

    def _enter(self, name: str, span: Span) -> None:
        """Enter a macro inside the others; fail if the nesting is too deep."""
        self._depth += 1
        if self._depth > MAX_MACROS:
            self._fail(MACROS_NESTED_TOO_DEEP, span, name=name, limit=MAX_MACROS)

    def _count(self, content: str, name: str, span: Span) -> None:
        """Count the text of a macro; fail if it is too much for one statement."""
        self._characters += len(content)
        if self._characters > MAX_CHARACTERS:
            self._fail(MACRO_TEXT_TOO_LONG, span, name=name, limit=MAX_CHARACTERS)

    def expand_block(self, block: tree.Block) -> list[tree.Statement] | None:
        """The statements of a block with macros; ``None`` for one without.

        Macros inside them are expanded as well.
        """
        macro = _first_macro(block)
        if macro is None:
            return None
        self._depth = 0
        self._characters = 0
        return list(self._expanded(block, macro))

    def _expanded(self, block: tree.Block, macro: tree.StringWord) -> Iterator[tree.Statement]:
        """The statements of a block; ``macro``: the word of the program that it comes from."""
        self._enter(macro.text, macro.span)
        content = " ".join(self._text(word, macro) for word in block.words)
        text = BlockText(block.span.file, content, [Piece(0, block.span.line, content)])
        try:
            statements = parse_content(text, replace(block.head, skip=None, label=None))
        except BlockError as error:
            self._fail(error.message, macro.span, **error.values)
        named = self._named
        environment = self._environment
        check(
            environment,
            self._fail,
            statements,
            macro.span,
            lambda: content,
            named_programs=named,
        )
        for statement in statements:
            if isinstance(statement, tree.Block) and _first_macro(statement) is not None:
                yield from self._expanded(statement, macro)
            else:
                yield statement
        self._depth -= 1

    def _text(self, word: tree.BlockWord, macro: tree.StringWord) -> str:
        """The text of a word; for a macro its replacement."""
        if not isinstance(word, tree.StringWord):
            return format_word(word)
        span = word.span if self._depth == 1 else macro.span
        if word.text not in self._texts:
            near = nearest(word.text, self._texts) or "–"
            self._fail(UNKNOWN_MACRO, span, name=word.text, nearest=near)
        content = self._texts[word.text]
        self._count(content, word.text, span)
        return content


def _first_macro(block: tree.Block) -> tree.StringWord | None:
    """The first word of a block that is a macro."""
    return next((word for word in block.words if isinstance(word, tree.StringWord)), None)
