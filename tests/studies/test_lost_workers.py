# SPDX-License-Identifier: MIT
"""Workers that end by themselves, or are killed, lose no finished run."""

from __future__ import annotations

import os
import shutil
import signal
import sys
from pathlib import Path
from typing import Any

import pytest

from nctakt.base.failure import Failure
from nctakt.base.version import __version__
from nctakt.cli import main
from nctakt.cli.results import study_progress
from nctakt.studies.rows.results import read_rows
from nctakt.studies.rows.row_store import RowStore
from nctakt.studies.runs.blocks import Blocks
from nctakt.studies.runs.row_block import RowBlock
from nctakt.studies.study import Study
from nctakt.studies.workers import processes, worker_process
from nctakt.studies.workers.worker_process import WorkerProcess

pytestmark = pytest.mark.slow

PLC = """\
import os

from nctakt import Plc


class Cell(Plc):
    def each_tick(self, hli):
        if hli.read("V.E.VALUE") == 13:
            os._exit(3)
"""


def study(folder: Path, *, count: int = 120, plc: bool = False) -> Study:
    """A study of a value, one run for each."""
    (folder / "part.nc").write_text("G01 X[V.E.VALUE] F6000\nM30\n")
    (folder / "cell.py").write_text(PLC)
    entries: dict[str, Any] = {"plc": str(folder / "cell.py")} if plc else {}
    return Study(
        program=str(folder / "part.nc"),
        until="0.2 s",
        vary=[{"variable": "V.E.VALUE", "from": 1, "to": count, "step": 1}],
        measure={"end": "X at end"},
        **entries,
    )


@pytest.mark.nightly
def test_a_run_that_ends_its_process_is_reported(tmp_path: Path) -> None:
    """The run gets a row that says so, all others theirs."""
    done = study(tmp_path, count=20, plc=True).run(processes=2)
    assert [row["run"] for row in done.rows if row["verdict"] == "crashed"] == [12]
    assert done.counts["passed"] == 19


@pytest.mark.nightly
def test_a_killed_worker_is_replaced(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """After kill -9 the rows are those of one process, in the same order."""
    started: list[WorkerProcess] = []
    begin = WorkerProcess.__init__

    def noted(worker: WorkerProcess, *words: Any) -> None:
        begin(worker, *words)
        started.append(worker)

    monkeypatch.setattr(WorkerProcess, "__init__", noted)
    plan = study(tmp_path)
    expected = plan.run().rows

    def kill(_block: RowBlock) -> None:
        if len(started) == 1:
            started[0].kill()

    executor = lambda p, n: processes.rows_of_processes(p, n, 1)  # noqa: E731
    assert plan.run(executor=executor, on_rows=kill).rows == expected
    assert len(started) == 2


@pytest.mark.nightly
@pytest.mark.parametrize("is_copied", [False, True])
def test_copies_and_new_processes_make_the_same_rows(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, is_copied: bool
) -> None:
    """Whether a worker is a copy of this process cannot be seen in its rows."""
    if is_copied and not worker_process.can_copy():
        pytest.skip("this process cannot be copied")
    monkeypatch.setattr(processes, "can_copy", lambda: is_copied)
    plan = study(tmp_path, count=30)
    assert plan.run(processes=2).rows == plan.run().rows


def test_a_worker_that_cannot_start_is_reported(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Not once for each run, but as the end of the study (901486)."""
    monkeypatch.setattr(processes, "can_copy", lambda: False)
    plan = study(tmp_path, count=30)
    for path in (shutil.which("false"), str(tmp_path / "nowhere")):
        monkeypatch.setattr(sys, "executable", path)
        with pytest.raises(Failure) as raised:
            plan.run(processes=2)
        assert [one.id for one in raised.value.diagnostics] == [901486]


@pytest.mark.nightly
@pytest.mark.parametrize("is_copied", [False, True])
def test_a_plc_reads_and_prints_what_it_likes(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, is_copied: bool
) -> None:
    """Neither disturbs what a worker is asked and answers."""
    if is_copied and not worker_process.can_copy():
        pytest.skip("this process cannot be copied")
    monkeypatch.setattr(processes, "can_copy", lambda: is_copied)
    plan = study(tmp_path, count=6, plc=True)
    text = "        print('x' * 9000)\n        assert os.read(0, 1) == b''\n"
    cell = PLC.replace("        if hli", f"{text}        if hli")
    (tmp_path / "cell.py").write_text(f"{cell}\nprint('x' * 9000, flush=True)\n")
    assert plan.run(processes=2).counts["passed"] == 6


def test_blocks_are_as_long_as_they_should_be() -> None:
    """This many runs as take the time of a block; few at the end, so that no worker waits."""
    blocks = Blocks(range(5000), 4, block_s=0.2)
    lengths, numbers = [], []
    for block in blocks:
        lengths.append(len(block))
        numbers += block
        blocks.note(0.001)
    assert numbers == list(range(5000))
    assert lengths[:3] == [20, 200, 200]
    assert lengths[-8:-1] == [10] * 7
    assert len(list(Blocks(iter(range(100)), 4, block_s=0.2))) == 5


def test_what_is_finished_is_not_made_again(tmp_path: Path) -> None:
    """``resumes`` makes the missing runs only, also after a line that was cut off."""
    plan = study(tmp_path, count=8)
    whole = plan.run().rows
    path = tmp_path / "out.csv.rows"
    store = RowStore(path, plan.plan, resumes=False)
    plan.run(numbers=range(5), store=store)
    store.close()
    with path.open("ab") as file:
        file.write(b'{"run": 5, "V.E')
    again: list[int] = []
    store = RowStore(path, plan.plan, resumes=True)
    done = plan.run(store=store, on_rows=lambda block: again.extend(block.numbers))
    store.close()
    assert again == [5, 6, 7]
    assert done.rows == whole


def test_rows_of_another_plan_are_refused(tmp_path: Path) -> None:
    """A program that has changed since makes other runs (901309)."""
    path = tmp_path / "out.csv.rows"
    RowStore(path, study(tmp_path, count=3).plan, resumes=False).close()
    with pytest.raises(Failure) as raised:
        RowStore(path, study(tmp_path, count=4).plan, resumes=True)
    assert raised.value.diagnostics[0].id == 901309


@pytest.mark.nightly
@pytest.mark.parametrize("name", ["rows.parquet", "rows.jsonl", "rows.csv"])
def test_rows_are_read_back(tmp_path: Path, name: str) -> None:
    """Numbers to the last bit, texts, and what has no value."""
    if name.endswith("parquet"):
        pytest.importorskip("pyarrow")
    study(tmp_path)
    plan = Study(
        program=str(tmp_path / "part.nc"),
        vary=[{"variable": "V.E.VALUE", "values": [1, 2]}],
        measure={"end": "X at end", "late": "time of M100"},
    )
    done = plan.run()
    done.save(tmp_path / name)
    rows = list(read_rows(tmp_path / name))
    assert [row["end"] for row in rows] == [row["end"] for row in done.rows]
    assert [row["late"] for row in rows] == [None, None]
    assert [row["digest"] for row in rows] == [row["digest"] for row in done.rows]


def schedule(folder: Path) -> Study:
    """A study of its own schedule with files, and a measure of a user's."""
    (folder / "own.py").write_text("def cycles(simulation):\n    return simulation.cycles\n")
    (folder / "load.toml").write_text("[functions]\ntask_rnd = 500\n")
    (folder / "rtconf.lis").write_text(
        "interrupt_source 2 # timer\ncycle_time 2000\ntime_slice 500\nwindows_time 500\n"
        "thread[0].name GEO\nthread[0].cycle 2000\nthread[0].priority 115\n"
        "thread[0].function[0].name task_int\nthread[0].function[1].name task_rnd\nEnd\n"
    )
    return Study(
        rtconf=str(folder / "rtconf.lis"),
        load=str(folder / "load.toml"),
        until="20 ms",
        vary=[{"load_entry": "functions.task_rnd", "from": 10, "to": 100, "step": 1}],
        measure={"own": f"python {folder / 'own.py'}:cycles", "response": "response of GEO"},
    )


@pytest.mark.nightly
@pytest.mark.filterwarnings("ignore")
def test_a_cluster_yields_the_same_rows_and_survives_kills(tmp_path: Path) -> None:
    """Dask workers on this machine, one of them killed: the rows of one process, byte for byte."""
    distributed = pytest.importorskip("distributed")
    from nctakt.studies.workers.cluster import rows_of_cluster  # noqa: PLC0415 - an extra

    plan = study(tmp_path, count=200)
    plan.run().save(tmp_path / "one.csv")
    plan.run(processes=4).save(tmp_path / "four.csv")
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, dashboard_address=None
    ) as cluster:
        killed: list[int] = []

        def kill(_block: RowBlock) -> None:
            if not killed:
                pid = next(iter(cluster.workers.values())).pid
                killed.append(pid)
                os.kill(pid, signal.SIGKILL)

        executor = lambda p, n: rows_of_cluster(p, n, cluster)  # noqa: E731
        plan.run(executor=executor, on_rows=kill).save(tmp_path / "cluster.csv")
        assert killed
        own = schedule(tmp_path)
        assert own.run(executor=executor).rows == own.run().rows
    files = [(tmp_path / f"{name}.csv").read_bytes() for name in ("one", "four", "cluster")]
    assert files[0] == files[1] == files[2]


@pytest.mark.filterwarnings("ignore")
def test_a_cluster_without_workers_is_reported(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Nobody would make the runs: 901316 after a time, instead of waiting forever."""
    distributed = pytest.importorskip("distributed")
    from nctakt.studies.workers import cluster  # noqa: PLC0415 - an extra

    monkeypatch.setattr(cluster, "WORKER_S", 0.5)
    with (
        distributed.LocalCluster(n_workers=0, processes=False, dashboard_address=None) as empty,
        pytest.raises(Failure) as raised,
    ):
        study(tmp_path).run(executor=lambda p, n: cluster.rows_of_cluster(p, n, empty))
    assert raised.value.diagnostics[0].id == 901316


@pytest.mark.nightly
@pytest.mark.skipif(os.name == "nt", reason="needs kill -9")
@pytest.mark.filterwarnings("ignore")
def test_a_killed_scheduler_keeps_what_is_finished(
    tmp_path: Path,
    scheduler: tuple[str, int],
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """The message names it, a note how many runs are kept; ``--resume`` makes the others."""
    from nctakt.studies.workers import cluster  # noqa: PLC0415 - an extra

    study(tmp_path)
    (tmp_path / "plan.toml").write_text(
        'program = "part.nc"\nuntil = "0.2 s"\n'
        '[[vary]]\nvariable = "V.E.VALUE"\nfrom = 1\nto = 500\nstep = 1\n'
    )
    address, pid = scheduler
    out = tmp_path / "rows.csv"
    words = ["study", str(tmp_path / "plan.toml"), "--out", str(out), "--quiet"]

    def kill(self: study_progress.StudyProgress, block: RowBlock) -> None:
        os.kill(pid, signal.SIGKILL)

    with monkeypatch.context() as patch:
        patch.setattr(cluster, "CONNECT_S", 3)
        patch.setattr(study_progress.StudyProgress, "add", kill)
        assert main([*words, "--scheduler", address]) == 2
    reported = capsys.readouterr().err
    assert "901316" in reported
    assert "901310" in reported
    assert "Traceback" not in reported
    kept = len(out.with_suffix(".csv.rows").read_bytes().splitlines()) - 1
    assert 0 < kept < 500
    assert f"{kept} of 500" in reported
    assert main([*words, "--resume", "-j", "2"]) == 0
    resumed = out.read_bytes()
    assert main([*words, "-j", "2"]) == 0
    assert out.read_bytes() == resumed


@pytest.mark.nightly
def test_a_worker_of_another_version_makes_no_runs(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its rows could be others: 901485 with both versions, for a study and for a search."""
    distributed = pytest.importorskip("distributed")
    from nctakt.studies.workers import cluster  # noqa: PLC0415 - an extra

    part = tmp_path / "part.nc"
    part.write_text("G01 X1 F6000\nM30\n")
    plan = Study(program=str(part), vary=[{"variable": "V.E.VALUE", "values": [1]}]).plan
    monkeypatch.setattr(cluster, "__version__", "0.0.1")
    with distributed.LocalCluster(
        n_workers=1, threads_per_worker=1, processes=False, dashboard_address=None
    ) as local:
        with pytest.raises(Failure, match="901485") as raised:
            list(cluster.rows_of_cluster(plan, [0], local))
        assert f"nctakt 0.0.1, not {__version__}" in str(raised.value)
        with (
            pytest.raises(Failure, match="901485"),
            cluster.points_of_cluster(plan, local) as make,
        ):
            list(make([(0, (1,))]))
