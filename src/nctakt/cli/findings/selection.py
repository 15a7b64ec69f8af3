# SPDX-License-Identifier: MIT
"""``--select`` and ``--ignore``: the messages that a check reports and counts.

In: words such as ``22009``, ``9002`` (all with this prefix), ``22000-22099``, ``NCTAKT22009``,
separated by commas. Out: a ``Selection``; a word without a message is a ``Failure`` (900586).
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import cache

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.lists.format.controller_numbers import all_numbers
from nctakt.messages import diagnostic
from nctakt.messages.catalogue import catalogue
from nctakt.messages.commands.checking import NO_MESSAGE_SELECTED

#: The prefix of a message's number among the rules of other tools.
RULE_PREFIX = "NCTAKT"

_WORD = re.compile(rf"(?:{RULE_PREFIX})?([0-9]+)(?:-(?:{RULE_PREFIX})?([0-9]+))?", re.IGNORECASE)


@dataclass(frozen=True, slots=True)
class Selection:
    """The selected numbers, leading or not; ``selected`` ``None``: all except the ignored ones."""

    selected: frozenset[int] | None = None
    ignored: frozenset[int] = frozenset()

    def includes(self, finding: Diagnostic) -> bool:
        """Return whether a finding is selected by one of its numbers, and ignored by none."""
        numbers = {finding.id, *finding.also}
        chosen = self.selected is None or not numbers.isdisjoint(self.selected)
        return chosen and numbers.isdisjoint(self.ignored)


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
    """Return the numbers of a range, the number itself, or those with a prefix."""
    if last is not None:
        low, high = int(first), int(last)
        return sorted(number for number in _numbers_of_all() if low <= number <= high)
    if int(first) in _numbers_of_all():
        return [int(first)]
    return sorted(number for number in _numbers_of_all() if str(number).startswith(first))


@cache
def _numbers_of_all() -> frozenset[int]:
    """Return the numbers of all messages and of the values of parameters."""
    numbers = {number for message in catalogue() for number in message.numbers}
    return frozenset(numbers.union(one.number for one in all_numbers()))
