# SPDX-License-Identifier: MIT
"""The layout of V.E variables in the packed memory that a PLC sees, in bytes, and its checks.

In: variables in the order of their list, the alignment of P-STUP-00145. Out: the offset of each
number, string and array of them. The layout is that of a C structure under ``#pragma pack(n)``: the
offset of a member is a multiple of its size or of n, whichever is less, the size of a structure is
a multiple of its strictest member. Variables follow one another in the same way, unless the list
has an offset (P-EXTV-00002); the next one follows it. 0, automatic, is 8. A variable that shares
bytes with an earlier one of any channel or lies outside the memory is reported and left out, as the
controller does.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from nctakt.base.dataclass import dataclass
from nctakt.lists.declared.startup import StartupConfiguration
from nctakt.lists.declared.variables import SCALARS
from nctakt.lists.format.values import Values
from nctakt.lists.machine.external.variables import (
    Node,
    Variable,
    VariablesConfiguration,
    VariableScope,
)
from nctakt.messages import Collector
from nctakt.messages.machines.variables import (
    EXTERNAL_VARIABLES_TOO_LARGE,
    VARIABLE_OUTSIDE_MEMORY,
    VARIABLES_OVERLAP,
)

#: The alignment that the controller chooses: that of TwinCAT 3.
AUTOMATIC_ALIGNMENT = 8


@dataclass(frozen=True, slots=True)
class Field:
    """A number or string, or an array of them, in one packed memory.

    ``path``: as in a program after ``V.E.``, without the index of an array of ``count`` elements.
    ``offset`` in bytes from the start of the memory. ``count``: 0 for a single value.
    ``size_bytes``: of one element.
    """

    path: str
    offset: int
    type: str
    count: int
    size_bytes: int


@dataclass(frozen=True, slots=True)
class Placed:
    """A variable with its offset and its size in bytes."""

    variable: Variable
    offset: int
    size_bytes: int

    @property
    def end(self) -> int:
        """The offset of the byte after it."""
        return self.offset + self.size_bytes


def pack_of(alignment: int) -> int:
    """Return the n of ``#pragma pack(n)`` for a value of P-STUP-00145."""
    return alignment or AUTOMATIC_ALIGNMENT


def alignment_of(node: Node, pack: int) -> int:
    """Return the alignment of a variable in bytes."""
    if node.members:
        return max(alignment_of(member, pack) for member in node.members)
    return min(node.size_bytes, pack) if SCALARS[node.type].is_numeric else 1


def size_of(node: Node, pack: int) -> int:
    """Return the size of a variable in bytes, with all elements of an array."""
    return element_size(node, pack) * max(1, node.array_elements)


def element_size(node: Node, pack: int) -> int:
    """Return the size of one element of a variable in bytes."""
    if not node.members:
        return node.size_bytes
    end = 0
    for member, offset in members(node, pack):
        end = offset + size_of(member, pack)
    return _aligned(end, alignment_of(node, pack))


def members(node: Node, pack: int) -> Iterator[tuple[Node, int]]:
    """Yield the members of a structure with their offsets in it."""
    end = 0
    for member in node.members:
        offset = _aligned(end, alignment_of(member, pack))
        yield member, offset
        end = offset + size_of(member, pack)


def _aligned(offset: int, alignment: int) -> int:
    return -(-offset // alignment) * alignment


def place_variables(variables: Sequence[Variable], pack: int) -> tuple[Placed, ...]:
    """Return the variables of one memory with their offsets."""
    placed: list[Placed] = []
    end = 0
    for variable in variables:
        offset = variable.byte_offset
        if offset < 0:
            offset = _aligned(end, alignment_of(variable.node, pack))
        placed.append(Placed(variable, offset, size_of(variable.node, pack)))
        end = placed[-1].end
    return tuple(placed)


def overlaps(placed: Sequence[Placed]) -> Iterator[tuple[Placed, Placed]]:
    """Yield each variable that begins within another one, after that one.

    Without the second of each pair nothing overlaps.
    """
    furthest: Placed | None = None
    for item in sorted(placed, key=lambda each: each.offset):
        if furthest is not None and item.offset < furthest.end:
            yield furthest, item
        else:
            furthest = item


def size_bytes(placed: Sequence[Placed]) -> int:
    """Return the size of a memory in bytes, up to the end of its last variable."""
    return max((item.end for item in placed), default=0)


def fields(placed: Placed, pack: int) -> Iterator[Field]:
    """Yield the fields of a variable, in the order of its leaves."""
    node = placed.variable.node
    yield from _fields(node, node.name, placed.offset, pack)


def _fields(node: Node, path: str, offset: int, pack: int) -> Iterator[Field]:
    if not node.members:
        yield Field(path, offset, node.type, node.array_elements, node.size_bytes)
        return
    size = element_size(node, pack)
    for index in range(max(1, node.array_elements)):
        element = f"{path}[{index}]" if node.array_elements else path
        for member, member_offset in members(node, pack):
            yield from _fields(
                member, f"{element}.{member.name}", offset + index * size + member_offset, pack
            )


def possible_variables(
    startup: StartupConfiguration,
    lists: Sequence[VariablesConfiguration],
    collector: Collector,
) -> tuple[VariablesConfiguration, ...]:
    """Leave out variables that overlap (P-EXTV-00011) or are outside the memory (P-STUP-00037)."""
    pack = pack_of(startup.member_alignment)
    available = startup.external_variables_bytes
    return tuple(_possible(variables, pack, available, collector) for variables in lists)


def _possible(
    variables: VariablesConfiguration, pack: int, available: int, collector: Collector
) -> VariablesConfiguration:
    dropped: set[str] = set()
    for scope in VariableScope:
        placed = place_variables([one for one in variables.external if one.scope is scope], pack)
        inside = []
        for one in placed:
            if available and one.variable.byte_offset >= 0 and one.end > available:
                dropped.add(one.variable.name)
                collector.report(
                    VARIABLE_OUTSIDE_MEMORY,
                    None,
                    name=one.variable.name,
                    scope=scope.value,
                    end=one.end,
                    available=available,
                )
            else:
                inside.append(one)
        for one, other in overlaps(inside) if variables.checks_overlapping else ():
            name, earlier = other.variable.name, one.variable.name
            dropped.add(name)
            collector.report(VARIABLES_OVERLAP, None, name=name, other=earlier, offset=other.offset)
    kept = tuple(one for one in variables.external if one.name not in dropped)
    return replace(variables, external=kept) if dropped else variables


def check_memory(
    startup: StartupConfiguration,
    lists: Sequence[VariablesConfiguration],
    values: Values,
    collector: Collector,
) -> None:
    """Report channels with too many variables; ``values``: those of the start-up list."""
    pack = pack_of(startup.member_alignment)
    available = startup.external_variables_bytes
    for channel, variables in enumerate(lists if available else (), start=1):
        needed = sum(size_of(variable.node, pack) for variable in variables.external)
        if needed > available:
            numbers = {"channel": channel, "needed": needed, "available": available}
            values.report(collector, EXTERNAL_VARIABLES_TOO_LARGE, ("ext_var_max",), **numbers)
