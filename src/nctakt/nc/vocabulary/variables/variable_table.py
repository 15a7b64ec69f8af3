# SPDX-License-Identifier: MIT
"""The V.* table: path -> type, unit, rights, and memory cell.

In: axes and variables from the lists. Out: ``Layout``, which assigns each variable of the machine
its cells in the one memory, and ``NameTable``, the view of one channel. Names are resolved once,
when a program is checked or decoded; the tick knows only cells. Realtime variables:
``realtime_variables.py``; V.E and V.CH: RC-301, RC-310.
"""

from __future__ import annotations

import copy
import enum
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from math import inf

from nctakt.base.dataclass import dataclass, field
from nctakt.base.misspelling import nearest
from nctakt.lists.declared.variables import SCALARS
from nctakt.lists.machine.external.variables import (
    AccessRights,
    IgnoredVariable,
    Node,
    Variable,
    VariableScope,
)
from nctakt.nc.vocabulary.single_axes.axis_commands import AxisTraits
from nctakt.nc.vocabulary.variables.cells import cells_of, leaf_cells
from nctakt.nc.vocabulary.variables.realtime_variables import (
    AXIS_VARIABLES,
    CHANNEL_VARIABLES,
    SPINDLE_VALUES,
    Access,
    RealtimeVariable,
)

#: Families declared by the variables list, with rights for each variable.
DECLARED = ("E", "CH")

#: Rights of programs and cycles to a V.E variable (RC-303).
RIGHTS = {
    AccessRights.READ_WRITE: Access.BOTH,
    AccessRights.READ_ONLY: Access.READ,
    AccessRights.WRITE_ONLY: Access.WRITE,
}


@dataclass(frozen=True, slots=True)
class Dimension:
    """One index of an array access: ``count`` elements, ``stride`` cells apart."""

    count: int
    stride: int


@dataclass(frozen=True, slots=True)
class Location:
    """A variable without its index values.

    ``cell``: its first cell with all indices 0; a character string takes as many cells as its
    ``size_bytes`` need. ``dimensions``: one entry for each index in the order of the text.
    ``is_length``: the value is mm of a linear axis, converted in inch programs.
    """

    name: str
    family: str
    type: str
    cell: int
    dimensions: tuple[Dimension, ...]
    synchronous: bool
    decoder: Access
    cycle: Access
    is_length: bool = False
    size_bytes: int = 0

    @property
    def is_numeric(self) -> bool:
        """Whether it is a number, not a character string."""
        return self.type not in ("STRING", "VSTRING")


@dataclass(frozen=True, slots=True)
class Aggregate:
    """A structure or a whole array, without its index values.

    ``node``: its declaration, without ``array_elements`` where its own index is given. ``cell`` and
    ``dimensions`` as in ``Location``.
    """

    name: str
    node: Node
    cell: int
    dimensions: tuple[Dimension, ...]


class Problem(enum.Enum):
    """The reason why a path names no value."""

    UNKNOWN = "unknown"
    STRUCTURE = "structure"
    INDICES = "indices"


@dataclass(frozen=True, slots=True)
class NotFound:
    """A path that names no value: the reason, the known part of the path, the nearest known
    name.
    """

    reason: Problem
    name: str
    nearest: str = ""
    expected_indices: int = 0


@dataclass(frozen=True, slots=True)
class ChannelNames:
    """The names of one channel: its axes with their numbers in the machine, and its variables.

    ``linear``, ``modulo``, ``single``: numbers of axes whose positions are lengths, of modulo axes,
    of axes that may move independently (P-AXIS-00457). Programs know ``spindles`` by
    ``spindle_names``. ``ranges``: number of an axis -> its software limits or modulo range.
    ``logical``: logical numbers of axes that the channel can fetch -> numbers in the machine.
    ``ignored``: variables of its list that have no possible type.
    """

    axes: tuple[tuple[str, int], ...]
    linear: frozenset[int]
    external: tuple[Variable, ...]
    channel: tuple[Variable, ...]
    spindles: tuple[str, ...] = ()
    modulo: frozenset[int] = frozenset()
    single: frozenset[int] = frozenset()
    ranges: Mapping[int, tuple[float, float]] = field(default_factory=dict)
    logical: Mapping[int, int] = field(default_factory=dict)
    spindle_names: tuple[str, ...] = ()
    ignored: tuple[IgnoredVariable, ...] = ()


def _row_cells(rows: Sequence[RealtimeVariable]) -> int:
    return sum(max(1, row.count) for row in rows)


class Layout:
    """The cells of all variables in the machine's memory; ``size`` in cells.

    Channels first, then axes, then ``panel_cells`` of the HLI for each channel, then spindles, then
    the variables of the lists. ``external``: the first cell of each V.E variable by channel,
    counted from 1 (0 for GLOBAL), and name.
    """

    def __init__(
        self, channels: Sequence[ChannelNames], axis_count: int, panel_cells: int = 0
    ) -> None:
        self.channel_cells = _row_cells(CHANNEL_VARIABLES)
        self.axis_cells = _row_cells(AXIS_VARIABLES)
        self.first_axis = self.channel_cells * len(channels)
        self.panel_cells = panel_cells
        self.first_panel = self.first_axis + self.axis_cells * axis_count
        self.spindles = [channel.spindles for channel in channels]
        self.first_spindle = self.first_panel + panel_cells * len(channels)
        self.size = self.first_spindle + len(SPINDLE_VALUES) * sum(map(len, self.spindles))
        self._names: list[tuple[int, str]] = []
        self._global: dict[str, tuple[Variable, int]] = {}
        self.external: dict[tuple[int, str], int] = {}
        self.tables = [NameTable(self, i, channel) for i, channel in enumerate(channels)]

    def channel_cell(self, channel: int) -> int:
        """Return the first cell of a channel."""
        return self.channel_cells * channel

    def axis_cell(self, axis: int) -> int:
        """Return the first cell of an axis."""
        return self.first_axis + self.axis_cells * axis

    def panel_cell(self, channel: int) -> int:
        """Return the first cell of a channel's operator panel."""
        return self.first_panel + self.panel_cells * channel

    def spindle_cell(self, channel: int) -> int:
        """Return the first cell of a channel's spindles."""
        before = sum(len(names) for names in self.spindles[:channel])
        return self.first_spindle + len(SPINDLE_VALUES) * before

    def channel_value(self, channel: int, path: str) -> int:
        """Return the cell of a channel's value such as ``PATH.SPEED``."""
        return self.channel_cell(channel) + _offsets(CHANNEL_VARIABLES)[path][1]

    def axis_value(self, axis: int, path: str) -> int:
        """Return the cell of an axis' value such as ``ACS.ACT_POS``."""
        return self.axis_cell(axis) + _offsets(AXIS_VARIABLES)[path][1]

    def allocate(self, variable: Variable) -> int:
        """Allocate a variable and return its first cell; GLOBAL ones exist once for all
        channels.
        """
        if variable.scope is VariableScope.GLOBAL:
            existing = self._global.get(variable.name)
            if existing is not None and existing[0].node == variable.node:
                return existing[1]
        cell = self.size
        self.size += cells_of(variable.node)
        if variable.scope is VariableScope.GLOBAL:
            self._global[variable.name] = (variable, cell)
        return cell


class NameTable:
    """The variables that the programs of one channel know."""

    def __init__(self, layout: Layout, index: int, channel: ChannelNames) -> None:
        self._layout, self._index, self._channel = layout, index, channel
        self._is_shared = True
        self._axes = dict(channel.axes)
        #: Names of axes that a program fetches, with their logical numbers if these are known.
        self.fetched: dict[str, int | None] = {}
        self._linear = channel.linear
        self.spindles = channel.spindles
        self.spindle_names = channel.spindle_names or channel.spindles
        self._axis_traits = {name: self._traits(number) for name, number in channel.axes}
        self._variables: dict[str, dict[str, tuple[Node, int]]] = {"E": {}, "CH": {}}
        for variable in channel.external:
            cell = layout.allocate(variable)
            owner = 0 if variable.scope is VariableScope.GLOBAL else index + 1
            layout.external[(owner, variable.name)] = cell
            self._variables["E"][variable.name] = (variable.node, cell)
        for variable in channel.channel:
            self._variables["CH"][variable.name] = (variable.node, layout.allocate(variable))
        #: Variables of the list that are ignored, by the names that programs would use.
        self.ignored = {f"{one.space.value}.{one.name}": one for one in channel.ignored}
        self._locations: dict[tuple[object, ...], Location | NotFound] = {}
        self._rtg = _offsets(CHANNEL_VARIABLES)
        self._rta = _offsets(AXIS_VARIABLES)

    def _traits(self, number: int) -> AxisTraits:
        channel = self._channel
        return AxisTraits(
            number,
            number in channel.linear,
            number in channel.modulo,
            number in channel.single,
            *channel.ranges.get(number, (-inf, inf)),
        )

    def own_table(self) -> NameTable:
        """Return a table that may learn names of axes: a copy if others use it, too."""
        if not self._is_shared:
            return self
        table = copy.copy(self)
        table._is_shared = False
        table.fetched = {}
        return table

    def own_copy(self) -> NameTable:
        """Return a copy with the same names, which may learn others."""
        table = copy.copy(self)
        table.fetched = dict(self.fetched)
        return table

    def learn_axis(self, name: str, number: int | None) -> None:
        """Bind a name to the axis with a logical number, ``None`` for one not known yet.

        Names that the table already has are unchanged.
        """
        if name in self._axes or (name in self.fetched and number is None):
            return
        self.fetched[name] = number
        if number is not None and number in self._channel.logical:
            self.place_axis(name, self._channel.logical[number])

    def can_fetch(self, number: int) -> bool:
        """Return whether the channel can have the axis with a logical number."""
        return number in self._channel.logical

    def place_axis(self, name: str, number: int) -> None:
        """Bind a name to an axis of the machine from here on."""
        if self._axes.get(name) != number:
            self._axes = {**self._axes, name: number}
            self._axis_traits = {**self._axis_traits, name: self._traits(number)}
            self._locations = {}

    def axis(self, name: str) -> AxisTraits | None:
        """Return the traits of an axis of the channel; ``None`` for any other name."""
        return self._axis_traits.get(name)

    def resolve(self, family: str, parts: Sequence[tuple[str, int]]) -> Location | NotFound:
        """Return the location of ``V.<family>.<parts>``; a part is a name and its number of
        indices.
        """
        key = (family, *parts)
        if key not in self._locations:
            self._locations[key] = self._resolve(family, parts)
        return self._locations[key]

    def _resolve(self, family: str, parts: Sequence[tuple[str, int]]) -> Location | NotFound:
        if family in self._variables:
            return self._resolve_external(family, parts)
        if family == "RTG":
            return self._resolve_channel(parts)
        if family == "RTA":
            return self._resolve_axis(parts)
        return NotFound(Problem.UNKNOWN, f"V.{family}")

    def resolve_aggregate(
        self, family: str, parts: Sequence[tuple[str, int]]
    ) -> Aggregate | NotFound:
        """Return the structure or whole array of V.E or V.CH that the path names."""
        if family not in self._variables:
            return NotFound(Problem.UNKNOWN, f"V.{family}")
        location = self.resolve(family, parts)
        if isinstance(location, Location):
            return NotFound(Problem.STRUCTURE, location.name)
        aggregate = self._walk(family, parts)
        assert (
            isinstance(aggregate, NotFound)
            or aggregate.node.members
            or aggregate.node.array_elements
        )
        return aggregate

    def _resolve_external(
        self, family: str, parts: Sequence[tuple[str, int]]
    ) -> Location | NotFound:
        aggregate = self._walk(family, parts)
        if isinstance(aggregate, NotFound):
            return aggregate
        node, text = aggregate.node, aggregate.name
        if node.array_elements:
            return NotFound(Problem.INDICES, text, expected_indices=1)
        if node.members:
            first = f"{text}.{node.members[0].name}"
            return NotFound(Problem.STRUCTURE, text, first)
        access = RIGHTS[node.rights]
        return Location(
            text,
            family,
            node.type,
            aggregate.cell,
            aggregate.dimensions,
            node.synchronous,
            access,
            access,
            size_bytes=0 if SCALARS[node.type].is_numeric else node.size_bytes,
        )

    def _walk(self, family: str, parts: Sequence[tuple[str, int]]) -> Aggregate | NotFound:
        """Follow a path; only its last part may lack an index."""
        variables = self._variables[family]
        text = f"V.{family}"
        if not parts or parts[0][0] not in variables:
            name = parts[0][0] if parts else ""
            return NotFound(
                Problem.UNKNOWN, f"{text}.{name}", _nearest(f"{text}.{name}", text, variables)
            )
        node, cell = variables[parts[0][0]]
        dimensions: list[Dimension] = []
        for position, (name, indices) in enumerate(parts):
            if position:
                members = {member.name: member for member in node.members}
                if name not in members:
                    full = f"{text}.{name}"
                    return NotFound(Problem.UNKNOWN, full, _nearest(full, text, members))
                for member in node.members:
                    if member.name == name:
                        break
                    cell += cells_of(member)
                node = members[name]
            text += f".{name}"
            expected = 1 if node.array_elements else 0
            if expected and not indices and position == len(parts) - 1:
                break
            if indices != expected:
                return NotFound(Problem.INDICES, text, expected_indices=expected)
            if expected:
                stride = cells_of(node) // node.array_elements
                dimensions.append(Dimension(node.array_elements, stride))
                node = replace(node, array_elements=0)
                text += "[]"
        return Aggregate(text, node, cell, tuple(dimensions))

    def _resolve_channel(self, parts: Sequence[tuple[str, int]]) -> Location | NotFound:
        path = ".".join(name for name, _ in parts)
        first = self._layout.channel_cell(self._index)
        return _resolve_row("RTG", path, "", parts, self._rtg, first, False)

    def _resolve_axis(self, parts: Sequence[tuple[str, int]]) -> Location | NotFound:
        axis = parts[-1][0] if parts else ""
        path = ".".join(name for name, _ in parts[:-1])
        if axis not in self._axes:
            full = f"V.RTA.{path}.{axis}" if path else f"V.RTA.{axis}"
            return NotFound(Problem.UNKNOWN, full, _nearest(axis, "", self._axes))
        number = self._axes[axis]
        first = self._layout.axis_cell(number)
        return _resolve_row("RTA", path, axis, parts, self._rta, first, number in self._linear)

    def resolve_text(self, text: str) -> tuple[Location, int] | NotFound:
        """Return location and cell of a variable with its index values, as in ``V.E.LIST[3]``."""
        match = _PATH.fullmatch(text.strip())
        if match is None:
            return NotFound(Problem.UNKNOWN, text.strip())
        parts: list[tuple[str, int]] = []
        values: list[int] = []
        for name, indices in _PART.findall(match["parts"]):
            numbers = [int(number) for number in re.findall(r"\d+", indices)]
            parts.append((name, len(numbers)))
            values += numbers
        location = self.resolve(match["family"].upper(), parts)
        if isinstance(location, NotFound):
            return location
        cell = location.cell
        for value, dimension in zip(values, location.dimensions, strict=True):
            if value >= dimension.count:
                return NotFound(Problem.INDICES, location.name, expected_indices=dimension.count)
            cell += value * dimension.stride
        return location, cell

    def signals(self) -> Iterator[tuple[str, int, RealtimeVariable]]:
        """Yield the trace signals of the channel and its axes: name, cell, row of the table."""
        for axis, number in self._axes.items():
            for row, offset in self._rta.values():
                yield f"{axis}.{row.path}", self._layout.axis_cell(number) + offset, row
        cell = self._layout.spindle_cell(self._index)
        for spindle in self._layout.spindles[self._index]:
            for row in SPINDLE_VALUES:
                yield f"{spindle}.{row.path}", cell, row
                cell += 1
        first = self._layout.channel_cell(self._index)
        for row, offset in self._rtg.values():
            if row.count == 0:
                yield row.path, first + offset, row
            for index in range(row.count):
                yield f"V.RTG.{row.path}[{index}]", first + offset + index, row

    def realtime(self) -> Iterator[tuple[str, int]]:
        """Yield name and cell of every V.RTG and V.RTA value that programs may use."""
        for axis, number in self._axes.items():
            for row, offset in self._rta.values():
                if row.decoder or row.cycle:
                    yield f"V.RTA.{row.path}.{axis}", self._layout.axis_cell(number) + offset
        for row, offset in self._rtg.values():
            if row.decoder or row.cycle:
                for index in range(max(1, row.count)):
                    element = f"[{index}]" if row.count else ""
                    cell = self._layout.channel_cell(self._index) + offset + index
                    yield f"V.RTG.{row.path}{element}", cell

    def values(self) -> Iterator[tuple[str, int, str]]:
        """Yield name, first cell and type of every number and string of V.E and V.CH."""
        for family, variables in self._variables.items():
            for name, (node, cell) in variables.items():
                for path, leaf, first in leaf_cells(node, f"V.{family}.{name}", cell):
                    yield path, first, leaf.type


def _resolve_row(
    family: str,
    path: str,
    axis: str,
    parts: Sequence[tuple[str, int]],
    rows: dict[str, tuple[RealtimeVariable, int]],
    first: int,
    linear: bool,
) -> Location | NotFound:
    """Return the location of a row of one of the access tables, or why there is none."""
    name = f"V.{family}.{path}" + (f".{axis}" if axis else "")
    names = {key: row for key, (row, _) in rows.items() if row.decoder or row.cycle}
    if path not in names:
        near = _nearest(path, "", names)
        full = f"V.{family}.{near}" + (f".{axis}" if axis else "") if near else ""
        return NotFound(Problem.UNKNOWN, name, full)
    row, offset = rows[path]
    indices = sum(count for _, count in parts)
    expected = 1 if row.count else 0
    if indices != expected or (expected and parts[-1][1] != 1):
        return NotFound(Problem.INDICES, name, expected_indices=expected)
    dimensions = (Dimension(row.count, 1),) if row.count else ()
    return Location(
        name + ("[]" if row.count else ""),
        family,
        row.type,
        first + offset,
        dimensions,
        True,
        row.decoder,
        row.cycle,
        linear and row.unit == "mm",
    )


def _offsets(rows: Sequence[RealtimeVariable]) -> dict[str, tuple[RealtimeVariable, int]]:
    offset = 0
    table: dict[str, tuple[RealtimeVariable, int]] = {}
    for row in rows:
        table[row.path] = (row, offset)
        offset += max(1, row.count)
    return table


def _nearest(name: str, prefix: str, names: Iterable[str]) -> str:
    return nearest(name, [f"{prefix}.{other}" if prefix else other for other in names])


_PART = re.compile(r"([A-Za-z_][A-Za-z0-9_]*)((?:\[\s*\d+\s*\])*)")
_PATH = re.compile(
    rf"[Vv][Ss]?\.(?P<family>[A-Za-z]+)\.(?P<parts>{_PART.pattern}(?:\.{_PART.pattern})*)"
)
