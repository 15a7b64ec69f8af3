# SPDX-License-Identifier: MIT
"""What a run gives back: how far it came, what its realtime cycles did, what it put out.

In: events, as the run goes on (``RunStatistics`` is a sink), and what the controller knows at its
end. Out: ``Run``, which is the same for the same inputs: it holds no wall-clock time.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Literal

from nctakt.base.diagnostics import Diagnostic, Severity, Span
from nctakt.results.coverage import Coverage
from nctakt.results.starving import OverflowCount, ScheduleStatistics, Starvation
from nctakt.results.user_errors import UserErrorReport, user_errors
from nctakt.results.why import WhyReport
from nctakt.schedule.open_schedule import RunSchedule
from nctakt.trace.events import Event
from nctakt.trace.recorded import Trace
from nctakt.trace.sinks import TraceHeader

#: ``ended``: all programs ran to their end. ``error``: an NC error stopped the run. ``limit``: the
#: limit of ticks came first. ``reset``: RESET on the HLI. ``interrupted``: the user broke it off.
RunState = Literal["ended", "error", "limit", "reset", "interrupted"]

#: The frequency of a branch that has none (a plain ``$IF``, ``$ELSEIF``, ``$ELSE``).
NO_FREQUENCY = ""


@dataclass(frozen=True, slots=True)
class SaidMessage:
    """A ``#MSG`` as it comes; ``exclusive`` and ``unbroken`` are for the message file.

    There it stands without its time stamp if it is exclusive, without line end if unbroken.
    ``channel``: its number where the machine has more than one, else 0.
    ``file``: where the program wants a saved one to be (#FILENAME), empty without a wish.
    """

    time_us: int
    text: str
    exclusive: bool = False
    unbroken: bool = False
    channel: int = 0
    file: str = ""


@dataclass(frozen=True, slots=True)
class Reaction:
    """A branch of a realtime cycle: its place and ``ONCE``, ``EDGE``, ``ALWAYS`` or nothing."""

    span: Span
    frequency: str = NO_FREQUENCY


@dataclass(frozen=True, slots=True)
class FrozenValue:
    """An asynchronous variable of a realtime cycle: its name, its place in the cycle, its value.

    That is the one which it had when the definition was decoded (RC-302); the cycle sees no other.
    """

    name: str
    value: float
    span: Span


@dataclass(frozen=True, slots=True)
class ReactionResult:
    """How often a branch fired: ``count`` series of run-throughs in which its body ran.

    ``first_tick`` and ``last_tick`` are the ticks in which the first and the last series began,
    ``None`` when there was none.
    """

    span: Span | None
    frequency: str
    count: int
    first_tick: int | None
    last_tick: int | None


@dataclass(frozen=True, slots=True)
class CycleResult:
    """A realtime cycle: ID (``#1`` without one), scope, place of its definition, reactions.

    ``instances`` says how often this definition was executed. ``runs`` is the number of its
    run-throughs since its creation, ``None`` where they are not counted for it alone. ``frozen``
    are the asynchronous values in it, those of its latest instance.
    """

    name: str
    scope: str
    span: Span | None
    reactions: tuple[ReactionResult, ...]
    instances: int = 1
    runs: int | None = None
    frozen: tuple[FrozenValue, ...] = ()


@dataclass(frozen=True, slots=True)
class OutputCount:
    """How often an M or H function was put out; ``realtime``: by a realtime cycle."""

    letter: str
    number: int
    realtime: bool
    count: int
    first_tick: int


@dataclass(frozen=True, slots=True)
class TechnologyOutput:
    """One M or H function that was put out.

    ``sequence`` is its number within the tick in the realtime section (RC-403), 0 for a function
    of the main program.
    """

    tick: int
    time_us: int
    letter: str
    number: int
    sequence: int
    span: Span | None
    cycle: str


@dataclass(frozen=True, slots=True)
class Run:
    """The result of one call of ``Controller.run``.

    ``ticks`` were run, from tick ``first_tick`` of the controller on. ``trace`` and ``events`` are
    there when the trace was kept in memory (else ``None`` and empty); counts are always there.
    ``messages`` are the times in microseconds and texts of what programs said. Where the run was
    asked to, ``why`` tells what each condition saw and did, ``coverage`` how often. ``schedule``:
    what gave it its time; ``starved`` and ``overflows``: what that did to it.
    """

    programs: tuple[str, ...]
    cycle_time_us: int
    first_tick: int
    ticks: int
    state: RunState
    trace: Trace | None = None
    diagnostics: tuple[Diagnostic, ...] = ()
    messages: tuple[tuple[int, str], ...] = ()
    cycles: tuple[CycleResult, ...] = ()
    outputs: tuple[OutputCount, ...] = ()
    why: WhyReport | None = None
    schedule: RunSchedule | None = None
    starved: tuple[Starvation, ...] = ()
    overflows: tuple[OverflowCount, ...] = ()
    coverage: Coverage | None = None

    @property
    def virtual_time_us(self) -> int:
        """How long the machine would have taken, in microseconds."""
        return self.ticks * self.cycle_time_us

    @property
    def events(self) -> Sequence[Event]:
        """All events in the order of their occurrence."""
        return () if self.trace is None else self.trace.events

    @property
    def technology(self) -> list[TechnologyOutput]:
        """The M and H functions that were put out, in their order."""
        return [_technology(event) for event in self.events if event.kind in _TECHNOLOGY]

    @property
    def user_errors(self) -> list[UserErrorReport]:
        """What programs and realtime cycles have raised with ``#ERROR``."""
        return user_errors(self.events)

    @property
    def errors(self) -> tuple[Diagnostic, ...]:
        """The diagnostics that are errors."""
        return tuple(found for found in self.diagnostics if found.severity is Severity.ERROR)


_TECHNOLOGY = ("M", "H", "output")


def _technology(event: Event) -> TechnologyOutput:
    words = event.text.split()
    if event.kind == "output":
        letter, number, sequence = words[0], int(words[1]), 0
    else:
        letter, number, sequence = event.kind, int(words[0]), int(words[1])
    span, cycle = event.span, event.cycle
    return TechnologyOutput(event.tick, event.time_us, letter, number, sequence, span, cycle)


@dataclass(slots=True)
class _Fired:
    frequency: str
    count: int = 0
    first_tick: int | None = None
    last_tick: int | None = None

    def add(self, tick: int) -> None:
        self.count += 1
        self.last_tick = tick
        if self.first_tick is None:
            self.first_tick = tick


@dataclass(slots=True)
class _Cycle:
    name: str
    scope: str
    span: Span | None
    instances: int = 0
    reactions: dict[Span | None, _Fired] = field(default_factory=dict)
    frozen: tuple[FrozenValue, ...] = ()


@dataclass(slots=True)
class _Output:
    first_tick: int
    count: int = 0


class RunStatistics:
    """Counts what a run does, in memory that does not grow with its ticks; a sink.

    ``reactions`` gives the branches of a cycle by its name, in the order of their places, so that
    a branch that never fires is told too; without it only those that fire are known. Cycles that
    one definition made again and again are counted together. ``frozen`` gives what was frozen into
    the cycle of a name and a place.
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
        self._messages: list[tuple[int, str]] = []
        self.schedule = ScheduleStatistics()

    def open(self, header: TraceHeader) -> None:
        """Nothing to do: counts need no header."""

    def rows(self, first_tick: int, rows: memoryview[float], width: int) -> None:
        """Nothing to do: counts come from events."""

    def close(self) -> None:
        """Nothing to do."""

    def events(self, events: Sequence[Event]) -> None:
        """Count these events."""
        for event in events:
            if event.kind == "created":
                self._created(event)
            elif event.kind == "fired":
                self._fired(event)
            elif event.kind in _TECHNOLOGY:
                self._output(event)
            elif event.kind == "message":
                self._messages.append((event.time_us, event.text))
            elif event.kind in ("starved", "overflow"):
                self.schedule.add(event)
            elif event.kind == "ended":
                self._living.pop(event.cycle, None)

    def _created(self, event: Event) -> None:
        scope = event.text.split()[-1]
        name = event.cycle.partition("#")[0] + "#" if "#" in event.cycle else event.cycle
        key = (name, scope, event.span)
        if key not in self._cycles:
            made = _Cycle(event.cycle, scope, event.span)
            for reaction in self._reactions(event.cycle) if self._reactions else ():
                made.reactions[reaction.span] = _Fired(reaction.frequency)
            self._cycles[key] = made
        self._cycles[key].instances += 1
        if self._frozen is not None:
            self._cycles[key].frozen = tuple(self._frozen(event.cycle, event.span))
        self._living[event.cycle] = self._cycles[key]

    def _fired(self, event: Event) -> None:
        living = self._living.get(event.cycle)
        if living is None:  # a GLOBAL cycle that an earlier run of this controller created
            living = _Cycle(event.cycle, "GLOBAL", None, instances=1)
            self._living[event.cycle] = living
            self._cycles[(event.cycle, "GLOBAL", None)] = living
        known = _same_start(living.reactions, event.span)
        living.reactions.setdefault(known, _Fired(NO_FREQUENCY)).add(event.tick)

    def _output(self, event: Event) -> None:
        put_out = _technology(event)
        key = (put_out.letter, put_out.number, event.kind != "output")
        self._outputs.setdefault(key, _Output(event.tick)).count += 1

    @property
    def messages(self) -> tuple[tuple[int, str], ...]:
        """Time in microseconds and text of each message, in their order."""
        return tuple(self._messages)

    def outputs(self) -> tuple[OutputCount, ...]:
        """The M and H functions in the order of their first output."""
        return tuple(
            OutputCount(letter, number, realtime, output.count, output.first_tick)
            for (letter, number, realtime), output in self._outputs.items()
        )

    def cycles(self, runs: Mapping[str, int] | None = None) -> tuple[CycleResult, ...]:
        """The cycles in the order of their creation; ``runs`` gives run-throughs by name."""
        return tuple(
            CycleResult(
                cycle.name,
                cycle.scope,
                cycle.span,
                tuple(
                    ReactionResult(
                        span, fired.frequency, fired.count, fired.first_tick, fired.last_tick
                    )
                    for span, fired in cycle.reactions.items()
                ),
                cycle.instances,
                self._runs(cycle, runs or {}),
                cycle.frozen,
            )
            for cycle in self._cycles.values()
        )

    def _runs(self, cycle: _Cycle, runs: Mapping[str, int]) -> int | None:
        """The cycle's run-throughs, if ``runs`` counts them for this definition alone."""
        if cycle.instances > 1 and "#" in cycle.name:
            return None
        if sum(other.name == cycle.name for other in self._cycles.values()) > 1:
            return None
        return runs.get(cycle.name)


def _same_start(spans: Mapping[Span | None, _Fired], span: Span | None) -> Span | None:
    """The span among ``spans`` that begins where ``span`` does: events know no end of a span."""
    if span is None or span in spans:
        return span
    for known in spans:
        if known is not None and (known.file, known.line) == (span.file, span.line):
            if known.column == span.column:
                return known
    return span
