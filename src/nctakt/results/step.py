# SPDX-License-Identifier: MIT
"""The results of some ticks, for callers that step a controller themselves."""

from __future__ import annotations

from typing import NamedTuple

from nctakt.base.diagnostics import Diagnostic
from nctakt.results.run import (
    TECHNOLOGY_KINDS,
    ProgramMessage,
    TechnologyOutput,
    technology_output,
)
from nctakt.results.trace.events import Event


class Step(NamedTuple):
    """The ticks from ``first_tick`` on.

    ``state`` is that of the controller after them. ``events``, ``messages`` and ``diagnostics``
    are those of these ticks only.
    """

    first_tick: int
    ticks: int
    state: str
    events: tuple[Event, ...]
    messages: tuple[ProgramMessage, ...]
    diagnostics: tuple[Diagnostic, ...]

    @property
    def technology(self) -> list[TechnologyOutput]:
        """The M and H functions that went out, in their order."""
        return [technology_output(event) for event in self.events if event.kind in TECHNOLOGY_KINDS]

    def __repr__(self) -> str:
        what = ", ".join(map(str, self.events)) or "nothing"
        return f"<{self.ticks} ticks from {self.first_tick}, {self.state}: {what}>"
