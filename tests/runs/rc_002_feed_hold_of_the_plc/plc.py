# SPDX-License-Identifier: MIT
"""A PLC that holds the feed for a while."""


class Plc:
    """Feed hold from tick 40 to tick 99."""

    def cycle(self, hli):
        hli.feed_hold = 39 <= hli.tick < 99
