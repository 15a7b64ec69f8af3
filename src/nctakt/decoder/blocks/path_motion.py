# SPDX-License-Identifier: MIT
"""The path of a block: lines and arcs, their ends, software limits (MO-1, MO-3, MO-4).

In: the modal state, the block's target and words. Out: one ``Segment``, or ``None`` if nothing
moves. Mistakes raise ``DecodeError``.
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Span
from nctakt.decoder.blocks import segments
from nctakt.decoder.blocks.feed import FeedRate
from nctakt.decoder.blocks.threads import ThreadMotion
from nctakt.decoder.state.arcs import PLANES, Arc, ArcError, arc_about, arc_of_radius, extremes
from nctakt.decoder.state.commands import Segment
from nctakt.decoder.state.feed_modifiers import FeedModifiers
from nctakt.decoder.values.variables import Values
from nctakt.kernel import codes, rows
from nctakt.messages.coordinate_systems import ARC_PLANE_ASKEW, WORD_IN_ROTATED_COORDINATE_SYSTEM
from nctakt.messages.decoder import TARGET_OUTSIDE_LIMITS
from nctakt.messages.motion import (
    ARC_OUTSIDE_LIMITS,
    ARC_WITHOUT_CENTRE,
    CENTRE_NOT_IN_PLANE,
    PLANE_AXIS_MISSING,
)
from nctakt.messages.tools import (
    G238_DURING_COMPENSATION,
    NO_RADIUS_TO_COMPENSATE,
    PLANE_CHANGE_DURING_COMPENSATION,
)
from nctakt.messages.transformations import ARC_DURING_PTP, TRANSFORMED_WAY_OUTSIDE_LIMITS
from nctakt.nc import tree
from nctakt.nc.vocabulary.function_rows import Group
from nctakt.nc.vocabulary.functions import (
    ABSOLUTE_CENTRE,
    APPROACH_INNER_CORNER,
    ARC_CLOCKWISE,
    ARCS,
    CIRCULAR_TRANSITIONS,
    COMPENSATION_LEFT,
    COMPENSATION_OFF,
    CONTOUR_FEED,
    CONTOURING_ON,
    CONTOURING_ONCE,
    DEPART_WITHOUT_MOTION,
    DIAMETER_ON,
    EXACT_STOP_ON,
    EXACT_STOP_ONCE,
    MASKING_ON,
    NO_OVERRIDE,
    THREAD_CUTTING,
    THREADS,
    group_of,
)

#: Words of a centre, one for each of the first three axes.
CENTRE_WORDS = ("I", "J", "K")


@dataclass(slots=True)
class PathWords:
    """The words of a block for its path, except the target: centre, G60, G61, G166.

    ``offset_kinds``: the offsets that apply to its absolute positions. ``end_feed``: E.
    """

    end_feed: tuple[Span, float] | None = None
    centre: dict[str, tuple[Span, float]] = field(default_factory=dict)
    once: frozenset[int] = frozenset()
    offset_kinds: int = codes.ALL_OFFSETS


class PathMotion:
    """Makes the segments of one program; ``span``: the block of the last one."""

    def __init__(self, values: Values, feed_rate: FeedRate, threads: ThreadMotion) -> None:
        self._values = values
        self.feed_rate = feed_rate
        self.threads = threads
        self._environment = values.environment
        self._state = values.state
        self.span: Span

    def modal(self, function: int) -> None:
        """Process a modal G function of the path."""
        path = self._state.path
        match group_of(function):
            case Group.MOTION:
                self._state.motion = function
                if function != THREAD_CUTTING:
                    self._state.thread.offset = 0.0
            case Group.PLANE:
                path.plane = function
            case Group.DIAMETER:
                path.has_diameters = function == DIAMETER_ON
            case Group.FEED:
                self._state.feed.feed_mode = function
            case Group.ARC_CENTRE:
                path.absolute_centre = function == ABSOLUTE_CENTRE
            case Group.CONTOURING:
                path.contouring = function == CONTOURING_ON
            case Group.EXACT_STOP:
                path.exact_stop = function == EXACT_STOP_ON
            case Group.COMPENSATION if function == COMPENSATION_OFF:
                self._end_compensation()
            case Group.TRANSITION:
                path.compensation.by_arc = function == CIRCULAR_TRANSITIONS
            case Group.APPROACH:
                path.compensation.mode = function
            case Group.MASKING:
                path.compensation.masks = function == MASKING_ON
            case Group.FEED_ADAPTATION:
                path.compensation.adapts_feed = function == CONTOUR_FEED

    def word(self, word: tree.Word, value: float) -> bool:
        """Process F, R and S.OFFSET; return false for any other word."""
        match word.name:
            case "F":
                self.feed_rate.feed_word(value, word.span)
            case "R":
                self._state.path.radius = value * self._state.length_unit_mm
            case "S.OFFSET":
                self._state.thread.offset = value
            case _:
                return False
        return True

    def _end_compensation(self) -> None:
        """Process G40; after G239 the program continues from the tool's position."""
        compensation = self._state.path.compensation
        compensation.side = 0
        if compensation.has_left_path and compensation.mode == DEPART_WITHOUT_MOTION:
            for axis, value in zip(PLANES[self._state.path.plane], compensation.end, strict=True):
                self._state.positions[axis] = value

    def radius_of(self, axis: int, value: float) -> float:
        """Return a programmed value of an axis, half of it if it is a diameter (G51, G90)."""
        state = self._state
        is_diameter = state.path.has_diameters and state.absolute
        return 0.5 * value if is_diameter and self._environment.axes[axis].is_face else value

    def keep_plane(self, function: int, span: Span) -> None:
        """Raise ``DecodeError`` for a change of plane during compensation."""
        path = self._state.path
        if function != path.plane:
            self._values.fail(
                PLANE_CHANGE_DURING_COMPENSATION, span, word=f"G{function}", plane=path.plane
            )

    def keep_selection(self, function: int, span: Span) -> None:
        """Raise ``DecodeError`` for a change to or from G238 during compensation."""
        mode = self._state.path.compensation.mode
        if function != mode and APPROACH_INNER_CORNER in (function, mode):
            self._values.fail(G238_DURING_COMPENSATION, span, word=f"G{function}")

    def compensate(self, function: int, span: Span) -> None:
        """Activate G41 or G42 with the active tool."""
        compensation = self._state.path.compensation
        radius = self._state.tool.tool.radius
        if radius == 0.0:
            self._values.fail(NO_RADIUS_TO_COMPENSATE, span, word=f"G{function}")
        path = self._state.path
        if not self._environment.offsets.systems.keeps_plane(path.plane):
            self._values.fail(
                WORD_IN_ROTATED_COORDINATE_SYSTEM, span, word=f"G{function}", plane=path.plane
            )
        compensation.radius = radius
        compensation.side = 1 if function == COMPENSATION_LEFT else -1

    def segment(
        self, start: list[float], target: list[float], words: PathWords, span: Span, number: int
    ) -> Segment | None:
        """Return the segment from ``start`` to ``target``, ``None`` if nothing moves."""
        state = self._state
        arc = None
        if state.motion in ARCS:
            arc = self._arc(start, target, words, span)
        if arc is None and start == target:
            return None
        transformation = self._environment.offsets.transformation
        if transformation.is_straight:
            if arc is not None:
                self._values.fail(ARC_DURING_PTP, span)
            start, target = transformation.to_axes(start), transformation.to_axes(target)
            self.check_limits(target, range(len(target)), span)
        elif transformation.is_active:
            self.check_way(start, target, arc, span)
        elif arc is not None:
            self.check_extremes(arc, start, span)
        is_exempt = NO_OVERRIDE in words.once
        feed, pace = self.feed_rate.of(start, target, arc, is_exempt, span)
        if words.end_feed is not None:
            pace = self.feed_rate.with_end(feed, pace, *words.end_feed)
        exact = self._stops_exactly(words)
        if state.motion in THREADS:
            feed, pace = self.threads.of(start, target, pace or FeedModifiers(), span)
            exact = exact or not state.thread.chains
        self.span = span
        rounds = state.path.contouring or CONTOURING_ONCE in words.once
        return segments.segment(
            self._environment.source_id(span),
            number,
            start,
            target,
            rows.RAPID_MOTION if state.rapid else rows.FEED_MOTION,
            feed,
            exact,
            state.path.rounding if rounds and not exact and state.motion not in THREADS else 0.0,
            state.path.limits_jerk,
            None if arc is None else arc.row,
            pace,
        )

    def _stops_exactly(self, words: PathWords) -> bool:
        state = self._state
        if state.rapid and self._environment.parameters.exact_stop_after_g00:
            return True
        return state.path.exact_stop or EXACT_STOP_ONCE in words.once

    def _arc(
        self, start: list[float], target: list[float], words: PathWords, span: Span
    ) -> Arc | None:
        """Return the arc of the block; ``None`` if it has only a radius."""
        path = self._state.path
        clockwise = self._state.motion == ARC_CLOCKWISE
        if max(PLANES[path.plane]) >= len(start):
            self._values.fail(PLANE_AXIS_MISSING, span, plane=path.plane)
        offsets = self._environment.offsets
        begin = offsets.inside(start, words.offset_kinds)
        end = offsets.inside(target, words.offset_kinds)
        try:
            if words.centre:
                centre = self._centre(begin, words)
                tolerance = self._environment.parameters.centre_tolerance
                arc = arc_about(begin, end, path.plane, centre, clockwise, tolerance)
            elif path.radius == 0.0:
                raise ArcError(ARC_WITHOUT_CENTRE)
            elif start == target:
                return None
            else:
                arc = arc_of_radius(begin, end, path.plane, path.radius, clockwise)
        except ArcError as error:
            self._values.fail(error.message, span, **error.values)
        if not offsets.systems.is_active:
            return arc
        outside = offsets.systems.arc(arc, begin, start)
        if outside is None:
            self._values.fail(ARC_PLANE_ASKEW, span, plane=path.plane)
        return outside

    def _centre(self, start: list[float], words: PathWords) -> tuple[float, float]:
        """Return the centre in the plane, relative to the start (G162) or absolute (G161);
        default 0.
        """
        plane = PLANES[self._state.path.plane]
        for name, (span, _) in words.centre.items():
            if CENTRE_WORDS.index(name) not in plane:
                self._values.fail(
                    CENTRE_NOT_IN_PLANE, span, word=name, plane=self._state.path.plane
                )
        centre = []
        for axis in plane:
            _, value = words.centre.get(CENTRE_WORDS[axis], (None, 0.0))
            begin = start[axis]
            if self._state.path.absolute_centre:
                begin = self._environment.offsets.total(axis, words.offset_kinds)
            centre.append(begin + value * self._state.length_unit_mm)
        return (centre[0], centre[1])

    def check_extremes(self, arc: Arc, start: Sequence[float], span: Span) -> None:
        """Raise ``DecodeError`` if the arc leaves the software limits between its ends."""
        for index, position in extremes(arc, start):
            axis = self._environment.axes[index]
            low, high = axis.software_limit_low, axis.software_limit_high
            if not axis.is_modulo and not low <= position <= high:
                self._values.fail(
                    ARC_OUTSIDE_LIMITS, span, axis=axis.name, position=position, low=low, high=high
                )

    def check_piece(
        self,
        start: list[float],
        target: list[float],
        arc: Arc | None,
        axes: Sequence[int],
        span: Span,
    ) -> None:
        """Raise ``DecodeError`` if these axes leave their software limits on a piece of a block."""
        if self._environment.offsets.transformation.is_active:
            self.check_way(start, target, arc, span)
            return
        if arc is not None:
            self.check_extremes(arc, start, span)
        self.check_limits(target, axes, span)

    def check_way(
        self, start: list[float], target: list[float], arc: Arc | None, span: Span
    ) -> None:
        """Raise ``DecodeError`` if an axis leaves its software limits on a transformed block."""
        axis_check = self._environment.offsets.transformation.axis_check
        index = axis_check.first_outside(start, target, [] if arc is None else list(arc.row))
        if index < 0:
            return
        axis = self._environment.axes[index]
        low, high = axis.software_limit_low, axis.software_limit_high
        self._values.fail(
            TRANSFORMED_WAY_OUTSIDE_LIMITS,
            span,
            axis=axis.name,
            position=axis_check.position,
            low=low,
            high=high,
        )

    def check_limits(self, target: Sequence[float], axes: Sequence[int], span: Span) -> None:
        """Raise ``DecodeError`` if one of these axes of a target is outside its software limits."""
        for axis in axes:
            self.check_limit(axis, target[axis], span)

    def check_limit(self, index: int, position: float, span: Span) -> None:
        """Raise ``DecodeError`` if the target of an axis is outside its software limits."""
        axis = self._environment.axes[index]
        low, high = axis.software_limit_low, axis.software_limit_high
        if not low <= position <= high and not axis.is_modulo:
            self._values.fail(
                TARGET_OUTSIDE_LIMITS, span, axis=axis.name, position=position, low=low, high=high
            )
