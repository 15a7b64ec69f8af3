# SPDX-License-Identifier: MIT
"""G150, G151, ``#SPLINE``, ``#AKIMA`` -> where splines begin and end, and with which direction."""

from __future__ import annotations

from collections.abc import Generator, Iterator

from nctakt.base.diagnostics import Span
from nctakt.decoder.state.geometry.coordinate_systems import MAIN_AXES
from nctakt.decoder.state.queued.commands import Answer, Command
from nctakt.decoder.state.queued.shape_commands import (
    AKIMA,
    BSPLINE,
    TRANSITIONS,
    ReleaseMotions,
    SplineBegin,
    SplineEnd,
    Vector,
)
from nctakt.decoder.values.variables import Values
from nctakt.messages.path.splines import (
    INVALID_SPLINE_VECTOR,
    INVALID_TRANSITION,
    SPLINE_DURING_COMPENSATION,
    SPLINE_WITH_CONTOURING,
)
from nctakt.nc import tree
from nctakt.nc.meaning.path import SWITCHES, VECTORS, command_name, is_transition, transitions
from nctakt.nc.vocabulary.functions import SPLINE_ON


class SplineWords:
    """The words and commands of splines of one program."""

    def __init__(self, values: Values) -> None:
        self._values = values
        self._environment = values.environment
        self._state = values.state
        self._switch: bool | None = None
        self._vector = ""
        self.has_words = False

    def word(self, name: str) -> None:
        """Keep a word without a value for ``commands``."""
        self.has_words = True
        if name in SWITCHES:
            self._switch = SWITCHES[name]
        elif name in VECTORS:
            self._vector = name

    def switch(self, function: int, _span: Span) -> None:
        """Keep G150 or G151."""
        self.has_words = True
        self._switch = function == SPLINE_ON

    def commands(
        self, axes: list[tuple[tree.AxisWord, float]], span: Span, number: int
    ) -> Iterator[Command]:
        """Yield the spline commands of the block; removes the axis words of a direction."""
        self.has_words = False
        spline = self._state.shapes.spline
        if self._vector:
            vector = self._direction(axes, span)
            axes.clear()
            if VECTORS[self._vector]:
                spline.start_vector = vector
            else:
                spline.end_vector = vector
            self._vector = ""
        switch, self._switch = self._switch, None
        if switch is None or switch == spline.is_on:
            return
        source = self._environment.source_id(span)
        spline.is_on = switch
        if not switch:
            yield SplineEnd(source, number, span, spline.end, spline.end_vector)
            return
        path = self._state.path
        if path.compensation.is_active:
            self._values.fail(SPLINE_DURING_COMPENSATION, span)
        if path.rounding != 0.0:
            self._values.fail(SPLINE_WITH_CONTOURING, span)
        yield SplineBegin(source, number, span, spline.kind, spline.start, spline.start_vector)

    def _direction(self, axes: list[tuple[tree.AxisWord, float]], span: Span) -> Vector:
        numbers = self._environment.axis_numbers
        vector = tuple((numbers[word.name], value) for word, value in axes)
        linear = [axis.is_linear for axis in self._environment.axes]
        if not any(value for axis, value in vector if linear[axis]):
            main = list(numbers)[:MAIN_AXES]
            self._values.fail(
                INVALID_SPLINE_VECTOR,
                span,
                command=self._vector,
                axes=", ".join(main),
                example=" ".join(f"{name}1" for name in main),
            )
        frame = self._state.frame
        return frame.vector(vector, len(linear)) if frame.is_active else vector

    def settings(self, command: tree.HashCommand, number: int) -> Generator[Command, Answer]:
        """Execute ``#SPLINE TYPE``, ``#AKIMA TRANS`` or one of their old forms."""
        spline = self._state.shapes.spline
        name = command_name(command)
        if name.endswith((AKIMA, BSPLINE)):
            spline.kind = BSPLINE if name.endswith(BSPLINE) else AKIMA
            source = self._environment.source_id(command.span)
            if not spline.is_on:
                yield ReleaseMotions(source, number, command.span, forgets=True)
            return
        modes = []
        for value in transitions(command):
            mode = value
            if isinstance(value, tree.Expression):
                chosen = yield from self._values.evaluate(value, number)
                if not is_transition(chosen):
                    self._values.fail(INVALID_TRANSITION, value.span, value=chosen)
                mode = TRANSITIONS[int(chosen) - 1]
            modes.append(mode or TRANSITIONS[0])
        spline.start, spline.end = (str(mode) for mode in modes)
