# SPDX-License-Identifier: MIT
"""Messages of the variables lists: V.E and V.CH (900080 … 900085, 900087 … 900099, 900814)."""

from __future__ import annotations

from nctakt.messages.catalogue import ERROR, WARNING, Catalogue

MESSAGES = Catalogue()
_add = MESSAGES.add

_add(
    1000178,
    WARNING,
    "alignment {value} of the external variables does not exist; the controller chooses it",
    "die Ausrichtung {value} der externen Variablen gibt es nicht; die Steuerung wählt sie",
    remedy_en="Use 0, 1, 2, 4 or 8.",
    remedy_de="0, 1, 2, 4 oder 8 verwenden.",
    parameters={
        "value": "P-STUP-00145 as written",
    },
)
_add(
    21196,
    WARNING,
    "{key}: '{value}' is no scope; {default} is used",
    "{key}: '{value}' ist kein Gültigkeitsbereich; es gilt {default}",
    remedy_en="Use GLOBAL or CHANNEL.",
    remedy_de="GLOBAL oder CHANNEL verwenden.",
    cause_en="Only GLOBAL variables are shared by all channels, so a scope that cannot be read "
    "stays in its channel.",
    cause_de="Nur GLOBAL-Variablen gelten für alle Kanäle; ein unlesbarer Gültigkeitsbereich "
    "bleibt darum im Kanal.",
    parameters={
        "key": "the entry's name",
        "value": "the value as it stands in the list",
        "default": "the scope that is used",
    },
    reaction=1,
    clearing=1,
)
_add(
    21992,
    ERROR,
    "V.CH variables need {needed} byte, P-CHAN-00424 gives {available}; the channel has "
    "none of them",
    "V.CH-Variablen brauchen {needed} Byte, P-CHAN-00424 gibt {available}; der Kanal hat "
    "keine davon",
    remedy_en="Set configuration.decoder.v_ch_memory to at least {needed}.",
    remedy_de="configuration.decoder.v_ch_memory auf mindestens {needed} setzen.",
    cause_en="Each variable takes its data and some bytes of management; what does not fit cannot "
    "exist in part.",
    cause_de="Jede Variable braucht ihre Daten und einige Byte Verwaltung; was nicht hineinpasst, "
    "kann es nicht zum Teil geben.",
    parameters={
        "needed": "bytes of data and management",
        "available": "P-CHAN-00424",
    },
    reaction=2,
    clearing=7,
)
_add(
    900080,
    WARNING,
    "{key}: '{value}' is no name for a variable, or used already; it is left out",
    "{key}: '{value}' ist kein zulässiger Variablenname oder schon vergeben; sie entfällt",
    remedy_en="Use up to {limit} letters, digits and underscores, beginning with a letter.",
    remedy_de="Bis zu {limit} Buchstaben, Ziffern und Unterstriche verwenden, mit einem Buchstaben "
    "beginnend.",
    parameters={
        "key": "the entry's name",
        "value": "the name",
        "limit": "the greatest length",
    },
)
_add(
    900081,
    WARNING,
    "{key} does not exist: number_used_variables is {count}",
    "{key} gibt es nicht: number_used_variables ist {count}",
    remedy_en="Set number_used_variables to the highest index plus 1.",
    remedy_de="number_used_variables auf den höchsten Index plus 1 setzen.",
    parameters={
        "key": "the first variable beyond the number",
        "count": "P-EXTV-00010",
    },
)
_add(
    900082,
    WARNING,
    "{key}: '{value}' is no type and no structure of this list; the variable is left out",
    "{key}: '{value}' ist kein Typ und keine Struktur dieser Liste; die Variable entfällt",
    remedy_en="Use one of {names}, or the name of a structure.",
    remedy_de="Eines von {names} oder den Namen einer Struktur verwenden.",
    parameters={
        "key": "the entry's name",
        "value": "the type as written",
        "names": "the types that exist",
    },
)
_add(
    900083,
    WARNING,
    "the structure {name} contains itself; variables of it are left out",
    "die Struktur {name} enthält sich selbst; Variablen dieses Typs entfallen",
    remedy_en="Break the circle.",
    remedy_de="Den Kreis auflösen.",
    parameters={
        "name": "the structure",
    },
)
_add(
    900084,
    WARNING,
    "{key}: the variable has more than {limit} elements and is left out",
    "{key}: die Variable hat mehr als {limit} Elemente und entfällt",
    remedy_en="Make its arrays smaller.",
    remedy_de="Ihre Felder verkleinern.",
    parameters={
        "key": "the entry's name",
        "limit": "the greatest number of elements",
    },
)
_add(
    900085,
    WARNING,
    "structures inside {name} nest deeper than {limit}; variables of it are left out",
    "Strukturen in {name} sind tiefer als {limit} geschachtelt; Variablen dieses Typs entfallen",
    remedy_en="Nest the structures less deeply.",
    remedy_de="Die Strukturen weniger tief schachteln.",
    parameters={
        "name": "the outermost structure",
        "limit": "the deepest nesting",
    },
)
_add(
    900087,
    WARNING,
    "V.E.{name} at byte {offset} overlaps V.E.{other} in the memory that the PLC sees",
    "V.E.{name} bei Byte {offset} überlappt V.E.{other} im Speicher, den die SPS sieht",
    remedy_en="Leave byte_offset out, or give each variable a place of its own.",
    remedy_de="byte_offset weglassen oder jeder Variablen einen eigenen Ort geben.",
    parameters={
        "name": "the variable that lies further behind",
        "other": "the one in front of it",
        "offset": "its first byte",
    },
)
_add(
    900088,
    WARNING,
    "{key}: byte {value} is too far; the variable stands behind the one before",
    "{key}: Byte {value} ist zu weit; die Variable steht hinter der davor",
    remedy_en="Give a place up to {limit}, or leave it to the controller with -1.",
    remedy_de="Einen Ort bis {limit} angeben oder ihn mit -1 der Steuerung überlassen.",
    parameters={
        "key": "the entry's name",
        "value": "P-EXTV-00002 as written",
        "limit": "the last possible place",
    },
)
_add(
    900814,
    WARNING,
    "the V.E variables of channel {channel} take {needed} bytes, and ext_var_max gives {available}",
    "die V.E-Variablen von Kanal {channel} belegen {needed} Byte, und ext_var_max gibt {available}",
    remedy_en="Raise ext_var_max (P-STUP-00037): it counts blocks of 24 bytes.",
    remedy_de="ext_var_max erhöhen (P-STUP-00037): es zählt Blöcke zu 24 Byte.",
    parameters={
        "channel": "the number of the channel",
        "needed": "bytes of the variables",
        "available": "P-STUP-00037 in bytes",
    },
)
