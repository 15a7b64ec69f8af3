# SPDX-License-Identifier: MIT
"""When a PLC acknowledges M and H functions: the answers that a test needs, as small objects.

``ALL`` at once, ``NONE`` never, ``after(ticks)`` late, ``only("M100", "H7")`` some of them.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from nctakt.interface import Interface, TechnologyEntry


class Policy(Protocol):
    """Says whether a function is acknowledged after this tick."""

    def answers(self, function: TechnologyEntry, hli: Interface) -> bool:
        """Asked after each tick for each function that waits."""


@dataclass(frozen=True, slots=True)
class Always:
    """Acknowledges or not, whatever waits."""

    answer: bool

    def answers(self, function: TechnologyEntry, hli: Interface) -> bool:
        """The same for all."""
        return self.answer


ALL = Always(True)
NONE = Always(False)


@dataclass(frozen=True, slots=True)
class After:
    """Acknowledges when a function has waited for so many ticks; 0: behind its own tick."""

    ticks: int

    def answers(self, function: TechnologyEntry, hli: Interface) -> bool:
        """Whether its time has come."""
        return hli.time_us - function.time_us >= self.ticks * hli.cycle_time_us


@dataclass(frozen=True, slots=True)
class Only:
    """Acknowledges the functions of these names as ``then`` says, all others never."""

    names: frozenset[str]
    then: Policy = ALL

    def answers(self, function: TechnologyEntry, hli: Interface) -> bool:
        """Whether it is one of them, and ``then`` answers."""
        return function.name in self.names and self.then.answers(function, hli)


def after(ticks: int) -> After:
    """Acknowledge each function ``ticks`` ticks after the one in which it appeared."""
    if ticks < 0:
        raise ValueError(f"{ticks} ticks are less than none")
    return After(ticks)


def only(*names: str, then: Policy = ALL) -> Only:
    """Acknowledge ``M100``, ``H7`` … alone; ``then`` says when."""
    return Only(frozenset(name.upper() for name in names), then)
