# SPDX-License-Identifier: MIT
"""Messages of checked program: single-axis commands of realtime cycles (900260 … 900269)."""

from __future__ import annotations

from nctakt.messages.catalogue import ERROR, Catalogue

MESSAGES = Catalogue()
_add = MESSAGES.add

_WORD = {"word": "the word as written"}
_AXIS = {"axis": "the axis"}

_add(
    22032,
    ERROR,
    "{axis}[INDP …]: the keyword {word} stands twice",
    "{axis}[INDP …]: das Schlüsselwort {word} steht zweimal",
    remedy_en="Keep one of both.",
    remedy_de="Eines von beiden behalten.",
    cause_en="The keywords of a single-axis command stand in any order, each once.",
    cause_de="Die Schlüsselwörter eines Einzelachsbefehls stehen in beliebiger Reihenfolge, jedes "
    "einmal.",
    parameters={**_AXIS, **_WORD},
    reaction=2,
    clearing=3,
)
_add(
    50965,
    ERROR,
    "{axis}[INDP …] takes no {word}",
    "{axis}[INDP …] nimmt kein {word}",
    remedy_en="G90, G91, G00 and G01 are possible, written as numbers.",
    remedy_de="Möglich sind G90, G91, G00 und G01, als Zahlen geschrieben.",
    cause_en="A single axis moves straight: absolute or relative, with rapid speed or with FEED.",
    cause_de="Eine Einzelachse fährt geradeaus: absolut oder relativ, im Eilgang oder mit FEED.",
    parameters={**_AXIS, **_WORD},
    reaction=6,
    clearing=6,
)
_add(
    50966,
    ERROR,
    "{axis} may not be moved on its own (P-AXIS-00457)",
    "{axis} darf nicht für sich bewegt werden (P-AXIS-00457)",
    remedy_en="Write kenngr.enable_single_axis 1 into the list of that axis.",
    remedy_de="kenngr.enable_single_axis 1 in die Liste dieser Achse schreiben.",
    cause_en="Realtime cycles and the PLC move an axis beside the path only where its list allows "
    "it.",
    cause_de="Echtzeit-Zyklen und SPS bewegen eine Achse neben der Bahn nur, wo ihre Liste das "
    "erlaubt.",
    parameters=_AXIS,
    reaction=6,
    clearing=6,
)
_add(
    50967,
    ERROR,
    "{axis}[INDP …]: {reason_en}",
    "{axis}[INDP …]: {reason_de}",
    remedy_en="Write {axis}[INDP G90 G01 FEED=500 POS=100], {axis}[INDP FEED=500] or "
    "{axis}[INDP STOP].",
    remedy_de="{axis}[INDP G90 G01 FEED=500 POS=100], {axis}[INDP FEED=500] oder "
    "{axis}[INDP STOP] schreiben.",
    cause_en="A single-axis command goes to a position, runs endlessly, or stops; its keywords "
    "must say one of these.",
    cause_de="Ein Einzelachsbefehl fährt auf eine Position, fährt endlos oder stoppt; seine "
    "Schlüsselwörter müssen eines davon sagen.",
    parameters={
        **_AXIS,
        "reason_en": "what does not fit, in English",
        "reason_de": "what does not fit, in German",
    },
    reaction=6,
    clearing=6,
)
_add(
    900260,
    ERROR,
    "{axis}[INDP …] belongs into a realtime cycle",
    "{axis}[INDP …] gehört in einen Echtzeit-Zyklus",
    remedy_en="Move it into #RT CYCLE … #RT CYCLE END, or move the axis with the path.",
    remedy_de="In #RT CYCLE … #RT CYCLE END verschieben oder die Achse mit der Bahn bewegen.",
    parameters=_AXIS,
)
_add(
    900261,
    ERROR,
    "{axis}[INDP …] has no keyword {word}",
    "{axis}[INDP …] hat kein Schlüsselwort {word}",
    remedy_en="Keywords: ABORTING, BUFFERED, STOP, OFFSET=, G90, G91, G00, G01, FEED=, POS=, DIR=",
    remedy_de="Wörter: ABORTING, BUFFERED, STOP, OFFSET=, G90, G91, G00, G01, FEED=, POS=, DIR=",
    parameters={**_AXIS, **_WORD},
)
_add(
    900262,
    ERROR,
    "{spindle} is a spindle; INDP moves axes",
    "{spindle} ist eine Spindel; INDP bewegt Achsen",
    remedy_en="Name an axis of the channel in front of the bracket.",
    remedy_de="Vor der Klammer eine Achse des Kanals nennen.",
    parameters={"spindle": "the spindle"},
)
_add(
    900263,
    ERROR,
    "the keyword {word} takes no value",
    "das Schlüsselwort {word} nimmt keinen Wert",
    remedy_en="Leave the value out.",
    remedy_de="Den Wert weglassen.",
    parameters=_WORD,
)
