# SPDX-License-Identifier: MIT
"""An operator who does at random what a panel allows, for tests that look at every tick."""

from __future__ import annotations

import random

from nctakt.run.plcs.plc_view import PlcView

#: The operator lets go after this many ticks.
PLAY_TICKS = 4000


class Operator:
    """Turns the override, holds the feed, switches single block, goes back: what is asked for."""

    def __init__(self, seed: int, ways: str) -> None:
        self.chance = random.Random(seed)
        self.ways = ways
        self.next_tick = 1

    def cycle(self, hli: PlcView) -> None:
        hli.acknowledge_all()
        plays = hli.tick < PLAY_TICKS
        if not plays:
            hli.single_block = False
        if hli.tick < self.next_tick:
            return
        self.next_tick = hli.tick + self.chance.choice((1, 5, 40, 150, 400))
        if "override" in self.ways:
            hli.override_pct = self.chance.choice((0.0, 3.0, 50.0, 80.0, 100.0)) if plays else 100.0
        if "hold" in self.ways:
            hli.feed_hold = plays and self.chance.random() < 0.2
        if "back" in self.ways:
            hli.backward_motion = plays and self.chance.random() < 0.5
        if "single" in self.ways:
            hli.single_block = plays and self.chance.random() < 0.4
        if self.chance.random() < 0.7 or not plays:
            hli.start()
