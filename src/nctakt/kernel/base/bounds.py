# SPDX-License-Identifier: MIT
"""Range checks for what Python hands to the realtime part.

The tick reads and writes memory without a check of its own, so each method of the realtime part
that Python calls checks numbers that become an index, a length or an integer of 64 bits.
"""

from __future__ import annotations


def check_index(number: int, count: int, what: str) -> None:
    """Raise ``ValueError`` unless ``number`` is one of ``count`` from 0 on; ``what`` names it."""
    check_range(number, 0, count - 1, what)


def check_range(number: int, low: int, high: int, what: str) -> None:
    """Raise ``ValueError`` unless ``number`` lies in ``low`` … ``high``; ``what`` names it."""
    if not low <= number <= high:
        raise ValueError(f"{what} {number} is not in {low} … {high}")


def check_finite(number: float, what: str) -> None:
    """Raise ``ValueError`` for infinity and what is not a number; ``what`` names it."""
    if number - number != 0.0:
        raise ValueError(f"{what} {number} is not a finite number")
