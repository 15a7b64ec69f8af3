# SPDX-License-Identifier: MIT
"""A PLC that takes its time."""


class Plc:
    """Acknowledges each function 80 ticks after its output."""

    def cycle(self, hli):
        for function in hli.functions():
            if hli.time_us - function.time_us >= 80_000:
                hli.acknowledge(function)
