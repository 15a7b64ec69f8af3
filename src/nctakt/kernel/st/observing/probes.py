# SPDX-License-Identifier: MIT
"""Statement probes for a debugger of a PLC: where a tick passes, and where it is to halt.

A probe wraps a statement only while somebody debugs. It costs no elementary instructions and writes
nothing into the PLC's memory, so that a watched run does the same as any other. Statements are
numbered as they begin, from 1 on in each tick that is looked into. A halt ends the tick before a
statement as a fault does: the memory stays as it is there, and the calls that are open are noted.
The halted controller is inspected and discarded.
"""

from __future__ import annotations

from nctakt.kernel.base.arrays import integers
from nctakt.kernel.base.bounds import check_range
from nctakt.kernel.st import kinds
from nctakt.kernel.st.context import PlcContext
from nctakt.kernel.st.steps import Step
from nctakt.kernel.st.wholes import Whole, WholeConstant

#: Statements of a tick of which source and depth are kept.
KEPT = 1 << 16


class StatementCounter:
    """The statements that have begun since ``begin``; ``halt_at``: before which one to halt.

    ``sources`` and ``depths``: where the first of them are, and how many calls were open.
    """

    def __init__(self) -> None:
        self.passed = 0
        self.halt_at = 0
        self.room = KEPT
        self.each = Sought()
        self.sources = integers(KEPT)
        self.depths = integers(KEPT)

    def begin(self, halt_at: int) -> None:
        """Restart counting; halt before a statement by its number, 0: before none."""
        check_range(halt_at, 0, 1 << 60, "number of a statement")
        self.passed = 0
        self.halt_at = halt_at

    def count(self, source: int, depth: int) -> None:
        """Count a statement that begins."""
        if self.passed < self.room:
            self.sources[self.passed] = source
            self.depths[self.passed] = depth
        self.passed += 1

    def seek(self, each: Sought) -> None:
        """Let these observe each statement from now on."""
        self.each = each


class Sought:
    """Base of all probes, and null object at the end of a chain.

    ``held``: how often it has held. ``first`` after the statement number ``after``, and ``last``
    before ``before``: the numbers of the statements at which it did, 0 for none.
    """

    def __init__(self) -> None:
        self.held = 0
        self.after = 0
        self.before = 1 << 60
        self.first = 0
        self.last = 0

    def within(self, after: int, before: int) -> None:
        """Look again, between two statements by their numbers."""
        self.after = after
        self.before = before
        self.first = 0
        self.last = 0

    def look(self, context: PlcContext, number: int) -> None:
        """Look at a statement that is about to begin."""

    def note(self, number: int) -> None:
        """Note that it holds at a statement."""
        self.held += 1
        if number > self.after and self.first == 0:
            self.first = number
        if number < self.before:
            self.last = number


class SoughtStatement(Sought):
    """A statement, with ``guard`` true before it, while at most ``max_depth`` calls are open.

    ``others`` are those that are looked for at the same statement. A guard that is not defined at
    the moment is false.
    """

    def __init__(self, guard: Whole, max_depth: int, others: Sought) -> None:
        super().__init__()
        check_range(max_depth, 0, kinds.MAX_DEPTH, "number of calls")
        self.guard = guard
        self.max_depth = max_depth
        self.others = others

    def look(self, context: PlcContext, number: int) -> None:
        if context.depth <= self.max_depth:
            truth = self.guard.value(context)
            if context.fault:
                context.fault = 0
            elif truth:
                self.note(number)
        self.others.look(context, number)


class Probe(Step):
    """A statement that is numbered when it begins; ``source``: its place in the text."""

    def __init__(self, body: Step, source: int, counter: StatementCounter) -> None:
        self.body = body
        self.source = source
        self.counter = counter
        self.sought = Sought()

    def seek(self, sought: Sought) -> None:
        """Let these observe this statement from now on."""
        self.sought = sought

    def run(self, context: PlcContext) -> int:
        self.counter.count(self.source, context.depth)
        if self.counter.passed == self.counter.halt_at:
            context.fail(kinds.HALTED, 0, 0)
            return context.stop_at(self.source)
        self.counter.each.look(context, self.counter.passed)
        self.sought.look(context, self.counter.passed)
        return self.body.run(context)


#: Probe that is true at each statement.
ALWAYS = WholeConstant(1)
