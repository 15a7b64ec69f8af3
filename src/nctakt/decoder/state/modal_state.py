# SPDX-License-Identifier: MIT
"""What the decoder remembers from block to block: the modal state of one channel.

Positions are programmed ones in mm or degrees, in the order of the channel's axes; lengths in inch
are converted where they enter (G70).
"""

from __future__ import annotations

from nctakt.base.dataclass import dataclass, field
from nctakt.decoder.state.call_stack import CallStack
from nctakt.lists.declared.tools import NO_TOOL, Tool
from nctakt.lists.machine.channel_configuration import (
    CENTRE_GROUP,
    DIMENSION_GROUP,
    MOTION_GROUP,
    PLANE_GROUP,
    UNIT_GROUP,
    ProgramStart,
)
from nctakt.nc.vocabulary.function_rows import Group
from nctakt.nc.vocabulary.functions import (
    ABSOLUTE,
    ABSOLUTE_CENTRE,
    APPROACH_DIRECT,
    APPROACH_INDIRECT,
    APPROACH_INNER_CORNER,
    COMPENSATION_LEFT,
    COMPENSATION_RIGHT,
    DEPART_WITHOUT_MOTION,
    FEED_PER_MINUTE,
    G_FUNCTIONS,
    INCH,
    INVERSE_TIME_FEED,
    MOTIONS,
    RAPID,
    group_of,
)

MM_PER_INCH = 25.4

#: Approaches without a way around a corner, to a contour and from it.
_DIRECT_MODES = (APPROACH_DIRECT, APPROACH_INNER_CORNER, DEPART_WITHOUT_MOTION)

#: The deviation of contouring where the program has set none, mm.
DEVIATION_MM = 1.0


@dataclass(slots=True)
class CompensationState:
    """Tool radius compensation as the program wants it (MO-9).

    ``side``: 1 left of the contour (G41), -1 right of it (G42), 0 off; ``radius`` in mm. Around
    outer corners in an arc (``by_arc``, G26). ``masks``: what the tool does not fit into is left
    out (G141). ``adapts_feed``: F counts at the contour (G11). ``has_left_path``: the tool has left
    the programmed path. ``end``: where the tool ends the contour (G239), in the plane.
    """

    side: int = 0
    radius: float = 0.0
    by_arc: bool = False
    mode: int = APPROACH_INDIRECT
    masks: bool = False
    adapts_feed: bool = False
    has_left_path: bool = False
    end: tuple[float, float] = (0.0, 0.0)

    @property
    def is_direct(self) -> bool:
        """Whether the tool comes to a contour and from it without a way around a corner."""
        return self.mode in _DIRECT_MODES

    @property
    def is_active(self) -> bool:
        """Whether motions in the plane are not what they are without compensation."""
        return self.side != 0 or self.has_left_path

    @property
    def word(self) -> str:
        """G41 or G42, as the program has it."""
        return f"G{COMPENSATION_LEFT if self.side > 0 else COMPENSATION_RIGHT}"


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
class FeedState:
    """What F means, 93 … 95 or 194, and its values under G93, G95, G194; the program's overrides.

    Overrides are factors of feed and rapid blocks: of the path, and by axis (its place).
    """

    feed_mode: int = FEED_PER_MINUTE
    time_s: float = 0.0
    per_revolution_mm: float = 0.0
    share_pct: float = 0.0
    path_override: tuple[float, float] = (1.0, 1.0)
    axis_overrides: dict[int, tuple[float, float]] = field(default_factory=dict)

    @property
    def block_time_s(self) -> float:
        """How long a feed block lasts, 0 where F is no time."""
        return self.time_s if self.feed_mode == INVERSE_TIME_FEED else 0.0


@dataclass(slots=True)
class ModalState:
    """``motion``: G00 … G03. ``feed_mm_s``: under G94, 0: none yet. ``parameters``: P1, P2, …

    ``measures``: edge banding is on (G108). ``message_file``: what #FILENAME has named for the
    messages that are saved. ``not_plain``: the active G functions that plain lines do not
    know, by group.
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
    feed: FeedState = field(default_factory=FeedState)
    call_stack: CallStack = field(default_factory=CallStack)
    not_plain: dict[Group, int] = field(default_factory=dict)

    @property
    def rapid(self) -> bool:
        """Whether G00 is active."""
        return self.motion == RAPID

    @property
    def allows_plain_lines(self) -> bool:
        """Whether lines and feeds mean what they mean without any further function.

        Of the G functions the table tells (``GFunction.plain``); each other command that changes
        how a line is made of its block has to be asked for here: plain blocks then take the tree's
        way (``handover.py``).
        """
        feed = self.feed
        has_override = feed.path_override != (1.0, 1.0) or bool(feed.axis_overrides)
        return not self.not_plain and not has_override

    def note(self, function: int) -> None:
        """Remember whether a G function that is active from here on lets lines be plain."""
        group = group_of(function)
        if group is None or group is Group.MOTION:
            return
        if G_FUNCTIONS[function].plain:
            self.not_plain.pop(group, None)
        else:
            self.not_plain[group] = function

    @property
    def length_unit_mm(self) -> float:
        """Millimetres in the active unit of length."""
        return MM_PER_INCH if self.inch else 1.0


def state_at_program_start(start: ProgramStart, positions: list[float]) -> ModalState:
    """The state when a main program begins, with the axes where they are."""
    functions = start.g_functions
    motion = functions[MOTION_GROUP]
    if motion not in MOTIONS:
        motion = RAPID  # G04, of the same group
    return ModalState(
        motion=motion,
        path=PathState(
            functions[PLANE_GROUP],
            functions[CENTRE_GROUP] == ABSOLUTE_CENTRE,
            start.slope_profile > 0,
        ),
        inch=functions[UNIT_GROUP] == INCH,
        absolute=functions[DIMENSION_GROUP] == ABSOLUTE,
        feed_mm_s=start.feed_mm_min / 60.0,
        positions=positions,
    )
