# SPDX-License-Identifier: MIT
"""Messages about the program's coordinate systems, ``#CS``, ``#ACS``, ``#BCS``."""

from __future__ import annotations

from nctakt.messages.cases import by_beginning
from nctakt.messages.catalogue import error, warning

_KIND = ("CS, ACS or BCS", "CS, ACS oder BCS")
COORDINATE_SYSTEM_NOT_STORED = error(
    20821,
    known_as=(900840,),
    en="coordinate system {id} of #{kind} is not stored",
    de="das Koordinatensystem {id} von #{kind} ist nicht gespeichert",
    remedy_en="Define it first with #{kind} DEF [1] [shift, angles], or in the channel list. "
    "Known: {known}",
    remedy_de="Vorher mit #{kind} DEF [1] [Verschiebung, Winkel] oder in der Kanalliste "
    "definieren. Bekannt: {known}",
    kind=_KIND,
    id=("the number or name of the coordinate system", "Nummer oder Name des Koordinatensystems"),
    known=("the known coordinate systems", "die bekannten Koordinatensysteme"),
)
INVALID_COORDINATE_SYSTEM_NUMBER = error(
    20820,
    en="#{kind}: {id} is not a valid number for a coordinate system",
    de="#{kind}: {id} ist keine gültige Nummer für ein Koordinatensystem",
    remedy_en="Program a number above 0.",
    remedy_de="Eine Nummer über 0 programmieren.",
    kind=_KIND,
)
NO_COORDINATE_SYSTEM_ACTIVE = warning(
    20824,
    known_as=(900841,),
    en="#{kind} OFF, but no such coordinate system is active",
    de="#{kind} OFF, aber kein solches Koordinatensystem ist aktiv",
    remedy_en="Remove it; #{kind} OFF ALL is allowed where none is active.",
    remedy_de="Entfernen; #{kind} OFF ALL ist erlaubt, wenn keines aktiv ist.",
    kind=_KIND,
    classes=(1, 1),
)
LINEAR_AXES_MISSING = error(
    20660,
    known_as=(900843,),
    en="a coordinate system needs the first three axes of the channel to be linear",
    de="ein Koordinatensystem braucht Linearachsen als die ersten drei Achsen des Kanals",
    remedy_en="Put the linear axes first in the channel list (gruppe[0].achse[0] … [2]).",
    remedy_de="Die Linearachsen in der Kanalliste voranstellen (gruppe[0].achse[0] … [2]).",
)
TOO_MANY_COORDINATE_SYSTEMS = error(
    21234,
    known_as=(900844,),
    en="more than {maximum} coordinate systems of #{kind} are stored",
    de="mehr als {maximum} Koordinatensysteme von #{kind} sind gespeichert",
    remedy_en="Reuse a number, or use #{kind} ON with values and without a number.",
    remedy_de="Eine Nummer wiederverwenden oder #{kind} ON mit Werten und ohne Nummer verwenden.",
    kind=_KIND,
)
TOO_MANY_ACTIVE_SYSTEMS = error(
    20826,
    en="more than {maximum} coordinate systems are active at a time",
    de="mehr als {maximum} Koordinatensysteme sind zugleich aktiv",
    remedy_en="Switch off those that are no longer used, with #CS OFF, #ACS OFF or #BCS OFF.",
    remedy_de="Nicht mehr benutzte mit #CS OFF, #ACS OFF oder #BCS OFF ausschalten.",
)
EFFECTOR_SYSTEM_WITH_OTHERS = error(
    901893,
    en="{command} while {other} is active: #ECS excludes every other coordinate system",
    de="{command}, solange {other} aktiv ist: #ECS schließt jedes andere Koordinatensystem aus",
    remedy_en="Switch off the active system first, with #CS OFF ALL or #ECS OFF.",
    remedy_de="Das aktive System vorher mit #CS OFF ALL oder #ECS OFF ausschalten.",
    other=("the active system", "das aktive System"),
    classes=(2, 3),
)
COORDINATE_SYSTEM_DURING_COMPENSATION = error(
    900846,
    known_as=(20608, 20671),
    cases=by_beginning("command", {"#CS": 20802, "#ACS": 20802}),
    en="{command} while tool radius compensation is active",
    de="{command} bei aktiver Werkzeugradiuskorrektur",
    remedy_en="Write it before G41 and G42, or after G40 and the motion that leaves the contour.",
    remedy_de="Vor G41 und G42 schreiben oder nach G40 und der Bewegung, die die Kontur verlässt.",
    classes=(2, 3),
)
INVALID_COORDINATE_SYSTEM_NAME = error(
    900929,
    known_as=(21598,),
    en="{name} is not a valid name for a coordinate system",
    de="{name} ist kein gültiger Name für ein Koordinatensystem",
    remedy_en="Choose another name of up to {maximum} characters; ACS, IMCS and MCS are reserved.",
    remedy_de="Einen anderen Namen mit bis zu {maximum} Zeichen wählen; ACS, IMCS und MCS sind "
    "reserviert.",
    classes=(2, 3),
)
COORDINATE_SYSTEM_NAME_TAKEN = error(
    21599,
    known_as=(900930,),
    en="#CS ADD [{name}]: a coordinate system of this name is already on the stack",
    de="#CS ADD [{name}]: ein Koordinatensystem dieses Namens liegt schon auf dem Stapel",
    remedy_en="Choose another name. Present: {known}",
    remedy_de="Einen anderen Namen wählen. Vorhanden: {known}",
    known=("the coordinate systems on the stack", "die Koordinatensysteme auf dem Stapel"),
)
COORDINATE_SYSTEM_STACK_FULL = error(
    21600,
    en="#CS ADD [{name}]: the stack of coordinate systems is full",
    de="#CS ADD [{name}]: der Stapel der Koordinatensysteme ist voll",
    remedy_en="Up to {maximum} systems can be stacked; remove one with #CS DEL. Present: {known}",
    remedy_de="Bis zu {maximum} Systeme können gestapelt sein; mit #CS DEL eines entfernen. "
    "Vorhanden: {known}",
    known=("the coordinate systems on the stack", "die Koordinatensysteme auf dem Stapel"),
)
UNKNOWN_COORDINATE_SYSTEM_NAME = error(
    21601,
    known_as=(900931,),
    en="#CS SELECT [{name}]: unknown coordinate system",
    de="#CS SELECT [{name}]: unbekanntes Koordinatensystem",
    remedy_en="Define it first with #CS ADD [{name}] [shift, angles]. Present: {known}",
    remedy_de="Vorher mit #CS ADD [{name}] [Verschiebung, Winkel] definieren. Vorhanden: {known}",
    known=("the coordinate systems on the stack", "die Koordinatensysteme auf dem Stapel"),
)
MACHINE_SYSTEM_MISSING = error(
    901821,
    en="#CS SELECT [MCS], but no transformation is active",
    de="#CS SELECT [MCS], aber keine Transformation ist aktiv",
    remedy_en="Program #TRAFO ON before it, or #CS OFF ALL to leave all systems.",
    remedy_de="Davor #TRAFO ON programmieren, oder #CS OFF ALL, um alle Systeme zu verlassen.",
    classes=(2, 3),
)
CS_SELECT_DURING_CS_ON = error(
    900932,
    known_as=(21854,),
    en="#CS SELECT while a coordinate system of #CS ON is active",
    de="#CS SELECT, solange ein Koordinatensystem von #CS ON aktiv ist",
    remedy_en="Switch it off with #CS OFF first; it may be switched on again inside the selected "
    "one.",
    remedy_de="Es vorher mit #CS OFF ausschalten; innerhalb des angewählten darf es wieder "
    "eingeschaltet werden.",
    classes=(2, 3),
)
