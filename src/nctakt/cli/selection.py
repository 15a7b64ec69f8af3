# SPDX-License-Identifier: MIT
"""``--select`` and ``--ignore``: the messages that a check reports and counts.

In: words such as ``22009``, ``9002`` (all with this prefix), ``22000-22099``, ``NCTAKT22009``,
separated by commas. Out: a ``Selection``; a word without a message is a ``Failure`` (900586).
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from nctakt.base.dataclass import dataclass
from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.catalogue import catalogue
from nctakt.messages.checking import NO_MESSAGE_SELECTED

#: The prefix of a message's number among the rules of other tools.
RULE_PREFIX = "NCTAKT"

_WORD = re.compile(rf"(?:{RULE_PREFIX})?([0-9]+)(?:-(?:{RULE_PREFIX})?([0-9]+))?", re.IGNORECASE)


@dataclass(frozen=True, slots=True)
class Selection:
    """The selected numbers; ``selected`` ``None``: all except the ignored ones."""

    selected: frozenset[int] | None = None
    ignored: frozenset[int] = frozenset()

    def includes(self, number: int) -> bool:
        """Return whether a message is selected and not ignored."""
        chosen = self.selected is None or number in self.selected
        return chosen and number not in self.ignored


def read_selection(select: Sequence[str], ignore: Sequence[str]) -> Selection:
    """Return the selection of both options; raises one ``Failure`` for all mistakes."""
    wrong: list[str] = []
    selected = frozenset(_numbers(select, wrong))
    ignored = frozenset(_numbers(ignore, wrong))
    if wrong:
        raise Failure(*(diagnostic(NO_MESSAGE_SELECTED, text=text) for text in wrong))
    return Selection(selected if select else None, ignored)


def _numbers(words: Sequence[str], wrong: list[str]) -> Iterator[int]:
    for text in (part.strip() for word in words for part in word.split(",")):
        match = _WORD.fullmatch(text)
        fitting = [] if match is None else _fitting(match[1], match[2])
        if not fitting:
            wrong.append(text)
        yield from fitting


def _fitting(first: str, last: str | None) -> list[int]:
    """Return the messages of a range, with a number, or with a prefix."""
    if last is not None:
        low, high = int(first), int(last)
        return [number for number in catalogue() if low <= number <= high]
    if int(first) in catalogue():
        return [int(first)]
    return [number for number in catalogue() if str(number).startswith(first)]
