# SPDX-License-Identifier: MIT
"""Where a block ends: axis words -> positions of the axes (MO-8).

In: the words of a block with their values, the offsets and the map of the contour. Out: the
positions, inside the software limits. Mistakes raise ``DecodeError``.
"""

from __future__ import annotations

from collections.abc import Container, Iterable, Mapping, Sequence

from nctakt.base.diagnostics import Span
from nctakt.decoder.blocks.axes.coupled_axes import check_travel, check_words
from nctakt.decoder.blocks.block_content import BlockContent
from nctakt.decoder.blocks.diameters import radius_of
from nctakt.decoder.blocks.path.path_motion import CENTRE_WORDS, PathMotion
from nctakt.decoder.state.geometry.arcs import SAME_POINT_MM
from nctakt.decoder.state.geometry.coordinate_systems import MAIN_AXES
from nctakt.decoder.values.variables import Values
from nctakt.kernel import codes
from nctakt.nc.vocabulary.functions import ARC_IN_SPACE


class Targets:
    """The targets of one program's blocks."""

    def __init__(self, values: Values, path: PathMotion) -> None:
        self._values = values
        self._environment = values.environment
        self._state = values.state
        self._path = path

    def in_axis_unit(self, axis: int, value: float) -> float:
        """Return a programmed value in mm or degrees."""
        is_linear = self._environment.offsets.transformation.is_linear
        in_mm = is_linear(axis, self._environment.axes[axis])
        return value * self._state.length_unit_mm if in_mm else value

    def of(self, content: BlockContent, span: Span) -> list[float]:
        """Return the axis positions at the end of the block; keep the interim point of G303."""
        target = self._of(content, span)
        if self._state.motion == ARC_IN_SPACE:
            content.path.interim = self._interim_of(content)
        if self._values.state.couplings.places:
            check_words(self._values, content.programmed)
            check_travel(self._values, self._state.positions, target, span)
        return target

    def _of(self, content: BlockContent, span: Span) -> list[float]:
        offsets, kinds = self._environment.offsets, content.path.offset_kinds
        target = offsets.inside(self._state.positions, kinds)
        spans = {}
        for index, position in content.kept.items():
            target[index] = position + offsets.total(index, kinds)
        if self._state.frame.is_active:
            spans = self._mapped(target, content)
        else:
            is_inch = self._state.inch
            for word, value in content.axes:
                index = self._environment.axis_numbers[word.name]
                begin = offsets.total(index, kinds) if self._state.absolute else target[index]
                distance = self.in_axis_unit(index, value) if is_inch else value
                target[index] = begin + radius_of(
                    self._values, index, distance, is_absolute=self._state.absolute
                )
                spans[index] = word.span
        if content.kept:
            spans = dict.fromkeys(content.kept, span) | spans
        if offsets.systems.is_active:
            target = self._outside(target, spans, kinds)
            if any(index < MAIN_AXES for index in spans):
                spans = {index: span for index in range(MAIN_AXES)} | spans
        if not offsets.transformation.is_active:
            if content.measures and self._environment.parameters.measuring.shortens_travel:
                target = self._shortened(target, spans)
            for index, word_span in spans.items():
                self._path.check_limit(index, target[index], word_span)
        return target

    def _interim_of(self, content: BlockContent) -> tuple[float, ...]:
        """Return the point that an arc in space leads by: I, J, K as X, Y, Z of the block."""
        words = content.path.centre
        programmed = {
            index: words[name][1] for index, name in enumerate(CENTRE_WORDS) if name in words
        }
        is_absolute = self._state.absolute
        return tuple(self._point(programmed, content.path.offset_kinds, is_absolute=is_absolute))

    def positions_of(self, programmed: Mapping[int, float]) -> dict[int, float]:
        """Return the axis positions of an absolute point, of which these axes are programmed.

        If the program's coordinates are not those of the axes, all main axes are part of it.
        """
        positions = self._point(programmed, codes.ALL_OFFSETS, is_absolute=True)
        is_mapped = self._state.frame.is_active or self._environment.offsets.systems.is_active
        axes: Iterable[int] = range(MAIN_AXES) if is_mapped else programmed
        return {index: positions[index] for index in axes}

    def _point(
        self, programmed: Mapping[int, float], kinds: int, *, is_absolute: bool
    ) -> list[float]:
        """Return the axis positions of a point that has the others where they are."""
        offsets, frame = self._environment.offsets, self._state.frame
        target = offsets.inside(self._state.positions, kinds)
        totals = [offsets.total(index, kinds) for index in range(len(target))]
        values = frame.inside([value - total for value, total in zip(target, totals, strict=True)])
        for index, value in programmed.items():
            begin = 0.0 if is_absolute else values[index]
            distance = self.in_axis_unit(index, value)
            values[index] = begin + radius_of(
                self._values, index, distance, is_absolute=is_absolute
            )
        mapped = frame.outside(values)
        return offsets.outside([a + b for a, b in zip(mapped, totals, strict=True)], kinds)

    def _shortened(self, target: Sequence[float], axes: Iterable[int]) -> list[float]:
        """Return where a line to ``target`` comes to the first software limit of these axes."""
        start, part, bounds = self._state.positions, 1.0, {}
        for index in axes:
            axis, begin, end = self._environment.axes[index], start[index], target[index]
            low, high = self._state.software_limits.of(axis, index)
            if axis.is_modulo or not low <= begin <= high or low <= end <= high:
                continue
            bounds[index] = low if end < low else high
            part = min(part, (bounds[index] - begin) / (end - begin))
        pairs = enumerate(zip(start, target, strict=True))
        ends = [begin + part * (end - begin) for _, (begin, end) in pairs]
        for index, bound in bounds.items():
            is_beyond = ends[index] > bound if target[index] > bound else ends[index] < bound
            ends[index] = bound if is_beyond else ends[index]
        return ends

    def _mapped(self, target: list[float], content: BlockContent) -> dict[int, Span]:
        """Put programmed values into coordinates by way of the map of the contour.

        Returns the axes that may move, each with the word that moves it. Axes that only rounding
        would move keep their coordinates.
        """
        frame = self._state.frame
        totals = [
            self._environment.offsets.total(index, content.path.offset_kinds)
            for index in range(len(target))
        ]
        programmed = frame.inside(
            [value - total for value, total in zip(target, totals, strict=True)]
        )
        spans: dict[int, Span] = {}
        for word, value in content.axes:
            index = self._environment.axis_numbers[word.name]
            begin = 0.0 if self._state.absolute else programmed[index]
            programmed[index] = begin + radius_of(
                self._values,
                index,
                self.in_axis_unit(index, value),
                is_absolute=self._state.absolute,
            )
            for moved in frame.moved_with(index):
                spans.setdefault(moved, word.span)
            spans[index] = word.span
        mapped = frame.outside(programmed)
        for index in spans:
            value = mapped[index] + totals[index]
            if abs(value - target[index]) >= SAME_POINT_MM:
                target[index] = value
        return spans

    def _outside(self, target: list[float], programmed: Container[int], kinds: int) -> list[float]:
        """Return a target in the program's coordinate system as axis positions.

        Axes that only rounding would move keep their positions.
        """
        start = self._state.positions
        positions = self._environment.offsets.outside(target, kinds)
        turns = any(axis in programmed for axis in range(MAIN_AXES))
        for index, before in enumerate(start):
            moves = turns if index < MAIN_AXES else index in programmed
            if not moves or abs(positions[index] - before) < SAME_POINT_MM:
                positions[index] = before
        return positions
