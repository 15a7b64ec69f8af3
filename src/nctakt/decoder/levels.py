# SPDX-License-Identifier: MIT
"""The programs at work: the main program and the subprograms that it has called.

In: calls and ends. Out: the innermost program with its text, its local variables and what its call
has handed over. Each call is a level; how many there may be is bounded, so that a program that
calls itself without end is told (``MOST_LEVELS``, a choice).
"""

from __future__ import annotations

from dataclasses import dataclass, field

from nctakt.decoder.own_variables import Scopes
from nctakt.nc.outline import ProgramText, Section

#: Programs inside each other, the main program included.
MOST_LEVELS = 20

#: Structures and calls inside each other, over all levels.
MOST_NESTED = 120


@dataclass(slots=True)
class Level:
    """One program at work; ``arguments``: @P1, @P2, … of its cycle, ``None`` without a cycle.

    A subprogram that a cycle calls sees the cycle's own.
    """

    text: ProgramText
    section: Section
    arguments: dict[int, float | str] | None = None


@dataclass(slots=True)
class Levels:
    """The levels from the main program on; ``scopes``: their variables."""

    stack: list[Level] = field(default_factory=list)
    scopes: Scopes = field(default_factory=lambda: Scopes({}))

    def enter(self, level: Level) -> None:
        """A program begins: variables of its own, as a cycle also V.CYC."""
        self.scopes.locals_.append({})
        if level.arguments is not None or not self.stack:
            self.scopes.cycles.append({})
        self.stack.append(level)

    def leave(self) -> None:
        """The innermost program has ended."""
        level = self.stack.pop()
        self.scopes.locals_.pop()
        if level.arguments is not None:
            self.scopes.cycles.pop()

    @property
    def top(self) -> Level:
        """The program that decodes."""
        return self.stack[-1]

    @property
    def arguments(self) -> dict[int, float | str]:
        """What the call of the innermost cycle has handed over."""
        for level in reversed(self.stack):
            if level.arguments is not None:
                return level.arguments
        return {}
