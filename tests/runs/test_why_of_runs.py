# SPDX-License-Identifier: MIT
"""What must hold of the report of every run: the runs of this folder, asked why."""

from __future__ import annotations

import functools
from pathlib import Path

import pytest
from support.run_folders import FOLDERS, HERE, perform

from nctakt.results.explained.reasons import (
    truth_at,
    why_branch_idle,
    why_branch_never,
    why_cycle_idle,
    why_cycle_never,
)
from nctakt.results.explained.why import WhyReport
from nctakt.results.histories import BranchHistory, CycleHistory
from nctakt.results.run import Run
from nctakt.run.controller import Controller

pytestmark = pytest.mark.slow

#: Ticks of a run that are looked at, at most.
_TICKS = 400


@pytest.fixture
def asked(monkeypatch: pytest.MonkeyPatch) -> None:
    """Every run is asked why."""
    monkeypatch.setattr(Controller, "run", functools.partialmethod(Controller.run, why=True))


def ticks_of(report: WhyReport) -> list[int]:
    """Some ticks of the run, and all at which something began or ended."""
    last_tick = report.first_tick + report.ticks - 1
    chosen = set(range(report.first_tick, last_tick + 1, max(1, report.ticks // _TICKS)))
    for cycle in report.cycles:
        for times in (cycle.runs, *(branch.bodies for branch in cycle.branches)):
            for one in times.series[:20]:
                chosen |= {one.first_tick - 1, one.first_tick, one.last_tick, one.last_tick + 1}
    return sorted(tick for tick in chosen if report.first_tick <= tick <= last_tick)


def check_tick(cycle: CycleHistory, branch: BranchHistory, tick: int) -> None:
    """A body runs where its branch is reached, and only there; else there is a reason."""
    ran = branch.bodies.holds(tick)
    assert (why_branch_idle(cycle, branch, tick) is None) == ran
    if ran or branch.evaluated.holds(tick):
        assert cycle.runs.holds(tick)
        assert branch.outer is None or cycle.branches[branch.outer].bodies.holds(tick)
        assert not any(cycle.branches[one].bodies.holds(tick) for one in branch.earlier)
    if ran and branch.word != "$ELSE":
        assert truth_at(branch.condition, tick) or branch.frequency == "ALWAYS"


def check_firings(run: Run, report: WhyReport) -> None:
    """RC-203: every firing in the trace is a run-through of that body in that tick."""
    for event in run.events:
        if event.kind != "fired":
            continue
        assert event.span is not None
        place = (event.span.file, event.span.line, event.span.column)
        bodies = [
            branch.bodies
            for cycle in report.cycles
            if cycle.name == event.cycle
            for branch in cycle.branches
            if (branch.span.file, branch.span.line, branch.span.column) == place
        ]
        assert any(times.holds(event.tick) is not False for times in bodies)


@pytest.mark.usefixtures("asked")
@pytest.mark.parametrize("name", FOLDERS)
def test_each_branch_of_each_run_ran_or_has_a_reason(name: str, tmp_path: Path) -> None:
    """RC-204: in each tick a branch ran, or one thing is to blame; the same in the whole run."""
    run = perform(HERE / name, set(), tmp_path)
    report = run.why
    assert report is not None
    if not report.ticks:
        return
    last_tick = report.first_tick + report.ticks - 1
    check_firings(run, report)
    ticks = ticks_of(report)
    for cycle in report.cycles:
        assert (why_cycle_never(cycle, last_tick) is None) == bool(cycle.runs.ticks)
        for branch in cycle.branches:
            assert (why_branch_never(cycle, branch, last_tick) is None) == bool(branch.bodies.ticks)
        for tick in ticks:
            assert (why_cycle_idle(cycle, tick) is None) == cycle.runs.holds(tick)
            for branch in cycle.branches:
                check_tick(cycle, branch, tick)
    for language in ("en", "de"):
        assert report.render(language)
        assert all(report.render_at(tick, language) for tick in ticks[:50])
