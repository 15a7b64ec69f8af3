# SPDX-License-Identifier: MIT
"""Messages about chamfers and roundings."""

from __future__ import annotations

from nctakt.messages.cases import by_word
from nctakt.messages.catalogue import error, warning

CORNER_SIZE_MISSING = error(
    20012,
    en="{word}: the chamfer or rounding has no size",
    de="{word}: die Fase oder Rundung hat keine Größe",
    remedy_en="Write I with a size above 0 in the block; later G301 or G302 may leave it out.",
    remedy_de="I mit einer Größe über 0 in den Satz schreiben; spätere G301 oder G302 brauchen es "
    "nicht.",
    word=("G301, G302 or a word with a size", "G301, G302 oder ein Wort mit einer Größe"),
)
CORNER_SIZE_INVALID = error(
    20800,
    en="{word}: {value} is not a size of a chamfer or rounding",
    de="{word}: {value} ist keine Größe einer Fase oder Rundung",
    remedy_en="Write a size above 0.",
    remedy_de="Eine Größe über 0 schreiben.",
    word=("G301, G302 or a word with a size", "G301, G302 oder ein Wort mit einer Größe"),
    value=("the size as programmed", "die Größe, wie programmiert"),
)
CORNER_OFF = error(
    21718,
    cases=by_word("word", {"#ANG": 21932, "#CHR": 21932, "#CHF": 21932, "#RND": 21932}),
    en="{word}: chamfers and roundings are switched off",
    de="{word}: Fasen und Rundungen sind abgeschaltet",
    remedy_en="Set disable_chamfers_roundings (P-CHAN-00273) to 0, or program the corner itself.",
    remedy_de="disable_chamfers_roundings (P-CHAN-00273) auf 0 setzen oder die Ecke selbst "
    "programmieren.",
    word=("G301, G302 or a word with a size", "G301, G302 oder ein Wort mit einer Größe"),
)
CORNER_WITHOUT_MOTION = warning(
    20351,
    en="no motion before the chamfer or rounding; nothing is inserted",
    de="vor der Fase oder Rundung fehlt eine Bewegung; nichts wird eingefügt",
    remedy_en="Put G301 or G302 between two motions without a wait in between.",
    remedy_de="G301 oder G302 zwischen zwei Bewegungen setzen, ohne Warten dazwischen.",
    classes=(1, 1),
)
CORNER_WITHOUT_NEXT_MOTION = warning(
    901610,
    en="no motion after the chamfer or rounding; nothing is inserted",
    de="nach der Fase oder Rundung fehlt eine Bewegung; nichts wird eingefügt",
    remedy_en="Program a motion directly after it, without a wait in between.",
    remedy_de="Direkt danach eine Bewegung programmieren, ohne Warten dazwischen.",
)
CORNER_BESIDE_MOTION = error(
    901611,
    en="{word} is in the block of {corner}, which belongs between two motions",
    de="{word} steht im Satz von {corner}, der zwischen zwei Bewegungen liegt",
    remedy_en="Put {corner} into a separate block, or use #CHR or #RND in the block of a motion.",
    remedy_de="{corner} in einen eigenen Satz setzen oder #CHR oder #RND im Satz einer Bewegung "
    "verwenden.",
    word=("the axis word as written", "das Achswort, wie geschrieben"),
    corner=("G301 or G302", "G301 oder G302"),
)
CORNER_FEED_WITHOUT_CORNER = error(
    901612,
    en="#FRC is in a block without chamfer or rounding",
    de="#FRC steht in einem Satz ohne Fase oder Rundung",
    remedy_en="Write it in a block with G301, G302, #CHR, #CHF or #RND, or use F.",
    remedy_de="Neben G301, G302, #CHR, #CHF oder #RND schreiben oder F verwenden.",
)
CORNER_FEED_WITHOUT_G94 = error(
    901613,
    en="#FRC needs G94, but G{mode} is active",
    de="#FRC braucht G94, aktiv ist aber G{mode}",
    remedy_en="Program G94 first, or leave out #FRC.",
    remedy_de="Vorher G94 programmieren oder #FRC weglassen.",
    mode=("number of the active G function", "Nummer der aktiven G-Funktion"),
)
CORNER_TOO_LARGE = error(
    901614,
    en="{size} mm is too large here: the motion {side} the corner would turn back",
    de="{size} mm ist hier zu groß: die Bewegung {side} der Ecke würde umkehren",
    remedy_en="Use a smaller chamfer or rounding, or longer motions.",
    remedy_de="Eine kleinere Fase oder Rundung oder längere Bewegungen verwenden.",
    size=("the size in mm", "die Größe in mm"),
    side=("before or after", "vor oder nach"),
)
CORNER_NOT_IN_PLANE = error(
    901615,
    en="no chamfer or rounding here: the motion {side} the corner is not in plane G{plane}",
    de="keine Fase oder Rundung hier: die Bewegung {side} der Ecke liegt nicht in der Ebene "
    "G{plane}",
    remedy_en="Select the plane of the two motions with G17, G18 or G19.",
    remedy_de="Mit G17, G18 oder G19 die Ebene der beiden Bewegungen wählen.",
    side=("before or after", "vor oder nach"),
    plane=("number of the active plane", "Nummer der aktiven Ebene"),
)
CORNER_REVERSES = error(
    901616,
    en="no rounding with radius {size} mm touches both motions at this corner",
    de="keine Rundung mit dem Radius {size} mm berührt beide Bewegungen an dieser Ecke",
    remedy_en="Use a smaller radius; motions that turn straight back have no rounding.",
    remedy_de="Einen kleineren Radius verwenden; zwischen Bewegungen hin und zurück gibt es keine "
    "Rundung.",
    size=("the radius in mm", "der Radius in mm"),
)
TWO_CORNERS = error(
    901617,
    en="{word}: the earlier {other} already inserts something at this corner",
    de="{word}: das frühere {other} fügt an dieser Ecke schon etwas ein",
    remedy_en="Keep one of them, or put a motion between them.",
    remedy_de="Eines davon behalten oder eine Bewegung dazwischen setzen.",
    word=("the later word", "das spätere Wort"),
    other=("the earlier word", "das frühere Wort"),
)
