# SPDX-License-Identifier: MIT
"""What the realtime variables hold, in words (RC-304 … RC-306).

In: a row of the access tables in ``variable_table.py``. Out: one sentence for explanation and
documentation.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from nctakt.base.diagnostics import Text
from nctakt.nc.vocabulary.variable_table import RealtimeVariable

_SYSTEMS = {
    "ACS": Text("of the axis itself", "der Achse selbst"),
    "MCS": Text("in machine coordinates", "in Maschinenkoordinaten"),
    "PCS": Text("in program coordinates", "in Programmkoordinaten"),
    "IPO": Text("of the interpolator", "des Interpolators"),
}
_POSITIONS = {
    "ACT_POS": Text("Command position of the tick", "Sollposition des Takts"),
    "CUR_POS": Text("Actual, measured position", "Gemessene Istposition"),
    "CMD_POS": Text("Target position of the running block", "Zielposition des laufenden Satzes"),
    "DIST_TO_GO": Text("Distance to go: target minus command", "Restweg: Ziel minus Soll"),
}

_CHANNEL: Mapping[str, Text] = MappingProxyType(
    {
        "OVERRIDE.VEL.CYCLE": Text(
            "Override of the path that cycles set; 100 at the start of each tick",
            "Override der Bahn, den Zyklen setzen; am Anfang jedes Takts 100",
        ),
        "OVERRIDE.VEL.TOTAL": Text(
            "Override of the path that takes effect, rounded",
            "Wirksamer Override der Bahn, gerundet",
        ),
        "CYCLES.DIAG_LEVEL": Text(
            "What goes into the diagnosis data: 1 errors, 2 warnings, 3 management, 4 actions",
            "Was in die Diagnosedaten kommt: 1 Fehler, 2 Warnungen, 3 Verwaltung, 4 Aktionen",
        ),
        "MEAS_DELTA": Text(
            "Distance that an edge probe has measured", "Weg, den ein Kantentaster gemessen hat"
        ),
        "LOOP.ENABLED": Text(
            "Whether a realtime loop is passed again", "Ob eine Echtzeit-Schleife weiterläuft"
        ),
        "LOOP.COUNT": Text("Passes of a realtime loop", "Durchläufe einer Echtzeit-Schleife"),
        "TIMER": Text(
            "Time of a timer of realtime cycles when #TIMER READ SYN was run last",
            "Zeit eines Timers der Echtzeit-Zyklen beim letzten #TIMER READ SYN",
        ),
    }
)

_AXIS: Mapping[str, Text] = MappingProxyType(
    {
        **{
            f"{system}.{position}": Text(
                f"{_POSITIONS[position].en}, {_SYSTEMS[system].en}",
                f"{_POSITIONS[position].de}, {_SYSTEMS[system].de}",
            )
            for system in _SYSTEMS
            for position in _POSITIONS
        },
        "OVERRIDE.VEL.CYCLE": Text(
            "Override of independent motions that cycles set; 100 at the start of each tick",
            "Override unabhängiger Bewegungen, den Zyklen setzen; am Anfang jedes Takts 100",
        ),
        "OVERRIDE.VEL.TOTAL": Text(
            "Override of the axis' independent motion that takes effect, rounded",
            "Wirksamer Override der unabhängigen Achsbewegung, gerundet",
        ),
        "FIXED_STOP.ACTIVE": Text(
            "Whether the axis is to detect a fixed stop", "Ob die Achse einen Festanschlag sucht"
        ),
        "FIXED_STOP.DETECTED": Text(
            "Whether the axis has met a fixed stop", "Ob die Achse auf einen Festanschlag traf"
        ),
        "FIXED_STOP.ACS.POS": Text(
            "Position of the axis at the fixed stop", "Position der Achse am Festanschlag"
        ),
    }
)


def meaning_of(name: str, row: RealtimeVariable) -> Text:
    """What the variable of this row holds; ``name`` is its full name."""
    table = _AXIS if name.startswith("V.RTA") else _CHANNEL
    return table[row.path]
