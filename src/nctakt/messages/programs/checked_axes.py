# SPDX-License-Identifier: MIT
"""Messages about checked programs: commands to single axes."""

from __future__ import annotations

from nctakt.messages.catalogue import error

DUPLICATE_INDP_KEYWORD = error(
    22032,
    known_as=(21373,),
    en="{axis}[INDP …]: the keyword {word} is given twice",
    de="{axis}[INDP …]: das Schlüsselwort {word} ist doppelt angegeben",
    remedy_en="Keep one of them.",
    remedy_de="Eines davon behalten.",
    cause_en="The keywords of a single-axis command may appear in any order, each once.",
    cause_de="Die Schlüsselwörter eines Einzelachsbefehls stehen in beliebiger Reihenfolge, jedes "
    "einmal.",
)
INDP_KEYWORD_NOT_ALLOWED = error(
    50965,
    en="{word} is not allowed in {axis}[INDP …]",
    de="{word} ist in {axis}[INDP …] nicht erlaubt",
    remedy_en="Only G90, G91, G00 and G01 are possible, written as numbers.",
    remedy_de="Möglich sind nur G90, G91, G00 und G01, als Zahlen geschrieben.",
    cause_en="A single axis moves in a straight line: absolute or relative, at rapid speed or with "
    "FEED.",
    cause_de="Eine Einzelachse fährt geradlinig: absolut oder relativ, im Eilgang oder mit FEED.",
    classes=(6, 6),
)
INDEPENDENT_MOTION_NOT_PERMITTED = error(
    50966,
    known_as=(21936,),
    en="{axis} must not be moved independently (P-AXIS-00457)",
    de="{axis} darf nicht unabhängig bewegt werden (P-AXIS-00457)",
    remedy_en="Write kenngr.enable_single_axis 1 in the list of that axis.",
    remedy_de="kenngr.enable_single_axis 1 in die Liste dieser Achse schreiben.",
    cause_en="Realtime cycles and the PLC can move an axis independently of the path only if its "
    "list allows it.",
    cause_de="Neben der Bahn bewegen Echtzeit-Zyklen und SPS eine Achse nur, wenn ihre Liste es "
    "erlaubt.",
    classes=(6, 6),
)
INDEPENDENT_MOTION_REFUSED = error(
    50967,
    known_as=(1700, 60212, 21374, 21375),
    en="{axis}[INDP …]: {reason}",
    de="{axis}[INDP …]: {reason}",
    remedy_en="Write {axis}[INDP G90 G01 FEED=500 POS=100], {axis}[INDP FEED=500] or {axis}[INDP "
    "STOP].",
    remedy_de="{axis}[INDP G90 G01 FEED=500 POS=100], {axis}[INDP FEED=500] oder {axis}[INDP STOP] "
    "schreiben.",
    cause_en="A single-axis command moves to a position, moves endlessly or stops; its keywords "
    "must specify one of these.",
    cause_de="Ein Einzelachsbefehl fährt auf eine Position, fährt endlos oder stoppt; seine "
    "Schlüsselwörter müssen eines davon angeben.",
    reason=("what does not fit", "was nicht passt"),
    classes=(6, 6),
)
INDP_OUTSIDE_REALTIME_CYCLE = error(
    900260,
    known_as=(21083,),
    en="{axis}[INDP …] belongs in a realtime cycle",
    de="{axis}[INDP …] gehört in einen Echtzeit-Zyklus",
    remedy_en="Move it into #RT CYCLE … #RT CYCLE END, or move the axis with the path.",
    remedy_de="In #RT CYCLE … #RT CYCLE END verschieben oder die Achse mit der Bahn bewegen.",
)
INDP_MISSING = error(
    901984,
    en="{axis}[…] has {word}, a keyword of independent motion, but not INDP",
    de="{axis}[…] hat {word}, ein Schlüsselwort unabhängiger Bewegung, aber kein INDP",
    remedy_en="Write {axis}[INDP …] in a realtime cycle.",
    remedy_de="In einem Echtzeit-Zyklus {axis}[INDP …] schreiben.",
)
UNKNOWN_AXIS_COMMAND = error(
    901985,
    en="{axis}[{word} …] is not a known command for an axis",
    de="{axis}[{word} …] ist kein bekannter Befehl für eine Achse",
    remedy_en="Did you mean {nearest}? Commands for an axis: {names}.",
    remedy_de="War {nearest} gemeint? Befehle für eine Achse: {names}.",
    names=("all of them", "alle"),
)
UNKNOWN_INDP_KEYWORD = error(
    21068,
    classes=(0, 0),
    known_as=(900261,),
    en="{axis}[INDP …]: unknown keyword {word}",
    de="{axis}[INDP …]: unbekanntes Schlüsselwort {word}",
    remedy_en="Keywords: ABORTING, BUFFERED, STOP, OFFSET=, G90, G91, G00, G01, FEED=, POS=, DIR=",
    remedy_de="Schlüsselwörter: ABORTING, BUFFERED, STOP, OFFSET=, G90, G91, G00, G01, FEED=, "
    "POS=, DIR=",
)
INDP_OF_SPINDLE = error(
    900262,
    known_as=(21414,),
    en="{spindle} is a spindle; INDP moves axes",
    de="{spindle} ist eine Spindel; INDP bewegt Achsen",
    remedy_en="Name an axis of the channel before the bracket.",
    remedy_de="Vor der Klammer eine Achse des Kanals nennen.",
)
INDP_KEYWORD_WITH_VALUE = error(
    21068,
    classes=(0, 0),
    known_as=(900263,),
    en="the keyword {word} takes no value",
    de="das Schlüsselwort {word} erwartet keinen Wert",
    remedy_en="Remove the value.",
    remedy_de="Den Wert entfernen.",
)
