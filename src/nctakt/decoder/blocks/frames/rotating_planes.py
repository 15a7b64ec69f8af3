# SPDX-License-Identifier: MIT
"""``#FACE`` and ``#CYL`` of the main program -> commands (MO-8).

In: the tree of a checked command. Two axes form a separate plane that turns with a rotary axis: the
face of a turned part, or its cylinder developed. Switching moves no axis. Arcs, centres and the
tool's radius lie in this plane until ``OFF``, which returns to the plane before it.
"""

from __future__ import annotations

from collections.abc import Generator

from nctakt.base.diagnostics import Span, Text
from nctakt.decoder.blocks.frames.transformation_commands import TransformationCommands
from nctakt.decoder.kinematics.rotating_planes import RotatingPlane
from nctakt.decoder.state.queued.commands import Answer, Command
from nctakt.decoder.values.variables import Values
from nctakt.lists.machine.transformations.kinematics import Kinematic
from nctakt.messages.path.frames import ROTATION_ENDED_BY_PLANE
from nctakt.messages.path.rotating_planes import (
    AXES_OF_PLANE,
    C_AXIS_NOT_MODULO,
    FUNCTION_IN_PLANE,
    NO_C_AXIS,
    PLANE_BY_GEOMETRY,
    PLANE_EXCLUDED,
    PLANE_NOT_CONFIGURED,
)
from nctakt.nc import tree
from nctakt.nc.meaning.coordinates import PlaneCommand, plane_command
from nctakt.nc.vocabulary.function_rows import Group
from nctakt.nc.vocabulary.functions import PLANE_XY, THREADS, group_of

#: The kinematics of both commands; #FACE on a lathe and on a milling machine.
_FACE_OF_LATHE, _FACE_OF_MILLING_MACHINE, _CYLINDER = 13, 14, 15
#: The index of HD2, the angle where the surface of the cylinder begins, and its unit per degree.
_ZERO_ANGLE, _PER_DEGREE = 1, 10_000.0
_LINEAR_AXES = 3


def check_function(values: Values, function: int, span: Span) -> None:
    """Raise ``DecodeError`` for a G function that a plane of #FACE or #CYL excludes (20944)."""
    plane = values.environment.offsets.transformation.plane
    if plane is None:
        return
    leaves_plane = group_of(function) is Group.PLANE and function != PLANE_XY
    if leaves_plane or function in THREADS:
        values.fail(FUNCTION_IN_PLANE, span, function=function, command=plane.command)


class RotatingPlanes:
    """The commands of one program."""

    def __init__(self, values: Values, transformations: TransformationCommands) -> None:
        self._values = values
        self._environment = values.environment
        self._transformations = transformations
        self._active = values.environment.offsets.transformation
        self._reported: set[str] = set()

    def command(self, statement: tree.HashCommand, number: int) -> Generator[Command, Answer]:
        """Execute one command; ``OFF`` of the other plane changes nothing."""
        command = plane_command(statement)
        assert command is not None
        if command.name.endswith(" OFF"):
            plane = self._active.plane
            if plane is not None and plane.command == command.shown.removesuffix(" OFF"):
                yield from self._transformations.switch(0, command.shown, statement.span, number)
                self._values.state.path.turning_plane = None
                self._end_rotation(statement.span)
            return
        self._check_alone(command, statement.span)
        plane = yield from self._plane(command, statement.span, number)
        if command.name not in self._reported:
            self._reported.add(command.name)
            self._values.warn(PLANE_BY_GEOMETRY, statement.span, command=command.shown)
        map_number = self._active.map_of_plane(plane, {})
        yield from self._transformations.switch(
            map_number, command.shown, statement.span, number, plane=plane
        )
        self._values.state.path.turning_plane = plane.axes

    def check_other(self, shown: str, span: Span) -> None:
        """Raise ``DecodeError`` for another command of coordinates while a plane is active."""
        if self._active.plane is not None:
            other = self._active.plane.command
            self._values.fail(PLANE_EXCLUDED, span, command=shown, other=other)

    def _check_alone(self, command: PlaneCommand, span: Span) -> None:
        """Raise ``DecodeError`` while a transformation or a coordinate system is active."""
        other = ""
        if self._environment.offsets.systems.is_active:
            other = "#CS"
        elif self._active.is_length_correction:
            other = "#TLC"
        elif self._active.is_transformation:
            other = "#TRAFO"
        elif self._values.state.frame.is_turned:
            other = "#ROTATION"
        if other:
            self._values.fail(PLANE_EXCLUDED, span, command=command.shown, other=other)

    def _end_rotation(self, span: Span) -> None:
        """End a rotation of the contour in a plane that ends, with a warning."""
        state = self._values.state
        if state.frame.is_turned:
            state.frame.is_turned = False
            self._values.warn(ROTATION_ENDED_BY_PLANE, span, plane=state.path.plane)

    def _kinematic(self, identity: int, command: PlaneCommand, span: Span) -> Kinematic:
        kinematic = self._active.kinematics.find(0, identity)
        if kinematic is None:
            self._values.fail(PLANE_NOT_CONFIGURED, span, command=command.shown, id=identity)
        return kinematic

    def _plane(
        self, command: PlaneCommand, span: Span, number: int
    ) -> Generator[Command, Answer, RotatingPlane]:
        """Return the plane of a command."""
        indices = [self._environment.axis_numbers[name] for name in command.axes]
        axes = self._environment.axes
        rotary = [index for index in indices[:2] if axes[index].is_c_axis]
        if not rotary:
            self._values.fail(NO_C_AXIS, span, command=command.shown)
        linear = [index for index in indices if index != rotary[0]]
        if len(linear) != len(indices) - 1 or any(
            not axes[index].is_linear or index >= _LINEAR_AXES for index in linear
        ):
            needed = Text("one C axis and linear axes", "eine C-Achse und Linearachsen")
            self._values.fail(AXES_OF_PLANE, span, command=command.shown, needed=needed)
        if not axes[rotary[0]].is_modulo and command.name not in self._reported:
            axis = axes[rotary[0]].name
            self._values.warn(C_AXIS_NOT_MODULO, span, axis=axis, command=command.shown)
        plane = indices[0], indices[1]
        if command.radius is not None:
            kinematic = self._kinematic(_CYLINDER, command, span)
            radius = yield from self._values.evaluate(command.radius, number)
            radius *= self._values.state.length_unit_mm
            if radius <= 0.0:
                needed = Text("a radius above 0", "einen Radius über 0")
                self._values.fail(AXES_OF_PLANE, span, command=command.shown, needed=needed)
            zero = kinematic.parameters.get(_ZERO_ANGLE, 0.0) / _PER_DEGREE
            return RotatingPlane(command.shown, plane, rotary[0], radius=radius, zero_angle=zero)
        beside = 0.0
        if self._active.kinematics.transformations.is_face_of_milling_machine:
            self._kinematic(_FACE_OF_MILLING_MACHINE, command, span)
            beside = yield from self._beside(linear[0], span, number)
        else:
            self._kinematic(_FACE_OF_LATHE, command, span)
        return RotatingPlane(command.shown, plane, rotary[0], linear[0], beside=beside)

    def _beside(self, radial: int, span: Span, number: int) -> Generator[Command, Answer, float]:
        """Return the position of the axis across the radial one, which stays there."""
        across = 1 - radial if radial < 2 else -1
        if (
            not 0 <= across < len(self._environment.axes)
            or not self._environment.axes[across].is_linear
        ):
            return 0.0
        positions = yield from self._transformations.stop("#FACE", span, number)
        return self._active.to_axes(positions)[across]
