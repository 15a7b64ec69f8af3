# SPDX-License-Identifier: MIT
"""G20 … G23, G351, G68, G69, ``#ROTATION``, ``#SCALE`` -> the map of programmed coordinates.

In: words of a block or a command. Out: changes of ``ContourFrame``. Mistakes raise ``DecodeError``.
"""

from __future__ import annotations

from collections.abc import Generator, Mapping

from nctakt.base.diagnostics import Span
from nctakt.decoder.blocks.block_content import BlockContent
from nctakt.decoder.blocks.diameters import radius_of
from nctakt.decoder.state.geometry.arcs import PLANES
from nctakt.decoder.state.queued.commands import Answer, Command
from nctakt.decoder.values.variables import Values
from nctakt.messages.path.frames import (
    FRAME_DURING_COMPENSATION,
    INVALID_MIRROR_VALUE,
    INVALID_SCALE_FACTOR,
    NOT_AN_AXIS_OF_THE_PLANE,
    ROTATION_ENDED_BY_PLANE,
    SCALE_IS_ON,
)
from nctakt.messages.path.motion import PLANE_AXIS_MISSING
from nctakt.nc import tree
from nctakt.nc.meaning.path import MIRROR_VALUES, keywords
from nctakt.nc.vocabulary.functions import (
    MIRRORED_BY_PLANE,
    MIRRORING_OF_AXES,
    ROTATION_OFF,
    ROTATION_ON,
)


class FrameCommands:
    """The commands of one program."""

    def __init__(self, values: Values) -> None:
        self._values = values
        self._environment = values.environment
        self._state = values.state
        self._frame = values.state.frame

    # --- words of a block -----------------------------------------------------------------------

    def words(self, numbers: Mapping[int, Span], content: BlockContent) -> None:
        """Take the functions of a block; axis words of G351 and G68 are no targets."""
        for function, span in numbers.items():
            if function in MIRRORED_BY_PLANE:
                self._keep_contour(f"G{function}", span)
                plane = self._state.path.plane_axes
                chosen = MIRRORED_BY_PLANE[function]
                self._frame.mirrored = frozenset(plane[index] for index in chosen)
            elif function == MIRRORING_OF_AXES:
                self._mirror_axes(content, span)
            elif function == ROTATION_ON:
                self._rotate_about(content, span)
            elif function == ROTATION_OFF:
                self._keep_contour("G69", span)
                self._frame.is_turned = False

    def _mirror_axes(self, content: BlockContent, span: Span) -> None:
        """Process G351: -1 mirrors an axis, 1 ends it."""
        self._keep_contour("G351", span)
        mirrored = set(self._frame.mirrored)
        for word, value in content.axes:
            if value not in MIRROR_VALUES:
                self._values.fail(INVALID_MIRROR_VALUE, word.span, axis=word.name, value=value)
            axis = self._environment.axis_numbers[word.name]
            mirrored.discard(axis)
            if value < 0.0:
                mirrored.add(axis)
        self._frame.mirrored = frozenset(mirrored)
        content.axes = []

    def _rotate_about(self, content: BlockContent, span: Span) -> None:
        """Process G68: about the programmed centre, else about where the axes are."""
        self._keep_contour("G68", span)
        self._check_plane(span)
        frame, plane = self._frame, self._state.path.plane_axes
        centre = self.unmirrored()
        for word, value in content.axes:
            axis = self._environment.axis_numbers[word.name]
            if axis not in plane:
                self._values.fail(
                    NOT_AN_AXIS_OF_THE_PLANE,
                    word.span,
                    axis=word.name,
                    plane=self._state.path.plane,
                )
            position = value * self._state.length_unit_mm
            centre[axis] = radius_of(self._values, axis, position, is_absolute=True)
        content.axes = []
        frame.axes = plane
        frame.centre = (centre[plane[0]], centre[plane[1]])
        frame.angle_deg = content.angle_deg
        frame.is_turned = True

    def unmirrored(self) -> list[float]:
        """Return the coordinates of the axes before mirroring, without offsets."""
        offsets = self._environment.offsets
        inside = offsets.inside(self._state.positions)
        return self._frame.unmirrored(
            [value - offsets.total(axis) for axis, value in enumerate(inside)]
        )

    def leave_plane(self, function: int, span: Span) -> None:
        """End a rotation where another plane is selected, with a warning."""
        if self._frame.is_turned and PLANES[function] != self._frame.axes:
            self._frame.is_turned = False
            self._values.warn(ROTATION_ENDED_BY_PLANE, span, plane=function)

    def _keep_contour(self, word: str, span: Span) -> None:
        """Raise ``DecodeError`` for a change during tool radius compensation."""
        compensation = self._state.path.compensation
        if compensation.is_active:
            self._values.fail(
                FRAME_DURING_COMPENSATION, span, word=word, compensation=compensation.word
            )

    def _check_plane(self, span: Span) -> None:
        """Raise ``DecodeError`` where the channel lacks an axis of the plane."""
        path = self._state.path
        if self._environment.places.lacks_any(path.plane_axes):
            self._values.fail(PLANE_AXIS_MISSING, span, plane=path.plane)

    # --- commands -------------------------------------------------------------------------------

    def rotation(self, command: tree.HashCommand, number: int) -> Generator[Command, Answer]:
        """Execute ``#ROTATION``; values that it does not name keep their last setting."""
        switch = command.words[1].name
        self._keep_contour(f"#ROTATION {switch}", command.span)
        frame = self._frame
        angle, centre = frame.angle_deg, list(frame.centre)
        for keyword in keywords(command):
            assert keyword.value is not None
            value = yield from self._values.evaluate(keyword.value, number)
            if keyword.name == "ANGLE":
                angle = value
            else:
                centre[int(keyword.name[-1]) - 1] = value * self._state.length_unit_mm
        frame.angle_deg, frame.centre = angle, (centre[0], centre[1])
        frame.axes = self._state.path.plane_axes
        frame.is_turned = switch == "ON"
        if frame.is_turned:
            self._check_plane(command.span)

    def scale(self, command: tree.OffsetCommand, number: int) -> Generator[Command, Answer]:
        """Execute ``#SCALE [ON] X2``: define factors, switch them on, or both."""
        self._keep_contour(f"#{command.name}", command.span)
        frame = self._frame
        if frame.is_scaled:
            self._values.fail(SCALE_IS_ON, command.span)
        factors = dict(frame.factors)
        for word in command.words:
            assert isinstance(word, tree.AxisWord)
            assert word.value is not None
            value = yield from self._values.evaluate(word.value, number)
            if value <= 0.0:
                self._values.fail(INVALID_SCALE_FACTOR, word.span, axis=word.name, value=value)
            factors[self._environment.axis_numbers[word.name]] = value
        frame.factors = factors
        frame.is_scaled = command.name == "SCALE ON"

    def end_scaling(self, command: tree.HashCommand) -> None:
        """Execute ``#SCALE OFF``; the factors stay for the next ``#SCALE ON``."""
        self._keep_contour("#SCALE OFF", command.span)
        self._frame.is_scaled = False
