# SPDX-License-Identifier: MIT
"""Channel lists (P-CHAN): the limits that ``#VECTOR LIMIT ON`` has without values."""

from __future__ import annotations

from nctakt.base.diagnostics import Text
from nctakt.lists.format.parameter import Parameter, ValueType

PATH_LIMITS = (
    *(
        Parameter(id_, path, ValueType.REAL64, default, Text(en, de), unit=unit)
        for id_, path, default, unit, en, de in (
            (
                "P-CHAN-00002",
                "vector.acceleration",
                1e8,
                "",
                "Acceleration of the path with #VECTOR LIMIT ON [ACC]",
                "Bahnbeschleunigung bei #VECTOR LIMIT ON [ACC]",
            ),
            (
                "P-CHAN-00208",
                "vector.deceleration",
                1e8,
                "",
                "Deceleration of the path with #VECTOR LIMIT ON [DEC]",
                "Bahnverzögerung bei #VECTOR LIMIT ON [DEC]",
            ),
            (
                "P-CHAN-00361",
                "vector.radial_acceleration",
                1e8,
                "",
                "Radial acceleration with #VECTOR LIMIT ON [RADIAL_ACC]",
                "Radialbeschleunigung bei #VECTOR LIMIT ON [RADIAL_ACC]",
            ),
            (
                "P-CHAN-00090",
                "vector.velocity",
                2e9,
                "mm/min",
                "Speed of the path with #VECTOR LIMIT ON [VEL]",
                "Bahngeschwindigkeit bei #VECTOR LIMIT ON [VEL]",
            ),
        )
    ),
    Parameter(
        "P-CHAN-00351",
        "vector.acc_dec_unit",
        ValueType.NAME,
        "MM_M2",
        Text(
            "Unit of accelerations and jerks of #VECTOR LIMIT: per min² (MM_M2) or per s² (MM_S2)",
            "Einheit von Beschleunigung und Ruck bei #VECTOR LIMIT: je min² (MM_M2), s² (MM_S2)",
        ),
        names={"MM_M2": None, "MM_S2": None},
    ),
)
