# SPDX-License-Identifier: MIT
"""A line of a program -> its tokens, whether it can be parsed or not.

In: a line. Out: ``Token``: kind and place. An editor colours, names and completes lines that are
being written, so this is no parser; comments are those of the lexer.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

from nctakt.nc.parse.lexer import without_comments

#: A variable as written, with indices and members.
VARIABLE = r"Vs?\.\w+(?:\[[^\[\]]*\])?(?:\.\w+(?:\[[^\[\]]*\])?)*"

_TOKEN = re.compile(
    r"""
    (?P<string>"[^"]*"?)
  | (?P<variable>(?<!\w\w)(?<![\d._])Vs?\.\w*(?:\.\w+)*)
  | (?P<control>\$\w*)
  | (?P<command>\#\s*[A-Z_]\w*(?:\s+[A-Z_]\w*\b(?!\s*[=.\]]))*)
  | (?P<program>^\s*%\s*(?:L\s+)?\S+)
  | (?P<frequency>\b(?:ONCE|EDGE|ALWAYS)\b)
  | (?P<call>\b(?:LL|L)\s+(?:CYCLE\b|[^\s\[=;]+))
  | (?P<block>\bN\s*\d+\s*:?)
  | (?P<function>\b[GMH]\d+(?:\.\d+)?\b|\b[GMH](?=\[))
  | (?P<parameter>@\bP\d+\b|\bP+\d+\b|\bP+(?=\[))
  | (?P<keyword>\b[A-Z_][A-Z_0-9]*(?=\s*=(?!=)))
  | (?P<axisword>(?<![A-Z_])[A-Z](?=[-+]?[\d.\[]))
  | (?P<number>\d+\.?\d*(?:E[-+]?\d+)?|\.\d+)
  | (?P<member>(?<=\])\.\w+(?:\.\w+)*)
  | (?P<name>\b[A-Z_]\w*\b)
  | (?P<operator>\*\*|&&|\|\||[<>=!]=|[-+*/]=|[-+*/<>=!&|^])
    """,
    re.IGNORECASE | re.VERBOSE,
)

#: The value of a word, after its letter.
_VALUE = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)")


class Token(NamedTuple):
    """A token: its kind (a group of the pattern, or ``comment``), its place in the line, text."""

    kind: str
    start: int
    end: int
    text: str


def tokens(line: str) -> Iterator[Token]:
    """Yield the tokens of a line, comments after all other parts."""
    code = without_comments(line)
    for match in _TOKEN.finditer(code):
        kind = match.lastgroup
        assert kind is not None
        start = match.end() - len(match[0].lstrip())
        yield Token(kind, start, match.end(), match[0].strip())
    yield from comments(line, code)


def comments(line: str, code: str) -> Iterator[Token]:
    """Yield the comments of a line; ``code``: the line without them."""
    start = 0
    while start < len(code):
        begin = next((i for i in range(start, len(code)) if code[i] != line[i]), len(code))
        if begin == len(code):
            break
        depth, end = 0, begin
        while end < len(code):
            depth += {"(": 1, ")": -1}.get(line[end], 0)
            end += 1
            if depth == 0:
                break
        yield Token("comment", begin, end, line[begin:end])
        start = end
    if len(code) < len(line):
        yield Token("comment", len(code), len(line), line[len(code) :])


def token_at(line: str, index: int) -> Token | None:
    """Return the token at an index or, if none begins there, the one that ends there."""
    touching = [item for item in tokens(line) if item.start <= index <= item.end]
    return next((item for item in touching if index < item.end), touching[0] if touching else None)


def word_at(line: str, index: int) -> Token | None:
    """Return the token at an index; in the value of a word, as in ``X-2.5``, the whole word.

    The text of that token is its letter.
    """
    found = token_at(line, index)
    if found is None or found.kind not in ("number", "operator"):
        return found
    for item in tokens(line):
        value = _VALUE.match(line, item.end) if item.kind == "axisword" else None
        if value is not None and item.end <= index <= value.end():
            return item._replace(end=value.end())
    return found
