# SPDX-License-Identifier: MIT
"""The PLC's requests for single axes: posted between two ticks, latched by the next.

Each request has its own owner number, from ``codes.PLC_OWNER`` on, so that the PLC can follow its
progress: its answer, whether its motion is open, whether it has arrived.
"""

from __future__ import annotations

from nctakt.kernel import codes
from nctakt.kernel.axes.single_axes import SingleAxes
from nctakt.kernel.base.arrays import doubles, integers
from nctakt.kernel.base.bounds import check_range

#: Requests whose answers are kept; more cannot be posted for one tick.
CAPACITY = 256


class AxisRequests:
    """The requests of the coming tick, and the answers to those of the last ones."""

    def __init__(self, single_axes: SingleAxes) -> None:
        self.single_axes = single_axes
        self.capacity = CAPACITY
        self.kind = integers(CAPACITY)
        self.axis = integers(CAPACITY)
        self.value = doubles(CAPACITY)
        self.speed_v = doubles(CAPACITY)
        self.mode = integers(CAPACITY)
        self.direction = integers(CAPACITY)
        self.answer = integers(CAPACITY)
        self.posted = 0
        self.latched = 0

    # --- Python's side, between two ticks -------------------------------------------------------

    def post(
        self, kind: int, axis: int, value: float, speed_v: float, mode: int, direction: int
    ) -> int:
        """Post a request for the next tick; return its owner number, 0 if there is no room."""
        check_range(kind, codes.ABSOLUTE, codes.CALIBRATION, "kind of request")
        self.single_axes.check_command(axis, value, speed_v, mode, direction, codes.PLC_OWNER)
        return self.put(kind, axis, value, speed_v, mode, direction)

    def put(
        self, kind: int, axis: int, value: float, speed_v: float, mode: int, direction: int
    ) -> int:
        """Post a request whose numbers were checked, as ``post``."""
        if self.posted - self.latched >= self.capacity:
            return 0
        slot = self.posted % self.capacity
        self.kind[slot] = kind
        self.axis[slot] = axis
        self.value[slot] = value
        self.speed_v[slot] = speed_v
        self.mode[slot] = mode
        self.direction[slot] = direction
        self.answer[slot] = -1
        self.posted += 1
        return codes.PLC_OWNER + self.posted - 1

    def answer_to(self, owner: int) -> int:
        """Answer to a request: 0 accepted, -1 not latched yet, else the refusing message.

        Raises ``ValueError`` for a number that is not the owner of one of the last requests.
        """
        newest = codes.PLC_OWNER + self.posted - 1
        oldest = max(codes.PLC_OWNER, newest - self.capacity + 1)
        check_range(owner, oldest, newest, "request")
        return self.answer[(owner - codes.PLC_OWNER) % self.capacity]

    def answer_of(self, owner: int) -> int:
        """Answer as ``answer_to``; 0 for a number that is not the owner of one of the last ones."""
        newest = codes.PLC_OWNER + self.posted - 1
        if owner < codes.PLC_OWNER or owner > newest or owner <= newest - self.capacity:
            return 0
        return self.answer[(owner - codes.PLC_OWNER) % self.capacity]

    def is_open(self, owner: int) -> bool:
        """Return whether the motion of a request runs or waits."""
        return self.single_axes.opened(owner) > 0

    def is_active(self, axis: int, owner: int) -> bool:
        """Return whether it is the present motion of the axis."""
        return self.single_axes.present_owner(axis) == owner

    def has_arrived(self, axis: int, owner: int) -> bool:
        """Return whether it was the last motion of the axis to come to its target."""
        return self.single_axes.arrived_owner(axis) == owner

    # --- the tick -------------------------------------------------------------------------------

    def event_bound(self) -> int:
        """Highest number of events of the coming tick's requests."""
        return 4 * (self.posted - self.latched)

    def latch(self) -> None:
        """Give the requests to the axes in their order, at the start of a tick."""
        while self.latched < self.posted:
            self.give(self.latched % self.capacity)
            self.latched += 1

    def give(self, slot: int) -> None:
        """Pass one request to its axis and keep the answer."""
        axis = self.axis[slot]
        owner = codes.PLC_OWNER + self.latched
        mode = int(self.mode[slot])
        direction = int(self.direction[slot])
        kind = self.kind[slot]
        self.single_axes.order(0, 0)
        if kind == codes.ABSOLUTE:
            self.answer[slot] = self.single_axes.move_to(
                axis, self.value[slot], self.speed_v[slot], mode, direction, owner
            )
        elif kind == codes.RELATIVE:
            self.answer[slot] = self.single_axes.move_by(
                axis, self.value[slot], self.speed_v[slot], mode, owner
            )
        elif kind == codes.VELOCITY:
            self.answer[slot] = self.single_axes.run_endless(
                axis, self.speed_v[slot], direction, mode, owner
            )
        elif kind == codes.HALT:
            self.answer[slot] = self.single_axes.stop(axis, owner)
        elif kind == codes.CLEAR_FAULT:
            self.answer[slot] = self.single_axes.clear_fault(axis)
        elif kind == codes.HOMING:
            self.answer[slot] = self.single_axes.home(axis, self.value[slot], mode, owner)
        elif kind == codes.POSITION:
            self.answer[slot] = self.single_axes.give_position(axis, self.value[slot], mode, owner)
        else:
            self.answer[slot] = self.single_axes.calibrate(axis, self.value[slot], mode, owner)
