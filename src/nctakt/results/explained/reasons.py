# SPDX-License-Identifier: MIT
"""The reasons why a branch or a realtime cycle did not run, in one tick or in a whole run.

In: histories. Out: ``Reason``: a state of the cycle, another branch, the condition itself
(RC-105 … RC-111, RC-201 … RC-204, RC-505).
"""

from __future__ import annotations

from nctakt.results.histories import (
    BranchHistory,
    Change,
    ConditionHistory,
    CycleHistory,
    LifeEvent,
    Reason,
)

_FORGOTTEN = Reason("forgotten")


# --- in one tick ---------------------------------------------------------------------------------


def why_cycle_idle(cycle: CycleHistory, tick: int) -> Reason | None:
    """Return why the cycle did not run in ``tick``; ``None`` if it did."""
    ran = cycle.runs.holds(tick)
    if ran:
        return None
    if not cycle.life or (tick < cycle.life[0].tick and not cycle.life_left_out):
        return Reason("undefined", cycle.life[0].tick if cycle.life else None)
    if ran is None or tick < cycle.life[0].tick:
        return _FORGOTTEN
    last = [event for event in cycle.life if event.tick <= tick][-1]
    match last.kind:
        case "created":
            return Reason("unstarted", last.tick)
        case "held":
            return Reason("held", last.tick, last.span)
        case "ended":
            return _ended(last)
    for stop in cycle.stops:
        if stop.tick == tick:
            return Reason("stopped", tick, stop.span, number=stop.number)
    if cycle.scope == "BLOCK":
        return Reason("waiting", last.tick)
    return Reason("reset", tick)


def _ended(event: LifeEvent) -> Reason:
    return Reason("ended", event.tick, event.span, ended_by=event.ended_by, number=event.number)


def last_change(condition: ConditionHistory, tick: int) -> Change | None:
    """Return the condition's last change of truth up to ``tick``."""
    before = [change for change in condition.changes if change.tick <= tick]
    return before[-1] if before else None


def truth_at(condition: ConditionHistory, tick: int) -> bool | None:
    """Return the truth of the condition after ``tick``; ``None`` if it has none or is unknown."""
    change = last_change(condition, tick)
    if change is not None:
        return change.truth
    return None if condition.changes_left_out else condition.was_true


def why_branch_idle(cycle: CycleHistory, branch: BranchHistory, tick: int) -> Reason | None:
    """Return why the branch's body did not run in ``tick``; ``None`` if it did."""
    ran = branch.bodies.holds(tick)
    if ran:
        return None
    idle = why_cycle_idle(cycle, tick)
    if idle is not None:
        return Reason("cycle", cycle=idle)
    if ran is None:
        return _FORGOTTEN
    if branch.evaluated.holds(tick):
        return _why_without_body(cycle, branch, tick)
    return _why_not_evaluated(cycle, branch, tick)


def _why_not_evaluated(cycle: CycleHistory, branch: BranchHistory, tick: int) -> Reason:
    """Return why the condition was not evaluated in a tick in which the cycle ran."""
    if branch.outer is not None:
        outer_ran = cycle.branches[branch.outer].bodies.holds(tick)
        if not outer_ran:
            return _FORGOTTEN if outer_ran is None else Reason("outer", branch=branch.outer)
    earlier_ran = {index: cycle.branches[index].bodies.holds(tick) for index in branch.earlier}
    for earlier, ran in earlier_ran.items():
        if ran:
            return Reason("earlier", branch=earlier)
    if None in (branch.evaluated.holds(tick), *earlier_ran.values()):
        return _FORGOTTEN
    if branch.frequency == "ONCE" and (done := _done_tick(branch, tick)) is not None:
        return Reason("done", done)
    return _without_evaluation(cycle, branch)


def _without_evaluation(cycle: CycleHistory, branch: BranchHistory) -> Reason:
    """Return why a condition in reach was not evaluated: an earlier fault, or a done ONCE."""
    fault = _stopped_by_fault(cycle)
    if fault is not None:
        return fault
    return Reason("done") if branch.frequency == "ONCE" else _FORGOTTEN


def _why_without_body(cycle: CycleHistory, branch: BranchHistory, tick: int) -> Reason:
    """Return why the body did not run although the condition was evaluated."""
    change = last_change(branch.condition, tick)
    truth = truth_at(branch.condition, tick)
    if truth is None:
        fault = None if branch.condition.changes_left_out else _stopped_by_fault(cycle)
        return fault or _FORGOTTEN
    if truth:
        return Reason("no rise", change.tick if change else None, change=change)
    return Reason("false", change.tick if change else None, change=change)


def _done_tick(branch: BranchHistory, tick: int) -> int | None:
    """Return the last tick before ``tick`` in which the body ran."""
    before = [series.last_tick for series in branch.bodies.series if series.last_tick < tick]
    return before[-1] if before else None


def _stopped_by_fault(cycle: CycleHistory) -> Reason | None:
    """Return the error that ended the cycle, ``None`` without one."""
    for event in cycle.life:
        if event.ended_by == "error":
            return Reason("fault", event.tick, event.span, number=event.number)
    return None


# --- in the whole run ----------------------------------------------------------------------------


def why_cycle_never(cycle: CycleHistory, last_tick: int) -> Reason | None:
    """Return why the cycle did not run at all; ``None`` if it did."""
    if cycle.runs.ticks:
        return None
    return why_cycle_idle(cycle, last_tick)


def why_branch_never(cycle: CycleHistory, branch: BranchHistory, last_tick: int) -> Reason | None:
    """Return why the branch's body did not run at all; ``None`` if it did."""
    if branch.bodies.ticks:
        return None
    idle = why_cycle_never(cycle, last_tick)
    if idle is not None:
        return Reason("cycle", cycle=idle)
    if branch.evaluated.ticks:
        return _why_never_true(cycle, branch)
    if branch.outer is not None and not cycle.branches[branch.outer].bodies.ticks:
        return Reason("outer", branch=branch.outer)
    ran = [earlier for earlier in branch.earlier if cycle.branches[earlier].bodies.ticks]
    if ran:
        return Reason("earlier", branch=ran[0])
    return _without_evaluation(cycle, branch)


def _why_never_true(cycle: CycleHistory, branch: BranchHistory) -> Reason:
    condition = branch.condition
    changes = condition.changes
    if condition.was_true or any(change.truth for change in changes):
        return Reason("no rise", changes[0].tick if changes else None)
    if changes or condition.was_true is False:
        return Reason("false", nearest=condition.nearest)
    return _stopped_by_fault(cycle) or _FORGOTTEN
