# SPDX-License-Identifier: MIT
"""Messages about the variables lists: V.E and V.CH."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note, warning

INVALID_ALIGNMENT = warning(
    1000178,
    en="alignment {value} of the external variables does not exist; the controller chooses it",
    de="die Ausrichtung {value} der externen Variablen gibt es nicht; die Steuerung wählt sie",
    remedy_en="Use 0, 1, 2, 4 or 8.",
    remedy_de="0, 1, 2, 4 oder 8 verwenden.",
    value=("P-STUP-00145 as written", "P-STUP-00145, wie geschrieben"),
)
INVALID_SCOPE = warning(
    21196,
    en="{key}: '{value}' is no scope; {default} is used",
    de="{key}: '{value}' ist kein Gültigkeitsbereich; es gilt {default}",
    remedy_en="Use GLOBAL or CHANNEL.",
    remedy_de="GLOBAL oder CHANNEL verwenden.",
    cause_en="Only GLOBAL variables are shared by all channels, so a scope that cannot be read "
    "stays in its channel.",
    cause_de="Nur GLOBAL-Variablen gelten für alle Kanäle; ein unlesbarer Gültigkeitsbereich "
    "bleibt darum im Kanal.",
    key=("the entry's name", "der Name des Eintrags"),
    value=("the value as it stands in the list", "der Wert, wie er in der Liste steht"),
    default=("the scope that is used", "der Gültigkeitsbereich, der gilt"),
    reaction=1,
    clearing=1,
)
CHANNEL_VARIABLES_TOO_LARGE = error(
    21992,
    en="V.CH variables need {needed} byte, P-CHAN-00424 gives {available}; the channel has none of "
    "them",
    de="V.CH-Variablen brauchen {needed} Byte, P-CHAN-00424 gibt {available}; der Kanal hat keine "
    "davon",
    remedy_en="Set configuration.decoder.v_ch_memory to at least {needed}.",
    remedy_de="configuration.decoder.v_ch_memory auf mindestens {needed} setzen.",
    cause_en="Each variable takes its data and some bytes of management; what does not fit cannot "
    "exist in part.",
    cause_de="Jede Variable braucht ihre Daten und einige Byte Verwaltung; was nicht hineinpasst, "
    "kann es nicht zum Teil geben.",
    needed=("bytes of data and management", "Byte für Daten und Verwaltung"),
    available=("P-CHAN-00424", "P-CHAN-00424"),
    reaction=2,
    clearing=7,
)
INVALID_VARIABLE_NAME = warning(
    900080,
    en="{key}: '{value}' is no name for a variable, or used already; it is left out",
    de="{key}: '{value}' ist kein zulässiger Variablenname oder schon vergeben; sie entfällt",
    remedy_en="Use up to {limit} letters, digits and underscores, beginning with a letter.",
    remedy_de="Bis zu {limit} Buchstaben, Ziffern und Unterstriche verwenden, mit einem Buchstaben "
    "beginnend.",
    key=("the entry's name", "der Name des Eintrags"),
    value=("the name", "der Name"),
    limit=("the greatest length", "die größte Länge"),
)
LONG_VARIABLE_NAME = note(
    900972,
    en="{key}: the name has {length} characters; a controller may have room for {limit} only",
    de="{key}: der Name hat {length} Zeichen; eine Steuerung hat womöglich nur für {limit} Platz",
    remedy_en="Shorten the name if the controller refuses it.",
    remedy_de="Den Namen kürzen, falls die Steuerung ihn ablehnt.",
    key=("the entry's name", "der Name des Eintrags"),
    length=("the length of the variable's name", "die Länge des Variablennamens"),
    limit=("the length that the manual names", "die Länge, die das Handbuch nennt"),
)
VARIABLE_BEYOND_COUNT = warning(
    900081,
    en="{key} does not exist: number_used_variables is {count}",
    de="{key} gibt es nicht: number_used_variables ist {count}",
    remedy_en="Set number_used_variables to the highest index plus 1.",
    remedy_de="number_used_variables auf den höchsten Index plus 1 setzen.",
    key=("the first variable beyond the number", "die erste Variable jenseits der Anzahl"),
    count=("P-EXTV-00010", "P-EXTV-00010"),
)
UNKNOWN_VARIABLE_TYPE = warning(
    900082,
    en="{key}: '{value}' is no type and no structure of this list; the variable is left out",
    de="{key}: '{value}' ist kein Typ und keine Struktur dieser Liste; die Variable entfällt",
    remedy_en="Use one of {names}, or the name of a structure.",
    remedy_de="Eines von {names} oder den Namen einer Struktur verwenden.",
    key=("the entry's name", "der Name des Eintrags"),
    value=("the type as written", "der Typ, wie geschrieben"),
    names=("the types that exist", "die Typen, die es gibt"),
)
RECURSIVE_STRUCTURE = warning(
    900083,
    en="the structure {name} contains itself; variables of it are left out",
    de="die Struktur {name} enthält sich selbst; Variablen dieses Typs entfallen",
    remedy_en="Break the circle.",
    remedy_de="Den Kreis auflösen.",
    name=("the structure", "die Struktur"),
)
VARIABLE_TOO_LARGE = warning(
    900084,
    en="{key}: the variable has more than {limit} elements and is left out",
    de="{key}: die Variable hat mehr als {limit} Elemente und entfällt",
    remedy_en="Make its arrays smaller.",
    remedy_de="Ihre Felder verkleinern.",
    key=("the entry's name", "der Name des Eintrags"),
    limit=("the greatest number of elements", "die größte Zahl von Elementen"),
)
VARIABLE_STRUCTURE_TOO_DEEP = warning(
    900085,
    en="structures inside {name} nest deeper than {limit}; variables of it are left out",
    de="Strukturen in {name} sind tiefer als {limit} geschachtelt; Variablen dieses Typs entfallen",
    remedy_en="Nest the structures less deeply.",
    remedy_de="Die Strukturen weniger tief schachteln.",
    name=("the outermost structure", "die äußerste Struktur"),
    limit=("the deepest nesting", "die tiefste Schachtelung"),
)
VARIABLES_OVERLAP = warning(
    900087,
    en="V.E.{name} at byte {offset} overlaps V.E.{other} in the memory that the PLC sees",
    de="V.E.{name} bei Byte {offset} überlappt V.E.{other} im Speicher, den die SPS sieht",
    remedy_en="Leave byte_offset out, or give each variable a place of its own.",
    remedy_de="byte_offset weglassen oder jeder Variablen einen eigenen Ort geben.",
    name=("the variable that lies further behind", "die Variable, die weiter hinten liegt"),
    other=("the one in front of it", "die davor"),
    offset=("its first byte", "ihr erstes Byte"),
)
VARIABLE_OFFSET_TOO_LARGE = warning(
    900088,
    en="{key}: byte {value} is too far; the variable stands behind the one before",
    de="{key}: Byte {value} ist zu weit; die Variable steht hinter der davor",
    remedy_en="Give a place up to {limit}, or leave it to the controller with -1.",
    remedy_de="Einen Ort bis {limit} angeben oder ihn mit -1 der Steuerung überlassen.",
    key=("the entry's name", "der Name des Eintrags"),
    value=("P-EXTV-00002 as written", "P-EXTV-00002, wie geschrieben"),
    limit=("the last possible place", "der letzte mögliche Ort"),
)
EXTERNAL_VARIABLES_TOO_LARGE = warning(
    900814,
    en="the V.E variables of channel {channel} take {needed} bytes, and ext_var_max gives "
    "{available}",
    de="die V.E-Variablen von Kanal {channel} belegen {needed} Byte, und ext_var_max gibt "
    "{available}",
    remedy_en="Raise ext_var_max (P-STUP-00037): it counts blocks of 24 bytes.",
    remedy_de="ext_var_max erhöhen (P-STUP-00037): es zählt Blöcke zu 24 Byte.",
    channel=("the number of the channel", "die Nummer des Kanals"),
    needed=("bytes of the variables", "Byte der Variablen"),
    available=("P-STUP-00037 in bytes", "P-STUP-00037 in Byte"),
)
