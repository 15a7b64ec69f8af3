# SPDX-License-Identifier: MIT
"""The simulation against a slow scheduler, its repetitions, chance, overheads, free placement."""

from __future__ import annotations

import itertools
from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.schedule_examples import EXAMPLE_1, TIGHT, load_text, make, with_line
from support.schedule_models import call, models
from support.stepwise import step

from nctakt.lists.declared.rtconf import InterruptSource
from nctakt.schedule.model import (
    ANY_CPU,
    Execution,
    Model,
    Overheads,
    Rules,
    Task,
    TaskClass,
    Train,
)
from nctakt.schedule.simulation.results import EventKind
from nctakt.schedule.simulation.simulate import hyperperiod, simulate

pytestmark = pytest.mark.slow

US = 1000


@pytest.mark.nightly
@pytest.mark.slow
@given(models())
@settings(max_examples=300, deadline=None)
def test_simulation_is_that_of_a_scheduler_that_looks_at_each_nanosecond(model: Model) -> None:
    """B2: responses, overflows, suspensions and Windows' time are those of a stepwise run."""
    cycles = 12
    run = simulate(model, cycles, record=0, repeat=False)
    expected = step(model, cycles)
    for i, numbers in enumerate(run.tasks):
        answers = expected.responses[i]
        assert numbers.completed == len(answers)
        assert numbers.response_sum == sum(answers)
        assert numbers.response_max == max(answers, default=None)
        assert numbers.response_min == min(answers, default=None)
        found = (numbers.overflows, numbers.lost, numbers.suspensions, numbers.busy)
        wanted = (
            expected.overflows[i],
            expected.lost[i],
            expected.suspensions[i],
            expected.busy[i],
        )
        assert found == wanted
    for place, windows in enumerate(run.windows[:-1]):
        shares = [row[place] for row in expected.windows]
        assert (windows.total, windows.minimum, windows.maximum) == (
            sum(shares),
            min(shares),
            max(shares),
        )


@given(models(), st.integers(1, 400))
@settings(max_examples=200, deadline=None)
def test_counted_repetitions_are_exact(model: Model, cycles: int) -> None:
    """Counting the repetitions gives every number of the full simulation."""
    short = simulate(model, cycles, record=0)
    full = simulate(model, cycles, record=0, repeat=False)
    assert short.tasks == full.tasks
    assert short.windows == full.windows
    assert (short.missed_suspensions, short.suspended_cycles, short.end) == (
        full.missed_suspensions,
        full.suspended_cycles,
        full.end,
    )


@given(models(), st.lists(st.integers(0, 9), min_size=2, max_size=4), st.integers(1, 300))
@settings(max_examples=60, deadline=None)
def test_repetitions_of_lists_of_times_are_exact(
    model: Model, times: list[int], cycles: int
) -> None:
    """Lists of execution times repeat, too; a time of 0 ends when its job is dispatched."""
    first = model.tasks[-1]
    changed = replace(first, calls=(replace(first.calls[0], execution=Execution(tuple(times))),))
    model = replace(model, tasks=(*model.tasks[:-1], changed))
    short = simulate(model, cycles, record=0)
    full = simulate(model, cycles, record=0, repeat=False)
    assert (short.tasks, short.windows) == (full.tasks, full.windows)


def test_an_hour_repeats_after_one_hyperperiod() -> None:
    """One hour of the example is 300 000 times its hyperperiod."""
    model, _ = make(EXAMPLE_1, load_text(TIGHT))
    run = simulate(model, 1_800_000)
    assert (run.repeats_after, hyperperiod(model)) == (6, 6)
    assert run.tasks[3].overflows == 300_000
    assert run.duration == 3600 * 1_000_000 * US


def test_recording_does_not_change_the_numbers() -> None:
    """What is recorded has no influence."""
    model, _ = make(EXAMPLE_1, load_text(TIGHT))
    runs = [simulate(model, 100, record=record) for record in (0, 1, 7, 100)]
    assert all(run.tasks == runs[0].tasks for run in runs)
    assert [len(run.record.jobs) for run in runs[:2]] == [0, 5]
    assert runs[-1].repeats_after is None


RANDOM = """\
seed = {seed}
[functions]
task_int = {{ uniform = [100, 400] }}
task_rnd = {{ uniform = [300.5, 900] }}
task_mmi_driver = 100
task_com = [100, 200, 300]
[external.external_sps]
time = 200
[interrupt]
jitter = 50
"""


def test_same_seed_same_schedule() -> None:
    """Random times and jitter come from the seed alone."""
    runs = [
        simulate(make(EXAMPLE_1, RANDOM.format(seed=seed), convention="field")[0], 500)
        for seed in (1, 1, 2)
    ]
    assert runs[0] == runs[1]
    assert runs[0].tasks != runs[2].tasks
    assert runs[0].repeats_after is None


def test_jitter_stays_within_its_bound() -> None:
    """Interrupts keep their order and their distance from the mean."""
    model, _ = make(EXAMPLE_1, RANDOM.format(seed=3), convention="field")
    record = simulate(model, 300, record=300).record
    times = [one.time for one in record.events if one.kind is EventKind.INTERRUPT]
    offsets = [time - k * 2000 * US for k, time in enumerate(times)]
    assert all(abs(offset) <= 50 * US for offset in offsets)
    assert min(offsets) < -40 * US and max(offsets) > 40 * US


def test_too_much_jitter_is_cut_to_half_a_period() -> None:
    """Two interrupts never change places."""
    load = RANDOM.format(seed=3).replace("jitter = 50", "jitter = 5000")
    model, _ = make(EXAMPLE_1, load, convention="field")
    assert model.train.jitter == 999_999
    record = simulate(model, 300, record=300).record
    times = [one.time for one in record.events if one.kind is EventKind.INTERRUPT]
    assert all(a < b for a, b in itertools.pairwise(times))


def test_lists_of_times_are_taken_one_after_another() -> None:
    """COM's times 100, 200, 300 come in turn."""
    load = load_text(TIGHT | {"task_int": 100, "task_rnd": 100}).replace(
        "task_com = 250", "task_com = [100, 200, 300]"
    )
    model, _ = make(EXAMPLE_1, load)
    jobs = [one for one in simulate(model, 12, record=12).record.jobs if one.task == 3]
    assert [one.times[0] // US for one in jobs] == [100, 200, 300, 100, 200, 300]


def test_interleaved_calls() -> None:
    """The functions of a thread in turn instead of one after another."""
    text = with_line(
        EXAMPLE_1,
        "thread[1].function[0].calls_per_cycle 3",
        "thread[1].function[1].name task_com",
        "thread[1].function[1].calls_per_cycle 2",
    )
    order = [
        [
            call.function
            for call in make(text, load_text(TIGHT), rules=Rules(calls=calls))[0].tasks[1].calls
        ]
        for calls in ("block", "interleave")
    ]
    assert order[0] == ["task_rnd"] * 3 + ["task_com"] * 2
    assert order[1] == ["task_rnd", "task_com", "task_rnd", "task_com", "task_rnd"]


def test_overheads_add_to_the_jobs_that_cause_them() -> None:
    """A switch costs whoever gets the processor, an activation whoever is released."""
    load = load_text(TIGHT, extra="[overheads]\nswitch = 2\nactivation = 1\n")
    model, _ = make(EXAMPLE_1, load)
    assert model.overheads == Overheads(2 * US, US)
    run = simulate(model, 1)
    assert [one.response_max for one in run.tasks[:2]] == [403 * US, 403 * US + 203 * US + 703 * US]


def test_queued_activations_all_come() -> None:
    """The policy 'queue' loses nothing."""
    model, _ = make(EXAMPLE_1, load_text(TIGHT), rules=Rules(overflow="queue"))
    run = simulate(model, 60)
    assert all(one.lost == 0 for one in run.tasks)
    assert run.tasks[3].overflows > 0


def free(cpus: int, *times: int, windows: int = 0) -> Model:
    """Tasks of falling urgency that may run anywhere."""
    tasks = tuple(
        Task(
            f"thread[{i}]",
            f"T{i}",
            TaskClass.ASYNCHRONOUS if i else TaskClass.REALTIME,
            1,
            -i,
            ANY_CPU,
            (call(time),),
        )
        for i, time in enumerate(times)
    )
    return Model(
        InterruptSource.TIMER,
        20,
        5,
        windows,
        Train(20),
        tasks,
        tuple(range(1, cpus + 1)),
        (1,) if windows else tuple(range(1, cpus + 1)),
    )


def test_free_tasks_take_the_first_free_processor() -> None:
    """F8: the lowest number that is free; who waits comes when one gets free."""
    record = simulate(free(2, 6, 4, 5), 1, record=1).record
    found = [(one.task, one.cpu, one.begin, one.end) for one in record.segments]
    assert found == [(0, 1, 0, 6), (1, 2, 0, 4), (2, 2, 4, 9)]


def test_free_tasks_flee_from_the_time_of_windows() -> None:
    """F8: a suspended task goes on where Windows does not run."""
    record = simulate(free(2, 14, 18, 2, windows=10), 1, record=1).record
    found = [(one.task, one.cpu, one.begin, one.end) for one in record.segments]
    assert (0, 1, 0, 14) in found
    assert (1, 2, 0, 18) in found
    assert (2, 2, 18, 20) in found


@given(models())
@settings(max_examples=100, deadline=None)
def test_free_tasks_on_one_processor_are_bound_ones(model: Model) -> None:
    """With one processor it does not matter who places the tasks."""
    bound = replace(
        model,
        tasks=tuple(replace(task, cpu=1) for task in model.tasks),
        cpus=(1,),
        windows_cpus=(1,),
    )
    anywhere = replace(bound, tasks=tuple(replace(task, cpu=ANY_CPU) for task in model.tasks))
    assert simulate(bound, 20).tasks == simulate(anywhere, 20).tasks


@given(models())
@settings(max_examples=100, deadline=None)
def test_placing_is_that_of_bound_tasks_where_only_one_is_free(model: Model) -> None:
    """A free task without work changes nothing for the others on their processors."""
    if len(model.cpus) == 1:
        return
    idle = Task("thread[6]", "idle", TaskClass.ASYNCHRONOUS, 1, -9, ANY_CPU, ())
    with_idle = replace(model, tasks=(*model.tasks, idle))
    bound, placed = simulate(model, 20), simulate(with_idle, 20)
    assert placed.tasks[:-1] == bound.tasks
    shares = [(one.total, one.minimum, one.maximum) for one in placed.windows]
    assert shares == [(one.total, one.minimum, one.maximum) for one in bound.windows]


@pytest.mark.parametrize("record", [0, 3])
def test_task_without_calls_is_never_released(record: int) -> None:
    """F4: a thread without function never runs."""
    text = with_line(EXAMPLE_1, "thread[4].name EMPTY", "thread[4].cycle 2000")
    model, _ = make(text, load_text(TIGHT))
    empty = simulate(model, 6, record=record).tasks[4]
    assert (empty.due, empty.completed) == (0, 0)
