# SPDX-License-Identifier: MIT
"""The path of a block: lines and arcs, their ends, software limits (MO-1, MO-3, MO-4).

In: the modal state, the block's target and words. Out: one ``Segment``, or ``None`` if nothing
moves. Mistakes raise ``DecodeError``.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Message, Span
from nctakt.decoder import tilted_motions
from nctakt.decoder.blocks.axes.coupled_axes import check_slaves
from nctakt.decoder.blocks.path import segments
from nctakt.decoder.blocks.path.corners import CornerWords
from nctakt.decoder.blocks.path.feed import FeedRate
from nctakt.decoder.blocks.path.splines import SplineWords
from nctakt.decoder.blocks.path.threads import ThreadMotion
from nctakt.decoder.state.geometry import cubics
from nctakt.decoder.state.geometry.arcs import (
    PLANES,
    Arc,
    ArcError,
    arc_about,
    arc_of_radius,
    arc_through,
    extremes,
)
from nctakt.decoder.state.geometry.coordinate_systems import MAIN_AXES, Matrix, turned_out
from nctakt.decoder.state.modal_state import LastArc
from nctakt.decoder.state.queued.commands import Segment
from nctakt.decoder.state.queued.feed_modifiers import FeedModifiers
from nctakt.decoder.values.variables import Values
from nctakt.kernel import codes, rows
from nctakt.kernel.kinematics import map_rows
from nctakt.messages import diagnostic
from nctakt.messages.path.frames import ARC_SCALED_UNEQUALLY
from nctakt.messages.path.motion import (
    ARC_IN_SPACE_DURING_COMPENSATION,
    ARC_OUTSIDE_LIMITS,
    ARC_WITHOUT_CENTRE,
    CENTRE_NOT_IN_PLANE,
    PLANE_AXIS_MISSING,
)
from nctakt.messages.path.tools import (
    NO_RADIUS_TO_COMPENSATE,
    TANGENTIAL_WITH_G238,
)
from nctakt.messages.path.transformations import (
    ARC_DURING_PTP,
    DIRECTION_OUT_OF_REACH,
    TRANSFORMED_WAY_OUTSIDE_LIMITS,
    WAY_THROUGH_POLE,
)
from nctakt.messages.programs.decoder import TARGET_OUTSIDE_LIMITS
from nctakt.nc import tree
from nctakt.nc.vocabulary.functions import (
    APPROACH_INNER_CORNER,
    ARC_CLOCKWISE,
    ARC_IN_SPACE,
    ARCS,
    COMPENSATION_LEFT,
    CONTOURING_ONCE,
    EXACT_STOP_ONCE,
    NO_OVERRIDE,
    THREADS,
)

#: Words of a centre, one for each of the first three axes.
CENTRE_WORDS = ("I", "J", "K")
#: Those of each plane of main axes.
_WORDS_OF_PLANES = {
    plane: (CENTRE_WORDS[plane[0]], CENTRE_WORDS[plane[1]]) for plane in PLANES.values()
}

#: Lines by which a curve is compared with the limits of axes that a transformation moves.
LIMIT_LINES = 8


@dataclass(slots=True)
class PathWords:
    """The words of a block for its path, except the target: centre, G60, G61, G166.

    ``offset_kinds``: the offsets that apply to its absolute positions. ``end_feed``: E.
    ``ramp``: G193 or G293, and F before the block in mm/s. ``interim``: the point that an arc of
    G303 leads by, positions of the axes.
    """

    end_feed: tuple[Span, float] | None = None
    ramp: tuple[int, float] | None = None
    centre: dict[str, tuple[Span, float]] = field(default_factory=dict)
    once: frozenset[int] = frozenset()
    offset_kinds: int = codes.ALL_OFFSETS
    interim: tuple[float, ...] = ()


class PathMotion:
    """Makes the segments of one program; ``span``: the block of the last one."""

    def __init__(self, values: Values, feed_rate: FeedRate, threads: ThreadMotion) -> None:
        self._values = values
        self.corners = CornerWords(values)
        self.splines = SplineWords(values)
        self.feed_rate = feed_rate
        self.threads = threads
        self._environment = values.environment
        self._state = values.state
        self.span: Span

    def word(self, word: tree.Word, value: float) -> bool:
        """Process F, R, S.OFFSET and words of chamfers; return false for any other word."""
        match word.name:
            case "F":
                self.feed_rate.feed_word(value, word.span)
            case "R":
                self._state.path.radius = value * self._state.length_unit_mm
            case "S.OFFSET":
                self._state.thread.offset = value
            case _:
                return self.corners.word(word.name, word.span, value)
        return True

    def go_tangentially(self, span: Span) -> None:
        """Process G05, which G238 ignores."""
        compensation = self._state.path.compensation
        if compensation.mode == APPROACH_INNER_CORNER:
            text = self._environment.line_text(span)
            self._environment.warn(diagnostic(TANGENTIAL_WITH_G238, span, text))
            return
        compensation.is_tangential = True

    def compensate(self, function: int, span: Span) -> None:
        """Activate G41 or G42 with the active tool."""
        compensation = self._state.path.compensation
        radius = self._state.tool.tool.radius
        if radius == 0.0:
            self._values.fail(NO_RADIUS_TO_COMPENSATE, span, word=f"G{function}")
        path = self._state.path
        if self._environment.places.lacks_any(path.plane_axes):
            self._values.fail(PLANE_AXIS_MISSING, span, plane=path.plane)
        compensation.radius = radius
        is_reversed = self._state.frame.reverses(path.plane_axes)
        compensation.is_reversed = is_reversed
        compensation.side = 1 if (function == COMPENSATION_LEFT) is not is_reversed else -1

    def segment(
        self, start: list[float], target: list[float], words: PathWords, span: Span, number: int
    ) -> Segment | None:
        """Return the segment from ``start`` to ``target``, ``None`` if nothing moves."""
        state = self._state
        arc = turn = tilt = None
        if state.motion in ARCS:
            arc = self._arc(start, target, words, span)
            if arc is not None:
                turn = self._environment.offsets.systems.tilt(state.path.plane)
        elif state.motion == ARC_IN_SPACE:
            arc, turn = self._arc_in_space(start, target, words, span)
        if arc is None and start == target:
            return None
        transformation = self._environment.offsets.transformation
        if transformation.is_straight:
            if arc is not None:
                self._values.fail(ARC_DURING_PTP, span)
            start, target = transformation.to_axes(start), transformation.to_axes(target)
            self.check_limits(target, range(len(target)), span)
        elif arc is not None and turn is not None:
            tilt = tilted_motions.tilt_of(turn, self._environment, start, target)
            start, target = map(list, tilt.inside)
            pieces = tilted_motions.cubics_of(start, target, arc.row, turn)
            self.check_curve(pieces, span, message=ARC_OUTSIDE_LIMITS)
        elif transformation.is_active:
            self.check_travel(start, target, arc, span)
        elif arc is not None:
            self.check_extremes(arc, start, span)
        is_exempt = NO_OVERRIDE in words.once
        feed, feed_modifiers = self.feed_rate.of(start, target, arc, is_exempt, span)
        if words.end_feed is not None:
            feed_modifiers = self.feed_rate.with_end(feed, feed_modifiers, *words.end_feed)
        exact = self._stops_exactly(words)
        if state.motion in THREADS:
            feed, feed_modifiers = self.threads.of(
                start, target, feed_modifiers or FeedModifiers(), span
            )
            exact = exact or not state.thread.chains
        self.span = span
        rounding = state.path.rounding
        if CONTOURING_ONCE in words.once:
            rounding = state.path.contour.size
        return segments.segment(
            self._environment.source_id(span),
            number,
            start,
            target,
            rows.RAPID_MOTION if state.rapid else rows.FEED_MOTION,
            feed,
            exact,
            0.0 if exact or state.motion in THREADS else rounding,
            state.path.limits_jerk,
            None if arc is None else arc.row,
            feed_modifiers,
            tilt,
        )

    def _stops_exactly(self, words: PathWords) -> bool:
        state = self._state
        if state.rapid and self._environment.parameters.exact_stop_after_g00:
            return True
        return state.path.exact_stop or EXACT_STOP_ONCE in words.once

    def _arc(
        self, start: list[float], target: list[float], words: PathWords, span: Span
    ) -> Arc | None:
        """Return the arc of the block; ``None`` if it has only a radius and does not move.

        Where the coordinate system tilts its plane, the centre is in that plane.
        """
        path = self._state.path
        plane, frame = path.plane_axes, self._state.frame
        if self._environment.places.lacks_any(plane):
            self._values.fail(PLANE_AXIS_MISSING, span, plane=path.plane)
        clockwise, radius = self._state.motion == ARC_CLOCKWISE, path.radius
        if frame.is_active:
            clockwise = clockwise is not frame.reverses(plane)
            factor = frame.factor_in(plane)
            if factor is None:
                self._values.fail(ARC_SCALED_UNEQUALLY, span, plane=path.plane)
            radius *= factor
        offsets = self._environment.offsets
        begin = offsets.inside(start, words.offset_kinds)
        end = offsets.inside(target, words.offset_kinds)
        centre = None
        try:
            if words.centre:
                centre = self._centre(begin, words, plane)
                tolerance = self._environment.parameters.centre_tolerance
                arc = arc_about(begin, end, plane, centre, clockwise, tolerance)
            elif radius == 0.0:
                raise ArcError(ARC_WITHOUT_CENTRE)
            elif start == target:
                return None
            else:
                arc = arc_of_radius(begin, end, plane, radius, clockwise)
        except ArcError as error:
            self._values.fail(error.message, span, **error.values)
        unit = self._state.length_unit_mm
        path.last_arc = LastArc(arc, begin, words.centre, centre, unit)
        return offsets.systems.arc(arc, begin, start) if offsets.systems.is_active else arc

    def _arc_in_space(
        self, start: list[float], target: list[float], words: PathWords, span: Span
    ) -> tuple[Arc, Matrix]:
        """Return the arc of G303 and the matrix of its plane."""
        if self._state.path.compensation.is_active:
            self._values.fail(ARC_IN_SPACE_DURING_COMPENSATION, span)
        if self._environment.places.lacks_any(range(MAIN_AXES)):
            self._values.fail(PLANE_AXIS_MISSING, span, plane=self._state.path.plane)
        try:
            return arc_through(start, words.interim, target)
        except ArcError as error:
            self._values.fail(error.message, span, **error.values)

    def _centre(
        self, start: list[float], path_words: PathWords, plane: tuple[int, int]
    ) -> tuple[float, float]:
        """Return the centre in the plane, relative to the start (G162) or absolute (G161);
        default 0.
        """
        path, frame, given = self._state.path, self._state.frame, path_words.centre
        first, second = plane
        names = CENTRE_WORDS[:2]
        if path.turning_plane is None:
            names = _WORDS_OF_PLANES[plane]
        for name, (span, _) in given.items():
            if name not in names:
                self._values.fail(CENTRE_NOT_IN_PLANE, span, word=name, plane=path.plane)
        unit = self._state.length_unit_mm
        x = given[names[0]][1] * unit if names[0] in given else 0.0
        y = given[names[1]][1] * unit if names[1] in given else 0.0
        if path.absolute_centre:
            kinds, total = path_words.offset_kinds, self._environment.offsets.total
            x, y = frame.point(plane, (x, y)) if frame.is_active else (x, y)
            return (total(first, kinds) + x, total(second, kinds) + y)
        x, y = frame.direction(plane, (x, y)) if frame.is_active else (x, y)
        return (start[first] + x, start[second] + y)

    def check_extremes(self, arc: Arc, start: Sequence[float], span: Span) -> None:
        """Raise ``DecodeError`` if the arc leaves the software limits between its ends."""
        for index, position in extremes(arc, start):
            check_slaves(self._values, index, position, span)
            axis = self._environment.axes[index]
            low, high = self._state.software_limits.of(axis, index)
            if not axis.is_modulo and not low <= position <= high:
                self._values.fail(
                    ARC_OUTSIDE_LIMITS,
                    span,
                    axis=self._environment.places.name(index),
                    position=position,
                    low=low,
                    high=high,
                )

    def check_piece(
        self,
        start: list[float],
        target: list[float],
        arc: Arc | None,
        axes: Sequence[int],
        span: Span,
        turn: Matrix | None,
    ) -> None:
        """Raise ``DecodeError`` if these axes leave their software limits on a piece of a block.

        ``turn``: the piece is in a plane that is tilted by this matrix, and moves all axes.
        """
        if turn is not None:
            if arc is not None:
                pieces = tilted_motions.cubics_of(start, target, arc.row, turn)
                self.check_curve(pieces, span, message=ARC_OUTSIDE_LIMITS)
                return
            start, target = turned_out(turn, start), turned_out(turn, target)
            axes = range(len(target))
        if self._environment.offsets.transformation.is_active:
            self.check_travel(start, target, arc, span)
            return
        if arc is not None:
            self.check_extremes(arc, start, span)
        self.check_limits(target, axes, span)

    def check_travel(
        self, start: list[float], target: list[float], arc: Arc | None, span: Span
    ) -> None:
        """Raise ``DecodeError`` if an axis cannot follow a transformed block within its limits."""
        axis_check = self._environment.offsets.transformation.axis_check
        index = axis_check.first_outside(start, target, [] if arc is None else list(arc.row))
        if index < 0:
            return
        if axis_check.obstacle == map_rows.WAY_OUT_OF_REACH:
            self._values.fail(DIRECTION_OUT_OF_REACH, span)
        axis = self._environment.axes[index]
        if axis_check.obstacle == map_rows.AXIS_JUMPS:
            angle = axis_check.position
            self._values.fail(
                WAY_THROUGH_POLE,
                span,
                axis=self._environment.places.name(index),
                angle=round(angle, 3),
            )
        low, high = self._state.software_limits.of(axis, index)
        self._values.fail(
            TRANSFORMED_WAY_OUTSIDE_LIMITS,
            span,
            axis=self._environment.places.name(index),
            position=axis_check.position,
            low=low,
            high=high,
        )

    def check_curve(
        self,
        pieces: Sequence[cubics.Cubic],
        span: Span,
        near: list[float] | None = None,
        *,
        message: Message,
    ) -> None:
        """Raise ``DecodeError`` if an axis leaves its software limits on a curve.

        ``near``: the axes at its begin, where a transformation has them elsewhere now.
        """
        if not self._environment.offsets.transformation.is_active:
            self._check_extremes_of(pieces, span, message)
            return
        axis_check = self._environment.offsets.transformation.axis_check
        axes_at_end = axis_check.axes_at_end()
        axis_check.start_at(axes_at_end if near is None else near)
        for piece in pieces:
            points = [
                cubics.point(piece, number / LIMIT_LINES) for number in range(LIMIT_LINES + 1)
            ]
            for start, target in pairwise(points):
                self.check_travel(list(start), list(target), None, span)
        if near is not None:
            axis_check.start_at(axes_at_end)

    def _check_extremes_of(
        self, pieces: Sequence[cubics.Cubic], span: Span, message: Message
    ) -> None:
        for index, axis in enumerate(self._environment.axes):
            low, high = self._state.software_limits.of(axis, index)
            for piece in () if axis.is_modulo else pieces:
                for position in cubics.extremes(piece, index):
                    check_slaves(self._values, index, position, span)
                    if not low <= position <= high:
                        self._values.fail(
                            message,
                            span,
                            axis=self._environment.places.name(index),
                            position=position,
                            low=low,
                            high=high,
                        )

    def check_limits(self, target: Sequence[float], axes: Sequence[int], span: Span) -> None:
        """Raise ``DecodeError`` if one of these axes of a target is outside its software limits."""
        for axis in axes:
            self.check_limit(axis, target[axis], span)

    def check_limit(self, index: int, position: float, span: Span) -> None:
        """Raise ``DecodeError`` if the target of an axis is outside its software limits."""
        check_slaves(self._values, index, position, span)
        axis = self._environment.axes[index]
        low, high = self._state.software_limits.of(axis, index)
        if not low <= position <= high and not axis.is_modulo:
            self._values.fail(
                TARGET_OUTSIDE_LIMITS,
                span,
                axis=self._environment.places.name(index),
                position=position,
                low=low,
                high=high,
            )
