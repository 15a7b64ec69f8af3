# SPDX-License-Identifier: MIT
"""The common form of brackets for single axes in programs: a first keyword, then others.

``X[INDP_SYN …]``, ``X[INDP_ASYN …]``, ``X[OSC …]``: each keyword once, some with a value, before
which the sign ``=`` is optional.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import ClassVar

from nctakt.base.diagnostics import Message, Span, Text
from nctakt.messages.axes.independent_axes import (
    AXIS_KEYWORD_NOT_FIRST,
    DUPLICATE_AXIS_KEYWORD,
)
from nctakt.messages.programs.checked_blocks import WORD_VALUE_MISSING
from nctakt.nc.tree import BracketCommand, Expression, Keyword
from nctakt.nc.vocabulary.single_axes.axis_commands import Finding

#: The first keywords.
INDP_SYN, INDP_ASYN, OSC = "INDP_SYN", "INDP_ASYN", "OSC"
FORMS = (INDP_SYN, INDP_ASYN, OSC)

_UNKNOWN_KEYWORD = Text("{word} is not one of its keywords", "{word} ist keines davon")
_VALUE_ALONE = Text("a value without a keyword", "ein Wert ohne Schlüsselwort")
_TAKES_NO_VALUE = Text("{word} takes no value", "{word} erwartet keinen Wert")


def form_of(command: BracketCommand) -> str:
    """Return the word of ``FORMS`` that a bracket has, else an empty text."""
    names = (item.name for item in command.items if isinstance(item, Keyword))
    return next((name for name in names if name in FORMS), "")


class BracketReader:
    """Reads the keywords of a bracket.

    ``syntax``: the message for a wrong form. ``flags``: keywords without a value; ``values``: those
    with one; ``refusals``: those that are known and refused, with the word of their row.
    """

    syntax: ClassVar[Message]
    flags: ClassVar[Sequence[str]]
    values: ClassVar[Sequence[str]]
    refusals: ClassVar[Mapping[str, str]] = {}

    def __init__(self, command: BracketCommand) -> None:
        self.bracket = command
        self.form = form_of(command)
        self.named = {"axis": command.name, "form": self.form}
        self.keywords: dict[str, Keyword] = {}
        self.findings: list[Finding] = []
        self.refused: list[tuple[str, Span]] = []

    def find(self, message: Message, span: Span, **values: object) -> None:
        """Note a mistake."""
        self.findings.append(Finding(message, span, values))

    def wrong(self, reason: Text, span: Span | None = None) -> None:
        """Note a wrong form, of the whole bracket if there is no span."""
        self.find(self.syntax, span or self.bracket.span, reason=reason, **self.named)

    def read(self) -> bool:
        """Note the keywords and the mistakes in each; return whether there is none."""
        first = self.bracket.items[0]
        if not isinstance(first, Keyword) or first.name != self.form or first.value is not None:
            self.find(AXIS_KEYWORD_NOT_FIRST, self.bracket.span, **self.named)
            return False
        pending: Keyword | None = None
        for item in self.bracket.items[1:]:
            if not isinstance(item, Keyword):
                if pending is None:
                    self.wrong(_VALUE_ALONE, item.span)
                else:
                    self.keywords[pending.name] = Keyword(pending.span, pending.name, item)
                pending = None
                continue
            self._miss(pending)
            pending = self._keyword(item)
        self._miss(pending)
        return not self.findings

    def _miss(self, pending: Keyword | None) -> None:
        """Report a keyword after which no value came."""
        if pending is not None:
            self.find(WORD_VALUE_MISSING, pending.span, word=pending.name)

    def name_of(self, item: Keyword) -> str:
        """Return the name of a keyword, empty if it has been reported."""
        return item.name

    def _keyword(self, item: Keyword) -> Keyword | None:
        """Note a keyword; return it if its value has to follow."""
        name = self.name_of(item)
        if not name:
            return None
        if name in self.refusals:
            self.refused.append((self.refusals[name], item.span))
            return None
        if item.arguments or (name not in self.values and name not in self.flags):
            self.wrong(_with(_UNKNOWN_KEYWORD, name), item.span)
            return None
        if name in self.keywords:
            self.find(DUPLICATE_AXIS_KEYWORD, item.span, word=name, **self.named)
            return None
        if name in self.flags and item.name == name and item.value is not None:
            self.wrong(_with(_TAKES_NO_VALUE, name), item.span)
        self.keywords[name] = item
        return item if name in self.values and item.value is None else None

    def value(self, name: str) -> Expression | None:
        """Return the value of a keyword, ``None`` without it."""
        keyword = self.keywords.get(name)
        return None if keyword is None else keyword.value


def _with(text: Text, word: str) -> Text:
    return Text(text.en.format(word=word), text.de.format(word=word))
