# SPDX-License-Identifier: MIT
"""When a PLC in Python is due: its conditions are checked after each tick, without Python.

Such a PLC names what it waits for: a tick, a function or a spindle's job that appears, conditions
that become true; functions that it acknowledges after a delay. ``Kernel.run`` returns after a tick
in which any of it has happened; the PLC costs the other ticks nothing else. Its actions count from
the next tick on (RC-002), and acknowledgements come after the call that is due.
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.kernel import codes
from nctakt.kernel.axes.spindles import Spindles
from nctakt.kernel.base.arrays import integers
from nctakt.kernel.base.bounds import check_range
from nctakt.kernel.cycles.context import context_of
from nctakt.kernel.cycles.expressions import Expression
from nctakt.kernel.plc.technology_slots import Hli, Section
from nctakt.kernel.tick import stops

#: A delay that no run reaches: a function is not acknowledged.
NEVER = 1 << 62


class Whens:
    """A chain of conditions, since the tick cannot walk through a list; the base is its end."""

    def look(self, tick: int) -> int:
        """Return whether any of them has become true after this tick; look at all."""
        return 0


class When(Whens):
    """A condition that a PLC waits for; ``was_true``: its truth at the last look.

    It looks at a tick once, however often it is asked.
    """

    def __init__(self, expression: Expression, memory: bytearray, was_true: bool) -> None:
        self.expression = expression
        self.context = context_of(memory)
        self.was_true = 1 if was_true else 0
        self.rises = 0
        self.tick = -1
        self.others = Whens()

    def before(self, others: Whens) -> When:
        """Put it before other conditions; return it as the begin of the chain."""
        self.others = others
        return self

    def rises_in(self, tick: int) -> bool:
        """Return whether it has become true after this tick."""
        check_range(tick, 0, NEVER, "tick")
        self.look_alone(tick)
        return self.rises != 0

    def look(self, tick: int) -> int:
        self.look_alone(tick)
        return self.others.look(tick) | self.rises

    def look_alone(self, tick: int) -> None:
        """Watch this condition and no other."""
        if self.tick == tick:
            return
        self.tick = tick
        self.context.tick = tick
        is_now = stops.is_true(self.expression, self.context)
        self.rises = 1 if is_now and not self.was_true else 0
        self.was_true = is_now


class Delays:
    """After how many ticks a PLC acknowledges functions: all others, and those of some codes."""

    def __init__(self, others: int, functions: Sequence[int], delays: Sequence[int]) -> None:
        self.others = others
        self.count = len(functions)
        self.functions = integers(self.count + 1)
        self.delays = integers(self.count + 1)
        for i, (function, delay) in enumerate(zip(functions, delays, strict=True)):
            self.functions[i] = function
            self.delays[i] = delay

    def delay_of(self, function: int) -> int:
        """Delay of a function in ticks."""
        for i in range(self.count):
            if self.functions[i] == function:
                return self.delays[i]
        return self.others


class PlcCalls:
    """The conditions that a PLC in Python waits for; ``is_watching``: there is such a PLC.

    ``next_tick``: the tick after which it is called at the latest. ``is_noting``: somebody takes
    note of acknowledgements, ``answer_count``: how many there were after the latest tick.
    """

    def __init__(self, hli: Hli, spindles: Spindles) -> None:
        self.is_watching = False
        self.is_noting = False
        self.next_tick = 0
        self.hli = hli
        self.spindles = spindles
        self.issued_program = 0
        self.issued_realtime = 0
        self.issued_jobs = 0
        self.whens = Whens()
        self.delays = Delays(NEVER, [], [])
        self.answer_count = 0

    def watch(self, hli: Hli, spindles: Spindles, whens: Sequence[When], delays: Delays) -> None:
        """Wait for these conditions, for functions and jobs, and for the next tick at first."""
        self.whens = Whens()
        for when in reversed(whens):
            self.whens = when.before(self.whens)
        self.hli = hli
        self.spindles = spindles
        self.delays = delays
        self.next_tick = 0
        self.answer_count = 0
        self.is_watching = True

    def stop(self) -> None:
        """Wait for nothing any more."""
        self.is_watching = False

    def is_due(self, tick: int) -> int:
        """Return whether the PLC is to be called after this tick."""
        is_new = self.hli.program.issued != self.issued_program
        is_new = is_new or self.hli.realtime.issued != self.issued_realtime
        is_new = is_new or self.spindles.issued != self.issued_jobs
        if is_new:
            self.issued_program = self.hli.program.issued
            self.issued_realtime = self.hli.realtime.issued
            self.issued_jobs = self.spindles.issued
        is_risen = self.whens.look(tick)
        return 1 if is_new or is_risen or tick >= self.next_tick else 0

    def answer(self, tick: int) -> None:
        """Acknowledge the functions whose delay is over, after the PLC's call."""
        self.answer_count = 0
        if self.hli.waiting_count() > 0:
            self.answer_section(self.hli.program, tick)
            self.answer_section(self.hli.realtime, tick)

    def answer_section(self, section: Section, tick: int) -> None:
        """Acknowledge the functions of a section."""
        for i in range(section.slot_count):
            section.is_answered[i] = 0
            if section.state[i] == codes.FREE:
                continue
            if tick - section.tick[i] >= self.delays.delay_of(section.function[i]):
                section.state[i] = codes.ACKNOWLEDGED
                section.is_answered[i] = 1
                self.answer_count += 1
