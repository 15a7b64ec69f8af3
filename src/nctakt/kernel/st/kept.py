# SPDX-License-Identifier: MIT
"""Values that the frame keeps, and values after a statement: both are evaluated once."""

from __future__ import annotations

from nctakt.kernel.base.bounds import check_range
from nctakt.kernel.st import kinds, words
from nctakt.kernel.st.context import PlcContext
from nctakt.kernel.st.reals import Real
from nctakt.kernel.st.steps import Step
from nctakt.kernel.st.wholes import Whole


class KeptWhole(Whole):
    """A number that the frame keeps, so that others read it without evaluating it again."""

    def __init__(self, operand: Whole, offset: int) -> None:
        check_range(offset, 0, kinds.MAX_MEMORY, "offset")
        self.operand = operand
        self.offset = offset

    def value(self, context: PlcContext) -> int:
        value = self.operand.value(context)
        at = context.checked_target(context.frame + self.offset, 8)
        if context.fault == 0:
            words.store(context.memory, at, kinds.I64, value)
        return value


class WholeAfter(Whole):
    """A number that is read after a statement: an assignment within an expression."""

    def __init__(self, before: Step, operand: Whole) -> None:
        self.before = before
        self.operand = operand

    def value(self, context: PlcContext) -> int:
        self.before.run(context)
        return 0 if context.fault else self.operand.value(context)


class RealAfter(Real):
    """A real number that is read after a statement."""

    def __init__(self, before: Step, operand: Real) -> None:
        self.before = before
        self.operand = operand

    def number(self, context: PlcContext) -> float:
        self.before.run(context)
        return 0.0 if context.fault else self.operand.number(context)
