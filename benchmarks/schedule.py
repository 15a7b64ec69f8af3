# SPDX-License-Identifier: MIT
"""``python -m benchmarks.schedule``: how fast schedules are simulated.

The task set is the manual's first example list under load. Measured in one run: jobs per second
with every cycle simulated, with random execution times, with repetitions counted; one hour of it;
and SimSo 0.8.5 on the same task set, where it is installed (``pip install simso``; it needs Python
3.11). SimSo has no suspension: there a more urgent task takes the time of Windows.
"""

from __future__ import annotations

import importlib.util
import platform
import sys
import time
import warnings
from collections.abc import Callable
from dataclasses import replace
from typing import Any

from nctakt.lists.declared.rtconf import InterruptSource
from nctakt.schedule.model import Call, Execution, Model, Task, TaskClass, Train
from nctakt.schedule.simulation.results import Simulation
from nctakt.schedule.simulation.simulate import simulate

US = 1000
REPEATS = 3
HOUR_CYCLES = 3600 * 500
#: This many are simulated one by one, to compare the numbers.
CHECKED_CYCLES = HOUR_CYCLES // 10
#: Name, kind, due in each n-th cycle, priority, execution time in µs.
TASKS = (
    ("GEO", TaskClass.REALTIME, 1, 115, 400),
    ("BACKGROUND_", TaskClass.ASYNCHRONOUS, 1, 105, 700),
    ("MMI_DRIVER", TaskClass.ASYNCHRONOUS, 3, 95, 300),
    ("COM", TaskClass.ASYNCHRONOUS, 2, 90, 250),
    ("external_sps", TaskClass.EXTERNAL, 1, 110, 200),
)
CYCLE_US, SLICE_US, WINDOWS_US = 2000, 500, 500


def example() -> Model:
    """The example list with its load."""
    tasks = tuple(
        Task(name, name, kind, every, priority, 1, (Call(name, 0, Execution((us * US,))),))
        for name, kind, every, priority, us in TASKS
    )
    return Model(
        InterruptSource.TIMER,
        CYCLE_US * US,
        SLICE_US * US,
        WINDOWS_US * US,
        Train(CYCLE_US * US),
        tasks,
        (1,),
        (1,),
    )


def with_chance(model: Model) -> Model:
    """The same with execution times spread by a tenth: nothing repeats."""

    def spread(task: Task) -> Task:
        mean = task.calls[0].execution.longest
        execution = Execution((mean * 9 // 10, mean * 11 // 10), spread=True)
        return replace(task, calls=(replace(task.calls[0], execution=execution),))

    return replace(model, tasks=tuple(spread(task) for task in model.tasks))


def best(run: Callable[[], Simulation]) -> tuple[float, Simulation]:
    """The shortest of several runs in seconds."""
    seconds = float("inf")
    for _ in range(REPEATS):
        begin = time.perf_counter()
        result = run()
        seconds = min(seconds, time.perf_counter() - begin)
    return seconds, result


def simso_jobs_per_second(cycles: int) -> float | None:
    """Jobs per second of SimSo, those of Windows' stand-in left out; ``None``: not installed."""
    if importlib.util.find_spec("simso") is None or sys.version_info >= (3, 12):
        return None
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        from simso.configuration import Configuration  # noqa: PLC0415 - it may be missing
        from simso.core import Model as SimsoModel  # noqa: PLC0415

    seconds, jobs = float("inf"), 0
    for _ in range(REPEATS):
        configuration: Any = Configuration()
        configuration.cycles_per_ms = 1_000_000
        configuration.duration = cycles * CYCLE_US * US
        rows = [(name, every, priority, us, 0.0) for name, _, every, priority, us in TASKS]
        rows.append(("WINDOWS", 1, 107, WINDOWS_US, (CYCLE_US - WINDOWS_US) / US))
        for number, (name, every, priority, us, date) in enumerate(rows):
            configuration.add_task(
                name=name,
                identifier=number,
                period=every * CYCLE_US / US,
                activation_date=date,
                wcet=us / US,
                deadline=every * CYCLE_US / US,
                data={"priority": priority},
                abort_on_miss=False,
            )
        configuration.add_processor(name="CPU", identifier=1)
        configuration.scheduler_info.clas = "simso.schedulers.FP"
        configuration.check_all()
        model: Any = SimsoModel(configuration)
        begin = time.perf_counter()
        model.run_model()
        seconds = min(seconds, time.perf_counter() - begin)
        jobs = sum(
            len(result.jobs)
            for task, result in model.results.tasks.items()
            if task.name != "WINDOWS"
        )
    return jobs / seconds


def main() -> None:
    """Measure and print."""
    print(f"{platform.python_implementation()} {platform.python_version()}, {platform.machine()}")
    model = example()
    seconds, run = best(lambda: simulate(model, 50_000, record=0, repeat=False))
    each = run.jobs / seconds
    print(f"each cycle simulated          {each:14,.0f} jobs/s")
    chance = with_chance(model)
    seconds, run = best(lambda: simulate(chance, 20_000, record=0))
    print(f"random execution times        {run.jobs / seconds:14,.0f} jobs/s")
    begin = time.perf_counter()
    simulate(chance, HOUR_CYCLES, record=0)
    print(f"one hour, random times        {time.perf_counter() - begin:14.1f} s")
    seconds, run = best(lambda: simulate(model, HOUR_CYCLES))
    print(f"repetitions counted           {run.jobs / seconds:14,.0f} jobs/s")
    print(f"one hour, repetitions counted {seconds:14.4f} s")
    begin = time.perf_counter()
    full = simulate(model, CHECKED_CYCLES, record=0, repeat=False)
    print(f"six minutes, each cycle       {time.perf_counter() - begin:14.1f} s")
    counted = simulate(model, CHECKED_CYCLES, record=0)
    assert (full.tasks, full.windows) == (counted.tasks, counted.windows)
    other = simso_jobs_per_second(2000)
    if other is None:
        print("SimSo 0.8.5: not installed, or not for this Python; no comparison")
        return
    print(f"SimSo                         {other:14,.0f} jobs/s")
    print(f"each cycle simulated: {each / other:.0f} × SimSo")


if __name__ == "__main__":
    main()
