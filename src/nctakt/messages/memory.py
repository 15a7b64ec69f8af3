# SPDX-License-Identifier: MIT
"""Messages about texts, structures, arrays and the packed image of V.E."""

from __future__ import annotations

from nctakt.messages.catalogue import error, warning

TEXT_INSTEAD_OF_NUMBER = error(
    900340,
    en="{name} holds a text; a number is needed here",
    de="{name} enthält einen Text; hier wird eine Zahl gebraucht",
    remedy_en="Use a variable with a number; texts can be assigned, compared and shown by #MSG.",
    remedy_de="Eine Zahl verwenden; Texte lassen sich zuweisen, vergleichen, mit #MSG zeigen.",
    name=("the variable, or the text", "die Variable oder der Text"),
    reaction=2,
    clearing=3,
)
OPERATOR_WITH_TEXT = error(
    900341,
    en="{operator} does not work with texts",
    de="{operator} ist für Texte nicht definiert",
    remedy_en="Compare texts with == or !=, join them with +.",
    remedy_de="Texte mit == oder != vergleichen, mit + aneinanderhängen.",
    operator=("the operator", "der Operator"),
    reaction=2,
    clearing=3,
)
NUMBER_INSTEAD_OF_TEXT = error(
    900342,
    en="{value} is no text; a text is needed here",
    de="{value} ist kein Text; hier wird ein Text gebraucht",
    remedy_en='Write a text between "…" or name a variable of type STRING or VSTRING.',
    remedy_de='"…" schreiben oder eine Variable vom Typ STRING oder VSTRING angeben.',
    value=("the expression as written", "der Ausdruck, wie geschrieben"),
    reaction=2,
    clearing=3,
)
TEXT_TOO_LONG = error(
    900343,
    en="{name} takes {limit} characters; the text has {count}",
    de="{name} fasst {limit} Zeichen; der Text hat {count}",
    remedy_en="Shorten it, or enlarge the variable: P-EXTV-00022 for STRING, 00008 for VSTRING",
    remedy_de="Ihn kürzen oder die Variable vergrößern: P-EXTV-00022 für STRING, 00008 für VSTRING",
    name=("the variable", "die Variable"),
    limit=("the most characters that it takes", "die meisten Zeichen, die sie fasst"),
    count=("characters of the text", "Zeichen des Textes"),
    reaction=2,
    clearing=3,
)
CHARACTER_NOT_STORABLE = error(
    900344,
    en="{name} cannot hold the character {character}",
    de="{name} kann das Zeichen {character} nicht enthalten",
    remedy_en="Use characters of Windows-1252: a variable keeps one byte for each.",
    remedy_de="Zeichen aus Windows-1252 verwenden: eine Variable hat ein Byte für jedes.",
    name=("the variable", "die Variable"),
    character=("number of the character in Unicode", "Nummer des Zeichens in Unicode"),
    reaction=2,
    clearing=3,
)
AGGREGATE_TYPE_MISMATCH = error(
    900345,
    en="{value} has not the type of {name} and cannot be assigned as a whole",
    de="{value} hat nicht den Typ von {name} und kann nicht als Ganzes zugewiesen werden",
    remedy_en="Assign single values, such as {member}",
    remedy_de="Einzelne Werte zuweisen, etwa {member}",
    value=("the structure or array on the right", "die Struktur oder das Feld rechts"),
    name=("the one on the left", "das, was links steht"),
    member=("a value of the one on the right", "ein Wert dessen, was rechts steht"),
    reaction=2,
    clearing=3,
)
PLC_VALUE_NOT_FINITE = warning(
    900346,
    en="the PLC wrote no finite number into {variable}, which keeps its value",
    de="die SPS hat keine endliche Zahl in {variable} geschrieben; der Wert bleibt",
    remedy_en="Write a finite number; this is told once for each variable.",
    remedy_de="Eine endliche Zahl schreiben; gemeldet wird das einmal je Variable.",
    variable=("the variable", "die Variable"),
    reaction=1,
    clearing=1,
)
HLI_IMAGE_EXISTS = error(
    900347,
    en="this controller has an image of the HLI already",
    de="diese Steuerung hat schon ein Abbild des HLI",
    remedy_en="Use that one, or close it before.",
    remedy_de="Dieses verwenden oder es vorher schließen.",
)
SHARED_MEMORY_IN_USE = error(
    900348,
    en="the shared memory is still looked at and stays in this process",
    de="der gemeinsame Speicher wird noch betrachtet und bleibt in diesem Prozess",
    remedy_en="Release all views of its memory and sections, then close the image again.",
    remedy_de="Alle Ansichten des Speichers und der Bereiche freigeben, dann nochmals schließen.",
)
SHARED_MEMORY_EXISTS = error(
    900349,
    en="there is a shared memory {name} already",
    de="einen gemeinsamen Speicher {name} gibt es schon",
    remedy_en="Take another name; if nobody uses the old one any longer, remove it (/dev/shm).",
    remedy_de="Einen anderen Namen wählen; den alten, falls unbenutzt, entfernen (/dev/shm).",
    name=("the name that was given", "der angegebene Name"),
)
SHARED_MEMORY_NOT_AVAILABLE = error(
    900350,
    en="a shared memory {name} cannot be had: {reason}",
    de="ein gemeinsamer Speicher {name} ist nicht zu bekommen: {reason}",
    remedy_en="Take a short name of letters, digits and underscores.",
    remedy_de="Einen kurzen Namen aus Buchstaben, Ziffern und Unterstrichen wählen.",
    name=("the name that was given", "der angegebene Name"),
    reason=("what the system says", "was das System sagt"),
)
NOT_VISIBLE_TO_PLC = error(
    900351,
    en="{name} belongs to the channel; a PLC does not see it",
    de="{name} gehört dem Kanal; eine SPS sieht sie nicht",
    remedy_en="Use a V.E variable, which programs, cycles and the PLC share.",
    remedy_de="Eine V.E-Variable verwenden, die Programme, Zyklen und SPS gemeinsam haben.",
    name=("the variable", "die Variable"),
)
