# SPDX-License-Identifier: MIT
"""Statements of PLC code: trees of objects that run themselves (ST-510 … ST-514).

``run(context)`` answers how the statement ends: ``kinds.GOES_ON``, a fault, EXIT, CONTINUE or
RETURN. The cost of a statement in elementary instructions is known when it is built and counted
before it runs (ST-830). Statements are in a tree of blocks of four, so that code of any length
needs little recursion.
"""

from __future__ import annotations

from itertools import pairwise

from nctakt.kernel.base.bounds import check_range
from nctakt.kernel.st import chains, kinds, leaves, real_leaves, words
from nctakt.kernel.st.context import PlcContext
from nctakt.kernel.st.reals import Real
from nctakt.kernel.st.wholes import Whole


class Step:
    """Base of a statement, and null object: no effect."""

    def run(self, context: PlcContext) -> int:
        """Run the statement once; return how it ends."""
        return kinds.GOES_ON

    def execute(self, context: PlcContext) -> int:
        """Run the statement for Python's side."""
        return self.run(context)


class StepPair(Step):
    """Two statements in order."""

    def __init__(self, first: Step, second: Step) -> None:
        self.first = first
        self.second = second

    def run(self, context: PlcContext) -> int:
        end = self.first.run(context)
        if end:
            return end
        return self.second.run(context)


class Uncounted(Step):
    """Steps that cost the PLC nothing: others act in its memory."""

    def __init__(self, body: Step) -> None:
        self.body = body

    def run(self, context: PlcContext) -> int:
        steps = context.steps
        end = self.body.run(context)
        context.steps = steps
        return end


class StepBlock(Step):
    """Four statements in order."""

    def __init__(self, first: Step, second: Step, third: Step, fourth: Step) -> None:
        self.first = first
        self.second = second
        self.third = third
        self.fourth = fourth

    def run(self, context: PlcContext) -> int:
        end = self.first.run(context)
        if end:
            return end
        end = self.second.run(context)
        if end:
            return end
        end = self.third.run(context)
        if end:
            return end
        return self.fourth.run(context)


def steps_in_order(steps: list[Step]) -> Step:
    """Tie statements in order, nested no deeper than their number's logarithm."""
    count = len(steps)
    if count == 0:
        return Step()
    if count == 1:
        return steps[0]
    if count < 4:
        return StepPair(steps[0], steps_in_order(steps[1:]))
    cuts = [count * i // 4 for i in range(5)]
    return StepBlock(*[steps_in_order(steps[begin:end]) for begin, end in pairwise(cuts)])


class Sourced(Step):
    """Base of a statement that costs elementary instructions and has a source."""

    def __init__(self, source: int, cost: int) -> None:
        self.source = source
        self.cost = cost


class Store(Sourced):
    """Base of an assignment of a whole number, a truth or an address."""

    def __init__(self, target: int, kind: int, operand: Whole, source: int, cost: int) -> None:
        super().__init__(source, cost)
        self.target = target
        self.kind = kind
        self.operand = operand


class StoreFixed(Store):
    """An assignment to a variable of data."""

    def __init__(
        self, target: int, kind: int, operand: Whole, source: int, cost: int, end: int
    ) -> None:
        check_range(target, kinds.NULL_BYTES, end, "address")
        super().__init__(target, kind, operand, source, cost)

    def run(self, context: PlcContext) -> int:
        context.steps += self.cost
        if context.steps > context.max_steps:
            return context.over_budget(self.source)
        value = leaves.value_of(self.operand, context)
        if context.fault:
            return context.stop_at(self.source)
        words.store(context.memory, self.target, self.kind, value)
        if context.is_noting:
            context.wrote(self.target, self.kind, self.source)
        return kinds.GOES_ON


class StoreFrame(Store):
    """An assignment to a variable of the running routine."""

    def __init__(self, target: int, kind: int, operand: Whole, source: int, cost: int) -> None:
        check_range(target, 0, kinds.SLACK - 8, "offset")
        super().__init__(target, kind, operand, source, cost)

    def run(self, context: PlcContext) -> int:
        context.steps += self.cost
        if context.steps > context.max_steps:
            return context.over_budget(self.source)
        value = leaves.value_of(self.operand, context)
        if context.fault:
            return context.stop_at(self.source)
        words.store(context.memory, context.frame + self.target, self.kind, value)
        return kinds.GOES_ON


class StoreInstance(Store):
    """An assignment to a variable of the block that is called."""

    def __init__(self, target: int, kind: int, operand: Whole, source: int, cost: int) -> None:
        check_range(target, 0, kinds.SLACK - 8, "offset")
        super().__init__(target, kind, operand, source, cost)

    def run(self, context: PlcContext) -> int:
        context.steps += self.cost
        if context.steps > context.max_steps:
            return context.over_budget(self.source)
        value = leaves.value_of(self.operand, context)
        if context.fault:
            return context.stop_at(self.source)
        words.store(context.memory, context.instance + self.target, self.kind, value)
        if context.is_noting:
            context.wrote(context.instance + self.target, self.kind, self.source)
        return kinds.GOES_ON


class StoreAt(Sourced):
    """An assignment to a computed address, which is evaluated before the value (ST-502)."""

    def __init__(self, address: Whole, kind: int, operand: Whole, source: int, cost: int) -> None:
        super().__init__(source, cost)
        self.address = address
        self.kind = kind
        self.operand = operand

    def run(self, context: PlcContext) -> int:
        context.steps += self.cost
        if context.steps > context.max_steps:
            return context.over_budget(self.source)
        at = leaves.target_of(self.address, context)
        value = leaves.value_of(self.operand, context)
        if context.fault:
            return context.stop_at(self.source)
        words.store(context.memory, at, self.kind, value)
        if at >= context.plain_end:
            context.wrote_target(at, self.kind, self.source)
        return kinds.GOES_ON


class StoreReal(Sourced):
    """Base of an assignment of a real number, which follows the links of a chain by itself."""

    def __init__(self, target: int, kind: int, operand: Real, source: int, cost: int) -> None:
        super().__init__(source, cost)
        self.target = target
        self.kind = kind
        self.operand, parts = chains.opened(operand)
        self.links = chains.links_of(parts)


class StoreRealFixed(StoreReal):
    """An assignment to a variable of data."""

    def __init__(
        self, target: int, kind: int, operand: Real, source: int, cost: int, end: int
    ) -> None:
        check_range(target, kinds.NULL_BYTES, end, "address")
        super().__init__(target, kind, operand, source, cost)

    def run(self, context: PlcContext) -> int:
        context.steps += self.cost
        if context.steps > context.max_steps:
            return context.over_budget(self.source)
        number = real_leaves.number_of(self.operand, context)
        number = real_leaves.followed(self.links, number, context)
        if context.fault:
            return context.stop_at(self.source)
        words.store_real(context.memory, self.target, self.kind, number)
        if context.is_noting:
            context.wrote(self.target, self.kind, self.source)
        return kinds.GOES_ON


class StoreRealFrame(StoreReal):
    """An assignment to a variable of the running routine."""

    def __init__(self, target: int, kind: int, operand: Real, source: int, cost: int) -> None:
        check_range(target, 0, kinds.SLACK - 8, "offset")
        super().__init__(target, kind, operand, source, cost)

    def run(self, context: PlcContext) -> int:
        context.steps += self.cost
        if context.steps > context.max_steps:
            return context.over_budget(self.source)
        number = real_leaves.number_of(self.operand, context)
        number = real_leaves.followed(self.links, number, context)
        if context.fault:
            return context.stop_at(self.source)
        words.store_real(context.memory, context.frame + self.target, self.kind, number)
        return kinds.GOES_ON


class StoreRealInstance(StoreReal):
    """An assignment to a variable of the block that is called."""

    def __init__(self, target: int, kind: int, operand: Real, source: int, cost: int) -> None:
        check_range(target, 0, kinds.SLACK - 8, "offset")
        super().__init__(target, kind, operand, source, cost)

    def run(self, context: PlcContext) -> int:
        context.steps += self.cost
        if context.steps > context.max_steps:
            return context.over_budget(self.source)
        number = real_leaves.number_of(self.operand, context)
        number = real_leaves.followed(self.links, number, context)
        if context.fault:
            return context.stop_at(self.source)
        words.store_real(context.memory, context.instance + self.target, self.kind, number)
        if context.is_noting:
            context.wrote(context.instance + self.target, self.kind, self.source)
        return kinds.GOES_ON


class StoreRealAt(Sourced):
    """An assignment to a computed address, which is evaluated before the value."""

    def __init__(self, address: Whole, kind: int, operand: Real, source: int, cost: int) -> None:
        super().__init__(source, cost)
        self.address = address
        self.kind = kind
        self.operand = operand

    def run(self, context: PlcContext) -> int:
        context.steps += self.cost
        if context.steps > context.max_steps:
            return context.over_budget(self.source)
        at = leaves.target_of(self.address, context)
        number = real_leaves.number_of(self.operand, context)
        if context.fault:
            return context.stop_at(self.source)
        words.store_real(context.memory, at, self.kind, number)
        if at >= context.plain_end:
            context.wrote_target(at, self.kind, self.source)
        return kinds.GOES_ON


class StoreBit(Sourced):
    """An assignment to a bit of a whole number (ST-317), or to a BIT of a structure (ST-312)."""

    def __init__(
        self, address: Whole, kind: int, bit: int, operand: Whole, source: int, cost: int
    ) -> None:
        check_range(bit, 0, 63, "bit")
        super().__init__(source, cost)
        self.address = address
        self.kind = kind
        self.bit = bit
        self.operand = operand

    def run(self, context: PlcContext) -> int:
        context.steps += self.cost
        if context.steps > context.max_steps:
            return context.over_budget(self.source)
        at = leaves.target_of(self.address, context)
        value = leaves.value_of(self.operand, context)
        if context.fault:
            return context.stop_at(self.source)
        mask = words.shift_left(1, self.bit)
        old = words.load(context.memory, at, self.kind)
        new = old | mask if value else old & (-1 - mask)
        words.store(context.memory, at, self.kind, new)
        if context.is_noting:
            context.wrote(at, self.kind, self.source)
        return kinds.GOES_ON


class CopyBytes(Sourced):
    """An assignment of a structure, an array or an instance: its bytes (ST-510)."""

    def __init__(self, address: Whole, origin: Whole, size: int, source: int, cost: int) -> None:
        check_range(size, 0, kinds.MAX_MEMORY, "size")
        super().__init__(source, cost)
        self.address = address
        self.origin = origin
        self.size = size

    def run(self, context: PlcContext) -> int:
        context.steps += self.cost
        if context.steps > context.max_steps:
            return context.over_budget(self.source)
        to = context.checked_target(leaves.place_of(self.address, context), self.size)
        origin = context.checked(leaves.place_of(self.origin, context), self.size)
        if context.fault:
            return context.stop_at(self.source)
        words.copy(context.memory, to, origin, self.size)
        if context.is_noting:
            context.wrote_bytes(to, self.size, self.source)
        return kinds.GOES_ON


class Evaluate(Sourced):
    """A call whose result is discarded."""

    def __init__(self, operand: Whole, source: int, cost: int) -> None:
        super().__init__(source, cost)
        self.operand = operand

    def run(self, context: PlcContext) -> int:
        context.steps += self.cost
        if context.steps > context.max_steps:
            return context.over_budget(self.source)
        leaves.value_of(self.operand, context)
        return context.stop_at(self.source) if context.fault else kinds.GOES_ON


class EvaluateReal(Sourced):
    """A call whose real result is discarded."""

    def __init__(self, operand: Real, source: int, cost: int) -> None:
        super().__init__(source, cost)
        self.operand = operand

    def run(self, context: PlcContext) -> int:
        context.steps += self.cost
        if context.steps > context.max_steps:
            return context.over_budget(self.source)
        real_leaves.number_of(self.operand, context)
        return context.stop_at(self.source) if context.fault else kinds.GOES_ON


class Leave(Sourced):
    """``EXIT``, ``CONTINUE`` or ``RETURN`` (ST-513)."""

    def __init__(self, end: int, source: int) -> None:
        check_range(end, kinds.EXITS, kinds.RETURNS, "end")
        super().__init__(source, 1)
        self.end = end

    def run(self, context: PlcContext) -> int:
        context.steps += self.cost
        if context.steps > context.max_steps:
            return context.over_budget(self.source)
        return self.end


class Fail(Sourced):
    """A statement that cannot run: a numbered fault (``F_RaiseException``, or refused code)."""

    def __init__(self, message: int, operand: Whole, source: int) -> None:
        check_range(message, 1, 1 << 30, "message")
        super().__init__(source, 1)
        self.message = message
        self.operand = operand

    def run(self, context: PlcContext) -> int:
        context.fail(self.message, leaves.value_of(self.operand, context), 0)
        return context.stop_at(self.source)
