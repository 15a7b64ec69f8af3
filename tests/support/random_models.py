# SPDX-License-Identifier: MIT
"""Random small models of all kinds, made from a seed alone: cheap enough for many thousands.

An NC cycle is some ten nanoseconds long, so that everything falls together now and then.
"""

from __future__ import annotations

import random
from dataclasses import replace
from math import gcd

from nctakt.lists.declared.rtconf import InterruptSource
from nctakt.schedule.model import (
    ANY_CPU,
    Call,
    Execution,
    Model,
    Overheads,
    Rules,
    Task,
    TaskClass,
    Train,
)

#: More external threads than threads of the list would be usual: they have most of the cases.
_KINDS = (TaskClass.ASYNCHRONOUS, TaskClass.ASYNCHRONOUS, TaskClass.EXTERNAL, TaskClass.REALTIME)


def random_model(seed: int) -> Model:
    """Return the model of a seed."""
    chance = random.Random(seed)
    slice_ = chance.randint(2, 6)
    slices = chance.randint(2, 5)
    cycle = slice_ * slices
    windows = slice_ * chance.choice([0, 1, 1, 1, *range(slices + 1)])
    cpus = tuple(range(1, chance.choice([1, 1, 1, 2, 3]) + 1))
    windows_cpus = chance.choice([cpus, cpus, cpus[:1], cpus[-1:], ()])
    source, train = _interrupts(chance, cycle, slice_)
    rules = Rules(
        overflow=chance.choice(["skip", "skip", "pend", "queue"]),
        suspension=chance.choice(["ticks", "elapsed"]),
    )
    overheads = Overheads(*chance.choice([(0, 0), (0, 0), (0, 0), (1, 0), (0, 1), (2, 1)]))
    return Model(
        source,
        cycle,
        slice_,
        windows,
        train,
        _tasks(chance, cycle, cpus),
        cpus,
        windows_cpus,
        overheads,
        rules,
        seed,
    )


def _interrupts(chance: random.Random, cycle: int, slice_: int) -> tuple[InterruptSource, Train]:
    if chance.random() < 0.4:
        return InterruptSource.TIMER, Train(cycle, chance.choice([0, 0, 3]))
    source = chance.choice([InterruptSource.HARDWARE, InterruptSource.SEMAPHORE])
    period = cycle
    if chance.random() < 0.3:
        period = chance.randint(max(1, cycle // 2), 2 * cycle)
    train = Train(period, chance.randrange(2 * slice_))
    if chance.random() < 0.3:
        train = replace(train, drift=chance.randint(-1, 2))
    if chance.random() < 0.4:
        train = replace(train, jitter=chance.randint(0, max(0, (train.distance - 1) // 2)))
    return source, train


def _tasks(chance: random.Random, cycle: int, cpus: tuple[int, ...]) -> tuple[Task, ...]:
    count = chance.randint(1, 5)
    kinds = [TaskClass.REALTIME, *(chance.choice(_KINDS) for _ in range(count - 1))]
    kinds.sort(key=lambda kind: kind is TaskClass.EXTERNAL)
    has_ties = chance.random() < 0.15
    urgencies = [chance.randint(0, 3) if has_ties else i for i in range(count)]
    chance.shuffle(urgencies)
    has_free = chance.random() < 0.3
    longest = max(1, cycle // chance.choice([1, 2, 3, 4, 6]))
    return tuple(
        Task(
            f"thread[{i}]",
            f"T{i}",
            kind,
            chance.choice([1, 1, 1, 2, 2, 3, 4]),
            urgency,
            ANY_CPU if has_free and chance.random() < 0.5 else chance.choice(cpus),
            _calls(chance, f"f{i}", longest),
        )
        for i, (kind, urgency) in enumerate(zip(kinds, urgencies, strict=True))
    )


def _calls(chance: random.Random, name: str, longest: int) -> tuple[Call, ...]:
    count = chance.choice([1, 1, 1, 1, 2, 0])
    kind = chance.random()
    low, high = sorted((chance.randint(0, longest), chance.randint(0, longest)))
    execution = Execution((chance.randint(chance.choice([0, 1]), longest),))
    if kind < 0.1:
        execution = Execution((low, high), spread=True)
    elif kind < 0.25:
        values = [chance.randint(0, longest) for _ in range(chance.randint(2, 4))]
        execution = Execution(tuple(values))
    return tuple(Call(name, number, execution) for number in range(count))


def phases(model: Model) -> range:
    """Return all phases that make a difference to an interrupt that the timer does not give."""
    if model.source is InterruptSource.TIMER:
        return range(model.train.phase, model.train.phase + 1)
    return range(gcd(model.train.distance, model.slice))
