# SPDX-License-Identifier: MIT
"""Active offsets between programmed and axis positions, and their commands.

In: G53 … G59, G159, G92, ``#PSET``, ``#PRESET``, ``#MCS``, the lists of zero and clamp offsets,
the tool.
Out: the offset of an absolute position (``ActiveOffsets.total``), and ``SetOffset`` commands that
keep the V.RTA positions in PCS in step with the blocks (MO-8). An offset moves no axis: it applies
to the next absolute position of the axis; relative motions are unaffected.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from nctakt.base.dataclass import dataclass
from nctakt.decoder.kinematics.selection import ChannelAxes
from nctakt.decoder.state.geometry.coordinate_systems import (
    LAYERS,
    MAIN_AXES,
    ActiveSystem,
    CoordinateSystems,
    LowerOffsets,
    Placement,
    SavedOffsets,
)
from nctakt.decoder.state.geometry.transformation import NO_STEPS, ActiveTransformation, Steps
from nctakt.decoder.state.queued.commands import Command, SetOffset
from nctakt.kernel import codes
from nctakt.kernel.axes.coordinates import Offsets
from nctakt.lists.declared.offsets import ClampOffsets, ZeroOffsets
from nctakt.nc.tree import Keyword, OffsetCommand
from nctakt.nc.vocabulary.functions import ZERO_OFFSETS

#: The zero offset that each G function selects (P-ZERO-00003); G159 has its own number.
ZERO_GROUPS = {function: group for group, function in enumerate(ZERO_OFFSETS)}

#: Bits of the kinds of offsets by keyword (RC-407).
KEYWORDS = {
    "ZERO": 1 << codes.ZERO_OFFSET,
    "ADD_ZERO": 1 << codes.ADD_ZERO_OFFSET,
    "PSET": 1 << codes.PSET_OFFSET,
    "CLAMP": 1 << codes.CLAMP_OFFSET,
    "TOOL": 1 << codes.TOOL_OFFSET,
    "MEASURE": 1 << codes.MEASURE_OFFSET,
    "MANUAL": 1 << codes.MANUAL_OFFSET,
}
KEYWORDS["ALL"] = codes.ALL_OFFSETS

#: Kinds that a coordinate system absorbs when it is entered: all but the tool's.
KINDS_IN_SYSTEMS = tuple(kind for kind in range(codes.OFFSET_KINDS) if kind != codes.TOOL_OFFSET)


def remaining_offset_kinds(command: OffsetCommand) -> int:
    """Return the kinds of offsets that stay active under ``#SUPPRESS OFFSETS``, as bits."""
    named = [KEYWORDS[kind.name] for kind in command.kinds if isinstance(kind, Keyword)]
    return codes.ALL_OFFSETS - sum(dict.fromkeys(named)) if named else 0


@dataclass(slots=True)
class SuspendedCoordinates:
    """The settings that ``#MCS ON`` has switched off.

    ``steps`` and ``map_number``: of the transformation. ``is_without_tools``: tools that are
    selected meanwhile have no offsets (EX TOOL); ``has_tool``: one was selected, and it has.
    """

    steps: Steps
    map_number: int
    systems: list[ActiveSystem]
    offsets: SavedOffsets
    is_without_tools: bool
    has_tool: bool = False


class ActiveOffsets:
    """The offsets of a channel's axes in the decoder, in mm or degrees.

    ``axes``: the numbers of the channel's axes in the machine. ``zero_groups``: zero offsets by
    group and axis. ``default_group``: the group at program start. ``clamp_group``: the active clamp
    offsets. ``suspended``: the settings that are off until ``#MCS OFF``, ``None`` without ``#MCS
    ON``.
    """

    def __init__(
        self,
        axes: Sequence[int],
        zero_offsets: ZeroOffsets,
        clamp_offsets: ClampOffsets,
        transformation: ActiveTransformation,
    ) -> None:
        self._axes = tuple(axes)
        self._values = [[0.0] * codes.OFFSET_KINDS for _ in axes]
        self.zero_groups = {group: dict(values) for group, values in zero_offsets.groups.items()}
        self.default_group = zero_offsets.default_group
        self._clamp_offsets = clamp_offsets
        self.clamp_group = 0
        #: Zero offsets by group and axis of the machine, as they were before an exchange.
        self._absent: dict[int, dict[int, float]] = {}
        self.systems = CoordinateSystems(self._axes)
        self.transformation = transformation
        self.suspended: SuspendedCoordinates | None = None

    def exchange(self, own: ChannelAxes) -> None:
        """Take the axes of a channel whose axes were exchanged.

        Offsets of an exchanged axis begin at 0; offsets of the lists follow the axes that they are
        for. Neither a system nor a transformation of exchanged axes is active.
        """
        axes = own.members
        before = dict(zip(self._axes, self._values, strict=True))
        for group, values in self.zero_groups.items():
            by_axis = self._absent.setdefault(group, {})
            by_axis |= {
                self._axes[slot]: value for slot, value in values.items() if slot < len(self._axes)
            }
            places = enumerate(axes)
            self.zero_groups[group] = {
                slot: by_axis[axis] for slot, axis in places if axis in by_axis
            }
        self._axes = axes
        self._values = [before.get(axis, [0.0] * codes.OFFSET_KINDS) for axis in axes]
        self.systems = CoordinateSystems(self._axes)
        self.transformation.exchange(own)

    def total(self, axis: int, kinds: int = codes.ALL_OFFSETS) -> float:
        """Return the sum of the offsets of these kinds for an absolute position of an axis.

        In a coordinate system of the program the tool offset is not included (``inside``).
        """
        if self.systems.is_active:
            kinds &= codes.ALL_OFFSETS - KEYWORDS["TOOL"]
        values = self._values[axis]
        if kinds == codes.ALL_OFFSETS:
            return sum(values)
        return sum(value for kind, value in enumerate(values) if kinds >> kind & 1)

    def value(self, axis: int, kind: int) -> float:
        """Return the offset of one kind."""
        return self._values[axis][kind]

    # --- coordinate systems ---------------------------------------------------------------------

    def inside(self, positions: Sequence[float], kinds: int = codes.ALL_OFFSETS) -> list[float]:
        """Return axis positions in the program's coordinate system, including offsets."""
        if not self.systems.is_active:
            return list(positions)
        return self.systems.inside(positions, self._tool(kinds))

    def outside(self, positions: Sequence[float], kinds: int = codes.ALL_OFFSETS) -> list[float]:
        """Return the axis positions of coordinates, the inverse of ``inside``."""
        if not self.systems.is_active:
            return list(positions)
        return self.systems.outside(positions, self._tool(kinds))

    def _tool(self, kinds: int) -> list[float]:
        acts = kinds >> codes.TOOL_OFFSET & 1
        return [values[codes.TOOL_OFFSET] if acts else 0.0 for values in self._values]

    def converted(
        self,
        positions: Sequence[float],
        near: Sequence[float],
        system: Placement | None,
        map_number: int,
        to_machine: bool,
    ) -> tuple[list[float], int]:
        """Return programmed positions as those of the axes, or the other way round.

        In between lie the offsets, a ``system`` that is not active, and a map; the axes are at
        ``near``. Returns ``REACHED`` as well, or why no position leads there.
        """
        systems = CoordinateSystems(self._axes)
        without_tool = codes.ALL_OFFSETS - KEYWORDS["TOOL"]
        shift = [self.total(axis, without_tool) for axis in range(len(near))]
        tool = self._tool(codes.ALL_OFFSETS)
        if map_number:
            tool[:MAIN_AXES] = [0.0] * MAIN_AXES  # the map has them
        if system is None:
            tool = [a + b for a, b in zip(shift, tool, strict=True)]
        else:
            lower = LowerOffsets((), tuple(shift), 0)
            # No command: nothing is activated by it.
            list(systems.enter(LAYERS.index("CS"), system, lower, 0, 0))
        if to_machine:
            outside = systems.outside(positions, tool)
            return self.transformation.mapped(map_number, outside, near, to_machine)
        inside, answer = self.transformation.mapped(map_number, positions, near, to_machine)
        return systems.inside(inside, tool), answer

    def enter_system(
        self, layer: int, placement: Placement, axis_count: int, source: int, number: int
    ) -> Iterator[Command]:
        """Activate a system: the active offsets shift it and restart at 0 in it.

        Those of the first ``axis_count`` axes, if it is the innermost system; one that lies below
        others takes the offsets of the one above.
        """
        without_tool = codes.ALL_OFFSETS - KEYWORDS["TOOL"]
        count = len(self._axes)
        own = range(min(axis_count, count))
        shift = [self.total(axis, without_tool) if axis in own else 0.0 for axis in range(count)]
        kept = tuple(tuple(values) for values in self._values)
        lower = LowerOffsets(kept, tuple(shift), len(own))
        is_innermost = yield from self.systems.enter(layer, placement, lower, source, number)
        for kind in KINDS_IN_SYSTEMS if is_innermost else ():
            for axis in own:
                yield from self._set(axis, kind, 0.0, source, number)

    def leave_system(self, layer: int, source: int, number: int) -> Iterator[Command]:
        """Leave the last system of a kind; restore the offsets before the innermost one."""
        lower = yield from self.systems.leave(layer, source, number)
        if lower is not None:
            for kind in KINDS_IN_SYSTEMS:
                for axis in range(lower.axis_count):
                    yield from self._set(axis, kind, lower.values[axis][kind], source, number)

    # --- machine coordinates --------------------------------------------------------------------

    @property
    def is_kinematic_suspended(self) -> bool:
        """Whether a transformation is off until ``#MCS OFF``."""
        return self.suspended is not None and self.suspended.steps != NO_STEPS

    @property
    def has_tool_offsets(self) -> bool:
        """Whether the tool has offsets: between ``#MCS ON`` and ``OFF`` one selected there."""
        return self.suspended is None or self.suspended.has_tool

    def suspend(
        self, steps: Steps, map_number: int, is_without_tools: bool, source: int, number: int
    ) -> Iterator[Command]:
        """Switch off systems and offsets until ``resume``; the transformation is off already."""
        kept = tuple(tuple(values) for values in self._values)
        systems = yield from self.systems.suspend(source, number)
        self.suspended = SuspendedCoordinates(steps, map_number, systems, kept, is_without_tools)
        for kind in range(codes.OFFSET_KINDS):
            yield from self._set_group(kind, {}, source, number)

    def resume(
        self, suspended: SuspendedCoordinates, source: int, number: int
    ) -> Iterator[Command]:
        """Undo ``suspend``."""
        self.suspended = None
        yield from self.systems.resume(suspended.systems, source, number)
        for kind in range(codes.OFFSET_KINDS):
            before = {axis: values[kind] for axis, values in enumerate(suspended.offsets)}
            yield from self._set_group(kind, before, source, number)

    def adopt(self, offsets: Offsets) -> None:
        """Adopt the offsets of the realtime part; after a reset some commands were never
        executed.
        """
        for values, axis in zip(self._values, self._axes, strict=True):
            for kind in range(codes.OFFSET_KINDS) if axis >= 0 else ():
                values[kind] = offsets.of(axis, 1 << kind)

    # --- commands, from ``source`` in the block ``number`` ---------------------------------------

    def begin_program(self) -> Iterator[Command]:
        """Yield the commands that set zero and clamp offsets to those of the lists."""
        self.suspended = None
        yield from self.transformation.begin_program()
        yield from self.systems.begin_program()
        yield from self._set_group(codes.ZERO_OFFSET, self._group(self.default_group), 0, 0)
        clamp = self._clamp_offsets.groups.get(self.clamp_group, {})
        yield from self._set_group(codes.CLAMP_OFFSET, clamp, 0, 0)
        for kind in (
            codes.ADD_ZERO_OFFSET,
            codes.PSET_OFFSET,
            codes.TOOL_OFFSET,
            codes.MEASURE_OFFSET,
        ):
            yield from self._set_group(kind, {}, 0, 0)

    def select_group(self, group: int, source: int, number: int) -> Iterator[SetOffset]:
        """Select a zero offset (G53 … G59, G159); one missing in the list is 0."""
        yield from self._set_group(codes.ZERO_OFFSET, self._group(group), source, number)

    def add_zero(
        self, axis: int, value: float, relative: bool, source: int, number: int
    ) -> Iterator[SetOffset]:
        """Set the G92 offset of one axis; under G91 add to it."""
        before = self._values[axis][codes.ADD_ZERO_OFFSET] if relative else 0.0
        yield from self._set(axis, codes.ADD_ZERO_OFFSET, before + value, source, number)

    def set_zero(self, axis: int, value: float, source: int, number: int) -> Iterator[SetOffset]:
        """Set the zero offset of one axis until the next selection."""
        yield from self._set(axis, codes.ZERO_OFFSET, value, source, number)

    def preset(
        self, axis: int, position: float, value: float, source: int, number: int
    ) -> Iterator[SetOffset]:
        """Name the current position (ACS) of an axis ``value`` (``#PSET``)."""
        others = self.total(axis, codes.ALL_OFFSETS - KEYWORDS["PSET"])
        yield from self._set(axis, codes.PSET_OFFSET, position - others - value, source, number)

    def release(self, axis: int, source: int, number: int) -> Iterator[SetOffset]:
        """Remove the preset of an axis (``#PRESET``)."""
        yield from self._set(axis, codes.PSET_OFFSET, 0.0, source, number)

    def set_tool(
        self, offsets: Mapping[int, float], source: int, number: int
    ) -> Iterator[SetOffset]:
        """Set the offsets of the tool, by axis index."""
        yield from self._set_group(codes.TOOL_OFFSET, offsets, source, number)

    def set_measured(
        self, axis: int, value: float, source: int, number: int
    ) -> Iterator[SetOffset]:
        """Set the measuring offset of one axis (G101); 0 takes it out (G102)."""
        yield from self._set(axis, codes.MEASURE_OFFSET, value, source, number)

    def _group(self, group: int) -> Mapping[int, float]:
        return self.zero_groups.get(group, {})

    def _set_group(
        self, kind: int, values: Mapping[int, float], source: int, number: int
    ) -> Iterator[SetOffset]:
        for axis in range(len(self._axes)):
            yield from self._set(axis, kind, values.get(axis, 0.0), source, number)

    def _set(
        self, axis: int, kind: int, value: float, source: int, number: int
    ) -> Iterator[SetOffset]:
        if self._values[axis][kind] != value and self._axes[axis] >= 0:
            self._values[axis][kind] = value
            yield SetOffset(source, number, self._axes[axis], kind, value)
