# SPDX-License-Identifier: MIT
"""``study --out FOLDER/``: Parquet parts that workers write, on this machine and elsewhere."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest

from nctakt.base.failure import Failure
from nctakt.cli import main
from nctakt.studies.rows.folder_store import FolderStore
from nctakt.studies.rows.part_folder import Part, PartFolder, RowsOfFolder
from nctakt.studies.runs.blocks import make_runs
from nctakt.studies.runs.row_block import RowBlock
from nctakt.studies.study import Study

Captured = pytest.CaptureFixture[str]

pytest.importorskip("pyarrow")
pytest.importorskip("fsspec")

PLAN = """\
program = "part.nc"
expect = ["X at end < 4.5"]
[measure]
end = "X at end"
[[vary]]
variable = "V.E.VALUE"
from = 0
to = 39
step = 1
"""


@pytest.fixture
def plan(tmp_path: Path) -> Path:
    """A plan of 40 runs."""
    (tmp_path / "part.nc").write_text("G01 X[V.E.VALUE] F6000\nM30\n")
    path = tmp_path / "plan.toml"
    path.write_text(PLAN)
    return path


def folder_of(study: Study, address: str) -> PartFolder:
    """Return a folder for the results of a study."""
    return PartFolder(address, study.plan, dict(study.runner.units))


@pytest.mark.nightly
def test_processes_write_parts(plan: Path, capsys: Captured) -> None:
    """Every run once, with the rows of a study in memory; a second study is refused (902690)."""
    polars = pytest.importorskip("polars")
    folder = plan.with_name("results")
    words = ["study", str(plan), "--quiet", "-j", "2", "--out", f"{folder}/"]
    assert main(words) == 1
    assert "40 runs: 5 passed, 35 failed" in capsys.readouterr().out
    frame = polars.read_parquet(f"{folder}/*/*.parquet")
    assert sorted(frame["run"].to_list()) == list(range(40))
    study = Study(plan)
    rows = RowsOfFolder(folder_of(study, str(folder)))
    assert rows == study.run().rows
    assert not list(folder.rglob("*.tmp"))
    assert main(words) == 2
    assert "902690" in capsys.readouterr().err
    page = plan.with_name("page.html")
    assert main(["study", "report", str(plan), str(folder), "--report", str(page)]) == 0
    assert page.exists()


def test_only_missing_runs_are_made(plan: Path) -> None:
    """Parts with gaps and overlaps are in order, each run once; another plan is refused."""
    study, address = Study(plan), str(plan.with_name("results"))
    store = FolderStore(folder_of(study, address), study.plan, resumes=False)
    for numbers in ((0, 1, 2, 9), (5, 6), (6, 7)):
        block = make_runs(study.runner, numbers, store.folder).rows
        assert (block.rows, len(block)) == ([], len(numbers))
    store.close()
    again = FolderStore(folder_of(study, address), study.plan, resumes=True)
    assert [number for number in range(40) if number in again.done] == [0, 1, 2, 5, 6, 7, 9]
    with pytest.raises(Failure, match="900919"):
        FolderStore(folder_of(study, address), study.plan, resumes=True)
    result = study.run(store=again)
    again.close()
    assert result == study.run()
    other = Study(plan, seed=7)
    with pytest.raises(Failure, match="901309"):
        FolderStore(folder_of(other, address), other.plan, resumes=True)


def test_a_full_disk_leaves_what_was_done(plan: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A part that cannot be written ends the study (900507); those before it stay, whole."""
    study, address = Study(plan), str(plan.with_name("results"))
    store = FolderStore(folder_of(study, address), study.plan, resumes=False)
    replace = Path.replace

    def full(path: Path, target: Path) -> Path:
        if path.name.startswith("run-") and int(path.name.split("-")[1]) >= 3:
            raise OSError(28, "No space left on device")
        return replace(path, target)

    monkeypatch.setattr(Path, "replace", full)

    make_runs(study.runner, (0, 1, 2), store.folder)
    with pytest.raises(Failure, match="No space left"):
        make_runs(study.runner, (3, 4, 5), store.folder)
    store.close()
    assert store.folder.parts() == [Part(0, 2, 3)]
    assert not list(Path(address).rglob("*.tmp"))


def test_any_storage_of_fsspec(plan: Path) -> None:
    """In memory: what this process gathers becomes a part at the end."""
    study, address = Study(plan), "memory://study-of-parts"
    store = FolderStore(folder_of(study, address), study.plan, resumes=False)
    for number in (1, 0, 2):
        store.add(RowBlock([study.runner.row(number)]))
    assert [row["run"] for row in store.rows()] == [0, 1, 2]
    assert store.folder.parts() == [Part(0, 2, 3)]


def test_parts_that_this_process_does_not_see_are_reported(plan: Path, capsys: Captured) -> None:
    """Memory of the workers, or a folder on their machines: no result without these runs."""
    words = ["study", str(plan), "--out", "memory://memory-of-workers", "-j", "1", "--quiet"]
    assert main(words) == 2
    shown = capsys.readouterr()
    assert ("902982" in shown.err, shown.out) == (True, "")


@pytest.mark.nightly
def test_object_storage(plan: Path, monkeypatch: pytest.MonkeyPatch, capsys: Captured) -> None:
    """Two processes write to a server of S3; when it has gone, that is reported (900507)."""
    server_of: Any = pytest.importorskip("moto.server")
    s3fs: Any = pytest.importorskip("s3fs")
    server = server_of.ThreadedMotoServer(ip_address="127.0.0.1", port=0)
    server.start()
    _, port = server.get_host_and_port()
    for name in ("AWS_ACCESS_KEY_ID", "AWS_SECRET_ACCESS_KEY"):
        monkeypatch.setenv(name, "testing")
    monkeypatch.setenv("AWS_ENDPOINT_URL", f"http://127.0.0.1:{port}")
    monkeypatch.setenv("AWS_DEFAULT_REGION", "us-east-1")
    try:
        s3fs.S3FileSystem().mkdir("studies")
        words = ["study", str(plan), "--quiet", "-j", "2", "--out", "s3://studies/first"]
        assert main(words) == 1
        study = Study(plan)
        rows = RowsOfFolder(folder_of(study, "s3://studies/first"))
        assert rows == study.run().rows
    finally:
        server.stop()
    capsys.readouterr()
    assert main([*words, "--resume"]) == 2
    assert "90050" in capsys.readouterr().err


@pytest.mark.nightly
@pytest.mark.skipif(sys.platform != "linux", reason="sends SIGKILL")
def test_a_killed_study_goes_on(plan: Path) -> None:
    """All parts that are there after a SIGKILL are whole; --resume makes the others."""
    plan.write_text(PLAN.replace("to = 39", "to = 39999"))
    folder = plan.with_name("results")
    words = [sys.executable, "-m", "nctakt", "study", str(plan), "--quiet", "--out", f"{folder}/"]
    process = subprocess.Popen([*words, "--yes"], stdout=subprocess.DEVNULL)
    while process.poll() is None and len(list(folder.rglob("*.parquet"))) < 2:
        time.sleep(0.05)
    os.kill(process.pid, signal.SIGKILL)
    process.wait()
    study = Study(plan)
    rows = RowsOfFolder(folder_of(study, str(folder)))
    assert 0 < len(rows) < 40_000
    assert [row["run"] for row in rows] == sorted({row["run"] for row in rows})
