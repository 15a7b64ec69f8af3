# SPDX-License-Identifier: MIT
"""Messages about axes that programs move independently: INDP_SYN, INDP_ASYN, OSC."""

from __future__ import annotations

from nctakt.messages.catalogue import error, warning

_FORM = ("INDP_SYN, INDP_ASYN or OSC", "INDP_SYN, INDP_ASYN oder OSC")

INDEPENDENT_SYNTAX = error(
    21068,
    known_as=(902400, 21083),
    en="{axis}[{form} …]: {reason}",
    de="{axis}[{form} …]: {reason}",
    remedy_en="Write {axis}[{form} G90 G01 FEED=500 POS=100] or {axis}[{form} G90 G00 POS=100].",
    remedy_de="{axis}[{form} G90 G01 FEED=500 POS=100] oder {axis}[{form} G90 G00 POS=100] "
    "schreiben.",
    cause_en="An independent axis moves to a position (G90) or by a distance (G91), at rapid "
    "traverse (G00) or at its own speed (G01).",
    cause_de="Eine unabhängige Achse fährt auf eine Position (G90) oder um einen Weg (G91), im "
    "Eilgang (G00) oder mit eigener Geschwindigkeit (G01).",
    form=_FORM,
    reason=("what does not fit", "was nicht passt"),
)
AXIS_KEYWORD_NOT_FIRST = error(
    21301,
    en="{axis}[…]: {form} must be the first keyword",
    de="{axis}[…]: {form} muss das erste Schlüsselwort sein",
    remedy_en="Begin the bracket with it: {axis}[{form} …].",
    remedy_de="Die Klammer damit beginnen: {axis}[{form} …].",
    form=_FORM,
)
DUPLICATE_AXIS_KEYWORD = error(
    21373,
    en="{axis}[{form} …]: the keyword {word} is given twice",
    de="{axis}[{form} …]: das Schlüsselwort {word} ist doppelt angegeben",
    remedy_en="Keep one of them.",
    remedy_de="Eines davon behalten.",
    form=_FORM,
)
AXIS_VALUE_INVALID = error(
    21375,
    known_as=(21374,),
    en="{axis}[{form} …]: {word} cannot be {value}",
    de="{axis}[{form} …]: {word} kann nicht {value} sein",
    remedy_en="FEED, TIME, FREQ, EXCUR must be above 0, FEED_MAX_WEIGHT up to 100, 1ST_DELT and "
    "2ND_DELT 0 or more.",
    remedy_de="FEED, TIME, FREQ, EXCUR müssen über 0 liegen, FEED_MAX_WEIGHT bis 100, 1ST_DELT und "
    "2ND_DELT ab 0.",
    form=_FORM,
)
INDEPENDENT_IN_TRANSFORMATION = error(
    21071,
    known_as=(1709, 50948),
    en="{axis}[{form} …]: {axis} cannot move independently while a transformation is active",
    de="{axis}[{form} …]: bei aktiver Transformation kann {axis} nicht allein fahren",
    remedy_en="Program #TRAFO OFF first, or move the axis with the path.",
    remedy_de="Vorher #TRAFO OFF programmieren oder die Achse mit der Bahn bewegen.",
    cause_en="Under a transformation the path moves all its axes together.",
    cause_de="In einer Transformation bewegt die Bahn alle ihre Achsen gemeinsam.",
    form=_FORM,
)
AXIS_MOVED_TWICE = error(
    21072,
    known_as=(21179,),
    en="{axis}[{form} …]: the block moves {axis} with the path, too",
    de="{axis}[{form} …]: der Satz bewegt {axis} auch mit der Bahn",
    remedy_en="Write the two motions into two blocks.",
    remedy_de="Die beiden Bewegungen in zwei Sätze schreiben.",
    cause_en="An axis has one owner at a time. An arc moves both axes of its plane.",
    cause_de="Eine Achse hat immer nur einen Eigentümer. Ein Kreisbogen bewegt beide Achsen seiner "
    "Ebene.",
    form=_FORM,
)
OSCILLATION_SYNTAX = error(
    902580,
    en="{axis}[{form} …]: {reason}",
    de="{axis}[{form} …]: {reason}",
    remedy_en="Write {axis}[OSC ON 1ST_POS=-5 2ND_POS=5 FREQ=1], {axis}[OSC OFF] or "
    "{axis}[OSC OFF INSTANT].",
    remedy_de="{axis}[OSC ON 1ST_POS=-5 2ND_POS=5 FREQ=1], {axis}[OSC OFF] oder "
    "{axis}[OSC OFF INSTANT] schreiben.",
    cause_en="An oscillating axis needs two positions and a speed: FEED, the frequency FREQ in Hz "
    "or the period TIME in s.",
    cause_de="Eine pendelnde Achse braucht zwei Positionen und eine Geschwindigkeit: FEED, die "
    "Frequenz FREQ in Hz oder die Periodendauer TIME in s.",
    form=_FORM,
    reason=("what does not fit", "was nicht passt"),
)
OSCILLATION_WITHOUT_SPEED = error(
    50593,
    en="{axis}[OSC …]: the oscillation has no speed",
    de="{axis}[OSC …]: das Pendeln hat keine Geschwindigkeit",
    remedy_en="Give FEED, FREQ or TIME a value above 0.",
    remedy_de="FEED, FREQ oder TIME einen Wert über 0 geben.",
)
OSCILLATION_WITHOUT_STROKE = error(
    120470,
    en="{axis}[OSC …]: both reversal positions are {position}",
    de="{axis}[OSC …]: beide Umkehrpositionen sind {position}",
    remedy_en="Give 1ST_POS and 2ND_POS different values.",
    remedy_de="1ST_POS und 2ND_POS verschiedene Werte geben.",
    position=("the position, mm or degrees", "die Position, mm oder Grad"),
)
OSCILLATION_COUNT = error(
    21237,
    en="{axis}[OSC …]: NBR_OSC cannot be {value}",
    de="{axis}[OSC …]: NBR_OSC kann nicht {value} sein",
    remedy_en="Give it a whole number from 1 to {highest}, or leave it out: the axis oscillates "
    "until OSC OFF.",
    remedy_de="Eine ganze Zahl von 1 bis {highest} angeben oder weglassen: die Achse pendelt bis "
    "OSC OFF.",
)
OSCILLATION_OUTSIDE_MODULO_RANGE = error(
    22277,
    en="{axis}[OSC …]: {position} is not in the modulo range from {low} to {high}",
    de="{axis}[OSC …]: {position} liegt nicht im Modulobereich von {low} bis {high}",
    remedy_en="Give both reversal positions in this range; SHORT makes the axis go the shorter way "
    "between them.",
    remedy_de="Beide Umkehrpositionen in diesem Bereich angeben; mit SHORT fährt die Achse den "
    "kürzeren Weg dazwischen.",
    position=("the position, degrees", "die Position, Grad"),
)
OSCILLATION_LIMITED = warning(
    50487,
    en="{axis}[OSC …]: an oscillation takes at least {reached} s instead of {period} s",
    de="{axis}[OSC …]: eine Pendelperiode dauert mindestens {reached} s statt {period} s",
    remedy_en="Shorten the stroke or the waiting times, or give the axis a lower frequency.",
    remedy_de="Hub oder Wartezeiten verkürzen oder der Achse eine kleinere Frequenz geben.",
    cause_en="The axis cannot oscillate faster with its highest speed and its acceleration.",
    cause_de="Schneller kann die Achse mit ihrer Höchstgeschwindigkeit und ihrer Beschleunigung "
    "nicht pendeln.",
    reached=("s, with the limits of the axis", "s, mit den Grenzen der Achse"),
    period=("s, as it is programmed", "s, wie programmiert"),
)
