# SPDX-License-Identifier: MIT
"""``python -m benchmarks.fmu``: what a step of co-simulation costs, on both sides of FMI.

FMU in: a small model in C coupled to a run, in this process and in a separate one, compared with
the same run without it. FMU out: a cell in FMPy, ticks of 1 ms, over the same ticks of a run; and
the small model in FMPy, whose step does nothing: that is FMPy's own share. The best of many short
rounds counts, since other work on the machine only ever adds time. ``--hour``: 3,600 s of
co-simulation in FMPy, with the memory of the process each ten minutes.
"""

from __future__ import annotations

import argparse
import platform
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))
from fmpy import extract, read_model_description
from fmpy.fmi2 import FMU2Slave
from fmpy.fmi3 import FMU3Slave
from support.small_fmus import build_library, description, write_fmu

from nctakt.base.mode import is_compiled
from nctakt.cli import main as nctakt
from nctakt.fmu import Fmu
from nctakt.run.controller import Controller, NcText

#: To and fro endlessly.
PROGRAM = "$FOR P1 = 1, 100000, 1\nG01 X100 Y20 F6000\nG01 X0 Y0\n$ENDFOR\nM30\n"
STEPS, ROUNDS, TICK_S = 50, 400, 0.001
TEN_MINUTES = 600_000
TIES: dict[str, Any] = {"inputs": {"u": "X.ACS.ACT_POS"}, "outputs": {"y": "V.E.VALUE"}}


def best(round_of: Callable[[], float]) -> float:
    """Return the least time of several rounds, in µs a step."""
    return min(round_of() for _ in range(ROUNDS)) / STEPS * 1e6


def run_of(fmu: Fmu | None) -> Callable[[], float]:
    """Return what advances a run by a round and returns its seconds, without the start-up."""
    run = Controller().begin(
        {1: [NcText("part.nc", PROGRAM)]}, fmu=fmu, memory_trace=False, until="1000 s"
    )
    run.advance(1000)
    end = 1000

    def advance() -> float:
        nonlocal end
        end += STEPS
        begin = time.perf_counter()
        run.advance(end)
        return time.perf_counter() - begin

    return advance


def model_of(file: Path, folder: Path) -> Any:
    """Return an FMU in FMPy, initialised."""
    said = read_model_description(file, validate=False)
    is_two = said.fmiVersion == "2.0"
    model = (FMU2Slave if is_two else FMU3Slave)(
        guid=said.guid,
        unzipDirectory=extract(str(file), unzipdir=str(folder)),
        modelIdentifier=said.coSimulation.modelIdentifier,
        instanceName="one",
    )
    model.instantiate()
    if is_two:
        model.setupExperiment(startTime=0.0)
    model.enterInitializationMode()
    model.exitInitializationMode()
    return model


def steps_of(model: Any) -> Callable[[], float]:
    """Return what makes a round of steps and returns its seconds."""
    done = 0

    def advance() -> float:
        nonlocal done
        begin = time.perf_counter()
        for step in range(done, done + STEPS):
            model.doStep(step * TICK_S, TICK_S)
        done += STEPS
        return time.perf_counter() - begin

    return advance


def memory_mb() -> float:
    """Return the resident memory of this process."""
    pages = int(Path("/proc/self/statm").read_text("ascii").split()[1])
    return pages * 4096 / 1e6


def an_hour(file: Path, folder: Path) -> None:
    """Print the memory in each ten minutes of an hour of steps of a tick."""
    model = model_of(file, folder)
    for step in range(6 * TEN_MINUTES + 1):
        if step % TEN_MINUTES == 0:
            print(f"  {step // 60_000:3d} min: {memory_mb():.1f} MB", flush=True)
        model.doStep(step * TICK_S, TICK_S)
    model.terminate()
    model.freeInstance()


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--hour", action="store_true")
    given = parser.parse_args()
    print(f"{platform.python_version()}, {'compiled' if is_compiled() else 'plain'}")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "part.nc").write_text(PROGRAM, "utf-8")
        tick = best(run_of(None))
        print(f"a tick: {tick:.2f} µs")
        for version in (2, 3):
            small = write_fmu(
                folder / f"small{version}.fmu",
                description(version),
                build_library(version, folder),
            )
            cell = folder / f"cell{version}.fmu"
            nctakt(["fmu", str(folder / "part.nc"), "--fmi", str(version), "-o", str(cell)])
            inside = best(run_of(Fmu(small, **TIES))) - tick
            apart = best(run_of(Fmu(small, isolate=True, **TIES))) - tick
            own = best(steps_of(model_of(small, folder / f"s{version}")))
            out = best(steps_of(model_of(cell, folder / f"c{version}")))
            print(
                f"FMI {version}.0: FMU in, beyond the tick: {inside:.1f} µs in this process, "
                f"{apart:.1f} µs isolated\n"
                f"         FMU out, a step of a tick: {out:.1f} µs; of it FMPy {own:.1f} µs, "
                f"so beyond tick and FMPy {out - own - tick:.1f} µs"
            )
        if given.hour:
            print("an hour of co-simulation, FMI 3.0, resident memory:")
            an_hour(folder / "cell3.fmu", folder / "hour")


if __name__ == "__main__":
    main()
