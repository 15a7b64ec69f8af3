# SPDX-License-Identifier: MIT
"""Random five-axis programs, their machine, and where the tool's tip has to be.

The tip is computed here a second time, from the positions of the axes: a head with the axes C and
A, and a table with them, as products of matrices.
"""

from __future__ import annotations

import functools
import random
import shutil
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from nctakt import machines
from nctakt.lists.machine.machine import Machine, load_machine

NAMES = ("X", "Y", "Z", "C", "A")
#: Per s, s² and s³: what the lists of demo5 allow the axes.
SPEED = np.array([500.0, 500.0, 500.0, 360.0, 180.0])
ACCELERATION = np.array([4000.0, 4000.0, 4000.0, 4000.0, 1000.0])
JERK = ACCELERATION / 0.05
TICK_S = 0.001

#: Holder of the head with all axes at 0, and the centre of the table, mm.
HEAD = np.array([12.0, -7.5, -180.0])
TABLE = np.array([150.0, 80.0, -60.0])

_HEAD_LIST = """
trafo[0].id 1
trafo[0].type 91
trafo[0].zero_orientation[2] 1
trafo[0].zero_position[0] 120000
trafo[0].zero_position[1] -75000
trafo[0].zero_position[2] -1800000
trafo[0].rtcp 1
trafo[0].programming_mode 17
trafo[0].number_of_axes 5
"""

_TABLE_LIST = """
trafo[1].id 2
trafo[1].type 91
trafo[1].zero_orientation[2] 1
trafo[1].rtcp 1
trafo[1].programming_mode 17
trafo[1].number_of_axes 5
"""


def _joints(index: int, chain: tuple[int, ...], signs: float, point: np.ndarray) -> str:
    lines = [f"trafo[{index}].chain[{place}] {axis}" for place, axis in enumerate(chain)]
    directions = ((0, 1.0), (1, 1.0), (2, 1.0), (2, signs), (0, signs))
    for axis, (component, value) in enumerate(directions):
        lines.append(f"trafo[{index}].axis[{axis}].type {2 if axis > 2 else 1}")
        lines.append(f"trafo[{index}].axis[{axis}].orientation[{component}] {value:g}")
        if axis > 2:
            lines += [
                f"trafo[{index}].axis[{axis}].point[{k}] {round(value * 1e4)}"
                for k, value in enumerate(point)
                if value
            ]
    return "\n".join(lines) + "\n"


@functools.cache
def machine() -> Machine:
    """The machine demo5 with kinematic 1, a head, and kinematic 2, a table."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name) / "machine"
        shutil.copytree(Path(machines.__path__[0]) / "demo5", folder)
        file = folder / "sda_mds1.lis"
        text = file.read_text("utf-8")
        lines = [line for line in text.splitlines() if not line.startswith(("trafo", "kinematik"))]
        at = lines.index("Ende")
        own = _HEAD_LIST + _joints(0, (0, 1, 2, 3, 4), 1.0, np.zeros(3))
        own += _TABLE_LIST + _joints(1, (3, 4, 0, 1, 2), -1.0, TABLE)
        file.write_text("\n".join([*lines[:at], own, *lines[at:]]) + "\n", "utf-8")
        return load_machine(folder)


def rotation(axis: int, degrees: np.ndarray) -> np.ndarray:
    """The matrices of turns about a main axis."""
    cosine, sine = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    matrices = np.zeros((len(degrees), 3, 3))
    first, second = (axis + 1) % 3, (axis + 2) % 3
    matrices[:, axis, axis] = 1.0
    matrices[:, first, first] = matrices[:, second, second] = cosine
    matrices[:, second, first] = sine
    matrices[:, first, second] = -sine
    return matrices


def tips(places: np.ndarray, kinematic: int) -> np.ndarray:
    """The tool's tip in the workpiece for positions of the axes."""
    turn_c, turn_a = rotation(2, places[:, 3]), rotation(0, places[:, 4])
    if kinematic == 1:
        return places[:, :3] + (turn_c @ turn_a @ HEAD)
    back_a, back_c = np.swapaxes(turn_a, 1, 2), np.swapaxes(turn_c, 1, 2)
    inner = TABLE + (back_a @ (places[:, :3] - TABLE)[:, :, None])[:, :, 0]
    return TABLE + (back_c @ (inner - TABLE)[:, :, None])[:, :, 0]


@dataclass(frozen=True)
class FiveAxisProgram:
    """A program; ``ways``: N number -> start and end of its line in X Y Z C A."""

    text: str
    kinematic: int
    ways: dict[int, tuple[np.ndarray, np.ndarray]]
    has_jerk_limit: bool


def five_axis_program(seed: int) -> FiveAxisProgram:
    """A program with lines of all lengths and turns, rapid ones among them."""
    dice = random.Random(f"five axes {seed}")
    kinematic = dice.choice((1, 2))
    has_jerk_limit = dice.random() < 0.5
    place = np.array([dice.uniform(-100.0, 100.0) for _ in range(3)] + [0.0, 0.0])
    lines = [
        "N1 #SLOPE [TYPE=TRAPEZ]" if has_jerk_limit else "N1 #SLOPE [TYPE=STEP]",
        "N2 G00 " + " ".join(f"{n}{v:.4f}" for n, v in zip(NAMES, place, strict=True)),
        f"N3 #TRAFO [{kinematic}]",
    ]
    place = np.round(place, 4)
    place[:3] = tips(place[None, :], kinematic)[0]
    ways: dict[int, tuple[np.ndarray, np.ndarray]] = {}
    size, turn = dice.choice((0.3, 2.0, 15.0, 60.0)), dice.choice((0.5, 5.0, 40.0))
    motion = "G01"
    for number in range(10, 10 + dice.choice((4, 12, 30))):
        end = place.copy()
        if number > 10:
            end[:3] += [dice.gauss(0.0, size) for _ in range(3)]
        else:
            end[:3] = [dice.uniform(-60.0, 60.0) for _ in range(3)]
        if dice.random() < 0.8:
            end[3] += dice.gauss(0.0, turn)
            end[4] = min(max(end[4] + dice.gauss(0.0, turn), -90.0), 90.0)
        end = np.round(end, 4)
        motion = "G00" if dice.random() < 0.1 else "G01"
        words = " ".join(f"{n}{v:.4f}" for n, v in zip(NAMES, end, strict=True))
        lines.append(f"N{number} {motion} {words} F{dice.choice((500, 3000, 12000, 30000))}")
        ways[number] = (place, end)
        place = end
    return FiveAxisProgram("\n".join([*lines, "M30", ""]), kinematic, ways, has_jerk_limit)
