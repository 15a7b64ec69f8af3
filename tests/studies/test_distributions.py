# SPDX-License-Identifier: MIT
"""Distributions of dimensions: what is drawn, and what a plan must not say."""

from __future__ import annotations

import statistics
from pathlib import Path
from typing import Any

import pytest

from nctakt.base.failure import Failure
from nctakt.run.controller import NcText
from nctakt.studies.plans.distribution import Normal, Samples, Triangular
from nctakt.studies.study import Study


def study_of(count: int = 500, method: str = "random", **entry: Any) -> Study:
    """A study of one dimension of drawn values."""
    program = NcText("part.nc", "G01 X[V.E.VALUE] F6000\nM30\n")
    vary = [{"variable": "V.E.VALUE", **entry}]
    return Study(program=program, vary=vary, method=method, count=count)


def test_quantiles() -> None:
    """Worked out by hand: 84.13 % are below mean + deviation; areas of the triangle."""
    normal = Normal(50.0, 2.0)
    assert normal.quantile(0.5, 38.0, 62.0) == pytest.approx(50.0)
    assert normal.quantile(0.8413447, 38.0, 62.0) == pytest.approx(52.0, abs=1e-5)
    assert normal.quantile(0.0, 49.0, 51.0) == pytest.approx(49.0)
    triangle = Triangular(4.0)
    found = [triangle.quantile(share, 0.0, 10.0) for share in (0.0, 0.1, 0.4, 0.85, 1.0)]
    assert found == pytest.approx([0.0, 2.0, 4.0, 7.0, 10.0])
    samples = Samples((1.0, 2.0, 2.0, 4.0), Path("x"))
    assert [samples.quantile(share, 1, 4) for share in (0, 0.3, 0.6, 0.99)] == [1, 2, 2, 4]


@pytest.mark.parametrize("method", ["random", "latin", "sobol"])
def test_values_are_drawn_as_the_plan_says(method: str) -> None:
    """Mean and deviation of the drawn values; on the steps where there are any."""
    if method != "random":
        pytest.importorskip("scipy")
    words = {"distribution": "normal", "mean": 50, "deviation": 2}
    plan = study_of(method=method, **words, step=0.5).plan
    drawn = [float(plan.point(number)[0]) for number in range(500)]
    assert statistics.mean(drawn) == pytest.approx(50, abs=0.3)
    assert statistics.stdev(drawn) == pytest.approx(2, abs=0.2)
    assert all(value * 2 == round(value * 2) for value in drawn)
    assert plan.dimensions[0].rest_value == 50


def test_samples_of_a_column(tmp_path: Path) -> None:
    """Comments and empty cells are skipped; times have units; the median is the unchanged run."""
    file = tmp_path / "measured.csv"
    file.write_text("# machine 3\nstart,delay\n1,20 ms\n2,\n3,30 ms\n4,0.025s\n")
    program = NcText("part.nc", "M8\nM30\n")
    vary = [{"acknowledge": "M8", "distribution": "samples", "file": str(file), "column": "delay"}]
    plan = Study(program=program, vary=vary, method="random", count=50).plan
    assert {plan.point(number)[0] for number in range(50)} == {20_000, 25_000, 30_000}
    assert plan.dimensions[0].rest_value == 25_000
    assert file in plan.files


@pytest.mark.parametrize(
    ("words", "number"),
    [
        ({"distribution": "normal", "mean": 5}, 901303),
        ({"distribution": "normal", "mean": 5, "deviation": 0}, 901302),
        ({"distribution": "normal", "mean": 5, "deviation": 1, "from": 9, "to": 3}, 901302),
        ({"distribution": "normal", "mean": 5, "deviation": 1, "peak": 3}, 901302),
        ({"distribution": "normal", "mean": 5, "deviation": 1, "values": [3]}, 901302),
        ({"distribution": "triangular", "from": 1, "to": 2}, 901303),
        ({"distribution": "triangular", "from": 1, "to": 2, "peak": 3}, 901302),
        ({"distribution": "samples", "file": "nowhere.csv"}, 901302),
        ({"distribution": "poisson", "from": 1, "to": 2}, 901302),
        ({"distribution": ["normal"], "from": 1, "to": 2}, 901302),
        ({"mean": 5, "from": 1, "to": 2}, 901302),
        ({"method": "grid", "distribution": "triangular", "from": 1, "to": 2, "peak": 1}, 901302),
    ],
)
def test_wrong_distributions_are_refused(words: dict[str, Any], number: int) -> None:
    """What is missing, wrong, without meaning, or without effect."""
    with pytest.raises(Failure) as raised:
        study_of(**words)
    assert number in [found.id for found in raised.value.diagnostics]


def test_wrong_samples_are_reported_by_line(tmp_path: Path) -> None:
    """Each cell that is no number (902532); a column that is not there (902533)."""
    file = tmp_path / "measured.csv"
    file.write_text("a,b\n1,x\n2,nan\n3,7\n")
    for column, expected in (("b", [902532, 902532]), ("c", [902533]), ("", [902533])):
        words = {"distribution": "samples", "file": str(file), "column": column}
        with pytest.raises(Failure) as raised:
            study_of(**{name: word for name, word in words.items() if word})
        assert [found.id for found in raised.value.diagnostics] == expected
    file.write_text("a\n")
    with pytest.raises(Failure) as raised:
        study_of(distribution="samples", file=str(file))
    assert [found.id for found in raised.value.diagnostics] == [902533]
