# SPDX-License-Identifier: MIT
"""The record of a simulation for other tools: VCD (GTKWave), Perfetto's JSON, CSV.

In: ``Simulation`` with a record. Out: the file. Writing raises ``OSError``.
"""

from __future__ import annotations

import csv
from collections import deque
from collections.abc import Iterator
from pathlib import Path

from nctakt.files.perfetto import (
    TraceEvent,
    counted,
    lasting,
    moment,
    process_name,
    thread_name,
    write_perfetto_file,
)
from nctakt.files.vcd import VcdVariable, apart, identifier, levels, merged, write_vcd_file
from nctakt.schedule.analysis.findings import us
from nctakt.schedule.model import NS_PER_US, PARTS
from nctakt.schedule.pictures.gantt_layout import bit_functions
from nctakt.schedule.simulation.interpolation_steps import parts_of
from nctakt.schedule.simulation.results import EventKind, Simulation
from nctakt.schedule.simulation.timeline import suspended_times, tick_times, windows_times
from nctakt.schedule.simulation.tracebits import BITS, calls_of, trace_bits

#: Time in ns for which a bit is low between two touching calls, and an interrupt high.
GAP = 1000

#: More timer interrupts than this are left out.
MAX_TICKS = 100_000

_EVENT_ORDER = ("END", "SUSPEND", "NC", "RESUME", "RELEASE", "OVERFLOW", "TICK", "RUN", "WINDOWS")


def write_vcd(run: Simulation, path: Path) -> None:
    """Write trace bits with their functions, interrupts, who runs, is suspended, overflows.

    The unit is 1 ns.
    """
    write_vcd_file(path, _variables(run), timescale="1 ns", begin=min(0, run.record.begin))


def _variables(run: Simulation) -> Iterator[VcdVariable]:
    record, tasks = run.record, run.model.tasks

    def level(scope: str, name: str, times: list[tuple[int, int]]) -> VcdVariable:
        return VcdVariable((scope,), name, "wire", levels(times))

    bits = trace_bits(run.model, record)
    for bit, names in bit_functions(run.model).items():
        yield level("trace", "_".join((f"bit{bit}", *names)), apart(bits[bit], GAP))
    nc = [item.time for item in record.events if item.kind is EventKind.INTERRUPT]
    yield level("interrupts", "NC", [(time, time + GAP) for time in nc])
    yield level("interrupts", "timer", [(time, time + GAP) for time in _ticks(run)])
    for i, task in enumerate(tasks):
        ran = [(item.begin, item.end) for item in record.segments if item.task == i]
        yield level("running", task.name, merged(ran))
        yield level("suspended", task.name, suspended_times(run, i))
        late = [
            item.time
            for item in record.events
            if item.task == i and item.kind is EventKind.OVERFLOW
        ]
        yield level("overflow", task.name, [(time, time + GAP) for time in late])
    for cpu in run.model.cpus:
        rest = "Windows" if cpu in run.model.windows_cpus else "idle"
        changes = [(begin, 0, rest) for begin, _ in windows_times(run, cpu)]
        changes += [
            (item.begin, 1, tasks[item.task].name)
            for item in record.segments
            if item.cpu == cpu and item.end > item.begin
        ]
        changes.sort(key=lambda change: change[:2])
        yield VcdVariable(
            ("cpu",), f"cpu{cpu}", "text", ((time, identifier(name)) for time, _, name in changes)
        )


def _ticks(run: Simulation) -> range:
    """The timer interrupts of the record; none if there are too many."""
    ticks = tick_times(run.model, run.record.begin, run.record.end)
    return ticks if len(ticks) <= MAX_TICKS else range(0)


def write_perfetto(run: Simulation, path: Path) -> None:
    """Write Chrome's trace format: slices of processors, calls of threads, counters."""
    events = [*_names(run), *_slices(run), *_moments(run), *_counters(run)]
    write_perfetto_file(path, events)


def _time(time: int) -> float:
    return time / NS_PER_US


def _names(run: Simulation) -> Iterator[TraceEvent]:
    yield from process_name(0, "calls")
    for cpu in run.model.cpus:
        yield from process_name(cpu, f"CPU {cpu}")
    for i, task in enumerate(run.model.tasks):
        for pid in (0, *run.model.cpus):
            yield from thread_name(pid, i + 1, task.name)


def _slices(run: Simulation) -> Iterator[TraceEvent]:
    tasks, record = run.model.tasks, run.record
    for segment in record.segments:
        track = (segment.cpu, segment.task + 1)
        times = (_time(segment.begin), _time(segment.end))
        yield lasting(tasks[segment.task].name, track, times, {"job": segment.job})
    for call in calls_of(run.model, record):
        times = (_time(call.begin), _time(record.end if call.end is None else call.end))
        name = tasks[call.task].calls[call.call].function
        yield lasting(name, (0, call.task + 1), times, {"job": call.job, "call": call.call})
    for part in parts_of(run.model, record):
        times = (_time(part.begin), _time(part.end))
        yield lasting(PARTS[part.part], (0, part.task + 1), times)


def _moments(run: Simulation) -> Iterator[TraceEvent]:
    shown = (EventKind.INTERRUPT, EventKind.OVERFLOW, EventKind.SUSPEND, EventKind.RESUME)
    for event in run.record.events:
        if event.kind in shown:
            is_global = event.kind is EventKind.INTERRUPT
            track = (0, event.task + 1)
            yield moment(event.kind.value, track, _time(event.time), is_global=is_global)


def _counters(run: Simulation) -> Iterator[TraceEvent]:
    tracks = {
        f"trace bit {bit}": times
        for bit, times in trace_bits(run.model, run.record).items()
        if times and bit in BITS
    }
    for cpu in run.model.windows_cpus:
        tracks[f"Windows CPU {cpu}"] = windows_times(run, cpu)
    for name, times in tracks.items():
        for begin, end in times:
            yield counted(name, 0, _time(begin), 1)
            yield counted(name, 0, _time(end), 0)


def windows_shares(run: Simulation) -> list[tuple[int, int, int]]:
    """Return for each recorded cycle its start and the share of Windows per processor, in ns."""
    events = run.record.events
    begins = [event.time for event in events if event.kind is EventKind.INTERRUPT]
    ends = [*begins[1:], run.record.end]
    shares: list[tuple[int, int, int]] = []
    for cpu in run.model.windows_cpus:
        free = deque(windows_times(run, cpu))
        for begin, end in zip(begins, ends, strict=True):
            share = 0
            while free and free[0][0] < end:
                start, stop = free.popleft()
                share += min(stop, end) - max(start, begin)
                if stop > end:
                    free.appendleft((end, stop))
            shares.append((begin, cpu, share))
    return shares


def write_csv(run: Simulation, path: Path) -> None:
    """Write events, pieces of execution and shares of Windows in the order of time, in µs."""
    tasks, record = run.model.tasks, run.record
    rows: list[tuple[int, str, str, str, str, str]] = []
    for event in record.events:
        name = tasks[event.task].name if event.task >= 0 else ""
        is_count = event.kind in (EventKind.INTERRUPT, EventKind.RELEASE)
        value = str(event.value) if is_count else us(event.value)
        rows.append((event.time, event.kind.value, name, "", "", value))
    for time in _ticks(run):
        rows.append((time, "TICK", "", "", "", ""))
    for segment in record.segments:
        cells = (
            tasks[segment.task].name,
            str(segment.cpu),
            str(segment.job),
            us(segment.end - segment.begin),
        )
        rows.append((segment.begin, "RUN", *cells))
    for begin, cpu, share in windows_shares(run):
        rows.append((begin, "WINDOWS", "", str(cpu), "", us(share)))
    rows.sort(key=lambda row: (row[0], _EVENT_ORDER.index(row[1])))
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(("time_us", "event", "thread", "cpu", "job", "value"))
        writer.writerows((us(time), *cells) for time, *cells in rows)
