# SPDX-License-Identifier: MIT
"""Injections that are tried off an unchanged run have the rows of runs from the start."""

from __future__ import annotations

import random
from pathlib import Path

import pytest
from support.program_generator import program
from support.random_seeds import all_seeds

from nctakt.lists.format.times import Time
from nctakt.run.controller import NcText
from nctakt.run.realtime.snapshot import Snapshot
from nctakt.studies.measuring.measure_nodes import Condition, Reaction
from nctakt.studies.measuring.window import LOOK_TICKS, Injection, ValuesFrom
from nctakt.studies.runs.shared_beginning import MAX_LEAD, SharedBeginning
from nctakt.studies.runs.trial import Trials
from nctakt.studies.study import Study

MOVE = 'G01 X10 F6000\nG04 X0.2\nX0 Y5\n#MSG ["at %f", V.E.VALUE]\nX20\nM30\n'
WAITING = """#RT CYCLE [SCOPE = PROG]
  $IF EDGE V.E.VALUE > 1
    M100
    V.RTG.OVERRIDE.VEL.CYCLE = 30
  $ENDIF
#RT CYCLE END
"""


def each_tick(text: str, expect: str, injected: str = "V.E.VALUE = 5", **vary: str) -> Study:
    """The study of an injection at each tick."""
    entry = {"time_of": injected, "each_tick": True, "to": "700 ms"} | vary
    return Study(program=NcText("p.nc", text), vary=[entry], until="2 s", expect=[expect])


@pytest.mark.parametrize(
    "expect",
    ["PATH.SPEED < 0 within 100 ms", "PATH.SPEED > 20 within 90 ms", "V.E.VALUE >= 5 within 1 s"],
)
def test_a_tried_injection_has_the_row_of_a_run_from_the_start(
    expect: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Whatever is expected, with a value that goes back, at ticks of all kinds."""
    plan = each_tick(WAITING + MOVE, expect, **{"for": "30 ms"})
    made = count_trials(monkeypatch)
    shared = SharedBeginning(plan.runner, may_copy=False)
    numbers = [*range(0, 40, 3), *range(90, 330, 11), 5]
    for number in numbers:
        assert shared.row(number) == plan.runner.row(number)
    assert made.count(True) > len(numbers) // 3


def test_one_snapshot_serves_the_injections_after_it(monkeypatch: pytest.MonkeyPatch) -> None:
    """The unchanged run waits for less than 32 ticks; a run's row does not depend on where."""
    taken: list[int] = []
    take = Snapshot._take

    def counted(self: Snapshot) -> None:
        taken.append(self._realtime.kernel.tick)
        take(self)

    plan = each_tick(WAITING + MOVE, "PATH.SPEED < 0 within 40 ms")
    shared, anew = (SharedBeginning(plan.runner, may_copy=False) for _ in range(2))
    anew.row(20)
    monkeypatch.setattr(Snapshot, "_take", counted)
    rows = [shared.row(number) for number in range(10, 80)]
    assert [tick for tick in taken if tick] == [10, 10 + MAX_LEAD, 10 + 2 * MAX_LEAD]
    for number in (20, 41, 42, 73, 79):
        assert anew.row(number) == rows[number - 10]


def count_trials(monkeypatch: pytest.MonkeyPatch) -> list[bool]:
    """Whether each call of ``Trials.make`` from now on has made a trial."""
    made: list[bool] = []
    make = Trials.make

    def counted(self: Trials, *given: object) -> object:
        tried = make(self, *given)  # type: ignore[arg-type]
        made.append(tried is not None)
        return tried

    monkeypatch.setattr(Trials, "make", counted)
    return made


@pytest.mark.slow
def test_random_programs_have_the_same_rows(monkeypatch: pytest.MonkeyPatch) -> None:
    """Programs with cycles, overrides and faults of all kinds."""
    made = count_trials(monkeypatch)
    for seed in all_seeds(compiled=6, plain=2):
        chance = random.Random(seed)
        name = chance.choice(("V.E.TRIGGER", "V.E.VALUE1", "V.E.COUNT", "HLI.FEED_HOLD"))
        limit = chance.choice((20, 100, 300))
        plan = each_tick(
            program(seed), f"PATH.SPEED > 90 within {limit} ms", f"{name} = 1", **{"for": "15 ms"}
        )
        shared = SharedBeginning(plan.runner, may_copy=False)
        for number in sorted(chance.sample(range(len(plan)), min(12, len(plan)))):
            assert shared.row(number) == plan.runner.row(number), (seed, number)
    assert any(made)


def test_other_stimuli_of_the_plan_are_not_forgotten() -> None:
    """Near them a run is made from its start."""
    plan = Study(
        program=NcText("p.nc", WAITING + MOVE),
        at=[["50 ms", "V.E.VALUE = 3"]],
        vary=[{"time_of": "HLI.OVERRIDE = 40", "each_tick": True, "to": "150 ms"}],
        expect=["PATH.SPEED < 0 within 40 ms"],
    )
    shared = SharedBeginning(plan.runner, may_copy=False)
    for number in range(0, 150, 7):
        assert shared.row(number) == plan.runner.row(number)


def test_a_run_is_looked_at_from_its_injection_on() -> None:
    """Every 64 ticks, and at the end of the window."""
    held = Reaction(Condition("X", ">", 1.0), Time(150_000), None)
    injection = Injection(7_500, 8, 159, 1000, (held,))
    assert list(injection.looks()) == [8 + LOOK_TICKS, 8 + 2 * LOOK_TICKS, 159]


def test_values_before_the_window_are_not_there() -> None:
    """Nobody takes one of them for another."""
    values = ValuesFrom(3, [1.0, 2.0])
    assert (len(values), values[3], values[4]) == (5, 1.0, 2.0)
    with pytest.raises(IndexError):
        values[2]


def test_a_decided_run_is_left(tmp_path: Path) -> None:
    """A condition that comes at once is decided at the first look, not at the window's end."""
    plan = each_tick(WAITING + MOVE, "V.E.VALUE >= 5 within 1 s")
    row = plan.runner.row(20)
    assert (row["state"], row["ticks"], row["reaction_time"]) == ("decided", 20 + LOOK_TICKS, 0.001)
