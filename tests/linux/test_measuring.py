# SPDX-License-Identifier: MIT
"""What is made of a run's log, without running anything: a simulation written as a log.

If the log of a run says what the simulation says, both must give the same numbers and the same
record: a run is measured by the simulator's rules.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.schedule_examples import EXAMPLE_1, TIGHT, change, load_text, make
from support.schedule_models import models

from nctakt.base.failure import Failure
from nctakt.schedule.model import Model, TaskClass
from nctakt.schedule.real import area as layout
from nctakt.schedule.real import measure as measuring
from nctakt.schedule.real.measure import Measurement, late_wakes, measure
from nctakt.schedule.real.plan import Plan, crowded_cpus, make_plan
from nctakt.schedule.real.run import RunLog
from nctakt.schedule.simulation.results import Event, EventKind, Record, Simulation
from nctakt.schedule.simulation.simulate import simulate
from nctakt.schedule.simulation.tracebits import calls_of

_Row = tuple[int, int, int, int, int, int]


def rows_of(run: Simulation) -> Iterator[_Row]:
    """The entries that processes would have written, had they done what was simulated."""
    model, record = run.model, run.record
    waiting = [0] * len(model.tasks)
    numbers = [0] * len(model.tasks)
    for event in record.events:
        time, i = event.time, event.task
        if event.kind is EventKind.INTERRUPT:
            yield time, time, layout.INTERRUPT, 0, 0, 0
        elif event.kind is EventKind.OVERFLOW:
            keeps = is_remembered(model, i, waiting[i])
            yield time, event.value, layout.OVERFLOW, i, int(keeps), 0
            if keeps:
                yield time, numbers[i], layout.RELEASE, i, 1, 0
                numbers[i] += 1
                waiting[i] += 1
        elif event.kind is EventKind.RELEASE:
            if is_due_now(record, event):
                yield time, numbers[i], layout.RELEASE, i, 0, 0
                numbers[i] += 1
            else:
                waiting[i] -= 1
        elif event.kind is EventKind.SUSPEND:
            yield time, event.value, layout.SUSPEND, i, 0, 0
        elif event.kind is EventKind.RESUME:
            yield time, event.value, layout.RESUME, i, 0, 0
    yield record.end, record.end, layout.INTERRUPT, 0, 0, 0


def is_due_now(record: Record, event: Event) -> bool:
    """Whether a job is released when it is due, not when the one before it ends."""
    job = next(j for j in record.jobs if (j.task, j.number) == (event.task, event.value))
    return job.due == event.time


def is_remembered(model: Model, i: int, waiting: int) -> bool:
    """The rule for an activation that finds its task busy."""
    policy = model.rules.overflow
    if model.tasks[i].kind is TaskClass.EXTERNAL or policy == "queue":
        return True
    return policy == "pend" and not waiting


def workers_rows(run: Simulation) -> Iterator[_Row]:
    """What the workers would have written."""
    begun: set[tuple[int, int]] = set()
    record = run.record
    ends: dict[tuple[int, int], int] = {}
    numbers = [0] * len(run.model.tasks)
    for event in record.events:
        if event.kind is EventKind.END:
            ends[event.task, numbers[event.task]] = event.time
            numbers[event.task] += 1
    last = {(one.task, one.job): one for one in record.segments}
    for one in record.segments:
        job = (one.task, one.job)
        if job not in begun:
            begun.add(job)
            yield one.begin, one.job, layout.WAKE, one.task, 0, one.cpu
        yield one.begin, one.end, layout.SEGMENT, one.task, 0, one.cpu
        if last[job] is one and job in ends:
            yield ends[job], one.job, layout.END, one.task, 0, one.cpu


def log_of(run: Simulation) -> RunLog:
    """A simulation of which everything was recorded, as the log of a run."""
    due: list[list[int]] = [[] for _ in run.model.tasks]
    waiting = list(rows_of(run))
    begin = 0
    for time, value, kind, i, _, _ in waiting:
        if kind == layout.INTERRUPT:
            begin = time
        elif kind == layout.RELEASE:
            assert value == len(due[i])
            due[i].append(begin)
    # At one instant the scheduler acts first, then what ends, then what begins.
    rows = np.array([*waiting, *workers_rows(run)], layout.ENTRY)
    rows = rows[np.argsort(rows["time"], kind="stable")]
    plan = make_plan(run.model, run.cycles, is_fifo=True, plays_external=True)
    nobody: tuple[int | None, ...] = (None,) * len(run.model.tasks)
    posted = (0,) * len(run.model.tasks)
    return RunLog(plan, rows, tuple(due), nobody, posted, False, False, (), 0, run.end)


@settings(deadline=None)
@given(models(), st.integers(1, 20))
def test_a_log_of_a_simulation_gives_its_numbers(model: Model, cycles: int) -> None:
    """The numbers of threads and of Windows, suspensions, overflows: those of the simulation."""
    run = simulate(model, cycles, record=cycles, repeat=False)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(measuring, "TOLERATED", 10**9)
        found = measure(log_of(run), cycles).run
    assert found.tasks == run.tasks
    assert found.windows == run.windows
    assert found.missed_suspensions == run.missed_suspensions
    assert found.suspended_cycles == run.suspended_cycles
    assert (found.begin, found.end, found.cycles) == (run.begin, run.end, run.cycles)


def example(**values: object) -> Measurement:
    """The manual's first example under load, measured from a log."""
    model, _ = make(change(EXAMPLE_1, **values), load_text(TIGHT))
    return measure(log_of(simulate(model, 6, record=6)), 6)


def test_a_log_of_a_simulation_gives_its_record() -> None:
    """Segments, jobs, calls and events are those of the simulation: the same pictures (S1)."""
    model, _ = make(EXAMPLE_1, load_text(TIGHT))
    run = simulate(model, 6, record=6)
    found = example().run.record
    assert found.segments == run.record.segments
    assert sorted(found.events, key=str) == sorted(run.record.events, key=str)
    assert sorted(calls_of(model, found), key=str) == sorted(calls_of(model, run.record), key=str)
    assert (found.begin, found.end) == (run.record.begin, run.record.end)


def test_a_shorter_record_is_cut() -> None:
    """Of six cycles one is recorded; what is not over by then has no end in the record."""
    model, _ = make(EXAMPLE_1, load_text(TIGHT))
    run = simulate(model, 6, record=6)
    found = measure(log_of(run), 1).run.record
    assert found.end == model.cycle
    short = simulate(model, 6, record=1)
    assert found.segments == short.record.segments
    assert [one.end for one in calls_of(model, found)] == [400000, 1300000, None, 600000]


def test_windows_time_may_be_a_little_short() -> None:
    """A tenth of windows_time may be missing: the timer is late now and then."""
    model, _ = make(EXAMPLE_1, load_text(TIGHT))
    log = log_of(simulate(model, 6, record=6))
    late = log.entries.copy()
    segments = (late["kind"] == layout.SEGMENT) & (late["value"] == 1_500_000)
    for by, violated in ((50_000, 0), (50_001, 1)):
        late["value"][segments] = 1_500_000 + by
        found = measure(replace(log, entries=late), 6).run.windows[0]
        assert (found.minimum, found.violated) == (500_000 - by, violated)


def test_how_late_it_was() -> None:
    """Late is what came after its moment; more than a time slice is reported."""
    model, _ = make(EXAMPLE_1, load_text(TIGHT))
    log = log_of(simulate(model, 6, record=6))
    late = log.entries.copy()
    interrupts = late["kind"] == layout.INTERRUPT
    late["time"][interrupts] += 7
    found = measure(replace(log, entries=late), 6)
    assert found.timer == (7,) * 7
    assert found.wakes[0] == (0,) * 6
    assert late_wakes(found) == []
    late["time"][interrupts] += 500_000
    found = measure(replace(log, entries=late), 6)
    assert late_wakes(found) == [500_007] * 7


def test_no_cycle() -> None:
    """900695: there is nothing to measure before the first cycle is over."""
    model, _ = make(EXAMPLE_1, load_text(TIGHT))
    log = log_of(simulate(model, 1, record=1))
    none = log.entries[:1]
    with pytest.raises(Failure) as raised:
        measure(replace(log, entries=none), 1)
    assert [one.id for one in raised.value.diagnostics] == [900695]


# --- the plan -----------------------------------------------------------------------------------


def plan_of(extra: str = "", **values: object) -> Plan:
    """The plan of the first example."""
    model, _ = make(change(EXAMPLE_1, **values), load_text(TIGHT, extra=extra))
    return make_plan(model, 12, is_fifo=True, plays_external=False)


def test_ranks() -> None:
    """A4: SCHED_FIFO from 80 down in the order of the list's priorities, whatever they are."""
    found = [(one.task.name, one.priority, one.semaphore) for one in plan_of().tasks]
    assert found == [
        ("GEO", 80, ""),
        ("external_sps", 79, "/external_sps"),
        ("BACKGROUND_", 78, ""),
        ("MMI_DRIVER", 77, ""),
        ("COM", 76, ""),
    ]


@pytest.mark.parametrize("source", [1, 2])
def test_run_and_simulation_draw_the_same(source: int) -> None:
    """Moments and execution times are those that the simulation draws with the same seed."""
    load = load_text(TIGHT, extra="seed = 5")
    load = load.replace("task_int = 400", "task_int = { uniform = [100, 200] }")
    load = load.replace("task_rnd = 700", "task_rnd = [300, 310, 320]")
    load += "[interrupt]\nphase = 3\njitter = 40\ndrift = 7\n" if source == 1 else ""
    model, _ = make(change(EXAMPLE_1, interrupt_source=source), load)
    plan = make_plan(model, 12, is_fifo=True, plays_external=True)
    record = simulate(model, 12, record=12).record
    moments = [one.time for one in record.events if one.kind is EventKind.INTERRUPT]
    shift = plan.moments[0] - moments[0]
    assert shift % model.slice == 0 and plan.moments[0] >= 0
    assert [moment + shift for moment in [*moments, record.end]] == list(plan.moments)
    for planned in plan.tasks:
        drawn = [job.times for job in record.jobs if job.task == planned.number]
        rows = [tuple(row) for row in planned.times.tolist()]
        assert drawn == [rows[i % len(rows)] for i in range(len(drawn))]


def test_crowded_processors() -> None:
    """Where threads leave less than a twentieth of a processor nothing runs without --force."""
    assert crowded_cpus(plan_of()) == []
    assert [cpu for cpu, _ in crowded_cpus(plan_of(windows_time=0))] == []
    model, _ = make(EXAMPLE_1, load_text(TIGHT | {"task_int": 1900}))
    found = crowded_cpus(make_plan(model, 1, is_fifo=True, plays_external=False))
    assert found == [(1, pytest.approx(0.95))]
