# SPDX-License-Identifier: MIT
"""A PLC that sleeps for a while."""


class Plc:
    """Acknowledges everything from tick 5 on."""

    def cycle(self, hli):
        if hli.tick >= 5:
            hli.acknowledge_all()
