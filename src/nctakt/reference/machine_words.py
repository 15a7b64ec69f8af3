# SPDX-License-Identifier: MIT
"""Articles about words of a program as the lists of a machine have them: axes, F, M and H.

In: a machine, a word. Out: articles; where the channels of the machine differ, one for each.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import isfinite

from nctakt.base.diagnostics import Text, number_text
from nctakt.lists.declared.technology_functions import TechnologyFunction
from nctakt.lists.machine.axis_configuration import AxisConfiguration, AxisType
from nctakt.lists.machine.machine import ChannelConfiguration, Machine
from nctakt.nc.vocabulary.functions import SPINDLE_FUNCTIONS
from nctakt.nc.vocabulary.words import TECHNOLOGY
from nctakt.reference.article import Article, Fact, fact, same

_TYPES = {
    AxisType.LINEAR: Text("linear axis, positions in mm", "Linearachse, Positionen in mm"),
    AxisType.ROTARY: Text("rotary axis, positions in degrees", "Rundachse, Positionen in Grad"),
    AxisType.SPINDLE: Text("spindle, positions in degrees", "Spindel, Positionen in Grad"),
}
_NONE = Text("none", "keine")


def axis_articles(machine: Machine, name: str) -> tuple[Article, ...]:
    """Return the articles of an axis or spindle of this name, one for each channel that has it."""
    found = []
    for channel in machine.channels:
        members = [(axis.name, axis.index) for axis in channel.axes]
        members += [(item.name, item.index) for item in channel.spindles if item.index is not None]
        for member, index in members:
            if member == name.upper():
                found.append((channel, _axis_article(machine, name.upper(), machine.axes[index])))
    return _distinguished(machine, found)


def feed_articles(machine: Machine) -> tuple[Article, ...]:
    """Return the articles of F: its unit, and the feed at the start of a program."""
    found = []
    for channel in machine.channels:
        start = channel.parameters.program_start
        unit = number_text(start.feed_unit_mm_min)
        facts = [
            fact(
                "F1 means",
                "F1 bedeutet",
                Text(
                    f"{unit} mm/min with G94 and G71; another unit with G70, G93, G95, G194",
                    f"{unit} mm/min bei G94 und G71; anderes bei G70, G93, G95, G194",
                ),
            )
        ]
        if start.feed_mm_min:
            feed = f"{number_text(start.feed_mm_min)} mm/min"
            facts.append(fact("At program start", "Bei Programmstart", feed))
        meaning = Text("feed of the path", "Vorschub der Bahn")
        found.append((channel, Article("F", _kind(machine, "word", "Wort"), meaning, tuple(facts))))
    return _distinguished(machine, found)


def function_articles(machine: Machine, letter: str, number: int) -> tuple[Article, ...]:
    """Return the articles of an M or H function that the channel lists define."""
    found = []
    for channel in machine.channels:
        function = _function(channel, letter.upper(), number)
        if function is not None:
            name = f"{letter.upper()}{number}"
            found.append((channel, _function_article(machine, name, function)))
    return _distinguished(machine, found)


def _function(channel: ChannelConfiguration, letter: str, number: int) -> TechnologyFunction | None:
    """Return a function of the channel list; of the main spindle where it turns that."""
    parameters = channel.parameters
    if letter == "M" and number in SPINDLE_FUNCTIONS and channel.main_spindle is not None:
        return channel.main_spindle.spindle.functions.get(f"m{number}")
    listed = parameters.m_functions if letter == "M" else parameters.h_functions
    return listed.get(number)


def _function_article(machine: Machine, name: str, function: TechnologyFunction) -> Article:
    synchronisation = function.synchronisation
    known = TECHNOLOGY.get(synchronisation)
    meaning = same(synchronisation)
    if known is not None:
        meaning = Text(
            f"{synchronisation}: {known.meaning.en}", f"{synchronisation}: {known.meaning.de}"
        )
    facts = [fact("Synchronisation", "Synchronisation", meaning)]
    if function.modifiers:
        facts.append(fact("Modifiers", "Zusätze", ", ".join(function.modifiers)))
    time_ms = function.process_time_us / 1000
    time = same(f"{number_text(time_ms)} ms") if time_ms else _NONE
    facts.append(fact("Process time", "Prozesszeit", time))
    if function.axis_name:
        facts.append(fact("Output to axis", "Ausgabe an Achse", function.axis_name))
    kind = _kind(machine, "function", "Funktion")
    return Article(name, kind, Text("as its channel list says", "laut Kanalliste"), tuple(facts))


def _axis_article(machine: Machine, name: str, axis: AxisConfiguration) -> Article:
    kind = _kind(machine, "axis", "Achse")
    return Article(name, kind, _TYPES[axis.type], tuple(_axis_facts(axis)))


def _axis_facts(axis: AxisConfiguration) -> Iterator[Fact]:
    unit = "mm" if axis.is_linear else "°"
    low, high = axis.reachable
    yield fact("Logical number", "Logische Nummer", axis.logical_number)
    if axis.is_modulo:
        span = f"{number_text(low)} … {number_text(high)} {unit}"
        yield fact("Modulo range", "Modulobereich", span)
    elif isfinite(low) and isfinite(high):
        span = f"{number_text(low)} … {number_text(high)} {unit}"
        yield fact("Software limits", "Software-Endschalter", span)
    if axis.type is AxisType.SPINDLE:
        speed = number_text(axis.max_speed / 6)
        yield fact("Highest speed", "Höchste Drehzahl", f"{speed} 1/min")
        return
    for en, de, value in (
        ("Speed of G00", "Geschwindigkeit von G00", axis.rapid_speed),
        ("Highest speed", "Höchste Geschwindigkeit", axis.max_speed),
    ):
        yield fact(en, de, f"{number_text(value * 60)} {unit}/min")
    acceleration = f"{number_text(axis.max_acceleration)} {unit}/s²"
    yield fact("Acceleration, trapezoid", "Beschleunigung, Trapez", acceleration)


def _kind(machine: Machine, en: str, de: str) -> Text:
    return Text(f"{en} of the machine {machine.name}", f"{de} der Maschine {machine.name}")


def _distinguished(
    machine: Machine, found: list[tuple[ChannelConfiguration, Article]]
) -> tuple[Article, ...]:
    """Return each article once; with the number of its channel where the channels differ."""
    different = list(dict.fromkeys(article for _, article in found))
    if len(different) <= 1:
        return tuple(different)
    return tuple(
        Article(
            article.name,
            Text(
                f"{article.kind.en}, channel {channel.number}",
                f"{article.kind.de}, Kanal {channel.number}",
            ),
            article.meaning,
            article.facts,
        )
        for channel, article in found
    )
