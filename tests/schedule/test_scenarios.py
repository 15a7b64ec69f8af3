# SPDX-License-Identifier: MIT
"""Worked schedules, to the microsecond."""

from __future__ import annotations

import pytest
from support.nominal_times import NOMINAL
from support.schedule_examples import (
    EXAMPLE_1,
    EXAMPLE_2,
    TIGHT,
    change,
    load_text,
    make,
    with_line,
)

from nctakt.schedule.model import Model, Rules
from nctakt.schedule.simulation.results import EventKind, Simulation
from nctakt.schedule.simulation.simulate import simulate
from nctakt.schedule.simulation.tracebits import trace_bits

US = 1000
GEO, BG, MMI, COM = "GEO", "BACKGROUND_", "MMI_DRIVER", "COM"
EXT = "external_sps"

Timeline = list[tuple[str, int, int]]


def timeline(model: Model, cycles: int, cpu: int = 1) -> list[Timeline]:
    """Who runs when, cycle by cycle, in µs; ``WIN`` is the rest of a cycle."""
    record = simulate(model, cycles, record=cycles).record
    starts = [one.time for one in record.events if one.kind is EventKind.INTERRUPT]
    found: list[Timeline] = []
    for begin, end in zip(starts, [*starts[1:], record.end], strict=True):
        row: Timeline = []
        now = begin
        for one in record.segments:
            if one.cpu == cpu and begin <= one.begin < end:
                name = model.tasks[one.task].name
                now = min(one.end, end)
                if row and row[-1][0] == name:
                    row[-1] = (name, row[-1][1], now // US)
                else:
                    row.append((name, one.begin // US, now // US))
            elif one.cpu == cpu and one.begin < begin < one.end:
                now = min(one.end, end)
                row.append((model.tasks[one.task].name, begin // US, now // US))
        if now < end:
            row.append(("WIN", now // US, end // US))
        found.append(row)
    return found


def suspensions(model: Model, cycles: int) -> list[tuple[int, str, int]]:
    """When who is suspended with how much work left, in µs."""
    record = simulate(model, cycles, record=cycles).record
    return [
        (one.time // US, model.tasks[one.task].name, one.value // US)
        for one in record.events
        if one.kind is EventKind.SUSPEND
    ]


def responses(simulation: Simulation) -> dict[str, int | None]:
    """The longest response of each task, in µs."""
    names = [task.name for task in simulation.model.tasks]
    longest = [one.response_max for one in simulation.tasks]
    return {
        name: None if time is None else time // US
        for name, time in zip(names, longest, strict=True)
    }


def numbers(simulation: Simulation, name: str) -> tuple[int, int, int]:
    """Overflows, completions and suspensions of a task."""
    place = [task.name for task in simulation.model.tasks].index(name)
    one = simulation.tasks[place]
    return one.overflows, one.completed, one.suspensions


def share(simulation: Simulation) -> float:
    """Windows' share in percent."""
    return round(100 * simulation.windows[-1].total / simulation.duration, 2)


def tight(**times: int) -> str:
    """The load of most scenarios, with other times for some functions."""
    return load_text(TIGHT | times)


S4_TIMES = {"task_rnd": 500, "task_mmi_driver": 100, "task_com": 100}
S4_LIST = with_line(EXAMPLE_1, "thread[1].function[0].calls_per_cycle 4")


def test_s0a_example_with_little_load() -> None:
    """S0a: everything fits; Windows gets what is left."""
    model, _ = make(EXAMPLE_1, load_text(NOMINAL))
    assert timeline(model, 3) == [
        [
            (GEO, 0, 300),
            (EXT, 300, 450),
            (BG, 450, 1050),
            (MMI, 1050, 1250),
            (COM, 1250, 1450),
            ("WIN", 1450, 2000),
        ],
        [(GEO, 2000, 2300), (EXT, 2300, 2450), (BG, 2450, 3050), ("WIN", 3050, 4000)],
        [
            (GEO, 4000, 4300),
            (EXT, 4300, 4450),
            (BG, 4450, 5050),
            (COM, 5050, 5250),
            ("WIN", 5250, 6000),
        ],
    ]
    run = simulate(model, 60)
    assert share(run) == 39.17
    assert run.windows[0].minimum == 550 * US
    assert all(one.overflows == one.suspensions == 0 for one in run.tasks)


def test_assumed_times_are_those_of_s0a() -> None:
    """Without a load the assumed times give S0a, and a note."""
    model, found = make(EXAMPLE_1, None)
    assert found == [900625]
    assert timeline(model, 60) == timeline(make(EXAMPLE_1, load_text(NOMINAL))[0], 60)


def test_s0b_second_example() -> None:
    """S0b: task_com in the background thread."""
    model, _ = make(EXAMPLE_2, load_text(NOMINAL))
    rows = timeline(model, 3)
    assert rows[0] == [
        (GEO, 0, 300),
        (EXT, 300, 450),
        (BG, 450, 1250),
        (MMI, 1250, 1450),
        ("WIN", 1450, 2000),
    ]
    assert rows[1][-2:] == [(BG, 2450, 3250), ("WIN", 3250, 4000)]
    assert rows[2][-1] == ("WIN", 5250, 6000)
    assert share(simulate(model, 60)) == 34.17


S1_ROWS = [
    [
        (GEO, 0, 400),
        (EXT, 400, 600),
        (BG, 600, 1300),
        (MMI, 1300, 1500),
        ("WIN", 1500, 2000),
    ],
    [
        (GEO, 2000, 2400),
        (EXT, 2400, 2600),
        (BG, 2600, 3300),
        (MMI, 3300, 3400),
        (COM, 3400, 3500),
        ("WIN", 3500, 4000),
    ],
    [
        (GEO, 4000, 4400),
        (EXT, 4400, 4600),
        (BG, 4600, 5300),
        (COM, 5300, 5450),
        ("WIN", 5450, 6000),
    ],
    [
        (GEO, 6000, 6400),
        (EXT, 6400, 6600),
        (BG, 6600, 7300),
        (MMI, 7300, 7500),
        ("WIN", 7500, 8000),
    ],
    [
        (GEO, 8000, 8400),
        (EXT, 8400, 8600),
        (BG, 8600, 9300),
        (MMI, 9300, 9400),
        (COM, 9400, 9500),
        ("WIN", 9500, 10000),
    ],
    [
        (GEO, 10000, 10400),
        (EXT, 10400, 10600),
        (BG, 10600, 11300),
        (COM, 11300, 11450),
        ("WIN", 11450, 12000),
    ],
]
S1_SUSPENSIONS = [
    (1500, MMI, 100),
    (1500, COM, 250),
    (3500, COM, 150),
    (7500, MMI, 100),
    (9500, COM, 150),
]


def check_s1(model: Model) -> None:
    """All that S1 says."""
    assert timeline(model, 6) == S1_ROWS
    assert suspensions(model, 6) == S1_SUSPENSIONS
    run = simulate(model, 60)
    assert share(run) == 25.83
    assert numbers(run, COM)[:2] == (10, 20)
    assert responses(run) == {GEO: 400, BG: 1300, MMI: 3400, COM: 5450, EXT: 600}
    assert sum(one.suspensions for one in run.tasks) == 50


def test_s1_windows_time_suspends() -> None:
    """S1: MMI_DRIVER and COM are suspended; COM overflows in silence."""
    model, _ = make(EXAMPLE_1, tight())
    check_s1(model)
    record = simulate(model, 3, record=3).record
    overflow = [one for one in record.events if one.kind is EventKind.OVERFLOW]
    assert [(one.time, model.tasks[one.task].name) for one in overflow] == [(4000 * US, COM)]


def test_s1_pending_activations() -> None:
    """S1 with one remembered activation: it counts from the moment when it was due."""
    model, _ = make(EXAMPLE_1, tight(), rules=Rules(overflow="pend"))
    run = simulate(model, 60)
    assert share(run) == 25.0
    assert numbers(run, COM)[:2] == (28, 24)


def test_s1_trace_bits() -> None:
    """S1: a bit is high from the begin of a call to its end, through any interruption."""
    model, _ = make(EXAMPLE_1, tight())
    bits = trace_bits(model, simulate(model, 3).record)
    high = {bit: [(a // US, b // US) for a, b in bits[bit]] for bit in range(1, 8)}
    assert high[1] == [(0, 400), (2000, 2400), (4000, 4400)]
    assert high[2] == [(600, 1300), (2600, 3300), (4600, 5300)]
    assert high[4] == [(3400, 5450)]
    assert all(high[bit] == [] for bit in (3, 5, 6, 7))


def test_s2_the_background_thread_itself_is_suspended() -> None:
    """S2: task_com in the background thread is interrupted; its bit stays high."""
    model, _ = make(EXAMPLE_2, tight())
    assert timeline(model, 3) == [
        [(GEO, 0, 400), (EXT, 400, 600), (BG, 600, 1500), ("WIN", 1500, 2000)],
        [
            (GEO, 2000, 2400),
            (EXT, 2400, 2600),
            (BG, 2600, 2650),
            (MMI, 2650, 2950),
            ("WIN", 2950, 4000),
        ],
        [(GEO, 4000, 4400), (EXT, 4400, 4600), (BG, 4600, 5500), ("WIN", 5500, 6000)],
    ]
    assert suspensions(model, 3) == [(1500, BG, 50), (1500, MMI, 300), (5500, BG, 50)]
    run = simulate(model, 60)
    assert numbers(run, BG)[:2] == (30, 30)
    assert share(run) == 41.25
    bits = trace_bits(model, simulate(model, 3).record)
    assert next((a // US, b // US) for a, b in bits[4]) == (1300, 2650)


def test_s2_pending_activations_starve_the_driver() -> None:
    """S2 with one remembered activation: MMI_DRIVER never runs."""
    model, _ = make(EXAMPLE_2, tight(), rules=Rules(overflow="pend"))
    found = [left for _, name, left in suspensions(model, 3) if name == BG]
    assert found == [50, 100, 150]
    assert numbers(simulate(model, 60), MMI)[:2] == (19, 0)


def test_s3_overload_of_the_realtime_thread() -> None:
    """S3: GEO is not suspended and overflows; the external thread is woken twice."""
    model, _ = make(EXAMPLE_1, tight(task_int=2100))
    assert timeline(model, 3) == [
        [(GEO, 0, 2000)],
        [
            (GEO, 2000, 2100),
            (EXT, 2100, 2500),
            (BG, 2500, 3200),
            (MMI, 3200, 3500),
            ("WIN", 3500, 4000),
        ],
        [(GEO, 4000, 6000)],
    ]
    assert suspensions(model, 2) == [
        (1500, BG, 700),
        (1500, MMI, 300),
        (1500, COM, 250),
        (3500, COM, 250),
    ]
    run = simulate(model, 60)
    assert numbers(run, GEO)[0] == 30
    assert share(run) == 12.92
    assert responses(run)[GEO] == 2100
    assert run.windows[0].violated == 30
    assert run.windows[0].culprits[0] == 30


def test_s3_pending_activations_starve_all() -> None:
    """S3 with one remembered activation: GEO takes the whole processor."""
    model, _ = make(EXAMPLE_1, tight(task_int=2100), rules=Rules(overflow="pend"))
    assert timeline(model, 5)[1:] == [[(GEO, 2000 * k, 2000 * k + 2000)] for k in range(1, 5)]


def test_s4_calls_per_cycle() -> None:
    """S4: four calls of task_rnd stretch over three cycles."""
    model, _ = make(S4_LIST, tight(**S4_TIMES))
    rows = timeline(model, 3)
    assert rows[0][2:] == [(BG, 600, 1500), ("WIN", 1500, 2000)]
    assert rows[1][2:] == [(BG, 2600, 3500), ("WIN", 3500, 4000)]
    assert rows[2][2:] == [
        (BG, 4600, 4800),
        (MMI, 4800, 4900),
        (COM, 4900, 5000),
        ("WIN", 5000, 6000),
    ]
    left = [left for _, name, left in suspensions(model, 3) if name == BG]
    assert left == [1100, 200]
    run = simulate(model, 3)
    assert (numbers(run, BG)[0], numbers(run, COM)[0]) == (2, 1)
    assert responses(run)[BG] == 4800


def test_s4b_without_windows_time() -> None:
    """S4b: with windows_time 0 nobody is suspended."""
    model, _ = make(change(S4_LIST, windows_time=0), tight(**S4_TIMES))
    rows = timeline(model, 3)
    assert rows[0][2:] == [(BG, 600, 2000)]
    assert rows[1][2:] == [
        (BG, 2600, 3200),
        (MMI, 3200, 3300),
        (COM, 3300, 3400),
        ("WIN", 3400, 4000),
    ]
    assert rows[2][2:] == [(BG, 4600, 6000)]
    assert suspensions(model, 3) == []


def test_s5_external_thread_in_the_time_of_windows() -> None:
    """S5: an external thread of low priority runs in Windows' time."""
    load = load_text(TIGHT | {"task_rnd": 900, "external_sps": 400}, priority=80)
    model, _ = make(EXAMPLE_1, load)
    assert timeline(model, 1)[0] == [
        (GEO, 0, 400),
        (BG, 400, 1300),
        (MMI, 1300, 1500),
        (EXT, 1500, 1900),
        ("WIN", 1900, 2000),
    ]
    windows = simulate(model, 1).windows[0]
    assert (windows.violated, windows.culprits) == (1, (0, 0, 0, 0, 1))


def test_s6_realtime_thread_in_the_time_of_windows() -> None:
    """S6: GEO and the external thread leave 100 µs in each cycle; all others starve."""
    model, _ = make(EXAMPLE_1, tight(task_int=1700))
    for row in timeline(model, 60):
        assert [name for name, _, _ in row] == [GEO, EXT, "WIN"]
    run = simulate(model, 60)
    assert (run.windows[0].minimum, run.windows[0].maximum) == (100 * US, 100 * US)
    assert [numbers(run, name)[:2] for name in (BG, MMI, COM)] == [(59, 0), (19, 0), (29, 0)]


def asynchronous(period: int, phase: int, mode: str = "ticks") -> Model:
    """The load of S4 with its own interrupt."""
    load = load_text(TIGHT | S4_TIMES, extra=f"[interrupt]\nperiod = {period}\nphase = {phase}\n")
    suspension = "ticks" if mode == "ticks" else "elapsed"
    rules = Rules(suspension=suspension)
    return make(S4_LIST, load, convention="field", rules=rules)[0]


@pytest.mark.parametrize(("mode", "at", "windows"), [("ticks", 1500, 630), ("elapsed", 2000, 130)])
def test_s7_external_interrupt(mode: str, at: int, windows: int) -> None:
    """S7: timer and NC interrupt do not fall together; counted ticks keep the guarantee."""
    model = asynchronous(2000, 130, mode)
    assert suspensions(model, 1)[0][0] == at
    assert simulate(model, 1).windows[0].total == windows * US


def test_s8_drift() -> None:
    """S8: over a drifting interrupt the suspension varies by one time_slice."""
    for mode, low, high, minimum in (("ticks", 1001, 1500, 503), ("elapsed", 1500, 1999, 4)):
        model = asynchronous(2003, 137, mode)
        run = simulate(model, 2000, record=2000)
        starts = {
            one.value: one.time for one in run.record.events if one.kind is EventKind.INTERRUPT
        }
        offsets = []
        for one in run.record.events:
            if one.kind is EventKind.SUSPEND:
                cycle = (one.time - 137 * US) // (2003 * US)
                begin = starts[cycle]
                offsets.append((one.time - begin) // US)
        assert (min(offsets), max(offsets)) == (low, high)
        assert run.windows[0].minimum == minimum * US


@pytest.mark.parametrize(("period", "minimum"), [(1997, 497), (1600, 137)])
def test_short_interrupts_break_the_guarantee(period: int, minimum: int) -> None:
    """Interrupts that come early leave Windows less than windows_time."""
    run = simulate(asynchronous(period, 137), 2000)
    assert run.windows[0].minimum == minimum * US


@pytest.mark.parametrize(("period", "cycles"), [(1400, 1334), (1200, 600)])
def test_very_short_interrupts_prevent_suspensions(period: int, cycles: int) -> None:
    """Cycles that end before their point of suspension suspend nothing."""
    run = simulate(asynchronous(period, 137), 2000)
    assert run.suspended_cycles == cycles
    assert run.missed_suspensions > 0


def test_s9_two_processors() -> None:
    """S9: GEO on its own processor."""
    text = with_line(EXAMPLE_1, "thread[0].cpu 2")
    load = load_text(
        TIGHT | {"task_int": 1200, "task_rnd": 900}, extra="[machine]\nwindows_cpus = [1]\n"
    )
    model, found = make(text, load)
    assert found == []
    assert timeline(model, 3) == [
        [(EXT, 0, 200), (BG, 200, 1100), (MMI, 1100, 1400), (COM, 1400, 1500), ("WIN", 1500, 2000)],
        [(EXT, 2000, 2200), (BG, 2200, 3100), (COM, 3100, 3250), ("WIN", 3250, 4000)],
        [(EXT, 4000, 4200), (BG, 4200, 5100), (COM, 5100, 5350), ("WIN", 5350, 6000)],
    ]
    assert suspensions(model, 3) == [(1500, COM, 150)]
    assert timeline(model, 1, cpu=2)[0][0] == (GEO, 0, 1200)


VXWORKS = [f"thread[{i}].priority {10 * i + 10}" for i in range(4)]


def test_s10_priorities_that_count_downwards() -> None:
    """S10: 10, 20, 30, 40 under VxWorks are S1."""
    model, _ = make(with_line(EXAMPLE_1, *VXWORKS), load_text(TIGHT, priority=15), os="vxworks")
    check_s1(model)


def test_s11_the_wrong_operating_system() -> None:
    """S11: the example's numbers under VxWorks turn the order round."""
    model, _ = make(EXAMPLE_1, tight(), os="vxworks")
    row = timeline(model, 1)[0]
    assert [name for name, _, _ in row] == [COM, MMI, BG, EXT, GEO, "WIN"]
    assert row[4] == (GEO, 1450, 1850)
    record = simulate(model, 3).record
    ends = [
        one.value // US
        for one in record.events
        if one.kind is EventKind.END and model.tasks[one.task].name == GEO
    ]
    assert ends == [1850, 1300, 1550]


def test_s12_windows_takes_the_whole_cycle() -> None:
    """S12: windows_time 2000 suspends at once; suspendable threads never run."""
    model, _ = make(change(EXAMPLE_1, windows_time=2000), tight())
    run = simulate(model, 60)
    assert {time % 2000 for time, _, _ in suspensions(model, 6)} == {0}
    assert numbers(run, BG)[:2] == (59, 0)
    assert (run.windows[0].minimum, run.windows[0].maximum) == (1400 * US, 1400 * US)


def test_s13_longer_windows_time() -> None:
    """S13: windows_time 1000 suspends after 1000 µs."""
    model, _ = make(change(EXAMPLE_1, windows_time=1000), tight())
    assert suspensions(model, 1)[0] == (1000, BG, 300)


def test_s14_processor_that_does_not_exist() -> None:
    """S14: 1000180 once per thread; the operating system places the threads."""
    lines = [f"thread[{i}].cpu 2" for i in range(4)]
    load = load_text(TIGHT, extra="[machine]\ncpus = 1\n")
    model, found = make(with_line(EXAMPLE_1, *lines), load)
    assert found == [1000180] * 4
    check_s1(model)


def test_processor_that_is_offline() -> None:
    """P-RTCF-00015: an existing processor that cannot be had is 1000181."""
    load = load_text(TIGHT, extra="[machine]\ncpus = 2\noffline = [2]\n")
    model, found = make(with_line(EXAMPLE_1, "thread[0].cpu 2"), load)
    assert found == [1000181]
    check_s1(model)


@pytest.mark.parametrize(
    ("text", "times"),
    [
        (EXAMPLE_1, NOMINAL),
        (EXAMPLE_2, NOMINAL),
        (EXAMPLE_1, TIGHT),
        (EXAMPLE_2, TIGHT),
        (EXAMPLE_1, TIGHT | {"task_int": 2100}),
        (S4_LIST, TIGHT | S4_TIMES),
        (EXAMPLE_1, TIGHT | {"task_int": 1700}),
        (change(EXAMPLE_1, windows_time=2000), TIGHT),
        (change(EXAMPLE_1, windows_time=1000), TIGHT),
    ],
)
@pytest.mark.parametrize("suspension", ["ticks", "elapsed"])
def test_external_interrupt_of_the_same_period(
    text: str, times: dict[str, int], suspension: str
) -> None:
    """S0 to S6, S12, S13: an undisturbed external interrupt gives the timer's schedule."""
    rules = Rules(suspension="ticks" if suspension == "ticks" else "elapsed")
    timer, _ = make(text, load_text(times), rules=rules)
    hardware, _ = make(text, load_text(times), convention="field", rules=rules)
    assert timer.source is not hardware.source
    assert timeline(timer, 12) == timeline(hardware, 12)
    assert simulate(timer, 60).tasks == simulate(hardware, 60).tasks
