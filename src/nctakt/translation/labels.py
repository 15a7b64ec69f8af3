# SPDX-License-Identifier: MIT
"""The labels of ``CASE`` as ranges: where each leads, and the values that a run must come near.

In: a checked ``CASE``. Out: ranges with the number of their branch; of a run that counts, also the
values for which no label is written, which lead to ELSE.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from nctakt.st.tree import Case
from nctakt.st.types import Elementary, EnumType
from nctakt.translation.layout import as_word

#: Lowest and highest label, and the number of their target.
LabelRange = tuple[int, int, int]

_GREATEST = (1 << 63) - 1


def labels_of(written: Case) -> list[LabelRange]:
    """Return the labels by branches, without those that an earlier one covers (ST-511)."""
    kept: list[LabelRange] = []
    for number, branch in enumerate(written.branches):
        for label in branch.labels:
            left = _without(label.first, label.last, kept)
            kept += [(first, last, number) for first, last in left]
    return kept


def _without(low: int, high: int, ranges: list[LabelRange]) -> list[tuple[int, int]]:
    """Return the parts of a range that lie in none of the others."""
    pieces = [(low, high)]
    for first, last, _ in ranges:
        rest: list[tuple[int, int]] = []
        for begin, end in pieces:
            if end < first or begin > last:
                rest.append((begin, end))
                continue
            if begin < first:
                rest.append((begin, first - 1))
            if end > last:
                rest.append((last + 1, end))
        pieces = rest
    return pieces


def as_signed(label: LabelRange) -> Iterator[LabelRange]:
    """Yield a range as signed words of 64 bits: from 2⁶³ on labels of ULINT are negative there."""
    first, last, number = label
    if first <= _GREATEST:
        yield first, min(last, _GREATEST), number
    if last > _GREATEST:
        yield as_word(max(first, _GREATEST + 1)), as_word(last), number


def seen_labels(
    written: Case, ranges: list[LabelRange], kind: Elementary | EnumType, counted: Mapping[int, int]
) -> list[tuple[float, float, int]]:
    """Return ranges of the selector with the number that counts the body to which they lead."""
    numbers = [counted.get(id(branch.body)) for branch in written.branches]
    found = [(first, last, numbers[index]) for first, last, index in ranges]
    otherwise = counted.get(id(written.otherwise))
    if otherwise is not None:
        base = kind.base if isinstance(kind, EnumType) else kind
        left = _without(base.low, base.high, ranges)
        found += [(first, last, otherwise) for first, last in left]
    return [
        (float(first), float(last), number) for first, last, number in found if number is not None
    ]
