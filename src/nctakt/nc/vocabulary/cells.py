# SPDX-License-Identifier: MIT
"""How a declared variable lies in the cells of the memory.

In: the tree of a variable. Out: how many cells it takes and where each number and string in it
begins. Elements of arrays stand in ascending order, members as they are declared. A number is one
cell, whatever its type; the bytes of a character string fill as many cells as they need.
"""

from __future__ import annotations

from collections.abc import Iterator

from nctakt.lists.machine.variables import Node

#: Bytes of a cell.
CELL_BYTES = 8


def cells_of(node: Node) -> int:
    """Cells that a variable takes, all its elements and members; eight characters fill a cell."""
    if node.members:
        own = sum(cells_of(member) for member in node.members)
    else:
        own = -(-node.size_bytes // CELL_BYTES)
    return own * max(1, node.array_elements)


def leaf_cells(node: Node, path: str, cell: int) -> Iterator[tuple[str, Node, int]]:
    """The numbers and strings of a variable at ``cell``: path, declaration, first cell of each."""
    count = node.array_elements
    stride = cells_of(node) // max(1, count)
    for index in range(max(1, count)):
        element = f"{path}[{index}]" if count else path
        first = cell + index * stride
        if not node.members:
            yield element, node, first
        for member in node.members:
            yield from leaf_cells(member, f"{element}.{member.name}", first)
            first += cells_of(member)


def same_type(node: Node, other: Node) -> bool:
    """Whether two variables can be assigned to each other as wholes (RC-310); names do not count.

    Structures are compared member by member: two lists may use one name for different ones.
    """
    if (node.type, node.array_elements, node.size_bytes) != (
        other.type,
        other.array_elements,
        other.size_bytes,
    ):
        return False
    if [member.name for member in node.members] != [member.name for member in other.members]:
        return False
    return all(map(same_type, node.members, other.members))
