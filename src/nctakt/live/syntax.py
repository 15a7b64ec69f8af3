# SPDX-License-Identifier: MIT
"""The colours of a program's lines on the page: those that the language server has.

In: the lines of a text, the range in view. Out: their texts with tokens; the browser compares the
texts with its own, since the user may have typed meanwhile.
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.editor.token_colours import Surroundings, coloured

#: Lines that are coloured at a time, and characters of a line.
MAX_LINES, MAX_CHARACTERS = 400, 2000

#: A token for the browser: its columns, as it counts them, and its classes.
Token = tuple[int, int, str]


class Syntax:
    """The colours of one browser; ``synchronous``: variables that are read in each tick."""

    def __init__(self, synchronous: frozenset[str]) -> None:
        self._synchronous = synchronous
        self._lines: Sequence[str] = [""]
        self._surroundings = Surroundings(self._lines)

    def shown(self, lines: Sequence[str], first: int, last: int) -> list[tuple[str, list[Token]]]:
        """Return the lines from ``first`` to ``last``, from 1, with their tokens."""
        if lines is not self._lines:
            self._lines, self._surroundings = lines, Surroundings(lines)
        begin = max(first, 1) - 1
        shown = lines[begin : min(last, begin + MAX_LINES)]
        return [(line, self._tokens(line, number)) for number, line in enumerate(shown, begin)]

    def _tokens(self, line: str, number: int) -> list[Token]:
        code = line[:MAX_CHARACTERS]
        return [
            (units(code, one.start), units(code, one.end), _classes(one.type, one.modifier))
            for one in coloured(code, self._surroundings.of(number), self._synchronous)
        ]


def units(line: str, index: int) -> int:
    """Return a column as browsers count it: in units of UTF-16."""
    if line.isascii():
        return index
    return len(line[:index].encode("utf-16-le", "surrogatepass")) // 2


def _classes(kind: str, modifier: str) -> str:
    return f"nc-t-{kind} nc-t-realtime" if modifier == "realtime" else f"nc-t-{kind}"
