# SPDX-License-Identifier: MIT
"""The words for kinds, phases and causes of time, in both languages."""

from __future__ import annotations

from nctakt.base.diagnostics import Language, Text
from nctakt.timing.entries import NOTHING, Cause, Limit, Phase, TimeKind

KINDS: dict[TimeKind, Text] = {
    "rapid": Text("rapid", "Eilgang"),
    "feed": Text("feed", "Vorschub"),
    "dwell": Text("dwell", "Verweilzeit"),
    "wait": Text("waiting", "Warten"),
    "commands": Text("between blocks", "zwischen Sätzen"),
    "backward": Text("backward motion", "Rückwärtsfahren"),
    "idle": Text("no program", "kein Programm"),
}

PHASES: dict[Phase, Text] = {
    "accelerating": Text("accelerating", "Beschleunigen"),
    "constant": Text("constant speed", "konstante Geschwindigkeit"),
    "braking": Text("braking", "Bremsen"),
    "standing": Text("standing", "Stillstand"),
}

#: Causes before the axis, line or cycle that they name.
CAUSES: dict[Cause, Text] = {
    "feed": Text("F", "F"),
    "override operator": Text("operator's override", "Override des Bedieners"),
    "override cycle": Text("override by", "Override durch"),
    "override both": Text("override by the operator and", "Override durch den Bediener und"),
    "override program": Text("programmed override", "programmierter Override"),
    "speed": Text("speed of axis", "Geschwindigkeit der Achse"),
    "acceleration": Text("acceleration of axis", "Beschleunigung der Achse"),
    "jerk": Text("jerk of axis", "Ruck der Achse"),
    "curvature": Text("radius or limit on the path", "Radius oder Grenze der Bahn"),
    "rounding": Text("rounded corner", "verschliffene Ecke"),
    "corner": Text("corner before", "Ecke vor"),
    "next feed": Text("lower F from", "kleineres F ab"),
    "next limit": Text("slower axes from", "langsamere Achsen ab"),
    "exact stop": Text("exact stop at the end of", "Genauhalt am Ende von"),
    "standstill": Text(
        "stop, since no motion follows at once after", "Halt, da keine Bewegung anschließt an"
    ),
    "horizon": Text("end of the look-ahead", "Ende der Vorausschau"),
    "spindle": Text("speed of the spindle", "Drehzahl der Spindel"),
    "hold": Text("feed hold", "Vorschubhalt"),
    "stop": Text("error or reset", "Fehler oder Reset"),
    "tick": Text("shorter than a tick", "kürzer als ein Takt"),
    "wait": Text("waits for", "wartet auf"),
    "programmed": Text("programmed time", "programmierte Zeit"),
    "none": Text("", ""),
    "unknown": Text("not known", "nicht bekannt"),
}

#: Causes without the axis, line or cycle that they name where it is known.
_WITHOUT_DETAIL: dict[Cause, Text] = {
    "override cycle": Text("override of a realtime cycle", "Override eines Echtzeit-Zyklus"),
    "override both": Text(
        "override of operator and realtime cycle", "Override von Bediener und Echtzeit-Zyklus"
    ),
    "speed": Text("speed of an axis", "Geschwindigkeit einer Achse"),
    "acceleration": Text("acceleration", "Beschleunigung"),
    "jerk": Text("jerk", "Ruck"),
    "corner": Text("corner", "Ecke"),
    "next feed": Text("lower F ahead", "kleineres F voraus"),
    "next limit": Text("slower axes ahead", "langsamere Achsen voraus"),
    "exact stop": Text("exact stop", "Genauhalt"),
    "standstill": Text(
        "stop at the end of the block: no motion follows at once",
        "Halt am Satzende: keine Bewegung schließt an",
    ),
}


def limit_text(limit: Limit, language: Language) -> str:
    """Return a cause with its particulars."""
    if limit.detail == NOTHING:
        return _WITHOUT_DETAIL.get(limit.cause, CAUSES[limit.cause]).get(language)
    return f"{CAUSES[limit.cause].get(language)} {limit.detail.get(language)}"


def general_text(limit: Limit, language: Language) -> str:
    """Return a cause without lines, which still distinguishes axes and awaited events."""
    if limit.cause in ("speed", "acceleration", "jerk", "wait", "override cycle"):
        return limit_text(limit, language)
    return limit_text(Limit(limit.cause), language)
