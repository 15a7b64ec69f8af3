# SPDX-License-Identifier: MIT
"""Axis lists (P-AXIS): homing (G74)."""

from __future__ import annotations

from nctakt.base.diagnostics import Text
from nctakt.lists.format.parameter import Limit, Parameter, ValueType

_POSITION = "0.1 µm, 1e-4°"
#: The homing type of an axis that must not be homed (P-AXIS-00299).
DISABLED = "DISABLED"
_TYPES = (
    "DRIVE_DEFAULT",
    "NONE",
    "TORQ",
    "CNC_CONTROLLED",
    "DRIVE_CONTROLLED",
    DISABLED,
    "IGNORE_ABS_POS",
)

AXIS_HOMING = (
    Parameter(
        "P-AXIS-00299",
        "kenngr.homing.homing_type",
        ValueType.NAME,
        "DRIVE_DEFAULT",
        Text("Kind of homing; DISABLED: none", "Art der Referenzpunktfahrt; DISABLED: keine"),
        names=dict.fromkeys(_TYPES),
    ),
    Parameter(
        "P-AXIS-00158",
        "kenngr.ref_richt",
        ValueType.BOOLEAN,
        False,
        Text(
            "Direction in which homing begins: 0 negative, 1 positive",
            "Richtung, in der die Referenzpunktfahrt beginnt: 0 negativ, 1 positiv",
        ),
    ),
    Parameter(
        "P-AXIS-00156",
        "kenngr.ref_ohne_nocken",
        ValueType.BOOLEAN,
        False,
        Text(
            "Homing on the zero pulse alone, without a cam",
            "Referenzpunktfahrt nur auf den Nullimpuls, ohne Nocken",
        ),
    ),
    Parameter(
        "P-AXIS-00084",
        "kenngr.homing_without_zero_pulse",
        ValueType.BOOLEAN,
        False,
        Text(
            "Homing on the cam alone, without the zero pulse",
            "Referenzpunktfahrt nur auf den Nocken, ohne Nullimpuls",
        ),
    ),
    Parameter(
        "P-AXIS-00161",
        "antr.simu.rpf_weg_bis_nip",
        ValueType.SGN32,
        10,
        Text(
            "Way of a simulated axis to the zero pulse",
            "Weg einer simulierten Achse bis zum Nullimpuls",
        ),
        unit=_POSITION,
    ),
    Parameter(
        "P-AXIS-00152",
        "getriebe[0..5].pos_refpkt",
        ValueType.SGN32,
        0,
        Text(
            "Position that the axis has at the reference point",
            "Position, die die Achse im Referenzpunkt hat",
        ),
        unit=_POSITION,
        at_least=Limit("P-AXIS-00177", is_exclusive=True),
        at_most=Limit("P-AXIS-00178", is_exclusive=True),
    ),
    Parameter(
        "P-AXIS-00218",
        "getriebe[0..5].vb_reflow",
        ValueType.UNS32,
        16_666,
        Text(
            "Speed of homing to the zero pulse",
            "Geschwindigkeit der Referenzpunktfahrt zum Nullimpuls",
        ),
        low=1,
        unit="µm/s, 1e-3°/s",
        at_most=Limit("P-AXIS-00219"),
    ),
    Parameter(
        "P-AXIS-00219",
        "getriebe[0..5].vb_refmax",
        ValueType.UNS32,
        83_333,
        Text(
            "Speed of homing to the cam, at least that to the zero pulse",
            "Geschwindigkeit der Fahrt zum Nocken, mindestens die zum Nullimpuls",
        ),
        low=1,
        unit="µm/s, 1e-3°/s",
        at_most=Limit("P-AXIS-00212"),
    ),
)
