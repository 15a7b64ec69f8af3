# SPDX-License-Identifier: MIT
"""Kinematic maps: positions of the axes <-> positions of the tool in the workpiece.

A map is a row of numbers (``map_rows.py``) that never changes. A chain is the product of the rigid
motions of its joints, from the workpiece to the tool, applied to the tool's tip. With the rotary
axes given the tip is affine in the three linear axes, so one system of three equations leads back;
where no rotary joint lies between two linear ones its matrix is constant. Positions are in the
order of the channel's axes: the first three are those of the tip, those of the rotary axes are
unchanged (RTCP) or give the tool's direction (complete).

A map may be followed by that of a second step, whose axes are the results of the first.

Maps are kept by number, from 1 on, for as long as the machine lives: segments in the queue and in
the history refer to them.
"""

from __future__ import annotations

from nctakt.kernel.base import arithmetic
from nctakt.kernel.base.arrays import doubles
from nctakt.kernel.base.bounds import check_finite, check_range, check_size
from nctakt.kernel.kinematics import map_rows, rotating_planes
from nctakt.kernel.kinematics.orientation import Orientation

#: Initial capacity, in maps.
CAPACITY = 4
#: Volume of the three directions of the linear axes below which they no longer span the space.
SMALLEST_WHOLE = 1e-9


class KinematicMaps:
    """The maps of a machine of ``axis_count`` axes; ``used`` is the number of the next one.

    ``x``, ``y``, ``z`` hold the point that the joints move, ``columns`` the directions of the three
    linear axes as the joints before them turn them; ``between`` the values between two steps.
    """

    def __init__(self, axis_count: int) -> None:
        check_size(axis_count, "number of axes")
        self.axis_count = axis_count
        self.capacity = CAPACITY
        self.used = 1
        self.values = doubles(CAPACITY * map_rows.MAP_WIDTH)
        self.columns = doubles(9)
        self.linear = doubles(3)
        room = max(1, axis_count)
        self.between = doubles(room)
        self.near_between = doubles(room)
        self.orientation = Orientation()
        self.x = 0.0
        self.y = 0.0
        self.z = 0.0

    def add(self, values: list[float]) -> int:
        """Return the number of a map; equal maps share a number.

        Raise ``ValueError`` where a number is out of range.
        """
        check_range(len(values), map_rows.MAP_WIDTH, map_rows.MAP_WIDTH, "length of a map")
        row = [float(value) for value in values]
        check_map(row, self.axis_count)
        check_column(row, map_rows.SECOND_STEP, 0, self.used - 1)
        for number in range(1, self.used):
            first = number * map_rows.MAP_WIDTH
            if [self.values[first + i] for i in range(map_rows.MAP_WIDTH)] == row:
                return number
        if self.used == self.capacity:
            self.grow()
        for i, value in enumerate(row):
            self.values[self.used * map_rows.MAP_WIDTH + i] = value
        self.used += 1
        return self.used - 1

    def grow(self) -> None:
        """Double the room for maps."""
        kept = self.values
        self.capacity *= 2
        self.values = doubles(self.capacity * map_rows.MAP_WIDTH)
        for i in range(self.used * map_rows.MAP_WIDTH):
            self.values[i] = kept[i]

    def has_axis(self, number: int, axis: int) -> int:
        """Return whether an axis of the channel belongs to map ``number``."""
        while number > 0:
            row = number * map_rows.MAP_WIDTH
            count = int(self.values[row + map_rows.JOINT_COUNT])
            for k in range(count):
                joint = row + map_rows.JOINTS + k * map_rows.JOINT_WIDTH
                if self.values[joint + map_rows.JOINT_AXIS] == axis:
                    return 1
            number = int(self.values[row + map_rows.SECOND_STEP])
        return 0

    def forward(
        self,
        number: int,
        positions: memoryview[float],
        near: memoryview[float],
        results: memoryview[float],
    ) -> None:
        """Put the tool's positions into ``results``, from those of the axes.

        Of two pairs of programmed angles, take the one nearer to ``near``.
        """
        row = number * map_rows.MAP_WIDTH
        second = int(self.values[row + map_rows.SECOND_STEP])
        if second > 0:
            self.forward_step(row, positions, near, self.between)
            self.forward_step(second * map_rows.MAP_WIDTH, self.between, near, results)
        else:
            self.forward_step(row, positions, near, results)

    def forward_step(
        self,
        row: int,
        positions: memoryview[float],
        near: memoryview[float],
        results: memoryview[float],
    ) -> None:
        """``forward`` of one step."""
        for i in range(int(self.values[row + map_rows.AXIS_COUNT])):
            results[i] = positions[i]
        if self.values[row + map_rows.PROGRAMMING] >= map_rows.FACE_PLANE:
            rotating_planes.to_plane(self.values, row, positions, results)
            return
        self.place_tip(row, positions)
        results[map_rows.X] = self.x
        results[map_rows.Y] = self.y
        results[map_rows.Z] = self.z
        if self.values[row + map_rows.PROGRAMMING] == map_rows.MACHINE_ANGLES:
            return
        self.point_tool(row, positions)
        self.name_direction(row, near, results)

    def inverse(
        self,
        number: int,
        positions: memoryview[float],
        near: memoryview[float],
        results: memoryview[float],
    ) -> int:
        """Put the axes' positions into ``results``, from those of ``forward``.

        Of two solutions, take the one nearer to ``near``, positions of the axes. Return
        ``REACHED``, or why there is none; ``results`` are ``near`` then.
        """
        row = number * map_rows.MAP_WIDTH
        second = int(self.values[row + map_rows.SECOND_STEP])
        if second == 0:
            return self.inverse_step(row, positions, near, results)
        self.forward_step(row, near, near, self.near_between)
        answer = self.inverse_step(
            second * map_rows.MAP_WIDTH, positions, self.near_between, self.between
        )
        if answer == map_rows.REACHED:
            return self.inverse_step(row, self.between, near, results)
        for i in range(int(self.values[row + map_rows.AXIS_COUNT])):
            results[i] = near[i]
        return answer

    def inverse_step(
        self,
        row: int,
        positions: memoryview[float],
        near: memoryview[float],
        results: memoryview[float],
    ) -> int:
        """``inverse`` of one step."""
        for i in range(int(self.values[row + map_rows.AXIS_COUNT])):
            results[i] = positions[i]
        answer = map_rows.REACHED
        if self.values[row + map_rows.PROGRAMMING] >= map_rows.FACE_PLANE:
            return rotating_planes.to_axes(self.values, row, positions, near, results)
        if self.values[row + map_rows.PROGRAMMING] != map_rows.MACHINE_ANGLES:
            answer = self.turn_axes(row, positions, near, results)
        self.x = positions[map_rows.X]
        self.y = positions[map_rows.Y]
        self.z = positions[map_rows.Z]
        if answer == map_rows.REACHED:
            if self.values[row + map_rows.IS_SPLIT] > 0.0:
                self.solve_split(row, results)
            else:
                answer = self.solve_mixed(row, results)
        if answer != map_rows.REACHED:
            for i in range(int(self.values[row + map_rows.AXIS_COUNT])):
                results[i] = near[i]
        return answer

    def aim(
        self,
        number: int,
        vector: memoryview[float],
        near: memoryview[float],
        results: memoryview[float],
    ) -> int:
        """Put the words for a vector along the tool into the rotary places of ``results``.

        The vector leads from the tip to the clamp; of two solutions, take the one nearer to
        ``near``. Return ``REACHED``, or why there is none; the vector is that of the first step.
        """
        row = number * map_rows.MAP_WIDTH
        self.orientation.start(vector, 0)
        if not self.orientation.normalise():
            return map_rows.NO_DIRECTION
        if self.values[row + map_rows.PROGRAMMING] == map_rows.MACHINE_ANGLES:
            return self.turn_onto_direction(row, near, results)
        return self.name_direction(row, near, results)

    def other_aim(self, number: int, results: memoryview[float]) -> None:
        """Put the other solution of the last ``aim`` into the rotary places of ``results``."""
        row = number * map_rows.MAP_WIDTH
        first = int(self.values[row + map_rows.FIRST_PLACE])
        second = int(self.values[row + map_rows.SECOND_PLACE])
        if self.values[row + map_rows.PROGRAMMING] == map_rows.MACHINE_ANGLES:
            joint = int(self.values[row + map_rows.FIRST_JOINT])
            first = int(self.values[row + joint + map_rows.JOINT_AXIS])
            joint = int(self.values[row + map_rows.SECOND_JOINT])
            second = int(self.values[row + joint + map_rows.JOINT_AXIS])
        if self.values[row + map_rows.PROGRAMMING] != map_rows.VECTOR:
            results[first] = self.orientation.other_first
            results[second] = self.orientation.other_second

    def direction(
        self, number: int, positions: memoryview[float], results: memoryview[float]
    ) -> None:
        """Put the vector from the tip to the clamp, of length 1, into ``results[0]`` … ``[2]``.

        It is that of the first step.
        """
        self.point_tool(number * map_rows.MAP_WIDTH, positions)
        results[map_rows.X] = self.orientation.x
        results[map_rows.Y] = self.orientation.y
        results[map_rows.Z] = self.orientation.z

    # --- the tip ----------------------------------------------------------------------------------

    def place_tip(self, row: int, positions: memoryview[float]) -> None:
        """Keep the tip's place as x, y, z."""
        self.x = self.values[row + map_rows.TOOL]
        self.y = self.values[row + map_rows.TOOL + map_rows.Y]
        self.z = self.values[row + map_rows.TOOL + map_rows.Z]
        count = int(self.values[row + map_rows.JOINT_COUNT])
        if self.values[row + map_rows.IS_SPLIT] > 0.0:
            trailing = int(self.values[row + map_rows.TRAILING_FIRST])
            self.turn_back_to(row, count - 1, trailing, positions)
            self.map_linear(row, positions)
            self.x += self.linear[map_rows.X]
            self.y += self.linear[map_rows.Y]
            self.z += self.linear[map_rows.Z]
            leading = int(self.values[row + map_rows.LEADING_COUNT])
            self.turn_back_to(row, leading - 1, 0, positions)
            return
        self.map_linear(row, positions)
        for k in range(count - 1, -1, -1):
            joint = row + map_rows.JOINTS + k * map_rows.JOINT_WIDTH
            if self.values[joint + map_rows.JOINT_IS_ROTARY] > 0.0:
                self.turn_point(joint, positions[int(self.values[joint + map_rows.JOINT_AXIS])])
            else:
                covered = self.linear[int(self.values[joint + map_rows.JOINT_AXIS])]
                self.x += covered * self.values[joint + map_rows.JOINT_DIRECTION]
                self.y += covered * self.values[joint + map_rows.JOINT_DIRECTION + map_rows.Y]
                self.z += covered * self.values[joint + map_rows.JOINT_DIRECTION + map_rows.Z]

    def turn_back_to(self, row: int, last: int, first: int, positions: memoryview[float]) -> None:
        """Turn the point about the rotary joints ``last`` down to ``first``."""
        for k in range(last, first - 1, -1):
            joint = row + map_rows.JOINTS + k * map_rows.JOINT_WIDTH
            self.turn_point(joint, positions[int(self.values[joint + map_rows.JOINT_AXIS])])

    def turn_point(self, joint: int, angle: float) -> None:
        """Turn the point about a joint."""
        a = self.values[joint + map_rows.JOINT_DIRECTION]
        b = self.values[joint + map_rows.JOINT_DIRECTION + map_rows.Y]
        c = self.values[joint + map_rows.JOINT_DIRECTION + map_rows.Z]
        cosine = arithmetic.cosine(angle)
        sine = arithmetic.sine(angle)
        x = self.x - self.values[joint + map_rows.JOINT_POINT]
        y = self.y - self.values[joint + map_rows.JOINT_POINT + map_rows.Y]
        z = self.z - self.values[joint + map_rows.JOINT_POINT + map_rows.Z]
        along = (a * x + b * y + c * z) * (1.0 - cosine)
        self.x = x * cosine + (b * z - c * y) * sine + a * along
        self.y = y * cosine + (c * x - a * z) * sine + b * along
        self.z = z * cosine + (a * y - b * x) * sine + c * along
        self.x += self.values[joint + map_rows.JOINT_POINT]
        self.y += self.values[joint + map_rows.JOINT_POINT + map_rows.Y]
        self.z += self.values[joint + map_rows.JOINT_POINT + map_rows.Z]

    def map_linear(self, row: int, positions: memoryview[float]) -> None:
        """Keep the motion of the linear joints that belongs to the linear axes' positions."""
        for i in range(3):
            matrix = row + map_rows.MATRIX + 3 * i
            self.linear[i] = (
                self.values[matrix] * positions[map_rows.X]
                + self.values[matrix + map_rows.Y] * positions[map_rows.Y]
                + self.values[matrix + map_rows.Z] * positions[map_rows.Z]
                + self.values[row + map_rows.SHIFT + i]
            )

    # --- back to the axes -------------------------------------------------------------------------

    def solve_split(self, row: int, results: memoryview[float]) -> None:
        """Put the linear axes for the tip into ``results``, which has the rotary ones."""
        for k in range(int(self.values[row + map_rows.LEADING_COUNT])):
            joint = row + map_rows.JOINTS + k * map_rows.JOINT_WIDTH
            self.turn_point(joint, 0.0 - results[int(self.values[joint + map_rows.JOINT_AXIS])])
        x = self.x
        y = self.y
        z = self.z
        self.x = self.values[row + map_rows.TOOL]
        self.y = self.values[row + map_rows.TOOL + map_rows.Y]
        self.z = self.values[row + map_rows.TOOL + map_rows.Z]
        count = int(self.values[row + map_rows.JOINT_COUNT])
        trailing = int(self.values[row + map_rows.TRAILING_FIRST])
        self.turn_back_to(row, count - 1, trailing, results)
        self.unmap_linear(row, x - self.x, y - self.y, z - self.z, results)

    def unmap_linear(
        self, row: int, x: float, y: float, z: float, results: memoryview[float]
    ) -> None:
        """Put the positions of the linear axes for this motion of the joints into ``results``."""
        x -= self.values[row + map_rows.SHIFT]
        y -= self.values[row + map_rows.SHIFT + map_rows.Y]
        z -= self.values[row + map_rows.SHIFT + map_rows.Z]
        for i in range(3):
            matrix = row + map_rows.INVERSE + 3 * i
            results[i] = (
                self.values[matrix] * x
                + self.values[matrix + map_rows.Y] * y
                + self.values[matrix + map_rows.Z] * z
            )

    def solve_mixed(self, row: int, results: memoryview[float]) -> int:
        """``solve_split`` with rotary joints between linear ones; ``REACHED`` or ``SINGULAR``."""
        x = self.x
        y = self.y
        z = self.z
        self.x = self.values[row + map_rows.TOOL]
        self.y = self.values[row + map_rows.TOOL + map_rows.Y]
        self.z = self.values[row + map_rows.TOOL + map_rows.Z]
        count = int(self.values[row + map_rows.JOINT_COUNT])
        for k in range(count - 1, -1, -1):
            joint = row + map_rows.JOINTS + k * map_rows.JOINT_WIDTH
            axis = int(self.values[joint + map_rows.JOINT_AXIS])
            if self.values[joint + map_rows.JOINT_IS_ROTARY] > 0.0:
                self.turn_point(joint, results[axis])
                self.turn_columns(row, k, results[axis])
            else:
                column = 3 * axis
                for i in range(3):
                    self.columns[column + i] = self.values[joint + map_rows.JOINT_DIRECTION + i]
        return self.solve_columns(row, x - self.x, y - self.y, z - self.z, results)

    def turn_columns(self, row: int, k: int, angle: float) -> None:
        """Turn the directions of the linear joints after rotary joint ``k``."""
        turned = row + map_rows.JOINTS + k * map_rows.JOINT_WIDTH + map_rows.JOINT_DIRECTION
        count = int(self.values[row + map_rows.JOINT_COUNT])
        for further in range(k + 1, count):
            joint = row + map_rows.JOINTS + further * map_rows.JOINT_WIDTH
            if self.values[joint + map_rows.JOINT_IS_ROTARY] == 0.0:
                column = int(self.values[joint + map_rows.JOINT_AXIS])
                column *= 3
                self.orientation.start(self.columns, column)
                self.orientation.turn(self.values, turned, angle)
                self.columns[column] = self.orientation.x
                self.columns[column + map_rows.Y] = self.orientation.y
                self.columns[column + map_rows.Z] = self.orientation.z

    def solve_columns(
        self, row: int, x: float, y: float, z: float, results: memoryview[float]
    ) -> int:
        """Split a vector into the three columns, and put the axes' positions into ``results``."""
        a_x = (
            self.columns[map_rows.SECOND_Y] * self.columns[map_rows.THIRD_Z]
            - self.columns[map_rows.SECOND_Z] * self.columns[map_rows.THIRD_Y]
        )
        a_y = (
            self.columns[map_rows.SECOND_Z] * self.columns[map_rows.THIRD_X]
            - self.columns[map_rows.SECOND_X] * self.columns[map_rows.THIRD_Z]
        )
        a_z = (
            self.columns[map_rows.SECOND_X] * self.columns[map_rows.THIRD_Y]
            - self.columns[map_rows.SECOND_Y] * self.columns[map_rows.THIRD_X]
        )
        whole = (
            self.columns[map_rows.FIRST_X] * a_x
            + self.columns[map_rows.FIRST_Y] * a_y
            + self.columns[map_rows.FIRST_Z] * a_z
        )
        if 0.0 - SMALLEST_WHOLE < whole < SMALLEST_WHOLE:
            return map_rows.SINGULAR
        b_x = (
            self.columns[map_rows.THIRD_Y] * self.columns[map_rows.FIRST_Z]
            - self.columns[map_rows.THIRD_Z] * self.columns[map_rows.FIRST_Y]
        )
        b_y = (
            self.columns[map_rows.THIRD_Z] * self.columns[map_rows.FIRST_X]
            - self.columns[map_rows.THIRD_X] * self.columns[map_rows.FIRST_Z]
        )
        b_z = (
            self.columns[map_rows.THIRD_X] * self.columns[map_rows.FIRST_Y]
            - self.columns[map_rows.THIRD_Y] * self.columns[map_rows.FIRST_X]
        )
        c_x = (
            self.columns[map_rows.FIRST_Y] * self.columns[map_rows.SECOND_Z]
            - self.columns[map_rows.FIRST_Z] * self.columns[map_rows.SECOND_Y]
        )
        c_y = (
            self.columns[map_rows.FIRST_Z] * self.columns[map_rows.SECOND_X]
            - self.columns[map_rows.FIRST_X] * self.columns[map_rows.SECOND_Z]
        )
        c_z = (
            self.columns[map_rows.FIRST_X] * self.columns[map_rows.SECOND_Y]
            - self.columns[map_rows.FIRST_Y] * self.columns[map_rows.SECOND_X]
        )
        first = (x * a_x + y * a_y + z * a_z) / whole
        second = (x * b_x + y * b_y + z * b_z) / whole
        third = (x * c_x + y * c_y + z * c_z) / whole
        self.unmap_linear(row, first, second, third, results)
        return map_rows.REACHED

    # --- the tool's direction ---------------------------------------------------------------------

    def point_tool(self, row: int, positions: memoryview[float]) -> None:
        """Keep the direction of the tool as the vector of the orientation."""
        self.orientation.start(self.values, row + map_rows.TOOL_DIRECTION)
        count = int(self.values[row + map_rows.JOINT_COUNT])
        for k in range(count - 1, -1, -1):
            joint = row + map_rows.JOINTS + k * map_rows.JOINT_WIDTH
            if self.values[joint + map_rows.JOINT_IS_ROTARY] > 0.0:
                angle = positions[int(self.values[joint + map_rows.JOINT_AXIS])]
                self.orientation.turn(self.values, joint + map_rows.JOINT_DIRECTION, angle)

    def name_direction(self, row: int, near: memoryview[float], results: memoryview[float]) -> int:
        """Put the programmed values for the orientation's vector into ``results`` (complete)."""
        if self.values[row + map_rows.PROGRAMMING] == map_rows.VECTOR:
            results[map_rows.VECTOR_X] = self.orientation.x
            results[map_rows.VECTOR_Y] = self.orientation.y
            results[map_rows.VECTOR_Z] = self.orientation.z
            return map_rows.REACHED
        first = int(self.values[row + map_rows.FIRST_PLACE])
        second = int(self.values[row + map_rows.SECOND_PLACE])
        answer = self.orientation.solve(
            self.values,
            row + map_rows.FIRST_DIRECTION,
            row + map_rows.SECOND_DIRECTION,
            row + map_rows.FIRST_DIRECTION,
            near[first],
            near[second],
        )
        results[first] = self.orientation.first
        results[second] = self.orientation.second
        return answer

    def turn_axes(
        self,
        row: int,
        positions: memoryview[float],
        near: memoryview[float],
        results: memoryview[float],
    ) -> int:
        """Put the rotary axes for the programmed direction into ``results`` (complete)."""
        if self.values[row + map_rows.PROGRAMMING] == map_rows.VECTOR:
            self.orientation.start(positions, map_rows.VECTOR_X)
            if not self.orientation.normalise():
                return map_rows.NO_DIRECTION
            results[map_rows.VECTOR_Z] = near[map_rows.VECTOR_Z]
        else:
            second = positions[int(self.values[row + map_rows.SECOND_PLACE])]
            self.orientation.start(self.values, row + map_rows.FIRST_DIRECTION)
            self.orientation.turn(self.values, row + map_rows.SECOND_DIRECTION, second)
            first = positions[int(self.values[row + map_rows.FIRST_PLACE])]
            self.orientation.turn(self.values, row + map_rows.FIRST_DIRECTION, first)
        return self.turn_onto_direction(row, near, results)

    def turn_onto_direction(
        self, row: int, near: memoryview[float], results: memoryview[float]
    ) -> int:
        """Put the rotary axes for the orientation's vector into ``results``."""
        if self.values[row + map_rows.SECOND_JOINT] == 0.0:
            return map_rows.OUT_OF_REACH
        first = int(self.values[row + map_rows.FIRST_JOINT])
        first += row
        second = int(self.values[row + map_rows.SECOND_JOINT])
        second += row
        first_axis = int(self.values[first + map_rows.JOINT_AXIS])
        second_axis = int(self.values[second + map_rows.JOINT_AXIS])
        answer = self.orientation.solve(
            self.values,
            first + map_rows.JOINT_DIRECTION,
            second + map_rows.JOINT_DIRECTION,
            row + map_rows.TOOL_DIRECTION,
            near[first_axis],
            near[second_axis],
        )
        if answer == map_rows.REACHED:
            results[first_axis] = self.orientation.first
            results[second_axis] = self.orientation.second
        return answer


def check_map(row: list[float], axis_count: int) -> None:
    """Raise ``ValueError`` unless every index of a map is in range and every number finite."""
    for value in row:
        check_finite(value, "number of a map")
    check_column(row, map_rows.SLOT, 0, axis_count - 1)
    check_column(row, map_rows.AXIS_COUNT, map_rows.VECTOR_X, axis_count)
    check_column(row, map_rows.PROGRAMMING, map_rows.MACHINE_ANGLES, map_rows.LATERAL)
    if row[map_rows.PROGRAMMING] == map_rows.VECTOR:
        check_column(row, map_rows.AXIS_COUNT, map_rows.VECTOR_Z + 1, axis_count)
    places = int(row[map_rows.AXIS_COUNT])
    is_chain = row[map_rows.PROGRAMMING] < map_rows.FACE_PLANE
    fewest = map_rows.VECTOR_X if is_chain else 1
    check_column(row, map_rows.JOINT_COUNT, fewest, map_rows.MAX_JOINTS)
    count = int(row[map_rows.JOINT_COUNT])
    check_column(row, map_rows.LEADING_COUNT, 0, count)
    check_column(row, map_rows.TRAILING_FIRST, 0, count)
    check_column(row, map_rows.FIRST_PLACE, 0, places - 1)
    check_column(row, map_rows.SECOND_PLACE, 0, places - 1)
    check_column(row, map_rows.FIRST_JOINT, 0, map_rows.MAP_WIDTH - map_rows.JOINT_WIDTH)
    check_column(row, map_rows.SECOND_JOINT, 0, map_rows.MAP_WIDTH - map_rows.JOINT_WIDTH)
    for k in range(count):
        joint = map_rows.JOINTS + k * map_rows.JOINT_WIDTH
        check_column(row, joint + map_rows.JOINT_MEMBER, 0, axis_count - 1)
        last = places - 1 if row[joint + map_rows.JOINT_IS_ROTARY] else map_rows.Z
        check_column(row, joint + map_rows.JOINT_AXIS, 0, last)


def check_column(row: list[float], column: int, low: int, high: int) -> None:
    """Raise ``ValueError`` unless a column of a map is an integer in ``low`` … ``high``."""
    check_range(int(row[column]), low, high, "number of a map")
