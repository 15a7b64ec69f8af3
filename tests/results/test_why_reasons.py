# SPDX-License-Identifier: MIT
"""Why a branch or a cycle did not run: each kind of reason, in a run and in a tick."""

from __future__ import annotations

import pytest
from support.why_runs import EDGE, NESTED, NESTED_AT, ONCE, never, series, why

from nctakt.results.explained.reasons import why_branch_idle, why_cycle_idle, why_cycle_never
from nctakt.results.histories import Reason
from nctakt.run.controller import Controller, NcText


def body(*lines: str, head: str = "#RT CYCLE", tail: str = "#TIME 0.01") -> str:
    """A cycle with this body, then a dwell of ten ticks."""
    return "\n".join([head, *lines, "#RT CYCLE END", tail, "M30", ""])


IF = ("$IF V.E.CONDITION == 1", "V.E.COUNT += 1", "$ENDIF")


def test_never_true() -> None:
    """The nearest value is reported: 0.25 at tick 2, in which it was first seen."""
    at = [(2, "V.E.VALUE", 4.0), (3, "V.E.VALUE", 0.0), (5, "V.E.VALUE", 4.0)]
    report = why(body("$IF V.E.VALUE > 4.25", "V.E.COUNT += 1", "$ENDIF"), at=at)
    (cycle,) = report.cycles
    reason = never(report, cycle, 0)
    assert reason is not None
    assert reason.kind == "false"
    assert reason.nearest == cycle.branches[0].condition.nearest
    assert reason.nearest is not None
    assert (reason.nearest.tick, reason.nearest.left, reason.nearest.distance) == (2, 4.0, 0.25)


def test_never_reached_since_the_branch_around_it_was_false() -> None:
    """RC-204: the inner condition is not evaluated; the outer one is to blame."""
    report = why(NESTED)
    (cycle,) = report.cycles
    assert cycle.branches[1].evaluated.ticks == 0
    assert never(report, cycle, 1) == Reason("outer", branch=0)
    outer = never(report, cycle, 0)
    assert outer is not None
    assert outer.kind == "false"


def test_never_reached_since_an_earlier_branch_was_true() -> None:
    """RC-201: ``$ELSEIF`` and ``$ELSE`` after a branch that is true in each tick."""
    lines = (*IF[:2], "$ELSEIF V.E.VALUE == 1", "$ELSE", "V.E.COUNT = 0", "$ENDIF")
    report = why(body(*lines), set={"V.E.CONDITION": 1})
    (cycle,) = report.cycles
    assert [never(report, cycle, branch) for branch in range(3)] == [
        None,
        Reason("earlier", branch=0),
        Reason("earlier", branch=0),
    ]


def test_a_cycle_that_was_only_defined() -> None:
    """RC-102: DEF without START."""
    report = why(body(*IF, head="#RT CYCLE DEF [ID = 1]"))
    (cycle,) = report.cycles
    assert why_cycle_idle(cycle, 3) == Reason("unstarted", 0)
    assert why_cycle_never(cycle, 10) == Reason("unstarted", 0)
    assert never(report, cycle, 0) == Reason("cycle", cycle=Reason("unstarted", 0))


def test_a_block_cycle_whose_program_ends_first() -> None:
    """RC-004, RC-105: armed in tick 0, M30 in tick 1: ended without a run."""
    report = why(body(*IF, head="#RT CYCLE [SCOPE = BLOCK]", tail=""))
    (cycle,) = report.cycles
    assert report.ticks == 2
    assert why_cycle_idle(cycle, 0) == Reason("waiting", 0)
    reason = why_cycle_never(cycle, 1)
    assert reason is not None
    assert (reason.kind, reason.tick, reason.ended_by) == ("ended", 1, "program")


def test_a_block_cycle_whose_block_is_over() -> None:
    """RC-105: it runs in the ten ticks of the dwell; the next dwell is not its block."""
    report = why(body(*IF, head="#RT CYCLE [SCOPE = BLOCK]", tail="#TIME 0.01\n#TIME 0.01"))
    (cycle,) = report.cycles
    assert series(cycle.runs) == [(0, 9)]
    reason = why_cycle_idle(cycle, 15)
    assert reason is not None
    assert (reason.kind, reason.tick, reason.ended_by) == ("ended", 10, "scope")


def test_a_held_cycle() -> None:
    """RC-111: HOLD in tick 5 (line 6), CONTINUE in tick 10: it does not run in between."""
    tail = "#TIME 0.005\n#RT CYCLE HOLD [ID=2]\n#TIME 0.005\n#RT CYCLE CONTINUE [ID=2]\n#TIME 0.005"
    (cycle,) = why(body(*IF, head="#RT CYCLE [ID = 2]", tail=tail)).cycles
    assert series(cycle.runs) == [(0, 4), (10, 14)]
    reason = why_cycle_idle(cycle, 9)
    assert reason is not None
    assert (reason.kind, reason.tick, reason.span and reason.span.line) == ("held", 5, 7)
    branch = why_branch_idle(cycle, cycle.branches[0], 9)
    assert branch == Reason("cycle", cycle=reason)


def test_a_deleted_cycle() -> None:
    """RC-111: DELETE in tick 5."""
    tail = "#TIME 0.005\n#RT CYCLE DELETE [ID=2]\n#TIME 0.005"
    (cycle,) = why(body(*IF, head="#RT CYCLE [ID = 2 SCOPE = GLOBAL]", tail=tail)).cycles
    reason = why_cycle_idle(cycle, 7)
    assert reason is not None
    assert (reason.kind, reason.tick, reason.ended_by) == ("ended", 5, "delete")
    assert reason.span is not None
    assert reason.span.line == 7


def test_a_fault_before_the_condition_is_reached() -> None:
    """RC-207, RC-505: the division in line 2 ends the cycle in tick 0; line 3 is not reached."""
    report = why(body("V.E.COUNT = 1 / V.E.VALUE", *IF))
    (cycle,) = report.cycles
    reason = never(report, cycle, 0)
    assert reason is not None
    assert (reason.kind, reason.tick, reason.number) == ("fault", 0, 50879)
    assert reason.span is not None
    assert reason.span.line == 2


def test_a_fault_in_the_condition_itself() -> None:
    """RC-207: an evaluation that fails is no truth and no nearest value."""
    report = why(body("$IF 1 / V.E.VALUE > 5", "V.E.COUNT += 1", "$ENDIF"))
    (cycle,) = report.cycles
    (branch,) = cycle.branches
    assert series(branch.evaluated) == [(0, 0)]
    assert branch.condition.changes == ()
    assert branch.condition.nearest is None
    reason = never(report, cycle, 0)
    assert reason is not None
    assert (reason.kind, reason.number) == ("fault", 50879)
    reported = why_branch_idle(cycle, branch, 0)
    assert reported is not None
    assert reported.kind == "fault"


def test_a_cycle_that_another_one_stops() -> None:
    """RC-505: after a fault no further cycle runs in that tick."""
    text = body("V.E.COUNT = 1 / V.E.VALUE").replace("#TIME", "#RT CYCLE\n#RT CYCLE END\n#TIME")
    report = why(text, set={"V.E.VALUE": 1}, at=[(3, "V.E.VALUE", 0.0)])
    first, second = report.cycles
    assert series(first.runs) == [(0, 3)]
    assert second.runs.holds(2)
    assert not second.runs.holds(3)
    reason = why_cycle_idle(second, 3)
    assert reason is not None
    assert (reason.kind, reason.number) == ("stopped", 50879)


def test_a_reset_runs_no_cycle() -> None:
    """RC-007: an error of the first run is reset in the first tick of the second one."""
    controller = Controller()
    text = body(
        "V.E.COUNT += 1", head="#RT CYCLE [ID=1 SCOPE=GLOBAL]", tail="#RT CYCLE HOLD [ID=9]"
    )
    assert controller.run(NcText("part.nc", text)).state == "error"
    begin = controller.tick
    (cycle,) = why("#TIME 0.005\nM30\n", controller=controller).cycles
    assert why_cycle_idle(cycle, begin) == Reason("reset", begin)
    assert cycle.runs.holds(begin + 1)


def test_an_edge_that_was_true_before() -> None:
    """RC-203: no rise in this run, since the condition was true before it and stays so."""
    controller = Controller()
    text = body(
        "$IF EDGE V.E.CONDITION == 1", "M100", "$ENDIF", head="#RT CYCLE [ID=1 SCOPE=GLOBAL]"
    )
    controller.run(NcText("part.nc", text), set={"V.E.CONDITION": 1})
    report = why("#TIME 0.005\nM30\n", controller=controller)
    (cycle,) = report.cycles
    assert never(report, cycle, 0) == Reason("no rise")


def test_an_edge_between_two_rises() -> None:
    """RC-203: true since tick 463, it does not rise in tick 500."""
    (cycle,) = why(EDGE).cycles
    (branch,) = cycle.branches
    reason = why_branch_idle(cycle, branch, 500)
    assert reason is not None
    assert (reason.kind, reason.tick) == ("no rise", 463)
    assert why_branch_idle(cycle, branch, 463) is None


def test_a_once_that_is_done() -> None:
    """RC-203: after tick 463 nothing is evaluated."""
    (cycle,) = why(ONCE).cycles
    assert why_branch_idle(cycle, cycle.branches[0], 500) == Reason("done", 463)


def test_a_once_that_was_done_in_an_earlier_run() -> None:
    """RC-107, RC-203: done stays done until START."""
    controller = Controller()
    text = body(
        "$IF ONCE V.E.CONDITION == 1", "M100", "$ENDIF", head="#RT CYCLE [ID=1 SCOPE=GLOBAL]"
    )
    controller.run(NcText("part.nc", text), set={"V.E.CONDITION": 1})
    report = why("#TIME 0.005\nM30\n", controller=controller)
    (cycle,) = report.cycles
    assert never(report, cycle, 0) == Reason("done")


@pytest.mark.parametrize(
    ("tick", "outer", "inner"),
    [
        (1, "false", "outer"),
        (3, None, "false"),
        (5, None, None),
        (9, "false", "outer"),
        (12, None, None),
        (14, "cycle", "cycle"),
    ],
)
def test_a_nested_always_tick_by_tick(tick: int, outer: str | None, inner: str | None) -> None:
    """RC-204: why each of the two did not run in a tick."""
    (cycle,) = why(NESTED, at=NESTED_AT, set={"V.E.VALUE": 200}).cycles
    found = [why_branch_idle(cycle, branch, tick) for branch in cycle.branches]
    assert [reason and reason.kind for reason in found] == [outer, inner]


def test_a_definition_that_the_run_does_not_reach() -> None:
    """A branch of the program that is not taken, and a tick before the definition."""
    text = f"$IF 0\n{body(*IF, tail='')}".replace("M30", "$ENDIF\n#TIME 0.004")
    text += body(*IF)
    report = why(text)
    late, unreached = report.cycles
    assert (unreached.name, unreached.span.line, unreached.branches[0].span.line) == ("", 2, 3)
    assert why_cycle_never(unreached, report.ticks - 1) == Reason("undefined")
    assert why_cycle_idle(late, 3) == Reason("undefined", 4)
    assert series(late.runs) == [(4, 13)]
