# SPDX-License-Identifier: MIT
"""``python -m benchmarks.plc``: the cost of a PLC in Python, compared with the run without one.

Three axes move and two realtime cycles run; everything is measured in one run of this module, in
slices of a few milliseconds that take turns, and the best slice of each counts, since wall-clock
figures differ from machine to machine and hour to hour: the differences and ratios count. Then
single accesses, and runs of 1,000 ticks in a study.
"""

from __future__ import annotations

import gc
import platform
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import nctakt.plc
from benchmarks.tick import LAWS, program
from nctakt.base.mode import is_compiled
from nctakt.run.controller import Controller, NcText
from nctakt.studies.runs.blocks import make_runs
from nctakt.studies.runs.shared_beginning import maker_of
from nctakt.studies.runs.study_runner import StudyRunner
from nctakt.studies.study import Study

SLICES = 200
TICKS = 2_000
MOTION = "G01 X9000 Y9000 Z9000 F600"

PLCS = {
    "declarative (at, on, when with a text, after)": """
from nctakt import Plc, after, at, on, when


class Declared(Plc):
    acknowledge = after("20 ticks")

    @at("0.5 s")
    def slow_down(self, hli):
        hli.override_pct = 50

    @when("V.RTA.ACS.ACT_POS.X > 4")
    def near_the_end(self, hli):
        hli.override_pct = 100

    @on("M100")
    def clamp(self, hli, function):
        hli.write("V.E.CONDITION", 1)
""",
    "cycle(self, hli): pass": """
class Idle:
    def cycle(self, hli):
        pass
""",
    "four lines": """
class FourLines:
    def cycle(self, hli):
        if hli.axis("X").command > 100:
            hli.override_pct = 80
        else:
            hli.override_pct = 100
        hli.write("V.E.VALUE", hli.tick % 7)
        hli.acknowledge_all()
""",
}

#: A run of 1,000 ticks.
SHORT = "#RT CYCLE [SCOPE=PROG]\n$IF ONCE V.RTA.ACS.ACT_POS.X > 40\nM100\n$ENDIF\n#RT CYCLE END\n"
SHORT += "G01 X97.4 Y97.4 F8263\nM30\n"


def loaded(folder: Path) -> dict[str, Path]:
    """Write each PLC into its own file and return the files by the names of the PLCs."""
    files = {}
    for number, (name, text) in enumerate(PLCS.items()):
        files[name] = folder / f"plc_{number}.py"
        files[name].write_text(text, "utf-8")
    return files


def ns_per_tick(files: dict[str, Path]) -> dict[str, float]:
    """Return the best time of a tick in ns, without a PLC (``""``) and with each of them."""
    text = program(LAWS[0], 2, MOTION)
    controllers = {}
    for name, file in {"": None, **files}.items():
        controller = Controller()
        plc = None if file is None else nctakt.plc.load_plc(file)
        controller.start(NcText("benchmark.nc", text), plc=plc)
        controller.step(1000)
        controllers[name] = controller
    best = dict.fromkeys(controllers, 1e9)
    for _ in range(SLICES):
        for name, controller in controllers.items():
            begin = time.perf_counter()
            controller.step(TICKS)
            best[name] = min(best[name], time.perf_counter() - begin)
    for controller in controllers.values():
        assert controller.state == "running", controller.diagnostics
    return {name: seconds / TICKS * 1e9 for name, seconds in best.items()}


def us_each(function: Callable[[int], Any], count: int = 2_000, repeats: int = 50) -> float:
    """Return the best time of one of ``count`` accesses in µs, the loop included."""
    best = 1e9
    for _ in range(repeats):
        begin = time.perf_counter()
        function(count)
        best = min(best, time.perf_counter() - begin)
    return best / count * 1e6


def accesses() -> None:
    """Print the times of single accesses."""
    controller = Controller()
    controller.start(NcText("benchmark.nc", program(LAWS[0], 2, MOTION)))
    controller.step(1000)
    position = controller.bind("V.RTA.ACS.ACT_POS.X")
    value = controller.bind("V.E.VALUE")

    def steps(count: int) -> None:
        for _ in range(count):
            controller.step(1)

    def reads(count: int) -> None:
        for _ in range(count):
            position.value  # noqa: B018 - it is the access that is measured

    def writes(count: int) -> None:
        for _ in range(count):
            value.value = 5.0

    def reads_by_name(count: int) -> None:
        for _ in range(count):
            controller.read("V.RTA.ACS.ACT_POS.X")

    def writes_by_name(count: int) -> None:
        for _ in range(count):
            controller.write("V.E.VALUE", 5.0)

    print(f"step(1): {us_each(steps):.2f} µs (goal 1.5)")
    print(f"bound read: {us_each(reads):.3f} µs (goal 0.15)")
    print(f"bound write: {us_each(writes):.3f} µs (goal 0.25)")
    print(f"read by name: {us_each(reads_by_name):.2f} µs")
    print(f"write by name: {us_each(writes_by_name):.2f} µs")


def runs_per_second(plc: Path | None, folder: Path, count: int = 200) -> tuple[float, float]:
    """Return how many runs of a study a core makes in a second, and the ticks of a run."""
    path = folder / "short.nc"
    path.write_text(SHORT, "utf-8")
    study = Study(
        program=str(path),
        plc=None if plc is None else str(plc),
        vary=[{"variable": "V.E.COUNT", "from": 0, "to": count, "step": 1}],
        measure={"crossed": "time of M100"},
    )
    runner: StudyRunner = study.runner
    maker = maker_of(runner, may_copy=True)
    ticks = maker.row(0)["ticks"]
    gc.collect()
    best = 1e9
    for _ in range(3):
        begin = time.process_time()
        make_runs(maker, tuple(range(count)))
        best = min(best, time.process_time() - begin)
    return count / best, float(str(ticks))


def main() -> None:
    """Print all figures with their goals."""
    form = "compiled" if is_compiled() else "plain"
    print(f"Python {platform.python_version()}, {platform.machine()}, {form}\n")
    with tempfile.TemporaryDirectory() as name:
        files = loaded(Path(name))
        figures = ns_per_tick(files)
        alone = figures.pop("")
        print(f"{'3 axes moving, 2 cycles':46} {'ns/tick':>9} {'more':>9} {'ratio':>7}")
        print(f"{'without a PLC':46} {alone:9.1f}")
        goals = ("ratio 1.3", "600 more", "3000 more")
        for (plc, tick), goal in zip(figures.items(), goals, strict=True):
            print(f"{plc:46} {tick:9.1f} {tick - alone:9.1f} {tick / alone:7.2f}  (goal {goal})")
        print()
        accesses()
        print()
        for plc, goal in zip(("", *files), ("", " (goal 1000)", "", " (goal 250)"), strict=True):
            rate, ticks = runs_per_second(files.get(plc), Path(name))
            shown = plc or "without a PLC"
            print(f"runs of {ticks:.0f} ticks a second, {shown}: {rate:.0f}{goal}")


if __name__ == "__main__":
    main()
