# SPDX-License-Identifier: MIT
"""Channel lists (P-CHAN): weights of the dynamics by the length of a motion or an arc's radius."""

from __future__ import annotations

from nctakt.base.diagnostics import Text
from nctakt.lists.format.parameter import Parameter, ValueType

#: The tables by their names: the numbers of their first parameter and of their last row.
_TABLES = (("dynamic_weighting", 191, 9), ("curve_dynamic_weighting", 231, 2))
_LIMITS = {
    191: (
        "path_limit",
        "Length of a motion below which a row of weights applies",
        "Weglänge, unterhalb derer eine Zeile von Gewichten gilt",
    ),
    231: (
        "radius_limit",
        "Radius of an arc below which a row of weights applies",
        "Kreisradius, unterhalb dessen eine Zeile von Gewichten gilt",
    ),
}
_FACTORS = (
    ("velocity_fact", "Weight of the speed in a row", "Gewicht der Geschwindigkeit in einer Zeile"),
    (
        "acceleration_fact",
        "Weight of the acceleration in a row",
        "Gewicht der Beschleunigung in einer Zeile",
    ),
    (
        "ramp_time_fact",
        "Weight of the ramp times in a row",
        "Gewicht der Rampenzeit in einer Zeile",
    ),
)

DYNAMIC_WEIGHTS = (
    Parameter(
        "P-CHAN-00190",
        "dynamic_weighting_active",
        ValueType.UNS32,
        0,
        Text(
            "Weights by the length of a motion: 1 of G00, 2 of feed motions, 3 of both",
            "Gewichte nach der Weglänge: 1 bei G00, 2 bei Vorschub, 3 bei beiden",
        ),
        low=0,
        high=3,
    ),
    Parameter(
        "P-CHAN-00230",
        "curve_dynamic_weighting_active",
        ValueType.BOOLEAN,
        False,
        Text("Weights by the radius of arcs", "Gewichte nach dem Radius von Kreisen"),
    ),
    *(
        Parameter(
            f"P-CHAN-00{first}",
            f"{table}[0..{last}].{_LIMITS[first][0]}",
            ValueType.UNS32,
            0,
            Text(*_LIMITS[first][1:]),
            unit="0.1 µm, 1e-4°",
        )
        for table, first, last in _TABLES
    ),
    *(
        Parameter(
            f"P-CHAN-00{first + 1 + column}",
            f"{table}[0..{last}].{name}",
            ValueType.UNS32,
            0,
            Text(en, de),
            unit="‰",
        )
        for table, first, last in _TABLES
        for column, (name, en, de) in enumerate(_FACTORS)
    ),
)
