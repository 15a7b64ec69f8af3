# SPDX-License-Identifier: MIT
"""A PLC that writes a variable and the override at known ticks."""


class Plc:
    """Answers after ticks 49, 99 and 299."""

    def cycle(self, hli):
        if hli.tick == 49:
            hli.write("V.E.TRIGGER", 1)
        if hli.tick == 99:
            hli.override_pct = 0
        if hli.tick == 299:
            hli.override_pct = 100
