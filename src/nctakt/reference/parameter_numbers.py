# SPDX-License-Identifier: MIT
"""Articles about the controller's numbers for values of parameters."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import groupby

from nctakt.base.diagnostics import Text
from nctakt.lists.all_parameters import find_parameters
from nctakt.lists.format.controller_numbers import (
    CASES,
    ParameterNumber,
    all_numbers,
    parameters_of,
)
from nctakt.reference.article import Article, Fact, Topic, same

_KIND = Text("number of the controller for a parameter", "Nummer der Steuerung für einen Parameter")
_FOUND = {
    "list": Text(
        "The controller reports it when it reads the list.",
        "Die Steuerung meldet sie, wenn sie die Liste liest.",
    ),
    "run": Text(
        "The controller reports it while it works, not when it reads the list.",
        "Die Steuerung meldet sie im Betrieb, nicht schon beim Lesen der Liste.",
    ),
}


def article(number: int, rows: tuple[ParameterNumber, ...]) -> Article:
    """The article of one number: its parameters, and its meaning for them."""
    return Article(str(number), _KIND, _FOUND[rows[0].found], tuple(map(_fact, rows)))


def _fact(one: ParameterNumber) -> Fact:
    names = {found.parameter.pattern for found in find_parameters(one.id)}
    return Fact(same(" ".join((one.id, *sorted(names)))), CASES[one.case])


def _all() -> Iterator[Article]:
    for number, rows in groupby(all_numbers(), key=lambda one: one.number):
        yield article(number, tuple(rows))


def _find(word: str) -> tuple[Article, ...]:
    rows = parameters_of(int(word)) if word.isascii() and word.isdigit() else ()
    return (article(int(word), rows),) if rows else ()


def _names() -> Iterator[str]:
    return (str(number) for number in sorted({one.number for one in all_numbers()}))


PARAMETER_NUMBERS = Topic(
    "numbers",
    Text("Numbers of the controller for parameters", "Nummern der Steuerung für Parameter"),
    ("110087", "110101"),
    _all,
    _find,
    _names,
)
