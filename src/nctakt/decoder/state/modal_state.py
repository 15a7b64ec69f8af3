# SPDX-License-Identifier: MIT
"""What the decoder remembers from block to block: the modal state of one channel.

Positions are programmed ones in mm or degrees, in the order of the channel's axes; lengths in inch
are converted where they enter (G70).
"""

from __future__ import annotations

from dataclasses import dataclass, field

from nctakt.decoder.state.call_stack import Levels
from nctakt.lists.declared.tools import NO_TOOL, Tool
from nctakt.lists.machine.channel_configuration import ProgramStart

MM_PER_INCH = 25.4

#: Groups of G functions whose start value the channel list gives (P-CHAN-00063).
MOTION_GROUP, PLANE_GROUP, UNIT_GROUP, DIMENSION_GROUP, CENTRE_GROUP = 0, 4, 12, 14, 23

#: The last of the motions G00 … G03; the group has G04 as well.
MOST_MOTION = 3

#: The deviation of contouring where the program has set none, mm.
DEVIATION_MM = 1.0


#: How the tool comes to a contour and from it: by motions of the program without a way around
#: corners, with one, by ways of their own across the contour, in an inner corner of a closed one;
#: by a motion, and not from it.
DIRECT, INDIRECT, PERPENDICULAR, INNER_CORNER, ENDS_WITHOUT_WAY = 138, 139, 237, 238, 239


@dataclass(slots=True)
class CompensationState:
    """Tool radius compensation as the program wants it (MO-9).

    ``side``: 1 left of the contour (G41), -1 right of it (G42), 0 off; ``radius`` in mm. Around
    outer corners in an arc (``by_arc``, G26). ``masks``: what the tool does not fit into is left
    out (G141). ``adapts_feed``: F counts at the contour (G11). ``is_on_way``: the tool has left the
    programmed path. ``end``: where the tool ends the contour (G239), in the plane.
    """

    side: int = 0
    radius: float = 0.0
    by_arc: bool = False
    mode: int = INDIRECT
    masks: bool = False
    adapts_feed: bool = False
    is_on_way: bool = False
    end: tuple[float, float] = (0.0, 0.0)

    @property
    def is_direct(self) -> bool:
        """Whether the tool comes to a contour and from it without a way around a corner."""
        return self.mode in (DIRECT, INNER_CORNER, ENDS_WITHOUT_WAY)

    @property
    def is_active(self) -> bool:
        """Whether motions in the plane are not what they are without compensation."""
        return self.side != 0 or self.is_on_way

    @property
    def word(self) -> str:
        """G41 or G42, as the program has it."""
        return "G41" if self.side > 0 else "G42"


@dataclass(slots=True)
class PathState:
    """How the path goes on: plane, arcs, the ends of blocks.

    ``limits_jerk``: the slope is an S-curve (P-CHAN-00071). ``radius``: the last R, 0 none yet.
    ``deviation``: how far contouring may pass a corner, mm.
    """

    plane: int
    absolute_centre: bool
    limits_jerk: bool
    radius: float = 0.0
    exact_stop: bool = False
    contouring: bool = False
    deviation: float = DEVIATION_MM
    compensation: CompensationState = field(default_factory=CompensationState)


@dataclass(slots=True)
class ToolState:
    """``number``: the last T. ``record``: the last D; ``tool``: what it selects."""

    number: int = 0
    record: int = 0
    tool: Tool = NO_TOOL


@dataclass(slots=True)
class PaceState:
    """What F means, 93 … 95 or 194, and its values under G93, G95, G194; the program's overrides.

    Overrides are factors of feed and rapid blocks: of the path, and by axis (its place).
    """

    feed_mode: int = 94
    time_s: float = 0.0
    per_revolution_mm: float = 0.0
    share_pct: float = 0.0
    path_override: tuple[float, float] = (1.0, 1.0)
    axis_overrides: dict[int, tuple[float, float]] = field(default_factory=dict)

    @property
    def block_time_s(self) -> float:
        """How long a feed block lasts, 0 where F is no time."""
        return self.time_s if self.feed_mode == 93 else 0.0


@dataclass(slots=True)
class ModalState:
    """``motion``: G00 … G03. ``feed_mm_s``: under G94, 0: none yet. ``parameters``: P1, P2, …

    ``measures``: edge banding is on (G108). ``message_file``: what #FILENAME has named for the
    messages that are saved.
    """

    motion: int
    path: PathState
    inch: bool
    absolute: bool
    feed_mm_s: float
    positions: list[float]
    tool: ToolState = field(default_factory=ToolState)
    parameters: dict[int, float] = field(default_factory=dict)
    message_file: str = ""
    measures: bool = False
    pace: PaceState = field(default_factory=PaceState)
    levels: Levels = field(default_factory=Levels)

    @property
    def rapid(self) -> bool:
        """Whether G00 is active."""
        return self.motion == 0

    @property
    def is_usual(self) -> bool:
        """Whether lines and feeds mean what they mean without any further function.

        Each function that changes how a line is made of its block has to be asked for here: plain
        blocks then take the tree's way (``handover.py``).
        """
        pace = self.pace
        has_override = pace.path_override != (1.0, 1.0) or bool(pace.axis_overrides)
        return pace.feed_mode == 94 and not has_override

    @property
    def length_unit_mm(self) -> float:
        """Millimetres in the active unit of length."""
        return MM_PER_INCH if self.inch else 1.0


def state_at_program_start(start: ProgramStart, positions: list[float]) -> ModalState:
    """The state when a main program begins, with the axes where they are."""
    functions = start.g_functions
    return ModalState(
        motion=functions[MOTION_GROUP] if functions[MOTION_GROUP] <= MOST_MOTION else 0,
        path=PathState(
            functions[PLANE_GROUP], functions[CENTRE_GROUP] == 161, start.slope_profile > 0
        ),
        inch=functions[UNIT_GROUP] == 70,
        absolute=functions[DIMENSION_GROUP] == 90,
        feed_mm_s=start.feed_mm_min / 60.0,
        positions=positions,
    )
