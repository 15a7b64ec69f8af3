# SPDX-License-Identifier: MIT
"""What the preparation of a block costs, counted in calls and not in time (MO-3).

A block can raise the speeds of those before it, but only so far back: each costs the same, however
long the program is. Calls are counted in the plain mode, in its own process.
"""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

from nctakt.base.mode import is_compiled

#: Puts this many blocks of a kind into the queue and counts the calls that each of them costs.
COUNTING = """
import math, sys
from nctakt.kernel import rows
from nctakt.run.realtime.assembly import AssembledMachine
from nctakt.lists.machine.machine import load_machine

kind, blocks = sys.argv[1], int(sys.argv[2])
length = {"short": 0.01, "long": 1.0, "smooth": 0.05, "arcs": 0.3}[kind]
channel = AssembledMachine(load_machine(None)).channels[0]
calls = 0

def count(frame, event, argument):
    global calls
    calls += event == "call"

place, heading, turn = (0.0, 0.0), 0.0, 0.1 if kind == "arcs" else 0.0
sys.setprofile(count)
for number in range(blocks):
    start, arc = place, None
    if turn:
        radius = length / turn
        centre = (start[0] - math.sin(heading) * radius, start[1] + math.cos(heading) * radius)
        heading += turn
        place = (centre[0] + math.sin(heading) * radius, centre[1] - math.cos(heading) * radius)
        arc = (0.0, 1.0, *centre, math.degrees(turn))
    else:
        place = (start[0] + length, start[1])
    ends = (*start, 0.0, 0.0), (*place, 0.0, 0.0)
    is_smooth = kind == "smooth"
    channel.queue.put_segment(0, number, *ends, rows.FEED_MOTION, 200.0, False, 0.0, is_smooth, arc)
sys.setprofile(None)
print(calls / blocks)
"""


def calls_per_block(kind: str, blocks: int) -> float:
    """How many calls of functions a block costs."""
    done = subprocess.run(
        [sys.executable, "-c", COUNTING, kind, str(blocks)],
        env={**os.environ, "NCTAKT_PLAIN": "1"},
        capture_output=True,
        text=True,
        check=True,
    )
    return float(done.stdout)


@pytest.mark.skipif(is_compiled(), reason="calls are counted in the plain mode")
@pytest.mark.parametrize("kind", ["short", "long", "smooth", "arcs"])
def test_the_cost_of_a_block_does_not_grow_with_the_program(kind: str) -> None:
    """Three times as many cost three times as much: lines, limited jerk, arcs by their angle."""
    few, many = calls_per_block(kind, 300), calls_per_block(kind, 900)
    assert many <= 1.4 * few
