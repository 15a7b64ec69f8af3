# SPDX-License-Identifier: MIT
"""rtconf.lis: the scheduling of the controller's threads (P-RTCF-00001 … 00018).

In: the bytes of the list. Out: ``RtconfConfiguration``. Source: manual "Configuration list of
realtime parameters", version 1.07, whose German text is the better one. There are only these 17
parameters: each unknown entry is a separate warning, hexadecimal numbers are refused.
"""

from __future__ import annotations

import enum

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text
from nctakt.lists.format.parameter import MAX_UNS16, MAX_UNS32, Alias, Parameter, ValueType
from nctakt.lists.format.reader import ListDialect
from nctakt.lists.format.schema import ForeignName, Schema

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


_BASIC = (
    Parameter(
        "P-RTCF-00001",
        "interrupt_source",
        ValueType.UNS16,
        0,
        Text(
            "What starts each NC cycle: 1 hardware interrupt, 2 timer, 3 semaphore, "
            "4 external scheduling",
            "Was jeden NC-Takt auslöst: 1 Hardware-Interrupt, 2 Timer, 3 Semaphor, "
            "4 externes Scheduling",
        ),
        low=1,
        high=4,
    ),
    Parameter(
        "P-RTCF-00002",
        "cycle_time",
        ValueType.UNS32,
        None,
        Text(
            "Length of an NC cycle; rounded up to a multiple of time_slice",
            "Dauer eines NC-Takts; auf ein Vielfaches von time_slice aufgerundet",
        ),
        low=1,
        high=MAX_UNS32 - 1,
        unit="µs",
    ),
    Parameter(
        "P-RTCF-00003",
        "time_slice",
        ValueType.UNS32,
        None,
        Text(
            "Distance of the timer interrupts, a third to a twentieth of the NC cycle",
            "Abstand der Timer-Interrupts, ein Drittel bis ein Zwanzigstel des NC-Takts",
        ),
        low=1,
        high=MAX_UNS32 - 1,
        unit="µs",
    ),
    Parameter(
        "P-RTCF-00004",
        "windows_time",
        ValueType.UNS16,
        None,
        Text(
            "Time in each NC cycle that Windows is sure to get; 0 guarantees none",
            "Zeit in jedem NC-Takt, die Windows sicher bekommt; 0 garantiert keine",
        ),
        low=0,
        high=MAX_UNS16 - 1,
        unit="µs",
    ),
    Parameter(
        "P-RTCF-00005",
        "external_object_name",
        ValueType.STRING,
        "",
        Text(
            "Semaphore of the operating system that starts the NC cycle (interrupt source 3)",
            "Semaphor des Betriebssystems, der den NC-Takt auslöst (Interruptquelle 3)",
        ),
    ),
    Parameter(
        "P-RTCF-00018",
        "schedule",
        ValueType.NAME,
        "STANDARD",
        Text(
            "Order of input, interpolation and output within a cycle",
            "Reihenfolge von Einlesen, Interpolation und Ausgabe in einem Takt",
        ),
        names={"STANDARD": None, "COMPLETE": None, "SWITCHED": None},
    ),
)

_THREADS = (
    Parameter(
        "P-RTCF-00008",
        "thread[0..9].name",
        ValueType.STRING,
        "",
        Text("Name of a thread", "Name eines Threads"),
        high=NAME_LENGTH,
    ),
    Parameter(
        "P-RTCF-00009",
        "thread[0..9].cycle",
        ValueType.UNS32,
        0,
        Text(
            "Cycle of a thread; rounded up to a multiple of the NC cycle",
            "Takt eines Threads; auf ein Vielfaches des NC-Takts aufgerundet",
        ),
        unit="µs",
    ),
    Parameter(
        "P-RTCF-00010",
        "thread[0..9].priority",
        ValueType.SGN32,
        0,
        Text(
            "Priority of a thread in the sense of the operating system",
            "Priorität eines Threads im Sinn des Betriebssystems",
        ),
    ),
    Parameter(
        "P-RTCF-00011",
        "thread[0..9].error_on_overflow",
        ValueType.BOOLEAN,
        False,
        Text("Report when the thread overflows", "Meldung, wenn der Thread überläuft"),
    ),
    Parameter(
        "P-RTCF-00012",
        "thread[0..9].function[0..9].name",
        ValueType.STRING,
        "",
        Text(
            "Function that the thread calls: task_int, task_rnd, task_com, task_mmi_driver, "
            "task_tcp",
            "Funktion, die der Thread ruft: task_int, task_rnd, task_com, task_mmi_driver, "
            "task_tcp",
        ),
        high=NAME_LENGTH,
    ),
    Parameter(
        "P-RTCF-00013",
        "thread[0..9].function[0..9].calls_per_cycle",
        ValueType.UNS32,
        1,
        Text("Calls of the function per activation", "Aufrufe der Funktion je Aktivierung"),
        low=1,
        high=MAX_UNS32 - 1,
    ),
    Parameter(
        "P-RTCF-00014",
        "thread[0..9].function[0..9].trace_bit",
        ValueType.UNS16,
        0,
        Text(
            "Bit that shows the function's run on an oscilloscope, 0: none",
            "Bit, das den Lauf der Funktion am Oszilloskop zeigt, 0: keines",
        ),
        high=7,
    ),
    Parameter(
        "P-RTCF-00015",
        "thread[0..9].cpu",
        ValueType.UNS16,
        1,
        Text("CPU core of the thread, from 1", "CPU-Kern des Threads, ab 1"),
        low=1,
        high=7,
    ),
    Parameter(
        "P-RTCF-00017",
        "thread[0..9].context_info",
        ValueType.UNS32,
        0,
        Text(
            "Context that channels name to be run by this thread",
            "Kontext, den Kanäle nennen, um in diesem Thread zu laufen",
        ),
        aliases=(Alias("thread[0..9].context"),),
    ),
)

_EXTERNAL_THREADS = (
    Parameter(
        "P-RTCF-00006",
        "external_thread[0..3].cycle",
        ValueType.UNS32,
        0,
        Text(
            "Cycle of an external thread; rounded up to a multiple of the NC cycle",
            "Takt eines externen Threads; auf ein Vielfaches des NC-Takts aufgerundet",
        ),
        unit="µs",
    ),
    Parameter(
        "P-RTCF-00007",
        "external_thread[0..3].semaphore_name",
        ValueType.STRING,
        "",
        Text(
            "Semaphore that wakes the external thread",
            "Semaphor, der den externen Thread weckt",
        ),
        high=NAME_LENGTH,
    ),
)

RTCONF = Schema(
    "rtconf",
    Text("Realtime configuration", "Echtzeitkonfiguration"),
    ListDialect(
        hexadecimal=False,
        references=False,
        boolean_words=False,
        expects_end=True,
        comment_notes=True,
    ),
    _BASIC + _THREADS + _EXTERNAL_THREADS,
    foreign=(
        ForeignName("schedule.context.geo", "channel", "P-CHAN-00410"),
        ForeignName("schedule.context.sda", "channel", "P-CHAN-00411"),
        ForeignName("schedule.context.com", "channel", "P-CHAN-00409"),
    ),
)
