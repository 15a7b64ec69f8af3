# SPDX-License-Identifier: MIT
"""The simulation against SimSo, an independent scheduler, where that is installed.

SimSo has no suspension: a task WINDOWS of the length windows_time, released at the point of
suspension, more urgent than all that can be suspended and less than all that cannot, does the same.
SimSo queues activations of busy tasks, so the rule here is 'queue'.
"""

from __future__ import annotations

import importlib.util
import random
import sys
import warnings
from typing import Any

import pytest
from support.random_seeds import each_seed

from nctakt.lists.declared.rtconf import InterruptSource
from nctakt.schedule.model import Call, Execution, Model, Rules, Task, TaskClass, Train
from nctakt.schedule.simulation.results import EventKind
from nctakt.schedule.simulation.simulate import simulate

pytestmark = [
    pytest.mark.skipif(sys.version_info >= (3, 12), reason="SimSo does not run with this Python"),
    pytest.mark.skipif(importlib.util.find_spec("simso") is None, reason="SimSo is not installed"),
]

US = 1000
CYCLE, SLICE, WINDOWS = 2000 * US, 500 * US, 500 * US


def random_model(seed: int) -> Model:
    """One realtime task, some external ones right after it, suspendable ones below."""
    chance = random.Random(seed)
    tasks = []
    for i in range(chance.randint(2, 6)):
        kind = TaskClass.ASYNCHRONOUS
        if i == 0:
            kind = TaskClass.REALTIME
        time = chance.randint(1, 60 if i < 2 else 160) * 5 * US
        every = chance.choice([1, 1, 2, 3, 4])
        call = Call(f"f{i}", 0, Execution((time,)))
        tasks.append(Task(f"thread[{i}]", f"T{i}", kind, every, -i, 1, (call,)))
    if chance.random() < 0.5:
        call = Call("e", 0, Execution((chance.randint(1, 300) * US,)))
        # The external thread follows the realtime one in urgency.
        others = [tasks[0]]
        for task in tasks[1:]:
            others.append(
                Task(task.key, task.name, task.kind, task.every, task.urgency - 1, 1, task.calls)
            )
        external = Task("external_thread[0]", "EXT", TaskClass.EXTERNAL, 1, -1, 1, (call,))
        tasks = [*others, external]
    return Model(
        InterruptSource.TIMER,
        CYCLE,
        SLICE,
        WINDOWS,
        Train(CYCLE),
        tuple(tasks),
        (1,),
        (1,),
        rules=Rules(overflow="queue"),
    )


def simso_responses(model: Model, cycles: int) -> list[list[int]]:
    """The responses of each task's jobs in SimSo, in ns, as far as they ended."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        from simso.configuration import Configuration  # noqa: PLC0415
        from simso.core import Model as SimsoModel  # noqa: PLC0415

        configuration: Any = Configuration()
        configuration.cycles_per_ms = 1_000_000
        configuration.duration = cycles * CYCLE
        for i, task in enumerate(model.tasks):
            # Twice the urgency leaves room for Windows.
            _add(configuration, i + 1, task.every * 2, task.longest / 1e6, 2 * task.urgency)
        stoppable = [t.urgency for t in model.tasks if t.kind is TaskClass.ASYNCHRONOUS]
        point = (CYCLE - WINDOWS) / 1e6
        _add(configuration, 99, 2, WINDOWS / 1e6, 2 * max(stoppable, default=-99) + 1, point)
        configuration.add_processor(name="CPU", identifier=1)
        configuration.scheduler_info.clas = "simso.schedulers.FP"
        configuration.check_all()
        run: Any = SimsoModel(configuration)
        run.run_model()
    found: list[list[int]] = [[] for _ in model.tasks]
    for task, result in run.results.tasks.items():
        if task.identifier != 99:
            times = [job.response_time for job in result.jobs]
            found[task.identifier - 1] = [round(time) for time in times if time is not None]
    return found


def _add(
    configuration: Any, number: int, period: float, wcet: float, priority: int, date: float = 0
) -> None:
    configuration.add_task(
        name=f"T{number}",
        identifier=number,
        period=period,
        activation_date=date,
        wcet=wcet,
        deadline=period,
        data={"priority": priority},
        abort_on_miss=False,
    )


@each_seed(25, 10)
def test_responses_are_those_of_simso(seed: int) -> None:
    """On random task sets each job answers as in SimSo."""
    model = random_model(seed)
    cycles = 36
    run = simulate(model, cycles, record=cycles)
    mine: list[list[int]] = [[] for _ in model.tasks]
    for event in run.record.events:
        if event.kind is EventKind.END:
            mine[event.task].append(event.value)
    theirs = simso_responses(model, cycles)
    for own, other in zip(mine, theirs, strict=True):
        # Jobs that end with the simulation itself count in one of the two only.
        count = min(len(own), len(other))
        assert abs(len(own) - len(other)) <= 1
        assert own[:count] == other[:count]
    assert all(own or not other for own, other in zip(mine, theirs, strict=True))
