# SPDX-License-Identifier: MIT
"""Axis lists: feed-forward control of drives."""

from __future__ import annotations

from nctakt.base.diagnostics import Text
from nctakt.lists.format.parameter import Parameter, ValueType

FEED_FORWARD = (
    Parameter(
        "P-AXIS-00223",
        "vorsteuer.vorsteuerung",
        ValueType.FLAGS,
        ("NONE",),
        Text(
            "Which feed-forward control the drive has; here only that of the velocity acts",
            "Welche Vorsteuerung der Antrieb hat; hier wirkt nur die der Geschwindigkeit",
        ),
        names={
            "NONE": 0,
            "VEL": 1,
            "ACC": 2,
            "JERK": 4,
            "ADD_VEL": 257,
            "ADD_ACC": 514,
            "ADD_JERK": 2052,
        },
    ),
    Parameter(
        "P-AXIS-00228",
        "vorsteuer.vs_v_faktor",
        ValueType.SGN32,
        1,
        Text(
            "Numerator of the weight of the feed-forward control",
            "Zähler der Gewichtung der Vorsteuerung",
        ),
        low=0,
    ),
    Parameter(
        "P-AXIS-00229",
        "vorsteuer.vs_v_nenner",
        ValueType.SGN32,
        1,
        Text(
            "Denominator of the weight of the feed-forward control",
            "Nenner der Gewichtung der Vorsteuerung",
        ),
        low=1,
    ),
    Parameter(
        "P-AXIS-00255",
        "vorsteuer.default_active",
        ValueType.BOOLEAN,
        False,
        Text(
            "Feed-forward control is always on, also without G135",
            "Die Vorsteuerung ist immer ein, auch ohne G135",
        ),
    ),
    Parameter(
        "P-AXIS-00256",
        "vorsteuer.global_disable",
        ValueType.BOOLEAN,
        False,
        Text(
            "Feed-forward control is always off, also with G135",
            "Die Vorsteuerung ist immer aus, auch mit G135",
        ),
    ),
)
