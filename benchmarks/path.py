# SPDX-License-Identifier: MIT
"""``python -m benchmarks.path``: what preparing a block and a tick of the path cost.

Preparation: straight blocks of three lengths along a winding line, put into the queue with limits,
corner speeds and look-ahead; a queue of blocks that are always too short to stop in makes the
look-ahead walk as far as it goes. Ticks: three axes over short blocks with two realtime cycles,
without and with a trace of twelve signals; with limited jerk blocks of 4 mm, twenty in a row. The
best of several repetitions is taken.
"""

from __future__ import annotations

import math
import platform
import time

from benchmarks.tick import LAWS, REPEATS, program
from nctakt.base.mode import is_compiled
from nctakt.kernel import rows
from nctakt.lists.machine.machine import load_machine
from nctakt.run.controller import Controller, NcText
from nctakt.run.realtime.assembly import AssembledMachine

#: Blocks that are put into the queue at once.
CHUNK = 180


def places(length: float, count: int, turn: float) -> list[tuple[float, ...]]:
    """The corners of a line that turns by ``turn`` radians in each of its blocks."""
    x, y, z = 0.0, 0.0, 0.0
    found: list[tuple[float, ...]] = [(x, y, z, 0.0)]
    for i in range(count):
        x += length * math.cos(turn * i)
        y += length * math.sin(turn * i)
        z += 0.1 * length
        found.append((x, y, z, 0.0))
    return found


def blocks_per_second(
    length: float, turn: float, deviation: float, limits_jerk: bool = False
) -> float:
    """How many blocks a second are prepared."""
    corners = places(length, CHUNK, turn)
    best = 1e9
    for _ in range(20 * REPEATS):
        channel = AssembledMachine(load_machine(None)).channels[0]
        begin = time.perf_counter()
        for i in range(CHUNK):
            channel.queue.put_segment(
                0,
                i,
                corners[i],
                corners[i + 1],
                rows.FEED_MOTION,
                200.0,
                False,
                deviation,
                limits_jerk,
                None,
            )
        best = min(best, time.perf_counter() - begin)
    return CHUNK / best


def ns_per_tick(text: str, signals: list[str] | None, ticks: int) -> float:
    """The best time of a tick in ns, decoding and preparation included."""
    best = 1e9
    for _ in range(REPEATS):
        controller = Controller()
        begin = time.perf_counter()
        controller.run(
            NcText("benchmark.nc", text),
            ticks=ticks,
            signals=signals,
            memory_trace=signals is not None,
            record_writes=False,
        )
        best = min(best, (time.perf_counter() - begin) / ticks * 1e9)
    return best


def preparation() -> None:
    """Blocks a second."""
    print(f"{'preparation of straight blocks':44} {'blocks/s':>10}")
    for name, length, turn, deviation in (
        ("0.01 mm, bent by 0.1°", 0.01, 0.0017, 0.0),
        ("1 mm, bent by 1°", 1.0, 0.017, 0.0),
        ("10 mm, bent by 60°, rounded", 10.0, 1.05, 0.1),
    ):
        print(f"{name:44} {blocks_per_second(length, turn, deviation):10,.0f}")
    for name, length in (
        ("0.01 mm in one line, limited jerk", 0.01),
        ("1 mm in one line, limited jerk", 1.0),
    ):
        print(f"{name:44} {blocks_per_second(length, 0.0, 0.0, True):10,.0f}")


def ticks() -> None:
    """ns per tick."""
    names = ["X.ACS.ACT_POS", "Y.ACS.ACT_POS", "Z.ACS.ACT_POS", "X.ACS.CUR_POS"]
    names += ["Y.ACS.CUR_POS", "Z.ACS.CUR_POS", "PATH.SPEED", "OVERRIDE.VEL.TOTAL"]
    names += ["BLOCK", "CYCLES.ACTIVE", "V.E.LIST[0]", "V.E.LIST[1]"]
    loop = (
        "$WHILE 1\nG91 G01 X40 Y1 Z0.1 F600\nX40 Y-1 Z0.1\nX-40 Y1 Z-0.1\nX-40 Y-1 Z-0.1\n$ENDWHILE"
    )
    arcs = "$WHILE 1\nG02 I20 Z1 F600\nG02 I20 Z0\n$ENDWHILE"
    print(f"\n{'3 axes, 2 cycles, look-ahead':44} {'ns/tick':>10}")
    flow = "\n".join(["G91 G01 F6000", "$WHILE 1", *["X4"] * 20, *["X-4"] * 20, "$ENDWHILE"])
    for name, motion in (
        ("long lines", loop),
        ("helices", arcs),
        ("long lines, limited jerk", f"#SLOPE [TYPE=TRAPEZ]\n{loop}"),
        ("a line of 4 mm in 40 ticks", flow),
        ("the same, limited jerk", f"#SLOPE [TYPE=TRAPEZ]\n{flow}"),
    ):
        text = program(LAWS[0], 2, motion)
        print(f"{name + ', without trace':44} {ns_per_tick(text, None, 400_000):10.1f}")
        print(f"{name + ', 12 signals recorded':44} {ns_per_tick(text, names, 400_000):10.1f}")


def main() -> None:
    """Print all tables."""
    form = "compiled" if is_compiled() else "plain"
    print(f"Python {platform.python_version()}, {platform.machine()}, {form}\n")
    preparation()
    ticks()


if __name__ == "__main__":
    main()
