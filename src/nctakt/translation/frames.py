# SPDX-License-Identifier: MIT
"""The frame of the routine that is being translated: room for intermediate results."""

from __future__ import annotations

from nctakt.translation.layout import aligned


class Frame:
    """Bytes of a frame that follow its variables; those of a statement are free after it."""

    def __init__(self, size: int) -> None:
        self._begin = aligned(size, 8)
        self._next = self._begin
        self.size = self._begin

    def take(self, count: int) -> int:
        """Return the offset of ``count`` bytes."""
        offset = self._next
        self._next += aligned(count, 8)
        self.size = max(self.size, self._next)
        return offset

    def release(self) -> None:
        """Free what the last statement has taken."""
        self._next = self._begin
