# SPDX-License-Identifier: MIT
"""Messages of the PLC's side: partners in other processes, scripted PLCs (900650 … 900679)."""

from __future__ import annotations

from nctakt.messages.catalogue import ERROR, Catalogue

MESSAGES = Catalogue()
_add = MESSAGES.add

_add(
    900650,
    ERROR,
    "no PLC has come to the HLI {name}",
    "keine SPS ist an das HLI {name} gekommen",
    remedy_en="Start the program that writes 1 into plc_present of hli_command, and wait for it.",
    remedy_de="Das Programm starten, das 1 in plc_present von hli_command schreibt.",
    parameters={"name": "the name of the shared memory"},
)
_add(
    900651,
    ERROR,
    "the PLC at the HLI does not answer after tick {tick}",
    "die SPS am HLI antwortet nach Takt {tick} nicht",
    remedy_en="Let it write turn of hli_header into turn of hli_link after each tick.",
    remedy_de="Sie muss nach jedem Takt turn von hli_header in turn von hli_link schreiben.",
    parameters={"tick": "the tick that had just been run"},
)
_add(
    900652,
    ERROR,
    "the PLC has left the HLI after tick {tick}",
    "die SPS hat das HLI nach Takt {tick} verlassen",
    remedy_en="Let it stay until ready of hli_header is 0.",
    remedy_de="Sie muss bleiben, bis ready von hli_header 0 ist.",
    parameters={"tick": "the tick that had just been run"},
)
_add(
    900653,
    ERROR,
    "--plc and --hli exclude each other: one PLC answers the CNC",
    "--plc und --hli schließen sich aus: eine SPS antwortet der CNC",
    remedy_en="Leave one of them out.",
    remedy_de="Eine der beiden Angaben weglassen.",
)
