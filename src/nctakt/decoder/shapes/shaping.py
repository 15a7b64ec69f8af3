# SPDX-License-Identifier: MIT
"""Shapes motions that follow from several blocks: chamfers, roundings, splines (MO-4, MO-18).

A stage between the decoder and the compensation of the tool's radius: commands in, commands out. A
program that may insert chamfers or roundings has each motion held until the next one arrives;
commands between them are kept after it. A command that waits for the realtime part releases all
motions before, so that nothing is inserted across it. In a spline the pieces of the curve take the
place of the motions; arcs of an Akima spline stay, and the curve fits them at both ends.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Generator, Iterator
from dataclasses import replace

from nctakt.base.diagnostics import Message, Span, Text
from nctakt.decoder.blocks.path.path_motion import PathMotion
from nctakt.decoder.fast.handover import PlainRun
from nctakt.decoder.shapes import corners
from nctakt.decoder.shapes.held_motion import HeldMotion
from nctakt.decoder.shapes.splines import Slope, Spline
from nctakt.decoder.state.environment import DecodeError
from nctakt.decoder.state.geometry.arcs import RADIANS, Arc
from nctakt.decoder.state.geometry.coordinate_systems import Matrix
from nctakt.decoder.state.queued.commands import (
    Answer,
    Command,
    DecoderWait,
    EmptyBlock,
    ProgramEnd,
    Segment,
    waits,
)
from nctakt.decoder.state.queued.feed_modifiers import FeedModifiers
from nctakt.decoder.state.queued.packing import takes_time
from nctakt.decoder.state.queued.shape_commands import (
    AKIMA,
    AUTO,
    BSPLINE,
    TANGENTIAL,
    InsertCorner,
    ReleaseMotions,
    ShapeCommand,
    SplineBegin,
    SplineEnd,
)
from nctakt.decoder.tilted_motions import into_plane
from nctakt.decoder.values.variables import Values
from nctakt.kernel import rows
from nctakt.messages import diagnostic
from nctakt.messages.path.shapes import (
    CORNER_NOT_IN_PLANE,
    CORNER_REVERSES,
    CORNER_TOO_LARGE,
    CORNER_WITHOUT_MOTION,
    CORNER_WITHOUT_NEXT_MOTION,
    TWO_CORNERS,
)
from nctakt.messages.path.splines import (
    ARC_IN_BSPLINE,
    CORNER_IN_SPLINE,
    NO_MOTION_AFTER_SPLINE,
    NO_MOTION_BEFORE_SPLINE,
)

#: Maximum number of other commands after a held motion; then nothing is inserted at its end.
MAX_BETWEEN = 1000

_BEFORE = Text("before", "vor")
_AFTER = Text("after", "nach")


class Shaping:
    """Shapes the motions of one program; ``pass_time`` is called for held commands as if executed.

    ``is_releasing``: commands are yielded for which it has been called.
    """

    def __init__(
        self, values: Values, path: PathMotion, pass_time: Callable[[Command], None]
    ) -> None:
        self._values = values
        self._environment = values.environment
        self._state = values.state
        self._path = path
        self._pass_time = pass_time
        self._held: HeldMotion | None = None
        self._spline: Spline | None = None
        self._end: SplineEnd | None = None
        self._before: Segment | None = None
        self.is_releasing = False

    @property
    def needs_next(self) -> bool:
        """Whether the next motion shapes the held one: after a corner, or in a spline."""
        held = self._held
        return self._spline is not None or (held is not None and held.corner is not None)

    @property
    def is_idle(self) -> bool:
        """Whether no motion is held."""
        return self._held is None and self._spline is None

    def shape(self, commands: Generator[Command, Answer]) -> Generator[Command, Answer]:
        """Yield the commands of a program with its motions shaped; raises ``DecodeError``."""
        answer: Answer = None
        try:
            while True:
                try:
                    command = commands.send(answer)
                except StopIteration:
                    return
                except DecodeError:
                    yield from self._stop()
                    raise
                if self._held is None and self._spline is None:
                    if isinstance(command, Segment):
                        concerns = self._state.shapes.waits_for_next
                    else:
                        concerns = isinstance(command, ShapeCommand)
                    if not concerns:
                        answer = yield command
                        continue
                try:
                    answer = yield from self._take(command)
                except DecodeError:
                    yield from self._stop()
                    raise
        finally:
            commands.close()

    def shape_body(self, body: list[Command]) -> list[Command]:
        """Return the commands of a realtime loop's body with its motions shaped."""
        if not any(isinstance(command, ShapeCommand) for command in body):
            return body
        inner = Shaping(self._values, self._path, lambda _: None)
        shaped: list[Command] = []
        for command in body:
            shaped += inner._take(command)
        shaped += inner._finish()
        return shaped

    def _take(self, command: Command) -> Generator[Command, Answer, Answer]:
        """Process one command of the program; return its answer."""
        match command:
            case Segment() if self._spline is not None:
                yield from self._vertex(self._spline, command)
            case Segment():
                yield from self._segment(command)
            case InsertCorner():
                self._corner(command)
            case SplineBegin():
                yield from self._begin_spline(command)
            case SplineEnd():
                yield from self._end_spline(command)
            case ReleaseMotions():
                if self._spline is None or self._end is not None:
                    yield from self._finish()
                if command.forgets:
                    self._before = None
            case DecoderWait() if self._spline is not None:
                return (yield command)
            case PlainRun() | DecoderWait() | ProgramEnd():
                yield from self._finish()
                return (yield command)
            case _ if waits(command):
                yield from self._finish()
                return (yield command)
            case _ if self._newest is None:
                return (yield command)
            case _:
                yield from self._hold(command)
        return None

    def _hold(self, command: Command) -> Iterator[Command]:
        """Keep a command after the newest motion that is held."""
        newest = self._newest
        assert newest is not None
        newest.between.append(command)
        if takes_time(command):
            self._pass_time(command)
        if len(newest.between) > MAX_BETWEEN and self._spline is None:
            yield from self._finish()

    @property
    def _newest(self) -> HeldMotion | None:
        """The newest motion that is held."""
        return self._held if self._spline is None else self._spline.last

    # --- motions --------------------------------------------------------------------------------

    def _segment(self, segment: Segment) -> Iterator[Command]:
        """Process a motion: it completes the held one, and is held itself."""
        self._pass_time(segment)
        segment = into_plane(segment, self._environment, self._state.path.plane)
        motion = HeldMotion(segment, self._path.span, self._state.feed.block_time_s)
        held, self._held = self._held, None
        if held is not None and held.corner is not None:
            inserted = self._insert(held, held.corner, motion)
            self._held = motion
            yield from self._release(held, inserted)
        else:
            self._held = motion
            if held is not None:
                yield from self._release(held, None)

    def _finish(self) -> Iterator[Command]:
        """Release the held motions; no further motion joins them."""
        if self._spline is not None:
            yield from self._close_spline(None)
        held, self._held = self._held, None
        if held is None:
            return
        if held.corner is not None:
            self._warn(CORNER_WITHOUT_NEXT_MOTION, held.corner.span)
        yield from self._release(held, None)

    def _release(self, held: HeldMotion, inserted: Segment | None) -> Iterator[Command]:
        """Yield a motion, then the commands after it with the shape inserted there."""
        yield from self._as_programmed(held.segment, held.span, held.time_s)
        self._before = held.segment
        self.is_releasing = True
        yield from held.between[: held.corner_at]
        if inserted is not None:
            assert held.corner is not None
            yield from self._as_programmed(inserted, held.corner.span, 0.0)
        self.is_releasing = True
        yield from held.between[held.corner_at :]
        self.is_releasing = False

    def _as_programmed(self, segment: Segment, span: Span, time_s: float) -> Iterator[Command]:
        """Yield a motion with the state of its block; one of no length as an empty block."""
        feed = self._state.feed
        kept = (self._path.span, feed.time_s)
        self._path.span, feed.time_s = span, time_s
        self.is_releasing = True
        if segment.start == segment.target and segment.arc is None:
            yield EmptyBlock(segment.source, segment.number)
        else:
            yield segment
        self.is_releasing = False
        self._path.span, feed.time_s = kept

    # --- splines --------------------------------------------------------------------------------

    def _begin_spline(self, command: SplineBegin) -> Iterator[Command]:
        """Begin a spline after the previous motion."""
        yield from self._finish()
        spline = Spline(self._values, self._path, command.kind, command.span)
        if command.kind != BSPLINE and command.start == TANGENTIAL and self._before is None:
            self._values.fail(NO_MOTION_BEFORE_SPLINE, command.span)
        spline.start_slope = spline.slope(command.start, command.vector, self._before, at_end=False)
        self._spline = spline

    def _end_spline(self, command: SplineEnd) -> Iterator[Command]:
        """End the spline; a tangential end waits for the next motion."""
        spline = self._spline
        if spline is None:
            return
        self._end = command
        if not self._waits_for_end(spline, command):
            yield from self._close_spline(None)

    def _waits_for_end(self, spline: Spline, end: SplineEnd) -> bool:
        """Return whether the end of a spline depends on the motion after it."""
        return end.end == TANGENTIAL and spline.last is not None and not spline.is_bspline

    def _vertex(self, spline: Spline, segment: Segment) -> Iterator[Command]:
        """Process a motion while a spline is on, or the one after it."""
        if self._end is not None:
            yield from self._close_spline(segment)
            yield from self._segment(segment)
            return
        if segment.arc is not None:
            yield from self._pause(spline, segment)
            return
        self._pass_time(segment)
        motion = HeldMotion(segment, self._path.span, self._state.feed.block_time_s)
        for held, pieces in spline.add(motion):
            yield from self._release_pieces(held, pieces)

    def _pause(self, spline: Spline, arc: Segment) -> Iterator[Command]:
        """Let the curve end at an arc, and another begin after it."""
        if spline.is_bspline:
            self._values.fail(ARC_IN_BSPLINE, self._path.span)
        end = SplineEnd(arc.source, arc.number, self._path.span, TANGENTIAL, ())
        if spline.last is None:
            end = replace(end, end=AUTO)
        self._end = end
        yield from self._close_spline(arc)
        self._pass_time(arc)
        held = HeldMotion(arc, self._path.span, self._state.feed.block_time_s)
        yield from self._release(held, None)
        after = Spline(self._values, self._path, AKIMA, spline.span)
        after.start_slope = after.slope(TANGENTIAL, (), arc, at_end=False)
        self._spline = after

    def _close_spline(self, after: Segment | None) -> Iterator[Command]:
        """Release the rest of a spline; ``after``: the motion that follows it."""
        spline, end = self._spline, self._end
        assert spline is not None
        self._spline = self._end = None
        slope: Slope = ()
        if end is not None:
            if after is None and self._waits_for_end(spline, end):
                self._values.fail(NO_MOTION_AFTER_SPLINE, end.span)
            slope = spline.slope(end.end, end.vector, after, at_end=True)
        for held, pieces in spline.finish(slope):
            yield from self._release_pieces(held, pieces)

    def _release_pieces(self, held: HeldMotion, pieces: list[Segment]) -> Iterator[Command]:
        """Yield the pieces of a motion, then the commands after it."""
        for piece in pieces:
            yield from self._as_programmed(piece, held.span, 0.0)
        self._before = pieces[-1]
        self.is_releasing = True
        yield from held.between
        self.is_releasing = False

    def _stop(self) -> Iterator[Command]:
        """Flush held motions before a mistake; of a spline only the settled part."""
        spline, self._spline = self._spline, None
        self._end = None
        yield from self._finish()
        if spline is not None:
            try:
                rest = list(spline.finish(()))
            except DecodeError:
                return
            for held, pieces in rest:
                yield from self._release_pieces(held, pieces)

    # --- chamfers and roundings -----------------------------------------------------------------

    def _corner(self, corner: InsertCorner) -> None:
        """Keep the shape inserted after the held motion."""
        if self._spline is not None:
            self._values.fail(CORNER_IN_SPLINE, corner.span, word=corner.word)
        held = self._held
        if held is None:
            self._warn(CORNER_WITHOUT_MOTION, corner.span)
            return
        if held.corner is not None:
            other = held.corner.word
            self._values.fail(TWO_CORNERS, corner.span, word=corner.word, other=other)
        held.corner = corner
        held.corner_at = len(held.between)

    def _warn(self, message: Message, span: Span) -> None:
        text = self._environment.line_text(span)
        self._environment.warn(diagnostic(message, span, text))

    def _insert(self, held: HeldMotion, corner: InsertCorner, motion: HeldMotion) -> Segment | None:
        """Cut two motions short at their corner; return the shape inserted between them.

        ``None`` for a rounding between motions in one straight line.
        """
        plane = self._state.path.plane_axes
        if _matrix(held.segment) != _matrix(motion.segment):
            number = self._state.path.plane
            self._values.fail(CORNER_NOT_IN_PLANE, corner.span, side=_BEFORE, plane=number)
        before = corners.Side(held.segment, plane, is_before=True)
        after = corners.Side(motion.segment, plane, is_before=False)
        for side, cut, where in ((before, held, _BEFORE), (after, motion, _AFTER)):
            if side.length < corners.NOTHING_LEFT:
                if cut.segment.start == cut.segment.target:
                    self._values.fail(CORNER_TOO_LARGE, corner.span, size=corner.size, side=where)
                self._values.fail(
                    CORNER_NOT_IN_PLANE, corner.span, side=where, plane=self._state.path.plane
                )
        centre, left = None, 0.0
        if corner.is_rounding:
            x, y = before.direction
            u, v = after.direction
            if abs(x * v - y * u) < corners.SAME_DIRECTION and x * u + y * v > 0.0:
                return None
            found = corners.rounding_centre(before, after, corner.size)
            if found is None:
                self._values.fail(CORNER_REVERSES, corner.span, size=corner.size)
            centre, left = found
            parts = (before.touch(centre), after.touch(centre))
        else:
            chord = corner.size
            if corner.word == "#CHF":
                chord /= 2.0 * max(math.sin(0.5 * corners.inner_angle(before, after)), 1e-12)
            parts = (before.part_of_chord(chord), after.part_of_chord(chord))
        points = []
        for side, part, where in zip((before, after), parts, (_BEFORE, _AFTER), strict=True):
            if part > 1.0 + corners.NOTHING_LEFT:
                self._values.fail(CORNER_TOO_LARGE, corner.span, size=corner.size, side=where)
            is_all = part > 1.0 - corners.NOTHING_LEFT
            points.append(side.far if is_all else side.point_at(part))
        held.segment = corners.without_end(held.segment, plane, min(parts[0], 1.0), points[0])
        motion.segment = corners.without_begin(motion.segment, plane, min(parts[1], 1.0), points[1])
        arc = None
        if centre is not None:
            arc = _arc(plane, points, centre, left)
            start, target = list(held.segment.target), list(motion.segment.start)
            turn = _matrix(held.segment)
            self._path.check_piece(start, target, arc, plane, corner.span, turn)
        inserted = self._inserted(held.segment, motion.segment, corner, arc)
        if corner.of_block:
            held.segment = replace(held.segment, continues_block=True)
        return inserted

    def _inserted(
        self, before: Segment, after: Segment, corner: InsertCorner, arc: Arc | None
    ) -> Segment:
        """Return the chamfer or rounding as a separate motion.

        It is rapid next to a rapid motion. Its feed is that of ``#FRC``, else E of the motion
        before, else F.
        """
        is_feed = before.is_feed and after.is_feed
        modifiers = before.modifiers
        feed = corner.feed or before.feed
        if modifiers is not None:
            if modifiers.end_feed > 0.0 and not corner.has_own_feed:
                feed = modifiers.end_feed / modifiers.override
            modifiers = replace(modifiers, end_feed=0.0, thread=rows.NO_THREAD)
            modifiers = None if modifiers == FeedModifiers() else modifiers
        return replace(
            before,
            source=corner.source,
            number=corner.number,
            start=before.target,
            target=after.start,
            motion=rows.FEED_MOTION if is_feed else rows.RAPID_MOTION,
            feed=feed if is_feed else 0.0,
            exact_stop=before.exact_stop and corner.of_block,
            arc=None if arc is None else arc.row,
            modifiers=modifiers,
            continues_block=False,
        )


def _matrix(segment: Segment) -> Matrix | None:
    """Return the tilt of a motion's plane."""
    return None if segment.tilt is None else segment.tilt.matrix


def _arc(
    plane: tuple[int, int], ends: list[corners.Point], centre: corners.Point, left: float
) -> Arc:
    """Return the arc of a rounding between two points, to the left or right."""
    begin = math.atan2(ends[0][1] - centre[1], ends[0][0] - centre[0])
    end = math.atan2(ends[1][1] - centre[1], ends[1][0] - centre[0])
    angle = (end - begin) * left % math.tau
    return Arc(*plane, *centre, angle * left / RADIANS)
