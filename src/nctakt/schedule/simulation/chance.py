# SPDX-License-Identifier: MIT
# cython: boundscheck=True, cdivision=False, initializedcheck=True, wraparound=True
"""Random numbers: those of ``random.Random`` with the same seed, drawn in blocks.

In: a seed. Out: uniformly distributed integers. The words come from numpy's generator, which is the
same as Python's (MT19937); they become integers as in Python's ``randint``.
"""

from __future__ import annotations

import random
from array import array
from typing import Any

#: Number of words drawn at once.
_BLOCK = 4096


class Chance:
    """A seeded generator."""

    def __init__(self, seed: int) -> None:
        self._seed = seed
        self._source: Any = None
        self._words = array("Q")
        self._next = 0
        self._count = 0

    def _refill(self) -> None:
        if self._source is None:
            self._source = _generator(self._seed)
        self._words = array("Q", self._source.random_raw(_BLOCK).tobytes())
        self._next = 0
        self._count = _BLOCK

    def _word(self) -> int:
        """Return the next 32 bits."""
        if self._next == self._count:
            self._refill()
        self._next += 1
        return self._words[self._next - 1]

    def below(self, limit: int, bits: int) -> int:
        """Return a number from 0 to below ``limit``, which has ``bits`` bits (at most 63)."""
        while True:
            if bits <= 32:
                drawn = self._word() >> (32 - bits)
            else:
                drawn = self._word()
                drawn |= (self._word() >> (64 - bits)) << 32
            if drawn < limit:
                return drawn

    def randint(self, low: int, high: int) -> int:
        """Return a number from ``low`` to ``high``."""
        span = high - low + 1
        return low + self.below(span, span.bit_length())


def _generator(seed: int) -> Any:
    """Return numpy's generator in the state of Python's."""
    from numpy.random import MT19937  # noqa: PLC0415 - a schedule without chance needs no numpy

    words = random.Random(seed).getstate()[1]
    generator = MT19937()
    state = generator.state
    state["state"]["key"][:] = words[:-1]
    state["state"]["pos"] = words[-1]
    generator.state = state
    return generator
