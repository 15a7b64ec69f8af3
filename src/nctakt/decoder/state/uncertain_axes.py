# SPDX-License-Identifier: MIT
"""Axes that realtime cycles may have moved since the decoder last knew their positions (RC-409).

The decoder prepares blocks ahead with computed positions; an axis named in a single-axis command of
a cycle may be elsewhere by then. It is *uncertain* from the moment when the cycle may move it until
its position is requested: with SCOPE=BLOCK from the end of the cycle's block on; with PROG and
GLOBAL from the start of the cycle on, and, while that lives, again after each block or wait in
which the path does not move the axis. The same applies to an axis that the program itself moves
independently (SA-4), from its command on, or lets oscillate (SA-15).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from nctakt.base.dataclass import dataclass
from nctakt.decoder.state.queued.commands import Command, EmptyBlock


@dataclass(frozen=True, slots=True)
class LivingCycle:
    """A cycle of scope GLOBAL left by an earlier program, with the axes that it names."""

    identity: int
    axes: tuple[str, ...]
    is_started: bool


@dataclass(frozen=True, slots=True)
class _CycleAxes:
    """The axes in the single-axis commands of a cycle."""

    axes: tuple[str, ...]
    is_block: bool


class UncertainAxes:
    """Tracks the axes of one program; ``moving``: axes in independent motion at its start.

    ``awaits_block``: a BLOCK cycle is armed for the next motion or dwell.
    """

    def __init__(self, living: Sequence[LivingCycle], moving: Sequence[str]) -> None:
        self._by_identity = {cycle.identity: _CycleAxes(cycle.axes, False) for cycle in living}
        self._running: dict[int, tuple[str, ...]] = {}
        self._without_id: list[tuple[str, ...]] = []
        self._armed: dict[str, None] = {}
        self.awaits_block = False
        self._uncertain: dict[str, None] = dict.fromkeys(moving)
        self._independent: dict[str, None] = {}
        self._oscillating: dict[str, None] = {}
        for cycle in living:
            if cycle.is_started:
                self.start_cycle(cycle.identity)

    def define_cycle(
        self, identity: int, axes: tuple[str, ...], *, is_block: bool, starts: bool
    ) -> None:
        """Note a definition; ``identity`` is 0 without an ID."""
        cycle = _CycleAxes(axes, is_block)
        if identity:
            self._by_identity[identity] = cycle
        if starts:
            self._start(identity, cycle)

    def start_cycle(self, identity: int) -> None:
        """Note START, also of a running cycle; unknown IDs are ignored."""
        cycle = self._by_identity.get(identity)
        if cycle is not None:
            self._start(identity, cycle)

    def _start(self, identity: int, cycle: _CycleAxes) -> None:
        if cycle.is_block:
            self.awaits_block = True
            self._armed.update(dict.fromkeys(cycle.axes))
            return
        if not cycle.axes:
            return
        if identity:
            self._running[identity] = cycle.axes
        else:
            self._without_id.append(cycle.axes)
        self._uncertain.update(dict.fromkeys(cycle.axes))

    def delete_cycle(self, identity: int, moving: Iterable[str]) -> None:
        """Note DELETE, which requests positions; ``moving``: axes that still move then."""
        cycle = self._by_identity.pop(identity, None)
        self._running.pop(identity, None)
        moving = tuple(moving)
        self._independent = {axis: None for axis in self._independent if axis in moving}
        for axis in (*self._uncertain, *(cycle.axes if cycle is not None else ())):
            if axis in moving:
                self._uncertain[axis] = None
            else:
                self._uncertain.pop(axis, None)

    def pass_time(self, moved: Iterable[str] = (), *, is_block: bool = True) -> None:
        """Note a command that takes time; ``moved``: axes that the path moves in it.

        ``is_block``: a motion or dwell, for which BLOCK cycles wait.
        """
        if is_block:
            self._uncertain.update(self._armed)
            self._armed.clear()
            self.awaits_block = False
        if self._running or self._without_id:
            moved = tuple(moved)
            for axes in (*self._running.values(), *self._without_id):
                self._uncertain.update(dict.fromkeys(axis for axis in axes if axis not in moved))

    def pass_over(self, source: int, number: int) -> Iterator[Command]:
        """Yield that a motion or dwell takes no tick, for BLOCK cycles that are armed (RC-105)."""
        if self.awaits_block:
            yield EmptyBlock(source, number)

    @property
    def is_empty(self) -> bool:
        """Whether no axis is uncertain or will become so, and no BLOCK cycle is armed."""
        if self.awaits_block:
            return False
        of_program = self._independent or self._oscillating
        return not (self._uncertain or of_program or self._running or self._without_id)

    def uncertain(self, axes: Iterable[str]) -> tuple[str, ...]:
        """Return those of these axes whose positions must be requested before the path moves
        them.
        """
        doubtful = self._uncertain.keys() | self._independent.keys() | self._oscillating.keys()
        return tuple(axis for axis in axes if axis in doubtful) if doubtful else ()

    def move_alone(self, axis: str) -> None:
        """Note that the program moves an axis independently of the path."""
        self._independent[axis] = None

    def oscillate(self, axis: str) -> None:
        """Note that the program lets an axis oscillate."""
        self._oscillating[axis] = None

    def end_oscillation(self, axis: str, *, anywhere: bool) -> None:
        """Note that the program ends an oscillation, at its second position or ``anywhere``."""
        self._oscillating.pop(axis, None)
        (self._uncertain if anywhere else self._independent)[axis] = None

    def of_program(self, axes: Iterable[str]) -> tuple[str, ...]:
        """Return those of these axes that only the program moves independently of the path."""
        return tuple(
            axis for axis in axes if axis in self._independent and axis not in self._uncertain
        )

    def confirm(self, axes: Iterable[str]) -> None:
        """Note that the positions of these axes are known."""
        for axis in axes:
            self._uncertain.pop(axis, None)
            self._independent.pop(axis, None)
            self._oscillating.pop(axis, None)
