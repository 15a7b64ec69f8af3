# SPDX-License-Identifier: MIT
"""``python -m benchmarks.studies``: how many runs of a study are made per second, at what cost.

Measured: runs of examples/crossing.nc with fresh inputs in one process, the same on two; injections
into it with windows of 100 ticks; the overhead of Dask against processes; the size of 10^6 rows as
Parquet; the memory of a process over many runs; a loop over a reusable controller beside a study.
Goals: 2,800 runs/s and 10,000 injections/s per core, two cores 1.9 times one, Dask within 10 %, 60
MB, memory flat, one's own loop 1.3 times a study. ``benchmarks.plc`` has runs with a PLC. ``python
-m benchmarks.studies 1000000`` makes this many runs into a folder of parts instead, with one
worker, and says what they and 10^9 take. ``--rows 20`` only makes this many rows: instructions of a
run are those of 60 less those of 20, by 40 (``valgrind --tool=callgrind``).
"""

from __future__ import annotations

import gc
import platform
import resource
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

from nctakt.run.controller import Controller
from nctakt.studies.rows.folder_store import FolderStore
from nctakt.studies.rows.part_folder import PartFolder
from nctakt.studies.rows.results import write_rows
from nctakt.studies.runs.blocks import make_runs
from nctakt.studies.runs.shared_beginning import maker_of
from nctakt.studies.runs.study_runner import Row, StudyRunner
from nctakt.studies.study import Study
from nctakt.studies.workers.processes import rows_of_processes

PROGRAM = Path(__file__).parent.parent / "examples" / "crossing.nc"
RUNS = 600
#: The ticks of the program, and how many more it has with a longer way.
TICKS, LONG_WAY, MORE_TICKS = 1306, "X5000", 12000


def crossing(count: int, after: str = "0 s", program: Path = PROGRAM) -> Study:
    """The study of a value that the program counts on."""
    return Study(
        program=str(program),
        vary=[{"variable": "V.E.COUNT", "from": 0, "to": count - 1, "step": 1}],
        measure={"crossed": "time of M100"},
        expect=["crossed < 1 s"],
        after=after,
    )


def on_processes(study: Study, count: int) -> None:
    """Make the runs of a study on this many processes, without this one."""
    study.run(executor=lambda plan, left: rows_of_processes(plan, left, count, study.runner))


def injections() -> Study:
    """The injection at each tick, undecided for 100 ticks."""
    return Study(
        program=str(PROGRAM),
        vary=[{"time_of": "V.E.TRIGGER = 1", "each_tick": True}],
        expect=["PATH.SPEED < 0 within 100 ms"],
    )


def per_cpu_second(runner: StudyRunner, count: int) -> float:
    """How many rows of a runner are made in a second of its processor.

    Only this thread counts: libraries that rows import let one of theirs spin for a while.
    """
    maker = maker_of(runner, may_copy=True)
    maker.row(0)
    gc.collect()
    gc.freeze()  # as a worker does
    begin = time.thread_time()
    make_runs(maker, tuple(range(count)))
    return count / (time.thread_time() - begin)


def share_of_ticks(short: Callable[[], object], long: Callable[[], object]) -> tuple[float, float]:
    """How long a tick takes in seconds, and the share that ``TICKS`` have of the shorter run.

    ``long`` makes the same run with ``MORE_TICKS`` more. Both are made in turn, since the machine
    is not equally busy at all times.
    """
    taken: tuple[list[float], list[float]] = ([], [])
    for _ in range(60):
        for run, times in zip((short, long), taken, strict=True):
            begin = time.process_time()
            for _ in range(5):
                run()
            times.append((time.process_time() - begin) / 5)
    short_s, long_s = (sorted(times)[len(times) // 4] for times in taken)
    tick_s = (long_s - short_s) / MORE_TICKS
    return tick_s, tick_s * TICKS / short_s


def ticks_of_a_study() -> tuple[float, float]:
    """Tick and share of ticks in runs of a study, as ``share_of_ticks``."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "part.nc"
        path.write_text(PROGRAM.read_text("utf-8").replace("X500", LONG_WAY), "utf-8")
        runners = crossing(100).runner, crossing(100, program=path).runner
        for runner in runners:
            for number in range(3):
                runner.row(number)
        short, long = ((lambda one=runner: one.row(7)) for runner in runners)
        return share_of_ticks(short, long)


def loop_per_cpu_second(count: int) -> float:
    """How many runs of a reusable controller, with their traces, a second of a processor makes."""
    with Controller().reusable() as controller:
        for number in range(3):
            controller.run(PROGRAM, set={"V.E.COUNT": number})
        begin = time.thread_time()
        for number in range(count):
            controller.run(PROGRAM, set={"V.E.COUNT": number})
        return count / (time.thread_time() - begin)


def wall(function: Callable[[], object]) -> float:
    """How long a function takes in seconds."""
    begin = time.perf_counter()
    function()
    return time.perf_counter() - begin


def processor_seconds(who: int) -> float:
    """The time of a processor that this process (``RUSAGE_SELF``) or its ended children took."""
    usage = resource.getrusage(who)
    return usage.ru_utime + usage.ru_stime


def shares_of_two(study: Study) -> tuple[float, float]:
    """Shares of two processes while they make a study.

    How much of their time they have a processor, which is less on a machine that others use, too;
    how much of all processor time goes to who hands out the runs.
    """
    whos = resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN
    before = [processor_seconds(who) for who in whos]
    taken_s = wall(lambda: on_processes(study, 2))
    own_s, made_s = (processor_seconds(who) - at for who, at in zip(whos, before, strict=True))
    return made_s / (2 * taken_s), own_s / (own_s + made_s)


def parquet_megabytes(count: int) -> float:
    """The size of a file with this many rows."""
    first: Row = crossing(10).run().rows[0]
    rows: list[Row] = [
        {**first, "run": i, "V.E.COUNT": i, "digest": f"{i * 0x9E3779B97F4A7C15 % 2**64:016x}"}
        for i in range(count)
    ]
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "rows.parquet"
        write_rows(rows, list(first), path)
        return path.stat().st_size / 1e6


def memory_megabytes() -> float:
    """The largest memory of this process so far."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def at_length(count: int) -> None:
    """Make this many runs into a folder of parts; print what they take, and 10^9 at that rate."""
    study = crossing(count)
    with tempfile.TemporaryDirectory() as name:
        folder = PartFolder(f"{name}/rows/", study.plan, dict(study.runner.units))
        store = FolderStore(folder, study.plan, resumes=False)
        begin = time.perf_counter()
        rows = study.run(processes=1, store=store).rows
        taken_s = time.perf_counter() - begin
        store.close()
        assert len(rows) == count
        parts = list(Path(name).rglob("*.parquet"))
        size = sum(part.stat().st_size for part in parts)
    made_s = processor_seconds(resource.RUSAGE_CHILDREN)
    own_s = processor_seconds(resource.RUSAGE_SELF)
    memory = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
    print(f"{count} runs in {taken_s:.0f} s: {made_s:.0f} s of the worker, {own_s:.0f} s "
          f"of who hands out; {len(parts)} parts, {size / 1e6:.1f} MB; "
          f"{memory:.0f} and {memory_megabytes():.0f} MB of memory")  # fmt: skip
    hours = (made_s + own_s) / count * 1e9 / 3600
    print(f"10^9 runs: {hours:.0f} hours of a core, {size / count:.1f} GB")


def main() -> int:
    """Print one line for each goal."""
    if sys.argv[1:] and sys.argv[1].isdigit():
        at_length(int(sys.argv[1]))
        return 0
    runner = crossing(100_000).runner
    if sys.argv[1:2] == ["--rows"]:
        for number in range(int(sys.argv[2])):
            runner.row(number)
        return 0
    print(f"CPython {platform.python_version()}, {platform.machine()}")
    runs = per_cpu_second(runner, RUNS)
    print(f"runs per second of a core: {runs:.0f} (goal 2800)")
    tick_s, share = ticks_of_a_study()
    print(f"its {TICKS} ticks of {tick_s * 1e9:.0f} ns take {share:.0%} of a run")
    own = runs / loop_per_cpu_second(RUNS)
    print(f"a run of a reusable controller takes {own:.2f} times as long (goal 1.3)")
    each_tick = injections()
    print(
        f"injections per second of a core: {per_cpu_second(each_tick.runner, RUNS):.0f}"
        " (goal 10000)"
    )
    before = memory_megabytes()
    for number in range(5 * RUNS):
        runner.row(number)
    grown = memory_megabytes() - before
    print(f"memory grows by {grown:.1f} MB over {5 * RUNS} runs (goal 0)")
    study = crossing(20 * RUNS)
    one, two = (wall(lambda count=count: on_processes(study, count)) for count in (1, 2))  # type: ignore[misc]
    print(f"two processes are {one / two:.2f} times as fast as one (goal 1.9)")
    busy, own = shares_of_two(study)
    print(f"two processes are busy for {busy:.0%} of the time; handing out takes {own:.1%} of it")
    print(f"10^6 rows take {parquet_megabytes(1_000_000):.0f} MB as Parquet (goal 60)")
    if "--dask" in sys.argv:
        import distributed  # noqa: PLC0415 - an extra

        from nctakt.studies.workers.cluster import rows_of_cluster  # noqa: PLC0415

        with distributed.LocalCluster(n_workers=2, threads_per_worker=1) as cluster:
            client = distributed.Client(cluster)
            slow = crossing(2 * RUNS, after="50 s")
            slow.run(numbers=range(100), executor=lambda p, n: rows_of_cluster(p, n, client))
            dask = wall(lambda: slow.run(executor=lambda p, n: rows_of_cluster(p, n, client)))
            two = wall(lambda: on_processes(slow, 2))
            client.close()
        print(f"Dask takes {100 * (dask / two - 1):.0f} % longer than processes (goal 10)")
    return 0


if __name__ == "__main__":
    sys.exit(main())
