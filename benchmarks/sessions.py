# SPDX-License-Identifier: MIT
"""``python -m benchmarks.sessions [LINES …]``: how long it takes to go back in long programs.

For programs of 2,000, 20,000, 200,000 and 1,000,000 lines, each lived through to its end or for
``--ticks``:

- the way there, against ``run``;
- a step back by a block, and by a tick, from random places: at most 100 ms; and how often the
  machine was given away meanwhile, since other work makes the longest ones;
- a search backward that runs everything again, against ``run``: at least 0.8;
- a search backward in the record: at least 20 million ticks a second.
"""

from __future__ import annotations

import argparse
import random
import statistics
import tempfile
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path

from nctakt import Controller
from nctakt.session.session import Session

LINES = (2_000, 20_000, 200_000, 1_000_000)
PLACES = 12


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


def seconds(method: Callable[[], object]) -> float:
    """Return how long something takes."""
    begin_s = time.perf_counter()
    method()
    return time.perf_counter() - begin_s


def described(name: str, found_s: list[float]) -> str:
    """Return some times as text."""
    found_ms = sorted(1000 * one for one in found_s)
    return f"{name} {statistics.median(found_ms):.0f} ms, at most {found_ms[-1]:.0f} ms"


def measure(path: Path, lines: int, ticks: int) -> None:
    """Measure one length of a program and print it."""
    write_program(path, lines)
    with Session(path) as session:
        there_s = seconds(lambda: session.run(f"{ticks} ticks"))
        latest = session.tick
        controller = Controller()
        run_s = seconds(lambda: controller.run(path, ticks=latest, blocks=True, memory_trace=False))
        print(f"{lines:,} lines, {latest:,} ticks: run {run_s:.2f} s", end="")
        print(f", a session {there_s:.2f} s ({run_s / there_s:.2f} of its speed)", flush=True)
        chance = random.Random(2)
        blocks_s, ticks_s, travel_s = [], [], []
        for _ in range(PLACES):
            tick = chance.randrange(latest // 20, latest)
            travel_s.append(seconds(partial(session.go_to, tick)))
            for _ in range(3):
                blocks_s.append(seconds(session.previous_block))
                ticks_s.append(seconds(session.back))
        print(
            f"  back {described('by a block', blocks_s)}; {described('by a tick', ticks_s)}", end=""
        )
        print(f"; {described('anywhere', travel_s)}", flush=True)
        session.go_to(latest)
        search_s = seconds(lambda: session.back_to("V.RTA.ACS.ACT_POS.X > 1000000"))
        print(
            f"  a search that runs all again {search_s:.2f} s: {run_s / search_s:.2f} of run",
            end="",
        )
        record_s = min(seconds(lambda: session.back_to("message")) for _ in range(3))
        print(f"; in the record {latest / record_s / 1e6:.0f} million ticks/s", flush=True)


def main() -> None:
    """Print the measurements."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("lines", type=int, nargs="*", default=LINES)
    parser.add_argument("--ticks", type=int, default=100_000_000)
    words = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        for lines in words.lines:
            measure(Path(folder) / "long.nc", lines, words.ticks)


if __name__ == "__main__":
    main()
