# SPDX-License-Identifier: MIT
"""Assignments that change a variable: ``x := x + y`` (ST-502, ST-510)."""

from __future__ import annotations

from nctakt.kernel.base.bounds import check_range
from nctakt.kernel.st import kinds, leaves, words
from nctakt.kernel.st.context import PlcContext
from nctakt.kernel.st.steps import Sourced
from nctakt.kernel.st.wholes import ElementPlace, Whole


def changed(operator: int, left: int, right: int) -> int:
    """Return what an operator makes of the old value."""
    if operator == kinds.ADD:
        return words.add(left, right)
    if operator == kinds.SUBTRACT:
        return words.subtract(left, right)
    return left & right if operator == kinds.AND else left | right


class UpdateAt(Sourced):
    """``x := x + y`` of a variable whose address is evaluated once."""

    def __init__(
        self, address: Whole, kind: int, operator: int, operand: Whole, source: int, cost: int
    ) -> None:
        check_range(operator, kinds.ADD, kinds.OR, "operator")
        super().__init__(source, cost)
        self.address = address
        self.kind = kind
        self.operator = operator
        self.operand = operand

    def run(self, context: PlcContext) -> int:
        context.steps += self.cost
        if context.steps > context.max_steps:
            return context.over_budget(self.source)
        at = leaves.target_of(self.address, context)
        left = words.load(context.memory, at, self.kind)
        right = leaves.value_of(self.operand, context)
        if context.fault:
            return context.stop_at(self.source)
        words.store(context.memory, at, self.kind, changed(self.operator, left, right))
        if at >= context.plain_end:
            context.wrote_target(at, self.kind, self.source)
        return kinds.GOES_ON


class UpdateElement(UpdateAt):
    """The same of an element of an array, where nothing is computed by a call."""

    def __init__(
        self,
        element: ElementPlace,
        kind: int,
        operator: int,
        operand: Whole,
        source: int,
        cost: int,
    ) -> None:
        super().__init__(element, kind, operator, operand, source, cost)
        self.element = element
        self.is_near = leaves.is_near(operand)

    def run(self, context: PlcContext) -> int:
        if self.is_near and self.element.is_near:
            number = leaves.near_value(self.element.index, context)
            number = words.subtract(number, self.element.lowest)
            if 0 <= number < self.element.count:
                at = leaves.near_place(self.element.address, context)
                at += number * self.element.stride
                steps = context.steps + self.cost
                if kinds.NULL_BYTES <= at < context.plain_end and steps <= context.max_steps:
                    context.steps = steps
                    left = words.load(context.memory, at, self.kind)
                    right = leaves.near_value(self.operand, context)
                    words.store(context.memory, at, self.kind, changed(self.operator, left, right))
                    return kinds.GOES_ON
        return UpdateAt.run(self, context)
