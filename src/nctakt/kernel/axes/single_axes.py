# SPDX-License-Identifier: MIT
"""Independent motion: axes that cycles or the PLC move independently of the path (MO-11, MO-13).

Commands and queries; the motions themselves, tick by tick, are in ``axis_motions.py``. An owner is
a number: 0 none, channel * 1024 + slot + 1 a realtime cycle, ``codes.PROGRAM_OWNER`` programs, from
``codes.PLC_OWNER`` on the PLC. Each command returns 0, or the number of the message that refuses
it; then nothing changes.
"""

from __future__ import annotations

from nctakt.kernel import cells, codes, rows
from nctakt.kernel.axes.axes import Axes
from nctakt.kernel.axes.axis_motions import AxisMotions
from nctakt.kernel.base import bounds
from nctakt.kernel.base.arrays import integers
from nctakt.kernel.base.record import Record

#: The highest number that an owner can have.
MAX_OWNER = (1 << 62) - 1


class SingleAxes(AxisMotions):
    """All axes of the machine, as far as they move independently.

    ``source`` and ``serial`` say who gives the next commands; ``closed``: the axis is in a reset.
    """

    def __init__(self, axes: Axes, record: Record, cycle_time_us: int) -> None:
        super().__init__(axes, record, cycle_time_us)
        self.source = 0
        self.serial = 0
        self.requested_axis = 0
        self.has_exchanged = False
        self.closed = integers(axes.count)

    # --- commands -------------------------------------------------------------------------------

    def order(self, source: int, serial: int) -> None:
        """Set who gives the next commands: source and serial of the cycle, for events."""
        self.source = source
        self.serial = serial

    def move_to(
        self, axis: int, target: float, speed_v: float, mode: int, direction: int, owner: int
    ) -> int:
        """Move to a position; ``mode``: ``codes.ABORTING`` or ``codes.BUFFERED``.

        ``direction`` (``codes.POSITIVE`` …) counts for modulo axes only.
        """
        message = self.refusal(axis, mode, owner)
        if message == 0:
            message = self.is_beyond(axis, target)
        if message == 0:
            self.put(axis, codes.TO_POSITION, target, speed_v, direction, mode, owner)
        return message

    def move_by(self, axis: int, distance: float, speed_v: float, mode: int, owner: int) -> int:
        """Move by a distance, from the commanded position, or BUFFERED from the goal."""
        message = self.refusal(axis, mode, owner)
        start = self.axes.command[axis]
        if mode == codes.BUFFERED and self.kind[axis] == codes.TO_POSITION:
            start = self.goal[axis]
        if message == 0:
            message = self.is_beyond(axis, start + distance)
        if message == 0:
            self.put(axis, codes.BY_DISTANCE, distance, speed_v, codes.PRESENT, mode, owner)
        return message

    def run_endless(self, axis: int, speed_v: float, direction: int, mode: int, owner: int) -> int:
        """Move without a target in a direction (0: the present one) up to the software limit."""
        message = self.refusal(axis, mode, owner)
        if message == 0:
            self.put(axis, codes.ENDLESS, 0.0, speed_v, direction, mode, owner)
        return message

    def stop(self, axis: int, owner: int) -> int:
        """Brake to a standstill; drop the axis' motions, no matter who commanded them."""
        message = self.refusal(axis, codes.ABORTING, owner)
        if message == 0:
            self.give_up(axis)
        return message

    def refusal(self, axis: int, mode: int, owner: int) -> int:
        """Return the message that refuses a command for the axis now; 0 if none does.

        P-AXIS-00457 counts for realtime cycles and the PLC only: programs own their axes.
        """
        if not self.limits.is_enabled[axis] and owner != codes.PROGRAM_OWNER:
            return 50966
        if self.has_exchanged and self.is_foreign(axis, owner):
            return 50899
        if self.closed[axis]:
            return 900810
        if self.axes.couplings.closed[axis]:
            return 21481
        if self.axes.on_path[axis]:
            return 50603
        if self.faults.message[axis]:
            return 60213
        return 1704 if mode == codes.BUFFERED and self.waiting.kind[axis] else 0

    def is_foreign(self, axis: int, owner: int) -> int:
        """Return whether a cycle commands an axis that its channel does not have (any more)."""
        if owner == 0 or owner >= codes.PROGRAM_OWNER:
            return 0
        before = (self.in_channel[axis] - 1) * codes.CYCLE_OWNERS
        return 0 if before < owner <= before + codes.CYCLE_OWNERS else 1

    def put(
        self,
        axis: int,
        kind: int,
        value: float,
        speed_v: float,
        direction: int,
        mode: int,
        owner: int,
    ) -> None:
        """Store a motion: after the present one (BUFFERED), or in its place."""
        if mode == codes.ABORTING:
            self.drop(axis)
        self.waiting.kind[axis] = kind
        self.waiting.owner[axis] = owner
        self.waiting.serial[axis] = self.serial
        self.waiting.source[axis] = self.source
        self.waiting.value[axis] = value
        self.waiting.speed_v[axis] = speed_v
        self.waiting.direction[axis] = direction
        self.waiting.held[axis] = 0
        if mode == codes.ABORTING or self.kind[axis] == codes.IDLE:
            self.begin(axis)

    def execute(self, queue: memoryview[float], row: int, kind: int) -> int:
        """Execute a command for one axis, HOME … END_OSCILLATION; return 0, or the message that
        refuses it.
        """
        axis = int(queue[row + rows.HOMED_AXIS])
        if kind == rows.MOVE_ALONE:
            return self.move_alone(axis, queue, row)
        if kind == rows.OSCILLATE:
            return self.oscillate(axis, queue, row)
        if kind == rows.END_OSCILLATION:
            return self.end_oscillation(axis, queue, row)
        if kind == rows.SOFTWARE_LIMITS:
            self.limits.low[axis] = queue[row + rows.LIMIT_LOW]
            self.limits.high[axis] = queue[row + rows.LIMIT_HIGH]
            return 0
        if self.closed[axis]:
            return 900810
        if self.axes.on_path[axis] or self.kind[axis] != codes.IDLE:
            return 50603
        if kind == rows.REFER:
            self.axes.refer(axis, queue[row + rows.HOMING_DISTANCE])
            self.homing.keep(axis, self.homing.position[axis])
            return 0
        self.order(int(queue[row + rows.SOURCE]), 0)
        self.homing.running[axis] = codes.HOMED_BY_PROGRAM
        distance = queue[row + rows.HOMING_DISTANCE]
        speed_v = queue[row + rows.HOMING_SPEED]
        self.put(axis, codes.BY_DISTANCE, distance, speed_v, codes.PRESENT, codes.BUFFERED, 0)
        return 0

    def home(self, axis: int, position: float, is_listed: int, owner: int) -> int:
        """Home an axis at rest; at its zero pulse it has ``position``, or that of its list."""
        message = self.refusal(axis, codes.ABORTING, owner)
        if message:
            return message
        if not self.homing.is_allowed[axis]:
            return 50686
        if self.kind[axis] != codes.IDLE:
            return 902860
        self.homing.ordered[axis] = self.homing.position[axis] if is_listed else position
        self.homing.running[axis] = codes.HOMED_BY_PLC
        distance, speed_v = self.homing.distance[axis], self.homing.speed[axis]
        self.put(axis, codes.BY_DISTANCE, distance, speed_v, codes.PRESENT, codes.BUFFERED, owner)
        return 0

    def give_position(self, axis: int, value: float, is_relative: int, owner: int) -> int:
        """Set the position of an axis to ``value``, or shift it by ``value``, without moving it."""
        shift = value if is_relative else value - self.axes.actual_position(axis)
        message = self.refusal(axis, codes.ABORTING, owner)
        if message == 0:
            message = self.is_shift_beyond(axis, shift)
        if message == 0:
            self.move_origin(axis, shift)
        return message

    def calibrate(self, axis: int, position: float, keeps_position: int, owner: int) -> int:
        """Count an axis at rest as homed where it is, with ``position`` or its present position."""
        message = self.refusal(axis, codes.ABORTING, owner)
        if message == 0 and self.kind[axis] != codes.IDLE:
            message = 902860
        if message == 0 and not keeps_position:
            message = self.give_position(axis, position, 0, owner)
        if message == 0:
            self.homing.keep(axis, self.axes.actual_position(axis))
        return message

    def move_alone(self, axis: int, queue: memoryview[float], row: int) -> int:
        """Begin a program's independent motion: it replaces what the axis does (SA-5)."""
        value = queue[row + rows.ALONE_VALUE]
        speed_v = queue[row + rows.ALONE_SPEED]
        self.order(int(queue[row + rows.SOURCE]), 0)
        if queue[row + rows.ALONE_IS_RELATIVE] != 0.0:
            return self.move_by(axis, value, speed_v, codes.ABORTING, codes.PROGRAM_OWNER)
        direction = codes.SHORTEST
        return self.move_to(axis, value, speed_v, codes.ABORTING, direction, codes.PROGRAM_OWNER)

    def oscillate(self, axis: int, queue: memoryview[float], row: int) -> int:
        """Begin an oscillation of a program: the axis goes to its first position (SA-11)."""
        message = self.refusal(axis, codes.ABORTING, codes.PROGRAM_OWNER)
        if message:
            return message
        self.order(int(queue[row + rows.SOURCE]), 0)
        self.oscillations.first_d[axis] = queue[row + rows.SWING_FIRST]
        self.oscillations.second_d[axis] = queue[row + rows.SWING_SECOND]
        self.oscillations.stroke_d[axis] = queue[row + rows.SWING_STROKE]
        self.oscillations.first_pause[axis] = int(queue[row + rows.SWING_FIRST_TICKS])
        self.oscillations.second_pause[axis] = int(queue[row + rows.SWING_SECOND_TICKS])
        self.waiting.swings[axis] = int(queue[row + rows.SWING_COUNT])
        self.oscillations.stage[axis] = codes.APPROACH
        speed_v = queue[row + rows.SWING_SPEED]
        first_d, kind, owner = (
            self.oscillations.first_d[axis],
            codes.OSCILLATION,
            codes.PROGRAM_OWNER,
        )
        self.put(axis, kind, first_d, speed_v, codes.SHORTEST, codes.ABORTING, owner)
        return 0

    def end_oscillation(self, axis: int, queue: memoryview[float], row: int) -> int:
        """End the oscillation of an axis (OSC OFF); nothing happens if there is none."""
        how = int(queue[row + rows.ENDED_HOW])
        if self.oscillations.left[axis] == 0:
            return 0
        if how == codes.FINISHES:
            self.finish_swing(axis)
            return 0
        if how == codes.HALTS:
            return self.stop(axis, codes.PROGRAM_OWNER)
        self.order(int(queue[row + rows.SOURCE]), 0)
        speed_v, target_d = queue[row + rows.ENDED_SPEED], self.oscillations.second_d[axis]
        direction = codes.SHORTEST
        return self.move_to(axis, target_d, speed_v, codes.ABORTING, direction, codes.PROGRAM_OWNER)

    # --- all motions of an owner ----------------------------------------------------------------

    def hold(self, owner: int) -> None:
        """Brake the owner's motions from this tick on; they keep their targets (RC-111).

        A motion that waits for another owner's motion is held as soon as that motion has ended.
        """
        if self.active_count == 0:
            return
        for axis in range(self.axes.count):
            if self.waiting.kind[axis] and self.waiting.owner[axis] == owner:
                self.waiting.held[axis] = 1
            if (
                self.owner[axis] == owner
                and codes.IDLE < self.kind[axis] < codes.BRAKING
                and not self.held[axis]
            ):
                self.held[axis] = 1
                self.axes.show_state(axis, codes.STOPPING)
                self.event(rows.EVENT_AXIS_CHANGED, axis, rows.MOTION_HELD)

    def resume(self, owner: int) -> None:
        """Continue the held motions of an owner from the present state."""
        if self.active_count == 0:
            return
        for axis in range(self.axes.count):
            if self.waiting.owner[axis] == owner:
                self.waiting.held[axis] = 0
            if self.owner[axis] == owner and self.held[axis]:
                self.held[axis] = 0
                self.plans.planned_v[axis] = -1.0
                is_endless = self.kind[axis] == codes.ENDLESS
                self.axes.show_state(
                    axis, codes.CONTINUOUS_MOTION if is_endless else codes.DISCRETE_MOTION
                )
                self.event(rows.EVENT_AXIS_CHANGED, axis, rows.MOTION_CONTINUED)

    def abort(self, owner: int, with_cycle: int) -> None:
        """Brake the owner's motions and give them up, the held and the waiting ones included.

        ``with_cycle``: because the cycle has ended.
        """
        if self.active_count == 0:
            return
        for axis in range(self.axes.count):
            if self.waiting.kind[axis] and self.waiting.owner[axis] == owner:
                self.drop_next(axis, rows.WITH_CYCLE_WAITING if with_cycle else rows.NOT_WITH_CYCLE)
            if self.owner[axis] == owner and codes.IDLE < self.kind[axis] < codes.BRAKING:
                why = rows.NOT_WITH_CYCLE
                if with_cycle:
                    is_endless = self.kind[axis] == codes.ENDLESS
                    why = rows.WITH_CYCLE_ENDLESS if is_endless else rows.WITH_CYCLE
                self.drop_present(axis, why)
                self.brake(axis)

    def end_owner(self, owner: int, continues: int) -> None:
        """Abort the motions of an owner that has ended, or let them continue (RC-110)."""
        if not continues:
            self.abort(owner, 1)
            return
        for axis in range(self.axes.count):
            if self.owner[axis] == owner:
                self.owner[axis] = 0
            if self.waiting.owner[axis] == owner:
                self.waiting.owner[axis] = 0

    def open_count(self, owner: int) -> int:
        """Number of open motions of an owner, the waiting ones included (RC-408)."""
        count = 0
        for axis in range(self.axes.count):
            if codes.IDLE < self.kind[axis] < codes.BRAKING and self.owner[axis] == owner:
                count += 1
            if self.waiting.kind[axis] and self.waiting.owner[axis] == owner:
                count += 1
        return count

    def open_on(self, axis: int, owner: int) -> int:
        """Number of the owner's open motions of one axis."""
        count = 0
        if codes.IDLE < self.kind[axis] < codes.BRAKING and self.owner[axis] == owner:
            count += 1
        if self.waiting.kind[axis] and self.waiting.owner[axis] == owner:
            count += 1
        return count

    def finish_swings(self, members: memoryview[int], count: int) -> None:
        """End the oscillations of these axes at their second positions."""
        for i in range(count):
            if members[i] < self.axes.count:
                self.finish_swing(members[i])

    def finish_requested(self, queue: memoryview[float], row: int) -> None:
        """End the oscillations of the axes of a position request."""
        for i in range(int(queue[row + rows.POSITIONS_COUNT])):
            self.finish_swing(int(queue[row + rows.POSITIONS_AXES + i]))

    def all_free(self, members: memoryview[int], count: int) -> int:
        """Return whether none of these axes moves independently."""
        for i in range(count):
            if members[i] < self.axes.count and not self.is_free(members[i]):
                return 0
        return 1

    def take_faults(self, members: memoryview[int], count: int) -> int:
        """Take the errors of all these axes (``take_fault``); return the last one's message."""
        last_message = 0
        for i in range(count):
            message = self.faults.take(members[i]) if members[i] < self.axes.count else 0
            if message:
                last_message = message
        return last_message

    def request_state(self, queue: memoryview[float], row: int) -> int:
        """First state other than ``codes.AXIS_STOPPED`` of an axis in a position request."""
        for i in range(int(queue[row + rows.POSITIONS_COUNT])):
            self.requested_axis = int(queue[row + rows.POSITIONS_AXES + i])
            state = self.state_for_request(self.requested_axis)
            if state != codes.AXIS_STOPPED:
                return state
        return codes.AXIS_STOPPED

    def state_for_request(self, axis: int) -> int:
        """Return ``codes.AXIS_STOPPED`` … ``codes.AXIS_HELD`` (RC-409)."""
        if self.held[axis]:
            return codes.AXIS_HELD
        if self.kind[axis] == codes.ENDLESS:
            return codes.AXIS_MOVES_ENDLESSLY
        return codes.AXIS_STOPPED if self.is_free(axis) else codes.AXIS_MOVES

    def assign_to_channel(self, axis: int, channel: int = 1) -> None:
        """Assign this axis to a channel, from 1, which gets its errors and resets it; 0: none."""
        bounds.check_index(axis, self.axes.count, "axis")
        bounds.check_range(channel, 0, codes.MAX_SIGNAL_CHANNEL, "channel")
        self.in_channel[axis] = channel

    def note_exchange(self) -> None:
        """Note that an axis has changed its channel: cycles may name foreign ones from here on."""
        self.has_exchanged = True

    def reset(self, axis: int) -> None:
        """Brake the axis, no matter who moves it, and clear its error (RC-007).

        Until ``reopen`` it takes no command, else the reset might never end.
        """
        self.closed[axis] = 1
        self.limits.put_back(axis)
        self.give_up(axis)
        self.clear_fault(axis)

    def reopen(self, axis: int) -> None:
        """Let the axis take commands again after the channel's reset; it follows no master."""
        self.closed[axis] = 0
        self.axes.couplings.uncouple(axis)

    def clear_fault(self, axis: int) -> int:
        """Leave ErrorStop (PLCopen's MC_Reset); return 0, or the message that refuses it."""
        if not self.limits.is_enabled[axis]:
            return 50966
        if self.faults.message[axis]:
            self.faults.take(axis)
            self.faults.message[axis] = 0
            self.axes.show_state(axis, codes.STOPPING if self.kind[axis] else codes.STANDSTILL)
        return 0

    # --- queries --------------------------------------------------------------------------------

    def is_free(self, axis: int) -> int:
        """Return whether the path may move the axis: no motion, none held, none braking (MO-13)."""
        return 1 if self.kind[axis] == codes.IDLE else 0

    def is_held(self, axis: int) -> int:
        """Return whether a motion of the axis is held."""
        return 1 if self.held[axis] else 0

    def state(self, axis: int) -> int:
        """The PLCopen state (``codes.STANDSTILL`` …)."""
        shown = int(self.axes.cells[self.axes.cell_of(axis) + cells.AXIS_STATE])
        return shown

    def is_ending(self, axis: int) -> int:
        """Return whether the axis will come to rest without another command."""
        if self.kind[axis] == codes.BRAKING:
            return 1
        if self.kind[axis] == codes.IDLE:
            return 0
        if self.held[axis]:
            return 0 if self.plans.speed[axis] == 0.0 else 1
        if self.plans.planned_v[axis] == 0.0:
            return 0
        if self.waiting.kind[axis] and not self.waiting.held[axis]:
            return 1
        if self.oscillations.left[axis] < 0:
            return 0
        return 1 if self.kind[axis] == codes.TO_POSITION else 0

    def event_bound(self, commands: int) -> int:
        """Return the highest number of events in a tick with ``commands`` commands."""
        return 6 * self.axes.count + 4 * commands * self.active_count

    # --- Python's side, between two ticks -------------------------------------------------------

    def is_command(
        self, axis: int, value: float, speed_v: float, mode: int, direction: int, owner: int
    ) -> bool:
        """Return whether all numbers of a command of an axis are in their ranges."""
        return (
            0 <= axis < self.axes.count
            and value - value == 0.0
            and speed_v - speed_v == 0.0
            and codes.ABORTING <= mode <= codes.BUFFERED
            and codes.NEGATIVE <= direction <= codes.SHORTEST
            and owner >> 62 == 0  # 0 … MAX_OWNER
        )

    def check_command(
        self, axis: int, value: float, speed_v: float, mode: int, direction: int, owner: int
    ) -> None:
        """Raise ``ValueError`` for a number that no command of an axis has."""
        try:
            is_right = self.is_command(axis, value, speed_v, mode, direction, owner)
        except (OverflowError, TypeError, ValueError):  # no number of 64 bits
            is_right = False
        if not is_right:
            bounds.check_index(axis, self.axes.count, "axis")
            bounds.check_finite(value, "position or distance")
            bounds.check_finite(speed_v, "speed")
            bounds.check_range(mode, codes.ABORTING, codes.BUFFERED, "buffer mode")
            bounds.check_range(direction, codes.NEGATIVE, codes.SHORTEST, "direction")
            bounds.check_range(owner, 0, MAX_OWNER, "owner")

    def absolute(
        self, axis: int, target: float, speed_v: float, mode: int, direction: int, owner: int
    ) -> int:
        """``move_to`` for Python: raises ``ValueError`` for numbers out of range."""
        self.check_command(axis, target, speed_v, mode, direction, owner)
        return self.move_to(axis, target, speed_v, mode, direction, owner)

    def relative(self, axis: int, distance: float, speed_v: float, mode: int, owner: int) -> int:
        """``move_by`` for Python: raises ``ValueError`` for numbers out of range."""
        self.check_command(axis, distance, speed_v, mode, codes.PRESENT, owner)
        return self.move_by(axis, distance, speed_v, mode, owner)

    def velocity(self, axis: int, speed_v: float, direction: int, mode: int, owner: int) -> int:
        """``run_endless`` for Python: raises ``ValueError`` for numbers out of range."""
        self.check_command(axis, 0.0, speed_v, mode, direction, owner)
        return self.run_endless(axis, speed_v, direction, mode, owner)

    def halt(self, axis: int, owner: int) -> int:
        """``stop`` for Python: raises ``ValueError`` for an unknown axis."""
        self.check_command(axis, 0.0, 0.0, codes.ABORTING, codes.PRESENT, owner)
        return self.stop(axis, owner)

    def command_owner(self, what: str, owner: int) -> None:
        """``hold``, ``resume``, ``abort``, ``end`` or ``leave`` an owner's motions."""
        bounds.check_range(owner, 0, MAX_OWNER, "owner")
        if what == "hold":
            self.hold(owner)
        elif what == "resume":
            self.resume(owner)
        elif what == "abort":
            self.abort(owner, 0)
        else:
            self.end_owner(owner, 1 if what == "leave" else 0)

    def clear(self, axis: int) -> None:
        """Reset one axis and let it take commands at once."""
        bounds.check_index(axis, self.axes.count, "axis")
        self.reset(axis)
        self.reopen(axis)

    def state_of(self, axis: int) -> tuple[int, float, float]:
        """PLCopen state, speed per s and acceleration per s² of an axis."""
        bounds.check_index(axis, self.axes.count, "axis")
        return self.state(axis), self.plans.speed[axis], self.plans.acceleration[axis]

    def present_owner(self, axis: int) -> int:
        """Owner of the present motion, 0 without one."""
        bounds.check_index(axis, self.axes.count, "axis")
        return self.owner[axis]

    def arrived_owner(self, axis: int) -> int:
        """Owner of the motion that came to its target last."""
        bounds.check_index(axis, self.axes.count, "axis")
        return self.arrived[axis]

    def fault_of(self, axis: int) -> int:
        """Message of the error that the axis is in, 0 without one."""
        bounds.check_index(axis, self.axes.count, "axis")
        return abs(self.faults.message[axis])

    def at_speed(self, axis: int) -> bool:
        """Return whether an endless motion has reached its speed."""
        bounds.check_index(axis, self.axes.count, "axis")
        return bool(self.is_at_speed(axis))

    def opened(self, owner: int) -> int:
        """Number of open motions of an owner; raise ``ValueError`` for no owner."""
        bounds.check_range(owner, 0, MAX_OWNER, "owner")
        return self.open_count(owner)

    def moves(self, axis: int) -> bool:
        """Return whether the axis has an independent motion, even if held."""
        bounds.check_index(axis, self.axes.count, "axis")
        return not self.is_free(axis)

    def ending_count(self) -> int:
        """Number of axes that will come to rest unaided: a run waits for them (RC-006)."""
        return sum(self.is_ending(axis) for axis in range(self.axes.count))
