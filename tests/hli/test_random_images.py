# SPDX-License-Identifier: MIT
"""Bytes that chance writes into the interface image: what the PLC may write, and what it may not.

What is in the CNC's own areas is written anew after each tick and never read back: a run whose
image is scribbled over there gives the same positions. In the PLC's areas anything is allowed:
values that cannot be are refused, serials that nobody gave acknowledge nothing, and the channel
stays in one of its states with finite positions. ``NCTAKT_SEEDS=100000`` makes as many images.
"""

from __future__ import annotations

import math
from random import Random

from support.random_seeds import seeds_in_parts

from nctakt.hli.operator_panel import STATES
from nctakt.hli.places import ImageLayout
from nctakt.lists.machine.machine import load_machine
from nctakt.run.controller import Controller, NcText

DEMO = load_machine(None)
PROGRAM = """\
#RT CYCLE [ID=1 SCOPE=PROG]
$IF EDGE V.E.TRIGGER == 1
M102
$ENDIF
#RT CYCLE END
M111
G01 X5 F6000
S3[M3 REV=500]
M112 H1
G01 Y3
M30
"""
#: Ticks of one run, with the image written in between.
TICKS = 60
#: Bit patterns that numbers have at their edges: NaN, infinity, -1, the largest, one half.
PATTERNS = (
    bytes.fromhex("000000000000f87f"),
    bytes.fromhex("000000000000f07f"),
    b"\xff" * 8,
    bytes.fromhex("ffffffffffffef7f"),
    bytes.fromhex("000000000000e03f"),
    bytes(8),
)


def scribble(chance: Random, memory: memoryview, begin: int, end: int) -> None:
    """Write some bytes at a random place of an area."""
    size = min(8, end - begin)
    place = chance.randrange(begin, end - size + 1)
    pattern = chance.choice((*PATTERNS, chance.randbytes(8), chance.randbytes(8)))
    memory[place : place + size] = pattern[:size]


def plcs_areas(layout: ImageLayout) -> list[tuple[int, int]]:
    """The commands of channels and spindles, and the V.E variables."""
    return [
        (layout.command_offset, layout.spindle_command_offset),
        (layout.spindle_command_offset, layout.ve_offset),
        (layout.ve_offset, layout.size),
    ]


def started() -> Controller:
    """A controller in the midst of its program."""
    controller = Controller(DEMO)
    controller.start(NcText("p.nc", PROGRAM))
    return controller


def positions(controller: Controller) -> list[float]:
    """The command positions of all axes."""
    return [controller.hli.axis(axis.name)["command"] for axis in controller.channel_axes]


@seeds_in_parts(100, 20, 25)
def test_any_bytes_of_the_plc_leave_the_controller_sound(seeds: range) -> None:
    """Finite positions, a known state, diagnostics for what cannot be."""
    for seed in seeds:
        chance = Random(seed)
        controller = started()
        with controller.interface_image() as image:
            while controller.tick < TICKS:
                for _ in range(chance.randint(1, 6)):
                    scribble(chance, image.memory, *chance.choice(plcs_areas(image.layout)))
                controller.step(chance.randint(1, 9))
                assert controller.hli.state in STATES, seed
                assert all(map(math.isfinite, positions(controller))), seed
                assert all(one.render() for one in controller.diagnostics), seed


@seeds_in_parts(30, 6, 10)
def test_bytes_in_the_areas_of_the_cnc_change_no_run(seeds: range) -> None:
    """Header, channels, axes and spindles are what the CNC says, whatever is there."""
    for seed in seeds:
        chance = Random(seed)
        undisturbed, controller = started(), started()
        with undisturbed.interface_image(), controller.interface_image() as image:
            while controller.tick < TICKS:
                layout = image.layout
                scribble(chance, image.memory, layout.channel_offset, layout.command_offset)
                ticks = chance.randint(1, 9)
                controller.step(ticks)
                undisturbed.step(ticks)
                assert positions(controller) == positions(undisturbed), seed
                assert controller.hli.state == undisturbed.hli.state, seed
        assert controller.diagnostics == undisturbed.diagnostics, seed
