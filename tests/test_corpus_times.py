# SPDX-License-Identifier: MIT
"""How long foreign programs of lines and arcs take (MO-2, MO-3), where NCTAKT_CORPUS names them.

The bound is no controller's: each block's length by its feed, as if axes had no acceleration, read
from the text by the few lines below and by nothing of nctakt's.
"""

from __future__ import annotations

import math
import os
import re
from pathlib import Path

import pytest

from nctakt.run.controller import Controller, NcText

CORPUS = Path(os.environ.get("NCTAKT_CORPUS", ""))

#: The demo machine's rapid speed in mm/s, its tick in seconds.
RAPID, TICK = 500.0, 0.001

#: What is taken out for both: G20 and G21 mirror in this dialect, the tool has no radius, and the
#: demo machine's zero offset lies somewhere else.
LEFT_OUT = re.compile(r"\([^)]*\)|;.*|\b(?:G(?:2[01]|4[0-2]|54)\b|[DTN]\d+)")
WORD = re.compile(r"([A-Z])\s*([-+]?(?:\d+\.?\d*|\.\d+))")

#: The axes of each plane, and the words of its centre.
PLANES = {17: "XYIJ", 18: "ZXKI", 19: "YZJK"}

PROGRAMS = (
    "arc-ijk",
    "arc-xy-plane",
    "arc-xz-plane",
    "arc-yz-plane",
    "circle",
    "circle-inch",
    "g2-arc",
    "helical-thread-milling",
    "jsdc",
)


def least_time(text: str) -> float:
    """The seconds of a program on a machine without inertia."""
    place = dict.fromkeys("XYZ", 0.0)
    motion, plane, relative, feed, seconds = 0, 17, False, 0.0, 0.0
    for line in text.splitlines():
        words = [(letter, float(value)) for letter, value in WORD.findall(line)]
        for value in (int(value) for letter, value in words if letter == "G"):
            motion = value if value <= 3 else motion
            plane = value if value in PLANES else plane
            relative = value == 91 if value in (90, 91) else relative
        given = dict(words)
        feed = given.get("F", feed)
        wanted = {axis: given[axis] for axis in "XYZ" if axis in given}
        if not wanted and not given.keys() & set("IJK"):
            continue
        target = place | {axis: place[axis] * relative + by for axis, by in wanted.items()}
        ways = {axis: target[axis] - place[axis] for axis in "XYZ"}
        if motion == 0:
            seconds += max(abs(way) for way in ways.values()) / RAPID
        elif motion == 1:
            seconds += math.hypot(*ways.values()) / (feed / 60)
        else:
            seconds += arc_length(motion, plane, ways, given) / (feed / 60)
        place = target
    return seconds


def arc_length(motion: int, plane: int, ways: dict[str, float], given: dict[str, float]) -> float:
    """The length of an arc or helix, by its centre or by its radius."""
    first, second, *centre = PLANES[plane]
    chord = complex(ways[first], ways[second])
    rise = math.hypot(*ways.values()) ** 2 - abs(chord) ** 2
    if "R" in given:
        radius = abs(given["R"])
        angle = 2 * math.asin(min(1.0, abs(chord) / 2 / radius))
        return math.sqrt((radius * angle) ** 2 + rise)
    to_centre = complex(*(given.get(word, 0.0) for word in centre))
    turn = (chord - to_centre) / -to_centre
    angle = math.atan2(turn.imag, turn.real) * (1 if motion == 3 else -1)
    return math.sqrt((abs(to_centre) * (angle % math.tau or math.tau)) ** 2 + rise)


@pytest.mark.skipif("NCTAKT_CORPUS" not in os.environ, reason="NCTAKT_CORPUS names no folder")
@pytest.mark.parametrize("name", PROGRAMS)
def test_foreign_arcs_take_hardly_longer_than_without_inertia(name: str) -> None:
    """Within 3 % of a bound that no machine can reach, and never below it."""
    file = CORPUS / "cncjs" / f"examples_gcode_{name}.gcode"
    text = LEFT_OUT.sub("", file.read_text("latin-1"))
    run = Controller().run(NcText(file.name, text + "\nM30\n"), memory_trace=False, signals=[])
    assert (run.state, run.errors) == ("ended", ())
    minimum = least_time(text)
    assert minimum <= run.ticks * TICK <= 1.03 * minimum
