# SPDX-License-Identifier: MIT
"""Statements of realtime cycles: trees of small objects, each of which runs itself.

RC-207, RC-307, RC-403, RC-501; ``$IF`` is in ``branches.py``. ``run(context)`` returns 0 if the
run-through continues, and another number if the cycle must stop: a fault or a limit, noted in the
context. The cost of a statement in elementary instructions is known when it is built and added
before it runs. Statements are in a tree of blocks of four, so that a cycle of any length needs
little recursion.
"""

from __future__ import annotations

from itertools import pairwise

from nctakt.kernel import rows
from nctakt.kernel.base import arithmetic
from nctakt.kernel.base.bounds import check_index
from nctakt.kernel.cycles.context import Context
from nctakt.kernel.cycles.expressions import Expression, Index, Load


class Statement:
    """Base of a statement, and null object: no effect."""

    def run(self, context: Context) -> int:
        """Run the statement once; return 1 if the cycle must stop, else 0."""
        return 0

    def restart(self) -> None:
        """Forget the states of ``$IF`` (START, RC-111)."""


class Pair(Statement):
    """Two statements in order."""

    def __init__(self, first: Statement, second: Statement) -> None:
        self.first = first
        self.second = second

    def run(self, context: Context) -> int:
        if self.first.run(context):
            return 1
        return self.second.run(context)

    def restart(self) -> None:
        self.first.restart()
        self.second.restart()


class Triple(Statement):
    """Three statements in order."""

    def __init__(self, first: Statement, second: Statement, third: Statement) -> None:
        self.first = first
        self.second = second
        self.third = third

    def run(self, context: Context) -> int:
        if self.first.run(context):
            return 1
        if self.second.run(context):
            return 1
        return self.third.run(context)

    def restart(self) -> None:
        self.first.restart()
        self.second.restart()
        self.third.restart()


class Block(Statement):
    """Four statements in order."""

    def __init__(
        self, first: Statement, second: Statement, third: Statement, fourth: Statement
    ) -> None:
        self.first = first
        self.second = second
        self.third = third
        self.fourth = fourth

    def run(self, context: Context) -> int:
        if self.first.run(context):
            return 1
        if self.second.run(context):
            return 1
        if self.third.run(context):
            return 1
        return self.fourth.run(context)

    def restart(self) -> None:
        self.first.restart()
        self.second.restart()
        self.third.restart()
        self.fourth.restart()


def sequence(statements: list[Statement]) -> Statement:
    """Tie statements in order, nested no deeper than their number's logarithm."""
    count = len(statements)
    if count == 0:
        return Statement()
    if count == 1:
        return statements[0]
    if count == 2:
        return Pair(*statements)
    if count == 3:
        return Triple(*statements)
    cuts = [count * i // 4 for i in range(5)]
    return Block(*[sequence(statements[begin:end]) for begin, end in pairwise(cuts)])


class Watch:
    """Base of the observers called before a statement runs, and null object: does nothing."""

    def look(self, context: Context) -> None:
        """Look at the memory; the statement runs next."""


class Watched(Statement):
    """A statement at which a session can stop: ``put`` exchanges the observer."""

    def __init__(self, statement: Statement) -> None:
        self.statement = statement
        self.watch = Watch()

    def put(self, watch: Watch) -> None:
        """Exchange the observer."""
        self.watch = watch

    def run(self, context: Context) -> int:
        self.watch.look(context)
        return self.statement.run(context)

    def restart(self) -> None:
        self.statement.restart()


class Counted(Statement):
    """Base of a statement that costs elementary instructions and has a source."""

    def __init__(self, source: int, cost: int) -> None:
        self.source = source
        self.cost = cost


# The common part of all statements, as functions of this module: the compiler inlines them.


def begin(statement: Counted, context: Context) -> int:
    """Count a statement; 1 when a limit stops the cycle before it (RC-502, RC-503)."""
    context.steps += statement.cost
    if context.steps > context.check_at:
        return context.over_limit(statement.source)
    return 0


def stop(statement: Counted, context: Context) -> int:
    """Complete a fault by the statement's source, unless it has one; return 1."""
    if context.fault_source == 0:
        context.fault_source = statement.source
    return 1


def reject(statement: Counted, context: Context, value: float) -> int:
    """Refuse a value that is a fault or not finite (50879, RC-207); return 1."""
    if context.fault == 0:
        context.fail(50879, statement.source, 0.0, value)
    return stop(statement, context)


def write(statement: Counted, context: Context, cell: int, value: float) -> None:
    """Store a value; a new one is an event."""
    if value != context.cells[cell]:
        context.cells[cell] = value
        if context.record.records_writes:
            context.record.written(statement.source, context.serial, cell, value)


def evaluate(statement: Counted, expression: Expression, context: Context) -> float:
    """Count the statement and evaluate its expression; a fault is in the context."""
    if begin(statement, context):
        return 0.0
    value = expression.value(context)
    if context.fault != 0 or value - value != 0.0:
        reject(statement, context, value)
    return value


class Assignment(Counted):
    """Base of ``v = e``."""

    def __init__(self, target: Load, expression: Expression, source: int, cost: int) -> None:
        super().__init__(source, cost)
        self.cell = target.cell
        self.room = target.room
        self.expression = expression

    def store(self, context: Context, cell: int, value: float) -> int:
        """Convert to the variable's type and store; return 1 if the value does not fit."""
        return 0


class AssignReal(Assignment):
    """Assignment to a REAL64 variable.

    Most cycles mostly do this, so it is written out instead of composed like the others.
    """

    def run(self, context: Context) -> int:
        context.steps += self.cost
        if context.steps > context.check_at and context.over_limit(self.source):
            return 1
        value = self.expression.value(context)
        if context.fault != 0 or value - value != 0.0:
            return reject(self, context, value)
        if value != context.cells[self.cell]:
            context.cells[self.cell] = value
            if context.record.records_writes:
                context.record.written(self.source, context.serial, self.cell, value)
        return 0

    def store(self, context: Context, cell: int, value: float) -> int:
        write(self, context, cell, value)
        return 0


class AddToReal(Assignment):
    """``v += e`` of a REAL64 variable (fused)."""

    def run(self, context: Context) -> int:
        context.steps += self.cost
        if context.steps > context.check_at and context.over_limit(self.source):
            return 1
        value = self.expression.value(context) + context.cells[self.cell]
        if context.fault != 0 or value - value != 0.0:
            return reject(self, context, value)
        if value != context.cells[self.cell]:
            context.cells[self.cell] = value
            if context.record.records_writes:
                context.record.written(self.source, context.serial, self.cell, value)
        return 0


class BoundedAssignment(Assignment):
    """Base of rounding assignments; ``lowest`` and ``highest`` bound the variable."""

    def __init__(
        self,
        target: Load,
        expression: Expression,
        lowest: float,
        highest: float,
        source: int,
        cost: int,
    ) -> None:
        super().__init__(target, expression, source, cost)
        self.lowest = lowest
        self.highest = highest


def round_into_range(
    statement: BoundedAssignment, context: Context, cell: int, value: float
) -> float:
    """Round a value for an integer variable; 50892 outside its range (RC-307)."""
    value = arithmetic.round_half_even(value)
    if not statement.lowest <= value <= statement.highest:
        context.fail(50892, statement.source, cell, value)
    return value


class AssignInteger(BoundedAssignment):
    """Assignment to an integer variable: rounded half to even (RC-307)."""

    def run(self, context: Context) -> int:
        value = evaluate(self, self.expression, context)
        if context.fault:
            return 1
        return self.store(context, self.cell, value)

    def store(self, context: Context, cell: int, value: float) -> int:
        value = round_into_range(self, context, cell, value)
        if context.fault:
            return 1
        write(self, context, cell, value)
        return 0


class AssignBoolean(Assignment):
    """Assignment to a BOOLEAN: whether the magnitude is at least 0.5 (RC-307)."""

    def run(self, context: Context) -> int:
        value = evaluate(self, self.expression, context)
        if context.fault:
            return 1
        return self.store(context, self.cell, value)

    def store(self, context: Context, cell: int, value: float) -> int:
        write(self, context, cell, 1.0 if arithmetic.is_true(value) else 0.0)
        return 0


class AssignOverride(BoundedAssignment):
    """Assignment to an override: no event, since it is written in every tick (RC-305).

    Its changes show in the trace rows.
    """

    def run(self, context: Context) -> int:
        value = evaluate(self, self.expression, context)
        if context.fault:
            return 1
        value = round_into_range(self, context, self.cell, value)
        if context.fault:
            return 1
        context.cells[self.cell] = value
        return 0


class AssignElement(Counted):
    """``v[i] = e`` with an index computed in the tick; ``scalar`` knows type and expression."""

    def __init__(self, index: Index, scalar: Assignment, source: int, cost: int) -> None:
        super().__init__(source, cost)
        check_index(index.span, scalar.room, "index")
        self.index = index
        self.scalar = scalar

    def run(self, context: Context) -> int:
        value = evaluate(self, self.scalar.expression, context)
        if context.fault:
            return 1
        offset = int(self.index.value(context))
        if context.fault:
            return stop(self, context)
        return self.scalar.store(context, self.scalar.cell + offset, value)


class Read(Counted):
    """A variable alone in a block: read and dropped (RC-311)."""

    def __init__(self, expression: Expression, source: int, cost: int) -> None:
        super().__init__(source, cost)
        self.expression = expression

    def run(self, context: Context) -> int:
        if begin(self, context):
            return 1
        self.expression.value(context)
        if context.fault:
            return stop(self, context)
        return 0


class IssueTechnology(Counted):
    """M or H function, put into the realtime section of the HLI in this tick (RC-403).

    ``ticks``: how long the function takes.
    """

    def __init__(self, function: int, ticks: int, source: int, cost: int) -> None:
        super().__init__(source, cost)
        self.function = function
        self.ticks = ticks

    def run(self, context: Context) -> int:
        if begin(self, context):
            return 1
        sequence = context.hli.realtime.issue(self.function, context.tick, self.ticks)
        if sequence <= 0:
            number = 50942 if sequence < 0 else 50943
            context.fail(number, self.source, self.function, context.hli.realtime.slot_count)
            return 1
        context.record.event(
            rows.EVENT_TECHNOLOGY_RT, self.source, context.serial, self.function, sequence
        )
        return 0


class CommandTimer(Counted):
    """``#TIMER START|STOP|READ|CLEAR SYN [ID=i]`` (RC-401); 21167 for an unknown ID."""

    def __init__(self, action: int, timer: Expression, source: int, cost: int) -> None:
        super().__init__(source, cost)
        self.action = action
        self.timer = timer

    def run(self, context: Context) -> int:
        value = evaluate(self, self.timer, context)
        if context.fault:
            return 1
        value = arithmetic.round_half_even(value)
        if not 0.0 <= value <= 127.0:
            context.fail(21167, self.source, value, 127.0)
            return 1
        context.timers.command(self.action, int(value), context.tick)
        if context.record.records_writes:
            latched_ms = context.timers.latched(int(value))
            context.record.event(
                rows.EVENT_TIMER, self.source, context.serial, value, self.action, latched_ms
            )
        return 0
