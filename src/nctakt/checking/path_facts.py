# SPDX-License-Identifier: MIT
"""Facts certain at a point of a program: positions, modal functions, feeds, axes of cycles.

In: the facts of two branches. Out: those that hold in both.
"""

from __future__ import annotations

from dataclasses import replace

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Span
from nctakt.base.line_shift import LineShift


@dataclass(frozen=True, slots=True)
class CommandedAxis:
    """A command that a living realtime cycle gives its axis in each tick, whatever happens.

    ``target``: its absolute position in mm or degrees, ``None`` for any other motion. ``start``:
    where the axis was before, if that is known. ``is_of_block``: the cycle runs with the next block
    only.
    """

    span: Span
    target: float | None
    start: float | None
    is_of_block: bool


@dataclass(slots=True)
class Facts:
    """Facts certain at a point of the program; ``None``: unknown.

    ``positions``: axis -> programmed position in mm or degrees. ``radius_mm``: that of R.
    ``is_shifted`` is false while no offset acts. ``lacking_feeds``: the modes of F (G93 …) in which
    no F has been given. ``is_cutting``: S is a cutting speed. ``given_axes``: those that the
    program has given away. ``commanded``: the axes that living cycles command.
    """

    positions: dict[str, float] = field(default_factory=dict)
    motion: int | None = None
    plane: int | None = None
    is_absolute: bool | None = None
    has_absolute_centre: bool | None = None
    is_inch: bool | None = None
    radius_mm: float | None = None
    is_shifted: bool | None = None
    has_diameters: bool | None = None
    feed_mode: int | None = None
    lacking_feeds: frozenset[int] | None = None
    is_cutting: bool | None = None
    given_axes: frozenset[str] = frozenset()
    commanded: dict[str, CommandedAxis] = field(default_factory=dict)

    def copy(self) -> Facts:
        """Return a copy that later ones do not change."""
        return replace(self, positions=dict(self.positions), commanded=dict(self.commanded))

    def join(self, other: Facts) -> None:
        """Keep only the facts that also hold in the other state."""
        for name in self.__slots__:
            if name not in _COLLECTIONS and getattr(self, name) != getattr(other, name):
                setattr(self, name, None)
        self.given_axes &= other.given_axes
        self.positions = dict(self.positions.items() & other.positions.items())
        self.commanded = {
            axis: command
            for axis, command in self.commanded.items()
            if other.commanded.get(axis) == command
        }

    def shifted(self, shift: LineShift) -> Facts:
        """Return them for a text with other lines; raises ``ReplacedLine``."""
        commanded = {
            axis: replace(command, span=shift.span(command.span))
            for axis, command in self.commanded.items()
        }
        return replace(self, positions=dict(self.positions), commanded=commanded)


_COLLECTIONS = ("positions", "given_axes", "commanded")
