# SPDX-License-Identifier: MIT
"""``python -m benchmarks.branches``: how many branches ``study --cover`` reaches.

Thirty programs with branches of known difficulty: each with the share of all inputs that reach its
hardest branch. Measured: the share of the hard branches that are reached within 2,000 runs of each
program, by guided search, by points drawn at random, and by Hypothesis, whose ``target`` gets the
same distances. Goal: 90 % where random points reach at most 30 %. ``python -m benchmarks.branches
500 3`` allows 500 runs and takes every third program.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator

import hypothesis
from hypothesis import strategies

from nctakt.base.dataclass import dataclass
from nctakt.run.controller import NcText
from nctakt.studies.plans.coordinates import Coordinates, PlanCoordinates
from nctakt.studies.plans.dimension import chance
from nctakt.studies.searching.branch_distance import distances
from nctakt.studies.searching.cover import covered, reach
from nctakt.studies.searching.search_runs import SearchRuns
from nctakt.studies.study import Study

RUNS = 2_000
#: Branches that random points reach less often than this in a run count as hard.
HARD = 2e-4

WHOLE = {"from": 0, "to": 99_999, "step": 1}
REAL = {"from": 0.0, "to": 1_000.0}
A, B, C = ({"variable": f"V.E.{name}", **REAL} for name in ("VALUE", "VALUE1", "VALUE2"))
N, P, Q = ({"variable": f"V.E.{name}", **WHOLE} for name in ("COUNT_POS", "COUNT_NEG", "CONDITION"))
FEED = {"variable": "HLI.OVERRIDE", "from": 1.0, "to": 100.0}


def at(name: str, until_ms: int) -> dict[str, object]:
    """A value that is 1 for a tick, at any time."""
    return {"time_of": f"V.E.{name} = 1", "for": "1 tick", "from": "0 s", "to": f"{until_ms} ms"}


@dataclass(frozen=True, slots=True)
class Case:
    """A program: the branches of its realtime cycle, what varies, and the blocks that move.

    ``hard``: how many of its branches are hard. ``share``: of all inputs, those that reach them.
    """

    cycle: str
    vary: tuple[dict[str, object], ...]
    hard: int
    share: float
    blocks: str = "G04 X0.005"

    @property
    def study(self) -> Study:
        """The study of the program."""
        body = self.cycle.replace(";", "\n")
        text = f"#RT CYCLE [ID=1 SCOPE=PROG]\n{body}\n#RT CYCLE END\n{self.blocks}\nM30\n"
        return Study(
            program=NcText("case.nc", text), vary=list(self.vary), method="random", count=RUNS
        )


def on(condition: str) -> str:
    """An ``$IF`` with this condition alone."""
    return f"$IF {condition};V.E.COUNT = 1;$ENDIF"


def inside(*conditions: str) -> str:
    """``$IF`` in ``$IF``."""
    opened = "".join(f"$IF {condition};V.E.COUNT = 1;" for condition in conditions)
    return opened + ";".join("$ENDIF" for _ in conditions)


X = "V.RTA.ACS.ACT_POS.X"
SLOW = "G01 X20 F6000"
CASES = (
    # --- one input ---
    Case(on("V.E.COUNT_POS == 77777"), (N,), 1, 1e-5),
    Case(on("V.E.VALUE > 617.30 && V.E.VALUE < 617.31"), (A,), 1, 1e-5),
    Case(on("V.E.COUNT_POS * 3 - 1000 == 200"), (N,), 1, 1e-5),
    Case(on("V.E.VALUE * V.E.VALUE > 250000 && V.E.VALUE * V.E.VALUE < 250010"), (A,), 1, 1e-5),
    Case(on("SIN[V.E.VALUE / 4] > 0.99999999"), (A,), 1, 1e-4),
    Case(on("ABS[V.E.COUNT_POS - 50000] < 1"), (N,), 1, 1e-5),
    Case("$IF V.E.COUNT_POS != 43210;V.E.COUNT = 1;$ELSE;V.E.COUNT = 2;$ENDIF", (N,), 1, 1e-5),
    Case(
        "$IF V.E.COUNT_POS == 100;V.E.COUNT = 1;$ELSEIF V.E.COUNT_POS == 2000;V.E.COUNT = 2;"
        "$ELSEIF V.E.COUNT_POS == 30000;V.E.COUNT = 3;$ELSE;V.E.COUNT = 4;$ENDIF",
        (N,), 3, 1e-5,
    ),
    Case(on("V.E.COUNT_POS == 12 || V.E.COUNT_POS == 88888"), (N,), 1, 2e-5),
    Case(on("V.E.COUNT_POS MOD 4096 == 4095 && V.E.COUNT_POS > 90000"), (N,), 1, 2e-5),
    # --- several inputs ---
    Case(on("V.E.COUNT_POS == 4711 && V.E.COUNT_NEG == 815"), (N, P), 1, 1e-10),
    Case(inside("V.E.COUNT_POS == 4711", "V.E.COUNT_NEG == 815"), (N, P), 2, 1e-10),
    Case(
        inside("V.E.COUNT_POS > 99000", "V.E.COUNT_NEG < 10", "V.E.CONDITION == 5"),
        (N, P, Q), 2, 1e-11,
    ),
    Case(on("V.E.COUNT_POS == V.E.COUNT_NEG + 12345"), (N, P), 1, 1e-5),
    Case(on("ABS[V.E.VALUE - V.E.VALUE1] < 0.001 && V.E.VALUE2 > 999"), (A, B, C), 1, 2e-9),
    Case(on("V.E.VALUE + V.E.VALUE1 > 1999.9"), (A, B), 1, 5e-9),
    Case(on("V.E.VALUE * V.E.VALUE1 > 100 && V.E.VALUE * V.E.VALUE1 < 100.01"), (A, B), 1, 1e-7),
    Case(
        on(
            "V.E.VALUE * V.E.VALUE + V.E.VALUE1 * V.E.VALUE1 < 250000 && "
            "V.E.VALUE * V.E.VALUE + V.E.VALUE1 * V.E.VALUE1 > 249990"
        ),
        (A, B), 1, 8e-6,
    ),
    Case(
        "$IF V.E.VALUE >= 0.01 || ABS[V.E.VALUE1 - 300] >= 0.01;V.E.COUNT = 1;"
        "$ELSE;V.E.COUNT = 2;$ENDIF",
        (A, B), 1, 2e-10,
    ),
    Case(
        on("V.E.VALUE < V.E.VALUE1 && V.E.VALUE1 < V.E.VALUE2 && V.E.VALUE2 - V.E.VALUE < 0.01"),
        (A, B, C), 1, 5e-11,
    ),
    Case(on("[V.E.COUNT_POS == 7 || V.E.COUNT_POS == 9] && V.E.COUNT_NEG == 3"), (N, P), 1, 2e-10),
    Case(
        "V.E.SYNC = V.E.COUNT_POS + 2 * V.E.COUNT_NEG;" + on("V.E.SYNC == 250001"),
        (N, P), 1, 5e-6,
    ),
    Case(
        "V.E.COUNT = 0;$IF V.E.VALUE > 999.5;V.E.COUNT = 1;$ENDIF;$IF V.E.VALUE1 < 0.5;"
        "V.E.COUNT = V.E.COUNT + 1;$ENDIF;" + on("V.E.COUNT == 2"),
        (A, B), 1, 2.5e-7,
    ),
    # --- times, and where the axes are ---
    Case(on(f"V.E.TRIGGER == 1 && {X} > 15 && {X} < 15.2"), (at("TRIGGER", 20_000),), 1, 1e-4,
         SLOW),
    Case(
        on("V.E.TRIGGER == 1 && V.E.COUNT_POS == 31415"), (at("TRIGGER", 400), N), 1, 4e-6, SLOW
    ),
    Case(
        on(f"V.E.TRIGGER == 1 && V.E.CONDITION == 1 && {X} > 10 && {X} < 11"),
        (at("TRIGGER", 4_000), at("CONDITION", 4_000)), 1, 7e-7, SLOW,
    ),
    Case(on(f"{X} > 10 && V.RTA.ACS.ACT_POS.Y > 4.9999 && {X} < 10.01"), (A, B), 1, 1e-8,
         "G00 X[V.E.VALUE / 50] Y[V.E.VALUE1 / 100]"),
    Case(on(f"ABS[{X} - V.E.VALUE] < 0.0001 && {X} > 3"), (A,), 1, 1e-5, "G00 X10"),
    Case(on(f"{X} > 19 && V.E.COUNT_POS == 555"), (FEED, N), 1, 1e-5, "G01 X20 F60000"),
    Case(
        inside("V.E.TRIGGER == 1", f"{X} > 15 && {X} < 15.2", "V.E.COUNT_POS > 99990"),
        (at("TRIGGER", 20_000), N), 2, 1e-8, SLOW,
    ),
)  # fmt: skip


def by_search(case: Case, runs: int) -> tuple[int, int]:
    """Return how many branches guided search leaves, and how many runs it makes."""
    reached = reach(SearchRuns(case.study.runner, covers=True), runs)
    return reached.coverage.branches - reached.coverage.ran, reached.coverage.runs


def at_random(case: Case, runs: int) -> tuple[int, int]:
    """Return how many branches random points leave, and how many of them there were."""
    return _ran(case, _random_points(case, runs))


def _random_points(case: Case, runs: int) -> Iterator[Coordinates]:
    sizes = PlanCoordinates(case.study.plan).sizes
    for number in range(runs):
        shares = [chance(7, number, axis) for axis in range(len(sizes))]
        yield tuple(int(share * size) for share, size in zip(shares, sizes, strict=True))


def _ran(case: Case, points: Iterator[Coordinates]) -> tuple[int, int]:
    study, left, made = case.study, -1, 0
    space = PlanCoordinates(study.plan)
    reached: set[object] = set()
    for coordinates in points:
        coverage = covered(study.runner, space.point(coordinates))
        found = distances(coverage)
        made += 1
        reached.update(key for key, distance in found.items() if not distance.levels)
        left = len(found) - len(reached)
        if not left:
            break
    return left, made


def by_hypothesis(case: Case, runs: int) -> tuple[int, int]:
    """Return how many branches Hypothesis leaves with ``target``, and after how many runs."""
    study, made, needed = case.study, 0, runs
    space = PlanCoordinates(study.plan)
    left: dict[object, bool] = {}

    @hypothesis.seed(7)
    @hypothesis.settings(
        max_examples=runs, deadline=None, database=None,
        suppress_health_check=list(hypothesis.HealthCheck),
    )  # fmt: skip
    @hypothesis.given(strategies.tuples(*(strategies.integers(0, n - 1) for n in space.sizes)))
    def run(coordinates: tuple[int, ...]) -> None:
        nonlocal made, needed
        if made >= runs:
            return
        made += 1
        for key, distance in distances(covered(study.runner, space.point(coordinates))).items():
            left[key] = left.get(key, True) and bool(distance.levels)
            if left[key]:
                hypothesis.target(-(distance.levels + distance.rest / 10), label=str(key))
        if not any(left.values()):
            needed = min(needed, made)

    run()
    return sum(left.values()), needed


def main() -> None:
    """Print a line for each program, and the shares of the hard branches."""
    runs, every = (*map(int, sys.argv[1:]), RUNS, 1)[:2] if len(sys.argv) > 1 else (RUNS, 1)
    cases = CASES[::every]
    total = sum(case.hard for case in cases)
    for method in (by_search, at_random, by_hypothesis):
        begin, reached = time.process_time(), 0
        print(f"{method.__name__}:")
        for number, case in enumerate(cases):
            left, made = method(case, runs)
            reached += max(case.hard - left, 0)
            print(f"  {number * every:2}  {case.share:.0e}  {left} left  {made:5} runs  "
                  f"{case.cycle[:60]}")  # fmt: skip
        seconds = time.process_time() - begin
        print(
            f"  {reached} of {total} hard branches, {100 * reached / total:.0f} %, {seconds:.0f} s"
        )


if __name__ == "__main__":
    main()
