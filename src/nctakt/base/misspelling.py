# SPDX-License-Identifier: MIT
"""Names that differ from a known name in a letter or two.

In: known names, and an unknown one. Out: the known name that it is a misspelling of, if any is. A
letter too many, too few or wrong and two swapped letters are an error each; letter case does not
count. ``text.nearest`` suits names that may differ in more than that.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

#: Maximum number of errors of a name.
_MAX_ERRORS = 2
#: Letters per error: a name of as many may have one error, of twice as many two.
_LETTERS_PER_ERROR = 4
#: Pieces of a name, of which at least one is left whole by two errors.
_PIECES = 4


class KnownNames:
    """Known names, indexed so that a search compares few of them."""

    def __init__(self, names: Iterable[str]) -> None:
        self._by_piece: dict[tuple[int, int, str], list[str]] = {}
        for name in names:
            folded = name.casefold()
            for number, start, size in _bounds(len(folded)):
                key = (len(folded), number, folded[start : start + size])
                self._by_piece.setdefault(key, []).append(name)

    def nearest(self, name: str) -> str | None:
        """Return the known name that ``name`` is a misspelling of, ``None`` if there is none."""
        folded = name.casefold()
        limit = min(_MAX_ERRORS, max(1, len(folded) // _LETTERS_PER_ERROR)) + 1
        best: str | None = None
        for candidate in self._candidates(folded):
            errors = typing_errors(folded, candidate.casefold(), limit)
            if errors < limit:
                limit, best = errors, candidate
        return best

    def _candidates(self, folded: str) -> Iterator[str]:
        """Yield the names that share a piece with this one, at about the same place."""
        seen: dict[str, None] = {}
        for length in range(max(1, len(folded) - _MAX_ERRORS), len(folded) + _MAX_ERRORS + 1):
            for number, start, size in _bounds(length):
                for shift in range(-_MAX_ERRORS, _MAX_ERRORS + 1):
                    begin = max(0, start + shift)
                    key = (length, number, folded[begin : begin + size])
                    for name in self._by_piece.get(key, ()):
                        seen[name] = None
        return iter(seen)


def _bounds(length: int) -> Iterator[tuple[int, int, int]]:
    """Yield number, start and length of the pieces of a name of that length."""
    ends = [length * number // _PIECES for number in range(_PIECES + 1)]
    for number in range(_PIECES):
        yield number, ends[number], ends[number + 1] - ends[number]


def typing_errors(first: str, second: str, limit: int) -> int:
    """Return the number of errors between two names; ``limit`` stands for as many and more."""
    if abs(len(first) - len(second)) >= limit:
        return limit
    shortest = min(len(first), len(second))
    start = 0
    while start < shortest and first[start] == second[start]:
        start += 1
    end = 0
    while end < shortest - start and first[-1 - end] == second[-1 - end]:
        end += 1
    first, second = first[start : len(first) - end], second[start : len(second) - end]
    return min(limit, _edit_distance(first, second, limit))


def _edit_distance(first: str, second: str, limit: int) -> int:
    """Return the restricted Damerau-Levenshtein distance, or ``limit`` if it is not below it."""
    two_above: list[int] = []
    above = list(range(len(second) + 1))
    for row, letter in enumerate(first, start=1):
        line = [row]
        for column, other in enumerate(second, start=1):
            cost = min(
                above[column] + 1,
                line[column - 1] + 1,
                above[column - 1] + (letter != other),
            )
            is_swapped = (
                row > 1 and column > 1 and (letter, first[row - 2]) == (second[column - 2], other)
            )
            if is_swapped:
                cost = min(cost, two_above[column - 2] + 1)
            line.append(cost)
        if min(line) >= limit:
            return limit
        two_above, above = above, line
    return above[-1]
