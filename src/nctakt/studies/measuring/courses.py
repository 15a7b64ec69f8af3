# SPDX-License-Identifier: MIT
"""Where the course of a signal meets a condition: compiled, since each run of a study asks for it.

In: the values of a signal, one for each tick, and a condition. Out: the first value that meets it,
or all that do so after one that did not. A condition is a number, ``limit``, and whether values
below it, equal to it, above it and NaN meet it.
"""

from __future__ import annotations


def first(
    values: memoryview[float],
    begin: int,
    limit: float,
    below: bool,
    equal: bool,
    above: bool,
    unordered: bool,
) -> int:
    """Return the index of the first value from ``begin`` on that meets a condition, else -1."""
    for i in range(begin, len(values)):
        if meets(values[i], limit, below, equal, above, unordered):
            return i
    return -1


def begins(
    values: memoryview[float],
    limit: float,
    below: bool,
    equal: bool,
    above: bool,
    unordered: bool,
) -> list[int]:
    """Return the index of each value that meets a condition where the one before it does not."""
    found = []
    was_met = False
    for i in range(len(values)):
        is_met = meets(values[i], limit, below, equal, above, unordered)
        if is_met and not was_met:
            found.append(i)
        was_met = is_met
    return found


def meets(
    value: float, limit: float, below: bool, equal: bool, above: bool, unordered: bool
) -> bool:
    """Return whether a value meets a condition."""
    if value < limit:
        return below
    if value > limit:
        return above
    return equal if value == limit else unordered
