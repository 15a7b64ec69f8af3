# SPDX-License-Identifier: MIT
"""Calls of subprograms, checked before they are decoded.

In: ``L``, ``LL`` and their forms with CYCLE. Out: diagnostics, and the calls by a constant name, so
that the called files can be loaded.
"""

from __future__ import annotations

from nctakt.base.diagnostics import NOTHING
from nctakt.base.misspelling import nearest
from nctakt.messages.programs.checked_blocks import WORD_VALUE_MISSING
from nctakt.messages.programs.checked_cycles import DUPLICATE_KEYWORD
from nctakt.messages.programs.program_structure import INVALID_CALL_PARAMETER
from nctakt.nc.check.blocks import WordChecker
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.meaning.words import MODAL_BLOCK, MODAL_MOVE, parameter_number
from nctakt.nc.tree import (
    Block,
    BlockWord,
    Expression,
    Keyword,
    Number,
    StringLiteral,
    StringWord,
    SubprogramCall,
    Word,
)
from nctakt.nc.vocabulary import support_level
from nctakt.nc.vocabulary.function_rows import Form
from nctakt.nc.vocabulary.functions import TOOL_CHANGE

_MODAL = (*MODAL_MOVE, MODAL_BLOCK)


class CallChecker:
    """Checks the calls of one program."""

    def __init__(self, words: WordChecker, values: ValueChecker, findings: Findings) -> None:
        self._words = words
        self._values = values
        self._findings = findings
        self._calls: list[SubprogramCall] = []

    def take(self) -> list[SubprogramCall]:
        """Return the calls by a constant name since the last call of this method."""
        taken, self._calls = self._calls, []
        return taken

    def call(self, call: SubprogramCall) -> None:
        """Check one call with the words of its block."""
        if call.words:
            self._words.block(Block(call.span, call.head, call.words))
        self._values.line(*_given(call))
        if isinstance(call.name, StringLiteral):
            self._calls.append(call)
        else:
            self._values.text(call.name)
        seen: dict[str, None] = {}
        for item in call.keywords:
            if isinstance(item, Keyword):
                self._keyword(item, seen)
            else:
                self._unknown(item)

    def _keyword(self, keyword: Keyword, seen: dict[str, None]) -> None:
        if keyword.name in _MODAL and keyword.value is None and not keyword.arguments:
            if _MODAL[0] in seen:
                self._findings.report(
                    DUPLICATE_KEYWORD, keyword.span, command="L CYCLE", word=keyword.name
                )
            seen[_MODAL[0]] = None
        elif parameter_number(keyword) is None:
            self._unknown(keyword)
        elif keyword.name in seen:
            self._findings.report(
                DUPLICATE_KEYWORD, keyword.span, command="L CYCLE", word=keyword.name
            )
        elif keyword.value is None:
            self._findings.report(WORD_VALUE_MISSING, keyword.span, word=keyword.name)
        else:
            seen[keyword.name] = None
            self._values.any_value(keyword.value)

    def _unknown(self, item: Keyword | Expression) -> None:
        word = self._findings.written(item.span)
        near = nearest(word, _MODAL) or NOTHING
        self._findings.report(INVALID_CALL_PARAMETER, item.span, word=word, nearest=near)


def _given(call: SubprogramCall) -> list[Expression]:
    """Return the values that the call passes."""
    keywords = (item for item in call.keywords if isinstance(item, Keyword))
    return [keyword.value for keyword in keywords if keyword.value is not None]


def may_call(block: Block) -> bool:
    """Return whether a block may call a program: by a macro, M6, G80 … or a computed number."""
    return any(isinstance(word, StringWord) or _may_call(word) for word in block.words)


def _may_call(word: BlockWord) -> bool:
    if not isinstance(word, Word) or word.name not in ("G", "M"):
        return False
    if not isinstance(word.value, Number):
        return True
    if word.name == "M":
        return word.value.value == TOOL_CHANGE
    row = support_level.g_function(word.value.value)
    return row is None or row.form is Form.SUBPROGRAM
