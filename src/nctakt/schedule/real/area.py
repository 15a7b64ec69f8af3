# SPDX-License-Identifier: MIT
"""The memory that Python, the scheduler and the workers share, as ``shared_area.h`` has it.

In: ``Plan``. Out: ``SharedArea``: anonymous memory, which cannot be left over. Times are ns since
its ``origin``, a time of CLOCK_MONOTONIC that the scheduler chooses.
"""

from __future__ import annotations

import ctypes
import mmap
from typing import Any

import numpy as np
import numpy.typing as npt

from nctakt.schedule.model import TaskClass
from nctakt.schedule.real.plan import Plan, PlannedTask

NAME_SIZE = 256
_TITLE_SIZE = 16
_ALIGN = 64
_NUMBER = ctypes.c_int64

_KINDS = {TaskClass.REALTIME: 0, TaskClass.ASYNCHRONOUS: 1, TaskClass.EXTERNAL: 2}
_POLICIES = {"skip": 0, "pend": 1, "queue": 2}

#: Entries of a log (``enum entry_kind``).
INTERRUPT, POINT, RELEASE, OVERFLOW, SUSPEND, RESUME, WAKE, SEGMENT, END = range(9)
#: The end of a run (``enum status``).
RUNNING, DONE, STOPPED, LOG_FULL, NO_SEMAPHORE, NO_PROCESS, PROCESS_ENDED = range(7)

ENTRY = np.dtype(
    [
        ("time", "i8"),
        ("value", "i8"),
        ("kind", "i4"),
        ("task", "i4"),
        ("call", "i4"),
        ("cpu", "i4"),
    ]
)
Entries = npt.NDArray[np.void]

#: Entries of a job besides one for each call, and of the scheduler for one activation.
_ENTRIES_PER_JOB = 12
#: Maximum number of entries of a log.
MAX_ENTRIES = 4_000_000


class _Log(ctypes.Structure):
    _fields_ = (("entries", _NUMBER), ("capacity", _NUMBER), ("count", _NUMBER))


class TaskPart(ctypes.Structure):
    """``struct task``."""

    _fields_ = (
        ("name", ctypes.c_char * _TITLE_SIZE),
        ("semaphore", ctypes.c_char * NAME_SIZE),
        ("number", _NUMBER),
        ("kind", _NUMBER),
        ("has_process", _NUMBER),
        ("every", _NUMBER),
        ("cpu", _NUMBER),
        ("priority", _NUMBER),
        ("calls", _NUMBER),
        ("rows", _NUMBER),
        ("times", _NUMBER),
        ("due", _NUMBER),
        ("max_jobs", _NUMBER),
        ("log", _Log),
        ("pid", _NUMBER),
        ("jobs", _NUMBER),
        ("is_suspended", _NUMBER),
        ("wakes", _NUMBER),
        ("cpu_error", _NUMBER),
        ("waiting_at_end", _NUMBER),
        ("busy", _NUMBER),
        ("left", _NUMBER),
        ("cpu_now", _NUMBER),
        ("wake", _NUMBER * 8),
        ("semaphore_address", ctypes.c_void_p),
    )


class AreaPart(ctypes.Structure):
    """``struct area``."""

    _fields_ = (
        ("task_count", _NUMBER),
        ("tasks", _NUMBER),
        ("cycles", _NUMBER),
        ("moments", _NUMBER),
        ("limit", _NUMBER),
        ("cycle", _NUMBER),
        ("slice", _NUMBER),
        ("windows", _NUMBER),
        ("elapsed", _NUMBER),
        ("phase", _NUMBER),
        ("windows_cpus", _NUMBER),
        ("policy", _NUMBER),
        ("wants_fifo", _NUMBER),
        ("from_semaphore", _NUMBER),
        ("source", ctypes.c_char * NAME_SIZE),
        ("record", ctypes.c_char * NAME_SIZE),
        ("log", _Log),
        ("origin", _NUMBER),
        ("fifo_error", _NUMBER),
        ("status", _NUMBER),
        ("status_task", _NUMBER),
        ("status_number", _NUMBER),
        ("is_clean", _NUMBER),
        ("drained", _NUMBER),
        ("end", _NUMBER),
        ("ready", _NUMBER),
        ("stop", _NUMBER),
        ("is_full", _NUMBER),
    )


class SharedArea:
    """The memory of one run."""

    def __init__(self, plan: Plan) -> None:
        self._size = 0
        tasks = plan.tasks
        head = self._take(ctypes.sizeof(AreaPart))
        assert head == 0
        at_tasks = self._take(ctypes.sizeof(TaskPart) * len(tasks))
        at_moments = self._take(8 * len(plan.moments))
        activations = sum(task.activations for task in tasks)
        capacity = _capacity(4 * len(plan.moments) + 4 * activations)
        at_log = self._take(ENTRY.itemsize * capacity)
        offsets = [self._take_task(task) for task in tasks]
        self.memory = mmap.mmap(-1, self._size)
        self.head: Any = AreaPart.from_buffer(self.memory)
        self.tasks: Any = (TaskPart * len(tasks)).from_buffer(self.memory, at_tasks)
        self.head.task_count, self.head.tasks = len(tasks), at_tasks
        self.head.moments = at_moments
        self.head.log.entries, self.head.log.capacity = at_log, capacity
        self._numbers(at_moments, len(plan.moments))[:] = plan.moments
        self._describe(plan)
        for part, task, task_offsets in zip(self.tasks, tasks, offsets, strict=True):
            self._describe_task(part, task, *task_offsets)

    def _take(self, size: int) -> int:
        """Reserve ``size`` bytes and return their offset."""
        begin = self._size
        self._size += -(-size // _ALIGN) * _ALIGN
        return begin

    def _take_task(self, task: PlannedTask) -> tuple[int, int, int, int]:
        """Reserve a task's execution times, due times and log; return offsets and log capacity."""
        capacity = _capacity(task.activations * (_ENTRIES_PER_JOB + task.times.shape[1]))
        return (
            self._take(8 * task.times.size),
            self._take(8 * task.activations),
            self._take(ENTRY.itemsize * capacity),
            capacity,
        )

    def _numbers(self, offset: int, count: int) -> npt.NDArray[np.int64]:
        return np.frombuffer(self.memory, np.int64, count, offset)

    def _describe(self, plan: Plan) -> None:
        head, model = self.head, plan.model
        head.cycles = plan.cycles
        head.limit = plan.moments[-1]
        head.cycle, head.slice, head.windows = model.cycle, model.slice, model.windows
        head.elapsed = model.rules.suspension == "elapsed"
        head.phase = plan.phase
        head.windows_cpus = sum(1 << (cpu - 1) for cpu in model.windows_cpus)
        head.policy = _POLICIES[model.rules.overflow]
        head.wants_fifo = plan.is_fifo
        head.from_semaphore = plan.source is not None
        head.source = (plan.source or "").encode()

    def _describe_task(
        self, part: Any, task: PlannedTask, times: int, due: int, log: int, capacity: int
    ) -> None:
        part.name = task.task.name.encode()[: _TITLE_SIZE - 1]
        part.semaphore = task.semaphore.encode()
        part.number = task.number
        part.kind = _KINDS[task.task.kind]
        part.has_process = task.has_process
        part.every, part.cpu, part.priority = task.task.every, task.task.cpu, task.priority
        part.rows, part.calls = task.times.shape
        part.times, part.due, part.max_jobs = times, due, task.activations
        part.log.entries, part.log.capacity = log, capacity
        self._numbers(times, task.times.size)[:] = task.times.ravel()

    def entries(self) -> Entries:
        """Return all entries of all logs, in the order of time."""
        logs = [self.head.log, *(task.log for task in self.tasks)]
        parts = [np.frombuffer(self.memory, ENTRY, log.count, log.entries) for log in logs]
        entries = np.concatenate(parts)
        return entries[np.argsort(entries["time"], kind="stable")]

    def due(self, part: Any) -> list[int]:
        """Return the due times of a task's jobs, in ns."""
        count = part.jobs if part.has_process else 0
        moments: list[int] = self._numbers(part.due, count).tolist()
        return moments


def _capacity(entries: int) -> int:
    return min(entries + 1000, MAX_ENTRIES)
