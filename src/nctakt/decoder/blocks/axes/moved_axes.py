# SPDX-License-Identifier: MIT
"""The axes that a block or a command moves, and their positions if those are uncertain (RC-409)."""

from __future__ import annotations

from collections.abc import Generator, Sequence

from nctakt.base.diagnostics import Span
from nctakt.decoder.blocks.block_content import BlockContent
from nctakt.decoder.state.geometry.coordinate_systems import MAIN_AXES
from nctakt.decoder.state.queued.commands import Answer, Command, PositionRequest, Segment
from nctakt.decoder.state.uncertain_axes import UncertainAxes
from nctakt.decoder.values.variables import Values
from nctakt.nc.vocabulary.functions import ARC_IN_SPACE, ARCS


class MovedAxes:
    """The moved axes of one program."""

    def __init__(self, values: Values, uncertain_axes: UncertainAxes) -> None:
        self._uncertain_axes = uncertain_axes
        self._values = values
        self._environment = values.environment
        self._state = values.state

    def programmed(self, content: BlockContent) -> list[str]:
        """Return the names of the axes of the block; an arc moves both axes of its plane."""
        names = [word.name for word, _ in content.axes]
        if self._state.motion in ARCS:
            plane = self._state.path.plane_axes
            for name, axis in self._environment.axis_numbers.items():
                if axis in plane and name not in names:
                    names.append(name)
        if self._state.motion == ARC_IN_SPACE:
            main = list(self._environment.axis_numbers)[:MAIN_AXES]
            names += [name for name in main if name not in names]
        if self._state.frame.is_turned:
            names = self._with_turned(names)
        if self._environment.offsets.systems.is_active:
            main = list(self._environment.axis_numbers)[:MAIN_AXES]
            names += [name for name in main if name not in names]
        return self._environment.offsets.transformation.with_moved(names)

    def is_along_axes(self) -> bool:
        """Return whether each word of a block moves only its own axis, along a line."""
        offsets = self._environment.offsets
        is_line = self._state.motion not in ARCS and self._state.motion != ARC_IN_SPACE
        is_bent = self._state.frame.is_active or offsets.systems.is_active
        return is_line and not is_bent and not offsets.transformation.is_active

    def _with_turned(self, names: list[str]) -> list[str]:
        """Return these axes with those that a rotation of the contour moves as well."""
        numbers, frame = self._environment.axis_numbers, self._state.frame
        moved = {axis for name in names for axis in frame.moved_with(numbers[name])}
        return names + [name for name in numbers if numbers[name] in moved and name not in names]

    def request(self, axes: Sequence[str], span: Span, number: int) -> Generator[Command, Answer]:
        """Request the positions of those of these axes that cycles may have moved (RC-409)."""
        uncertain = self._uncertain_axes.uncertain(axes)
        if not uncertain:
            return
        self._values.check_flush_allowed(", ".join(uncertain), span)
        source = self._environment.source_id(span)
        indices = [self._environment.axis_numbers[name] for name in uncertain]
        if self._environment.offsets.transformation.is_active:
            indices = list(range(len(self._state.positions)))
        numbers = (self._environment.names.axis(name) for name in uncertain)
        answer = yield PositionRequest(
            source, number, tuple(axis.number for axis in numbers if axis is not None)
        )
        assert isinstance(answer, tuple)
        for index in indices:
            self._state.positions[index] = answer[index]
        self._uncertain_axes.confirm(uncertain)

    def axes_moved_by(self, command: Command) -> list[str]:
        """Return the names of the axes that a command moves with the path."""
        if not isinstance(command, Segment):
            return []
        plane = () if command.arc is None else command.arc[:2]
        numbers = self._environment.axis_numbers
        start, target = command.start, command.target
        if command.curve is not None or command.tilt is not None:
            return self._environment.offsets.transformation.with_moved(list(numbers))
        names = [n for n, axis in numbers.items() if start[axis] != target[axis] or axis in plane]
        return self._environment.offsets.transformation.with_moved(names)
