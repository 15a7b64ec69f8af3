# SPDX-License-Identifier: MIT
"""Realtime cycles that a program defines and starts, by their IDs."""

from __future__ import annotations

from dataclasses import replace

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span
from nctakt.base.line_shift import LineShift


@dataclass(frozen=True, slots=True)
class CycleUse:
    """A definition or a START of a realtime cycle, or a call whose effect is unknown.

    ``identity``: ``None`` for a computed ID, and for such a call, which is definition and start in
    one. ``is_deferred``: a DEF, which needs a later START. ``line``: its text.
    """

    identity: int | None
    span: Span
    line: str
    scope: str = ""
    is_definition: bool = False
    is_start: bool = False
    is_deferred: bool = False

    def shifted(self, shift: LineShift) -> CycleUse:
        """Return it for a text with other lines; raises ``ReplacedLine``."""
        return replace(self, span=shift.span(self.span))
