# SPDX-License-Identifier: MIT
"""A PLC with the override at 33 %."""


class Plc:
    """The operator has turned the knob down."""

    def cycle(self, hli):
        hli.override_pct = 33
