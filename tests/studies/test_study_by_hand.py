# SPDX-License-Identifier: MIT
"""A study whose answer is worked out by hand, found in each way that there is.

X moves at 100 mm/s from its first ramp on; V.E.TRIGGER stops the path. The ramp up and the braking
take the same way, so that X comes to rest at 100 mm/s times the time of the stop: a stop at 550 ms
rests at 55.0 mm, one a tick later at 55.1 mm. With ``max X < 55.05`` the first tick at which the
stop comes too late is that at 551 ms.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import pytest
from support.insides import let_copy

from nctakt.run.controller import Controller, NcText
from nctakt.studies.plans.plan import Goal
from nctakt.studies.runs.shared_beginning import SharedBeginning
from nctakt.studies.runs.study_runner import Digest
from nctakt.studies.searching.search import search
from nctakt.studies.searching.search_runs import SearchRuns
from nctakt.studies.study import Study

pytestmark = pytest.mark.slow

PROGRAM = """\
#RT CYCLE [ID = 1 SCOPE = PROG]
  $IF V.E.TRIGGER > 0
    V.RTG.OVERRIDE.VEL.CYCLE = 0
  $ENDIF
#RT CYCLE END
N10 G01 X100 F6000
M30
"""
FIRST_LATE = 0.551


@pytest.fixture
def program(tmp_path: Path) -> Path:
    """The program in its own file."""
    path = tmp_path / "stop.nc"
    path.write_text(PROGRAM)
    return path


def study(program: Path, **entries: Any) -> Study:
    """The study of the time of the stop."""
    vary = {"time_of": "V.E.TRIGGER = 1", "name": "stop", **entries}
    return Study(
        program=str(program),
        until="1 s",
        vary=[vary],
        measure={"rest": "max X"},
        expect=["max X < 55.05"],
    )


def test_a_grid_finds_the_first_late_tick(program: Path) -> None:
    """Each tick of a span as a grid of times."""
    done = study(program, **{"from": "540 ms", "to": "560 ms", "step": "1 tick"}).run()
    assert len(done) == 21
    assert done.broken[0]["stop"] == FIRST_LATE
    assert [row["verdict"] for row in done.rows] == ["passed"] * 11 + ["failed"] * 10
    assert done.rows[10]["rest"] == pytest.approx(55.0)


def test_each_tick_finds_it(program: Path) -> None:
    """The injection at each tick from a time on, up to the end of the unchanged run."""
    done = study(program, each_tick=True, **{"from": "530 ms", "to": "570 ms"}).run()
    assert done.broken[0]["stop"] == FIRST_LATE


@pytest.mark.skipif(not hasattr(os, "fork"), reason="needs fork")
@pytest.mark.filterwarnings("ignore:.*multi-threaded:DeprecationWarning")
def test_a_shared_beginning_yields_the_same_rows(program: Path) -> None:
    """Injections into copies of one run are those of runs from the start, to the last digit."""
    vary = {"time_of": "V.E.TRIGGER = 1", "each_tick": True, "for": "10 ms", "from": "300 ms"}
    plan = Study(
        program=str(program),
        vary=[vary],
        at=[["302 ms", "V.E.VALUE = 1"]],
        expect=["PATH.SPEED <= 0 within 20 ms"],
    )
    shared = SharedBeginning(plan.runner, may_copy=False)
    let_copy(shared)
    for number in (0, 1, 2, 3, 40, 700, 5):
        assert shared.row(number) == plan.runner.row(number)


def test_bisecting_finds_both_neighbours(program: Path) -> None:
    """The last tick that holds and the first one that does not, in few runs."""
    plan = Study(
        program=str(program),
        until="1 s",
        vary=[
            {
                "time_of": "V.E.TRIGGER = 1",
                "name": "stop",
                "from": "0 ms",
                "to": "900 ms",
                "step": "1 tick",
            }
        ],
        expect=["max X < 55.05"],
        find={"boundary": "stop"},
    )
    (answer,) = plan.find()
    assert [row["stop"] for row in answer.rows] == [0.55, FIRST_LATE]
    assert answer.runs <= 12


def test_a_span_without_a_switch_over_is_reported(program: Path) -> None:
    """Both ends hold: 901314 instead of an answer."""
    plan = study(program, **{"from": "0 ms", "to": "100 ms", "step": "1 tick"})
    finding = search(SearchRuns(plan.runner), Goal("boundary", "stop", 0)).finding
    assert finding is not None
    assert finding.id == 901314


def test_a_violation_shrinks_to_the_smallest_change(program: Path) -> None:
    """From a stop at 900 ms back towards that at 0 ms, as far as it stays too late."""
    plan = study(program, **{"from": "0 ms", "to": "900 ms", "step": "1 tick"})
    assert plan.shrink(900).rows[0]["stop"] == FIRST_LATE


def test_expectations_bound_a_search(program: Path) -> None:
    """The latest stop that rests before 55.05 mm is that at 550 ms (100 mm/s); without this limit
    it would be the last one of the grid, which is shown with what it breaks."""
    plan = study(program, **{"from": "500 ms", "to": "560 ms", "step": "1 tick"})
    answer = search(SearchRuns(plan.runner), Goal("maximize", "rest", 61))  # each point of the grid
    best, beyond = answer.rows
    assert (best["stop"], best["verdict"], answer.finding) == (0.55, "passed", None)
    assert beyond["stop"] == 0.56
    assert beyond["rest"] == pytest.approx(56.0)
    assert beyond["verdict"] == "failed"


def test_a_search_without_a_run_that_passes_says_so(program: Path) -> None:
    """All stops from 560 ms on are too late: 901940, and the best of them."""
    plan = study(program, **{"from": "560 ms", "to": "570 ms", "step": "1 tick"})
    answer = search(SearchRuns(plan.runner), Goal("minimize", "rest", 20))
    assert [row["stop"] for row in answer.rows] == [0.56]
    assert answer.finding is not None
    assert answer.finding.id == 901940


def test_several_objectives_have_a_pareto_set(program: Path) -> None:
    """Between 540 and 560 ms a later stop rests further; those up to 550 ms pass, and none of
    them is better in both: a late stop that rests early."""
    plan = Study(
        program=str(program),
        until="1 s",
        vary=[{"time_of": "V.E.TRIGGER = 1", "name": "stop", "from": "545 ms", "to": "560 ms",
               "step": "1 tick"}],
        measure={"rest": "max X", "reserve": "55.05 - rest"},
        expect=["rest < 55.05"],
        find={"pareto": ["maximize rest", "maximize reserve"], "budget": 20},
    )  # fmt: skip
    (answer,) = plan.find()
    assert [row["stop"] for row in answer.rows] == [n / 1000 for n in range(550, 544, -1)]
    plan = study(program, **{"from": "545 ms", "to": "560 ms", "step": "1 tick"})
    both = (("maximize", "rest"), ("maximize", "rest"))
    (row,) = search(SearchRuns(plan.runner), Goal("pareto", "", 20, both)).rows
    assert row["stop"] == 0.55


def test_a_boundary_is_two_ticks_that_follow_each_other(program: Path) -> None:
    """Whatever the step, and though 0.3 ms is no tick: 550 and 551 ms."""
    plan = study(program, **{"from": "0.3 ms", "to": "900 ms", "step": "7 ms"})
    answer = search(SearchRuns(plan.runner), Goal("boundary", "stop", 0))
    assert [row["stop"] for row in answer.rows] == [0.55, FIRST_LATE]


def test_a_search_finds_the_first_late_tick(program: Path) -> None:
    """The stop that rests nearest to 55.1 mm, among 901: by optuna, then by halving steps. The
    nearest one that passes comes first."""
    pytest.importorskip("optuna")
    plan = Study(
        program=str(program),
        until="1 s",
        vary=[
            {"time_of": "V.E.TRIGGER = 1", "name": "stop", "from": "0 s", "to": "900 ms",
             "step": "1 tick"}
        ],
        measure={"rest": "max X", "miss": "(rest - 55.1) * (rest - 55.1)"},
        expect=["rest < 55.05"],
        find={"minimize": "miss", "budget": 90},
    )  # fmt: skip
    (answer,) = plan.find()
    assert [row["stop"] for row in answer.rows] == [0.55, FIRST_LATE]
    assert answer.runs <= 90


def test_a_search_without_any_value_is_reported(program: Path) -> None:
    """901393 instead of an answer."""
    plan = Study(
        program=str(program),
        vary=[{"variable": "V.E.VALUE", "from": 0, "to": 1}],
        measure={"late": "time of M100"},
        find={"minimize": "late", "budget": 3},
    )
    pytest.importorskip("optuna")
    (answer,) = plan.find()
    assert answer.finding is not None
    assert answer.finding.id == 901393


def test_processes_yield_the_same_rows(program: Path) -> None:
    """One process, and two others that are given blocks of runs (same bytes, same order)."""
    plan = study(program, **{"from": "500 ms", "to": "560 ms", "step": "1 tick"})
    assert plan.run().rows == plan.run(processes=2).rows


def test_a_row_is_that_of_a_plain_run(program: Path) -> None:
    """The digest of a run of a study is that of the same run on a new controller."""
    row = study(program, values=["551 ms"]).run().rows[0]
    digest = Digest()
    Controller().run(
        NcText(str(program), PROGRAM),
        at=[("551 ms", "V.E.TRIGGER", 1)],
        until="1 s",
        signals=("X.ACS.ACT_POS",),
        sinks=[digest],
    )
    assert row["digest"] == digest.text()


def test_a_broken_run_has_its_command(program: Path) -> None:
    """The command of a run says its inputs in the words of ``nctakt run``."""
    plan = study(program, values=["551 ms"])
    command = plan.command(0)
    assert command == f"nctakt run {program} --at 0.551s V.E.TRIGGER=1 --until 1s"
