# SPDX-License-Identifier: MIT
"""The layout of a declared variable in the cells of the memory.

In: the declaration of a variable. Out: the number of its cells and the first cell of each number
and string in it. Elements of arrays are stored in ascending order, members in the order of
declaration. A number takes one cell, whatever its type; a character string takes as many cells as
its bytes need.
"""

from __future__ import annotations

from collections.abc import Iterator

from nctakt.lists.machine.external.variables import Node

#: Bytes of a cell.
CELL_BYTES = 8


def cells_of(node: Node) -> int:
    """Return the number of cells of a variable with all its elements and members."""
    if node.members:
        own = sum(cells_of(member) for member in node.members)
    else:
        own = -(-node.size_bytes // CELL_BYTES)
    return own * max(1, node.array_elements)


def leaf_cells(node: Node, path: str, cell: int) -> Iterator[tuple[str, Node, int]]:
    """Yield path, declaration and first cell of each number and string of a variable at
    ``cell``.
    """
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
    """Return whether two aggregates can be assigned to each other (RC-310); type names do not
    count.

    Structures are compared member by member, since two lists may use one name for different types.
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
