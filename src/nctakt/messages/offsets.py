# SPDX-License-Identifier: MIT
"""Messages of offsets between programmed and axis positions (900770 … 900799)."""

from __future__ import annotations

from nctakt.messages.catalogue import ERROR, Catalogue

MESSAGES = Catalogue()
_add = MESSAGES.add

_add(
    900770,
    ERROR,
    "G159 needs the number of a zero offset",
    "G159 braucht die Nummer einer Nullpunktverschiebung",
    remedy_en="Write G159 = 7; group n of the list of zero offsets is np_grp[n].",
    remedy_de="G159 = 7 schreiben; Gruppe n der Nullpunktliste ist np_grp[n].",
)
_add(
    900771,
    ERROR,
    "{command} names no axis",
    "{command} nennt keine Achse",
    remedy_en="Write the axes with their values behind it, as in G92 X10.",
    remedy_de="Die Achsen mit ihren Werten dahinter schreiben, etwa G92 X10.",
    parameters={"command": "the word or command"},
)
_add(
    900772,
    ERROR,
    "{word} cannot stand with {command}, whose values are no motion",
    "{word} darf nicht bei {command} stehen, dessen Werte keine Bewegung sind",
    remedy_en="Write the motion into a block of its own.",
    remedy_de="Die Bewegung in einen eigenen Satz schreiben.",
    parameters={"word": "the word as written", "command": "the word or command"},
)
_add(
    900773,
    ERROR,
    "{word} is no kind of offset",
    "{word} ist keine Art von Verschiebung",
    remedy_en="Known are: {names}.",
    remedy_de="Bekannt sind: {names}.",
    parameters={"word": "the word as written", "names": "the known words"},
)
_add(
    900774,
    ERROR,
    "there is no zero offset {group}",
    "eine Nullpunktverschiebung {group} gibt es nicht",
    remedy_en="Use a whole number from 0 to {highest}.",
    remedy_de="Eine ganze Zahl von 0 bis {highest} verwenden.",
    parameters={"group": "the number as programmed", "highest": "the greatest number"},
)
