# SPDX-License-Identifier: MIT
# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
# cython: initializedcheck=False, nonecheck=False, annotation_typing=False, auto_pickle=False
"""The coordinate systems: what lies between ACS, MCS and PCS for each axis (MO-8).

A position in PCS is the position in ACS less all active offsets of the axis, in mm or degrees.
Without a transformation MCS and IPO are ACS. Each axis has one offset of each of the kinds that
``X[INDP OFFSET=…]`` names (RC-407), in that order.
"""

from __future__ import annotations

# Kinds of offsets.
ZERO = 0
ADD_ZERO = 1
PSET = 2
CLAMP = 3
TOOL = 4
MEASURE = 5
MANUAL = 6

#: How many kinds there are.
KINDS = 7


class Offsets:
    """The offsets of ``count`` axes."""

    def __init__(self, count: int) -> None:
        self.values = memoryview(bytearray(8 * 7 * count)).cast("d")
        self.program = memoryview(bytearray(8 * count)).cast("d")

    def set(self, axis: int, kind: int, value: float) -> None:
        """One offset of an axis gets another value."""
        self.values[axis * 7 + kind] = value
        self.program[axis] = self.sum_of(axis, 127)

    def sum_of(self, axis: int, kinds: int) -> float:
        """The sum of an axis' offsets of these kinds: bit k stands for kind k."""
        total = 0.0
        for kind in range(7):
            if kinds >> kind & 1:
                total += self.values[axis * 7 + kind]
        return total

    def of(self, axis: int, kinds: int) -> float:
        """``sum_of`` for Python's side."""
        return self.sum_of(axis, kinds)
