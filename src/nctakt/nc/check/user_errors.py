# SPDX-License-Identifier: MIT
"""``#ERROR`` of programs and realtime cycles: its keywords and values (RC-402).

In: the statement. Out: diagnostics. Without errors each keyword is known, unique and has a value,
there is an ID, and constant values are within their bounds.
"""

from __future__ import annotations

from nctakt.base.whole_numbers import is_whole
from nctakt.messages.programs.checked_blocks import UNKNOWN_COMMAND_OPTION, WORD_VALUE_MISSING
from nctakt.messages.programs.checked_cycles import DUPLICATE_KEYWORD, UNKNOWN_KEYWORD_IN_CYCLE
from nctakt.messages.programs.user_errors import (
    INVALID_USER_ERROR_ID,
    INVALID_USER_ERROR_MID,
    INVALID_USER_ERROR_RC,
    USER_ERROR_TEXT_TOO_LONG,
    USER_ERROR_WITHOUT_ID,
)
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.meaning.words import ERROR_KEYWORDS
from nctakt.nc.tree import Expression, Keyword, Number, StringLiteral, UserError

#: Maximum length of a text reported with an error.
LONGEST_TEXT = 23

#: Minimum and maximum of constant values, and the message for others.
_BOUNDS = {
    "ID": (1, 1000, INVALID_USER_ERROR_ID),
    "RC": (0, 7, INVALID_USER_ERROR_RC),
    "MID": (1, 4294967295, INVALID_USER_ERROR_MID),
}


class UserErrorChecker:
    """Checks ``#ERROR``; ``in_cycle``: in the body of a realtime cycle."""

    def __init__(self, values: ValueChecker, findings: Findings, *, in_cycle: bool) -> None:
        self._values = values
        self._findings = findings
        self._in_cycle = in_cycle

    def check(self, error: UserError) -> None:
        """Check one statement."""
        keywords: dict[str, Keyword] = {}
        lost = False  # a value whose = is missing
        for item in error.keywords:
            if lost and isinstance(item, Expression):
                lost = False
                continue
            lost = isinstance(item, Keyword) and item.value is None
            if not isinstance(item, Keyword) or item.name not in ERROR_KEYWORDS or item.arguments:
                written = self._findings.written(item.span)
                if self._in_cycle:
                    self._findings.report(
                        UNKNOWN_KEYWORD_IN_CYCLE, item.span, command="#ERROR", word=written
                    )
                else:
                    names = ", ".join(ERROR_KEYWORDS)
                    self._findings.report(
                        UNKNOWN_COMMAND_OPTION,
                        item.span,
                        command="#ERROR",
                        word=written,
                        names=names,
                    )
            elif item.name in keywords:
                self._findings.report(
                    DUPLICATE_KEYWORD, item.span, command="#ERROR", word=item.name
                )
            else:
                keywords[item.name] = item
        if "ID" not in keywords:
            self._findings.report(USER_ERROR_WITHOUT_ID, error.span)
        expressions = [keyword.value for keyword in keywords.values() if keyword.value is not None]
        self._values.line(*expressions)
        for keyword in keywords.values():
            self._value(keyword)

    def _value(self, keyword: Keyword) -> None:
        value = keyword.value
        if value is None:
            self._findings.report(WORD_VALUE_MISSING, keyword.span, word=keyword.name)
        elif keyword.name.startswith("PV") and isinstance(value, StringLiteral):
            if len(value.value) > LONGEST_TEXT:
                self._findings.report(USER_ERROR_TEXT_TOO_LONG, value.span, longest=LONGEST_TEXT)
        elif keyword.name.startswith("PV"):
            self._values.any_value(value)
        else:
            self._values.value(value)
            if isinstance(value, Number) and keyword.name in _BOUNDS:
                low, high, message = _BOUNDS[keyword.name]
                if not is_whole(value.value, low, high):
                    self._findings.report(
                        message, value.span, value=self._findings.written(value.span)
                    )
