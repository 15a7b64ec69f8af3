# SPDX-License-Identifier: MIT
"""Runs a plan: starts the scheduler's process, waits for it, and cleans up.

In: ``Plan``. Out: ``RunLog``. Raises ``Failure`` if the system refuses something, or if a process
of the run was killed from outside.
"""

from __future__ import annotations

import ctypes
import os
import signal
import time
from types import FrameType
from typing import Any

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Text
from nctakt.base.failure import Failure
from nctakt.base.interrupts import handling
from nctakt.messages import diagnostic
from nctakt.messages.scheduling.linux_run import (
    SCHEDULE_RUN_ENDED,
    SEMAPHORE_NOT_CREATED,
    SEMAPHORE_NOT_OPENED,
)
from nctakt.messages.scheduling.schedule_results import CPU_NOT_ASSIGNABLE
from nctakt.schedule.real import area as layout
from nctakt.schedule.real.area import AreaPart, Entries, SharedArea, TaskPart
from nctakt.schedule.real.names import SemaphoreNames
from nctakt.schedule.real.plan import Plan

#: Interval of the checks whether the scheduler has ended, in seconds.
_LOOK = 0.02
#: Time in seconds after its planned end at which the scheduler is killed.
_PATIENCE = 15.0


@dataclass(frozen=True, slots=True)
class RunLog:
    """The log of the processes of a run.

    ``due``: for each task of the model the due times of its jobs, in ns. ``posts``: the number of
    posts of each task's semaphore; ``wakeups``: of an external thread, the number of posts that a
    process has received. ``was_stopped``: by Ctrl-C or SIGTERM; ``is_cut``: the log was full.
    ``cpu_errors``: task and errno of each refused processor. ``drained``: posts from before the
    start, of the semaphore that triggers the NC interrupts. ``end``: of the last NC cycle, in ns.
    """

    plan: Plan
    entries: Entries
    due: tuple[list[int], ...]
    wakeups: tuple[int | None, ...]
    posts: tuple[int, ...]
    was_stopped: bool
    is_cut: bool
    cpu_errors: tuple[tuple[int, int], ...]
    drained: int
    end: int


def run_plan(plan: Plan, *, for_all_users: bool = False) -> RunLog:
    """Run a plan to its end, or until a signal ends it, and return its log.

    ``for_all_users``: processes of other users may wait on its semaphores.
    """
    from nctakt.schedule.real import processes  # noqa: PLC0415 - it may be missing

    sizes = (ctypes.sizeof(AreaPart), ctypes.sizeof(TaskPart), layout.ENTRY.itemsize)
    assert sizes == (processes.AREA_SIZE, processes.TASK_SIZE, processes.ENTRY_SIZE)
    area = SharedArea(plan)
    semaphores = [task.semaphore for task in plan.tasks if task.semaphore]
    names = SemaphoreNames(semaphores, for_all_users=for_all_users)
    try:
        area.head.record = os.fsencode(names.record)
        _wait(processes.spawn(area.memory), plan)
    finally:
        # A killed scheduler has removed nothing.
        if area.head.is_clean:
            names.release()
        else:
            names.remove()
    return _log(plan, area)


def _wait(pid: int, plan: Plan) -> None:
    """Wait for the scheduler; signals to this process end the run, too."""

    def pass_on(number: int, frame: FrameType | None) -> None:
        os.kill(pid, signal.SIGTERM)

    end = time.monotonic() + plan.moments[-1] / 1e9 + _PATIENCE
    with handling(pass_on):
        while os.waitpid(pid, os.WNOHANG) == (0, 0):
            if time.monotonic() > end:
                os.kill(pid, signal.SIGKILL)
            time.sleep(_LOOK)


def _log(plan: Plan, area: SharedArea) -> RunLog:
    head = area.head
    if head.status not in (layout.DONE, layout.STOPPED, layout.LOG_FULL):
        raise Failure(_failure(plan, head))
    due: list[list[int]] = [[] for _ in plan.tasks]
    wakeups: list[int | None] = [None] * len(plan.tasks)
    posts = [0] * len(plan.tasks)
    errors: list[tuple[int, int]] = []
    for task, part in zip(plan.tasks, area.tasks, strict=True):
        due[task.number] = area.due(part)
        if not task.has_process:
            wakeups[task.number] = part.jobs - part.waiting_at_end
        posts[task.number] = part.jobs
        if part.cpu_error:
            errors.append((task.number, part.cpu_error))
    return RunLog(
        plan,
        area.entries(),
        tuple(due),
        tuple(wakeups),
        tuple(posts),
        head.status == layout.STOPPED,
        head.status == layout.LOG_FULL,
        tuple(errors),
        head.drained,
        head.end,
    )


def placement_refusals(log: RunLog) -> list[Diagnostic]:
    """Return a diagnostic (1000181) for each thread whose processor the system refused."""
    names = {task.number: task.task for task in log.plan.tasks}
    refusals: list[Diagnostic] = []
    for number, error in log.cpu_errors:
        reason = os.strerror(error)
        task = names[number]
        refusals.append(
            diagnostic(
                CPU_NOT_ASSIGNABLE,
                thread=task.name,
                cpu=task.cpu,
                reason=reason,
            )
        )
    return refusals


def _failure(plan: Plan, head: Any) -> Diagnostic:
    """Return the reason why a run could not begin or did not reach its end."""
    number = head.status_number
    names = {task.number: task.task.name for task in plan.tasks}
    if head.status == layout.NO_SEMAPHORE and head.status_task < 0:
        return diagnostic(SEMAPHORE_NOT_OPENED, name=plan.source or "", reason=os.strerror(number))
    name = names.get(head.status_task, "")
    if head.status == layout.NO_SEMAPHORE:
        return diagnostic(SEMAPHORE_NOT_CREATED, name=name, reason=os.strerror(number))
    if head.status == layout.NO_PROCESS:
        reason: str | Text = os.strerror(number)
    elif head.status == layout.PROCESS_ENDED:
        ended = signal.strsignal(number) if number else "exit"
        reason = f"{name}: {ended}"
    else:
        reason = Text("the scheduler was killed", "der Scheduler wurde beendet")
    return diagnostic(SCHEDULE_RUN_ENDED, reason=reason)
