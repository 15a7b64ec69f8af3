# SPDX-License-Identifier: MIT
"""Messages about labels, jumps, calls and the ends of programs."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note

SUBPROGRAM_END_IN_MAIN_PROGRAM = error(
    20376,
    classes=(0, 0),
    known_as=(900123,),
    en="{word} ends a subprogram, but this is the main program",
    de="{word} beendet ein Unterprogramm, dies ist aber das Hauptprogramm",
    remedy_en="Write M30, or call this text with L or LL.",
    remedy_de="M30 schreiben oder diesen Text mit L oder LL aufrufen.",
)
PROGRAM_ENDS_AS_SUBPROGRAM = note(
    901076,
    en="{word} ends a subprogram: run as a main program, this file is refused (20376)",
    de="{word} beendet ein Unterprogramm: als Hauptprogramm wird diese Datei abgelehnt (20376)",
    remedy_en="Write M30 if it is a main program; check it together with its caller if it is not.",
    remedy_de="M30 schreiben, wenn es ein Hauptprogramm ist; sonst mit dem Aufrufer zusammen "
    "prüfen.",
)
PROGRAM_END_IN_SUBPROGRAM = error(
    20377,
    classes=(0, 0),
    known_as=(900124,),
    en="{word} ends a main program, but this is a subprogram",
    de="{word} beendet ein Hauptprogramm, dies ist aber ein Unterprogramm",
    remedy_en="Write M17 to return to the caller.",
    remedy_de="M17 schreiben, um zum Aufrufer zurückzukehren.",
)
BLOCK_NUMBER_BEFORE_HASH_IF = error(
    20593,
    classes=(0, 0),
    known_as=(900125,),
    en="there must be no block number before #IF",
    de="vor #IF darf keine Satznummer stehen",
    remedy_en="Remove the number, or write $IF.",
    remedy_de="Die Nummer entfernen oder $IF schreiben.",
)
UNKNOWN_LABEL = error(
    20840,
    classes=(0, 0),
    known_as=(900126, 21697, 21698),
    en="this program has no label {label}",
    de="dieses Programm hat keine Sprungmarke {label}",
    remedy_en="Did you mean {nearest}? Write {form} before a block of the same program.",
    remedy_de="War {nearest} gemeint? {form} vor einen Satz desselben Programms schreiben.",
    cause_en="A jump stays within its main program or subprogram.",
    cause_de="Ein Sprung bleibt in seinem Haupt- oder Unterprogramm.",
    nearest=("the most similar label", "die ähnlichste Sprungmarke"),
    form=("the label as it is written before a block", "die Marke, wie sie vor einem Satz steht"),
)
JUMP_INTO_LOOP = error(
    21480,
    classes=(0, 0),
    known_as=(900127,),
    en="the label {label} is in a loop: it is not possible to jump there",
    de="die Sprungmarke {label} steht in einer Schleife: dorthin kann nicht gesprungen werden",
    remedy_en="Put the label before or after the loop; use $CONTINUE and $BREAK inside it.",
    remedy_de="Die Marke vor oder hinter die Schleife setzen; innerhalb $CONTINUE und $BREAK "
    "verwenden.",
)
DUPLICATE_LABEL = error(
    20836,
    classes=(0, 0),
    known_as=(900128,),
    en="the label {label} is defined twice in this program",
    de="die Sprungmarke {label} ist in diesem Programm doppelt definiert",
    remedy_en="Rename one of them.",
    remedy_de="Eine der beiden umbenennen.",
)
UNKNOWN_LOCAL_SUBPROGRAM = error(
    20373,
    classes=(0, 0),
    known_as=(900129,),
    en="this file has no local subprogram {name}",
    de="diese Datei hat kein lokales Unterprogramm {name}",
    remedy_en="Did you mean {nearest}? A local subprogram begins with %L {name}; call a file with "
    "L.",
    remedy_de="War {nearest} gemeint? Ein lokales Unterprogramm beginnt mit %L {name}; Dateien mit "
    "L aufrufen.",
    nearest=("the most similar local subprogram", "das ähnlichste lokale Unterprogramm"),
)
DUPLICATE_LOCAL_SUBPROGRAM = error(
    900130,
    en="the local subprogram {name} is already defined in line {line}",
    de="das lokale Unterprogramm {name} ist schon in Zeile {line} definiert",
    remedy_en="Rename one of them.",
    remedy_de="Eines der beiden umbenennen.",
    line=("the line of the first definition", "die Zeile der ersten Definition"),
)
PROGRAM_NOT_FOUND = error(
    20369,
    known_as=(900131, 20368, 20364),
    en="program {name} was not found",
    de="das Programm {name} wurde nicht gefunden",
    remedy_en="Searched: {folders}. Add folders with path[i].dir in the channel list.",
    remedy_de="Durchsucht: {folders}. Weitere Ordner mit path[i].dir in der Kanalliste angeben.",
    folders=("the folders that were searched", "die durchsuchten Ordner"),
)
INVALID_CALL_PARAMETER = error(
    900133,
    known_as=(21220, 22151),
    en="{word} is not a parameter of a call",
    de="{word} ist kein Parameter eines Aufrufs",
    remedy_en="Did you mean {nearest}? A call has NAME and @P1 … @P200.",
    remedy_de="War {nearest} gemeint? Ein Aufruf hat NAME und @P1 … @P200.",
)
INVALID_RETURN_OPTION = error(
    900135,
    known_as=(21220, 22151),
    en="{word} is not a valid option of a return",
    de="{word} ist keine gültige Angabe für einen Rücksprung",
    remedy_en="M17 takes [MAIN] or [JUMPS=number], and a label: [NAME] or N20.",
    remedy_de="M17 nimmt [MAIN] oder [JUMPS=Zahl] und eine Marke: [NAME] oder N20.",
)
CYCLE_CALL_WITHOUT_NAME = error(
    900916,
    known_as=(21208,),
    en="L CYCLE without NAME: it is not clear which program to call",
    de="L CYCLE ohne NAME: es ist nicht klar, welches Programm aufgerufen werden soll",
    remedy_en="Add NAME=file.nc to its keywords: L CYCLE [NAME=file.nc @P1=5]",
    remedy_de="NAME=datei.nc bei den Schlüsselwörtern ergänzen: L CYCLE [NAME=datei.nc @P1=5]",
)
