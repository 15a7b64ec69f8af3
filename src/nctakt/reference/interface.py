# SPDX-License-Identifier: MIT
"""Articles about the interface to the PLC (HLI): its structures and their values."""

from __future__ import annotations

from collections.abc import Iterator

from nctakt.base.diagnostics import Text
from nctakt.hli.layout import (
    AXIS,
    CHANNEL,
    LAMPS,
    PANEL,
    PREFIX,
    SPINDLE,
    STRUCTURES,
    Entry,
    Structure,
)
from nctakt.reference.article import Article, Fact, Topic, fact
from nctakt.reference.interface_german import GERMAN

_STRUCTURE = Text("structure of the interface to the PLC", "Struktur der Schnittstelle zur SPS")
_VALUE = Text("value of the interface to the PLC", "Wert der Schnittstelle zur SPS")
_BY_CNC = Text("the CNC", "die CNC")
_BY_PLC = Text("the PLC", "die SPS")
#: What a PLC in Python calls to see the values of a structure.
_VIEWS = {AXIS.name: "axis", CHANNEL.name: "channel", SPINDLE.name: ""}

#: What the manuals call a value of the interface, and its name here.
_OTHER_NAMES = {"pos_rt": "hli_unit.identifier"}


def _structure(structure: Structure) -> Article:
    names = [entry.name for entry in structure.entries]
    facts = [
        fact("Written by", "Geschrieben von", _BY_PLC if structure.is_command else _BY_CNC),
        fact("Values", "Werte", ", ".join([*names, *structure.units])),
    ]
    return Article(
        structure.name, _STRUCTURE, Text(structure.meaning, GERMAN[structure.name]), tuple(facts)
    )


def _value(structure: Structure, entry: Entry) -> Article:
    name = f"{structure.name}.{entry.name}"
    return Article(
        name,
        _VALUE,
        Text(entry.meaning, GERMAN[name]),
        tuple(_facts(structure, entry)),
    )


def _facts(structure: Structure, entry: Entry) -> Iterator[Fact]:
    yield fact("Type", "Typ", entry.type)
    if entry.count:
        yield fact("Elements", "Elemente", entry.count)
    if entry.unit:
        yield fact("Unit", "Einheit", entry.unit)
    yield fact("Written by", "Geschrieben von", _BY_PLC if structure.is_command else _BY_CNC)
    if entry in (*PANEL, *LAMPS):
        yield fact("From outside", "Von außen", f"{PREFIX}{entry.name.upper()}")
    view = _VIEWS.get(structure.name, "")
    if view == "axis" and entry.source:
        yield fact("In Python", "In Python", f'hli.axis("X")["{entry.name}"]')
    elif view == "channel" and (entry.source or entry in LAMPS):
        yield fact("In Python", "In Python", f'hli.channel()["{entry.name}"]')


def _all() -> Iterator[Article]:
    for structure in STRUCTURES:
        yield _structure(structure)
        for entry in structure.entries:
            yield _value(structure, entry)


def _find(word: str) -> tuple[Article, ...]:
    """Return the articles of a structure, a value with or without its structure, or its name."""
    name = word.lower()
    outside = PREFIX.lower()
    if name.startswith(outside):
        name = name.removeprefix(outside)
    name = _OTHER_NAMES.get(name, name)
    return tuple(
        article for article in _all() if name in (article.name, article.name.rpartition(".")[2])
    )


def _names() -> Iterator[str]:
    for structure in STRUCTURES:
        yield structure.name
        for entry in structure.entries:
            yield f"{structure.name}.{entry.name}"


HLI = Topic(
    "hli",
    Text("The interface to the PLC (HLI)", "Die Schnittstelle zur SPS (HLI)"),
    ("hli_axis", "path_speed", "HLI.OVERRIDE"),
    _all,
    _find,
    _names,
)
