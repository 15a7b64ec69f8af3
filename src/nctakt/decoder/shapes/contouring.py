# SPDX-License-Identifier: MIT
"""Curves over corners that the realtime part does not round itself (``#CONTOUR MODE``, MO-3).

The last stage of the decoder, after the compensation of the tool's radius: commands in, commands
out. The realtime part rounds corners of two lines that meet without anything between them. This
module has those with arcs, those with M and H functions, which act before the curve, at its interim
point or after it, and those whose curve begins and ends at different distances or has a given
interim point, and all under a transformation. A motion that contours is held until the next one
arrives.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterator, Sequence
from dataclasses import replace
from typing import Protocol

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Span
from nctakt.decoder.blocks.path.path_motion import PathMotion
from nctakt.decoder.fast.handover import PlainRun
from nctakt.decoder.shapes import contour_curve
from nctakt.decoder.shapes.contour_curve import Joint
from nctakt.decoder.shapes.splines import slope_of
from nctakt.decoder.state.environment import DecodeError, DecoderEnvironment
from nctakt.decoder.state.geometry import cubics
from nctakt.decoder.state.geometry.contour_form import ContourForm
from nctakt.decoder.state.queued.commands import (
    Answer,
    AwaitAcknowledge,
    BlockMark,
    Command,
    DecoderWait,
    EmptyBlock,
    ProgramEnd,
    Segment,
    TechnologyOutput,
    UserMessage,
    WaitMark,
    WriteText,
    WriteVariable,
    waits,
)
from nctakt.decoder.state.queued.feed_modifiers import FeedModifiers
from nctakt.decoder.state.queued.packing import takes_time
from nctakt.decoder.state.queued.spindle_commands import AwaitSpindle, SpindleJob
from nctakt.decoder.state.queued.start_block import StartReached
from nctakt.decoder.state.queued.tool_life import ToolLifeFactors
from nctakt.decoder.values.variables import Values
from nctakt.kernel import rows
from nctakt.kernel.kinematics import map_rows
from nctakt.messages.path.motion import CURVE_OUTSIDE_LIMITS
from nctakt.nc.vocabulary.path_keywords import INTER_ACTION, POST_ACTION, PRE_ACTION

#: Distances from the corner up to this count as 0, mm.
NO_DISTANCE_MM = 1e-6

#: Maximum number of times that a curve next to an arc is shortened to keep the deviation.
MAX_STEPS = 12

#: Maximum number of commands after a held motion.
MAX_BETWEEN = 1000

_ACTIONS = TechnologyOutput | AwaitAcknowledge | SpindleJob | AwaitSpindle
#: Commands allowed between two motions that a curve joins.
_WITHOUT_CONTOUR = (
    _ACTIONS
    | BlockMark
    | EmptyBlock
    | StartReached
    | ToolLifeFactors
    | UserMessage
    | WaitMark
    | WriteText
    | WriteVariable
)


#: Up to which d/p the curve is faster; both are those of the axes that take longest.
FASTER = 2.0 * 0.4
FASTER_WITH_JERK = 0.5 * 6.0 * 0.1

#: How far from the corner the directions of the axes are taken, mm.
NEAR_MM = 0.01


@dataclass(slots=True)
class _Held:
    """A motion that contours, with the commands after it.

    ``form``: the curve at its end. ``used``: the length used by the curve at its start, mm.
    ``is_compensated``: it is a piece of a compensated contour. ``axes_at_end``: the axes at its end
    under a transformation, which bends their paths.
    """

    segment: Segment
    span: Span
    form: ContourForm
    used: float
    is_compensated: bool
    axes_at_end: list[float] | None
    between: list[Command] = field(default_factory=list)

    @property
    def has_actions(self) -> bool:
        """Whether M or H functions come after the motion."""
        return any(isinstance(command, _ACTIONS) for command in self.between)

    def joins(self, segment: Segment, is_compensated: bool) -> bool:
        """Return whether a curve made here joins the motion with the next one.

        With a limit of the jerk an arc is left to the realtime part, which is faster there; so is
        one of a compensated contour.
        """
        has_arc = self.segment.arc is not None or segment.arc is not None
        is_after = self.form.action == POST_ACTION and not any(
            isinstance(command, AwaitAcknowledge | AwaitSpindle) for command in self.between
        )
        if not (
            self.form.is_own
            or self.axes_at_end is not None
            or (has_arc and not (self.segment.limits_jerk or self.is_compensated or is_compensated))
            or (self.has_actions and not is_after)
        ):
            return False
        return all(isinstance(command, _WITHOUT_CONTOUR) for command in self.between)


class Releasing(Protocol):
    """The stage before this one."""

    @property
    def is_releasing(self) -> bool:
        """Whether it yields pieces of a compensated contour."""


class Contouring:
    """Rounds corners of one program; ``pass_time`` is called for held commands as if they were
    executed; ``before``: the compensation of the tool's radius.

    ``is_releasing``: commands are yielded for which it has been called.
    """

    def __init__(
        self,
        values: Values,
        path: PathMotion,
        pass_time: Callable[[Command], None],
        before: Releasing,
    ) -> None:
        self._values = values
        self._environment = values.environment
        self._state = values.state
        self._path = path
        self._pass_time = pass_time
        self._before = before
        self._held: _Held | None = None
        self.is_releasing = False

    @property
    def _linear(self) -> list[int]:
        """The axes that are programmed in mm at this moment of decoding."""
        is_linear = self._environment.offsets.transformation.is_linear
        return [
            index for index, axis in enumerate(self._environment.axes) if is_linear(index, axis)
        ]

    @property
    def needs_next(self) -> bool:
        """Whether the next motion shapes the held one."""
        return self._held is not None and (self._held.has_actions or self._held.form.is_own)

    @property
    def is_idle(self) -> bool:
        """Whether no motion is held."""
        return self._held is None

    def contour(self, commands: Generator[Command, Answer]) -> Generator[Command, Answer]:
        """Yield the commands of a program with its corners rounded; raises ``DecodeError``."""
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
                if self._held is None and not (
                    isinstance(command, Segment) and command.deviation != 0.0
                ):
                    answer = yield command
                    continue
                answer = yield from self._take(command)
        finally:
            commands.close()

    def plain_body(self, body: list[Command]) -> list[Command]:
        """Return the commands of a realtime loop's body, whose corners get no curves here."""
        form = self._state.path.contour.form(self._state.limits)
        if not form.is_own:
            return body
        return [
            replace(command, deviation=form.plain_deviation)
            if isinstance(command, Segment) and command.deviation != 0.0
            else command
            for command in body
        ]

    def _take(self, command: Command) -> Generator[Command, Answer, Answer]:
        """Process one command of the program; return its answer."""
        held = self._held
        if isinstance(command, Segment):
            yield from self._segment(command)
            return None
        assert held is not None
        if isinstance(command, PlainRun | DecoderWait | ProgramEnd) or waits(command):
            yield from self._finish()
            return (yield command)
        if len(held.between) >= MAX_BETWEEN:
            yield from self._finish()
            return (yield command)
        held.between.append(command)
        if takes_time(command):
            self._pass_time(command)
        return None

    def _segment(self, segment: Segment) -> Iterator[Command]:
        """Process a motion: it completes the held one, and is held itself if it contours."""
        held, self._held = self._held, None
        is_compensated = self._before.is_releasing
        used = 0.0
        if held is not None:
            rest = segment
            if held.joins(segment, is_compensated):
                rest = yield from self._join(held, segment)
            else:
                yield from self._release(held)
            used = _used_length(segment, rest, self._linear)
            segment = rest
        if not self._contours(segment):
            yield segment
            return
        self._pass_time(segment)
        form = self._state.path.contour.form(self._state.limits)
        transformation = self._environment.offsets.transformation
        axes_at_end = transformation.axis_check.axes_at_end() if transformation.is_active else None
        self._held = _Held(segment, self._path.span, form, used, is_compensated, axes_at_end)

    def _contours(self, segment: Segment) -> bool:
        """Return whether the corner at the end of a motion may get a curve of here."""
        modifiers = segment.modifiers
        if segment.deviation == 0.0 or segment.curve is not None:
            return False
        if self._state.path.hsc.is_on and not self._state.path.contouring:
            return False
        if modifiers is not None and (modifiers.end_feed > 0.0 or modifiers.thread):
            return False
        transformation = self._environment.offsets.transformation
        return self._state.feed.block_time_s == 0.0 and not transformation.is_straight

    def _finish(self) -> Iterator[Command]:
        """Release the held motion; no further motion joins it."""
        held, self._held = self._held, None
        if held is not None:
            yield from self._release(held)

    def _release(self, held: _Held) -> Iterator[Command]:
        """Yield a motion whose corner is left to the realtime part, and the commands after it."""
        segment = held.segment
        if held.form.is_own:
            segment = replace(segment, deviation=held.form.plain_deviation)
        yield from self._passed([segment, *held.between])

    def _passed(self, commands: list[Command]) -> Iterator[Command]:
        """Yield commands whose time has passed."""
        self.is_releasing = True
        yield from commands
        self.is_releasing = False

    # --- the curve ------------------------------------------------------------------------------

    def _join(self, held: _Held, segment: Segment) -> Generator[Command, None, Segment]:
        """Yield everything up to the end of the curve between two motions; return the rest.

        Where no curve fits, the corner is left to the realtime part.
        """
        form = held.form
        turn = contour_curve.turn_of(held.segment, segment, self._linear)
        if (
            segment.curve is not None
            or not contour_curve.smallest_turn(held.segment, segment) < turn <= form.max_bend
            or segment.start != held.segment.target
            or segment.limits_jerk != held.segment.limits_jerk
            or not self._is_wanted(held, segment)
            or _has_thread(segment) != _has_thread(held.segment)
        ):
            yield from self._release(held)
            return segment
        before = Joint(held.segment, self._linear, form.part, is_before=True, used=held.used)
        after = Joint(segment, self._linear, form.part, is_before=False)
        halves = contour_curve.distances(before, after, turn, form.deviation, form.distances)
        if max(halves) <= NO_DISTANCE_MM and not form.point:
            yield from self._release(held)
            return segment
        for _ in range(MAX_STEPS):
            first, last = before.without(halves[0]), after.without(halves[1])
            middle = contour_curve.interim_point(
                segment.start, (before.corner_slope, after.corner_slope), halves, form.point
            )
            pieces = contour_curve.curve(
                before.end(first), after.end(last), halves, middle, self._linear
            )
            if form.deviation == 0.0:
                break
            off = contour_curve.deviation_of(
                [cubic for half in pieces for cubic in half],
                (held.segment, segment),
                self._linear,
            )
            if off <= form.deviation:
                break
            halves = (0.8 * halves[0], 0.8 * halves[1])
        whole = [cubic for half in pieces for cubic in half]
        self._path.check_curve(whole, held.span, held.axes_at_end, message=CURVE_OUTSIDE_LIMITS)
        one, two = (self._motions(half, held.segment, segment) for half in pieces)
        two[-1] = replace(two[-1], continues_block=held.segment.continues_block)
        begin = replace(first, deviation=0.0, continues_block=True)
        action = form.action if held.has_actions else POST_ACTION
        commands: list[Command] = [begin]
        commands += held.between if action == PRE_ACTION else []
        commands += one
        commands += held.between if action == INTER_ACTION else []
        commands += two
        commands += held.between if action == POST_ACTION else []
        yield from self._passed(commands)
        return last

    def _is_wanted(self, held: _Held, segment: Segment) -> bool:
        """Return whether a corner needs its curve, or is passed faster with it."""
        if held.axes_at_end is None or held.form.is_own or held.has_actions:
            return True
        return is_faster(self._environment, held.segment, segment, self._linear, held.axes_at_end)

    def _motions(self, half: list[cubics.Cubic], before: Segment, after: Segment) -> list[Segment]:
        """Return a half of the curve as motions of the block before the corner.

        It is rapid only between rapid motions, and has the lower of two feeds.
        """
        is_feed = before.is_feed or after.is_feed
        feeds = [segment.feed for segment in (before, after) if segment.is_feed]
        modifiers = before.modifiers
        if modifiers == FeedModifiers():
            modifiers = None
        return [
            replace(
                before,
                start=cubic[0],
                target=cubic[3],
                motion=rows.FEED_MOTION if is_feed else rows.RAPID_MOTION,
                feed=min(feeds, default=0.0),
                deviation=0.0,
                arc=None,
                modifiers=modifiers,
                curve=(*cubic[1], *cubic[2]),
                continues_block=True,
            )
            for piece in half
            for cubic in cubics.divided(piece, self._linear)
        ]


def _has_thread(segment: Segment) -> bool:
    return segment.modifiers is not None and segment.modifiers.thread != rows.NO_THREAD


def _used_length(segment: Segment, rest: Segment, linear: list[int]) -> float:
    """Return which length of a motion is not in its rest, mm."""
    if rest is segment:
        return 0.0
    return contour_curve.length_of(segment, linear) - contour_curve.length_of(rest, linear)


# Whether a curve over a corner is faster than the corner, where a transformation bends the paths.
#
# Where the direction of an axis changes by d, its path on a curve that begins h before the corner
# bends by d/h per mm. So the curve takes about twice the root of d·h/a, or the cube root of d·h/j;
# from a standstill at the corner the axis needs twice that of 2·p·h/a, or 6·p·h/j, if p is its part
# of the length. The look-ahead leaves the bend 0.4 of the acceleration a or 0.1 of the jerk j, and
# with limited jerk the lines next to a curve have its lower acceleration, which costs as much.


def is_faster(
    environment: DecoderEnvironment,
    before: Segment,
    after: Segment,
    linear: Sequence[int],
    axes_at_end: Sequence[float],
) -> bool:
    """Return whether a curve between two motions is faster than the corner.

    ``linear``: the axes that are programmed in mm; ``axes_at_end``: positions of the axes at the
    corner.
    """
    transformation = environment.offsets.transformation

    def axes_at(slope: Sequence[float], distance: float) -> list[float] | None:
        point = [begin + distance * part for begin, part in zip(after.start, slope, strict=True)]
        axes, answer = transformation.mapped(
            transformation.number, point, axes_at_end, to_axes=True
        )
        return axes if answer == map_rows.REACHED else None

    leaving = slope_of(before, linear, at_end=True)
    near = axes_at(leaving, -NEAR_MM)
    corner = axes_at(leaving, 0.0)
    beyond = axes_at(slope_of(after, linear, at_end=False), NEAR_MM)
    if near is None or corner is None or beyond is None:
        return False
    change = part = 0.0
    for axis, *places in zip(environment.axes, near, corner, beyond, strict=True):
        limit = axis.dynamics.feed_acceleration
        if before.limits_jerk:
            limit = axis.dynamics.jerk_slope.jerk or axis.dynamics.smooth_accelerations[1]
        out, on = places[1] - places[0], places[2] - places[1]
        change = max(change, abs(on - out) / limit)
        part = max(part, abs(out) / limit, abs(on) / limit)
    return change <= (FASTER_WITH_JERK if before.limits_jerk else FASTER) * part
