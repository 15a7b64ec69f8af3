# SPDX-License-Identifier: MIT
"""Messages about ``nctakt explain``, ``why`` and ``coverage``: requests without a result."""

from __future__ import annotations

from nctakt.messages.catalogue import error

UNKNOWN_TOPIC = error(
    900570,
    en="unknown topic '{word}'",
    de="unbekanntes Stichwort '{word}'",
    remedy_en="nctakt explain without a word lists all topics.",
    remedy_de="nctakt explain ohne Wort zeigt alle Stichwörter.",
)
MISSPELLED_TOPIC = error(
    900571,
    en="unknown topic '{word}'",
    de="unbekanntes Stichwort '{word}'",
    remedy_en="Did you mean {nearest}?",
    remedy_de="War {nearest} gemeint?",
)
CYCLE_NOT_IN_RUN = error(
    900574,
    en="this run has no realtime cycle {cycle}",
    de="dieser Lauf hat keinen Echtzeit-Zyklus {cycle}",
    remedy_en="Name one of these: {known}",
    remedy_de="Einen von diesen nennen: {known}",
    cycle=("the ID that was given", "die angegebene ID"),
    known=("the IDs of the run's cycles", "die IDs der Zyklen des Laufs"),
)
LINE_NOT_IN_CYCLE = error(
    900575,
    en="line {line} does not belong to a realtime cycle",
    de="Zeile {line} gehört zu keinem Echtzeit-Zyklus",
    remedy_en="The nearest line of a cycle is {nearest}",
    remedy_de="Die nächste Zeile eines Zyklus ist {nearest}",
    nearest=("the nearest line of a cycle", "die nächste Zeile eines Zyklus"),
)
TICK_NOT_IN_RUN = error(
    900576,
    en="tick {tick} is outside the run, which went from tick {first} to tick {last}",
    de="Takt {tick} liegt außerhalb des Laufs, der von Takt {first} bis Takt {last} ging",
    remedy_en="Give a time within the run.",
    remedy_de="Eine Zeit innerhalb des Laufs angeben.",
    first=("the run's first tick", "der erste Takt des Laufs"),
    last=("its last tick", "sein letzter Takt"),
)
RUN_WITHOUT_CYCLES = error(
    900577,
    en="there is no realtime cycle {cycle}: this run defined no cycles",
    de="es gibt keinen Echtzeit-Zyklus {cycle}: dieser Lauf hat keinen definiert",
    remedy_en="Leave the cycle out to see which definitions were not reached.",
    remedy_de="Den Zyklus weglassen, um zu sehen, welche Definitionen nicht erreicht wurden.",
    cycle=("the ID that was given", "die angegebene ID"),
)
PROGRAMS_WITHOUT_CYCLES = error(
    900578,
    en="line {line} does not belong to a realtime cycle: the programs have no cycles",
    de="Zeile {line} gehört zu keinem Echtzeit-Zyklus: die Programme haben keinen",
    remedy_en="Name a program that defines realtime cycles.",
    remedy_de="Ein Programm nennen, das Echtzeit-Zyklen definiert.",
)
MACHINE_VARIABLE_UNCHANGED = error(
    902932,
    en="no PLC in Structured Text has written {name} in this run; at its end it is {value}",
    de="keine SPS in Strukturiertem Text hat {name} in diesem Lauf geschrieben; am Ende ist sie "
    "{value}",
    remedy_en="Its values in each tick: nctakt run, with --trace FILE --signals {name}.",
    remedy_de="Ihre Werte in jedem Takt: nctakt run, mit --trace DATEI --signals {name}.",
)
PLC_VARIABLE_UNCHANGED = error(
    902660,
    en="this run has recorded no write of {path} by the PLC",
    de="dieser Lauf hat kein Schreiben von {path} durch die SPS aufgezeichnet",
    remedy_en="{meant}Texts, pointers, FOR counters and libraries are not recorded.",
    remedy_de="{meant}Texte, Zeiger, FOR-Zähler und Bibliotheken werden nicht aufgezeichnet.",
    path=("the path that was given", "der angegebene Pfad"),
    meant=("the path that is probably meant", "der Pfad, der wohl gemeint ist"),
)
