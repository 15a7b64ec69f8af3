# SPDX-License-Identifier: MIT
"""Messages about moving to a fixed stop."""

from __future__ import annotations

from nctakt.messages.catalogue import error

FIXED_STOP_WITHOUT_MOTION = error(
    21966,
    en="{axis}[FIXED_STOP ON] in a block that does not move {axis}",
    de="{axis}[FIXED_STOP ON] in einem Satz, der {axis} nicht bewegt",
    remedy_en="Program the motion to the stop in the same block: X100 X[FIXED_STOP ON].",
    remedy_de="Die Bewegung zum Anschlag im selben Satz programmieren: X100 X[FIXED_STOP ON].",
)
INVALID_FIXED_STOP_RANGE = error(
    21968,
    en="START = {start} and END = {end} of FIXED_STOP are not a part of the path",
    de="START = {start} und END = {end} von FIXED_STOP bezeichnen keinen Teil des Weges",
    remedy_en="Give percentages of the block's path length: from 0, START below END, END at most "
    "100.",
    remedy_de="Prozente des Weges im Satz angeben: ab 0, START kleiner als END, END höchstens 100.",
    start=("the value of START", "der Wert von START"),
    end=("the value of END", "der Wert von END"),
)
FIXED_STOP_NOT_FOUND = error(
    50886,
    en="axis {axis} found no fixed stop on its way",
    de="Achse {axis} hat auf ihrem Weg keinen Festanschlag gefunden",
    remedy_en="Program a longer motion, lower POS_LAG_LIMIT, or write ERR_NOT_DETECTED=0.",
    remedy_de="Einen längeren Weg programmieren, POS_LAG_LIMIT senken oder ERR_NOT_DETECTED=0 "
    "schreiben.",
    cause_en="A monitored axis must meet an obstacle; in the simulation this is "
    "antr.simu.fixed_stop of the axis list.",
    cause_de="Eine überwachte Achse muss auf ein Hindernis treffen; in der Simulation ist das "
    "antr.simu.fixed_stop der Achsliste.",
    classes=(6, 6),
)
FIXED_STOP_WITHOUT_HISTORY = error(
    50881,
    en="{axis}[FIXED_STOP ON] needs the history of the path, and this channel has none",
    de="{axis}[FIXED_STOP ON] braucht die Historie der Bahn, und dieser Kanal hat keine",
    remedy_en="Give the channel memory for it: fb_storage_size (P-STUP-00033).",
    remedy_de="Dem Kanal Speicher dafür geben: fb_storage_size (P-STUP-00033).",
)
FIXED_STOP_ACTIVE = error(
    21969,
    known_as=(50885,),
    en="{axis} is already monitored for a fixed stop",
    de="{axis} wird schon auf einen Festanschlag überwacht",
    remedy_en="End the monitoring first, with a motion away from the stop: {axis}0 "
    "{axis}[FIXED_STOP OFF].",
    remedy_de="Die Überwachung zuerst beenden, mit einer Bewegung vom Anschlag weg: {axis}0 "
    "{axis}[FIXED_STOP OFF].",
)
AXIS_AT_FIXED_STOP = error(
    21967,
    known_as=(50889,),
    en="{axis} is at a fixed stop, or was on its way to it, and cannot be moved",
    de="{axis} steht am Festanschlag oder war auf dem Weg dorthin und kann nicht verfahren werden",
    remedy_en="End the monitoring in the block that moves away: {axis}0 {axis}[FIXED_STOP OFF].",
    remedy_de="Die Überwachung im Satz beenden, der wegfährt: {axis}0 {axis}[FIXED_STOP OFF].",
)
POSITION_AT_FIXED_STOP = error(
    21964,
    known_as=(50884,),
    en="#CHANNEL INIT [ACTPOS] asks for the position of {axis}, which is at a fixed stop",
    de="#CHANNEL INIT [ACTPOS] fordert die Position von {axis} an, die am Festanschlag steht",
    remedy_en="Leave the stop first: {axis}0 {axis}[FIXED_STOP OFF].",
    remedy_de="Zuerst vom Anschlag wegfahren: {axis}0 {axis}[FIXED_STOP OFF].",
)
