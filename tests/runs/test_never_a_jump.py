# SPDX-License-Identifier: MIT
"""Random programs whose realtime cycles and path move the same axes (RC-409, MO-1, MO-13).

Cycles send axes to positions, by distances, endlessly, and stop them; they are held, continued,
aborted, deleted and started again, while blocks of the path program the same axes. Some programs
end with an error, which is a way to end as well; none may make an axis jump. Nor may a PLC that
commands the same axes, holds the feed, changes the override and presses START and RESET.
"""

from __future__ import annotations

from random import Random

import numpy as np
from support.random_seeds import seeds_in_parts

from nctakt.plc import MC_Halt, MC_MoveAbsolute, MC_MoveRelative, MC_MoveVelocity, MC_Reset, Plc
from nctakt.plc.axes import AxisBlock
from nctakt.results.run import Run
from nctakt.run.controller import Controller
from nctakt.run.plc_view import PlcView
from nctakt.run.program_loader import NcText

AXES = ("X", "Y", "Z", "A")
#: Highest way of an axis in a tick of 1 ms: 500 mm/s, 360 degrees/s.
HIGHEST = {"X": 0.5, "Y": 0.5, "Z": 0.5, "A": 0.36}
#: Highest change of that way from tick to tick: 4000 mm/s² and degrees/s².
HIGHEST_CHANGE = 0.004
TICKS = 20_000

#: What a program may end with: an axis that is not free, a start elsewhere, too many actions, …
EXPECTED_ERRORS = {50858, 50967, 51028, 900420, 50603, 1704, 50766}


class Generator:
    """One program from one seed."""

    def __init__(self, seed: int) -> None:
        self.chance = Random(seed)
        self.lines: list[str] = []
        self.next_id = 1
        self.known: list[int] = []

    def program(self) -> str:
        """The program's text."""
        for _ in range(self.chance.randint(6, 14)):
            self.chance.choice((self.block, self.block, self.cycle, self.control, self.dwell))()
        return "\n".join([*self.lines, "M30", ""])

    def block(self) -> None:
        """A motion of the path."""
        chance = self.chance
        axes = chance.sample(AXES, chance.randint(1, 3))
        words = " ".join(f"{axis}{chance.uniform(-60, 60):.3f}" for axis in axes)
        self.lines.append(f"{chance.choice(('G00', 'G01 F6000', 'G01 F25000'))} {words}")

    def dwell(self) -> None:
        """A wait."""
        self.lines.append(f"G04 {self.chance.uniform(0.001, 0.4):.3f}")

    def cycle(self) -> None:
        """A cycle with one to three commands."""
        chance = self.chance
        words = [f"SCOPE={chance.choice(('BLOCK', 'PROG', 'GLOBAL'))}"]
        words.append(f"END_ACTION={chance.choice(('MOVE_ABORT', 'MOVE_CONT'))}")
        words.append(f"ID={self.next_id}")
        self.known.append(self.next_id)
        self.next_id += 1
        is_defined = chance.random() < 0.3
        self.lines.append(f"#RT CYCLE {'DEF ' if is_defined else ''}[{' '.join(words)}]")
        for _ in range(chance.randint(1, 3)):
            when = chance.choice(("ONCE", "ONCE", "EDGE"))
            axis = chance.choice(("X", "Y", "Z"))
            compared = (
                f"V.RTA.ACS.ACT_POS.{axis} {chance.choice('<>')} {chance.uniform(-40, 40):.2f}"
            )
            self.lines += [f"$IF {when} {compared}", self.command(), "$ENDIF"]
        self.lines.append("#RT CYCLE END")

    def command(self) -> str:
        """A single-axis command."""
        chance = self.chance
        axis = chance.choice(AXES)
        mode = chance.choice(("", "ABORTING ", "BUFFERED "))
        feed = f"FEED={chance.uniform(200, 30000):.1f}"
        position = f"POS={chance.uniform(-80, 80):.3f}"
        return chance.choice(
            (
                f"{axis}[INDP {mode}G90 G00 {position}]",
                f"{axis}[INDP {mode}G90 G01 {feed} {position}]",
                f"{axis}[INDP {mode}G91 {feed} {position}]",
                f"{axis}[INDP {mode}{feed} DIR={chance.choice(('POS', 'NEG', 'CUR'))}]",
                f"{axis}[INDP STOP]",
            )
        )

    def control(self) -> None:
        """A management command for a cycle that was defined, living or not."""
        if not self.known:
            return
        chance = self.chance
        action = chance.choice(("HOLD", "CONTINUE", "ABORT ACTION", "DELETE", "START"))
        self.lines.append(f"#RT CYCLE {action} [ID={chance.choice(self.known)}]")


class RandomPlc(Plc):
    """Does what comes to its mind."""

    def __init__(self, seed: int) -> None:
        self.chance = Random(seed)
        self.blocks: list[tuple[AxisBlock, dict[str, object]]] = []

    def each_tick(self, hli: PlcView) -> None:
        """Follow the blocks that are busy, and now and then do something new."""
        for block, inputs in self.blocks:
            block(hli, execute=True, **inputs)  # type: ignore[operator]
        self.blocks = [one for one in self.blocks if one[0].busy]
        chance = self.chance
        if chance.random() < 0.02:
            self.blocks.append(self.command(chance.choice(AXES)))
        if chance.random() < 0.002:
            hli.reset()
        if chance.random() < 0.01:
            hli.start()
        if chance.random() < 0.01:
            hli.feed_hold = chance.random() < 0.3
        if chance.random() < 0.01:
            hli.override_pct = chance.choice((0, 20, 100, 120))

    def command(self, axis: str) -> tuple[AxisBlock, dict[str, object]]:
        """A block with its inputs."""
        chance = self.chance
        speed = {"velocity": chance.uniform(1, 500), "buffered": chance.random() < 0.3}
        way = chance.uniform(-80, 80)
        choices: tuple[tuple[AxisBlock, dict[str, object]], ...] = (
            (MC_MoveAbsolute(axis), {"position": way, **speed}),
            (MC_MoveRelative(axis), {"distance": way, **speed}),
            (MC_MoveVelocity(axis), {"direction": chance.choice((1, -1, 0)), **speed}),
            (MC_Halt(axis), {}),
            (MC_Reset(axis), {}),
        )
        return chance.choice(choices)


def assert_within_limits(run: Run, seed: int) -> None:
    """MO-1: the speed and the acceleration of each axis, tick by tick."""
    assert run.trace is not None
    for axis, maximum in HIGHEST.items():
        steps = np.diff(run.trace[f"{axis}.ACS.ACT_POS"], prepend=0.0)
        if axis == "A":
            steps = (steps + 180.0) % 360.0 - 180.0
        assert np.abs(steps).max(initial=0.0) <= maximum * (1 + 1e-9), (seed, axis)
        changes = np.diff(steps, prepend=0.0)
        assert np.abs(changes).max(initial=0.0) <= HIGHEST_CHANGE * (1 + 1e-6), (seed, axis)


def run_of(seed: int) -> Run:
    """A run of the program of this seed."""
    program = NcText(f"seed{seed}.nc", Generator(seed).program())
    return Controller().run(program, ticks=TICKS)


@seeds_in_parts(50, 4, 25)
def test_no_axis_moves_or_changes_faster_than_it_can(seeds: range) -> None:
    """RC-409, MO-1: no command position ever changes by more than the axis' speed × tick.

    Nor does its change by more than its acceleration allows, whatever ends the program.
    """
    ended = 0
    for seed in seeds:
        run = run_of(seed)
        assert_within_limits(run, seed)
        found = {error.id for error in run.errors}
        assert found <= EXPECTED_ERRORS, seed
        ended += not found
    assert ended > len(seeds) // 4


@seeds_in_parts(20, 4, 10)
def test_nor_does_it_with_a_plc_that_commands_them(seeds: range) -> None:
    """MO-1, MO-13, RC-007: every second run waits for START, so that RESET does not end it."""
    for seed in seeds:
        program = NcText(f"seed{seed}.nc", Generator(seed).program())
        plc = RandomPlc(seed)
        waits = seed % 2 == 0
        run = Controller().run(program, ticks=3000, plc=plc, wait_for_start=waits)
        assert_within_limits(run, seed)
        assert {error.id for error in run.errors} <= EXPECTED_ERRORS | {50900}, seed
