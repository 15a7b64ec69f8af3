# SPDX-License-Identifier: MIT
"""The checked values of one list.

In: what ``load_list`` (``list_check.py``) has checked. Out: ``Values``: the value of each parameter
that a list names, the default for all others, and where each entry stands.
"""

from __future__ import annotations

from collections.abc import Container, Mapping
from dataclasses import replace

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Message, Span, whole_file
from nctakt.lists.format.parameter import Parameter, Value, with_indices
from nctakt.lists.format.reader import Entry
from nctakt.lists.format.schema import Schema
from nctakt.messages import Collector

#: A parameter of a list: its pattern and its indices.
Key = tuple[str, tuple[int, ...]]


@dataclass(frozen=True, slots=True)
class EntryValue:
    """The value of an entry.

    ``reference``: the other parameter whose value it takes (``P-AXIS-00008.0``), as text.
    """

    value: Value
    entry: Entry
    reference: str = ""


@dataclass(frozen=True, slots=True)
class Values:
    """The values of one list, the defaults of its schema for all that it does not name.

    ``entry_values``: those of the parameters that nctakt uses; ``unused_values``: the others.
    """

    schema: Schema
    file: str
    entry_values: Mapping[Key, EntryValue] = field(default_factory=dict)
    unused_values: Mapping[Key, EntryValue] = field(default_factory=dict)

    def get(self, pattern: str, *indices: int) -> Value:
        """Return the effective value of ``pattern`` (``thread[].name``) at ``indices``."""
        item = self.entry_values.get((pattern, indices))
        return item.value if item is not None else self._parameter(pattern).default

    def integer(self, pattern: str, *indices: int) -> int:
        """As ``get``, of an integer parameter."""
        value = self.get(pattern, *indices)
        assert isinstance(value, int), pattern
        return int(value)

    def real(self, pattern: str, *indices: int) -> float:
        """As ``get``, of a number parameter."""
        value = self.get(pattern, *indices)
        assert isinstance(value, int | float), pattern
        return float(value)

    def flag(self, pattern: str, *indices: int) -> bool:
        """As ``get``, of a BOOLEAN parameter."""
        value = self.get(pattern, *indices)
        assert isinstance(value, bool), pattern
        return value

    def text(self, pattern: str, *indices: int) -> str:
        """As ``get``, of a STRING or NAME parameter."""
        value = self.get(pattern, *indices)
        assert isinstance(value, str), pattern
        return value

    def names(self, pattern: str, *indices: int) -> tuple[str, ...]:
        """As ``get``, of a FLAGS parameter."""
        value = self.get(pattern, *indices)
        assert isinstance(value, tuple), pattern
        return value

    def given(self, pattern: str, *indices: int) -> bool:
        """Return whether a list gives a valid value for this parameter."""
        assert self._parameter(pattern)
        return (pattern, indices) in self.entry_values

    def indices(self, prefix: str, *outer: int) -> tuple[int, ...]:
        """The indices of ``prefix`` (``thread[]``) behind ``outer`` with any entry, ascending."""
        depth = prefix.count("[]")
        assert depth == len(outer) + 1, prefix
        found = {
            indices[depth - 1]
            for pattern, indices in self.entry_values
            if pattern.startswith(prefix) and indices[: depth - 1] == outer
        }
        return tuple(sorted(found))

    def place(self, pattern: str, *indices: int) -> tuple[Span, str]:
        """Return where the parameter stands, and that line.

        Where it is missing, the first entry of the same element (``thread[2]``); the file where
        there is none.
        """
        item = self.entry_values.get((pattern, indices)) or self._relative(pattern, indices)
        if item is None:
            return whole_file(self.file), ""
        return item.entry.key_span, item.entry.line

    def _relative(self, pattern: str, indices: tuple[int, ...]) -> EntryValue | None:
        """Return the first entry of the element that an entry belongs to."""
        parts = pattern.split("[]")
        for depth in range(len(indices), 0, -1):
            element = "[]".join(parts[:depth]) + "[]"
            relatives = [
                item
                for (other, others), item in self.entry_values.items()
                if other.startswith(element)
                and others[:depth] == indices[:depth]
                and item.entry.key_span.file == self.file
            ]
            if relatives:
                return min(relatives, key=lambda item: item.entry.key_span)
        return None

    def where(self, patterns: Container[str], value: Value) -> tuple[Span, str]:
        """As ``place``, of the first entry of these names with this value."""
        for (pattern, indices), item in self.entry_values.items():
            if pattern in patterns and item.value == value:
                return self.place(pattern, *indices)
        return whole_file(self.file), ""

    def report(
        self,
        collector: Collector,
        message: Message,
        at: tuple[str, *tuple[int, ...]],
        /,
        **values: object,
    ) -> None:
        """Report ``message`` at the entry ``at``: the pattern, then the indices."""
        span, line = self.place(*at)
        found = collector.report(message, span, line, **values)
        collector.diagnostics[-1] = replace(found, entry=with_indices(at[0], at[1:]))

    def _parameter(self, pattern: str) -> Parameter:
        found = self.schema.find(pattern)
        assert found is not None and found[1] is None, pattern
        return found[0]
