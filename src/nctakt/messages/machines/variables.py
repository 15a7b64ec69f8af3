# SPDX-License-Identifier: MIT
"""Messages about the variables lists: V.E and V.CH."""

from __future__ import annotations

from nctakt.base.diagnostics import Cases
from nctakt.messages.cases import by_beginning, names_of_variables
from nctakt.messages.catalogue import error, note, warning

INVALID_ALIGNMENT = warning(
    1000178,
    en="{value} is not a valid alignment of the external variables; the controller chooses one",
    de="{value} ist keine gültige Ausrichtung der externen Variablen; die Steuerung wählt sie",
    remedy_en="Use 0, 1, 2, 4 or 8.",
    remedy_de="0, 1, 2, 4 oder 8 verwenden.",
    value=("P-STUP-00145 as written", "P-STUP-00145, wie geschrieben"),
)
INVALID_SCOPE = warning(
    21196,
    en="{key}: '{value}' is not a scope; {default} is used",
    de="{key}: '{value}' ist kein Gültigkeitsbereich; es gilt {default}",
    remedy_en="Use GLOBAL or CHANNEL.",
    remedy_de="GLOBAL oder CHANNEL verwenden.",
    cause_en="Only GLOBAL variables are shared by all channels, so a variable with an invalid "
    "scope stays in its channel.",
    cause_de="Nur GLOBAL-Variablen gelten für alle Kanäle; eine Variable mit ungültigem "
    "Gültigkeitsbereich bleibt darum in ihrem Kanal.",
    default=("the scope that is used", "der Gültigkeitsbereich, der gilt"),
    classes=(1, 1),
)
CHANNEL_VARIABLES_TOO_LARGE = error(
    22079,
    en="V.CH variables need {needed} bytes, but P-CHAN-00424 provides {available}; the channel "
    "gets none of them",
    de="V.CH-Variablen brauchen {needed} Byte, P-CHAN-00424 bietet aber {available}; der Kanal "
    "erhält keine davon",
    remedy_en="Set configuration.decoder.v_ch_memory to at least {needed}.",
    remedy_de="configuration.decoder.v_ch_memory auf mindestens {needed} setzen.",
    cause_en="Each variable needs its data and some bytes of management; variables are not stored "
    "partially.",
    cause_de="Jede Variable braucht ihre Daten und einige Byte Verwaltung; Variablen werden nicht "
    "teilweise gespeichert.",
    needed=("bytes of data and management", "Byte für Daten und Verwaltung"),
    available=("P-CHAN-00424", "P-CHAN-00424"),
    classes=(2, 7),
)
INVALID_VARIABLE_NAME = warning(
    900080,
    cases=Cases((20788, 21182, 21485, 21429, 21430, 21432, 21433), names_of_variables),
    en="{key}: '{value}' is not a valid name of a variable or is already used; the variable is "
    "ignored",
    de="{key}: '{value}' ist kein gültiger Variablenname oder schon vergeben; die Variable wird "
    "ignoriert",
    remedy_en="Use up to {limit} letters, digits and underscores, starting with a letter.",
    remedy_de="Bis zu {limit} Buchstaben, Ziffern und Unterstriche verwenden, mit einem Buchstaben "
    "beginnend.",
    value=("the name", "der Name"),
    limit=("the maximum length", "die größte Länge"),
)
LONG_VARIABLE_NAME = note(
    900972,
    en="{key}: the name has {length} characters; a controller may allow only {limit}",
    de="{key}: der Name hat {length} Zeichen; eine Steuerung erlaubt womöglich nur {limit}",
    remedy_en="Shorten the name if the controller refuses it.",
    remedy_de="Den Namen kürzen, falls die Steuerung ihn ablehnt.",
    length=("the length of the variable's name", "die Länge des Variablennamens"),
    limit=("the length given in the manual", "die Länge laut Handbuch"),
)
VARIABLE_BEYOND_COUNT = warning(
    900081,
    known_as=(20085,),
    en="{key} does not exist: number_used_variables is {count}",
    de="{key} gibt es nicht: number_used_variables ist {count}",
    remedy_en="Set number_used_variables to the highest index plus 1.",
    remedy_de="number_used_variables auf den höchsten Index plus 1 setzen.",
    key=("the first variable beyond this number", "die erste Variable jenseits dieser Anzahl"),
    count=("P-EXTV-00010", "P-EXTV-00010"),
)
UNKNOWN_VARIABLE_TYPE = warning(
    20088,
    known_as=(900082, 21434, 21435, 21437, 21438, 21442),
    cases=by_beginning("key", {"STRUCT": 21441}),
    en="{key}: '{value}' is neither a type nor a structure of this list; the variable is ignored",
    de="{key}: '{value}' ist weder ein Typ noch eine Struktur dieser Liste; die Variable wird "
    "ignoriert",
    remedy_en="{meant}Use one of {names}, or the name of a structure.",
    remedy_de="{meant}Einen der Typen {names} oder den Namen einer Struktur verwenden.",
    value=("the type as written", "der Typ, wie geschrieben"),
    names=("the types", "die Typen"),
    meant=("the type that is probably meant", "der Typ, der wohl gemeint ist"),
)
RECURSIVE_STRUCTURE = warning(
    900083,
    known_as=(21440,),
    en="structure {name} contains itself; variables of this type are ignored",
    de="die Struktur {name} enthält sich selbst; Variablen dieses Typs werden ignoriert",
    remedy_en="Remove the circular reference.",
    remedy_de="Den Zirkelbezug auflösen.",
    name=("the structure", "die Struktur"),
)
VARIABLE_TOO_LARGE = warning(
    900084,
    known_as=(21602,),
    en="{key}: the variable has more than {limit} elements and is ignored",
    de="{key}: die Variable hat mehr als {limit} Elemente und wird ignoriert",
    remedy_en="Make its arrays smaller.",
    remedy_de="Ihre Felder verkleinern.",
    limit=("the maximum number of elements", "die größte Anzahl von Elementen"),
)
VARIABLES_TOO_MANY = warning(
    902028,
    en="{key}: with this variable the list has more than {limit} elements: it is ignored",
    de="{key}: mit dieser Variable hat die Liste mehr als {limit} Elemente: sie wird ignoriert",
    remedy_en="Make the arrays of the list smaller.",
    remedy_de="Die Felder der Liste verkleinern.",
    cause_en="A list must not take the memory of the computer that simulates it.",
    cause_de="Eine Liste darf dem Rechner, der sie simuliert, nicht den Speicher nehmen.",
    limit=("the maximum number of elements", "die größte Anzahl von Elementen"),
)
VARIABLE_STRUCTURE_TOO_DEEP = warning(
    21440,
    known_as=(900085,),
    en="structures in {name} are nested more than {limit} deep; variables of this type are ignored",
    de="Strukturen in {name} sind tiefer als {limit} geschachtelt; Variablen dieses Typs werden "
    "ignoriert",
    remedy_en="Nest the structures less deeply.",
    remedy_de="Die Strukturen weniger tief schachteln.",
    name=("the outermost structure", "die äußerste Struktur"),
    limit=("the maximum nesting", "die größte Schachtelung"),
)
VARIABLES_OVERLAP = warning(
    21848,
    known_as=(900087,),
    en="V.E.{name} at byte {offset} overlaps V.E.{other} in the memory of the PLC: it is left out",
    de="V.E.{name} bei Byte {offset} überlappt V.E.{other} im Speicher der SPS und entfällt",
    remedy_en="Omit byte_offset, or give each variable a separate location.",
    remedy_de="byte_offset weglassen oder jeder Variablen einen eigenen Ort geben.",
    name=("the variable with the larger offset", "die Variable mit dem größeren Offset"),
    other=("the variable before it", "die Variable davor"),
    offset=("its first byte", "ihr erstes Byte"),
)
VARIABLE_OFFSET_TOO_LARGE = warning(
    21988,
    known_as=(900088, 21518, 21519),
    en="{key}: byte {value} is out of range; the variable is left out",
    de="{key}: Byte {value} liegt außerhalb des Bereichs; die Variable entfällt",
    remedy_en="Give an offset up to {limit}, or leave it to the controller with -1.",
    remedy_de="Einen Offset bis {limit} angeben oder ihn mit -1 der Steuerung überlassen.",
    value=("P-EXTV-00002 as written", "P-EXTV-00002, wie geschrieben"),
    limit=("the largest possible offset", "der größte mögliche Offset"),
)
VARIABLE_OUTSIDE_MEMORY = warning(
    21518,
    cases=by_beginning("scope", {"GLOBAL": 21519}),
    en="V.E.{name} ({scope}) would end at byte {end} of {available}: it is left out",
    de="V.E.{name} ({scope}) würde bei Byte {end} von {available} enden und entfällt",
    remedy_en="Give it a smaller byte_offset, or increase ext_var_max (P-STUP-00037).",
    remedy_de="Einen kleineren byte_offset angeben oder ext_var_max (P-STUP-00037) erhöhen.",
    scope=("P-EXTV-00004", "P-EXTV-00004"),
    end=("the byte after it", "das Byte danach"),
    available=("P-STUP-00037 in bytes", "P-STUP-00037 in Byte"),
)
EXTERNAL_VARIABLES_TOO_LARGE = warning(
    21520,
    known_as=(900814, 21197, 21342),
    en="the V.E variables of channel {channel} need {needed} bytes, but ext_var_max provides "
    "{available}",
    de="die V.E-Variablen von Kanal {channel} brauchen {needed} Byte, ext_var_max bietet aber "
    "{available}",
    remedy_en="Increase ext_var_max (P-STUP-00037): it counts blocks of 24 bytes.",
    remedy_de="ext_var_max erhöhen (P-STUP-00037): es zählt Blöcke zu 24 Byte.",
    needed=("the bytes of the variables", "die Bytes der Variablen"),
    available=("P-STUP-00037 in bytes", "P-STUP-00037 in Byte"),
)
