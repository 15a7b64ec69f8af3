# SPDX-License-Identifier: MIT
"""Names of the tracks of a run, in both languages."""

from __future__ import annotations

from nctakt.base.diagnostics import Language, Text
from nctakt.results.timelines.timeline import TrackKind

PROGRAM = Text("program", "Programm")
CYCLES = Text("realtime cycles", "Echtzeit-Zyklen")
FUNCTIONS = Text("M and H functions", "M- und H-Funktionen")
MOTIONS = Text("axes and spindles", "Achsen und Spindeln")
SIGNALS = Text("signals", "Signale")

_KINDS: dict[TrackKind, Text] = {
    "program": Text("program", "Programm"),
    "channel": Text("channel", "Kanal"),
    "block": Text("block", "Satz"),
    "wait": Text("waits for", "wartet auf"),
    "cycle": Text("cycle", "Zyklus"),
    "condition": Text("condition", "Bedingung"),
    "reaction": Text("reaction", "Reaktion"),
    "function": Text("function", "Funktion"),
    "axis": Text("axis", "Achse"),
    "spindle": Text("spindle", "Spindel"),
    "message": Text("message", "Meldung"),
    "error": Text("error", "Fehler"),
    "starved": Text("no commands", "keine Befehle"),
    "overflow": Text("overflow", "Überlauf"),
    "paused": Text("stopped", "angehalten"),
    "end": Text("program end", "Programmende"),
}
_STATES = {
    "defined": Text("defined", "definiert"),
    "active": Text("active", "aktiv"),
    "held": Text("held", "angehalten"),
    "starved": Text("no commands", "keine Befehle"),
}


def kind_name(kind: TrackKind, language: Language) -> str:
    """Return the name of a kind of tracks."""
    return _KINDS[kind].get(language)


def slice_name(name: str, language: Language) -> str:
    """Return the name of a slice; states of cycles have one in each language."""
    return _STATES[name].get(language) if name in _STATES else name
