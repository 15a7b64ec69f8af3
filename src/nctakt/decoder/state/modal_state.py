# SPDX-License-Identifier: MIT
"""The modal state of one channel's decoder.

Positions are programmed ones in mm or degrees, in the order of the channel's axes; lengths in inch
are converted on input (G70).
"""

from __future__ import annotations

from nctakt.base.dataclass import dataclass, field
from nctakt.decoder.state.call_stack import CallStack
from nctakt.decoder.state.path_limits import LimitState
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

#: Default of the contouring deviation, mm.
DEVIATION_MM = 1.0


@dataclass(slots=True)
class CompensationState:
    """The programmed state of tool radius compensation (MO-9).

    ``side``: 1 left of the contour (G41), -1 right of it (G42), 0 off; ``radius`` in mm.
    ``by_arc``: arcs around outer corners (G26). ``masks``: contour elements that the tool cannot
    follow are left out (G141). ``adapts_feed``: F applies to the contour (G11). ``has_left_path``:
    the tool is off the programmed path. ``end``: the tool's position at the end of the contour
    (G239), in the plane.
    """

    side: int = 0
    radius: float = 0.0
    by_arc: bool = False
    mode: int = APPROACH_INDIRECT
    masks: bool = False
    adapts_feed: bool = False
    has_left_path: bool = False
    end: tuple[float, float] = (0.0, 0.0)

    def change_from(self, before: float) -> str:
        """Return the functions that changed the distance from the contour, ``before`` in mm."""
        if self.side == 0:
            return "G40"
        if before != 0.0:
            return "G41/G42"
        return "G41" if self.side > 0 else "G42"

    @property
    def is_direct(self) -> bool:
        """Whether contours are approached and left without a motion around a corner."""
        return self.mode in _DIRECT_MODES

    @property
    def is_active(self) -> bool:
        """Whether compensation changes motions in the plane."""
        return self.side != 0 or self.has_left_path

    @property
    def word(self) -> str:
        """The active word, G41 or G42."""
        return f"G{COMPENSATION_LEFT if self.side > 0 else COMPENSATION_RIGHT}"


@dataclass(slots=True)
class ContourState:
    """The mode of ``#CONTOUR MODE`` and its sizes in mm, by keyword."""

    mode: str = "DEV"
    sizes: dict[str, float] = field(
        default_factory=lambda: dict.fromkeys(
            ("PATH_DEV", "PATH_DIST", "PRE_DIST", "POST_DIST"), DEVIATION_MM
        )
    )

    @property
    def size(self) -> float:
        """The deviation at a corner; negative: the distance from it; 0: it stays sharp."""
        if self.mode == "DIST":
            return -min(self.sizes["PRE_DIST"], self.sizes["POST_DIST"])
        if self.mode == "DIST_SOFT":
            return -max(self.sizes["PATH_DIST"], 0.0)
        return self.sizes["PATH_DEV"]


@dataclass(slots=True)
class PathState:
    """The modal state of the path: plane, arcs, ends of blocks.

    ``limits_jerk``: the slope is an S-curve (P-CHAN-00071). ``radius``: the last R, 0 before the
    first. ``contour``: how corners are rounded. ``has_diameters``: absolute positions of the face
    axis are diameters (G51).
    """

    plane: int
    absolute_centre: bool
    limits_jerk: bool
    radius: float = 0.0
    exact_stop: bool = False
    contouring: bool = False
    contour: ContourState = field(default_factory=ContourState)
    has_diameters: bool = False
    compensation: CompensationState = field(default_factory=CompensationState)

    @property
    def rounding(self) -> float:
        """How corners are rounded: the deviation in mm; negative: the distance from the corner."""
        return self.contour.size


@dataclass(slots=True)
class ToolState:
    """The tool; ``number``: the last T; ``record``: the last D; ``tool``: the record that D
    selects.
    """

    number: int = 0
    record: int = 0
    tool: Tool = NO_TOOL


@dataclass(slots=True)
class FeedState:
    """The meaning of F (``feed_mode``), its values under G93, G95 and G194, and programmed
    overrides.

    ``follows_spindle``: the feed under G95 follows the speed of the spindle as it is (#TURN).
    Overrides are factors for feed and rapid blocks, of the path and by axis index. ``group``: the
    axes whose path F applies to (``#FGROUP``); empty: the linear ones.
    """

    feed_mode: int = FEED_PER_MINUTE
    time_s: float = 0.0
    per_revolution_mm: float = 0.0
    follows_spindle: bool = True
    share_pct: float = 0.0
    path_override: tuple[float, float] = (1.0, 1.0)
    axis_overrides: dict[int, tuple[float, float]] = field(default_factory=dict)
    group: frozenset[int] = frozenset()

    @property
    def block_time_s(self) -> float:
        """The duration of a feed block under G93, else 0."""
        return self.time_s if self.feed_mode == INVERSE_TIME_FEED else 0.0


@dataclass(slots=True)
class ThreadState:
    """What threads take from blocks before: pitches in mm by their words, S of tapping in 1/min.

    ``speed``: below 0 turns backward, 0: none yet. ``spindle``: its place in the channel, -1: the
    main spindle. ``offset``: the start angle of cut threads in degrees, until another motion.
    ``chains``: a thread goes on into the next block. ``has_noted_cutting``, ``has_noted_tapping``:
    the notes on what was decided are given.
    """

    pitches: dict[str, float] = field(default_factory=dict)
    speed: float = 0.0
    spindle: int = -1
    offset: float = 0.0
    chains: bool = True
    has_noted_cutting: bool = False
    has_noted_tapping: bool = False


@dataclass(slots=True)
class ModalState:
    """The modal state; ``motion``: an active G function; ``feed_mm_s``: under G94, 0 before an F.

    ``parameters``: P1, P2, … ``measures``: edge banding is on (G108). ``message_file``: the file of
    saved messages (#FILENAME). ``not_plain``: the active G functions that plain lines do not know,
    by group. ``monitored``: the axes at a fixed stop or on their way to it.
    ``has_read_signal``: the last ``#SIGNAL READ`` has taken one. ``limits``: weights, and the
    limits of the path.
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
    thread: ThreadState = field(default_factory=ThreadState)
    call_stack: CallStack = field(default_factory=CallStack)
    not_plain: dict[Group, int] = field(default_factory=dict)
    monitored: set[str] = field(default_factory=set)
    has_read_signal: bool = False
    limits: LimitState = field(default_factory=LimitState)

    @property
    def rapid(self) -> bool:
        """Whether G00 is active."""
        return self.motion == RAPID

    @property
    def allows_plain_lines(self) -> bool:
        """Whether plain lines may be decoded without the tree.

        For G functions the table decides (``GFunction.plain``). Every other command that changes
        how a line is made from its block must be tested here.
        """
        feed = self.feed
        has_override = feed.path_override != (1.0, 1.0) or bool(feed.axis_overrides)
        has_feed_of_its_own = has_override or bool(feed.group)
        return not self.not_plain and not has_feed_of_its_own and not self.monitored

    def note(self, function: int) -> None:
        """Note a G function that becomes active, for ``allows_plain_lines``."""
        group = group_of(function)
        if group is None or group is Group.MOTION:
            return
        if G_FUNCTIONS[function].plain:
            self.not_plain.pop(group, None)
        else:
            self.not_plain[group] = function

    @property
    def length_unit_mm(self) -> float:
        """The active unit of length in mm."""
        return MM_PER_INCH if self.inch else 1.0


def state_at_program_start(start: ProgramStart, positions: list[float]) -> ModalState:
    """Return the state at the start of a main program, with the axes at ``positions``."""
    functions = start.g_functions
    motion = functions[MOTION_GROUP]
    if motion not in MOTIONS:
        motion = RAPID  # G04 belongs to the same group
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
