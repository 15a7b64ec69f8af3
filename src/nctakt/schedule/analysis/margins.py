# SPDX-License-Identifier: MIT
"""How far a schedule is from overflowing, or how much less would do, by search on the analysis.

In: ``Model``. Out: ``Margins``. A function's limit is that of its own processors: overflows on
another one do not count. Where the analysis is a bound, so are the margins, on the safe side. Times
in ns.
"""

from __future__ import annotations

from collections.abc import Callable, Container
from dataclasses import replace
from functools import partial

from nctakt.base.dataclass import dataclass
from nctakt.schedule.analysis.analyse import analyse
from nctakt.schedule.model import ANY_CPU, NS_PER_US, Execution, Model, Task

#: A cycle_time this many times the present one is searched, not more.
_MAX_CYCLES = 64
#: Factors are searched in steps of a thousandth.
_STEPS = 1000
#: Number of values of windows_time that are tried first.
_MAX_TRIALS = 200


@dataclass(frozen=True, slots=True)
class FunctionLimit:
    """The longest execution time of one call of a function, all else unchanged.

    ``limit`` ``None``: even without it something overflows on its processors.
    """

    function: str
    present: int
    limit: int | None

    @property
    def change(self) -> int | None:
        """Return the difference from the present time in ns; negative where it must be shorter."""
        return None if self.limit is None else self.limit - self.present


@dataclass(frozen=True, slots=True)
class CpuFactor:
    """A processor on which something overflows; with all times of execution there multiplied by
    ``factor`` nothing does. ``None``: not even without any work."""

    cpu: int
    factor: float | None


@dataclass(frozen=True, slots=True)
class Margins:
    """``None``: something overflows at any value."""

    functions: tuple[FunctionLimit, ...]
    factors: tuple[CpuFactor, ...]
    windows_time: int | None
    cycle_time: int | None


def find_margins(model: Model) -> Margins:
    """Return all margins, found by search; execution times to the microsecond."""
    names = dict.fromkeys(call.function for task in model.tasks for call in task.calls)
    return Margins(
        tuple(_function_limit(model, name) for name in names),
        tuple(_factors(model)),
        _windows_time(model),
        _cycle_time(model),
    )


def _fits(model: Model, cpus: Container[int] | None = None) -> bool:
    """Return whether nothing overflows, on some processors or on all."""
    analysis = analyse(model)
    return not any(
        bound.can_overflow
        for task, bound in zip(model.tasks, analysis.tasks, strict=True)
        if cpus is None or task.cpu in cpus
    )


def _greatest(fits: Callable[[int], bool], high: int) -> int | None:
    """Return the greatest number from 0 to ``high`` that fits, where all smaller ones fit, too."""
    if not fits(0):
        return None
    low = 0
    while low < high:
        middle = (low + high + 1) // 2
        if fits(middle):
            low = middle
        else:
            high = middle - 1
    return low


def _with_executions(model: Model, change: Callable[[Task, str, Execution], Execution]) -> Model:
    """Return the model with other execution times."""
    tasks = tuple(
        replace(
            task,
            calls=tuple(
                replace(call, execution=change(task, call.function, call.execution))
                for call in task.calls
            ),
        )
        for task in model.tasks
    )
    return replace(model, tasks=tasks)


def longest_time(model: Model, function: str) -> int:
    """Return the longest execution time of a function, in ns."""
    calls = [call for task in model.tasks for call in task.calls if call.function == function]
    return max(call.execution.longest for call in calls)


def with_time(model: Model, function: str, time: int) -> Model:
    """Return the model in which the longest execution time of a function is ``time``.

    Several times all become longer or shorter by the same amount, none below 0.
    """
    change = time - longest_time(model, function)

    def changed(_: Task, name: str, execution: Execution) -> Execution:
        if name != function:
            return execution
        values = tuple(max(0, value + change) for value in execution.values)
        return replace(execution, values=values, parts=None)

    return _with_executions(model, changed)


def _function_limit(model: Model, function: str) -> FunctionLimit:
    present = longest_time(model, function)
    cpus = {
        task.cpu for task in model.tasks if any(call.function == function for call in task.calls)
    }
    is_free = ANY_CPU in {task.cpu for task in model.tasks}
    longest = max(task.every for task in model.tasks) * model.train.distance // NS_PER_US
    limit = _greatest(
        lambda us: _fits(with_time(model, function, us * NS_PER_US), None if is_free else cpus),
        longest,
    )
    return FunctionLimit(function, present, None if limit is None else limit * NS_PER_US)


def with_factor(model: Model, cpu: int, factor: float) -> Model:
    """Return the model with shorter execution times on a processor."""

    def changed(task: Task, _: str, execution: Execution) -> Execution:
        if task.cpu not in (cpu, ANY_CPU):
            return execution
        values = tuple(int(value * factor) for value in execution.values)
        return replace(execution, values=values, parts=None)

    return _with_executions(model, changed)


def _factors(model: Model) -> list[CpuFactor]:
    """Return a factor for each processor on which something overflows."""

    def fits(cpu: int, steps: int) -> bool:
        return _fits(with_factor(model, cpu, steps / _STEPS), (cpu, ANY_CPU))

    factors: list[CpuFactor] = []
    for cpu in model.cpus:
        if not fits(cpu, _STEPS):
            steps = _greatest(partial(fits, cpu), _STEPS - 1)
            factors.append(CpuFactor(cpu, None if steps is None else steps / _STEPS))
    return factors


def with_windows(model: Model, windows: int) -> Model:
    """Return the model with another windows_time."""
    return replace(model, windows=windows)


def _windows_time(model: Model) -> int | None:
    """Return the largest windows_time.

    More of it leaves suspendable threads less, and less urgent external ones more: so the search
    goes down from above, in steps of several slices if there are many, and bisects only within a
    step.
    """
    slices = model.cycle // model.slice
    step = -(-slices // _MAX_TRIALS)

    def fits(first: int, more: int) -> bool:
        return _fits(with_windows(model, (first + more) * model.slice))

    for first in (*range(slices, 0, -step), 0):
        more = _greatest(partial(fits, first), min(step - 1, slices - first))
        if more is not None:
            windows: int = (first + more) * model.slice
            return windows
    return None


def with_cycle(model: Model, cycle: int) -> Model:
    """Return the model with another cycle_time; each task stays due in every n-th cycle."""
    train = model.train
    if train.period == model.cycle:
        train = replace(train, period=cycle)
    return replace(model, cycle=cycle, train=train)


def _cycle_time(model: Model) -> int | None:
    minimum, maximum = 1, _MAX_CYCLES * model.cycle // model.slice
    less = _greatest(
        lambda less: _fits(with_cycle(model, (maximum - less) * model.slice)), maximum - minimum
    )
    return None if less is None else (maximum - less) * model.slice
