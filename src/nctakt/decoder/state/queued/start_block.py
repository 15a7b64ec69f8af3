# SPDX-License-Identifier: MIT
"""Parts of a program: where it begins by block search, where it has no single block."""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span, Text
from nctakt.decoder.state.queued.commands import Command
from nctakt.kernel import rows


@dataclass(frozen=True, slots=True)
class SingleStep(Command):
    """Single block has no effect from here on, or again (``#SINGLE STEP``).

    ``resolution``: it stops before blocks whose numbers are multiples of this, 0: of all; ``None``:
    as before, and being disabled counts.
    """

    packed_as = rows.SINGLE_STEP

    is_disabled: bool = False
    resolution: int | None = None

    def arguments(self, _reference: int) -> Sequence[float]:
        return self.is_disabled, -1 if self.resolution is None else self.resolution


@dataclass(frozen=True, slots=True)
class StartBlock:
    """A line of the main program's file, or the N word of one of its blocks; 0: not by this.

    ``passes``: how often the program has to come to it, the last time included.
    """

    line: int = 0
    number: int = 0
    passes: int = 1

    def is_at(self, span: Span, file: str, number: int) -> bool:
        """Return whether the statement at ``span`` with this N word is the start block."""
        if span.file != file:
            return False
        return span.line == self.line if self.line else 0 < self.number == number

    @property
    def shown(self) -> Text:
        """The block as users name it."""
        if self.line:
            return Text(f"line {self.line}", f"Zeile {self.line}")
        if self.passes > 1:
            return Text(
                f"N{self.number}, pass {self.passes}", f"N{self.number}, Durchlauf {self.passes}"
            )
        return Text(f"N{self.number}", f"N{self.number}")


@dataclass(frozen=True, slots=True)
class StartReached(Command):
    """The start block begins here, after the part skipped by the search; it ends in the search.

    ``span``: the block. ``positions``: where the program has the axes. ``uncertain``: the axes that
    realtime cycles may have moved since, which stay where they are. ``steps``: the gear step that
    each spindle would have.
    """

    span: Span
    positions: tuple[float, ...]
    uncertain: tuple[str, ...]
    steps: dict[int, int]
