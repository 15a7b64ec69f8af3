# SPDX-License-Identifier: MIT
"""Bounds of values by other parameters of the same list: ``a_beschl`` ≤ ``a_max``.

In: the values of a list. Out: the same values; one beyond such a bound is reported and replaced by
the bound, as on the controller.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from nctakt.base.diagnostics import Span, Text
from nctakt.lists.format.controller_numbers import bound_number
from nctakt.lists.format.parameter import Limit, Parameter, ValueType, shown, with_indices
from nctakt.lists.format.references import effective_value, key_of
from nctakt.lists.format.schema import Schema
from nctakt.lists.format.values import EntryValue, Key
from nctakt.messages import Collector
from nctakt.messages.machines.lists import BEYOND_OTHER_PARAMETER

_ABOVE, _BELOW = Text("above", "über"), Text("below", "unter")


def keep_limits(
    schema: Schema, file: str, values: Mapping[Key, EntryValue], collector: Collector
) -> dict[Key, EntryValue]:
    """Return the values of the list in ``file`` (and its defaults list) within their bounds."""
    kept = dict(values)
    for key in values:
        declared = schema.find(key[0])
        assert declared is not None, key
        parameter = declared[0]
        if parameter.at_least is None and parameter.at_most is None:
            continue
        for limit, is_upper in ((parameter.at_least, False), (parameter.at_most, True)):
            if limit is not None:
                kept[key] = _within(schema, file, kept, key, parameter, limit, is_upper, collector)
    return kept


def _within(
    schema: Schema,
    file: str,
    values: Mapping[Key, EntryValue],
    key: Key,
    parameter: Parameter,
    limit: Limit,
    is_upper: bool,
    collector: Collector,
) -> EntryValue:
    item = values[key]
    value = item.value
    bound = _bound(schema, values, parameter, key, limit, is_upper)
    limiting = key_of(schema, limit.id, key[1])
    if bound is None or limiting is None or not isinstance(value, int | float):
        return item
    is_kept = value <= bound if is_upper else value >= bound
    if is_kept or value in parameter.also or value == parameter.default == 0:
        # A default of 0 means "not set".
        return item
    position = _position(file, item, values.get(limiting))
    if position is not None:
        collector.report_as(
            bound_number(parameter.id, value, is_above=is_upper),
            BEYOND_OTHER_PARAMETER,
            *position,
            key=with_indices(*key),
            value=shown(value),
            side=_ABOVE if is_upper else _BELOW,
            limit=shown(bound),
            other=with_indices(*limiting),
            id=limit.id,
        )
    return replace(item, value=bound)


def _bound(
    schema: Schema,
    values: Mapping[Key, EntryValue],
    parameter: Parameter,
    key: Key,
    limit: Limit,
    is_upper: bool,
) -> int | float | None:
    """Return the nearest value within the bound; ``None`` if the other parameter sets none."""
    other = effective_value(schema, values, limit.id, key[1])
    if not isinstance(other, int | float):
        return None
    if other == 0 and is_upper and not parameter.type.is_signed:
        # The limit is not set: a maximum speed of 0 means no bound.
        return None
    bound = other * limit.factor
    if parameter.type is ValueType.REAL64:
        return bound
    step = (-1 if is_upper else 1) if limit.is_exclusive else 0
    return int(bound) + step


def _position(file: str, item: EntryValue, limiting: EntryValue | None) -> tuple[Span, str] | None:
    """Return the entry that breaks the bound, ``None`` if only the defaults list does."""
    for candidate in (item, limiting):
        if candidate is not None and candidate.entry.key_span.file == file:
            return candidate.entry.key_span, candidate.entry.line
    return None
