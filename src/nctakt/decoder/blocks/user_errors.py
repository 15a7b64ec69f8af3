# SPDX-License-Identifier: MIT
"""``#ERROR`` of the main program and of realtime cycles (RC-402).

In: the checked statement. Out: its parts, and for the main program the commands that report the
error in its order in the queue. Values appear in the order of the program.
"""

from __future__ import annotations

from collections.abc import Generator

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Message
from nctakt.base.whole_numbers import is_whole
from nctakt.decoder.state.queued.commands import (
    Answer,
    Command,
    UserErrorReport,
    UserErrorStop,
    UserErrorText,
    UserErrorValue,
)
from nctakt.decoder.values.variables import Values
from nctakt.messages.programs.user_errors import INVALID_USER_ERROR_ID, INVALID_USER_ERROR_RC
from nctakt.nc import tree
from nctakt.nc.meaning.words import ERROR_KEYWORDS

#: Default of RC: an error that a reset clears.
DEFAULT_REACTION = 2.0

HIGHEST_ID = 1000
HIGHEST_REACTION = 7


@dataclass(frozen=True, slots=True)
class UserErrorParts:
    """The parts of one ``#ERROR``.

    ``values``: for each further keyword its index in ``KEYWORDS`` and its value.
    """

    identity: tree.Expression
    reaction: tree.Expression
    values: tuple[tuple[int, tree.Expression], ...]


def parts(statement: tree.UserError) -> UserErrorParts:
    """Return the parts of a checked statement."""
    keywords: dict[str, tree.Expression] = {}
    for keyword in statement.keywords:
        assert isinstance(keyword, tree.Keyword)
        assert keyword.value is not None
        keywords[keyword.name] = keyword.value
    reaction = keywords.get("RC", tree.Number(statement.span, DEFAULT_REACTION))
    names = [name for name in keywords if name not in ("ID", "RC")]
    values = tuple((ERROR_KEYWORDS.index(name), keywords[name]) for name in names)
    return UserErrorParts(keywords["ID"], reaction, values)


def user_error(
    values: Values, statement: tree.UserError, number: int
) -> Generator[Command, Answer]:
    """Yield the commands of an ``#ERROR`` of the main program."""
    error_parts = parts(statement)
    identity = yield from _whole(
        values, error_parts.identity, number, 1, HIGHEST_ID, INVALID_USER_ERROR_ID
    )
    reaction = yield from _whole(
        values, error_parts.reaction, number, 0, HIGHEST_REACTION, INVALID_USER_ERROR_RC
    )
    contents: list[tuple[int, float | str]] = []
    for code, expression in error_parts.values:
        contents.append((code, (yield from values.evaluate_any(expression, number))))
    source = values.environment.source_id(statement.span)
    yield UserErrorReport(source, number, identity, reaction)
    for code, value in contents:
        if isinstance(value, str):
            yield UserErrorText(source, number, code, values.environment.text_id(value))
        else:
            yield UserErrorValue(source, number, code, value)
    if reaction > 0:
        yield UserErrorStop(source, number, reaction)


def _whole(
    values: Values, expression: tree.Expression, number: int, low: int, high: int, message: Message
) -> Generator[Command, Answer, int]:
    """Return an integer from ``low`` to ``high``; raises ``DecodeError`` with the given message."""
    value = yield from values.evaluate(expression, number)
    if not is_whole(value, low, high):
        values.fail(message, expression.span, value=value)
    return int(value)
