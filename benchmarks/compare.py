# SPDX-License-Identifier: MIT
"""``python -m benchmarks.compare``: what laying a log over a run costs.

The log is made by our own run, twenty signals at 1 ms, whose stamps are moved by 1.25 s. ``nctakt
compare`` runs as its own process, whose time of the processor and peak of memory are reported.
``--seconds``: how long the log is (3,600); ``--rows``: how many rows a log of one signal has that
is compared with the same program as well (0: none). The goals: an hour of twenty signals in 20 s
and 500 MB, 10^8 rows in 500 MB.
"""

from __future__ import annotations

import argparse
import platform
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

from nctakt.base.mode import is_compiled
from nctakt.results.trace.sinks import CsvSink
from nctakt.run.controller import Controller

#: A program of this many rounds, of some 1.6 s each.
PROGRAM = """$FOR P1 = 1, {rounds}, 1
N10 G01 X[90 + 10 * SIN[P1 * 37]] Y[20 + 10 * SIN[P1 * 11]] F12000
N20 G04 X0.3
N30 G01 X0 Y0 Z[P1 / 100] A[P1 / 10]
N40 G04 X0.2
$ENDFOR
M30
"""
ROUND_S = 1.4
#: How the process of a comparison reports its consumption.
MEASURED = """
import resource, sys
from nctakt.cli import main
main(sys.argv[1:])
used = resource.getrusage(resource.RUSAGE_SELF)
print(used.ru_utime + used.ru_stime, used.ru_maxrss / 1024, file=sys.stderr)
"""
FRAMES = ("ACS.ACT_POS", "ACS.CMD_POS", "MCS.ACT_POS", "PCS.ACT_POS", "PCS.CMD_POS")
SIGNALS = [f"{axis}.{frame}" for axis in "XYZA" for frame in FRAMES]
OFFSET_US = 1_250_000


def log_of_a_run(folder: Path, seconds: int) -> int:
    """Write the log of a run, its stamps moved; return its rows."""
    plain = folder / "trace.csv"
    with plain.open("w", encoding="utf-8", newline="") as file:
        run = Controller().run(
            folder / "part.nc",
            signals=SIGNALS,
            sinks=[CsvSink(file)],
            memory_trace=False,
            until=f"{seconds}s",
        )
    with plain.open(encoding="utf-8") as trace, (folder / "log.csv").open("w") as log:
        log.writelines(moved(trace))
    plain.unlink()
    return run.ticks


def moved(lines: Iterator[str]) -> Iterator[str]:
    """Yield the lines of a trace with moved stamps and without ticks and events."""
    next(lines)
    yield ",".join(["time_us", *SIGNALS]) + "\n"
    for line in lines:
        _, stamp, *values = line.split(",", len(SIGNALS) + 2)
        yield f"{int(stamp) + OFFSET_US},{','.join(values[: len(SIGNALS)])}\n"


def long_log(file: Path, rows: int) -> None:
    """Write a log of one signal: the axis moves to and fro forever."""
    period = "".join(f",{100 * abs(1000 - tick) / 1000:.3f}\n" for tick in range(2000)).split()
    with file.open("w", encoding="utf-8") as log:
        log.write("time_ms,X.ACS.ACT_POS\n")
        for begin in range(0, rows, 2000):
            log.write("\n".join(f"{begin + at}{text}" for at, text in enumerate(period)) + "\n")


def measure(folder: Path, log: str, *words: str) -> str:
    """Return what a comparison takes, and the first lines of its answer."""
    begin = time.perf_counter()
    done = subprocess.run(
        [sys.executable, "-c", MEASURED, "compare", log, "part.nc", "--quiet", *words],
        cwd=folder,
        capture_output=True,
        text=True,
        check=True,
    )
    wall = time.perf_counter() - begin
    processor, memory = map(float, done.stderr.splitlines()[-1].split())
    said = "\n".join(done.stdout.splitlines()[:6])
    return f"{processor:.1f} s of a processor, {wall:.1f} s by the clock, {memory:.0f} MB\n{said}"


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=int, default=3600)
    parser.add_argument("--rows", type=int, default=0)
    given = parser.parse_args()
    print(f"{platform.python_version()}, {'compiled' if is_compiled() else 'plain'}")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        rounds = int(given.seconds / ROUND_S) + 1
        (folder / "part.nc").write_text(PROGRAM.format(rounds=rounds), "utf-8")
        rows = log_of_a_run(folder, given.seconds)
        size = (folder / "log.csv").stat().st_size / 1e6
        print(f"\n{rows} rows of {len(SIGNALS)} signals, {size:.0f} MB of text:")
        limit = f"{given.seconds}s"
        print(measure(folder, "log.csv", "--until", limit))
        (folder / "log.csv").unlink()
        if given.rows:
            long_log(folder / "long.csv", given.rows)
            size = (folder / "long.csv").stat().st_size / 1e6
            print(f"\n{given.rows} rows of one signal, {size:.0f} MB of text:")
            print(measure(folder, "long.csv", "--until", limit, "--offset", "0s"))


if __name__ == "__main__":
    main()
