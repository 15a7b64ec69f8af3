# SPDX-License-Identifier: MIT
"""Calls: functions, blocks and methods, with their frames on the stack (ST-520, ST-601 … ST-604).

A frame begins with the part that caller and callee share: result, inputs, outputs, references of
VAR_IN_OUT; variables and intermediate results follow. The caller clears and fills the shared part,
the callee the rest. A block instance begins with the number of its type; types are numbered so that
those derived from one follow it, and a method that several types have is chosen by ranges.
"""

from __future__ import annotations

from nctakt.kernel.base.bounds import check_range
from nctakt.kernel.st import kinds, words
from nctakt.kernel.st.context import PlcContext
from nctakt.kernel.st.steps import Step
from nctakt.kernel.st.wholes import Whole


class Callee:
    """Base of what can be called, and null object: nothing of that type has the method."""

    def invoke(self, context: PlcContext, frame: int, instance: int) -> int:
        """Run with a frame that the caller has begun; return whether the PLC keeps running."""
        context.fail(kinds.PLACE, instance, 0)
        return kinds.STOPS


class Routine(Callee):
    """A function, a method, or the body of a block or program.

    ``shared`` bytes of its frame are the caller's, ``size`` all of it; both are known when the body
    is translated, as the body itself is: it may call its caller (ST-407).
    """

    def __init__(self) -> None:
        self.shared = 0
        self.size = 0
        self.body = Step()

    def complete(self, shared: int, size: int, body: Step) -> None:
        """Give the routine its body."""
        check_range(size, 0, kinds.MAX_MEMORY, "size")
        check_range(shared, 0, size, "shared")
        self.shared = shared
        self.size = size
        self.body = body

    def invoke(self, context: PlcContext, frame: int, instance: int) -> int:
        if context.depth >= kinds.MAX_DEPTH or frame > context.stack_end - self.size:
            context.fail(kinds.STACK, context.depth, frame + self.size - context.stack)
            return kinds.STOPS
        outer_frame = context.frame
        outer_instance = context.instance
        context.frame = frame
        context.instance = instance
        context.top = frame + self.size
        context.depth += 1
        words.fill(context.memory, frame + self.shared, self.size - self.shared, 0)
        end = self.body.run(context)
        context.depth -= 1
        context.frame = outer_frame
        context.instance = outer_instance
        return kinds.STOPS if end == kinds.STOPS else kinds.GOES_ON


class OfTypes(Callee):
    """The routine of instances whose type is ``lowest`` … ``highest``."""

    def __init__(self, lowest: int, highest: int, routine: Callee) -> None:
        self.lowest = lowest
        self.highest = highest
        self.routine = routine

    def invoke(self, context: PlcContext, frame: int, instance: int) -> int:
        number = words.load(context.memory, instance, kinds.I64)
        if number < self.lowest or number > self.highest:
            context.fail(kinds.PLACE, instance, 0)
            return kinds.STOPS
        return self.routine.invoke(context, frame, instance)


class ByType(Callee):
    """Routines of types below ``split``, and of all others."""

    def __init__(self, split: int, below: Callee, others: Callee) -> None:
        self.split = split
        self.below = below
        self.others = others

    def invoke(self, context: PlcContext, frame: int, instance: int) -> int:
        if words.load(context.memory, instance, kinds.I64) < self.split:
            return self.below.invoke(context, frame, instance)
        return self.others.invoke(context, frame, instance)


def callee_of(ranges: list[tuple[int, int, Callee]]) -> Callee:
    """Tie the routines of ranges of types, given in ascending order."""
    if not ranges:
        return Callee()
    if len(ranges) < 2:
        return OfTypes(*ranges[0])
    middle = len(ranges) // 2
    return ByType(ranges[middle][0], callee_of(ranges[:middle]), callee_of(ranges[middle:]))


class Call(Whole):
    """A call; its value is the address of its result.

    ``instance`` is the block that is called, evaluated before the arguments; a function has none.
    The arguments go into the instance (``fills_instance``) or into the frame; the outputs are
    taken after it.
    """

    def __init__(
        self,
        callee: Callee,
        instance: Whole,
        shared: int,
        arguments: Step,
        outputs: Step,
        fills_instance: bool,
        source: int,
    ) -> None:
        check_range(shared, 0, kinds.MAX_MEMORY, "shared")
        self.callee = callee
        self.instance = instance
        self.shared = shared
        self.arguments = arguments
        self.outputs = outputs
        self.fills_instance = fills_instance
        self.source = source

    def value(self, context: PlcContext) -> int:
        frame = context.top
        if context.fault:
            return frame
        instance = self.instance.value(context)
        if context.fault:
            return frame
        if frame > context.stack_end - self.shared:
            context.fail(kinds.STACK, context.depth, frame + self.shared - context.stack)
            return frame
        outer = context.passing
        address = instance if self.fills_instance else frame
        context.top = frame + self.shared
        context.passing = address
        words.fill(context.memory, frame, self.shared, 0)
        if self.arguments.run(context) == kinds.GOES_ON:
            context.passing = outer
            if self.callee.invoke(context, frame, instance):
                context.note_call(self.source)
            else:
                context.top = frame + self.shared
                context.passing = address
                self.outputs.run(context)
        context.passing = outer
        context.top = frame
        return frame


class ResultPlace(Whole):
    """The result of a call as bytes, kept in the caller's frame: a text, a structure, an array."""

    def __init__(self, call: Call, offset: int, size: int, kept: int) -> None:
        check_range(size, 0, kinds.MAX_MEMORY, "size")
        self.call = call
        self.offset = offset
        self.size = size
        self.kept = kept

    def value(self, context: PlcContext) -> int:
        frame = self.call.value(context)
        address = context.frame + self.kept
        if context.fault:
            return address
        origin = context.checked(frame + self.offset, self.size)
        words.copy(context.memory, context.checked_target(address, self.size), origin, self.size)
        return address


class NoteCaller(Step):
    """Note where a function of the tests was called, once its arguments are there (ST-903)."""

    def __init__(self, source: int) -> None:
        self.source = source

    def run(self, context: PlcContext) -> int:
        context.caller = self.source
        return kinds.GOES_ON


class CallerSource(Whole):
    """Where the latest function of the tests was called."""

    def value(self, context: PlcContext) -> int:
        return context.caller
