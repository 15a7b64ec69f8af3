# SPDX-License-Identifier: MIT
"""The kinematic transformations in the values of a channel list.

In: checked values. Out: ``Transformations``. A universal kinematic whose definition is defective is
reported and cannot be selected.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from nctakt.base.diagnostics import Message
from nctakt.lists.declared.kinematics import MAX_CHAIN, PREFIXES
from nctakt.lists.format.parameter import with_indices
from nctakt.lists.format.values import Values
from nctakt.lists.machine.kinematics import (
    POINT_VECTOR,
    PROGRAMMING_MODES,
    UNIVERSAL,
    Kinematic,
    KinematicAxis,
    Transformations,
    UniversalKinematic,
    Vector,
)
from nctakt.messages import Collector
from nctakt.messages.kinematics import (
    KINEMATIC_AXIS_COUNT,
    KINEMATIC_AXIS_TYPE,
    KINEMATIC_CHAIN_INVALID,
    KINEMATIC_DEPENDENT_AXES,
    KINEMATIC_GIVEN_TWICE,
    KINEMATIC_ORIENTATION_AXES,
    KINEMATIC_PROGRAMMING_MODE,
    KINEMATIC_VECTOR_AXES,
    KINEMATIC_WITHOUT_ID,
    KINEMATIC_ZERO_DIRECTION,
)

_UNITS_PER_MM = 10_000
_LINEAR_AXES = 3
_LINEAR, _ROTARY = 1, 2
_MIN_AXES = 3
#: Volume of three directions, or sine of the angle between two, below which they depend.
_DEPENDENT = 1e-6


def transformations(values: Values, axis_count: int, collector: Collector) -> Transformations:
    """Return the transformations of a channel of ``axis_count`` axes."""
    steps = tuple(_step(values, step, axis_count, collector) for step in range(2))
    first = values.integer("default_id_of_kin_step[]", 0) or values.integer("kinematik_id")
    return Transformations(
        (first, values.integer("default_id_of_kin_step[]", 1)),
        steps,
        values.text("ori.mode"),
        values.integer("tool_ori_cs.axis"),
        values.integer("tool_ori_cs.mode"),
    )


def _elements(values: Values, step: int) -> Iterator[tuple[str, tuple[int, ...]]]:
    """Yield where the kinematics of a step stand: prefix and indices."""
    short, long = PREFIXES
    if step == 0:
        for index in values.indices(short):
            yield short, (index,)
    for index in values.indices(long, step):
        yield long, (step, index)


def _step(
    values: Values, step: int, axis_count: int, collector: Collector
) -> Mapping[int, Kinematic]:
    kinematics: dict[int, Kinematic] = {}
    seen: set[int] = set()
    for prefix, indices in _elements(values, step):
        element = _Element(values, prefix, indices, axis_count, collector)
        if element.id == 0:
            element.warn_at(KINEMATIC_WITHOUT_ID, "id")
        elif element.id in seen:
            element.warn_at(KINEMATIC_GIVEN_TWICE, "id", id=element.id)
        else:
            seen.add(element.id)
            kinematic = element.kinematic()
            if kinematic is not None:
                kinematics[element.id] = kinematic
    return kinematics


class _Element:
    """One kinematic of a list: ``trafo[j]``."""

    def __init__(
        self,
        values: Values,
        prefix: str,
        indices: tuple[int, ...],
        axis_count: int,
        collector: Collector,
    ) -> None:
        self.values = values
        self.prefix = prefix
        self.indices = indices
        self.axis_count = axis_count
        self.collector = collector
        self.id = values.integer(f"{prefix}.id", *indices)

    def kinematic(self) -> Kinematic | None:
        """Return the kinematic; ``None``, reported: it is defective."""
        type_ = self.values.integer(f"{self.prefix}.type", *self.indices) or self.id
        pattern = f"{self.prefix}.param[]"
        parameters = {
            index: self.values.real(pattern, *self.indices, index)
            for index in self.values.indices(pattern, *self.indices)
        }
        if type_ != UNIVERSAL:
            return Kinematic(self.id, type_, parameters)
        universal = self.universal()
        return None if universal is None else Kinematic(self.id, type_, parameters, universal)

    # --- the universal kinematic ----------------------------------------------------------------

    def universal(self) -> UniversalKinematic | None:
        """Return the definition of a universal kinematic; ``None``, reported: it is defective."""
        count = self.number("number_of_axes")
        if not _MIN_AXES <= count <= min(MAX_CHAIN, self.axis_count) or count != int(count):
            self.warn_at(
                KINEMATIC_AXIS_COUNT,
                "number_of_axes",
                id=self.id,
                value=f"{count:g}",
                count=self.axis_count,
            )
            return None
        axes = tuple(self.axis(index) for index in range(int(count)))
        chain = tuple(self.number("chain[]", index) for index in range(int(count)))
        if sorted(chain) != list(range(int(count))):
            text = " ".join(f"{index:g}" for index in chain)
            self.warn_at(KINEMATIC_CHAIN_INVALID, "chain[]", 0, id=self.id, chain=text, count=count)
            return None
        kinematic = UniversalKinematic(
            self.vector("zero_orientation[]"),
            self.point("zero_position[]"),
            self.number("rtcp") != 0.0,
            int(self.number("programming_mode")) or self.values.integer("ori_rotation_angle"),
            axes,
            tuple(int(index) for index in chain),
            self.linkage(),
        )
        return kinematic if self.is_sound(kinematic) else None

    def axis(self, index: int) -> KinematicAxis:
        """Return an axis as it stands in the list."""
        is_rotary = self.number("axis[].type", index) == _ROTARY
        point = self.point("axis[].point[]", index)
        return KinematicAxis(is_rotary, self.vector("axis[].orientation[]", index), point)

    def linkage(self) -> tuple[Vector, ...]:
        """Return the matrix and the shift between linear axes and chain; empty: none."""
        if self.number("linkage_mode") == 0.0:
            return ()
        rows = tuple(self.vector("linkage[][]", i) for i in range(_LINEAR_AXES))
        return (*rows, self.point("linkage[][]", _LINEAR_AXES))

    def is_sound(self, kinematic: UniversalKinematic) -> bool:
        """Return whether a definition can be used; report what prevents it."""
        for index, axis in enumerate(kinematic.axes):
            given = self.number("axis[].type", index)
            if given != (_ROTARY if index >= _LINEAR_AXES else _LINEAR):
                self.warn_at(
                    KINEMATIC_AXIS_TYPE,
                    "axis[].type",
                    index,
                    id=self.id,
                    index=index,
                    value=f"{given:g}",
                )
                return False
            if _length(axis.direction) == 0.0:
                self.warn_at(KINEMATIC_ZERO_DIRECTION, "axis[].orientation[]", index, 0, id=self.id)
                return False
        if _length(kinematic.zero_orientation) == 0.0:
            self.warn_at(KINEMATIC_ZERO_DIRECTION, "zero_orientation[]", 0, id=self.id)
            return False
        directions = [axis.direction for axis in kinematic.axes[:_LINEAR_AXES]]
        if _are_dependent(*directions):
            self.warn_at(KINEMATIC_DEPENDENT_AXES, "axis[].orientation[]", 0, 0, id=self.id)
            return False
        if kinematic.linkage and _are_dependent(*kinematic.linkage[:_LINEAR_AXES]):
            self.warn_at(KINEMATIC_DEPENDENT_AXES, "linkage[][]", 0, 0, id=self.id)
            return False
        return self.is_programmable(kinematic)

    def is_programmable(self, kinematic: UniversalKinematic) -> bool:
        """Return whether the tool's direction can be programmed; report what prevents it."""
        mode = kinematic.programming_mode
        is_complete = mode == POINT_VECTOR or not kinematic.is_rtcp
        if mode not in PROGRAMMING_MODES and (mode > 0 or is_complete):
            self.warn_at(KINEMATIC_PROGRAMMING_MODE, "programming_mode", id=self.id, value=mode)
            return False
        if mode == POINT_VECTOR and self.axis_count < MAX_CHAIN:
            count = self.axis_count
            self.warn_at(KINEMATIC_VECTOR_AXES, "programming_mode", id=self.id, count=count)
            return False
        if is_complete and not _turns_tool(kinematic):
            self.warn_at(KINEMATIC_ORIENTATION_AXES, "rtcp", id=self.id)
            return False
        return True

    # --- entries --------------------------------------------------------------------------------

    def number(self, name: str, *further: int) -> float:
        """Return a number of this kinematic."""
        return self.values.real(f"{self.prefix}.{name}", *self.indices, *further)

    def vector(self, name: str, *further: int) -> Vector:
        """Return three numbers of this kinematic."""
        x, y, z = (self.number(name, *further, i) for i in range(3))
        return x, y, z

    def point(self, name: str, *further: int) -> Vector:
        """Return three lengths of this kinematic in mm."""
        x, y, z = self.vector(name, *further)
        return x / _UNITS_PER_MM, y / _UNITS_PER_MM, z / _UNITS_PER_MM

    def warn_at(self, message: Message, name: str, *further: int, **values: object) -> None:
        """Report a message at an entry of this kinematic."""
        pattern = f"{self.prefix}.{name}"
        at = (*self.indices, *further)
        key = with_indices(pattern, at)
        self.values.report(self.collector, message, (pattern, *at), key=key, **values)


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
