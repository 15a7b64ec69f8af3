# SPDX-License-Identifier: MIT
"""Messages of tools in programs and of tool radius compensation (900865 … 900879)."""

from __future__ import annotations

from nctakt.messages.catalogue import ERROR, Catalogue

MESSAGES = Catalogue()
_add = MESSAGES.add

_add(
    900865,
    ERROR,
    "the tool list has no tool {tool}",
    "die Werkzeugliste hat kein Werkzeug {tool}",
    remedy_en="Add wz[{tool}] to the tool list of the channel, or call another tool.",
    remedy_de="wz[{tool}] in die Werkzeugliste des Kanals aufnehmen oder ein anderes Werkzeug "
    "anwählen.",
    parameters={"tool": "the number of the tool"},
)
_add(
    900866,
    ERROR,
    "tool {tool} is not valid",
    "Werkzeug {tool} ist nicht gültig",
    remedy_en="Set wz[{tool}].gueltig (P-TOOL-00005) to 1, or call another tool.",
    remedy_de="wz[{tool}].gueltig (P-TOOL-00005) auf 1 setzen oder ein anderes Werkzeug anwählen.",
    parameters={"tool": "the number of the tool"},
)
_add(
    900867,
    ERROR,
    "{value} is no number of a tool",
    "{value} ist keine Werkzeugnummer",
    remedy_en="Write a whole number behind {word}, 0 or more.",
    remedy_de="Hinter {word} eine ganze Zahl schreiben, 0 oder größer.",
    parameters={"word": "the word: T or D", "value": "the value as programmed"},
)
_add(
    900868,
    ERROR,
    "the length {length} mm of the tool has no axis: the channel has none beside plane G{plane}",
    "die Werkzeuglänge {length} mm hat keine Achse: der Kanal hat keine neben der Ebene G{plane}",
    remedy_en="Choose a plane whose third axis the channel has, or a tool without length.",
    remedy_de="Eine Ebene wählen, deren dritte Achse der Kanal hat, oder ein Werkzeug ohne Länge.",
    parameters={"length": "the length of the tool in mm", "plane": "the number of the plane"},
)
