# SPDX-License-Identifier: MIT
"""A motion that waits for the next one."""

from __future__ import annotations

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Span
from nctakt.decoder.state.queued.commands import Command, Segment
from nctakt.decoder.state.queued.shape_commands import InsertCorner


@dataclass(slots=True)
class HeldMotion:
    """A motion and the commands after it; ``time_s``: the duration of its block under G93.

    ``corner``: the shape inserted at its end, after ``corner_at`` of these commands.
    """

    segment: Segment
    span: Span
    time_s: float
    between: list[Command] = field(default_factory=list)
    corner: InsertCorner | None = None
    corner_at: int = 0
