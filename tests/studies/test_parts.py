# SPDX-License-Identifier: MIT
"""``study --part I/N``: shares of the runs, each with its own Parquet file in one folder."""

from __future__ import annotations

from pathlib import Path

import pytest

from nctakt.cli import main
from nctakt.studies.rows.results import Part, RowsOfParts, parse_part

Captured = pytest.CaptureFixture[str]

PLAN = """\
program = "part.nc"
expect = ["X at end < 4.5"]
[measure]
end = "X at end"
late = "time of M100"
[[vary]]
variable = "V.E.VALUE"
values = [1, 2.5, 3, 4, 5, 6, 7]
"""


@pytest.fixture
def plan(tmp_path: Path) -> Path:
    """A plan of seven runs."""
    (tmp_path / "part.nc").write_text("G01 X[V.E.VALUE] F6000\nM30\n")
    path = tmp_path / "plan.toml"
    path.write_text(PLAN)
    return path


@pytest.mark.parametrize("count", [1, 2, 3, 7, 10])
def test_parts_have_each_run_once(count: int) -> None:
    """In order, and as many as each other but for one."""
    parts = [Part(number, count).runs(7) for number in range(1, count + 1)]
    assert [run for part in parts for run in part] == list(range(7))
    assert max(map(len, parts)) - min(map(len, parts)) <= 1


def test_texts_that_are_no_parts() -> None:
    """From 1 to N, two whole numbers."""
    assert parse_part("3/10") == Part(3, 10)
    assert not any(map(parse_part, ("0/3", "4/3", "1", "a/b", "-1/3", "1/3/5", "")))


def test_parts_are_one_table(plan: Path, capsys: Captured) -> None:
    """The types do not depend on the values of a part; the report has all of them in order."""
    parquet = pytest.importorskip("pyarrow.parquet")
    folder = plan.parent / "results"
    for number in (3, 1):
        main(["study", str(plan), "--quiet", "--part", f"{number}/3", "--out", str(folder)])
    assert sorted(path.name for path in folder.iterdir()) == [
        "part-1-of-3.parquet", "part-3-of-3.parquet",
    ]  # fmt: skip
    page = plan.parent / "results.html"
    assert main(["study", "report", str(plan), str(folder), "--report", str(page)]) == 0
    assert "902535" in capsys.readouterr().err
    main(["study", str(plan), "--quiet", "--part", "2/3", "--out", str(folder)])
    schemas = [parquet.read_schema(path) for path in sorted(folder.iterdir())]
    assert schemas[0].equals(schemas[1])
    assert schemas[1].equals(schemas[2])
    rows = RowsOfParts(folder)
    assert [row["run"] for row in rows] == list(range(7))
    assert [row["end"] for row in rows] == [1, 2.5, 3, 4, 5, 6, 7]
    assert main(["study", "report", str(plan), str(folder)]) == 0
    assert not capsys.readouterr().err
    assert "3 failed" in page.read_text()


def test_parts_of_several_studies_are_refused(plan: Path, capsys: Captured) -> None:
    """A tenth and a third are not of the same division (902534); nor is an empty folder."""
    folder = plan.parent / "results"
    folder.mkdir()
    assert main(["study", "report", str(plan), str(folder)]) == 2
    for name in ("part-1-of-3.parquet", "part-01-of-10.parquet"):
        (folder / name).touch()
    assert main(["study", "report", str(plan), str(folder)]) == 2
    assert capsys.readouterr().err.count("902534") == 2


@pytest.mark.parametrize(
    "words",
    [
        ["--part", "4/3", "--out", "x"],
        ["--part", "1/3"],
        ["--part", "1/3", "--out", "x.csv"],
        ["--part", "1/3", "--out", "x", "--only", "1"],
        ["--part", "1/3", "--out", "x", "--cover"],
    ],
)
def test_parts_that_have_no_meaning(plan: Path, capsys: Captured, words: list[str]) -> None:
    """Before any run, and without a folder."""
    assert main(["study", str(plan), *words]) == 2
    assert "--part" in capsys.readouterr().err


def test_a_folder_that_is_a_file(plan: Path, capsys: Captured) -> None:
    """Nothing is overwritten (900507)."""
    assert main(["study", str(plan), "--part", "1/3", "--out", str(plan.parent / "part.nc")]) == 2
    assert "900507" in capsys.readouterr().err
