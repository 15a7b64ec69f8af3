# SPDX-License-Identifier: MIT
"""Messages about paths of the interface between CNC and PLC."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note

_PATH = ("the path as it was given", "der Pfad, wie er angegeben wurde")

UNKNOWN_HLI_PATH = error(
    902100,
    en="the interface has no {path}: nothing is called {part} there",
    de="die Schnittstelle hat kein {path}: dort heißt nichts {part}",
    remedy_en="Did you mean {nearest}? Find paths by any part of a name with nctakt explain.",
    remedy_de="War {nearest} gemeint? Mit nctakt explain nach jedem Teil eines Namens suchen.",
    path=_PATH,
    part=("the name in it that is unknown", "der unbekannte Name darin"),
    nearest=("the nearest path, or –", "der ähnlichste Pfad, oder –"),
)
INDEX_OUTSIDE_ARRAY = error(
    902101,
    en="{path}: there is no index {index}",
    de="{path}: den Index {index} gibt es nicht",
    remedy_en="Give an index from {low} to {high}.",
    remedy_de="Einen Index von {low} bis {high} angeben.",
    path=_PATH,
    index=("the index that is not there", "der Index, den es nicht gibt"),
    low=("the first index", "der erste Index"),
    high=("the last index", "der letzte Index"),
)
NO_INDEX_TAKEN = error(
    902102,
    en="{path}: {name} is not an array and takes no index",
    de="{path}: {name} ist kein Feld und nimmt keinen Index",
    remedy_en="Leave the index out.",
    remedy_de="Den Index weglassen.",
    path=_PATH,
    name=("the name before the index", "der Name vor dem Index"),
)
PATH_OF_NO_CHANNEL = error(
    902103,
    en="{path}: the machine has {count} of them, counted from 0",
    de="{path}: die Maschine hat davon {count}, ab 0 gezählt",
    remedy_en="Give a smaller index after gpCh or gpAx.",
    remedy_de="Hinter gpCh oder gpAx einen kleineren Index angeben.",
    path=_PATH,
    count=("channels, or axes", "Kanäle, oder Achsen"),
)
PATH_IS_STRUCTURE = error(
    902104,
    en="{path} is a structure, not a single value",
    de="{path} ist eine Struktur, kein einzelner Wert",
    remedy_en="Name one of its members: {members}",
    remedy_de="Eines ihrer Elemente nennen: {members}",
    path=_PATH,
    members=("its members", "ihre Elemente"),
)
PATH_READ_ONLY = error(
    902105,
    en="{path} cannot be written: the CNC writes it",
    de="{path} lässt sich nicht schreiben: die CNC schreibt es",
    remedy_en="Write command_w and enable_w of its control unit, if it has one.",
    remedy_de="command_w und enable_w der Control Unit schreiben, wenn es eine hat.",
    path=_PATH,
)
PATH_HAS_NO_EFFECT = note(
    902106,
    en="{path} is known and has no effect here",
    de="{path} ist bekannt und hat hier keine Wirkung",
    path=_PATH,
)
UNIT_NOT_ENABLED = note(
    902107,
    en="the control unit {path} acts only with its enable_w, and with plc_present_w of its area",
    de="die Control Unit {path} wirkt nur mit ihrem enable_w und mit plc_present_w ihres Bereichs",
    path=("the path of the control unit", "der Pfad der Control Unit"),
)
NO_SUCH_TRANSITION = error(
    902108,
    en="{path}: a number is not finite, or the transition leads to a mode or state that is not "
    "simulated",
    de="{path}: eine Zahl ist nicht endlich, oder der Übergang führt zu etwas nicht Simuliertem",
    remedy_en="Go to mode 2 (automatic), state 1 … 5 or 15.",
    remedy_de="In Betriebsart 2 (Automatik) gehen, Zustand 1 … 5 oder 15.",
    path=_PATH,
)
NUMBER_NOT_TAKEN = error(
    902850,
    en="{path} does not take {value}: the meaning of this number on the controller is not "
    "simulated",
    de="{path} nimmt {value} nicht an: die Bedeutung dieser Zahl auf der Steuerung ist nicht "
    "simuliert",
    remedy_en="Write one of these: {known}.",
    remedy_de="Eine von diesen schreiben: {known}.",
    path=_PATH,
    known=("the numbers that are simulated", "die Zahlen, die simuliert werden"),
)
NO_SUCH_BYTES = error(
    902321,
    en="{path}: no element begins and ends there; the pointer leads to {size} bytes",
    de="{path}: dort beginnt und endet kein Element; der Zeiger führt zu {size} Byte",
    remedy_en="nctakt explain elements shows where each element begins.",
    remedy_de="nctakt explain elements zeigt, wo jedes Element beginnt.",
    path=_PATH,
    size=("the bytes that the pointer leads to", "die Bytes hinter dem Zeiger"),
)
TRANSITION_DROPPED = note(
    902322,
    en="{path} had a transition to a mode or state that is not simulated; it is dropped",
    de="{path}: dort stand ein Übergang zu etwas nicht Simuliertem; er wurde verworfen",
    path=_PATH,
)
PATH_NOT_SERVED = error(
    902109,
    en="{path} has no value here: nctakt does not compute it",
    de="{path} hat hier keinen Wert: nctakt berechnet ihn nicht",
    remedy_en="nctakt explain elements lists the elements that act and those that show something.",
    remedy_de="nctakt explain elements nennt die Elemente, die wirken, und die, die etwas "
    "anzeigen.",
    path=_PATH,
)
COUNTED_FROM_ONE = error(
    902854,
    en="{path}: there is no index 0, names of the older generation count from 1",
    de="{path}: den Index 0 gibt es nicht, Namen der älteren Generation zählen ab 1",
    remedy_en="Give an index from 1 on, or the present name, which counts from 0.",
    remedy_de="Einen Index ab 1 angeben, oder den heutigen Namen, der ab 0 zählt.",
    path=_PATH,
)
