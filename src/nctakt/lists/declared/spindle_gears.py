# SPDX-License-Identifier: MIT
"""Channel lists (P-CHAN): gear steps of the main spindle."""

from __future__ import annotations

from nctakt.base.diagnostics import Text
from nctakt.lists.format.parameter import Parameter, ValueType

SPINDLE_GEARS = (
    Parameter(
        "P-CHAN-00052",
        "main_spindle_gear_change",
        ValueType.BOOLEAN,
        False,
        Text(
            "M40 … M45 change the gear step of the main spindle",
            "M40 … M45 schalten die Getriebestufe der Hauptspindel",
        ),
    ),
    Parameter(
        "P-CHAN-00004",
        "spindel[0..5].autom_range",
        ValueType.BOOLEAN,
        False,
        Text(
            "The speed S chooses the gear step, without M40 … M45",
            "Die Drehzahl S wählt die Getriebestufe, ohne M40 … M45",
        ),
    ),
    Parameter(
        "P-CHAN-00074",
        "spindel[0..5].range_way",
        ValueType.UNS16,
        0,
        Text(
            "Search among the ranges of speeds: 0 from the first one, 1 from the last one",
            "Suche in den Drehzahlbereichen: 0 von der ersten, 1 von der letzten Stufe an",
        ),
    ),
    Parameter(
        "P-CHAN-00058",
        "spindel[0..5].range_table[0..5].min_speed",
        ValueType.UNS16,
        0,
        Text("Lowest speed of a gear step", "Niedrigste Drehzahl einer Getriebestufe"),
        unit="1/min",
    ),
    Parameter(
        "P-CHAN-00055",
        "spindel[0..5].range_table[0..5].max_speed",
        ValueType.UNS16,
        0,
        Text(
            "Highest speed of a gear step; 0: the step has no range",
            "Höchste Drehzahl einer Getriebestufe; 0: die Stufe hat keinen Bereich",
        ),
        unit="1/min",
    ),
)
