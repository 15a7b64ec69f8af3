# SPDX-License-Identifier: MIT
"""Constant cutting speed of the main spindle: G96, G97, and its limit, G196.

In: the G functions of a block and its S. Out: commands that let the realtime part set the speed
from the radius in each tick, and the speed in 1/min at which the spindle starts.
"""

from __future__ import annotations

import math
from collections.abc import Container, Iterator

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span
from nctakt.decoder.state.geometry.arcs import PLANES
from nctakt.decoder.state.queued.commands import Command
from nctakt.decoder.state.queued.spindle_commands import CuttingSpeed
from nctakt.decoder.values.variables import Values
from nctakt.messages.path.cutting import (
    CUTTING_DECIDED,
    CUTTING_START_LIMITED,
    CUTTING_WITH_PLC_SPINDLE,
    CUTTING_WITH_TWO_FACE_AXES,
    CUTTING_WITHOUT_FACE_AXIS,
    INVALID_SPINDLE_LIMIT,
)
from nctakt.nc.vocabulary.functions import CONSTANT_SPEED, CUTTING_SPEED, SPINDLE_LIMIT

_DEGREES_PER_S = 6.0
_MM_S_PER_M_MIN = 1000.0 / 60.0


@dataclass(slots=True)
class CuttingSpeeds:
    """The cutting speed of one program: ``surface`` in m/min, 0 before the first S under G96.

    ``is_active``: G96. ``limit``: G196 in 1/min, 0 for none. ``sets_limit``: S of this block is
    that limit.
    """

    values: Values
    is_active: bool = False
    surface: float = 0.0
    limit: float = 0.0
    factor: float = 1.0
    sets_limit: bool = False
    has_noted: bool = False

    def functions(
        self, numbers: Container[int], spindle: int, span: Span, number: int
    ) -> Iterator[Command]:
        """Process G96, G97 and G196 of a block; ``spindle``: the main one."""
        self.sets_limit = SPINDLE_LIMIT in numbers
        if CONSTANT_SPEED in numbers:
            if self.is_active and self.surface > 0.0:
                yield CuttingSpeed(self.values.environment.source_id(span), number, spindle)
            self.is_active = False
            self.surface = 0.0
        if CUTTING_SPEED in numbers:
            parameters = self.values.environment.parameters
            if parameters.spindles[spindle].plc_controlled:
                name = parameters.spindles[spindle].name
                self.values.fail(CUTTING_WITH_PLC_SPINDLE, span, spindle=name)
            self._face_axis(span)
            self.is_active = True
            if not self.has_noted:
                self.has_noted = True
                self.values.warn(CUTTING_DECIDED, span)

    def set_limit(self, value: float, spindle: int, span: Span, number: int) -> Iterator[Command]:
        """Process S of a block with G196: the highest speed under G96, in 1/min."""
        if value <= 0.0:
            self.values.fail(INVALID_SPINDLE_LIMIT, span, value=value)
        self.limit = value
        if self.is_active and self.surface > 0.0:
            yield self._command(spindle, span, number)

    def start(self, spindle: int, span: Span, number: int) -> tuple[CuttingSpeed, float]:
        """Return the command for the surface speed, and the speed in 1/min where the axis is."""
        command = self._command(spindle, span, number)
        axis = self._face_axis(span)
        radius = abs(self.values.state.positions[axis] - command.centre)
        limit = self.limit_of(spindle)
        surface = self.surface * self.factor
        if radius * limit * 2.0 * math.pi > surface * 1000.0:
            return command, surface * 1000.0 / (2.0 * math.pi * radius)
        speed = surface * 1000.0 / (2.0 * math.pi * radius) if radius > 0.0 else math.inf
        shown = "∞" if speed == math.inf else f"{speed:.6g}"
        self.values.warn(CUTTING_START_LIMITED, span, speed=shown, limit=limit)
        return command, limit

    def limit_of(self, spindle: int) -> float:
        """Return the highest speed under G96 in 1/min: G196, at most that of the spindle."""
        highest = self.values.environment.spindle_gears[spindle].gear.speed_v / _DEGREES_PER_S
        return min(highest, self.limit) if self.limit > 0.0 else highest

    def _command(self, spindle: int, span: Span, number: int) -> CuttingSpeed:
        environment = self.values.environment
        axis = self._face_axis(span)
        name = next(name for name, index in environment.axis_numbers.items() if index == axis)
        traits = environment.names.axis(name)
        assert traits is not None
        return CuttingSpeed(
            environment.source_id(span),
            number,
            spindle,
            self.surface * self.factor * _MM_S_PER_M_MIN,
            traits.number,
            environment.offsets.total(axis),
            self.limit * _DEGREES_PER_S,
        )

    def _face_axis(self, span: Span) -> int:
        """Return the index of the only face axis in the plane."""
        plane = self.values.state.path.plane
        axes = self.values.environment.axes
        face = [axis for axis in PLANES[plane] if axis < len(axes) and axes[axis].is_face]
        if not face:
            self.values.fail(CUTTING_WITHOUT_FACE_AXIS, span, plane=plane)
        if len(face) > 1:
            self.values.fail(CUTTING_WITH_TWO_FACE_AXES, span, plane=plane)
        return face[0]
