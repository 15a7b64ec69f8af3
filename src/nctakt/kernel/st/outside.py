# SPDX-License-Identifier: MIT
"""Access of PLC code to the machine by calls: pointers of the interface, motions of axes.

A command of an axis goes the same way as one of a PLC in Python (``kernel.plc.axis_requests``): the
next tick latches it, and the number of its owner identifies it for queries (ST-743).
"""

from __future__ import annotations

from nctakt.kernel import codes
from nctakt.kernel.base.arrays import doubles, integers
from nctakt.kernel.base.bounds import check_range
from nctakt.kernel.plc.axis_requests import AxisRequests
from nctakt.kernel.st import kinds, words


class Outside:
    """Base, and null object: no machine is connected."""

    def open(self, memory: memoryview) -> None:
        """Let the pointers of the interface point to it."""

    def command(
        self, kind: int, axis: int, value: float, speed_v: float, mode: int, direction: int
    ) -> int:
        """Command an axis for the next tick; return the owner, or the message that refuses it,
        negative.
        """
        return 0

    def power(self, axis: int, is_on: int) -> int:
        """Release an axis for commands, or brake it; return whether it is released."""
        return 0

    def lock(self, axis: int, is_on: int) -> int:
        """Refuse commands for an axis, or take them again; return whether it is locked."""
        return 0

    def override(self, axis: int, factor: float) -> int:
        """Multiply the speeds of independent motions by a factor; return whether it is in 0 … 1."""
        return 0

    def look(self, what: int, axis: int, owner: int) -> int:
        """Return a value of an axis or a command."""
        return 0

    def measure(self, what: int, axis: int) -> float:
        """Return a position, speed or acceleration of an axis."""
        return 0.0

    def follow(self) -> None:
        """Note how the axes move, at the end of a tick."""


class Connection(Outside):
    """The axes of a machine, and the pointers of the interface.

    ``pointers``: rows of address of the variable and value. ``numbers``: logical number of each
    axis; ``measures``: ``kinds.AXIS_MEASURES`` cells for each axis of the machine's ``cells``.
    ``refused`` are the messages for a value that no axis takes, and for an axis without a release.
    Speeds are noted from ``watch`` on.
    """

    def __init__(
        self,
        requests: AxisRequests,
        pointers: list[tuple[int, int]],
        numbers: list[int],
        measures: list[int],
        memory: bytearray,
        refused: tuple[int, int],
    ) -> None:
        self.requests = requests
        self.single_axes = self.requests.single_axes
        self.count = len(numbers)
        check_range(
            len(measures),
            kinds.AXIS_MEASURES * self.count,
            kinds.AXIS_MEASURES * self.count,
            "cells",
        )
        self.cells = memoryview(memory).cast("d")
        self.numbers = integers(self.count + 1)
        self.is_powered = integers(self.count + 1)
        self.is_locked = integers(self.count + 1)
        self.measures = integers(len(measures) + 8)
        for i, number in enumerate(numbers):
            self.numbers[i] = number
        for i, cell in enumerate(measures):
            check_range(cell, 0, len(self.cells) - 1, "cell")
            self.measures[i] = cell
        self.pointer_count = len(pointers)
        self.pointer_at = integers(len(pointers) + 8)
        self.pointer_value = integers(len(pointers) + 8)
        for i, (at, value) in enumerate(pointers):
            check_range(at, kinds.NULL_BYTES, kinds.MAX_MEMORY, "address")
            self.pointer_at[i] = at
            self.pointer_value[i] = value
        self.wrong_value, self.not_released = refused
        self.ticks_per_s = 0.0
        self.notes = doubles(kinds.AXIS_NOTES * self.count + 1)

    def watch(self, ticks_per_s: float) -> None:
        """Note speeds and accelerations of the axes from the next tick on."""
        self.ticks_per_s = ticks_per_s
        for i in range(self.count):
            self.note(i)
            for k in range(kinds.NOTED_ACTUAL):
                self.notes[kinds.AXIS_NOTES * i + k] = 0.0

    def follow(self) -> None:
        if self.ticks_per_s > 0.0:
            for i in range(self.count):
                self.note(i)

    def note(self, axis: int) -> None:
        """Note positions, speeds and accelerations of an axis.

        Setting the position of an axis is not a motion: it is at rest, or the step is too large for
        one.
        """
        at = kinds.AXIS_NOTES * axis
        command = self.single_axes.axes.command[axis]
        actual = self.single_axes.axes.actual_position(axis)
        before = self.notes[at + kinds.NOTED_ACTUAL]
        actual_v = self.single_axes.axes.distance(axis, before, actual) * self.ticks_per_s
        before = self.notes[at + kinds.NOTED_COMMAND]
        command_v = self.single_axes.axes.distance(axis, before, command) * self.ticks_per_s
        limit_v = 1.01 * self.single_axes.limits.max_v[axis]
        if command_v != 0.0 and self.single_axes.state(axis) == codes.STANDSTILL:
            actual_v = 0.0
            command_v = 0.0
        elif limit_v > 0.0 and (command_v > limit_v or command_v < 0.0 - limit_v):
            actual_v = self.notes[at + kinds.NOTED_ACTUAL_SPEED]
            command_v = self.notes[at + kinds.NOTED_SET_SPEED]
        change_v = actual_v - self.notes[at + kinds.NOTED_ACTUAL_SPEED]
        self.notes[at + kinds.NOTED_ACTUAL_ACCELERATION] = change_v * self.ticks_per_s
        change_v = command_v - self.notes[at + kinds.NOTED_SET_SPEED]
        self.notes[at + kinds.NOTED_SET_ACCELERATION] = change_v * self.ticks_per_s
        self.notes[at + kinds.NOTED_ACTUAL_SPEED] = actual_v
        self.notes[at + kinds.NOTED_SET_SPEED] = command_v
        self.notes[at + kinds.NOTED_ACTUAL] = actual
        self.notes[at + kinds.NOTED_COMMAND] = command

    def open(self, memory: memoryview) -> None:
        for i in range(self.pointer_count):
            words.store(memory, self.pointer_at[i], kinds.U64, self.pointer_value[i])

    def command(
        self, kind: int, axis: int, value: float, speed_v: float, mode: int, direction: int
    ) -> int:
        if axis < 0 or axis >= self.count:
            return -self.wrong_value
        is_motion = kind >= codes.ABSOLUTE and kind <= codes.VELOCITY
        needs_release = is_motion or kind == codes.HOMING
        if needs_release and (not self.is_powered[axis] or self.is_locked[axis]):
            return -self.not_released
        is_right = self.single_axes.is_command(
            axis, value, speed_v, mode, direction, codes.PLC_OWNER
        )
        if not is_right or (is_motion and speed_v <= 0.0):
            return -self.wrong_value
        return self.requests.put(kind, axis, value, speed_v, mode, direction)

    def power(self, axis: int, is_on: int) -> int:
        if axis < 0 or axis >= self.count:
            return 0
        if self.is_powered[axis] and not is_on:
            self.requests.put(codes.HALT, axis, 0.0, 0.0, 0, codes.SHORTEST)
        self.is_powered[axis] = 1 if is_on else 0
        return is_on

    def lock(self, axis: int, is_on: int) -> int:
        if axis < 0 or axis >= self.count:
            return 0
        self.is_locked[axis] = is_on
        return is_on

    def override(self, axis: int, factor: float) -> int:
        if axis < 0 or axis >= self.count or not (factor >= 0.0 and factor <= 1.0):
            return 0
        self.single_axes.axes.plc_factor[axis] = factor
        self.single_axes.axes.override_version += 1
        return 1

    def look(self, what: int, axis: int, owner: int) -> int:
        if what == kinds.AXIS_ANSWER:
            return self.requests.answer_of(owner)
        if what == kinds.AXIS_OPEN:
            return 1 if self.single_axes.open_count(owner) > 0 else 0
        if what == kinds.AXIS_INDEX:
            for i in range(self.count):
                if self.numbers[i] == axis:
                    return i
            return -1
        if axis < 0 or axis >= self.count:
            return 0
        if what == kinds.AXIS_ACTIVE:
            return 1 if self.single_axes.owner[axis] == owner else 0
        if what == kinds.AXIS_ARRIVED:
            return 1 if self.single_axes.arrived[axis] == owner else 0
        if what == kinds.AXIS_AT_SPEED:
            return self.single_axes.is_at_speed(axis)
        if what == kinds.AXIS_FAULT:
            fault = self.single_axes.faults.message[axis]
            return fault if fault >= 0 else 0 - fault
        if what == kinds.AXIS_STATE:
            return self.single_axes.state(axis)
        if what == kinds.AXIS_SHOWN_STATE:
            return self.shown_state(axis)
        if what == kinds.AXIS_HOMES:
            return 1 if self.single_axes.homing.running[axis] else 0
        if what == kinds.AXIS_IS_HOMED:
            return self.single_axes.homing.is_homed[axis]
        return self.is_powered[axis]

    def shown_state(self, axis: int) -> int:
        """The PLCopen state; an axis kept at rest by MC_Stop is Stopping (ST-744)."""
        state = self.single_axes.state(axis)
        return codes.STOPPING if self.is_locked[axis] and state == codes.STANDSTILL else state

    def measure(self, what: int, axis: int) -> float:
        if axis < 0 or axis >= self.count or what < 0 or what > kinds.AXIS_SET_ACCELERATION:
            return 0.0
        if what > kinds.AXIS_LAG:
            return self.notes[kinds.AXIS_NOTES * axis + what - kinds.AXIS_ACTUAL_SPEED]
        if what == kinds.AXIS_LAG:
            command = self.single_axes.axes.command[axis]
            actual = self.single_axes.axes.actual_position(axis)
            return self.single_axes.axes.distance(axis, actual, command)
        if what >= kinds.AXIS_MEASURES:
            return self.limit(what, axis)
        return self.cells[self.measures[axis * kinds.AXIS_MEASURES + what]]

    def limit(self, what: int, axis: int) -> float:
        """Return a limit of the axis' independent motions, in mm or degrees, and the same per s."""
        if what == kinds.AXIS_HIGH:
            return self.single_axes.limits.high[axis]
        if what == kinds.AXIS_LOW:
            return self.single_axes.limits.low[axis]
        if what == kinds.AXIS_SPEED_LIMIT:
            return self.single_axes.limits.max_v[axis]
        if what == kinds.AXIS_ACCELERATION_LIMIT:
            return self.single_axes.limits.max_a[axis]
        return self.single_axes.limits.max_j[axis]
