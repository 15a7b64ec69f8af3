# SPDX-License-Identifier: MIT
"""Which axes realtime cycles may have moved since the decoder last knew where they are (RC-409).

The decoder prepares blocks ahead with the positions that it has computed; an axis that a cycle
names in a single-axis command may stand elsewhere by then. It is *doubtful* from the moment on from
which the cycle may move it, until its position has been requested: with SCOPE=BLOCK from the end of
the cycle's block on; with PROG and GLOBAL from the start of the cycle on, and, while that lives,
again after each block or wait in which the path does not move the axis.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class LivingCycle:
    """A cycle that an earlier program has left, with the axes that it names."""

    identity: int
    axes: tuple[str, ...]
    is_started: bool


@dataclass(frozen=True, slots=True)
class _Known:
    """A cycle with single-axis commands."""

    axes: tuple[str, ...]
    is_block: bool


class MovedAxes:
    """Follows the commands of one program; ``moving`` are axes on their way when it begins."""

    def __init__(self, living: Sequence[LivingCycle], moving: Sequence[str]) -> None:
        self._by_identity = {one.identity: _Known(one.axes, False) for one in living}
        self._running: dict[int, tuple[str, ...]] = {}
        self._nameless: list[tuple[str, ...]] = []
        self._armed: dict[str, None] = {}
        self._doubtful: dict[str, None] = dict.fromkeys(moving)
        for one in living:
            if one.is_started:
                self.started(one.identity)

    def defined(
        self, identity: int, axes: tuple[str, ...], *, is_block: bool, starts: bool
    ) -> None:
        """A definition; ``identity`` is 0 without an ID."""
        known = _Known(axes, is_block)
        if identity:
            self._by_identity[identity] = known
        if starts:
            self._start(identity, known)

    def started(self, identity: int) -> None:
        """START, also of a cycle that runs; an ID that none has names no axis."""
        known = self._by_identity.get(identity)
        if known is not None:
            self._start(identity, known)

    def _start(self, identity: int, known: _Known) -> None:
        if not known.axes:
            return
        if known.is_block:
            self._armed.update(dict.fromkeys(known.axes))
            return
        if identity:
            self._running[identity] = known.axes
        else:
            self._nameless.append(known.axes)
        self._doubtful.update(dict.fromkeys(known.axes))

    def deleted(self, identity: int, moving: Iterable[str]) -> None:
        """DELETE, whose request told the positions; ``moving`` are axes that still move then."""
        known = self._by_identity.pop(identity, None)
        self._running.pop(identity, None)
        moving = tuple(moving)
        for axis in (*self._doubtful, *(known.axes if known is not None else ())):
            if axis in moving:
                self._doubtful[axis] = None
            else:
                self._doubtful.pop(axis, None)

    def took_time(self, moved: Iterable[str] = (), *, is_block: bool = True) -> None:
        """A command that takes time went down; ``moved``: axes that the path moves in it.

        ``is_block``: a motion or dwell, which BLOCK cycles wait for.
        """
        if is_block:
            self._doubtful.update(self._armed)
            self._armed.clear()
        if self._running or self._nameless:
            moved = tuple(moved)
            for axes in (*self._running.values(), *self._nameless):
                self._doubtful.update(dict.fromkeys(axis for axis in axes if axis not in moved))

    @property
    def is_quiet(self) -> bool:
        """Whether no axis is or will become doubtful by what is known."""
        return not (self._doubtful or self._armed or self._running or self._nameless)

    def doubtful(self, axes: Iterable[str]) -> tuple[str, ...]:
        """Those of these axes whose positions have to be requested before the path moves them."""
        return tuple(axis for axis in axes if axis in self._doubtful) if self._doubtful else ()

    def told(self, axes: Iterable[str]) -> None:
        """The positions of these axes are known again."""
        for axis in axes:
            self._doubtful.pop(axis, None)
