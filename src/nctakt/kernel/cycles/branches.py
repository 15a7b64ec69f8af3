# SPDX-License-Identifier: MIT
"""``$IF`` of realtime cycles: statements that run under a condition (RC-201 … RC-203, RC-208)."""

from __future__ import annotations

from itertools import pairwise

from nctakt.kernel import codes, rows
from nctakt.kernel.cycles import instructions
from nctakt.kernel.cycles.conditions import Condition
from nctakt.kernel.cycles.context import Context
from nctakt.kernel.cycles.instructions import Counted, Statement


class Reaction(Counted):
    """Base of a body that runs under a condition.

    Counts the body's run-throughs and records the first of each series of consecutive ones.
    ``next_tick`` is the tick after the last of them, -1 before the first.
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
    """Evaluate the condition: ``codes.FALSE``, ``codes.TRUE`` or ``codes.STOPS``.

    An evaluation that a fault breaks off has no truth.
    """
    context.steps += reaction.cost
    if context.steps > context.check_at and context.over_limit(reaction.source):
        return codes.STOPS
    truth = reaction.condition.decide(context)
    if context.fault:
        reaction.condition.forget()
        instructions.stop(reaction, context)
        return codes.STOPS
    return truth


def react(reaction: Reaction, context: Context) -> int:
    """Run the body."""
    if reaction.last_run != context.run - 1:
        if reaction.count == 0:
            reaction.first_tick = context.tick
        context.record.event(rows.EVENT_FIRED, reaction.source, context.serial)
    if reaction.next_tick != context.tick:
        context.record.series(reaction.condition.probe, rows.PROBE_RAN, reaction.next_tick)
    reaction.next_tick = context.tick + 1
    reaction.count += 1
    reaction.last_run = context.run
    return reaction.body.run(context)


class Branch(Reaction):
    """One branch of a plain ``$IF``."""

    def attempt(self, context: Context) -> int:
        """Evaluate the condition and, if it holds, run the body; as ``judge``."""
        result = judge(self, context)
        if result == codes.TRUE and react(self, context):
            return codes.STOPS
        return result

    def run(self, context: Context) -> int:
        """Run a plain ``$IF`` with one branch."""
        truth = judge(self, context)
        return react(self, context) if truth == codes.TRUE else truth


class Branches(Branch):
    """Up to four branches, of which at most one is taken; more of them nest (RC-201)."""

    def __init__(self, first: Branch, second: Branch, third: Branch, fourth: Branch) -> None:
        super().__init__(Condition(), Statement(), 0, 0)
        self.first = first
        self.second = second
        self.third = third
        self.fourth = fourth

    def run(self, context: Context) -> int:
        return 1 if self.attempt(context) == codes.STOPS else 0

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
    """Tie the branches of a plain ``$IF``, no deeper than their number's logarithm."""
    count = len(alternatives)
    if count == 1:
        return alternatives[0]
    if count <= 4:
        return Branches(*alternatives, *[NoBranch() for _ in range(4 - count)])
    cuts = [count * i // 4 for i in range(5)]
    return Branches(*[branches(alternatives[begin:end]) for begin, end in pairwise(cuts)])


class IfOnce(Reaction):
    """``$IF ONCE``: the body runs once, at the first true evaluation (RC-203)."""

    def __init__(self, condition: Condition, body: Statement, source: int, cost: int) -> None:
        super().__init__(condition, body, source, cost)
        self.is_done = False

    def run(self, context: Context) -> int:
        if self.is_done:
            return 0
        truth = judge(self, context)
        if truth != codes.TRUE:
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
        if truth == codes.STOPS:
            return 1
        rises = truth == codes.TRUE and self.was_true == 0
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
            if truth != codes.TRUE:
                return truth
            self.is_latched = True
        return react(self, context)

    def restart(self) -> None:
        self.is_latched = False
        self.last_run = -2
        self.condition.forget()
        self.body.restart()
