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
    axis=("the axis", "die Achse"),
    reaction=2,
    clearing=3,
)
INVALID_FIXED_STOP_RANGE = error(
    21968,
    en="START = {start} and END = {end} of FIXED_STOP are no part of the way",
    de="START = {start} und END = {end} von FIXED_STOP sind kein Teil des Wegs",
    remedy_en="Give percents of the block's way: from 0 on, START below END, END at most 100.",
    remedy_de="Prozente des Wegs im Satz angeben: ab 0, START kleiner als END, END höchstens 100.",
    start=("the value of START", "der Wert von START"),
    end=("the value of END", "der Wert von END"),
    reaction=2,
    clearing=3,
)
FIXED_STOP_NOT_FOUND = error(
    50885,
    en="the axis {axis} has found no fixed stop on its way",
    de="die Achse {axis} hat auf ihrem Weg keinen Festanschlag gefunden",
    remedy_en="Move farther, lower POS_LAG_LIMIT, or write ERR_NOT_DETECTED=0.",
    remedy_de="Weiter fahren, POS_LAG_LIMIT senken oder ERR_NOT_DETECTED=0 schreiben.",
    cause_en="An axis that is monitored has to meet an obstacle; that of the simulation is "
    "antr.simu.fixed_stop of the axis list.",
    cause_de="Eine überwachte Achse muss auf ein Hindernis treffen; das der Simulation ist "
    "antr.simu.fixed_stop der Achsliste.",
    axis=("the axis", "die Achse"),
    reaction=6,
    clearing=6,
)
