# SPDX-License-Identifier: MIT
"""Messages about homing (G74) and programmed software limits (G98, G99)."""

from __future__ import annotations

from nctakt.messages.catalogue import error, warning

HOMING_NOT_ALLOWED = error(
    50686,
    known_as=(60313,),
    en="{axis} must not be homed",
    de="{axis} darf nicht referenziert werden",
    remedy_en="Leave {axis} out of G74, or change kenngr.homing.homing_type (P-AXIS-00299), which "
    "is DISABLED.",
    remedy_de="{axis} in G74 weglassen oder kenngr.homing.homing_type (P-AXIS-00299) ändern: es "
    "ist DISABLED.",
    classes=(2, 6),
)
INVALID_HOMING_ORDER = error(
    901710,
    en="{value} is not a valid place in the homing order",
    de="{value} ist kein gültiger Platz in der Reihenfolge der Referenzpunktfahrt",
    remedy_en="Write a whole number from 1 on: the axes with 1 come first, equal ones together.",
    remedy_de="Eine ganze Zahl ab 1 schreiben: Achsen mit 1 kommen zuerst, gleiche gemeinsam.",
    classes=(2, 3),
)
HOMING_DURING_TRANSFORMATION = error(
    901711,
    en="G74 while a transformation or a coordinate system of the program is active",
    de="G74, während eine Transformation oder ein Koordinatensystem des Programms aktiv ist",
    remedy_en="Switch it off first: #TRAFO OFF, #CS OFF ALL.",
    remedy_de="Sie vorher ausschalten: #TRAFO OFF, #CS OFF ALL.",
    classes=(2, 3),
)
NEGATIVE_LIMIT_IGNORED = warning(
    21648,
    en="G98 {axis}: {value} is below the limit {listed} of the list, and is ignored",
    de="G98 {axis}: {value} liegt unter dem Endschalter {listed} der Liste und wird nicht beachtet",
    remedy_en="Stay within the limits of the list, or set range_check_prog_soft_limits "
    "(P-CHAN-00498) to 0.",
    remedy_de="Innerhalb der Endschalter der Liste bleiben oder "
    "range_check_prog_soft_limits (P-CHAN-00498) = 0.",
    value=("the limit in mm or degrees", "der Endschalter in mm oder Grad"),
    listed=("the limit of the list", "der Endschalter der Liste"),
)
POSITIVE_LIMIT_IGNORED = warning(
    21650,
    en="G99 {axis}: {value} is above the limit {listed} of the list, and is ignored",
    de="G99 {axis}: {value} liegt über dem Endschalter {listed} der Liste und wird nicht beachtet",
    remedy_en="Stay within the limits of the list, or set range_check_prog_soft_limits "
    "(P-CHAN-00498) to 0.",
    remedy_de="Innerhalb der Endschalter der Liste bleiben oder "
    "range_check_prog_soft_limits (P-CHAN-00498) = 0.",
    value=("the limit in mm or degrees", "der Endschalter in mm oder Grad"),
    listed=("the limit of the list", "der Endschalter der Liste"),
)
NEGATIVE_LIMIT_TOO_HIGH = error(
    21649,
    en="G98 {axis}: {value} is not below the positive limit {other}",
    de="G98 {axis}: {value} liegt nicht unter dem positiven Endschalter {other}",
    remedy_en="Program a smaller value, or move the positive limit first (G99).",
    remedy_de="Einen kleineren Wert programmieren oder zuerst den positiven Endschalter "
    "versetzen (G99).",
    value=("the limit in mm or degrees", "der Endschalter in mm oder Grad"),
    other=("the positive limit in force", "der wirksame positive Endschalter"),
)
POSITIVE_LIMIT_TOO_LOW = error(
    21878,
    en="G99 {axis}: {value} is not above the negative limit {other}",
    de="G99 {axis}: {value} liegt nicht über dem negativen Endschalter {other}",
    remedy_en="Program a greater value, or move the negative limit first (G98).",
    remedy_de="Einen größeren Wert programmieren oder zuerst den negativen Endschalter "
    "versetzen (G98).",
    value=("the limit in mm or degrees", "der Endschalter in mm oder Grad"),
    other=("the negative limit in force", "der wirksame negative Endschalter"),
)
