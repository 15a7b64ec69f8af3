# SPDX-License-Identifier: MIT
# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
# cython: initializedcheck=False, nonecheck=False, annotation_typing=False, auto_pickle=False
"""The coordinate systems: what lies between ACS and MCS, PCS, IPO for each axis (MO-8).

A position in a system is the position in ACS less the system's offset, in mm or degrees. No command
sets an offset yet, so all are zero and the systems coincide.
"""

from __future__ import annotations


class Offsets:
    """One offset for each axis and system."""

    def __init__(self, count: int) -> None:
        self.machine = memoryview(bytearray(8 * count)).cast("d")
        self.program = memoryview(bytearray(8 * count)).cast("d")
        self.interpolator = memoryview(bytearray(8 * count)).cast("d")
