# SPDX-License-Identifier: MIT
"""Which NC cycles pictures and traces show, and records that begin later than the simulation."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import pytest
from support.random_models import random_model
from support.schedule_examples import EXAMPLE_1, TIGHT, load_text, make

from nctakt.cli import main
from nctakt.schedule.model import Model
from nctakt.schedule.pictures.drawn_cycles import (
    MAX_DRAWN,
    first_overflow,
    shown_cycles,
    shown_together,
    simulate_shown,
)
from nctakt.schedule.simulation.interpolation_steps import parts_of
from nctakt.schedule.simulation.results import EventKind, Simulation
from nctakt.schedule.simulation.simulate import simulate
from nctakt.schedule.simulation.tracebits import Ran, calls_of

LIST = """\
cycle_time 2000
time_slice 500
windows_time 500
interrupt_source 1 # 1: internal timer, 2: IRQ
thread[0].name GEO
thread[0].cycle 2000
thread[0].priority 115
thread[0].error_on_overflow 1
thread[0].function[0].name task_int
thread[0].function[0].calls_per_cycle 1
thread[0].function[0].trace_bit 1
thread[1].name SDA
thread[1].cycle 2000
thread[1].priority 105
thread[1].error_on_overflow 1
thread[1].function[0].name task_rnd
thread[1].function[0].calls_per_cycle 1
thread[1].function[0].trace_bit 2
End
"""


def model_of(times: Sequence[int]) -> Model:
    """GEO takes 500 µs of each 2000; SDA these times, of which 1000 µs fit beside Windows' 500."""
    load = f"[functions]\ntask_int = 500\ntask_rnd = {list(times)}\n"
    return make(LIST, load)[0]


def interrupts(run: Simulation) -> list[int]:
    """The numbers of the recorded NC cycles."""
    return [event.value for event in run.record.events if event.kind is EventKind.INTERRUPT]


def overflows(run: Simulation) -> int:
    """How many overflows are recorded."""
    return sum(event.kind is EventKind.OVERFLOW for event in run.record.events)


def test_an_overflow_of_each_second_cycle_is_shown() -> None:
    """SDA needs 1600 µs: it ends in its second cycle, whose activation finds it busy."""
    run = simulate_shown(model_of([1600]), 500)
    assert (run.tasks[1].overflows, run.repeats_after) == (250, 2)
    assert interrupts(run)[:2] == [0, 1] and len(interrupts(run)) <= MAX_DRAWN
    assert overflows(run) >= 1


def test_a_late_overflow_is_shown_with_the_cycles_around_it() -> None:
    """The 170th job, of cycle 169, is the first that is too long; cycle 170 finds SDA busy."""
    run = simulate_shown(model_of([600] * 169 + [1600] + [600] * 30), 500)
    assert run.repeats_after is not None and run.repeats_after > MAX_DRAWN
    assert first_overflow(run) == 170
    assert interrupts(run) == list(range(162, 178))
    assert overflows(run) == 1


def test_without_overflow_the_repetition_is_shown() -> None:
    """Three times in turn: the schedule comes back to its state after 3 cycles."""
    run = simulate_shown(model_of([500, 600, 700]), 500)
    assert (run.repeats_from, run.repeats_after) == (0, 3)
    assert interrupts(run) == [0, 1, 2]


def test_nothing_is_recorded_beyond_the_end() -> None:
    """A simulation of one cycle shows that one."""
    assert interrupts(simulate_shown(model_of([1600]), 1)) == [0]


def test_two_lists_are_shown_over_the_same_cycles() -> None:
    """Those of the one that overflows where the other one repeats at once."""
    easy, late = (
        simulate(model_of(times), 500, record=0)
        for times in ([600], [600] * 169 + [1600] + [600] * 30)
    )
    assert shown_together([easy, late]) == shown_cycles(late) == range(162, 178)
    often = simulate(model_of([1600]), 500, record=0)
    assert shown_together([easy, often]) == shown_cycles(often)


def ran_from(calls: Sequence[Ran], begin: int) -> list[Ran]:
    """What is left of calls that take time, from a time on."""
    found = [
        Ran(one.task, one.job, one.call, max(one.begin, begin), one.end)
        for one in calls
        if one.end is None or one.end > max(begin, one.begin)
    ]
    return sorted(found, key=lambda one: (one.task, one.job, one.call))


@pytest.mark.parametrize("seed", range(12))
def test_a_later_record_is_a_part_of_the_whole_one(seed: int) -> None:
    """Pieces, events, calls and parts from a cycle on are the same, jobs that go on included."""
    model = random_model(seed) if seed else make(EXAMPLE_1, load_text(TIGHT))[0]
    whole = simulate(model, 30, record=30)
    part = simulate(model, 30, record=range(11, 30))
    assert part.tasks == whole.tasks
    begin = part.record.begin
    assert interrupts(part) == list(range(11, 30))
    events = [one for one in whole.record.events if one.time >= begin]
    resumed = [one for one in events if one.time > begin or one.kind is not EventKind.RESUME]
    ended = [one for one in resumed if one.time > begin or one.kind is not EventKind.END]
    assert list(part.record.events) == ended
    assert list(part.record.segments) == [
        one if one.begin >= begin else replace(one, begin=begin, overhead=0)
        for one in whole.record.segments
        if one.end > begin or one.begin >= begin
    ]
    calls = ran_from(calls_of(model, part.record), begin)
    assert calls == ran_from(calls_of(model, whole.record), begin)
    assert parts_of(model, part.record) == [
        replace(one, begin=max(one.begin, begin))
        for one in parts_of(model, whole.record)
        if one.end > begin
    ]


@pytest.mark.parametrize("command", ["simulate", "compare"])
def test_the_picture_has_the_overflow(command: str, tmp_path: Path) -> None:
    """Without ``--drawn`` the picture names the cycles and has the sign."""
    rtconf, load = tmp_path / "rtconf.lis", tmp_path / "load.toml"
    rtconf.write_text(LIST, "utf-8")
    load.write_text("[functions]\ntask_int = 500\ntask_rnd = 1600\n", "utf-8")
    lists = [str(rtconf)] * (1 if command == "simulate" else 2)
    words = ["--load", str(load), "--plot", str(tmp_path / "a.svg"), "--quiet"]
    main(["schedule", command, *lists, *words])
    picture = (tmp_path / "a.svg").read_text("utf-8")
    assert "NC cycles 0 … 2" in picture
    assert "SDA: 2000 µs, 600 µs" in picture
