# SPDX-License-Identifier: MIT
"""Events as clients select their fields, and their filters.

In: an event, with its texts in both languages. Out: the fields of an event in the language of a
client; whether it passes the client's filter.
"""

from __future__ import annotations

import fnmatch
import re
from collections.abc import Callable, Mapping
from datetime import UTC, datetime
from typing import Any

from asyncua import ua

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Language, Text
from nctakt.servers.opcua.library import AddressSpace

#: A field: its value, or its value in a language; and its type.
Field = tuple[Any, ua.VariantType]


@dataclass(frozen=True, slots=True)
class Event:
    """An event; ``values``: its fields by their paths, such as ``ActiveState/Id``.

    A ``Text`` among them is one in the language of the client.
    """

    type: ua.NodeId
    id: bytes
    values: Mapping[str, Field]

    def field(self, path: str, language: Language) -> ua.Variant:
        """Return a field; one that the event does not have is null."""
        found = self.values.get(path)
        if found is None:
            return ua.Variant(None, ua.VariantType.Null)
        value, kind = found
        if isinstance(value, Text):
            words = value.get(language)
            value = ua.LocalizedText(words, language) if kind == _LOCALIZED else words
        elif isinstance(value, tuple):
            value = [one.get(language) if isinstance(one, Text) else one for one in value]
            return ua.Variant(value, kind, is_array=True)
        return ua.Variant(value, kind)


_LOCALIZED = ua.VariantType.LocalizedText


def base_fields(
    type_: ua.NodeId,
    event_id: bytes,
    source: ua.NodeId,
    source_name: str,
    time: datetime,
    message: Text,
    severity: int,
) -> dict[str, Field]:
    """Return the fields that each event has."""
    kinds = ua.VariantType
    return {
        "EventId": (event_id, kinds.ByteString),
        "EventType": (type_, kinds.NodeId),
        "SourceNode": (source, kinds.NodeId),
        "SourceName": (source_name, kinds.String),
        "Time": (time, kinds.DateTime),
        "ReceiveTime": (datetime.now(UTC), kinds.DateTime),
        "Message": (message, kinds.LocalizedText),
        "Severity": (severity, kinds.UInt16),
    }


class SeenEvent:
    """An event as one client sees it."""

    def __init__(self, event: Event, language: Language, types: EventTypes) -> None:
        self._event = event
        self._language = language
        self._types = types

    def fields(self, clauses: list[Any]) -> list[ua.Variant]:
        """Return the selected fields, in the order of the selection."""
        return [self._field(clause) for clause in clauses]

    def _field(self, clause: Any) -> ua.Variant:
        if not clause.BrowsePath:  # the ID of the condition
            return self._event.field("NodeId", self._language)
        path = "/".join(str(part.Name) for part in clause.BrowsePath)
        return self._event.field(path, self._language)

    def passes(self, clause: Any) -> bool:
        """Return whether the event passes a filter; an invalid filter lets none pass."""
        if clause is None or not clause.Elements:
            return True
        try:
            return self._evaluate(clause.Elements, 0, 0) is True
        except (TypeError, ValueError, IndexError, AttributeError, KeyError):
            return False

    def _evaluate(self, elements: Any, index: int, depth: int) -> Any:
        if depth > len(elements):
            raise ValueError("a filter that refers to itself")
        element = elements[index]
        values = [self._operand(elements, operand, depth + 1) for operand in element.FilterOperands]
        if element.FilterOperator == ua.FilterOperator.OfType:
            return self._types.is_of(self._event.type, values[0])
        return _OPERATORS[element.FilterOperator](values)

    def _operand(self, elements: Any, operand: Any, depth: int) -> Any:
        if isinstance(operand, ua.ElementOperand):
            return self._evaluate(elements, operand.Index, depth)
        if isinstance(operand, ua.LiteralOperand):
            return operand.Value.Value
        return self._field(operand).Value


def _like(values: list[Any]) -> bool:
    """Return whether a text is as a pattern with % and _ wants it."""
    pattern = str(values[1]).replace("*", "[*]").replace("?", "[?]")
    pattern = pattern.replace("%", "*").replace("_", "?")
    return re.match(fnmatch.translate(pattern), str(values[0])) is not None


_OPERATORS: dict[Any, Callable[[list[Any]], Any]] = {
    ua.FilterOperator.Equals: lambda values: values[0] == values[1],
    ua.FilterOperator.IsNull: lambda values: values[0] is None,
    ua.FilterOperator.GreaterThan: lambda values: values[0] > values[1],
    ua.FilterOperator.LessThan: lambda values: values[0] < values[1],
    ua.FilterOperator.GreaterThanOrEqual: lambda values: values[0] >= values[1],
    ua.FilterOperator.LessThanOrEqual: lambda values: values[0] <= values[1],
    ua.FilterOperator.Like: _like,
    ua.FilterOperator.Not: lambda values: not values[0],
    ua.FilterOperator.Between: lambda values: values[1] <= values[0] <= values[2],
    ua.FilterOperator.InList: lambda values: values[0] in values[1:],
    ua.FilterOperator.And: lambda values: bool(values[0] and values[1]),
    ua.FilterOperator.Or: lambda values: bool(values[0] or values[1]),
    ua.FilterOperator.BitwiseAnd: lambda values: values[0] & values[1],
    ua.FilterOperator.BitwiseOr: lambda values: values[0] | values[1],
}


class EventTypes:
    """The types of events in an address space."""

    def __init__(self, space: AddressSpace) -> None:
        self._space = space

    def is_of(self, type_: ua.NodeId, requested: ua.NodeId) -> bool:
        """Return whether a type is another one, or below it."""
        has_subtype = ua.NodeId(ua.ObjectIds.HasSubtype)
        for _ in range(20):  # no type is deeper
            if type_ == requested:
                return True
            bases = [
                one.NodeId
                for one in self._space[type_].references
                if one.ReferenceTypeId == has_subtype and not one.IsForward
            ]
            if not bases:
                return False
            type_ = bases[0]
        return False
