# SPDX-License-Identifier: MIT
"""Construction of nodes field by field; compiled modules use the C functions in ``raw_nodes.pxd``.

Fields of a frozen dataclass with slots can be set only by its slow constructor or by the
descriptors of the slots.
"""

from __future__ import annotations

from typing import Any


def new_node(cls: type[Any], size: int) -> Any:
    """Return an object of this class with empty slots; ``size`` is 0."""
    assert size == 0
    return object.__new__(cls)


def set_field(slot: Any, node: Any, value: Any) -> None:
    """Set a field of a node by its slot, ``Span.line``."""
    slot.__set__(node, value)
