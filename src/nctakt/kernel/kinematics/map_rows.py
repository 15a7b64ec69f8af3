# SPDX-License-Identifier: MIT
"""The columns of a kinematic map: one row of float64, lengths in mm, angles in degrees.

A map leads from the positions of a channel's axes to those of the tool in the workpiece and back.
Axes are named by their places in the channel. ``map_rows.pxd`` has the same names as constants of
C; ``scripts/constants`` writes it from this file.
"""

from __future__ import annotations

#: Components of a vector, and places of the linear axes.
X, Y, Z = range(3)
#: Places of a vector along the tool, where one is programmed.
VECTOR_X, VECTOR_Y, VECTOR_Z = range(3, 6)
#: Components of three vectors, one after the other.
FIRST_X, FIRST_Y, FIRST_Z, SECOND_X, SECOND_Y, SECOND_Z, THIRD_X, THIRD_Y, THIRD_Z = range(9)

#: Meanings of the words of the rotary axes.
(
    MACHINE_ANGLES,  # the positions of the rotary axes themselves
    VECTOR,  # a vector along the tool, in the places 3 to 5
    TWO_ANGLES,  # angles of an ideal chain of two rotary axes
    FACE_PLANE,  # with the first axis a place in mm on the face that turns with the rotary axis
    LATERAL,  # mm on the surface of a cylinder that turns with the rotary axis
) = range(5)

#: Results of ``inverse``.
(
    REACHED,
    OUT_OF_REACH,  # no position of the axes leads there
    NO_DIRECTION,  # the vector along the tool is zero
    SINGULAR,  # rotary axes have turned two linear ones into one direction, or three into a plane
) = range(4)

#: Why the axes cannot follow a block.
(
    AXIS_OUTSIDE,  # an axis leaves its limits
    WAY_OUT_OF_REACH,  # no position of the axes leads to a point of it
    AXIS_JUMPS,  # an axis would have to jump: a pole
) = range(3)

#: Columns of every map.
(
    SLOT,  # number of the channel's first axis in the machine
    AXIS_COUNT,  # how many axes the channel has
    PROGRAMMING,  # ``MACHINE_ANGLES`` …
    JOINT_COUNT,
    LEADING_COUNT,  # rotary joints before the first linear one
    TRAILING_FIRST,  # the first of the rotary joints after the last linear one
    SECOND_STEP,  # number of the map applied to the results of this one; 0: none
    IS_SPLIT,  # 1: no rotary joint between two linear ones
    TOOL,  # three columns: the tool's tip with all axes at 0
    _TOOL_Y,
    _TOOL_Z,
    TOOL_DIRECTION,  # three columns: from the tip to the clamp with all axes at 0, length 1
    _TOOL_DIRECTION_Y,
    _TOOL_DIRECTION_Z,
    FIRST_JOINT,  # complete: the column where the first rotary joint begins …
    SECOND_JOINT,  # … and the second one
    FIRST_PLACE,  # ``TWO_ANGLES``: the axis that the first angle is programmed with …
    SECOND_PLACE,  # … and the second one; ``FACE_PLANE``, ``LATERAL``: the radial and rotary axis
    FIRST_DIRECTION,  # three columns: the axis of the first angle; the tool's direction at 0, 0
    _FIRST_DIRECTION_Y,
    _FIRST_DIRECTION_Z,
    SECOND_DIRECTION,  # three columns: the axis of the second angle
    _SECOND_DIRECTION_Y,
    _SECOND_DIRECTION_Z,
    SHIFT,  # three columns: displacement of the linear joints with the linear axes at 0
    _SHIFT_Y,
    _SHIFT_Z,
    MATRIX,  # nine columns, row by row: linear axes -> linear joints, or -> motion where split
) = range(28)
#: Nine columns: the inverse of ``MATRIX``; then the joints begin.
INVERSE = MATRIX + 9
JOINTS = INVERSE + 9

#: Columns of a joint.
(
    JOINT_AXIS,  # its axis; of a linear one its place 0, 1, 2
    JOINT_MEMBER,  # number of this axis in the machine
    JOINT_IS_ROTARY,
    JOINT_DIRECTION,  # three columns: along it or about it, length 1
    _JOINT_DIRECTION_Y,
    _JOINT_DIRECTION_Z,
    JOINT_POINT,  # three columns: a point of a rotary axis
    _JOINT_POINT_Y,
    _JOINT_POINT_Z,
    JOINT_WIDTH,
) = range(10)

#: The most joints of a map, and its columns.
MAX_JOINTS = 6
MAP_WIDTH = JOINTS + MAX_JOINTS * JOINT_WIDTH
