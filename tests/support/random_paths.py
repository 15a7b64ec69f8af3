# SPDX-License-Identifier: MIT
"""Random programs of lines, arcs and rounded corners, and what MO-1 demands of their positions."""

from __future__ import annotations

import math
import random
from collections.abc import Sequence

import numpy as np

#: Names of the demo machine's axes, with their highest speed and acceleration per tick.
AXES = ("X", "Y", "Z", "A")
MAX_MM = {"X": 0.5, "Y": 0.5, "Z": 0.5, "A": 0.36}
MAX_STEP_MM = 0.004


def program(seed: int, slope: str = "") -> str:
    """A program of some forty blocks that stays within 1 m of where it began."""
    chance = random.Random(seed)
    lines = [slope, "G01 F6000"] if slope else ["G01 F6000"]
    place = [0.0, 0.0, 0.0, 0.0]
    size = chance.choice((0.02, 0.3, 3.0, 20.0))
    bend = chance.choice((0.01, 0.2, 3.0))
    heading = chance.uniform(-math.pi, math.pi)
    for _ in range(chance.randint(5, 45)):
        if chance.random() < 0.1:
            size = chance.choice((0.02, 0.3, 3.0, 20.0))
        if chance.random() < 0.2:
            lines.append(_setting(chance))
        heading += chance.gauss(0.0, bend)
        length = size * chance.uniform(0.2, 2.0)
        place[0] += length * math.cos(heading)
        place[1] += length * math.sin(heading)
        words = ""
        if chance.random() < 0.3:
            place[2] += length * chance.uniform(-1.0, 1.0)
            words += f" Z{place[2]:.4f}"
        if chance.random() < 0.1:
            place[3] += length * chance.uniform(-1.0, 1.0)
            words += f" A{place[3]:.4f}"
        target = f"X{place[0]:.4f} Y{place[1]:.4f}{words}"
        if chance.random() < 0.3:
            radius = length * chance.choice((0.6, 1.0, 4.0)) * chance.choice((1, 1, 1, -1))
            lines.append(f"G0{chance.choice((2, 3))} {target} R{radius:.4f}")
            heading = chance.uniform(-math.pi, math.pi) if bend > 1 else heading
        else:
            lines.append(f"G0{chance.choice((1, 1, 1, 1, 1, 0))} {target}")
    return "\n".join([*lines, "M30"])


def flowing(seed: int, slope: str = "") -> str:
    """A program whose blocks mostly go on in their direction: pieces of lines, tangential arcs."""
    chance = random.Random(seed)
    lines = [slope, "G91 G01 F6000"]
    heading = chance.choice((0.0, math.pi / 4, math.pi / 2, chance.uniform(-math.pi, math.pi)))
    size = chance.choice((0.05, 0.3, 3.0, 20.0))
    for _ in range(chance.randint(8, 60)):
        if chance.random() < 0.1:
            size = chance.choice((0.05, 0.3, 3.0, 20.0))
        if chance.random() < 0.2:
            lines.append(_setting(chance))
        if chance.random() < 0.2:
            heading += chance.choice((1e-4, 1e-3, 1e-2, 0.1)) * chance.gauss(0.0, 1.0)
        length = size * chance.uniform(0.2, 2.0)
        rise = f" Z{length * chance.uniform(-0.5, 0.5):.6f}" if chance.random() < 0.1 else ""
        if chance.random() < 0.4:
            radius = size * chance.choice((0.3, 1.0, 5.0, 50.0)) * chance.choice((1, -1))
            x, y = -math.sin(heading) * radius, math.cos(heading) * radius
            heading += math.copysign(min(length / abs(radius), 2.5), radius)
            ends = f"X{x + math.sin(heading) * radius:.9f} Y{y - math.cos(heading) * radius:.9f}"
            lines.append(f"G0{3 if radius > 0 else 2} {ends} I{x:.9f} J{y:.9f}{rise}")
        else:
            ends = f"X{length * math.cos(heading):.9f} Y{length * math.sin(heading):.9f}"
            lines.append(f"G0{chance.choice((1, 1, 1, 1, 1, 0))} {ends}{rise}")
    return "\n".join([*lines, "M30"])


def cornered(seed: int, slope: str = "") -> str:
    """A program of lines whose corners of any angle are to be rounded."""
    chance = random.Random(seed)
    lines = [slope, "G91 G01 F6000 G261"]
    heading = chance.uniform(-math.pi, math.pi)
    size = chance.choice((0.3, 3.0, 20.0, 60.0))
    deviation = chance.choice((0.01, 0.1, 1.0, 5.0))
    lines.append(f"#CONTOUR MODE [DEV PATH_DEV={deviation}]")
    for _ in range(chance.randint(5, 30)):
        if chance.random() < 0.1:
            size = chance.choice((0.3, 3.0, 20.0, 60.0))
        if chance.random() < 0.2:
            lines.append(_setting(chance))
        heading += chance.choice((0.01, 0.3, 1.6)) * chance.gauss(0.0, 1.0)
        length = size * chance.uniform(0.2, 2.0)
        rise = f" Z{length * chance.uniform(-0.5, 0.5):.6f}" if chance.random() < 0.2 else ""
        turn = f" A{length * chance.uniform(-0.5, 0.5):.6f}" if chance.random() < 0.1 else ""
        ends = f"X{length * math.cos(heading):.9f} Y{length * math.sin(heading):.9f}"
        lines.append(f"G0{chance.choice((1, 1, 1, 1, 1, 0))} {ends}{rise}{turn}")
    return "\n".join([*lines, "M30"])


def _setting(chance: random.Random) -> str:
    return chance.choice(
        (
            f"F{chance.choice((600, 3000, 12000, 40000))}",
            f"F{chance.choice((600, 3000, 12000, 40000))}",
            "G261",
            "G260",
            f"#CONTOUR MODE [DEV PATH_DEV={chance.choice((0.01, 0.1, 1.0))}]",
            "G360",
            "G359",
            "M100",
            "#TIME 0.005",
        )
    )


def violations(positions: Sequence[float], name: str, jerk_mm: float = 0.0) -> list[str]:
    """Where an axis is faster than it may, or changes its speed more than it may, in a tick."""
    path = np.concatenate([[0.0] * 3, np.asarray(positions), [positions[-1]] * 3])
    if name == "A":  # a modulo axis is shown within its range
        path = np.unwrap(path, period=360.0)
    speed = np.diff(path)
    step = np.diff(speed)
    found = []
    fuzz = 1e-9
    if (worst := np.abs(speed).max()) > MAX_MM[name] * (1 + 1e-9) + fuzz:
        found.append(f"{name}: speed {worst * 1000:.3f} mm/s at {np.abs(speed).argmax()}")
    if (worst := np.abs(step).max()) > MAX_STEP_MM * (1 + 1e-6) + fuzz:
        found.append(f"{name}: acceleration {worst * 1e6:.1f} mm/s² at {np.abs(step).argmax()}")
    if jerk_mm:
        jerk = np.diff(step)
        if (worst := np.abs(jerk).max()) > jerk_mm * (1 + 1e-6) + fuzz:
            found.append(f"{name}: jerk {worst * 1e9:.1f} mm/s³ at {np.abs(jerk).argmax()}")
    return found


def farthest(way: np.ndarray, curve: np.ndarray) -> float:
    """How far the farthest of some places is from a polyline."""
    starts, steps = curve[:-1], np.diff(curve, axis=0)
    sizes = np.maximum((steps * steps).sum(axis=1), 1e-300)
    worst = 0.0
    for place in way:
        part = np.clip(((place - starts) * steps).sum(axis=1) / sizes, 0.0, 1.0)
        off = place - (starts + part[:, None] * steps)
        worst = max(worst, float(np.sqrt((off * off).sum(axis=1).min())))
    return worst
