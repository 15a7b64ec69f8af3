# SPDX-License-Identifier: MIT
"""``python -m benchmarks.st_cycle``: what the cycle of a PLC in Structured Text costs.

Everything is measured in one run, together with the same loops in C compiled with -O2 with the same
checks (bounds of arrays, a bound on instructions), since wall-clock figures differ from machine to
machine and hour to hour: the ratios count. Other work on the machine only ever adds time, so both
sides run in slices and the best slice is taken.

``--ticks N --only WORD`` runs N ticks of the one program whose name has WORD, nothing else: under
``valgrind --tool=callgrind`` the difference of two runs is what a cycle costs in instructions,
whatever else the machine does.
"""

from __future__ import annotations

import argparse
import platform
import shutil
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

from nctakt.base.mode import is_compiled
from nctakt.plc.structured_text import load_structured
from nctakt.run.controller import Controller, NcText

SLICES = 300
TASK = """
CONFIGURATION Cell RESOURCE Controller ON PLC
TASK Fast(INTERVAL := T#1MS, PRIORITY := 1);
PROGRAM Main1 WITH Fast : MAIN;
END_RESOURCE END_CONFIGURATION
"""


@dataclass(frozen=True, slots=True)
class Loop:
    """A body of MAIN, and the same in C; both have it ``times`` in a cycle."""

    name: str
    variables: str
    body: str
    c: str
    times: int = 1


LOOPS = (
    Loop(
        "filters (dependent chains of LREAL)",
        "a, b, c : LREAL; u : LREAL := 1.0;",
        "a := a + 0.25 * (u - c - a); b := b + 0.25 * (a - b); c := c + 0.25 * (b - c);",
        "r[0] += 0.25 * (1.0 - r[2] - r[0]); r[1] += 0.25 * (r[0] - r[1]);"
        " r[2] += 0.25 * (r[1] - r[2]); if (++steps > limit) return;",
        10,
    ),
    Loop(
        "loop over whole numbers and arrays",
        "i, s : DINT; v : ARRAY[0..99] OF DINT;",
        "FOR i := 0 TO 99 DO v[i] := v[i] + i; s := s + v[i]; END_FOR",
        "for (int i = 0; i <= 99; i++) { if (i < 0 || i > 99) return; v[i] = v[i] + i;"
        " s = s + v[i]; if ((steps += 3) > limit) return; }",
    ),
)

_C = """
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
static volatile long limit = 1L << 60;
static double r[3]; static int v[100]; static int s; static long steps;
static void __attribute__((noinline)) cycle(void) {{ {body} }}
int main(int argc, char **argv) {{
    long cycles = atol(argv[1]), slices = atol(argv[2]);
    struct timespec a, b; double best = 1e9;
    for (long k = 0; k < slices; k++) {{
        clock_gettime(CLOCK_MONOTONIC, &a);
        for (long i = 0; i < cycles; i++) cycle();
        clock_gettime(CLOCK_MONOTONIC, &b);
        double t = (b.tv_sec - a.tv_sec) + 1e-9 * (b.tv_nsec - a.tv_nsec);
        if (t < best) best = t;
    }}
    printf("%.12f %g\\n", best / cycles * 1e9, r[2] + s);
    return 0;
}}
"""


def started(plc_text: str | None, part: str = "G04 100000\nM30") -> Controller:
    """A controller that runs this PLC, or none, together with a program."""
    controller = Controller()
    plc = None
    with tempfile.TemporaryDirectory() as folder:
        if plc_text is not None:
            path = Path(folder) / "cell.st"
            path.write_text(plc_text + TASK, "utf-8")
            plc = load_structured(path)
    controller.start(NcText("benchmark.nc", part), plc=plc)
    controller.step(100)
    return controller


def ns_per_tick(plc_text: str | None, ticks: int, part: str = "G04 100000\nM30") -> float:
    """The best time of a tick in ns, with a PLC or without."""
    controller = started(plc_text, part)
    best = 1e9
    for _ in range(SLICES):
        begin = time.perf_counter()
        controller.step(ticks)
        best = min(best, time.perf_counter() - begin)
    return best / ticks * 1e9


def ns_in_c(body: str) -> float:
    """The best time of the same cycle in C."""
    with tempfile.TemporaryDirectory() as folder:
        source = Path(folder) / "cycle.c"
        source.write_text(_C.format(body=body), "utf-8")
        program = Path(folder) / "cycle"
        subprocess.run(["gcc", "-O2", source, "-o", program], check=True)
        done = subprocess.run([program, "2000", "300"], check=True, capture_output=True, text=True)
    return float(done.stdout.split()[0])


def program(variables: str, body: str) -> str:
    """MAIN with these variables and statements."""
    return f"PROGRAM MAIN\nVAR {variables} END_VAR\n{body}\nEND_PROGRAM\n"


def large_plc() -> str:
    """MAIN with ten timers and 500 statements of the usual kinds."""
    names = range(10)
    variables = [f"t{i} : TON; b{i} : BOOL; n{i} : INT; x{i} : LREAL;" for i in names]
    body = []
    for number in range(49):
        i, j = number % 10, (number + 1) % 10
        body += [
            f"n{i} := n{j} + 1;",
            f"x{i} := 0.5 * x{j} + n{i};",
            f"b{i} := n{i} > 10 AND NOT b{j};",
            f"IF b{i} THEN",
            f"n{j} := n{j} - {number};",
            "ELSE",
            f"n{j} := n{i} MOD 7;",
            "END_IF",
            f"x{j} := LIMIT(-1000.0, x{i}, 1000.0);",
            f"CASE n{i} OF 0: b{j} := TRUE; 1..5: b{j} := x{j} > 3.0; END_CASE",
            f"n{i} := SEL(b{i}, n{j}, {number});",
            f"b{j} := b{i} OR b{j};",
        ]
    body += [f"t{i}(IN := b{i}, PT := T#50MS);" for i in names]
    return program(" ".join(variables), "\n".join(body))


def only(word: str, ticks: int) -> None:
    """Run ticks of one program."""
    texts = {loop.name: program(loop.variables, loop.body * loop.times) for loop in LOOPS}
    texts |= {"500 statements": large_plc(), "without statements": program("n : INT;", ";")}
    (found,) = [text for name, text in texts.items() if word in name]
    started(found).step(ticks)


def main() -> int:
    """Print the figures, or run one program."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--ticks", type=int, help="run so many ticks of one program")
    parser.add_argument("--only", default="filters", help="the word in its name")
    asked = parser.parse_args()
    if asked.ticks:
        only(asked.only, asked.ticks)
        return 0
    print(f"{platform.machine()}, Python {platform.python_version()}, compiled: {is_compiled()}")
    idle = ns_per_tick(None, 2000)
    print(f"{'a tick without a PLC':45}{idle / 1000:8.2f} us")
    empty = ns_per_tick(program("n : INT;", ";"), 2000)
    print(f"{'a cycle without statements':45}{(empty - idle) / 1000:8.2f} us more")
    for loop in LOOPS:
        ours = ns_per_tick(program(loop.variables, loop.body * loop.times), 500) - empty
        if shutil.which("gcc") is None:
            print(f"{loop.name:45}{ours:8.0f} ns")
            continue
        native = ns_in_c(loop.c * loop.times)
        print(f"{loop.name:45}{ours:8.0f} ns, C {native:6.1f} ns: {ours / native:5.1f} x")
    large = ns_per_tick(large_plc(), 200) - idle
    print(f"{'500 statements, ten timers':45}{large / 1000:8.2f} us a cycle")
    moves = "N10 G01 X500 Y300 Z100 F2000\nN20 G01 X0 Y0 Z0\n" * 40 + "M30"
    moving = ns_per_tick(large_plc(), 200, moves)
    print(f"{'with it, three axes moving':45}{1e6 / moving:8.0f} x real time")
    return 0


if __name__ == "__main__":
    sys.exit(main())
