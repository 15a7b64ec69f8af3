# SPDX-License-Identifier: MIT
"""The histories of conditions -> tracks: when a condition was true, when a body ran.

In: ``WhyReport``. Out: for each branch of a realtime cycle a track of its condition and one of its
reaction, each slice with the compared values. Instances of a cycle with the same name share their
tracks, and so do unnamed definitions at one place.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator
from itertools import pairwise

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Span, Text
from nctakt.results.compared_numbers import comparison_text
from nctakt.results.explained.why import WhyReport
from nctakt.results.explained.why_text import why_never
from nctakt.results.explained.why_words import Words
from nctakt.results.histories import BranchHistory, Change
from nctakt.results.timelines.timeline import Slice, Track, TrackKind


@dataclass(slots=True)
class _Branch:
    """The history of all instances of one branch."""

    group: str
    span: Span
    text: str
    condition: str
    truths: list[Slice] = field(default_factory=list)
    bodies: list[Slice] = field(default_factory=list)
    evaluated: list[tuple[int, int]] = field(default_factory=list)
    kept: list[tuple[int, int]] = field(default_factory=list)
    truths_left_out: int = 0
    bodies_left_out: int = 0
    why_not: Text = Text("", "")


def branch_tracks(why: WhyReport, *, idle: bool = False) -> Iterator[Track]:
    """Yield the tracks of all branches that have slices, conditions first.

    ``idle``: those without slices as well, with the reason why.
    """
    branches: dict[tuple[str, Span], _Branch] = {}
    groups: dict[Span, str] = {}
    last_tick = why.first_tick + why.ticks - 1
    words = (Words("en", why.cycle_time_us), Words("de", why.cycle_time_us))
    for cycle in why.cycles:
        if not (cycle.life or idle):
            continue
        name = groups.setdefault(cycle.span, cycle.name) if "#" in cycle.name else cycle.name
        name = name or f"{cycle.span.file}:{cycle.span.line}"
        for branch in cycle.branches:
            key = (name, branch.span)
            track_branch = branches.setdefault(
                key, _Branch(name, branch.span, branch.text, branch.condition.text)
            )
            track_branch.truths += _truths(branch, why)
            track_branch.bodies += _bodies(branch, why)
            track_branch.evaluated += _evaluated(branch, why)
            track_branch.kept.append(_kept(branch, why))
            track_branch.truths_left_out += branch.condition.changes_left_out
            track_branch.bodies_left_out += branch.bodies.left_out
            if idle:
                reasons = (why_never(cycle, branch, last_tick, one) for one in words)
                track_branch.why_not = Text(*reasons)
    for track_branch in branches.values():
        if track_branch.truths or (idle and track_branch.condition and not track_branch.bodies):
            yield _track(
                track_branch,
                "condition",
                track_branch.truths,
                track_branch.truths_left_out,
                track_branch.evaluated,
            )
    for track_branch in branches.values():
        if track_branch.bodies or idle:
            begin_us, end_us = max(track_branch.kept)
            yield _track(
                track_branch,
                "reaction",
                track_branch.bodies,
                track_branch.bodies_left_out,
                [(begin_us, end_us)],
            )


def _track(
    track_branch: _Branch,
    kind: TrackKind,
    slices: list[Slice],
    left_out: int,
    known: list[tuple[int, int]],
) -> Track:
    ordered = tuple(sorted(slices, key=lambda item: item.begin_us))
    label = f"{track_branch.group}: {track_branch.span.line}"
    why_not = Text("", "") if slices else track_branch.why_not
    places = track_branch.group, track_branch.span, track_branch.text
    return Track(kind, label, ordered, *places, left_out, why_not, tuple(sorted(known)))


def _evaluated(branch: BranchHistory, why: WhyReport) -> Iterator[tuple[int, int]]:
    """Yield when the condition was evaluated, with its truth as far as it is kept."""
    condition = branch.condition
    first_tick = condition.changes[0].tick if condition.changes_left_out else why.first_tick
    for series in branch.evaluated.series:
        if series.last_tick >= first_tick:
            begin_tick = max(series.first_tick, first_tick)
            yield begin_tick * why.cycle_time_us, (series.last_tick + 1) * why.cycle_time_us


def _kept(branch: BranchHistory, why: WhyReport) -> tuple[int, int]:
    """Return since when it is kept in which ticks the body ran, and the end of the run."""
    bodies, first_tick, end_tick = branch.bodies, why.first_tick, why.first_tick + why.ticks
    if bodies.left_out:
        first_tick = bodies.series[0].first_tick if bodies.series else end_tick
    return first_tick * why.cycle_time_us, end_tick * why.cycle_time_us


def _bodies(branch: BranchHistory, why: WhyReport) -> Iterator[Slice]:
    """Yield a slice for each series of ticks in which the body ran."""
    for series in branch.bodies.series:
        yield Slice(
            series.first_tick * why.cycle_time_us,
            (series.last_tick + 1) * why.cycle_time_us,
            branch.text,
            branch.span,
            _values(branch, series.first_tick),
        )


def _truths(branch: BranchHistory, why: WhyReport) -> Iterator[Slice]:
    """Yield a slice for each time in which the condition was evaluated and true."""
    condition = branch.condition
    if not condition.text:
        return
    end_tick = why.first_tick + why.ticks
    begins: list[tuple[int, bool]] = []
    if condition.was_true is not None and not condition.changes_left_out:
        begins.append((why.first_tick, condition.was_true))
    begins += [(change.tick, change.truth) for change in condition.changes]
    begins.append((end_tick, False))
    evaluated = branch.evaluated.series
    firsts = [series.first_tick for series in evaluated]
    for (begin, truth), (end, _) in pairwise(begins):
        if not truth:
            continue
        for series in evaluated[max(0, bisect_right(firsts, begin) - 1) :]:
            first, stop = max(begin, series.first_tick), min(end, series.last_tick + 1)
            if series.first_tick >= end:
                break
            if first < stop:
                tick_us = why.cycle_time_us
                values = _values(branch, first)
                yield Slice(first * tick_us, stop * tick_us, condition.text, branch.span, values)


def _values(branch: BranchHistory, tick: int) -> str:
    """Return the compared values of the last change up to a tick: ``200.25 > 200``."""
    condition = branch.condition
    change: Change | None = None
    for item in condition.changes:
        if item.tick > tick:
            break
        change = item
    if change is None or not condition.operator:
        return ""
    if condition.operator in ("&&", "||"):
        return ""
    return comparison_text(condition.operator, change.left, change.right)
