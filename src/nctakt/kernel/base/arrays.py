# SPDX-License-Identifier: MIT
"""Arrays of the realtime part: numbers of 64 bits, all 0 at first."""

from __future__ import annotations


def doubles(count: int) -> memoryview[float]:
    """Return an array of floating-point numbers."""
    return memoryview(bytearray(8 * count)).cast("d")


def integers(count: int) -> memoryview[int]:
    """Return an array of integers."""
    return memoryview(bytearray(8 * count)).cast("q")
