# SPDX-License-Identifier: MIT
"""``#ANG``: lines by their angle in the plane -> the axis words that are missing (MO-4).

A line has its angle and one axis of the plane in its block. Or two lines are in two blocks: the
first one has its angle only, the second one angle and target; they meet in one point. The angle
counts from the first axis of the plane, as it is programmed.
"""

from __future__ import annotations

from typing import NamedTuple

from nctakt.base.diagnostics import Span
from nctakt.decoder.blocks.block_content import BlockContent
from nctakt.decoder.blocks.diameters import radius_of
from nctakt.decoder.blocks.path.path_motion import PathMotion
from nctakt.decoder.blocks.targets import Targets
from nctakt.decoder.state.queued.shape_commands import InsertCorner
from nctakt.decoder.values.variables import Values
from nctakt.kernel.base import arithmetic
from nctakt.messages.path.contour_lines import (
    ANGLE_DURING_ARC,
    ANGLE_WITH_BOTH_AXES,
    ANGLES_ARE_PARALLEL,
    AXIS_NOT_REACHED_BY_ANGLE,
    CONTOUR_LINE_INCOMPLETE,
    SECOND_LINE_RELATIVE,
)
from nctakt.messages.path.shapes import CORNER_OFF
from nctakt.nc import tree
from nctakt.nc.meaning.path import ANGLE_WORD
from nctakt.nc.vocabulary.functions import ANY_ARCS

#: The sine of an angle between lines below which they count as parallel.
PARALLEL = 1e-9


class FirstLine(NamedTuple):
    """The first of two lines: its block, its angle in degrees, its motion and feed in mm/s."""

    content: BlockContent
    corner: InsertCorner | None
    span: Span
    number: int
    angle: float
    motion: int
    feed_mm_s: float


class ContourLines:
    """The lines of one program; ``first``: the one whose end follows from the next block."""

    def __init__(self, values: Values, targets: Targets, path: PathMotion) -> None:
        self._values = values
        self._environment = values.environment
        self._state = values.state
        self._targets = targets
        self._path = path
        self._angle: tuple[Span, float] | None = None
        self.first: FirstLine | None = None

    @property
    def is_concerned(self) -> bool:
        """Whether a block has to be completed, or ends the line before."""
        return self._angle is not None or self.first is not None

    def word(self, name: str, span: Span, value: float) -> bool:
        """Keep ``#ANG`` for ``complete``; return false for any other word."""
        if name != ANGLE_WORD:
            return False
        self._angle = (span, value)
        return True

    def complete(
        self, content: BlockContent, corner: InsertCorner | None, span: Span, number: int
    ) -> FirstLine | None:
        """Add the axis words that are missing; return the line before, which now has its end.

        Where the block is the first of two lines, it is kept as ``first``.
        """
        angle, self._angle = self._angle, None
        first, self.first = self.first, None
        self._state.shapes.open_line = None
        if angle is None or content.ends_program:
            assert first is not None or angle is not None
            self._values.fail(CONTOUR_LINE_INCOMPLETE, span if first is None else first.span)
        if not self._environment.parameters.allows_corners:
            self._values.fail(CORNER_OFF, angle[0], word=ANGLE_WORD)
        if self._state.motion in ANY_ARCS:
            self._values.fail(ANGLE_DURING_ARC, angle[0], function=self._state.motion)
        words = self._words(content)
        if first is not None:
            self._meet(first, content, words, *angle)
            return first
        if not words:
            state = self._state
            self.first = FirstLine(
                content, corner, span, number, angle[1], state.motion, state.feed_mm_s
            )
            state.shapes.open_line = span
        elif len(words) == 1:
            self._complete(content, words, *angle)
        else:
            self._values.fail(ANGLE_WITH_BOTH_AXES, angle[0])
        return None

    def _words(self, content: BlockContent) -> dict[int, float]:
        """Return where the block's axes of the plane go, as programmed in mm, by axis."""
        plane, start = self._state.path.plane_axes, self._programmed(content)
        positions = {}
        for word, value in content.axes:
            axis = self._environment.axis_numbers[word.name]
            if axis in plane:
                begin = 0.0 if self._state.absolute else start[axis]
                positions[axis] = begin + value * self._factor(axis)
        return positions

    def _complete(
        self, content: BlockContent, words: dict[int, float], span: Span, angle: float
    ) -> None:
        """Add the other axis of the plane to a single line."""
        first, second = self._state.path.plane_axes
        cosine, sine = arithmetic.cosine(angle), arithmetic.sine(angle)
        (given,) = words
        along, across = (cosine, sine) if given == first else (sine, cosine)
        start = self._programmed(content)
        if along == 0.0:
            name = self._name(given)
            self._values.fail(AXIS_NOT_REACHED_BY_ANGLE, span, axis=name, angle=angle)
        other = second if given == first else first
        distance = (words[given] - start[given]) / along * across
        self._add(content, other, start[other] + distance, span)

    def _meet(
        self,
        first: FirstLine,
        content: BlockContent,
        words: dict[int, float],
        span: Span,
        angle: float,
    ) -> None:
        """Set the end of the first line, from which the second line leads to its target."""
        if len(words) < 2:
            self._values.fail(CONTOUR_LINE_INCOMPLETE, first.span)
        if not self._state.absolute:
            self._values.fail(SECOND_LINE_RELATIVE, span)
        x, y = self._state.path.plane_axes
        between = arithmetic.sine(angle - first.angle)
        if abs(between) < PARALLEL:
            self._values.fail(ANGLES_ARE_PARALLEL, span, angle=angle, first=first.angle)
        start = self._programmed(first.content)
        dx, dy = words[x] - start[x], words[y] - start[y]
        length = (dx * arithmetic.sine(angle) - dy * arithmetic.cosine(angle)) / between
        for axis, part in (
            (x, arithmetic.cosine(first.angle)),
            (y, arithmetic.sine(first.angle)),
        ):
            self._add(first.content, axis, start[axis] + length * part, first.span)

    def _programmed(self, content: BlockContent) -> list[float]:
        """Return how the present positions would be programmed, in mm or degrees."""
        offsets, kinds = self._environment.offsets, content.path.offset_kinds
        inside = offsets.inside(self._state.positions, kinds)
        return self._state.frame.inside(
            [value - offsets.total(axis, kinds) for axis, value in enumerate(inside)]
        )

    def _factor(self, axis: int) -> float:
        """Return how far an axis goes by a word with the value 1, in mm."""
        travel = self._targets.in_axis_unit(axis, 1.0)
        return radius_of(self._values, axis, travel, is_absolute=self._state.absolute)

    def _add(self, content: BlockContent, axis: int, position: float, span: Span) -> None:
        """Add a word that leads an axis to a programmed position in mm."""
        if not self._state.absolute:
            position -= self._programmed(content)[axis]
        word = tree.AxisWord(span, self._name(axis), None)
        content.axes.append((word, position / self._factor(axis)))

    def _name(self, axis: int) -> str:
        return self._environment.places.name(axis)
