# SPDX-License-Identifier: MIT
# cython: boundscheck=True, cdivision=False, initializedcheck=True, wraparound=True
"""A model -> its schedule in virtual time.

In: ``Model``, the number of NC cycles. Out: ``Simulation``. Everything is released at NC
interrupts, so within one cycle nothing is preempted: each processor works off its tasks in the
order of their urgency, suspendable ones up to the point of suspension, the others up to the next
interrupt, and the rest of the cycle belongs to Windows. At equal instants the order is: a job ends,
a timer interrupt suspends, the NC interrupt releases, processors are given.

When nothing is random, the state at the start of a cycle decides all that follows; once it comes
back the rest is counted in whole repetitions, not simulated.
"""

from __future__ import annotations

from array import array
from collections import deque
from math import lcm

from nctakt.schedule.model import ANY_CPU, Model, TaskClass, suspension_point
from nctakt.schedule.simulation.chance import Chance
from nctakt.schedule.simulation.counters import NEVER, Counters
from nctakt.schedule.simulation.recorder import Recorder
from nctakt.schedule.simulation.repetition import Repetition
from nctakt.schedule.simulation.results import Event, EventKind, Simulation
from nctakt.schedule.simulation.shared_cores import Placement
from nctakt.schedule.simulation.work import Work

#: No job: the work left of a task that waits.
IDLE = -1
#: Maximum hyperperiod, in cycles, whose due tasks are looked up, not computed.
_LONGEST_TABLE = 10_000


def hyperperiod(model: Model) -> int:
    """Return the number of NC cycles after which the same tasks are due again."""
    return lcm(1, *(task.every for task in model.tasks))


def simulate(
    model: Model, cycles: int, *, record: int | range | None = None, repeat: bool = True
) -> Simulation:
    """Simulate ``cycles`` NC cycles (at least one).

    ``record``: the cycles that are recorded in full, or how many of the first ones, by default one
    hyperperiod. ``repeat``: count repetitions instead of simulating them, where that is exact.
    """
    assert cycles > 0
    requested = hyperperiod(model) if record is None else record
    if isinstance(requested, int):
        requested = range(requested)
    recorded = requested[: max(0, cycles - requested.start)]
    state = SchedulerState(model, Recorder(recorded))
    search = Repetition() if repeat and state.can_repeat else None
    start = begin = state.interrupt(0)
    if search is not None:
        search.note_start(state, begin)
    cycle = 0
    while cycle < cycles:
        if recorded and cycle == recorded.start:
            state.begin_record()
        end = state.interrupt(cycle + 1)
        state.run_cycle(cycle, begin, end)
        begin = end
        cycle += 1
        if cycle == recorded.stop and state.recorder.is_open:
            state.end_record(begin)
        if search is not None and cycle >= recorded.stop:
            skipped = search.cycles_to_skip(state, cycle, cycles, begin)
            cycle += skipped
            begin += skipped * model.train.distance
    return state.result(cycles, start, begin, search)


class SchedulerState:
    """The state that a cycle passes on to the next."""

    def __init__(self, model: Model, recorder: Recorder) -> None:
        tasks = model.tasks
        self.model = model
        self.hyperperiod = hyperperiod(model)
        self.counters = Counters(model)
        self.recorder = recorder
        self._records = self.recorder.is_open
        #: The work left of each task's job, when that job was due, its place in the queue.
        self.left = array("q", [IDLE] * len(tasks))
        self._due = array("q", [0] * len(tasks))
        self._sequence = array("q", [0] * len(tasks))
        self._next_sequence = 0
        #: When the activations that are remembered after that job were due.
        self._waiting: list[deque[int]] = [deque() for _ in tasks]
        self.suspendable = [task.kind is TaskClass.ASYNCHRONOUS for task in tasks]
        self._stoppable = [i for i, suspendable in enumerate(self.suspendable) if suspendable]
        self._cpu = [task.cpu for task in tasks]
        self._chance = Chance(model.seed)
        extra = model.overheads.activation
        self._work = [Work(task, extra, self._chance) for task in tasks]
        #: The task that each processor (from 1) ran last.
        self._last = array("q", [IDLE] * (max(model.cpus) + 1))
        self._idle = array("q", [0] * len(self._last))
        self._switch = model.overheads.switch
        self._phase = model.train.phase
        self._distance = model.train.distance
        self._jitter = model.train.jitter
        # Where interrupts fall on timer interrupts the suspension comes always at the same place.
        self._is_regular = bool(model.windows) and model.is_synchronous
        self._offset = max(0, model.cycle - model.windows)
        self._processors = [(cpu, cpu in model.windows_cpus) for cpu in model.cpus]
        self._sort_tasks()
        self._due_table = self._make_due_table()

    def _sort_tasks(self) -> None:
        """Sort the tasks of each processor, the most urgent first."""
        tasks, cpus = self.model.tasks, self.model.cpus
        is_free = len(cpus) > 1 and any(task.cpu == ANY_CPU for task in tasks)
        self._placement = Placement(self.model) if is_free else None
        #: Of all processors together under ``ANY_CPU``.
        self._order: list[list[int]] = []
        self._has_ties: list[bool] = []
        order = sorted(range(len(tasks)), key=lambda i: (-tasks[i].urgency, i))
        for cpu in range(max(cpus) + 1):
            own = [i for i in order if cpu == ANY_CPU or tasks[i].cpu in (cpu, ANY_CPU)]
            self._order.append(own)
            self._has_ties.append(len({tasks[i].urgency for i in own}) < len(own))

    def _make_due_table(self) -> list[list[int]]:
        if self.hyperperiod > _LONGEST_TABLE:
            return []
        return [self._due_in(cycle) for cycle in range(self.hyperperiod)]

    def _due_in(self, cycle: int) -> list[int]:
        tasks = enumerate(self.model.tasks)
        return [i for i, task in tasks if task.calls and cycle % task.every == 0]

    @property
    def can_repeat(self) -> bool:
        """Return whether nothing in the model is random."""
        return not self.model.train.jitter and not any(work.is_random for work in self._work)

    def key(self, now: int) -> tuple[object, ...]:
        """Return the state that decides the future, at the start of a cycle at ``now``."""
        busy = [i for i, left in enumerate(self.left) if left != IDLE]
        busy.sort(key=self._sequence.__getitem__)
        return (
            tuple(self.left),
            tuple((i, now - self._due[i]) for i in busy),
            tuple(tuple(now - due for due in waiting) for waiting in self._waiting),
            tuple(work.state for work in self._work),
            tuple(self._last) if self._switch else (),
            None if self._placement is None else self._placement.state,
            0 if self.model.is_synchronous else now % self.model.slice,
        )

    def shift(self, by: int) -> None:
        """Continue ``by`` ns later in the same state."""
        self._due = array("q", [due + by for due in self._due])
        self._waiting = [deque(due + by for due in waiting) for waiting in self._waiting]

    def interrupt(self, cycle: int) -> int:
        """Return the time of the NC interrupt that opens ``cycle``, in ns."""
        moment = self._phase + cycle * self._distance
        if self._jitter:
            moment += self._chance.randint(-self._jitter, self._jitter)
        return moment

    def begin_record(self) -> None:
        """Begin the record, with the jobs that are open."""
        self.recorder.open(list(self.counters.completed))
        self._records = True
        for i, left in enumerate(self.left):
            if left != IDLE:
                times = self._work[i].times
                done = sum(times) + self.model.overheads.activation - left
                self.recorder.add_carried_job(i, self._due[i], times, done)

    def end_record(self, now: int) -> None:
        """End the record at ``now``."""
        self.recorder.close(now)
        self._records = False

    def run_cycle(self, cycle: int, begin: int, end: int) -> None:
        """Simulate one NC cycle, from its interrupt up to the next one."""
        self._release(cycle, begin)
        point = self._point(begin)
        stop = end if point == NEVER or point > end else point
        if self._placement is not None:
            order = self._by_urgency(ANY_CPU)
            self._idle = array("q", self._placement.run(self, order, begin, stop, end))
        else:
            for cpu, on_windows in self._processors:
                limit = stop if on_windows else end
                self._idle[cpu] = self._run_cpu(cpu, begin, limit, end)
        is_missed = point > end
        suspended = point != NEVER and not is_missed and self._suspend(stop)
        self.counters.end_cycle(self._idle, point, end, is_missed, suspended)

    def _point(self, begin: int) -> int:
        """Return the point of suspension in the cycle from ``begin`` on, or ``NEVER``."""
        if self._is_regular:
            return begin + self._offset
        point = suspension_point(self.model, begin)
        return NEVER if point is None else point

    def _release(self, cycle: int, begin: int) -> None:
        if self._records:
            self.recorder.interrupt(begin, cycle)
        table = self._due_table
        for i in table[cycle % self.hyperperiod] if table else self._due_in(cycle):
            self.counters.due[i] += 1
            if self.left[i] != IDLE:
                self._overflow(i, begin)
                continue
            self._due[i] = begin
            self._sequence[i] = self._next_sequence
            self._next_sequence += 1
            work = self._work[i]
            self.left[i] = work.draw()
            if self._records:
                self.recorder.job(i, begin, begin, work.times)

    def _overflow(self, i: int, begin: int) -> None:
        """Handle an activation that finds its task busy."""
        self.counters.overflow(i, begin)
        if self._records:
            self.recorder.event(Event(begin, EventKind.OVERFLOW, i, self.left[i]))
        external = self.model.tasks[i].kind is TaskClass.EXTERNAL
        policy = "queue" if external else self.model.rules.overflow
        if policy == "queue" or (policy == "pend" and not self._waiting[i]):
            self._waiting[i].append(begin)
        else:
            self.counters.lost[i] += 1

    def _by_urgency(self, cpu: int) -> list[int]:
        """Return the tasks of a processor; equally urgent ones in the order of their release."""
        order = self._order[cpu]
        if not self._has_ties[cpu]:
            return order
        tasks, sequence = self.model.tasks, self._sequence
        return sorted(order, key=lambda i: (-tasks[i].urgency, sequence[i]))

    def _run_cpu(self, cpu: int, begin: int, stop: int, end: int) -> int:
        """Simulate a cycle of one processor; return its idle time in ns."""
        now = begin
        for i in self._by_urgency(cpu):
            if self.left[i] == IDLE:
                continue
            got, limit = now, stop if self.suspendable[i] else end
            while now < limit and self.left[i] != IDLE:
                overhead = self.switch(i, cpu)
                until = now + self.left[i] + overhead
                now = self.advance(i, cpu, now, until if until < limit else limit, overhead)
            if now > stop and now > got:
                self.counters.runs_late(cpu, i)
        return end - now

    def switch(self, i: int, cpu: int) -> int:
        """Return the cost of giving ``cpu`` to task ``i``, in ns."""
        return 0 if self._last[cpu] == i else self._switch

    def advance(self, i: int, cpu: int, now: int, until: int, overhead: int) -> int:
        """Let task ``i`` run from ``now`` to ``until``, in ns; return ``until``."""
        self._last[cpu] = i
        if self._records:
            self.recorder.segment(cpu, now, until, i, overhead)
        self.counters.busy[i] += until - now
        left = self.left[i] + overhead - (until - now)
        self.left[i] = left
        if left == 0:
            self._finish(i, until)
        return until

    def _finish(self, i: int, now: int) -> None:
        """End the job of task ``i``; a remembered activation begins at once."""
        response = now - self._due[i]
        self.counters.finish(i, response)
        if self._records:
            self.recorder.event(Event(now, EventKind.END, i, response))
        if not self._waiting[i]:
            self.left[i] = IDLE
            return
        work = self._work[i]
        self._due[i] = self._waiting[i].popleft()
        self.left[i] = work.draw()
        if self._records:
            self.recorder.job(i, self._due[i], now, work.times)

    def _suspend(self, moment: int) -> bool:
        """Suspend tasks on the CPUs of Windows; return whether any was suspended."""
        is_any = False
        for i in self._stoppable:
            if self.left[i] == IDLE:
                continue
            cpu = self._cpu[i]
            if cpu == ANY_CPU and self._placement is not None:
                cpu = self._placement.cpu_at_stop(i)
            if cpu == ANY_CPU or cpu in self.model.windows_cpus:
                is_any = True
                self.counters.suspensions[i] += 1
                if self._records:
                    self.recorder.suspend(moment, i, self.left[i])
        return is_any

    def result(
        self, cycles: int, begin: int, end: int, repetition: Repetition | None
    ) -> Simulation:
        """Return the results of the simulation."""
        unfinished = [self._due[i] if left != IDLE else None for i, left in enumerate(self.left)]
        return Simulation(
            self.model,
            cycles,
            begin,
            end,
            self.counters.task_numbers(unfinished),
            self.counters.windows_numbers(),
            self.counters.missed,
            self.counters.suspended_cycles,
            None if repetition is None else repetition.period,
            self.recorder.result(),
            None if repetition is None else repetition.begin,
        )
