# SPDX-License-Identifier: MIT
"""Articles about parameters of lists, from their schemas."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from nctakt.base.diagnostics import Text
from nctakt.lists.all_parameters import (
    SCHEMAS,
    DeclaredParameter,
    find_parameters,
    similar_parameters,
)
from nctakt.lists.format.parameter import Effect, Parameter, Schema, ValueType, shown
from nctakt.reference.article import Article, Fact, Topic, fact

_NUMBERS = frozenset(
    (
        ValueType.SGN08,
        ValueType.UNS08,
        ValueType.SGN16,
        ValueType.UNS16,
        ValueType.SGN32,
        ValueType.UNS32,
        ValueType.REAL64,
    )
)
#: Names of a value of which no more are told.
_MANY_NAMES = 20


def article(schema: Schema, parameter: Parameter) -> Article:
    """The article of one parameter of a kind of list."""
    name = f"{parameter.id} {parameter.path}".strip()
    return Article(name, kind_of(schema), parameter.text, tuple(_facts(parameter)))


def kind_of(schema: Schema) -> Text:
    """Where its parameters stand."""
    return Text(f"parameter, {schema.title.en}", f"Parameter, {schema.title.de}")


def _facts(parameter: Parameter) -> Iterator[Fact]:
    yield fact("Type", "Typ", parameter.type.value)
    allowed = range_of(parameter)
    if allowed:
        yield fact("Range", "Bereich", allowed)
    if parameter.names:
        names = list(_values_of(parameter))
        more = " …" if len(names) > _MANY_NAMES else ""
        yield fact("Values", "Werte", ", ".join(names[:_MANY_NAMES]) + more)
    if parameter.unit:
        yield fact("Unit", "Einheit", parameter.unit)
    yield fact("Default", "Standardwert", shown(parameter.default))
    if parameter.restart:
        yield fact(
            "Change",
            "Änderung",
            Text("counts from the next start on", "gilt ab dem nächsten Start"),
        )
    for alias in parameter.aliases:
        yield fact("Old name", "Alter Name", alias.path)
    yield fact("In nctakt", "In nctakt", effect(parameter))


def _values_of(parameter: Parameter) -> Iterator[str]:
    """The names that a value may have, with the number that says the same."""
    for name, number in parameter.names.items():
        is_number = parameter.type is ValueType.NAME and number is not None
        yield f"{name} ({number})" if is_number else name


def range_of(parameter: Parameter) -> str:
    """``1 … 65534``; for a text its greatest length; empty where there is none to tell."""
    if parameter.type is ValueType.STRING:
        return "" if parameter.high is None else f"≤ {parameter.high}"
    if parameter.type not in _NUMBERS:
        return ""
    low, high = parameter.bounds
    infinite = float("inf")
    if (low, high) == (-infinite, infinite):
        return ""
    return f"{_bound(low)} … {_bound(high)}"


def _bound(value: int | float) -> str:
    if value in (float("inf"), float("-inf")):
        return "∞" if value > 0 else "−∞"
    return str(value)


def effect(parameter: Parameter) -> Text:
    """Whether nctakt does what it says."""
    match parameter.effect:
        case Effect.TAKEN:
            return Text("takes effect", "wirkt")
        case Effect.CHECKED:
            return Text("read and checked, changes nothing", "gelesen und geprüft, ändert nichts")
        case Effect.ACCEPTED:
            return Text("accepted, has no effect", "wird angenommen, wirkt nicht")


def _all() -> Iterator[Article]:
    for schema in SCHEMAS:
        for parameter in schema.parameters:
            yield article(schema, parameter)


def _articles(found: Iterable[DeclaredParameter]) -> tuple[Article, ...]:
    return tuple(article(one.schema, one.parameter) for one in found)


def _find(word: str) -> tuple[Article, ...]:
    return _articles(find_parameters(word))


def _find_similar(word: str) -> tuple[Article, ...]:
    return _articles(similar_parameters(word))


def _names() -> Iterator[str]:
    for schema in SCHEMAS:
        for parameter in schema.parameters:
            if parameter.id:
                yield parameter.id
            yield parameter.pattern


PARAMETERS = Topic(
    "parameters",
    Text("Parameters of lists by ID or name", "Parameter der Listen nach ID oder Name"),
    ("P-CHAN-00425", "rt_cycles.max_duration"),
    _all,
    _find,
    _names,
    _find_similar,
)
