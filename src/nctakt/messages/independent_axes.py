# SPDX-License-Identifier: MIT
"""Messages about independent axes of programs: INDP_SYN, INDP_ASYN."""

from __future__ import annotations

from nctakt.messages.catalogue import error

_FORM = ("INDP_SYN or INDP_ASYN", "INDP_SYN oder INDP_ASYN")

INDEPENDENT_SYNTAX = error(
    21068,
    known_as=(902400, 21083),
    en="{axis}[{form} …]: {reason}",
    de="{axis}[{form} …]: {reason}",
    remedy_en="Write {axis}[{form} G90 G01 FEED=500 POS=100] or {axis}[{form} G90 G00 POS=100].",
    remedy_de="{axis}[{form} G90 G01 FEED=500 POS=100] oder {axis}[{form} G90 G00 POS=100] "
    "schreiben.",
    cause_en="An independent axis moves to a position (G90) or by a distance (G91), at rapid "
    "traverse (G00) or with a speed of its own (G01).",
    cause_de="Eine unabhängige Achse fährt auf eine Position (G90) oder um einen Weg (G91), im "
    "Eilgang (G00) oder mit eigener Geschwindigkeit (G01).",
    form=_FORM,
    reason=("what does not fit", "was nicht passt"),
)
INDEPENDENT_KEYWORD_NOT_FIRST = error(
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
INDEPENDENT_VALUE_INVALID = error(
    21375,
    known_as=(21374,),
    en="{axis}[{form} …]: {word} cannot be {value}",
    de="{axis}[{form} …]: {word} kann nicht {value} sein",
    remedy_en="FEED and TIME must be above 0, FEED_MAX_WEIGHT above 0 and at most 100 percent.",
    remedy_de="FEED und TIME müssen über 0 liegen, FEED_MAX_WEIGHT über 0 und höchstens bei 100 "
    "Prozent.",
    form=_FORM,
)
INDEPENDENT_IN_TRANSFORMATION = error(
    21071,
    known_as=(1709, 50948),
    en="{axis}[{form} …]: a transformation is active, in which {axis} cannot move alone",
    de="{axis}[{form} …]: eine Transformation ist aktiv, in der {axis} nicht allein fahren kann",
    remedy_en="Write #TRAFO OFF before, or move the axis with the path.",
    remedy_de="Vorher #TRAFO OFF schreiben oder die Achse mit der Bahn bewegen.",
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
