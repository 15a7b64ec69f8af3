# SPDX-License-Identifier: MIT
"""``python -m benchmarks.threads``: two controllers in two threads against one.

Ticks release the interpreter, all else holds it: building a controller, decoding, events, results.
Measured: the runs of two threads compared with those of one in the same time, with a controller
built for each run, and with one that is restored; and the share of the ticks of a short program,
which bounds the gain. Goal: 1.6 times the runs of one thread.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from pathlib import Path

from benchmarks.studies import LONG_WAY, share_of_ticks
from nctakt.run.controller import Controller, NcText

EXAMPLES = Path(__file__).parent.parent / "examples"
SHORT = (EXAMPLES / "crossing.nc").read_text("utf-8")
LINES = "".join(f"G01 X{number % 7} Y{number % 5} F6000\n" for number in range(2_000)) + "M30\n"
#: Name -> program, and how many runs a thread makes.
PROGRAMS = {
    "examples/crossing.nc": (NcText("part.nc", SHORT), 50),
    "2,000 short lines": (NcText("lines.nc", LINES), 10),
    "one line of 60,000 ticks": (NcText("line.nc", "G01 X6000 F6000\nM30\n"), 20),
}


def built(part: NcText, count: int) -> None:
    """Make runs, each on a new controller."""
    for _ in range(count):
        Controller().run(part)


def put_back(part: NcText, count: int) -> None:
    """Make runs on one controller."""
    with Controller().reusable() as controller:
        for _ in range(count):
            controller.run(part)


def seconds(
    function: Callable[[NcText, int], None], part: NcText, count: int, threads: int
) -> float:
    """How long this many threads take together."""
    several = [threading.Thread(target=function, args=(part, count)) for _ in range(threads)]
    begin = time.perf_counter()
    for thread in several:
        thread.start()
    for thread in several:
        thread.join()
    return time.perf_counter() - begin


def free_share(part: NcText, longer: NcText) -> tuple[float, float]:
    """The share of a run in which the interpreter is free, built anew and put back."""
    built(part, 2)
    new = share_of_ticks(lambda: Controller().run(part), lambda: Controller().run(longer))[1]
    with Controller().reusable() as controller:
        for one in (part, longer) * 3:
            controller.run(one)
        own = share_of_ticks(lambda: controller.run(part), lambda: controller.run(longer))[1]
    return new, own


def main() -> None:
    """Print a line for each program and each way to make its runs."""
    shares = free_share(NcText("part.nc", SHORT), NcText("p.nc", SHORT.replace("X500", LONG_WAY)))
    print("ticks of examples/crossing.nc take {:.0%} of a run, {:.0%} put back".format(*shares))
    for name, (part, count) in PROGRAMS.items():
        for function in (built, put_back):
            function(part, 2)
            found = []
            for _ in range(5):
                one = seconds(function, part, count, 1)
                found.append(2 * one / seconds(function, part, count, 2))
            print(
                f"{name}, {function.__name__}: {sorted(found)[2]:.2f} times one thread (goal 1.6)"
            )


if __name__ == "__main__":
    main()
