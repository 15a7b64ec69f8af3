# SPDX-License-Identifier: MIT
"""rtconf.lis under an operating system: what interrupt_source means, priorities, choices."""

from __future__ import annotations

import pytest

from nctakt.base.diagnostics import Severity
from nctakt.lists.declared.rtconf import InterruptSource, RtconfConfiguration
from nctakt.lists.machine.schedules.scheduling import load_rtconf
from nctakt.lists.machine.schedules.scheduling_checks import check_contexts
from nctakt.lists.machine.schedules.scheduling_profile import PROFILES, RtconfOptions
from nctakt.lists.machine.schedules.scheduling_source import read_source
from nctakt.messages import Collector

HARDWARE, TIMER = InterruptSource.HARDWARE, InterruptSource.TIMER
SEMAPHORE = InterruptSource.SEMAPHORE
BASE = """\
interrupt_source 3
external_object_name s
cycle_time 2000
time_slice 500
windows_time 500
thread[0].name GEO
thread[0].cycle 2000
thread[0].priority 115
thread[0].error_on_overflow 1
thread[0].function[0].name task_int
"""


def load(text: str, options: RtconfOptions | None = None) -> tuple[RtconfConfiguration, list[int]]:
    """The configuration of a list, and what was found."""
    configuration, collector = collect(text, options)
    return configuration, [found.id for found in collector.diagnostics]


def collect(
    text: str, options: RtconfOptions | None = None
) -> tuple[RtconfConfiguration, Collector]:
    """The configuration of a list, and the findings."""
    collector = Collector()
    data = f"{text}\nEnd\n".encode()
    configuration = load_rtconf("rtconf.lis", data, collector, options or RtconfOptions())
    for found in collector.diagnostics:
        assert found.render("en") and found.render("de")
    return configuration, collector


def system(name: str) -> RtconfOptions:
    """The options of an operating system."""
    return RtconfOptions(profile=PROFILES[name])


@pytest.mark.parametrize(
    ("number", "comment", "convention", "source"),
    [
        (2, "# 1: internal timer, 2: IRQ, 3: Semaphore", "field", HARDWARE),
        (2, "# 1: internal Timer, 2: IRQ, 3: Semaphore", "field", HARDWARE),
        (1, "# 1: internal timer, 2: IRQ, 3: Semaphore", "field", TIMER),
        (2, "# 1 == internal timer, 2 == external", "field", HARDWARE),
        (2, "# 1 == internal Timer, 2 == external", "field", HARDWARE),
        (
            3,
            "# 1 == internal Timer, 2 == external IRQ, 3 == external Semaphore, "
            "4 == external Scheduling",
            "field",
            SEMAPHORE,
        ),
        (2, "# 1: Hardware ISR 2: Real-time operating system timer", "table", TIMER),
        (1, "# 1: Hardware ISR 2: Real-time operating system timer", "table", HARDWARE),
        (2, "", "table", TIMER),
        (2, "# SERCOS", "field", HARDWARE),
        (1, "# SERCOS", "table", HARDWARE),
        (1, "# Timer", "field", TIMER),
        (2, "(timer)", "table", TIMER),
        (2, "# internal timer", "table", TIMER),
        (1, "# no timer", "table", HARDWARE),
        (2, "# Semaphore", "table", TIMER),
        (2, "# see the drawing of the timer", "table", TIMER),
        (2, "# 1 = timer, 2 = timer", "table", TIMER),
        (2, "# since 2 ms cycle", "table", TIMER),
        (2, "( 1) intern; 2) extern )", "field", HARDWARE),
        (2, "/* 1-timer | 2-hw */", "field", HARDWARE),
        (2, "# 2: not the timer", "table", TIMER),
        (2, "# 2: kein Timer", "table", TIMER),
        (2, "# 1: external timer, 2: irq", "table", TIMER),
        (2, "# 1: timer, 2: irq, 3: timer", "table", TIMER),
        (1, "# 1 timer 1 irq", "table", HARDWARE),
        (1, "# 0.2 irq", "table", HARDWARE),
        (1, "# 2ms irq", "table", HARDWARE),
        (1, "# 2: isr", "field", TIMER),
    ],
)
def test_comment_explains_the_numbers(
    number: int, comment: str, convention: str, source: InterruptSource
) -> None:
    """E1: a comment that explains 1 and 2 is believed, else the manual's table counts."""
    reading = read_source(number, comment, "auto")
    assert (reading.convention, reading.source) == (convention, source)


def test_convention_can_be_chosen() -> None:
    """E1: 'table' and 'field' are taken whatever the comment says."""
    comment = "# 1: internal timer, 2: IRQ"
    assert read_source(2, comment, "table").source is TIMER
    assert read_source(2, "", "field").source is HARDWARE
    assert read_source(3, "", "field").source is SEMAPHORE


def test_comment_of_the_line_that_counts() -> None:
    """E1: of several lines the last one, with its own comment."""
    text = "interrupt_source 2 # 1: timer, 2: IRQ\n"
    assert load(text + BASE.split("\n", 2)[2])[0].interrupt_source is HARDWARE
    both = text + "interrupt_source 2\n" + BASE.split("\n", 2)[2]
    configuration, found = load(both)
    assert configuration.interrupt_source is TIMER
    assert 900600 in found


def test_meaning_of_one_and_two_is_always_a_warning() -> None:
    """E1: the warning says meaning, convention and reason; a semaphore needs none."""
    text = BASE.replace("interrupt_source 3", "interrupt_source 2 # the usual one")
    _, collector = collect(text)
    found = next(one for one in collector.diagnostics if one.id == 900600)
    assert "timer" in found.text("en") and "'table'" in found.text("en")
    assert "the usual one" in found.text("de")
    assert load(BASE)[1] == []
    assert 900600 not in load(text, RtconfOptions(convention="table"))[1]


def test_external_scheduling() -> None:
    """Value 4 is in comments of shipped lists: another program calls the tasks."""
    for convention in ("auto", "table", "field"):
        options = RtconfOptions(convention=convention)  # type: ignore[arg-type]
        text = BASE.replace("interrupt_source 3", "interrupt_source 4")
        configuration, found = load(text.replace("external_object_name s\n", ""), options)
        assert (configuration.interrupt_source, found) == (InterruptSource.OUTSIDE, [900618])


THREAD = """\
thread[1].name B
thread[1].cycle 2000
thread[1].function[0].name task_rnd
"""


@pytest.mark.parametrize(
    ("name", "line", "numbers", "priority"),
    [
        ("rtx", "thread[1].priority 105", [], 105),
        ("rtx", "thread[1].priority 0", [], 0),
        ("rtx", "thread[1].priority 128", [900603, 900604], 0),
        ("rtx", "thread[1].priority -1", [900603, 900604], 0),
        ("rtx", "thread[1].priority 115", [900606], 115),
        ("rtx", "", [900604], 0),
        ("vxworks", "thread[1].priority 255", [], 255),
        ("vxworks", "thread[1].priority 256", [900603, 900607, 900614], 0),
        ("vxworks", "thread[1].priority 105", [900607], 105),
        ("intime", "thread[1].priority 200", [], 200),
    ],
)
def test_priorities(name: str, line: str, numbers: list[int], priority: int) -> None:
    """P-RTCF-00010: range and direction are those of the operating system."""
    configuration, found = load(BASE + THREAD + line, system(name))
    assert sorted(set(found) - {900601}) == numbers
    assert configuration.threads[1].priority == priority


@pytest.mark.parametrize(
    ("name", "priority", "numbers"),
    [
        ("rtx", 124, []),
        ("rtx", 125, [900605]),
        ("rtx", 127, [900605]),
        ("intime", 2, [900605]),
        ("intime", 3, []),
        ("linux", 98, []),
        ("linux", 99, [900605]),
        ("vxworks", 0, []),
    ],
)
def test_reserved_priorities(name: str, priority: int, numbers: list[int]) -> None:
    """4.3: some priorities belong to the system; they are kept with a warning."""
    text = BASE.replace("priority 115", f"priority {priority}")
    configuration, found = load(text, system(name))
    assert [number for number in found if number != 900601] == numbers
    assert configuration.threads[0].priority == priority


def test_comments_of_priorities() -> None:
    """Row 13: a comment HIGHEST or LOWEST that is false is a note."""
    low = BASE + THREAD + "thread[1].priority 90 # LOWEST"
    assert load(low)[1] == []
    assert load(low.replace("LOWEST", "HIGHEST"))[1] == [900608]
    assert load(low.replace("priority 115", "priority 80 # highest"))[1] == [900607, 900608, 900608]


def test_time_slice_is_fixed_by_some_systems() -> None:
    """F6: time_slice can be set with RTX and VxWorks only."""
    numbers = {name: load(BASE, system(name))[1] for name in PROFILES}
    assert {name for name in numbers if 900601 in numbers[name]} == {"intime", "linux"}


@pytest.mark.parametrize(
    ("name", "hal", "numbers"), [("rtx", 500, []), ("rtx", 1000, [900609]), ("vxworks", 1, [])]
)
def test_period_of_the_hal_timer(name: str, hal: int, numbers: list[int]) -> None:
    """P-RTCF-00003: with RTX the HAL timer's period has to be time_slice."""
    options = RtconfOptions(profile=PROFILES[name], hal_timer_us=hal)
    assert load(BASE, options)[1] == numbers


def test_small_windows_time_by_choice_off() -> None:
    """Row 6: below time_slice it is an error; rounded down by choice it is off."""
    text = BASE.replace("windows_time 500", "windows_time 499")
    assert load(text)[0].windows_time_us == 500
    configuration, found = load(text, RtconfOptions(small_windows_is_off=True))
    assert (configuration.windows_time_us, found) == (0, [900615])


def test_windows_time_of_lists_for_linux() -> None:
    """Row 20: the whole cycle means nothing there, and the guarantee can be ignored."""
    text = BASE.replace("windows_time 500", "windows_time 2000")
    assert load(text)[0].windows_time_us == 2000
    configuration, found = load(text, system("linux"))
    assert configuration.windows_time_us == 0
    assert 900602 in found
    configuration, found = load(BASE, RtconfOptions(ignore_windows=True))
    assert (configuration.windows_time_us, found) == (0, [900602])


def test_unstable_windows_time() -> None:
    """F5: 100 µs and less can make RTX unstable, others not."""
    text = BASE.replace("time_slice 500", "time_slice 100").replace(
        "windows_time 500", "windows_time 100"
    )
    assert load(text)[1] == [900039, 900613]
    assert load(text.replace("priority 115", "priority 0"), system("vxworks"))[1] == [900039]


@pytest.mark.parametrize(
    ("name", "counts"),
    [("s", True), ("/s", True), ("a/b", False), ("x" * 250, True), ("x" * 251, False)],
)
def test_name_of_the_semaphore(name: str, counts: bool) -> None:
    """F2: at most 250 characters and no '/' inside."""
    configuration, found = load(
        BASE.replace("external_object_name s", f"external_object_name {name}")
    )
    assert (configuration.external_object_name == name) is counts
    assert (900610 in found) is not counts


def test_own_functions_can_be_named() -> None:
    """P-RTCF-00012: functions that the user registers are no finding."""
    text = BASE + "thread[0].function[1].name my_one\nthread[0].function[2].name my_other\n"
    _, collector = collect(text)
    assert [one.id for one in collector.diagnostics] == [900048]
    assert collector.diagnostics[0].values["names"] == "my_one, my_other"
    assert load(text, RtconfOptions(functions=("my_one", "my_other")))[1] == []


def test_misspelt_functions() -> None:
    """A name that is nearly one of the controller's is its own warning, task_tcp is known."""
    text = BASE + "thread[0].function[1].name {}\n"
    _, collector = collect(text.format("task_rmd"))
    assert [one.id for one in collector.diagnostics] == [900616]
    assert collector.diagnostics[0].values["name"] == "task_rnd"
    assert load(text.format("task_tcp"))[1] == []


def test_advice_about_windows_is_for_windows() -> None:
    """Ratio and windows_time are free where there is no Windows beside."""
    text = BASE.replace("cycle_time 2000", "cycle_time 1000").replace("cycle 2000", "cycle 1000")
    text = text.replace("priority 115", "priority 60")
    assert 900033 in load(text)[1]
    assert load(text, system("linux"))[1] == [900601]
    for line, numbers in (("", [900601]), ("windows_time 0", [900601])):
        configuration, found = load(text.replace("windows_time 500", line), system("linux"))
        assert (configuration.windows_time_us, found) == (0, numbers)
    short = text.replace("windows_time 500", "windows_time 100")
    assert load(short, system("linux"))[1] == [900601, 900602]


def test_places_of_missing_entries() -> None:
    """A missing entry is reported where its thread begins, one of the whole list without a line."""
    text = BASE.replace("cycle_time 2000\n", "") + THREAD
    spans = {one.entry: str(one.span) for one in collect(text)[1].diagnostics}
    assert spans["thread[1].priority"] == "rtconf.lis:10:1"
    assert spans["cycle_time"] == "rtconf.lis"


def test_ten_threads_with_ten_functions() -> None:
    """The manual prints seven, larger systems have ten: a note reports it once for each kind."""
    lines = [
        f"thread[{i}].name T{i}\nthread[{i}].cycle 2000\nthread[{i}].priority {100 - i}\n"
        f"thread[{i}].function[0].name task_rnd\n"
        for i in range(1, 10)
    ]
    functions = [f"thread[0].function[{j}].name task_com\n" for j in range(1, 10)]
    configuration, found = load(BASE + "".join(lines + functions))
    assert found == [900617, 900617]
    assert (len(configuration.threads), len(configuration.threads[0].functions)) == (10, 10)
    assert 2009 in load(BASE + "thread[10].name X\n")[1]


def test_lenient_errors_are_warnings() -> None:
    """F1: errors by our choice are warnings on request, those of the manual stay."""
    text = "windows_time 100\ntime_slice 500\n"
    strict = collect(text)[1].diagnostics
    lenient = collect(text, RtconfOptions(lenient=True))[1].diagnostics
    assert [one.id for one in strict] == [one.id for one in lenient]

    def errors(found: list) -> list[int]:  # type: ignore[type-arg]
        return [one.id for one in found if one.severity is Severity.ERROR]

    assert errors(strict) == [900030, 900031, 900612, 900036]
    assert errors(lenient) == [900612, 900036]


def test_empty_list() -> None:
    """An empty list has an error for each missing value, and no thread."""
    configuration, found = load("")
    assert configuration.threads == ()
    assert found == [900030, 900031, 900031, 900612, 900031]


class Channel:
    """The contexts of a channel."""

    def __init__(self, geo: int, sda: int, com: int) -> None:
        self.context_geo, self.context_sda, self.context_com = geo, sda, com


def test_contexts_of_channels() -> None:
    """F7: each context of a channel needs a thread with that context and function.

    A context of a thread that no channel has is 260103.
    """
    configuration = load(BASE + "thread[0].context_info 1\n")[0]
    for channel, expected in (
        (Channel(1, 0, 0), []),
        (Channel(2, 0, 0), [260102, 260103]),
        (Channel(1, 1, 1), [260102, 260102]),
        (Channel(0, 0, 0), [260103]),
    ):
        collector = Collector()
        check_contexts(configuration, [channel], collector)  # type: ignore[list-item]
        assert [found.id for found in collector.diagnostics] == expected


PARAMETERS = """\
thread[0].name GEO1
thread[0].context_info 1
thread[0].cycle 2000
thread[0].priority 31 # HIGHEST
thread[0].error_on_overflow 1
thread[0].function[0].name task_int
thread[0].function[0].calls_per_cycle 1
thread[0].function[0].trace_bit 1
thread[0].cpu 1
schedule STANDARD
external_thread[0].cycle 2000
external_thread[0].semaphore_name external_sps
"""


def test_parameter_examples_of_the_manual() -> None:
    """F3: the examples of chapters 4 and 5 are taken unchanged."""
    head = "interrupt_source 3\nexternal_object_name s\n"
    times = "cycle_time 2000\ntime_slice 500\nwindows_time 500\n"
    configuration, found = load(head + times + PARAMETERS)
    assert found == []
    thread = configuration.threads[0]
    assert (thread.name, thread.context, thread.priority) == ("GEO1", 1, 31)
    assert configuration.external_threads[0].semaphore_name == "external_sps"


@pytest.mark.parametrize(
    ("line", "name", "numbers"),
    [
        ("thread[0].name STRING_1 (comment requires a '(' bracket!)", "STRING_1", []),
        ("thread[0].name STRING_1 (Kommentar benötigt '(' Klammer!)", "STRING_1", []),
        ('thread[0].name" STRING_(2)" (comment requires a bracket)', " STRING_(2)", [900007]),
        ('thread[0].name "STRING_(2)" (Kommentar benötigt Klammer)', "STRING_(2)", []),
        ('thread[0].name "STRING_WITH_COMMENT( # /*)_CHARACTERS"', None, []),
        ('thread[0].name "STRING_WITH_POST_SPACES "', "STRING_WITH_POST_SPACES", []),
        ("thread[0].name STRING_WITH_STANDARD_CHARACTERS!", None, []),
    ],
)
def test_strings_of_the_manual(line: str, name: str | None, numbers: list[int]) -> None:
    """F3: the string examples of chapters 2.4 and 2.5 in both languages."""
    text = BASE.replace("thread[0].name GEO", line)
    configuration, found = load(text)
    assert found == numbers
    if name is not None:
        assert configuration.threads[0].name == name
