# SPDX-License-Identifier: MIT
"""A PLC that never acknowledges."""


class Plc:
    """Looks on."""

    def cycle(self, hli):
        assert len(hli.functions()) in (0, 7)
