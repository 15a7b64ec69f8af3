# SPDX-License-Identifier: MIT
"""Messages of the lines of the realtime cycles' diagnosis data (900456 … 900458, 900550 …)."""

from __future__ import annotations

from nctakt.messages.catalogue import NOTE, Catalogue

MESSAGES = Catalogue()
_add = MESSAGES.add

_HIDE_INFO_EN = "V.RTG.CYCLES.DIAG_LEVEL below 3 keeps such lines out of the diagnosis data."
_HIDE_INFO_DE = "V.RTG.CYCLES.DIAG_LEVEL unter 3 hält solche Zeilen aus den Diagnosedaten heraus."
_HIDE_ACTION_EN = "V.RTG.CYCLES.DIAG_LEVEL below 4 keeps such lines out of the diagnosis data."
_HIDE_ACTION_DE = "V.RTG.CYCLES.DIAG_LEVEL unter 4 hält solche Zeilen aus den Diagnosedaten heraus."
_CYCLE = {"cycle": "the cycle's ID, or # and a number when it has none"}

_add(
    900550,
    NOTE,
    "Realtime cycle manager was initialised",
    "Echtzeit-Zyklen-Manager wurde initialisiert",
    remedy_en=_HIDE_INFO_EN,
    remedy_de=_HIDE_INFO_DE,
)
_add(
    900551,
    NOTE,
    "Realtime cycle manager: {count} cycles",
    "Echtzeit-Zyklen-Manager: {count} Zyklen",
    remedy_en=_HIDE_INFO_EN,
    remedy_de=_HIDE_INFO_DE,
    parameters={"count": "how many cycles there are"},
)
_add(
    900552,
    NOTE,
    "Cycle {cycle} was created with {scope} validity",
    "Zyklus {cycle} mit Gueltigkeit {scope} wurde angelegt",
    remedy_en=_HIDE_INFO_EN,
    remedy_de=_HIDE_INFO_DE,
    parameters={**_CYCLE, "scope": "BLOCK, PROG or GLOBAL"},
)
_add(
    900553,
    NOTE,
    "Cycle {cycle} was started",
    "Zyklus {cycle} wurde gestartet",
    remedy_en=_HIDE_INFO_EN,
    remedy_de=_HIDE_INFO_DE,
    parameters=_CYCLE,
)
_add(
    900554,
    NOTE,
    "Cycle {cycle} was put on hold",
    "Zyklus {cycle} wurde angehalten",
    remedy_en=_HIDE_INFO_EN,
    remedy_de=_HIDE_INFO_DE,
    parameters=_CYCLE,
)
_add(
    900555,
    NOTE,
    "Cycle {cycle} was continued",
    "Zyklus {cycle} wurde fortgesetzt",
    remedy_en=_HIDE_INFO_EN,
    remedy_de=_HIDE_INFO_DE,
    parameters=_CYCLE,
)
_add(
    900556,
    NOTE,
    "The actions of cycle {cycle} were aborted",
    "Die Aktionen von Zyklus {cycle} wurden abgebrochen",
    remedy_en=_HIDE_INFO_EN,
    remedy_de=_HIDE_INFO_DE,
    parameters=_CYCLE,
)
_add(
    900557,
    NOTE,
    "Cycle {cycle} ended with its validity",
    "Zyklus {cycle} endete mit seiner Gueltigkeit",
    remedy_en=_HIDE_INFO_EN,
    remedy_de=_HIDE_INFO_DE,
    parameters=_CYCLE,
)
_add(
    900558,
    NOTE,
    "Cycle {cycle} was deleted",
    "Zyklus {cycle} wurde geloescht",
    remedy_en=_HIDE_INFO_EN,
    remedy_de=_HIDE_INFO_DE,
    parameters=_CYCLE,
)
_add(
    900559,
    NOTE,
    "Cycle {cycle} was ended by a reset",
    "Zyklus {cycle} wurde durch einen Reset beendet",
    remedy_en=_HIDE_INFO_EN,
    remedy_de=_HIDE_INFO_DE,
    parameters=_CYCLE,
)
_add(
    900560,
    NOTE,
    "Cycle {cycle} was ended by an error",
    "Zyklus {cycle} wurde durch einen Fehler beendet",
    remedy_en=_HIDE_INFO_EN,
    remedy_de=_HIDE_INFO_DE,
    parameters=_CYCLE,
)
_add(
    900561,
    NOTE,
    "Cycle {cycle}: the branch in line {line} runs",
    "Zyklus {cycle}: der Zweig in Zeile {line} laeuft",
    remedy_en=_HIDE_ACTION_EN,
    remedy_de=_HIDE_ACTION_DE,
    parameters={**_CYCLE, "line": "the line of the branch"},
)
_add(
    900562,
    NOTE,
    "Cycle {cycle}: {variable} = {value}",
    "Zyklus {cycle}: {variable} = {value}",
    remedy_en=_HIDE_ACTION_EN,
    remedy_de=_HIDE_ACTION_DE,
    parameters={**_CYCLE, "variable": "the variable's name", "value": "its new value"},
)
_add(
    900563,
    NOTE,
    "Cycle {cycle}: {function} was put out, number {sequence} of the tick",
    "Zyklus {cycle}: {function} wurde ausgegeben, Nummer {sequence} im Takt",
    remedy_en=_HIDE_ACTION_EN,
    remedy_de=_HIDE_ACTION_DE,
    parameters={
        **_CYCLE,
        "function": "the M or H function",
        "sequence": "its number within the tick, from 1",
    },
)

_AXIS = {**_CYCLE, "axis": "the axis"}

_add(
    900456,
    NOTE,
    "Cycle {cycle}: axis {axis} moves to {position}",
    "Zyklus {cycle}: Achse {axis} faehrt auf {position}",
    remedy_en=_HIDE_ACTION_EN,
    remedy_de=_HIDE_ACTION_DE,
    parameters={**_AXIS, "position": "its target in ACS, in mm or degrees"},
)
_add(
    900457,
    NOTE,
    "Cycle {cycle}: axis {axis} moves endlessly in {direction_en} direction",
    "Zyklus {cycle}: Achse {axis} faehrt endlos in {direction_de} Richtung",
    remedy_en=_HIDE_ACTION_EN,
    remedy_de=_HIDE_ACTION_DE,
    parameters={
        **_AXIS,
        "direction_en": "positive or negative, in English",
        "direction_de": "positive or negative, in German",
    },
)
_add(
    900458,
    NOTE,
    "Cycle {cycle}: the motion of axis {axis} {state_en}",
    "Zyklus {cycle}: die Bewegung der Achse {axis} {state_de}",
    remedy_en=_HIDE_ACTION_EN,
    remedy_de=_HIDE_ACTION_DE,
    parameters={
        **_AXIS,
        "state_en": "what has become of it, in English",
        "state_de": "what has become of it, in German",
    },
)
