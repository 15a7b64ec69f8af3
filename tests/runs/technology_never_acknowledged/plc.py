# SPDX-License-Identifier: MIT
"""A PLC that does nothing."""


class Plc:
    """Acknowledges nothing."""

    def cycle(self, hli):
        pass
