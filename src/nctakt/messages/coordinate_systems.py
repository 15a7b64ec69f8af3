# SPDX-License-Identifier: MIT
"""Messages about the program's coordinate systems, ``#CS``."""

from __future__ import annotations

from nctakt.messages.catalogue import error

COORDINATE_SYSTEM_NOT_STORED = error(
    900840,
    en="no coordinate system {id} is stored",
    de="kein Koordinatensystem {id} ist gespeichert",
    remedy_en="Define it with #CS DEF [{id}] [shift, angles] before. Stored: {known}",
    remedy_de="Vorher mit #CS DEF [{id}] [Verschiebung, Winkel] definieren. Gespeichert: {known}",
    id=("its number", "seine Nummer"),
    known=("those that are", "die es gibt"),
    reaction=2,
    clearing=3,
)
NO_COORDINATE_SYSTEM_ACTIVE = error(
    900841,
    en="#CS OFF, and no coordinate system is on",
    de="#CS OFF, und kein Koordinatensystem ist eingeschaltet",
    remedy_en="Take it out; #CS OFF ALL is allowed where none is on.",
    remedy_de="Entfernen; #CS OFF ALL ist erlaubt, wo keines eingeschaltet ist.",
    reaction=2,
    clearing=3,
)
ARC_PLANE_ASKEW = error(
    900842,
    en="in this coordinate system the arc's plane G{plane} lies askew to the axes",
    de="in diesem Koordinatensystem liegt die Ebene G{plane} schräg zu den Achsen",
    remedy_en="Program straight lines, or turn the system about the plane's normal only.",
    remedy_de="Geraden programmieren oder das System nur um die Normale der Ebene drehen.",
    cause_en="nctakt drives arcs in planes of two axes.",
    cause_de="nctakt fährt Kreise in Ebenen zweier Achsen.",
    plane=("number of the G function", "Nummer der G-Funktion"),
    reaction=2,
    clearing=3,
)
LINEAR_AXES_MISSING = error(
    900843,
    en="a coordinate system needs three linear axes, the first ones of the channel",
    de="ein Koordinatensystem braucht drei Linearachsen, die ersten des Kanals",
    remedy_en="Put the linear axes first in the channel list (gruppe[0].achse[0] … [2]).",
    remedy_de="Die Linearachsen in der Kanalliste voranstellen (gruppe[0].achse[0] … [2]).",
    reaction=2,
    clearing=3,
)
TOO_MANY_COORDINATE_SYSTEMS = error(
    900844,
    en="more than {most} coordinate systems are stored",
    de="mehr als {most} Koordinatensysteme sind gespeichert",
    remedy_en="Use a number again, or #CS ON with values and without a number.",
    remedy_de="Eine Nummer wieder verwenden oder #CS ON mit Werten und ohne Nummer.",
    most=("as many may be", "so viele dürfen es sein"),
    reaction=2,
    clearing=3,
)
WORD_IN_ROTATED_COORDINATE_SYSTEM = error(
    900845,
    en="{word} in a coordinate system that is turned out of the axes' plane G{plane}",
    de="{word} in einem Koordinatensystem, das aus der Ebene G{plane} der Achsen gedreht ist",
    remedy_en="Turn the system about the plane's normal only, or program the tool's own path.",
    remedy_de="Das System nur um die Normale der Ebene drehen oder die Bahn des Werkzeugs selbst "
    "programmieren.",
    word=("G41 or G42", "G41 oder G42"),
    plane=("number of the G function", "Nummer der G-Funktion"),
    reaction=2,
    clearing=3,
)
COORDINATE_SYSTEM_DURING_COMPENSATION = error(
    900846,
    en="{command} while the radius of the tool is compensated",
    de="{command}, während der Werkzeugradius korrigiert wird",
    remedy_en="Write it before G41 and G42, or behind G40 and the motion that leaves the contour.",
    remedy_de="Vor G41 und G42 schreiben, oder hinter G40 und die Bewegung, die wegführt.",
    command=("the word or command", "das Wort oder der Befehl"),
    reaction=2,
    clearing=3,
)
INVALID_COORDINATE_SYSTEM_NAME = error(
    900929,
    en="{name} is no name for a coordinate system",
    de="{name} ist kein Name für ein Koordinatensystem",
    remedy_en="Take another name of up to {most} characters; ACS, IMCS and MCS belong to machines.",
    remedy_de="Einen anderen Namen bis {most} Zeichen nehmen; ACS, IMCS, MCS gehören der Maschine.",
    name=("the name as written", "der Name, wie geschrieben"),
    most=("upper limit", "obere Grenze"),
    reaction=2,
    clearing=3,
)
COORDINATE_SYSTEM_NOT_ADDED = error(
    900930,
    en="#CS ADD [{name}]: the name is taken, or the stack is full",
    de="#CS ADD [{name}]: der Name ist vergeben, oder der Stapel ist voll",
    remedy_en="Up to {most} systems with different names lie on each other. There are: {known}",
    remedy_de="Bis zu {most} Systeme mit verschiedenen Namen liegen aufeinander. Es gibt: {known}",
    name=("the name as written", "der Name, wie geschrieben"),
    most=("upper limit", "obere Grenze"),
    known=("those that are", "die es gibt"),
    reaction=2,
    clearing=3,
)
UNKNOWN_COORDINATE_SYSTEM_NAME = error(
    900931,
    en="#CS SELECT [{name}]: no coordinate system has this name",
    de="#CS SELECT [{name}]: kein Koordinatensystem heißt so",
    remedy_en="Define it with #CS ADD [{name}] [shift, angles] before. There are: {known}",
    remedy_de="Vorher mit #CS ADD [{name}] [Verschiebung, Winkel] definieren. Es gibt: {known}",
    name=("the name as written", "der Name, wie geschrieben"),
    known=("those that are", "die es gibt"),
    reaction=2,
    clearing=3,
)
CS_SELECT_DURING_CS_ON = error(
    900932,
    en="#CS SELECT while a coordinate system of #CS ON is active",
    de="#CS SELECT, solange ein Koordinatensystem von #CS ON aktiv ist",
    remedy_en="Take that off with #CS OFF before; it may be put on again inside the selected one.",
    remedy_de="Jenes vorher mit #CS OFF abwählen; im angewählten darf es wieder an.",
    reaction=2,
    clearing=3,
)
