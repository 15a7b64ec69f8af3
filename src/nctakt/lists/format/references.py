# SPDX-License-Identifier: MIT
"""Entries and defaults whose value is that of another parameter.

In: the entries of a list with the references among them (``P-AXIS-00212.0`` is "as P-AXIS-00212 of
gear step 0"). Out: the same with values. A broken or circular reference is reported and leaves the
default.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

from nctakt.lists.format.parameter import Parameter, Value, ValueType, shown, with_indices
from nctakt.lists.format.reader import Entry
from nctakt.lists.format.schema import Schema
from nctakt.lists.format.values import EntryValue, Key
from nctakt.messages import Collector
from nctakt.messages.machines.lists import INVALID_PARAMETER_REFERENCE

_REFERENCE = re.compile(r"(P-[A-Z]{4}-[0-9]{5})((?:\.[0-9]{1,4})*)")


def reference_of(parameter: Parameter, entry: Entry) -> str:
    """Return the reference in an entry's value, empty without one; a text is never one."""
    if parameter.type is ValueType.STRING:
        return ""
    words = entry.rest.split(None, 1)
    return words[0] if words and _REFERENCE.fullmatch(words[0]) else ""


def resolve(
    schema: Schema, values: Mapping[Key, EntryValue], collector: Collector
) -> dict[Key, EntryValue]:
    """Return ``values`` with the references among them resolved."""
    resolved: dict[Key, EntryValue] = {}
    for key, item in values.items():
        if not item.reference:
            resolved[key] = item
            continue
        parameter = _parameter(schema, key)
        value = _follow(schema, values, key)
        if value is not None and _has_type(parameter, value):
            resolved[key] = EntryValue(value, item.entry, item.reference)
            continue
        collector.report(
            INVALID_PARAMETER_REFERENCE,
            item.entry.key_span,
            item.entry.line,
            key=with_indices(*key),
            value=item.reference,
            default=shown(item.value),
        )
        if item.value is not None:
            resolved[key] = EntryValue(item.value, item.entry)
    return resolved


def effective_value(
    schema: Schema, values: Mapping[Key, EntryValue], parameter_id: str, indices: tuple[int, ...]
) -> Value:
    """Return the value of the parameter with this ID, ``None`` if there is none.

    There is none if the parameter has more indices than ``indices`` and the list names several of
    its elements.
    """
    key = key_of(schema, parameter_id, indices)
    if key is None:
        return None
    if len(key[1]) > len(indices) and any(other[0] == key[0] and other != key for other in values):
        return None
    return _follow(schema, values, key)


def key_of(schema: Schema, parameter_id: str, indices: tuple[int, ...]) -> Key | None:
    """Return the element of the parameter with this ID that belongs to ``indices``.

    Surplus indices are ignored; missing ones are 0.
    """
    parameters = schema.by_id(parameter_id)
    if len(parameters) != 1:
        return None
    depth = len(parameters[0].index_ranges)
    return parameters[0].pattern, (*indices, *(0,) * depth)[:depth]


def default_of(
    schema: Schema, values: Mapping[Key, EntryValue], parameter: Parameter, indices: tuple[int, ...]
) -> Value:
    """Return the default of a parameter, which may be the value of another parameter."""
    if parameter.default_id:
        return effective_value(schema, values, parameter.default_id, indices)
    return parameter.default


def _parameter(schema: Schema, key: Key) -> Parameter:
    declared = schema.find(key[0])
    assert declared is not None, key
    return declared[0]


def _has_type(parameter: Parameter, value: Value) -> bool:
    match parameter.type:
        case ValueType.BOOLEAN:
            return isinstance(value, bool)
        case ValueType.NAME:
            return value in parameter.names
        case ValueType.FLAGS:
            return isinstance(value, tuple) and all(name in parameter.names for name in value)
        case ValueType.REAL64:
            return isinstance(value, int | float) and parameter.allows(value)
    return isinstance(value, int) and parameter.allows(value)


def _follow(schema: Schema, values: Mapping[Key, EntryValue], start: Key) -> Value:
    """Return the value at the end of a chain of references, ``None`` for a broken or circular one.

    A default that refers to another parameter is a link of the chain as well.
    """
    key, visited = start, {start}
    while True:
        item = values.get(key)
        if item is not None and not item.reference:
            return item.value
        parameter = _parameter(schema, key)
        if item is None and not parameter.default_id:
            return parameter.default
        match = _REFERENCE.fullmatch(item.reference if item is not None else parameter.default_id)
        assert match is not None
        own = tuple(int(text) for text in match[2].split(".")[1:])
        target = key_of(schema, match[1], own or key[1])
        if target is None or target in visited:
            return None
        key = target
        visited.add(key)
