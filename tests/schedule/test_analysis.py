# SPDX-License-Identifier: MIT
"""Response times in closed form: the worked ones, against the simulation, and the margins."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import assume, given, settings
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
from support.schedule_models import models

from nctakt.schedule.analysis.analyse import Analysis, analyse
from nctakt.schedule.analysis.findings import analysis_findings, simulation_findings
from nctakt.schedule.analysis.margins import find_margins, with_cycle, with_time, with_windows
from nctakt.schedule.analysis.self_check import contradictions
from nctakt.schedule.model import Execution, Model, Rules
from nctakt.schedule.simulation.simulate import hyperperiod, simulate

pytestmark = pytest.mark.slow

US = 1000


def responses(analysis: Analysis) -> list[int | None]:
    """In µs."""
    return [None if one.response is None else one.response // US for one in analysis.tasks]


def test_worked_responses() -> None:
    """B4: S1 and S0a as worked out; S1 predicts the overflow of COM."""
    tight = analyse(make(EXAMPLE_1, load_text(TIGHT))[0])
    assert responses(tight) == [400, 1300, 3400, 5450, 600]
    assert [one.can_overflow for one in tight.tasks] == [
        False,
        False,
        False,
        True,
        False,
    ]
    assert tight.cpus[0].demand == pytest.approx(0.7625)
    assert tight.cpus[0].suspendable_supply == 0.75
    nominal = analyse(make(EXAMPLE_1, load_text(NOMINAL))[0])
    assert responses(nominal) == [300, 1050, 1250, 1450, 450]
    assert nominal.is_exact


EXTERNAL_INTERRUPT = """\
interrupt_source 1
cycle_time 2000
time_slice 500
windows_time 500
thread[0].name GEO
thread[0].cycle 2000
thread[0].priority 115
thread[0].error_on_overflow 1
thread[0].function[0].name task_int
thread[1].name BG
thread[1].cycle {cycle}
thread[1].priority 105
thread[1].function[0].name task_rnd
external_thread[0].semaphore_name plc
external_thread[0].cycle 2000
End
"""


def behind(cycle: int, load: str, rules: Rules | None = None) -> tuple[Analysis, list[int | None]]:
    """The analysis of a list with an external interrupt; the longest simulated responses, in µs."""
    model, _ = make(EXTERNAL_INTERRUPT.format(cycle=cycle), load, rules=rules)
    analysis, run = analyse(model), simulate(model, 500)
    assert contradictions(analysis, run) == []
    longest = [one.response_max for one in run.tasks]
    return analysis, [None if one is None else one // US for one in longest]


PLC_BELOW = """\
[functions]
task_int = {geo}
task_rnd = {bg}
[external.plc]
time = {plc}
priority = 90
[interrupt]
{interrupt}
"""


def test_external_thread_after_a_suspended_one() -> None:
    """The PLC runs in Windows' time, and what was suspended goes on before it in the next cycle."""
    load = PLC_BELOW.format(geo=100, bg=1600, plc=700, interrupt="phase = 1")
    analysis, simulated = behind(6000, load)
    assert (responses(analysis)[2], simulated[2]) == (2500, 2500)
    assert analysis.tasks[2].can_overflow


def test_external_thread_after_one_that_is_suspended_late() -> None:
    """By elapsed time suspension can come a time slice later: the PLC waits longer."""
    load = PLC_BELOW.format(geo=100, bg=1900, plc=300, interrupt="phase = 1")
    ticks, _ = behind(6000, load)
    elapsed, simulated = behind(6000, load, Rules(suspension="elapsed"))
    assert responses(ticks)[2] == 1899
    assert responses(elapsed)[2] == simulated[2] == 2400


@pytest.mark.parametrize(
    ("jitter", "simulated", "bound"), [(1, 2750, 2751), (200, 2949, 3149), (500, 3245, 5349)]
)
def test_more_jitter_never_lowers_a_bound(jitter: int, simulated: int, bound: int) -> None:
    """The NC interrupt that resumes a suspended thread can come late."""
    load = PLC_BELOW.format(geo=300, bg=1150, plc=0, interrupt=f"phase = 0\njitter = {jitter}")
    analysis, longest = behind(4000, load)
    assert (longest[1], responses(analysis)[1]) == (simulated, bound)


def test_worst_phase_where_the_load_names_none() -> None:
    """3.1: an external interrupt does not run synchronously to the timer, whatever is left out."""
    load = PLC_BELOW.format(geo=100, bg=1600, plc=700, interrupt="")
    analysis, simulated = behind(6000, load)
    assert analysis.phases == {1: 499_999, 2: 0}
    assert not analysis.is_exact
    assert (responses(analysis)[1], simulated[1]) == (2799, 2300)


def test_unbounded_response() -> None:
    """B4: in S2 MMI_DRIVER has no bound, though the rule 'skip' lets it finish."""
    model, _ = make(EXAMPLE_2, load_text(TIGHT))
    analysis = analyse(model)
    assert analysis.cpus[0].demand == pytest.approx(0.825)
    assert responses(analysis)[2] is None
    assert simulate(model, 60).tasks[2].response_max is not None


def test_realtime_thread_in_the_time_of_windows_is_found() -> None:
    """B4: S6 reaches into Windows' time; the result is a bound."""
    analysis = analyse(make(EXAMPLE_1, load_text(TIGHT | {"task_int": 1700}))[0])
    assert analysis.cpus[0].reaches_windows
    assert not analysis.is_exact
    assert 900640 in [one.id for one in analysis_findings(analysis)]


def test_bound_where_the_realtime_thread_reaches_into_the_time_of_windows() -> None:
    """B4: GEO every second cycle 1600, BG every second 50: 2150 against 2050 simulated."""
    text = EXAMPLE_1.replace("thread[0].cycle 2000", "thread[0].cycle 4000").replace(
        "thread[1].cycle 2000", "thread[1].cycle 4000"
    )
    short = {"task_mmi_driver": 0, "task_com": 0, "external_sps": 0}
    model, _ = make(text, load_text({"task_int": 1600, "task_rnd": 50} | short))
    assert responses(analyse(model))[1] == 2150
    assert simulate(model, 4).tasks[1].response_max == 2050 * US


@pytest.mark.nightly
@pytest.mark.slow
@given(models(ties=False, synchronous=True, load=4))
@settings(max_examples=400, deadline=None)
def test_analysis_is_the_simulation_where_it_says_so(model: Model) -> None:
    """B4: an exact analysis gives the longest responses of the simulation."""
    analysis = analyse(model)
    assume(analysis.is_exact)
    run = simulate(model, 2 * hyperperiod(model))
    for one, numbers in zip(analysis.tasks, run.tasks, strict=True):
        assert one.response == numbers.response_max
        assert numbers.overflows == 0


@pytest.mark.nightly
@pytest.mark.slow
@given(models(load=4))
@settings(max_examples=400, deadline=None)
def test_analysis_is_a_bound_everywhere(model: Model) -> None:
    """B4: a task that cannot overflow by the analysis never does, nor margins later."""
    analysis = analyse(model)
    assume(not analysis.can_overflow)
    run = simulate(model, 60)
    for one, numbers in zip(analysis.tasks, run.tasks, strict=True):
        assert one.response is not None
        assert numbers.overflows == 0
        assert (numbers.response_max or 0) <= one.response


@given(models(ties=False, synchronous=True, load=3))
@settings(max_examples=60, deadline=None)
def test_longest_execution_times_are_the_last_that_fit(model: Model) -> None:
    """The answer fits, one microsecond more does not."""
    thousand = replace(
        model,
        cycle=model.cycle * US,
        slice=model.slice * US,
        windows=model.windows * US,
        train=replace(model.train, period=model.train.period * US, phase=0),
        tasks=tuple(
            replace(
                task,
                calls=(
                    replace(
                        task.calls[0], execution=Execution((task.calls[0].execution.longest * US,))
                    ),
                ),
            )
            for task in model.tasks
        ),
    )
    for i, one in enumerate(find_margins(thousand).functions):
        cpu = thousand.tasks[i].cpu
        if one.limit is not None:
            assert not overflows_on(with_time(thousand, one.function, one.limit), cpu)
            assert overflows_on(with_time(thousand, one.function, one.limit + US), cpu)
        else:
            assert overflows_on(with_time(thousand, one.function, 0), cpu)


def overflows_on(model: Model, cpu: int) -> bool:
    """Whether anything can overflow on a processor."""
    tasks = zip(model.tasks, analyse(model).tasks, strict=True)
    return any(found.can_overflow for task, found in tasks if task.cpu == cpu)


def test_margins_of_the_example() -> None:
    """The limits of S0a, each confirmed by the simulation."""
    model, _ = make(EXAMPLE_1, load_text(NOMINAL))
    margins = find_margins(model)
    limits = {one.function: one.limit for one in margins.functions}
    assert limits["task_rnd"] == 850 * US

    def overflows(changed: Model) -> int:
        return sum(one.overflows for one in simulate(changed, 120).tasks)

    for function, longest in limits.items():
        assert longest is not None
        assert overflows(with_time(model, function, longest)) == 0
        assert overflows(with_time(model, function, longest + US)) > 0
    assert margins.windows_time == 500 * US
    assert overflows(with_windows(model, 500 * US)) == 0
    assert overflows(with_windows(model, 1000 * US)) > 0
    assert margins.cycle_time == 2000 * US
    assert overflows(with_cycle(model, 1500 * US)) > 0


def test_no_answer_where_everything_overflows() -> None:
    """An overloaded realtime thread overflows with any windows_time."""
    model, _ = make(EXAMPLE_1, load_text(TIGHT | {"task_int": 2100}))
    margins = find_margins(model)
    assert margins.windows_time is None
    assert margins.cycle_time is not None and margins.cycle_time > 2000 * US
    other = next(one for one in margins.functions if one.function == "task_com")
    assert other.limit is None


def test_limits_belong_to_a_processor() -> None:
    """A function's limit does not depend on what overflows on another processor."""
    text = with_line(EXAMPLE_1, "thread[1].cpu 2", "thread[2].cpu 2", "thread[3].cpu 2")
    model, _ = make(text, load_text(TIGHT | {"task_int": 2100}))
    margins = find_margins(model)
    changes = {one.function: one.change for one in margins.functions}
    assert changes["task_com"] == 1050 * US
    assert changes["task_int"] == -300 * US
    assert changes["external_sps"] is None
    assert [(one.cpu, one.factor) for one in margins.factors] == [(1, 0.869)]


def test_how_much_less_would_do() -> None:
    """Where something overflows a limit lies below the present time."""
    margins = find_margins(make(EXAMPLE_1, load_text(TIGHT))[0])
    changes = {one.function: one.change for one in margins.functions}
    assert changes["task_com"] == -150 * US
    assert [(one.cpu, one.factor) for one in margins.factors] == [(1, 0.952)]
    assert margins.windows_time == 0


def test_list_of_times_counts_with_its_worst_neighbours() -> None:
    """100, 200, 300 in turn: two jobs take 500 at most, not 600."""
    load = load_text(NOMINAL).replace("task_rnd = 600", "task_rnd = [300, 500, 900]")
    analysis = analyse(make(EXAMPLE_1, load)[0])
    assert analysis.cpus[0].demand == pytest.approx(
        (300 + 1700 / 3 + 200 / 3 + 200 / 2 + 150) / 2000
    )
    assert responses(analysis)[3] == 2 * (300 + 150) + 500 + 900 + 200 + 200 + 500


def test_windows_off_and_late_threads() -> None:
    """F5: windows_time 0 is not sensible when a thread needs longer than a cycle (S4b)."""
    text = change(EXAMPLE_1, windows_time=0)
    model, _ = make(text, load_text(TIGHT | {"task_rnd": 1500}))
    assert 900633 in [one.id for one in simulation_findings(simulate(model, 6))]
    assert 900633 in [one.id for one in analysis_findings(analyse(model))]
    model, _ = make(text, load_text(NOMINAL))
    assert list(simulation_findings(simulate(model, 6))) == []
    exactly_full = load_text(NOMINAL | {"task_com": 750})
    found = list(simulation_findings(simulate(make(text, exactly_full)[0], 6)))
    assert [one.id for one in found] == [900633]
    assert "no time" in found[0].text("en")


def test_findings_of_simulations() -> None:
    """Overflows that are to be reported, broken guarantees with who broke them."""
    model, _ = make(EXAMPLE_1, load_text(TIGHT | {"task_int": 2100}))
    found = list(simulation_findings(simulate(model, 60)))
    assert [one.id for one in found] == [900630, 900632]
    assert (found[0].values["count"], found[0].values["time"]) == (30, "2000")
    assert found[1].values["who"] == "GEO 30"
    short = load_text(TIGHT, extra="[interrupt]\nperiod = 1200\n")
    model, _ = make(EXAMPLE_1, short, convention="field")
    numbers = [one.id for one in simulation_findings(simulate(model, 60))]
    assert 900631 in numbers
