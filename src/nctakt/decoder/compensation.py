# SPDX-License-Identifier: MIT
"""Tool radius compensation: contours of the program -> paths of the tool's centre (MO-9).

A stage after the decoder: commands in, commands out. Between G41 or G42 and the motion with which
G40 leaves the contour, a motion in the plane is held until the next one determines its end
(``tool_path.py``); commands in between stay after it. With contour masking (G141), and with the
detection of contour damage (P-CHAN-00219), as many motions are held as a loop of the path may span.
Other held commands are bounded by ``MAX_BETWEEN``.

The first motion in the plane approaches the contour, the one after G40 leaves it: as straight lines
that are not shifted themselves (G138, G139), with additional motions (G237), or not at all, so that
the contour ends at the tool's position (G239). A closed contour that begins in an inner corner
(G238) is held as a whole, because its last motion determines where both ends meet.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Generator, Iterator
from dataclasses import replace
from functools import cached_property
from typing import NoReturn

from nctakt.base.diagnostics import Span
from nctakt.decoder import tilted_motions
from nctakt.decoder.blocks.path.path_motion import PathMotion
from nctakt.decoder.contour import rows as contour_rows
from nctakt.decoder.contour.tool_path import ToolPath
from nctakt.decoder.fast.compensated_lines import CompensatedLines
from nctakt.decoder.fast.handover import PlainRun
from nctakt.decoder.pending_motion import (
    PendingMotion,
    at_tool,
    plain_span,
    segments_of,
)
from nctakt.decoder.state.environment import DecodeError
from nctakt.decoder.state.geometry.arcs import SAME_POINT_MM
from nctakt.decoder.state.queued.commands import (
    Answer,
    Command,
    DecoderWait,
    ProgramEnd,
    Segment,
    waits,
)
from nctakt.decoder.state.queued.packing import takes_time
from nctakt.decoder.values.variables import Values
from nctakt.messages import diagnostic
from nctakt.messages.path.tools import (
    ARC_REVERSED_BY_RADIUS,
    CLOSED_CONTOUR_TOO_LONG,
    COMPENSATION_NEEDS_LINE,
    CONTOUR_NOT_CLOSED,
    LEAD_CUTS_CONTOUR,
    LEAD_WOULD_CUT_CONTOUR,
    LINE_REVERSED_BY_RADIUS,
    RADIUS_CHANGE_IN_ARC,
    RADIUS_CHANGE_WITH_G238,
    SIDE_CHANGE_WITH_G238,
    TOO_MANY_COMMANDS_IN_CONTOUR,
    TOOL_CUTS_CONTOUR,
    TOOL_CUTS_INNER_CORNER,
    TOOL_TOO_LARGE_FOR_ARC,
    TOOL_WOULD_CUT_CONTOUR,
    TOOL_WOULD_CUT_INNER_CORNER,
)
from nctakt.nc.vocabulary.functions import (
    APPROACH_INNER_CORNER,
    APPROACH_PERPENDICULAR,
    DEPART_WITHOUT_MOTION,
)

#: Maximum number of other commands between the held motions.
MAX_BETWEEN = 1000

#: Maximum number of motions in a contour with G238, all of which are held.
MAX_CLOSED = 200

#: A piece of the tool path: start, end, kind, centre, angle (``ToolPath.taken``).
_Piece = tuple[float, ...]


class Compensation:
    """Compensates one program; ``pass_time`` is called for held commands as if executed."""

    def __init__(
        self, values: Values, path: PathMotion, pass_time: Callable[[Command], None]
    ) -> None:
        self._values = values
        self._environment = values.environment
        self._path = path
        self._state = values.state.path
        self._pass_time = pass_time
        self._motions: deque[PendingMotion] = deque()
        self._spans: deque[tuple[int, Span]] = deque(maxlen=2 * contour_rows.REACH + 2)
        self._between = 0
        self._distance = 0.0
        self._at: tuple[float, float] | None = None
        self.is_releasing = False

    @cached_property
    def tool(self) -> ToolPath:
        """The path of the tool's centre, made for the first contour."""
        return ToolPath()

    @property
    def is_idle(self) -> bool:
        """Whether no motion is held."""
        return not self._motions

    def compensate(self, commands: Generator[Command, Answer]) -> Generator[Command, Answer]:
        """Yield the commands of a program with its contours compensated; raises ``DecodeError``."""
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
                if not self._motions and not isinstance(command, Segment):
                    answer = yield command
                    continue
                try:
                    answer = yield from self._take(command)
                except DecodeError:
                    yield from self._stop()
                    raise
        finally:
            commands.close()

    def _take(self, command: Command) -> Generator[Command, Answer, Answer]:
        """Process one command of the program; return its answer."""
        is_active = self._state.compensation.is_active
        if isinstance(command, Segment) and is_active and command.curve is None:
            yield from self._segment(command)
            return None
        if self._motions and not isinstance(command, Segment | PlainRun | DecoderWait):
            if not waits(command) and not isinstance(command, ProgramEnd):
                self._hold(command)
                return None
            yield from self._finish()
        if isinstance(command, Segment) and command.tilt is not None:
            yield from self._at_once(command)
            return None
        return (yield command)

    def _segment(self, segment: Segment) -> Iterator[Command]:
        """Process a motion: in the plane as part of the contour, else unchanged in its order."""
        segment = tilted_motions.into_plane(segment, self._environment, self._state.plane)
        first, second = self._state.plane_axes
        x, y = segment.start[first], segment.start[second]
        x_2, y_2 = segment.target[first], segment.target[second]
        if segment.arc is None and max(abs(x - x_2), abs(y - y_2)) <= SAME_POINT_MM:
            yield from self._beside_plane(segment)
            return
        compensation = self._state.compensation
        distance = compensation.side * compensation.radius
        if distance != self._distance and compensation.approach in (
            APPROACH_PERPENDICULAR,
            DEPART_WITHOUT_MOTION,
        ):
            yield from self._leave(distance)
            if distance == 0.0:
                yield from self._at_once(segment)
                return
        if self._is_closed_one and distance != self._distance:
            if distance != 0.0:
                keeps_side = distance * self._distance > 0.0
                message = RADIUS_CHANGE_WITH_G238 if keeps_side else SIDE_CHANGE_WITH_G238
                self._values.fail(message, self._path.span)
            yield from self._finish()
        self._pass_time(segment)
        self._enter(segment, (x, y, x_2, y_2), distance)
        compensation.has_left_path = True
        tool = self.tool
        is_tangential = compensation.is_tangential or (
            tool.is_open and self._motions[-1].tangent is not None
        )
        tool.set_corners(compensation.by_arc, compensation.is_direct or is_tangential)
        if not tool.is_open:
            at = (x, y) if self._at is None else self._at
            self._at = at
            tool.begin(
                *at,
                self._distance == 0.0 and compensation.approach == APPROACH_PERPENDICULAR,
            )
        elif not tool.add():
            self._fail(self._motions.pop())
        before, self._distance = self._distance, distance
        self._keep(segment, before)
        if tool.crossed:
            self._report_crossing()
        if not self._is_closed_one:
            yield from self._release(contour_rows.REACH if self._waits_for_loops else 0)
        elif len(self._motions) > MAX_CLOSED:
            self._values.fail(CLOSED_CONTOUR_TOO_LONG, self._path.span, count=MAX_CLOSED)
        compensation.end = tool.beside_end()
        if distance == 0.0:
            yield from self._finish()
            self._left()

    def _beside_plane(self, segment: Segment) -> Iterator[Command]:
        """Process a motion of axes outside the plane."""
        if not self._motions and self._at is None:
            yield from self._at_once(segment)
        elif self._moves_others(segment):
            self.tool.parts = True
            if self._motions:
                self._hold(segment)
            else:
                yield from self._at_once(at_tool(segment, self._state.plane_axes, self._at))

    def _at_once(self, command: Command) -> Iterator[Command]:
        """Yield a motion that is not held; one of a tilted plane as the axes make it."""
        if not isinstance(command, Segment) or command.tilt is None:
            yield command
            return
        self._pass_time(command)
        self.is_releasing = True
        yield from tilted_motions.out_of_plane(command, self._environment)
        self.is_releasing = False

    def _enter(self, segment: Segment, ends: tuple[float, float, float, float], d: float) -> None:
        """Pass the line or arc of a motion and its distance ``d`` (mm) to the tool path."""
        tool, before = self.tool, self._distance
        compensation = self._state.compensation
        tool.side = 1.0 if (d or before) > 0.0 else -1.0
        tool.masks = compensation.masks
        is_feed = segment.is_feed
        if segment.arc is None:
            compared = contour_rows.OF_CONTOUR if is_feed else contour_rows.NO_CONTOUR
            if d == before:
                tool.line(*ends, d, d, compared)
            elif d * before > 0.0:
                tool.line(*ends, before, d, compared)
            elif compensation.approach == APPROACH_PERPENDICULAR:
                tool.line(*ends, d, d, compared)
            else:
                leads = contour_rows.LEADS if is_feed else contour_rows.NO_CONTOUR
                tool.line(*ends, 0.0, 0.0, leads)
            return
        if d * before > 0.0 and d != before:
            self._values.fail(RADIUS_CHANGE_IN_ARC, self._path.span)
        if d != before and compensation.approach != APPROACH_PERPENDICULAR:
            change = compensation.change_from(before)
            self._values.fail(COMPENSATION_NEEDS_LINE, self._path.span, change=change)
        if not tool.arc(*ends, d, *segment.arc[2:]) and not tool.masks:
            self._values.fail(TOOL_TOO_LARGE_FOR_ARC, self._path.span, radius=abs(d))

    def _keep(self, segment: Segment, before: float) -> None:
        """Hold the motion until the next one arrives; ``before``: the distance before it."""
        number, compensation = self.tool.number, self._state.compensation
        misfit = LINE_REVERSED_BY_RADIUS if segment.arc is None else ARC_REVERSED_BY_RADIUS
        if segment.arc is not None and not self.tool.last_motion_fits():
            misfit = TOOL_TOO_LARGE_FOR_ARC
        motion = PendingMotion(
            number,
            segment,
            self._path.span,
            compensation.radius,
            misfit,
            self._values.state.feed.block_time_s,
            compensation.adapts_feed,
            compensation.take_tangent(segment, self._state.plane_axes, before, self._distance),
        )
        self._motions.append(motion)
        self._spans.append((number, self._path.span))

    @property
    def _is_closed_one(self) -> bool:
        """Whether a closed contour that begins in an inner corner is active (G238)."""
        return self._state.compensation.mode == APPROACH_INNER_CORNER and self._distance != 0.0

    @property
    def _waits_for_loops(self) -> bool:
        """Whether motions are held as long as a loop of the path may still close."""
        return self._state.compensation.masks or self._environment.parameters.looks_for_damage

    def _hold(self, command: Command) -> None:
        if self._between >= MAX_BETWEEN:
            self._values.fail(TOO_MANY_COMMANDS_IN_CONTOUR, self._path.span, count=MAX_BETWEEN)
        self._between += 1
        self._motions[-1].between.append(command)
        if takes_time(command):
            self._pass_time(command)

    def _moves_others(self, segment: Segment) -> bool:
        """Return whether axes outside the plane move."""
        plane = self._state.plane_axes
        axes = range(len(segment.start))
        return any(
            segment.start[axis] != segment.target[axis] for axis in axes if axis not in plane
        )

    # --- the contour ends ------------------------------------------------------------------------

    def _leave(self, distance: float) -> Iterator[Command]:
        """Leave an active contour without a motion of the program."""
        is_perpendicular = self._state.compensation.mode == APPROACH_PERPENDICULAR
        if self._distance == 0.0 or (distance != 0.0 and not is_perpendicular):
            return
        if distance * self._distance > 0.0:
            return
        yield from self._finish()
        self._left()

    def _left(self) -> None:
        """Reset to the programmed path."""
        self._state.compensation.has_left_path = False
        self._distance = 0.0
        self._at = None

    def _finish(self) -> Iterator[Command]:
        """Release all held motions; no further motion joins the last one."""
        tool, compensation = self.tool, self._state.compensation
        side = 1.0 if self._distance > 0.0 else -1.0
        is_left = compensation.side * compensation.radius * side <= 0.0
        failed = None
        if tool.is_open and self._is_closed_one:
            self._enclose()
        elif tool.is_open and not tool.close(
            self._distance != 0.0 and is_left and compensation.mode == APPROACH_PERPENDICULAR
        ):
            failed = self._motions.pop()
        if tool.crossed and failed is None:
            self._report_crossing()
        yield from self._release(0)
        if failed is not None:
            self._fail(failed)

    def _enclose(self) -> None:
        """Close the contour of G238: its end is its start."""
        tool, first, last = self.tool, self._motions[0].segment, self._motions[-1]
        if tool.number == tool.first:
            tool.close(False)
            return
        if any(
            abs(first.target[axis] - last.segment.target[axis]) > SAME_POINT_MM
            for axis in self._state.plane_axes
        ):
            self._values.fail(CONTOUR_NOT_CLOSED, last.span)
        misfit = tool.enclose()
        for motion in self._motions:
            if motion.number == misfit:
                self._fail(motion)

    def _stop(self) -> Iterator[Command]:
        """Run the contour up to a mistake; a contour of G238 is discarded."""
        if self._is_closed_one:
            self._motions.clear()
            self.tool.give_up()
        yield from self._finish()

    def _fail(self, motion: PendingMotion) -> NoReturn:
        """Report that the tool cannot follow the contour (90019, 90038, 90017)."""
        self._values.fail(motion.misfit, motion.span, radius=abs(motion.radius))

    def _report_crossing(self) -> None:
        """Report contour damage: a warning, or an error as P-CHAN-00219 demands."""
        tool, spans = self.tool, dict(self._spans)
        closes = tool.closes_contour()
        crossed, tool.crossed = tool.crossed, 0
        span, other = spans[tool.crossing], spans[crossed]
        warning, error = TOOL_CUTS_CONTOUR, TOOL_WOULD_CUT_CONTOUR
        if closes:
            warning, error = TOOL_CUTS_INNER_CORNER, TOOL_WOULD_CUT_INNER_CORNER
        elif tool.crosses_lead:
            warning, error = LEAD_CUTS_CONTOUR, LEAD_WOULD_CUT_CONTOUR
            if crossed == tool.first:
                span, other = other, span
        line = other.line
        if self._environment.parameters.looks_for_damage:
            while self._motions and self._motions[-1].number >= crossed:
                self._motions.pop()
            tool.give_up()
            self._values.fail(error, span, line=line)
        text = self._environment.line_text(span)
        self._environment.warn(diagnostic(warning, span, text, line=line))

    # --- plain blocks ----------------------------------------------------------------------------

    def can_export(self) -> bool:
        """Return whether plain blocks may continue the contour (``compensated_lines.py``).

        That needs exactly one held line with nothing after it, whose end depends on the next
        motion only.
        """
        compensation = self._state.compensation
        if not compensation.is_active:
            return True
        if self._waits_for_loops or compensation.mode == APPROACH_INNER_CORNER:
            return False
        if compensation.is_tangential:
            return False
        if compensation.side * compensation.radius != self._distance:
            return False
        if len(self._motions) != 1 or not self.tool.is_open:
            return False
        held = self._motions[0].segment
        return (
            not self._motions[0].between
            and self._motions[0].tangent is None
            and held.arc is None
            and held.modifiers is None
            and self._motions[0].time_s == 0.0
            and held.limits_jerk == self._state.limits_jerk
            and held.deviation == (0.0 if held.exact_stop else self._deviation)
        )

    @property
    def _deviation(self) -> float:
        """The permitted deviation at the end of a line, mm."""
        return self._state.rounding

    def export_to(self, lines: CompensatedLines) -> None:
        """Export the pending contour, if there is one."""
        compensation = self._state.compensation
        lines.is_on = compensation.is_active
        if not lines.is_on:
            return
        held = self._motions[0].segment
        lines.first, lines.second = self._state.plane_axes
        lines.distance = self._distance
        lines.source, lines.number = held.source, held.number
        for axis, (start, target) in enumerate(zip(held.start, held.target, strict=True)):
            lines.set_motion(axis, start, target)
        lines.motion, lines.feed_v = held.motion, held.feed
        lines.stops = held.exact_stop
        lines.deviation = self._deviation
        lines.limits_jerk = self._state.limits_jerk
        self.tool.side = 1.0 if self._distance > 0.0 else -1.0
        self.tool.set_corners(compensation.by_arc, compensation.is_direct)

    def import_from(self, lines: CompensatedLines, file: str) -> None:
        """Import the pending contour after plain blocks of the text ``file``."""
        before, number = self._motions[0], self.tool.number
        if number == before.number:
            return
        for passed in range(max(before.number + 1, number - contour_rows.REACH), number):
            span = plain_span(lines.source_of(passed), file, self._environment.line_text)
            self._spans.append((passed, span))
        motions = [lines.motion_of(axis) for axis in range(lines.count)]
        segment = replace(
            before.segment,
            source=lines.source,
            number=lines.number,
            start=tuple(start for start, _ in motions),
            target=tuple(target for _, target in motions),
            motion=lines.motion,
            feed=lines.feed_v,
            exact_stop=lines.stops,
            deviation=0.0 if lines.stops else lines.deviation,
            limits_jerk=lines.limits_jerk,
        )
        span = plain_span(lines.source, file, self._environment.line_text)
        self._spans.append((number, span))
        self._motions[0] = replace(
            before,
            number=number,
            segment=segment,
            span=span,
            misfit=LINE_REVERSED_BY_RADIUS,
            between=[],
        )
        self._at = (self.tool.at_x, self.tool.at_y)
        self._state.compensation.end = self.tool.beside_end()

    # --- commands out ----------------------------------------------------------------------------

    def _release(self, kept: int) -> Iterator[Command]:
        """Yield the motions with known ends, except for the last ``kept`` ones."""
        last = self.tool.number - self.tool.is_open - kept
        while self._motions and self._motions[0].number <= last:
            motion = self._motions.popleft()
            self._between -= len(motion.between)
            try:
                commands = self._commands(motion)
                if self.tool.crossed:
                    self._report_crossing()
            except DecodeError:
                self._motions.clear()  # commands after a mistake are not run
                self.tool.give_up()
                raise
            self.is_releasing = True
            yield from commands
            self.is_releasing = False

    def _commands(self, motion: PendingMotion) -> list[Command]:
        """Return the pieces of a motion and the commands after it."""
        plane = self._state.plane_axes
        pieces = self._pieces(motion)
        commands: list[Command] = list(
            segments_of(motion, pieces, self._environment.axes, plane, self._path.check_piece)
        )
        commands += [at_tool(command, plane, self._at) for command in motion.between]
        if motion.segment.tilt is None:
            return commands
        return tilted_motions.all_out_of_plane(commands, self._environment)

    def _pieces(self, motion: PendingMotion) -> list[tuple[_Piece, float]]:
        """Return the pieces of a motion with their lengths in mm; empty if it is masked."""
        pieces = []
        while (shape := self.tool.take(motion.number)) != contour_rows.NOTHING:
            if shape == contour_rows.GAP:
                self._fail(motion)
            piece, length = self.tool.taken(), self.tool.taken_length()
            if motion.tangent is not None and shape == contour_rows.LINE:
                piece, length = motion.tangent.arc(piece)
            pieces.append((piece, length))
            self._at = (piece[2], piece[3])
        if not pieces and self._moves_others(motion.segment):
            assert self._at is not None
            pieces.append(((*self._at, *self._at, 0.0), 0.0))
        return pieces
