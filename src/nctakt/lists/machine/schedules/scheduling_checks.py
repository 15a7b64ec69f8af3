# SPDX-License-Identifier: MIT
"""Checks of the threads' priorities for an operating system.

In: the threads with their priorities as written, the profile. Out: findings, and the effective
priorities. Source: manual 4.3 (P-RTCF-00010).
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from nctakt.lists.declared.rtconf import (
    REALTIME_FUNCTION,
    RtconfConfiguration,
    SchedulerThread,
)
from nctakt.lists.format.parameter import with_indices
from nctakt.lists.format.values import Values
from nctakt.lists.machine.channel_configuration import ChannelParameters
from nctakt.lists.machine.schedules.scheduling_profile import Profile
from nctakt.lists.machine.schedules.scheduling_source import comment_of
from nctakt.messages import Collector
from nctakt.messages.scheduling.linux_run import CYCLES_MAY_TAKE_WINDOWS_TIME
from nctakt.messages.scheduling.schedule_check import (
    CHANNEL_CONTEXT_WITHOUT_THREAD,
    COMMENT_CONTRADICTS_ENTRY,
    DUPLICATE_PRIORITY,
    HIGHEST_PRIORITY_ASSUMED,
    LOWEST_PRIORITY_ASSUMED,
    PRIORITY_OUT_OF_RANGE,
    PRIORITY_RESERVED,
    THREAD_BEFORE_REALTIME_THREAD,
    THREAD_CONTEXT_WITHOUT_CHANNEL,
)

_KEY = "thread[].priority"
_EXTREME = re.compile(r"\b(highest|lowest)\b", re.I)


def is_realtime(thread: SchedulerThread) -> bool:
    """Return whether the thread runs the interpolation."""
    return any(function.name == REALTIME_FUNCTION for function in thread.functions)


def check_priorities(
    values: Values, threads: tuple[SchedulerThread, ...], profile: Profile, collector: Collector
) -> tuple[SchedulerThread, ...]:
    """Return the threads with their effective priorities."""
    checked = tuple(_check_range(values, thread, profile, collector) for thread in threads)
    _check_equal(values, checked, collector)
    _check_realtime(values, checked, profile, collector)
    _check_comments(values, checked, profile, collector)
    return checked


def _check_range(
    values: Values, thread: SchedulerThread, profile: Profile, collector: Collector
) -> SchedulerThread:
    key = (_KEY, thread.index)
    name = with_indices(*_at(thread))
    priority = thread.priority
    if not profile.low <= priority <= profile.high and values.is_set(*key):
        values.report(
            collector,
            PRIORITY_OUT_OF_RANGE,
            key,
            key=name,
            value=priority,
            low=profile.low,
            high=profile.high,
            profile=profile.title,
        )
        priority = 0
    elif priority in profile.reserved and values.is_set(*key):
        values.report(
            collector, PRIORITY_RESERVED, key, key=name, value=priority, profile=profile.title
        )
    if priority != thread.priority or not values.is_set(*key):
        number = LOWEST_PRIORITY_ASSUMED if profile.greatest_first else HIGHEST_PRIORITY_ASSUMED
        values.report(collector, number, key, key=name, profile=profile.title)
    return replace(thread, priority=priority)


def _at(thread: SchedulerThread) -> tuple[str, tuple[int]]:
    return _KEY, (thread.index,)


def _check_equal(
    values: Values, threads: tuple[SchedulerThread, ...], collector: Collector
) -> None:
    first: dict[int, int] = {}
    for thread in threads:
        other = first.setdefault(thread.priority, thread.index)
        if other != thread.index:
            values.report(
                collector,
                DUPLICATE_PRIORITY,
                (_KEY, thread.index),
                key=with_indices(*_at(thread)),
                other=with_indices(_KEY, (other,)),
                value=thread.priority,
            )


def _check_realtime(
    values: Values, threads: tuple[SchedulerThread, ...], profile: Profile, collector: Collector
) -> None:
    others = [thread for thread in threads if not is_realtime(thread)]
    for thread in threads:
        urgency = profile.urgency(thread.priority)
        above = [thread for thread in others if profile.urgency(thread.priority) > urgency]
        if is_realtime(thread) and above:
            values.report(
                collector,
                THREAD_BEFORE_REALTIME_THREAD,
                (_KEY, thread.index),
                thread=thread.index,
                other=above[0].index,
                profile=profile.title,
            )


def _check_comments(
    values: Values, threads: tuple[SchedulerThread, ...], profile: Profile, collector: Collector
) -> None:
    urgencies = [profile.urgency(thread.priority) for thread in threads]
    for thread, urgency in zip(threads, urgencies, strict=True):
        entry_value = values.entry_values.get(_at(thread))
        match = _EXTREME.search(comment_of(entry_value.entry)) if entry_value is not None else None
        if match is None:
            continue
        extreme = max(urgencies) if match[1].lower() == "highest" else min(urgencies)
        if urgency != extreme:
            values.report(
                collector,
                COMMENT_CONTRADICTS_ENTRY,
                (_KEY, thread.index),
                key=with_indices(*_at(thread)),
                word=match[1],
            )


def check_contexts(
    configuration: RtconfConfiguration,
    channels: Sequence[ChannelParameters],
    collector: Collector,
) -> None:
    """Check that each context has its thread, and is a channel's (P-RTCF-00017, P-CHAN-00409 …
    00411).
    """
    for number, channel in enumerate(channels, start=1):
        for key, function, context in (
            ("schedule.context.geo", "task_int", channel.context_geo),
            ("schedule.context.sda", "task_rnd", channel.context_sda),
            ("schedule.context.com", "task_com", channel.context_com),
        ):
            if context and not any(
                thread.context == context
                and any(called.name == function for called in thread.functions)
                for thread in configuration.threads
            ):
                collector.report(
                    CHANNEL_CONTEXT_WITHOUT_THREAD,
                    None,
                    channel=number,
                    key=key,
                    context=context,
                    function=function,
                )
    of_channels = {
        context
        for channel in channels
        for context in (channel.context_geo, channel.context_sda, channel.context_com)
    }
    for thread in configuration.threads:
        if thread.context and thread.context not in of_channels:
            collector.report(
                THREAD_CONTEXT_WITHOUT_CHANNEL,
                None,
                key=f"thread[{thread.index}].context_info",
                context=thread.context,
            )


def check_time_limits(
    configuration: RtconfConfiguration,
    channels: Sequence[ChannelParameters],
    collector: Collector,
) -> None:
    """Check that realtime cycles do not reach into Windows' time (P-CHAN-00425, P-RTCF-00004).

    Their thread is never suspended. Both together may be the whole NC cycle, as with the default of
    75 % and the times recommended by the manual.
    """
    for number, channel in enumerate(channels, start=1):
        limits = channel.realtime_cycles
        allowed_us = limits.max_duration_pct * configuration.cycle_time_us // 100
        windows_us = configuration.windows_time_us
        if limits.enable and windows_us and allowed_us + windows_us > configuration.cycle_time_us:
            collector.report(
                CYCLES_MAY_TAKE_WINDOWS_TIME,
                None,
                channel=number,
                share=limits.max_duration_pct,
                allowed=allowed_us,
                windows=windows_us,
                cycle=configuration.cycle_time_us,
            )
