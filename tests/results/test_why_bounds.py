# SPDX-License-Identifier: MIT
"""Memory of the report is bounded: what is kept, what is reported of the rest."""

from __future__ import annotations

import pytest
from support.why_runs import TOGGLE, why

from nctakt.results.branch_log import CHANGES_KEPT, SERIES_KEPT
from nctakt.results.explained.reasons import truth_at, why_branch_idle
from nctakt.results.histories import Reason
from nctakt.results.probe_log import CYCLES_KEPT


@pytest.mark.parametrize("over", [-1, 0, 1])
def test_the_newest_changes_are_kept(over: int) -> None:
    """One change a tick: at the bound nothing is left out, after it the oldest."""
    (cycle,) = why(TOGGLE, ticks=CHANGES_KEPT + over).cycles
    condition = cycle.branches[0].condition
    assert len(condition.changes) == min(CHANGES_KEPT, CHANGES_KEPT + over)
    assert condition.changes_left_out == max(0, over)
    assert condition.changes[0].tick == max(0, over)
    assert truth_at(condition, 0) is (None if over > 0 else True)


@pytest.mark.parametrize("over", [-1, 0, 1])
def test_the_newest_series_are_kept(over: int) -> None:
    """The body runs in every other tick; all ticks are counted; a dropped one is not known."""
    count = SERIES_KEPT + over
    (cycle,) = why(TOGGLE, ticks=2 * count - 1).cycles
    branch = cycle.branches[0]
    assert branch.bodies.ticks == count
    assert branch.bodies.left_out == max(0, over)
    assert len(branch.bodies.series) == min(SERIES_KEPT, count)
    idle = why_branch_idle(cycle, branch, 0)
    assert idle == (Reason("forgotten") if over > 0 else None)


@pytest.mark.parametrize("over", [-1, 0, 1])
def test_the_newest_cycles_are_kept(over: int) -> None:
    """A loop that defines cycles without end: the oldest ended one makes room."""
    count = CYCLES_KEPT + over
    text = f"$FOR P1 = 1, {count}, 1\n#RT CYCLE [SCOPE = BLOCK]\n$IF V.E.VALUE\n$ENDIF\n"
    report = why(f"{text}#RT CYCLE END\n#TIME 0.001\n$ENDFOR\nM30\n")
    assert report.left_out == max(0, over)
    assert len(report.cycles) == min(CYCLES_KEPT, count)
    assert report.cycles[-1].name == f"#{count}"
    assert all(cycle.runs.ticks == 1 for cycle in report.cycles)
