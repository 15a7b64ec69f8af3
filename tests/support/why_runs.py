# SPDX-License-Identifier: MIT
"""Runs programs on the demo machine for the tests of the report: 500 mm/s, 4000 mm/s², 1 ms."""

from __future__ import annotations

from nctakt.results.explained.reasons import why_branch_never
from nctakt.results.explained.why import WhyReport
from nctakt.results.histories import BranchHistory, CycleHistory, Reason, Times
from nctakt.run.controller import Controller, NcText

ONCE = """\
#RT CYCLE [ID = 17 SCOPE = PROG]
  $IF ONCE V.RTA.ACS.ACT_POS.X > 200
    M100
  $ENDIF
#RT CYCLE END
N20 G00 X300
M30
"""

EDGE = """\
#RT CYCLE [SCOPE = PROG]
  $IF EDGE V.RTA.ACS.ACT_POS.X > 200
    M100
  $ENDIF
#RT CYCLE END
G00 X300
G00 X0
G00 X300
M30
"""

NESTED = """\
#RT CYCLE [SCOPE = PROG]
  $IF V.E.CONDITION == 1
    $IF ALWAYS V.E.VALUE > 100
      V.E.COUNT += 1
    $ENDIF
  $ENDIF
#RT CYCLE END
#TIME 0.014
M30
"""

NESTED_AT = [
    (1, "V.E.VALUE", 0.0),
    (2, "V.E.CONDITION", 1.0),
    (4, "V.E.VALUE", 150.0),
    (6, "V.E.VALUE", 0.0),
    (8, "V.E.CONDITION", 0.0),
    (11, "V.E.CONDITION", 1.0),
]


#: The condition changes in each tick: true in even ticks, false in odd ones.
TOGGLE = """\
#RT CYCLE
  $IF V.E.COUNT == 0
    V.E.COUNT = 1
  $ELSE
    V.E.COUNT = 0
  $ENDIF
#RT CYCLE END
#TIME 100
M30
"""


def why(
    text: str,
    *,
    at: list[tuple[int, str, float]] | None = None,
    controller: Controller | None = None,
    set: dict[str, float] | None = None,
    ticks: int | None = None,
) -> WhyReport:
    """The report of a program; ``at`` are stimuli in ticks."""
    run = (controller or Controller()).run(
        NcText("part.nc", text),
        at=[(f"{tick} ticks", name, value) for tick, name, value in at or ()],
        set=set,
        ticks=ticks,
        memory_trace=False,
        why=True,
    )
    assert run.why is not None
    assert (run.why.first_tick, run.why.ticks) == (run.first_tick, run.ticks)
    return run.why


def series(times: Times) -> list[tuple[int, int]]:
    """First and last ticks."""
    return [(one.first_tick, one.last_tick) for one in times.series]


def changes(branch: BranchHistory) -> list[tuple[int, bool, float, float]]:
    """Tick, truth, left and right of each change of the condition."""
    found = branch.condition.changes
    return [(change.tick, change.truth, change.left, change.right) for change in found]


def never(report: WhyReport, cycle: CycleHistory, branch: int) -> Reason | None:
    """Why a branch never ran."""
    last_tick = report.first_tick + report.ticks - 1
    return why_branch_never(cycle, cycle.branches[branch], last_tick)
