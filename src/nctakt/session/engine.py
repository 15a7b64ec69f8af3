# SPDX-License-Identifier: MIT
"""One controller at one tick, with the requests that a session makes to it.

In: a ``Setup``, then requests: run up to a tick, plan inputs, read, evaluate. Out: slices and
values. It knows no process, no thread and no clock: the same requests give the same answers
wherever it runs.
"""

from __future__ import annotations

import math
import re
from collections import deque
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from nctakt.base.dataclass import dataclass, field, write_initialisers
from nctakt.base.diagnostics import Diagnostic, Language, Span, Text
from nctakt.base.failure import Failure
from nctakt.decoder.cycles.builder import CycleBranch, CycleDefinition
from nctakt.decoder.state.call_stack import OpenCall
from nctakt.files.access import FileAccess
from nctakt.hli.plc_entries import SpindleEntry, TechnologyEntry
from nctakt.kernel import codes
from nctakt.kernel.cycles.context import context_of
from nctakt.kernel.cycles.expressions import OPERATIONS
from nctakt.lists.machine.machine import load_machine
from nctakt.messages.programs.realtime import CYCLE_OPERATION_WITHOUT_RESULT
from nctakt.plc.loading import load_plcs
from nctakt.plc.retained import retained_text, structured_plcs
from nctakt.results.compared import Compared, compared_last, compared_now
from nctakt.results.instruction_tree import ListedCycle, list_cycle
from nctakt.results.run import ProgramMessage, Run, RunState
from nctakt.results.trace.event_words import EventMatcher, SoughtEvents
from nctakt.results.trace.events import Event
from nctakt.run.access.inputs import IMAGE, PLC, SELECT, Cells, Input, unpack
from nctakt.run.access.shared_image import SharedImage
from nctakt.run.access.stimuli import Stimulus, as_inputs, read_stimulus
from nctakt.run.options import RunKeywords, completed
from nctakt.run.plcs.plc_view import AnyPlc, PlcView
from nctakt.run.plcs.realtime_plc import memories_of, parts_of
from nctakt.run.program_loader import load
from nctakt.run.program_run import ProgramRun
from nctakt.run.realtime.assembly import AssembledMachine
from nctakt.run.tick_loop import TickLoop
from nctakt.session.channel_states import ChannelState, channel_states
from nctakt.session.decoders import DecoderState, decoder_state
from nctakt.session.history.columns import MAX_SIGNALS, Extent, Necessary, extent_end, necessary
from nctakt.session.history.trail import Mark, Trail, now_us
from nctakt.session.outline import outlined
from nctakt.session.rest import LOOK_TICKS, PAUSED, rest
from nctakt.session.schedules import EngineSchedule
from nctakt.session.setup import Description, Inventory, Setup
from nctakt.session.statements import PlcPlace
from nctakt.session.stops import EventFilter, StopAt, StopBuilder, read_stop
from nctakt.session.tick_log import MAX_EVENTS, SignalRows, TickLog
from nctakt.timing.account import BlockSink, RunningAccount
from nctakt.timing.table import TitledTables, time_tables

#: Ticks whose rows are held at once if only some of them are kept.
OUTLINED_AT = 20_000

#: Result of ``Engine.last_hit``: a tick or 0, the tick reached, its marks.
Found = tuple[int, int, tuple[Mark, ...]]


@dataclass(frozen=True, slots=True)
class FoundEvents:
    """The events found in the ticks from ``first`` up to, but without, ``end``.

    ``left_out``: how many others there were; ``marks``: those of a run of these ticks.
    """

    first: int
    end: int
    events: tuple[Event, ...]
    left_out: int
    marks: tuple[Mark, ...] = ()


#: What ``Engine.account`` has come to: a tick, its marks.
Accounted = tuple[int, tuple[Mark, ...]]

#: The events at which a stop holds, ``None`` if others decide; conditions necessary for it.
Evidence = tuple[tuple[EventFilter, ...] | None, Necessary | None]

#: Places of ended realtime cycles that a state_view has at most, the newest.
_ENDED_SHOWN = 100

#: Ticks of a stretch that is looked at in detail.
MAX_LOOKED_AT = 1_000_000


@dataclass(frozen=True, slots=True)
class StepResult:
    """The results of the ticks from ``first_tick`` up to, but without, ``tick``.

    ``run_state`` has a value once the run is over. ``hits``: the stops that held in the last tick,
    by their index; they have ended the slice. ``blocks``: number of the channel -> place of its
    current block, ``calls``: the programs that are open there, the main program first;
    ``decoding``: place of the latest command of its decoder. ``inputs``: all inputs from outside,
    in order. ``decoded``: blocks passed so far. ``differs``: the first tick in which the PLC
    differed from the tape. ``marks``, ``rows``, ``columns``: the trail of the ticks (``trail.py``),
    for the past of the session. ``is_resting``: it has ended because no block comes without input;
    ``diagnostics`` says why the programs wait.
    """

    first_tick: int
    tick: int
    state: str
    run_state: RunState | None
    hits: Sequence[int]
    events: Sequence[Event]
    left_out: int
    messages: Sequence[ProgramMessage]
    diagnostics: Sequence[Diagnostic]
    inputs: Sequence[Input]
    blocks: Mapping[int, Span]
    decoded: int
    differs: int | None = None
    decoding: Mapping[int, Span] = field(default_factory=dict)
    calls: Mapping[int, tuple[OpenCall, ...]] = field(default_factory=dict)
    marks: tuple[Mark, ...] = ()
    rows: bytes = b""
    columns: tuple[tuple[Extent, ...], bytes] = ((), b"")
    is_resting: bool = False


def joined(first: StepResult, second: StepResult) -> StepResult:
    """Return two consecutive slices as one."""
    events = [*first.events, *second.events]
    surplus = max(0, len(events) - MAX_EVENTS)
    return replace(
        second,
        first_tick=first.first_tick,
        events=tuple(events[surplus:]),
        left_out=first.left_out + second.left_out + surplus,
        messages=(*first.messages, *second.messages),
        diagnostics=(*first.diagnostics, *second.diagnostics),
        inputs=(*first.inputs, *second.inputs),
    )


def since_tick(done: StepResult, tick: int, cycle_us: int) -> StepResult:
    """Return a slice without its events before a tick."""
    return replace(
        done,
        first_tick=max(tick, done.first_tick),
        messages=tuple(one for one in done.messages if one.time_us >= tick * cycle_us),
        inputs=tuple(one for one in done.inputs if one.tick >= tick),
    )


@dataclass(frozen=True, slots=True)
class BranchState:
    """A branch of a realtime cycle at this tick.

    ``truth``: of its condition at its last evaluation, ``None`` before the first, and after one
    aborted by a fault. ``is_evaluated`` and ``has_run``: in the last tick. ``count``: how often its
    body ran. ``evaluated_at``: the tick of the last evaluation, ``seen``: the values it compared,
    ``now``: the values it would compare at this tick, ``None`` if that is not defined.
    """

    span: Span
    frequency: str
    truth: bool | None
    is_evaluated: bool
    has_run: bool
    count: int
    evaluated_at: int | None = None
    seen: Compared | None = None
    now: Compared | None = None


@dataclass(frozen=True, slots=True)
class CycleState:
    """A realtime cycle: its name, its state and its branches in the order of the text."""

    name: str
    state: str
    scope: str
    span: Span
    runs: int
    branches: tuple[BranchState, ...]


@dataclass(frozen=True, slots=True)
class StateView:
    """Values of signals, living cycles, waiting functions, and channels, before one tick.

    ``ended``: ended cycles that were defined at a place where none lives now, the newest of each
    place, at most 100.
    """

    tick: int
    values: tuple[float | bool | str, ...]
    cycles: tuple[CycleState, ...]
    waiting: tuple[tuple[int, TechnologyEntry | SpindleEntry], ...]
    channels: tuple[ChannelState, ...]
    ended: tuple[CycleState, ...] = ()


class Engine:
    """One controller that runs the programs of a setup; raises ``Failure`` as a controller does."""

    def __init__(self, setup: Setup) -> None:
        access = FileAccess([Path(folder) for folder in setup.folders])
        configuration = load_machine(setup.machine, access=access)
        self._diagnostics = list(configuration.diagnostics)
        self._schedule = EngineSchedule(setup, access)
        configuration = self._schedule.scheduled(configuration, self._diagnostics)
        self._machine = machine = AssembledMachine(configuration, access)
        machine.report = self._diagnostics.append
        self._signals = machine.signals()
        options = setup.options
        chosen = options.get("signals")
        recorded = _recorded(machine) if chosen is None else list(chosen)
        self._cycle_us = configuration.cycle_time_us
        self._loop = TickLoop(machine, self._diagnostics.append, None)
        self._happened = TickLog()
        self._trail = Trail(machine.memory)
        self._inputs: list[Input] = []
        self._expected: deque[Input] = deque()
        self._differs: int | None = None
        self._stop_builder = StopBuilder(machine)
        self._matcher: EventMatcher | None = None
        self._account: RunningAccount | None = None
        self._cycles: dict[int, tuple[str, CycleDefinition]] = {}
        self._newest: dict[Span, int] = {}
        self._stops: Sequence[StopAt] = ()
        self._listed: list[int | str] = []
        self._reported_diagnostics = self._reported_messages = 0
        plc = load_plcs(setup.plcs)
        for one in parts_of(plc)[0]:
            one.is_replayed = setup.is_replay
        self._schedule.follow(self._loop, plc, self._diagnostics.append)
        stimuli = [read_stimulus(stimulus) for stimulus in options.get("at", ())]
        options = self._options(options, plc, stimuli, recorded)
        self._run = ProgramRun(self._loop, self._diagnostics, setup.programs, completed(options))
        self._trail.follow(memories_of(plc))
        self._loop.connect(plc, has_plc=not setup.acknowledges)
        self._recorded_cells = tuple(self._signals[name][0] for name in recorded)
        self._selected: tuple[Sequence[int], bool] | None = None
        self._columns = {cell: number for number, cell in enumerate(self._recorded_cells)}
        self._run.load()
        self.statements = self._stop_builder.statements
        self.statements.follow(plc)
        self.description = Description(
            configuration.cycle_time_us,
            len(machine.channels),
            {name: found.unit for name, found in self._signals.items()},
            {text.source.file: tuple(text.source.lines) for text in self._run.texts},
            tuple(self._diagnostics),
            self._planned(stimuli, setup.inputs),
            self._run.state is not None,
            self.statements.texts(),
            self.statements.lines(),
            frozenset(name for name, found in self._signals.items() if found.is_boolean),
        )

    def _options(
        self, given: RunKeywords, plc: AnyPlc | None, stimuli: list[Stimulus], recorded: list[str]
    ) -> RunKeywords:
        """Return the options of the run that the session is."""
        return {
            **given,
            "at": stimuli,
            "plc": plc,
            "signals": recorded,
            "sinks": (self._happened, self._trail),
            "memory_trace": False,
            "on_cycle": self._add_cycle,
            "blocks": True,
            "record": self._note,
        }

    def schedule(self, request: str, *words: str) -> str | None:
        """Carry out a request of the session to a real schedule; ``None`` without one."""
        return self._schedule.carry_out(request, *words)

    def _planned(self, stimuli: Sequence[Stimulus], inputs: Sequence[Input]) -> list[Input]:
        """Return the inputs that are planned before the first tick."""
        cycle_us = self._machine.configuration.cycle_time_us
        planned = sorted([*as_inputs(stimuli, 0, cycle_us), *inputs], key=lambda one: one.tick)
        if any(one.kind == IMAGE for one in inputs):
            self._attach_image()
        if inputs:
            self.plan(planned)
        return planned

    def _attach_image(self) -> None:
        """Create an image for the values of a PLC in another process."""
        machine = self._machine
        self._image = SharedImage(
            machine.configuration, machine.kernel, machine.channels, machine.layout
        )
        machine.inputs.attach(self._image)

    def _add_cycle(self, name: str, definition: CycleDefinition) -> None:
        self._cycles[definition.serial] = name, definition
        self._newest.pop(definition.span, None)  # the newest place comes last
        self._newest[definition.span] = definition.serial
        self._stop_builder.add_cycle(definition)

    def _note(self, cells: Cells) -> None:
        inputs = unpack(cells)
        self._inputs += inputs
        for arrived in inputs:
            if arrived.source != PLC or self._differs is not None or not self._expected:
                continue
            if self._expected.popleft() != arrived:
                self._differs = arrived.tick

    def warm_up(self) -> None:
        """Do in advance what each copy of this would otherwise do in its first ticks."""
        write_initialisers()

    # --- going on -------------------------------------------------------------------------------

    @property
    def tick(self) -> int:
        """The number of ticks since start-up."""
        return self._loop.tick

    @property
    def has_plc(self) -> bool:
        """Whether a PLC in Python runs with it."""
        return self._loop.plc is not None

    def plan(self, inputs: Sequence[Input]) -> None:
        """Replace the inputs that are to come, from this tick on.

        Those of a PLC in Python are only compared with its actions if it is rerun, too.
        """
        runs_again = self._loop.runs_python
        own = [planned for planned in inputs if planned.source != PLC or not runs_again]
        self._expected = deque(one for one in inputs if one.source == PLC and runs_again)
        self._differs = None
        self._machine.inputs.plan(own)

    def post(self, inputs: Sequence[Input]) -> None:
        """Add inputs; raises ``Failure`` for an unknown name or a wrong value, and adds none."""
        self._machine.inputs.check_all(inputs)
        for posted in inputs:
            if posted.kind == SELECT:
                channel, name = posted.values
                with self._machine.files.untouched():  # it is read when its tick has come
                    load(str(name), self._machine, [], int(channel))
        self._machine.inputs.add(inputs)
        self._expected.clear()

    def post_each(self, groups: Sequence[Sequence[Input]]) -> list[tuple[Diagnostic, ...] | None]:
        """Add groups of inputs as ``post``; return for each why it was refused, or ``None``."""
        answers: list[tuple[Diagnostic, ...] | None] = []
        for group in groups:
            try:
                self.post(group)
                answers.append(None)
            except Failure as failure:
                answers.append(tuple(failure.diagnostics))
        return answers

    def run(
        self,
        end: int,
        stops: Sequence[StopAt] = (),
        events: bool = True,
        marks: Sequence[int] | None = (),
        rests: bool = False,
        since: int | None = None,
    ) -> StepResult:
        """Run up to tick ``end``, to the first tick in which a stop holds, or to the run's end.

        Without ``events`` the slice has none; the next one that has any brings them along.
        ``since``, not before the next tick: where the slice begins; everything earlier is
        forgotten, except diagnostics. ``marks``: where the slice has marks; ``None``: the ticks run
        for the first time, with as many marks as necessary, and the rows of events. ``rests``: also
        end where no stop can hold any more without input.
        """
        if stops != self._stops:
            self._watch(stops)
        self._stop_builder.watch_pauses(PAUSED if rests else None)
        first = self.tick
        if since is not None:
            self._happened.begin(since)
        # Before the first tick no program has begun.
        resting: tuple[Diagnostic, ...] = ()
        if rests and first and self._run.state is None:
            resting = rest(self._machine, self._loop, stops)
        if resting:
            return self._slice(first, [], events=True, resting=resting)
        found: list[Mark] = []
        self._trail.keeps = marks is None
        self._select(self._recorded_cells if marks is None else (), reduced=marks is None)
        while True:
            bound = min(end, self._next_look) if rests else end
            if marks is None:
                is_stopped = self._explore(end, found, stops if rests else None)
            else:
                is_stopped = self._repeat(bound, marks, found)
            hits = self._stop_builder.hits(self.tick - 1) if is_stopped else []
            hits = [hit for hit in hits if hit < len(stops)]
            is_there = bool(hits) or self._run.state is not None
            resting = () if is_there or not rests else rest(self._machine, self._loop, stops)
            if is_there or resting or self.tick >= end:
                break
        done = self._slice(first, hits, events=events or is_there or bool(resting), resting=resting)
        rows, columns = self._trail.take(), self._trail.take_columns()
        done = replace(done, marks=tuple(found), rows=rows, columns=columns)
        return done if since is None else since_tick(done, since, self._cycle_us)

    def _select(self, cells: Sequence[int], *, reduced: bool = False) -> None:
        """Record only these cells in each tick from now on: others would only cost time.

        ``reduced``: only their lowest and highest values.
        """
        if self._selected != (cells, reduced):
            self._machine.record.select(list(cells), reduced=reduced)
            self._selected = cells, reduced
        elif reduced:
            self._machine.record.begin_extent()

    @property
    def _next_look(self) -> int:
        """The tick of the next look whether anything can still happen."""
        return (self.tick // LOOK_TICKS + 1) * LOOK_TICKS

    def _explore(self, end: int, found: list[Mark], resting: Sequence[StopAt] | None) -> bool:
        """Run ticks for the first time, with marks where they are due; return as ``advance``.

        ``resting``: also end where none of these stops can hold any more without input.
        """
        while True:
            before, begin_us = self.tick, now_us()
            bound = min(end, before + self._trail.part, extent_end(before))
            bound = bound if resting is None else min(bound, self._next_look)
            is_stopped = self._run.advance(bound)
            is_due = self._trail.note(self.tick - before, now_us() - begin_us)
            is_there = is_stopped or self._run.state is not None or self.tick >= end
            if resting is not None and not is_there and self.tick % LOOK_TICKS == 0:
                is_there = bool(rest(self._machine, self._loop, resting))
            if is_due or is_there:
                found.append(self._mark())
            if is_there:
                return is_stopped

    def _repeat(
        self,
        end: int,
        marks: Sequence[int],
        found: list[Mark],
        advance: Callable[[int], bool] | None = None,
    ) -> bool:
        """Rerun ticks, with these marks on the way; return as ``ProgramRun.advance``.

        ``advance``: runs up to a tick, by default that.
        """
        advance = advance or self._run.advance
        for tick in marks:
            is_stopped = self._run.state is None and advance(tick)
            if not is_stopped or self.tick == tick:
                found.append(self._mark())
            if is_stopped:
                return True
        return advance(end)

    def _mark(self) -> Mark:
        return self._trail.mark(self.tick, is_over=self._run.state is not None)

    def last_hit(self, end: int, stops: Sequence[StopAt], marks: Sequence[int]) -> Found:
        """Run up to tick ``end`` past all stops; return the last tick after which one has held.

        The events of these ticks are only digested, so that the search is no slower than a run.
        """
        if stops != self._stops:
            self._watch(stops)
            self._loop.recording.reduce_to(self._trail)
        self._select(())
        self._stop_builder.watch_pauses(None)
        found: list[Mark] = []
        self._repeat(end, marks, found)
        return self._stop_builder.last_hit() + 1, self.tick, tuple(found)

    def find_events(
        self, end: int, sought: SoughtEvents, marks: Sequence[int], since: int
    ) -> FoundEvents:
        """Run up to tick ``end`` past all stops; return the events that are sought.

        ``since``: from which tick on they are. Those of the calls before are forgotten.
        """
        if self._matcher is None or self._matcher.sought != sought:
            self._watch(())
            self._stop_builder.watch_pauses(None)
            self._select(())
            self._matcher = EventMatcher(sought)
            self._loop.recording.reduce_to(self._trail)
            self._loop.recording.add(self._matcher)
        self._trail.keeps = False
        self._matcher.begin(since)
        first, found = self.tick, list[Mark]()
        self._repeat(end, marks, found)
        events, left_out = self._matcher.take()
        return FoundEvents(max(first, since), self.tick, events, left_out, tuple(found))

    # --- its signals ----------------------------------------------------------------------------

    def record(self, signals: Sequence[str] | None) -> None:
        """Record signals, by default those of a run, in each tick from here on.

        Raises ``Failure`` for unknown signals.
        """
        self._watch(())
        self._stop_builder.watch_pauses(None)
        self._loop.recording.remove(self._happened)
        self._trail.keeps = False
        self._run.record(signals)

    def record_to(self, end: int, marks: Sequence[int]) -> Accounted:
        """Run past all stops to tick ``end``; return where it is, and the marks on the way."""
        found = list[Mark]()
        self._repeat(end, marks, found)
        return self.tick, tuple(found)

    # --- where the time goes --------------------------------------------------------------------

    def account(self, end: int, marks: Sequence[int]) -> Accounted:
        """Run from the first tick on, or from the last call on, past all stops to tick ``end``.

        Each tick is accounted for. Return where it is, and the marks of these ticks.
        """
        if self._account is None:
            self._watch(())
            self._stop_builder.watch_pauses(None)
            self._select(())
            blocks = BlockSink()
            self._account = RunningAccount(self._machine, self._loop.channels, blocks)
            self._loop.recording.reduce_to(self._trail)
            self._loop.recording.add(blocks)
        self._trail.keeps = False
        found = list[Mark]()
        self._repeat(end, marks, found, self._account_to)
        return self.tick, tuple(found)

    def _account_to(self, end: int) -> bool:
        """Run each tick up to ``end`` by itself; no stop ends it."""
        assert self._account is not None
        tick = self.tick
        while self._run.state is None and tick < end:
            self._run.advance(tick + 1)
            if self.tick > tick:
                self._account.end_tick(tick)
                tick = self.tick
        return False

    def time_tables(self, language: Language) -> TitledTables:
        """Return where the time of the ticks went that are accounted for."""
        if self._account is None:
            return []
        return time_tables(self._account.times(self.tick), language)

    # --- within a tick --------------------------------------------------------------------------

    def watch_statements(self) -> None:
        """Put probes into the code of the PLC; raises ``Failure`` (902810) without one."""
        self.statements.plc.install()

    def statements_passed(self) -> tuple[list[int], list[int]] | None:
        """Run a tick; return sources and depths of its statements, ``None`` for too many."""
        self._watch(())
        self.statements.within(0, 0)
        self._run.advance(self.tick + 1)
        return self.statements.passed()

    def statement_sources(self, stops: Sequence[StopAt]) -> list[list[int]]:
        """Return for each stop at statements those that it means; none: any."""
        return self.statements.sources(stops)

    def statements_met(
        self, stops: Sequence[StopAt], after: int, before: int
    ) -> list[tuple[int, int]]:
        """Run a tick; return for each stop at which statements of it it held.

        Those are numbers from 1 on: the first one after a statement, the last one before another
        one, 0 for none.
        """
        self._watch(stops)
        self.statements.within(after, before)
        self._run.advance(self.tick + 1)
        return self.statements.met(stops)

    def halt(self, number: int) -> PlcPlace | None:
        """Run a tick up to just before a statement; return where that is.

        The controller is only good to be looked at then: ``look_inside``.
        """
        tick = self.tick
        self._watch(())
        self.statements.halt_at(number)
        self._run.advance(tick + 1)
        return self.statements.stopped_at(tick, number)

    def plc_fault(self) -> PlcPlace | None:
        """Return where a fault has stopped the PLC, ``None`` while it runs."""
        return self.statements.stopped_at(self.tick - 1, 0)

    def look_inside(self, request: str, *words: Any) -> Any:
        """Answer a question about calls and variables of the PLC; raises ``Failure``."""
        questions: dict[str, Callable[..., Any]] = {
            "scopes": self.statements.scopes,
            "of_scope": self.statements.of_scope,
            "below": self.statements.below,
            "value": self.statements.value,
            "texts_beside": self.statements.texts_beside,
            "tree_beside": self.statements.tree_beside,
            "instances": self.statements.instances,
        }
        return questions[request](*words)

    def evidence(self, stops: Sequence[StopAt]) -> list[Evidence]:
        """Return for each stop the evidence in the record of a session."""
        return [
            (self._stop_builder.filters(stop), necessary(stop, self._machine, self._columns))
            for stop in stops
        ]

    def sought(self, stops: Sequence[StopAt | str]) -> tuple[tuple[StopAt, ...], list[Evidence]]:
        """Return stops as ``read_stops``, each with the evidence in the record of a session."""
        read = self.read_stops(stops)
        return read, self.evidence(read)

    def _watch(self, stops: Sequence[StopAt]) -> None:
        """Watch only these stops from now on."""
        self._stop_builder.watch(stops)
        self._stops = stops

    def read_stops(self, stops: Sequence[StopAt | str]) -> tuple[StopAt, ...]:
        """Return stops, some given as texts; raises ``Failure`` with all mistakes of them."""
        read: list[StopAt] = []
        mistakes: list[Diagnostic] = []
        for stop in stops:
            try:
                read.append(stop if isinstance(stop, StopAt) else read_stop(stop))
                self._stop_builder.check(read[-1:])
            except Failure as failure:
                mistakes += failure.diagnostics
        if mistakes:
            raise Failure(*mistakes)
        self._stop_builder.check(read)
        return tuple(read)

    def _slice(
        self,
        first: int,
        hits: Sequence[int],
        *,
        events: bool,
        resting: tuple[Diagnostic, ...] = (),
    ) -> StepResult:
        happened, left_out = self._happened.take() if events else ([], 0)
        inputs, self._inputs = self._inputs, []
        messages = self._loop.recording.messages[self._reported_messages :]
        diagnostics = self._diagnostics[self._reported_diagnostics :]
        self._reported_messages += len(messages)
        self._reported_diagnostics += len(diagnostics)
        return StepResult(
            first,
            self.tick,
            self._loop.state,
            self._run.state,
            tuple(hits),
            tuple(happened),
            left_out,
            tuple(messages),
            (*diagnostics, *resting),
            tuple(inputs),
            dict(self._happened.blocks),
            self._happened.block_count,
            self._differs,
            self._decoding(),
            {
                channel: self._machine.registry.path(number)
                for channel, number in self._happened.calls.items()
            },
            is_resting=bool(resting),
        )

    def _decoding(self) -> dict[int, Span]:
        """Return where the decoders of the channels are in their programs."""
        files = self._machine.files
        places = {
            number: files.span(channel.queue.last_source())
            for number, channel in enumerate(self._machine.channels, 1)
        }
        return {number: span for number, span in places.items() if span is not None}

    # --- looking --------------------------------------------------------------------------------

    def read(self, names: Sequence[str]) -> list[float | bool | str]:
        """Return signals and variables by name; raises ``Failure`` for an unknown one."""
        signals, cells = self._signals, self._machine.cells
        return [
            cells[signals[name][0]] if name in signals else self._machine.read(name)
            for name in names
        ]

    def read_listed(self, names: Sequence[str] | None) -> list[float | bool | str]:
        """Return values as ``read``; without names, of those that were asked for last."""
        signals, cells = self._signals, self._machine.cells
        if names is not None:
            self._listed = [signals[name][0] if name in signals else name for name in names]
        return [
            cells[one] if isinstance(one, int) else self._machine.read(one) for one in self._listed
        ]

    def evaluate(self, text: str, channel: int = 1) -> float:
        """Return the value of an expression in the controller's language.

        It is no number where the expression is not defined at the moment. Raises ``Failure`` for
        mistakes in it.
        """
        context = context_of(self._machine.memory)
        value = self._stop_builder.read(text, channel).measure(context)
        return math.nan if context.fault else value

    def undefined(self, text: str, channel: int = 1) -> Text | None:
        """Return why an expression is not defined at present, ``None`` if it is."""
        context = context_of(self._machine.memory)
        self._stop_builder.read(text, channel).measure(context)
        if not context.fault:
            return None
        if context.fault == CYCLE_OPERATION_WITHOUT_RESULT.id:
            name = OPERATIONS.get(int(context.fault_a), "=")
            return Text(f"'{name}' has no valid result", f"'{name}' hat kein gültiges Ergebnis")
        return Text(f"error {context.fault}", f"Fehler {context.fault}")

    def cycles(self) -> list[CycleState]:
        """Return the living realtime cycles with the truth of their conditions."""
        return [
            self._cycle_state(cycle.serial, _STATES[manager.state_of(cycle.slot)])
            for manager in (channel.manager for channel in self._machine.channels)
            for cycle in manager.loaded
        ]

    def _ended_cycles(self) -> list[CycleState]:
        """Return, for each definition without a living cycle, its newest one, up to a bound."""
        managers = [channel.manager for channel in self._machine.channels]
        living = {cycle.serial for manager in managers for cycle in manager.loaded}
        newest = list(self._newest.values())[-_ENDED_SHOWN:]
        return [self._cycle_state(serial, "ended") for serial in newest if serial not in living]

    def _cycle_state(self, serial: int, state: str) -> CycleState:
        name, definition = self._cycles[serial]
        branches = tuple(self._branch_state(branch) for branch in definition.reactions)
        return CycleState(
            name, state, definition.scope, definition.span, definition.cycle.runs, branches
        )

    def _branch_state(self, branch: CycleBranch) -> BranchState:
        node, condition = branch.node, branch.node.condition
        seen = compared_last(condition)
        return BranchState(
            branch.span,
            branch.frequency,
            None if seen is None else seen.truth,
            condition.next_tick == self.tick,
            node.next_tick == self.tick,
            node.count,
            None if seen is None else condition.next_tick - 1,
            seen,
            None if seen is None else compared_now(condition, context_of(self._machine.memory)),
        )

    def state_view(self, names: Sequence[str]) -> StateView:
        """Return values, cycles and waiting functions, all of this tick; raises as ``read``."""
        values = tuple(self.read(names))
        channels = channel_states(self._machine, self._loop.channels)
        cycles, ended = tuple(self.cycles()), tuple(self._ended_cycles())
        return StateView(self.tick, values, cycles, tuple(self.waiting()), channels, ended)

    def inventory(self) -> Inventory:
        """Return the variables of the machine, and the realtime cycles of its programs."""
        return Inventory(
            {
                number: {
                    **{name: type_ for name, _, type_ in channel.names.values()},
                    **{name: "" for name, _ in channel.names.realtime()},
                }
                for number, channel in enumerate(self._machine.assembled, start=1)
            },
            tuple(cycle for text in self._run.texts for cycle in text.cycles),
        )

    def instructions(self) -> list[tuple[str, ListedCycle]]:
        """Return the living realtime cycles as their elementary instructions, with their names."""
        found = []
        for manager in (channel.manager for channel in self._machine.channels):
            for cycle in manager.loaded:
                name, definition = self._cycles[cycle.serial]
                found.append((name, list_cycle(definition)))
        return found

    def decoders(self) -> list[DecoderState]:
        """Return the decoders that have a program open."""
        return [
            decoder_state(number, channel.feeder.state, channel.feeder.environment)
            for number, channel in enumerate(self._loop.channels, start=1)
            if channel.feeder is not None
        ]

    def waiting(self) -> list[tuple[int, TechnologyEntry | SpindleEntry]]:
        """Return functions and jobs that wait for acknowledgement, each with its channel.

        The functions of a channel come first, then the jobs of spindles that the PLC turns.
        """
        found: list[tuple[int, TechnologyEntry | SpindleEntry]] = []
        for number in range(1, len(self._machine.channels) + 1):
            view = PlcView(self._machine, number - 1)
            found += ((number, entry) for entry in view.functions())
            found += ((number, job) for job in view.spindle_jobs())
        return found

    def look(self, end: int, signals: Sequence[str], every: int) -> bytes:
        """Run up to tick ``end``; return the signals after each ``every``-th tick.

        Rows of float64, one cell for each signal.
        """
        if end - self.tick > MAX_LOOKED_AT * every:
            raise ValueError(f"{end - self.tick} ticks")
        known = self._signals
        unknown = [name for name in signals if name not in known]
        if unknown:
            raise Failure(*(self._machine.unknown_signal(name) for name in unknown))
        cells = tuple(known[name][0] for name in signals)
        self._watch(())
        self._trail.keeps = False
        found = bytearray()
        if every > 1:
            memory = self._machine.cells
            while self._run.state is None and self.tick < end:
                self._run.advance(min(end, self.tick + every))
                for cell in cells:
                    found += memory[cell : cell + 1].tobytes()
            return bytes(found)
        collector = SignalRows(found)
        self._select(cells)
        self._loop.recording.add(collector)
        self._run.advance(end)
        self._loop.recording.remove(collector)
        return bytes(found)

    def outline(self, end: int, signals: Sequence[str], followed: int, count: int) -> bytes:
        """Run up to tick ``end``; return the signals after ``count`` ticks at most.

        Rows of float64: the tick, a cell for each signal. The first ``followed`` of these are near
        a straight line between two rows, as far as so few rows can show where they go.
        """
        first, found = self.tick, bytearray()
        while self._run.state is None and self.tick < end:
            begin = self.tick
            data = self.look(min(end, begin + OUTLINED_AT), signals, 1)
            rows = np.frombuffer(data).reshape(-1, len(signals))
            ticks = np.arange(begin, begin + len(rows))
            share = max(1, count * len(rows) // (end - first))
            kept = outlined(ticks, rows[:, :followed], share)
            found += np.column_stack((ticks[kept], rows[kept])).tobytes()
        return bytes(found)

    # --- the end --------------------------------------------------------------------------------

    def result(self) -> Run:
        """End the run where it is; return its result."""
        if self._run.state is None:
            self._run.interrupt()
        self._run.close()
        return self._run.result()

    def retained(self) -> str:
        """Return the PLC's retained values, as the text of a file."""
        return retained_text(structured_plcs(self._loop.plc))


def _recorded(machine: AssembledMachine) -> list[str]:
    """Return the signals of a run, and the single variables of the machine, each of them once."""
    signals = machine.signals()
    variables = [name for name in signals if _VARIABLE.fullmatch(name)]
    names: dict[int, str] = {}
    for name in (*machine.default_signals(), *variables):
        names.setdefault(signals[name][0], name)  # all channels have the variables of the machine
    return list(names.values())[:MAX_SIGNALS]


#: A variable of the machine that is no element of an array and no part of a structure.
_VARIABLE = re.compile(r"(CH\d+\.)?V\.(E|CH)\.\w+")

_STATES = {
    codes.LOADED: "loaded",
    codes.DEFINED: "defined",
    codes.ARMED: "armed",
    codes.RUNNING: "running",
    codes.HELD: "held",
    codes.ENDED: "ended",
}
