# SPDX-License-Identifier: MIT
"""``python -m benchmarks.kinematics``: what a kinematic map costs, there and back, in ns.

Heads and tables with five axes, RTCP and complete. What a call from Python costs is taken off: it
is that of a call with the same arguments that returns at once. The best of several repetitions.
"""

from __future__ import annotations

import platform
import time
from collections.abc import Callable
from functools import partial

from nctakt.base.mode import is_compiled
from nctakt.decoder.kinematics.chain import Chain, Joint, ProgrammedAngles, X, Y, Z, map_values
from nctakt.kernel.kinematics.maps import KinematicMaps

REPEATS = 60 if is_compiled() else 5
CALLS = 10_000 if is_compiled() else 2_000
AXES = 5
POINT = (1.0, 2.0, 150.0)

LINEAR = tuple(Joint(i, False, direction) for i, direction in enumerate((X, Y, Z)))
HEAD = (Joint(3, True, Z, POINT), Joint(4, True, X, POINT))
TABLE = (Joint(3, True, (0.0, 0.0, -1.0), POINT), Joint(4, True, (-1.0, 0.0, 0.0), POINT))
ANGLES = ProgrammedAngles(3, 4, Z, X)

CHAINS = {
    "head C A, RTCP": Chain(LINEAR + HEAD),
    "table C A, RTCP": Chain(TABLE + LINEAR),
    "C in the table, A in the head, RTCP": Chain(TABLE[:1] + LINEAR + HEAD[1:]),
    "C between the linear axes, RTCP": Chain(LINEAR[:2] + HEAD[:1] + LINEAR[2:] + HEAD[1:]),
    "head C A, complete": Chain(LINEAR + HEAD, angles=ANGLES),
}


def doubles(values: list[float]) -> memoryview[float]:
    """Return values as the realtime part wants them."""
    row = memoryview(bytearray(8 * len(values))).cast("d")
    for i, value in enumerate(values):
        row[i] = value
    return row


def best_ns(call: Callable[[], object]) -> float:
    """Return the shortest time of a call, in ns."""
    seconds = float("inf")
    for _ in range(REPEATS):
        begin = time.perf_counter()
        for _ in range(CALLS):
            call()
        seconds = min(seconds, time.perf_counter() - begin)
    return seconds / CALLS * 1e9


def main() -> None:
    """Print a line for each map."""
    print(f"{platform.machine()}, Python {platform.python_version()}, compiled {is_compiled()}")
    print(f"{'map':38} {'forward':>9} {'inverse':>9} {'both':>9}")
    zero = doubles([0.0] * AXES)
    for name, chain in CHAINS.items():
        maps = KinematicMaps(AXES)
        number = maps.add(map_values(chain, range(AXES), 100.0))
        axes = doubles([10.0, -20.0, 30.0, 33.0, -41.0])
        tool, back = doubles([0.0] * AXES), doubles([0.0] * AXES)
        empty = best_ns(partial(maps.aim, number, zero, zero, zero))
        maps.forward(number, axes, axes, tool)
        forward = best_ns(partial(maps.forward, number, axes, axes, tool)) - empty
        inverse = best_ns(partial(maps.inverse, number, tool, axes, back)) - empty
        print(f"{name:38} {forward:9.0f} {inverse:9.0f} {forward + inverse:9.0f}")


if __name__ == "__main__":
    main()
