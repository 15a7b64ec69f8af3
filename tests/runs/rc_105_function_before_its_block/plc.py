# SPDX-License-Identifier: MIT
"""A PLC that takes 3 ms for each function."""


class Plc:
    """Acknowledges what is 3 ms old."""

    def cycle(self, hli):
        for function in hli.functions():
            if hli.time_us - function.time_us >= 3000:
                hli.acknowledge(function)
