# SPDX-License-Identifier: MIT
"""Factors between units of logs and models and units of signals."""

from __future__ import annotations

#: Spellings of units: the quantity, and the factor to its first unit.
_UNITS: dict[str, tuple[str, float]] = {
    "mm": ("length", 1.0),
    "m": ("length", 1e3),
    "cm": ("length", 10.0),
    "µm": ("length", 1e-3),
    "um": ("length", 1e-3),
    "0.1µm": ("length", 1e-4),
    "0.1um": ("length", 1e-4),
    "nm": ("length", 1e-6),
    "in": ("length", 25.4),
    "inch": ("length", 25.4),
    "°": ("angle", 1.0),
    "deg": ("angle", 1.0),
    "grad": ("angle", 1.0),
    "rad": ("angle", 180.0 / 3.141592653589793),
    "mm/s": ("speed", 1.0),
    "mm/min": ("speed", 1.0 / 60.0),
    "m/s": ("speed", 1e3),
    "m/min": ("speed", 1e3 / 60.0),
    "µm/s": ("speed", 1e-3),
    "um/s": ("speed", 1e-3),
    "1/min": ("rotation", 1.0),
    "rpm": ("rotation", 1.0),
    "u/min": ("rotation", 1.0),
    "min-1": ("rotation", 1.0),
    "1/s": ("rotation", 60.0),
    "%": ("share", 1.0),
    "s": ("time", 1e3),
    "ms": ("time", 1.0),
    "us": ("time", 1e-3),
    "µs": ("time", 1e-3),
}


def factor_between(theirs: str, unit: str) -> float | None:
    """Return how many ``unit`` make one of ``theirs``; ``None`` for units that do not match.

    A log or model that names no unit is taken to have the signal's.

    >>> factor_between("m", "mm"), factor_between("rpm", "mm"), factor_between("", "mm")
    (1000.0, None, 1.0)
    """
    if not theirs or theirs == unit:
        return 1.0
    # A micro sign has two characters that look alike; in small letters it is the Greek one.
    found = _UNITS.get(theirs.casefold().replace("\u03bc", "µ").replace(" ", ""))
    ours = _UNITS.get(unit)
    if found is None or ours is None or found[0] != ours[0]:
        return None
    return found[1] / ours[1]
