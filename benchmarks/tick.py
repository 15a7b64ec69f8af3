# SPDX-License-Identifier: MIT
"""``python -m benchmarks.tick``: what a tick and an elementary instruction cost.

Everything is measured in one run, together with the same arithmetic as a C loop compiled with -O2,
since wall-clock figures differ from machine to machine and hour to hour: the ratios count. The
cycles are control laws: chains in which each statement needs what the one before has written,
closed over the ticks, as in a filter or a controller.

Other work on the machine only ever adds time. So both sides run in slices of less than a
millisecond, after the start-up, and the best slice is taken.
"""

from __future__ import annotations

import platform
import shutil
import subprocess
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

from nctakt.base.mode import is_compiled
from nctakt.results.trace.sinks import CsvSink
from nctakt.run.controller import Controller, NcText

REPEATS = 5
SLICES = 500


@dataclass(frozen=True, slots=True)
class Law:
    """One control law: the body of a realtime cycle, and the same in C over the cells ``c``."""

    name: str
    body: str
    c: str


LAWS = (
    Law(
        "filters (no library functions)",
        """
V.E.LIST[0] += 0.25 * [V.E.VALUE - V.E.LIST[2] - V.E.LIST[0]]
V.E.LIST[1] += 0.25 * [V.E.LIST[0] - V.E.LIST[1]]
V.E.LIST[2] += 0.25 * [V.E.LIST[1] - V.E.LIST[2]]
""",
        """
c[0] = c[0] + 0.25 * (c[9] - c[2] - c[0]);
c[1] = c[1] + 0.25 * (c[0] - c[1]);
c[2] = c[2] + 0.25 * (c[1] - c[2]);
""",
    ),
    Law(
        "controller (library functions)",
        """
V.E.LIST[0] = V.E.VALUE - V.E.LIST[2]
V.E.LIST[1] += 0.01 * V.E.LIST[0] * SIN[30 * V.E.LIST[0]]
$IF V.E.LIST[1] > 100
  V.E.LIST[1] = 100
$ENDIF
V.E.LIST[2] = SQRT[ABS[V.E.LIST[0] + V.E.LIST[1]]] / 2
""",
        """
c[0] = c[9] - c[2];
c[1] = c[1] + 0.01 * c[0] * sin(30.0 * c[0] * 0.017453292519943295);
if (c[1] > 100.0) c[1] = 100.0;
c[2] = sqrt(fabs(c[0] + c[1])) / 2.0;
""",
    ),
    # the most that the probes of conditions cost: none is ever true, so each keeps a nearest miss
    Law(
        "limits never reached",
        """
V.E.LIST[0] += 0.25 * [V.E.VALUE - V.E.LIST[2] - V.E.LIST[0]]
$IF V.E.LIST[0] > 100
  V.E.LIST[0] = 100
$ENDIF
V.E.LIST[1] += 0.25 * [V.E.LIST[0] - V.E.LIST[1]]
$IF V.E.LIST[1] < V.E.LIST[2] - 100
  V.E.LIST[1] = 0
$ENDIF
V.E.LIST[2] += 0.25 * [V.E.LIST[1] - V.E.LIST[2]]
$IF V.E.LIST[2] == 100
  V.E.LIST[2] = 0
$ENDIF
""",
        """
c[0] = c[0] + 0.25 * (c[9] - c[2] - c[0]);
if (c[0] > 100.0) c[0] = 100.0;
c[1] = c[1] + 0.25 * (c[0] - c[1]);
if (c[1] < c[2] - 100.0) c[1] = 0.0;
c[2] = c[2] + 0.25 * (c[1] - c[2]);
if (c[2] == 100.0) c[2] = 0.0;
""",
    ),
)

_C = """
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
static void __attribute__((noinline)) law(double *c) {{ {body} }}
int main(int argc, char **argv) {{
    long cycles = atol(argv[1]), ticks = atol(argv[2]), slices = atol(argv[3]);
    static double c[16];
    struct timespec a, b;
    double best = 1e9;
    c[9] = 1.0;
    for (long s = 0; s < slices; s++) {{
        clock_gettime(CLOCK_MONOTONIC, &a);
        for (long t = 0; t < ticks; t++)
            for (long i = 0; i < cycles; i++) law(c);
        clock_gettime(CLOCK_MONOTONIC, &b);
        double seconds = (b.tv_sec - a.tv_sec) + 1e-9 * (b.tv_nsec - a.tv_nsec);
        if (seconds < best) best = seconds;
    }}
    printf("%.12f %.17g\\n", best, c[2]);
    return 0;
}}
"""


def ns_per_tick(program: str, ticks: int) -> tuple[float, float]:
    """The best time of a tick in ns, in slices of this many; the elementary instructions in it."""
    best, steps = 1e9, 0.0
    for _ in range(REPEATS):
        controller = Controller()
        controller.write("V.E.VALUE", 1.0)
        controller.start(NcText("benchmark.nc", program))
        controller.step(1000)
        for _ in range(SLICES):
            begin = time.perf_counter()
            controller.step(ticks)
            best = min(best, time.perf_counter() - begin)
        assert controller.state == "running", controller.diagnostics
        steps = controller.instructions_in_tick
    return best / ticks * 1e9, steps


def ns_per_recorded_tick(program: str, ticks: int, signals: list[str]) -> float:
    """The best time of a tick in ns, the record in memory included, after the start-up."""
    best = {1: 1e9, ticks: 1e9}
    for count in 4 * REPEATS * tuple(best):
        controller = Controller()
        text = NcText("benchmark.nc", program)
        begin = time.perf_counter()
        run = controller.run(text, ticks=count, signals=signals, record_writes=False)
        best[count] = min(best[count], time.perf_counter() - begin)
        assert run.state == "limit", run.diagnostics
    return (best[ticks] - best[1]) / (ticks - 1) * 1e9


def program(law: Law, cycles: int, motion: str) -> str:
    """This many cycles with the law's body, then a motion or dwell longer than the measurement."""
    begin, end = "#RT CYCLE [SCOPE = PROG]", "#RT CYCLE END\n"
    return f"{begin}{law.body}{end}" * cycles + motion + "\nM30\n"


def c_ns_per_tick(law: Law, folder: Path, cycles: int, ticks: int) -> float | None:
    """ns of the same arithmetic in C; ``None`` without a compiler."""
    compiler = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")
    if compiler is None:
        return None
    source, binary = folder / "law.c", folder / "law"
    source.write_text(_C.format(body=law.c), "utf-8")
    flags = ["-O2", "-ffp-contract=off", "-o", str(binary), str(source), "-lm"]
    subprocess.run([compiler, *flags], check=True)
    words = [str(binary), str(cycles), str(ticks), str(SLICES)]
    output = subprocess.run(words, check=True, capture_output=True, text=True).stdout
    return float(output.split()[0]) / ticks * 1e9


def instructions() -> None:
    """ns per elementary instruction, for 1, 2 and 50 cycles, compared with C."""
    dwell = "#TIME 100000"
    idle, _ = ns_per_tick(dwell + "\nM30\n", 5_000)
    print(f"idle tick: {idle:.1f} ns\n")
    print(f"{'cycles':32} {'instr.':>6} {'ns/tick':>9} {'ns/instr.':>9} {'C':>7} {'ratio':>6}")
    with tempfile.TemporaryDirectory() as name:
        for law in LAWS:
            for cycles in (1, 2, 50):
                ticks = 5_000 // cycles + 100
                tick, steps = ns_per_tick(program(law, cycles, dwell), ticks)
                each = (tick - idle) / steps
                in_c = c_ns_per_tick(law, Path(name), cycles, ticks)
                row = f"{cycles:3} × {law.name:26} {steps:6.0f} {tick:9.1f} {each:9.2f}"
                if in_c is not None:
                    row += f" {in_c / steps:7.3f} {each * steps / in_c:6.2f}"
                print(row)


def ticks() -> None:
    """ns per tick of three moving axes and two cycles, with and without a trace."""
    motion = "G01 X9000 Y9000 Z9000 F1"
    text = program(LAWS[0], 2, motion)
    names = ["X.ACS.ACT_POS", "Y.ACS.ACT_POS", "Z.ACS.ACT_POS", "X.ACS.CUR_POS"]
    names += ["Y.ACS.CUR_POS", "Z.ACS.CUR_POS", "PATH.SPEED", "OVERRIDE.VEL.TOTAL"]
    names += ["BLOCK", "CYCLES.ACTIVE", "V.E.LIST[0]", "V.E.LIST[1]"]
    print(f"\n{'3 axes moving, 2 cycles':40} {'ns/tick':>9} {'× real time at 1 ms':>20}")
    plain, _ = ns_per_tick(text, 3_000)
    print(f"{'without trace':40} {plain:9.1f} {1e6 / plain:20,.0f}")
    traced = ns_per_recorded_tick(text, 50_000, names)
    print(f"{'12 signals recorded in memory':40} {traced:9.1f} {1e6 / traced:20,.0f}")
    csv = csv_us_per_row(text, 100_000, names)
    print(f"{'12 signals to CSV':40} {csv * 1e3:9.1f} {1e3 / csv:20,.0f}   {csv:.2f} µs a row")


def csv_us_per_row(text: str, count: int, names: list[str]) -> float:
    """µs per CSV row, formatting and writing included."""
    best = 1e9
    for _ in range(REPEATS):
        with tempfile.TemporaryDirectory() as name:
            path = Path(name, "trace.csv")
            controller = Controller()
            begin = time.perf_counter()
            with path.open("w", encoding="utf-8", newline="\n") as file:
                sink = CsvSink(file)
                controller.run(
                    NcText("benchmark.nc", text),
                    ticks=count,
                    signals=names,
                    sinks=[sink],
                    memory_trace=False,
                    record_writes=False,
                )
            best = min(best, (time.perf_counter() - begin) / count * 1e6)
    return best


def main() -> None:
    """Print all tables."""
    form = "compiled" if is_compiled() else "plain"
    print(f"Python {platform.python_version()}, {platform.machine()}, {form}\n")
    if not is_compiled():
        print("the realtime part is not compiled: the figures below are not what is promised")
    instructions()
    ticks()


if __name__ == "__main__":
    main()
