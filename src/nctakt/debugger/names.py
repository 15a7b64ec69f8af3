# SPDX-License-Identifier: MIT
"""Names such as ``V.E.LIST[3].POS`` as a tree, so that a client can unfold them.

In: names with dots and indices. Out: nodes with children, in the order of the names.
"""

from __future__ import annotations

import re
from collections.abc import Iterable

from nctakt.base.dataclass import dataclass, field

_PIECES = re.compile(r"\[[^\]]*\]|[^.\[]+")


@dataclass(slots=True)
class Node:
    """A part of names; ``full``: the whole name where one ends here."""

    piece: str
    full: str = ""
    children: dict[str, Node] = field(default_factory=dict)

    @property
    def is_array(self) -> bool:
        """Whether its children are elements."""
        return next(iter(self.children), "").startswith("[")

    def find(self, path: Iterable[str]) -> Node | None:
        """Return the node at a path below this one, ``None`` where there is none."""
        node: Node | None = self
        for piece in path:
            node = None if node is None else node.children.get(piece)
        return node


def pieces_of(name: str) -> tuple[str, ...]:
    """Return the parts of a name: ``V.E.LIST[3]`` is ``V``, ``E``, ``LIST``, ``[3]``."""
    return tuple(_PIECES.findall(name))


def tree_of(names: Iterable[str]) -> Node:
    """Return the tree of names."""
    root = Node("")
    for name in names:
        node = root
        for piece in pieces_of(name):
            node = node.children.setdefault(piece, Node(piece))
        node.full = name
    return root
