# SPDX-License-Identifier: MIT
"""The commands of a session -> their effects, without a thread, a socket or a clock.

In: commands such as step, run, back, post. Out: slices, values. A session is between two ticks:
``tick`` is the next one, and a command returns the results of the ticks before it.
"""

from __future__ import annotations

from array import array
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import cast

from nctakt.base.diagnostics import Language, Text
from nctakt.base.failure import Failure
from nctakt.hli.plc_entries import SpindleEntry, TechnologyEntry
from nctakt.lists.format.times import TimeLike, read_time
from nctakt.results.instruction_tree import ListedCycle
from nctakt.results.run import Run
from nctakt.run.access.input_words import WRITE
from nctakt.run.access.inputs import ACKNOWLEDGE, ACKNOWLEDGE_SPINDLE, SELECT, Input
from nctakt.session.cursor import Cursor
from nctakt.session.decoders import DecoderState
from nctakt.session.engine import CycleState, Evidence, StateView, StepResult, joined
from nctakt.session.history.branch import Branch
from nctakt.session.history.comparing import BranchDifference
from nctakt.session.history.past import Past
from nctakt.session.history.timeline import Poll, Timeline
from nctakt.session.process.process_pool import RemoteEngine
from nctakt.session.setup import Description, Inventory, Setup
from nctakt.session.stops import StopAt

#: Rows that a look at a stretch of the session returns at most.
MAX_ROWS = 20_000

#: The stops at which a step to the next block or reaction ends.
NEXT_BLOCK = StopAt("block")
NEXT_REACTION = StopAt("fires")

#: Where an automatic acknowledgement waits for its tick.
HANDED = StopAt("handed")

#: Where automatic acknowledgements come from, on the tape.
AUTOMATIC = "automatic"

#: A tick that no session reaches.
_NEVER = 1 << 60


class SessionCore:
    """One session's commands; raises ``Failure`` with the mistakes of the setup.

    ``stops``: those at which it stops, in the order in which they were added. ``delay``: ticks
    after which functions and jobs of spindles are acknowledged as by a person; ``None``: never.
    ``poll`` is called while the past is rerun, and may end that by an exception.
    """

    def __init__(self, setup: Setup, poll: Poll = lambda: None) -> None:
        self.timeline = Timeline(setup, poll)
        self.description: Description = self.timeline.description
        self.cursor = Cursor(self.timeline)
        self.stops: tuple[StopAt, ...] = ()
        self.delay: int | None = None
        self._latest = self.timeline.run(0)

    # --- where it is ----------------------------------------------------------------------------

    @property
    def tick(self) -> int:
        """The tick that comes next."""
        return self.timeline.tick

    @property
    def took_s(self) -> float:
        """How long the controller took for its latest ticks, in seconds, however long it waited."""
        return self.timeline.took_s

    @property
    def branch(self) -> Branch:
        """The branch of the tape that it is in."""
        return self.timeline.branch

    @property
    def branches(self) -> Sequence[Branch]:
        """All branches of the tape."""
        return self.timeline.branches

    @property
    def is_over(self) -> bool:
        """Whether the run has ended at this tick."""
        return self._latest.run_state is not None

    @property
    def progress(self) -> tuple[int, int] | None:
        """How many of how many ticks of the past have been run again, while some are."""
        return self.timeline.progress

    @property
    def latest(self) -> StepResult:
        """The result of the last command that ran ticks."""
        return self._latest

    def ticks_of(self, time: TimeLike) -> int:
        """Return the tick that begins at or after a time of the session."""
        return read_time(time).ticks(self.description.cycle_time_us)

    # --- forward --------------------------------------------------------------------------------

    def run(
        self,
        end: int | None = None,
        *,
        stops: Sequence[StopAt] | None = None,
        events: bool = True,
        rests: bool = False,
    ) -> StepResult:
        """Run up to tick ``end``, to a stop, or to the end of the run.

        ``stops`` are watched instead of those of the session. Without ``events`` those of the slice
        come with the next slice that ends at a stop or has any. ``rests``: also stop where nothing
        can happen any more without input.
        """
        watched = self.stops if stops is None else tuple(stops)
        last = _NEVER if end is None else end
        if last > self.tick:
            self.cursor.leave()
        if self.delay is None:
            self._latest = self.timeline.run(last, watched, events=events, rests=rests)
        else:
            self._latest = self._run_acknowledging(last, watched, self.delay, rests=rests)
        return self._latest

    def with_events(self) -> StepResult:
        """Return the latest slice with the events that were left for later."""
        self._latest = joined(self._latest, self.timeline.run(self.tick))
        return self._latest

    def _run_acknowledging(
        self, end: int, stops: Sequence[StopAt], delay: int, *, rests: bool
    ) -> StepResult:
        """Run, and plan an acknowledgement for all that comes up; the tape holds it then."""
        whole: StepResult | None = None
        watched = (*stops, HANDED)
        while True:
            self._plan_acknowledgements(delay)
            done = self.timeline.run(end, watched, rests=rests)
            hits = [hit for hit in done.hits if hit < len(stops)]
            is_on_way = bool(done.hits) and not hits and done.run_state is None and done.tick < end
            done = replace(done, hits=tuple(hits))
            whole = done if whole is None else joined(whole, done)
            if not is_on_way:
                return whole

    def _plan_acknowledgements(self, delay: int) -> None:
        """Have waiting functions acknowledged after their time, unless the tape does that."""
        branch = self.timeline.branch
        if self.tick < branch.latest:
            return
        planned = {(one.kind, one.values) for one in branch.all_inputs() if one.tick >= self.tick}
        cycle_us = self.description.cycle_time_us
        for channel, entry in self.waiting():
            due = max(self.tick, entry.time_us // cycle_us + delay)
            answer = _acknowledgement(due, channel, entry, AUTOMATIC)
            if (answer.kind, answer.values) not in planned:
                self.timeline.post([answer])

    def moved_within(self, stops: Sequence[StopAt], *, is_back: bool = False) -> StepResult | None:
        """Go to the next statement of this PLC cycle at which a stop holds, or back to one.

        Returns the latest slice with these stops as its hits; ``None`` if there is none.
        """
        own = [index for index, stop in enumerate(stops) if stop.kind == "statement"]
        chosen = [stops[index] for index in own]
        cursor = self.cursor
        met = cursor.last_in_tick(chosen) if is_back else cursor.next_in_tick(chosen)
        if met:
            return replace(self._latest, hits=tuple(own[index] for index in met))
        faults = [index for index, stop in enumerate(stops) if stop.kind == "fault"]
        halted = cursor.statement
        if is_back or not faults or halted is None or halted.fault is not None:
            return None
        # The PLC has passed this statement, so a fault belongs to the same tick.
        if not cursor.enter_fault() or cursor.statement is None or cursor.statement.fault is None:
            return None
        texts = ("", str(cursor.statement.fault.id))
        return replace(
            self._latest, hits=tuple(index for index in faults if stops[index].text in texts)
        )

    def enter(self, stops: Sequence[StopAt], hits: Sequence[int]) -> tuple[int, ...]:
        """Be where in the last tick the first of some stops has held, if that is in the PLC.

        ``hits``: those that have held; returns them without those at later statements.
        """
        own = [hit for hit in hits if hit < len(stops) and stops[hit].kind == "statement"]
        met = self.cursor.first_in_tick([stops[hit] for hit in own])
        first = {own[index] for index in met}
        faults = [hit for hit in hits if hit < len(stops) and stops[hit].kind == "fault"]
        if faults and not first:
            self.cursor.enter_fault()
        later = {*own} - first | ({*faults} if first else set())
        return tuple(hit for hit in hits if hit not in later)

    def step(self, ticks: int = 1) -> StepResult:
        """Run this number of ticks, past any stop."""
        return self.run(self.tick + ticks, stops=())

    # --- back -----------------------------------------------------------------------------------

    def go_to(self, tick: int, branch: int | None = None) -> StepResult:
        """Go to just before a tick the session has reached; raises ``Failure`` (901154, 901901).

        Where it is interrupted it stays where it was.
        """
        self.cursor.leave()
        self._latest = self.timeline.go_to(tick, branch)
        return self._latest

    def prepare(self) -> bool:
        """Work for commands to come, while there are none; return whether there is more to do."""
        return self.timeline.refine()

    def back(self, ticks: int = 1) -> StepResult:
        """Go back by this number of ticks, at most to the start."""
        return self.go_to(max(0, self.tick - ticks))

    def back_to(
        self, stops: Sequence[StopAt], evidence: Sequence[Evidence] | None = None
    ) -> StepResult | None:
        """Go back to the last time that one of these stops held; ``None``, and stay, if never.

        ``evidence``: the result of ``sought`` for them.
        """
        tick = self.timeline.previous(stops, evidence)
        return None if tick is None else self.go_to(tick)

    # --- stops ----------------------------------------------------------------------------------

    def set_stops(self, stops: Sequence[StopAt | str]) -> tuple[StopAt, ...]:
        """Stop at these from now on; raises ``Failure`` with all mistakes, and keeps the old."""
        self.stops = self.read_stops(stops)
        return self.stops

    def read_stops(self, stops: Sequence[StopAt | str]) -> tuple[StopAt, ...]:
        """Return stops that this machine can watch; raises ``Failure`` with all mistakes."""
        if all(stop in (NEXT_BLOCK, NEXT_REACTION) for stop in stops):
            return cast("tuple[StopAt, ...]", tuple(stops))
        return cast("tuple[StopAt, ...]", self.timeline.live.ask("read_stops", tuple(stops)))

    def sought(
        self, stops: Sequence[StopAt | str]
    ) -> tuple[tuple[StopAt, ...], Sequence[Evidence]]:
        """Return stops as ``read_stops``, and the record's evidence about each of them.

        It is a single request to the controller, since two take longer than the record of a short
        run.
        """
        found = self.timeline.live.ask("sought", tuple(stops))
        return cast("tuple[tuple[StopAt, ...], Sequence[Evidence]]", found)

    # --- inputs ---------------------------------------------------------------------------------

    def write(self, values: Mapping[str, float | bool | str], source: str) -> bool:
        """Let variables or the operator's values have these from the next tick on.

        Returns whether another branch of the tape has begun. Raises ``Failure`` for a wrong name or
        value.
        """
        return self.timeline.post(
            [Input(self.tick, source, WRITE, (name, value)) for name, value in values.items()]
        )

    def write_each(
        self,
        requests: Sequence[tuple[Mapping[str, float | bool | str], str]],
        answers: list[Failure | int],
    ) -> bool:
        """Write for several clients; ``answers``: the reason for a refusal, or the tick."""
        groups = [
            [Input(self.tick, source, WRITE, pair) for pair in values.items()]
            for values, source in requests
        ]
        begins, refused = self.timeline.post_each(groups)
        answers += [self.tick if failure is None else failure for failure in refused]
        return begins

    def select(self, program: str, channel: int, source: str) -> bool:
        """Select a program file for a channel, counted from 1; returns as ``write``."""
        values = channel - 1, program
        return self.timeline.post([Input(self.tick, source, SELECT, values)])

    def acknowledge(self, channel: int, entry: TechnologyEntry | SpindleEntry, source: str) -> bool:
        """Acknowledge an entry of ``waiting``; returns as ``write``."""
        return self.timeline.post([_acknowledgement(self.tick, channel, entry, source)])

    # --- looking --------------------------------------------------------------------------------

    def read(self, names: Sequence[str]) -> list[float | bool | str]:
        """Return signals and variables at this tick; raises ``Failure`` for an unknown name."""
        return self.timeline.live.read(tuple(names))

    def evaluate(self, text: str, channel: int = 1) -> float:
        """Return the value of an expression in the controller's language at this tick."""
        return cast("float", self.timeline.live.ask("evaluate", text, channel))

    def undefined(self, text: str, channel: int) -> Text | None:
        """Return why an expression is not defined at this tick, ``None`` if it is."""
        return cast("Text | None", self.timeline.live.ask("undefined", text, channel))

    def cycles(self) -> list[CycleState]:
        """Return the living realtime cycles at this tick."""
        return self.timeline.live.cycles()

    def waiting(self) -> list[tuple[int, TechnologyEntry | SpindleEntry]]:
        """Return functions and jobs that wait for acknowledgement, each with its channel."""
        waiting = self.timeline.live.ask("waiting")
        return cast("list[tuple[int, TechnologyEntry | SpindleEntry]]", waiting)

    def look(
        self, first: int, end: int, signals: Sequence[str], rows: int = MAX_ROWS
    ) -> tuple[int, memoryview[float]]:
        """Return signals after the ticks from ``first`` up to, but without, ``end``.

        At most ``rows`` rows: one for each, or for each second, third … tick; the distance comes
        with them. The cells are float64, row after row. The session stays where it is.
        """
        end = min(end, self.branch.latest)
        first = min(max(0, first), end)
        count = max(1, min(rows, MAX_ROWS))
        every = max(1, -(-(end - first) // count))
        engine = self.timeline.trial(first)
        try:
            data = engine.ask("look", end, list(signals), every)
            self.timeline.confirm(engine, end)
        finally:
            engine.close()
        return every, memoryview(data).cast("d")

    def outline(
        self, first: int, end: int, signals: Sequence[str], followed: int, count: int
    ) -> tuple[list[int], list[list[float]]]:
        """Return some ticks from ``first`` up to ``end``, and signals after them, by columns.

        At most ``count`` ticks: those that show best where the first ``followed`` signals go.
        """
        end = min(end, self.branch.latest)
        engine = self.timeline.trial(min(max(0, first), end))
        try:
            data = engine.ask("outline", end, list(signals), followed, count)
            self.timeline.confirm(engine, end)
        finally:
            engine.close()
        rows = array("d", data).tolist()
        ticks, *columns = (rows[cell :: len(signals) + 1] for cell in range(len(signals) + 1))
        return [int(tick) for tick in ticks], columns

    def ahead(self) -> RemoteEngine | None:
        """Return a copy that can run ahead, or ``None`` if the future cannot be predicted."""
        return self.timeline.ahead()

    def fork(self, one: int, other: int) -> int:
        """Return the tick before which two branches are the same."""
        return self.timeline.fork(one, other)

    def compare(self, one: int, other: int, poll: Poll) -> BranchDifference:
        """Return where all signals of two branches differ first."""
        signals = self.description.signals
        shorter = (name.removeprefix("CH1.") for name in signals)
        return self.timeline.compare(one, other, tuple(dict.fromkeys(shorter)), poll)

    def happened(self, first: int, end: int) -> StepResult:
        """Return the results of the ticks from ``first`` up to ``end``.

        The session stays where it is.
        """
        end = min(end, self.branch.latest)
        return self.timeline.happened(min(max(0, first), end), end)

    def state_view(self, names: Sequence[str]) -> StateView:
        """Return values, cycles and waiting functions, all of this tick."""
        return cast("StateView", self.timeline.live.ask("state_view", list(names)))

    def past(self, tick: int | None = None, branch: int | None = None) -> Past:
        """Return everything needed to rerun a branch up to a tick, by default up to here."""
        timeline = self.timeline
        end = self.tick if tick is None else tick
        target = timeline.reached(end, branch)
        marks = tuple(target.marks_between(-1, end))
        return Past(timeline.setup, target, tuple(timeline.tape(target)), end, marks)

    # --- the end --------------------------------------------------------------------------------

    def inventory(self) -> Inventory:
        """Return the variables of the machine, and the realtime cycles of its programs."""
        return cast("Inventory", self.timeline.live.ask("inventory"))

    def instructions(self) -> list[tuple[str, ListedCycle]]:
        """Return the realtime cycles that live at this tick as their elementary instructions."""
        return cast("list[tuple[str, ListedCycle]]", self.timeline.live.ask("instructions"))

    def decoders(self) -> list[DecoderState]:
        """Return the decoders that have a program open at this tick."""
        return cast("list[DecoderState]", self.timeline.live.ask("decoders"))

    def result(self) -> Run:
        """Return the result of the run so far; the session does not move."""
        engine = self.timeline.trial(self.tick)
        try:
            return cast("Run", engine.ask("result"))
        finally:
            engine.close()

    def retained(self) -> str:
        """Return the text of the PLC's retained values at this tick."""
        return cast("str", self.timeline.live.ask("retained"))

    def restart_schedule(self) -> None:
        """Restart a real schedule after a pause."""
        self.timeline.restart_schedule()

    def schedule_table(self, language: Language) -> str:
        """Return the table of a real schedule; empty without one."""
        return self.timeline.schedule_table(language)

    def tape(self) -> list[Input]:
        """Return the inputs of this branch, the PLC's too, in the order of their ticks."""
        return self.timeline.tape()

    def news(self, first: int) -> tuple[int, int, list[Input]]:
        """Return branch, latest tick, and the inputs before it from tick ``first`` on."""
        return self.timeline.news(first)

    def abandon(self) -> None:
        """Kill a controller that does not answer."""
        self.timeline.abandon()

    def close(self) -> None:
        """End the session."""
        self.cursor.leave()
        self.timeline.close()


def _acknowledgement(
    tick: int, channel: int, entry: TechnologyEntry | SpindleEntry, source: str
) -> Input:
    """Return the input that acknowledges an entry of ``waiting`` in a tick."""
    values: tuple[float | str | bool, ...]
    if isinstance(entry, SpindleEntry):
        kind, values = ACKNOWLEDGE_SPINDLE, (channel - 1, entry.index, entry.serial, entry.name)
    else:
        slot = (entry.is_realtime, entry.slot, entry.serial, entry.name)
        kind, values = ACKNOWLEDGE, (channel - 1, *slot)
    return Input(tick, source, kind, values)
