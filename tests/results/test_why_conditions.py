# SPDX-License-Identifier: MIT
"""What a run shows of each condition: evaluations, changes, run-throughs, nearest misses."""

from __future__ import annotations

import pytest
from support.why_runs import EDGE, NESTED, NESTED_AT, ONCE, changes, series, why

from nctakt.run.controller import Controller, NcText


def test_once_is_evaluated_until_it_is_true() -> None:
    """RC-203: X is 200.25 after 463 increments, read in tick 463; then nothing is evaluated."""
    (cycle,) = why(ONCE).cycles
    (branch,) = cycle.branches
    assert (cycle.name, cycle.scope, str(cycle.span)) == ("17", "PROG", "part.nc:1:1")
    assert series(cycle.runs) == [(0, 724)]
    assert branch.text == "$IF ONCE V.RTA.ACS.ACT_POS.X > 200"
    assert series(branch.evaluated) == [(0, 463)]
    assert changes(branch) == [(0, False, 0.0, 200.0), (463, True, 200.25, 200.0)]
    assert series(branch.bodies) == [(463, 463)]
    assert branch.condition.nearest is None


def test_the_life_of_a_cycle() -> None:
    """RC-102, RC-106: defined and started in tick 0; deleted in tick 725 by the program's end."""
    (cycle,) = why(ONCE).cycles
    assert [(event.tick, event.kind, event.ended_by) for event in cycle.life] == [
        (0, "created", ""),
        (0, "started", ""),
        (725, "ended", "program"),
    ]


def test_edge_runs_at_each_rise() -> None:
    """RC-203: X passes 200 upwards in ticks 463 and 1450 + 463, downwards in between.

    On the way back 100 mm are left at 200; after 262 increments X is 300 - 99.75 = 200.25, after
    263 it is 199.75, which is read in tick 725 + 263.
    """
    (cycle,) = why(EDGE).cycles
    (branch,) = cycle.branches
    assert series(branch.evaluated) == [(0, 2174)]
    assert [change[:3] for change in changes(branch)] == [
        (0, False, 0.0),
        (463, True, 200.25),
        (988, False, pytest.approx(199.75)),
        (1913, True, pytest.approx(200.25)),
    ]
    assert series(branch.bodies) == [(463, 463), (1913, 1913)]


def test_a_latched_always_inside_a_plain_if() -> None:
    """RC-203, RC-204: the inner condition is evaluated in ticks 2 to 4 only; it stays latched."""
    (cycle,) = why(NESTED, at=NESTED_AT, set={"V.E.VALUE": 200}).cycles
    outer, inner = cycle.branches
    assert inner.outer == 0
    assert series(outer.evaluated) == [(0, 13)]
    assert changes(outer) == [
        (0, False, 0.0, 1.0),
        (2, True, 1.0, 1.0),
        (8, False, 0.0, 1.0),
        (11, True, 1.0, 1.0),
    ]
    assert series(outer.bodies) == [(2, 7), (11, 13)]
    assert outer.bodies.ticks == 9
    assert series(inner.evaluated) == [(2, 4)]
    assert changes(inner) == [(2, False, 0.0, 100.0), (4, True, 150.0, 100.0)]
    assert series(inner.bodies) == [(4, 7), (11, 13)]


def test_the_nearest_miss_is_kept() -> None:
    """In the last tick X is 0.5 · 4000 · 0.001² = 0.002 mm from its end."""
    (cycle,) = why(ONCE.replace("200", "300")).cycles
    nearest = cycle.branches[0].condition.nearest
    assert nearest is not None
    assert (nearest.tick, nearest.right) == (724, 300.0)
    assert nearest.left == pytest.approx(299.998)
    assert nearest.distance == pytest.approx(0.002)


def test_a_mirrored_comparison_is_reported_as_it_is_evaluated() -> None:
    """``200 < x`` is true when ``x > 200`` is: left and operator belong together."""
    (cycle,) = why(ONCE.replace("V.RTA.ACS.ACT_POS.X > 200", "200 < V.RTA.ACS.ACT_POS.X")).cycles
    condition = cycle.branches[0].condition
    last = condition.changes[-1]
    assert (last.left, condition.operator, last.right) == (200.25, ">", 200.0)
    assert condition.text == "200 < V.RTA.ACS.ACT_POS.X"


def test_each_branch_of_an_if_has_its_ticks() -> None:
    """RC-201: X passes 100 in tick 263 (100.25 read) and 200 in tick 463; one branch runs."""
    text = """\
#RT CYCLE
  $IF V.RTA.ACS.ACT_POS.X > 200
    V.E.COUNT = 2
  $ELSEIF V.RTA.ACS.ACT_POS.X > 100
    V.E.COUNT = 1
  $ELSE
    V.E.COUNT = 0
  $ENDIF
#RT CYCLE END
G00 X300
M30
"""
    (cycle,) = why(text).cycles
    first, second, last = cycle.branches
    assert (second.word, second.earlier, last.word, last.earlier) == (
        "$ELSEIF",
        (0,),
        "$ELSE",
        (0, 1),
    )
    assert series(first.bodies) == [(463, 724)]
    assert series(second.evaluated) == [(0, 462)]
    assert series(second.bodies) == [(263, 462)]
    assert series(last.bodies) == [(0, 262)]
    assert last.evaluated.ticks == 0


def test_the_parts_of_a_condition_have_histories_of_their_own() -> None:
    """RC-501: both sides of ``&&`` and ``||`` are evaluated, so each is known in each tick."""
    text = ONCE.replace("ONCE ", "").replace(
        "X > 200", "X > 100 && V.RTA.ACS.ACT_POS.X < 150 || V.E.VALUE"
    )
    (cycle,) = why(text).cycles
    (branch,) = cycle.branches
    above, below, value = branch.parts
    assert [part.text for part in branch.parts] == [
        "V.RTA.ACS.ACT_POS.X > 100",
        "V.RTA.ACS.ACT_POS.X < 150",
        "V.E.VALUE",
    ]
    assert [(change.tick, change.truth) for change in above.changes] == [(0, False), (263, True)]
    assert [(change.tick, change.truth) for change in below.changes] == [(0, True), (363, False)]
    assert value.nearest is not None
    assert (value.nearest.left, value.nearest.right) == (0.0, 0.5)
    assert branch.condition.operator == "||"
    assert [change[:2] for change in changes(branch)] == [(0, False), (263, True), (363, False)]
    assert series(branch.bodies) == [(263, 362)]


def test_start_makes_everything_new() -> None:
    """RC-111: a ONCE that is done is evaluated again from the START in tick 5 on, and runs."""
    text = """\
#RT CYCLE DEF [ID = 3]
  $IF ONCE V.E.CONDITION == 1
    V.E.COUNT += 1
  $ENDIF
#RT CYCLE END
#RT CYCLE START [ID = 3]
#TIME 0.005
#RT CYCLE START [ID = 3]
#TIME 0.005
M30
"""
    (cycle,) = why(text, set={"V.E.CONDITION": 1}).cycles
    (branch,) = cycle.branches
    assert series(cycle.runs) == [(0, 9)]
    assert series(branch.evaluated) == [(0, 0), (5, 5)]
    assert changes(branch) == [(0, True, 1.0, 1.0), (5, True, 1.0, 1.0)]
    assert series(branch.bodies) == [(0, 0), (5, 5)]
    kinds = [(event.tick, event.kind) for event in cycle.life]
    assert kinds == [(0, "created"), (0, "started"), (5, "started"), (10, "ended")]


def test_a_global_cycle_of_an_earlier_run_goes_on() -> None:
    """RC-107: the second run knows its state at its begin, and only its own ticks."""
    controller = Controller()
    first = "#RT CYCLE [ID=4 SCOPE=GLOBAL]\n$IF V.E.VALUE > 5\nV.E.COUNT += 1\n$ENDIF\n"
    first += "#RT CYCLE END\n#TIME 0.01\nM30\n"
    controller.run(NcText("first.nc", first), set={"V.E.VALUE": 6})
    assert controller.tick == 11
    report = why("#TIME 0.01\nM30\n", controller=controller, at=[(4, "V.E.VALUE", 1.0)])
    (cycle,) = report.cycles
    (branch,) = cycle.branches
    assert [(event.tick, event.kind) for event in cycle.life] == [(11, "living")]
    assert series(cycle.runs) == [(11, 21)]
    assert branch.condition.was_true is True
    assert series(branch.evaluated) == [(11, 21)]
    assert changes(branch) == [(15, False, 1.0, 5.0)]
    assert series(branch.bodies) == [(11, 14)]


def test_the_report_does_not_depend_on_how_the_run_is_cut() -> None:
    """A PLC that is asked after each tick changes nothing."""

    class Waits:
        def cycle(self, hli: object) -> None:
            """Nothing to do."""

    def report(plc: Waits | None) -> object:
        run = Controller().run(
            NcText("part.nc", EDGE.replace("M100", "V.E.COUNT += 1")), plc=plc, why=True
        )
        return run.why

    assert report(Waits()) == report(None)


def test_nothing_is_kept_unless_it_is_asked_for() -> None:
    """``why`` is off by default, also after a run that had it on."""
    controller = Controller()
    assert why(ONCE, controller=controller).cycles
    assert controller.run(NcText("part.nc", "G00 X0\nM30\n")).why is None
