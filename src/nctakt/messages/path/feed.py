# SPDX-License-Identifier: MIT
"""Messages about feeds and the program's overrides."""

from __future__ import annotations

from nctakt.base.diagnostics import Cases
from nctakt.messages.cases import feed_factor
from nctakt.messages.catalogue import error, note, warning

FEED_PER_REVOLUTION_SPINDLE_STOPPED = error(
    22044,
    en="feed per revolution (G95), but the program leaves spindle {spindle} stopped",
    de="Vorschub je Umdrehung (G95), aber das Programm lässt die Spindel {spindle} stehen",
    remedy_en="Program M03 or M04 with a speed S first.",
    remedy_de="Vorher M03 oder M04 mit einer Drehzahl S programmieren.",
    classes=(6, 6),
)
FEED_NOT_POSITIVE = error(
    20176,
    known_as=(900903, 900926, 120022),
    en="feed {value} is not above 0",
    de="Vorschub {value} liegt nicht über 0",
    remedy_en="Program F with a value above 0; the target defines the direction.",
    remedy_de="F mit einem Wert über 0 programmieren; die Richtung ergibt sich aus dem Ziel.",
)
INVALID_PROGRAM_OVERRIDE = error(
    21419,
    known_as=(900835,),
    cases=Cases((21826, 21987), feed_factor),
    en="{word} {value} is not a valid override: {low} … {high} %",
    de="{word} {value} ist kein gültiger Override: {low} … {high} %",
    remedy_en="Give a value in this range; 100 is the programmed speed.",
    remedy_de="Einen Wert in diesem Bereich angeben; 100 ist die programmierte Geschwindigkeit.",
    word=("FEED_FACT, RAPID_FACT or SPEED_FACT", "FEED_FACT, RAPID_FACT oder SPEED_FACT"),
    low=("lowest override", "kleinster Override"),
    high=("highest override", "größter Override"),
)
FEED_PER_REVOLUTION_WITHOUT_SPINDLE = error(
    21980,
    known_as=(900836,),
    en="feed per revolution (G95), but the channel has no main spindle",
    de="Vorschub je Umdrehung (G95), aber der Kanal hat keine Hauptspindel",
    remedy_en="Name it in the channel list: main_spindle_ax_nr (P-CHAN-00051), main_spindle_name "
    "(P-CHAN-00053).",
    remedy_de="Sie in der Kanalliste nennen: main_spindle_ax_nr (P-CHAN-00051), main_spindle_name "
    "(P-CHAN-00053).",
)
END_FEED_WITHOUT_G94 = error(
    901590,
    en="E, the feed at the block's end, needs feed per minute (G94); G{mode} is active",
    de="E, der Vorschub am Satzende, braucht Vorschub je Minute (G94); aktiv ist G{mode}",
    remedy_en="Program G94, or remove E.",
    remedy_de="G94 programmieren oder E entfernen.",
    mode=("the active G function", "die aktive G-Funktion"),
    classes=(2, 3),
)
INVALID_WEIGHT = error(
    901550,
    known_as=(120027, 120028, 120031, 120032),
    en="{word}: the weight {value} % is not allowed",
    de="{word}: die Gewichtung {value} % ist nicht zulässig",
    remedy_en="Program a weight above 0; 0 is allowed for G127, G128, G129 and G136, too.",
    remedy_de="Eine Gewichtung über 0 programmieren; 0 auch bei G127, G128, G129 und G136.",
    word=("the G function", "die G-Funktion"),
    classes=(2, 3),
)
NO_FEED_AXES = note(
    21209,
    en="#FGROUP: the channel list names no axes of the feed; F refers to the linear axes",
    de="#FGROUP: die Kanalliste nennt keine Vorschubachsen; F bezieht sich auf die Linearachsen",
    remedy_en="Name the axes: #FGROUP [X, Y], or in the channel list (P-CHAN-00011, P-CHAN-00096).",
    remedy_de="Die Achsen nennen: #FGROUP [X, Y], oder in der Kanalliste (P-CHAN-00011, "
    "P-CHAN-00096).",
)
FEED_GROUP_NOT_FOR_SPLINES = warning(
    120462,
    en="F refers to the linear axes of a spline, whatever #FGROUP says",
    de="F bezieht sich beim Spline auf die Linearachsen, unabhängig von #FGROUP",
    remedy_en="Program #FGROUP before the spline, naming all linear axes.",
    remedy_de="Vor dem Spline #FGROUP mit allen Linearachsen programmieren.",
)
AXIS_NOT_ROTARY = error(
    901830,
    en="#FGROUP ROT: {axis} is not a rotary axis",
    de="#FGROUP ROT: {axis} ist keine Rundachse",
    remedy_en="Name the rotary axis that turns the workpiece: #FGROUP ROT [AX=C REF=40].",
    remedy_de="Die Rundachse nennen, die das Werkstück dreht: #FGROUP ROT [AX=C REF=40].",
    classes=(2, 3),
)
FEED_GROUP_VALUE_NOT_POSITIVE = error(
    901831,
    en="#FGROUP: {word}={value} is not above 0",
    de="#FGROUP: {word}={value} liegt nicht über 0",
    remedy_en="Program a factor of the axis, or a radius in mm, above 0.",
    remedy_de="Einen Faktor der Achse oder einen Radius in mm über 0 programmieren.",
    word=("the axis or REF", "die Achse oder REF"),
    classes=(2, 3),
)
CORNER_FEED_MISSING = error(
    20795,
    en="G13: no feed for corners has been set",
    de="G13: es ist kein Vorschub für Ecken festgelegt",
    remedy_en="Program #CORNER PARAM [DIST=10 UNIT=PERCENT FEED=50] before it.",
    remedy_de="Davor #CORNER PARAM [DIST=10 UNIT=PERCENT FEED=50] programmieren.",
)
CORNER_VALUE_NOT_POSITIVE = error(
    901832,
    en="#CORNER PARAM: {word}={value} is not above 0",
    de="#CORNER PARAM: {word}={value} liegt nicht über 0",
    remedy_en="Program a distance and a feed above 0; G12 switches the deceleration off.",
    remedy_de="Abstand und Vorschub über 0 programmieren; G12 schaltet die Verzögerung aus.",
    word=("DIST or FEED", "DIST oder FEED"),
    classes=(2, 3),
)
WAITING_FOR_MAIN_SPINDLE = warning(
    900819,
    known_as=(50181, 60132),
    en="the path waits for the main spindle, which is stopped: feed per revolution (G95)",
    de="die Bahn wartet auf die Hauptspindel, die steht: Vorschub je Umdrehung (G95)",
    remedy_en="Let the spindle turn (M3 S1000), or program feed per minute (G94).",
    remedy_de="Die Spindel drehen lassen (M3 S1000) oder den Vorschub je Minute angeben (G94).",
    cause_en="The path speed is the spindle speed times the feed; the path continues when the "
    "spindle turns.",
    cause_de="Die Bahngeschwindigkeit ist Drehzahl mal Vorschub; die Bahn fährt weiter, wenn die "
    "Spindel dreht.",
)
