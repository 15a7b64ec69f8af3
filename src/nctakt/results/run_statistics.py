# SPDX-License-Identifier: MIT
"""Statistics of a run, counted during it.

In: events, as a sink. Out: reactions of cycles and outputs of functions as records of
``results/run.py``, in memory that does not grow with the ticks.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Span
from nctakt.kernel import rows
from nctakt.results.run import (
    NO_FREQUENCY,
    TECHNOLOGY_KINDS,
    CycleResult,
    FrozenValue,
    MotionCount,
    OutputCount,
    Reaction,
    ReactionResult,
    SpindleJobCount,
    technology_output,
)
from nctakt.results.starving import ScheduleStatistics
from nctakt.results.trace.chunks import of_kinds, repetitions
from nctakt.results.trace.events import Event
from nctakt.results.trace.sinks import TraceHeader

#: Events that are counted.
_COUNTED = frozenset(
    (
        rows.EVENT_CREATED,
        rows.EVENT_FIRED,
        rows.EVENT_ENDED,
        rows.EVENT_TECHNOLOGY_RT,
        rows.EVENT_TECHNOLOGY,
        rows.EVENT_AXIS_BEGUN,
        rows.EVENT_AXIS_ENDLESS,
        rows.EVENT_AXIS_OSCILLATES,
        rows.EVENT_AXIS_ENDED,
        rows.EVENT_SPINDLE,
        rows.EVENT_STARVED,
        rows.EVENT_FED,
        rows.EVENT_OVERFLOW,
    )
)


@dataclass(slots=True)
class _Firings:
    frequency: str
    count: int = 0
    first_tick: int | None = None
    last_tick: int | None = None

    def add(self, first_tick: int, last_tick: int, count: int) -> None:
        self.count += count
        self.last_tick = last_tick
        if self.first_tick is None:
            self.first_tick = first_tick


@dataclass(slots=True)
class _Cycle:
    name: str
    scope: str
    span: Span | None
    instances: int = 0
    reactions: dict[Span | None, _Firings] = field(default_factory=dict)
    frozen: tuple[FrozenValue, ...] = ()


@dataclass(slots=True)
class _Output:
    first_tick: int
    count: int = 0


@dataclass(slots=True)
class _Motions:
    first_tick: int
    count: int = 0
    done: int = 0


class RunStatistics:
    """The counts of a run; a sink.

    ``reactions`` returns the branches of a cycle by its name, in the order of the text, so that
    branches that never fire are listed too; without it only firing branches are listed. The cycles
    of one definition are counted together. ``frozen`` returns the frozen values of the cycle with a
    name and a span.
    """

    def __init__(
        self,
        reactions: Callable[[str], Sequence[Reaction]] | None = None,
        frozen: Callable[[str, Span | None], Sequence[FrozenValue]] | None = None,
    ) -> None:
        self._reactions = reactions
        self._frozen = frozen
        self._cycles: dict[tuple[str, str, Span | None], _Cycle] = {}
        self._living: dict[str, _Cycle] = {}
        self._outputs: dict[tuple[str, int, bool], _Output] = {}
        self._motions: dict[tuple[str, bool, bool], _Motions] = {}
        self._jobs: dict[tuple[str, str, bool], _Output] = {}
        self.schedule = ScheduleStatistics()

    def open(self, header: TraceHeader) -> None:
        """Do nothing: the counts need no header."""

    def close(self) -> None:
        """Do nothing: the counts stay."""

    def events(self, events: Sequence[Event]) -> None:
        """Count these events."""
        for event, count, last_tick in repetitions(of_kinds(events, _COUNTED)):
            if event.kind == "created":
                self._created(event)
            elif event.kind == "fired":
                self._fired(event, count, last_tick)
            elif event.kind in TECHNOLOGY_KINDS:
                self._output(event, count)
            elif event.kind == "axis":
                self._moved(event)
            elif event.kind == "spindle":
                spindle, function, _ = event.text.split()
                key = (spindle, function, bool(event.cycle))
                self._jobs.setdefault(key, _Output(event.tick)).count += 1
            elif event.kind in ("starved", "overflow"):
                self.schedule.add(event)
            elif event.kind == "ended":
                self._living.pop(event.cycle, None)

    def _created(self, event: Event) -> None:
        scope = event.text.split()[-1]
        key = (common_name(event.cycle), scope, event.span)
        if key not in self._cycles:
            cycle = _Cycle(event.cycle, scope, event.span)
            for reaction in self._reactions(event.cycle) if self._reactions else ():
                cycle.reactions[reaction.span] = _Firings(reaction.frequency)
            self._cycles[key] = cycle
        self._cycles[key].instances += 1
        if self._frozen is not None:
            self._cycles[key].frozen = tuple(self._frozen(event.cycle, event.span))
        self._living[event.cycle] = self._cycles[key]

    def _fired(self, event: Event, count: int, last_tick: int) -> None:
        living = self._living.get(event.cycle)
        if living is None:  # a GLOBAL cycle that an earlier run of this controller created
            living = _Cycle(event.cycle, "GLOBAL", None, instances=1)
            self._living[event.cycle] = living
            self._cycles[(event.cycle, "GLOBAL", None)] = living
        span = _span_beginning_at(living.reactions, event.span)
        firings = living.reactions.setdefault(span, _Firings(NO_FREQUENCY))
        firings.add(event.tick, last_tick, count)

    def _output(self, event: Event, count: int) -> None:
        output = technology_output(event)
        key = (output.letter, output.number, event.kind != "output")
        self._outputs.setdefault(key, _Output(event.tick)).count += count

    def _moved(self, event: Event) -> None:
        """Count a motion that begins, or one that has reached its target."""
        axis, what, *_ = event.text.split()
        owner = (axis, bool(event.cycle), event.span is not None and not event.cycle)
        motions = self._motions.setdefault(owner, _Motions(event.tick))
        motions.count += what == "begun"
        motions.done += what == "done"

    def motions(self) -> tuple[MotionCount, ...]:
        """Return the independent motions of axes in the order of their first occurrence."""
        return tuple(
            MotionCount(axis, is_realtime, own.count, own.done, own.first_tick, is_of_program)
            for (axis, is_realtime, is_of_program), own in self._motions.items()
        )

    def spindle_jobs(self) -> tuple[SpindleJobCount, ...]:
        """Return the jobs of spindles in the order of their first occurrence."""
        return tuple(
            SpindleJobCount(spindle, function, is_realtime, job.count, job.first_tick)
            for (spindle, function, is_realtime), job in self._jobs.items()
        )

    def outputs(self) -> tuple[OutputCount, ...]:
        """Return the M and H functions in the order of their first output."""
        return tuple(
            OutputCount(letter, number, is_realtime, output.count, output.first_tick)
            for (letter, number, is_realtime), output in self._outputs.items()
        )

    def cycles(
        self, runs: Mapping[str, int] | None = None, bodies: Mapping[BranchKey, int] | None = None
    ) -> tuple[CycleResult, ...]:
        """Return the cycles in the order of their creation.

        ``runs``: run-throughs by name. ``bodies``: those of the bodies of branches.
        """
        ran = bodies or {}
        return tuple(
            CycleResult(
                cycle.name,
                cycle.scope,
                cycle.span,
                tuple(
                    ReactionResult(
                        span,
                        firings.frequency,
                        firings.count,
                        ran.get(branch_key(cycle.name, span), 0),
                        firings.first_tick,
                        firings.last_tick,
                    )
                    for span, firings in cycle.reactions.items()
                ),
                cycle.instances,
                self._runs(cycle, runs or {}),
                cycle.frozen,
            )
            for cycle in self._cycles.values()
        )

    def _runs(self, cycle: _Cycle, runs: Mapping[str, int]) -> int | None:
        """Return the cycle's run-throughs; ``None`` if another definition shares their count."""
        if cycle.instances > 1 and "#" in cycle.name:
            return None
        if sum(other.name == cycle.name for other in self._cycles.values()) > 1:
            return None
        return runs.get(cycle.name)


#: A branch: the name of its cycle, file, line and column.
BranchKey = tuple[str, str, int, int]


def common_name(cycle: str) -> str:
    """Return the name that a cycle shares with those of its definition: ``#`` without an ID."""
    return cycle.partition("#")[0] + "#" if "#" in cycle else cycle


def branch_key(cycle: str, span: Span | None) -> BranchKey:
    """Return the key that distinguishes a branch from others."""
    name = common_name(cycle)
    return (name, "", 0, 0) if span is None else (name, span.file, span.line, span.column)


def _span_beginning_at(spans: Mapping[Span | None, _Firings], begin: Span | None) -> Span | None:
    """Return the span with the same begin, else ``begin``: an event has no end of its span."""
    if begin is None or begin in spans:
        return begin
    for span in spans:
        if span is not None and (span.file, span.line) == (begin.file, begin.line):
            if span.column == begin.column:
                return span
    return begin
