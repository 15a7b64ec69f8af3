# SPDX-License-Identifier: MIT
"""``python -m benchmarks.sessions [LINES …]``: how long it takes to go back in long programs.

For programs of 2,000, 20,000, 200,000 and 1,000,000 lines, each lived through to its end or for
``--ticks``:

- the way there, against ``run``;
- a step back by a block, and by a tick, from the front and from places in each part of the program:
  at most 100 ms;
- a search backward that runs everything again, against ``run``: at least 0.8;
- a search backward in the record, for events, writes and recorded signals: at least 20 million
  ticks a second.

Besides the elapsed time there is the processor time of all processes together: it does not include
other work on the machine, so comparisons use it (Linux).
"""

from __future__ import annotations

import argparse
import functools
import os
import random
import statistics
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import IO, Any

from nctakt import Controller
from nctakt.base.dataclass import dataclass
from nctakt.session.process.process_pool import RemoteEngine
from nctakt.session.session import Session

LINES = (2_000, 20_000, 200_000, 1_000_000)
PLACES = 12

#: Searches that the record answers: an event, a write, signals that never do it.
RECORDED = ("message", "written V.E.COUNT", "V.RTA.ACS.ACT_POS.X > 1000000", "changes V.E.VALUE")

#: A search of which no single signal decides.
RUN_AGAIN = "V.RTA.ACS.ACT_POS.X + V.RTA.ACS.ACT_POS.Y > 1000000"


def write_program(path: Path, lines: int) -> None:
    """Write a program as CAM systems do: many short motions along a curve."""
    chance = random.Random(1)
    x = y = 0.0
    with path.open("w", encoding="utf-8") as file:
        file.write("G261\nG01 X0 Y0 F6000\n")
        for number in range(lines):
            x += chance.uniform(0.1, 0.3) * (1 if number // 400 % 2 else -1)
            y += chance.uniform(-0.02, 0.02)
            file.write(f"N{number} G01 X{x:.3f} Y{y:.3f}\n")
        file.write("M30\n")


@dataclass(frozen=True, slots=True)
class Cost:
    """How long something took, and how long processors worked for it, in seconds."""

    passed_s: float
    worked_s: float


class Meter:
    """Measures what a session does, in its own process and in those of its controllers."""

    def __init__(self) -> None:
        self._controllers_s = 0.0

    @contextmanager
    def installed(self) -> Iterator[None]:
        """Count what controllers work between a request and its answer."""
        ask = RemoteEngine.ask

        def counted(engine: RemoteEngine, request: str, *words: Any) -> Any:
            before_s = _worked_s(engine.process)
            try:
                return ask(engine, request, *words)
            finally:
                self._controllers_s += max(0.0, _worked_s(engine.process) - before_s)

        RemoteEngine.ask = counted  # type: ignore[method-assign, assignment]
        try:
            yield
        finally:
            RemoteEngine.ask = ask  # type: ignore[method-assign]

    def cost(self, method: Callable[[], object]) -> Cost:
        """Return what a method takes."""
        self._controllers_s = 0.0
        begin_s, worked_s = time.perf_counter(), time.process_time()
        method()
        passed_s = time.perf_counter() - begin_s
        return Cost(passed_s, time.process_time() - worked_s + self._controllers_s)


@functools.lru_cache(256)
def _statistics(process: int) -> IO[bytes]:
    """Return the open file about a process: to open it takes longer than a search in the record."""
    return Path(f"/proc/{process}/schedstat").open("rb", buffering=0)


def _worked_s(process: int) -> float:
    """Return how long a process has had a processor; 0 where that cannot be seen."""
    try:
        return int(os.pread(_statistics(process).fileno(), 64, 0).split()[0]) / 1e9
    except OSError:
        return 0.0


def described(name: str, costs: list[Cost]) -> str:
    """Return some costs as text."""
    passed = sorted(1000.0 * one.passed_s for one in costs)
    worked = sorted(1000.0 * one.worked_s for one in costs)
    return (
        f"{name} {statistics.median(passed):.0f} ms, at most {passed[-1]:.0f} ms "
        f"(processor {statistics.median(worked):.0f} ms, at most {worked[-1]:.0f} ms)"
    )


def steps(session: Session, meter: Meter, blocks: list[Cost], ticks: list[Cost]) -> None:
    """Measure some steps back, by blocks and by ticks in turn."""
    for _ in range(3):
        blocks.append(meter.cost(session.previous_block))
        ticks.append(meter.cost(session.back))


def searched(session: Session, meter: Meter, run: Callable[[], object], lines: int) -> float:
    """Return the speed of a search that runs all again, as a share of ``run``: of pairs in turn."""
    shares = []
    for _ in range(7 if lines <= 20_000 else 1):
        ran = meter.cost(run)
        again = meter.cost(lambda: session.back_to(RUN_AGAIN))
        shares.append(ran.worked_s / again.worked_s)
    return statistics.median(shares)


def measure(path: Path, lines: int, ticks: int) -> None:
    """Measure one length of a program and print it."""
    write_program(path, lines)
    meter = Meter()
    with meter.installed(), Session(path, until="24 h") as session:
        there = meter.cost(lambda: session.run(f"{ticks} ticks"))
        latest = session.tick
        controller = Controller()

        def run_again() -> None:
            controller.run(path, ticks=latest, blocks=True, memory_trace=False, until="24 h")

        run = meter.cost(run_again)
        print(f"{lines:,} lines, {latest:,} ticks: run {run.worked_s:.2f} s of a processor", end="")
        print(f", a session at {run.worked_s / there.worked_s:.2f} of its speed", flush=True)
        front: tuple[list[Cost], list[Cost]] = [], []
        steps(session, meter, *front)
        print(f"  at the front: back {described('by a block', front[0])}", flush=True)
        chance = random.Random(2)
        travel, blocks, single = list[Cost](), list[Cost](), list[Cost]()
        for part in chance.sample(range(PLACES), PLACES):
            tick = chance.randrange(latest * part // PLACES, latest * (part + 1) // PLACES)
            travel.append(meter.cost(partial(session.go_to, max(tick, latest // 50))))
            steps(session, meter, blocks, single)
        print(f"  in {PLACES} parts: back {described('by a block', blocks)}")
        print(f"    {described('by a tick', single)}; {described('anywhere', travel)}", flush=True)
        session.go_to(latest)
        share = searched(session, meter, run_again, lines)
        print(f"  a search that runs all again: {share:.2f} of run")
        for stop in RECORDED:  # a tenth of a millisecond in a short program: the best of many
            worked_s = min(meter.cost(partial(session.back_to, stop)).worked_s for _ in range(20))
            print(f"  in the record, {stop}: {latest / worked_s / 1e6:.0f} million ticks/s")


def main() -> None:
    """Print the measurements."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("lines", type=int, nargs="*", default=LINES)
    parser.add_argument("--ticks", type=int, default=80_000_000)
    words = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        for lines in words.lines:
            measure(Path(folder) / "long.nc", lines, words.ticks)


if __name__ == "__main__":
    main()
