# SPDX-License-Identifier: MIT
"""The past of a session: branches of its tape, parked controllers, travel to any moment.

In: runs forward, inputs, requests to move. Out: the live controller, at the requested moment. The
past is not stored but rerun: from the nearest parked controller along the tape. An input in the
past begins another branch; the old one stays.
"""

from __future__ import annotations

import bisect
import contextlib
import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import cast

from nctakt.base.diagnostics import Language
from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.connections.session import NO_SUCH_BRANCH, PLC_HOLDS_OPEN, TICK_NOT_REACHED
from nctakt.messages.scheduling.real_schedule import REAL_SCHEDULE_HAS_NO_PAST
from nctakt.run.access.inputs import PLC, SCHEDULE, Input, in_order
from nctakt.run.plcs.realtime_plc import is_structured
from nctakt.session.engine import Evidence, StepResult, joined
from nctakt.session.history.branch import Branch, index_of
from nctakt.session.history.columns import WRITE_KINDS, Necessary
from nctakt.session.history.comparing import BranchDifference, fork_of
from nctakt.session.history.comparing import first_difference as differing
from nctakt.session.history.parked import Parked, ParkedControllers
from nctakt.session.history.parking import COPY_US, DENSE_US, SPARSE_US, approach, first_gap
from nctakt.session.history.record import (
    BranchRecord,
    PastMark,
    check_programs,
    first_difference,
    past_differs,
    ticks_of,
)
from nctakt.session.history.trail import Confirmed
from nctakt.session.process.process_pool import ProcessPool, RemoteEngine
from nctakt.session.schedules import CLOSE, RESTART, TABLE
from nctakt.session.setup import Setup
from nctakt.session.stops import BLOCKS, StopAt

#: Ticks, and marks, between two calls of ``poll`` while the past is run again.
PART_TICKS = 100_000
PART_MARKS = 12

#: Work that a step back may do for those to come, in microseconds.
REFINED_US = 20_000.0

#: How far before a moment that somebody has travelled to controllers are parked at once, in us.
FAR_US = 100_000.0

#: Number of ticks before a moment whose events are delivered on arrival.
ARRIVAL_TICKS = 100

#: Steps back or forward, by blocks and by ticks, that need no separate proof after another.
NEAR_TICKS = 8

#: Work of the latest stretch that a search reruns, in microseconds, and how much longer each
#: earlier one is at least: a copy of a controller takes as long as some 30 ms of a run.
SEARCHED_US = 100_000.0
SEARCHED_GROWTH = 3.0

#: How often a stop may hold that only notes when it did last.
_NEVER = 1 << 60

Poll = Callable[[], None]


class Timeline:
    """The moments of a session, and the live controller at one of them.

    Raises ``Failure`` with the mistakes of the setup. ``branch``: the current branch. ``poll`` is
    called while the past is rerun, and may end that by an exception. ``progress``: how many of how
    many ticks of the past have been rerun so far, ``None`` while there are none. ``took_s``: how
    long the controller took for the latest ``run``, in seconds.
    """

    def __init__(self, setup: Setup, poll: Poll) -> None:
        self._setup = setup
        self._poll = poll
        self._pool = ProcessPool()
        try:
            self._live, self.description = self._pool.open(setup)
        except BaseException:
            self._pool.close()
            raise
        self._has_past = setup.rtconf is None
        # a controller with threads cannot be copied
        self._can_copy = self._pool.can_copy and self._has_past
        self.branch = Branch(1, None, 0, list(self.description.inputs))
        self.branches = [self.branch]
        self._plc: dict[int, list[Input]] = {1: []}
        self._parked = ParkedControllers()
        self._fault: Failure | None = None
        self._held: Failure | None = None
        self._confirmed = Confirmed()
        self._is_warm = False
        self._is_refined = True
        self.progress: tuple[int, int] | None = None
        self.took_s = 0.0
        if self._can_copy:
            self._park()

    @property
    def tick(self) -> int:
        """The tick at which the live controller is."""
        return self._live.tick

    @property
    def live(self) -> RemoteEngine:
        """The live controller; raises ``Failure`` (901901) if it is not as it was."""
        if self._fault is not None:
            raise self._fault
        return self._live

    # --- forward --------------------------------------------------------------------------------

    def run(
        self, end: int, stops: Sequence[StopAt] = (), *, events: bool = True, rests: bool = False
    ) -> StepResult:
        """Run the live controller as ``Engine.run``.

        Ticks run before must be as they were; raises ``Failure`` (901901) if they are not.
        """
        live, branch, again = self.live, self.branch, None
        self.took_s = 0.0
        if self._has_past and self.tick < branch.latest:
            again = self._run_again(min(end, branch.latest), stops, events=events)
            is_there = again.hits or again.run_state is not None or again.tick >= end
            if is_there or again.tick < branch.latest:
                return again
        done = live.run(
            end, stops, events=events, marks=None if self._has_past else (), rests=rests
        )
        self.took_s += live.took_s
        branch.record.add(done.marks, done.rows, done.columns)
        done = replace(done, marks=(), rows=b"", columns=((), b""))
        if done.tick > branch.latest:
            if not self._has_past:
                own = (PLC, SCHEDULE)
                self._plc[branch.number] += [one for one in done.inputs if one.source in own]
            elif self._setup.plcs:
                news = [one for one in done.inputs if one.tick > branch.latest]
                self._plc[branch.number] += [one for one in news if one.source == PLC]
            branch.latest = done.tick
        if self._can_copy and self._is_far_from_parked():
            self._park()
        return done if again is None else joined(again, done)

    def _run_again(self, end: int, stops: Sequence[StopAt], *, events: bool) -> StepResult:
        """Let the live controller rerun ticks that it has run before."""
        marks = self.branch.marks_between(self.tick, end)
        self._confirmed.enter(self.branch.number)
        asked = _asked(marks, self._confirmed.between(self.tick, end, NEAR_TICKS))
        try:
            done = self._live.run(end, stops, events=events, marks=asked)
            self.took_s = self._live.took_s
            done = self._compared(self.branch, done, marks, asked)
            self._confirm(self._live, self.branch)
        except Failure as failure:
            self._fault = failure
            raise
        return done

    def _is_far_from_parked(self) -> bool:
        nearest = self._parked.nearest(self.branch, self.tick)
        before_us = 0.0 if nearest is None else nearest.work_us
        return self.branch.work_at(self.tick) - before_us > SPARSE_US

    def _park(self, engine: RemoteEngine | None = None) -> None:
        """Park a copy of the live controller, or one brought to a tick."""
        tick = self.tick if engine is None else engine.tick
        nearest = self._parked.nearest(self.branch, tick)
        if nearest is not None and nearest.tick == tick:
            if engine is not None:
                engine.close()
            return
        try:
            parked = self._live.copy() if engine is None else engine
        except Failure as failure:
            if failure.diagnostics[0].id == PLC_HOLDS_OPEN.id:
                self._held, self._can_copy = failure, False
                return
            raise
        self._parked.add(Parked(self.branch, tick, self.branch.work_at(tick), parked))
        self._parked.thin_out(self.branch.work_at(self.tick))

    # --- rerun ticks ----------------------------------------------------------------------------

    def _compared(
        self, branch: Branch, done: StepResult, marks: Sequence[PastMark], asked: Sequence[int] = ()
    ) -> StepResult:
        """Return the results of rerun ticks; raises ``Failure`` (901901).

        ``asked``: where the slice has marks, by default at ``marks`` alone. If a PLC has acted
        differently from before, the slice says so. If a program has changed, commands that it has
        decoded may not have been executed yet: raises ``Failure`` (901900).
        """
        check_programs(done.diagnostics)
        ends = ticks_of(marks)
        found = list(zip(asked or ends, done.marks, strict=False))
        differs = first_difference([mark for tick, mark in found if tick in ends], marks)
        if differs is None and not self._setup.plcs:
            near = (mark for tick, mark in found if tick == mark.tick)
            differs = self._confirmed.compare(branch.number, near)
        done = replace(done, marks=(), rows=b"")
        if differs is None or done.differs is not None:
            return done
        if self._setup.plcs:
            return replace(done, differs=differs)
        raise past_differs(differs)

    def _confirm(self, engine: RemoteEngine, branch: Branch) -> None:
        """Let a copy run on to the next mark, to prove that the state shown here is as it was."""
        tick = engine.tick
        following = branch.mark_after(tick)
        if following is None or not self._can_copy or self._setup.plcs:
            return
        if self._confirmed.is_proved(tick):
            return
        if following.end > tick:
            asked = _asked([following], _likely_steps(branch, tick, following.tick))
            scout = engine.copy()
            try:
                done = scout.run(following.end, events=False, marks=asked, since=tick)
            finally:
                scout.close()
            self._compared(branch, done, [following], asked)
        self._confirmed.prove()

    def _rerun(
        self,
        engine: RemoteEngine,
        branch: Branch,
        end: int,
        *,
        first: int | None = None,
        since: int | None = None,
        near: Sequence[int] = (),
    ) -> StepResult:
        """Run a controller over ticks of the past, up to ``end``; ``first``: where it began.

        Returns the results of the ticks from ``since`` on, by default none. ``near``: ticks to
        which somebody may go next.
        """
        begin = engine.tick if first is None else first
        forgotten: int | None = end if since is None else max(since, engine.tick)
        done: StepResult | None = None
        while done is None or (engine.tick < end and done.run_state is None):
            if engine.tick < end:
                self._report(engine.tick - begin, end - begin)
            part, marks = next_part(branch, engine.tick, end)
            asked = _asked(marks, [one for one in near if engine.tick < one <= part])
            again = engine.run(part, events=part == end, marks=asked, since=forgotten)
            again = self._compared(branch, again, marks, asked)
            done, forgotten = again if done is None else joined(done, again), None
        return done

    def _report(self, done: int, whole: int) -> None:
        self.progress = done, whole
        self._poll()

    # --- inputs ---------------------------------------------------------------------------------

    def post(self, inputs: Sequence[Input]) -> bool:
        """Add inputs for the next tick or a later one; return whether a branch has begun.

        Raises ``Failure`` for a wrong name or value, and nothing has happened.
        """
        arriving = [one._replace(tick=max(one.tick, self.tick)) for one in inputs]
        self.live.post(arriving)
        return self._keep(arriving)

    def post_each(self, groups: Sequence[Sequence[Input]]) -> tuple[bool, list[Failure | None]]:
        """Post groups of inputs for the next tick, of which some may be refused.

        Returns whether a branch has begun, and for each group why it was refused, or ``None``.
        """
        answers = self.live.ask("post_each", groups)
        kept = [
            one
            for group, answer in zip(groups, answers, strict=True)
            if answer is None
            for one in group
        ]
        begins = self._keep(kept) if kept else False
        return begins, [None if answer is None else Failure(*answer) for answer in answers]

    def _keep(self, arriving: Sequence[Input]) -> bool:
        """Note inputs that the live controller has; return whether a branch has begun."""
        branch = self.branch
        begins = self.tick < branch.latest
        if begins:
            later = [one for one in branch.all_inputs() if one.tick >= self.tick]
            planned = [one for one in later if one.source == "stimuli"]
            record = BranchRecord(branch.work_at(self.tick))
            self.branch = Branch(len(self.branches) + 1, branch, self.tick, [], self.tick, record)
            self.branches.append(self.branch)
            self._plc[self.branch.number] = []
            self.branch.inputs = planned
        _insert(self.branch.inputs, arriving)
        if begins:
            self.live.plan(self.branch.inputs)
        return begins

    # --- anywhere -------------------------------------------------------------------------------

    def go_to(self, tick: int, branch: int | None = None) -> StepResult:
        """Bring the live controller to just before a tick of a branch, by default of this one.

        Returns what its last ticks have done. If it raises ``Failure`` (901154, 901157, 901901), it
        does not move.
        """
        target = self.reached(tick, branch)
        if target is self.branch and tick == self.tick and self._fault is None:
            return self._live.run(tick)
        is_front = self._can_copy and self.tick == self.branch.latest and self._fault is None
        if is_front and self._setup.plcs:
            with contextlib.suppress(Failure):  # a controller that is gone is abandoned
                self._park()  # whatever holds a file open shows now
        before_us, copies = self.branch.work_at(self.tick), self._pool.copies
        self._confirmed.enter(target.number)
        engine = self._controller_before(target, tick)
        begin_us = target.work_at(engine.tick)
        try:
            done = self._approach(engine, target, tick)
            self._confirm(engine, target)
        except BaseException:
            if engine is not self._live:
                engine.close()
            self._parked.give_up_candidate()
            raise
        finally:
            self.progress = None
        if engine is not self._live:
            self._leave(is_front=is_front)
        present_us = target.work_at(tick)
        self._parked.keep_candidate(present_us)
        self._live, self.branch, self._fault = engine, target, None
        self._is_refined = abs(present_us - before_us) < SPARSE_US
        if self._is_refined:
            spent_us = present_us - begin_us + COPY_US * (self._pool.copies - copies)
            self._refine_step(spent_us)
        return done

    def _leave(self, *, is_front: bool) -> None:
        """Give up the live controller; at the front it is parked, so that the way back is short."""
        if is_front:
            self._park(self._live)
        else:
            self._live.close()

    def reached(self, tick: int, branch: int | None = None) -> Branch:
        """Return a branch, by default this one; raises ``Failure`` (901154, 901157).

        It must have reached this tick.
        """
        target = self.branch if branch is None else self._branch(branch)
        if not 0 <= tick <= target.latest:
            raise Failure(diagnostic(TICK_NOT_REACHED, tick=tick, latest=target.latest))
        return target

    def _branch(self, number: int) -> Branch:
        if not 0 < number <= len(self.branches):
            raise Failure(diagnostic(NO_SUCH_BRANCH, branch=number, count=len(self.branches)))
        return self.branches[number - 1]

    def _controller_before(self, target: Branch, tick: int) -> RemoteEngine:
        """Return a controller before a tick of a branch, as near to it as possible."""
        self._refuse_without_past()
        nearest = self._parked.nearest(target, tick)
        if target is self.branch and self._fault is None and self.tick <= tick:
            if nearest is None or nearest.tick <= self.tick:
                return self._live.copy() if self._can_copy else self._live
        return self._woken(target, nearest)

    def _woken(self, target: Branch, parked: Parked | None) -> RemoteEngine:
        """Return a copy of a parked controller with the inputs of a branch, else a new one."""
        engine = self._pool.open(self._setup)[0] if parked is None else parked.engine.copy()
        if parked is not None and parked.tick == 0 and not self._is_warm:
            parked.engine.order("warm_up")  # while the first copy runs
            self._is_warm = True
        engine.plan(self._planned(target, engine.tick))
        return engine

    def _refuse_without_past(self) -> None:
        if self._held is not None:
            raise self._held
        if not self._has_past:
            raise Failure(diagnostic(REAL_SCHEDULE_HAS_NO_PAST))

    def _planned(self, branch: Branch, tick: int) -> list[Input]:
        """Return the inputs of a branch from a tick on, with those that its PLC gave."""
        planned = branch.inputs_from(tick)
        given: list[Input] = []
        part: Branch | None = branch
        last = branch.latest
        while part is not None and last > tick:
            own = self._plc[part.number]
            given = own[index_of(own, tick + 1) : index_of(own, last + 1)] + given
            last, part = part.first_tick, part.parent
        return planned + given

    def _approach(self, engine: RemoteEngine, branch: Branch, tick: int) -> StepResult:
        """Run a controller up to a tick; park on the way if that is expensive."""
        first = engine.tick
        ways = (SPARSE_US,) if self._refines else ()  # nearer ones are parked later
        for work_us in approach(branch.work_at(first), branch.work_at(tick), *ways):
            mark = branch.mark_before_work(work_us)
            if self._can_copy and mark is not None and engine.tick < mark.tick < tick:
                self._rerun(engine, branch, mark.tick, first=first)
                self._parked.add(Parked(branch, mark.tick, mark.work_us, engine.copy()))
        near = self._near(branch, engine.tick, tick)
        work_us = branch.work_at(near[0]) if near else 0.0
        is_far = work_us - branch.work_at(engine.tick) > COPY_US
        if is_far and engine.tick < near[0] < tick:
            self._rerun(engine, branch, near[0], first=first, near=near)
            self._parked.candidate = Parked(branch, near[0], work_us, engine.copy())
        since = tick - ARRIVAL_TICKS
        done = self._rerun(engine, branch, tick, first=first, since=since, near=near)
        self._parked.thin_out(branch.work_at(tick))
        return done

    @property
    def _refines(self) -> bool:
        """Whether controllers are parked, and ticks known, for those who go back step by step."""
        return self._can_copy and not self._setup.plcs

    def _near(self, branch: Branch, first: int, tick: int) -> list[int]:
        """Return ``tick`` and those after ``first`` to which somebody goes back from there."""
        if not self._refines:
            return []
        if tick in self._confirmed:
            return [tick]
        mark = branch.mark_before_work(branch.work_at(tick) - DENSE_US)
        first = max(first, 0 if mark is None else mark.tick)
        blocks = branch.ticks_between(BLOCKS, first, tick - 1)[-NEAR_TICKS:]
        steps = range(max(first + 1, tick - NEAR_TICKS), tick + 1)
        return sorted({*(one + 1 for one in blocks), *steps})

    def refine(self) -> bool:
        """Park at one place before here, for steps back by somebody who has come from afar.

        Return whether there may be others. It takes as long as a short travel: nobody should wait.
        """
        if not self._is_refined:
            self._is_refined = self._refined(math.inf, FAR_US) is None
        return not self._is_refined

    def _refine_step(self, spent_us: float) -> None:
        """Do the same at once, where somebody goes step by step: ``REFINED_US`` with the step."""
        while spent_us < REFINED_US:
            work_us = self._refined(REFINED_US - spent_us)
            if work_us is None:
                return
            spent_us += work_us

    def _refined(self, limit_us: float, reach_us: float = math.inf) -> float | None:
        """Park where it is far to the next parked controller, at most ``reach_us`` before here.

        Return the work, about ``limit_us`` at most; ``None``: it is far nowhere.
        """
        if not self._refines or self._fault is not None:
            return None
        present_us = self.branch.work_at(self.tick)
        parked = self._parked.before(self.branch, self.tick)
        gap = first_gap([one.work_us for one in parked], present_us)
        if gap is None or present_us - gap[1] > reach_us:
            return None
        older, mark = parked[gap[0]], self.branch.mark_before_work(gap[1])
        if mark is None or mark.tick <= older.tick:
            return None
        try:
            return self._fill(older, mark, limit_us)
        except Failure:
            return None  # going there reports the reason; here it is not needed

    def _fill(self, older: Parked, mark: PastMark, limit_us: float) -> float:
        """Bring a copy of a parked controller to a mark, or some work nearer; return the work."""
        branch = self.branch
        filler = self._parked.filler
        if (
            filler is None
            or filler.branch is not branch
            or not older.tick <= filler.tick < mark.tick
        ):
            self._parked.give_up_filler()
            filler = Parked(branch, older.tick, older.work_us, self._woken(branch, older))
        self._parked.filler = None
        end = branch.mark_before_work(filler.work_us + limit_us)
        last = mark if end is None or end.tick > mark.tick else end
        engine = filler.engine
        try:
            self._rerun(engine, branch, last.tick)
        except BaseException:
            engine.close()
            raise
        finally:
            self.progress = None
        moved = Parked(branch, engine.tick, last.work_us, engine)
        if engine.tick >= mark.tick:
            self._parked.add(moved)
            self._parked.thin_out(branch.work_at(self.tick))
        else:
            self._parked.filler = moved
        return max(last.work_us - filler.work_us, DENSE_US)

    # --- looking --------------------------------------------------------------------------------

    def trial(self, tick: int, branch: Branch | None = None) -> RemoteEngine:
        """Return a controller before a tick of a branch that never joins the session.

        Close it after use; ``confirm`` its state. Raises ``Failure`` (901154, 901901).
        """
        target = self.branch if branch is None else branch
        if not 0 <= tick <= target.latest:
            raise Failure(diagnostic(TICK_NOT_REACHED, tick=tick, latest=target.latest))
        if self._can_copy and target is self.branch and self.tick == tick:
            return self.live.copy()
        self._refuse_without_past()
        engine = self._woken(target, self._parked.nearest(target, tick))
        try:
            self._rerun(engine, target, tick)
        except BaseException:
            engine.close()
            raise
        finally:
            self.progress = None
        return engine

    def inside(self) -> RemoteEngine:
        """Return a controller before the last tick that this one has run, kept for the next call.

        Close it after use. Raises ``Failure`` as ``trial``.
        """
        engine = self.trial(self.tick - 1)
        if self._can_copy:
            self._parked.add(
                Parked(self.branch, engine.tick, self.branch.work_at(engine.tick), engine.copy())
            )
            self._parked.thin_out(self.branch.work_at(self.tick))
        return engine

    def ahead(self) -> RemoteEngine | None:
        """Return a controller at the end of this branch to run ahead, in whichever thread.

        ``None`` if the future depends on somebody outside who cannot be copied: a PLC in Python or
        a model that may reach beyond this process, a schedule on the real clock.
        """
        is_outside = not all(map(is_structured, self._setup.plcs))
        if not self._can_copy or is_outside or self._setup.options.get("fmu") is not None:
            return None
        engine = self.trial(self.branch.latest)
        engine.is_apart = True
        return engine

    def fork(self, one: int, other: int) -> int:
        """Return the tick before which two branches are the same; raises ``Failure`` (901157)."""
        return fork_of(self._branch(one), self._branch(other))

    def compare(self, one: int, other: int, signals: Sequence[str], poll: Poll) -> BranchDifference:
        """Return where two branches differ first; raises ``Failure`` (901157)."""
        branches = self._branch(one), self._branch(other)
        fork = fork_of(*branches)
        engines: list[RemoteEngine] = []
        try:
            for branch in branches:
                engines.append(self.trial(fork, branch))
            end = min(branch.latest for branch in branches)
            return differing((engines[0], engines[1]), end, signals, poll)
        finally:
            for engine in engines:
                engine.close()
            self.progress = None

    def happened(self, first: int, end: int) -> StepResult:
        """Return the results of this branch's ticks from ``first`` up to ``end``."""
        engine = self.trial(first)
        try:
            done = self._rerun(engine, self.branch, end, since=first)
            self.confirm(engine, end)
        finally:
            engine.close()
            self.progress = None
        return done

    def confirm(self, engine: RemoteEngine, tick: int) -> None:
        """Let a trial, which has come to a tick, run on to the next mark.

        Raises ``Failure`` (901901) if it is not as it was there.
        """
        following = self.branch.mark_after(tick)
        if following is not None and self._has_past:
            asked = ticks_of([following])
            done = engine.run(following.end, events=False, marks=asked, since=engine.tick)
            self._compared(self.branch, done, [following], asked)

    def previous(
        self, stops: Sequence[StopAt], answers: Sequence[Evidence] | None = None
    ) -> int | None:
        """Return the last tick before the present at which one of the stops held, or ``None``.

        ``answers``: the live controller's evidence about each of them, if it has been asked. The
        record shows where there were events and writes. For other stops the past is rerun, from the
        latest parked controller to the earliest: if they depend on a recorded signal, only up to
        the ticks in which they can have held.
        """
        end, found = self.tick - 1, 0
        if end <= 0:
            return None
        self._refuse_without_past()
        self._poll()
        others: list[tuple[StopAt, int, Necessary | None]] = []
        evidence = self.live.ask("evidence", stops) if answers is None else answers
        for stop, (requested, needed) in zip(stops, evidence, strict=True):
            if requested is None:
                others.append((replace(stop, count=_NEVER), end, needed))
            for one in requested or ():
                found = max(found, self.branch.last_event(one, end) + 1)
                if one.kinds & WRITE_KINDS and self.branch.writes_from:
                    known = replace(stop, count=_NEVER), min(end, self.branch.writes_from), None
                    others.append(known)
        if others:
            found = self._searched(others, found, end)
        return found or None

    def _possible_end(self, stops: Sequence[tuple[StopAt, int, Necessary | None]], end: int) -> int:
        """Return the last tick before ``end`` in which one of some stops can have held."""
        ends = [(min(end, last), needed) for _, last, needed in stops]
        return max(
            last if needed is None else self.branch.possible_end(needed, last)
            for last, needed in ends
        )

    def _searched(
        self, others: Sequence[tuple[StopAt, int, Necessary | None]], found: int, end: int
    ) -> int:
        """Return the last tick up to ``end`` at which a stop held, ``found`` if that is later.

        ``others``: stops, each with the tick up to which to search and its necessary condition.
        """
        stops = [stop for stop, _, _ in others]
        end = self._possible_end(others, end)
        whole, stretch_us = end - found, SEARCHED_US / SEARCHED_GROWTH
        try:
            while end > found:
                before_us = SEARCHED_GROWTH * stretch_us
                engine, stretch_us = self.before(self.branch, end, before_us)
                try:
                    begin = engine.tick
                    hit = self._last_hit(engine, end, stops, whole - end + found, whole)
                finally:
                    engine.close()
                if hit:
                    return max(hit, found)
                end = self._possible_end(others, begin)
        finally:
            self.progress = None
        return found

    def before(self, branch: Branch, end: int, work_us: float) -> tuple[RemoteEngine, float]:
        """Return a controller before the ticks up to ``end`` that took some work, and their work.

        It is at a tick before ``end``, as near to it as there is one, and never joins the session.
        """
        self._refuse_without_past()
        parked = self._parked.before_by(branch, end - 1, work_us)
        stretch_us = branch.work_at(end) - (parked.work_us if parked else 0.0)
        return self._woken(branch, parked), stretch_us

    def plan_on(self, engine: RemoteEngine, branch: Branch) -> int:
        """Give a controller the present inputs of a branch; return up to where."""
        engine.plan(self._planned(branch, engine.tick))
        return branch.latest

    def _last_hit(
        self, engine: RemoteEngine, end: int, stops: Sequence[StopAt], before: int, whole: int
    ) -> int:
        """Run a controller up to a tick; return the last tick at which a stop held, or 0."""
        first, hit, has_plc = engine.tick, 0, bool(self._setup.plcs)
        marks: Sequence[PastMark] = ()
        while engine.tick < end:
            self._report(before + engine.tick - first, whole)
            part, marks = next_part(self.branch, engine.tick, end)
            tick = engine.tick
            hit, _, found = engine.last_hit(part, stops, ticks_of(marks))
            differs = first_difference(found, marks)
            if differs is not None and not has_plc:
                raise past_differs(differs)
            if engine.tick == tick:
                break  # the run is over
        if not marks or marks[-1].tick != end:
            self.confirm(engine, end)
        return hit

    @property
    def setup(self) -> Setup:
        """The setup of the session."""
        return self._setup

    def tape(self, branch: Branch | None = None) -> list[Input]:
        """Return the inputs of a branch, by default of this one, in the order of their ticks.

        Those of the PLC are among them.
        """
        return sorted(self._planned(branch or self.branch, -1), key=lambda one: one.tick)

    def news(self, first: int) -> tuple[int, int, list[Input]]:
        """Return branch, latest tick, and the inputs before it from tick ``first`` on."""
        end = self.branch.latest
        found = sorted(self._planned(self.branch, first - 1), key=lambda one: one.tick)
        kept = found[index_of(found, first) : index_of(found, end)]
        return self.branch.number, end, kept

    def restart_schedule(self) -> None:
        """Restart a real schedule after a pause."""
        if self._setup.rtconf is not None:
            self.live.ask("schedule", RESTART)

    def schedule_table(self, language: Language) -> str:
        """Return the table of a real schedule; empty without one."""
        return cast("str | None", self.live.ask("schedule", TABLE, language)) or ""

    # --- the end --------------------------------------------------------------------------------

    def abandon(self) -> None:
        """Kill a controller that does not answer; callable from any thread."""
        self._pool.abandon()

    def close(self) -> None:
        """Let all controllers end."""
        self._parked.close()
        for branch in self.branches:
            branch.record.close()
        if self._setup.rtconf is not None:
            with contextlib.suppress(Failure, RuntimeError):
                self._live.ask("schedule", CLOSE)
        self._live.close()
        self._pool.close()


def _asked(marks: Sequence[PastMark], near: Sequence[int]) -> list[int]:
    """Return how far a run must go for some marks, and for other ticks on its way."""
    return sorted({*ticks_of(marks), *near})


def _likely_steps(branch: Branch, tick: int, end: int) -> list[int]:
    """Return the ticks before ``end`` to which somebody is likely to step from a tick."""
    blocks = branch.ticks_between(BLOCKS, tick - 1, end - 1)[:NEAR_TICKS]
    return [*(one + 1 for one in blocks), *range(tick + 1, min(tick + 1 + NEAR_TICKS, end))]


def next_part(branch: Branch, tick: int, end: int) -> tuple[int, list[PastMark]]:
    """Return how far a controller reruns in one go, and the marks on the way."""
    marks = branch.marks_between(tick, end)[:PART_MARKS]
    part = min(end, tick + PART_TICKS, *(mark.tick for mark in marks[PART_MARKS - 1 :]))
    return part, [mark for mark in marks if mark.tick <= part]


def _insert(inputs: list[Input], arriving: Sequence[Input]) -> None:
    """Insert inputs into an ordered list, nearly always at its end."""
    first = min(map(in_order, arriving), default=None)
    if first is not None:
        at = bisect.bisect_right(inputs, first, key=in_order)
        inputs[at:] = sorted([*inputs[at:], *arriving], key=in_order)
