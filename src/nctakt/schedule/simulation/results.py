# SPDX-License-Identifier: MIT
"""Results of a simulation: numbers per task and of Windows, and a record for pictures.

All times in integer nanoseconds. Numbers cover whole NC cycles, from the first interrupt on.
"""

from __future__ import annotations

import enum

from nctakt.base.dataclass import dataclass
from nctakt.schedule.model import Model
from nctakt.schedule.simulation.responses import ResponseCounts


@dataclass(frozen=True, slots=True)
class TaskNumbers:
    """One task over a simulation; responses count from the moment when the job was due.

    ``due``: activations. ``completed``: jobs that ended. ``lost``: activations that never became a
    job. ``suspensions``: cycles in which it was stopped for Windows with work left. ``response_*``
    are ``None`` without a completed job; ``unfinished_since``: when the job that is still busy at
    the end was due. ``responses``: number of jobs by response.
    """

    due: int
    completed: int
    overflows: int
    lost: int
    suspensions: int
    busy: int
    response_min: int | None
    response_sum: int
    response_max: int | None
    unfinished_since: int | None
    first_overflow: int | None
    responses: ResponseCounts


@dataclass(frozen=True, slots=True)
class Snapshot:
    """The sums of a simulation at one moment."""

    numbers: list[list[int]]
    responses: list[ResponseCounts]


@dataclass(frozen=True, slots=True)
class WindowsNumbers:
    """Windows on one processor (``cpu`` 0: their sum) over a simulation.

    ``violated``: cycles in which it got less than guaranteed; ``culprits``: in how many of them
    each task ran within its time, in the order of the tasks; ``late``: in how many the
    suspension came too late.
    """

    cpu: int
    total: int
    minimum: int
    maximum: int
    violated: int
    culprits: tuple[int, ...]
    late: int


@dataclass(frozen=True, slots=True)
class Segment:
    """A time from ``begin`` to ``end`` in which a task has a processor; ``job`` counts its jobs.

    ``overhead``: how much of it scheduling added when the task got the processor.
    """

    cpu: int
    begin: int
    end: int
    task: int
    job: int
    overhead: int = 0


class EventKind(enum.Enum):
    """Kinds of event."""

    INTERRUPT = "NC"
    RELEASE = "RELEASE"
    OVERFLOW = "OVERFLOW"
    SUSPEND = "SUSPEND"
    RESUME = "RESUME"
    END = "END"


@dataclass(frozen=True, slots=True)
class Event:
    """``value``: the cycle of an interrupt, the work left at overflow and suspension, the
    response at an end, the number of the job at a release."""

    time: int
    kind: EventKind
    task: int
    value: int


@dataclass(frozen=True, slots=True)
class Job:
    """One activation: its calls' execution times in their order, in ns.

    ``done``: how much of its work, that of the activation included, lies before the record.
    """

    task: int
    number: int
    due: int
    times: tuple[int, ...]
    done: int = 0


@dataclass(frozen=True, slots=True)
class Record:
    """The record of some cycles, from ``begin`` to ``end``."""

    begin: int
    end: int
    segments: tuple[Segment, ...]
    events: tuple[Event, ...]
    jobs: tuple[Job, ...]


@dataclass(frozen=True, slots=True, repr=False)
class Simulation:
    """A simulated schedule.

    ``repeats_after``: the schedule was seen to repeat exactly with that many cycles, from the cycle
    ``repeats_from`` on, and the rest was counted, not simulated; ``None``: each cycle was
    simulated. ``missed_suspensions``: cycles that were over before their point of suspension.
    """

    model: Model
    cycles: int
    begin: int
    end: int
    tasks: tuple[TaskNumbers, ...]
    windows: tuple[WindowsNumbers, ...]
    missed_suspensions: int
    suspended_cycles: int
    repeats_after: int | None
    record: Record
    repeats_from: int | None = None

    @property
    def duration(self) -> int:
        """The time from the first interrupt to the end, in ns."""
        return self.end - self.begin

    @property
    def jobs(self) -> int:
        """The number of completed jobs of all tasks."""
        return sum(task.completed for task in self.tasks)

    def __repr__(self) -> str:
        overflows = sum(task.overflows for task in self.tasks)
        return f"<Simulation of {self.cycles} NC cycles: {self.jobs} jobs, {overflows} overflows>"
