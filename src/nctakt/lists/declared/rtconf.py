# SPDX-License-Identifier: MIT
"""rtconf.lis: the scheduling of the controller's threads (P-RTCF-00001 … 00018).

In: the bytes of the list. Out: ``RtconfConfiguration``. Source: manual "Configuration list of
realtime parameters", version 1.07; its German text is the better one. There are only these 17
parameters: each unknown entry is a separate warning, hexadecimal numbers are refused.
"""

from __future__ import annotations

import enum

from nctakt.base.dataclass import dataclass

NAME_LENGTH = 127
#: Numbers of threads, and of functions of a thread, in the manual; systems have up to ten.
PRINTED_COUNT = 7
KNOWN_FUNCTIONS = ("task_rnd", "task_int", "task_com", "task_mmi_driver", "task_tcp")
#: The function of the interpolation, whose thread is never suspended.
REALTIME_FUNCTION = "task_int"


class InterruptSource(enum.Enum):
    """The source of NC cycles, by meaning, since lists disagree about the numbers 1 and 2."""

    HARDWARE = "hardware interrupt"
    TIMER = "timer"
    SEMAPHORE = "semaphore"
    #: Another program calls the tasks (not in the manual).
    OUTSIDE = "external scheduling"


#: The numbers of the manual's parameter table, and the one of shipped lists.
INTERRUPT_SOURCES = {
    1: InterruptSource.HARDWARE,
    2: InterruptSource.TIMER,
    3: InterruptSource.SEMAPHORE,
    4: InterruptSource.OUTSIDE,
}


@dataclass(frozen=True, slots=True)
class ThreadFunction:
    """``thread[i].function[j].*``: a function of a thread; ``trace_bit`` 0 is none."""

    index: int
    name: str
    calls_per_cycle: int
    trace_bit: int


@dataclass(frozen=True, slots=True)
class SchedulerThread:
    """``thread[i].*`` with its effective cycle; ``priority`` as written, ``cpu`` counts from 1."""

    index: int
    name: str
    cycle_us: int
    priority: int
    error_on_overflow: bool
    cpu: int
    context: int
    functions: tuple[ThreadFunction, ...]


@dataclass(frozen=True, slots=True)
class ExternalThread:
    """``external_thread[i].*`` with its effective cycle."""

    index: int
    semaphore_name: str
    cycle_us: int


@dataclass(frozen=True, slots=True)
class RtconfConfiguration:
    """The effective scheduling; ``windows_time_us`` 0: no time is guaranteed to Windows."""

    interrupt_source: InterruptSource
    cycle_time_us: int
    time_slice_us: int
    windows_time_us: int
    external_object_name: str
    schedule: str
    threads: tuple[SchedulerThread, ...]
    external_threads: tuple[ExternalThread, ...]
