# SPDX-License-Identifier: MIT
"""Range checks for values that Python passes to the realtime part.

The tick itself reads and writes memory unchecked, so each method of the realtime part that Python
calls checks numbers that become an index, a length or an integer of 64 bits.
"""

from __future__ import annotations

#: No table of the realtime part has more rows.
MAX_SIZE = 1 << 24


def check_index(number: int, count: int, what: str) -> None:
    """Raise ``ValueError`` unless ``number`` is one of ``count`` from 0 on; ``what`` names it."""
    check_range(number, 0, count - 1, what)


def check_range(number: int, low: int, high: int, what: str) -> None:
    """Raise ``ValueError`` unless ``number`` lies in ``low`` … ``high``; ``what`` names it."""
    if not low <= number <= high:
        raise ValueError(f"{what} {number} is not in {low} … {high}")


def check_finite(number: float, what: str) -> None:
    """Raise ``ValueError`` unless ``number`` is finite; ``what`` names it."""
    if number - number != 0.0:
        raise ValueError(f"{what} {number} is not a finite number")


def check_size(number: int, what: str) -> None:
    """Raise ``ValueError`` unless ``number`` is a size of a table; ``what`` names it."""
    check_range(number, 0, MAX_SIZE, what)


def check_cells(first_cell: int, count: int, memory: bytearray | memoryview) -> None:
    """Raise ``ValueError`` unless ``count`` cells from ``first_cell`` on lie in ``memory``."""
    check_range(first_cell, 0, len(memory) // 8 - count, "first cell")
