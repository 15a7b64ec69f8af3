# SPDX-License-Identifier: MIT
"""Nodes filled field by field, which is quick where it is compiled: C functions in
``raw_nodes.pxd``.

A frozen dataclass with slots lets nobody but its own, slow constructor set its fields; the
descriptors of its slots can.
"""

from __future__ import annotations

from typing import Any


def new_node(cls: type[Any], size: int) -> Any:
    """An object of this class with empty slots; ``size`` is 0."""
    assert size == 0
    return object.__new__(cls)


def set_field(slot: Any, node: Any, value: Any) -> None:
    """Fill a slot of a node, which its class gives: ``Span.line``."""
    slot.__set__(node, value)
