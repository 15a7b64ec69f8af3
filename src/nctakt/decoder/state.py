# SPDX-License-Identifier: MIT
"""What the decoder remembers from block to block: the modal state of one channel.

Positions are programmed ones in mm or degrees, in the order of the channel's axes; lengths in inch
are converted where they enter (G70).
"""

from __future__ import annotations

from dataclasses import dataclass, field

from nctakt.decoder.levels import Levels
from nctakt.lists.channel_configuration import ProgramStart

MM_PER_INCH = 25.4

#: Groups of G functions whose start value the channel list gives (P-CHAN-00063).
MOTION_GROUP, UNIT_GROUP, DIMENSION_GROUP = 0, 12, 14


@dataclass(slots=True)
class ModalState:
    """``rapid``: G00 is active. ``feed_mm_s`` 0: no feed yet. ``parameters``: P1, P2, …"""

    rapid: bool
    inch: bool
    absolute: bool
    feed_mm_s: float
    positions: list[float]
    parameters: dict[int, float] = field(default_factory=dict)
    levels: Levels = field(default_factory=Levels)

    @property
    def length_unit_mm(self) -> float:
        """Millimetres in the active unit of length."""
        return MM_PER_INCH if self.inch else 1.0


def state_at_program_start(start: ProgramStart, positions: list[float]) -> ModalState:
    """The state when a main program begins, with the axes where they are."""
    functions = start.g_functions
    return ModalState(
        rapid=functions[MOTION_GROUP] == 0,
        inch=functions[UNIT_GROUP] == 70,
        absolute=functions[DIMENSION_GROUP] == 90,
        feed_mm_s=start.feed_mm_min / 60.0,
        positions=positions,
    )
