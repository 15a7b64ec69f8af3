# SPDX-License-Identifier: MIT
"""Macros: a text in quotes alone in a block stands for NC text.

In: definitions ``"NAME" = "text"``, and blocks that use them. Out: the statements that the block
then is. The text is read and checked when the block is decoded, since only then it is known. Upper
and lower case of names count. A text holds no quotes, so macros do not stand in macros.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import NoReturn

from nctakt.decoder.rewriting import check
from nctakt.decoder.surroundings import Surroundings
from nctakt.diagnostics import Span
from nctakt.nc import syntax
from nctakt.nc.lexer import BlockError, BlockText, Piece
from nctakt.nc.printer import format_word
from nctakt.nc.words import parse_content
from nctakt.text import nearest


class Macros:
    """The macros of one run of a program; ``fail`` gives it up."""

    def __init__(self, surroundings: Surroundings, fail: Callable[..., NoReturn]) -> None:
        self._surroundings = surroundings
        self._fail = fail
        self._texts: dict[str, str] = {}

    def define(self, definition: syntax.MacroDefinition) -> None:
        """A later definition of a name replaces an earlier one."""
        self._texts[definition.name] = definition.text

    def expand(self, block: syntax.Block) -> list[syntax.Statement] | None:
        """The statements of a block with macros; ``None`` for one without."""
        if not any(isinstance(word, syntax.StringWord) for word in block.words):
            return None
        content = " ".join(self._text(word, block.span) for word in block.words)
        text = BlockText(block.span.file, content, [Piece(0, block.span.line, content)])
        try:
            statements = parse_content(text, replace(block.head, skip=None, label=None))
        except BlockError as error:
            self._fail(error.number, block.span, **error.values)
        check(self._surroundings, self._fail, statements, block.span)
        return statements

    def _text(self, word: syntax.BlockWord, span: Span) -> str:
        """The text of a word; that of a macro is what it stands for."""
        if not isinstance(word, syntax.StringWord):
            return format_word(word)
        if word.text not in self._texts:
            near = nearest(word.text, self._texts) or "–"
            self._fail(900319, span, name=word.text, nearest=near)
        return self._texts[word.text]
