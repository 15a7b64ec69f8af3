# SPDX-License-Identifier: MIT
"""Messages about labels, jumps, calls and the ends of programs."""

from __future__ import annotations

from nctakt.messages.catalogue import error, warning

SUBPROGRAM_END_IN_MAIN_PROGRAM = error(
    900123,
    en="{word} ends a subprogram, and this is the main program",
    de="{word} beendet ein Unterprogramm, und dies ist das Hauptprogramm",
    remedy_en="Write M30, or call this text with L or LL.",
    remedy_de="M30 schreiben oder diesen Text mit L oder LL rufen.",
    word=("the word as written", "das Wort, wie geschrieben"),
)
PROGRAM_END_IN_SUBPROGRAM = warning(
    900124,
    en="{word} in a subprogram ends the main program",
    de="{word} in einem Unterprogramm beendet das Hauptprogramm",
    remedy_en="Write M17 to go back to the caller.",
    remedy_de="Mit M17 geht es zurück zum Aufrufer.",
    word=("the word as written", "das Wort, wie geschrieben"),
)
BLOCK_NUMBER_BEFORE_HASH_IF = error(
    900125,
    en="no block number stands before #IF",
    de="vor #IF steht keine Satznummer",
    remedy_en="Remove the number, or write $IF.",
    remedy_de="Die Nummer entfernen oder $IF schreiben.",
)
UNKNOWN_LABEL = error(
    900126,
    en="this program has no label {label}",
    de="dieses Programm hat keine Sprungmarke {label}",
    remedy_en="Nearest: {nearest}. Write N20: or [NAME] before a block of the same program.",
    remedy_de="Am nächsten: {nearest}. N20: oder [NAME] vor einen Satz desselben Programms "
    "schreiben.",
    cause_en="A jump stays within its main program or subprogram.",
    cause_de="Ein Sprung bleibt in seinem Haupt- oder Unterprogramm.",
    label=("the label", "die Sprungmarke"),
    nearest=("the label that is most like it", "die ähnlichste Sprungmarke"),
)
JUMP_INTO_LOOP = error(
    900127,
    en="the label {label} stands in a loop: no jump leads there",
    de="die Sprungmarke {label} steht in einer Schleife: dorthin führt kein Sprung",
    remedy_en="Put the label before or behind the loop; $CONTINUE and $BREAK stay within it.",
    remedy_de="Die Marke vor oder hinter die Schleife setzen; in ihr bleiben $CONTINUE und $BREAK.",
    label=("the label", "die Sprungmarke"),
)
DUPLICATE_LABEL = error(
    900128,
    en="the label {label} stands twice in this program",
    de="die Sprungmarke {label} steht zweimal in diesem Programm",
    remedy_en="Rename one of them.",
    remedy_de="Eine der beiden umbenennen.",
    label=("the label", "die Sprungmarke"),
)
UNKNOWN_LOCAL_SUBPROGRAM = error(
    900129,
    en="this file has no local subprogram {name}",
    de="diese Datei hat kein lokales Unterprogramm {name}",
    remedy_en="It has: {nearest}. A local subprogram begins with %L {name}; a file is called with "
    "L.",
    remedy_de="Vorhanden: {nearest}. Ein lokales Unterprogramm beginnt mit %L {name}; eine Datei "
    "ruft L.",
    name=("the name", "der Name"),
    nearest=("the nearest local subprogram", "das nächste lokale Unterprogramm"),
)
DUPLICATE_LOCAL_SUBPROGRAM = error(
    900130,
    en="the local subprogram {name} begins in line {line} already",
    de="das lokale Unterprogramm {name} beginnt schon in Zeile {line}",
    remedy_en="Rename one of them.",
    remedy_de="Eines der beiden umbenennen.",
    name=("the name", "der Name"),
    line=("the line of the first one", "die Zeile des ersten"),
)
PROGRAM_NOT_FOUND = error(
    900131,
    en="the program {name} is not found",
    de="das Programm {name} ist nicht zu finden",
    remedy_en="Searched: {folders}. path[i].dir of the channel list names further folders.",
    remedy_de="Gesucht: {folders}. Weitere Ordner nennt path[i].dir der Kanalliste.",
    name=("the name", "der Name"),
    folders=("where it was searched", "wo es gesucht wurde"),
    reaction=2,
    clearing=3,
)
INVALID_CALL_PARAMETER = error(
    900133,
    en="{word} is nothing that a call hands over",
    de="{word} ist nichts, was ein Aufruf übergibt",
    remedy_en="A call has NAME and @P1 … @P200; perhaps {nearest} is meant.",
    remedy_de="Ein Aufruf hat NAME und @P1 … @P200; vielleicht ist {nearest} gemeint.",
    word=("the word", "das Wort"),
    nearest=("the word that is most like it", "das ähnlichste Wort"),
)
INVALID_RETURN_OPTION = error(
    900135,
    en="{word} says nothing about a return",
    de="{word} sagt nichts über einen Rücksprung",
    remedy_en="M17 has [MAIN] or [JUMPS=number], and one label: [NAME] or N20.",
    remedy_de="M17 hat [MAIN] oder [JUMPS=Zahl] und eine Marke: [NAME] oder N20.",
    word=("the word as written", "das Wort, wie geschrieben"),
)
CYCLE_CALL_WITHOUT_NAME = error(
    900916,
    en="L CYCLE without NAME: nothing tells which program is called",
    de="L CYCLE ohne NAME: nichts sagt, welches Programm gerufen wird",
    remedy_en="Write NAME=file.nc among its keywords: L CYCLE [NAME=file.nc @P1=5]",
    remedy_de="NAME=datei.nc zu den Schlüsselwörtern schreiben: L CYCLE [NAME=datei.nc @P1=5]",
)
