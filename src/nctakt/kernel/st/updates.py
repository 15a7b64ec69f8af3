# SPDX-License-Identifier: MIT
"""Assignments that change a variable: ``x := x + y`` (ST-502, ST-510)."""

from __future__ import annotations

from nctakt.kernel.base.bounds import check_range
from nctakt.kernel.st import kinds, leaves, words
from nctakt.kernel.st.context import PlcContext
from nctakt.kernel.st.steps import Sourced
from nctakt.kernel.st.wholes import ElementPlace, LoadElement, Whole


def changed(operator: int, left: int, right: int) -> int:
    """Return the result of an operator for the old value."""
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


def change(node: UpdateAt, at: int, operand: int, context: PlcContext) -> int:
    """Change the variable at an address already checked; return that the PLC keeps running."""
    context.steps += node.cost
    left = words.load(context.memory, at, node.kind)
    words.store(context.memory, at, node.kind, changed(node.operator, left, operand))
    return kinds.GOES_ON


class UpdateVariable(UpdateAt):
    """``x := x + y`` of two variables, or of a variable and a constant."""

    def run(self, context: PlcContext) -> int:
        at = leaves.near_place(self.address, context)
        is_inside = kinds.NULL_BYTES <= at < context.plain_end
        if is_inside and context.steps + self.cost <= context.max_steps:
            return change(self, at, leaves.near_value(self.operand, context), context)
        return UpdateAt.run(self, context)


class UpdateElement(UpdateAt):
    """``v[i] := v[i] + y``, where nothing is computed by a call."""

    def run(self, context: PlcContext) -> int:
        at = leaves.near_element(self.address, context)
        is_inside = kinds.NULL_BYTES <= at < context.plain_end
        if is_inside and context.steps + self.cost <= context.max_steps:
            return change(self, at, leaves.near_value(self.operand, context), context)
        return UpdateAt.run(self, context)


class UpdateByElement(UpdateAt):
    """``x := x + v[i]``, where nothing is computed by a call."""

    def __init__(
        self,
        address: Whole,
        kind: int,
        operator: int,
        element: LoadElement,
        source: int,
        cost: int,
    ) -> None:
        super().__init__(address, kind, operator, element, source, cost)
        self.element = element

    def run(self, context: PlcContext) -> int:
        at = leaves.near_place(self.address, context)
        origin = leaves.near_element(self.element, context)
        is_inside = kinds.NULL_BYTES <= at < context.plain_end
        is_inside = is_inside and kinds.NULL_BYTES <= origin <= context.end
        if is_inside and context.steps + self.cost <= context.max_steps:
            operand = words.load(context.memory, origin, self.element.kind)
            return change(self, at, operand, context)
        return UpdateAt.run(self, context)


def updated(
    address: Whole, kind: int, operator: int, operand: Whole, source: int, cost: int
) -> UpdateAt:
    """Return ``x := x + y`` as the node that suits its variable and its operand."""
    node = UpdateAt
    if leaves.is_near_place(address):
        if isinstance(operand, LoadElement) and operand.is_near:
            return UpdateByElement(address, kind, operator, operand, source, cost)
        if leaves.is_near(operand):
            node = UpdateVariable
    elif isinstance(address, ElementPlace) and address.is_near and leaves.is_near(operand):
        node = UpdateElement
    return node(address, kind, operator, operand, source, cost)
