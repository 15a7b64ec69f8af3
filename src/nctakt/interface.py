# SPDX-License-Identifier: MIT
"""What a scripted PLC gets in each tick: the HLI by names.

Everything that it writes counts from the next tick on (RC-002).
"""

from __future__ import annotations

from dataclasses import dataclass

from nctakt.assembly import Machine


@dataclass(frozen=True, slots=True)
class TechnologyEntry:
    """A function that waits for its acknowledgement.

    ``letter`` is M or H. ``sequence`` numbers the functions of realtime cycles within their tick,
    0 for one of the main program. ``time_us`` is the stamp.
    """

    letter: str
    number: int
    sequence: int
    time_us: int
    slot: int


#: The slot of the main program's function, which has a section of its own.
PROGRAM_SLOT = -1


class Interface:
    """The PLC's side of one channel."""

    def __init__(self, machine: Machine) -> None:
        self._machine = machine
        self._hli = machine.channels[0].hli

    @property
    def tick(self) -> int:
        """The tick that has just been run."""
        return self._machine.kernel.tick - 1

    @property
    def time_us(self) -> int:
        """The time at which it began."""
        return self.tick * self._machine.configuration.cycle_time_us

    def functions(self) -> list[TechnologyEntry]:
        """The functions that wait, the main program's first, then in the order of commanding."""
        cycle_time_us = self._machine.configuration.cycle_time_us
        waiting = []
        if self._hli.program_state == 1:
            letter, number = _named(self._hli.program_function)
            waiting.append(TechnologyEntry(letter, number, 0, self.time_us, PROGRAM_SLOT))
        for slot, function, sequence, tick in self._hli.entries():
            letter, number = _named(function)
            waiting.append(TechnologyEntry(letter, number, sequence, tick * cycle_time_us, slot))
        return waiting

    def acknowledge(self, entry: TechnologyEntry) -> None:
        """The PLC has taken this function."""
        if entry.slot == PROGRAM_SLOT:
            self._hli.acknowledge_program()
        else:
            self._hli.acknowledge(entry.slot)

    def acknowledge_all(self) -> None:
        """The PLC has taken everything that waits."""
        for entry in self.functions():
            self.acknowledge(entry)

    def read(self, name: str) -> float | bool | str:
        """The value of a V. variable after this tick."""
        return self._machine.read(name)

    def write(self, name: str, value: float | bool | str) -> None:
        """A value for a V.E variable; raises ``Failure`` for a wrong name or value."""
        self._machine.write(name, value)

    @property
    def override_pct(self) -> float:
        """The operator's override of the path in percent."""
        return self._hli.operator_override_pct

    @override_pct.setter
    def override_pct(self, value: float) -> None:
        assert value >= 0.0, value
        self._hli.operator_override_pct = float(value)

    @property
    def feed_hold(self) -> bool:
        """Whether the path is held."""
        return self._hli.feed_hold

    @feed_hold.setter
    def feed_hold(self, value: bool) -> None:
        self._hli.feed_hold = value


def _named(function: int) -> tuple[str, int]:
    return ("H", -function - 1) if function < 0 else ("M", function)
