# SPDX-License-Identifier: MIT
"""The past of a session: branches of its tape, parked controllers, the way to any moment.

In: runs forward, inputs, wishes to be elsewhere. Out: the live controller, at the moment that was
asked for. The past is not stored but run again: from the nearest parked controller over the tape.
An input in the past begins another branch; the old one stays.
"""

from __future__ import annotations

import bisect
import contextlib
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import cast

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Language
from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.real_schedule import REAL_SCHEDULE_HAS_NO_PAST
from nctakt.messages.session import NO_SUCH_BRANCH, TICK_NOT_REACHED
from nctakt.run.inputs import PLC, SCHEDULE, Input, in_order
from nctakt.session.engine import Slice, joined
from nctakt.session.parking import SPARSE_US, Cost, approach, surplus
from nctakt.session.schedules import CLOSE, RESTART, TABLE
from nctakt.session.setup import Setup
from nctakt.session.stops import StopAt
from nctakt.session.workshop import RemoteEngine, Workshop

#: Ticks that are run again at a time while a stop is looked for backward.
_SEARCHED_TICKS = 4096

#: Ticks between two calls of ``poll`` while the past is run again.
PART_TICKS = 10_000

Poll = Callable[[], None]


@dataclass(slots=True)
class Branch:
    """One story of the inputs.

    It shares the inputs of its ``parent`` before ``first_tick``. ``inputs`` are its own, by tick
    and order; ``latest``: the furthest tick that it has reached.
    """

    number: int
    parent: Branch | None
    first_tick: int
    inputs: list[Input] = field(default_factory=list)
    latest: int = 0

    def all_inputs(self, before: int | None = None) -> list[Input]:
        """Return its inputs from the start on, up to but without tick ``before``."""
        inherited = [] if self.parent is None else self.parent.all_inputs(self.first_tick)
        own = self.inputs
        if before is not None:
            own = own[: bisect.bisect_left(own, before, key=lambda one: one.tick)]
            inherited = [one for one in inherited if one.tick < before]
        return inherited + own

    def inputs_from(self, tick: int) -> list[Input]:
        """Return its inputs from a tick on."""
        own = self.inputs[_index_of(self.inputs, tick) :]
        if self.parent is None or tick >= self.first_tick:
            return own
        inherited = self.parent.inputs_from(tick)
        return inherited[: _index_of(inherited, self.first_tick)] + own

    def shares(self, other: Branch, tick: int) -> bool:
        """Return whether a state of ``other`` before a tick is one of this branch's, too."""
        branch: Branch | None = self
        while branch is not None and branch is not other:
            if tick > branch.first_tick:
                return False
            branch = branch.parent
        return branch is other


@dataclass(frozen=True, slots=True)
class _Parked:
    branch: Branch
    tick: int
    blocks: int
    engine: RemoteEngine


class Timeline:
    """The moments of a session, and the live controller that stands in one of them.

    Raises ``Failure`` with the mistakes of the setup. ``branch``: the one that it is in. ``poll``
    is called while the past is run again, and may end that by an exception.
    """

    def __init__(self, setup: Setup, poll: Poll) -> None:
        self._setup = setup
        self._poll = poll
        self._workshop = Workshop()
        try:
            self.live, self.description = self._workshop.open(setup)
        except BaseException:
            self._workshop.close()
            raise
        # a controller with threads cannot be copied
        self._can_copy = self._workshop.can_copy and setup.rtconf is None
        self._cost = Cost()
        self.branch = Branch(1, None, 0, list(self.description.inputs))
        self.branches = [self.branch]
        self._plc: dict[int, list[Input]] = {1: []}
        self._parked: list[_Parked] = []
        self._blocks = 0
        if self._can_copy:
            self._park()

    @property
    def tick(self) -> int:
        """The tick at which the live controller stands."""
        return self.live.tick

    # --- forward --------------------------------------------------------------------------------

    def run(self, end: int, stops: Sequence[StopAt] = (), *, events: bool = True) -> Slice:
        """Run the live controller as ``Engine.run``."""
        done = self.live.run(end, stops, events=events)
        self._blocks = done.decoded
        branch = self.branch
        if done.tick > branch.latest:
            if self._setup.rtconf is not None:  # nothing is run again
                own = (PLC, SCHEDULE)
                self._plc[branch.number] += [one for one in done.inputs if one.source in own]
            elif self._setup.plc is not None:
                news = [one for one in done.inputs if one.tick > branch.latest]
                self._plc[branch.number] += [one for one in news if one.source == PLC]
            branch.latest = done.tick
        if self._can_copy and self._is_far_from_parked():
            self._park()
        return done

    def _is_far_from_parked(self) -> bool:
        present = self._cost.of(self.tick, self._blocks)
        last = max((self._cost.of(one.tick, one.blocks) for one in self._near()), default=0.0)
        return present - last > SPARSE_US

    def _near(self) -> list[_Parked]:
        """Return the parked controllers of this branch at or before the present, by tick."""
        return [
            one
            for one in self._parked
            if one.tick <= self.tick and self.branch.shares(one.branch, one.tick)
        ]

    def _park(self) -> None:
        """Park a copy of the live controller; give up those that stand too dense."""
        if any(one.tick == self.tick for one in self._near()):
            return
        self._parked.append(_Parked(self.branch, self.tick, self._blocks, self.live.copy()))
        self._parked.sort(key=lambda one: (one.tick, one.branch.number))
        present = self._cost.of(self.tick, self._blocks)
        works = [min(self._cost.of(one.tick, one.blocks), present) for one in self._parked]
        for index in reversed(surplus(works, present)):
            self._parked.pop(index).engine.close()

    # --- inputs ---------------------------------------------------------------------------------

    def post(self, inputs: Sequence[Input]) -> bool:
        """Let inputs reach the next tick, or a later one; return whether a branch has begun.

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
            self.branch = Branch(len(self.branches) + 1, branch, self.tick, [], self.tick)
            self.branches.append(self.branch)
            self._plc[self.branch.number] = []
            self.branch.inputs = planned
        _insert(self.branch.inputs, arriving)
        if begins:
            self.live.plan(self.branch.inputs)
        return begins

    # --- anywhere -------------------------------------------------------------------------------

    def go_to(self, tick: int, branch: int | None = None) -> Slice:
        """Make the live controller stand before a tick of a branch, by default of this one.

        Returns what its last ticks have done. Raises ``Failure`` (901154, 901157).
        """
        target = self.branch if branch is None else self._branch(branch)
        if not 0 <= tick <= target.latest:
            raise Failure(diagnostic(TICK_NOT_REACHED, tick=tick, latest=target.latest))
        if target is self.branch and tick == self.tick:
            return self.live.run(tick)
        is_forward = target is self.branch and tick > self.tick
        if self._can_copy and self.tick == self.branch.latest:
            with contextlib.suppress(Failure):  # one that is gone is left behind
                self._park()  # so that the way back to the front is short
        nearest = self._nearest(target, tick)
        if not is_forward or (nearest is not None and nearest.tick > self.tick):
            self._wake(target, nearest)
        self.branch = target
        return self._approach(tick)

    def _branch(self, number: int) -> Branch:
        if not 0 < number <= len(self.branches):
            raise Failure(diagnostic(NO_SUCH_BRANCH, branch=number, count=len(self.branches)))
        return self.branches[number - 1]

    def _nearest(self, branch: Branch, tick: int) -> _Parked | None:
        """Return the last parked controller of a branch at or before a tick."""
        usable = [
            one for one in self._parked if one.tick <= tick and branch.shares(one.branch, one.tick)
        ]
        return max(usable, key=lambda one: one.tick, default=None)

    def _wake(self, branch: Branch, nearest: _Parked | None) -> None:
        """Let a copy of a parked controller be the live one, with the inputs of a branch."""
        self._refuse_on_real_schedule()
        if nearest is None:
            fresh, _ = self._workshop.open(self._setup)
            blocks = 0
        else:
            fresh, blocks = nearest.engine.copy(), nearest.blocks
        self.live.close()
        self.live, self._blocks = fresh, blocks
        fresh.plan(self._planned(branch, fresh.tick))

    def _refuse_on_real_schedule(self) -> None:
        if self._setup.rtconf is not None:
            raise Failure(diagnostic(REAL_SCHEDULE_HAS_NO_PAST))

    def _planned(self, branch: Branch, tick: int) -> list[Input]:
        """Return the inputs of a branch from a tick on, with those that its PLC gave."""
        planned = branch.inputs_from(tick)
        given: list[Input] = []
        story: Branch | None = branch
        last = branch.latest
        while story is not None and last > tick:
            own = self._plc[story.number]
            given = own[_index_of(own, tick + 1) : _index_of(own, last + 1)] + given
            last, story = story.first_tick, story.parent
        return planned + given

    def _approach(self, tick: int) -> Slice:
        """Run the live controller up to a tick; park on the way where that is dear."""
        first = self.tick
        if self._can_copy:
            per_tick = self._cost.of(1, 0) + self._cost.of(0, self._blocks) / max(first, 1)
            halves = approach(per_tick * first, per_tick * tick)
            for work in halves:
                between = int(work / per_tick)
                if first < between < tick:
                    self._blocks = run_in_parts(self.live, between, self._poll).decoded
                    self._park()
        done = run_in_parts(self.live, tick, self._poll)
        self._blocks = done.decoded
        return done

    # --- looking --------------------------------------------------------------------------------

    def trial(self, tick: int) -> RemoteEngine:
        """Return a controller before a tick of this branch that never joins the session.

        Close it after use. Raises ``Failure`` (901154).
        """
        target = self.branch
        if not 0 <= tick <= target.latest:
            raise Failure(diagnostic(TICK_NOT_REACHED, tick=tick, latest=target.latest))
        if self._can_copy and self.tick == tick:
            return self.live.copy()
        self._refuse_on_real_schedule()
        nearest = self._nearest(target, tick)
        if nearest is None:
            engine, _ = self._workshop.open(self._setup)
        else:
            engine = nearest.engine.copy()
        try:
            engine.plan(self._planned(target, engine.tick))
            if engine.tick < tick:
                run_in_parts(engine, tick, self._poll)
        except BaseException:
            engine.close()
            raise
        return engine

    def happened(self, first: int, end: int) -> Slice:
        """Return what the ticks of this branch from ``first`` up to ``end`` have done."""
        engine = self.trial(first)
        try:
            engine.run(first)  # what is left of the ticks before
            return run_in_parts(engine, end, self._poll)
        finally:
            engine.close()

    def previous(self, stops: Sequence[StopAt]) -> int | None:
        """Return the last tick before the present at which one of the stops held, or ``None``.

        It runs the past again in stretches, from the latest to the earliest.
        """
        once = [replace(stop, count=1) for stop in stops]
        end, width = self.tick - 1, _SEARCHED_TICKS
        while end > 0:
            begin = max(0, end - width)
            nearest = self._nearest(self.branch, begin)
            if nearest is not None and end - nearest.tick < 4 * width:
                begin = nearest.tick
            engine = self.trial(begin)
            try:
                found = search_in_parts(engine, end, once, self._poll)
            finally:
                engine.close()
            if found:
                return found[-1]
            end, width = begin, 2 * width
        return None

    @property
    def setup(self) -> Setup:
        """What the session was opened with."""
        return self._setup

    def tape(self) -> list[Input]:
        """Return the inputs of this branch, the PLC's too, in the order of their ticks."""
        return sorted(self._planned(self.branch, -1), key=lambda one: one.tick)

    def news(self, first: int) -> tuple[int, int, list[Input]]:
        """Return branch, latest tick, and the inputs before it from tick ``first`` on."""
        end = self.branch.latest
        found = sorted(self._planned(self.branch, first - 1), key=lambda one: one.tick)
        kept = found[_index_of(found, first) : _index_of(found, end)]
        return self.branch.number, end, kept

    def restart_schedule(self) -> None:
        """Let a real schedule begin anew behind a pause."""
        if self._setup.rtconf is not None:
            self.live.ask("schedule", RESTART)

    def schedule_table(self, language: Language) -> str:
        """Return the table of a real schedule; empty without one."""
        return cast("str | None", self.live.ask("schedule", TABLE, language)) or ""

    # --- the end --------------------------------------------------------------------------------

    def abandon(self) -> None:
        """Kill a controller that does not answer; callable from any thread."""
        self._workshop.abandon()

    def close(self) -> None:
        """Let all controllers end."""
        for parked in self._parked:
            parked.engine.close()
        self._parked.clear()
        if self._setup.rtconf is not None:
            with contextlib.suppress(Failure, RuntimeError):
                self.live.ask("schedule", CLOSE)
        self.live.close()
        self._workshop.close()


def run_in_parts(engine: RemoteEngine, end: int, poll: Poll) -> Slice:
    """Run a controller to a tick; ``poll`` is called between two parts of the way."""
    done = engine.run(min(end, engine.tick + PART_TICKS))
    while done.tick < end and done.run_state is None:
        poll()
        done = joined(done, engine.run(min(end, done.tick + PART_TICKS)))
    return done


def search_in_parts(
    engine: RemoteEngine, end: int, stops: Sequence[StopAt], poll: Poll
) -> list[int]:
    """Return the ticks up to ``end`` behind which a stop has held; ``poll`` as above."""
    found: list[int] = []
    while engine.tick < end:
        poll()
        before = engine.tick
        found += engine.search(min(end, before + PART_TICKS), stops)
        if engine.tick == before:
            break  # the run is over
    return found


def _index_of(inputs: Sequence[Input], tick: int) -> int:
    """Return the index of the first input of a tick or a later one, of inputs in their order."""
    return bisect.bisect_left(inputs, tick, key=lambda one: one.tick)


def _insert(inputs: list[Input], arriving: Sequence[Input]) -> None:
    """Insert inputs into a list in its order, whose end they nearly always concern."""
    first = min(map(in_order, arriving), default=None)
    if first is not None:
        at = bisect.bisect_right(inputs, first, key=in_order)
        inputs[at:] = sorted([*inputs[at:], *arriving], key=in_order)
