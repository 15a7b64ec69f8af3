# SPDX-License-Identifier: MIT
"""A run -> a VCD or FST file: signals, the current block, cycles, conditions, reactions, functions.

In: the timeline of a run, its trace. Out: the file; its unit is 1 µs. Names are English in every
language, since scripts read them. Writing raises ``OSError``.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from pathlib import Path

import numpy

from nctakt.files.fst import write_fst_file
from nctakt.files.vcd import VcdVariable, apart, levels, merged, truths, write_vcd_file
from nctakt.results.timelines.timeline import Timeline, Track, TrackKind
from nctakt.results.trace.recorded import Trace

#: Between two slices that touch, a wire is low for this long, in µs; a moment is high for as long.
GAP_US = 1

#: The scopes of axes and spindles.
_SCOPES: dict[TrackKind, str] = {"axis": "axes", "spindle": "spindles"}


def write_run_vcd(timeline: Timeline, trace: Trace, path: Path) -> None:
    """Write the file."""
    variables = [*_tracks(timeline), *_signals(trace)]
    write_vcd_file(path, variables, timescale="1 us", begin=timeline.begin_us)


def write_run_fst(timeline: Timeline, trace: Trace, path: Path) -> None:
    """Write the same as an FST file."""
    variables = [*_tracks(timeline), *_signals(trace)]
    write_fst_file(path, variables, exponent=-6, begin=timeline.begin_us)


def _tracks(timeline: Timeline) -> Iterator[VcdVariable]:
    for track in timeline.tracks:
        times = [(item.begin_us, item.end_us) for item in track.slices]
        cycle = ("cycles", _plain(f"cycle_{track.group or track.label}"))
        if track.kind == "cycle":
            yield VcdVariable(cycle, "state", "text", _texts(track))
        elif track.kind in ("condition", "reaction"):
            name = f"{track.kind}_line_{track.span.line if track.span else 0}"
            yield _truth(track, (*cycle, name), apart(merged(times), GAP_US), timeline.begin_us)
            if track.why_not.en and track.kind == "reaction":
                line = track.span.line if track.span else 0
                reason = [(timeline.begin_us, track.why_not.en)]
                yield VcdVariable(cycle, f"why_not_line_{line}", "text", reason)
        elif track.kind == "function":
            lasting = [(begin, max(end, begin + GAP_US)) for begin, end in times]
            wires = levels(_separated(lasting))
            yield VcdVariable(("functions",), _plain(track.label), "wire", wires)
        elif track.kind in ("axis", "spindle"):
            yield VcdVariable((_SCOPES[track.kind],), _plain(track.label), "text", _texts(track))
        else:
            scopes = ("program", *filter(None, (_plain(track.label),)))
            yield VcdVariable(scopes, track.kind, "text", _texts(track))


def _truth(
    track: Track, names: tuple[str, ...], times: list[tuple[int, int]], begin_us: int
) -> VcdVariable:
    """Return a condition, or a reaction: x where a condition was not evaluated.

    Also before the older ticks of which nothing is kept any more.
    """
    *scope, name = names
    if track.kind == "reaction" and all(first <= begin_us for first, _ in track.known):
        return VcdVariable(tuple(scope), name, "wire", levels(times))
    return VcdVariable(tuple(scope), name, "truth", truths(track.known, times))


def _separated(times: list[tuple[int, int]]) -> list[tuple[int, int]]:
    """Return the times with overlapping ones merged; those that only touch stay separate."""
    joined: list[tuple[int, int]] = []
    for begin, end in sorted(times):
        if joined and begin < joined[-1][1]:
            joined[-1] = (joined[-1][0], max(end, joined[-1][1]))
        else:
            joined.append((begin, end))
    return apart(joined, GAP_US)


def _texts(track: Track) -> Iterator[tuple[int, str]]:
    """Yield the name of the current slice, an empty one between slices."""
    end_us = -1
    for item in track.slices:
        if item.begin_us < end_us and item.is_moment:
            continue  # a second one at the same moment
        if end_us >= 0 and item.begin_us > end_us:
            yield end_us, ""
        name = item.name
        if track.kind == "block" and item.text:
            name = item.text
        yield item.begin_us, name
        end_us = item.begin_us + GAP_US if item.is_moment else item.end_us
    if end_us >= 0:
        yield end_us, ""


def _signals(trace: Trace) -> Iterator[VcdVariable]:
    for signal in trace.signals:
        *scope, name = signal.name.split(".")
        yield VcdVariable(
            ("signals", *map(_plain, scope)),
            _plain(name),
            "integer" if signal.integral else "real",
            _changes(trace, signal.name, is_integral=signal.integral),
        )


def _changes(trace: Trace, name: str, *, is_integral: bool) -> Iterator[tuple[int, int | float]]:
    """Yield the values that differ from those of the tick before, at the end of their tick."""
    values = trace[name]
    if not len(values):
        return
    indexes = numpy.flatnonzero(numpy.diff(values, prepend=numpy.nan) != 0.0)
    first = trace.first_tick + 1
    for index in indexes.tolist():
        value = float(values[index])
        if math.isfinite(value):
            yield (first + index) * trace.cycle_time_us, int(value) if is_integral else value


def _plain(name: str) -> str:
    """Return a name of letters, digits and brackets: dots and colons divide names in viewers."""
    return re.sub(r"[^\w()\-+]", "_", name.replace("[", "(").replace("]", ")").replace("#", "n"))
