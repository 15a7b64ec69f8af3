# SPDX-License-Identifier: MIT
"""The timeline of a run -> lanes of bars and marks.

In: ``Timeline``, signals with two values. Out: lanes in the order in which they are shown. A
reaction and its condition share one: the condition is drawn in the background, the reaction on top,
and its number is that of its marks on the path.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import count

import numpy

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Language
from nctakt.plots.motion import Curve
from nctakt.plots.words import kind_name, slice_name
from nctakt.results.timelines.timeline import Slice, Timeline, Track
from nctakt.results.trace.recorded import Trace


@dataclass(frozen=True, slots=True)
class Bar:
    """From ``begin_s`` to ``end_s``; both are the same for a moment.

    ``name`` and ``tip`` explain it: its meaning, origin and values.
    """

    begin_s: float
    end_s: float
    name: str
    tip: str = ""


@dataclass(frozen=True, slots=True)
class Lane:
    """Bars of one subject; ``background``: when its condition was true.

    ``kind``: that of its track, or ``signal``. ``number``: of a reaction, from 1; else 0. ``text``:
    the source line of a reaction.
    """

    kind: str
    label: str
    bars: tuple[Bar, ...]
    background: tuple[Bar, ...] = ()
    number: int = 0
    text: str = ""


#: Kinds of tracks that ``lanes_of`` shows before the others, or as a part of them.
_IN_FRONT = ("program", "channel", "block", "wait", "cycle", "condition", "reaction")


@dataclass(frozen=True, slots=True)
class Arrow:
    """A signal from the lane ``sender`` to the lane ``receiver``, both by their index."""

    begin_s: float
    end_s: float
    sender: int
    receiver: int
    name: str


def arrows_of(timeline: Timeline) -> Iterator[Arrow]:
    """Yield an arrow for each signal; the lanes of the channels are the first ones."""
    rows = {track.label: row for row, track in enumerate(timeline.of("channel"))}
    for signal in timeline.signals:
        if signal.sender in rows and signal.receiver in rows:
            yield Arrow(
                signal.sent_us / 1e6,
                signal.taken_us / 1e6,
                rows[signal.sender],
                rows[signal.receiver],
                signal.name,
            )


def lanes_of(timeline: Timeline, language: Language) -> Iterator[Lane]:
    """Yield the lanes of a run."""
    programs = {track.label: track for track in timeline.of("program")}
    for track in timeline.of("channel"):
        lane = _lane(track, language)
        program = programs.get(track.label)
        background = () if program is None else _bars(program.slices, language)
        yield Lane(lane.kind, lane.label, lane.bars, background)
    for track in timeline.of("block", "wait"):
        yield _lane(track, language)
    for track in timeline.of("cycle"):
        if _tells_something(track, timeline):
            yield _lane(track, language)
    yield from _branches(timeline, language)
    for track in timeline.tracks:
        if track.kind not in _IN_FRONT:
            yield _lane(track, language)


def _tells_something(track: Track, timeline: Timeline) -> bool:
    """Return whether a cycle was anything but active from its definition to its end."""
    is_whole = len(track.slices) == 1 and track.slices[0].name == "active"
    return not is_whole or track.slices[0].begin_us > timeline.begin_us


def _branches(timeline: Timeline, language: Language) -> Iterator[Lane]:
    """Yield a lane for each branch whose body ran or whose condition was true."""
    conditions = {(track.group, track.span): track for track in timeline.of("condition")}
    numbers = count(1)
    seen: set[object] = set()
    for track in timeline.of("reaction"):
        key = (track.group, track.span)
        seen.add(key)
        condition = conditions.get(key)
        background = () if condition is None else _bars(condition.slices, language)
        yield Lane(
            track.kind,
            track.label,
            _bars(track.slices, language),
            background,
            next(numbers),
            track.text,
        )
    for key, track in conditions.items():
        if key not in seen:
            yield Lane(track.kind, track.label, (), _bars(track.slices, language), 0, track.text)


def _lane(track: Track, language: Language) -> Lane:
    label = track.label
    if track.kind not in ("axis", "spindle", "function", "channel") or not label:
        label = f"{kind_name(track.kind, language)} {label}".strip()
    return Lane(track.kind, label, _bars(track.slices, language))


def _bars(slices: Sequence[Slice], language: Language) -> tuple[Bar, ...]:
    return tuple(
        Bar(
            item.begin_us / 1e6,
            item.end_us / 1e6,
            slice_name(item.name, language),
            "\n".join(filter(None, (item.text, _position(item)))),
        )
        for item in slices
    )


def _position(item: Slice) -> str:
    return "" if item.span is None else f"{item.span.file}:{item.span.line}"


def signal_lane(name: str, curve: Curve, trace: Trace) -> Lane | None:
    """Return a lane with a bar while a signal is 1; ``None`` if it has other values than 0 and 1.

    The signal has its value from the begin of its tick.
    """
    values = curve.values
    if not len(values) or not bool(numpy.isin(values, (0.0, 1.0)).all()):
        return None
    edges = numpy.diff(numpy.concatenate(([0.0], values, [0.0])))
    tick_s = trace.cycle_time_us / 1e6
    begins = (trace.first_tick + numpy.flatnonzero(edges > 0.0)) * tick_s
    ends = (trace.first_tick + numpy.flatnonzero(edges < 0.0)) * tick_s
    bars = (
        Bar(begin, end, f"{name} = 1")
        for begin, end in zip(begins.tolist(), ends.tolist(), strict=True)
    )
    return Lane("signal", name, tuple(bars))


def joined(bars: Sequence[Bar], max_bars: int, duration_s: float) -> tuple[tuple[Bar, ...], bool]:
    """Return at most about ``max_bars`` bars, and whether close ones were joined to have so few."""
    if len(bars) <= max_bars:
        return tuple(bars), False
    gap_s = duration_s / max_bars
    kept: list[Bar] = []
    counts: list[int] = []
    for bar in bars:
        if (
            kept
            and bar.begin_s - kept[-1].end_s < gap_s
            and bar.end_s - kept[-1].begin_s < 4 * gap_s
        ):
            kept[-1] = Bar(kept[-1].begin_s, max(bar.end_s, kept[-1].end_s), bar.name, bar.tip)
            counts[-1] += 1
        else:
            kept.append(bar)
            counts.append(1)
    return (
        tuple(
            bar if number == 1 else Bar(bar.begin_s, bar.end_s, f"{number} ×")
            for bar, number in zip(kept, counts, strict=True)
        ),
        True,
    )
