# SPDX-License-Identifier: MIT
"""The share of a realtime cycle in the memory of P-CHAN-00407 (RC-504).

In: the checked tree of a cycle. Out: bytes, the sum of documented sizes; the sizes are nctakt's,
since no source gives the controller's. They depend on the program's text only, not on fused nodes.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator

from nctakt.nc import tree

#: Management of a cycle.
CYCLE_BYTES = 64
#: Each place for an open action, P-CHAN-00480 of them.
ACTION_PLACE_BYTES = 16
#: Each statement, and each branch of an ``$IF`` with its state.
STATEMENT_BYTES = 24
#: Each operator, function, variable, constant, and word that is an action.
NODE_BYTES = 8

_STATEMENTS = (tree.Statement, tree.ElseIf)
_NODES = (tree.Expression, tree.Word, tree.BracketCommand)


def memory_bytes(cycle: tree.RealtimeCycle, max_open_actions: int) -> int:
    """Return the bytes of one loaded cycle."""
    total = CYCLE_BYTES + max_open_actions * ACTION_PLACE_BYTES
    for statement in cycle.body:
        for node in _walk(statement):
            if isinstance(node, _STATEMENTS):
                total += STATEMENT_BYTES
            elif isinstance(node, _NODES):
                total += NODE_BYTES
    return total


def _walk(node: tree.Node) -> Iterator[tree.Node]:
    """Yield the node and all nodes below it."""
    yield node
    for field in dataclasses.fields(node):
        value = getattr(node, field.name)
        for item in value if isinstance(value, tuple) else (value,):
            if isinstance(item, tree.Node):
                yield from _walk(item)
