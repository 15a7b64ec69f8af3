# SPDX-License-Identifier: MIT
"""Messages about ``#FACE`` and ``#CYL``: planes that turn with a rotary axis."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note, warning

_COMMAND = ("the command", "der Befehl")

NO_C_AXIS = error(
    20886,
    en="{command} names no C axis",
    de="{command} nennt keine C-Achse",
    remedy_en="Name a rotary axis whose list has the mode 0x204 (P-AXIS-00015, P-AXIS-00018).",
    remedy_de="Eine Rundachse nennen, deren Liste die Betriebsart 0x204 hat (P-AXIS-00015, "
    "P-AXIS-00018).",
    command=_COMMAND,
)
FUNCTION_IN_PLANE = error(
    20944,
    en="G{function} is not allowed between {command} and its end",
    de="G{function} ist zwischen {command} und seinem Ende nicht erlaubt",
    remedy_en="Program {command} OFF before it.",
    remedy_de="Davor {command} OFF programmieren.",
    command=_COMMAND,
)
C_AXIS_NOT_MODULO = warning(
    110565,
    en="C axis {axis} of {command} is not a modulo axis; its angle keeps counting here",
    de="die C-Achse {axis} von {command} ist keine Moduloachse; ihr Winkel zählt hier weiter",
    remedy_en="Set the bit 4 of P-AXIS-00015 in the list of the axis.",
    remedy_de="Das Bit 4 von P-AXIS-00015 in der Liste der Achse setzen.",
    command=_COMMAND,
)
UNKNOWN_AXIS_OF_PLANE = error(
    901812,
    en="the channel has no axis {axis}",
    de="der Kanal hat keine Achse {axis}",
    remedy_en="Name one of the channel: {known}",
    remedy_de="Eine des Kanals nennen: {known}",
    known=("the axes of the channel", "die Achsen des Kanals"),
)
AXES_OF_PLANE = error(
    901813,
    en="{command} needs {needed}",
    de="{command} braucht {needed}",
    remedy_en="Write for example #FACE [X, C] or #CYL [Z, C, X60], with linear axes among the "
    "first three.",
    remedy_de="Etwa #FACE [X, C] oder #CYL [Z, C, X60] schreiben, mit Linearachsen unter den "
    "ersten drei.",
    command=_COMMAND,
    needed=("what is missing", "was fehlt"),
    classes=(2, 3),
)
PLANE_EXCLUDED = error(
    901814,
    en="{command} is not possible while {other} is active",
    de="{command} ist nicht möglich, solange {other} aktiv ist",
    remedy_en="Switch the other one off first.",
    remedy_de="Vorher das andere ausschalten.",
    command=_COMMAND,
    other=("what is active", "was aktiv ist"),
    classes=(2, 3),
)
PLANE_NOT_CONFIGURED = error(
    901815,
    en="{command} needs kinematic {id}, which the channel list does not have",
    de="{command} braucht die Kinematik {id}, die die Kanalliste nicht hat",
    remedy_en="Add trafo[…].id {id} to the channel list (P-CHAN-00262).",
    remedy_de="In der Kanalliste trafo[…].id {id} ergänzen (P-CHAN-00262).",
    command=_COMMAND,
    id=("number of the kinematic", "Nummer der Kinematik"),
    classes=(2, 3),
)
PLANE_BY_GEOMETRY = note(
    901816,
    en="{command}: the plane follows plain geometry; of trafo[…].param only HD2 of kinematic 15 "
    "counts",
    de="{command}: die Ebene folgt einfacher Geometrie; von trafo[…].param zählt nur HD2 der "
    "Kinematik 15",
    remedy_en="Nothing to do; docs/conformance/turning.md says how both planes are read.",
    remedy_de="Nichts zu tun; docs/conformance/turning.md sagt, wie beide Ebenen gelesen werden.",
    command=_COMMAND,
)
