# SPDX-License-Identifier: MIT
"""Calls to the machine by blocks for axes, the interface and tasks (ST-743, ST-761, ST-721)."""

from __future__ import annotations

from nctakt.kernel.st.context import PlcContext
from nctakt.kernel.st.reals import Real
from nctakt.kernel.st.wholes import Whole


class OpenInterface(Whole):
    """Lets the pointers of the interface point to it; TRUE."""

    def value(self, context: PlcContext) -> int:
        context.outside.open(context.memory)
        return 1


class TaskNumber(Whole):
    """The number of the task at work, from 1 (ST-721)."""

    def value(self, context: PlcContext) -> int:
        return context.task


class CommandAxis(Whole):
    """Commands an axis: the owner, or the message that refuses it, negative."""

    def __init__(
        self, kind: Whole, axis: Whole, target: Real, speed: Real, mode: Whole, direction: Whole
    ) -> None:
        self.kind = kind
        self.axis = axis
        self.target = target
        self.speed = speed
        self.mode = mode
        self.direction = direction

    def value(self, context: PlcContext) -> int:
        kind = self.kind.value(context)
        axis = self.axis.value(context)
        target = self.target.number(context)
        speed_v = self.speed.number(context)
        mode = self.mode.value(context)
        direction = self.direction.value(context)
        if context.fault:
            return 0
        return context.outside.command(kind, axis, target, speed_v, mode, direction)


class SwitchAxis(Whole):
    """Releases an axis for commands, or locks it against them; whether it is so now."""

    def __init__(self, axis: Whole, is_on: Whole, is_lock: bool) -> None:
        self.axis = axis
        self.is_on = is_on
        self.is_lock = is_lock

    def value(self, context: PlcContext) -> int:
        axis = self.axis.value(context)
        is_on = 1 if self.is_on.value(context) else 0
        if context.fault:
            return 0
        if self.is_lock:
            return context.outside.lock(axis, is_on)
        return context.outside.power(axis, is_on)


class OverrideAxis(Whole):
    """Multiplies the speeds of independent motions by a factor; whether it is in 0 … 1."""

    def __init__(self, axis: Whole, factor: Real) -> None:
        self.axis = axis
        self.factor = factor

    def value(self, context: PlcContext) -> int:
        axis = self.axis.value(context)
        factor = self.factor.number(context)
        return 0 if context.fault else context.outside.override(axis, factor)


class LookAtAxis(Whole):
    """A value of an axis or a command, by its number."""

    def __init__(self, what: Whole, axis: Whole, owner: Whole) -> None:
        self.what = what
        self.axis = axis
        self.owner = owner

    def value(self, context: PlcContext) -> int:
        what = self.what.value(context)
        axis = self.axis.value(context)
        return context.outside.look(what, axis, self.owner.value(context))


class MeasureAxis(Real):
    """A position or the speed of an axis."""

    def __init__(self, what: Whole, axis: Whole) -> None:
        self.what = what
        self.axis = axis

    def number(self, context: PlcContext) -> float:
        what = self.what.value(context)
        return context.outside.measure(what, self.axis.value(context))
