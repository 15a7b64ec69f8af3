# SPDX-License-Identifier: MIT
"""The numbers of a kinematic of type 91 -> its definition, or the reason that prevents its use.

Lists give these numbers by name, or by the index of ``param[]`` (P-CHAN-00263), which is the same
memory; programs change them with V.G.KIN, tools add to them (P-TOOL-00009).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

from nctakt.base.diagnostics import Message
from nctakt.lists.machine.transformations.kinematics import (
    DIRECT,
    HANDED_ON,
    POINT_VECTOR,
    PROGRAMMING_MODES,
    UNIVERSAL,
    Entry,
    Kinematic,
    KinematicAxis,
    UniversalKinematic,
    Vector,
)
from nctakt.messages.machines.kinematics import (
    KINEMATIC_AXIS_COUNT,
    KINEMATIC_AXIS_TYPE,
    KINEMATIC_CHAIN_INVALID,
    KINEMATIC_DEPENDENT_AXES,
    KINEMATIC_ORIENTATION_AXES,
    KINEMATIC_PROGRAMMING_MODE,
    KINEMATIC_VECTOR_AXES,
    KINEMATIC_ZERO_DIRECTION,
)

#: The joints that a chain can have.
MAX_CHAIN = 6

#: The entries of the definition, with the number of elements at each of their indices.
ENTRIES: Mapping[str, tuple[int, ...]] = {
    "zero_orientation[]": (3,),
    "zero_position[]": (3,),
    "number_of_axes": (),
    "rtcp": (),
    "programming_mode": (),
    "chain[]": (MAX_CHAIN,),
    "axis[].type": (MAX_CHAIN,),
    "axis[].orientation[]": (MAX_CHAIN, 3),
    "axis[].point[]": (MAX_CHAIN, 3),
    "linkage_mode": (),
    "linkage[][]": (4, 3),
}

#: Entries by their index in ``param[]``; those after them are not published.
_OF_AXIS = ("axis[].type", "axis[].orientation[]", "axis[].point[]")
PARAMETERS: tuple[Entry, ...] = (
    *(("zero_orientation[]", (i,)) for i in range(3)),
    *(("zero_position[]", (i,)) for i in range(3)),
    ("number_of_axes", ()),
    *(
        (name, (axis, *index))
        for axis in range(MAX_CHAIN)
        for name in _OF_AXIS
        for index in ([(i,) for i in range(3)] if name != "axis[].type" else [()])
    ),
)

#: V.G.KIN besides these entries, and how many offsets of P-CHAN-00446 there are.
PARAMETER, BASE, MAX_BASE = "param[]", "base[]", 6

_UNITS_PER_MM = 10_000
_LINEAR_AXES = 3
_LINEAR, _ROTARY = 1, 2
_MIN_AXES = 3
#: Volume of three directions, or sine of the angle between two, below which they depend.
_DEPENDENT = 1e-6


def entry_of(kinematic: Kinematic, name: str, indices: tuple[int, ...]) -> Entry | None:
    """Return the entry named in V.G.KIN; ``None`` if type 91 has no such entry."""
    if name in ENTRIES:
        return name, indices
    is_known = kinematic.type == UNIVERSAL and name == PARAMETER and indices[0] < len(PARAMETERS)
    return PARAMETERS[indices[0]] if is_known else None


class UnusableKinematicError(Exception):
    """The reason that prevents the use of a definition: a message about an entry and its values."""

    def __init__(
        self, message: Message, name: str, indices: tuple[int, ...], **values: object
    ) -> None:
        super().__init__(name)
        self.message = message
        self.name = name
        self.indices = indices
        self.values = values


class DefinitionReader:
    """Reads the definition of a kinematic in a channel of ``axis_count`` axes.

    ``number`` returns the number of an entry. ``listed_mode``: P-CHAN-00112.
    """

    def __init__(self, number: Callable[[Entry], float], axis_count: int, listed_mode: int) -> None:
        self._number = number
        self._axis_count = axis_count
        self._listed_mode = listed_mode

    def read(self) -> UniversalKinematic:
        """Return the definition; raise ``UnusableKinematicError``."""
        count = self._value("number_of_axes")
        if not _MIN_AXES <= count <= min(MAX_CHAIN, self._axis_count) or count != int(count):
            raise UnusableKinematicError(
                KINEMATIC_AXIS_COUNT,
                "number_of_axes",
                (),
                value=f"{count:g}",
                count=self._axis_count,
            )
        axes = tuple(self._axis(index) for index in range(int(count)))
        chain = tuple(self._value("chain[]", index) for index in range(int(count)))
        if sorted(chain) != list(range(int(count))):
            text = " ".join(f"{index:g}" for index in chain)
            raise UnusableKinematicError(
                KINEMATIC_CHAIN_INVALID, "chain[]", (0,), chain=text, count=int(count)
            )
        mode = int(self._value("programming_mode")) or self._listed_mode
        kinematic = UniversalKinematic(
            self._vector("zero_orientation[]"),
            self._point("zero_position[]"),
            self._value("rtcp") != 0.0,
            DIRECT if mode == HANDED_ON else mode,
            axes,
            tuple(int(index) for index in chain),
            self._linkage(),
        )
        self._check_directions(kinematic)
        self._check_programming(kinematic)
        return kinematic

    def _axis(self, index: int) -> KinematicAxis:
        """Return an axis as defined."""
        is_rotary = self._value("axis[].type", index) == _ROTARY
        point = self._point("axis[].point[]", index)
        return KinematicAxis(is_rotary, self._vector("axis[].orientation[]", index), point)

    def _linkage(self) -> tuple[Vector, ...]:
        """Return the matrix and the shift between linear axes and chain; empty: none."""
        if self._value("linkage_mode") == 0.0:
            return ()
        rows = tuple(self._vector("linkage[][]", i) for i in range(_LINEAR_AXES))
        return (*rows, self._point("linkage[][]", _LINEAR_AXES))

    def _check_directions(self, kinematic: UniversalKinematic) -> None:
        for index, axis in enumerate(kinematic.axes):
            given = self._value("axis[].type", index)
            if given != (_ROTARY if index >= _LINEAR_AXES else _LINEAR):
                raise UnusableKinematicError(
                    KINEMATIC_AXIS_TYPE, "axis[].type", (index,), index=index, value=f"{given:g}"
                )
            if _length(axis.direction) == 0.0:
                at = (index, 0)
                raise UnusableKinematicError(KINEMATIC_ZERO_DIRECTION, "axis[].orientation[]", at)
        if _length(kinematic.zero_orientation) == 0.0:
            raise UnusableKinematicError(KINEMATIC_ZERO_DIRECTION, "zero_orientation[]", (0,))
        directions = [axis.direction for axis in kinematic.axes[:_LINEAR_AXES]]
        if _are_dependent(*directions):
            raise UnusableKinematicError(KINEMATIC_DEPENDENT_AXES, "axis[].orientation[]", (0, 0))
        if kinematic.linkage and _are_dependent(*kinematic.linkage[:_LINEAR_AXES]):
            raise UnusableKinematicError(KINEMATIC_DEPENDENT_AXES, "linkage[][]", (0, 0))

    def _check_programming(self, kinematic: UniversalKinematic) -> None:
        """Check that the tool's direction can be programmed."""
        mode = kinematic.programming_mode
        is_complete = mode == POINT_VECTOR or not kinematic.is_rtcp
        if mode not in PROGRAMMING_MODES and (mode > 0 or is_complete):
            raise UnusableKinematicError(
                KINEMATIC_PROGRAMMING_MODE, "programming_mode", (), value=mode
            )
        if mode == POINT_VECTOR and self._axis_count < MAX_CHAIN:
            count = self._axis_count
            raise UnusableKinematicError(KINEMATIC_VECTOR_AXES, "programming_mode", (), count=count)
        if is_complete and not _turns_tool(kinematic):
            raise UnusableKinematicError(KINEMATIC_ORIENTATION_AXES, "rtcp", ())

    def _value(self, name: str, *indices: int) -> float:
        return self._number((name, indices))

    def _vector(self, name: str, *indices: int) -> Vector:
        x, y, z = (self._value(name, *indices, i) for i in range(3))
        return x, y, z

    def _point(self, name: str, *indices: int) -> Vector:
        """Return three lengths in mm."""
        x, y, z = self._vector(name, *indices)
        return x / _UNITS_PER_MM, y / _UNITS_PER_MM, z / _UNITS_PER_MM


def _length(vector: Vector) -> float:
    return math.hypot(*vector)


def _cross(left: Vector, right: Vector) -> Vector:
    return (
        left[1] * right[2] - left[2] * right[1],
        left[2] * right[0] - left[0] * right[2],
        left[0] * right[1] - left[1] * right[0],
    )


def _are_dependent(first: Vector, second: Vector, third: Vector) -> bool:
    """Return whether three vectors lie in a plane, or nearly so."""
    x, y, z = _cross(first, second)
    whole = x * third[0] + y * third[1] + z * third[2]
    return abs(whole) <= _DEPENDENT * _length(first) * _length(second) * _length(third)


def _are_parallel(left: Vector, right: Vector) -> bool:
    """Return whether two vectors lie on one line, or nearly so."""
    return _length(_cross(left, right)) <= _DEPENDENT * _length(left) * _length(right)


def _turns_tool(kinematic: UniversalKinematic) -> bool:
    """Return whether two rotary axes both turn the tool."""
    directions = [kinematic.axes[index].direction for index in kinematic.rotary]
    if len(directions) != 2:
        return False
    first, second = directions
    return not (_are_parallel(first, second) or _are_parallel(second, kinematic.zero_orientation))
