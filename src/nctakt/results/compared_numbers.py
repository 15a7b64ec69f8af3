# SPDX-License-Identifier: MIT
"""Compared numbers as shown in explanations: short, and never contradicting the explanation.

In: an operator and its values. Out: their text.
"""

from __future__ import annotations

import math

from nctakt.results.trace.events import number_text

#: The magnitude from which on a condition without an operator is true (RC-202).
TRUE_FROM = 0.5

#: Significant digits of a number, from the fewest on.
_DIGITS = (6, 9, 12)


def comparison_text(comparison: str, left: float, right: float) -> str:
    """Return compared values for a reader: ``150.267 > 150``; without an operator the left one.

    They have six digits, or as many more as it takes to keep them apart and in their order: a value
    below 0.5 never seems to be 0.5, from which on it is true.
    """
    limit = right if comparison else TRUE_FROM
    compared = left if comparison else abs(left)
    for digits in _DIGITS:
        if _order(_rounded(compared, digits), _rounded(limit, digits)) == _order(compared, limit):
            left, right = _rounded(left, digits), _rounded(right, digits)
            break
    if not comparison:
        return number_text(left)
    return f"{number_text(left)} {comparison} {number_text(right)}"


def distance_text(distance: float) -> str:
    """Return the difference of compared values; it is 0 only where they are the same."""
    return number_text(_rounded(distance, _DIGITS[0]))


def _rounded(value: float, digits: int) -> float:
    """Return a number with these significant digits; no digit before the point is lost."""
    if abs(value) >= 10.0**digits and math.isfinite(value):
        return float(round(value))
    return float(f"{value:.{digits}g}")


def _order(left: float, right: float) -> int:
    return (left > right) - (left < right)
