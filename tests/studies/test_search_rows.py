# SPDX-License-Identifier: MIT
"""The runs of a search as rows: written, gone on with, shown, made elsewhere."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

import pytest

from nctakt.base.failure import Failure
from nctakt.cli import main
from nctakt.studies.plans.dimension import Value
from nctakt.studies.plans.plan import COVERAGE
from nctakt.studies.rows.folder_store import FolderStore
from nctakt.studies.rows.part_folder import PartFolder, RowsOfFolder
from nctakt.studies.rows.row_store import RowStore
from nctakt.studies.runs.study_runner import Row, StudyRunner
from nctakt.studies.searching.search_runs import Point, SearchRuns
from nctakt.studies.study import Study

Captured = pytest.CaptureFixture[str]

PLAN = """\
program = "part.nc"
expect = ["end < 4.5"]
[measure]
end = "X at end"
[[vary]]
variable = "V.E.VALUE"
from = 0
to = 7
step = 1
[[find]]
boundary = "V.E.VALUE"
[[find]]
maximize = "end"
budget = 8
"""


@pytest.fixture
def plan(tmp_path: Path) -> Path:
    """X goes to V.E.VALUE, 0 to 7; up to 4 passes."""
    (tmp_path / "part.nc").write_text("G01 X[V.E.VALUE] F6000\nM30\n")
    path = tmp_path / "plan.toml"
    path.write_text(PLAN)
    return path


def test_a_search_writes_its_runs(plan: Path, capsys: Captured) -> None:
    """The boundary: 0, 7, 3, 5, 4; then each point of the grid."""
    out, page = plan.with_name("out.jsonl"), plan.with_name("page.html")
    words = ["study", str(plan), "--quiet", "--out", str(out), "--report", str(page)]
    assert main(words) == 0
    rows = list(map(json.loads, out.read_text().splitlines()))
    assert [row["V.E.VALUE"] for row in rows] == [0, 7, 3, 5, 4, *range(8)]
    assert [row["run"] for row in rows] == list(range(13))
    assert not plan.with_name("out.jsonl.rows").exists()
    assert "--set V.E.VALUE=5" in page.read_text()


def test_a_search_goes_on(plan: Path, capsys: Captured, monkeypatch: pytest.MonkeyPatch) -> None:
    """After Ctrl-C only the runs that are missing are made, with the same bytes at the end."""
    out, runs = plan.with_name("out.jsonl"), list[int]()
    words = ["study", str(plan), "--quiet", "--out", str(out)]
    main(words)
    whole = out.read_bytes()
    row_of = StudyRunner.row_of

    def noted(runner: StudyRunner, index: int, point: Sequence[Value], *, covers: bool) -> Row:
        if index == 6 and 6 not in runs:
            runs.append(index)
            raise KeyboardInterrupt
        runs.append(index)
        return row_of(runner, index, point, covers=covers)

    monkeypatch.setattr(StudyRunner, "row_of", noted)
    assert main(words) == 1
    runs[:] = [6]
    assert main([*words, "--resume"]) == 0
    assert runs == [6, *range(6, 13)]
    assert out.read_bytes() == whole


def test_another_maker_gives_the_same_answers(plan: Path) -> None:
    """The grid in one go, the points of the boundary one by one."""
    study, asked = Study(plan), list[int]()

    def make(points: Sequence[Point]) -> list[Row]:
        asked.append(len(points))
        return [study.runner.row_of(*point) for point in points]

    assert study.find(SearchRuns(study.runner, make=make)) == study.find()
    assert asked == [1, 1, 1, 1, 1, 8]


@pytest.mark.nightly
def test_a_cluster_makes_the_runs_of_a_search(plan: Path) -> None:
    """The same answers as here; and no scheduler is reported (901316)."""
    distributed = pytest.importorskip("distributed")
    from nctakt.studies.workers.cluster import points_of_cluster  # noqa: PLC0415 - an extra

    study = Study(plan)
    with (
        distributed.LocalCluster(
            n_workers=1, threads_per_worker=1, processes=False, dashboard_address=None
        ) as cluster,
        points_of_cluster(study.plan, cluster) as make,
    ):
        assert study.find(SearchRuns(study.runner, make=make)) == study.find()
    with pytest.raises(Failure, match="901316"), points_of_cluster(study.plan, "tcp://127.0.0.1:1"):
        pass


COVER = """\
program = "part.nc"
expect = ["end < 4.5"]
[measure]
end = "X at end"
[[vary]]
variable = "V.E.VALUE"
from = 0
to = 999
step = 1
"""
CYCLE = """\
#RT CYCLE [ID=1 SCOPE=PROG]
$IF V.E.VALUE == 7
V.E.COUNT = 1
$ENDIF
$IF V.E.VALUE == 777
V.E.COUNT = 2
$ENDIF
#RT CYCLE END
G01 X[V.E.VALUE / 100] F6000
M30
"""


@pytest.fixture
def cover(tmp_path: Path) -> Path:
    """X goes to a hundredth of V.E.VALUE, 0 to 999; two of these values have branches."""
    (tmp_path / "part.nc").write_text(CYCLE)
    path = tmp_path / "plan.toml"
    path.write_text(COVER)
    return path


def test_a_search_for_branches_writes_its_runs(cover: Path, capsys: Captured) -> None:
    """The rows are those of the same points in a study; the page has its pictures."""
    out, page = cover.with_name("out.jsonl"), cover.with_name("page.html")
    words = ["study", str(cover), "--cover", "--quiet", "--out", str(out), "--report", str(page)]
    assert main(words) == 0
    rows = list(map(json.loads, out.read_text().splitlines()))
    assert [row["run"] for row in rows] == list(range(len(rows)))
    assert {7, 777} <= {row["V.E.VALUE"] for row in rows}
    assert len({row["V.E.VALUE"] for row in rows}) == len(rows) < 100
    runner = Study(cover).runner
    assert rows == [runner.row_of(row["run"], [row["V.E.VALUE"]]) for row in rows]
    assert not cover.with_name("out.jsonl.rows").exists()
    assert "--set V.E.VALUE=777" in page.read_text()


def test_a_search_for_branches_goes_on(
    cover: Path, capsys: Captured, monkeypatch: pytest.MonkeyPatch
) -> None:
    """After Ctrl-C only the missing runs are made, and the output is the same in each letter."""
    out = cover.with_name("out.jsonl")
    words = ["study", str(cover), "--cover", "--quiet", "--out", str(out)]
    assert main(words) == 0
    whole, shown = out.read_bytes(), capsys.readouterr().out
    made, last, row_of = list[int](), [20], StudyRunner.row_of

    def noted(runner: StudyRunner, index: int, point: Sequence[Value], *, covers: bool) -> Row:
        if index == last[0]:
            raise KeyboardInterrupt
        made.append(index)
        return row_of(runner, index, point, covers=covers)

    monkeypatch.setattr(StudyRunner, "row_of", noted)
    assert main(words) == 1
    assert "20 of 1000 runs" in capsys.readouterr().err
    assert main(["study", str(cover), "--quiet", "--out", str(out), "--resume"]) == 2
    last[0] = -1
    assert main([*words, "--resume"]) == 0
    assert made == list(range(len(whole.splitlines())))
    assert (out.read_bytes(), capsys.readouterr().out) == (whole, shown)


def test_rows_of_other_points_are_made_again(cover: Path) -> None:
    """A corpus that another search has changed since: no row is for other inputs."""
    study = Study(cover)
    store = RowStore(cover.with_name("rows"), study.plan, resumes=False)
    SearchRuns(study.runner, store, covers=True).add([(3,), (4,)])
    rows = SearchRuns(study.runner, store, covers=True).add([(3,), (5,)])
    store.close()
    assert [(row["run"], row["V.E.VALUE"]) for row in rows] == [(0, 3), (1, 5)]


@pytest.mark.parametrize("option", ["--part=1/2", "--shrink"])
def test_what_a_search_for_branches_cannot_do(cover: Path, option: str, capsys: Captured) -> None:
    """Each run decides about the next: no parts of them."""
    words = ["study", str(cover), "--cover", "--out", str(cover.with_name("out"))]
    assert main([*words, option]) == 2
    assert option.partition("=")[0] in capsys.readouterr().err


@pytest.mark.parametrize("search", ["cover", "find"])
def test_a_folder_has_the_rows_of_a_search(
    search: str, cover: Path, capsys: Captured, monkeypatch: pytest.MonkeyPatch
) -> None:
    """After Ctrl-C it goes on, and its parts have the rows of an undisturbed file (one of each)."""
    pytest.importorskip("pyarrow")
    pytest.importorskip("fsspec")
    if search == "find":
        goal = '[[find]]\nmaximize = "end"\nbudget = 40\n[[vary]]'
        cover.write_text(COVER.replace("[[vary]]", goal))
    words = ["study", str(cover), "--quiet", *(["--cover"] if search == "cover" else [])]
    out, folder = cover.with_name("out.jsonl"), f"{cover.parent}/parts/"
    assert main([*words, "--out", str(out)]) == 0
    shown = capsys.readouterr().out
    last, row_of = [20], StudyRunner.row_of

    def broken_off(runner: StudyRunner, index: int, point: Sequence[Value], **how: bool) -> Row:
        if index == last[0]:
            raise KeyboardInterrupt
        return row_of(runner, index, point, **how)

    monkeypatch.setattr(StudyRunner, "row_of", broken_off)
    assert main([*words, "--out", folder]) == 1
    last[0] = -1
    assert main([*words, "--out", folder]) == 2  # results are there
    assert "902690" in capsys.readouterr().err
    assert main([*words, "--out", folder, "--resume"]) == 0
    assert capsys.readouterr().out == shown
    study = Study(cover)
    units = dict(study.runner.units)
    kept = PartFolder(folder, study.plan, units, covers=search == "cover")
    assert [part.count for part in kept.parts()] == [20, len(RowsOfFolder(kept)) - 20]
    rows = [{**row} for row in RowsOfFolder(kept)]
    assert [row.pop(COVERAGE, None) is not None for row in rows] == [search == "cover"] * len(rows)
    assert rows == list(map(json.loads, out.read_text().splitlines()))


def test_a_folder_keeps_its_rows_of_other_points(cover: Path) -> None:
    """A corpus that another search has changed since: refused (901309), no row is exchanged."""
    pytest.importorskip("pyarrow")
    pytest.importorskip("fsspec")
    study = Study(cover)
    units = dict(study.runner.units)
    folder = PartFolder(f"{cover.parent}/parts", study.plan, units, covers=True)
    store = FolderStore(folder, study.plan, resumes=False)
    SearchRuns(study.runner, store, covers=True).add([(3,), (4,)])
    searched = SearchRuns(study.runner, store, covers=True)
    with pytest.raises(Failure, match="901309"):
        searched.add([(3,), (5,)])
    store.close()
    assert [row["V.E.VALUE"] for row in RowsOfFolder(folder)] == [3, 4]


@pytest.mark.nightly
def test_a_cluster_makes_the_runs_of_a_search_for_branches(cover: Path) -> None:
    """Those that do not depend on each other at once; the same rows and answers as here."""
    distributed = pytest.importorskip("distributed")
    from nctakt.studies.workers.cluster import points_of_cluster  # noqa: PLC0415 - an extra

    study = Study(cover)
    here = SearchRuns(study.runner, covers=True)
    with (
        distributed.LocalCluster(
            n_workers=1, threads_per_worker=1, processes=False, dashboard_address=None
        ) as cluster,
        points_of_cluster(study.plan, cluster, covers=True) as make,
    ):
        there = SearchRuns(study.runner, make=make, covers=True)
        assert study.cover(searched=there) == study.cover(searched=here)
    assert there.rows == here.rows
