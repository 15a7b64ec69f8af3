# SPDX-License-Identifier: MIT
"""A run compared with a machine's log: deviations, with the blocks and reactions involved."""

from __future__ import annotations

import bisect
from collections.abc import Mapping, Sequence
from functools import partial

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Span
from nctakt.base.failure import Failure
from nctakt.comparison.aligning_event import GivenTime
from nctakt.comparison.alignment import Alignment, Curve
from nctakt.comparison.delay_search import Delays, DelaySearch
from nctakt.comparison.delays import BlockDelays, Delay
from nctakt.comparison.deviations import Deviation, deviation_of
from nctakt.comparison.log import Log, LogColumn, Samples
from nctakt.comparison.mapping import Pair, Tolerance
from nctakt.comparison.recorded import Recorded
from nctakt.messages import diagnostic
from nctakt.messages.commands.comparison import BEGIN_UNCERTAIN, NO_OVERLAP, TIMES_NOT_ALIGNED
from nctakt.results.run import Run
from nctakt.results.trace.events import Event

#: A reaction within this time before a place is named with it, in µs.
_REACTION_US = 100_000
#: Begin and drift are to be found.
NOTHING_GIVEN = GivenTime()


@dataclass(frozen=True, slots=True)
class Running:
    """The activity at a time: the block, and the reaction that fired last before it."""

    time_us: int
    block: Span | None
    reaction: Event | None


@dataclass(frozen=True, slots=True)
class Comparison:
    """A log compared with a run; ``is_within``: no signal with a tolerance leaves it."""

    log: Log
    run: Run
    recorded: Recorded
    alignment: Alignment
    aligned_by: str
    given: GivenTime
    compared: Sequence[LogColumn]
    deviations: Sequence[Deviation]
    delays: Delays
    diagnostics: Sequence[Diagnostic]
    blocks: Sequence[Event]
    reactions: Sequence[Event]

    @property
    def is_within(self) -> bool:
        """Whether no signal leaves its tolerance."""
        return all(one.first_us is None for one in self.deviations)

    def running_at(self, time_us: int) -> Running:
        """Return the activity at a time of the run."""
        tick = time_us // self.run.cycle_time_us
        block = _last(self.blocks, tick)
        reaction = _last(self.reactions, tick)
        if reaction is not None:
            since_us = (tick - reaction.tick) * self.run.cycle_time_us
            reaction = reaction if since_us <= _REACTION_US else None
        return Running(time_us, None if block is None else block.span, reaction)


def compare(
    log: Log,
    run: Run,
    recorded: Recorded,
    pairs: Sequence[Pair],
    tolerances: Mapping[str, Tolerance],
    given: GivenTime = NOTHING_GIVEN,
    *,
    kept: int = 0,
) -> Comparison:
    """Compare a log with a run, of which ``recorded`` has the signals of the pairs.

    ``tolerances``: by the names of signals, "" for all others; ``given``: known facts about the
    log's time; ``kept``: how many samples of each pair are kept, as ``deviation_of`` does. Raises
    ``Failure`` if they have no time in common (902522).
    """
    raw = log.read([pair.column for pair in pairs])
    samples = [one.scaled(pair.factor, pair.offset) for pair, one in zip(pairs, raw, strict=True)]
    period_us = float(recorded.cycle_time_us)
    curves = [Curve(period_us, recorded[pair.signal.name]) for pair in pairs]
    triples = list(zip(pairs, samples, curves, strict=True))
    smooth = [(one, curve) for pair, one, curve in triples if not pair.signal.integral]
    alignment = given.alignment(smooth, recorded)
    beside = partial(
        _beside,
        triples,
        recorded.blocks,
        recorded.cycle_time_us,
        tolerances=tolerances,
        kept=kept,
    )
    deviations, late = beside(alignment)
    delays = Delays()
    search = DelaySearch(smooth, recorded.blocks, recorded.cycle_time_us)
    if alignment.reason is None and (late or search.is_apart(alignment)):
        if given.begin is None:
            nearer = search.begun(alignment)
            if nearer is not alignment:
                alignment = nearer
                deviations, _ = beside(alignment)
        delays = search.delays(alignment)
    if not deviations:
        raise Failure(diagnostic(NO_OVERLAP, offset=f"{alignment.offset_us / 1e6:.6f}"))
    names = [pair.signal.name for pair in pairs if not pair.signal.integral and given.begin is None]
    return Comparison(
        log,
        run,
        recorded,
        alignment,
        ", ".join(names[:3]),
        given,
        [pair.column for pair in pairs],
        deviations,
        delays,
        _findings(log, alignment, is_searched=given.begin is None),
        recorded.blocks,
        recorded.reactions,
    )


def _findings(log: Log, alignment: Alignment, *, is_searched: bool) -> list[Diagnostic]:
    """Return the questions left open by reading and aligning the log."""
    # it may have been read before
    found = [one for at, one in enumerate(log.notes) if one not in log.notes[:at]]
    if alignment.reason is not None:
        found.append(diagnostic(TIMES_NOT_ALIGNED, reason=alignment.reason))
    elif is_searched and alignment.is_uncertain:
        quality, gain = f"{alignment.quality:.2f}", f"{alignment.gain:.2f}"
        found.append(diagnostic(BEGIN_UNCERTAIN, quality=quality, gain=gain))
    return found


def _beside(
    triples: Sequence[tuple[Pair, Samples, Curve]],
    blocks: Sequence[Event],
    cycle_time_us: int,
    alignment: Alignment,
    *,
    tolerances: Mapping[str, Tolerance],
    kept: int,
) -> tuple[list[Deviation], list[Delay]]:
    """Return the deviations, and from which blocks on the log is late, in one pass."""
    delays = BlockDelays(blocks, cycle_time_us, alignment.is_scaled)
    deviations = [
        deviation_of(
            pair,
            samples,
            curve,
            alignment,
            _tolerance(pair, tolerances),
            delays=delays,
            kept=kept,
        )
        for pair, samples, curve in triples
    ]
    return [one for one in deviations if one is not None], delays.found()


def _tolerance(pair: Pair, tolerances: Mapping[str, Tolerance]) -> Tolerance | None:
    if pair.tolerance is not None:
        return pair.tolerance
    return tolerances.get(pair.signal.name, tolerances.get(""))


def _last(events: Sequence[Event], tick: int) -> Event | None:
    """Return the last of the events up to a tick."""
    at = bisect.bisect_right(events, tick, key=lambda event: event.tick)
    return events[at - 1] if at else None
