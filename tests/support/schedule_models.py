# SPDX-License-Identifier: MIT
"""Random small models: an NC cycle of some ten nanoseconds, so that each step can be looked at."""

from __future__ import annotations

from hypothesis import strategies as st

from nctakt.lists.declared.rtconf import InterruptSource
from nctakt.schedule.model import Call, Execution, Model, Rules, Task, TaskClass, Train

OVERFLOWS = ("skip", "pend", "queue")


def call(time: int, name: str = "f") -> Call:
    """A call that always takes the same time."""
    return Call(name, 0, Execution((time,)))


@st.composite
def tasks(
    draw: st.DrawFn, cpus: int, longest: int, *, ties: bool, minimum: int = 1
) -> tuple[Task, ...]:
    """A realtime task, suspendable ones, and maybe external ones."""
    count = draw(st.integers(1, 5))
    kinds = [TaskClass.REALTIME] + [
        draw(st.sampled_from([TaskClass.ASYNCHRONOUS, TaskClass.ASYNCHRONOUS, TaskClass.EXTERNAL]))
        for _ in range(count - 1)
    ]
    kinds.sort(key=lambda kind: kind is TaskClass.EXTERNAL)
    urgencies = (
        draw(st.lists(st.integers(0, 3), min_size=count, max_size=count))
        if ties
        else draw(st.permutations(range(count)))
    )
    return tuple(
        Task(
            f"thread[{i}]",
            f"T{i}",
            kind,
            draw(st.sampled_from([1, 1, 2, 3, 4])),
            urgencies[i],
            draw(st.integers(1, cpus)),
            (call(draw(st.integers(minimum, longest)), f"f{i}"),),
        )
        for i, kind in enumerate(kinds)
    )


@st.composite
def models(
    draw: st.DrawFn, *, ties: bool = True, synchronous: bool = False, load: int = 2
) -> Model:
    """A model; ``load``: the longest execution time is a cycle divided by it."""
    slice_ = draw(st.sampled_from([4, 5]))
    slices = draw(st.integers(2, 5))
    cycle = slice_ * slices
    windows = slice_ * draw(st.integers(0, slices))
    cpus = draw(st.integers(1, 2))
    source = InterruptSource.TIMER
    train = Train(cycle, draw(st.integers(0, 3)))
    if not synchronous and draw(st.booleans()):
        source = InterruptSource.HARDWARE
        train = Train(draw(st.integers(cycle // 2 + 1, 2 * cycle)), draw(st.integers(0, 20)))
    overflow = draw(st.sampled_from(OVERFLOWS))
    suspension = draw(st.sampled_from(["ticks", "elapsed"]))
    return Model(
        source,
        cycle,
        slice_,
        windows,
        train,
        draw(tasks(cpus, max(1, cycle // load), ties=ties)),
        tuple(range(1, cpus + 1)),
        draw(st.sampled_from([(1,), tuple(range(1, cpus + 1))])),
        rules=Rules(overflow=overflow, suspension=suspension),
    )
