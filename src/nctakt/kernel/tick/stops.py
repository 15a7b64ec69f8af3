# SPDX-License-Identifier: MIT
"""Stops: conditions that end ``Kernel.run`` after a tick, for those who watch a run.

Each stop is checked after every tick, and sees the results of the tick: the memory, the events of
the tick, the nodes of the realtime cycles. It changes nothing in the machine and uses none of the
instructions that the cycles may run.
"""

from __future__ import annotations

from collections.abc import MutableSequence

from nctakt.kernel import codes, rows
from nctakt.kernel.base.record import Record
from nctakt.kernel.cycles.branches import Reaction
from nctakt.kernel.cycles.conditions import Condition
from nctakt.kernel.cycles.context import Context, context_of
from nctakt.kernel.cycles.cycles import RealtimeCycle
from nctakt.kernel.cycles.expressions import Expression
from nctakt.kernel.cycles.instructions import Watch
from nctakt.kernel.st.context import PlcContext
from nctakt.kernel.st.observing.probes import Sought


class Stop:
    """Base of a stop, and null object at the end of the chain: never holds.

    It ends the run when it holds for the ``hits_needed``-th time while ``guard`` is true, from a
    magnitude of 0.5 on. ``count``: how often it has held so; ``last_tick``: when it did last.
    """

    def __init__(self, guard: Expression, hits_needed: int) -> None:
        self.guard = guard
        self.hits_needed = hits_needed
        self.count = 0
        self.last_tick = -1

    def begin(self, context: Context) -> None:
        """Take the present state as that before the first tick."""

    def holds(self, context: Context, record: Record) -> int:
        """Return whether the stop holds after this tick."""
        return 0


def is_true(expression: Expression, context: Context) -> int:
    """Return whether an expression is true; one that is not defined at the moment is false."""
    context.fault = 0
    value = expression.value(context)
    return 1 if context.fault == 0 and (value >= 0.5 or value <= -0.5) else 0


class BecomesTrue(Stop):
    """An expression becomes true, or false where ``truth`` is 0."""

    def __init__(
        self, expression: Expression, truth: int, guard: Expression, hits_needed: int
    ) -> None:
        super().__init__(guard, hits_needed)
        self.expression = expression
        self.truth = truth
        self.previous = 0

    def begin(self, context: Context) -> None:
        self.previous = is_true(self.expression, context)

    def holds(self, context: Context, record: Record) -> int:
        before = self.previous
        self.previous = is_true(self.expression, context)
        return 1 if self.previous == self.truth and before != self.truth else 0


class Changes(Stop):
    """The value of an expression changes."""

    def __init__(self, expression: Expression, guard: Expression, hits_needed: int) -> None:
        super().__init__(guard, hits_needed)
        self.expression = expression
        self.previous = 0.0

    def begin(self, context: Context) -> None:
        self.previous = self.expression.value(context)

    def holds(self, context: Context, record: Record) -> int:
        before = self.previous
        self.previous = self.expression.value(context)
        if before == self.previous:
            return 0
        return 1 if before == before or self.previous == self.previous else 0


class Happens(Stop):
    """An event of one of the ``kinds`` happens, a set of bits, with its columns within bounds.

    ``lowest`` and ``highest`` have a value for each column of an event; raises ``ValueError`` for
    another number of them.
    """

    def __init__(
        self,
        kinds: int,
        lowest: MutableSequence[float],
        highest: MutableSequence[float],
        guard: Expression,
        hits_needed: int,
    ) -> None:
        super().__init__(guard, hits_needed)
        if len(lowest) != rows.EVENT_WIDTH or len(highest) != rows.EVENT_WIDTH:
            raise ValueError((len(lowest), len(highest)))
        self.kinds = kinds
        self.lowest = lowest
        self.highest = highest

    def holds(self, context: Context, record: Record) -> int:
        number = record.event_count
        while number > 0:
            number -= 1
            row = number * rows.EVENT_WIDTH
            if record.events[row + rows.EVENT_TICK] != context.tick:
                return 0
            kind = int(record.events[row + rows.EVENT_KIND])
            if self.kinds >> kind & 1 and self.has_within(row, record):
                return 1
        return 0

    def has_within(self, row: int, record: Record) -> int:
        """Return whether the columns of an event lie within the bounds, or are no numbers."""
        column = 0
        while column < rows.EVENT_WIDTH:
            value = record.events[row + column]
            if value < self.lowest[column] or value > self.highest[column]:
                return 0
            column += 1
        return 1


class BlockUpToDepth(Stop):
    """Blocks become current, and in the last of them at most ``max_depth`` programs are open.

    ``channel``: its number in events, 0: any.
    """

    def __init__(self, channel: int, max_depth: int, guard: Expression, hits_needed: int) -> None:
        super().__init__(guard, hits_needed)
        self.channel = channel
        self.max_depth = max_depth

    def holds(self, context: Context, record: Record) -> int:
        number = record.event_count
        while number > 0:
            number -= 1
            row = number * rows.EVENT_WIDTH
            if record.events[row + rows.EVENT_TICK] != context.tick:
                return 0
            kind = int(record.events[row + rows.EVENT_KIND])
            channel = int(record.events[row + rows.EVENT_CHANNEL])
            if kind == rows.EVENT_BLOCK and self.channel in (0, channel):
                return 1 if record.events[row + rows.EVENT_C] <= self.max_depth else 0
        return 0


class Runs(Stop):
    """The body of a branch runs."""

    def __init__(self, reaction: Reaction, guard: Expression, hits_needed: int) -> None:
        super().__init__(guard, hits_needed)
        self.reaction = reaction

    def holds(self, context: Context, record: Record) -> int:
        return 1 if self.reaction.next_tick == context.tick + 1 else 0


class BeforeStatement(Watch):
    """Notes in which tick a guard has been true before a statement ran; ``others`` look as well."""

    def __init__(self, guard: Expression, context: Context, others: Watch) -> None:
        self.guard = guard
        self.context = context
        self.others = others
        self.next_tick = -1

    def look(self, context: Context) -> None:
        self.context.tick = context.tick
        if is_true(self.guard, self.context):
            self.next_tick = context.tick + 1
        self.others.look(context)


class RunsStatement(Stop):
    """A statement runs while a guard is true before it."""

    def __init__(self, before: BeforeStatement, guard: Expression, hits_needed: int) -> None:
        super().__init__(guard, hits_needed)
        self.before = before

    def holds(self, context: Context, record: Record) -> int:
        return 1 if self.before.next_tick == context.tick + 1 else 0


class RunsThrough(Stop):
    """A realtime cycle runs."""

    def __init__(self, cycle: RealtimeCycle, guard: Expression, hits_needed: int) -> None:
        super().__init__(guard, hits_needed)
        self.cycle = cycle

    def holds(self, context: Context, record: Record) -> int:
        return 1 if self.cycle.next_tick == context.tick + 1 else 0


class Turns(Stop):
    """The condition of a branch turns true, or false where ``truth`` is ``codes.FALSE``.

    A condition that is false when first evaluated has not turned.
    """

    def __init__(
        self, condition: Condition, truth: int, guard: Expression, hits_needed: int
    ) -> None:
        super().__init__(guard, hits_needed)
        self.condition = condition
        self.truth = truth
        self.previous = codes.UNKNOWN

    def begin(self, context: Context) -> None:
        self.previous = self.condition.truth

    def holds(self, context: Context, record: Record) -> int:
        before = self.previous
        self.previous = self.condition.truth
        if before == codes.UNKNOWN and self.truth == codes.FALSE:
            return 0
        return 1 if self.previous == self.truth and before != self.truth else 0


class PassesStatement(Stop):
    """A PLC passes a statement that is looked for."""

    def __init__(self, sought: Sought, guard: Expression, hits_needed: int) -> None:
        super().__init__(guard, hits_needed)
        self.sought = sought
        self.previous = 0

    def begin(self, context: Context) -> None:
        self.previous = self.sought.held

    def holds(self, context: Context, record: Record) -> int:
        before = self.previous
        self.previous = self.sought.held
        return 1 if self.previous != before else 0


class Faults(Stop):
    """A fault stops a PLC: one message by its number, or any, 0."""

    def __init__(self, plc: PlcContext, number: int, guard: Expression, hits_needed: int) -> None:
        super().__init__(guard, hits_needed)
        self.plc = plc
        self.number = number
        self.previous = 0

    def begin(self, context: Context) -> None:
        self.previous = self.plc.fault

    def holds(self, context: Context, record: Record) -> int:
        before = self.previous
        self.previous = self.plc.fault
        if self.number and self.previous != self.number:
            return 0
        return 1 if self.previous and before == 0 else 0


class Link:
    """A chain of stops, since the tick cannot walk through a list; the base is its end."""

    def check(self, context: Context, record: Record) -> int:
        """Check each stop; return whether one of them ends the run."""
        return 0


class StopLink(Link):
    """One stop and those after it."""

    def __init__(self, stop: Stop, others: Link) -> None:
        self.stop = stop
        self.others = others

    def check(self, context: Context, record: Record) -> int:
        ends = 0
        if self.stop.holds(context, record) and is_true(self.stop.guard, context):
            self.stop.count += 1
            self.stop.last_tick = context.tick
            if self.stop.count >= self.stop.hits_needed:
                ends = 1
        return self.others.check(context, record) | ends


class Stops:
    """The stops of a machine with this memory and this record."""

    def __init__(self, memory: bytearray, record: Record) -> None:
        self.context = context_of(memory)
        self.record = record
        self.is_watching = False
        self.chain = Link()

    def watch(self, stops: list[Stop]) -> None:
        """Watch these stops from the next tick on, instead of those before."""
        self.chain = Link()
        self.is_watching = False
        for stop in stops:
            self.add(stop)

    def add(self, stop: Stop) -> None:
        """Watch one more stop."""
        stop.begin(self.context)
        self.chain = StopLink(stop, self.chain)
        self.is_watching = True

    def check(self, tick: int) -> int:
        """Return whether a stop holds after this tick."""
        self.context.tick = tick
        return self.chain.check(self.context, self.record)
