# SPDX-License-Identifier: MIT
"""``python -m benchmarks.five_axes``: preparation and ticks of five axes, with and without type 91.

The built-in machine ``demo5``, head C A. Preparation: straight blocks of five axes along a winding
line, put into the queue with the limits of the axes, corner speeds and look-ahead. Ticks: long
lines in which the tool turns, and short ones; the commands are decoded in a loop that is read once.
Both ways run in turn, in the same process; the best of several repetitions is taken.
"""

from __future__ import annotations

import math
import platform
import time

from nctakt.base.mode import is_compiled
from nctakt.kernel import rows
from nctakt.kernel.tick.command_queue import CommandQueue
from nctakt.run.controller import Controller, NcText

REPEATS = 30 if is_compiled() else 2
#: Blocks that are put into the queue at once.
CHUNK = 180
TICKS = 200_000 if is_compiled() else 2_000

ON, OFF = "#KIN ID [91]\n#TRAFO ON\n", ""


def places(length: float, count: int) -> list[tuple[float, ...]]:
    """Corners of a line that winds, with a tool that turns by up to 1° in each block."""
    x, y = 100.0, 50.0
    found: list[tuple[float, ...]] = []
    for i in range(count + 1):
        found.append((x, y, 0.1 * i, 20.0 + 15.0 * math.sin(0.05 * i), 10.0 + 0.05 * i))
        x += length * math.cos(0.02 * i)
        y += length * math.sin(0.02 * i)
    return found


def blocks_per_second(begin: str, length: float) -> float:
    """How many blocks a second are prepared."""
    controller = Controller("demo5")
    controller.start(NcText("wait.nc", f"{begin}G04 100\nM30\n"))
    controller.step(50)
    assert controller.state == "running", controller.diagnostics
    channel = controller._machine.channels[0]
    command = [0.0] * (rows.TRANSFORMATION_OF_SEGMENTS + 1)
    command[rows.KIND] = rows.SET_TRANSFORMATION
    command[rows.TRANSFORMATION_OF_SEGMENTS] = 1.0 if begin else 0.0
    corners = places(length, CHUNK)
    best = float("inf")
    for _ in range(10 * REPEATS):
        queue = CommandQueue(channel.path, channel.queue.look_ahead)
        queue.put(command)
        start = time.perf_counter()
        for i in range(CHUNK):
            queue.put_segment(
                *(0, i, corners[i], corners[i + 1], rows.FEED_MOTION, 200.0, False, 0.0, False),
                None,
            )
        best = min(best, time.perf_counter() - start)
    return CHUNK / best


def ns_per_tick(begin: str, motion: str) -> float:
    """The best time of a tick in ns, decoding and preparation included."""
    text = f"{begin}G01 F6000 X100 Y0 Z0 A20 C10\n$WHILE 1\n{motion}$ENDWHILE\nM30\n"
    best = float("inf")
    for _ in range(max(2, REPEATS // 6)):
        controller = Controller("demo5")
        start = time.perf_counter()
        run = controller.run(
            NcText("ticks.nc", text), ticks=TICKS, memory_trace=False, record_writes=False
        )
        assert run.errors == (), run.errors
        best = min(best, (time.perf_counter() - start) / TICKS * 1e9)
    return best


def main() -> None:
    """Print a line for each case, without and with the transformation."""
    form = "compiled" if is_compiled() else "plain"
    print(f"Python {platform.python_version()}, {platform.machine()}, {form}\n")
    print(f"{'':40} {'untransformed':>14} {'type 91':>10}")
    for name, length in (("blocks/s of 0.1 mm", 0.1), ("blocks/s of 1 mm", 1.0)):
        found = [blocks_per_second(begin, length) for begin in (OFF, ON)]
        print(f"{name:40} {found[0]:14,.0f} {found[1]:10,.0f}")
    far = "X140 Y40 Z20 A35 C60\nX100 Y0 Z0 A20 C10\n"
    short = "".join(f"X{100 + i} Y{i % 3} A{20 + 0.2 * i} C{10 + 0.3 * i}\n" for i in range(40))
    for name, motion in (("ns/tick, long lines", far), ("ns/tick, lines of 1 mm", short)):
        found = [ns_per_tick(begin, motion) for begin in (OFF, ON)]
        print(f"{name:40} {found[0]:14,.0f} {found[1]:10,.0f}")


if __name__ == "__main__":
    main()
