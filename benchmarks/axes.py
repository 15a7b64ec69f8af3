# SPDX-License-Identifier: MIT
"""``python -m benchmarks.axes``: what independent motion costs.

A realtime part with nothing but axes: ns per tick of resting and moving axes, and of a new target
in each tick, which is planned from the present state. For comparison, in the same run and also
through Python, ruckig if it is installed. The best of several repetitions is taken.
"""

from __future__ import annotations

import importlib
import importlib.util
import platform
import time
from collections.abc import Callable
from typing import Any

from nctakt.base.mode import is_compiled
from nctakt.kernel import codes
from nctakt.kernel.axes.axes import Axes
from nctakt.kernel.axes.single_axes import SingleAxes
from nctakt.kernel.base.record import Record
from nctakt.kernel.kernel import Kernel

REPEATS = 5
TICKS = 1_000_000 if is_compiled() else 20_000
TARGETS = 100_000 if is_compiled() else 5_000
SPEED, ACCELERATION, JERK = 500.0, 4000.0, 80_000.0


class StudyRunner:
    """This many axes, ±10 m, and nothing else."""

    def __init__(self, count: int, jerk: float) -> None:
        memory = bytearray(8 * 21 * count)
        self.record = Record(memory)
        axes = Axes(memory, 0, count)
        self.single = SingleAxes(axes, self.record, 1000)
        for axis in range(count):
            self.single.configure(
                axis, low=-1e4, high=1e4, speed=SPEED, acceleration=ACCELERATION, jerk=jerk
            )
        self.kernel = Kernel(memory, axes, [], self.record, self.single)
        self.count = count

    def move(self, target: float, speed: float) -> None:
        """Give each axis a target."""
        for axis in range(self.count):
            assert self.single.absolute(axis, target, speed, 0, 2, codes.PLC_OWNER) == 0

    def ticks(self, count: int) -> None:
        """Run this many ticks."""
        done = self.kernel.run(count)
        assert done == 0, done


def best_ns(run: Callable[[], None], count: int) -> float:
    """The shortest of several runs, in ns per one of ``count``."""
    seconds = float("inf")
    for _ in range(REPEATS):
        begin = time.perf_counter()
        run()
        seconds = min(seconds, time.perf_counter() - begin)
    return seconds / count * 1e9


def tick_costs(count: int, jerk: float) -> tuple[float, float]:
    """ns per tick while all axes are at rest, and while all move."""
    standing = StudyRunner(count, jerk)
    moving = StudyRunner(count, jerk)
    moving.move(9000.0, 1.0)
    moving.ticks(1000)
    return (
        best_ns(lambda: standing.ticks(TICKS), TICKS),
        best_ns(lambda: moving.ticks(TICKS), TICKS),
    )


def target_cost(jerk: float) -> tuple[float, float]:
    """ns of a call of the kernel for one tick of a moving axis, and with a new target before."""
    runner = StudyRunner(1, jerk)

    def ticks() -> None:
        runner.move(9000.0, 1.0)
        for _ in range(TARGETS):
            runner.ticks(1)
        runner.record.take_events()

    def targets() -> None:
        for i in range(TARGETS):
            runner.single.absolute(0, 100.0 if i & 64 else -100.0, SPEED, 0, 2, codes.PLC_OWNER)
            runner.ticks(1)
            if i & 1023 == 0:
                runner.record.take_events()

    return best_ns(ticks, TARGETS), best_ns(targets, TARGETS)


def ruckig_costs() -> tuple[float, float] | None:
    """ns of an update, and with a new target before each one; ``None``: not installed."""
    if importlib.util.find_spec("ruckig") is None:
        return None
    ruckig: Any = importlib.import_module("ruckig")
    generator = ruckig.Ruckig(1, 0.001)
    target, given = ruckig.InputParameter(1), ruckig.OutputParameter(1)
    target.max_velocity, target.max_acceleration, target.max_jerk = [SPEED], [ACCELERATION], [JERK]

    def updates() -> None:
        target.target_position, target.max_velocity = [9000.0], [1.0]
        for _ in range(TARGETS):
            generator.update(target, given)
            given.pass_to_input(target)

    def targets() -> None:
        target.max_velocity = [SPEED]
        for i in range(TARGETS):
            shift = 0.001 * (i & 1)  # the same target would not be planned anew
            target.target_position = [100.0 + shift if i & 64 else -100.0 - shift]
            try:
                generator.update(target, given)
                given.pass_to_input(target)
            except ruckig.RuckigError:  # it finds nothing from a few states: begin at rest
                target.current_velocity, target.current_acceleration = [0.0], [0.0]

    return best_ns(updates, TARGETS), best_ns(targets, TARGETS)


def main() -> None:
    """Print the table."""
    form = "compiled" if is_compiled() else "plain"
    print(f"Python {platform.python_version()}, {platform.machine()}, {form}\n")
    for name, jerk in (("trapezoid", 0.0), ("jerk-limited", JERK)):
        for count in (1, 10):
            standing, moving = tick_costs(count, jerk)
            print(
                f"{name:13} {count:2} axes: {standing:7.1f} ns standing, {moving:7.1f} moving,"
                f" {moving - standing:7.1f} more"
            )
        plain, planned = target_cost(jerk)
        print(
            f"{name:13} new target: {planned - plain:7.1f} ns more than a call of one tick"
            f" ({plain:.1f}), through Python"
        )
    other = ruckig_costs()
    if other is None:
        print("ruckig: not installed, no comparison")
        return
    print(f"ruckig        {other[0]:7.1f} ns an update, {other[1]:7.1f} with a new target")


if __name__ == "__main__":
    main()
