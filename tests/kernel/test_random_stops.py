# SPDX-License-Identifier: MIT
"""A stop in any tick, of any kind, stays on the path and within the limits (MO-1, MO-6, RC-007)."""

from __future__ import annotations

import random

import pytest
from support.motion_checks import SIGNALS, stop_violations, violations
from support.motion_machines import machine
from support.motion_programs import MotionProgram
from support.random_seeds import seeds_in_parts

from nctakt.run.access.stimuli import Stimulus
from nctakt.run.controller import Controller, NcText

#: This many ticks after the stop everything is at rest.
BRAKING_TICKS = 1500

SLOPES = (("STEP",), ("TRAPEZ",), ("STEP", "TRAPEZ"))
#: Stops of the operator: what they switch.
SWITCHES = {"hold": "HLI.FEED_HOLD", "single block": "HLI.SINGLE_BLOCK", "reset": "HLI.RESET"}
#: Stops of a realtime cycle: what it does.
ACTIONS = {
    "error of the user": "#ERROR [ID=815 RC=2]",
    "fault": "V.E.VALUE1 = 1 / [V.E.COUNT - V.E.COUNT]",
    "override": "V.RTG.OVERRIDE.VEL.CYCLE = 0",
}
#: The numbers of the errors of these stops, and of contours that the tool does not fit into.
ERRORS = {900464, 50879}
KINDS = (*SWITCHES, *ACTIONS)


def cycle(action: str) -> str:
    """The realtime cycle that acts while V.E.TRIGGER is 1."""
    head = "#RT CYCLE [ID=9 SCOPE=PROG]\n$IF V.E.TRIGGER == 1"
    return f"{head}\n{action}\n$ENDIF\n#RT CYCLE END\n"


def wrong_with(seed: int, kind: str) -> list[str]:
    """What is wrong with the run of a seed's program that this stops in a tick of the seed's."""
    chance = random.Random(seed)
    program = MotionProgram(seed, SLOPES[seed // 4 % 3], 25)
    chosen = machine(seed % 4)
    tick = chance.randint(1, chance.choice((60, 600, 2500)))
    backward = chance.random() < 0.25
    text, name = program.text, SWITCHES.get(kind, "V.E.TRIGGER")
    if kind in ACTIONS:
        text = cycle(ACTIONS[kind]) + text
    stimuli = [Stimulus(f"{tick} ticks", name, 1.0)]
    if backward:
        before = max(tick - chance.randint(1, 300), 1)
        stimuli.append(Stimulus(f"{before} ticks", "HLI.BACKWARD_MOTION", 1.0))
        end = tick + BRAKING_TICKS
        stimuli.append(Stimulus(f"{end} ticks", "HLI.BACKWARD_MOTION", 0.0))
    run = Controller(chosen.configuration).run(
        NcText("p.nc", text),
        signals=SIGNALS,
        ticks=tick + BRAKING_TICKS,
        at=stimuli,
        record_writes=False,
    )
    if run.state == "ended":
        return violations(program, run, chosen)
    found = {error.id for error in run.errors}
    if run.state == "error" and not (found <= ERRORS or program.has_compensation):
        return [f"{[error.text for error in run.errors]}"]
    # Single block lets a block come to its end, and another cycle may turn the override as well.
    stands = kind != "single block" and not (kind == "override" and program.has_wave)
    return stop_violations(program, run, chosen, stands=stands)


@pytest.mark.parametrize("kind", KINDS)
@seeds_in_parts(40, 4, 10)
def test_a_stop_in_any_tick_stays_on_the_path(seeds: range, kind: str) -> None:
    """MO-6: with each kind of slope, forward and backward, whatever stops the path."""
    for seed in seeds:
        assert wrong_with(seed, kind) == [], seed
