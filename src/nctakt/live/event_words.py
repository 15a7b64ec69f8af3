# SPDX-License-Identifier: MIT
"""Events as a person reads them, in English and German.

The names of events in traces are for programs and stay as they are; on the page they are words.
"""

from __future__ import annotations

from nctakt.base.diagnostics import Language, Text
from nctakt.trace.events import Event

_KINDS = {
    "acknowledged": Text("acknowledged", "quittiert"),
    "aborted": Text("cycle aborted", "Zyklus abgebrochen"),
    "axis": Text("axis", "Achse"),
    "block": Text("block", "Satz"),
    "continued": Text("cycle continued", "Zyklus fortgesetzt"),
    "created": Text("cycle defined", "Zyklus definiert"),
    "dropped": Text("function dropped", "Funktion verworfen"),
    "end": Text("program end", "Programmende"),
    "ended": Text("cycle ended", "Zyklus beendet"),
    "error": Text("error", "Fehler"),
    "fired": Text("reaction", "Reaktion"),
    "fixed_stop": Text("fixed stop", "Festanschlag"),
    "frozen": Text("frozen", "eingefroren"),
    "held": Text("cycle held", "Zyklus angehalten"),
    "loop": Text("loop", "Schleife"),
    "message": Text("message", "Meldung"),
    "notice": Text("notice", "Hinweis"),
    "output": Text("to the PLC", "an die SPS"),
    "overflow": Text("thread too slow", "Thread zu langsam"),
    "paused": Text("waits for START", "wartet auf START"),
    "probe": Text("probe", "Taster"),
    "retrace": Text("on the path", "auf der Bahn"),
    "spindle": Text("spindle", "Spindel"),
    "spindle_position": Text("spindle stopped at", "Spindel steht auf"),
    "spindle_reached": Text("spindle at speed", "Spindel auf Drehzahl"),
    "started": Text("cycle started", "Zyklus gestartet"),
    "starved": Text("queue empty", "Queue leer"),
    "timer": Text("timer", "Timer"),
    "tool_life": Text("tool life sent", "Standgröße gesendet"),
    "touch": Text("probe touches", "Taster schaltet"),
    "user_error": Text("user error", "Anwenderfehler"),
    "user_value": Text("value of the error", "Wert zum Fehler"),
    "waits": Text("decoder waits", "Dekoder wartet"),
    "warning": Text("warning", "Warnung"),
    "written": Text("written", "geschrieben"),
}

#: Words in the particulars of events; names, messages and numbers stay as they are.
_PARTICULARS = {
    "aborted": "abgebrochen",
    "backward": "rückwärts",
    "begun": "begonnen",
    "continued": "fortgesetzt",
    "decoded": "dekodiert",
    "delete": "durch DELETE",
    "done": "fertig",
    "error": "durch Fehler",
    "ended": "beendet",
    "failed": "gescheitert",
    "flush": "auf leeren Vorrat",
    "forward": "vorwärts",
    "front": "am vordersten Punkt",
    "held": "angehalten",
    "left": "verlassen",
    "line": "Zeile",
    "negative": "negativ",
    "positions": "auf Positionen",
    "positive": "positiv",
    "read": "auf Lesen",
    "reset": "durch RESET",
    "scope": "am Ende des Bereichs",
    "skipped": "übersprungen",
    "start": "am Anfang",
    "stopped": "gestoppt",
    "write": "auf Schreiben",
}

#: Events whose particulars are somebody's words.
_VERBATIM = ("message", "user_value", "written", "frozen", "end", "overflow")


def event_words(event: Event, language: Language) -> str:
    """Return an event in words: what has happened, and its particulars."""
    kind = _KINDS.get(event.kind)
    name = event.kind if kind is None else kind.get(language)
    parts = event.text.split(" ")
    if event.kind == "block":
        parts = []
    if event.kind in ("fired", "paused"):
        parts = parts[:-2]  # its line, which is beside it
    if event.kind in ("M", "H"):
        name, parts = f"{event.kind}{parts[0]}", []
    if event.kind in ("output", "acknowledged", "dropped"):
        parts = ["".join(parts[:2]), *(parts[2:] if event.kind == "output" else [])]
    if language == "de" and event.kind not in _VERBATIM:
        parts = [_PARTICULARS.get(part, part) for part in parts]
    return f"{event.prefix}{name} {' '.join(parts)}".rstrip()
