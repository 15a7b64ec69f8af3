# SPDX-License-Identifier: MIT
"""Tool radius compensation: contours of the program -> ways of the tool's centre (MO-9).

A stage behind the decoder: commands in, commands out. Between G41 or G42 and the motion that G40
leaves the contour with, a motion in the plane is held until the next one shows where it ends; what
comes in between keeps its place behind it. So there is never more than one motion in the plane and
``MOST_BETWEEN`` other commands under way. The first motion in the plane approaches the contour, the
one behind G40 leaves it: straight lines, that are not shifted themselves.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterator
from dataclasses import dataclass, replace
from typing import NoReturn

from nctakt.decoder import contours
from nctakt.decoder.arcs import PLANES, SAME_PLACE_MM, Arc
from nctakt.decoder.commands import Answer, Command, ProgramEnd, Segment, pack, waits
from nctakt.decoder.contours import Joint, Piece, Point
from nctakt.decoder.motion import PathMotion
from nctakt.decoder.surroundings import DecodeError
from nctakt.decoder.values import Values
from nctakt.diagnostics import Span
from nctakt.kernel import arithmetic
from nctakt.kernel.ring import TIMED_KINDS

#: Commands that may stand between two motions in the plane.
MOST_BETWEEN = 1000


@dataclass(slots=True)
class _Motion:
    """A motion in the plane; ``distance`` to the left of it goes the tool, 0: to and from it.

    ``beside``: the whole way at this distance. ``start``: where the tool begins it. ``time_s``: how
    long its block lasts under G93, 0 without.
    """

    segment: Segment
    span: Span
    piece: Piece
    distance: float
    beside: Piece
    start: Point = (0.0, 0.0)
    time_s: float = 0.0


class Compensation:
    """Compensates one program; ``took_time`` is told of what is held as if it were taken."""

    def __init__(
        self, values: Values, path: PathMotion, took_time: Callable[[Command], None]
    ) -> None:
        self._values = values
        self._path = path
        self._state = values.state.path
        self._took_time = took_time
        self._held: _Motion | None = None
        self._between: list[Command] = []
        self._distance = 0.0
        self._at: Point | None = None
        self.releases = False

    def through(self, commands: Generator[Command, Answer]) -> Generator[Command, Answer]:
        """The commands of a program with its contours compensated."""
        answer: Answer = None
        try:
            while True:
                try:
                    command = commands.send(answer)
                except StopIteration:
                    return
                except DecodeError:
                    yield from self._finish()
                    raise
                try:
                    answer = yield from self._take(command)
                except DecodeError:
                    yield from self._finish()
                    raise
        finally:
            commands.close()

    def _take(self, command: Command) -> Generator[Command, Answer, Answer]:
        """One command of the program; what its taker answers."""
        if isinstance(command, Segment) and self._state.compensation.is_active:
            yield from self._segment(command)
            return None
        if self._held is not None and not isinstance(command, Segment):
            if not waits(command) and not isinstance(command, ProgramEnd):
                self._hold(command)
                return None
            yield from self._finish()
        return (yield command)

    def _segment(self, segment: Segment) -> Iterator[Command]:
        """A motion: in the plane part of the contour, else it keeps its place."""
        piece = self._piece(segment)
        if piece is None:
            if self._held is None and self._at is None:
                yield segment
            elif self._moves_others(segment):
                if self._held is None:
                    yield self._elsewhere(segment)
                else:
                    self._hold(segment)
            return
        self._took_time(segment)
        wanted = self._state.compensation
        distance = wanted.side * wanted.radius
        is_free = distance != self._distance
        if is_free and not piece.is_line:
            self._values.fail(900870, self._path.span)
        beside = piece if is_free else contours.shifted(piece, distance)
        if beside is None:
            self._values.fail(900871, self._path.span, radius=abs(distance))
        own_distance = 0.0 if is_free else distance
        motion = _Motion(segment, self._path.span, piece, own_distance, beside)
        motion.time_s = self._values.state.pace.block_time_s
        self._distance = distance
        wanted.is_on_way = True
        if self._held is None:
            motion.start = piece.start if self._at is None else self._at
        else:
            yield from self._join(self._held, motion)
        self._held = motion
        if distance == 0.0:
            yield from self._finish()
            wanted.is_on_way = False
            self._at = None

    def _hold(self, command: Command) -> None:
        if len(self._between) >= MOST_BETWEEN:
            self._values.fail(900872, self._path.span, count=MOST_BETWEEN)
        self._between.append(command)
        if isinstance(command, Segment) or pack(command)[0] in TIMED_KINDS:
            self._took_time(command)

    def _piece(self, segment: Segment) -> Piece | None:
        """The motion in the plane, ``None`` where there is none."""
        first, second = PLANES[self._state.plane]
        start = (segment.start[first], segment.start[second])
        end = (segment.target[first], segment.target[second])
        if segment.arc is not None:
            _, _, x, y, angle = segment.arc
            return Piece(start, end, (x, y), angle)
        if max(abs(start[0] - end[0]), abs(start[1] - end[1])) <= SAME_PLACE_MM:
            return None
        return Piece(start, end)

    def _moves_others(self, segment: Segment) -> bool:
        """Whether axes move that are not in the plane."""
        plane = PLANES[self._state.plane]
        places = range(len(segment.start))
        return any(segment.start[one] != segment.target[one] for one in places if one not in plane)

    # --- joints ----------------------------------------------------------------------------------

    def _join(self, held: _Motion, motion: _Motion) -> Iterator[Command]:
        """The held motion up to where the next one begins, and what came between them."""
        if held.distance and motion.distance:
            by_arc = self._state.compensation.by_arc
            ways = (held.beside, motion.beside)
            joint = contours.join(held.piece, motion.piece, ways, held.distance, by_arc)
        else:
            joint = self._free_joint(held, motion)
        if joint is None:
            self._fail(held)
        motion.start = joint.start
        yield from self._release(held, joint)

    def _free_joint(self, held: _Motion, motion: _Motion) -> Joint:
        """Where a motion to or from the contour meets it: beside its end, or around its corner."""
        distance = held.distance or motion.distance
        corner = held.piece.end
        if distance == 0.0:
            return Joint(corner, (), corner)
        before = held.piece.direction_at(corner)
        behind = motion.piece.direction_at(corner)
        mode = self._state.compensation
        turn = contours.turn_between(before, behind)
        if contours.is_outer(turn, distance) and not mode.is_direct:
            ways = contours.around(corner, (before, behind), distance, mode.by_arc)
            return contours.extended(
                ways,
                first=held.piece.is_line and held.distance != 0.0,
                second=motion.piece.is_line and motion.distance != 0.0,
            )
        direction = before if held.distance else behind
        place = contours.beside(corner, direction, distance)
        return Joint(place, (), place)

    def _finish(self) -> Iterator[Command]:
        """The held motion up to its end: nothing follows that it could be joined with."""
        held = self._held
        if held is None:
            return
        end = held.piece.end
        if held.distance:
            end = contours.beside(end, held.piece.direction_at(end), held.distance)
        yield from self._release(held, Joint(end, (), end))

    # --- commands out ----------------------------------------------------------------------------

    def _release(self, held: _Motion, joint: Joint) -> Iterator[Command]:
        between, self._between, self._held = self._between, [], None
        pieces = [*self._own(held, joint.end), *joint.between]
        commands: list[Command] = list(self._segments(held, pieces))
        self._at = joint.start
        commands += [self._elsewhere(one) if isinstance(one, Segment) else one for one in between]
        self.releases = True
        yield from commands
        self.releases = False

    def _own(self, held: _Motion, end: Point) -> list[Piece]:
        """The way beside the motion itself; empty where nothing is left of it."""
        if held.distance:
            own = contours.trimmed(held.beside, held.start, end)
            if own is None:
                self._fail(held)
        else:
            own = Piece(held.start, end)
        moves = own.start != own.end or own.angle or self._moves_others(held.segment)
        return [own] if moves else []

    def _fail(self, held: _Motion) -> NoReturn:
        """The contour cannot be passed with this tool (90019, 90038)."""
        radius = abs(held.distance)
        self._values.fail(90019 if held.piece.is_line else 90038, held.span, radius=radius)

    def _segments(self, held: _Motion, pieces: list[Piece]) -> Iterator[Segment]:
        """The pieces of a motion; only the last one stops exactly."""
        first, second = PLANES[self._state.plane]
        segment = held.segment
        if held.time_s > 0.0 and segment.feed > 0.0:
            feed = self._whole_way(segment, pieces) / held.time_s
            segment = replace(segment, feed=feed)
        for number, piece in enumerate(pieces):
            is_last = number == len(pieces) - 1
            start = list(segment.start if number == 0 else segment.target)
            target = list(segment.target)
            start[first], start[second] = piece.start
            target[first], target[second] = piece.end
            row = None
            if piece.centre is not None:
                row = (first, second, *piece.centre, piece.angle)
                self._path.check_extremes(Arc(*row), start, held.span)
            self._path.check_limits(target, (first, second), held.span)
            yield replace(
                segment,
                start=tuple(start),
                target=tuple(target),
                exact_stop=segment.exact_stop and is_last,
                arc=row,
                goes_on=not is_last,
            )

    def _whole_way(self, segment: Segment, pieces: list[Piece]) -> float:
        """The way of a block with all its pieces; other axes move on the first of them."""
        plane = PLANES[self._state.plane]
        ways = [contours.length(piece) for piece in pieces]
        first2 = ways[0] * ways[0]
        for place, axis in enumerate(self._values.surroundings.axes):
            if axis.is_linear and place not in plane:
                rise = segment.target[place] - segment.start[place]
                first2 += rise * rise
        return arithmetic.square_root(first2) + sum(ways[1:])

    def _elsewhere(self, segment: Segment) -> Segment:
        """A motion of other axes, with those of the plane where the tool is."""
        if self._at is None:
            return segment
        start, target = list(segment.start), list(segment.target)
        for place, value in zip(PLANES[self._state.plane], self._at, strict=True):
            start[place] = target[place] = value
        return replace(segment, start=tuple(start), target=tuple(target))
