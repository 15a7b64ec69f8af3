# SPDX-License-Identifier: MIT
"""The longest response of one task, searched as a fixed point.

In: ``Model``, the responses of more urgent tasks as far as they are known. Out: a bound for all
jobs of the task, in ns, and whether a simulation shows exactly this bound.

A busy time is looked at from an NC interrupt on. Three cases differ:

* Without suspension it begins when no more urgent work is left. The job ends when its own work and
  that of all more urgent activations since then is done.
* A task that can be suspended: the same, counted in the time that suspendable tasks have. Tasks
  that cannot be suspended run in Windows' time, too; assuming that they all run before is on the
  safe side.
* A task that cannot be suspended, below some that can: it runs while they are suspended, so work
  of theirs can be left from before. The busy time begins with its own activation; of the others,
  work that can be pending then counts, and suspendable ones never get more than their time in each
  cycle.

A task placed by the operating system is analysed as bound to each of its processors in turn: it
waits only while all of them are busy. As a more urgent task it can come from another processor with
work left, so its possibly pending work counts.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from math import lcm

from nctakt.base.dataclass import dataclass
from nctakt.lists.declared.rtconf import InterruptSource
from nctakt.schedule.analysis.supply import Supply, suspension_offsets
from nctakt.schedule.model import ANY_CPU, Execution, Model, Task, TaskClass, Train

#: Steps of the search for one response; a schedule that needs more counts as unbounded.
MAX_STEPS = 10_000
#: Where more urgent tasks take all the time, the search ends after this many hyperperiods.
_HYPERPERIODS = 3
#: Jobs of a busy time that are looked at in any case.
_MIN_JOBS = 100


@dataclass(frozen=True, slots=True)
class Response:
    """A response in ns; ``time`` ``None``: no bound.

    ``can_overflow``: the task can be busy when it is due again. ``is_exact``: the first jobs of a
    simulation show this response. Exact needs a timer, constant times, different urgencies, no
    switching costs, no overflow, a separate processor, and no task that cannot be suspended
    reaching into Windows' time.
    """

    time: int | None
    can_overflow: bool = True
    is_exact: bool = False


class ResponseSearch:
    """Searches the responses in one model; ``known`` are bounds for all tasks up to now."""

    def __init__(self, model: Model) -> None:
        self.model = model
        self.offsets = suspension_offsets(model)
        self.supply = Supply(model, self.offsets)
        self.arrivals = Arrivals(model.train)
        self.work = [JobWork(task, model.overheads.activation) for task in model.tasks]
        self.has_free_tasks = len(model.cpus) > 1 and any(
            task.cpu == ANY_CPU for task in model.tasks
        )

    def cpus_of(self, i: int) -> tuple[int, ...]:
        """Return the processors that task ``i`` can run on."""
        cpu = self.model.tasks[i].cpu
        return self.model.cpus if cpu == ANY_CPU else (cpu,)

    def period(self, i: int) -> int:
        """Return the shortest time between two activations of task ``i``, in ns."""
        return self.arrivals.earliest(self.model.tasks[i].every)

    def is_guarded(self, cpu: int) -> bool:
        """Return whether tasks are suspended on a processor."""
        return self.model.windows > 0 and cpu in self.model.windows_cpus

    def more_urgent(self, i: int, cpu: int) -> list[int]:
        """Return the other tasks that can run before task ``i`` on ``cpu``, equal ones too."""
        urgency = self.model.tasks[i].urgency
        return [
            k
            for k, task in enumerate(self.model.tasks)
            if k != i and task.calls and task.urgency >= urgency and cpu in self.cpus_of(k)
        ]

    def response(self, i: int, bounds: Sequence[int | None]) -> Response:
        """Return the longest response of task ``i``, in ns."""
        if not self.model.tasks[i].calls:
            return Response(0, False, True)
        cpus = self.cpus_of(i)
        responses = [_BusyTime(self, i, cpu, bounds).longest_response() for cpu in cpus]
        times = [time for time in responses if time is not None]
        if not times:
            return Response(None)
        time = min(times)
        can_overflow = time > self.period(i)
        if self.work[i].longest(1) == 0:
            # A job without work ends when it begins, but comes too late at the same moment.
            time -= 1
        is_exact = not can_overflow and len(cpus) == 1 and self._is_exact(i, cpus[0], time, bounds)
        return Response(time, can_overflow, is_exact)

    def _is_exact(self, i: int, cpu: int, time: int, bounds: Sequence[int | None]) -> bool:
        model = self.model
        others = self.more_urgent(i, cpu)
        urgencies = [model.tasks[k].urgency for k in (i, *others)]
        executions = [call.execution for k in (i, *others) for call in model.tasks[k].calls]
        is_regular = (
            model.source is InterruptSource.TIMER
            and not model.overheads.switch
            and not self.has_free_tasks
            and len(set(urgencies)) == len(urgencies)
            and all(execution.is_constant for execution in executions)
        )
        if not is_regular:
            return False
        responses = {k: bounds[k] for k in others}
        if any(response is None or response >= self.period(k) for k, response in responses.items()):
            return False
        if not self.is_guarded(cpu):
            return True
        # Tasks that cannot be suspended must be finished when the others are.
        in_time = {
            k: (response or 0) <= self.supply.min_per_cycle for k, response in responses.items()
        }
        if model.tasks[i].kind is not TaskClass.ASYNCHRONOUS:
            return time <= self.supply.min_per_cycle and all(in_time.values())
        fixed = [k for k in others if model.tasks[k].kind is not TaskClass.ASYNCHRONOUS]
        return all(in_time[k] for k in fixed)


class _BusyTime:
    """The search for one task on one processor."""

    def __init__(
        self, search: ResponseSearch, i: int, cpu: int, bounds: Sequence[int | None]
    ) -> None:
        model = search.model
        self._search = search
        self._i = i
        self._task = model.tasks[i]
        others = search.more_urgent(i, cpu)
        self._is_guarded = search.is_guarded(cpu)
        suspendable = [k for k in others if self._can_be_suspended(k)]
        self._is_suspendable = self._can_be_suspended(i)
        self._is_behind = bool(suspendable) and not self._is_suspendable
        #: For each other task the NC interrupts before the busy time whose jobs it can still have.
        self._pending = {k: self._pending_of(k, bounds[k]) for k in others}
        self._fixed = [k for k in others if k not in suspendable]
        self._suspendable = suspendable
        self._steps = 0

    def _can_be_suspended(self, k: int) -> bool:
        return self._is_guarded and self._search.model.tasks[k].kind is TaskClass.ASYNCHRONOUS

    def _pending_of(self, k: int, response: int | None) -> int | None:
        """Return how many earlier NC interrupts count for a task; ``None``: without limit."""
        search = self._search
        is_free = search.has_free_tasks and search.model.tasks[k].cpu == ANY_CPU
        if not self._is_behind and not is_free:
            return 0
        return None if response is None else search.arrivals.pending(response)

    def longest_response(self) -> int | None:
        """Return the longest response of all jobs of the busy time in ns; ``None``: no bound."""
        search, task = self._search, self._task
        if self._is_suspendable and not search.supply.min_per_cycle:
            return None
        if any(self._pending[k] is None for k in self._fixed):
            return None
        if not self._is_behind and any(self._pending[k] is None for k in self._suspendable):
            return None
        remembers = task.kind is TaskClass.EXTERNAL or search.model.rules.overflow != "skip"
        if remembers and self._is_overloaded():
            return None
        work = search.work[self._i]
        limit = self._limit()
        longest, jobs, time = 0, 1, 1
        while jobs <= self._max_jobs():
            own = work.longest(jobs) + jobs * work.can_be_zero
            end = self._end(own, jobs, time, limit)
            if end is None:
                return None
            time = end
            longest = max(longest, time - search.arrivals.earliest((jobs - 1) * task.every))
            if not remembers or time <= search.arrivals.earliest(jobs * task.every):
                return longest
            jobs += 1
        return None

    def _end(self, own: int, jobs: int, start: int, limit: int | None) -> int | None:
        """Return when ``own`` work is done, from the start of the busy time."""
        time = max(start, self._min_end(own))
        while self._steps < MAX_STEPS:
            self._steps += 1
            needed = self._needed(own, jobs, time)
            if needed <= time:
                return needed
            time = needed
            if limit is not None and time > limit + own:
                return None
        return None

    def _needed(self, own: int, jobs: int, time: int) -> int:
        """Return when all work that arrives up to ``time`` is done."""
        supply = self._search.supply
        fixed = self._work_of(self._fixed, time) + self._switching(jobs, time)
        if self._is_behind:
            maximum = supply.maximum(time)
            if all(self._pending[k] is not None for k in self._suspendable):
                maximum = min(maximum, self._work_of(self._suspendable, time))
            return own + fixed + maximum
        amount = own + fixed + self._work_of(self._suspendable, time)
        return supply.moment(amount) if self._is_suspendable else amount

    def _jobs_of(self, k: int, time: int) -> int:
        """Return the most jobs of another task in the busy time up to ``time``."""
        interrupts = self._search.arrivals.count(time) + (self._pending[k] or 0)
        return -(-interrupts // self._search.model.tasks[k].every)

    def _work_of(self, tasks: list[int], time: int) -> int:
        return sum(self._search.work[k].longest(self._jobs_of(k, time)) for k in tasks)

    def _switching(self, jobs: int, time: int) -> int:
        """Return the cost of giving the processor to the task and to more urgent ones.

        Each job gets it once, and once more for each NC interrupt and each suspension, which take
        it from one task; where tasks change processors, from one task of each.
        """
        model = self._search.model
        if not model.overheads.switch:
            return 0
        others = sum(self._jobs_of(k, time) for k in (*self._fixed, *self._suspendable))
        moments = self._search.arrivals.count(time) * self._losers()
        return model.overheads.switch * (jobs + others + moments)

    def _losers(self) -> int:
        """Return how many tasks can lose a processor in one cycle without having finished."""
        cpus = len(self._search.model.cpus) if self._search.has_free_tasks else 1
        return (1 + self._is_guarded) * cpus

    def _rates(self) -> tuple[float, float]:
        """Return the share of time needed by more urgent tasks, and the share available to all."""
        model = self._search.model
        distance = model.train.distance
        supply = self._search.supply.min_per_cycle / distance
        switching = model.overheads.switch * self._losers() / distance
        fixed = self._rate_of(self._fixed) + switching
        suspendable = self._rate_of(self._suspendable)
        if self._is_behind:
            return fixed + min(suspendable, self._search.offsets.latest / distance), 1.0
        return fixed + suspendable, supply if self._is_suspendable else 1.0

    def _rate_of(self, tasks: list[int]) -> float:
        model = self._search.model
        works = (
            (self._search.work[k].mean + model.overheads.switch) / model.tasks[k].every
            for k in tasks
        )
        return sum(works) / model.train.distance

    def _is_overloaded(self) -> bool:
        """Return whether the task's remembered activations pile up forever."""
        demand, supply = self._rates()
        return demand + self._rate_of([self._i]) > supply * 1.000_001

    def _min_end(self, own: int) -> int:
        """Return a time before which the work cannot be done: at the rate that others leave."""
        demand, supply = self._rates()
        if self._is_suspendable:
            own -= self._search.supply.min_per_cycle
        return max(1, int(own / (supply - demand) * 0.999_999)) if supply > demand else 1

    def _hyperperiod(self) -> int:
        """Return after how many NC cycles all tasks that count are due together again."""
        tasks = (self._i, *self._fixed, *self._suspendable)
        return lcm(*(self._search.model.tasks[k].every for k in tasks))

    def _limit(self) -> int | None:
        """Return where the search may end without a result; ``None``: there is always one.

        When one hyperperiod brings at least as much work as time, the next one finds no less.
        """
        demand, supply = self._rates()
        if demand < supply * 0.999_999:
            return None
        return _HYPERPERIODS * self._hyperperiod() * self._search.model.train.distance

    def _max_jobs(self) -> int:
        """Return after how many jobs a busy time that has not ended counts as endless."""
        return max(_MIN_JOBS, _HYPERPERIODS * self._hyperperiod() // self._task.every)


class Arrivals:
    """Bounds of the NC interrupts after one of them; jitter can bring them closer together."""

    def __init__(self, train: Train) -> None:
        self._distance = train.distance
        self._spread = 2 * train.jitter

    def count(self, length: int) -> int:
        """Return the maximum number of NC interrupts in ``length`` ns (> 0), its start included."""
        return -(-(length + self._spread) // self._distance)

    def pending(self, response: int) -> int:
        """Return how many earlier NC interrupts can have jobs that are not finished yet.

        ``response`` is the longest response of such a job.
        """
        return max(0, -(-(response + self._spread) // self._distance) - 1)

    def earliest(self, cycles: int) -> int:
        """Return the shortest time to the NC interrupt ``cycles`` cycles later, in ns."""
        return cycles * self._distance - self._spread if cycles else 0


class JobWork:
    """The longest work of consecutive jobs of one task; ``activation`` is added to each job."""

    def __init__(self, task: Task, activation: int) -> None:
        executions: dict[str, list[Execution]] = {}
        for call in task.calls:
            executions.setdefault(call.function, []).append(call.execution)
        self._constant = activation if task.calls else 0
        self._lists: list[tuple[tuple[int, ...], int]] = []
        for calls in executions.values():
            first = calls[0]
            if first.spread or first.is_constant or any(call != first for call in calls):
                self._constant += sum(call.longest for call in calls)
            else:
                self._lists.append((first.values, len(calls)))
        self.can_be_zero = not self._constant and bool(task.calls)

    def longest(self, jobs: int) -> int:
        """Return the longest work of ``jobs`` consecutive jobs, in ns."""
        work = jobs * self._constant
        for values, calls in self._lists:
            work += longest_sum(values, jobs * calls)
        return work

    @property
    def mean(self) -> float:
        """Return the mean work of a job in ns if uniform times are always the longest."""
        return self._constant + sum(
            calls * sum(values) / len(values) for values, calls in self._lists
        )


def longest_sum(values: Sequence[int], count: int) -> int:
    """Return the greatest sum of ``count`` values that follow each other in a repeated list."""
    rounds, rest = divmod(count, len(values))
    return rounds * sum(values) + _longest_window(tuple(values), rest)


@lru_cache(maxsize=4096)
def _longest_window(values: tuple[int, ...], count: int) -> int:
    """Return the greatest sum of ``count`` neighbours, fewer than there are values."""
    around = (*values, *values)
    window = sum(around[:count])
    longest = window
    for begin in range(len(values) - 1):
        window += around[begin + count] - around[begin]
        longest = max(longest, window)
    return longest
