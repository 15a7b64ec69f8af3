# SPDX-License-Identifier: MIT
"""The arguments of a request, read with their types.

In: data from a client. Out: values; ``Failure`` (901224) for those of another type.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NoReturn

from nctakt.base.failure import Failure
from nctakt.messages import diagnostic
from nctakt.messages.connections.debugger import WRONG_ARGUMENT

#: Items of a list that are read at most.
MAX_ITEMS = 10_000


class Arguments:
    """The arguments of a request, or a part of them; ``path`` names it in messages."""

    def __init__(self, values: object, path: str = "") -> None:
        self._path = path
        if values is None:
            values = {}
        if not isinstance(values, Mapping):
            self._fail("", "an object")
        self._values: Mapping[str, Any] = values

    def _fail(self, name: str, expected: str) -> NoReturn:
        shown = f"{self._path}.{name}".strip(".") or "arguments"
        raise Failure(diagnostic(WRONG_ARGUMENT, name=shown, expected=expected))

    def names(self) -> list[str]:
        """Return the names of the given arguments."""
        return [name for name in self._values if self.has(name)]

    def value(self, name: str) -> object:
        """Return the value of an argument."""
        return self._values[name]

    def has(self, name: str) -> bool:
        """Return whether an argument is given, and is not null."""
        return self._values.get(name) is not None

    def text(self, name: str, default: str | None = None) -> str:
        """Return a text argument; it is required unless there is a default."""
        value = self._values.get(name)
        if value is None and default is not None:
            return default
        if not isinstance(value, str):
            self._fail(name, "a text")
        return value

    def optional_text(self, name: str) -> str | None:
        """Return a text, ``None`` where there is none."""
        return self.text(name) if self.has(name) else None

    def number(self, name: str, default: int | None = None) -> int:
        """Return a whole number."""
        value = self._values.get(name)
        if value is None and default is not None:
            return default
        if not isinstance(value, int) or isinstance(value, bool) or abs(value) >= 1 << 53:
            self._fail(name, "a whole number")
        return value

    def flag(self, name: str, default: bool = False) -> bool:
        """Return a truth value."""
        value = self._values.get(name)
        if value is None:
            return default
        if not isinstance(value, bool):
            self._fail(name, "true or false")
        return value

    def part(self, name: str) -> Arguments:
        """Return an object inside this one, empty if there is none."""
        return Arguments(self._values.get(name), f"{self._path}.{name}".strip("."))

    def parts(self, name: str) -> list[Arguments]:
        """Return a list of objects."""
        return [
            Arguments(item, f"{self._path}.{name}[{index}]".strip("."))
            for index, item in enumerate(self.items(name))
        ]

    def items(self, name: str) -> list[Any]:
        """Return a list of anything, empty where there is none."""
        value = self._values.get(name)
        if value is None:
            return []
        if not isinstance(value, list) or len(value) > MAX_ITEMS:
            self._fail(name, f"a list of at most {MAX_ITEMS} items")
        return value

    def texts(self, name: str) -> list[str]:
        """Return a text or a list of texts as a list."""
        value = self._values.get(name)
        items = [value] if isinstance(value, str) else self.items(name)
        if not all(isinstance(item, str) for item in items):
            self._fail(name, "a text or a list of texts")
        return items

    def entries(self, name: str) -> dict[str, Any]:
        """Return an object as names and values."""
        value = self._values.get(name)
        if value is None:
            return {}
        if not isinstance(value, Mapping):
            self._fail(name, "an object")
        return dict(value)
