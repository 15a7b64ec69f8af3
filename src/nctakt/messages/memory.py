# SPDX-License-Identifier: MIT
"""Messages of texts, wholes and the packed image of V.E (900340 … 900359)."""

from __future__ import annotations

from nctakt.messages.catalogue import ERROR, WARNING, Catalogue

MESSAGES = Catalogue()
_add = MESSAGES.add

_add(
    900340,
    ERROR,
    "{name} holds a text; a number is needed here",
    "{name} enthält einen Text; hier wird eine Zahl gebraucht",
    remedy_en="Use a variable with a number; texts can be assigned, compared and shown by #MSG.",
    remedy_de="Eine Zahl verwenden; Texte lassen sich zuweisen, vergleichen, mit #MSG zeigen.",
    parameters={"name": "the variable, or the text"},
    reaction=2,
    clearing=3,
)
_add(
    900341,
    ERROR,
    "{operator} does not work with texts",
    "{operator} ist für Texte nicht definiert",
    remedy_en="Compare texts with == or !=, join them with +.",
    remedy_de="Texte mit == oder != vergleichen, mit + aneinanderhängen.",
    parameters={"operator": "the operator"},
    reaction=2,
    clearing=3,
)
_add(
    900342,
    ERROR,
    "{value} is no text; a text is needed here",
    "{value} ist kein Text; hier wird ein Text gebraucht",
    remedy_en='Write a text between "…" or name a variable of type STRING or VSTRING.',
    remedy_de='"…" schreiben oder eine Variable vom Typ STRING oder VSTRING angeben.',
    parameters={"value": "the expression as written"},
    reaction=2,
    clearing=3,
)
_add(
    900343,
    ERROR,
    "{name} takes {limit} characters; the text has {count}",
    "{name} fasst {limit} Zeichen; der Text hat {count}",
    remedy_en="Shorten it, or enlarge the variable: P-EXTV-00022 for STRING, 00008 for VSTRING",
    remedy_de="Ihn kürzen oder die Variable vergrößern: P-EXTV-00022 für STRING, 00008 für VSTRING",
    parameters={
        "name": "the variable",
        "limit": "the most characters that it takes",
        "count": "characters of the text",
    },
    reaction=2,
    clearing=3,
)
_add(
    900344,
    ERROR,
    "{name} cannot hold the character {character}",
    "{name} kann das Zeichen {character} nicht enthalten",
    remedy_en="Use characters of Windows-1252: a variable keeps one byte for each.",
    remedy_de="Zeichen aus Windows-1252 verwenden: eine Variable hat ein Byte für jedes.",
    parameters={"name": "the variable", "character": "number of the character in Unicode"},
    reaction=2,
    clearing=3,
)
_add(
    900345,
    ERROR,
    "{value} has not the type of {name} and cannot be assigned as a whole",
    "{value} hat nicht den Typ von {name} und kann nicht als Ganzes zugewiesen werden",
    remedy_en="Assign single values, such as {member}",
    remedy_de="Einzelne Werte zuweisen, etwa {member}",
    parameters={
        "value": "the structure or array on the right",
        "name": "the one on the left",
        "member": "a value of the one on the right",
    },
    reaction=2,
    clearing=3,
)
_add(
    900346,
    WARNING,
    "the PLC wrote no finite number into {variable}, which keeps its value",
    "die SPS hat keine endliche Zahl in {variable} geschrieben; der Wert bleibt",
    remedy_en="Write a finite number; this is told once for each variable.",
    remedy_de="Eine endliche Zahl schreiben; gemeldet wird das einmal je Variable.",
    parameters={"variable": "the variable"},
    reaction=1,
    clearing=1,
)
_add(
    900347,
    ERROR,
    "this controller has an image of the HLI already",
    "diese Steuerung hat schon ein Abbild des HLI",
    remedy_en="Use that one, or close it before.",
    remedy_de="Dieses verwenden oder es vorher schließen.",
)
_add(
    900348,
    ERROR,
    "the shared memory is still looked at and stays in this process",
    "der gemeinsame Speicher wird noch betrachtet und bleibt in diesem Prozess",
    remedy_en="Release all views of its memory and sections, then close the image again.",
    remedy_de="Alle Ansichten des Speichers und der Bereiche freigeben, dann nochmals schließen.",
)
_add(
    900349,
    ERROR,
    "there is a shared memory {name} already",
    "einen gemeinsamen Speicher {name} gibt es schon",
    remedy_en="Take another name; if nobody uses the old one any longer, remove it (/dev/shm).",
    remedy_de="Einen anderen Namen wählen; den alten, falls unbenutzt, entfernen (/dev/shm).",
    parameters={"name": "the name that was given"},
)
_add(
    900350,
    ERROR,
    "a shared memory {name} cannot be had: {reason}",
    "ein gemeinsamer Speicher {name} ist nicht zu bekommen: {reason}",
    remedy_en="Take a short name of letters, digits and underscores.",
    remedy_de="Einen kurzen Namen aus Buchstaben, Ziffern und Unterstrichen wählen.",
    parameters={"name": "the name that was given", "reason": "what the system says"},
)
_add(
    900351,
    ERROR,
    "{name} belongs to the channel; a PLC does not see it",
    "{name} gehört dem Kanal; eine SPS sieht sie nicht",
    remedy_en="Use a V.E variable, which programs, cycles and the PLC share.",
    remedy_de="Eine V.E-Variable verwenden, die Programme, Zyklen und SPS gemeinsam haben.",
    parameters={"name": "the variable"},
)
