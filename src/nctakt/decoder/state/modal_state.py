# SPDX-License-Identifier: MIT
"""The modal state of one channel's decoder.

Positions are programmed ones in mm or degrees, in the order of the channel's axes; lengths in inch
are converted on input (G70).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Span
from nctakt.decoder.state.call_stack import CallStack
from nctakt.decoder.state.couplings import ActiveCouplings
from nctakt.decoder.state.geometry.arcs import PLANES, Arc
from nctakt.decoder.state.geometry.contour_form import ContourState
from nctakt.decoder.state.geometry.contour_frame import ContourFrame
from nctakt.decoder.state.geometry.tangential_arc import Tangent
from nctakt.decoder.state.path_limits import MAX_BEND, LimitState, bend_of
from nctakt.decoder.state.queued.commands import Segment
from nctakt.decoder.state.queued.shape_commands import ShapeState
from nctakt.kernel.base import arithmetic
from nctakt.lists.declared.tools import NO_TOOL, Tool
from nctakt.lists.machine.axis_configuration import AxisConfiguration
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
from nctakt.nc.vocabulary.orientation import ANGLE
from nctakt.nc.vocabulary.path_keywords import HSC_CURVES


@dataclass(slots=True)
class LimitsOfProgram:
    """Software limits in mm or degrees, by axis index; ``programmed``: those of G98 and G99."""

    programmed: dict[int, tuple[float, float]] = field(default_factory=dict)

    def of(self, axis: AxisConfiguration, index: int) -> tuple[float, float]:
        """Return the limits of an axis in force: those of the program, else of its list."""
        listed = (axis.software_limit_low, axis.software_limit_high)
        return self.programmed.get(index, listed) if self.programmed else listed


@dataclass(slots=True)
class FeedForwardState:
    """``is_on``: G135; ``weights``: factors of G136 by axis index, else 1.

    ``is_due``: the drives do not know it yet.
    """

    is_on: bool = False
    weights: dict[int, float] = field(default_factory=dict)
    is_due: bool = False

    def switch(self, *, is_on: bool) -> None:
        """Switch it on or off."""
        self.is_on = is_on
        self.is_due = True


MM_PER_INCH = 25.4

#: Approaches and departures of a contour without a path around a corner.
_DIRECT_MODES = (APPROACH_DIRECT, APPROACH_INNER_CORNER, DEPART_WITHOUT_MOTION)

#: Default of CONTERROR of ``#HSC``, mm.
HSC_ERROR_MM = 0.1


@dataclass(slots=True)
class CompensationState:
    """The programmed state of tool radius compensation (MO-9).

    ``side``: 1 left of the contour (G41), -1 right of it (G42), 0 off, the other way round where
    mirroring reverses the contour (``is_reversed``); ``radius`` in mm.
    ``by_arc``: arcs around outer corners (G26). ``masks``: contour elements that the tool cannot
    follow are left out (G141). ``adapts_feed``: F applies to the contour (G11). ``has_left_path``:
    the tool is off the programmed path. ``is_tangential``: the next motion to the contour or from
    it is an arc (G05). ``end``: the tool's position at the end of the contour
    (G239), in the plane.
    """

    side: int = 0
    is_reversed: bool = False
    radius: float = 0.0
    by_arc: bool = False
    mode: int = APPROACH_INDIRECT
    masks: bool = False
    adapts_feed: bool = False
    has_left_path: bool = False
    is_tangential: bool = False
    end: tuple[float, float] = (0.0, 0.0)

    def change_from(self, before: float) -> str:
        """Return the functions that changed the distance from the contour, ``before`` in mm."""
        if self.side == 0:
            return "G40"
        if before != 0.0:
            return "G41/G42"
        return self.word

    @property
    def approach(self) -> int:
        """How the next motion leads to the contour or from it: with G05 as with G138."""
        return APPROACH_DIRECT if self.is_tangential else self.mode

    def take_tangent(
        self, segment: Segment, plane: tuple[int, int], before: float, after: float
    ) -> Tangent | None:
        """Return the arc of a motion after G05 that changes the distance of the tool.

        ``before`` and ``after``: the distances in mm to the left.
        """
        if not self.is_tangential or before == after or before * after != 0.0:
            return None
        self.is_tangential = False
        point = segment.target if before == 0.0 else segment.start
        corner = (point[plane[0]], point[plane[1]])
        return Tangent(corner, before + after, leads_to=before == 0.0)

    @property
    def is_direct(self) -> bool:
        """Whether contours are approached and left without a motion around a corner."""
        return self.mode in _DIRECT_MODES

    @property
    def is_left(self) -> bool:
        """Whether G40 is in force, and the motion that leaves the contour is to come or held."""
        return self.side == 0 and self.has_left_path

    @property
    def is_active(self) -> bool:
        """Whether compensation changes motions in the plane."""
        return self.side != 0 or self.has_left_path

    @property
    def word(self) -> str:
        """The active word, G41 or G42."""
        is_left = (self.side > 0) is not self.is_reversed
        return f"G{COMPENSATION_LEFT if is_left else COMPENSATION_RIGHT}"


class LastArc(NamedTuple):
    """The last arc for V.G: itself, its start in mm, its words and centre, their unit."""

    arc: Arc
    begin: Sequence[float]
    words: Mapping[str, tuple[Span, float]]
    programmed_centre: tuple[float, float] | None
    unit_mm: float

    def word(self, name: str) -> float:
        """Return I, J or K in mm; 0 if the block had none."""
        return self.words[name][1] * self.unit_mm if name in self.words else 0.0

    @property
    def radius(self) -> float:
        """The radius in mm."""
        x = self.begin[self.arc.first] - self.arc.centre_first
        y = self.begin[self.arc.second] - self.arc.centre_second
        return arithmetic.square_root(x * x + y * y)

    @property
    def correction(self) -> tuple[float, float]:
        """How far the programmed centre was moved, in mm."""
        x, y = self.programmed_centre or (self.arc.centre_first, self.arc.centre_second)
        return (self.arc.centre_first - x, self.arc.centre_second - y)


@dataclass(slots=True)
class HscState:
    """``#HSC``: its ``curve`` may leave the polygon by ``deviation_mm`` or, without a name, by
    ``error_mm``; ``mode``: OPMODE.

    ``deviation_mm`` and ``max_angle_deg`` are ``None`` if the channel list gives them.
    """

    is_on: bool = False
    curve: str = HSC_CURVES[0]
    deviation_mm: float | None = None
    max_angle_deg: float | None = None
    mode: int = 1
    error_mm: float = HSC_ERROR_MM

    def deviation(self, listed_mm: float) -> float:
        """Return the deviation at a corner in mm; ``listed_mm``: that of the channel list."""
        if not self.curve:
            return self.error_mm
        return listed_mm if self.deviation_mm is None else self.deviation_mm

    def max_bend(self, listed_deg: float) -> float:
        """Return the largest change of direction that is rounded; the angle 0 means any."""
        angle = listed_deg if self.max_angle_deg is None else self.max_angle_deg
        return bend_of(angle) if self.curve and angle > 0.0 else MAX_BEND


@dataclass(slots=True)
class PathState:
    """The modal state of the path: plane, arcs, ends of blocks.

    ``limits_jerk``: the slope is an S-curve (P-CHAN-00071). ``radius``: the last R, 0 before the
    first. ``contour``: how corners are rounded. ``has_diameters``: positions or distances of the
    face axis are diameters (G51). ``turning_plane``: the axes of the plane of #FACE or #CYL.
    ``hsc_deviation``: that of ``#HSC`` in mm, 0 while it is off.
    """

    plane: int
    absolute_centre: bool
    limits_jerk: bool
    radius: float = 0.0
    exact_stop: bool = False
    contouring: bool = False
    contour: ContourState = field(default_factory=ContourState)
    has_diameters: bool = False
    turning_plane: tuple[int, int] | None = None
    last_arc: LastArc | None = None
    compensation: CompensationState = field(default_factory=CompensationState)
    hsc: HscState = field(default_factory=HscState)
    hsc_deviation: float = 0.0

    @property
    def plane_axes(self) -> tuple[int, int]:
        """The axes of the plane in which arcs and contours lie."""
        return self.turning_plane or PLANES[self.plane]

    @property
    def rounding(self) -> float:
        """How corners are rounded: the deviation in mm; negative: the distance from the corner;
        0: not at all.
        """
        return self.contour.size if self.contouring else self.hsc_deviation


@dataclass(slots=True)
class ToolState:
    """The tool; ``number``: the last T; ``record``: the last D; ``tool``: the record that D
    selects. ``length_axis``: the index of the axis of its length, and the sign (``#TLAX``).
    """

    number: int = 0
    record: int = 0
    tool: Tool = NO_TOOL
    length_axis: tuple[int, int] | None = None


@dataclass(frozen=True, slots=True)
class FeedGroup:
    """The axes that F refers to, other than the linear ones (``#FGROUP``).

    ``axes``: their indices with a factor of their distances; empty: the linear ones.
    ``is_weakest``: F is the speed of the axis that needs the longest time. ``rotary`` counts at
    ``radius`` mm, -1: none does.
    """

    axes: Mapping[int, float] = field(default_factory=dict)
    is_weakest: bool = False
    rotary: int = -1
    radius: float = 0.0

    @property
    def is_linear(self) -> bool:
        """Whether F refers to the linear axes, as ever."""
        return not self.axes and not self.is_weakest and self.rotary < 0

    def after_exchange(self, moved: Mapping[int, int]) -> FeedGroup | None:
        """Return the group without the axes that the channel has given away.

        ``moved``: old indices -> new ones of those that it keeps.
        """
        axes = {moved[index]: factor for index, factor in self.axes.items() if index in moved}
        group = FeedGroup(axes, self.is_weakest, moved.get(self.rotary, -1), self.radius)
        return None if group.is_linear else group


@dataclass(frozen=True, slots=True)
class CornerFeed:
    """The feed that G13 slows down to at the end of a block, over ``distance_mm`` (#CORNER PARAM).

    ``feed``: mm/s, or with ``is_share`` a factor of F.
    """

    distance_mm: float
    feed: float
    is_share: bool

    def feed_mm_s(self, programmed_mm_s: float) -> float:
        """Return the feed at the end of a block whose F is ``programmed_mm_s``, at most that."""
        slow = self.feed * programmed_mm_s if self.is_share else self.feed
        return min(slow, programmed_mm_s)


@dataclass(slots=True)
class FeedState:
    """The meaning of F (``feed_mode``), its values under G93, G95 and G194, and programmed
    overrides.

    ``follows_spindle``: the feed under G95 follows the actual speed of the spindle (#TURN).
    Overrides are factors for feed and rapid blocks, of the path and by axis index. ``group``: the
    axes whose path F applies to, ``None``: the linear ones. ``slows_at_ends``: G13, to ``corner``.
    """

    feed_mode: int = FEED_PER_MINUTE
    time_s: float = 0.0
    per_revolution_mm: float = 0.0
    follows_spindle: bool = True
    share_pct: float = 0.0
    path_override: tuple[float, float] = (1.0, 1.0)
    axis_overrides: dict[int, tuple[float, float]] = field(default_factory=dict)
    group: FeedGroup | None = None
    corner: CornerFeed | None = None
    slows_at_ends: bool = False

    @property
    def block_time_s(self) -> float:
        """The duration of a feed block under G93, else 0."""
        return self.time_s if self.feed_mode == INVERSE_TIME_FEED else 0.0


@dataclass(slots=True)
class ThreadState:
    """Values of earlier blocks for threads: pitches in mm by their words, S of tapping in 1/min.

    ``speed``: below 0 turns backward, 0: none yet. ``spindle``: its place in the channel, -1: the
    main spindle. ``offset``: the start angle of cut threads in degrees, until another motion.
    ``chains``: a thread continues into the next block. ``has_noted_cutting``,
    ``has_noted_tapping``: the notes on decisions have been given.
    """

    pitches: dict[str, float] = field(default_factory=dict)
    speed: float = 0.0
    spindle: int = -1
    offset: float = 0.0
    chains: bool = True
    has_noted_cutting: bool = False
    has_noted_tapping: bool = False


@dataclass(frozen=True, slots=True)
class Measured:
    """The result of a measuring block for one axis, in mm or degrees.

    ``has_touched``: the signal came. ``value``: with all offsets, in the active coordinate system;
    ``acs_value``: of the axis itself; ``pcs_value``: as programmed. ``deviation``: from the target.
    """

    has_touched: bool = False
    value: float = 0.0
    acs_value: float = 0.0
    pcs_value: float = 0.0
    deviation: float = 0.0


@dataclass(slots=True)
class MeasuringState:
    """How G100 measures until the end of the program, and its results by axis index.

    ``type``: 0: that of the list. ``needs_signal``: ``None``: as the list says. ``lead``: mm before
    the target where a simulated probe touches (SIMU_OFFSET). ``level``: the value of HLI.PROBE that
    is the signal.
    """

    type: int = 0
    needs_signal: bool | None = None
    lead: float = 0.0
    level: int = 1
    measured: dict[int, Measured] = field(default_factory=dict)


@dataclass(slots=True)
class ModalState:
    """The modal state; ``motion``: an active G function; ``feed_mm_s``: under G94, 0 before an F.

    ``parameters``: P1, P2, … ``measures``: edge banding is on (G108). ``message_file``: the file of
    saved messages, ``named_programs``: those of M6 and G80 … by word (#FILENAME). ``not_plain``:
    the active G functions that plain lines do not know, by group. ``monitored``: the axes at a
    fixed stop or moving towards it. ``has_read_signal``: the last ``#SIGNAL READ`` has taken one.
    ``limits``: weights, and the limits of the path. ``shapes``: chamfers and roundings.
    ``measuring``: with a touch probe. ``is_searching``: block search has not reached its start
    block. ``orientation``: the meaning of A, B, C under a transformation. ``wcs``, ``mcs``: V.A.WCS
    and V.A.MCS by axis, in mm or degrees. ``frame``: mirroring, rotation and scaling.
    ``block_number``: the last N. ``couplings``: axes that follow others. ``feed_forward``: G135 …
    G137. ``spindles_without_axis``: those whose axis ``S[PUTAX]`` has given away, by their indices
    in the channel list.
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
    named_programs: dict[str, str] = field(default_factory=dict)
    measures: bool = False
    feed: FeedState = field(default_factory=FeedState)
    thread: ThreadState = field(default_factory=ThreadState)
    call_stack: CallStack = field(default_factory=CallStack)
    not_plain: dict[Group, int] = field(default_factory=dict)
    monitored: set[str] = field(default_factory=set)
    has_read_signal: bool = False
    limits: LimitState = field(default_factory=LimitState)
    shapes: ShapeState = field(default_factory=ShapeState)
    measuring: MeasuringState = field(default_factory=MeasuringState)
    orientation: str = ANGLE
    is_searching: bool = False
    wcs: dict[int, float] = field(default_factory=dict)
    mcs: dict[int, float] = field(default_factory=dict)
    software_limits: LimitsOfProgram = field(default_factory=LimitsOfProgram)
    frame: ContourFrame = field(default_factory=ContourFrame)
    block_number: int = 0
    main_spindle: int = -1
    spindles_without_axis: set[int] = field(default_factory=set)
    feed_forward: FeedForwardState = field(default_factory=FeedForwardState)
    couplings: ActiveCouplings = field(default_factory=ActiveCouplings)

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
        if self.orientation != ANGLE or self.limits.weights_blocks:
            return False
        has_feed_of_its_own = has_override or feed.group is not None
        if has_feed_of_its_own or self.shapes.spline.is_on or self.frame.is_active:
            return False
        return not (self.not_plain or self.monitored or self.couplings.of_axes)

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
