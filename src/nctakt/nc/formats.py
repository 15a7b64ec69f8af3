# SPDX-License-Identifier: MIT
"""The text of a ``#MSG`` with places for values, as in ``"X = %f"``.

In: the text. Out: its places in order, or the text with values filled in. Numbers are REAL64 where
the program computes them, so ``%d`` takes the whole part of any number.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from math import isfinite

_PLACE = re.compile(r"%(?:%|[-+ #0]*\d{0,3}(?:\.\d{0,3})?(?P<kind>[diuxXfFeEgGs])|(?P<wrong>.?))")


def places(text: str) -> Iterator[tuple[str, bool]]:
    """Each place as it is written and whether it is one; ``%%`` is the sign itself."""
    for found in _PLACE.finditer(text):
        if found["kind"] is not None:
            yield found[0], True
        elif found["wrong"] is not None:
            yield found[0], False


def fill(text: str, values: Sequence[float | str]) -> str:
    """The text with the values in its places; the checker has seen that they fit.

    ``%d`` and its kin show the whole part of a number; one that is not finite has none and is
    shown by its name.
    """
    rest = iter(values)

    def shown(found: re.Match[str]) -> str:
        kind = found["kind"]
        if kind is None:
            return "%"
        value = next(rest)
        if kind in "diuxX" and isinstance(value, float):
            return found[0] % int(value) if isfinite(value) else str(value)
        return found[0] % value

    return _PLACE.sub(shown, text)
