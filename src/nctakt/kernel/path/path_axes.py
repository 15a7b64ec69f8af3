# SPDX-License-Identifier: MIT
"""The axes of a path: which of them its current segment has, and which it cannot have (MO-13)."""

from __future__ import annotations

from nctakt.kernel import cells, codes, rows
from nctakt.kernel.axes.axes import Axes
from nctakt.kernel.base.arrays import doubles, integers
from nctakt.kernel.base.bounds import check_index, check_range
from nctakt.kernel.path import geometry


class PathAxes:
    """Axes of one channel's path, ``members`` among those of the machine.

    The axis at index i of ``members`` is the one at place i of the channel; the number after the
    last axis of the machine marks an empty place. ``room``: how many places there can be.

    ``maps``: the transformations; ``mapped``: the axes at one end of a transformed segment.
    ``row``: where the row of the current segment begins in ``history_rows``; ``direction``: 1
    forward over it, -1 backward. ``moved``: the axes that the path has. ``shown_…``: the state for
    which the overrides were last published, no version if a realtime cycle had set one.
    """

    def __init__(self, axes: Axes, members: list[int], room: int) -> None:
        self.axes = axes
        self.shown_pct = 0.0
        self.shown_hold = 0
        self.shown_version = -1
        self.room = max(1, room, len(members))
        self.count = 0
        self.members = integers(self.room)
        for axis in members:
            check_index(axis, axes.count, "axis")
        self.set_axes(members)
        self.moved = integers(self.room)
        self.moved_count = 0
        self.refused_axis = 0
        self.history_rows = doubles(1)
        self.maps = axes.transformations.maps
        self.slot = members[0] if members else 0
        self.unmapped = doubles(self.room)
        self.near = doubles(self.room)
        self.mapped = doubles(self.room)
        self.row = 0
        self.direction = 1

    def set_axes(self, members: list[int]) -> None:
        """Assign these axes to the path; ``axes.count`` marks a place without one.

        Raise ``ValueError`` for an unknown axis, or for too many.
        """
        check_range(len(members), 0, self.room, "number of axes")
        for axis in members:
            check_range(axis, 0, self.axes.count, "axis")
        self.count = len(members)
        for i, axis in enumerate(members):
            self.members[i] = axis
        self.shown_version = -1

    def own_axes(self) -> list[int]:
        """Return the axes at the places of the channel, as ``set_axes`` takes them."""
        return [int(self.members[i]) for i in range(self.count)]

    def is_place_free(self, i: int) -> int:
        """Return whether a place of the channel has no axis."""
        return 1 if self.members[i] == self.axes.count else 0

    def locked_axis(self) -> int:
        """Return an axis of the path that the PLC does not release; -1 for none."""
        for i in range(self.count):
            if self.axes.locked[self.members[i]]:
                return int(self.members[i])
        return -1

    def transform(self, queue: memoryview[float], row: int) -> None:
        """Activate the transformation of the command at ``row`` (MO-8)."""
        number = int(queue[row + rows.TRANSFORMATION_NUMBER])
        self.axes.transform(self.slot, number)

    def shown_map(self) -> int:
        """Return the number of the map used to show the channel's positions, 0 for none."""
        return int(self.axes.transformations.active[self.slot])

    def publish_direction(self, memory: memoryview[float], cell: int) -> None:
        """Write where the channel's tool points under a transformation, all 0 elsewhere."""
        first = 3 * (self.slot if self.count > 0 else self.axes.count)
        for i in range(3):
            memory[cell + i] = self.axes.transformations.directions[first + i]

    def show_map(self, number: int) -> None:
        """Show the channel's positions by a map, as when a segment of the history was moved."""
        if number != self.axes.transformations.active[self.slot]:
            self.axes.transform(self.slot, number)

    def refusal(self, queue_row: int, queue: memoryview[float]) -> int:
        """Return the message that refuses a segment; 0 if the path can take it.

        The axes that it moves must be where it starts, since the path never jumps (RC-409), and
        must not move independently (MO-13); ``refused_axis`` is the first that fails this.
        """
        self.map_to_axes(queue_row, queue, queue_row + rows.START)
        for i in range(self.count):
            message = self.obstacle(queue_row, queue, i)
            if message:
                self.refused_axis = self.members[i]
                return message
        return 0

    def obstacle(self, queue_row: int, queue: memoryview[float], i: int) -> int:
        """Return the message that refuses axis ``i`` of a segment; 0 if nothing does."""
        if not self.moves_axis(queue, queue_row, i):
            return 0
        if self.axes.independent[self.members[i]]:
            return 50766
        return 0 if self.is_there(queue, queue_row, queue_row + rows.START, i) else 900420

    def moves_axis(self, segments: memoryview[float], row: int, i: int) -> int:
        """Return whether a segment moves its axis ``i``; transformed all that belong to the map."""
        if segments[row + rows.TRANSFORMATION] > 0.0:
            if self.maps.has_axis(int(segments[row + rows.TRANSFORMATION]), i):
                return 1
        return geometry.moves_axis(segments, row, self.count, i)

    def map_to_axes(self, row: int, segments: memoryview[float], column: int) -> None:
        """Put the axes at the positions at ``column`` of a transformed segment in ``mapped``."""
        if segments[row + rows.TRANSFORMATION] > 0.0:
            for i in range(self.count):
                self.unmapped[i] = segments[column + i]
                self.near[i] = self.axes.command[self.members[i]]
            number = int(segments[row + rows.TRANSFORMATION])
            self.maps.inverse(number, self.unmapped, self.near, self.mapped)

    def is_there(self, segments: memoryview[float], row: int, column: int, i: int) -> int:
        """Return whether axis ``i`` is at its position at ``column``.

        Transformed to within a millionth of a micrometre (``mapped``), the rounding error.
        """
        command = self.axes.command[self.members[i]]
        if segments[row + rows.TRANSFORMATION] > 0.0:
            distance = self.mapped[i] - command
            return 1 if -1e-9 < distance < 1e-9 else 0
        return 1 if segments[column + i] == command else 0

    def claim(self) -> None:
        """Claim the axes that the segment moves until it ends (MO-13).

        If the path brakes on a segment that it cannot execute, the other targets are unchanged.
        """
        self.moved_count = 0
        self.map_to_axes(self.row, self.history_rows, self.row + rows.START)
        for i in range(self.count):
            if self.obstacle(self.row, self.history_rows, i) == 0:
                self.claim_axis(i)
        self.aim()

    def claim_again(self) -> None:
        """Claim the axes anywhere on a segment that the path had before (MO-7).

        Except those that move independently by now (MO-13).
        """
        self.moved_count = 0
        self.show_map(int(self.history_rows[self.row + rows.SHOWN_TRANSFORMATION]))
        for i in range(self.count):
            if not self.axes.independent[self.members[i]]:
                self.claim_axis(i)
        self.aim()

    def claim_free(self, column: int) -> None:
        """Claim the axes whose position is the one at ``column``, for backward motion (MO-7)."""
        self.moved_count = 0
        self.show_map(int(self.history_rows[self.row + rows.SHOWN_TRANSFORMATION]))
        self.map_to_axes(self.row, self.history_rows, column)
        for i in range(self.count):
            if not self.axes.independent[self.members[i]]:
                if self.is_there(self.history_rows, self.row, column, i):
                    self.claim_axis(i)
        self.aim()

    def claim_axis(self, i: int) -> None:
        """Claim an axis if the segment moves it; its target is the segment's end."""
        self.axes.has_moved = True
        if self.moves_axis(self.history_rows, self.row, i):
            self.moved[self.moved_count] = i
            self.moved_count += 1
            axis = self.members[i]
            end = self.row + rows.START + (self.count if self.direction > 0 else 0)
            self.axes.target[axis] = self.history_rows[end + i]
            self.axes.on_path[axis] = 1
            self.axes.show_state(axis, codes.SYNCHRONIZED_MOTION)

    def release(self) -> None:
        """Free the axes of a segment that is over."""
        for k in range(self.moved_count):
            self.axes.on_path[self.members[self.moved[k]]] = 0

    def publish_overrides(self, operator_pct: float, is_held: int) -> None:
        """Publish TOTAL of the members' independent motions (RC-305); ``is_held``: feed hold.

        Mostly it is as in the tick before, and the cells show it already.
        """
        is_shown = self.axes.override_version == self.shown_version
        is_shown = is_shown and operator_pct == self.shown_pct and is_held == self.shown_hold
        if is_shown and self.has_no_cycle_override():
            return
        for i in range(self.count):
            if self.members[i] != self.axes.count:
                self.axes.publish_override(self.members[i], operator_pct, is_held)
        self.shown_pct = operator_pct
        self.shown_hold = is_held
        self.shown_version = -1
        if self.has_no_cycle_override():
            self.shown_version = self.axes.override_version

    def has_no_cycle_override(self) -> int:
        """Return whether no realtime cycle has set the override of a member in this tick."""
        for i in range(self.count):
            axis = self.members[i]
            if axis != self.axes.count:
                cell = self.axes.first_cell + axis * cells.AXIS_CELLS
                cycle_pct = self.axes.cells[cell + cells.AXIS_OVERRIDE_VEL_CYCLE]
                if cycle_pct < 100.0 or cycle_pct > 100.0:
                    return 0
        return 1

    def show_standstill(self) -> None:
        """Show the axes of an ended segment at a standstill, unless they move independently."""
        for k in range(self.moved_count):
            axis = self.members[self.moved[k]]
            if not self.axes.independent[axis]:
                self.axes.show_state(axis, codes.STANDSTILL)
        self.moved_count = 0

    def put_axes(self, column: int) -> None:
        """Put the axes that the segment moves to the positions at ``column``."""
        self.axes.has_moved = True
        if self.history_rows[self.row + rows.TRANSFORMATION] > 0.0:
            self.map_to_axes(self.row, self.history_rows, column)
            self.put_mapped()
            return
        for k in range(self.moved_count):
            i = self.moved[k]
            self.axes.command[self.members[i]] = self.history_rows[column + i]

    def put_transformed(self, positions: memoryview[float]) -> None:
        """Put the axes that the segment moves where its map has them for ``positions``."""
        self.map_positions(positions)
        self.put_mapped()

    def map_positions(self, positions: memoryview[float]) -> None:
        """Put the positions of the axes for those of a transformed segment into ``mapped``."""
        for i in range(self.count):
            self.near[i] = self.axes.command[self.members[i]]
        number = int(self.history_rows[self.row + rows.TRANSFORMATION])
        self.maps.inverse(number, positions, self.near, self.mapped)

    def to_axes(self, positions: memoryview[float]) -> None:
        """Replace positions of the current segment by those of the axes."""
        if self.history_rows[self.row + rows.TRANSFORMATION] > 0.0:
            self.map_positions(positions)
            for i in range(self.count):
                positions[i] = self.mapped[i]

    def continues_from(self, ends: memoryview[float]) -> int:
        """Return whether a transformed segment starts where the axes were at the last end.

        ``ends`` are those of this segment then.
        """
        continues = 1
        self.map_to_axes(self.row, self.history_rows, self.row + rows.START)
        for i in range(self.count):
            distance = self.mapped[i] - ends[i]
            if distance > 1e-9 or distance < -1e-9:
                continues = 0
        self.map_to_axes(self.row, self.history_rows, self.row + rows.START + self.count)
        for i in range(self.count):
            ends[i] = self.mapped[i]
        return continues

    def put_mapped(self) -> None:
        """Put the axes that the segment moves to the positions in ``mapped``."""
        for k in range(self.moved_count):
            i = self.moved[k]
            self.axes.command[self.members[i]] = self.mapped[i]

    def aim(self) -> None:
        """Make the end of a transformed segment the target of the axes that it moves."""
        if self.history_rows[self.row + rows.TRANSFORMATION] > 0.0:
            end = self.row + rows.START + (self.count if self.direction > 0 else 0)
            self.map_to_axes(self.row, self.history_rows, end)
            for k in range(self.moved_count):
                i = self.moved[k]
                self.axes.target[self.members[i]] = self.mapped[i]
