# SPDX-License-Identifier: MIT
"""Ticks of the past whose state is confirmed: a step to one of them needs no more proof.

In: marks of rerun ticks near the place somebody has gone to; the fact that the same run has led to
a mark of the first run. Out: whether a later run agrees there.
"""

from __future__ import annotations

from collections.abc import Iterable

from nctakt.session.history.trail import Mark

#: Maximum number of known ticks; beyond it those known so far are forgotten.
MAX_KNOWN = 4096


class Confirmed:
    """The known ticks of the branch that a session is in."""

    def __init__(self) -> None:
        self._branch = 0
        self._digests: dict[int, bytes] = {}
        self._unproved: dict[int, bytes] = {}
        self._compared = -1

    def enter(self, branch: int) -> None:
        """Begin to rerun the past of a branch; nothing is known about any other."""
        if branch != self._branch or len(self._digests) > MAX_KNOWN:
            self._digests.clear()
        self._branch = branch
        self._unproved.clear()
        self._compared = -1

    def __contains__(self, tick: int) -> bool:
        return tick in self._digests

    def between(self, after: int, last: int, count: int) -> list[int]:
        """Return the first ``count`` known ticks after a tick, up to another."""
        return sorted(tick for tick in self._digests if after < tick <= last)[:count]

    def compare(self, branch: int, found: Iterable[Mark]) -> int | None:
        """Take the marks of a run of a branch; return the first tick known to be otherwise.

        Nothing is known about any branch other than the entered one.
        """
        if branch != self._branch:
            return None
        for mark in found:
            known = self._digests.get(mark.tick)
            if known is None:
                self._unproved[mark.tick] = mark.digest
            elif known != mark.digest:
                return mark.tick
            else:
                self._compared = mark.tick
        return None

    def is_proved(self, tick: int) -> bool:
        """Return whether the latest run agrees with the known state of this tick."""
        return self._compared == tick

    def prove(self) -> None:
        """Know the ticks of the latest run from now on."""
        self._digests.update(self._unproved)
        self._unproved.clear()
