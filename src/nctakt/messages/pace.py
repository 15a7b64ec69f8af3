# SPDX-License-Identifier: MIT
"""Messages of feeds and of the program's overrides (60131, 900819, 900835 … 900839)."""

from __future__ import annotations

from nctakt.messages.catalogue import ERROR, WARNING, Catalogue

MESSAGES = Catalogue()
_add = MESSAGES.add

_add(
    60131,
    ERROR,
    "feed per revolution (G95), and the program lets spindle {spindle} stand",
    "Vorschub je Umdrehung (G95), und das Programm lässt die Spindel {spindle} stehen",
    remedy_en="Program M03 or M04 with a speed S before.",
    remedy_de="Vorher M03 oder M04 mit einer Drehzahl S programmieren.",
    parameters={"spindle": "the spindle's name"},
    reaction=6,
    clearing=6,
)
_add(
    900835,
    ERROR,
    "{word} {value} is no override: {low} … {high} %",
    "{word} {value} ist kein Override: {low} … {high} %",
    remedy_en="100 is the speed as programmed.",
    remedy_de="100 ist die programmierte Geschwindigkeit.",
    parameters={
        "word": "FEED_FACT or RAPID_FACT",
        "value": "the value",
        "low": "lowest override",
        "high": "highest override",
    },
    reaction=2,
    clearing=3,
)
_add(
    900836,
    ERROR,
    "feed per revolution (G95), and the channel has no main spindle",
    "Vorschub je Umdrehung (G95), und der Kanal hat keine Hauptspindel",
    remedy_en="main_spindle_ax_nr and main_spindle_name of the channel list name it (P-CHAN-00051, "
    "P-CHAN-00053).",
    remedy_de="main_spindle_ax_nr und main_spindle_name der Kanalliste nennen sie (P-CHAN-00051, "
    "P-CHAN-00053).",
    reaction=2,
    clearing=3,
)
_add(
    900819,
    WARNING,
    "the path waits for the main spindle, which stands: feed per revolution (G95)",
    "die Bahn wartet auf die Hauptspindel, die steht: Vorschub je Umdrehung (G95)",
    remedy_en="Let the spindle turn (M3 S1000), or program the feed per minute (G94).",
    remedy_de="Die Spindel drehen lassen (M3 S1000) oder den Vorschub je Minute angeben (G94).",
    cause_en="The speed of the path is that of the spindle times the feed; the path goes on when "
    "the spindle turns.",
    cause_de="Die Bahngeschwindigkeit ist Drehzahl mal Vorschub; die Bahn fährt weiter, wenn die "
    "Spindel dreht.",
)
