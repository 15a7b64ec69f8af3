# SPDX-License-Identifier: MIT
"""Mistakes of the path that no run is needed for: arcs off their circle, targets out of the limits,
blocks without feed, axes that others have.

In: the statements of a program in the order of execution, each once. Out: the diagnostics that a
run would give. Only constants and certain facts count: where a position, a plane or an offset
depends on a value, a call, a branch or a realtime cycle, nothing is reported.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span
from nctakt.base.line_shift import LineShift
from nctakt.checking.cycle_axes import (
    begin_cycle,
    check_motion,
    check_word,
    end_block,
    note_exchange,
)
from nctakt.checking.feeds_and_speeds import (
    allows_speeds,
    begin_program,
    check_feed,
    check_speeds,
    note_feed,
)
from nctakt.checking.path_facts import Facts
from nctakt.decoder.blocks.path.path_motion import CENTRE_WORDS
from nctakt.decoder.state.geometry.arcs import (
    PLANES,
    Arc,
    ArcError,
    arc_about,
    arc_of_radius,
    extremes,
)
from nctakt.lists.machine.axis_configuration import AxisConfiguration
from nctakt.lists.machine.channel_configuration import (
    CENTRE_GROUP,
    DIMENSION_GROUP,
    MOTION_GROUP,
    PLANE_GROUP,
    UNIT_GROUP,
    ChannelParameters,
)
from nctakt.messages.axes.axis_motions import INDP_TARGET_OUTSIDE_LIMITS
from nctakt.messages.path.motion import ARC_OUTSIDE_LIMITS
from nctakt.messages.programs.decoder import TARGET_OUTSIDE_LIMITS
from nctakt.nc.check.axes.main_spindle import is_main_spindle
from nctakt.nc.check.calls import may_call
from nctakt.nc.check.findings import Findings
from nctakt.nc.check.path.dwells import dwell_of
from nctakt.nc.meaning.axes import fixed_targets
from nctakt.nc.tree import (
    Assignment,
    AxisWord,
    Block,
    BracketCommand,
    CycleControl,
    Do,
    Expression,
    Flush,
    For,
    HashCommand,
    If,
    MacroDefinition,
    Number,
    RealtimeCycle,
    RealtimeLoop,
    Repeat,
    Statement,
    Switch,
    Time,
    Timer,
    Unary,
    UserError,
    UserMessage,
    Variable,
    VariableDeclarations,
    While,
    Word,
)
from nctakt.nc.vocabulary import support_level
from nctakt.nc.vocabulary.entries import Support
from nctakt.nc.vocabulary.function_rows import Group
from nctakt.nc.vocabulary.functions import (
    ABSOLUTE,
    ABSOLUTE_CENTRE,
    ARC_CLOCKWISE,
    ARC_RADIUS,
    ARCS,
    AXIS_VALUES,
    AXIS_WEIGHTS,
    CONSTANT_SPEED,
    CUTTING_SPEED,
    DIAMETER_ON,
    EDGE_BANDING,
    INCH,
    MAPS_BY_AXES,
    MAPS_OFF,
    MEASURING,
    REFERENCE_OFFSET,
    ROTATION_ON,
    SUBPROGRAM_ENDS,
    group_of,
)
from nctakt.nc.vocabulary.single_axes.axis_commands import blocks_in

#: Programs up to this length are followed block by block; others only where a block is new.
MAX_LINES = 5000
_MM_PER_INCH = 25.4
#: ``#`` commands that move nothing and shift nothing.
_QUIET_COMMANDS = ("CONTOUR", "SLOPE", "OVERRIDE", "EXPL", "FILENAME")
_QUIET_STATEMENTS = (
    Flush,
    MacroDefinition,
    Time,
    Timer,
    UserError,
    UserMessage,
    VariableDeclarations,
)


@dataclass(frozen=True, slots=True)
class PathState:
    """The state of a checker of the path between two statements."""

    facts: Facts
    has_axis_cycles: bool
    is_main: bool

    def shifted(self, shift: LineShift) -> PathState:
        """Return it for a text with other lines; raises ``ReplacedLine``."""
        return replace(self, facts=self.facts.shifted(shift))


class PathChecker:
    """Follows one program; ``axes``: those of the channel by name, in the order of the path.

    ``begins``: the program may be a main program, which begins with the settings of the channel
    list. ``speed_limits``: spindle -> its highest speed in 1/min, of those with one gear step.
    """

    def __init__(
        self,
        channel: ChannelParameters,
        axes: Mapping[str, AxisConfiguration],
        findings: Findings,
        *,
        begins: bool,
        is_shifted: bool,
        speed_limits: Mapping[str, float] = MappingProxyType({}),
    ) -> None:
        self._channel = channel
        self._speed_limits = speed_limits
        self._axes = axes
        self._names = list(axes)
        self._findings = findings
        self._begins = begins and not channel.implicit_programs.program_start
        self._starts_shifted = is_shifted
        self._facts = Facts()
        self._has_axis_cycles = False
        #: M17 and M29 of the main program: how the program begins is its caller's matter.
        self.subprogram_ends: list[Span] = []
        self._is_main = False

    @property
    def state(self) -> PathState:
        """State that later statements depend on."""
        return PathState(self._facts.copy(), self._has_axis_cycles, self._is_main)

    def resume(self, state: PathState) -> None:
        """Continue from a state."""
        self._facts = state.facts.copy()
        self._has_axis_cycles = state.has_axis_cycles
        self._is_main = state.is_main

    def section(self, *, is_main: bool) -> None:
        """Begin a main program or a subprogram."""
        self._is_main = is_main
        self._facts = Facts()
        if is_main and self._begins:
            functions = self._channel.program_start.g_functions
            self._facts = Facts(
                motion=functions[MOTION_GROUP],
                plane=functions[PLANE_GROUP],
                is_absolute=functions[DIMENSION_GROUP] == ABSOLUTE,
                has_absolute_centre=functions[CENTRE_GROUP] == ABSOLUTE_CENTRE,
                is_inch=functions[UNIT_GROUP] == INCH,
                is_shifted=None if self._starts_shifted else False,
                has_diameters=False,
            )
            begin_program(self._facts, self._channel)

    def statement(self, statement: Statement) -> None:
        """Follow one statement with all statements inside it."""
        if statement.head.label is not None:
            self._facts = Facts()  # a jump may lead here from anywhere
        before = self._facts.copy() if statement.head.skip is not None else None
        match statement:
            case Block():
                self._block(statement)
            case If():
                self._branches(
                    statement.body,
                    *(branch.body for branch in statement.elseifs),
                    statement.else_body or (),
                )
            case Switch():
                self._branches((), *(case.body for case in statement.cases))
            case For() | While() | Do() | Repeat() | RealtimeLoop():
                self._facts = Facts()
                self._all(statement.body)
                self._facts = Facts()
            case RealtimeCycle():
                begin_cycle(statement, self._facts, self._findings)
                for block in blocks_in(statement.body):
                    self._speeds(block)
                self._has_axis_cycles |= _commands_axes(statement.body)
            case CycleControl():
                self._facts.commanded.clear()
            case Assignment():
                if isinstance(statement.target, Variable) and statement.target.family == "G":
                    self._shift()
            case HashCommand():
                note_exchange(statement, self._facts, self._names)
                if is_main_spindle(statement):
                    self._facts.is_cutting = None
                if not _is_quiet(statement):
                    self._shift()
            case _ if not isinstance(statement, _QUIET_STATEMENTS):
                self._facts = Facts()
        if not isinstance(statement, RealtimeCycle):
            end_block(self._facts)
        if self._has_axis_cycles:
            self._facts.positions.clear()
        if before is not None:
            self._facts.join(before)

    def _all(self, statements: Sequence[Statement]) -> None:
        for statement in statements:
            self.statement(statement)

    def _branches(self, *bodies: Sequence[Statement]) -> None:
        before, after = self._facts, []
        for body in bodies:
            self._facts = before.copy()
            self._all(body)
            after.append(self._facts)
        self._facts = after[0]
        for other in after[1:]:
            self._facts.join(other)

    def _shift(self) -> None:
        """Forget where the axes are, and whether offsets act."""
        self._facts.positions.clear()
        self._facts.is_shifted = None

    # --- blocks ----------------------------------------------------------------------------------

    def _block(self, block: Block) -> None:
        if dwell_of(block) is not None:
            return
        if may_call(block):
            self._facts = Facts()
            return
        facts = self._facts
        for word in block.words:
            if isinstance(word, BracketCommand) and word.name in self._axes:
                facts.positions.clear()
            elif isinstance(word, Word) and word.name == "M" and _is_one_of(word, SUBPROGRAM_ENDS):
                if self._is_main:
                    self.subprogram_ends.append(word.span)
            elif isinstance(word, Word) and word.name in ("T", "D"):
                self._shift()
        numbers = [word for word in block.words if isinstance(word, Word) and word.name == "G"]
        if any(not isinstance(word.value, Number) for word in numbers):
            self._facts = Facts()
            return
        functions = [int(word.value.value) for word in numbers if isinstance(word.value, Number)]
        for function in functions:
            self._function(function)
        for word in block.words:
            if isinstance(word, BracketCommand):
                self._single_axis(word)
        note_feed(block, facts)
        if allows_speeds(functions, facts):
            self._speeds(block)
        if ROTATION_ON not in functions:
            self._radius(block)
        if REFERENCE_OFFSET in functions:
            self._shift()
        elif not MAPS_BY_AXES.isdisjoint(functions):
            pass
        elif not AXIS_VALUES.isdisjoint(functions) or MEASURING in functions:
            self._shift()
        elif AXIS_WEIGHTS.isdisjoint(functions):
            self._move(block)

    def _function(self, function: int) -> None:
        facts = self._facts
        match group_of(function):
            case Group.MOTION:
                facts.motion = function
            case Group.PLANE:
                facts.plane = function
            case Group.DIMENSION:
                facts.is_absolute = function == ABSOLUTE
            case Group.ARC_CENTRE:
                facts.has_absolute_centre = function == ABSOLUTE_CENTRE
            case Group.FEED:
                facts.feed_mode = function
            case Group.CUTTING:
                is_known = function in (CUTTING_SPEED, CONSTANT_SPEED)
                facts.is_cutting = function == CUTTING_SPEED if is_known else None
            case Group.DIAMETER:
                facts.has_diameters = function == DIAMETER_ON
            case Group.UNIT:
                facts.is_inch = function == INCH
            case Group.ZERO_OFFSET:
                self._shift()
            case Group.MIRROR | Group.ROTATION if (
                function not in MAPS_OFF or facts.is_shifted is not False
            ):
                self._shift()
            case Group.COMPENSATION:
                facts.positions.clear()
            case Group.EDGE_BANDING if function == EDGE_BANDING:
                facts.positions.clear()

    def _radius(self, block: Block) -> None:
        for word in block.words:
            if not isinstance(word, Word):
                continue
            value = None
            if word.name == "R":
                value = word.value
            elif word.name == "G" and _is_one_of(word, (ARC_RADIUS,)):
                value = word.additional
            if value is not None:
                self._facts.radius_mm = self._length(value)

    def _move(self, block: Block) -> None:
        facts = self._facts
        words = [word for word in block.words if isinstance(word, AxisWord)]
        centre = {
            word.name: word
            for word in block.words
            if isinstance(word, Word) and word.name in CENTRE_WORDS
        }
        if not words and not centre:
            return
        start = dict(facts.positions)
        for word in words:
            check_word(word, facts, self._findings)
            self._target(word)
            check_motion(word.name, facts.positions.get(word.name), facts, self._findings)
        self._feed(block.span, start)
        if facts.motion in ARCS and facts.plane is not None:
            arc = self._arc(block.span, start, centre)
            if arc is not None and facts.is_shifted is False:
                self._arc_limits(arc, start, block.span)

    def _diameter_or_radius(self, axis: AxisConfiguration, value: float) -> float | None:
        """Return the meaning of a face axis value under G51; ``None`` if that is uncertain."""
        facts = self._facts
        is_diameter = axis.absolute_diameters if facts.is_absolute else axis.relative_diameters
        if axis.absolute_diameters != axis.relative_diameters and facts.is_absolute is None:
            return None
        if not is_diameter:
            return value
        return 0.5 * value if facts.has_diameters else None

    def _speeds(self, block: Block) -> None:
        is_known = self._facts.is_cutting is not None
        check_speeds(block, self._channel, self._speed_limits, self._findings, has_main=is_known)

    def _feed(self, span: Span, start: Mapping[str, float]) -> None:
        """Check that a block has a feed where an axis certainly moves."""
        ends = self._facts.positions
        if any(start[axis] != end for axis, end in ends.items() if axis in start):
            check_feed(span, self._facts, self._findings)

    def _target(self, word: AxisWord) -> None:
        """Note where a word leads its axis, and check its limits."""
        facts, axis = self._facts, self._axes.get(word.name)
        if axis is None:
            return
        value = None if word.value is None else self._constant(word.value)
        if value is not None and axis.is_linear:
            value = None if facts.is_inch is None else value * self._unit()
        if value is not None and axis.is_face and facts.has_diameters is not False:
            value = self._diameter_or_radius(axis, value)
        if value is not None and facts.is_absolute is False:
            begin = facts.positions.get(word.name)
            value = None if begin is None else begin + value
        if value is None or facts.is_absolute is None:
            facts.positions.pop(word.name, None)
            return
        facts.positions[word.name] = value
        low, high = axis.software_limit_low, axis.software_limit_high
        if facts.is_shifted is False and not axis.is_modulo and not low <= value <= high:
            self._findings.report(
                TARGET_OUTSIDE_LIMITS, word.span, axis=word.name, position=value, low=low, high=high
            )

    def _single_axis(self, bracket: BracketCommand) -> None:
        """Check the target of an independent axis against its limits."""
        facts, axis = self._facts, self._axes.get(bracket.name)
        if axis is None or axis.is_modulo or facts.is_shifted is not False:
            return
        low, high = axis.software_limit_low, axis.software_limit_high
        for position in fixed_targets(bracket):
            value = self._constant(position)
            if value is not None and axis.is_linear:
                value = None if facts.is_inch is None else value * self._unit()
            if value is not None and not low <= value <= high:
                self._findings.report(
                    INDP_TARGET_OUTSIDE_LIMITS,
                    position.span,
                    axis=bracket.name,
                    target=value,
                    low=low,
                    high=high,
                )

    # --- arcs ------------------------------------------------------------------------------------

    def _arc(
        self, span: Span, start: Mapping[str, float], centre: Mapping[str, Word]
    ) -> Arc | None:
        """Return the arc of a block whose geometry is known; report what makes it impossible."""
        facts = self._facts
        assert facts.plane is not None
        plane = PLANES[facts.plane]
        if max(plane) >= len(self._names):
            return None
        begin, end = self._position_of(start, plane), self._position_of(facts.positions, plane)
        if begin is None or end is None:
            return None
        clockwise = facts.motion == ARC_CLOCKWISE
        try:
            if centre:
                middle = self._centre(begin, plane, centre)
                if middle is None:
                    return None
                tolerance = self._channel.centre_tolerance
                return arc_about(begin, end, PLANES[facts.plane], middle, clockwise, tolerance)
            if facts.radius_mm and begin != end:
                return arc_of_radius(begin, end, PLANES[facts.plane], facts.radius_mm, clockwise)
        except ArcError as error:
            self._findings.report(error.message, span, **error.values)
        return None

    def _position_of(
        self, positions: Mapping[str, float], plane: tuple[int, int]
    ) -> list[float] | None:
        """Return a position as on the path; ``None`` if one of the plane is unknown."""
        names = self._names[: max(plane) + 1]
        if any(self._names[index] not in positions for index in plane):
            return None
        return [positions.get(name, 0.0) for name in names]

    def _centre(
        self, begin: Sequence[float], plane: tuple[int, int], centre: Mapping[str, Word]
    ) -> tuple[float, float] | None:
        if self._facts.has_absolute_centre is None:
            return None
        if any(CENTRE_WORDS.index(name) not in plane for name in centre):
            return None
        values = []
        for index in plane:
            word = centre.get(CENTRE_WORDS[index])
            value = 0.0
            if word is not None:
                length = None if word.value is None else self._length(word.value)
                if length is None:
                    return None
                value = length
            values.append(value if self._facts.has_absolute_centre else begin[index] + value)
        return values[0], values[1]

    def _arc_limits(self, arc: Arc, start: Mapping[str, float], span: Span) -> None:
        begin = self._position_of(start, (arc.first, arc.second))
        assert begin is not None
        for index, position in extremes(arc, begin):
            name = self._names[index]
            axis = self._axes[name]
            low, high = axis.software_limit_low, axis.software_limit_high
            if not axis.is_modulo and not low <= position <= high:
                self._findings.report(
                    ARC_OUTSIDE_LIMITS, span, axis=name, position=position, low=low, high=high
                )

    # --- values ----------------------------------------------------------------------------------

    def _unit(self) -> float:
        return _MM_PER_INCH if self._facts.is_inch else 1.0

    def _length(self, expression: Expression) -> float | None:
        """Return a constant length in mm."""
        value = self._constant(expression)
        return None if value is None or self._facts.is_inch is None else value * self._unit()

    def _constant(self, expression: Expression) -> float | None:
        if isinstance(expression, Number):
            return expression.value
        if isinstance(expression, Unary) and expression.operator == "-":
            value = self._constant(expression.operand)
            return None if value is None else -value
        return None


def _is_one_of(word: Word, numbers: Sequence[int]) -> bool:
    return isinstance(word.value, Number) and word.value.value in numbers


def _is_quiet(command: HashCommand) -> bool:
    words = [word.name for word in command.words]
    entry = support_level.hash_command(words)
    if entry is None:
        return False
    return entry.support is Support.ACCEPTED or words[0] in _QUIET_COMMANDS


def _commands_axes(statements: Sequence[Statement]) -> bool:
    """Return whether a realtime cycle may move an axis."""
    return any(
        isinstance(word, BracketCommand) for block in blocks_in(statements) for word in block.words
    )
