# SPDX-License-Identifier: MIT
"""Modifiers of a segment's feed: overrides, and a spindle."""

from __future__ import annotations

from nctakt.base.dataclass import dataclass
from nctakt.kernel import rows


@dataclass(frozen=True, slots=True)
class FeedModifiers:
    """Modifiers of the feed of one segment.

    ``override``: the programmed one as a factor. ``is_exempt``: the operator's has no effect.
    ``spindle``: whose speed the feed follows, by its place in the channel, -1 none; the feed counts
    at ``spindle_v``, degrees per second. ``thread``: ``rows.CUTTING`` or ``rows.TAPPING`` couples
    the path with that spindle, ``turn`` degrees for each mm; ``angle``: where a cut thread starts.
    ``end_feed``: at its end, mm/s, 0: as the next segment.
    """

    override: float = 1.0
    is_exempt: bool = False
    spindle: int = -1
    spindle_v: float = 0.0
    thread: int = rows.NO_THREAD
    turn: float = 0.0
    angle: float = 0.0
    end_feed: float = 0.0

    @property
    def row(self) -> tuple[float, ...]:
        """The columns from ``rows.SPEED_OVERRIDE`` on, then the feed at the segment's end."""
        feed_modifiers = (self.override, self.is_exempt, self.spindle + 1, self.spindle_v)
        return (*feed_modifiers, self.thread, self.turn, self.angle, self.end_feed)
