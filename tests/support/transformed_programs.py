# SPDX-License-Identifier: MIT
"""Random programs of all kinds of type 91 on demo5, and the tool as a product of 4×4 matrices."""

from __future__ import annotations

import functools
import math
import random
import shutil
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from nctakt import machines
from nctakt.lists.machine.machine import Machine, load_machine
from support.five_axis_programs import HEAD, TABLE

#: ID -> whether it is a head (else a table), RTCP, programming mode (P-CHAN-00288).
KINEMATICS = {
    1: (True, 1, 17),
    2: (False, 1, 17),
    3: (True, 0, 17),
    4: (False, 0, 17),
    5: (False, 0, 19),
    6: (True, 0, 14),
}
_CHAINS = {True: (0, 1, 2, 3, 4), False: (3, 4, 0, 1, 2)}


def _list_entries(index: int, identity: int) -> list[str]:
    is_head, rtcp, mode = KINEMATICS[identity]
    entries: dict[str, float] = {
        "id": identity,
        "type": 91,
        "zero_orientation[2]": 1,
        "rtcp": rtcp,
        "programming_mode": mode,
        "number_of_axes": 5,
    }
    for k, axis in enumerate(_CHAINS[is_head]):
        entries[f"chain[{k}]"] = axis
    for axis, component in enumerate((0, 1, 2, 2, 0)):
        sign = 1 if is_head or axis < 3 else -1
        entries[f"axis[{axis}].type"] = 2 if axis > 2 else 1
        entries[f"axis[{axis}].orientation[{component}]"] = sign
    for k in range(3):
        if is_head:
            entries[f"zero_position[{k}]"] = round(HEAD[k] * 1e4)
        else:
            entries[f"axis[3].point[{k}]"] = entries[f"axis[4].point[{k}]"] = round(TABLE[k] * 1e4)
    return [f"trafo[{index}].{name} {value:g}" for name, value in entries.items()]


@functools.cache
def machine() -> Machine:
    """The machine demo5 with ``KINEMATICS``."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name) / "machine"
        shutil.copytree(Path(machines.__path__[0]) / "demo5", folder)
        file = folder / "sda_mds1.lis"
        lines = file.read_text("utf-8").splitlines()
        lines = [line for line in lines if not line.startswith(("trafo", "kinematik"))]
        at = lines.index("Ende")
        for index, identity in enumerate(KINEMATICS):
            lines[at:at] = _list_entries(index, identity)
        file.write_text("\n".join(lines) + "\n", "utf-8")
        return load_machine(folder)


def _translation(vector: np.ndarray) -> np.ndarray:
    matrix = np.eye(4)
    matrix[:3, 3] = vector
    return matrix


def _turn(axis: int, point: np.ndarray, degrees: float) -> np.ndarray:
    matrix = np.eye(4)
    first, second = (axis + 1) % 3, (axis + 2) % 3
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    matrix[first, first] = matrix[second, second] = c
    matrix[second, first], matrix[first, second] = s, -s
    return _translation(point) @ matrix @ _translation(-point)


def tip(place: np.ndarray, identity: int, tool_length: float = 0.0) -> np.ndarray:
    """The tool's tip for positions of the axes, as a product of rigid motions."""
    zero = np.zeros(3)
    if KINEMATICS[identity][0]:
        motion = _translation(place[:3]) @ _turn(2, zero, place[3]) @ _turn(0, zero, place[4])
        tool = HEAD - np.array([0.0, 0.0, tool_length])
    else:
        motion = _turn(2, TABLE, -place[3]) @ _turn(0, TABLE, -place[4]) @ _translation(place[:3])
        tool = np.array([0.0, 0.0, -tool_length])
    return (motion @ np.append(tool, 1.0))[:3]


@dataclass(frozen=True)
class TransformedProgram:
    """A program; its blocks from N10 on lie under the kinematic."""

    text: str
    kinematic: int
    has_jerk_limit: bool


def transformed_program(seed: int) -> TransformedProgram:
    """A program with lines, arcs and helices, in a turned coordinate system or not."""
    dice = random.Random(f"transformed {seed}")
    kinematic = dice.choice(tuple(KINEMATICS))
    has_jerk_limit = dice.random() < 0.5

    def pick(low: float, high: float) -> str:
        return f"{dice.uniform(low, high):.3f}"

    x, y, z = (pick(-50, 50) for _ in range(3))
    lines = [
        f"N1 #SLOPE [TYPE={'TRAPEZ' if has_jerk_limit else 'STEP'}]",
        f"N2 G00 X{x} Y{y} Z{z} C{pick(-60, 60)} A{pick(20, 60)}",
        f"N3 #TRAFO [{kinematic}]",
    ]
    if dice.random() < 0.5:
        lines.append(f"#CS ON [{pick(-20, 20)},{pick(-20, 20)},5,0,0,{pick(-180, 180)}]")
    lines.append("G91")
    size, turn = dice.choice((1, 10, 30)), dice.choice((1, 10, 30))
    for number in range(10, 10 + dice.choice((4, 8, 14))):
        words = f"Z{dice.gauss(0, 0.3 * size):.3f} F{dice.choice((500, 3000, 12000, 30000))}"
        if dice.random() < 0.8:
            words += f" C{dice.gauss(0, turn):.3f} A{dice.gauss(0, 0.4 * turn):.3f}"
        if dice.random() < 0.3:
            i, j, angle = dice.gauss(0, size), dice.gauss(0, size), dice.uniform(0.3, 5.0)
            end_x = i - i * math.cos(angle) + j * math.sin(angle)
            end_y = j - i * math.sin(angle) - j * math.cos(angle)
            words += f" X{end_x:.6f} Y{end_y:.6f} I{i:.6f} J{j:.6f}"
            lines.append(f"N{number} G03 {words}")
        else:
            motion = "G00" if dice.random() < 0.1 else "G01"
            words += f" X{dice.gauss(0, size):.3f} Y{dice.gauss(0, size):.3f}"
            lines.append(f"N{number} {motion} {words}")
    return TransformedProgram("\n".join([*lines, "M30", ""]), kinematic, has_jerk_limit)
