# SPDX-License-Identifier: MIT
"""A run -> a file for Perfetto: tracks of slices by process, counters of signals.

In: the timeline of a run, its trace. Out: the file. Processes are the program, its realtime
cycles, the M and H functions, axes and spindles, the signals. Writing raises ``OSError``.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import count
from pathlib import Path

import numpy

from nctakt.base.diagnostics import Language, Text
from nctakt.files.perfetto import (
    TraceEvent,
    counted,
    lasting,
    moment,
    process_name,
    thread_name,
    write_perfetto_file,
)
from nctakt.plots.motion import Curve, thinned
from nctakt.plots.words import (
    CYCLES,
    FUNCTIONS,
    MOTIONS,
    PROGRAM,
    SIGNALS,
    kind_name,
    slice_name,
)
from nctakt.results.timelines.timeline import Slice, Timeline, Track, TrackKind, rows_of
from nctakt.results.trace.recorded import Trace

#: Maximum number of changes of a counter; of more the lowest and highest of each piece are kept.
MAX_CHANGES = 100_000

#: The text on the empty track of a condition or reaction.
_NEVER: dict[TrackKind, Text] = {
    "condition": Text("never true", "nie wahr"),
    "reaction": Text("never ran", "nie gelaufen"),
}

#: The processes: name, kinds of their tracks.
_PROCESSES: tuple[tuple[Text, tuple[TrackKind, ...]], ...] = (
    (
        PROGRAM,
        (
            *("program", "channel", "block", "wait", "message"),
            *("error", "starved", "overflow", "paused", "end"),
        ),
    ),
    (CYCLES, ("cycle", "condition", "reaction")),
    (FUNCTIONS, ("function",)),
    (MOTIONS, ("axis", "spindle")),
)


def write_run_perfetto(
    timeline: Timeline, trace: Trace, path: Path, language: Language = "en"
) -> None:
    """Write the file."""
    write_perfetto_file(path, _events(timeline, trace, language))


def _events(timeline: Timeline, trace: Trace, language: Language) -> Iterator[TraceEvent]:
    for pid, (name, kinds) in enumerate(_PROCESSES, 1):
        tracks = timeline.of(*kinds)
        if tracks:
            yield from process_name(pid, name.get(language), pid)
        if name is CYCLES:
            tracks.sort(key=_cycle_order)
        numbers = count(1)
        for track in tracks:
            if track.slices:
                yield from _track(track, pid, numbers, language)
            else:
                yield from _idle(track, (pid, next(numbers)), timeline.begin_us, language)
    pid = len(_PROCESSES) + 1
    if trace.signals and trace.ticks:
        yield from process_name(pid, SIGNALS.get(language), pid)
        for signal in trace.signals:
            yield from _counter(trace, signal.name, signal.unit, pid)


def _cycle_order(track: Track) -> tuple[str, int, int]:
    """Return the key that puts the branches of a cycle after it, in the order of their lines."""
    if track.kind == "cycle" or track.span is None:
        return track.label, 0, 0
    return track.group, track.span.line, track.kind == "reaction"


def _idle(
    track: Track, ids: tuple[int, int], begin_us: int, language: Language
) -> Iterator[TraceEvent]:
    """Yield a track on which nothing happens, with the reason at its begin."""
    pid, tid = ids
    yield from thread_name(pid, tid, _name(track, language), tid)
    details: dict[str, object] = {"text": track.text}
    if track.span is not None:
        details["place"] = f"{track.span.file}:{track.span.line}"
    yield moment(
        _NEVER[track.kind].get(language),
        ids,
        begin_us,
        details | {"why not": track.why_not.get(language)},
    )


def _name(track: Track, language: Language) -> str:
    if track.kind in ("axis", "spindle", "function"):
        return track.label
    name = f"{kind_name(track.kind, language)} {track.label}".strip()
    return f"{name}  {track.text}" if track.kind in ("condition", "reaction") else name


def _track(
    track: Track, pid: int, numbers: Iterator[int], language: Language
) -> Iterator[TraceEvent]:
    """Yield a track; slices that overlap get further ones of its name."""
    for row in rows_of(track):
        tid = next(numbers)
        yield from thread_name(pid, tid, _name(track, language), tid)
        for item in row:
            yield _slice(item, (pid, tid), language)


def _slice(item: Slice, track: tuple[int, int], language: Language) -> TraceEvent:
    details: dict[str, object] = {}
    if item.text:
        details["text"] = item.text
    if item.span is not None:
        details["place"] = f"{item.span.file}:{item.span.line}"
    if item.is_open:
        details["open"] = True
    name = slice_name(item.name, language)
    if item.is_moment:
        return moment(name, track, item.begin_us, details)
    return lasting(name, track, (item.begin_us, item.end_us), details)


def _counter(trace: Trace, name: str, unit: str, pid: int) -> Iterator[TraceEvent]:
    """Yield the values that differ from those of the tick before, at the end of their tick."""
    values = trace[name]
    indexes = numpy.flatnonzero(numpy.diff(values, prepend=numpy.nan) != 0.0)
    times = (trace.first_tick + 1 + indexes) * trace.cycle_time_us
    few = thinned(Curve(times.astype(numpy.float64), values[indexes]), MAX_CHANGES)
    for time, value in zip(few.time_s.tolist(), few.values.tolist(), strict=True):
        if math.isfinite(value):
            yield counted(name, pid, int(time), value, unit)
