# SPDX-License-Identifier: MIT
"""``#ERROR`` in a realtime cycle: a user-defined error (RC-402).

A warning (RC 0) is reported and no more. With RC from 1 on the channel is in error state and the
path brakes from this tick; the statements after it, its cycle and all others run on until the
reset.
"""

from __future__ import annotations

from nctakt.kernel import rows
from nctakt.kernel.base import arithmetic
from nctakt.kernel.cycles import instructions
from nctakt.kernel.cycles.context import Context
from nctakt.kernel.cycles.expressions import Expression
from nctakt.kernel.cycles.instructions import Counted


class UserValue:
    """Base of a value of the error, and null object: the end of their chain."""

    def evaluate(self, context: Context) -> None:
        """Evaluate this value and those after it; a fault is in the context."""

    def record(self, context: Context, source: int) -> None:
        """Record this value and those after it as events."""


class NumberValue(UserValue):
    """``PV1=…`` and its kin; ``code``: number of the keyword (``nc/check/user_errors.py``)."""

    def __init__(self, code: int, expression: Expression, others: UserValue) -> None:
        self.code = code
        self.expression = expression
        self.others = others
        self.number = 0.0

    def evaluate(self, context: Context) -> None:
        self.number = self.expression.value(context)
        if self.number - self.number != 0.0:
            context.fail(50879, 0, 0.0, self.number)
        if context.fault == 0:
            self.others.evaluate(context)

    def record(self, context: Context, source: int) -> None:
        context.record.event(rows.EVENT_USER_VALUE, source, context.serial, self.code, self.number)
        self.others.record(context, source)


class TextValue(UserValue):
    """``PV1="…"``: a constant text, by its number."""

    def __init__(self, code: int, text: int, others: UserValue) -> None:
        self.code = code
        self.text = text
        self.others = others

    def evaluate(self, context: Context) -> None:
        self.others.evaluate(context)

    def record(self, context: Context, source: int) -> None:
        context.record.event(rows.EVENT_USER_TEXT, source, context.serial, self.code, self.text)
        self.others.record(context, source)


class RaiseUserError(Counted):
    """``#ERROR [ID=… RC=… PV1=…]``; 21171, 21173 for an ID or RC out of range."""

    def __init__(
        self,
        identity: Expression,
        reaction: Expression,
        values: UserValue,
        source: int,
        cost: int,
    ) -> None:
        super().__init__(source, cost)
        self.identity = identity
        self.reaction = reaction
        self.values = values

    def run(self, context: Context) -> int:
        if instructions.begin(self, context):
            return 1
        identity = self.whole(context, self.identity, 1.0, 1000.0, 21171)
        reaction = self.whole(context, self.reaction, 0.0, 7.0, 21173)
        self.values.evaluate(context)
        if context.fault:
            return instructions.stop(self, context)
        context.record.event(rows.EVENT_USER_ERROR, self.source, context.serial, identity, reaction)
        self.values.record(context, self.source)
        if reaction > context.user_reaction:
            context.user_reaction = int(reaction)
        return 0

    def whole(
        self, context: Context, expression: Expression, low: float, high: float, message: int
    ) -> float:
        """Evaluate a whole number from ``low`` to ``high``; else ``message`` is a fault."""
        if context.fault:
            return 0.0
        value = expression.value(context)
        if context.fault == 0 and not (
            low <= value <= high and value == arithmetic.round_half_even(value)
        ):
            context.fail(message, self.source, value, high)
        return value
