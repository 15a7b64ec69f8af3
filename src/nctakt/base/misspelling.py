# SPDX-License-Identifier: MIT
"""The known name probably meant by an unknown one.

In: known names, and an unknown one. Out: the known name that it is a misspelling of, if any is. A
letter too many, too few or wrong and two swapped letters are an error each; letter case does not
count. Names that differ in their numbers, other than by a doubled or swapped digit, are different
names, as are short ones that begin with different letters: a suggestion must be the intended name.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from functools import lru_cache
from typing import NamedTuple

#: Maximum number of errors of a name, and the lengths from which on it may have them.
_MAX_ERRORS = 2
_LENGTHS = ((8, 2), (3, 1))
#: Maximum distance of two names if one is the beginning or the end of the other.
_FARTHEST = 2 * _MAX_ERRORS + 3
#: Names up to this length must begin with the right letter.
_SHORT = 4
#: Least number of letters of a beginning or end.
_PART = 3
#: Pieces of a name, of which at least one is left whole by two errors.
_PIECES = 4
_NUMBERS = re.compile(r"\d+")
_DOUBLED = re.compile(r"(\d)\1+")
_VARIABLE = re.compile(r"vs?\.[a-z]+\.")


def nearest(name: str, names: Iterable[str]) -> str:
    """Return the known name probably meant by ``name``; empty if none or several might be.

    Besides typing errors it may have the parts of a path in another order, or be the beginning or
    the end of the known name, or the known name of it.
    """
    folded = name.casefold()
    best, rank, is_only = "", _FARTHEST + 1, True
    for known in names:
        found = _rank(folded, known.casefold())
        if found is not None and found <= rank and known != best:
            is_only = found < rank
            best, rank = known, found
    return best if is_only else ""


def nearest_item(item: str, labels: Iterable[str]) -> str:
    """Return the label ``TYPE.ITEM`` probably meant by an item with or without its type."""
    known = list(labels)
    label = nearest(item, known)
    if label or "." in item:
        return label
    name = nearest(item, (one.rpartition(".")[2] for one in known))
    return next((one for one in known if one.rpartition(".")[2] == name), "")


def resembles(name: str, names: Iterable[str]) -> bool:
    """Return whether ``name`` may mean one or several of the known names."""
    return any(_rank(name.casefold(), known.casefold()) is not None for known in names)


def nearest_first(name: str, names: Iterable[str]) -> list[str]:
    """Return known names in order, but first the one meant by ``name``."""
    known = list(names)
    meant = nearest(name, known)
    return sorted(known, key=lambda other: other != meant)


def _rank(name: str, known: str) -> int | None:
    """Return the distance of two folded names, ``None`` if neither may mean the other."""
    if name == known:
        return 0
    path, other = _path_of(name), _path_of(known)
    if len(path.inner) > 1 and path.inner == other.inner:
        return 1
    first, second = _without_common_parts(path.parts, other.parts)
    shorter, longer = sorted((first, second), key=len)
    is_beginning, is_end = longer.startswith(shorter), longer.endswith(shorter)
    allowed = allowed_errors(first)
    if len(longer) - len(shorter) <= allowed:
        errors = typing_errors(first, second, allowed + 1)
        if errors <= allowed and _may_be(first, second):
            return 2 * errors + (not is_beginning)
    if not (is_beginning or is_end) or len(shorter) < _PART:
        return None
    is_whole = longer.startswith(f"{shorter}_") or longer.endswith(f"_{shorter}")
    has_same_numbers = sum(map(str.isdigit, first)) == sum(map(str.isdigit, second))
    if (is_whole or len(shorter) * 2 >= len(longer)) and has_same_numbers:
        return _FARTHEST - is_beginning
    return None


class _Path(NamedTuple):
    """The parts of a name; ``inner``: those without the family of a variable, sorted."""

    parts: tuple[str, ...]
    inner: tuple[str, ...]


@lru_cache(maxsize=4096)
def _path_of(folded: str) -> _Path:
    return _Path(tuple(folded.split(".")), tuple(sorted(_VARIABLE.sub("", folded).split("."))))


def _without_common_parts(parts: tuple[str, ...], others: tuple[str, ...]) -> tuple[str, str]:
    """Return the rest of two paths without the parts shared at both ends."""
    limit = min(len(parts), len(others)) - 1
    begin = 0
    while begin < limit and parts[begin] == others[begin]:
        begin += 1
    end = 0
    while end < limit - begin and parts[-1 - end] == others[-1 - end]:
        end += 1
    return ".".join(parts[begin : len(parts) - end]), ".".join(others[begin : len(others) - end])


def allowed_errors(name: str) -> int:
    """Return how many errors a misspelt name may have."""
    return next((errors for length, errors in _LENGTHS if len(name) >= length), 0)


def _may_be(name: str, known: str) -> bool:
    """Return whether a name that differs by a few errors may mean the known one."""
    has_same_letters = sorted(name) == sorted(known)
    if _numbers(name) != _numbers(known) and not (has_same_letters and len(name) > _SHORT):
        return False
    return len(name) > _SHORT or name[:1] == known[:1] or has_same_letters


def _numbers(name: str) -> list[str]:
    """Return the numbers in a name, without leading zeros, a doubled digit as one."""
    return [_DOUBLED.sub(r"\1", digits.lstrip("0")) for digits in _NUMBERS.findall(name)]


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
        limit = allowed_errors(folded) + 1
        best: str | None = None
        for candidate in self._candidates(folded):
            errors = typing_errors(folded, candidate.casefold(), limit)
            if errors < limit and _may_be(folded, candidate.casefold()):
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
    """Return the number of errors between two names; ``limit`` means that many or more."""
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
