# SPDX-License-Identifier: MIT
"""PLCopen function blocks with which a PLC moves single axes (P-AXIS-00457).

``MC_MoveAbsolute``, ``MC_MoveRelative``, ``MC_MoveVelocity``, ``MC_Halt``, ``MC_Reset``: one object
for each use, called after each tick with its inputs. A rising ``execute`` gives the command, which
the next tick latches; the outputs are attributes: ``busy``, ``active``, ``done``
(``in_velocity``), ``command_aborted``, ``error``, ``error_id``. They fall with ``execute``, but
last for one call at least. Speeds are mm/s or °/s and at most those of the axis; acceleration and
jerk are those of the axis.
An axis has one owner at a time (MO-13): a further command aborts the previous one, a command for an
axis in motion on the path is refused.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from nctakt.kernel import codes

if TYPE_CHECKING:
    from nctakt.run.plcs.plc_view import PlcView

#: Directions of modulo axes and of endless motions.
POSITIVE, NEGATIVE, CURRENT, SHORTEST = 1, -1, 0, 2

_ERROR_STOP = 5


class AxisBlock:
    """The common part of the blocks: the outputs, and how they follow a command."""

    def __init__(self, axis: str) -> None:
        self.axis = axis
        self._owner = 0
        self._executed = False
        self._is_accepted = False
        self._clear()

    def _clear(self) -> None:
        self.busy = False
        self.active = False
        self.done = False
        self.command_aborted = False
        self.error = False
        self.error_id = 0

    def _call(
        self,
        hli: PlcView,
        execute: bool,
        kind: int,
        value: float,
        speed: float,
        mode: int,
        direction: int,
    ) -> None:
        """Give a command at a rising edge, else follow the last one."""
        rises = execute and not self._executed
        self._executed = execute
        if rises:
            self._clear()
            self._owner = hli.request_axis(kind, self.axis, value, speed, mode, direction)
            self._is_accepted = False
            self.busy = True
        elif self.busy:
            self._follow(hli)
        elif not execute:
            self._clear()

    def _follow(self, hli: PlcView) -> None:
        if not self._is_accepted:
            answer = hli.axis_answer(self._owner)
            if answer > 0:
                self._fail(answer)
            self._is_accepted = answer == 0
        if self._is_accepted:
            self._look(hli)

    def _look(self, hli: PlcView) -> None:
        """Set the outputs of an accepted command."""
        self.active = hli.is_axis_active(self.axis, self._owner)
        if hli.is_axis_open(self._owner):
            return
        if hli.has_axis_arrived(self.axis, self._owner):
            self._end()
            self.done = True
        elif hli.axis(self.axis)["state"] == _ERROR_STOP:
            self._fail(hli.axis_fault(self.axis))
        else:
            self._end()
            self.command_aborted = True

    def _end(self) -> None:
        self.busy = False
        self.active = False

    def _fail(self, number: int) -> None:
        self._end()
        self.error = True
        self.error_id = number


class MC_MoveAbsolute(AxisBlock):
    """MC_MoveAbsolute: moves to a position in ACS, in mm or °."""

    def __call__(
        self,
        hli: PlcView,
        *,
        execute: bool,
        position: float,
        velocity: float,
        direction: int = SHORTEST,
        buffered: bool = False,
    ) -> None:
        """``direction``: of a modulo axis; ``buffered``: after the running motion."""
        self._call(hli, execute, codes.ABSOLUTE, position, velocity, int(buffered), direction)


class MC_MoveRelative(AxisBlock):
    """MC_MoveRelative: moves by a distance from the command position, in mm or °."""

    def __call__(
        self,
        hli: PlcView,
        *,
        execute: bool,
        distance: float,
        velocity: float,
        buffered: bool = False,
    ) -> None:
        """``buffered``: after the running motion, from its end."""
        self._call(hli, execute, codes.RELATIVE, distance, velocity, int(buffered), SHORTEST)


class MC_MoveVelocity(AxisBlock):
    """MC_MoveVelocity: runs until another command; ``in_velocity`` at speed."""

    in_velocity = False

    def __call__(
        self,
        hli: PlcView,
        *,
        execute: bool,
        velocity: float,
        direction: int = POSITIVE,
        buffered: bool = False,
    ) -> None:
        """``direction``: ``POSITIVE``, ``NEGATIVE`` or ``CURRENT``."""
        self._call(hli, execute, codes.VELOCITY, 0.0, velocity, int(buffered), direction)
        self.in_velocity = self.active and hli.is_axis_at_speed(self.axis)


class MC_Halt(AxisBlock):
    """MC_Halt: brakes any motion to a standstill; the axis accepts commands meanwhile."""

    def __call__(self, hli: PlcView, *, execute: bool) -> None:
        """``done`` when the axis is at rest, ``command_aborted`` if it moves again before."""
        self._call(hli, execute, codes.HALT, 0.0, 0.0, 0, SHORTEST)

    def _look(self, hli: PlcView) -> None:
        state = hli.axis(self.axis)["state"]
        self.active = state == 4  # Stopping
        if self.active:
            return
        self._end()
        if state == _ERROR_STOP:
            self._fail(hli.axis_fault(self.axis))
        else:
            self.done = state == 1
            self.command_aborted = not self.done


class MC_Reset(AxisBlock):
    """MC_Reset: leaves ErrorStop, so that the axis accepts commands; a channel's error stays."""

    def __call__(self, hli: PlcView, *, execute: bool) -> None:
        """``done`` in the tick that latches it, even for an axis without an error."""
        self._call(hli, execute, codes.CLEAR_FAULT, 0.0, 0.0, 0, SHORTEST)

    def _look(self, hli: PlcView) -> None:
        self._end()
        self.done = True
