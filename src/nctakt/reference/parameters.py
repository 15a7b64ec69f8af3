# SPDX-License-Identifier: MIT
"""Articles about parameters of lists, from their schemas, and about the controller's numbers."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import groupby

from nctakt.base.diagnostics import Text
from nctakt.lists.all_parameters import (
    SCHEMAS,
    DeclaredParameter,
    find_parameters,
    similar_parameters,
)
from nctakt.lists.format.controller_numbers import (
    CASES,
    ParameterNumber,
    all_numbers,
    numbers_of,
    parameters_of,
)
from nctakt.lists.format.parameter import Effect, Parameter, Relevance, ValueType, range_text, shown
from nctakt.lists.format.schema import Schema
from nctakt.reference.article import Article, Fact, Topic, fact, same

#: Maximum number of names of a value in an article.
_MANY_NAMES = 20


#: The subjects of parameters, as in the tables.
CONCERNS: dict[str, Text] = {
    "compensation": Text("compensations", "Kompensationen"),
    "control": Text("position control", "die Lageregelung"),
    "coupling": Text("couplings of axes", "Achskopplungen"),
    "diagnosis": Text("diagnosis", "die Diagnose"),
    "display": Text("displays", "Anzeigen"),
    "drive": Text("the drive", "den Antrieb"),
    "dynamics": Text("dynamics", "die Dynamik"),
    "files": Text("files", "Dateien"),
    "filter": Text("filters", "Filter"),
    "homing": Text("homing", "die Referenzpunktfahrt"),
    "limits": Text("limits", "Grenzen"),
    "manual": Text("manual mode", "den Handbetrieb"),
    "measuring": Text("measuring", "das Messen"),
    "memory": Text("memory", "den Speicher"),
    "motion": Text("motion", "die Bewegung"),
    "offset": Text("offsets", "Verschiebungen"),
    "other": Text("other matters", "Sonstiges"),
    "plc": Text("the PLC", "die SPS"),
    "program": Text("NC programs", "NC-Programme"),
    "safety": Text("safety", "die Sicherheit"),
    "schedule": Text("scheduling", "das Scheduling"),
    "spindle": Text("spindles", "Spindeln"),
    "technology": Text("technology functions", "Technologiefunktionen"),
    "tool": Text("tools", "Werkzeuge"),
    "transformation": Text("transformations", "Transformationen"),
    "variables": Text("variables", "Variablen"),
}


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


def article(schema: Schema, parameter: Parameter) -> Article:
    """Return the article of one parameter of a kind of list."""
    name = " ".join(dict.fromkeys(word for word in (parameter.id, parameter.path) if word))
    return Article(name, kind_of(schema), parameter.text, tuple(_facts(parameter)))


def kind_of(schema: Schema) -> Text:
    """Return the kind of list that has the parameters of a schema."""
    return Text(f"parameter, {schema.title.en}", f"Parameter, {schema.title.de}")


def _facts(parameter: Parameter) -> Iterator[Fact]:
    yield fact("Type", "Typ", parameter.type.value)
    allowed = range_text(parameter)
    if allowed:
        yield fact("Range", "Bereich", allowed)
    if parameter.names:
        names = list(_values_of(parameter))
        more = " …" if len(names) > _MANY_NAMES or parameter.has_more_names else ""
        yield fact("Values", "Werte", ", ".join(names[:_MANY_NAMES]) + more)
    if parameter.unit:
        yield fact("Unit", "Einheit", parameter.unit)
    yield fact("Default", "Standardwert", default_text(parameter))
    if parameter.restart:
        yield fact(
            "Change",
            "Änderung",
            Text("takes effect at the next start", "gilt ab dem nächsten Start"),
        )
    for alias in parameter.aliases:
        yield fact("Old name", "Alter Name", f"{alias.id} {alias.path}".strip())
    if parameter.concern:
        yield fact("Concerns", "Betrifft", CONCERNS[parameter.concern])
    yield fact("In nctakt", "In nctakt", effect(parameter))
    for one in numbers_of(parameter.id):
        if one.case != "other":
            yield Fact(same(one.number), CASES[one.case])
    if parameter.page:
        yield fact("Help page", "Hilfeseite", parameter.page)


def default_text(parameter: Parameter) -> str:
    """Return the default as written in a list: a value, or the ID of the parameter with it."""
    return parameter.default_id or shown(parameter.default)


def _values_of(parameter: Parameter) -> Iterator[str]:
    """Yield the names that a value may have, each with its number."""
    for name, number in parameter.names.items():
        is_number = parameter.type is ValueType.NAME and number is not None
        yield f"{name} ({number})" if is_number else name


def effect(parameter: Parameter) -> Text:
    """Return the effect of a parameter."""
    if parameter.effect is Effect.USED:
        return Text("takes effect", "wirkt")
    match parameter.relevance:
        case Relevance.YES:
            return Text(
                "checked, no effect; would change a run",
                "geprüft, ohne Wirkung; würde einen Lauf ändern",
            )
        case Relevance.MAYBE:
            return Text(
                "checked, no effect; may change a run",
                "geprüft, ohne Wirkung; kann einen Lauf ändern",
            )
    return Text("checked, no effect", "geprüft, ohne Wirkung")


def _all() -> Iterator[Article]:
    for schema in SCHEMAS:
        for parameter in schema.parameters:
            yield article(schema, parameter)


def _articles(declared_parameters: Iterable[DeclaredParameter]) -> tuple[Article, ...]:
    return tuple(article(declared.schema, declared.parameter) for declared in declared_parameters)


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


def number_article(number: int, rows: tuple[ParameterNumber, ...]) -> Article:
    """Return the article of one number: its parameters, and its meaning for them."""
    return Article(str(number), _KIND, _FOUND[rows[0].found], tuple(map(_fact, rows)))


def _fact(one: ParameterNumber) -> Fact:
    names = {found.parameter.pattern for found in find_parameters(one.id)}
    return Fact(same(" ".join((one.id, *sorted(names)))), CASES[one.case])


def _all_numbers() -> Iterator[Article]:
    for number, rows in groupby(all_numbers(), key=lambda one: one.number):
        yield number_article(number, tuple(rows))


def _find_number(word: str) -> tuple[Article, ...]:
    rows = parameters_of(int(word)) if word.isascii() and word.isdigit() else ()
    return (number_article(int(word), rows),) if rows else ()


def _number_names() -> Iterator[str]:
    return (str(number) for number in sorted({one.number for one in all_numbers()}))


PARAMETER_NUMBERS = Topic(
    "numbers",
    Text("Numbers of the controller for parameters", "Nummern der Steuerung für Parameter"),
    ("110087", "110101"),
    _all_numbers,
    _find_number,
    _number_names,
)
