# SPDX-License-Identifier: MIT
"""Decisions on ``#BCS``, ``#ACS`` and ``#CS`` as layers of coordinates.

Public manuals: all of #BCS below all of #ACS below all of #CS, whatever the order of the commands;
each kind is switched off from its last one on; ten are active at most, and offsets that are
programmed in a system end with it.
"""

from __future__ import annotations

import random
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from support.decided import numbers, perform
from support.random_seeds import each_seed
from support.run_folders import changed_machine

from nctakt.run.controller import Controller

KINDS = ("BCS", "ACS", "CS")
SIGNALS = [f"{axis}.ACS.ACT_POS" for axis in "XYZA"]
#: Systems 1 and 2 of #CS and #ACS: turned by a quarter about Z, shifted in X and Y.
STORED = (
    "#CS DEF [1] [10, 0, 0, 0, 0, 90]\n#CS DEF [2] [0, 1, 0]\n"
    "#ACS DEF [1] [100, 0, 0, 0, 0, 90]\n#ACS DEF [2] [0, 200, 0]\n"
)


def ends_at(program: str, controller: Controller | None = None) -> list[float]:
    """The positions of X, Y, Z and A after a program."""
    run = perform(f"{program}\nM30", controller, signals=SIGNALS)
    assert run.state == "ended", run.diagnostics
    assert run.trace is not None
    return [run.trace.at(run.first_tick + run.ticks - 1, name) for name in SIGNALS]


@pytest.mark.parametrize(
    ("commands", "position"),
    [
        ("#CS ON [1]", (8, 1)),
        ("#CS ON [1]\n#ACS ON [2]", (8, 201)),
        ("#CS ON [1]\n#ACS ON [2]\n#ACS ON [1]", (99, 208)),
        ("#CS ON [1]\n#ACS ON [2]\n#ACS ON [1]\n#CS ON [2]", (99, 207)),
        ("#CS ON [1]\n#ACS ON [2]\n#ACS ON [1]\n#CS ON [2]\n#ACS OFF", (7, 201)),
        ("#CS ON [1]\n#ACS ON [2]\n#ACS ON [1]\n#CS ON [2]\n#ACS OFF\n#CS OFF", (8, 201)),
        ("#CS ON [1]\n#ACS ON [2]\n#ACS ON [1]\n#CS ON [2]\n#CS OFF ALL", (98, 201)),
        ("#CS ON [1]\n#ACS ON [2]\n#ACS ON [1]\n#CS ON [2]\n#ACS OFF ALL", (7, 1)),
        ("#BCS ON [0, 0, 0, 0, 0, 180]\n#ACS ON [1]\n#CS ON [1]", (-99, -8)),
        ("#CS ON [1]\n#BCS ON [0, 0, 0, 0, 0, 180]\n#ACS ON [1]", (-99, -8)),
    ],
)
def test_each_kind_lies_in_its_layer(commands: str, position: tuple[float, float]) -> None:
    """The public example of linked systems, in each of its states: X1 Y2 there."""
    found = ends_at(f"{STORED}{commands}\nG00 X1 Y2")
    assert found[:2] == pytest.approx(position, abs=1e-9)


@dataclass(eq=False)
class Layer:
    """A system of the model: kind, shift and matrix, and the offset G92 inside of it."""

    kind: int
    shift: NDArray[np.float64]
    matrix: NDArray[np.float64]
    offset: NDArray[np.float64] = field(default_factory=lambda: np.zeros(3))


def turned(angles: Sequence[float]) -> NDArray[np.float64]:
    """The matrix of the third angle about Z, the second about the new Y, the first about X."""
    (a, b, c), zero = np.radians(angles), 0.0
    about_x = [[1, 0, 0], [0, np.cos(a), -np.sin(a)], [0, np.sin(a), np.cos(a)]]
    about_y = [[np.cos(b), 0, np.sin(b)], [0, 1, 0], [-np.sin(b), 0, np.cos(b)]]
    about_z = [[np.cos(c), -np.sin(c), zero], [np.sin(c), np.cos(c), zero], [0, 0, 1]]
    return np.array(about_z) @ np.array(about_y) @ np.array(about_x)


@each_seed(30, 4)
def test_random_layers_against_matrices(seed: int) -> None:
    """Systems of all kinds go on and off in any order, with G92 in some of them."""
    chance = random.Random(seed)
    base = Layer(-1, np.zeros(3), np.eye(3))
    layers, lines = [base], []
    for _ in range(chance.randrange(2, 14)):
        kind = chance.randrange(3)
        of_kind = [layer for layer in layers if layer.kind == kind]
        choice = chance.random()
        if choice < 0.3:
            layers[-1].offset = np.array([chance.randrange(-9, 10) for _ in range(3)], float)
            x, y, z = layers[-1].offset
            lines.append(f"G92 X{x:g} Y{y:g} Z{z:g}")
        elif choice < 0.7 and len(layers) <= 10:
            shift = [chance.randrange(-20, 21) for _ in range(3)]
            angles = [chance.randrange(-180, 181) for _ in range(3)]
            layer = Layer(kind, np.array(shift, float), turned(angles))
            layers.insert(sum(other.kind <= kind for other in layers), layer)
            lines.append(f"#{KINDS[kind]} ON {[*shift, *angles]}")
        elif of_kind:
            layers.remove(of_kind[-1])
            lines.append(f"#{KINDS[kind]} OFF")
    target = np.array([1.0, 2.0, 3.0])
    for layer in reversed(layers):
        target = layer.shift + layer.matrix @ (layer.offset + target)
    found = ends_at("\n".join([*lines, "G00 X1 Y2 Z3"]))
    assert found[:3] == pytest.approx(target.tolist(), abs=1e-9)


def test_offsets_follow_their_layer() -> None:
    """Offsets of a system end with it, also when others lie above; #ACS below #CS has none."""
    inside = "#CS ON [1, 0, 0]\nG92 X5\n#ACS ON [100, 0, 0]"
    assert ends_at(f"G92 X1000\n{inside}\nG00 X0")[0] == 1106
    assert ends_at(f"G92 X1000\n{inside}\n#CS OFF\nG00 X0")[0] == 1100
    assert ends_at(f"G92 X1000\n{inside}\n#ACS OFF\n#CS OFF\nG00 X0")[0] == 1000
    below = "#ACS ON [100, 0, 0]\nG92 X7\n#CS ON [1, 0, 0]"
    assert ends_at(f"{below}\nG00 X0")[0] == 108
    assert ends_at(f"{below}\n#ACS OFF\nG00 X0")[0] == 1


def test_the_active_systems_are_stored_as_one() -> None:
    """``#CS DEF ACT``: that system alone lies where all of them did."""
    systems = "G92 X5\n#ACS ON [10, 0, 0, 0, 0, 90]\n#CS ON [1, 2, 3, 30, 40, 50]\nG92 Y1\n"
    all_off = "#CS DEF ACT [3]\n#CS OFF ALL\n#ACS OFF ALL\n"
    before = ends_at(f"{systems}G92 Y0\nG00 X1 Y2 Z3")
    assert ends_at(f"{systems}{all_off}#CS ON [3]\nG00 X1 Y2 Z3") == pytest.approx(before)
    assert ends_at(f"{systems}#ACS DEF ACT [3]\n{all_off}#ACS ON\nG00 X1 Y2 Z3") == pytest.approx(
        before
    )


def test_systems_of_the_channel_list(tmp_path: Path) -> None:
    """P-CHAN-00490 … 496: found by name by each kind; a number may be a name."""
    lines = [
        "coordinate_system.def[0].id Table",
        "coordinate_system.def[0].path[0].translation.t1 10.0",
        "coordinate_system.def[0].path[0].rotation.a3 90.0",
        "coordinate_system.def[3].id 7",
        "coordinate_system.def[3].path[0].translation.t2 3.0",
    ]
    controller = Controller(changed_machine({"sda_mds1.lis": lines}, tmp_path / "machine"))
    for kind in KINDS:
        found = ends_at(f"#{kind} ON [TABLE]\n#{kind} ON [7]\nG00 X1 Y2", controller)
        assert found[:2] == pytest.approx([5, 1], abs=1e-9)
    assert numbers(perform("#CS ON [CHAIR]\nM30", controller)) == [20821]


def test_rotation_about_fixed_axes(tmp_path: Path) -> None:
    """P-CHAN-00393 and ``#CS MODE``: Z by the third angle first, then X as it was before."""
    system = "#CS ON [0, 0, 0, 90, 0, 90]\nG00 X1 Y2 Z3"
    fixed = pytest.approx([-2, -3, 1], abs=1e-9)
    turned_along = pytest.approx([3, 1, 2], abs=1e-9)
    assert ends_at(f"#CS MODE ON [ROTATION_MODE_FIXED]\n{system}")[:3] == fixed
    lines = ["coordinate_system.rotation_mode_fixed 1"]
    listed = Controller(changed_machine({"sda_mds1.lis": lines}, tmp_path / "machine"))
    assert ends_at(system, listed)[:3] == fixed
    assert ends_at(f"#CS MODE OFF [ROTATION_MODE_FIXED]\n{system}", listed)[:3] == turned_along


def test_offsets_of_tracking_axes(tmp_path: Path) -> None:
    """P-CHAN-00397 and ``#CS MODE``: without their own offsets A keeps G92 through systems."""
    program = "G92 A10\n#CS ON [1, 0, 0]\nG92 A3\nG00 A0"
    assert ends_at(program)[3] == 13
    assert ends_at(f"{program}\n#CS OFF\nG00 A0")[3] == 10
    own = "AXES_OFFSETS_LAYER_SPECIFIC"
    assert ends_at(f"#CS MODE OFF [{own}]\n{program}")[3] == 3
    assert ends_at(f"#CS MODE OFF [{own}]\n{program}\n#CS OFF\nG00 A0")[3] == 3
    lines = ["coordinate_system.axes_offsets_layer_specific 0"]
    listed = Controller(changed_machine({"sda_mds1.lis": lines}, tmp_path / "machine"))
    assert ends_at(program, listed)[3] == 3
    assert ends_at(f"#CS MODE ON [{own}]\n{program}", listed)[3] == 13


@pytest.mark.parametrize(
    ("program", "number"),
    [
        ("#ACS ON", 20821),
        ("#CS DEF [1] [1, 2, 3]\n#ACS ON [1]", 20821),
        ("#CS ON [TABLE]", 20821),
        ("#ACS DEF [0] [1, 2, 3]", 20820),
        ("#BCS ON [-1] [1, 2, 3]", 20820),
        ("$FOR P1 = 1, 6, 1\n#BCS DEF [P1] [1, 2, 3]\n$ENDFOR", 21234),
        ("$FOR P1 = 1, 11, 1\n#ACS ON [1, 0, 0]\n$ENDFOR", 20826),
        ("#ACS OFF", 20824),
        ("#CS ON [1, 0, 0]\n#BCS OFF", 20824),
        ("D1 G41 G01 X10 F100\n#ACS ON [1,0,0]", 20802),
        ("#MCS ON\n#BCS ON [1, 0, 0]", 901760),
        ("#ACS ADD [A] [1]", 900233),
        ("#ACS DEF", 900233),
        ("#CS DEF ACT [1] [2, 3]", 900233),
        ("#CS ON [TABLE] [1]", 900233),
        ("#CS MODE ON [ROTATION_SEQUENCE=XYZ]", 900706),
        ("#CS MODE ON [ROTATION_MODE_FIXED=1]", 900233),
    ],
)
def test_what_cannot_be(program: str, number: int) -> None:
    """Each mistake has its own number."""
    assert numbers(perform(f"{program}\nM30")) == [number]
