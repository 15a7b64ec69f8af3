# SPDX-License-Identifier: MIT
"""Rows that come in any order: kept as they come, sorted in parts, written as one file."""

from __future__ import annotations

import errno
import os
import random
from pathlib import Path
from typing import Any

import pytest

from nctakt.base.failure import Failure
from nctakt.cli import main
from nctakt.studies.rows import row_store
from nctakt.studies.rows.results import write_rows
from nctakt.studies.rows.row_store import RowStore, RunNumbers
from nctakt.studies.runs.row_block import RowBlock
from nctakt.studies.runs.study_runner import Row
from nctakt.studies.study import Study, StudyResult

PLAN = (
    'program = "part.nc"\n[measure]\nend = "X at end"\n'
    '[[vary]]\nvariable = "V.E.VALUE"\nfrom = 1\nto = 9\nstep = 1\n'
)


@pytest.fixture
def study(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Study:
    """A study in its own folder."""
    monkeypatch.chdir(tmp_path)
    Path("part.nc").write_text("G01 X[V.E.VALUE] F6000\nM30\n")
    Path("plan.toml").write_text(PLAN)
    return Study("plan.toml")


def rows_of(count: int) -> list[Row]:
    """Rows of a study that was not made."""
    text: list[Row] = [
        {
            "run": number, "V.E.VALUE": number, "end": number / 7, "state": "ended", "ticks": 5,
            "verdict": "passed", "broken": "", "seed": 0, "digest": f"{number:x}",
        }
        for number in range(count)
    ]  # fmt: skip
    return text


@pytest.mark.parametrize("is_small", [True, False])
@pytest.mark.parametrize("name", ["rows.csv", "rows.jsonl", "rows.parquet"])
def test_rows_are_sorted_in_parts(
    study: Study, monkeypatch: pytest.MonkeyPatch, name: str, is_small: bool
) -> None:
    """The file is that of rows that came in order, whatever fits in memory."""
    if name.endswith("parquet"):
        pytest.importorskip("pyarrow")
    if is_small:
        monkeypatch.setattr(row_store, "MAX_KEPT", 1000)
        monkeypatch.setattr(row_store, "MAX_SORTED", 5000)
    rows = rows_of(300)
    columns = list(rows[0])
    write_rows(rows, columns, Path(name))
    whole = Path(name).read_bytes()
    mixed = random.Random(1).sample(rows, len(rows))
    store = RowStore(Path("x.rows"), study.plan, resumes=False)
    store.add(RowBlock(mixed[:100]))
    store.close()
    store = RowStore(Path("x.rows"), study.plan, resumes=True)
    assert len(store.done) == 100
    store.add(RowBlock(mixed[100:]))
    stored = store.rows()
    assert len(stored) == 300
    assert (stored[7], stored[-1], stored[3:5]) == (rows[7], rows[-1], rows[3:5])
    assert stored == rows
    write_rows(stored, columns, Path(name))
    assert Path(name).read_bytes() == whole
    result = StudyResult(study.plan, stored)
    assert result.counts["passed"] == 300
    assert "300 runs" in result.report()
    store.remove()
    assert not list(Path().glob("x.rows*"))


def test_numbers_of_runs() -> None:
    """A bit for each."""
    numbers = RunNumbers()
    for number in (3, 70, 3, 8):
        numbers.add(number)
    assert len(numbers) == 3
    assert [number for number in range(100) if number in numbers] == [3, 8, 70]


def test_a_full_disk_keeps_what_is_finished(
    study: Study, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """The message says why, a note how many are kept; ``--resume`` makes the others."""
    words = ["study", "plan.toml", "--out", "rows.csv", "--quiet", "-j", "1"]
    assert main(words) == 0
    whole = Path("rows.csv").read_bytes()
    Path("rows.csv").unlink()
    written: list[Any] = []
    write = os.write

    def full(file: int, data: bytes) -> int:
        if data.startswith(b'{"run"'):
            written.append(data)
        if len(written) > 4:
            raise OSError(errno.ENOSPC, "No space left on device")
        return write(file, data)

    with monkeypatch.context() as patch:
        patch.setattr(row_store.os, "write", full)
        assert main(words) == 2
    reported = capsys.readouterr().err
    assert "900507" in reported
    assert "901310" in reported
    assert "No space left" in reported
    assert not Path("rows.csv").exists()
    assert main([*words, "--resume"]) == 0
    assert Path("rows.csv").read_bytes() == whole
    assert not Path("rows.csv.rows").exists()


@pytest.mark.parametrize("line", ["5", '{"a": 1}', "nonsense", '{"run": "x", "verdict": "passed"}'])
def test_damaged_rows_are_reported(study: Study, line: str) -> None:
    """A whole line that is no row (900503)."""
    RowStore(Path("x.rows"), study.plan, resumes=False).close()
    with Path("x.rows").open("a") as file:
        file.write(f"{line}\n")
    with pytest.raises(Failure) as raised:
        RowStore(Path("x.rows"), study.plan, resumes=True)
    assert raised.value.diagnostics[0].id == 900503


def test_more_runs_than_anybody_counts(study: Study, capsys: pytest.CaptureFixture[str]) -> None:
    """10^36 points are reported with the estimate; a sample of them runs."""
    vary = '[[vary]]\nvariable = "V.E.VALUE{}"\nfrom = 0\nto = 1e6\nstep = 1e-12\n'
    text = PLAN + "".join(vary.format(number) for number in (1, 2))
    Path("plan.toml").write_text(text)
    assert main(["study", "plan.toml", "--quiet"]) == 2
    assert "901305" in capsys.readouterr().err
    assert main(["study", "plan.toml", "--quiet", "--sample", "3"]) == 0


@pytest.mark.parametrize("resumes", [False, True])
def test_a_file_of_the_user_with_the_name_of_the_rows_stays(study: Study, resumes: bool) -> None:
    """It is no rows of a study (902023); nor is a file touched that has the name of a part."""
    path = Path("out.csv.rows")
    for text in ("mine\n", "", '{"run": 1, "verdict": "passed"}\n'):
        path.write_text(text, "utf-8")
        with pytest.raises(Failure) as raised:
            RowStore(path, study.plan, resumes=resumes)
        assert raised.value.diagnostics[0].id == 902023
        assert path.read_text("utf-8") == text
    path.unlink()
    others = [Path(f"{path}{ending}") for ending in (".sorted", ".sorted.parts")]
    for other in others:
        other.write_text("mine", "utf-8")
    RowStore(path, study.plan, resumes=False).remove()
    assert [other.read_text("utf-8") for other in others] == ["mine", "mine"]


@pytest.mark.skipif(os.name == "nt", reason="no locks")
def test_two_studies_that_write_one_file_are_reported(study: Study) -> None:
    """The second one ends before it takes anything away (900919)."""
    path = Path("out.csv.rows")
    store = RowStore(path, study.plan, resumes=False)
    store.add(RowBlock(rows_of(3)))
    before = path.read_bytes()
    for resumes in (False, True):
        with pytest.raises(Failure) as raised:
            RowStore(path, study.plan, resumes=resumes)
        assert raised.value.diagnostics[0].id == 900919
    assert path.read_bytes() == before
    store.close()
    store = RowStore(path, study.plan, resumes=True)
    assert len(store.done) == 3
    store.remove()
    assert not path.exists()


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no copies of processes")
def test_a_copy_of_the_process_does_not_hold_the_file(study: Study) -> None:
    """A worker that goes on for a while must not keep the next study from resuming."""
    path = Path("out.csv.rows")
    store = RowStore(path, study.plan, resumes=False)
    reader, writer = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(writer)
        os.read(reader, 1)
        os._exit(0)
    store.close()
    RowStore(path, study.plan, resumes=True).close()
    os.close(writer)
    os.close(reader)
    os.waitpid(child, 0)
