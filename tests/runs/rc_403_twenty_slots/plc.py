# SPDX-License-Identifier: MIT
"""A PLC that acknowledges once."""


class Plc:
    """Acknowledges the oldest function after tick 19."""

    def cycle(self, hli):
        if hli.tick == 19:
            hli.acknowledge(hli.functions()[0])
