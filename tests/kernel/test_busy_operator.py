# SPDX-License-Identifier: MIT
"""Short rounded corners, and an operator whose hands are never still (MO-1, MO-5, MO-6, MO-7)."""

from __future__ import annotations

import random

from support.motion_checks import assert_smooth, run_of
from support.random_seeds import seeds_in_parts

from nctakt.run.access.stimuli import Stimulus

#: What the operator uses in one program: single block, hold, override, backward motion.
HABITS = (
    ("SINGLE_BLOCK", "FEED_HOLD"),
    ("SINGLE_BLOCK", "OVERRIDE"),
    ("SINGLE_BLOCK", "FEED_HOLD", "OVERRIDE"),
    ("BACKWARD_MOTION", "FEED_HOLD", "OVERRIDE"),
    ("BACKWARD_MOTION", "SINGLE_BLOCK", "FEED_HOLD", "OVERRIDE"),
)

#: How often a switch is set to on.
SHARES = {"SINGLE_BLOCK": 0.5, "FEED_HOLD": 0.4, "BACKWARD_MOTION": 0.4}

#: When the operator lets go, in ms.
CALM_MS = 1000


def program(chance: random.Random) -> str:
    """Three to five blocks, so short that the operator is in time; on some only cycles override."""
    deviation = chance.choice((0.01, 0.05, 0.2, 1.0))
    lines = [
        "#SLOPE [TYPE=TRAPEZ]",
        f"#CONTOUR MODE [DEV PATH_DEV={deviation}]",
        "G261 G91 G01 X5 F6000",
    ]
    for number in range(chance.randint(2, 4)):
        x, y = chance.uniform(1, 12), chance.uniform(-12, 12)
        z = chance.choice((0.0, 0.0, chance.uniform(-3, 3)))
        feed = chance.choice((1000, 3000, 6000, 12000, 30000))
        own = " G166" if chance.random() < 0.25 else ""
        lines.append(f"N{10 * number + 10} X{x:.3f} Y{y:.3f} Z{z:.3f} F{feed}{own}")
    return "\n".join([*lines, "M30"])


def hands(chance: random.Random) -> list[Stimulus]:
    """What the operator does until ``CALM_MS``, then all that lets the path come to its end."""
    habit = chance.choice(HABITS)
    longest_ms = chance.choice((4, 10, 25)) * 2
    found: list[Stimulus] = []
    now_ms = 2 * chance.randint(1, 75)
    while now_ms < CALM_MS:
        what = chance.choice(habit)
        if what == "OVERRIDE":
            value = chance.choice((0.0, 20.0, 50.0, 90.0, 100.0, 110.0))
        else:
            value = float(chance.random() < SHARES[what])
        found.append(Stimulus(f"{now_ms} ms", f"HLI.{what}", value))
        if what == "SINGLE_BLOCK":
            found.append(Stimulus(f"{now_ms + 30} ms", "HLI.START", 1.0))
        now_ms += 2 * chance.randint(1, longest_ms // 2)
    found.append(Stimulus(f"{CALM_MS} ms", "HLI.OVERRIDE", 100.0))
    found += [Stimulus(f"{CALM_MS} ms", f"HLI.{switch}", 0.0) for switch in SHARES]
    return found + [Stimulus(second, "HLI.START", 1.0) for second in (2, 4, 8, 16)]


@seeds_in_parts(60, 4, 20)
def test_short_bends_keep_the_limits_whatever_is_commanded(seeds: range) -> None:
    """Each axis keeps speed, acceleration and jerk in every tick, on four machines."""
    for seed in seeds:
        chance = random.Random(seed)
        number = chance.randrange(4)
        assert_smooth(number, run_of(number, program(chance), hands(chance)))
