# SPDX-License-Identifier: MIT
"""The values of rtconf.lis -> the effective scheduling.

In: checked values. Out: ``RtconfConfiguration``, all times multiples of each other as required by
the manual. The order is: time_slice, ratio of cycle_time to it (of the raw values: after rounding
it could not be below 1), cycle_time up, cycles of the threads up, windows_time down. A value
without a printed default gets that of the manual's example, with an error.
"""

from __future__ import annotations

from dataclasses import replace

from nctakt.lists.declared.rtconf import (
    ExternalThread,
    InterruptSource,
    RtconfConfiguration,
    SchedulerThread,
    ThreadFunction,
)
from nctakt.lists.declared.schemas import RTCONF
from nctakt.lists.format.list_check import load_list
from nctakt.lists.format.parameter import MAX_UNS16, MAX_UNS32, with_indices
from nctakt.lists.format.values import Values
from nctakt.lists.machine.schedules.scheduling_checks import check_priorities, is_realtime
from nctakt.lists.machine.schedules.scheduling_names import (
    check_function_names,
    check_indices,
    check_names,
    check_trace_bits,
)
from nctakt.lists.machine.schedules.scheduling_profile import STANDARD_OPTIONS, RtconfOptions
from nctakt.lists.machine.schedules.scheduling_source import comment_of, read_source
from nctakt.messages import Collector
from nctakt.messages.scheduling.rtconf import (
    CYCLE_TIME_LONG,
    CYCLE_TIME_NOT_A_MULTIPLE,
    CYCLE_TIME_SHORT,
    EXTERNAL_SCHEDULING,
    EXTERNAL_THREAD_WITHOUT_SEMAPHORE,
    INTERRUPT_SOURCE_MISSING,
    REALTIME_OVERFLOW_NOT_REPORTED,
    REALTIME_THREAD_ASSUMED,
    SCHEDULE_TEXT_EMPTY,
    SCHEDULE_TIME_MISSING,
    SCHEDULE_TIME_TOO_LONG,
    SEMAPHORE_NAME_MISSING,
    SEMAPHORE_NAME_WITHOUT_EFFECT,
    SEVERAL_CALLS_PER_ACTIVATION,
    THREAD_CYCLE_MISSING,
    THREAD_WITHOUT_FUNCTION,
    TIME_NOT_A_MULTIPLE,
    TIME_SLICE_ABOVE_CYCLE_TIME,
    WINDOWS_TIME_BELOW_TIME_SLICE,
    WINDOWS_TIME_DIFFERS,
    WINDOWS_TIME_SHORT,
    WINDOWS_TIME_TAKES_WHOLE_CYCLE,
    WINDOWS_TIME_ZERO,
)
from nctakt.messages.scheduling.schedule_check import (
    INTERRUPT_SOURCE_ASSUMED,
    INVALID_SEMAPHORE_NAME,
    SCHEDULE_WITHOUT_THREADS,
    TIME_SLICE_NOT_HAL_PERIOD,
    TIME_SLICE_NOT_SETTABLE,
    WINDOWS_TIME_IGNORED,
    WINDOWS_TIME_OFF,
    WINDOWS_TIME_UNSTABLE,
)

CYCLE_TIME_FALLBACK_US = 2000
TIME_SLICE_FALLBACK_US = 500
SHORT_WINDOWS_TIME_US = 200
UNSTABLE_WINDOWS_TIME_US = 100
#: Maximum length of a semaphore's name on Linux after the '/', in characters.
LONGEST_OBJECT_NAME = 250
_LONGEST_TIME_US = MAX_UNS32 - 1
_LONGEST_SLICE_US = MAX_UNS16 - 1


#: Errors by choice, where the manual has no default: warnings with the option ``lenient``.
_LENIENT = (
    INTERRUPT_SOURCE_MISSING,
    SCHEDULE_TIME_MISSING,
    SCHEDULE_TIME_TOO_LONG,
    EXTERNAL_THREAD_WITHOUT_SEMAPHORE,
)
#: Numbers of interrupt_source on which the manual's table and its examples disagree.
_UNCERTAIN_NUMBERS = (1, 2)


def load_rtconf(
    file: str, data: bytes, collector: Collector, options: RtconfOptions = STANDARD_OPTIONS
) -> RtconfConfiguration:
    """Read one rtconf.lis; ``file`` is its name in spans. Never fails."""
    return read_rtconf(file, data, collector, options)[1]


def read_rtconf(
    file: str, data: bytes, collector: Collector, options: RtconfOptions = STANDARD_OPTIONS
) -> tuple[Values, RtconfConfiguration]:
    """Return the raw values of an rtconf.lis and its effective scheduling."""
    values = load_list(RTCONF, file, data, collector)
    return values, effective(values, collector, options)


def effective(
    values: Values, collector: Collector, options: RtconfOptions = STANDARD_OPTIONS
) -> RtconfConfiguration:
    """Return the effective scheduling of the values of an rtconf.lis."""
    findings = Collector()
    configuration = _effective(values, findings, options)
    for finding in findings.diagnostics:
        is_lenient = options.lenient and finding.message in _LENIENT
        collector.diagnostics.append(replace(finding, is_lenient=True) if is_lenient else finding)
    return configuration


def _effective(values: Values, collector: Collector, options: RtconfOptions) -> RtconfConfiguration:
    source = _interrupt_source(values, collector, options)
    time_slice, cycle_time = _times(values, collector, options)
    threads = _threads(values, cycle_time, collector, options)
    external = _external_threads(values, cycle_time, collector)
    windows_time = _windows_time(values, time_slice, cycle_time, collector, options)
    return RtconfConfiguration(
        source,
        cycle_time,
        time_slice,
        windows_time,
        _object_name(values, source, collector),
        values.text("schedule"),
        threads,
        external,
    )


def _interrupt_source(
    values: Values, collector: Collector, options: RtconfOptions
) -> InterruptSource:
    key = ("interrupt_source",)
    entry_value = values.entry_values.get(("interrupt_source", ()))
    if entry_value is None:
        values.report(collector, INTERRUPT_SOURCE_MISSING, key)
        return InterruptSource.TIMER
    number = values.integer("interrupt_source")
    reading = read_source(number, comment_of(entry_value.entry), options.convention)
    if reading.source is InterruptSource.OUTSIDE:
        values.report(collector, EXTERNAL_SCHEDULING, key)
    elif number in _UNCERTAIN_NUMBERS and options.convention == "auto":
        text = reading.text
        values.report(collector, INTERRUPT_SOURCE_ASSUMED, key, value=number, meaning=text)
    return reading.source


def _object_name(values: Values, source: InterruptSource, collector: Collector) -> str:
    key = ("external_object_name",)
    name = values.text("external_object_name")
    if source is InterruptSource.SEMAPHORE and not name:
        values.report(collector, SEMAPHORE_NAME_MISSING, key)
    if source is not InterruptSource.SEMAPHORE and name:
        values.report(collector, SEMAPHORE_NAME_WITHOUT_EFFECT, key)
        return ""
    if len(name.removeprefix("/")) > LONGEST_OBJECT_NAME or "/" in name.removeprefix("/"):
        values.report(collector, INVALID_SEMAPHORE_NAME, key, limit=LONGEST_OBJECT_NAME)
        return ""
    return name


def _times(values: Values, collector: Collector, options: RtconfOptions) -> tuple[int, int]:
    """Return the effective time_slice and cycle_time in µs."""
    cycle = _value_or(values, "cycle_time", CYCLE_TIME_FALLBACK_US, collector)
    slice_ = _value_or(values, "time_slice", min(TIME_SLICE_FALLBACK_US, cycle), collector)
    profile, hal = options.profile, options.hal_timer_us
    if not profile.settable_slice and values.is_set("time_slice"):
        values.report(collector, TIME_SLICE_NOT_SETTABLE, ("time_slice",), profile=profile.title)
    if profile.name == "rtx" and hal is not None and hal != slice_:
        values.report(collector, TIME_SLICE_NOT_HAL_PERIOD, ("time_slice",), slice=slice_, hal=hal)
    if slice_ > _LONGEST_SLICE_US:
        values.report(
            collector,
            SCHEDULE_TIME_TOO_LONG,
            ("time_slice",),
            key="time_slice",
            limit=_LONGEST_SLICE_US,
        )
    ratio = {"cycle": cycle, "slice": slice_}
    if cycle < slice_:
        values.report(collector, TIME_SLICE_ABOVE_CYCLE_TIME, ("time_slice",), **ratio)
    elif profile.has_windows and cycle < 3 * slice_:
        values.report(collector, CYCLE_TIME_SHORT, ("time_slice",), **ratio)
    elif profile.has_windows and cycle > 20 * slice_:
        values.report(collector, CYCLE_TIME_LONG, ("time_slice",), **ratio)
    rounded = _round_up(cycle, slice_)
    if rounded > _LONGEST_TIME_US:
        values.report(
            collector,
            SCHEDULE_TIME_TOO_LONG,
            ("cycle_time",),
            key="cycle_time",
            limit=_LONGEST_TIME_US,
        )
        rounded = _round_up(CYCLE_TIME_FALLBACK_US, slice_)
    elif rounded != cycle:
        values.report(
            collector, CYCLE_TIME_NOT_A_MULTIPLE, ("cycle_time",), value=cycle, effective=rounded
        )
    return slice_, rounded


def _value_or(values: Values, pattern: str, fallback: int, collector: Collector) -> int:
    if values.is_set(pattern):
        return values.integer(pattern)
    values.report(collector, SCHEDULE_TIME_MISSING, (pattern,), key=pattern, fallback=fallback)
    return fallback


def _round_up(value: int, step: int) -> int:
    return -(-value // step) * step


def _windows_time(
    values: Values, slice_: int, cycle: int, collector: Collector, options: RtconfOptions
) -> int:
    key = ("windows_time",)
    has_windows = options.profile.has_windows
    if not has_windows and not values.is_set(*key):
        return 0
    written = _value_or(values, "windows_time", slice_, collector)
    if written == 0:
        if has_windows:
            values.report(collector, WINDOWS_TIME_ZERO, key)
        return 0
    # Vendors' lists for Linux have the cycle time here, without a meaning.
    means_nothing = not has_windows and not slice_ <= written < cycle
    if options.ignore_windows or means_nothing:
        values.report(collector, WINDOWS_TIME_IGNORED, key, value=written)
        return 0
    if written < slice_:
        values.report(
            collector,
            WINDOWS_TIME_OFF if options.small_windows_is_off else WINDOWS_TIME_BELOW_TIME_SLICE,
            key,
            value=written,
            slice=slice_,
        )
        if options.small_windows_is_off:
            return 0
        written = slice_
    rounded = written // slice_ * slice_
    if rounded != written:
        values.report(
            collector,
            TIME_NOT_A_MULTIPLE,
            key,
            key="windows_time",
            value=written,
            effective=rounded,
            step=slice_,
        )
    if has_windows:
        _check_windows_time(values, rounded, slice_, cycle, collector, options)
    return min(rounded, cycle)


def _check_windows_time(
    values: Values, time: int, slice_: int, cycle: int, collector: Collector, options: RtconfOptions
) -> None:
    key = ("windows_time",)
    if time >= cycle:
        values.report(collector, WINDOWS_TIME_TAKES_WHOLE_CYCLE, key, value=time, cycle=cycle)
    if time <= SHORT_WINDOWS_TIME_US:
        values.report(collector, WINDOWS_TIME_SHORT, key, value=time)
    elif time != slice_:
        values.report(collector, WINDOWS_TIME_DIFFERS, key, value=time, slice=slice_)
    if options.profile.name == "rtx" and time <= UNSTABLE_WINDOWS_TIME_US:
        values.report(collector, WINDOWS_TIME_UNSTABLE, key, value=time)


def _thread_cycle(
    values: Values, pattern: str, index: int, cycle_time: int, collector: Collector
) -> int:
    key = (pattern, index)
    name = with_indices(pattern, (index,))
    written = values.integer(pattern, index)
    if written == 0:
        values.report(collector, THREAD_CYCLE_MISSING, key, key=name, effective=cycle_time)
        return cycle_time
    rounded = _round_up(written, cycle_time)
    if rounded > _LONGEST_TIME_US:
        values.report(collector, SCHEDULE_TIME_TOO_LONG, key, key=name, limit=_LONGEST_TIME_US)
        return cycle_time
    if rounded != written:
        values.report(
            collector,
            TIME_NOT_A_MULTIPLE,
            key,
            key=name,
            value=written,
            effective=rounded,
            step=cycle_time,
        )
    return rounded


def _threads(
    values: Values, cycle_time: int, collector: Collector, options: RtconfOptions
) -> tuple[SchedulerThread, ...]:
    indices = values.indices("thread[]")
    check_indices(values, "thread[]", (), indices, collector)
    threads = tuple(_thread(values, index, cycle_time, collector) for index in indices)
    check_names(
        values,
        "thread[].name",
        [(thread.index, thread.name) for thread in threads],
        collector,
    )
    check_trace_bits(values, threads, collector)
    check_function_names(values, threads, options, collector)
    if not threads:
        values.report(collector, SCHEDULE_WITHOUT_THREADS, ("thread[].name", 0))
    elif not any(is_realtime(thread) for thread in threads):
        values.report(collector, REALTIME_THREAD_ASSUMED, ("thread[].function[].name", 0, 0))
    return check_priorities(values, threads, options.profile, collector)


def _thread(values: Values, index: int, cycle_time: int, collector: Collector) -> SchedulerThread:
    functions = _functions(values, index, collector)
    thread = SchedulerThread(
        index,
        values.text("thread[].name", index),
        _thread_cycle(values, "thread[].cycle", index, cycle_time, collector),
        values.integer("thread[].priority", index),
        values.flag("thread[].error_on_overflow", index),
        values.integer("thread[].cpu", index),
        values.integer("thread[].context_info", index),
        functions,
    )
    if not functions:
        values.report(collector, THREAD_WITHOUT_FUNCTION, ("thread[].name", index), thread=index)
    if is_realtime(thread) and not thread.error_on_overflow:
        values.report(
            collector,
            REALTIME_OVERFLOW_NOT_REPORTED,
            ("thread[].error_on_overflow", index),
            thread=index,
        )
    return thread


def _functions(values: Values, thread: int, collector: Collector) -> tuple[ThreadFunction, ...]:
    functions: list[ThreadFunction] = []
    indices = values.indices("thread[].function[]", thread)
    check_indices(values, "thread[].function[]", (thread,), indices, collector)
    for index in indices:
        name = values.text("thread[].function[].name", thread, index)
        key = ("thread[].function[].name", thread, index)
        path = with_indices(key[0], (thread, index))
        if not name:
            values.report(collector, SCHEDULE_TEXT_EMPTY, key, key=path)
            continue
        calls = values.integer("thread[].function[].calls_per_cycle", thread, index)
        if calls > 1 and name != "task_rnd":
            calls_key = ("thread[].function[].calls_per_cycle", thread, index)
            values.report(
                collector, SEVERAL_CALLS_PER_ACTIVATION, calls_key, function=name, value=calls
            )
        trace_bit = values.integer("thread[].function[].trace_bit", thread, index)
        functions.append(ThreadFunction(index, name, calls, trace_bit))
    return tuple(functions)


def _external_threads(
    values: Values, cycle_time: int, collector: Collector
) -> tuple[ExternalThread, ...]:
    threads: list[ExternalThread] = []
    indices = values.indices("external_thread[]")
    check_indices(values, "external_thread[]", (), indices, collector)
    for index in indices:
        name = values.text("external_thread[].semaphore_name", index)
        if not name:
            key = ("external_thread[].semaphore_name", index)
            values.report(collector, EXTERNAL_THREAD_WITHOUT_SEMAPHORE, key, thread=index)
            continue
        cycle = _thread_cycle(values, "external_thread[].cycle", index, cycle_time, collector)
        threads.append(ExternalThread(index, name, cycle))
    check_names(
        values,
        "external_thread[].semaphore_name",
        [(thread.index, thread.semaphore_name) for thread in threads],
        collector,
    )
    return tuple(threads)
