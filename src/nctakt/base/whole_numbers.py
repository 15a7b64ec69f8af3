# SPDX-License-Identifier: MIT
"""Whole numbers within bounds, of values that may have a fraction.

``value in range(…)`` is wrong for them: for 0.5 it walks through the whole range.
"""

from __future__ import annotations


def is_whole(value: float, low: int, high: int) -> bool:
    """Return whether a value is a whole number from ``low`` to ``high``."""
    return low <= value <= high and value == int(value)
