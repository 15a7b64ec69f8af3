# SPDX-License-Identifier: MIT
"""The rows of a study are those of one's own loop over ``Controller.run``.

The loop knows nothing of plans: it takes each value with each other one, the last dimension
fastest, says it with ``set`` and ``at``, and reads trace and events of the result itself.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from typing import Any

import hypothesis
from hypothesis import strategies
from support.random_seeds import examples

from nctakt.base.mode import is_compiled
from nctakt.run.controller import Controller, NcText
from nctakt.studies.runs.begun_run import Digest
from nctakt.studies.study import Study

#: X goes to V.E.VALUE, then M8, then Y; V.E.TRIGGER holds the path as long as it is set.
PART = NcText(
    "part.nc",
    """\
#RT CYCLE [ID=1 SCOPE=PROG]
$IF V.E.TRIGGER > 0
V.RTG.OVERRIDE.VEL.CYCLE = V.E.VALUE1
$ENDIF
#RT CYCLE END
G01 X[V.E.VALUE] F6000
M8
G01 Y2
M30
""",
)
X = "X.ACS.ACT_POS"
UNTIL = "250 ms"

halves = strategies.integers(0, 8).map(lambda number: number / 2)
times = strategies.integers(0, 90)


def several(values: strategies.SearchStrategy[Any]) -> strategies.SearchStrategy[list[Any]]:
    """One to three values of a dimension."""
    return strategies.lists(values, min_size=1, max_size=3, unique=True)


@strategies.composite
def plans(draw: Any) -> dict[str, Any]:
    """Ways of X, times and lengths of a stop, overrides for a while; limits of two measures."""
    return {
        "ways": draw(several(halves)),
        "stops": draw(several(times)),
        "length": draw(strategies.integers(1, 40)),
        "overrides": draw(several(strategies.integers(5, 150))),
        "at": draw(times),
        "for": draw(strategies.integers(1, 40)),
        "limits": (draw(halves), draw(times)),
    }


def study_of(plan: dict[str, Any]) -> Study:
    """The plan as a study."""
    way, late = plan["limits"]
    return Study(
        program=PART,
        until=UNTIL,
        vary=[
            {"variable": "V.E.VALUE", "values": plan["ways"]},
            {
                "time_of": "V.E.TRIGGER = 1",
                "values": [f"{ms} ms" for ms in plan["stops"]],
                "for": f"{plan['length']} ms",
            },
            {
                "variable": "HLI.OVERRIDE",
                "values": plan["overrides"],
                "at": f"{plan['at']} ms",
                "for": f"{plan['for']} ms",
                "rest": 100,
            },
        ],
        measure={"way": "max X", "end": "X at end", "late": "time of M8"},
        expect=[f"way < {way}", f"late < {late} ms"],
    )


def own_rows(plan: dict[str, Any], signals: tuple[str, ...]) -> Iterator[dict[str, Any]]:
    """The same runs, one after another, each on a new controller."""
    points = itertools.product(plan["ways"], plan["stops"], plan["overrides"])
    for number, (way, stop, override) in enumerate(points):
        digest = Digest()
        run = Controller().run(
            PART,
            set={"V.E.VALUE": way},
            at=[
                (f"{stop} ms", "V.E.TRIGGER", 1),
                (f"{stop + plan['length']} ms", "V.E.TRIGGER", 0),
                (f"{plan['at']} ms", "HLI.OVERRIDE", override),
                (f"{plan['at'] + plan['for']} ms", "HLI.OVERRIDE", 100),
            ],
            signals=signals,
            sinks=[digest],
            memory_trace=True,
            until=UNTIL,
        )
        xs = run.trace[X].tolist()
        late = [event.tick / 1000 for event in run.events if event.text == "M 8"]
        met = [max(xs) < plan["limits"][0], bool(late) and late[0] < plan["limits"][1] / 1000]
        yield {
            "run": number,
            "V.E.VALUE": way,
            "V.E.TRIGGER": stop / 1000,
            "HLI.OVERRIDE": override,
            "way": max(xs),
            "end": xs[-1],
            "late": late[0] if late else None,
            "state": run.state,
            "ticks": run.ticks,
            "verdict": "passed" if all(met) else "failed",
            "seed": 0,
            "digest": digest.text(),
        }


def test_a_study_makes_the_same_runs_as_a_loop() -> None:
    """Inputs, measures, state, ticks, verdict and the digest of the trace of each run."""

    @hypothesis.settings(
        max_examples=examples(12 if is_compiled() else 3),
        deadline=None, database=None, derandomize=True,
        suppress_health_check=list(hypothesis.HealthCheck),
    )  # fmt: skip
    @hypothesis.given(plans())
    def check(plan: dict[str, Any]) -> None:
        study = study_of(plan)
        rows = [dict(row) for row in study.run().rows]
        broken = [row.pop("broken") for row in rows]
        assert rows == list(own_rows(plan, study.runner.signals))
        assert [not text for text in broken] == [row["verdict"] == "passed" for row in rows]

    check()
