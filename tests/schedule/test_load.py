# SPDX-License-Identifier: MIT
"""Load files: what is taken, and what is reported about bad ones."""

from __future__ import annotations

import pytest
from support.schedule_examples import EXAMPLE_1, TIGHT, load_text, make, with_line

from nctakt.messages import Collector
from nctakt.schedule.load import Load, read_load
from nctakt.schedule.model import ANY_CPU, Execution, Overheads, TaskClass


def read(text: str) -> tuple[Load, list[int]]:
    """A load, and what was found."""
    collector = Collector()
    load = read_load("load.toml", text, collector)
    for found in collector.diagnostics:
        assert found.render("en") and found.render("de")
    return load, [found.id for found in collector.diagnostics]


COMPLETE = """\
seed = 7
[functions]
task_int = 400
task_rnd = [600, 650.5]
task_com = { uniform = [200, 300] }
"thread[1].function[1]" = 0
[external.external_sps]
time = 200
priority = 110
cpu = 2
[machine]
cpus = 3
offline = [3]
windows_cpus = [1]
[interrupt]
period = 2000
phase = 1
drift = -0.5
jitter = 10
[overheads]
switch = 2
activation = 1
"""


def test_complete_load() -> None:
    """All that a load can say, in nanoseconds."""
    load, found = read(COMPLETE)
    assert found == []
    assert load.seed == 7
    assert load.functions == {
        "task_int": Execution((400_000,)),
        "task_rnd": Execution((600_000, 650_500)),
        "task_com": Execution((200_000, 300_000), spread=True),
        "thread[1].function[1]": Execution((0,)),
    }
    external = load.external["external_sps"]
    assert (external.execution, external.priority, external.cpu) == (
        Execution((200_000,)),
        110,
        2,
    )
    assert (load.cpus, load.offline, load.windows_cpus) == (3, (3,), (1,))
    assert load.interrupt == {"period": 2_000_000, "phase": 1000, "drift": -500, "jitter": 10_000}
    assert load.overheads == Overheads(2000, 1000)


def test_times_may_have_units() -> None:
    """A text with a unit is a time wherever a number of microseconds is one."""
    text = COMPLETE.replace("switch = 2", "switch = '0.002 ms'").replace("-0.5", "'-0.5 us'")
    assert read(text) == read(COMPLETE)
    load, found = read("[functions]\ntask_rnd = ['1 ms', 650.5, '0.5us']\ntask_com = '1 h'")
    assert found == []
    assert load.functions["task_com"] == Execution((3_600 * 10**9,))
    assert load.functions["task_rnd"] == Execution((1_000_000, 650_500, 500))


def test_a_text_that_is_not_toml_is_reported_at_its_place() -> None:
    """900620 has line and column."""
    collector = Collector()
    read_load("load.toml", "[functions]\ntask_int 400", collector)
    (found,) = collector.diagnostics
    assert found.span is not None
    assert (found.span.line, found.span.column, found.source_line) == (2, 10, "task_int 400")


@pytest.mark.parametrize(
    ("text", "number"),
    [
        ("[functions", 900620),
        ("x" * 5, 900620),
        ("a = " + "[" * 5000, 900620),
        ("[functions]\ntask_int = -1", 900623),
        ("[functions]\ntask_int = nan", 900623),
        ("[functions]\ntask_int = inf", 900623),
        ("[functions]\ntask_int = 4294967295", 900623),
        ("[functions]\ntask_int = true", 900623),
        ("[functions]\ntask_int = 'x'", 900623),
        ("[functions]\ntask_int = '400'", 900623),
        ("[functions]\ntask_int = '4 ticks'", 900623),
        ("[functions]\ntask_int = '-1 us'", 900623),
        ("[functions]\ntask_int = '2 h'", 900623),
        ("[functions]\ntask_int = []", 900623),
        ("[functions]\ntask_int = [1, -2]", 900623),
        ("[functions]\ntask_int = { uniform = [3, 2] }", 900623),
        ("[functions]\ntask_int = { uniform = [3] }", 900623),
        ("[functions]\ntask_int = { normal = [1, 2] }", 900623),
        ("functions = 3", 900623),
        ("external = 3", 900623),
        ("[external]\nx = 3", 900623),
        ("[external.x]\ntime = -1", 900623),
        ("[external.x]\npriority = 1.5", 900623),
        ("[external.x]\ncpu = 0", 900623),
        ("[external.x]\nspeed = 1", 900624),
        ("[machine]\ncpus = 0", 900623),
        ("[machine]\ncpus = 9", 900623),
        ("[machine]\noffline = 1", 900623),
        ("[machine]\noffline = [1, 1]", 900623),
        ("[machine]\ncores = 1", 900624),
        ("[interrupt]\nperiod = 0", 900623),
        ("[interrupt]\njitter = -1", 900623),
        ("[interrupt]\noffset = 1", 900624),
        ("[overheads]\nswitch = -1", 900623),
        ("seed = 1.5", 900623),
        ("speed = 1", 900624),
    ],
)
def test_bad_loads(text: str, number: int) -> None:
    """Each defective entry has its diagnostic."""
    assert read(text)[1] == [number]


def test_missing_times() -> None:
    """Functions and external threads without a time have the assumed ones, a note names each."""
    model, found = make(EXAMPLE_1, "[functions]\ntask_int = 1\n")
    assert found == [900622] * 4
    assert [task.longest // 1000 for task in model.tasks] == [1, 600, 200, 200, 150]
    assert make(EXAMPLE_1, "[external.external_sps]\npriority = 1\n")[1] == [900622] * 5


def test_times_with_units() -> None:
    """A text with a unit is a time as everywhere else."""
    load, found = read("[functions]\na = '1.5ms'\nb = ['2us', 3]\nc = '1h'\n")
    assert found == []
    assert load.functions == {
        "a": Execution((1_500_000,)),
        "b": Execution((2000, 3000)),
        "c": Execution((3_600_000_000_000,)),
    }


def test_names_that_the_list_does_not_have() -> None:
    """Times of unknown functions and threads are not used, with a warning."""
    extra = "[external.other]\ntime = 1\n"
    load = load_text(TIGHT | {"task_intt": 3}, extra=extra)
    assert make(EXAMPLE_1, load)[1] == [900621, 900621]


def test_time_of_one_place_in_the_list() -> None:
    """A function's place in the list comes before its name."""
    load = load_text(TIGHT | {'"thread[0].function[0]"': 123})
    model, found = make(EXAMPLE_1, load)
    assert found == []
    assert model.tasks[0].longest == 123_000


def test_priority_of_an_external_thread() -> None:
    """Without a priority it comes right after the realtime thread."""
    load = load_text(TIGHT).replace("priority = 110\n", "")
    model, _ = make(EXAMPLE_1, load)
    order = sorted(model.tasks, key=lambda task: -task.urgency)
    assert [task.name for task in order][:2] == ["GEO", "external_sps"]
    model, _ = make(EXAMPLE_1, load, os="vxworks")
    order = sorted(model.tasks, key=lambda task: -task.urgency)
    assert [task.name for task in order][-2:] == ["GEO", "external_sps"]


def test_interrupt_of_the_timer() -> None:
    """Period, drift and jitter belong to other sources; the phase counts."""
    load = load_text(TIGHT, extra="[interrupt]\nperiod = 9\ndrift = 1\njitter = 1\nphase = 3\n")
    model, found = make(EXAMPLE_1, load)
    assert found == [900627] * 3
    assert (model.train.period, model.train.phase, model.train.jitter) == (2_000_000, 3000, 0)


def test_drift_must_leave_a_period() -> None:
    """A drift that eats the period is an error."""
    load = load_text(TIGHT, extra="[interrupt]\nperiod = 9\ndrift = -9\n")
    assert make(EXAMPLE_1, load, convention="field")[1] == [900623]


def test_all_processors_offline() -> None:
    """One processor must be left."""
    load = load_text(TIGHT, extra="[machine]\ncpus = 1\noffline = [1]\n")
    assert 900623 in make(EXAMPLE_1, load)[1]


def test_processors_follow_the_list() -> None:
    """Without a number there are as many as the list names; Windows runs on those in use."""
    model, _ = make(with_line(EXAMPLE_1, "thread[2].cpu 3"), load_text(TIGHT))
    assert (model.cpus, model.windows_cpus) == ((1, 2, 3), (1, 3))
    load = load_text(TIGHT, extra="[machine]\ncpus = 2\n")
    model, found = make(with_line(EXAMPLE_1, "thread[2].cpu 3"), load)
    assert found == [1000180]
    assert (model.tasks[2].cpu, model.windows_cpus) == (ANY_CPU, (1, 2))


def test_highest_thread_without_task_int() -> None:
    """B1: without task_int the thread of highest priority is the realtime thread."""
    text = EXAMPLE_1.replace("name task_int", "name task_x")
    model, _ = make(text, load_text(TIGHT | {"task_x": 1}))
    kinds = [task.kind for task in model.tasks[:4]]
    assert kinds == [TaskClass.REALTIME] + [TaskClass.ASYNCHRONOUS] * 3


@pytest.mark.parametrize(("calls", "numbers"), [(10_000, []), (10_001, [900628])])
def test_most_calls(calls: int, numbers: list[int]) -> None:
    """More calls than can be simulated are an error."""
    text = with_line(EXAMPLE_1, f"thread[1].function[0].calls_per_cycle {calls}")
    assert make(text, load_text(TIGHT))[1] == numbers
