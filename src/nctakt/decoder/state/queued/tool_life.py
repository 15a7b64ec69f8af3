# SPDX-License-Identifier: MIT
"""Tool life: the commands that the tick carries out (``kernel/tick/tool_lives.py``)."""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.base.dataclass import dataclass
from nctakt.decoder.state.queued.commands import Command
from nctakt.kernel import codes, rows

#: Time or distance of ``#TOOL LIFE DEF`` that is unchanged.
UNCHANGED = -1.0


@dataclass(frozen=True, slots=True)
class SetToolLife(Command):
    """A change of the tool life: ``action`` ``codes.LIFE_SENT`` …

    ``tool``: number of the text of the tool's ID, ``basic``: its first part. ``time``: seconds,
    ``distance``: mm.
    """

    packed_as = rows.TOOL_LIFE

    action: int
    tool: int = 0
    basic: int = 0
    time: float = 0.0
    distance: float = 0.0


@dataclass(frozen=True, slots=True)
class ToolLifeFactors(Command):
    """Other factors of the tool life from here on (V.TLM)."""

    packed_as = rows.TOOL_LIFE

    time: float
    distance: float

    def arguments(self, _reference: int) -> Sequence[float]:
        return codes.LIFE_FACTORS, 0, 0, self.time, self.distance
