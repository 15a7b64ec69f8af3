# SPDX-License-Identifier: MIT
"""A PLC that takes its time: ``nctakt run examples/crossing.nc --plc examples/slow_plc.py``."""

from nctakt import HliView


class SlowPlc:
    """Acknowledges each function after 200 ms; until then the path runs at half speed."""

    def cycle(self, hli: HliView) -> None:
        waiting = hli.functions()
        hli.override_pct = 50 if waiting else 100
        for function in waiting:
            if hli.time_us - function.time_us >= 200_000:
                hli.acknowledge(function)
