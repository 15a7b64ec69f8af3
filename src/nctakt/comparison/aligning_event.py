# SPDX-License-Identifier: MIT
"""An event that both sides have, by which a log is laid on a run (LG-701).

In: its text: ``X.ACS.ACT_POS > 10``, ``V.E.GATE rises``, or a function or a block of the run and an
edge of a column of the log, ``M10 @ MAIN.bDone rises``. Out: the first time that it happens on each
side. A time is that of the first sample that has it, on a curve the place between two samples.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

import numpy

from nctakt.base.dataclass import dataclass
from nctakt.base.failure import Failure
from nctakt.comparison.alignment import Alignment, Curve, align, placed
from nctakt.comparison.columns import Numbers
from nctakt.comparison.log import Log, Samples
from nctakt.comparison.mapping import Pair
from nctakt.comparison.recorded import Recorded
from nctakt.messages import diagnostic
from nctakt.messages.commands.comparison import EVENT_NOT_IN_LOG, EVENT_NOT_IN_RUN, EVENT_UNREADABLE
from nctakt.results.trace.events import Event
from nctakt.results.trace.sinks import Signal

_EDGE = re.compile(r"(?P<name>\S.*?)\s*(?:\b(?P<edge>rises|falls)|(?P<sign>[<>])\s*(?P<limit>\S+))")
_FUNCTION = re.compile(r"[MH]\d+")
_BLOCK = re.compile(r"(?P<file>.+):(?P<line>\d+)")
#: A truth is true from here on.
_HALF = 0.5


@dataclass(frozen=True, slots=True)
class Edge:
    """A value that becomes greater than a limit, or less than it."""

    name: str
    limit: float
    is_rising: bool

    def first(self, samples: Samples, *, is_whole: bool) -> tuple[float, float] | None:
        """Return when it happens first, and the time since the sample before; both in µs.

        ``is_whole``: there is nothing between two values. ``None`` if it never happens.
        """
        before_us, before = numpy.nan, numpy.nan
        for times, values in samples.stretches():
            is_past = values > self.limit if self.is_rising else values < self.limit
            was_past = before > self.limit if self.is_rising else before < self.limit
            starts = numpy.flatnonzero(is_past & ~numpy.append(was_past, is_past[:-1]))
            for at in starts.tolist():
                if at or not numpy.isnan(before):
                    time = float(times[at])
                    last_us, last = (times[at - 1], values[at - 1]) if at else (before_us, before)
                    share = 1.0 if is_whole else (self.limit - last) / (values[at] - last)
                    return float(last_us + share * (time - last_us)), float(time - last_us)
            before_us, before = times[-1], values[-1]
        return None


@dataclass(frozen=True, slots=True)
class AligningEvent:
    """An event: ``in_run`` is an edge of a signal, or the name of a function or a block."""

    text: str
    in_run: Edge | str
    in_log: Edge

    @classmethod
    def of(cls, text: str) -> AligningEvent:
        """Return that of a text; raises ``Failure`` (902845)."""
        ours, has_own, theirs = (part.strip() for part in text.partition("@"))
        run_edge, log_edge = _edge(ours), _edge(theirs if has_own else ours)
        in_run: Edge | str | None = run_edge
        if run_edge is None and (_FUNCTION.fullmatch(ours) or _BLOCK.fullmatch(ours)):
            in_run = ours
        if in_run is None or log_edge is None:
            raise Failure(diagnostic(EVENT_UNREADABLE, text=text))
        return cls(text, in_run, log_edge)

    @property
    def signal(self) -> str:
        """The signal that the run must record for it, "" for none."""
        return self.in_run.name if isinstance(self.in_run, Edge) else ""

    def run_us(self, recorded: Recorded, signals: Mapping[str, Signal]) -> float:
        """Return when it happens in a run; raises ``Failure`` (902846)."""
        tick_us = float(recorded.cycle_time_us)
        if isinstance(self.in_run, str):
            found = _event_tick(recorded, self.in_run)
            if found is not None:
                return found * tick_us
        else:
            values = recorded[self.in_run.name]
            ticks = _Ticks(len(values), tick_us)
            whole = signals[self.in_run.name].integral
            time = self.in_run.first(Samples(ticks, values), is_whole=whole)
            if time is not None:
                return time[0]
        raise Failure(diagnostic(EVENT_NOT_IN_RUN, event=self.text))

    def log_us(
        self, log: Log, pairs: Sequence[Pair], signals: Mapping[str, Signal]
    ) -> tuple[float, float]:
        """Return when it happens in a log, and how far its sample before is; raises ``Failure``."""
        own = self.in_log.name
        pair = next((one for one in pairs if one.signal.name == own), None)
        column = next((one for one in log.columns if one.name == own), None)
        if pair is None and column is None:
            raise self._not_in(log, f"{own}?")
        if pair is not None:
            (samples,) = log.read([pair.column])
            samples = samples.scaled(pair.factor, pair.offset)
        else:
            assert column is not None
            (samples,) = log.read([column])
        signal = signals.get(own)
        is_whole = signal.integral if signal is not None else self.in_log.limit == _HALF
        found = self.in_log.first(samples, is_whole=is_whole)
        if found is None:
            raise self._not_in(log, f"{samples.first_us / 1e6:g} … {samples.last_us / 1e6:g} s")
        return found

    def _not_in(self, log: Log, reason: str) -> Failure:
        return Failure(diagnostic(EVENT_NOT_IN_LOG, event=self.text, file=log.file, reason=reason))


@dataclass(frozen=True, slots=True)
class EventInLog:
    """An event with its time in a log, and how far its sample before is; both in µs."""

    event: AligningEvent
    time_us: float
    apart_us: float
    signals: Mapping[str, Signal]


@dataclass(frozen=True, slots=True)
class GivenTime:
    """Given facts about a log's time: where the run begins, in µs or by an event, and the drift.

    Values that are ``None`` are to be found.
    """

    begin: float | EventInLog | None = None
    drift: float | None = None

    @property
    def event(self) -> EventInLog | None:
        """The event that the log is laid by."""
        return self.begin if isinstance(self.begin, EventInLog) else None

    def alignment(self, pairs: Sequence[tuple[Samples, Curve]], recorded: Recorded) -> Alignment:
        """Return the log's position relative to a run; raises ``Failure`` (902846)."""
        if self.begin is None:
            return align(pairs, self.drift)
        if isinstance(self.begin, EventInLog):
            run_us = self.begin.event.run_us(recorded, self.begin.signals)
            return placed(pairs, self.begin.time_us, run_us, self.drift)
        return placed(pairs, self.begin, 0.0, self.drift)


class _Ticks:
    """The times of ticks as a column."""

    def __init__(self, count: int, tick_us: float) -> None:
        self._count, self._tick_us = count, tick_us

    def __len__(self) -> int:
        return self._count

    def __getitem__(self, rows: slice, /) -> Numbers:
        ticks = numpy.arange(*rows.indices(self._count), dtype=numpy.float64)
        return ticks * self._tick_us


def _edge(text: str) -> Edge | None:
    match = _EDGE.fullmatch(text)
    if match is None:
        return None
    if match["edge"]:
        return Edge(match["name"], _HALF, match["edge"] == "rises")
    try:
        limit = float(match["limit"])
    except ValueError:
        return None
    return Edge(match["name"], limit, match["sign"] == ">") if numpy.isfinite(limit) else None


def _event_tick(recorded: Recorded, name: str) -> int | None:
    """Return the tick in which a function goes out or a block begins first."""
    block = _BLOCK.fullmatch(name)
    events: Sequence[Event] = recorded.functions if block is None else recorded.blocks
    for event in events:
        if block is None:
            if _function_of(event) == name:
                return event.tick
        elif event.span is not None and event.span.line == int(block["line"]):
            if event.span.file.replace("\\", "/").endswith(block["file"].replace("\\", "/")):
                return event.tick
    return None


def _function_of(event: Event) -> str:
    """Return the function of an event: ``M 10`` of a block, ``100 1 159000`` of a cycle's M."""
    words = event.text.split()
    return "".join(words[:2]) if event.kind == "output" else event.kind + words[0]
