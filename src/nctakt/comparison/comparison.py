# SPDX-License-Identifier: MIT
"""A run beside a machine's log: deviations, with the blocks and reactions where they arise."""

from __future__ import annotations

import bisect
from collections.abc import Mapping, Sequence

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Span
from nctakt.base.failure import Failure
from nctakt.comparison.alignment import Alignment, Curve, align, aligned_before
from nctakt.comparison.delays import BlockDelays, Delay
from nctakt.comparison.deviations import Deviation, deviation_of
from nctakt.comparison.log import Log, Samples
from nctakt.comparison.mapping import Pair
from nctakt.messages import diagnostic
from nctakt.messages.comparison import NO_OVERLAP, TIMES_NOT_ALIGNED
from nctakt.results.run import Run
from nctakt.trace.events import Event
from nctakt.trace.recorded import Trace

#: A reaction within this time before a place is named with it, in µs.
_REACTION_US = 100_000


@dataclass(frozen=True, slots=True)
class Running:
    """What runs at a time: the block, and the reaction that fired last before it."""

    time_us: int
    block: Span | None
    reaction: Event | None


@dataclass(frozen=True, slots=True)
class Comparison:
    """A log beside a run; ``is_within``: no signal with a tolerance leaves it."""

    log: Log
    run: Run
    trace: Trace
    alignment: Alignment
    aligned_by: str
    deviations: Sequence[Deviation]
    delays: Sequence[Delay]
    diagnostics: Sequence[Diagnostic]

    @property
    def is_within(self) -> bool:
        """Whether no signal leaves its tolerance."""
        return all(one.first_us is None for one in self.deviations)

    def running_at(self, time_us: int) -> Running:
        """Return what runs at a time of the run."""
        trace = self.trace
        tick = time_us // trace.cycle_time_us
        block = _last(_events_of(self.run, "block"), tick)
        reaction = _last(_events_of(self.run, "fired"), tick)
        if reaction is not None:
            since_us = (tick - reaction.tick) * trace.cycle_time_us
            reaction = reaction if since_us <= _REACTION_US else None
        return Running(time_us, None if block is None else block.span, reaction)


def compare(
    log: Log,
    run: Run,
    pairs: Sequence[Pair],
    tolerances: Mapping[str, float],
    offset_us: float | None = None,
    *,
    is_drawn: bool = False,
) -> Comparison:
    """Return a log beside a run, in whose trace the signals of the pairs are.

    ``tolerances``: by the names of signals, "" for all others; ``offset_us``: where the run begins
    in the log, ``None`` to find it; ``is_drawn``: keep what a picture shows. Raises ``Failure`` if
    they have no time in common (902522).
    """
    trace = run.trace
    assert trace is not None
    raw = log.read([pair.column for pair in pairs])
    samples = [
        Samples(one.times, one.values * pair.factor + pair.offset)
        for pair, one in zip(pairs, raw, strict=True)
    ]
    curves = [Curve(float(trace.cycle_time_us), trace[pair.signal.name]) for pair in pairs]
    found: list[Diagnostic] = []
    if offset_us is None:
        moving = [
            (pair.signal.name, one, curve)
            for pair, one, curve in zip(pairs, samples, curves, strict=True)
            if not pair.signal.integral
        ]
        alignment = align([(one, curve) for _, one, curve in moving])
        names = ", ".join(name for name, _, _ in moving[:3])
        if alignment.reason is not None:
            found.append(diagnostic(TIMES_NOT_ALIGNED, reason=alignment.reason))
    else:
        alignment, names = Alignment(offset_us), ""
    smooth = [
        (one, curve)
        for pair, one, curve in zip(pairs, samples, curves, strict=True)
        if not pair.signal.integral
    ]
    delays = _delays(run, smooth, alignment)
    if offset_us is None and alignment.reason is None and delays:
        alignment = aligned_before(smooth, alignment, delays[0].time_us)
        delays = _delays(run, smooth, alignment)
    deviations = []
    for pair, one, curve in zip(pairs, samples, curves, strict=True):
        limit = pair.tolerance
        if limit is None:
            limit = tolerances.get(pair.signal.name, tolerances.get(""))
        deviation = deviation_of(pair, one, curve, alignment, limit, is_drawn=is_drawn)
        if deviation is not None:
            deviations.append(deviation)
    if not deviations:
        raise Failure(diagnostic(NO_OVERLAP, offset=f"{alignment.offset_us / 1e6:.6f}"))
    return Comparison(log, run, trace, alignment, names, deviations, delays, [*log.notes, *found])


def _delays(run: Run, pairs: Sequence[tuple[Samples, Curve]], alignment: Alignment) -> list[Delay]:
    delays = BlockDelays(_events_of(run, "block"))
    for samples, curve in pairs:
        delays.add(samples, curve, alignment)
    return delays.found()


def _events_of(run: Run, kind: str) -> list[Event]:
    return [event for event in run.events if event.kind == kind]


def _last(events: Sequence[Event], tick: int) -> Event | None:
    """Return the last of the events up to a tick."""
    at = bisect.bisect_right(events, tick, key=lambda event: event.tick)
    return events[at - 1] if at else None
