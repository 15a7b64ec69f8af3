# SPDX-License-Identifier: MIT
"""The realtime part without a decoder: rows are put into the queue by hand, ticks run one by one.

The machine is the demo machine: T 1 ms, X Y Z A, 500 mm/s, 4000 mm/s², trapezoid.
"""

from __future__ import annotations

import itertools
import shutil
from collections.abc import Sequence
from pathlib import Path

from nctakt.kernel import rows
from nctakt.kernel.cycles.cycles import RealtimeCycle
from nctakt.kernel.cycles.instructions import Statement
from nctakt.lists.machine.machine import load_machine
from nctakt.run.controller import Controller
from nctakt.run.realtime.assembly import AssembledMachine

DEMO = load_machine(None)
TICK_T = 0.001
ACCELERATION = 4000.0
RAPID = 500.0


class Rig:
    """One machine with its first channel; ``x`` are the command positions of X, tick by tick."""

    def __init__(self) -> None:
        self.machine = AssembledMachine(DEMO)
        self.channel = self.machine.channels[0]
        self.x: list[float] = []
        self.end = 0.0
        self._serials = 0

    def segment(
        self,
        length: float,
        *,
        speed: float = RAPID,
        end_speed: float = 0.0,
        exact_stop: bool = True,
        number: int = 0,
    ) -> None:
        """Append a straight motion of X, forward."""
        start, self.end = self.end, self.end + length
        row = [0.0] * rows.segment_width(self.channel.path.count)
        row[rows.KIND] = rows.SEGMENT
        row[rows.BLOCK_NUMBER] = number
        row[rows.LENGTH] = length
        row[rows.SPEED] = speed
        row[rows.MAX_SPEED] = RAPID
        row[rows.ACCELERATION] = ACCELERATION
        row[rows.END_SPEED] = end_speed
        row[rows.EXACT_STOP] = exact_stop
        row[rows.START] = start
        row[rows.START + self.channel.path.count] = self.end
        self.channel.queue.put(row)

    def dwell(self, ticks: int) -> None:
        """Append a dwell."""
        self.channel.queue.put([rows.DWELL, 0, 0, ticks])

    def flush(self) -> None:
        """Append a flush that nobody waits for."""
        self.channel.queue.put([rows.FLUSH, 0, 0, 0])

    def cycle(self, scope: int, identity: int = 0) -> RealtimeCycle:
        """Append the definition of an empty cycle; its ``runs`` say when it ran."""
        self._serials += 1
        made = RealtimeCycle(Statement(), self._serials, 3, 0)
        slot = self.channel.manager.load(made, identity, scope, 0)
        self.channel.queue.put([rows.DEFINE_CYCLE, 0, 0, slot, 1])
        return made

    def run(self, ticks: int) -> list[float]:
        """Run, and give the positions of X after each tick."""
        before = len(self.x)
        for _ in range(ticks):
            self.machine.reserve()
            self.machine.kernel.run(1)
            self.machine.record.take_events()
            self.machine.record.take_probes()
            self.x.append(self.machine.positions()[0])
        return self.x[before:]

    def run_to_the_end(self, maximum: int = 200_000) -> int:
        """Run until the queue is empty and the path is at rest: the ticks that it took."""
        for ticks in range(maximum):
            if not self.channel.queue.queued() and not self.channel.path.is_active:
                return ticks
            self.run(1)
        raise AssertionError("the path never ends")


def speeds(positions: Sequence[float], start: float = 0.0) -> list[float]:
    """Mean speeds of the ticks."""
    return [
        (after - before) / TICK_T
        for before, after in zip([start, *positions], positions, strict=False)
    ]


def assert_within_limits(positions: Sequence[float], speed: float = RAPID) -> None:
    """No tick is faster than ``speed``, no two differ by more than the acceleration allows.

    The mean speeds of two ticks differ by at most a·T, whatever happens within them (MO-1).
    """
    found = [0.0, *speeds(positions), 0.0]
    for before, after in itertools.pairwise(found):
        assert -1e-6 <= after <= speed + 1e-6
        assert abs(after - before) <= ACCELERATION * TICK_T + 1e-6


def controller_with(folder: Path, *entries: str) -> Controller:
    """A controller of the demo machine with further entries in its channel list."""
    machine = folder / "machine"
    shutil.copytree(DEMO.folder, machine)
    channel = machine / "sda_mds1.lis"
    text = channel.read_text("utf-8").replace("\nEnde", "\n" + "\n".join(entries) + "\nEnde")
    channel.write_text(text, "utf-8")
    return Controller(load_machine(machine))
