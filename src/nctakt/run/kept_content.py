# SPDX-License-Identifier: MIT
"""The contents of objects and containers at some moment, restored in place.

Compiled, since each run of a study does it. A run changes little of what it could change: if an
object still has the same attributes in the same order, they are only compared.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from typing import Any


class KeptContent:
    """Attributes of objects and content of containers; ``replaced``: attributes that may be any."""

    def __init__(self, replaced: frozenset[str]) -> None:
        self.replaced = replaced
        self.attributes: list[tuple[dict[str, Any], list[Any], dict[str, Any]]] = []
        self.slots: list[tuple[object, str, Any]] = []
        self.empty: list[tuple[object, str]] = []
        self.new: list[tuple[object, str, Callable[[Any], Any], Any]] = []
        self.lists: list[tuple[list[Any], list[Any]]] = []
        self.memories: list[tuple[memoryview, bytes]] = []
        self.dicts: list[tuple[dict[Any, Any], list[Any], dict[Any, Any]]] = []
        self.others: list[tuple[Any, Any]] = []

    def keep_attributes(self, attributes: dict[str, Any], kept: dict[str, Any]) -> None:
        """Keep these of the attributes that an object has as a dictionary."""
        self.attributes.append((attributes, _cells(kept), kept))

    def keep_slot(self, one: object, name: str, value: Any) -> None:
        """Keep an attribute that an object has elsewhere."""
        self.slots.append((one, name, value))

    def keep_empty(self, one: object, name: str) -> None:
        """Keep that an attribute has no value."""
        self.empty.append((one, name))

    def keep_new(self, one: object, name: str, container: Any) -> None:
        """Keep a container as an attribute that gets another container of the same content."""
        self.new.append((one, name, type(container), type(container)(container)))

    def keep_container(self, one: Any) -> None:
        """Keep the content of a container, or of memory."""
        if type(one) is list:
            self.lists.append((one, list(one)))
        elif type(one) is bytearray:
            self.memories.append((memoryview(one), bytes(one)))
        elif type(one) is dict:
            self.dicts.append((one, _cells(one), dict(one)))
        else:
            self.others.append((one, dict(one) if isinstance(one, dict) else list(one)))

    def put_back(self) -> None:
        """Restore everything."""
        for attributes, cells, kept in self.attributes:
            if not holds(attributes, cells):
                self.put_attributes_back(attributes, kept)
        for one, name, value in self.slots:
            setattr(one, name, value)
        for one, name in self.empty:
            if hasattr(one, name):
                delattr(one, name)
        for one, name, kind, content in self.new:
            setattr(one, name, kind(content))
        for items, kept_items in self.lists:
            if not holds_items(items, kept_items):
                items[:] = kept_items
        for memory, data in self.memories:
            memory[:] = data
        for container, cells, kept in self.dicts:
            if not holds(container, cells):
                container.clear()
                container.update(kept)
        for other, content in self.others:
            if other:
                other.clear()
            if content:
                (other.extend if isinstance(other, deque) else other.update)(content)

    def put_attributes_back(self, attributes: dict[str, Any], kept: dict[str, Any]) -> None:
        """Put the attributes of an object back; those that came later go, unless replaced."""
        if len(attributes) != len(kept):
            for name in attributes.keys() - kept.keys() - self.replaced:
                del attributes[name]
        attributes.update(kept)


def _cells(content: dict[Any, Any]) -> list[Any]:
    """Return keys and values in turn."""
    return [cell for pair in content.items() for cell in pair]


def holds(content: dict[Any, Any], cells: list[Any]) -> bool:
    """Return whether a dictionary has these keys and values, the same objects in this order."""
    if 2 * len(content) != len(cells):
        return False
    at = 0
    for key, value in content.items():
        if key is not cells[at] or value is not cells[at + 1]:
            return False
        at += 2
    return True


def holds_items(items: list[Any], kept_items: list[Any]) -> bool:
    """Return whether a list has these items, the same objects."""
    if len(items) != len(kept_items):
        return False
    for i in range(len(items)):
        if items[i] is not kept_items[i]:
            return False
    return True
