# SPDX-License-Identifier: MIT
"""Messages about offsets between programmed and axis positions."""

from __future__ import annotations

from nctakt.messages.catalogue import error

G159_WITHOUT_NUMBER = error(
    20147,
    classes=(0, 0),
    known_as=(900770,),
    en="G159 needs the number of a zero offset",
    de="G159 braucht die Nummer einer Nullpunktverschiebung",
    remedy_en="Write G159 = 7; group n in the list of zero offsets is np_grp[n].",
    remedy_de="G159 = 7 schreiben; Gruppe n steht in der Nullpunktliste als np_grp[n].",
)
COMMAND_WITHOUT_AXIS = error(
    20052,
    classes=(0, 0),
    known_as=(900771, 20003),
    en="{command} names no axis",
    de="{command} nennt keine Achse",
    remedy_en="Write the axes and their values after it, as in G92 X10.",
    remedy_de="Die Achsen mit ihren Werten dahinter schreiben, wie in G92 X10.",
)
MOTION_WORD_WITH_OFFSETS = error(
    900772,
    en="{word} is not allowed with {command}, whose values are not a motion",
    de="{word} ist bei {command} nicht erlaubt, dessen Werte keine Bewegung sind",
    remedy_en="Write the motion in a separate block.",
    remedy_de="Die Bewegung in einen eigenen Satz schreiben.",
)
UNKNOWN_OFFSET_KIND = error(
    20873,
    classes=(0, 0),
    known_as=(900773, 20521),
    en="{word} is not a kind of offset",
    de="{word} ist keine Art von Verschiebung",
    remedy_en="Possible: {names}.",
    remedy_de="Möglich: {names}.",
    names=("the possible words", "die möglichen Wörter"),
)
UNKNOWN_ZERO_OFFSET = error(
    20149,
    classes=(0, 0),
    known_as=(900774, 20582, 20584),
    en="there is no zero offset {group}",
    de="es gibt keine Nullpunktverschiebung {group}",
    remedy_en="Use a whole number from 0 to {highest}.",
    remedy_de="Eine ganze Zahl von 0 bis {highest} verwenden.",
    group=("the number as programmed", "die Nummer, wie programmiert"),
)
