# SPDX-License-Identifier: MIT
"""Homing in the values of an axis list."""

from __future__ import annotations

from nctakt.base.dataclass import dataclass
from nctakt.lists.format.values import Values

_POSITION_UNITS = 10_000
_SPEED_UNITS = 1_000


@dataclass(frozen=True, slots=True)
class AxisHoming:
    """Homing of a simulated axis, in mm or degrees and mm/s or degrees/s.

    ``distance``: signed, from where it is to the zero pulse; ``position``: its position there.
    """

    is_allowed: bool = True
    distance: float = -0.001
    speed: float = 16.666
    position: float = 0.0


def axis_homing(values: Values) -> AxisHoming:
    """Return how an axis is homed.

    A simulated axis starts on its cam: it leaves it against the direction of P-AXIS-00158, and
    without a cam it moves in that direction.
    """
    number = values.integer("kenngr.getriebe_stufe")
    steps = sorted({0, *values.indices("getriebe[]")})
    step = next((i for i in steps if values.integer("getriebe[].nummer", i) == number), 0)
    distance = values.integer("antr.simu.rpf_weg_bis_nip") / _POSITION_UNITS
    is_positive = values.flag("kenngr.ref_richt")
    if not values.flag("kenngr.ref_ohne_nocken"):
        is_positive = not is_positive
    if values.flag("kenngr.homing_without_zero_pulse"):
        distance = 0.0
    low, high = (values.integer(f"getriebe[].{name}", step) for name in ("vb_reflow", "vb_refmax"))
    return AxisHoming(
        values.text("kenngr.homing.homing_type") != "DISABLED",
        distance if is_positive else -distance,
        min(low, high) / _SPEED_UNITS,
        values.integer("getriebe[].pos_refpkt", step) / _POSITION_UNITS,
    )
