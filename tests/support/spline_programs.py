# SPDX-License-Identifier: MIT
"""Random programs with splines."""

from __future__ import annotations

import math
import random


def splined(seed: int, slope: str = "") -> str:
    """A program of splines, lines and arcs that stays within 1 m of where it began."""
    chance = random.Random(seed)
    lines = [slope, "G91 G01 F6000"]
    size = chance.choice((0.05, 0.5, 3.0, 20.0))
    for _ in range(chance.randint(1, 4)):
        kind = chance.choice(("AKIMA", "AKIMA", "BSPLINE"))
        heading = chance.uniform(-math.pi, math.pi)
        lines += [f"G01 X{size:.4f}", f"#SPLINE TYPE {kind}", f"G01 X{size:.4f}"]
        if kind == "AKIMA":
            ends = [chance.choice(("AUTO", "TANGENTIAL")) for _ in range(2)]
            lines.append(f"#AKIMA TRANS [START={ends[0]} END={ends[1]}]")
        lines.append(chance.choice(("G151", "#SPLINE ON")))
        for _ in range(chance.randint(4, 12)):
            heading += chance.gauss(0.0, chance.choice((0.1, 0.6, 1.5)))
            length = size * chance.uniform(0.3, 2.0)
            words = f"X{length * math.cos(heading):.4f} Y{length * math.sin(heading):.4f}"
            if chance.random() < 0.2:
                words += f" Z{length * chance.uniform(-1, 1):.4f}"
            if chance.random() < 0.1:
                words += f" A{length * chance.uniform(-1, 1):.4f}"
            if chance.random() < 0.1:
                words += f" F{chance.choice((600, 6000, 30000))}"
            lines.append(f"G0{chance.choice((1, 1, 1, 1, 1, 1, 0))} {words}")
        lines += [chance.choice(("G150", "#SPLINE OFF")), f"G01 Y{size:.4f}"]
    return "\n".join([*lines, "M30"])
