# SPDX-License-Identifier: MIT
"""The values of a variables list -> the variables, down to their single numbers.

In: checked values. Out: ``Variable`` trees. A structure's members inherit synchronisation and
access rights, unless their element of the structure has its own (P-EXTV-00018, 00019). An invalid
variable is reported and left out.
"""

from __future__ import annotations

import enum
import re
from collections.abc import Container, Iterator

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span, Text
from nctakt.base.misspelling import nearest
from nctakt.lists.declared.variables import INHERIT_ACCESS, MAX_NAME_LENGTH, NAME_LENGTH, SCALARS
from nctakt.lists.format.parameter import with_indices
from nctakt.lists.format.values import Values
from nctakt.messages import Collector
from nctakt.messages.machines.variables import (
    INVALID_VARIABLE_NAME,
    LONG_VARIABLE_NAME,
    RECURSIVE_STRUCTURE,
    UNKNOWN_VARIABLE_TYPE,
    VARIABLE_BEYOND_COUNT,
    VARIABLE_OFFSET_TOO_LARGE,
    VARIABLE_STRUCTURE_TOO_DEEP,
    VARIABLE_TOO_LARGE,
    VARIABLES_TOO_MANY,
)

#: Maximum number of numbers and strings in a variable.
MAX_LEAVES = 65_536
#: Maximum number of numbers and strings in all variables of a list.
MAX_LEAVES_OF_LIST = 1 << 20
#: Maximum depth of structures in structures.
MAX_NESTING = 32
#: Maximum offset of a variable in a list, in bytes.
MAX_OFFSET = 0xFFFFFF
#: Management data of each variable in V.CH memory, in bytes.
MANAGEMENT_BYTES = 64
_STRING_BYTES, _EXTENDED_STRING_BYTES, _VSTRING_BYTES = 24, 128, 128

_TYPE, _SIZE = Text("type", "ihres Typs"), Text("size", "ihrer Größe")

_NAME = re.compile(r"[A-Za-z_]\w*", re.A)


class VariableSpace(enum.Enum):
    """The space of a variable: its prefix in programs."""

    EXTERNAL = "V.E"
    CHANNEL = "V.CH"


class VariableScope(enum.Enum):
    """The scope of a variable (P-EXTV-00004): the whole controller or each channel."""

    GLOBAL = "GLOBAL"
    CHANNEL = "CHANNEL"


class AccessRights(enum.Enum):
    """The rights of NC programs and realtime cycles (P-EXTV-00006); the PLC has both."""

    READ_WRITE = "READ_WRITE"
    READ_ONLY = "READ_ONLY"
    WRITE_ONLY = "WRITE_ONLY"


@dataclass(frozen=True, slots=True)
class Node:
    """A variable or a member of one.

    ``type``: a key of ``SCALARS``, or the structure's name where ``members`` are given.
    ``array_elements`` 0: no array. ``size_bytes``: of one element; 0 for a structure.
    """

    name: str
    type: str
    array_elements: int
    synchronous: bool
    rights: AccessRights
    size_bytes: int
    members: tuple[Node, ...]


@dataclass(frozen=True, slots=True)
class Leaf:
    """A number or character string inside a variable.

    ``path``: as in a program after ``V.E.``: ``LEVEL_1_A[0].REAL64``. ``steps``: the same, in
    parts. ``type``: a key of ``SCALARS``.
    """

    path: str
    steps: tuple[str | int, ...]
    type: str
    synchronous: bool
    rights: AccessRights
    scope: VariableScope
    space: VariableSpace
    size_bytes: int

    @property
    def is_numeric(self) -> bool:
        """Whether it is a number (or truth value), not a character string."""
        return SCALARS[self.type].is_numeric


@dataclass(frozen=True, slots=True)
class Variable:
    """A variable as declared in its list; ``byte_offset`` -1: after the previous variable."""

    space: VariableSpace
    scope: VariableScope
    node: Node
    byte_offset: int = -1

    @property
    def name(self) -> str:
        """The name after the prefix."""
        return self.node.name

    def leaves(self) -> Iterator[Leaf]:
        """Yield all numbers and strings, arrays in ascending order, members as listed."""
        yield from self._leaves(self.node, self.node.name, (self.node.name,))

    def numeric_leaves(self) -> Iterator[Leaf]:
        """Yield all numbers."""
        return (leaf for leaf in self.leaves() if leaf.is_numeric)

    def _leaves(self, node: Node, path: str, steps: tuple[str | int, ...]) -> Iterator[Leaf]:
        if node.array_elements:
            for index in range(node.array_elements):
                yield from self._element(node, f"{path}[{index}]", (*steps, index))
        else:
            yield from self._element(node, path, steps)

    def _element(self, node: Node, path: str, steps: tuple[str | int, ...]) -> Iterator[Leaf]:
        if node.members:
            for member in node.members:
                yield from self._leaves(member, f"{path}.{member.name}", (*steps, member.name))
            return
        yield Leaf(
            path,
            steps,
            node.type,
            node.synchronous,
            node.rights,
            self.scope,
            self.space,
            node.size_bytes,
        )


@dataclass(frozen=True, slots=True)
class IgnoredVariable:
    """A variable whose type or size is impossible.

    ``declared``: where its name is. ``what`` and ``reason``: the impossible property, and where.
    """

    space: VariableSpace
    name: str
    declared: Span
    what: Text
    reason: Span


@dataclass(frozen=True, slots=True)
class VariablesConfiguration:
    """The variables of a list, in the order of their indices.

    ``checks_overlapping``: whether overlapping variables are left out (P-EXTV-00011).
    """

    external: tuple[Variable, ...]
    channel: tuple[Variable, ...]
    checks_overlapping: bool = False
    ignored: tuple[IgnoredVariable, ...] = ()


def variables_configuration(values: Values, collector: Collector) -> VariablesConfiguration:
    """Return the variables of a list."""
    builder = _Builder(values, collector)
    count = values.integer("number_used_variables")
    indices = values.indices("var[]")
    beyond = [index for index in indices if index >= count]
    if beyond:
        key = with_indices("var[]", (beyond[0],))
        values.report(
            collector, VARIABLE_BEYOND_COUNT, ("var[].name", beyond[0]), key=key, count=count
        )
    external = builder.variables(
        "var[]", VariableSpace.EXTERNAL, tuple(index for index in indices if index < count)
    )
    channel = builder.variables("vch[]", VariableSpace.CHANNEL, values.indices("vch[]"))
    checks_overlapping = values.flag("check_overlapping_variables")
    return VariablesConfiguration(external, channel, checks_overlapping, tuple(builder.ignored))


def channel_memory_bytes(variables: tuple[Variable, ...]) -> int:
    """Return the memory of V.CH variables of P-CHAN-00424: data and management, in bytes."""
    data = sum(leaf.size_bytes for variable in variables for leaf in variable.leaves())
    return data + MANAGEMENT_BYTES * len(variables)


@dataclass(frozen=True, slots=True)
class _Element:
    """An element of a structure and its indices in the list."""

    name: str
    indices: tuple[int, int]


class _Builder:
    """Builds the variables of one list; has its structures by name."""

    def __init__(self, values: Values, collector: Collector) -> None:
        self.values = values
        self.collector = collector
        self.structures: dict[str, tuple[_Element, ...]] = {}
        self.counts: dict[str, int] = {}
        self.ignored: list[IgnoredVariable] = []
        self._leaves = 0
        for index in values.indices("struct[]"):
            name = values.text("struct[].name", index)
            if not self._usable(name, self.structures, "struct[].name", index):
                continue
            elements = tuple(self._elements(index))
            if elements and name not in SCALARS:
                self.structures[name] = elements

    def _elements(self, structure: int) -> Iterator[_Element]:
        prefix = "struct[].element[]"
        names: list[str] = []
        for element in self.values.indices(prefix, structure):
            name = self.values.text(f"{prefix}.name", structure, element)
            if self._usable(name, names, f"{prefix}.name", structure, element):
                names.append(name)
                yield _Element(name, (structure, element))

    def variables(
        self, prefix: str, space: VariableSpace, indices: tuple[int, ...]
    ) -> tuple[Variable, ...]:
        """Return the variables at ``indices`` of ``prefix``; invalid ones are reported."""
        variables: dict[str, Variable] = {}
        for index in indices:
            name = self.values.text(f"{prefix}.name", index)
            if not self._usable(name, variables, f"{prefix}.name", index):
                continue
            misfit = self._misfit(f"{prefix}.type", f"{prefix}.array_elements", index)
            if misfit is not None:
                declared, _ = self.values.position(f"{prefix}.name", index)
                self.ignored.append(IgnoredVariable(space, name, declared, *misfit))
                continue
            variable = self._variable(prefix, space, name, index)
            if variable is not None:
                variables[name] = variable
        return tuple(variables.values())

    def _variable(
        self, prefix: str, space: VariableSpace, name: str, index: int
    ) -> Variable | None:
        """The variable, ``None`` where its place is outside any memory."""
        values = self.values
        synchronous = values.flag(f"{prefix}.synchronisation", index)
        external = space is VariableSpace.EXTERNAL
        rights = AccessRights.READ_WRITE
        scope = VariableScope.CHANNEL
        if external:
            rights = self._rights(f"{prefix}.access_rights", rights, index)
            scope = VariableScope(values.text(f"{prefix}.scope", index))
        node = self._node(prefix, (index,), name, synchronous, rights)
        offset = values.integer(f"{prefix}.byte_offset", index) if external else -1
        if offset > MAX_OFFSET:
            at = (f"{prefix}.byte_offset", index)
            key = with_indices(at[0], (index,))
            values.report(
                self.collector,
                VARIABLE_OFFSET_TOO_LARGE,
                at,
                key=key,
                value=offset,
                limit=MAX_OFFSET,
            )
            return None
        return Variable(space, scope, node, offset)

    def _node(
        self,
        prefix: str,
        indices: tuple[int, ...],
        name: str,
        synchronous: bool,
        rights: AccessRights,
    ) -> Node:
        values = self.values
        type_ = values.text(f"{prefix}.type", *indices)
        size = self._size(type_, values.integer(f"{prefix}.size", *indices))
        members: tuple[Node, ...] = ()
        if type_ in self.structures:
            members = tuple(self._members(type_, synchronous, rights))
        elements = values.integer(f"{prefix}.array_elements", *indices)
        return Node(name, type_, elements, synchronous, rights, size, members)

    def _members(self, type_: str, synchronous: bool, rights: AccessRights) -> Iterator[Node]:
        prefix = "struct[].element[]"
        values = self.values
        for element in self.structures[type_]:
            key = element.indices
            own_synchronous, own_rights = synchronous, rights
            if values.is_set(f"{prefix}.synchronisation", *key):
                own_synchronous = values.flag(f"{prefix}.synchronisation", *key)
            if values.is_set(f"{prefix}.access_rights", *key):
                own_rights = self._rights(f"{prefix}.access_rights", rights, *key)
            yield self._node(prefix, key, element.name, own_synchronous, own_rights)

    def _rights(self, pattern: str, outer: AccessRights, *indices: int) -> AccessRights:
        """Return the rights of an entry; ``outer`` are those that it may inherit."""
        name = self.values.text(pattern, *indices)
        return outer if name == INHERIT_ACCESS else AccessRights(name)

    def _size(self, type_: str, size: int) -> int:
        if type_ == "STRING":
            extended = self.values.flag("use_extended_string_var")
            return _EXTENDED_STRING_BYTES if extended else _STRING_BYTES
        if type_ == "VSTRING":
            return size or _VSTRING_BYTES
        return SCALARS[type_].size_bytes if type_ in SCALARS else 0

    def _usable(self, name: str, used: Container[str], pattern: str, *indices: int) -> bool:
        key = with_indices(pattern, indices)
        if _NAME.fullmatch(name) and len(name) <= MAX_NAME_LENGTH and name not in used:
            if len(name) > NAME_LENGTH:
                self.values.report(
                    self.collector,
                    LONG_VARIABLE_NAME,
                    (pattern, *indices),
                    key=key,
                    length=len(name),
                    limit=NAME_LENGTH,
                )
            return True
        self.values.report(
            self.collector,
            INVALID_VARIABLE_NAME,
            (pattern, *indices),
            key=key,
            value=name,
            limit=MAX_NAME_LENGTH,
        )
        return False

    def _misfit(
        self, type_pattern: str, array_pattern: str, index: int
    ) -> tuple[Text, Span] | None:
        """Return the impossible property of a variable, and where; ``None`` if there is none.

        Its type must exist and not be recursive, and it must not be too large.
        """
        type_ = self.values.text(type_pattern, index)
        elements = self._count(type_, (type_pattern, index), ())
        if elements is None:
            return _TYPE, self.values.position(type_pattern, index)[0]
        elements *= max(1, self.values.integer(array_pattern, index))
        message, limit = VARIABLE_TOO_LARGE, MAX_LEAVES
        if elements <= MAX_LEAVES:
            if self._leaves + elements <= MAX_LEAVES_OF_LIST:
                self._leaves += elements
                return None
            message, limit = VARIABLES_TOO_MANY, MAX_LEAVES_OF_LIST
        key = with_indices(array_pattern, (index,))
        self.values.report(self.collector, message, (array_pattern, index), key=key, limit=limit)
        return _SIZE, self.values.position(array_pattern, index)[0]

    def _count(
        self, type_: str, at: tuple[str, *tuple[int, ...]], outer: tuple[str, ...]
    ) -> int | None:
        """Return the number of leaves of an element of a type, ``None`` for an unknown type."""
        if type_ in SCALARS:
            return 1
        if type_ in self.counts:
            return self.counts[type_]
        if type_ in outer:
            self.values.report(self.collector, RECURSIVE_STRUCTURE, at, name=type_)
            return None
        if len(outer) > MAX_NESTING:
            self.values.report(
                self.collector, VARIABLE_STRUCTURE_TOO_DEEP, at, name=outer[0], limit=MAX_NESTING
            )
            return None
        if type_ not in self.structures:
            key = with_indices(at[0], tuple(at[1:]))
            near = nearest(type_, [*SCALARS, *self.structures])
            meant = (
                Text(f"Did you mean {near}? ", f"War {near} gemeint? ") if near else Text("", "")
            )
            self.values.report(
                self.collector,
                UNKNOWN_VARIABLE_TYPE,
                at,
                key=key,
                value=type_,
                names=", ".join(SCALARS),
                meant=meant,
            )
            return None
        total = 0
        prefix = "struct[].element[]"
        for element in self.structures[type_]:
            inner = self.values.text(f"{prefix}.type", *element.indices)
            count = self._count(inner, (f"{prefix}.type", *element.indices), (*outer, type_))
            if count is None:
                return None
            array = self.values.integer(f"{prefix}.array_elements", *element.indices)
            total += count * max(1, array)
        self.counts[type_] = total
        return total
