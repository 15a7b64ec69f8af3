# SPDX-License-Identifier: MIT
"""Any entry may hold anything: a plan is refused with messages, or its runs are made."""

from __future__ import annotations

import datetime
from pathlib import Path
from typing import Any

import hypothesis
import pytest
from hypothesis import strategies
from support.random_seeds import examples

from nctakt.base.failure import Failure
from nctakt.studies.study import Study
from tests.studies.test_schedule_studies import RTCONF

BASE: dict[str, Any] = {
    "machine": "demo",
    "plc": "plc.py",
    "method": "list",
    "count": 2,
    "seed": 1,
    "until": "5 ms",
    "after": "1 ms",
    "set": {"V.E.VALUE": 1},
    "at": [["1 ms", "V.E.TRIGGER = 1"]],
    "vary": [],
    "measure": {"way": "max X", "late": "time of M8", "own": "python own.py:measured"},
    "expect": ["way < 5", "X < 3 within 2 ms"],
    "find": [],
}
VARIED: list[dict[str, Any]] = [
    {"variable": "V.E.VALUE", "values": [1, 2], "nominal": 1},
    {"variable": "HLI.OVERRIDE", "values": [50], "rest": 10, "over": "2 ms", "at": "1 ms"},
    {"variable": "HLI.OVERRIDE", "from": 10, "to": 50, "step": 20, "for": "2 ms", "rest": 100},
    {"time_of": "V.E.TRIGGER = 1", "from": "0 ms", "to": "3 ms", "step": "1 tick", "for": "1 ms"},
    {"time_of": "V.E.TRIGGER = 1", "each_tick": True, "name": "injected"},
    {"noise": "V.E.VALUE", "values": [1, 2], "rest": 3, "amount": 2, "for": "3 ms"},
    {"series": "course", "values": ["course.csv"]},
    {"acknowledge": "M8", "values": ["never", "twice", "1 ms"]},
    {"plc_dies": "yes", "values": ["1 ms"]},
    {"plc_returns": "yes", "values": ["1 ms"]},
    {"parameter": "P-AXIS-00008", "of": "X", "values": [1000]},
    {"program_variable": "V.P.WAY", "from": 1, "to": 2},
]
OF_SCHEDULE: list[dict[str, Any]] = [
    {"load_entry": "functions.task_rnd", "from": 100, "to": 900},
    {"load_entry": "interrupt.phase", "each_phase": True, "name": "phase"},
    {"parameter": "P-RTCF-00010 of BACKGROUND", "values": [105, 116]},
    {"parameter": "P-RTCF-00002", "values": [2000]},
    {"rtconf": "list", "values": ["rtconf.lis"]},
    {"load": "file", "values": ["load.toml"]},
]
SCHEDULE: dict[str, Any] = {
    "rtconf": "rtconf.lis",
    "load": "load.toml",
    "os": "rtx",
    "until": "10 ms",
    "measure": {"way": "slack of GEO", "own": "p99 response of BACKGROUND", "all": "overflows"},
    "expect": ["way > 5 us"],
}
GOALS: list[dict[str, Any]] = [
    {"boundary": "V.E.VALUE", "budget": 3},
    {"minimize": "way", "budget": 2},
]
WORDS = (
    "", "0", "-1", "1 ms", "1e400 s", "nan", "X", "max X", "V.E.VALUE", "V.E.VALUE = 1", "way",
    "M8",
    "python own.py:missing", "python nowhere.py:f", "python own.py:number", "error 1.5", "own.py",
    "fired 17 line 2.5", "P-AXIS-00008", "P-AXIS-00020", "never", "a\0b", "x" * 300,
    "\udcff", "run",
    "((((", "1 / 0", "way / 0", "duration", "state", "within", "demo5", "course.csv",
    "interrupt.phase",
)  # fmt: skip
junk = strategies.recursive(
    strategies.one_of(
        strategies.booleans(),
        strategies.integers(-3, 3),
        strategies.integers(),
        strategies.sampled_from([10**30, -(10**30), 1e308, 1e-308, float("nan"), float("inf")]),
        strategies.sampled_from(WORDS),
        strategies.text(max_size=5),
        strategies.sampled_from([datetime.date(2026, 1, 1), datetime.time(1, 2)]),
    ),
    lambda inner: (
        strategies.lists(inner, max_size=3)
        | strategies.dictionaries(strategies.sampled_from(WORDS), inner, max_size=2)
    ),
    max_leaves=4,
)


@strategies.composite
def plans(draw: Any) -> dict[str, Any]:
    """A plan that is right but for one to three entries."""
    is_schedule = draw(strategies.integers(0, 3)) == 0
    base = SCHEDULE if is_schedule else BASE
    tables = {key: value for key, value in base.items() if draw(strategies.booleans())}
    tables |= {"rtconf": "rtconf.lis"} if is_schedule else {"program": "part.nc"}
    kinds = strategies.sampled_from(OF_SCHEDULE if is_schedule else VARIED)
    varied = draw(strategies.lists(kinds, max_size=2, unique_by=str))
    tables["vary"] = [dict(entry) for entry in varied]
    if draw(strategies.booleans()):
        tables["find"] = [dict(draw(strategies.sampled_from(GOALS)))]
    for _ in range(draw(strategies.integers(0, 3))):
        table = tables
        inner = [
            one
            for key in ("vary", "find")
            if isinstance(tables.get(key), list)
            for one in tables[key]
            if isinstance(one, dict) and one
        ]
        if inner and draw(strategies.booleans()):
            table = draw(strategies.sampled_from(inner))
        keys = [*table, *BASE, "from", "to", "step", "name", "rest", "os", "rtconf", "load"]
        table[draw(strategies.sampled_from(keys))] = draw(junk)
    return tables


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the files that plans name."""
    folder = tmp_path_factory.mktemp("plans")
    (folder / "part.nc").write_text("V.P.WAY = 1\nM8\nG01 X[V.P.WAY] F6000\nM30\n")
    (folder / "plc.py").write_text("from nctakt import Plc\n\n\nclass Own(Plc):\n    pass\n")
    (folder / "course.csv").write_text("time,V.E.VALUE\n0 s,5\n")
    (folder / "rtconf.lis").write_text(RTCONF)
    (folder / "load.toml").write_text("[functions]\ntask_rnd = 500\n")
    (folder / "own.py").write_text("number = 5\n\n\ndef measured(run):\n    return {}['no']\n")
    return folder


def test_a_plan_is_refused_with_messages_or_its_runs_are_made(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """No error of nctakt's own, whatever an entry holds."""
    monkeypatch.chdir(folder)

    @hypothesis.settings(
        max_examples=examples(30), deadline=None, database=None, derandomize=True,
        suppress_health_check=list(hypothesis.HealthCheck),
    )  # fmt: skip
    @hypothesis.given(plans())
    def check(tables: dict[str, Any]) -> None:
        try:
            study = Study(**tables)
            if len(study.plan.goals) and all(goal.budget < 9 for goal in study.plan.goals):
                study.find()
            result = study.run(numbers=range(min(study.plan.size, 3)))
            result.report()
            study.command(0)
        except Failure as failure:
            assert all(one.render("de") for one in failure.diagnostics)

    check()
