# SPDX-License-Identifier: MIT
"""Threads of this process that work when a scheduling list says so: class, processor, overflow.

In: the plan of a list, for each thread the action of one step of its job. Out: jobs that begin at
NC interrupts, overflows by the rule of the simulation (an activation that finds its thread busy is
lost), numbers in the form of a simulation. A step of a job never runs in parallel with the owner's
work: the owner opens the gate while it waits for an interrupt, and closes it before it continues.
"""

from __future__ import annotations

import os
import sys
import threading
import time
from collections import deque
from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

from nctakt.base.dataclass import dataclass
from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.scheduling.linux_run import SEMAPHORE_NOT_OPENED
from nctakt.schedule.model import Model, TaskClass, suspension_point
from nctakt.schedule.real.measure import Measurement
from nctakt.schedule.real.names import SemaphoreNames
from nctakt.schedule.real.plan import Plan, PlannedTask
from nctakt.schedule.simulation.counters import Counters
from nctakt.schedule.simulation.results import Record, Simulation

if TYPE_CHECKING:
    from nctakt.schedule.real.processes import Semaphore

#: Latencies that are kept of each thread; the table shows the latest ones.
_MAX_LATENCIES = 100_000

#: The time from the start to the first NC interrupt, in ns.
_LEAD = 20_000_000

#: What one step of a job does; it returns whether the job has another step.
Step = Callable[[], bool]


class Gate:
    """Lets threads work while its owner waits, one step at a time."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._is_open = threading.Event()
        self._lock.acquire()

    def open(self) -> None:
        """Let the threads work."""
        self._lock.release()
        self._is_open.set()

    def close(self) -> None:
        """Stop the threads after the step that is being made."""
        self._is_open.clear()
        self._lock.acquire()

    def step(self, work: Step) -> bool:
        """Make a step once the gate is open; return what it returns."""
        while True:
            self._is_open.wait()
            with self._lock:
                if self._is_open.is_set():
                    return work()


@dataclass(slots=True)
class _OwnerJob:
    """The latest job of the owner: when it was due, begun and done, in ns; 0: not yet."""

    due: int = 0
    begin: int = 0
    end: int = 0


class ScheduleThreads:
    """The threads of one controller, owned by the thread of the interpolation.

    ``interpolation``: the task that the owner plays; ``steps``: what a step of each other task that
    is played here does. ``refusals``: task and errno of each class or processor that was refused.
    """

    def __init__(self, plan: Plan, interpolation: int, steps: dict[int, Step]) -> None:
        from nctakt.schedule.real import processes  # noqa: PLC0415 - it may be missing

        self._processes = processes
        self._plan = plan
        self._tasks = {planned.number: planned for planned in plan.tasks}
        self._own = self._tasks[interpolation]
        self._model: Model = replace(plan.model, windows=0, windows_cpus=())
        self._counters = Counters(self._model)
        self._gate = Gate()
        self.refusals: list[tuple[int, int]] = []
        self._timer: deque[int] = deque(maxlen=_MAX_LATENCIES)
        self._wakes: list[deque[int]] = [deque(maxlen=_MAX_LATENCIES) for _ in plan.model.tasks]
        self._threads = [_Worker(self, self._tasks[i], step) for i, step in steps.items()]
        external = [one for one in plan.tasks if one.semaphore and one.number not in steps]
        self._names = SemaphoreNames([one.semaphore for one in external])
        self._semaphores = [(one, _opened(one.semaphore)) for one in external]
        #: Of each foreign thread how many posts were taken.
        self._taken: dict[int, int] = {}
        self._cycle = 0
        self._anchor = 0
        self._anchor_cycle = 0
        self._job = _OwnerJob()
        self.suspends_at = 0
        self._before: _Placement | None = None

    # --- the owner ------------------------------------------------------------------------------

    def restart(self) -> None:
        """Let the next NC interrupt be soon: the owner begins, or has paused."""
        self._anchor = 0

    def wait(self, every: int) -> tuple[bool, list[int]]:
        """Wait for the next activation of the owner, once in ``every`` NC cycles.

        Returns whether it is lost, since the owner was still busy, and which threads were.
        """
        if not self._anchor:
            self._start()
        busy: list[int] = []
        while True:
            cycle, due = self._cycle, self._due_of(self._cycle)
            self._gate.open()
            try:
                now = self._processes.wait_until(due)
            finally:
                self._gate.close()
            self._timer.append(max(0, now - due))
            self._cycle += 1
            self._release(cycle, due, busy)
            if cycle % every:
                continue
            own = self._own.number
            self._counters.due[own] += 1
            if self._job.end > due:
                self._counters.overflow(own, due)
                self._counters.lost[own] += 1
                return True, [own, *busy]
            self._job.due, self._job.begin = due, self.now()
            self._wakes[own].append(max(0, self._job.begin - due))
            return False, busy

    def finish(self) -> None:
        """Note that the owner's job is done."""
        if self._job.begin > self._job.end:
            self._job.end = self.now()
            self._counters.busy[self._own.number] += self._job.end - self._job.begin
            self._counters.finish(self._own.number, self._job.end - self._job.due)

    def close(self) -> None:
        """End the threads, and remove the semaphores."""
        for thread in self._threads:
            thread.end()
        self._gate.open()
        for thread in self._threads:
            thread.join()
        self._gate.close()
        self._semaphores.clear()
        self._names.remove()
        if self._before is not None:
            self._before.restore()

    def _start(self) -> None:
        """Place this thread, start the others, and let the first cycle begin soon."""
        if not self._cycle:
            self._before = _Placement()
            self.assign(self._own)
            for thread in self._threads:
                thread.start()
        self._anchor = self.now() + _LEAD
        self._anchor_cycle = self._cycle
        self._job.begin = self._job.end = 0

    def _due_of(self, cycle: int) -> int:
        return self._anchor + (cycle - self._anchor_cycle) * self._model.cycle

    def now(self) -> int:
        """Return the time of the monotonic clock in ns."""
        return self._processes.wait_until(0)

    def assign(self, task: PlannedTask) -> None:
        """Give the calling thread class and processor of a task."""
        priority = task.priority if self._plan.is_fifo else 0
        error = self._processes.place_thread(priority, task.task.cpu)
        if error:
            self.refusals.append((task.number, error))

    def _release(self, cycle: int, due: int, busy: list[int]) -> None:
        """Wake the threads that are due in an NC cycle; add those that are still busy."""
        point = suspension_point(self._plan.model, due) if self._plan.model.windows else None
        self.suspends_at = 0 if point is None else point
        for thread in self._threads:
            if cycle % thread.task.task.every == 0:
                number = thread.task.number
                self._counters.due[number] += 1
                if not thread.release(due):
                    self._counters.overflow(number, due)
                    self._counters.lost[number] += 1
                    busy.append(number)
        for task, semaphore in self._semaphores:
            if cycle % task.task.every == 0:
                self._counters.due[task.number] += 1
                if self._processes.post(semaphore):  # the previous post is still there
                    self._counters.overflow(task.number, due)
                else:
                    self._taken[task.number] = self._taken.get(task.number, 0) + 1

    # --- the threads ----------------------------------------------------------------------------

    def step(self, work: Step) -> bool:
        """Make a step of a job during the owner's wait; return whether there is another one."""
        return self._gate.step(work)

    def count_job(self, number: int, woken: int, due: int, busy: int) -> None:
        """Count a finished job of a thread."""
        self._counters.finish(number, self.now() - due)
        self._counters.busy[number] += busy
        self._wakes[number].append(max(0, woken - due))

    def count_suspension(self, number: int) -> None:
        """Count that a thread gives the rest of a cycle to the machine's other programs."""
        self._counters.suspensions[number] += 1

    # --- numbers --------------------------------------------------------------------------------

    def measurement(self) -> Measurement:
        """Return the numbers up to here, in the form of a simulation."""
        end = self._cycle * self._model.cycle
        tasks = list(self._counters.task_numbers([None] * len(self._model.tasks)))
        for number, count in self._taken.items():
            tasks[number] = replace(tasks[number], completed=count)
        run = Simulation(
            self._model,
            self._cycle,
            0,
            end,
            tuple(tasks),
            self._counters.windows_numbers(),
            0,
            0,
            None,
            Record(0, end, (), (), ()),
        )
        wakes = tuple(tuple(latencies) for latencies in self._wakes)
        return Measurement(run, tuple(self._timer), wakes)


class _Placement:
    """Class and processors of the calling thread, to be put back."""

    def __init__(self) -> None:
        assert sys.platform == "linux"
        self._policy = os.sched_getscheduler(0)
        self._parameter = os.sched_getparam(0)
        self._cpus = os.sched_getaffinity(0)

    def restore(self) -> None:
        """Put them back; this thread was allowed to have them."""
        assert sys.platform == "linux"
        os.sched_setscheduler(0, self._policy, self._parameter)
        os.sched_setaffinity(0, self._cpus)


class _Worker:
    """One thread with its jobs."""

    def __init__(self, owner: ScheduleThreads, task: PlannedTask, step: Step) -> None:
        self.task = task
        self._owner = owner
        self._step = step
        self._due = 0
        self._is_busy = False
        self._is_over = False
        self._wake = threading.Semaphore(0)
        self._thread = threading.Thread(target=self._live, name=task.task.name, daemon=True)

    def start(self) -> None:
        """Begin to wait for jobs."""
        self._thread.start()

    def release(self, due: int) -> bool:
        """Begin a job; return False, and lose it, while another one is running."""
        if self._is_busy:
            return False
        self._due, self._is_busy = due, True
        self._wake.release()
        return True

    def end(self) -> None:
        """End after the step that is being made."""
        self._is_over = True
        self._wake.release()

    def join(self) -> None:
        """Wait for the end."""
        if self._thread.is_alive():
            self._thread.join()

    def _live(self) -> None:
        self._owner.assign(self.task)
        while True:
            self._wake.acquire()
            if self._is_over:
                return
            woken, begin = self._owner.now(), time.thread_time_ns()
            while not self._is_over and self._owner.step(self._step):
                self._give_way()
            number = self.task.number
            self._owner.count_job(number, woken, self._due, time.thread_time_ns() - begin)
            self._is_busy = False

    def _give_way(self) -> None:
        """Wait for the next NC interrupt from the point of suspension on."""
        point = self._owner.suspends_at
        if self.task.task.kind is TaskClass.ASYNCHRONOUS and 0 < point <= self._owner.now():
            self._owner.count_suspension(self.task.number)
            while self._owner.suspends_at == point and not self._is_over:
                time.sleep(0.0001)


def _opened(name: str) -> Semaphore:
    from nctakt.schedule.real import processes  # noqa: PLC0415 - it may be missing

    try:
        return processes.open(name)
    except OSError as error:
        reason = error.strerror or str(error)
        raise Failure(diagnostic(SEMAPHORE_NOT_OPENED, name=name, reason=reason)) from error
