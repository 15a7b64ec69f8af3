# SPDX-License-Identifier: MIT
"""Slices, moments and counters -> a file in Chrome's trace format, which Perfetto reads.

In: events, made by the functions here; times in µs. Out: the file. A track is a pair of numbers,
process and thread; slices of one track must not overlap unless one holds the other.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

TraceEvent = dict[str, Any]


def process_name(pid: int, name: str, order: int | None = None) -> list[TraceEvent]:
    """Return the events that name a process, and with ``order`` say where it is shown."""
    events = [_metadata("process_name", pid, 0, {"name": name})]
    if order is not None:
        events.append(_metadata("process_sort_index", pid, 0, {"sort_index": order}))
    return events


def thread_name(pid: int, tid: int, name: str, order: int | None = None) -> list[TraceEvent]:
    """Return the events that name a track of a process, and with ``order`` say where it is."""
    events = [_metadata("thread_name", pid, tid, {"name": name})]
    if order is not None:
        events.append(_metadata("thread_sort_index", pid, tid, {"sort_index": order}))
    return events


def _metadata(kind: str, pid: int, tid: int, arguments: dict[str, Any]) -> TraceEvent:
    return {"ph": "M", "name": kind, "pid": pid, "tid": tid, "args": arguments}


def lasting(
    name: str,
    track: tuple[int, int],
    times: tuple[float, float],
    arguments: Mapping[str, object] | None = None,
) -> TraceEvent:
    """Return a slice from the first to the second time."""
    begin, end = times
    event = {"ph": "X", "name": name, "pid": track[0], "tid": track[1]}
    event |= {"ts": begin, "dur": round(end - begin, 3)}
    return {**event, "args": dict(arguments)} if arguments else event


def moment(
    name: str,
    track: tuple[int, int],
    time: float,
    arguments: Mapping[str, object] | None = None,
    *,
    is_global: bool = False,
) -> TraceEvent:
    """Return a moment; a global one is shown over all tracks."""
    event = {"ph": "i", "name": name, "pid": track[0], "tid": track[1], "ts": time}
    event["s"] = "g" if is_global else "t"
    return {**event, "args": dict(arguments)} if arguments else event


def counted(name: str, pid: int, time: float, value: float, unit: str = "") -> TraceEvent:
    """Return the value of a counter from a time on."""
    return {"ph": "C", "name": name, "pid": pid, "ts": time, "args": {unit: value}}


def write_perfetto_file(path: Path, events: Iterable[TraceEvent]) -> None:
    """Write the events, one on a line; raises ``OSError``."""
    with path.open("w", encoding="utf-8", newline="\n") as file:
        file.write('{"displayTimeUnit": "ns", "traceEvents": [')
        for number, event in enumerate(events):
            text = json.dumps(event, ensure_ascii=False, allow_nan=False)
            file.write(f"{',' if number else ''}\n{text}")
        file.write("\n]}\n")
