# SPDX-License-Identifier: MIT
"""Feeds that change within a block: G193 and G293, and G13 before the block's end.

In: the segment of a block, the feed in force before it. Out: pieces of it, each with the feed that
the ramp has in its middle, so that override and feed hold act as usual. No piece is shorter than a
few ticks of motion.
"""

from __future__ import annotations

from collections.abc import Generator, Iterator
from dataclasses import replace

from nctakt.base.diagnostics import Span
from nctakt.decoder.blocks.path.feed import FeedRate
from nctakt.decoder.state.geometry.arcs import Arc
from nctakt.decoder.state.modal_state import CornerFeed
from nctakt.decoder.state.queued.commands import Answer, Command, Segment
from nctakt.decoder.state.queued.feed_modifiers import FeedModifiers
from nctakt.decoder.values.variables import Values
from nctakt.kernel.base import arithmetic
from nctakt.messages.path.feed import CORNER_FEED_MISSING, CORNER_VALUE_NOT_POSITIVE
from nctakt.nc import tree
from nctakt.nc.meaning.path import keywords
from nctakt.nc.vocabulary.functions import CORNER_DECELERATION, FEED_PER_MINUTE, FEED_RAMPS

#: The number of pieces of a ramp, and how many ticks each takes at least.
MAX_PIECES, MIN_TICKS = 32, 4


class FeedRamps:
    """Divides the segments of one program's feed ramps."""

    def __init__(self, values: Values, feed_rate: FeedRate) -> None:
        self._values = values
        self._state = values.state
        self._feed_rate = feed_rate
        self._tick_s = values.environment.cycle_time_us / 1e6

    def switch(self, function: int, span: Span) -> None:
        """Process G12 or G13; raise ``DecodeError`` for G13 without ``#CORNER PARAM``."""
        feed = self._state.feed
        feed.slows_at_ends = function == CORNER_DECELERATION
        if feed.slows_at_ends and feed.corner is None:
            self._values.fail(CORNER_FEED_MISSING, span)

    def corner(self, command: tree.HashCommand, number: int) -> Generator[Command, Answer]:
        """Execute ``#CORNER PARAM [DIST=10 UNIT=PERCENT FEED=50]``."""
        distance = feed = 0.0
        is_share = False
        for item in keywords(command):
            assert item.value is not None
            if item.name == "UNIT":
                assert isinstance(item.value, tree.Name)
                is_share = item.value.name == "PERCENT"
                continue
            value = yield from self._values.evaluate(item.value, number)
            if value <= 0.0:
                self._values.fail(
                    CORNER_VALUE_NOT_POSITIVE, item.value.span, word=item.name, value=value
                )
            if item.name == "DIST":
                distance = value * self._state.length_unit_mm
            else:
                feed = value
        feed = feed / 100.0 if is_share else self._feed_rate.per_minute(feed)
        self._state.feed.corner = CornerFeed(distance, feed, is_share)

    def divide(self, segment: Segment, ramp: tuple[int, float] | None) -> Iterator[Segment]:
        """Yield the pieces of a segment, itself where its feed does not change.

        ``ramp``: G193 or G293, and F in force before the block in mm/s.
        """
        state = self._state
        if (
            not segment.is_feed
            or segment.limits_jerk
            or state.feed.feed_mode != FEED_PER_MINUTE
            or state.path.compensation.is_active
            or state.shapes.holds_motions
        ):
            yield segment
            return
        length = self._feed_rate.length(segment.start, segment.target, _arc(segment))
        path_ratio = segment.feed / state.feed_mm_s
        if ramp is not None:
            function, before_mm_s = ramp
            begin = before_mm_s * path_ratio if before_mm_s > 0.0 else segment.feed
            steps = self._steps(0.0, length, begin, segment.feed, function)
        else:
            assert state.feed.corner is not None
            slow = state.feed.corner.feed_mm_s(state.feed_mm_s) * path_ratio
            begin_at = max(length - state.feed.corner.distance_mm, 0.0)
            steps = self._steps(begin_at, length, segment.feed, slow, FEED_RAMPS[0])
        yield from _pieces(segment, steps)

    def _steps(
        self, begin_at: float, length: float, begin: float, end: float, function: int
    ) -> list[tuple[float, float]]:
        """Return the ends of the pieces as shares of the length, and the feed of each.

        The feed changes from ``begin`` to ``end`` from ``begin_at`` mm on.
        """
        shortest = MIN_TICKS * self._tick_s * max(begin, end)
        count = min(MAX_PIECES, int((length - begin_at) / shortest))
        if begin == end or count < 1:
            return [(1.0, end)]
        first = begin_at / length
        steps = [(first, begin)] if begin_at > 0.0 else []
        for i in range(count):
            share = (i + 0.5) / count
            if function == FEED_RAMPS[0]:
                feed = begin + (end - begin) * share
            else:
                feed = arithmetic.square_root(begin * begin + (end * end - begin * begin) * share)
            steps.append((first + (1.0 - first) * (i + 1) / count, feed))
        return steps


def _pieces(segment: Segment, steps: list[tuple[float, float]]) -> Iterator[Segment]:
    """Yield the pieces of a segment that end at these shares of its length, with these feeds."""
    start, begin = segment.start, 0.0
    for end, feed in steps:
        is_last = end == steps[-1][0]
        target = segment.target if is_last else _point(segment, end)
        arc = segment.arc
        yield replace(
            segment,
            start=start,
            target=target,
            feed=feed,
            exact_stop=segment.exact_stop and is_last,
            deviation=segment.deviation if is_last else 0.0,
            arc=None if arc is None else (*arc[:4], arc[4] * (end - begin)),
            modifiers=_without_end(segment, is_last=is_last),
            continues_block=segment.continues_block or not is_last,
        )
        start, begin = target, end


def _without_end(segment: Segment, *, is_last: bool) -> FeedModifiers | None:
    """Return the modifiers of a piece; E counts for the last one."""
    modifiers = segment.modifiers
    if modifiers is None or is_last or modifiers.end_feed == 0.0:
        return modifiers
    return replace(modifiers, end_feed=0.0)


def _arc(segment: Segment) -> Arc | None:
    """Return the arc of a segment, ``None`` for a line."""
    if segment.arc is None:
        return None
    first, second, *others = segment.arc
    return Arc(int(first), int(second), *others)


def _point(segment: Segment, share: float) -> tuple[float, ...]:
    """Return the point of a line or arc after a share of its length."""
    ends = zip(segment.start, segment.target, strict=True)
    point = [begin + (end - begin) * share for begin, end in ends]
    arc = _arc(segment)
    if arc is not None:
        cosine = arithmetic.cosine(arc.angle * share)
        sine = arithmetic.sine(arc.angle * share)
        along = segment.start[arc.first] - arc.centre_first
        across = segment.start[arc.second] - arc.centre_second
        point[arc.first] = arc.centre_first + along * cosine - across * sine
        point[arc.second] = arc.centre_second + along * sine + across * cosine
    return tuple(point)
