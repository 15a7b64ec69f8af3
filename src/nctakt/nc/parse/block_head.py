# SPDX-License-Identifier: MIT
"""The head of a block: skip level, block number, label; and ``%`` lines.

In: a block's text at its start. Out: a ``Head``; the reading position is after it. A label is
``N20:`` or a name in brackets; case does not matter.
"""

from __future__ import annotations

import re

from nctakt.messages.programs.nc_text import INVALID_SKIP_LEVEL
from nctakt.nc.parse.expressions import number_at, parse_expression
from nctakt.nc.parse.lexer import BlockError, BlockText
from nctakt.nc.tree import NO_HEAD, Expression, Head, ProgramStart

SKIP_LEVELS = 10

#: Skip level, block number, colon of a label, name of a label.
HEAD = re.compile(
    r"\s*(?:/(\d*)\s*)?(?:N\s*(\d+)(?:\s*(:))?\s*)?(?:\[\s*([^\W\d]\w*)\s*\]\s*)?", re.IGNORECASE
)
#: The same without groups, as the beginning of other patterns.
BLOCK_HEAD = r"\s*(?:/\d*\s*)?(?:N\s*\d+\s*:?\s*)?(?:\[\s*[^\W\d]\w*\s*\]\s*)?"
_COMPUTED_NUMBER = re.compile(r"\s*N(?=\s*(?:=|\[|@?P+[\d\[]|Vs?\.))\s*=?", re.IGNORECASE)
#: The label that a jump names: a number or a name.
LABEL = re.compile(r"\s*(?:N\s*(\d+)|\[\s*([^\W\d]\w*)\s*\])(?!\w)", re.IGNORECASE)
_START = re.compile(r"\s*%\s*(?:([Ll])\s+(?=\S))?(.*\S)?", re.DOTALL)


def parse_head(text: BlockText) -> Head:
    """Return skip level, number and label of the block; raises ``BlockError``."""
    match = text.match(HEAD)
    assert match is not None
    skip, digits, colon, name = match.groups()
    if skip is None and digits is None and name is None:
        computed = text.match(_COMPUTED_NUMBER)
        return NO_HEAD if computed is None else Head(parse_expression(text, names=False))
    level = None if skip is None else int(skip[:3] or 1)
    if level is not None and not 1 <= level <= SKIP_LEVELS:
        raise BlockError(INVALID_SKIP_LEVEL, *match.span(1), level=skip, limit=SKIP_LEVELS)
    number: Expression | None = None
    label = None if name is None else name.upper()
    if digits is not None:
        number = number_at(text, *match.span(2))
        if colon and label is None:
            label = number_label(digits)
    return Head(number, level, label)


def number_label(digits: str) -> str:
    """Return the label of a block number; ``N020`` and ``N20`` are the same."""
    return "N" + (digits.lstrip("0") or "0")


def parse_label(text: BlockText) -> str | None:
    """Return the label that a jump names, ``None`` without one."""
    match = text.match(LABEL)
    if match is None:
        return None
    return number_label(match[1]) if match[1] is not None else match[2].upper()


def parse_program_start(text: BlockText) -> ProgramStart:
    """Return the ``%name`` or ``%L name`` at the reading position; the name may contain blanks."""
    start = text.skip_blanks()
    match = text.match(_START)
    assert match is not None
    span = text.span(start, match.end())
    text.pos = len(text.text)
    return ProgramStart(span, NO_HEAD, match[2] or "", match[1] is not None)
