# SPDX-License-Identifier: MIT
"""A session: one thread owns the core of a controller; all others send it requests.

In: commands from any thread, a clock. Out: slices and values as answers, frames and notices.
"""

from __future__ import annotations

import contextlib
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, Self, Unpack

from nctakt.base.diagnostics import Language, Text
from nctakt.base.failure import Failure, error_text
from nctakt.base.notebook import html_columns, html_table
from nctakt.base.notebook_progress import notebook_progress
from nctakt.hli.plc_entries import SpindleEntry, TechnologyEntry
from nctakt.lists.format.times import Time, TimeLike
from nctakt.plc.stepping.beside import Branch, Line
from nctakt.plc.stepping.shown import PlcValue
from nctakt.results.explained.why import WhyReport
from nctakt.results.instruction_tree import ListedCycle
from nctakt.results.run import RecordedRun, Run
from nctakt.results.trace.events import Event
from nctakt.run.access.input_words import API
from nctakt.run.access.inputs import Input
from nctakt.run.options import ProgramOptions, check_keywords, merged, with_keywords
from nctakt.run.program_loader import NcText
from nctakt.session.ahead import UNKNOWN, Future, run_ahead
from nctakt.session.clock import AnyClock, FastClock, Pacing, WallClock
from nctakt.session.core import MAX_ROWS, NEXT_BLOCK, NEXT_REACTION, SessionCore
from nctakt.session.cursor import FAULT, Step
from nctakt.session.decoders import DecoderState
from nctakt.session.engine import CycleState, StateView, StepResult, joined
from nctakt.session.history.comparing import BranchDifference
from nctakt.session.history.event_search import EventSearch
from nctakt.session.history.past_runs import PastRuns
from nctakt.session.history.rerun import PastAccount, PastRecording
from nctakt.session.listening import Listener
from nctakt.session.process.thread import SessionThread
from nctakt.session.setup import Description, Inventory, Setup
from nctakt.session.statements import PlcPlace
from nctakt.session.stops import StopAt
from nctakt.session.subscribers import Subscribers
from nctakt.session.tapes import read_setup, save_tape

#: Maximum number of ticks that a notebook draws.
MAX_DRAWN = 300_000


class Session:
    """An interactive run: on any clock, with stops, forward and back.

    Any thread may command; a command returns when it has been done. ``programs``, ``channels`` and
    ``options`` are those of ``Controller.run``; ``machine`` is a folder, ``plc`` files of PLCs.
    Without a PLC, functions acknowledge themselves unless ``acknowledges`` is false. ``folders``:
    the only ones whose files may be read. ``pace``: on the wall clock ``slice`` runs the ticks of
    10 ms together, ``tick`` each at its own time. ``stays``: it continues after its programs.
    ``signals``: those that are recorded for searches backward, by default those of a run and the
    single variables of the machine.

    Raises ``Failure`` for files that cannot be read, and for wrong names and values; with errors in
    the programs, the session is over at once. ``on_travel`` is called from its thread while it goes
    back, with how many of how many ticks have been rerun.

    >>> with Session(NcText("move.nc", "G01 X100 F6000 M30")) as session:
    ...     session.run(until="V.RTA.ACS.ACT_POS.X >= 50").tick
    ...     session.back(10).tick
    ...     session.evaluate("V.RTA.ACS.ACT_POS.X < 50")
    513
    503
    1.0
    """

    @with_keywords("session", ProgramOptions)
    def __init__(
        self,
        *programs: str | Path | NcText,
        channels: Mapping[int, Sequence[str | Path | NcText]] | None = None,
        machine: str | Path | None = None,
        plc: str | Path | Sequence[str | Path] | None = None,
        acknowledges: bool = True,
        folders: Sequence[str | Path] = (),
        pace: str = "slice",
        stays: bool = False,
        **options: Unpack[ProgramOptions],
    ) -> None:
        check_keywords("Session", "session", options)
        self._begin(
            Setup(
                {1: programs, **(channels or {})},
                machine,
                plc,
                acknowledges,
                folders,
                options=merged(options, {"stays": stays}),
            ),
            pace,
        )

    @classmethod
    def of_tape(
        cls,
        tape: str | Path,
        *,
        anyway: bool = False,
        folders: Sequence[str | Path] = (),
        pace: str = "slice",
    ) -> Self:
        """Return a session of the run on a tape, which needs no PLC.

        Its inputs come at the same times; anything written after the start begins a branch. It
        reaches the files in ``folders``, by default those of the folder of the tape. Raises
        ``Failure`` for a tape that cannot be read, that names other files, or whose programs and
        lists have changed, unless it is to run ``anyway``.
        """
        return cls.of_setup(read_setup(tape, folders, anyway=anyway), pace)

    @classmethod
    def of_setup(cls, setup: Setup, pace: str = "slice") -> Self:
        """Return a session of a setup."""
        session = cls.__new__(cls)
        session._begin(setup, pace)
        return session

    def _begin(self, setup: Setup, pace: str) -> None:
        self.on_travel: Callable[[int, int], None] | None = None
        self._core = SessionCore(setup, self._poll)
        self._pasts = PastRuns()
        self._setup = setup
        self.description: Description = self._core.description
        has_schedule = setup.rtconf is not None
        self._pacing = Pacing(pace, self.description.cycle_time_us, has_schedule=has_schedule)
        self._subscribers = Subscribers(self._core)
        self._goal: int | None = None
        self._thread = SessionThread(self._run_slice, self._prepare, self._how_far)
        self._ask, self.together = self._thread.ask, self._thread.together

    def _poll(self) -> None:
        """End travel if it is interrupted; report its progress."""
        self._thread.poll()
        progress = self._core.progress
        if self.on_travel is not None and progress is not None:
            self.on_travel(*progress)

    def _how_far(self) -> tuple[int, int | None]:
        """Return how many of how many ticks have been rerun or, if none, have been run."""
        return self._core.progress or (self._core.tick, self._goal)

    def _prepare(self) -> bool:
        try:
            return self._core.prepare()
        except (Failure, RuntimeError):  # going there reports the reason
            return False

    def _run_slice(self, clock: AnyClock) -> None:
        end = clock.next_tick(time.monotonic())
        try:
            rests = isinstance(clock, FastClock) and clock.rests
            done = self._core.run(end, events=self._subscribers.wants_events, rests=rests)
            clock.note(done.tick - done.first_tick, self._core.took_s)
            is_at_end = bool(done.hits) or done.run_state is not None or done.is_resting
            if done.hits:
                done = replace(done, hits=self._core.enter(self._core.stops, done.hits))
            if is_at_end:
                self._thread.clock = None
            self._publish(done, at_once=is_at_end)
        except (Failure, RuntimeError) as error:
            self._thread.clock = None
            self._subscribers.notify("refused", error_text(error), error_text(error, "de"))

    @property
    def tick(self) -> int:
        """The tick that comes next."""
        return self._core.tick

    @property
    def progress(self) -> tuple[int, int] | None:
        """How many of how many ticks of the past have been run again, while some are."""
        return self._core.progress

    @property
    def latest(self) -> StepResult:
        """The results of the latest ticks."""
        return self._core.latest

    @property
    def is_over(self) -> bool:
        """Whether the run has ended at this tick."""
        return self._core.is_over

    @property
    def branch(self) -> int:
        """The number of the branch of the tape that it is in, from 1."""
        return self._core.branch.number

    @property
    def branches(self) -> dict[int, int]:
        """The branches of the tape, each with the tick that it has reached."""
        return {branch.number: branch.latest for branch in self._core.branches}

    @property
    def origins(self) -> dict[int, tuple[int, int]]:
        """The branches of the tape, each with the branch that it left and its first tick.

        The first one has left none: 0.
        """
        return {
            branch.number: (0 if branch.parent is None else branch.parent.number, branch.first_tick)
            for branch in self._core.branches
        }

    @property
    def folders(self) -> tuple[str | Path, ...]:
        """The only folders whose files may be read, if any are given."""
        return tuple(self._setup.folders)

    @property
    def input_count(self) -> int:
        """The number of inputs of the branch itself."""
        return len(self._core.branch.inputs)

    @property
    def stops(self) -> tuple[StopAt, ...]:
        """The stops at which it stops."""
        return self._core.stops

    # --- forward --------------------------------------------------------------------------------

    def run(
        self,
        end: TimeLike | None = None,
        *,
        until: str | StopAt | Sequence[str | StopAt] = (),
        rests: bool = False,
    ) -> StepResult:
        """Run to a time, a stop of the session or of ``until``, or the end of the run.

        A time that has passed already runs nothing. Without a time, or with ``rests``, it also ends
        where nothing can happen any more by itself, such as in single block, which waits for START;
        ``is_resting`` and the diagnostics of the slice say so.
        """
        named = [until] if isinstance(until, str | StopAt) else until
        return self._ask(self._run, end, named, rests)

    def _run(self, end: TimeLike | None, until: Sequence[str | StopAt], rests: bool) -> StepResult:
        tick = None if end is None else self._core.ticks_of(end)
        stops = [*self._core.stops, *self._core.read_stops(until)]
        return self._run_to(tick, stops, rests=rests or end is None)

    def _run_to(
        self, end: int | None, stops: Sequence[StopAt], *, rests: bool = False
    ) -> StepResult:
        """Run in slices, so that ``pause`` and ``close`` can end it.

        Within a cycle of the PLC the rest of that comes first.
        """
        self._thread.clock = None
        if end is None or end > self._core.tick or self._core.cursor.statement is not None:
            moved = self._core.moved_within(stops)
            if moved is not None:
                return moved
        self._goal = end
        try:
            return self._run_slices(end, stops, rests)
        finally:
            self._goal = None

    def _run_slices(self, end: int | None, stops: Sequence[StopAt], rests: bool) -> StepResult:
        clock = FastClock(self._core.tick)
        whole: StepResult | None = None
        while True:
            due = clock.next_tick(time.monotonic())
            is_last = end is not None and due >= end
            events = is_last or self._subscribers.wants_events
            due = due if end is None else min(due, end)
            done = self._core.run(due, stops=stops, events=events, rests=rests)
            clock.note(done.tick - done.first_tick, self._core.took_s)
            whole = done if whole is None else joined(whole, done)
            is_there = bool(done.hits or done.run_state or done.is_resting)
            is_there = is_there or (end is not None and done.tick >= end)
            self._publish(done, at_once=is_there)
            if is_there:
                return replace(whole, hits=self._core.enter(stops, done.hits))
            if self._thread.is_interrupted:
                return joined(whole, self._core.step(0))

    def step(self, ticks: int = 1) -> StepResult:
        """Run this number of ticks, past any stop."""
        return self._ask(lambda: self._run_to(self._core.tick + ticks, []))

    def next_block(self) -> StepResult:
        """Run until a block becomes current, or none can without input, as for ``run``."""
        return self._ask(lambda: self._run_to(None, [NEXT_BLOCK], rests=True))

    def step_statement(self, step: Step = "into") -> PlcPlace | None:
        """Go to the next statement of a PLC in Structured Text; return where it is then.

        ``step``: ``into`` calls, ``over`` them, or ``out`` of this one. ``None``: the run ended
        first. Raises ``Failure`` without such a PLC (902810), and if it has stopped (902818).
        """
        return self._ask(self._step_statement, step)

    def _step_statement(self, step: Step) -> PlcPlace | None:
        self._core.cursor.check_goes_on()
        self._run_to(None, [self._core.cursor.sought(step), FAULT, *self._core.stops])
        return self._core.cursor.statement

    def sought(self, step: Step) -> StopAt:
        """Return the stop at which a step from here ends; raises ``Failure`` (902810)."""
        return self._ask(self._core.cursor.sought, step)

    def step_statement_back(self, step: Step = "into") -> PlcPlace | None:
        """Go back to the last statement before this one; otherwise as ``step_statement``.

        ``None`` if there is none; then it does not move.
        """
        return self._ask(self._step_statement_back, step)

    def _step_statement_back(self, step: Step) -> PlcPlace | None:
        done = self._back_to([self._core.cursor.sought(step), *self._core.stops])
        return None if done is None else self._core.cursor.statement

    @property
    def statement(self) -> PlcPlace | None:
        """Where it is within the cycle of a PLC: before a statement; ``None`` after a tick."""
        return self._core.cursor.statement

    def scopes(self, level: int | None = 0) -> list[str]:
        """Return the scopes of a call of the PLC, counted from the innermost; ``None``: global."""
        return self._ask(self._core.cursor.look, "scopes", level)

    def of_scope(
        self, scope: str, level: int | None = 0, first: int = 0, count: int = 0
    ) -> list[PlcValue]:
        """Return variables of a scope of a call of the PLC, at most 1,000."""
        return self._ask(self._core.cursor.look, "of_scope", level, scope, first, count)

    def below(
        self, path: str, level: int | None = 0, first: int = 0, count: int = 0
    ) -> list[PlcValue]:
        """Return members, elements, or the target, of a variable of the PLC.

        Raises ``Failure`` for an unknown variable, and for one that refers to nothing.
        """
        return self._ask(self._core.cursor.look, "below", level, path, first, count)

    def texts_beside(
        self, file: str, lines: Sequence[Line], level: int | None = 0, instance: str = ""
    ) -> list[list[str]]:
        """Return the values of names in lines of a PLC's file, such as ``[(12, ["n", "a.b"])]``.

        Names have the meaning of their line: in a call, counted from the innermost, if the line
        belongs to it, else in an ``instance`` of the block. "" for a variable that has parts, or no
        value there.
        """
        return self._ask(self._core.cursor.look, "texts_beside", level, instance, file, lines)

    def tree_beside(
        self,
        file: str,
        line: Line,
        opened: Sequence[str] = (),
        level: int | None = 0,
        instance: str = "",
    ) -> list[Branch]:
        """Return the variables named in a line of a PLC's file as a tree: depth and value of each.

        Variables with one of the paths ``opened`` are expanded. Those without a value are left out.
        """
        words = (level, instance, file, line, tuple(opened))
        return self._ask(self._core.cursor.look, "tree_beside", *words)

    def plc_instances(self, file: str) -> list[str]:
        """Return the paths of the instances of the blocks that a PLC's file declares."""
        return self._ask(self._core.cursor.look, "instances", file)

    def value(self, text: str, level: int | None = 0) -> PlcValue:
        """Return a variable by path, or an expression in Structured Text, in a call of the PLC.

        Nothing is called or changed by that. Raises ``Failure`` for mistakes (902812 … 902814).
        """
        return self._ask(self._core.cursor.value, text, level)

    def next_reaction(self) -> StepResult:
        """Run until a branch of a realtime cycle fires, or nothing can happen any more."""
        return self._ask(lambda: self._run_to(None, [NEXT_REACTION], rests=True))

    # --- back -----------------------------------------------------------------------------------

    def go_to(self, tick: int, branch: int | None = None) -> StepResult:
        """Go to just before a tick of a branch, by default this one (901154, 901157)."""
        return self._ask(self._travel, self._core.go_to, tick, branch)

    def back(self, ticks: int = 1) -> StepResult:
        """Go back by this number of ticks, at most to the start."""
        return self._ask(self._travel, self._core.back, ticks)

    def back_to(self, *stops: str | StopAt) -> StepResult | None:
        """Go back to the last time that one of these stops held, by default the session's.

        ``None`` if that never happened; then it does not move.
        """
        return self._ask(self._back_to, stops)

    def previous_block(self) -> StepResult | None:
        """Go back to where the block before became current."""
        return self._ask(self._back_to, [NEXT_BLOCK])

    def previous_reaction(self) -> StepResult | None:
        """Go back to the last time that a branch fired."""
        return self._ask(self._back_to, [NEXT_REACTION])

    def last_change(self, expression: str) -> StepResult | None:
        """Go back to the last time that the value of an expression changed."""
        return self._ask(self._back_to, [StopAt("changes", expression)])

    def _back_to(self, stops: Sequence[str | StopAt]) -> StepResult | None:
        self._thread.clock = None
        named, evidence = self._core.sought(stops) if stops else (self._core.stops, None)
        moved = self._core.moved_within(named, is_back=True)
        if moved is not None:
            return moved
        done = self._core.back_to(named, evidence)
        if done is None:
            return None
        done = self._travelled(done)
        return self._core.moved_within(named, is_back=True) or done

    def _travel(self, method: Callable[..., StepResult], *words: Any) -> StepResult:
        self._thread.clock = None
        return self._travelled(method(*words))

    # --- the clock ------------------------------------------------------------------------------

    def play(self, speed: float | None = None, *, rests: bool = False) -> None:
        """Run continuously: at ``speed`` times the wall clock, 0.01 … 1000, else at full speed.

        Within a cycle of the PLC, a later statement of that at which a stop holds comes first.
        ``rests``: at full speed, stop where nothing can happen any more by itself. Raises
        ``ValueError`` for another speed.
        """
        self._ask(self._play, speed, rests)

    def _play(self, speed: float | None, rests: bool) -> None:
        if self._core.cursor.statement is not None:
            moved = self._core.moved_within(self._core.stops)
            if moved is not None:
                self._publish(replace(self._core.step(0), hits=moved.hits), at_once=True)
                return
        self._core.restart_schedule()
        clock = self._pacing.clock(speed, self._core.tick, time.monotonic())
        if isinstance(clock, FastClock):
            clock.rests = rests
        self._thread.clock = clock

    def pause(self) -> StepResult:
        """Stop between two ticks, also a ``run`` of another thread; return the latest slice."""
        self.interrupt()
        return self._ask(self._pause)

    def interrupt(self) -> None:
        """Let runs and steps of other threads end soon; travel and ``why`` raise 901474."""
        self._thread.interrupt()

    def _pause(self) -> StepResult:
        clock, self._thread.clock = self._thread.clock, None
        if clock is None:
            return self._core.latest
        self._subscribers.flush()
        return self._core.with_events()

    @property
    def speed(self) -> float | None:
        """The factor to the wall clock; ``None`` at full speed, and while it pauses."""
        clock = self._thread.clock
        return None if clock is None else clock.speed

    @property
    def is_playing(self) -> bool:
        """Whether it runs continuously."""
        return self._thread.clock is not None

    @property
    def lateness(self) -> tuple[int, float]:
        """The number of late slices since ``play``, and the largest lateness in seconds."""
        clock = self._thread.clock
        return (clock.late_count, clock.worst_s) if isinstance(clock, WallClock) else (0, 0.0)

    # --- stops, inputs --------------------------------------------------------------------------

    def set_stops(self, *stops: str | StopAt, only_check: bool = False) -> tuple[StopAt, ...]:
        """Stop at these, and at no other, from now on; raises ``Failure`` with all mistakes."""
        return self._ask(self._core.read_stops if only_check else self._core.set_stops, stops)

    def write(self, values: Mapping[str, float | bool | str], source: str = API) -> None:
        """Let variables or the operator's values have these from the next tick on.

        In the past this begins another branch of the tape. Raises ``Failure`` for a wrong name or
        value, and nothing is written.
        """
        self._ask(self._input, self._core.write, values, source)

    def write_each(
        self, requests: Sequence[tuple[Mapping[str, float | bool | str], str]]
    ) -> list[Failure | int]:
        """Write values with their sources; return for each why it is refused, or its tick."""
        answers: list[Failure | int] = []
        self._ask(self._input, self._core.write_each, requests, answers)
        return answers

    def acknowledge(
        self, channel: int, entry: TechnologyEntry | SpindleEntry, source: str = API
    ) -> None:
        """Acknowledge an entry of ``waiting``; otherwise as ``write``."""
        self._ask(self._input, self._core.acknowledge, channel, entry, source)

    def select(self, program: str | Path, channel: int = 1, source: str = API) -> None:
        """Select a program file for a channel: from the next tick on, as an input on the tape.

        It begins at once, with ``wait_for_start`` by START; a channel whose program runs, or that
        has an error, keeps its program (901148). Raises ``Failure`` for a file with mistakes.
        """
        self._ask(self._input, self._core.select, str(program), channel, source)

    def acknowledge_after(self, ticks: int | None) -> None:
        """Acknowledge functions and spindle jobs this number of ticks after they came up.

        The answers are inputs on the tape. ``None``: no longer. Raises ``ValueError`` below 1.
        """
        if ticks is not None and ticks < 1:
            raise ValueError(ticks)
        self._ask(setattr, self._core, "delay", ticks)

    def _input(self, method: Callable[..., bool], *words: Any) -> None:
        if method(*words):
            self._subscribers.notify("branch", str(self._core.branch.number))

    # --- looking --------------------------------------------------------------------------------

    def read(self, *names: str) -> list[float | bool | str]:
        """Return signals and variables at this tick; raises ``Failure`` for an unknown name."""
        return self._ask(self._core.read, names)

    def evaluate(self, expression: str, channel: int = 1) -> float:
        """Return the value of an expression in the controller's language at this tick.

        It is no number where the expression is not defined; ``undefined`` says why.
        """
        return self._ask(self._core.evaluate, expression, channel)

    def undefined(self, expression: str, channel: int = 1) -> Text | None:
        """Return why an expression is not defined at this tick, ``None`` if it is."""
        return self._ask(self._core.undefined, expression, channel)

    def cycles(self) -> list[CycleState]:
        """Return the living realtime cycles at this tick, with the truth of their conditions."""
        return self._ask(self._core.cycles)

    def waiting(self) -> list[tuple[int, TechnologyEntry | SpindleEntry]]:
        """Return functions and spindle jobs that wait for the PLC, each with its channel."""
        return self._ask(self._core.waiting)

    def state_view(self, *names: str) -> StateView:
        """Return values, living cycles and functions waiting for the PLC, all of the same tick."""
        return self._ask(self._core.state_view, names)

    def events(self, first: int, end: int) -> tuple[list[Event], int]:
        """Return the events of the ticks from ``first`` up to, but without, ``end``.

        At most the latest 1,000; how many there were before them comes with them. The session stays
        where it is.
        """
        done = self.happened(first, end)
        return list(done.events), done.left_out

    def event_search(self, branch: int | None = None) -> EventSearch:
        """Return a search over all events of a branch, by default this one, beside the session.

        Raises ``Failure`` (901157) for a branch that there is not.
        """
        timeline = self._core.timeline
        return EventSearch(self._ask, timeline, timeline.reached(0, branch))

    def time_account(self, branch: int | None = None) -> PastAccount:
        """Return an account of a branch's time, by default this one's, beside the session.

        Raises ``Failure`` (901157) for a branch that there is not.
        """
        timeline = self._core.timeline
        return PastAccount(self._ask, timeline, timeline.reached(0, branch))

    def happened(self, first: int, end: int) -> StepResult:
        """Return the results of the ticks from ``first`` up to, but without, ``end``.

        Of the events there are at most the latest 1,000. The session stays where it is.
        """
        return self._ask(self._core.happened, first, end)

    def future(self, *signals: str) -> Iterator[Future]:
        """Run a copy ahead from where the branch ends; each item knows more of the future.

        The session continues meanwhile. The result is what will happen unless somebody writes.
        """
        engine = self._ask(self._core.ahead)
        return iter((UNKNOWN,)) if engine is None else run_ahead(engine, signals)

    def fork(self, one: int, other: int) -> int:
        """Return the tick before which two branches are the same; raises ``Failure`` (901157)."""
        return self._core.fork(one, other)

    def compare_branches(self, one: int, other: int) -> BranchDifference:
        """Return where the signals of two branches differ first; raises ``Failure`` (901157)."""
        return self._ask(self._core.compare, one, other, self._poll)

    def why(
        self,
        tick: int | None = None,
        branch: int | None = None,
        *,
        meanwhile: Callable[[], None] = lambda: None,
    ) -> WhyReport:
        """Return why reactions have fired up to a tick, by default up to here, or have not.

        The past is rerun for it; the session continues meanwhile. ``meanwhile`` is called now and
        then, and may end it by an exception. Raises ``Failure`` if there are no ticks yet, or a
        branch has not reached the tick (901154, 901157).
        """
        is_interrupted = self._thread.poller()

        def poll() -> None:
            is_interrupted()
            meanwhile()

        report = self._pasts.explained(self._ask(self._core.past, tick, branch), poll).why
        assert report is not None
        return report

    def look(
        self, first: int, end: int, signals: Sequence[str], rows: int = MAX_ROWS
    ) -> tuple[int, memoryview[float]]:
        """Return signals after the ticks from ``first`` up to, but without, ``end``.

        At most ``rows`` rows of float64 cells: one for each, or for each second, third … tick; the
        distance comes with them. The session stays where it is.
        """
        return self._ask(self._core.look, first, end, signals, rows)

    def outline(
        self, first: int, end: int, signals: Sequence[str], followed: int, count: int
    ) -> tuple[list[int], list[list[float]]]:
        """Return some ticks from ``first`` up to ``end``, and signals after them, by columns.

        At most ``count`` ticks: those that show best where the first ``followed`` signals go. The
        session stays where it is.
        """
        return self._ask(self._core.outline, first, end, signals, followed, count)

    def inventory(self) -> Inventory:
        """Return the variables of the machine, and the realtime cycles of its programs."""
        return self._ask(self._core.inventory)

    def instructions(self) -> list[tuple[str, ListedCycle]]:
        """Return the living realtime cycles as their elementary instructions, with their names."""
        return self._ask(self._core.instructions)

    def decoders(self) -> list[DecoderState]:
        """Return the decoders with a program open: their programs, variables, parameters."""
        return self._ask(self._core.decoders)

    def result(self) -> Run:
        """Return the result of the run up to here; the session continues."""
        return self._ask(self._core.result)

    def recorded(
        self,
        end: int | None = None,
        branch: int | None = None,
        *,
        signals: Sequence[str] | None = None,
    ) -> RecordedRun:
        """Return the run of a branch up to a tick, by default up to here, with its trace.

        ``signals``: those of the trace, by default those of a run. The past is rerun for it; the
        session continues meanwhile. Raises ``Failure`` for an unknown signal, and for a tick or
        branch that there is not (901154, 901157).
        """
        past = self._ask(self._core.past, end, branch)
        rerun = PastRecording(self._ask, self._core.timeline, past.branch)
        poll, progress = self._thread.poller(), notebook_progress("Session")

        def on_progress(done: int, whole: int) -> None:
            poll()
            if progress is not None:
                progress.show(done, whole)

        with contextlib.ExitStack() as at_the_end:
            if progress is not None:
                at_the_end.callback(progress.close)
            return rerun.run(past.tick, signals, on_progress)

    def retained(self) -> str:
        """Return the PLC's retained values of this tick, as the text of a file (ST-406)."""
        return self._ask(self._core.retained)

    def tape(self) -> list[Input]:
        """Return the inputs of this branch, the PLC's too, in the order of their ticks."""
        return self._ask(self._core.tape)

    def news(self, first: int) -> tuple[int, int, list[Input]]:
        """Return branch, latest tick, and the inputs before it from tick ``first`` on."""
        return self._ask(self._core.news, first)

    def save(self, path: str | Path) -> None:
        """Write this branch up to its latest tick as a tape for ``nctakt replay``.

        Its run is repeated for that; the session continues meanwhile. Raises ``Failure`` for a file
        that cannot be written.
        """
        inputs, ticks = self._ask(lambda: (self._core.tape(), self._core.branch.latest))
        save_tape(path, self._setup, inputs, ticks)

    def schedule_table(self, language: Language) -> str:
        """Return the table of a real schedule up to here; empty without one."""
        return self._ask(self._core.schedule_table, language)

    # --- listening ------------------------------------------------------------------------------

    @contextlib.contextmanager
    def listen(
        self, *signals: str, rate_hz: float = 20.0, events: bool = True
    ) -> Iterator[Listener]:
        """Listen to signals, at most this often a second, and to events if these are wanted.

        Raises ``Failure`` for an unknown signal.
        """
        listener = Listener(signals, rate_hz, wants_events=events)
        self.attach(listener, signals)
        try:
            yield listener
        finally:
            self.detach(listener)

    def attach(self, listener: Listener, signals: Sequence[str] = ()) -> None:
        """Let a listener hear these signals alone from now on, until ``detach``; see ``listen``."""
        self._ask(self._subscribers.add, listener, self.speed, signals)

    def detach(self, listener: Listener) -> None:
        """Let a listener hear nothing more."""
        with contextlib.suppress(Failure):
            self._ask(self._subscribers.remove, listener)

    def _travelled(self, done: StepResult) -> StepResult:
        self._subscribers.travel(done)
        return done

    def _publish(self, done: StepResult, *, at_once: bool) -> None:
        self._subscribers.publish(done, self.speed, at_once=at_once)

    # --- the end --------------------------------------------------------------------------------

    def abandon(self) -> None:
        """Kill a controller that does not answer: who waits for it gets 901153."""
        self._core.abandon()

    def close(self) -> None:
        """End the session and all its processes; a controller that does not answer is killed."""
        if not self._thread.is_closed:
            self._thread.close(self._core.abandon)
            self._subscribers.notify("closed")
            self._pasts.close()
            self._core.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _repr_html_(self) -> str:
        """Return tables for notebooks: where it is, and its realtime cycles; a picture."""
        latest = self.latest
        cycle_time_us = self.description.cycle_time_us
        rows = [
            ("state", latest.state),
            ("tick", f"{self.tick}, {Time(self.tick * cycle_time_us)}"),
            ("branch", str(self.branch)),
            *((f"block of channel {number}", str(span)) for number, span in latest.blocks.items()),
        ]
        if self.is_over:
            return html_table("Session", rows) + self._picture()
        rows += [("waits for the PLC", entry.name) for _, entry in self.waiting()]
        cycles = [
            (one.name, one.scope, one.state, str(one.runs), str(one.span)) for one in self.cycles()
        ]
        heads = ("cycle", "scope", "state", "runs", "defined at")
        table = html_columns("Realtime cycles", heads, cycles) if cycles else ""
        return html_table("Session", rows) + table + self._picture()

    def _picture(self) -> str:
        """Return the run up to here as a picture for notebooks; empty for none and long ones."""
        if not 0 < self.tick <= MAX_DRAWN:
            return ""
        try:
            return self.recorded().html_picture()
        except Failure:  # whoever goes back gets the reason
            return ""

    def __repr__(self) -> str:
        return f"<Session at tick {self.tick} of branch {self.branch}, {self.latest.state}>"
