# SPDX-License-Identifier: MIT
"""Random programs that move single axes in each possible manner at once, and a PLC that joins in.

Cycles send axes to positions, by distances, endlessly, and stop them; they are held, continued,
aborted, deleted and started again. Blocks of the path program the same axes, and so do commands of
the program beside the path: INDP_SYN, INDP_ASYN, OSC.
"""

from __future__ import annotations

from random import Random

from nctakt.plc import MC_Halt, MC_MoveAbsolute, MC_MoveRelative, MC_MoveVelocity, MC_Reset, Plc
from nctakt.plc.axes import AxisBlock
from nctakt.run.plcs.plc_view import PlcView

AXES = ("X", "Y", "Z", "A")


class Generator:
    """One program from one seed; ``is_alone``: with commands of the program for single axes."""

    def __init__(self, seed: int, *, is_alone: bool = False) -> None:
        self.is_alone = is_alone
        self.chance = Random(seed)
        self.lines: list[str] = []
        self.next_id = 1
        self.known: list[int] = []

    def program(self) -> str:
        """The program's text."""
        kinds = [self.block, self.block, self.cycle, self.control, self.dwell]
        if self.is_alone:
            kinds += [self.alone, self.alone, self.oscillation, self.oscillation]
        for _ in range(self.chance.randint(6, 14)):
            self.chance.choice(kinds)()
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

    def alone(self) -> None:
        """Motions beside the path, or a wait for one."""
        chance = self.chance
        if chance.random() < 0.3:
            self.lines.append(f"#WAIT INDP [{chance.choice(AXES)}]")
            return
        words = []
        for axis in chance.sample(AXES, chance.randint(1, 2)):
            form = chance.choice(("INDP_SYN", "INDP_ASYN", "INDP_ASYN"))
            how = chance.choice(("G90", "G91"))
            feed = f"FEED={chance.uniform(200, 30000):.1f}"
            speed = chance.choice(("G00", f"G01 {feed}", f"TIME={chance.uniform(0.1, 1):.2f}"))
            words.append(f"{axis}[{form} {how} {speed} POS={chance.uniform(-60, 60):.3f}]")
        self.lines.append(" ".join(words))

    def oscillation(self) -> None:
        """The beginning or the end of an oscillation; A is a modulo axis from 0 to 360."""
        chance = self.chance
        axis = chance.choice(AXES)
        if chance.random() < 0.4:
            how = chance.choice(("", " INSTANT", f" FEED={chance.uniform(200, 30000):.1f}"))
            self.lines.append(f"{axis}[OSC OFF{how}]")
            return
        low, high = (0.0, 359.0) if axis == "A" else (-60.0, 60.0)
        first = chance.uniform(low, high)
        second = (low + high) / 2.0 if abs(first) > 1.0 else high
        words = [f"1ST_POS={first:.3f} 2ND_POS={second:.3f}"]
        feed, frequency = chance.uniform(200, 30000), chance.uniform(0.2, 8.0)
        words.append(chance.choice((f"FEED={feed:.1f}", f"FREQ={frequency:.2f}")))
        words.append(chance.choice(("", "1ST_DELT=0.02", "2ND_DELT=0.013")))
        words.append(chance.choice(("", "", "NBR_OSC=2", "INCL_OFFSETS")))
        words.append(chance.choice(("", "SHORT")))
        self.lines.append(f"{axis}[OSC ON {' '.join(words)}]")

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
