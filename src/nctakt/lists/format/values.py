# SPDX-License-Identifier: MIT
"""The checked values of one list.

In: the entries checked by ``load_list`` (``list_check.py``). Out: ``Values``: the value of each
parameter in a list, the default of all others, and the position of each entry.
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
    """The values of one list, and the defaults of its schema for all other parameters.

    ``entry_values``: those of parameters with an effect; ``unused_values``: the others.
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
        """Return the effective value of an integer parameter."""
        value = self.get(pattern, *indices)
        assert isinstance(value, int), pattern
        return int(value)

    def real(self, pattern: str, *indices: int) -> float:
        """Return the effective value of a number parameter."""
        value = self.get(pattern, *indices)
        assert isinstance(value, int | float), pattern
        return float(value)

    def flag(self, pattern: str, *indices: int) -> bool:
        """Return the effective value of a BOOLEAN parameter."""
        value = self.get(pattern, *indices)
        assert isinstance(value, bool), pattern
        return value

    def text(self, pattern: str, *indices: int) -> str:
        """Return the effective value of a STRING or NAME parameter."""
        value = self.get(pattern, *indices)
        assert isinstance(value, str), pattern
        return value

    def names(self, pattern: str, *indices: int) -> tuple[str, ...]:
        """Return the effective value of a FLAGS parameter."""
        value = self.get(pattern, *indices)
        assert isinstance(value, tuple), pattern
        return value

    def is_set(self, pattern: str, *indices: int) -> bool:
        """Return whether a list has a valid value of this parameter."""
        assert self._parameter(pattern)
        return (pattern, indices) in self.entry_values

    def given(self, pattern: str, *indices: int) -> EntryValue | None:
        """Return a list's value for a parameter, with or without effect; ``None`` without one."""
        key = (pattern, indices)
        return self.entry_values.get(key) or self.unused_values.get(key)

    def indices(self, prefix: str, *outer: int) -> tuple[int, ...]:
        """Return the indices of ``prefix`` (``thread[]``) after ``outer`` with entries."""
        depth = prefix.count("[]")
        assert depth == len(outer) + 1, prefix
        numbers = {
            entry_indices[depth - 1]
            for pattern, entry_indices in self.entry_values
            if pattern.startswith(prefix) and entry_indices[: depth - 1] == outer
        }
        return tuple(sorted(numbers))

    def position(self, pattern: str, *indices: int) -> tuple[Span, str]:
        """Return the span of a parameter's entry and its line.

        For a missing entry it is that of the first entry of the same element (``thread[2]``), else
        that of the file.
        """
        item = self.given(pattern, *indices) or self._relative(pattern, indices)
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
        """Return the span and line of the first entry of these names with this value."""
        for (pattern, indices), item in self.entry_values.items():
            if pattern in patterns and item.value == value:
                return self.position(pattern, *indices)
        return whole_file(self.file), ""

    def report(
        self,
        collector: Collector,
        message: Message,
        at: tuple[str, *tuple[int, ...]],
        number: int = 0,
        /,
        **values: object,
    ) -> None:
        """Report ``message`` at the entry ``at``: the pattern, then the indices.

        ``number``: that of a case which the values do not determine.
        """
        span, line = self.position(*at)
        message_at_entry = collector.report_as(number, message, span, line, **values)
        collector.diagnostics[-1] = replace(message_at_entry, entry=with_indices(at[0], at[1:]))

    def _parameter(self, pattern: str) -> Parameter:
        declared = self.schema.find(pattern)
        assert declared is not None and declared[1] is None, pattern
        return declared[0]
