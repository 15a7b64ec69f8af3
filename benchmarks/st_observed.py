# SPDX-License-Identifier: MIT
"""``python -m benchmarks.st_observed``: what it costs to look into a PLC in Structured Text.

- Coverage, and coverage with ``why``, beside the same run without: at most 1.5 times as long, of
  ``examples/cell`` with its program. The same of a PLC alone, whose 20 blocks do nothing else but
  what is counted, is the most that it can cost.
- A step back through the code of the PLC, into calls and over them: at most 100 ms.
- 1,000 unit tests of 100 cycles each by ``nctakt test``, with the start of the process: at most
  20 s on one core; with ``-j 2`` 1.8 times as fast, by the clock. One process starts and reads,
  so that is measured where the code under test takes long, too. Of pytest's plugins only those
  run that are needed.

All other figures are times of the processor, of all processes together: what other work on the
machine takes away is not in them. Runs that are compared take turns, and the best of each counts.
The invented PLC has 20 blocks with methods, conditions, loops and arrays, and no natives.
"""

from __future__ import annotations

import os
import platform
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path

from nctakt.base.mode import is_compiled
from nctakt.plc.structured_text import load_structured
from nctakt.run.controller import Controller, NcText
from nctakt.session.session import Session

TURNS, TICKS, CELL_TICKS = 5, 40_000, 200_000
CELL = Path(__file__).parent.parent / "examples" / "cell"
STEPS = 40
TESTS, CYCLES, SUITES = 1000, 100, ("first.st", "second.st")
#: How often code under test repeats a statement in a cycle, so that all take nearly 20 s.
REPEATS = 16_000

BLOCK = """\
FUNCTION_BLOCK FB_Gate
VAR_INPUT bGo : BOOL; END_VAR
VAR_INPUT nCount : INT; END_VAR
VAR nState, i : INT; fWay : LREAL; aTimes : ARRAY[0..9] OF INT; END_VAR
METHOD Advance : BOOL
VAR_INPUT nBy : INT; END_VAR
fWay := fWay + nBy * 0.125;
IF fWay > 100.0 AND nBy > 0 THEN
    fWay := 0.0;
    Advance := TRUE;
END_IF
END_METHOD
CASE nState OF
    0: IF bGo THEN nState := 1; END_IF
    1: IF Advance(3) THEN nState := 2; nCount := nCount + 1; END_IF
    2: FOR i := 0 TO 9 DO aTimes[i] := aTimes[i] + i; END_FOR
       nState := 0;
END_CASE
END_FUNCTION_BLOCK
PROGRAM MAIN
VAR aGates : ARRAY[1..20] OF FB_Gate; i, n : INT; END_VAR
n := n + 1;
FOR i := 1 TO 20 DO
    aGates[i](bGo := (n + i) MOD 7 <> 0);
    IF aGates[i].nCount > 1000 THEN aGates[i].nCount := 0; END_IF
END_FOR
END_PROGRAM
CONFIGURATION Cell RESOURCE Controller ON PLC
TASK Fast(INTERVAL := T#1MS, PRIORITY := 1); PROGRAM Main1 WITH Fast : MAIN;
END_RESOURCE END_CONFIGURATION
"""
NC = f"G04 X{TICKS / 1000}\nM30\n"


def processor_s() -> float:
    """Return how long this process and those that it has started have computed."""
    own = resource.getrusage(resource.RUSAGE_CHILDREN)
    started = _started(str(os.getpid()))
    return time.process_time() + own.ru_utime + own.ru_stime + sum(map(_computed_s, started))


def _started(process: str) -> list[str]:
    """Return the processes that one has started, and those that they have, as far as they run."""
    lists = Path(f"/proc/{process}/task").glob("*/children")
    own = [one for path in lists for one in path.read_text("ascii").split()]
    return [*own, *(one for child in own for one in _started(child))]


def _computed_s(process: str) -> float:
    threads = Path(f"/proc/{process}/task").glob("*/schedstat")
    return sum(int(path.read_text("ascii").split()[0]) for path in threads) / 1e9


def took(action: Callable[[], object]) -> float:
    """Return how long an action computes."""
    begin = processor_s()
    action()
    return processor_s() - begin


def observed(path: Path, program: NcText | Path, ticks: int, goal: str) -> None:
    """Print what coverage and ``why`` add to a run."""

    def run(counts: bool, why: bool) -> None:
        plc = load_structured(path)
        if counts:
            plc.count_branches()
        Controller().run(program, plc=plc, ticks=ticks, why=why, signals=[])

    kinds = {"plain": (False, False), "coverage": (True, False), "coverage and why": (True, True)}
    times: dict[str, list[float]] = {name: [] for name in kinds}
    for _ in range(TURNS):
        for name, words in kinds.items():
            times[name].append(took(partial(run, *words)))
    plain = min(times.pop("plain"))
    print(f"{path.name}, {ticks:,} ticks: {plain:.2f} s")
    for name, own in times.items():
        print(f"  with {name}: {min(own):.2f} s, {min(own) / plain:.2f} times{goal}")


def steps_back(path: Path) -> None:
    """Print how long steps back through the code take."""
    with Session(NcText("part.nc", NC), plc=path) as session:
        session.run("10 s")
        session.step_statement()
        for step in ("into", "over"):
            times = []
            for _ in range(STEPS):
                begin = time.perf_counter()
                used = took(partial(session.step_statement_back, step))
                times.append((used, time.perf_counter() - begin))
            used_s, passed_s = zip(*times, strict=True)
            print(
                f"a step back {step}: {1000 * statistics.median(used_s):.1f} ms of the processor "
                f"in the median, {1000 * max(used_s):.1f} ms at most (goal 100), "
                f"{1000 * statistics.median(passed_s):.1f} ms passed"
            )


def unit_tests(folder: Path) -> None:
    """Print how long unit tests in two files take, of little and of much code under test."""
    environment = {**os.environ, "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1"}
    environment.pop("PYTHONDONTWRITEBYTECODE", None)
    (folder / "pytest.ini").write_text("[pytest]\n", "utf-8")
    words = [sys.executable, "-m", "nctakt", "test", *SUITES]
    options = ["--", "-q", "--no-header", "-p", "no:cacheprovider", "-p", "nctakt.testing.plugin"]

    def run(processes: int = 1) -> None:
        done = subprocess.run(
            [*words, "-j", str(processes), *options],
            cwd=folder,
            env=environment,
            capture_output=True,
            text=True,
            check=False,
        )
        assert f"{TESTS} passed" in done.stdout, done.stdout + done.stderr

    for repeats, code in ((1, "little"), (REPEATS, "much")):
        for name in SUITES:
            (folder / name).write_text(suite_text(repeats), "utf-8")
        run()  # writes what Python keeps of the modules
        print(f"{TESTS:,} unit tests of {CYCLES} cycles with {code} code: ", end="")
        print(f"{took(run):.1f} s (goal 20)")
        passed = []
        for processes in (1, 2):
            begin = time.perf_counter()
            run(processes)
            passed.append(time.perf_counter() - begin)
        print(f"  with two processes {passed[0] / passed[1]:.2f} times as fast (goal 1.8)")


def suite_text(repeats: int) -> str:
    """Return half of the unit tests, whose code under test repeats something in each cycle."""
    tests = "".join(
        f"METHOD Test{number}\nVAR_INST nCycle, i : INT; nSum : DWORD; END_VAR\n"
        f"TEST('test {number}');\nnCycle := nCycle + 1;\n"
        f"FOR i := 1 TO {repeats} DO nSum := nSum XOR i; END_FOR\n"
        "AssertTrue(nCycle > 0, 'counts');\n"
        f"IF nCycle = {CYCLES} THEN TEST_FINISHED(); END_IF\nEND_METHOD\n"
        for number in range(TESTS // 2)
    )
    calls = "".join(f"Test{number}();\n" for number in range(TESTS // 2))
    return (
        f"FUNCTION_BLOCK FB_Suite EXTENDS FB_TestSuite\n{tests}{calls}END_FUNCTION_BLOCK\n"
        "PROGRAM MAIN VAR fbSuite : FB_Suite; END_VAR TcUnit.RUN(); END_PROGRAM\n"
        "CONFIGURATION Cell RESOURCE Controller ON PLC TASK Slow(INTERVAL := T#100MS); "
        "PROGRAM Main1 WITH Slow : MAIN; END_RESOURCE END_CONFIGURATION\n"
    )


def main() -> None:
    """Measure and print."""
    print(f"{platform.machine()}, Python {platform.python_version()}, compiled: {is_compiled()}")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        observed(CELL / "cell.st", CELL / "part.nc", CELL_TICKS, " (goal 1.5)")
        path = folder / "blocks.st"
        path.write_text(BLOCK, "utf-8")
        observed(path, NcText("part.nc", NC), TICKS, "")
        steps_back(path)
        path.unlink()
        unit_tests(folder)


if __name__ == "__main__":
    main()
