# SPDX-License-Identifier: MIT
"""Where V.E variables stand in the packed memory that a PLC sees, byte by byte.

In: variables in the order of their list, the alignment of P-STUP-00145. Out: the place of each
number, string and array of them. The layout is that of a C structure under ``#pragma pack(n)``:
a member stands at a multiple of its own size or of n, whichever is less, a structure is as long as
a multiple of its strictest member. Variables follow one another in the same way, unless the list
gives a place (P-EXTV-00002), which is taken as it is; the next one follows it. 0, automatic, is 8.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from nctakt.base.dataclass import dataclass
from nctakt.lists.declared.variables import SCALARS
from nctakt.lists.machine.variables import Node, Variable

#: Where the list leaves the alignment to the controller: that of TwinCAT 3.
AUTOMATIC_ALIGNMENT = 8


@dataclass(frozen=True, slots=True)
class Field:
    """A number or string, or an array of them, in one packed memory.

    ``path``: as in a program behind ``V.E.``, without the index of an array of ``count`` elements.
    ``offset`` in bytes from the start of the memory. ``count``: 0 for what is no array.
    ``size_bytes``: of one element.
    """

    path: str
    offset: int
    type: str
    count: int
    size_bytes: int


@dataclass(frozen=True, slots=True)
class Placed:
    """A variable with its first byte and its bytes."""

    variable: Variable
    offset: int
    size_bytes: int

    @property
    def end(self) -> int:
        """The byte behind it."""
        return self.offset + self.size_bytes


def pack_of(alignment: int) -> int:
    """Return the n of ``#pragma pack(n)`` for a value of P-STUP-00145."""
    return alignment or AUTOMATIC_ALIGNMENT


def alignment_of(node: Node, pack: int) -> int:
    """Return the number of bytes of which a variable's place is a multiple."""
    if node.members:
        return max(alignment_of(member, pack) for member in node.members)
    return min(node.size_bytes, pack) if SCALARS[node.type].is_numeric else 1


def size_of(node: Node, pack: int) -> int:
    """Return the number of bytes of a variable, all elements of an array."""
    return _element_size(node, pack) * max(1, node.array_elements)


def _element_size(node: Node, pack: int) -> int:
    if not node.members:
        return node.size_bytes
    end = 0
    for member, offset in _members(node, pack):
        end = offset + size_of(member, pack)
    return _aligned(end, alignment_of(node, pack))


def _members(node: Node, pack: int) -> Iterator[tuple[Node, int]]:
    """Yield the members of a structure with their places in it."""
    end = 0
    for member in node.members:
        offset = _aligned(end, alignment_of(member, pack))
        yield member, offset
        end = offset + size_of(member, pack)


def _aligned(offset: int, alignment: int) -> int:
    return -(-offset // alignment) * alignment


def place_variables(variables: Sequence[Variable], pack: int) -> tuple[Placed, ...]:
    """Return the places of variables of one memory."""
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
    """Variables that share bytes: each that begins within another one, with that one."""
    furthest: Placed | None = None
    for one in sorted(placed, key=lambda each: each.offset):
        if furthest is not None and one.offset < furthest.end:
            yield furthest, one
        if furthest is None or one.end > furthest.end:
            furthest = one


def size_bytes(placed: Sequence[Placed]) -> int:
    """Bytes of a memory: up to the end of the variable that reaches furthest."""
    return max((one.end for one in placed), default=0)


def fields(placed: Placed, pack: int) -> Iterator[Field]:
    """What a variable consists of; the same order as that of its leaves."""
    node = placed.variable.node
    yield from _fields(node, node.name, placed.offset, pack)


def _fields(node: Node, path: str, offset: int, pack: int) -> Iterator[Field]:
    if not node.members:
        yield Field(path, offset, node.type, node.array_elements, node.size_bytes)
        return
    size = _element_size(node, pack)
    for index in range(max(1, node.array_elements)):
        element = f"{path}[{index}]" if node.array_elements else path
        for member, place_ in _members(node, pack):
            yield from _fields(
                member, f"{element}.{member.name}", offset + index * size + place_, pack
            )
