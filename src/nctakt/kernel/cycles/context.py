# SPDX-License-Identifier: MIT
"""The view of a running realtime cycle: the memory, the tick, its budget, its fault.

Every numeric variable of the machine is one float64 cell of one block of memory. The ``Context`` of
a channel is its view of that block, with everything else that the channel's cycles need.
"""

from __future__ import annotations

from functools import cache

from nctakt.kernel import cells
from nctakt.kernel.axes.axes import Axes
from nctakt.kernel.axes.single_axes import SingleAxes
from nctakt.kernel.axes.spindles import Spindles
from nctakt.kernel.base.record import Record
from nctakt.kernel.base.timers import Timers
from nctakt.kernel.plc.panel import Panel
from nctakt.kernel.plc.technology_slots import Hli


class Context:
    """One channel's cycles at work.

    ``serial`` and ``run`` name the running cycle and its run-through, ``owner`` its slot for those
    who carry out its actions; ``max_open_actions`` of them may be open at once (P-CHAN-00480).
    ``steps`` counts the elementary instructions of this tick (RC-501), ``check_at`` is the count
    from which ``over_limit`` decides (RC-502, RC-503). ``fault`` is the message ID of the fault
    that stopped the running cycle, 0 without a fault; ``fault_source``, ``fault_a`` and ``fault_b``
    are its place and values. ``user_reaction`` is the highest RC of the ``#ERROR`` in this tick
    (RC-402).
    """

    def __init__(
        self,
        memory: bytearray,
        record: Record,
        hli: Hli,
        timers: Timers,
        single_axes: SingleAxes,
        spindles: Spindles,
    ) -> None:
        self.cells = memoryview(memory).cast("d")
        self.record = record
        self.hli = hli
        self.timers = timers
        self.single_axes = single_axes
        self.spindles = spindles
        self.tick = 0
        self.serial = 0
        self.run = 0
        self.user_reaction = 0
        self.owner = 0
        self.max_open_actions = 5
        self.fault = 0
        self.fault_source = 0
        self.fault_a = 0.0
        self.fault_b = 0.0
        self.steps = 0
        self.check_at = 0
        self.max_steps = 4294967294
        self.cont_steps = 100
        self.budget_steps = 75000

    def begin(self, tick: int) -> None:
        """Begin a tick: no instruction is counted yet."""
        self.tick = tick
        self.steps = 0
        self.fault = 0
        self.user_reaction = 0
        self.next_check()

    def next_check(self) -> None:
        """Set the next count at which the limits are checked."""
        self.check_at = min(self.steps + self.cont_steps, self.max_steps)

    def over_limit(self, source: int) -> int:
        """Check P-CHAN-00427, then P-CHAN-00425 in virtual time; 1 if the cycle must stop."""
        if self.steps > self.max_steps:
            self.fail(50854, source, self.steps, self.max_steps)
            return 1
        if self.steps > self.budget_steps:
            self.fail(50939, source, self.steps, self.budget_steps)
            return 1
        self.next_check()
        return 0

    def fail(self, message: int, source: int, a: float, b: float) -> None:
        """Note the first fault of a statement; ``source`` 0: the statement adds its source."""
        if self.fault == 0:
            self.fault = message
            self.fault_source = source
            self.fault_a = a
            self.fault_b = b


def empty_context() -> Context:
    """Context without variables, for expressions whose operands are all constant."""
    return context_of(bytearray(8 * 10))


def context_of(memory: bytearray) -> Context:
    """Context whose cells are this memory, at least ten, for expressions of Python's side."""
    record = Record(memory, row_capacity=1, event_capacity=1, probe_capacity=1)
    return Context(memory, record, *_without_machine())


@cache
def _without_machine() -> tuple[Hli, Timers, SingleAxes, Spindles]:
    """Objects that no expression reaches: slots, timers, axes, spindles; shared by all cycles."""
    own = bytearray(8 * (cells.PANEL_CELLS + cells.TIMERS))
    record = Record(own, row_capacity=1, event_capacity=1, probe_capacity=1)
    single_axes = SingleAxes(Axes(own, 0, 0), record, 1000)
    timers, spindles = Timers(own, cells.PANEL_CELLS, 1000), Spindles(own, 0, 0, record, 1000)
    return Hli(Panel(own, 0)), timers, single_axes, spindles
