# SPDX-License-Identifier: MIT
"""Messages of backward motion on the path and what works with its history (900880 … 900899)."""

from __future__ import annotations

from nctakt.messages.catalogue import WARNING, Catalogue

MESSAGES = Catalogue()
_add = MESSAGES.add

_add(
    50450,
    WARNING,
    "the memory for backward motion, {value} bytes, is too small; {least} are used",
    "der Speicher für das Rückwärtsfahren, {value} Byte, ist zu klein; es gelten {least}",
    remedy_en="Give fb_storage_size at least {least}, or 0 where nothing goes back.",
    remedy_de="fb_storage_size mindestens {least} geben, oder 0, wo nichts rückwärts fährt.",
    cause_en="The history of the path shall hold some blocks in any case.",
    cause_de="Die Vorgeschichte der Bahn soll in jedem Fall einige Sätze fassen.",
    parameters={"value": "P-STUP-00033 as written", "least": "the least size in bytes"},
)
_add(
    900880,
    WARNING,
    "backward motion is commanded, but the path has no history; it goes on forward",
    "Rückwärtsfahren ist befohlen, aber die Bahn hat keine Vorgeschichte; sie fährt vorwärts",
    remedy_en="Give the channel memory: fb_storage_size (P-STUP-00033) in the start-up list.",
    remedy_de="Dem Kanal Speicher geben: fb_storage_size (P-STUP-00033) in der Hochlaufliste.",
    cause_en="P-STUP-00033 is 0, its default: backward motion is not available.",
    cause_de="P-STUP-00033 ist 0, seine Vorgabe: Rückwärtsfahren gibt es nicht.",
)
