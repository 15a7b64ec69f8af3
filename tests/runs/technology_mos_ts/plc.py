# SPDX-License-Identifier: MIT
"""A PLC that stores stamps."""


class Plc:
    """Writes the stamp of each function into V.E.COUNT and acknowledges it."""

    def cycle(self, hli):
        for function in hli.functions():
            hli.write("V.E.COUNT", function.time_us)
            hli.acknowledge(function)
