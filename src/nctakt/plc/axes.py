# SPDX-License-Identifier: MIT
"""Function blocks with which a PLC moves single axes, as PLCopen has them (P-AXIS-00457).

``MC_MoveAbsolute``, ``MC_MoveRelative``, ``MC_MoveVelocity``, ``MC_Halt``, ``MC_Reset``: one object
for each use, called behind each tick with its inputs. A rising ``execute`` gives the command, which
is latched by the next tick; the outputs are attributes: ``busy``, ``active``, ``done``
(``in_velocity``), ``command_aborted``, ``error``, ``error_id``. They fall with ``execute``, but
stand for one call at least. Speeds are mm/s or °/s and at most those of the axis; acceleration and
jerk are the axis'.
An axis has one owner at a time (MO-13): what another command takes over is aborted, what the path
moves is refused.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from nctakt.kernel import codes

if TYPE_CHECKING:
    from nctakt.run.plc_view import PlcView

#: Directions of modulo axes and of endless motions.
POSITIVE, NEGATIVE, CURRENT, SHORTEST = 1, -1, 0, 2

_ERROR_STOP = 5


class AxisBlock:
    """What the blocks have in common: the outputs, and how they follow a command."""

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
        way: int,
    ) -> None:
        """One call: a rising edge gives a command, else the last one is followed."""
        rises = execute and not self._executed
        self._executed = execute
        if rises:
            self._clear()
            self._owner = hli.request_axis(kind, self.axis, value, speed, mode, way)
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
        """The command was accepted: what has become of it."""
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
    """To a position in ACS, mm or °."""

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
        """``direction`` counts for modulo axes; ``buffered``: behind the running motion."""
        self._call(hli, execute, codes.ABSOLUTE, position, velocity, int(buffered), direction)


class MC_MoveRelative(AxisBlock):
    """By a distance from where the axis is commanded to be."""

    def __call__(
        self,
        hli: PlcView,
        *,
        execute: bool,
        distance: float,
        velocity: float,
        buffered: bool = False,
    ) -> None:
        """``buffered``: behind the running motion, from where that one ends."""
        self._call(hli, execute, codes.RELATIVE, distance, velocity, int(buffered), SHORTEST)


class MC_MoveVelocity(AxisBlock):
    """On and on; ``in_velocity`` while the speed is reached. Ends by another command."""

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
    """Brake to a stand, whoever has commanded the motion; the axis takes commands meanwhile."""

    def __call__(self, hli: PlcView, *, execute: bool) -> None:
        """Done when the axis stands, aborted when it moves again before."""
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
    """Leave ErrorStop: the axis takes commands again. The channel's own error stays until RESET."""

    def __call__(self, hli: PlcView, *, execute: bool) -> None:
        """Done in the tick that latches it, with an axis that has no error as well."""
        self._call(hli, execute, codes.CLEAR_FAULT, 0.0, 0.0, 0, SHORTEST)

    def _look(self, hli: PlcView) -> None:
        self._end()
        self.done = True
