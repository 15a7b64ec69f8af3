# SPDX-License-Identifier: MIT
"""The tasks of a PLC in the tick (ST-801 … ST-805).

After the channels' part of a tick the due tasks run, in order of their priorities; their writes
count from the next tick on (RC-002). The time of a task's cycle is that of the tick. A fault stops
the PLC: no further cycle runs, and its output image stays (ST-560).
"""

from __future__ import annotations

from nctakt.kernel.base.arrays import integers
from nctakt.kernel.base.bounds import check_range
from nctakt.kernel.st import kinds, words
from nctakt.kernel.st.context import PlcContext
from nctakt.kernel.st.interface import CncSide
from nctakt.kernel.st.steps import Step

#: The longest cycle of a task, in ns.
MAX_CYCLE_NS = 1 << 60


class PlcTask:
    """Base of a task, and null object at the end of the chain of tasks."""

    def is_due(self, end: int) -> int:
        """Return whether a task is due before ``end``, in ns."""
        return 0

    def run(self, context: PlcContext, begin: int, end: int) -> int:
        """Run the tasks due before ``end``, in ns; return whether the PLC keeps running."""
        return kinds.GOES_ON


class TaskInfo:
    """Addresses of a task's CycleCount, FirstCycle, LastExecTime and CycleTimeExceeded (ST-804).

    All are 0 in a PLC that does not name them.
    """

    def __init__(
        self, count_at: int = 0, first_at: int = 0, length_at: int = 0, exceeded_at: int = 0
    ) -> None:
        self.count_at = count_at
        self.first_at = first_at
        self.length_at = length_at
        self.exceeded_at = exceeded_at


class CyclicTask(PlcTask):
    """A task with its programs; ``others`` are the tasks after it.

    ``number`` counts from 1. ``overruns`` counts the cycles that took longer than ``cycle``
    (ST-830).
    """

    def __init__(
        self,
        body: Step,
        cycle: int,
        max_steps: int,
        others: PlcTask,
        number: int,
        info: TaskInfo,
    ) -> None:
        check_range(cycle, 1, MAX_CYCLE_NS, "cycle")
        check_range(max_steps, 1, 1 << 62, "instructions")
        self.body = body
        self.cycle = cycle
        self.max_steps = max_steps
        self.others = others
        self.number = number
        self.info = info
        self.due = 0
        self.count = 0
        self.overruns = 0

    def exchange(self, body: Step) -> None:
        """Run this from now on: the same programs, with probes."""
        self.body = body

    def is_due(self, end: int) -> int:
        return 1 if self.due < end else self.others.is_due(end)

    def run(self, context: PlcContext, begin: int, end: int) -> int:
        if self.due < end:
            while self.due < end:
                self.due += self.cycle
            context.begin(begin)
            context.max_steps = self.max_steps
            context.task = self.number
            self.count += 1
            if self.info.count_at:
                words.store(context.memory, self.info.count_at, kinds.U32, self.count)
                words.store(context.memory, self.info.first_at, kinds.BOOL, self.count == 1)
            if self.body.run(context) == kinds.STOPS:
                return kinds.STOPS
            if context.instruction_ns:
                self.note_length(context, begin)
        return self.others.run(context, begin, end)

    def note_length(self, context: PlcContext, begin: int) -> None:
        """Note how long a cycle took; due times that pass meanwhile are lost (ST-830)."""
        length = context.steps * context.instruction_ns
        while self.due < begin + length:
            self.due += self.cycle
        is_exceeded = length > self.cycle
        if is_exceeded:
            self.overruns += 1
            context.overrun_task = self.number
            context.overrun_ns = length
        if self.info.count_at:
            words.store(context.memory, self.info.length_at, kinds.U32, words.divide(length, 100))
            words.store(context.memory, self.info.exceeded_at, kinds.BOOL, is_exceeded)


class PlcSide:
    """Base of a PLC in the tick, and null object: no PLC.

    ``has_news``: a fault that Python has not seen yet.
    """

    def __init__(self) -> None:
        self.has_news = False

    def event_bound(self) -> int:
        """Highest number of events in a tick."""
        return 0

    def latch(self) -> None:
        """Take over the variables that it has written, at the start of a tick."""

    def guard(self) -> None:
        """Put its commands into force, after what others have written."""

    def run(self, tick: int) -> None:
        """Run the tasks due in a tick."""


class PlcPair(PlcSide):
    """Two PLC projects, the second after the first in each tick."""

    def __init__(self, first: PlcSide, second: PlcSide) -> None:
        super().__init__()
        self.first = first
        self.second = second

    def event_bound(self) -> int:
        return self.first.event_bound() + self.second.event_bound()

    def latch(self) -> None:
        self.first.latch()
        self.second.latch()

    def guard(self) -> None:
        self.first.guard()
        self.second.guard()

    def run(self, tick: int) -> None:
        self.first.run(tick)
        self.second.run(tick)
        self.has_news = self.first.has_news or self.second.has_news


class PlcTasks(PlcSide):
    """All tasks of a PLC, with its inputs from outside, and the variables that are signals.

    Its time begins with ``first_tick``; ``memory`` is that of the machine, with the signals' cells;
    ``cnc``: the interface to the CNC.
    """

    def __init__(
        self,
        context: PlcContext,
        tasks: PlcTask,
        tick_ns: int,
        first_tick: int,
        memory: bytearray,
        cnc: CncSide,
    ) -> None:
        check_range(tick_ns, 1, MAX_CYCLE_NS, "tick")
        check_range(first_tick, 0, 1 << 60, "first tick")
        super().__init__()
        self.context = context
        self.tasks = tasks
        self.cnc = cnc
        self.tick_ns = tick_ns
        self.first_tick = first_tick
        self.cells = memoryview(memory).cast("d")
        self.message_at = 0
        self.input_count = 0
        self.input_address = integers(kinds.MAX_INPUTS)
        self.input_byte = integers(kinds.MAX_INPUTS)
        self.output_count = 0
        self.output_address = integers(kinds.MAX_OUTPUTS)
        self.output_kind = integers(kinds.MAX_OUTPUTS)
        self.output_cell = integers(kinds.MAX_OUTPUTS)

    def post(self, address: int, data: bytes) -> None:
        """Put bytes into the image that the next cycle latches."""
        check_range(address, kinds.NULL_BYTES, self.context.stack - len(data), "address")
        check_range(len(data), 0, kinds.MAX_INPUTS - self.input_count, "number of bytes")
        for i, byte in enumerate(data):
            self.input_address[self.input_count] = address + i
            self.input_byte[self.input_count] = byte
            self.input_count += 1

    def watch_messages(self, address: int) -> None:
        """Let Python look after each tick in which the number of messages is not 0 (ST-721)."""
        check_range(address, kinds.NULL_BYTES, self.context.stack - 4, "address")
        self.message_at = address

    def show(self, address: int, kind: int, cell: int) -> None:
        """Show a variable in a cell of the machine's memory after each tick."""
        # The stack follows: no width leads out of the memory.
        check_range(address, kinds.NULL_BYTES, self.context.stack - 1, "address")
        check_range(kind, kinds.BOOL, kinds.F64, "kind")
        check_range(cell, 0, len(self.cells) - 1, "cell")
        check_range(self.output_count, 0, kinds.MAX_OUTPUTS - 1, "number of signals")
        self.output_address[self.output_count] = address
        self.output_kind[self.output_count] = kind
        self.output_cell[self.output_count] = cell
        self.output_count += 1

    def event_bound(self) -> int:
        return self.cnc.event_bound()

    def latch(self) -> None:
        self.cnc.latch()

    def guard(self) -> None:
        self.cnc.guard()

    def run(self, tick: int) -> None:
        """Run the tasks that are due in a tick."""
        begin = (tick - self.first_tick) * self.tick_ns
        self.cnc.follow(tick)
        self.context.outside.follow()
        if self.context.fault == 0:
            self.latch_inputs(begin)
            if self.tasks.is_due(begin + self.tick_ns):
                self.run_tasks(tick, begin)
        self.show_outputs()

    def latch_inputs(self, begin: int) -> None:
        """Put values from outside into the memory, at this time in ns."""
        for i in range(self.input_count):
            words.store(self.context.memory, self.input_address[i], kinds.U8, self.input_byte[i])
        if self.context.is_noting:
            for i in range(self.input_count):
                self.context.notes.touch(self.context.memory, self.input_address[i], begin)
        self.input_count = 0

    def run_tasks(self, tick: int, begin: int) -> None:
        """Run the due tasks: show them the CNC's values first, take their commands afterwards."""
        self.cnc.show(tick)
        if self.context.is_noting:
            self.context.notes.refresh(self.context.memory, begin)
        if self.tasks.run(self.context, begin, begin + self.tick_ns) == kinds.STOPS:
            self.has_news = True
            if self.context.fault != kinds.HALTED:
                self.cnc.leave()
        elif self.cnc.read_commands() or self.context.overrun_task:
            self.has_news = True
        if self.context.notes.is_crowded:
            self.has_news = True
        if self.message_at and words.load(self.context.memory, self.message_at, kinds.I32):
            self.has_news = True

    def show_outputs(self) -> None:
        """Copy the variables that are signals into their cells."""
        for i in range(self.output_count):
            address = self.output_address[i]
            kind = int(self.output_kind[i])
            cell = self.output_cell[i]
            if kind >= kinds.F32:
                self.cells[cell] = words.load_real(self.context.memory, address, kind)
            elif kind == kinds.U64:
                value = words.load(self.context.memory, address, kind)
                self.cells[cell] = words.real_of_unsigned(value)
            else:
                self.cells[cell] = words.load(self.context.memory, address, kind)
