# SPDX-License-Identifier: MIT
"""Messages of the program's coordinate systems, ``#CS`` (900840 … 900846, 900929 … 900932)."""

from __future__ import annotations

from nctakt.messages.catalogue import ERROR, Catalogue

MESSAGES = Catalogue()
_add = MESSAGES.add

_add(
    900840,
    ERROR,
    "no coordinate system {id} is stored",
    "kein Koordinatensystem {id} ist gespeichert",
    remedy_en="Define it with #CS DEF [{id}] [shift, angles] before. Stored: {known}",
    remedy_de="Vorher mit #CS DEF [{id}] [Verschiebung, Winkel] definieren. Gespeichert: {known}",
    parameters={"id": "its number", "known": "those that are"},
    reaction=2,
    clearing=3,
)
_add(
    900841,
    ERROR,
    "#CS OFF, and no coordinate system is on",
    "#CS OFF, und kein Koordinatensystem ist eingeschaltet",
    remedy_en="Take it out; #CS OFF ALL is allowed where none is on.",
    remedy_de="Entfernen; #CS OFF ALL ist erlaubt, wo keines eingeschaltet ist.",
    reaction=2,
    clearing=3,
)
_add(
    900842,
    ERROR,
    "in this coordinate system the arc's plane G{plane} lies askew to the axes",
    "in diesem Koordinatensystem liegt die Ebene G{plane} schräg zu den Achsen",
    remedy_en="Program straight lines, or turn the system about the plane's normal only.",
    remedy_de="Geraden programmieren oder das System nur um die Normale der Ebene drehen.",
    cause_en="nctakt drives arcs in planes of two axes.",
    cause_de="nctakt fährt Kreise in Ebenen zweier Achsen.",
    parameters={"plane": "number of the G function"},
    reaction=2,
    clearing=3,
)
_add(
    900843,
    ERROR,
    "a coordinate system needs three linear axes, the first ones of the channel",
    "ein Koordinatensystem braucht drei Linearachsen, die ersten des Kanals",
    remedy_en="Put the linear axes first in the channel list (gruppe[0].achse[0] … [2]).",
    remedy_de="Die Linearachsen in der Kanalliste voranstellen (gruppe[0].achse[0] … [2]).",
    reaction=2,
    clearing=3,
)
_add(
    900844,
    ERROR,
    "more than {most} coordinate systems are stored",
    "mehr als {most} Koordinatensysteme sind gespeichert",
    remedy_en="Use a number again, or #CS ON with values and without a number.",
    remedy_de="Eine Nummer wieder verwenden oder #CS ON mit Werten und ohne Nummer.",
    parameters={"most": "as many may be"},
    reaction=2,
    clearing=3,
)
_add(
    900845,
    ERROR,
    "{word} in a coordinate system that is turned out of the axes' plane G{plane}",
    "{word} in einem Koordinatensystem, das aus der Ebene G{plane} der Achsen gedreht ist",
    remedy_en="Turn the system about the plane's normal only, or program the tool's own path.",
    remedy_de="Das System nur um die Normale der Ebene drehen oder die Bahn des Werkzeugs selbst "
    "programmieren.",
    parameters={"word": "G41 or G42", "plane": "number of the G function"},
    reaction=2,
    clearing=3,
)
_add(
    900846,
    ERROR,
    "{command} while the radius of the tool is compensated",
    "{command}, während der Werkzeugradius korrigiert wird",
    remedy_en="Write it before G41 and G42, or behind G40 and the motion that leaves the contour.",
    remedy_de="Vor G41 und G42 schreiben, oder hinter G40 und die Bewegung, die wegführt.",
    parameters={"command": "the word or command"},
    reaction=2,
    clearing=3,
)
_add(
    900929,
    ERROR,
    "{name} is no name for a coordinate system",
    "{name} ist kein Name für ein Koordinatensystem",
    remedy_en="Take another name of up to {most} characters; ACS, IMCS and MCS belong to machines.",
    remedy_de="Einen anderen Namen bis {most} Zeichen nehmen; ACS, IMCS, MCS gehören der Maschine.",
    parameters={"name": "the name as written", "most": "upper limit"},
    reaction=2,
    clearing=3,
)
_add(
    900930,
    ERROR,
    "#CS ADD [{name}]: the name is taken, or the stack is full",
    "#CS ADD [{name}]: der Name ist vergeben, oder der Stapel ist voll",
    remedy_en="Up to {most} systems with different names lie on each other. There are: {known}",
    remedy_de="Bis zu {most} Systeme mit verschiedenen Namen liegen aufeinander. Es gibt: {known}",
    parameters={
        "name": "the name as written",
        "most": "upper limit",
        "known": "those that are",
    },
    reaction=2,
    clearing=3,
)
_add(
    900931,
    ERROR,
    "#CS SELECT [{name}]: no coordinate system has this name",
    "#CS SELECT [{name}]: kein Koordinatensystem heißt so",
    remedy_en="Define it with #CS ADD [{name}] [shift, angles] before. There are: {known}",
    remedy_de="Vorher mit #CS ADD [{name}] [Verschiebung, Winkel] definieren. Es gibt: {known}",
    parameters={"name": "the name as written", "known": "those that are"},
    reaction=2,
    clearing=3,
)
_add(
    900932,
    ERROR,
    "#CS SELECT while a coordinate system of #CS ON is active",
    "#CS SELECT, solange ein Koordinatensystem von #CS ON aktiv ist",
    remedy_en="Take that off with #CS OFF before; it may be put on again inside the selected one.",
    remedy_de="Jenes vorher mit #CS OFF abwählen; im angewählten darf es wieder an.",
    reaction=2,
    clearing=3,
)
