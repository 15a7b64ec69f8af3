# SPDX-License-Identifier: MIT
"""Which transformation is active in each channel, and where it shows the tool's tip (MO-8).

A transformation is a kinematic map (``kinematics/maps.py``) from the axes of a channel to the tip
of its tool. While it is active programmed positions are those of the tip, in MCS, and the linear
axes have positions in MCS, IPO and PCS that differ from their own.
"""

from __future__ import annotations

from nctakt.kernel import codes
from nctakt.kernel.base.bounds import check_index, check_size
from nctakt.kernel.kinematics import map_rows
from nctakt.kernel.kinematics.maps import KinematicMaps


class Transformations:
    """The active maps of a machine's channels, by the first axis of the channel; 0: none.

    ``maps``: all maps of the machine.
    """

    def __init__(self, axis_count: int) -> None:
        check_size(axis_count, "number of axes")
        self.maps = KinematicMaps(axis_count)
        self.active_count = 0
        self.active = memoryview(bytearray(8 * axis_count)).cast("q")
        self.gathered = memoryview(bytearray(8 * axis_count)).cast("d")
        self.mapped = memoryview(bytearray(8 * axis_count)).cast("d")
        self.near = memoryview(bytearray(8 * axis_count)).cast("d")
        self.tips = memoryview(bytearray(8 * codes.TIPS * codes.TIP_AXES)).cast("d")

    def activate(self, slot: int, number: int) -> None:
        """Let map ``number`` be active in the channel whose first axis is ``slot``; 0: none."""
        before = 1 if self.active[slot] else 0
        self.active[slot] = number
        self.active_count += (1 if number else 0) - before

    def has_axis(self, number: int, axis: int) -> bool:
        """Return whether an axis of the channel belongs to map ``number``."""
        check_index(number, self.maps.used, "map")
        return bool(self.maps.has_axis(number, axis))

    # --- the tip --------------------------------------------------------------------------------

    def joint(self, number: int, k: int) -> int:
        """Return the column of a joint of map ``number``."""
        return number * map_rows.MAP_WIDTH + map_rows.JOINTS + k * map_rows.JOINT_WIDTH

    def joints(self, number: int) -> int:
        """Return the number of joints of map ``number``."""
        return int(self.maps.values[number * map_rows.MAP_WIDTH + map_rows.JOINT_COUNT])

    def axis_of(self, number: int, k: int) -> int:
        """Return the axis of a joint, by its place in the channel."""
        return int(self.maps.values[self.joint(number, k) + map_rows.JOINT_AXIS])

    def member(self, number: int, k: int) -> int:
        """Return the axis of a joint, by its number in the machine."""
        return int(self.maps.values[self.joint(number, k) + map_rows.JOINT_MEMBER])

    def map_forward(self, number: int, machine: memoryview[float], tip: int) -> None:
        """Keep what is shown of one kind of positions, from those of the machine's axes."""
        for k in range(self.joints(number)):
            self.gathered[self.axis_of(number, k)] = machine[self.member(number, k)]
        self.maps.forward(number, self.gathered, self.near, self.mapped)
        for k in range(self.joints(number)):
            axis = self.axis_of(number, k)
            self.tips[codes.TIP_AXES * tip + k] = self.mapped[axis]

    def copy_tip(self, tip: int, to: int) -> None:
        """Keep the same under another kind."""
        for k in range(codes.TIP_AXES):
            self.tips[codes.TIP_AXES * to + k] = self.tips[codes.TIP_AXES * tip + k]

    def tip(self, tip: int, k: int) -> float:
        """Return the position shown for the axis of a joint, in mm or degrees."""
        return self.tips[codes.TIP_AXES * tip + k]

    def is_mapped(self, number: int, k: int) -> int:
        """Return whether the axis of a joint has other positions in MCS than its own."""
        if self.maps.values[self.joint(number, k) + map_rows.JOINT_IS_ROTARY] == 0.0:
            return 1
        row = number * map_rows.MAP_WIDTH
        return 1 if self.maps.values[row + map_rows.PROGRAMMING] != map_rows.MACHINE_ANGLES else 0

    def rotation(self, number: int, start: memoryview[float], target: memoryview[float]) -> float:
        """Return the sum of the angles in degrees by which the rotary axes of a map differ."""
        total = 0.0
        for k in range(self.joints(number)):
            if self.maps.values[self.joint(number, k) + map_rows.JOINT_IS_ROTARY] > 0.0:
                axis = self.axis_of(number, k)
                angle = target[axis] - start[axis]
                total += angle if angle >= 0.0 else 0.0 - angle
        return total
