# SPDX-License-Identifier: MIT
"""Layout of a picture of a schedule: rows, strips, names.

In: ``Simulation`` with a record. Out: rows from top to bottom, by processor, then by urgency; the
strips of NC cycles below each other that make the picture no wider than a page. Where there are
more cycles than strips hold, the interesting ones are shown: overflows, the longest response of
each thread, the least time of Windows, then the first ones.
"""

from __future__ import annotations

import enum
from collections.abc import Iterator

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Language, Text
from nctakt.schedule.model import ANY_CPU, Model
from nctakt.schedule.simulation.results import EventKind, Simulation
from nctakt.schedule.simulation.timeline import windows_times
from nctakt.schedule.simulation.tracebits import BITS

MAX_STRIPS = 12
MAX_CYCLES_PER_STRIP = 8

_ANY_CPU = Text("any CPU", "jede CPU")
_TRACE_BITS = Text("Trace bits", "Trace-Bits")


class RowKind(enum.Enum):
    """Kinds of row."""

    HEADING = enum.auto()
    TASK = enum.auto()
    WINDOWS = enum.auto()
    BIT = enum.auto()


@dataclass(frozen=True, slots=True)
class Row:
    """A row; ``number``: the task's place in the model, the processor, the trace bit."""

    kind: RowKind
    name: str
    number: int = 0


@dataclass(frozen=True, slots=True)
class Strip:
    """NC cycles side by side: the first one, how many, from when to when in ns."""

    first: int
    count: int
    begin: int
    end: int


def rows_of(model: Model, language: Language) -> list[Row]:
    """Return the rows of a picture."""
    return [*_cpu_rows(model, language), *_bit_rows(model, language)]


def _cpu_rows(model: Model, language: Language) -> Iterator[Row]:
    order = sorted(range(len(model.tasks)), key=lambda i: (-model.tasks[i].urgency, i))
    for cpu in (*model.cpus, ANY_CPU):
        own = [i for i in order if model.tasks[i].cpu == cpu]
        has_windows = cpu in model.windows_cpus
        if not own and not has_windows:
            continue
        name = _ANY_CPU.get(language) if cpu == ANY_CPU else f"CPU {cpu}"
        yield Row(RowKind.HEADING, name)
        for i in own:
            yield Row(RowKind.TASK, model.tasks[i].name, i)
        if has_windows:
            yield Row(RowKind.WINDOWS, "Windows", cpu)


def bit_functions(model: Model) -> dict[int, list[str]]:
    """Return the functions of each trace bit that is used."""
    functions: dict[int, list[str]] = {bit: [] for bit in BITS}
    for task in model.tasks:
        for call in task.calls:
            if call.trace_bit and call.function not in functions[call.trace_bit]:
                functions[call.trace_bit].append(call.function)
    return {bit: names for bit, names in functions.items() if names}


def _bit_rows(model: Model, language: Language) -> Iterator[Row]:
    functions = bit_functions(model)
    if functions:
        yield Row(RowKind.HEADING, _TRACE_BITS.get(language))
    for bit, names in functions.items():
        yield Row(RowKind.BIT, f"{', '.join(names)}  {bit}", bit)


def strips_of(run: Simulation) -> list[Strip]:
    """Return the strips of a picture, in the order of time."""
    begins = [event.time for event in run.record.events if event.kind is EventKind.INTERRUPT]
    edges = [*begins, run.record.end]
    strips = [
        Strip(first, len(part), part[0], edges[first + len(part)])
        for first in range(0, len(begins), MAX_CYCLES_PER_STRIP)
        for part in [begins[first : first + MAX_CYCLES_PER_STRIP]]
    ]
    if len(strips) <= MAX_STRIPS:
        return strips
    chosen: dict[int, None] = {}
    for moment in (*_interesting(run), *(strip.begin for strip in strips)):
        if len(chosen) < MAX_STRIPS:
            chosen[_strip_at(strips, moment)] = None
    return [strips[index] for index in sorted(chosen)]


def _strip_at(strips: list[Strip], moment: int) -> int:
    return next(
        (index for index, strip in enumerate(strips) if moment < strip.end), len(strips) - 1
    )


def _interesting(run: Simulation) -> Iterator[int]:
    """Yield moments that a picture should show, the most important first."""
    first_overflow: dict[int, int] = {}
    longest: dict[int, tuple[int, int]] = {}
    for event in run.record.events:
        if event.kind is EventKind.OVERFLOW:
            first_overflow.setdefault(event.task, event.time)
        elif event.kind is EventKind.END:
            before = longest.get(event.task)
            if before is None or event.value > before[0]:
                longest[event.task] = (event.value, event.time)
    yield from first_overflow.values()
    for cpu in run.model.windows_cpus:
        yield _min_windows(run, cpu)
    yield from (time - response for response, time in longest.values())


def _min_windows(run: Simulation, cpu: int) -> int:
    """Return the begin of the recorded cycle in which Windows has the least time."""
    events = run.record.events
    begins = [event.time for event in events if event.kind is EventKind.INTERRUPT]
    shares = [0] * len(begins)
    cycle = 0
    edges = [*begins[1:], run.record.end]
    for begin, end in windows_times(run, cpu):
        start = begin
        while start < end:
            while edges[cycle] <= start:
                cycle += 1
            until = min(end, edges[cycle])
            shares[cycle] += until - start
            start = until
    return begins[shares.index(min(shares))]
