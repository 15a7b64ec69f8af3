# SPDX-License-Identifier: MIT
"""A PLC that holds the feed at first."""


class Plc:
    """Feed hold in ticks 2 to 9."""

    def cycle(self, hli):
        hli.feed_hold = 1 <= hli.tick < 9
