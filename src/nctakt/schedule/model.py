# SPDX-License-Identifier: MIT
"""The model of a schedule: tasks, interrupts, processors and the chosen rules.

A ``Model`` is a configuration together with a load, all names resolved and all times in integer
nanoseconds. Simulation, analysis and pictures work on it.
"""

from __future__ import annotations

import enum
from typing import Literal

from nctakt.base.dataclass import dataclass
from nctakt.lists.declared.rtconf import InterruptSource

NS_PER_US = 1000

#: Parts of one call of the interpolation, in the order of ``Execution.parts``.
PARTS = ("input", "interpolation", "output")

#: ``cpu`` of a task that the operating system places (after 1000180).
ANY_CPU = 0

OverflowPolicy = Literal["skip", "pend", "queue"]
CallOrder = Literal["block", "interleave"]
Suspension = Literal["ticks", "elapsed"]


class TaskClass(enum.Enum):
    """Kinds of tasks, for the scheduler."""

    #: Holds the interpolation; never suspended.
    REALTIME = "realtime"
    #: Suspended to give Windows its time.
    ASYNCHRONOUS = "asynchronous"
    #: Woken by a semaphore, in another process: never suspended.
    EXTERNAL = "external"


@dataclass(frozen=True, slots=True)
class Execution:
    """Execution times of one call in ns.

    ``values``: used in turn, then from the first again; one value is a constant. ``spread``: the
    two values are the bounds of a uniform distribution. ``parts``: input, interpolation and output
    of which a constant time consists.
    """

    values: tuple[int, ...]
    spread: bool = False
    parts: tuple[int, int, int] | None = None

    @property
    def is_constant(self) -> bool:
        """Return whether each call takes the same time."""
        return len(set(self.values)) == 1

    @property
    def longest(self) -> int:
        """The longest time that a call can take, in ns."""
        return max(self.values)


@dataclass(frozen=True, slots=True)
class Call:
    """One call of a function within an activation; ``number`` counts the function's calls.

    ``index``: that of the function in the thread's list.
    """

    function: str
    number: int
    execution: Execution
    trace_bit: int = 0
    index: int = 0


@dataclass(frozen=True, slots=True)
class Task:
    """A thread of the list, or an external one.

    ``key`` is its name in the list (``thread[0]``). ``every``: due in each such NC cycle.
    ``urgency``: the greater, the earlier, whatever the operating system's direction. ``cpu``
    counts from 1, or is ``ANY_CPU``.
    """

    key: str
    name: str
    kind: TaskClass
    every: int
    urgency: int
    cpu: int
    calls: tuple[Call, ...]
    error_on_overflow: bool = False

    @property
    def longest(self) -> int:
        """The longest execution time of one activation, in ns."""
        return sum(call.execution.longest for call in self.calls)


@dataclass(frozen=True, slots=True)
class Train:
    """The interrupts that start NC cycles, in ns: the k-th comes at phase + k·(period + drift),
    then up to ``jitter`` earlier or later. Without ``is_phase_known`` the phase is an assumption.
    """

    period: int
    phase: int = 0
    drift: int = 0
    jitter: int = 0
    is_phase_known: bool = True

    @property
    def distance(self) -> int:
        """The mean distance of two interrupts, in ns."""
        return self.period + self.drift


@dataclass(frozen=True, slots=True)
class Overheads:
    """The costs of scheduling itself, in ns.

    ``switch`` is added to a job each time it gets a processor that ran something else before,
    ``activation`` to each job that an interrupt releases.
    """

    switch: int = 0
    activation: int = 0


@dataclass(frozen=True, slots=True)
class Rules:
    """The choices where the manual is silent; every report prints them.

    ``overflow``: treatment of an activation that finds its thread busy (lost; one remembered; all
    remembered). ``calls``: the functions of a thread one after another, or in turn. ``suspension``:
    by counted timer interrupts, or by the time since the NC interrupt.
    """

    overflow: OverflowPolicy = "skip"
    calls: CallOrder = "block"
    suspension: Suspension = "ticks"


STANDARD_RULES = Rules()
NO_OVERHEADS = Overheads()


@dataclass(frozen=True, slots=True)
class Model:
    """A configuration and its load, ready to be simulated or analysed; times in ns.

    ``tasks``: internal ones first, each group in the order of its indices. ``cpus``: the processors
    that can be used. ``windows_cpus`` run Windows when no task needs them. ``schedule``: the order
    of the parts of the interpolation (P-RTCF-00018).
    """

    source: InterruptSource
    cycle: int
    slice: int
    windows: int
    train: Train
    tasks: tuple[Task, ...]
    cpus: tuple[int, ...]
    windows_cpus: tuple[int, ...]
    overheads: Overheads = NO_OVERHEADS
    rules: Rules = STANDARD_RULES
    seed: int = 0
    schedule: str = "STANDARD"

    @property
    def is_synchronous(self) -> bool:
        """Return whether NC interrupts always fall on timer interrupts."""
        if self.source is InterruptSource.TIMER:
            return True
        train = self.train
        return not (train.jitter or train.phase % self.slice or train.distance % self.slice)


def suspension_point(model: Model, begin: int) -> int | None:
    """Return when suspendable tasks of the NC cycle from ``begin`` stop, in ns; ``None``: never.

    The tick at ``begin`` itself belongs to the cycle before, so the first one lies after it. The
    result may lie after the next NC interrupt: then nothing is suspended in this cycle.
    """
    if not model.windows:
        return None
    before = model.cycle - model.windows
    if before <= 0:
        return begin
    origin = model.train.phase if model.source is InterruptSource.TIMER else 0
    if model.rules.suspension == "elapsed":
        return origin - (origin - begin - before) // model.slice * model.slice
    first = begin + model.slice - (begin - origin) % model.slice
    return first + before - model.slice
