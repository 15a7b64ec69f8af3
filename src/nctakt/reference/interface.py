# SPDX-License-Identifier: MIT
"""Articles about the interface to the PLC (HLI): its structures and their values."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cache

from nctakt.base.diagnostics import Text
from nctakt.hli import table
from nctakt.hli.layout import (
    AXIS,
    CHANNEL,
    LAMPS,
    PANEL,
    PREFIX,
    SPINDLE,
    SPINDLE_COMMAND,
    SPINDLE_OVERRIDE,
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
#: Calls by which a PLC in Python reads the values of a structure.
_VIEWS = {AXIS.name: "axis", CHANNEL.name: "channel", SPINDLE.name: ""}

#: The manuals' name of a value of the interface, and its name here.
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
    yield fact("Type", "Typ", entry.image_type)
    if entry.count:
        yield fact("Elements", "Elemente", entry.count)
    if entry.image_unit:
        yield fact("Unit", "Einheit", entry.image_unit)
    if entry.member != entry.name:
        yield fact("Name in memory", "Name im Speicher", entry.member)
    yield fact("Written by", "Geschrieben von", _BY_PLC if structure.is_command else _BY_CNC)
    if entry in (*PANEL, *LAMPS):
        yield fact("From outside", "Von außen", f"{PREFIX}{entry.name.upper()}")
    paths = _paths_of(structure, entry)
    if paths:
        yield fact("On the controller", "Auf der Steuerung", ", ".join(paths))
    view = _VIEWS.get(structure.name, "")
    if view == "axis" and entry.source:
        yield fact("In Python", "In Python", f'hli.axis("X")["{entry.name}"]')
    elif view == "channel" and (entry.source or entry in LAMPS):
        yield fact("In Python", "In Python", f'hli.channel()["{entry.name}"]')


@cache
def _paths() -> Mapping[tuple[str, bool], list[str]]:
    """Return the controller's paths of each value of the session, and whether it is an axis'."""
    found: dict[tuple[str, bool], list[str]] = {}
    for path, element in table.patterns().items():
        tie = element.tie
        if tie is not None and element.row is not None and element.inner is None:
            is_axis = element.root == "gpAx" or "coord_r" in path
            found.setdefault((tie.name, is_axis), []).append(path)
    return found


def _paths_of(structure: Structure, entry: Entry) -> Sequence[str]:
    """Return the paths of the controller that show a value or set it."""
    is_panel = entry in (*PANEL, *LAMPS)
    name = f"{PREFIX}{entry.name.upper()}" if is_panel else entry.source
    return _paths().get((name, structure is AXIS), []) if name else []


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
        spindle, dot, value = name.rpartition(".")
        if dot and value == SPINDLE_OVERRIDE.name and "." not in spindle:
            name = f"{SPINDLE_COMMAND.name}.{value}"  # HLI.S2.OVERRIDE
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
