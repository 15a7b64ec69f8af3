# SPDX-License-Identifier: MIT
"""Random programs of shapes: systems, contours, arcs, corners and transformations in any order.

Most of them end with a mistake that they make. None may make an axis jump (MO-1), begin a motion
beside where the last one has ended, or end in a fault of nctakt. ``NCTAKT_SEEDS=10000`` makes as
many.
"""

from __future__ import annotations

import functools
from pathlib import Path
from random import Random

import numpy as np
from support.random_seeds import seeds_in_parts

from nctakt import machines
from nctakt.lists.machine.machine import Machine, load_machine
from nctakt.run.controller import Controller, NcText

SIGNALS = [f"{axis}.ACS.ACT_POS" for axis in "XYZ"]
#: What the lists of both machines allow X, Y and Z, per s and s².
SPEED, ACCELERATION, TICK_S = 500.0, 4000.0, 0.001
#: The block does not start where the axis is: the decoder has lost it.
ELSEWHERE = 900420

BEFORE = ("V.G.WZ[1].R=2", "G01 X1 Y1 Z1 F6000")
#: Lines of any machine, each as often as another one.
LINES = (
    "#CS OFF",
    "#CS OFF ALL",
    "#ACS OFF ALL",
    "#CONTOUR MODE [DEV PATH_DEV=0.2]",
    "#CONTOUR MODE [DIST PRE_DIST=1 POST_DIST=2]",
    "#CONTOUR MODE [DIST_SOFT PATH_DIST=1]",
    "#CONTOUR MODE [POS PRE_DIST=1 POST_DIST=1 X3 Y4 Z5]",
    "#HSC ON [BSPLINE PATH_DEV 0.1]",
    "#HSC OFF",
    "#SCALE ON X2 Y2 Z2",
    "#SCALE OFF",
    "G05 G01 X3",
    "G17",
    "G18",
    "G19",
    "G20",
    "G21",
    "G22",
    "G51",
    "G52",
    "G53",
    "G54",
    "G68 R20",
    "G69",
    "G70",
    "G71",
    "G90",
    "G91",
    "G140",
    "G141",
    "G237",
    "G238",
    "G239",
    "G260",
    "G261",
    "G301 I1",
    "G302 I1.5",
    "G360",
    "M100",
    "#SPLINE TYPE AKIMA\n#AKIMA TRANS [START=TANGENTIAL]\nG01 X2 Y2\nG151\nG01 X9 Y8 Z7\nX3 Y1\n"
    "X1 Y5\nX2 Y9\nG150",
)
#: Lines of a machine with five axes.
FIVE_AXES = (
    "#ECS ON",
    "#ECS OFF",
    "#TRAFO ON",
    "#TRAFO OFF",
    "#MCS ON",
    "#MCS OFF",
    "#PTP ON",
    "#PTP OFF",
)


@functools.cache
def machine(is_five_axes: bool) -> Machine:
    """The built-in machine, or the one with five axes."""
    return load_machine(Path(machines.__path__[0]) / "demo5" if is_five_axes else None)


def numbers(dice: Random, names: str, size: float) -> str:
    """Words with these names, each within ``size`` of 0."""
    return " ".join(f"{name}{dice.uniform(-size, size):.3f}" for name in names)


def line(dice: Random, is_five_axes: bool) -> str:
    """A line of a program."""
    some = "".join(dice.sample("XYZ", dice.randint(1, 3)))
    speed = dice.choice(("", " F3000", " F30000"))
    arc = dice.choice(("G02", "G03"))
    match dice.choices(range(9), (8, 3, 1, 1, 2, 1, 1, 1, 8))[0]:
        case 0:
            turn = f" C{dice.uniform(-40, 40):.1f}" if is_five_axes and dice.random() < 0.3 else ""
            return f"G01 {numbers(dice, some, 30)}{turn}{speed}"
        case 1:
            return f"{arc} {numbers(dice, 'IJ', 9)}{dice.choice(('', ' Z3'))}"
        case 2:
            return f"{arc} {numbers(dice, 'XY', 30)} R{dice.uniform(25, 60):.2f}"
        case 3:
            return f"G303 {numbers(dice, 'IJK', 30)} {numbers(dice, some, 30)}"
        case 4:
            values = ",".join(f"{dice.uniform(-40, 40):.2f}" for _ in range(6))
            return f"#{dice.choice(('CS', 'CS', 'ACS'))} ON [{values}]"
        case 5:
            return f"D1 {dice.choice(('G41', 'G42'))} G01 {numbers(dice, some, 30)}"
        case 6:
            return f"G40 G01 {numbers(dice, some, 30)}"
        case 7:
            return f"G00 {numbers(dice, some, 30)}"
    return dice.choice((*LINES, *FIVE_AXES) if is_five_axes else LINES)


@seeds_in_parts(compiled=50, plain=2, part=25)
def test_no_axis_jumps(seeds: range) -> None:
    """Whatever the program does, and wherever it makes a mistake."""
    for seed in seeds:
        dice = Random(f"shapes {seed}")
        is_five_axes = dice.random() < 0.5
        slope = f"#SLOPE [TYPE={dice.choice(('STEP', 'TRAPEZ'))}]"
        lines = [line(dice, is_five_axes) for _ in range(dice.randint(5, 25))]
        text = "\n".join([*BEFORE[:1], slope, *BEFORE[1:], *lines, "M30"])
        controller = Controller(machine(is_five_axes))
        run = controller.run(NcText("p.nc", text), ticks=60_000, signals=SIGNALS)
        assert ELSEWHERE not in [one.id for one in run.errors], seed
        assert run.trace is not None
        axes = np.array([run.trace[name] for name in SIGNALS]).T
        if len(axes) > 2:
            speed = np.abs(np.diff(axes, axis=0)).max() / TICK_S
            change = np.abs(np.diff(axes, 2, axis=0)).max() / TICK_S**2
            assert speed <= SPEED * (1 + 1e-6), (seed, speed)
            assert change <= ACCELERATION * (1 + 1e-6), (seed, change)
