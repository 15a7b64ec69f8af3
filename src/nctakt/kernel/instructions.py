# SPDX-License-Identifier: MIT
# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
# cython: initializedcheck=False, nonecheck=False, annotation_typing=False, auto_pickle=False
"""Statements of realtime cycles: trees of small objects, each of which runs itself.

RC-201 … RC-208, RC-307, RC-403, RC-501. ``run(context)`` answers 0 when the run-through goes on and
not 0 when the cycle must stop: a fault or a limit, noted in the context. The cost of a statement in
elementary instructions is known when it is built and added before it runs. Statements stand in
a tree of blocks of four, so that a cycle of any length needs little recursion.
"""

from __future__ import annotations

from nctakt.kernel import arithmetic
from nctakt.kernel.conditions import Condition
from nctakt.kernel.expressions import Expression
from nctakt.kernel.memory import Context


class Statement:
    """Base, and null object: does nothing."""

    def run(self, context: Context) -> int:
        """One run-through of this statement."""
        return 0

    def restart(self) -> None:
        """START: the states of ``$IF`` are as new (RC-111)."""


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
    """The statements in order as one, nested no deeper than their number's logarithm."""
    count = len(statements)
    if count == 0:
        return Statement()
    if count == 1:
        return statements[0]
    if count < 4:
        return Pair(sequence(statements[: count // 2]), sequence(statements[count // 2 :]))
    cuts = [count * i // 4 for i in range(5)]
    return Block(*[sequence(statements[cuts[i] : cuts[i + 1]]) for i in range(4)])


class Counted(Statement):
    """Base of what costs elementary instructions and stands somewhere in the program."""

    def __init__(self, source: int, cost: int) -> None:
        self.source = source
        self.cost = cost


# What every statement does, as functions of this module: the compiler puts them in line.


def begin(statement: Counted, context: Context) -> int:
    """Count a statement; 1 when a limit stops the cycle before it (RC-502, RC-503)."""
    context.steps += statement.cost
    if context.steps > context.check_at:
        return context.over_limit(statement.source)
    return 0


def stop(statement: Counted, context: Context) -> int:
    """A fault: give it the statement's place, unless the operation gave its own."""
    if context.fault_source == 0:
        context.fault_source = statement.source
    return 1


def write(statement: Counted, context: Context, cell: int, value: float) -> None:
    """Store a value; one that differs from the old one is an event."""
    if value != context.cells[cell]:
        context.cells[cell] = value
        if context.record.records_writes:
            context.record.written(statement.source, context.serial, cell, value)


def evaluate(statement: Counted, expression: Expression, context: Context) -> float:
    """Count the statement and compute what it assigns; a fault is in the context.

    A result that is not finite is 50879 (RC-207).
    """
    if begin(statement, context):
        return 0.0
    value = expression.value(context)
    if context.fault:
        stop(statement, context)
    elif value - value != 0.0:
        context.fail(50879, statement.source, 0.0, value)
    return value


class Assignment(Counted):
    """Base of ``v = e``; ``lowest`` and ``highest`` bound what an integer variable takes."""

    def __init__(
        self,
        cell: int,
        expression: Expression,
        lowest: float,
        highest: float,
        source: int,
        cost: int,
    ) -> None:
        super().__init__(source, cost)
        self.cell = cell
        self.expression = expression
        self.lowest = lowest
        self.highest = highest

    def store(self, context: Context, cell: int, value: float) -> int:
        """Convert to the variable's type and store; 1 when the value does not fit."""
        return 0


def round_into_range(statement: Assignment, context: Context, cell: int, value: float) -> float:
    """The value as an integer variable takes it; 50892 outside its range (RC-307)."""
    value = arithmetic.round_half_even(value)
    if not statement.lowest <= value <= statement.highest:
        context.fail(50892, statement.source, cell, value)
    return value


class AssignReal(Assignment):
    """Into a REAL64 variable."""

    def run(self, context: Context) -> int:
        value = evaluate(self, self.expression, context)
        if context.fault:
            return 1
        write(self, context, self.cell, value)
        return 0

    def store(self, context: Context, cell: int, value: float) -> int:
        write(self, context, cell, value)
        return 0


class AssignInteger(Assignment):
    """Into an integer variable: rounded half to even (RC-307)."""

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
    """Into a BOOLEAN: whether the magnitude is at least 0.5 (RC-307)."""

    def run(self, context: Context) -> int:
        value = evaluate(self, self.expression, context)
        if context.fault:
            return 1
        return self.store(context, self.cell, value)

    def store(self, context: Context, cell: int, value: float) -> int:
        write(self, context, cell, 1.0 if arithmetic.is_true(value) else 0.0)
        return 0


class AssignOverride(Assignment):
    """Into an override: no event, since it is written anew in every tick (RC-305).

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

    def __init__(self, index: Expression, scalar: Assignment, source: int, cost: int) -> None:
        super().__init__(source, cost)
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
    """An M or H function: into the realtime section of the HLI, in this tick (RC-403).

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
        context.record.technology_rt(self.source, context.serial, self.function, sequence)
        return 0


class CommandTimer(Counted):
    """``#TIMER START|STOP|READ|CLEAR SYN [ID=i]`` (RC-401); an ID that is none is 900421."""

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
            context.fail(900421, self.source, value, 127.0)
            return 1
        context.timers.command(self.action, int(value), context.tick)
        return 0


class Reaction(Counted):
    """Base of what runs a body under a condition.

    Counts the body's run-throughs and tells the first of each series of consecutive ones.
    ``next_tick`` is the tick behind the last of them, -1 before the first.
    """

    def __init__(self, condition: Condition, body: Statement, source: int, cost: int) -> None:
        super().__init__(source, cost)
        self.condition = condition
        self.body = body
        self.count = 0
        self.first_tick = -1
        self.next_tick = -1
        self.last_run = -2

    def restart(self) -> None:
        self.last_run = -2
        self.condition.forget()
        self.body.restart()


def judge(reaction: Reaction, context: Context) -> int:
    """Evaluate the condition: 0 false, 1 true, 2 the cycle must stop."""
    if begin(reaction, context):
        return 2
    truth = reaction.condition.decide(context)
    if context.fault:
        stop(reaction, context)
        return 2
    return truth


def react(reaction: Reaction, context: Context) -> int:
    """Run the body."""
    if reaction.last_run != context.run - 1:
        if reaction.count == 0:
            reaction.first_tick = context.tick
        context.record.fired(reaction.source, context.serial)
    if reaction.next_tick != context.tick:
        context.record.series(reaction.condition.probe, 1, reaction.next_tick)
    reaction.next_tick = context.tick + 1
    reaction.count += 1
    reaction.last_run = context.run
    return reaction.body.run(context)


class Branch(Reaction):
    """One branch of a plain ``$IF``; ``attempt``: 0 not taken, 1 taken, 2 the cycle must stop."""

    def attempt(self, context: Context) -> int:
        """Evaluate the condition and, where it holds, run the body."""
        result = judge(self, context)
        if result == 1 and react(self, context):
            return 2
        return result

    def run(self, context: Context) -> int:
        """A plain ``$IF`` with one branch."""
        truth = judge(self, context)
        return react(self, context) if truth == 1 else truth


class Branches(Branch):
    """Up to four branches, of which at most one is taken; more of them nest (RC-201)."""

    def __init__(self, first: Branch, second: Branch, third: Branch, fourth: Branch) -> None:
        super().__init__(Condition(), Statement(), 0, 0)
        self.first = first
        self.second = second
        self.third = third
        self.fourth = fourth

    def run(self, context: Context) -> int:
        return 1 if self.attempt(context) == 2 else 0

    def attempt(self, context: Context) -> int:
        result = self.first.attempt(context)
        if result:
            return result
        result = self.second.attempt(context)
        if result:
            return result
        result = self.third.attempt(context)
        if result:
            return result
        return self.fourth.attempt(context)

    def restart(self) -> None:
        self.first.restart()
        self.second.restart()
        self.third.restart()
        self.fourth.restart()


class NoBranch(Branch):
    """The null object among branches: never taken."""

    def __init__(self) -> None:
        super().__init__(Condition(), Statement(), 0, 0)

    def attempt(self, context: Context) -> int:
        return 0


def branches(alternatives: list[Branch]) -> Branch:
    """A plain ``$IF`` of these branches, nested no deeper than their number's logarithm."""
    count = len(alternatives)
    if count == 1:
        return alternatives[0]
    if count <= 4:
        return Branches(*alternatives, *[NoBranch() for _ in range(4 - count)])
    cuts = [count * i // 4 for i in range(5)]
    return Branches(*[branches(alternatives[cuts[i] : cuts[i + 1]]) for i in range(4)])


class IfOnce(Reaction):
    """``$IF ONCE``: the body runs once, at the first true evaluation (RC-203)."""

    def __init__(self, condition: Condition, body: Statement, source: int, cost: int) -> None:
        super().__init__(condition, body, source, cost)
        self.is_done = False

    def run(self, context: Context) -> int:
        if self.is_done:
            return 0
        truth = judge(self, context)
        if truth != 1:
            return truth
        self.is_done = True
        return react(self, context)

    def restart(self) -> None:
        self.is_done = False
        self.last_run = -2
        self.condition.forget()
        self.body.restart()


class IfEdge(Reaction):
    """``$IF EDGE``: the body runs at each change from false to true (RC-203)."""

    def __init__(self, condition: Condition, body: Statement, source: int, cost: int) -> None:
        super().__init__(condition, body, source, cost)
        self.was_true = 0

    def run(self, context: Context) -> int:
        truth = judge(self, context)
        if truth == 2:
            return 1
        rises = truth == 1 and self.was_true == 0
        self.was_true = truth
        return react(self, context) if rises else 0

    def restart(self) -> None:
        self.was_true = 0
        self.last_run = -2
        self.condition.forget()
        self.body.restart()


class IfAlways(Reaction):
    """``$IF ALWAYS``: after the first true evaluation no longer evaluated (RC-203)."""

    def __init__(self, condition: Condition, body: Statement, source: int, cost: int) -> None:
        super().__init__(condition, body, source, cost)
        self.is_latched = False

    def run(self, context: Context) -> int:
        if not self.is_latched:
            truth = judge(self, context)
            if truth != 1:
                return truth
            self.is_latched = True
        return react(self, context)

    def restart(self) -> None:
        self.is_latched = False
        self.last_run = -2
        self.condition.forget()
        self.body.restart()
