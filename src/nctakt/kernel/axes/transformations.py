# SPDX-License-Identifier: MIT
"""Which transformation is active in each channel, and where it shows the tool's tip (MO-8).

A transformation is a kinematic map (``kinematics/maps.py``) from the axes of a channel to the tip
of its tool. While it is active programmed positions are those of the tip, in MCS, and the linear
axes have positions in MCS, IPO and PCS that differ from those in ACS.
"""

from __future__ import annotations

from nctakt.kernel import codes
from nctakt.kernel.base.arrays import doubles, integers
from nctakt.kernel.base.bounds import check_index, check_size
from nctakt.kernel.kinematics import map_rows
from nctakt.kernel.kinematics.maps import KinematicMaps


class Transformations:
    """The active maps of a machine's channels, by the first axis of the channel; 0: none.

    ``maps``: all maps of the machine. ``joint_axes``, ``joint_members``, ``joint_mapped``: of the
    ``joint_count`` joints of map ``named``, since a map never changes. ``mapped_targets``: the
    targets that are kept under map ``target_number``. ``directions``: of the tools, three numbers a
    channel, all 0 where no map says it; the last three are of a place without an axis.
    """

    def __init__(self, axis_count: int) -> None:
        check_size(axis_count, "number of axes")
        self.maps = KinematicMaps(axis_count)
        self.active_count = 0
        self.active = integers(axis_count)
        self.gathered = doubles(axis_count)
        self.mapped = doubles(axis_count)
        self.near = doubles(axis_count)
        self.tips = doubles(codes.TIPS * codes.TIP_AXES)
        self.directions = doubles(3 * (axis_count + 1))
        self.named = 0
        self.joint_count = 0
        self.joint_axes = integers(codes.TIP_AXES)
        self.joint_members = integers(codes.TIP_AXES)
        self.joint_mapped = integers(codes.TIP_AXES)
        self.target_number = 0
        self.mapped_targets = doubles(codes.TIP_AXES)

    def activate(self, slot: int, number: int) -> None:
        """Activate map ``number`` in the channel whose first axis is ``slot``; 0: none."""
        before = 1 if self.active[slot] else 0
        self.active[slot] = number
        self.active_count += (1 if number else 0) - before
        first = 3 * slot
        for i in range(3):
            self.directions[first + i] = 0.0

    def has_axis(self, number: int, axis: int) -> bool:
        """Return whether an axis of the channel belongs to map ``number``."""
        check_index(number, self.maps.used, "map")
        return bool(self.maps.has_axis(number, axis))

    # --- the tip --------------------------------------------------------------------------------

    def second_step(self, row: int) -> int:
        """Return the row of the second step after that of a map, 0 if it has none."""
        second = int(self.maps.values[row + map_rows.SECOND_STEP])
        return second * map_rows.MAP_WIDTH

    def joint(self, number: int, k: int) -> int:
        """Return the column of a joint of map ``number``; those of a second step come after."""
        row = number * map_rows.MAP_WIDTH
        count = int(self.maps.values[row + map_rows.JOINT_COUNT])
        if k >= count:
            row = self.second_step(row)
            k -= count
        return row + map_rows.JOINTS + k * map_rows.JOINT_WIDTH

    def joints(self, number: int) -> int:
        """Return the number of joints of map ``number``, with those of a second step."""
        row = number * map_rows.MAP_WIDTH
        count = int(self.maps.values[row + map_rows.JOINT_COUNT])
        row = self.second_step(row)
        further = int(self.maps.values[row + map_rows.JOINT_COUNT])
        return count + further if row else count

    def axis_of(self, number: int, k: int) -> int:
        """Return the axis of a joint, by its place in the channel."""
        return int(self.maps.values[self.joint(number, k) + map_rows.JOINT_AXIS])

    def map_forward(self, number: int, machine: memoryview[float], tip: int) -> None:
        """Keep the displayed positions of one kind, computed from those of the machine's axes."""
        if number != self.named:
            self.name_joints(number)
        for k in range(self.joint_count):
            self.gathered[self.joint_axes[k]] = machine[self.joint_members[k]]
        self.maps.forward(number, self.gathered, self.near, self.mapped)
        for k in range(self.joint_count):
            self.tips[codes.TIP_AXES * tip + k] = self.mapped[self.joint_axes[k]]

    def keep_direction(self, number: int, slot: int) -> None:
        """Keep the tool's direction, from its tip to the clamp, for the positions gathered last.

        A second step and a rotating plane show no direction.
        """
        row = number * map_rows.MAP_WIDTH
        if self.second_step(row) or self.maps.values[row + map_rows.PROGRAMMING] >= (
            map_rows.FACE_PLANE
        ):
            return
        self.maps.point_tool(row, self.gathered)
        first = 3 * slot
        self.directions[first] = self.maps.orientation.x
        self.directions[first + map_rows.Y] = self.maps.orientation.y
        self.directions[first + map_rows.Z] = self.maps.orientation.z

    def map_targets(self, number: int, machine: memoryview[float]) -> None:
        """Keep the displayed targets; they change from block to block only."""
        if number != self.named:
            self.name_joints(number)
        is_kept = number == self.target_number
        for k in range(self.joint_count):
            target = machine[self.joint_members[k]]
            if target != self.mapped_targets[k]:
                self.mapped_targets[k] = target
                is_kept = False
        if not is_kept:
            self.target_number = number
            self.map_forward(number, machine, codes.TIP_OF_TARGET)

    def name_joints(self, number: int) -> None:
        """Keep axes and members of the joints of map ``number``."""
        self.named = number
        self.joint_count = self.joints(number)
        for k in range(self.joint_count):
            self.joint_axes[k] = self.axis_of(number, k)
            self.joint_members[k] = int(
                self.maps.values[self.joint(number, k) + map_rows.JOINT_MEMBER]
            )
            self.joint_mapped[k] = self.is_mapped(number, k)

    def copy_tip(self, tip: int, to: int) -> None:
        """Keep the same under another kind."""
        for k in range(codes.TIP_AXES):
            self.tips[codes.TIP_AXES * to + k] = self.tips[codes.TIP_AXES * tip + k]

    def tip(self, tip: int, k: int) -> float:
        """Return the position shown for the axis of a joint, in mm or degrees."""
        return self.tips[codes.TIP_AXES * tip + k]

    def is_mapped(self, number: int, k: int) -> int:
        """Return whether the axis of a joint has other positions in MCS than in ACS."""
        if self.maps.values[self.joint(number, k) + map_rows.JOINT_IS_ROTARY] == 0.0:
            return 1
        row = number * map_rows.MAP_WIDTH
        if k >= self.maps.values[row + map_rows.JOINT_COUNT]:
            row = self.second_step(row)
        return 1 if self.maps.values[row + map_rows.PROGRAMMING] != map_rows.MACHINE_ANGLES else 0

    def is_lateral(self, number: int) -> int:
        """Return whether a map develops a cylinder: nothing turns otherwise than in proportion."""
        row = number * map_rows.MAP_WIDTH
        return 1 if self.maps.values[row + map_rows.PROGRAMMING] == map_rows.LATERAL else 0

    def plane_axis(self, number: int) -> int:
        """Return the rotary axis that is programmed in mm under map ``number``, -1 for none."""
        row = number * map_rows.MAP_WIDTH
        if self.maps.values[row + map_rows.PROGRAMMING] < map_rows.FACE_PLANE:
            return -1
        return int(self.maps.values[row + map_rows.SECOND_PLACE])

    def is_rotary(self, number: int, axis: int) -> int:
        """Return whether an axis of the channel is a rotary axis of map ``number``."""
        for k in range(self.joints(number)):
            if self.axis_of(number, k) == axis:
                return self.maps.values[self.joint(number, k) + map_rows.JOINT_IS_ROTARY] > 0.0
        return 0

    def turns_otherwise(self, number: int) -> int:
        """Return whether rotary axes turn differently from what is programmed for them."""
        row = number * map_rows.MAP_WIDTH
        if self.maps.values[row + map_rows.SECOND_STEP] > 0.0:
            return 1
        if self.is_lateral(number):
            return 0
        return 1 if self.maps.values[row + map_rows.PROGRAMMING] != map_rows.MACHINE_ANGLES else 0

    def rotation(self, number: int, start: memoryview[float], target: memoryview[float]) -> float:
        """Return the sum of the angles in degrees by which the rotary axes of a map differ."""
        total = 0.0
        if self.is_lateral(number):
            return total
        for k in range(self.joints(number)):
            if self.maps.values[self.joint(number, k) + map_rows.JOINT_IS_ROTARY] > 0.0:
                axis = self.axis_of(number, k)
                angle = target[axis] - start[axis]
                total += angle if angle >= 0.0 else 0.0 - angle
        return total
