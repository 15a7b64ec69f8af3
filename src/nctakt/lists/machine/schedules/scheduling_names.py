# SPDX-License-Identifier: MIT
"""Indices, names and trace bits of the threads in rtconf.lis.

In: the values of the list, its threads. Out: findings. Source: manual 4.1, 4.5, 5.2.
"""

from __future__ import annotations

from nctakt.base.misspelling import nearest
from nctakt.lists.declared.rtconf import KNOWN_FUNCTIONS, PRINTED_COUNT, SchedulerThread
from nctakt.lists.format.parameter import with_indices
from nctakt.lists.format.values import Values
from nctakt.lists.machine.schedules.scheduling_profile import RtconfOptions
from nctakt.messages import Collector
from nctakt.messages.scheduling.rtconf import (
    DUPLICATE_THREAD_BIT,
    DUPLICATE_THREAD_NAME,
    INDEX_BEYOND_MANUAL,
    MISSPELLED_THREAD_FUNCTION,
    SCHEDULE_TEXT_EMPTY,
    THREAD_INDEX_GAP,
    USER_THREAD_FUNCTIONS,
)

_FUNCTION = "thread[].function[].name"
#: The entry with the name of an element of each kind.
_NAMES = {
    "thread[]": "thread[].name",
    "thread[].function[]": _FUNCTION,
    "external_thread[]": "external_thread[].semaphore_name",
}


def check_indices(
    values: Values,
    prefix: str,
    outer: tuple[int, ...],
    indices: tuple[int, ...],
    collector: Collector,
) -> None:
    """Report the first gap in ``indices`` of ``prefix``, and the first index beyond the manual."""
    numbered = list(enumerate(indices))
    gap = next(((number, index) for number, index in numbered if number != index), None)
    if gap is not None:
        missing, index = gap
        at = (*outer, index)
        key = with_indices(prefix, (*outer, missing))
        values.report(collector, THREAD_INDEX_GAP, (_NAMES[prefix], *at), key=key)
    beyond = next((index for index in indices if index >= PRINTED_COUNT), None)
    if beyond is not None:
        at = (*outer, beyond)
        key, last = with_indices(prefix, at), PRINTED_COUNT - 1
        values.report(collector, INDEX_BEYOND_MANUAL, (_NAMES[prefix], *at), key=key, last=last)


def check_function_names(
    values: Values,
    threads: tuple[SchedulerThread, ...],
    options: RtconfOptions,
    collector: Collector,
) -> None:
    """Report functions that the controller does not have: misspelt ones, and the user's."""
    names_known = (*KNOWN_FUNCTIONS, *options.functions)
    own: dict[str, tuple[int, int]] = {}
    for thread in threads:
        for function in thread.functions:
            name, at = function.name, (thread.index, function.index)
            if name in names_known:
                continue
            if similar := nearest(name, names_known):
                values.report(
                    collector,
                    MISSPELLED_THREAD_FUNCTION,
                    (_FUNCTION, *at),
                    key=with_indices(_FUNCTION, at),
                    value=name,
                    name=similar,
                )
            else:
                own.setdefault(name, at)
    if own:
        at = next(iter(own.values()))
        names = ", ".join(own)
        values.report(collector, USER_THREAD_FUNCTIONS, (_FUNCTION, *at), names=names)


def check_names(
    values: Values, pattern: str, names: list[tuple[int, str]], collector: Collector
) -> None:
    """Report empty names, and names shared by several entries of ``pattern``."""
    first: dict[str, int] = {}
    for index, name in names:
        path = with_indices(pattern, (index,))
        if not name:
            values.report(collector, SCHEDULE_TEXT_EMPTY, (pattern, index), key=path)
        elif name in first:
            other = with_indices(pattern, (first[name],))
            values.report(
                collector,
                DUPLICATE_THREAD_NAME,
                (pattern, index),
                key=path,
                other=other,
                value=name,
            )
        else:
            first[name] = index


def check_trace_bits(
    values: Values, threads: tuple[SchedulerThread, ...], collector: Collector
) -> None:
    """Report trace bits shared by several functions."""
    used: dict[int, str] = {}
    pattern = "thread[].function[].trace_bit"
    for thread in threads:
        for function in thread.functions:
            path = with_indices(pattern, (thread.index, function.index))
            other = used.setdefault(function.trace_bit, path)
            if function.trace_bit and other != path:
                values.report(
                    collector,
                    DUPLICATE_THREAD_BIT,
                    (pattern, thread.index, function.index),
                    key=path,
                    other=other,
                    value=function.trace_bit,
                )
