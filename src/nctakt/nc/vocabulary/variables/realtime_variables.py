# SPDX-License-Identifier: MIT
"""The realtime variables: V.RTG of the channel, V.RTA of its axes (RC-303 … RC-306).

One row for each: type, unit, rights in programs and in realtime cycles, meaning. The order of the
rows is that of the cells in the memory. A row without any right is state for the trace.
"""

from __future__ import annotations

import enum
from collections.abc import Iterator

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text


class Access(enum.Flag):
    """Rights of a context to a variable."""

    NONE = 0
    READ = 1
    WRITE = 2
    BOTH = 3


_NO_MEANING = Text("", "")


@dataclass(frozen=True, slots=True)
class RealtimeVariable:
    """A row of the access tables; ``path`` without prefix and axis.

    ``unit``: ``mm`` for positions (degrees for rotary axes), ``%``, ``ms`` or nothing. ``count``:
    elements of an array, 0 for none.
    """

    path: str
    type: str
    unit: str
    decoder: Access
    cycle: Access
    meaning: Text = _NO_MEANING
    count: int = 0


def _state(path: str, type_: str, unit: str) -> RealtimeVariable:
    """A value for the trace that programs and cycles cannot use."""
    return RealtimeVariable(path, type_, unit, Access.NONE, Access.NONE)


#: Signals of a spindle, in the order of its cells (``kernel/axes/spindles.py``).
SPINDLE_VALUES = (
    _state("SPEED", "REAL64", "1/min"),
    _state("POSITION", "REAL64", "°"),
    _state("OVERRIDE", "REAL64", "%"),
)

#: V.RTG.*, in the order of the channel's cells (``kernel/tick/channel.py``).
CHANNEL_VARIABLES = (
    RealtimeVariable(
        "OVERRIDE.VEL.CYCLE",
        "UNS16",
        "%",
        Access.READ,
        Access.BOTH,
        Text(
            "Override of the path that cycles set; 100 at the start of each tick",
            "Override der Bahn, den Zyklen setzen; am Anfang jedes Takts 100",
        ),
    ),
    RealtimeVariable(
        "OVERRIDE.VEL.TOTAL",
        "UNS32",
        "%",
        Access.READ,
        Access.READ,
        Text(
            "Override of the path that takes effect, rounded",
            "Wirksamer Override der Bahn, gerundet",
        ),
    ),
    RealtimeVariable(
        "CYCLES.DIAG_LEVEL",
        "SGN32",
        "",
        Access.BOTH,
        Access.BOTH,
        Text(
            "What goes into the diagnosis data: 1 errors, 2 warnings, 3 management, 4 actions",
            "Was in die Diagnosedaten kommt: 1 Fehler, 2 Warnungen, 3 Verwaltung, 4 Aktionen",
        ),
    ),
    RealtimeVariable(
        "MEAS_DELTA",
        "REAL64",
        "mm",
        Access.BOTH,
        Access.NONE,
        Text("Distance that an edge probe has measured", "Weg, den ein Kantentaster gemessen hat"),
    ),
    RealtimeVariable(
        "LOOP.ENABLED",
        "BOOLEAN",
        "",
        Access.BOTH,
        Access.BOTH,
        Text("Whether a realtime loop is passed again", "Ob eine Echtzeit-Schleife weiterläuft"),
    ),
    RealtimeVariable(
        "LOOP.COUNT",
        "SGN32",
        "",
        Access.BOTH,
        Access.BOTH,
        Text("Passes of a realtime loop", "Durchläufe einer Echtzeit-Schleife"),
    ),
    _state("PATH.SPEED", "REAL64", "mm/s"),
    _state("BLOCK", "UNS32", ""),
    _state("CYCLES.ACTIVE", "UNS32", ""),
    _state("PATH.DIST_TO_GO", "REAL64", "mm"),
    _state("PATH.RAPID", "UNS32", ""),
    *(_state(f"TOOL.DIRECTION.{axis}", "REAL64", "") for axis in "XYZ"),
    RealtimeVariable(
        "TIMER",
        "UNS32",
        "ms",
        Access.READ,
        Access.READ,
        Text(
            "Time of a timer of realtime cycles when #TIMER READ SYN was run last",
            "Zeit eines Timers der Echtzeit-Zyklen beim letzten #TIMER READ SYN",
        ),
        count=128,
    ),
)

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


def _positions(system: str, *names: str) -> Iterator[RealtimeVariable]:
    """The positions of an axis in a coordinate system."""
    for name in names:
        meaning = Text(
            f"{_POSITIONS[name].en}, {_SYSTEMS[system].en}",
            f"{_POSITIONS[name].de}, {_SYSTEMS[system].de}",
        )
        yield RealtimeVariable(
            f"{system}.{name}", "REAL64", "mm", Access.READ, Access.READ, meaning
        )


#: V.RTA.*.<axis>, in the order of an axis' cells (``kernel/axes/axes.py``).
AXIS_VARIABLES = (
    *_positions("ACS", "ACT_POS", "CUR_POS", "CMD_POS"),
    *_positions("MCS", *_POSITIONS),
    *_positions("PCS", *_POSITIONS),
    *_positions("IPO", *_POSITIONS),
    RealtimeVariable(
        "OVERRIDE.VEL.CYCLE",
        "UNS16",
        "%",
        Access.READ,
        Access.BOTH,
        Text(
            "Override of independent motions that cycles set; 100 at the start of each tick",
            "Override unabhängiger Bewegungen, den Zyklen setzen; am Anfang jedes Takts 100",
        ),
    ),
    RealtimeVariable(
        "OVERRIDE.VEL.TOTAL",
        "UNS16",
        "%",
        Access.READ,
        Access.READ,
        Text(
            "Override of the axis' independent motion that takes effect, rounded",
            "Wirksamer Override der unabhängigen Achsbewegung, gerundet",
        ),
    ),
    RealtimeVariable(
        "FIXED_STOP.ACTIVE",
        "BOOLEAN",
        "",
        Access.READ,
        Access.READ,
        Text("Whether the axis is to detect a fixed stop", "Ob die Achse einen Festanschlag sucht"),
    ),
    RealtimeVariable(
        "FIXED_STOP.DETECTED",
        "BOOLEAN",
        "",
        Access.READ,
        Access.READ,
        Text("Whether the axis has met a fixed stop", "Ob die Achse auf einen Festanschlag traf"),
    ),
    RealtimeVariable(
        "FIXED_STOP.ACS.POS",
        "REAL64",
        "mm",
        Access.READ,
        Access.READ,
        Text("Position of the axis at the fixed stop", "Position der Achse am Festanschlag"),
    ),
    _state("STATE", "UNS08", ""),
)
