# SPDX-License-Identifier: MIT
"""Messages about texts, structures, arrays and the packed image of V.E."""

from __future__ import annotations

from nctakt.messages.cases import in_case
from nctakt.messages.catalogue import error, warning

TEXT_INSTEAD_OF_NUMBER = error(
    21461,
    known_as=(900340, 21457),
    en="{name} holds a text; a number is needed here",
    de="{name} enthält einen Text; hier wird eine Zahl gebraucht",
    remedy_en="Use a variable that holds a number; texts can be assigned, compared and output with "
    "#MSG.",
    remedy_de="Eine Variable mit einer Zahl verwenden; Texte lassen sich zuweisen, vergleichen, "
    "mit #MSG ausgeben.",
    name=("the variable, or the text", "die Variable oder der Text"),
)
OPERATOR_WITH_TEXT = error(
    21458,
    known_as=(900341,),
    en="{operator} cannot be used with texts",
    de="{operator} ist für Texte nicht möglich",
    remedy_en="Compare texts with == or !=, concatenate them with +.",
    remedy_de="Texte mit == oder != vergleichen, mit + verketten.",
    operator=("the operator", "der Operator"),
)
NUMBER_INSTEAD_OF_TEXT = error(
    21460,
    known_as=(900342,),
    en="{value} is not a text; a text is needed here",
    de="{value} ist kein Text; hier wird ein Text gebraucht",
    remedy_en="Write a text in double quotes, or name a variable of type STRING or VSTRING.",
    remedy_de="Einen Text in Anführungszeichen schreiben oder eine Variable vom Typ STRING oder "
    "VSTRING angeben.",
    value=("the expression as written", "der Ausdruck, wie geschrieben"),
)
TEXT_TOO_LONG = error(
    21462,
    known_as=(900343, 21455, 21870),
    en="{name} can hold {limit} characters; the text has {count}",
    de="{name} fasst {limit} Zeichen; der Text hat {count}",
    remedy_en="Shorten the text, or enlarge the variable: P-EXTV-00022 for STRING, 00008 for "
    "VSTRING",
    remedy_de="Den Text kürzen oder die Variable vergrößern: P-EXTV-00022 für STRING, 00008 für "
    "VSTRING",
    limit=("the maximum number of characters", "die größte Anzahl von Zeichen"),
    count=("the number of characters of the text", "die Anzahl der Zeichen des Textes"),
)
CHARACTER_NOT_STORABLE = error(
    900344,
    known_as=(22105,),
    en="{name} cannot hold the character {character}",
    de="{name} kann das Zeichen {character} nicht enthalten",
    remedy_en="Use characters of Windows-1252: a variable stores each character in one byte.",
    remedy_de="Zeichen aus Windows-1252 verwenden: eine Variable speichert jedes Zeichen in einem "
    "Byte.",
    character=("the number of the character in Unicode", "die Nummer des Zeichens in Unicode"),
    classes=(2, 3),
)
AGGREGATE_TYPE_MISMATCH = error(
    21443,
    known_as=(900345, 21444, 21445, 21447),
    en="{value} is not of the type of {name} and cannot be assigned as a whole",
    de="{value} hat nicht den Typ von {name} und kann nicht als Ganzes zugewiesen werden",
    remedy_en="Assign single values, for example {member}",
    remedy_de="Einzelne Werte zuweisen, zum Beispiel {member}",
    value=(
        "the structure or array on the right-hand side",
        "die Struktur oder das Feld auf der rechten Seite",
    ),
    name=(
        "the structure or array on the left-hand side",
        "die Struktur oder das Feld auf der linken Seite",
    ),
    member=("a value of the right-hand side", "ein Wert der rechten Seite"),
)
PLC_VALUE_NOT_FINITE = warning(
    21820,
    known_as=(900346, 50893),
    cases=in_case(21821, lambda values: values["value"] == "NaN"),
    en="the PLC wrote {value} to {variable}, which keeps its value",
    de="die SPS hat {value} in {variable} geschrieben; der Wert bleibt erhalten",
    remedy_en="Write a finite number; this is reported once for each variable.",
    remedy_de="Eine endliche Zahl schreiben; dies wird je Variable einmal gemeldet.",
    value=("an infinite number, or NaN", "eine unendliche Zahl oder NaN"),
    classes=(1, 1),
)
HLI_IMAGE_EXISTS = error(
    900347,
    en="this controller already has an image of the HLI",
    de="diese Steuerung hat schon ein Abbild des HLI",
    remedy_en="Use that image, or close it first.",
    remedy_de="Dieses Abbild verwenden oder es vorher schließen.",
)
SHARED_MEMORY_IN_USE = error(
    900348,
    en="the shared memory is still in use and stays in this process",
    de="der gemeinsame Speicher wird noch benutzt und bleibt in diesem Prozess",
    remedy_en="Release all views of its memory and its sections, then close the image again.",
    remedy_de="Alle Ansichten des Speichers und der Bereiche freigeben, dann das Abbild erneut "
    "schließen.",
)
SHARED_MEMORY_EXISTS = error(
    900349,
    en="shared memory {name} already exists",
    de="den gemeinsamen Speicher {name} gibt es schon",
    remedy_en="Choose another name; if the old one is no longer in use, remove it (/dev/shm).",
    remedy_de="Einen anderen Namen wählen; den alten, falls unbenutzt, entfernen (/dev/shm).",
)
SHARED_MEMORY_NOT_AVAILABLE = error(
    900350,
    known_as=(30073, 295014),
    en="shared memory {name} is not available: {reason}",
    de="der gemeinsame Speicher {name} ist nicht verfügbar: {reason}",
    remedy_en="Choose a short name of letters, digits and underscores.",
    remedy_de="Einen kurzen Namen aus Buchstaben, Ziffern und Unterstrichen wählen.",
)
NOT_VISIBLE_TO_PLC = error(
    900351,
    en="{name} belongs to the channel and is not visible to a PLC",
    de="{name} gehört dem Kanal und ist für eine SPS nicht sichtbar",
    remedy_en="Use a V.E variable, which programs, cycles and the PLC share.",
    remedy_de="Eine V.E-Variable verwenden, die Programme, Zyklen und SPS gemeinsam haben.",
)
