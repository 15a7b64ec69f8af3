# SPDX-License-Identifier: MIT
"""From the values of rtconf.lis to the effective scheduling."""

from __future__ import annotations

import pytest

from nctakt.lists.declared.rtconf import InterruptSource, RtconfConfiguration
from nctakt.lists.machine.schedules.scheduling import load_rtconf
from nctakt.messages import Collector

GEO = """\
thread[0].name GEO
thread[0].cycle {cycle}
thread[0].priority 115
thread[0].error_on_overflow 1
thread[0].function[0].name task_int
"""


#: The convention of interrupt_source and missing priorities have their own tests.
ELSEWHERE = (900600, 900604)


def load(text: str) -> tuple[RtconfConfiguration, list[int]]:
    """The configuration of a list, and what was found."""
    collector = Collector()
    configuration = load_rtconf("rtconf.lis", f"{text}\nEnd\n".encode(), collector)
    for found in collector.diagnostics:
        assert found.render("en") and found.render("de")
    numbers = [found.id for found in collector.diagnostics]
    return configuration, [number for number in numbers if number not in ELSEWHERE]


def with_times(
    cycle: object, slice_: object, windows: object, thread_cycle: object = 1
) -> tuple[RtconfConfiguration, list[int]]:
    """A list with one realtime thread and these times; an empty one is left out."""
    lines = ["interrupt_source 2"]
    for key, value in (("cycle_time", cycle), ("time_slice", slice_), ("windows_time", windows)):
        if value != "":
            lines.append(f"{key} {value}")
    return load("\n".join(lines) + "\n" + GEO.format(cycle=thread_cycle))


ROUND_THREAD = 900035


@pytest.mark.parametrize(
    ("cycle", "effective", "numbers"),
    [
        (1750, 2000, [1000153]),
        (2000, 2000, []),
        (2001, 2500, [1000153]),
        (300, 500, [900032, 1000153]),
        (1499, 1500, [900033, 1000153]),
        (1500, 1500, []),
        (10000, 10000, []),
        (10001, 10500, [900034, 1000153]),
    ],
)
def test_cycle_time_goes_up_to_a_multiple_of_time_slice(
    cycle: int, effective: int, numbers: list[int]
) -> None:
    """cycle_time is rounded up; the ratio to time_slice is judged before that."""
    configuration, found = with_times(cycle, 500, 500)
    assert configuration.cycle_time_us == effective
    assert configuration.time_slice_us == 500
    ignored = {ROUND_THREAD, 900038}
    assert [number for number in found if number not in ignored] == numbers


@pytest.mark.parametrize(
    ("windows", "effective", "numbers"),
    [
        (999, 500, [900035]),
        (1000, 1000, [900040]),
        (500, 500, []),
        (499, 500, [900036]),
        (1, 500, [900036]),
        (65535, 500, [1023, 900031]),
        ("", 500, [900031]),
        ("x", 500, [2022, 900031]),
        (0, 0, [900037]),
        (2000, 2000, [900038, 900040]),
        (65534, 2000, [900035, 900038, 900040]),
    ],
)
def test_windows_time_goes_down_to_a_multiple_of_time_slice(
    windows: object, effective: int, numbers: list[int]
) -> None:
    """windows_time is rounded down, at most cycle_time; 0 is off, less than time_slice an error."""
    configuration, found = with_times(2000, 500, windows, 2000)
    assert configuration.windows_time_us == effective
    assert found == numbers


def test_short_windows_time_is_a_warning() -> None:
    """200 µs and less are unfavourable."""
    assert with_times(1000, 200, 200, 1000)[1] == [900039]
    assert with_times(1005, 201, 201, 1005)[1] == []


@pytest.mark.parametrize(
    ("cycle", "effective", "numbers"),
    [
        (1750, 2000, [900035]),
        (3000, 4000, [900035]),
        (6000, 6000, []),
        (0, 2000, [900044]),
        (4294967295, 2000, [900052]),
    ],
)
def test_thread_cycles_go_up_to_a_multiple_of_the_nc_cycle(
    cycle: int, effective: int, numbers: list[int]
) -> None:
    """A thread's cycle is a multiple of the effective NC cycle; 0 is every cycle."""
    configuration, found = with_times(2000, 500, 500, cycle)
    assert configuration.threads[0].cycle_us == effective
    assert found == numbers


def test_thread_cycles_use_the_rounded_nc_cycle() -> None:
    """The NC cycle is rounded first, then the threads."""
    configuration, _ = with_times(1750, 500, 500, 1750)
    assert configuration.threads[0].cycle_us == 2000


def test_missing_times_are_errors_with_the_manuals_example_values() -> None:
    """What has no printed default is an error and gets 2000, 500 and time_slice."""
    configuration, found = load("interrupt_source 2\n" + GEO.format(cycle=2000))
    times = (
        configuration.cycle_time_us,
        configuration.time_slice_us,
        configuration.windows_time_us,
    )
    assert times == (2000, 500, 500)
    assert found == [900031, 900031, 900031]


def test_fallback_of_time_slice_is_never_above_cycle_time() -> None:
    """A cycle of 300 µs without time_slice gets a time_slice of 300."""
    configuration, _ = with_times(300, "", 300, 300)
    assert (configuration.cycle_time_us, configuration.time_slice_us) == (300, 300)


def test_rounding_beyond_the_type_is_an_error() -> None:
    """A cycle that would leave UNS32 by rounding falls back."""
    configuration, found = with_times(4294967294, 4294967293, 0, 0)
    assert 900052 in found
    assert configuration.cycle_time_us == 4294967293


@pytest.mark.parametrize(
    ("text", "source", "numbers"),
    [
        ("interrupt_source 1", InterruptSource.HARDWARE, []),
        ("interrupt_source 2", InterruptSource.TIMER, []),
        ("interrupt_source 3\nexternal_object_name s", InterruptSource.SEMAPHORE, []),
        ("interrupt_source 3", InterruptSource.SEMAPHORE, [900041]),
        ("interrupt_source 4", InterruptSource.OUTSIDE, [900618]),
        ("interrupt_source 2\nexternal_object_name s", InterruptSource.TIMER, [900042]),
        ("", InterruptSource.TIMER, [900030]),
        ("interrupt_source 0", InterruptSource.TIMER, [1024, 900030]),
        ("interrupt_source 5", InterruptSource.TIMER, [1023, 900030]),
    ],
)
def test_interrupt_source(text: str, source: InterruptSource, numbers: list[int]) -> None:
    """Without a valid source the timer is taken, with an error."""
    times = "\ncycle_time 2000\ntime_slice 500\nwindows_time 500\n" + GEO.format(cycle=2000)
    configuration, found = load(text + times)
    assert (configuration.interrupt_source, found) == (source, numbers)


def test_object_name_counts_for_a_semaphore_only() -> None:
    """The name of a semaphore that starts nothing is dropped."""
    assert load("interrupt_source 3\nexternal_object_name s\n")[0].external_object_name == "s"
    assert load("interrupt_source 2\nexternal_object_name s\n")[0].external_object_name == ""


BASE = "interrupt_source 2\ncycle_time 2000\ntime_slice 500\nwindows_time 500\n" + GEO.format(
    cycle=2000
)


@pytest.mark.parametrize(
    ("text", "numbers"),
    [
        ("thread[0].function[0].name task_rnd", [260102, 900023]),
        ("thread[1].name A\nthread[1].cycle 2000", [900053]),
        ("thread[2].name A\nthread[2].cycle 2000\nthread[2].function[0].name task_rnd", [900050]),
        (
            "thread[1].name GEO\nthread[1].cycle 2000\nthread[1].function[0].name task_rnd",
            [900047],
        ),
        ("thread[1].cycle 2000\nthread[1].function[0].name task_rnd", [900045]),
        ("thread[1].name A\nthread[1].cycle 2000\nthread[1].function[0].name my_task", [900048]),
        ("thread[0].function[1].trace_bit 1", [900045]),
        ("thread[0].function[0].calls_per_cycle 2", [900054]),
        (
            "thread[0].function[0].trace_bit 1\n"
            "thread[0].function[1].name task_com\nthread[0].function[1].trace_bit 1",
            [900049],
        ),
        ("thread[0].error_on_overflow 0", [900023, 900057]),
        ("external_thread[0].cycle 2000", [900055]),
        ("external_thread[0].semaphore_name s", [900044]),
        (
            "external_thread[0].semaphore_name s\nexternal_thread[0].cycle 2000\n"
            "external_thread[1].semaphore_name s\nexternal_thread[1].cycle 2000",
            [900047],
        ),
        ("thread[0].cpu 8", [1000180]),
        ("thread[0].function[0].trace_bit 8", [1023]),
    ],
)
def test_threads_are_plausible(text: str, numbers: list[int]) -> None:
    """Names, functions, trace bits, gaps and the realtime thread are looked at."""
    assert load(BASE)[1] == []
    assert sorted(load(BASE + text)[1]) == numbers


def test_external_thread_without_semaphore_is_left_out() -> None:
    """An external thread that nobody can wake does not exist."""
    assert load(BASE + "external_thread[0].cycle 2000")[0].external_threads == ()


EXAMPLE = """\
# RTX: 127 is highest
interrupt_source 2 # one of three
cycle_time 2000 # µs
time_slice 500
windows_time 500 # 0: off
#
thread[0].name GEO
thread[0].cycle 2000
thread[0].priority 115 # highest
thread[0].error_on_overflow 1
thread[0].function[0].name task_int
thread[0].function[0].calls_per_cycle 1
thread[0].function[0].trace_bit 1
thread[0].context_info 1
#
thread[1].name MMI_DRIVER
thread[1].cycle 6000
thread[1].priority 95
thread[1].cpu 2
thread[1].function[0].name task_mmi_driver
#
external_thread[0].semaphore_name plc
external_thread[0].cycle 2000
"""


def test_a_complete_list_has_no_findings() -> None:
    """A list as the manual shows it is taken as it is."""
    configuration, found = load(EXAMPLE)
    assert found == []
    geo, driver = configuration.threads
    assert (geo.name, geo.priority, geo.cpu, geo.context) == ("GEO", 115, 1, 1)
    assert [(one.name, one.trace_bit) for one in geo.functions] == [("task_int", 1)]
    assert (driver.cycle_us, driver.cpu, driver.error_on_overflow) == (6000, 2, False)
    assert [one.semaphore_name for one in configuration.external_threads] == ["plc"]
    assert configuration.schedule == "STANDARD"
