# SPDX-License-Identifier: MIT
"""``python -m benchmarks.live [SECONDS [MINUTES]]``: what a session and its page cost.

- A session at full speed with a listener of 12 signals at 20 Hz beside ``Controller.run`` of the
  same program without a trace, in turn: at least 90 % of its speed.
- A step back by one tick in a run of ten minutes with 100,000 blocks: the first at most 2 s, the
  others at most 100 ms.
- 1 ms ticks on the wall clock for ``SECONDS`` (60) in slices of 10 ms: late slices, and the
  lateness beside that of a thread that only sleeps.
- A tape of a run with a PLC that writes in each tick: at most 5 % of the run.
- The page in a browser for ``SECONDS`` on the wall clock and ``MINUTES`` (10) in all: see
  ``live_page.py``.
"""

from __future__ import annotations

import statistics
import sys
import tempfile
import threading
import time
from pathlib import Path

from benchmarks.live_page import measure_page
from nctakt import Controller, NcText, Plc
from nctakt.run.access.tape import TapeWriter
from nctakt.run.plcs.plc_view import PlcView
from nctakt.session.core import SessionCore
from nctakt.session.session import Session
from nctakt.session.setup import Setup

TICKS = 10_000_000
REPEATS = 5
SIGNALS = 12

_CYCLES = """\
#RT CYCLE [ID=1 SCOPE=PROG]
  $IF EDGE V.RTA.ACS.ACT_POS.X > 50
    V.E.COUNT += 1
  $ENDIF
#RT CYCLE END
"""


def oscillating(blocks: int, feed: int = 6000) -> NcText:
    """A program of straight blocks with a realtime cycle."""
    lines = [f"G01 X{100 * (number % 2)} Y{number % 7} F{feed}" for number in range(blocks)]
    return NcText("part.nc", _CYCLES + "\n".join(lines) + "\nM30")


def measure_speed() -> None:
    """Print the speed of sessions compared with that of runs."""
    program = oscillating(12_000)
    runs, sessions = [], []
    for _ in range(REPEATS):
        controller = Controller()
        begin = time.perf_counter()
        controller.run(program, ticks=TICKS, memory_trace=False, blocks=True)
        runs.append(TICKS / (time.perf_counter() - begin))
        with Session(program, until=f"{TICKS} ticks") as session:
            names = list(session.description.signals)[:SIGNALS]
            with session.listen(*names, rate_hz=20.0, events=False) as listener:
                begin = time.perf_counter()
                session.play()
                while session.is_playing:
                    listener.take(0.05)
                sessions.append(session.tick / (time.perf_counter() - begin))
    ratio = statistics.median(one / other for one, other in zip(sessions, runs, strict=True))
    print(f"run:                        {statistics.median(runs):12,.0f} ticks/s")
    print(f"session with a listener:    {statistics.median(sessions):12,.0f} ticks/s = {ratio:.2f}")


def measure_back() -> None:
    """Print how long a step back takes."""
    program = oscillating(100_000, 100_000)
    core = SessionCore(Setup({1: [program]}, options={"until": "20 min"}))
    try:
        while core.tick < 600_000 and not core.is_over:
            core.run(min(core.tick + 20_000, 600_000))
        steps = []
        for _ in range(20):
            begin = time.perf_counter()
            core.back()
            steps.append(1000 * (time.perf_counter() - begin))
        print(f"first step back of {core.branch.latest} ticks: {steps[0]:8.0f} ms")
        others = f"{statistics.median(steps[1:]):8.1f} {max(steps[1:]):8.1f}"
        print(f"others, median and worst:   {others} ms")
        begin = time.perf_counter()
        core.go_to(core.branch.latest)
        print(f"to the front:               {1000 * (time.perf_counter() - begin):8.0f} ms")
    finally:
        core.close()


def measure_wall_clock(seconds: float) -> None:
    """Print the lateness of slices, and that of a thread that only sleeps."""
    own: list[float] = []

    def sleep() -> None:
        due = time.monotonic()
        ends = due + seconds
        while due < ends:
            due += 0.010
            time.sleep(max(0.0, due - time.monotonic()))
            own.append(1000 * (time.monotonic() - due))

    with Session(oscillating(4000), until="1 h") as session:
        thread = threading.Thread(target=sleep)
        thread.start()
        session.play(1.0)
        thread.join()
        late, worst_s = session.lateness
        ticks = session.tick
        session.pause()
    own.sort()
    lateness = f"late slices {late}, worst {1000 * worst_s:.1f} ms"
    print(f"wall clock: {ticks} ticks in {seconds:.0f} s, {lateness}")
    p99 = own[int(0.99 * len(own))]
    print(f"a thread that only sleeps:  p99 {p99:.1f} ms, worst {own[-1]:.1f} ms")


class _Writer(Plc):
    """A PLC that writes in each tick."""

    def cycle(self, hli: PlcView) -> None:
        hli.write("V.E.COUNT", hli.time_us // 1000 % 1000)


def measure_tape() -> None:
    """Print what a tape costs."""
    program = oscillating(60)
    ratios = []
    with tempfile.TemporaryDirectory() as folder:
        for number in range(REPEATS):
            begin = time.perf_counter()
            Controller().run(program, plc=_Writer(), memory_trace=False)
            without = time.perf_counter() - begin
            with (Path(folder) / f"{number}.tape").open("w", encoding="utf-8") as file:
                writer = TapeWriter(file.write, {}, {}, True)
                begin = time.perf_counter()
                Controller().run(
                    program, plc=_Writer(), memory_trace=False, sinks=[writer], record=writer.note
                )
                ratios.append((time.perf_counter() - begin) / without)
    print(f"with a tape:                {statistics.median(ratios):8.2f} × the run")


def main() -> None:
    """Measure all."""
    seconds = float(sys.argv[1]) if len(sys.argv) > 1 else 60.0
    minutes = float(sys.argv[2]) if len(sys.argv) > 2 else 10.0
    measure_speed()
    measure_back()
    measure_wall_clock(seconds)
    measure_tape()
    measure_page(seconds, minutes)


if __name__ == "__main__":
    main()
