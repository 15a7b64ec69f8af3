# SPDX-License-Identifier: MIT
"""The record of a simulation for other tools: VCD (GTKWave), Perfetto's JSON, CSV.

In: ``Simulation`` with a record. Out: the file. Writing raises ``OSError``.
"""

from __future__ import annotations

import csv
import importlib.util
import json
from collections import deque
from pathlib import Path
from typing import Any

from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.schedule_results import LIBRARY_MISSING
from nctakt.schedule.findings import us
from nctakt.schedule.gantt_layout import bit_functions
from nctakt.schedule.interpolation_steps import parts_of
from nctakt.schedule.model import NS_PER_US, PARTS
from nctakt.schedule.results import EventKind, Simulation
from nctakt.schedule.timeline import suspended_times, tick_times, windows_times
from nctakt.schedule.tracebits import BITS, calls_of, trace_bits

#: Between two calls that touch a bit is shown low for so long, and an interrupt high, in ns.
GAP = 1000

#: More timer interrupts than this are left out.
MOST_TICKS = 100_000

_EVENT_ORDER = ("END", "SUSPEND", "NC", "RESUME", "RELEASE", "OVERFLOW", "TICK", "RUN", "WINDOWS")


def check_vcd() -> None:
    """Raise ``Failure`` (900634) where no VCD file can be written."""
    if importlib.util.find_spec("vcd") is None:
        raise Failure(diagnostic(LIBRARY_MISSING, library="pyvcd", what="--vcd"))


def write_vcd(run: Simulation, path: Path) -> None:
    """Write trace bits with their functions, interrupts, who runs, is suspended, overflows.

    The unit is 1 ns.
    """
    from vcd import VCDWriter  # noqa: PLC0415 - pyvcd only when needed

    record, tasks = run.record, run.model.tasks
    changes: list[tuple[int, int, Any, int | str]] = []
    with (
        path.open("w", encoding="utf-8", newline="\n") as file,
        VCDWriter(file, timescale="1 ns", date="", init_timestamp=min(0, record.begin)) as writer,
    ):

        def level(scope: str, name: str, times: list[tuple[int, int]]) -> None:
            variable = writer.register_var(scope, name, "wire", size=1, init=0)
            for begin, end in times:
                changes.append((begin, 1, variable, 1))
                changes.append((end, 0, variable, 0))

        bits = trace_bits(run.model, record)
        for bit, names in bit_functions(run.model).items():
            level("trace", identifier("_".join((f"bit{bit}", *names))), _apart(bits[bit]))
        nc = [item.time for item in record.events if item.kind is EventKind.INTERRUPT]
        level("interrupts", "NC", [(time, time + GAP) for time in nc])
        ticks = _ticks(run)
        level("interrupts", "timer", [(time, time + GAP) for time in ticks])
        for i, task in enumerate(tasks):
            ran = [(item.begin, item.end) for item in record.segments if item.task == i]
            level("running", identifier(task.name), _merged(ran))
            level("suspended", identifier(task.name), suspended_times(run, i))
            late = [
                item.time
                for item in record.events
                if item.task == i and item.kind is EventKind.OVERFLOW
            ]
            level("overflow", identifier(task.name), [(time, time + GAP) for time in late])
        for cpu in run.model.cpus:
            variable = writer.register_var("cpu", f"cpu{cpu}", "string", init="")
            for item in record.segments:
                if item.cpu == cpu and item.end > item.begin:
                    changes.append((item.begin, 1, variable, identifier(tasks[item.task].name)))
            rest = "Windows" if cpu in run.model.windows_cpus else "idle"
            for begin, _ in windows_times(run, cpu):
                changes.append((begin, 0, variable, rest))
        for time, _, variable, value in sorted(changes, key=lambda item: item[:2]):
            writer.change(variable, time, value)


def _ticks(run: Simulation) -> range:
    """The timer interrupts of the record; none where they are too many."""
    ticks = tick_times(run.model, run.record.begin, run.record.end)
    return ticks if len(ticks) <= MOST_TICKS else range(0)


def identifier(name: str) -> str:
    """Return a name without the characters that end one in a VCD file."""
    return "".join(
        character if character.isprintable() and not character.isspace() else "_"
        for character in name
    )


def _apart(times: list[tuple[int, int]]) -> list[tuple[int, int]]:
    """Times that touch, with a gap between them that can be seen."""
    shown: list[tuple[int, int]] = []
    for begin, end in times:
        touches = bool(shown) and shown[-1][1] == begin and end - begin > GAP
        shown.append((begin + GAP if touches else begin, end))
    return shown


def _merged(times: list[tuple[int, int]]) -> list[tuple[int, int]]:
    """Times that touch as one, empty ones left out."""
    merged: list[tuple[int, int]] = []
    for begin, end in sorted(times):
        if merged and begin <= merged[-1][1]:
            merged[-1] = (merged[-1][0], max(end, merged[-1][1]))
        elif end > begin:
            merged.append((begin, end))
    return merged


def write_perfetto(run: Simulation, path: Path) -> None:
    """Chrome's trace format: processors with their slices, threads with their calls, counters."""
    events = [*_names(run), *_slices(run), *_instants(run), *_counters(run)]
    text = json.dumps({"displayTimeUnit": "ns", "traceEvents": events}, ensure_ascii=False)
    path.write_text(text, "utf-8")


def _time(time: int) -> float:
    return time / NS_PER_US


def _names(run: Simulation) -> list[dict[str, Any]]:
    names: list[dict[str, Any]] = []

    def name(kind: str, pid: int, tid: int, text: str) -> None:
        names.append({"ph": "M", "name": kind, "pid": pid, "tid": tid, "args": {"name": text}})

    name("process_name", 0, 0, "calls")
    for cpu in run.model.cpus:
        name("process_name", cpu, 0, f"CPU {cpu}")
    for i, task in enumerate(run.model.tasks):
        for pid in (0, *run.model.cpus):
            name("thread_name", pid, i + 1, task.name)
    return names


def _slices(run: Simulation) -> list[dict[str, Any]]:
    tasks, record = run.model.tasks, run.record
    slices: list[dict[str, Any]] = [
        {
            "ph": "X",
            "name": tasks[segment.task].name,
            "pid": segment.cpu,
            "tid": segment.task + 1,
            "ts": _time(segment.begin),
            "dur": _time(segment.end - segment.begin),
            "args": {"job": segment.job},
        }
        for segment in record.segments
    ]
    for call in calls_of(run.model, record):
        end = record.end if call.end is None else call.end
        slices.append(
            {
                "ph": "X",
                "name": tasks[call.task].calls[call.call].function,
                "pid": 0,
                "tid": call.task + 1,
                "ts": _time(call.begin),
                "dur": _time(end - call.begin),
                "args": {"job": call.job, "call": call.call},
            }
        )
    for part in parts_of(run.model, record):
        slices.append(
            {
                "ph": "X",
                "name": PARTS[part.part],
                "pid": 0,
                "tid": part.task + 1,
                "ts": _time(part.begin),
                "dur": _time(part.end - part.begin),
            }
        )
    return slices


def _instants(run: Simulation) -> list[dict[str, Any]]:
    shown = (EventKind.INTERRUPT, EventKind.OVERFLOW, EventKind.SUSPEND, EventKind.RESUME)
    return [
        {
            "ph": "i",
            "name": event.kind.value,
            "pid": 0,
            "tid": event.task + 1,
            "ts": _time(event.time),
            "s": "g" if event.kind is EventKind.INTERRUPT else "t",
        }
        for event in run.record.events
        if event.kind in shown
    ]


def _counters(run: Simulation) -> list[dict[str, Any]]:
    tracks = {
        f"trace bit {bit}": times
        for bit, times in trace_bits(run.model, run.record).items()
        if times and bit in BITS
    }
    for cpu in run.model.windows_cpus:
        tracks[f"Windows CPU {cpu}"] = windows_times(run, cpu)
    samples: list[dict[str, Any]] = []
    for name, times in tracks.items():
        for begin, end in times:
            for time, value in ((begin, 1), (end, 0)):
                samples.append(
                    {"ph": "C", "name": name, "pid": 0, "ts": _time(time), "args": {"": value}}
                )
    return samples


def windows_shares(run: Simulation) -> list[tuple[int, int, int]]:
    """For each recorded cycle its begin, and what Windows gets on each of its processors."""
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
    """All events, pieces of execution and shares of Windows in the order of time, in µs."""
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
