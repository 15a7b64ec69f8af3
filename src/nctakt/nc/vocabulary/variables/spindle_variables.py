# SPDX-License-Identifier: MIT
"""The data of spindles that programs may read: V.SPDL and V.SPDL_PROG.

All are known when the block is decoded: those of the lists, and the latest settings of the program.
``<S>`` is a spindle of the channel, or its index ``[0]``; some are of the main spindle only.
"""

from __future__ import annotations

from types import MappingProxyType
from typing import NamedTuple

from nctakt.base.diagnostics import Text

LISTED, PROGRAMMED = "SPDL", "SPDL_PROG"
SPINDLE_FAMILIES = (LISTED, PROGRAMMED)


class SpindleRow(NamedTuple):
    """One variable: ``path`` without family and spindle."""

    family: str
    path: str
    type: str
    unit: str
    meaning: Text
    has_spindle: bool = True

    @property
    def name(self) -> str:
        """The name in documents: ``V.SPDL.LOG_AX_NR.S``."""
        return f"V.{self.family}.{self.path}" + (".S" if self.has_spindle else "")


SPINDLE_ROWS = (
    SpindleRow(
        LISTED, "LOG_AX_NR", "UNS16", "", Text("logical axis number", "logische Achsnummer")
    ),
    SpindleRow(
        LISTED,
        "PLC_CONTROL",
        "BOOLEAN",
        "",
        Text("whether the PLC turns the spindle", "ob die SPS die Spindel dreht"),
    ),
    SpindleRow(
        LISTED,
        "NBR_IN_CHANNEL",
        "UNS16",
        "",
        Text("number of spindles of the channel", "Anzahl der Spindeln des Kanals"),
        has_spindle=False,
    ),
    SpindleRow(
        PROGRAMMED, "SPEED", "REAL64", "1/min", Text("programmed speed", "programmierte Drehzahl")
    ),
    SpindleRow(
        PROGRAMMED,
        "MOVE_CMD",
        "UNS16",
        "",
        Text("3, 4 or 5: the last M function", "3, 4 oder 5: die letzte M-Funktion"),
    ),
    SpindleRow(
        PROGRAMMED,
        "POSITION",
        "REAL64",
        "degrees",
        Text("position of the last M19", "Position des letzten M19"),
    ),
    SpindleRow(
        PROGRAMMED,
        "MAX_SPEED",
        "REAL64",
        "1/min",
        Text(
            "highest speed of G96 (G196), main spindle",
            "höchste Drehzahl zu G96 (G196), Hauptspindel",
        ),
    ),
    SpindleRow(
        PROGRAMMED,
        "CONST_CUT_SPEED",
        "REAL64",
        "m/min",
        Text("cutting speed (G96), main spindle", "Schnittgeschwindigkeit (G96), Hauptspindel"),
    ),
    SpindleRow(
        PROGRAMMED,
        "DWELL_ROT_COUNT",
        "REAL64",
        "",
        Text(
            "revolutions of the last G04 S, main spindle",
            "Umdrehungen des letzten G04 S, Hauptspindel",
        ),
    ),
)

#: The rows by family and path.
SPINDLE_BY_PATH = MappingProxyType({(row.family, row.path): row for row in SPINDLE_ROWS})

#: Those of the main spindle only.
OF_MAIN_SPINDLE = ("MAX_SPEED", "CONST_CUT_SPEED", "DWELL_ROT_COUNT")
