# SPDX-License-Identifier: MIT
"""Machines for random programs of motion: axes alike and unlike, ticks of one and two milliseconds.

What a machine's axes can do is written down here a second time, so that a test holds the path to
the lists and not to what the code has made of them.
"""

from __future__ import annotations

import functools
import shutil
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from nctakt.lists.machine.machine import Machine, load_machine
from support.kernel_rig import DEMO

#: Path axes of all machines; A is a modulo axis.
AXES = ("X", "Y", "Z", "A")


@dataclass(frozen=True)
class Limits:
    """Of one axis: mm/s (degrees/s) and its powers; the ramp time in µs."""

    speed: int
    acceleration: int
    ramp_us: int

    @property
    def jerk(self) -> float:
        """What the ramp of the jerk-limited slope makes of the acceleration."""
        return self.acceleration * 1e6 / self.ramp_us


ALIKE = (Limits(500, 4000, 50_000),) * 3 + (Limits(360, 4000, 50_000),)
UNLIKE = (
    Limits(500, 4000, 50_000),
    Limits(300, 1500, 30_000),
    Limits(120, 800, 80_000),
    Limits(180, 2500, 20_000),
)


@dataclass(frozen=True)
class DrawnMachine:
    """A machine and what the four axes of its path can do, per tick, tick² and tick³."""

    configuration: Machine
    tick_us: int
    speed: np.ndarray
    acceleration: np.ndarray
    jerk: np.ndarray


@functools.cache
def machine(number: int) -> DrawnMachine:
    """0 the demo machine, 1 with unlike axes; 2 and 3 the same with a tick of 2 ms."""
    limits = UNLIKE if number % 2 else ALIKE
    tick_us = 2000 if number >= 2 else 1000
    tick_t = tick_us / 1e6
    return DrawnMachine(
        DEMO if number == 0 else _loaded(limits, tick_us),
        tick_us,
        np.array([one.speed * tick_t for one in limits]),
        np.array([one.acceleration * tick_t**2 for one in limits]),
        np.array([one.jerk * tick_t**3 for one in limits]),
    )


def _loaded(limits: tuple[Limits, ...], tick_us: int) -> Machine:
    """The demo machine with these axes and this tick."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name) / "machine"
        shutil.copytree(DEMO.folder, folder)
        for index, one in enumerate(limits, 1):
            _change(
                folder / f"achs_mds{index}.lis",
                f"getriebe[0].dynamik.vb_max {one.speed * 1000}",
                f"getriebe[0].dynamik.a_max {one.acceleration}",
                f"getriebe[0].slope_profil.tr_beschl_zu {one.ramp_us}",
            )
        for place in ("cycle_time", "thread[0].cycle", "thread[1].cycle"):
            _change(folder / "rtconf.lis", f"{place} {tick_us}")
        return load_machine(folder)


def _change(path: Path, *entries: str) -> None:
    """Put entries into a list, in place of those that it has."""
    names = {entry.split()[0] for entry in entries}
    kept = [line for line in path.read_text("utf-8").splitlines() if line.split()[0] not in names]
    place = kept.index("Ende")
    path.write_text("\n".join([*kept[:place], *entries, *kept[place:]]), "utf-8")
