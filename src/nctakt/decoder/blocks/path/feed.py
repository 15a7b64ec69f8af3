# SPDX-License-Identifier: MIT
"""The feed of a block: F under G93, G94, G95 and G194, programmed overrides (MO-4, MO-5, MO-17).

In: F, the G functions of the feed, ``#OVERRIDE``, ``X[OVERRIDE …]``, the length of a block. Out:
its feed in mm/s, or degrees/s if only rotary axes move, 0 for rapid, and ``FeedModifiers`` if there
are any. Each of G93 … G95 keeps its own F.
"""

from __future__ import annotations

from collections.abc import Generator, Sequence
from dataclasses import replace

from nctakt.base.diagnostics import Span
from nctakt.decoder.blocks.axes.spindles import DEGREES_PER_S, SpindleWords
from nctakt.decoder.blocks.path.feed_groups import FeedGroups
from nctakt.decoder.state.geometry.arcs import Arc
from nctakt.decoder.state.modal_state import FeedState
from nctakt.decoder.state.queued.commands import Answer, Command
from nctakt.decoder.state.queued.feed_modifiers import FeedModifiers
from nctakt.decoder.values.overrides import override_factor
from nctakt.decoder.values.variables import Values
from nctakt.kernel.base import arithmetic
from nctakt.messages.path.feed import (
    END_FEED_WITHOUT_G94,
    FEED_NOT_POSITIVE,
    FEED_PER_REVOLUTION_SPINDLE_STOPPED,
    FEED_PER_REVOLUTION_WITHOUT_SPINDLE,
)
from nctakt.messages.programs.decoder import G194_ABOVE_MAX_FEED, NO_FEED_ACTIVE
from nctakt.nc import tree
from nctakt.nc.meaning.path import OVERRIDE_FACTORS
from nctakt.nc.vocabulary.functions import (
    FEED_PER_MINUTE,
    FEED_PER_REVOLUTION,
    FEED_SHARE,
    INVERSE_TIME_FEED,
    THREADS,
)

#: Maximum F of G194, %.
MAX_SHARE_PCT = 100.0


class FeedRate:
    """Decodes the feed of the blocks of one program."""

    def __init__(self, values: Values, spindles: SpindleWords) -> None:
        self._values = values
        self._environment = values.environment
        self._state = values.state
        self._spindles = spindles
        self.groups = FeedGroups(values)

    def feed_word(self, value: float, span: Span) -> None:
        """Process F; in inch under G70, per minute regardless of P-CHAN-00108, or per
        revolution.

        Raises ``DecodeError`` unless it is above 0.
        """
        if value <= 0.0:
            self._values.fail(FEED_NOT_POSITIVE, span, value=value)
        state = self._state
        mode = state.feed.feed_mode
        if mode == INVERSE_TIME_FEED:
            state.feed.time_s = value
        elif mode == FEED_PER_REVOLUTION:
            state.feed.per_revolution_mm = value * state.length_unit_mm
        elif mode == FEED_SHARE:
            state.feed.share_pct = value
        else:
            state.feed_mm_s = self.per_minute(value)

    def per_minute(self, value: float) -> float:
        """Return a feed in mm/s that is programmed as F under G94."""
        if self._state.inch:
            return value * self._state.length_unit_mm / 60.0
        return value * self._environment.parameters.program_start.feed_unit_mm_min / 60.0

    # --- overrides ------------------------------------------------------------------------------

    def override(
        self,
        items: Sequence[tree.Keyword | tree.Expression],
        number: int,
        axis: int | None = None,
    ) -> Generator[Command, Answer]:
        """Process ``#OVERRIDE``, or ``X[OVERRIDE …]`` for the axis with this index."""
        feed_state = self._state.feed
        feed, rapid = feed_state.path_override
        if axis is not None:
            feed, rapid = feed_state.axis_overrides.get(axis, (1.0, 1.0))
        for item in items:
            if not isinstance(item, tree.Keyword) or item.value is None:
                continue
            factor = yield from override_factor(self._values, item, number)
            if item.name == OVERRIDE_FACTORS[0]:
                feed = factor
            else:
                rapid = factor
        if axis is None:
            feed_state.path_override = (feed, rapid)
        else:
            feed_state.axis_overrides[axis] = (feed, rapid)

    # --- a block --------------------------------------------------------------------------------

    def of(
        self,
        start: Sequence[float],
        target: Sequence[float],
        arc: Arc | None,
        is_exempt: bool,
        span: Span,
    ) -> tuple[float, FeedModifiers | None]:
        """Return feed and modifiers of a block; ``is_exempt``: without overrides (G166).

        Rapid motions and threads have no programmed feed: 0.
        """
        rapid = self._state.rapid
        feed_state = self._state.feed
        override = 1.0
        if not is_exempt:
            override = feed_state.path_override[rapid]
            if feed_state.axis_overrides:
                override *= self._min_axis_override(start, target, arc)
        has_own_feed = rapid or self._state.motion in THREADS
        feed, spindle, spindle_v = (
            (0.0, -1, 0.0) if has_own_feed else self._feed(start, target, arc, span)
        )
        if feed_state.group and feed_state.feed_mode in (FEED_PER_MINUTE, FEED_PER_REVOLUTION):
            length = self.length(start, target, arc)
            feed *= self.groups.ratio(feed_state.group, start, target, arc, length, span)
        if override == 1.0 and not is_exempt and spindle < 0:
            return feed, None
        return feed, FeedModifiers(override, is_exempt, spindle, spindle_v)

    def with_end(
        self, feed: float, feed_modifiers: FeedModifiers | None, span: Span, value: float
    ) -> FeedModifiers | None:
        """Return the modifiers of a block whose feed at its end is E, in the unit of F.

        Raises ``DecodeError`` without G94 and for a feed that is not above 0.
        """
        state = self._state
        if state.feed.feed_mode != FEED_PER_MINUTE:
            self._values.fail(END_FEED_WITHOUT_G94, span, mode=state.feed.feed_mode)
        if value <= 0.0:
            self._values.fail(FEED_NOT_POSITIVE, span, value=value)
        end_feed = self.per_minute(value)
        if feed <= 0.0 or end_feed >= state.feed_mm_s:
            return feed_modifiers
        end_feed *= feed / state.feed_mm_s
        feed_modifiers = feed_modifiers or FeedModifiers()
        return replace(feed_modifiers, end_feed=end_feed * feed_modifiers.override)

    def _min_axis_override(
        self, start: Sequence[float], target: Sequence[float], arc: Arc | None
    ) -> float:
        """Return the smallest override of the moving axes."""
        plane = () if arc is None else (arc.first, arc.second)
        return min(
            (
                factors[self._state.rapid]
                for axis, factors in self._state.feed.axis_overrides.items()
                if start[axis] != target[axis] or axis in plane
            ),
            default=1.0,
        )

    def _feed(
        self, start: Sequence[float], target: Sequence[float], arc: Arc | None, span: Span
    ) -> tuple[float, int, float]:
        """Return the feed, the spindle that it follows (-1: none), and that spindle's speed."""
        feed_state = self._state.feed
        if feed_state.feed_mode == INVERSE_TIME_FEED:
            self._need(feed_state.time_s, span)
            return self.length(start, target, arc) / feed_state.time_s, -1, 0.0
        if feed_state.feed_mode == FEED_PER_REVOLUTION:
            self._need(feed_state.per_revolution_mm, span)
            return self._per_revolution(feed_state, span)
        if feed_state.feed_mode == FEED_SHARE:
            self._need(feed_state.share_pct, span)
            if feed_state.share_pct > MAX_SHARE_PCT:
                self._values.fail(
                    G194_ABOVE_MAX_FEED, span, value=feed_state.share_pct, maximum=MAX_SHARE_PCT
                )
            return self._max_axis_feed(start, target, arc) * feed_state.share_pct / 100.0, -1, 0.0
        self._need(self._state.feed_mm_s, span)
        return self._state.feed_mm_s, -1, 0.0

    def _need(self, value: float, span: Span) -> None:
        """Raise ``DecodeError`` if there is no F (MO-17)."""
        if value == 0.0:
            self._values.fail(NO_FEED_ACTIVE, span)

    def _per_revolution(self, feed_state: FeedState, span: Span) -> tuple[float, int, float]:
        """Return the feed under G95; for a spindle of the PLC from its programmed speed."""
        index = self._state.main_spindle
        if index < 0:
            self._values.fail(FEED_PER_REVOLUTION_WITHOUT_SPINDLE, span)
        spindle = self._environment.parameters.spindles[index]
        modal = self._spindles.modal.get(index)
        if modal is None or modal.turning_speed <= 0.0:
            self._values.fail(FEED_PER_REVOLUTION_SPINDLE_STOPPED, span, spindle=spindle.name)
        speed = modal.turning_speed
        if self._spindles.cutting.is_active:
            speed = self._spindles.cutting.limit_of(index)
        feed = feed_state.per_revolution_mm * speed / 60.0
        if spindle.plc_controlled or not feed_state.follows_spindle:
            return feed, -1, 0.0
        return feed, index, speed * DEGREES_PER_S

    def _max_axis_feed(
        self, start: Sequence[float], target: Sequence[float], arc: Arc | None
    ) -> float:
        """Return the feed at which an axis reaches its maximum speed (P-AXIS-00212), none exceeds
        it.

        In the plane of an arc the slower axis counts, wherever the arc begins and ends.
        """
        length = self.length(start, target, arc)
        highest = []
        for index, axis in enumerate(self._environment.axes):
            part = abs(target[index] - start[index])
            if arc is not None and index in (arc.first, arc.second):
                part = arc.length(start)
            if part > 0.0:
                highest.append(axis.max_speed * length / part)
        return min(highest, default=0.0)

    def length(self, start: Sequence[float], target: Sequence[float], arc: Arc | None) -> float:
        """Return the length of a block: of the linear axes, else of the rotary ones."""
        linear2 = rotary2 = 0.0
        for index, axis in enumerate(self._environment.axes):
            if arc is not None and index in (arc.first, arc.second):
                continue
            rise = target[index] - start[index]
            if self._environment.offsets.transformation.is_linear(index, axis):
                linear2 += rise * rise
            else:
                rotary2 += rise * rise
        if arc is not None:
            turn = arc.length(start)
            return arithmetic.square_root(linear2 + turn * turn)
        is_rotary = linear2 < 1e-12 and rotary2 > 0.0
        return arithmetic.square_root(rotary2 if is_rotary else linear2)
