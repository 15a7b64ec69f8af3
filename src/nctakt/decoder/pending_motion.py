# SPDX-License-Identifier: MIT
"""A motion of a contour, held until the next one determines its end (MO-9)."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Message, Span
from nctakt.base.source_ids import NO_SOURCE, unpack
from nctakt.decoder.contour import rows
from nctakt.decoder.state.geometry.arcs import Arc
from nctakt.decoder.state.geometry.coordinate_systems import Matrix
from nctakt.decoder.state.geometry.tangential_arc import Tangent
from nctakt.decoder.state.queued.commands import Command, Segment
from nctakt.kernel.base import arithmetic
from nctakt.lists.machine.axis_configuration import AxisConfiguration

#: The check of the axes' limits on a piece of a motion.
CheckPiece = Callable[
    [list[float], list[float], Arc | None, tuple[int, int], Span, Matrix | None], None
]

_COMMENT = re.compile(r"[;(].*")


@dataclass(slots=True)
class PendingMotion:
    """A motion in the plane and the commands after it.

    ``radius``: of the tool, mm; ``misfit``: the message if the tool does not fit. ``time_s``: the
    duration of its block under G93, 0 without. ``adapts``: F applies to the contour (G11).
    ``tangent``: it leads to the contour, or from it, in an arc (G05).
    """

    number: int
    segment: Segment
    span: Span
    radius: float
    misfit: Message
    time_s: float
    adapts: bool
    tangent: Tangent | None = None
    between: list[Command] = field(default_factory=list)


def share_of_contour(segment: Segment, arc: tuple[float, ...], start: list[float]) -> float:
    """Return the ratio of the tool centre's speed on an arc to the speed along the contour (G11).

    1 on an arc that the program does not contain.
    """
    if segment.arc is None or segment.arc[2:4] != arc[2:4]:
        return 1.0
    first, second = int(arc[0]), int(arc[1])
    radii = []
    for point in (start, segment.start):
        x, y = point[first] - arc[2], point[second] - arc[3]
        radii.append(arithmetic.square_root(x * x + y * y))
    return radii[0] / radii[1]


def at_tool(
    command: Command, plane: tuple[int, int], position: tuple[float, float] | None
) -> Command:
    """Return a motion of other axes with those of the plane where the tool is; else the command."""
    if position is None or not isinstance(command, Segment):
        return command
    start, target = list(command.start), list(command.target)
    for axis, value in zip(plane, position, strict=True):
        start[axis] = target[axis] = value
    return replace(command, start=tuple(start), target=tuple(target))


def block_length(
    segment: Segment,
    lengths: Sequence[float],
    axes: Sequence[AxisConfiguration],
    plane: tuple[int, int],
) -> float:
    """Return the length of a block with all its pieces, mm; ``lengths``: those in the plane.

    Axes outside the plane move on the first piece.
    """
    first2 = lengths[0] * lengths[0]
    for index, axis in enumerate(axes):
        if axis.is_linear and index not in plane:
            rise = segment.target[index] - segment.start[index]
            first2 += rise * rise
    return arithmetic.square_root(first2) + sum(lengths[1:])


def segments_of(
    motion: PendingMotion,
    pieces: list[tuple[tuple[float, ...], float]],
    axes: Sequence[AxisConfiguration],
    plane: tuple[int, int],
    check: CheckPiece,
) -> Iterator[Segment]:
    """Yield the pieces of a motion, with their lengths, as segments; only the last one stops
    exactly.

    ``check`` is called for each of them.
    """
    first, second = plane
    segment = motion.segment
    turn = None if segment.tilt is None else segment.tilt.matrix
    if motion.time_s > 0.0 and segment.is_feed and pieces:
        lengths = [length for _, length in pieces]
        length = block_length(segment, lengths, axes, plane)
        segment = replace(segment, feed=length / motion.time_s)
    for number, (piece, _) in enumerate(pieces):
        is_last = number == len(pieces) - 1
        start = list(segment.start if number == 0 else segment.target)
        target = list(segment.target)
        start[first], start[second] = piece[:2]
        target[first], target[second] = piece[2:4]
        row = arc = None
        feed = segment.feed
        if piece[rows.SHAPE] == rows.ARC:
            arc = Arc(first, second, *piece[5:8])
            row = arc.row
            if motion.adapts and segment.is_feed and motion.time_s == 0.0:
                feed *= share_of_contour(segment, row, start)
        check(start, target, arc, plane, motion.span, turn)
        yield replace(
            segment,
            start=tuple(start),
            target=tuple(target),
            feed=feed,
            exact_stop=segment.exact_stop and is_last,
            arc=row,
            continues_block=not is_last,
        )


def plain_span(source: int, file: str, line_text: Callable[[Span], str]) -> Span:
    """Return the span of a plain block up to the end of its line, without a comment."""
    if source == NO_SOURCE:
        return Span(file, 1, 1, 2)
    _, line, column = unpack(source)
    text = line_text(Span(file, line, column, column + 1))
    return Span(file, line, column, len(_COMMENT.sub("", text).rstrip()) + 1)
