# SPDX-License-Identifier: MIT
"""How far a schedule is from overflowing, found by search on the analysis.

In: ``Model``. Out: ``Answers``: the longest execution time of each function alone, the longest
windows_time, the shortest cycle_time with which nothing overflows, all else unchanged. Where the
analysis is a bound, so are the answers, on the safe side. Times in ns.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

from nctakt.schedule.analyse import analyse
from nctakt.schedule.model import NS_PER_US, Execution, Model, Task

#: A cycle_time this many times the present one is searched, not more.
_MOST_CYCLES = 64


@dataclass(frozen=True, slots=True)
class Longest:
    """The longest execution time of one call of a function; ``None``: none is short enough."""

    function: str
    present: int
    longest: int | None


@dataclass(frozen=True, slots=True)
class Answers:
    """``None``: whatever it is, something overflows."""

    functions: tuple[Longest, ...]
    windows_time: int | None
    cycle_time: int | None


def find_answers(model: Model) -> Answers:
    """Search all answers; execution times to the microsecond."""
    names = dict.fromkeys(call.function for task in model.tasks for call in task.calls)
    return Answers(
        tuple(_longest(model, name) for name in names),
        _windows_time(model),
        _cycle_time(model),
    )


def _fits(model: Model) -> bool:
    return not analyse(model).can_overflow


def _greatest(fits: Callable[[int], bool], high: int) -> int | None:
    """The greatest number from 0 to ``high`` that fits, where all smaller ones fit, too."""
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


def with_time(model: Model, function: str, time: int) -> Model:
    """The model with another execution time of all calls of a function."""
    execution = Execution((time,))

    def changed(task: Task) -> Task:
        calls = tuple(
            replace(call, execution=execution) if call.function == function else call
            for call in task.calls
        )
        return replace(task, calls=calls)

    return replace(model, tasks=tuple(changed(task) for task in model.tasks))


def _longest(model: Model, function: str) -> Longest:
    calls = [call for task in model.tasks for call in task.calls if call.function == function]
    present = max(call.execution.longest for call in calls)
    most = max(task.every for task in model.tasks) * model.train.distance // NS_PER_US
    found = _greatest(lambda us: _fits(with_time(model, function, us * NS_PER_US)), most)
    return Longest(function, present, None if found is None else found * NS_PER_US)


def with_windows(model: Model, windows: int) -> Model:
    """The model with another windows_time."""
    return replace(model, windows=windows)


def _windows_time(model: Model) -> int | None:
    slice_ = model.slice
    found = _greatest(
        lambda slices: _fits(with_windows(model, slices * slice_)), model.cycle // slice_
    )
    return None if found is None else found * slice_


def with_cycle(model: Model, cycle: int) -> Model:
    """The model with another cycle_time; each task stays due in every n-th cycle."""
    train = model.train
    if train.period == model.cycle:
        train = replace(train, period=cycle)
    return replace(model, cycle=cycle, train=train)


def _cycle_time(model: Model) -> int | None:
    slice_ = model.slice
    least, most = 1, _MOST_CYCLES * model.cycle // slice_
    found = _greatest(lambda less: _fits(with_cycle(model, (most - less) * slice_)), most - least)
    return None if found is None else (most - found) * slice_
