# SPDX-License-Identifier: MIT
"""Nodes put into an address space at once, each with its attributes and references.

In: an address space of asyncua. Out: nodes in it. A description of a node as its neighbours show it
is made once, so that thousands of nodes are built in a fraction of a second.
"""

from __future__ import annotations

from typing import Any

from asyncua import ua

from nctakt.base.dataclass import dataclass
from nctakt.servers.opcua.library import AddressSpace, AttributeValue, NodeData

#: Kinds of references, as numbers of namespace 0.
ORGANIZES, HAS_ENCODING, HAS_DESCRIPTION, HAS_TYPE, GENERATES = 35, 38, 39, 40, 41
HAS_RULE, HAS_SUBTYPE, HAS_PROPERTY, HAS_COMPONENT = 37, 45, 46, 47
HAS_CONDITION, HAS_EVENT_SOURCE, HAS_NOTIFIER, HAS_ADD_IN = 9006, 36, 48, 17604

#: A rank of a value: a scalar, an array of one dimension.
SCALAR, ARRAY = -1, 1

#: Rights to a value: read, write, its history.
READ, WRITE, HISTORY = 1, 2, 4


def standard(number: int) -> ua.NodeId:
    """Return the ID of a node of namespace 0."""
    return ua.NodeId(number, 0)


_TYPE = standard(HAS_TYPE)


def text(words: str, language: str = "en") -> ua.LocalizedText:
    """Return a text in a language."""
    return ua.LocalizedText(words, language)


@dataclass(frozen=True, slots=True)
class VariableValue:
    """The value of a variable as clients see it: its type and shape, its first value, the rights.

    ``dimensions``: the lengths of an array, none where they are open. ``interval_ms``: how often it
    can change.
    """

    data_type: ua.NodeId
    value: ua.DataValue
    rank: int = SCALAR
    dimensions: tuple[int, ...] = ()
    rights: int = READ
    interval_ms: float = 0.0


class Nodes:
    """Adds nodes to an address space."""

    def __init__(self, space: AddressSpace) -> None:
        self.space = space

    # --- nodes ----------------------------------------------------------------------------------

    def add_object(
        self,
        node: ua.NodeId,
        name: ua.QualifiedName,
        type_: ua.NodeId,
        *,
        is_notifier: bool = False,
        display: str = "",
    ) -> ua.NodeId:
        """Add an object; ``is_notifier``: clients may subscribe to its events."""
        attributes = {ua.AttributeIds.EventNotifier: (int(is_notifier), ua.VariantType.Byte)}
        self._add(node, ua.NodeClass.Object, name, attributes, display)
        self.refer(node, HAS_TYPE, type_)
        return node

    def add_variable(
        self,
        node: ua.NodeId,
        name: ua.QualifiedName,
        type_: ua.NodeId,
        shown: VariableValue,
    ) -> ua.NodeId:
        """Add a variable with its first value."""
        kinds = ua.VariantType
        attributes: dict[ua.AttributeIds, tuple[Any, ua.VariantType]] = {
            ua.AttributeIds.DataType: (shown.data_type, kinds.NodeId),
            ua.AttributeIds.ValueRank: (shown.rank, kinds.Int32),
            ua.AttributeIds.AccessLevel: (shown.rights, kinds.Byte),
            ua.AttributeIds.UserAccessLevel: (shown.rights, kinds.Byte),
            ua.AttributeIds.MinimumSamplingInterval: (shown.interval_ms, kinds.Double),
            ua.AttributeIds.Historizing: (bool(shown.rights & HISTORY), kinds.Boolean),
        }
        data = self._add(node, ua.NodeClass.Variable, name, attributes)
        if shown.dimensions:
            shape = ua.Variant(list(shown.dimensions), kinds.UInt32, is_array=True)
            data.attributes[ua.AttributeIds.ArrayDimensions] = AttributeValue(ua.DataValue(shape))
        data.attributes[ua.AttributeIds.Value] = AttributeValue(shown.value)
        self.refer(node, HAS_TYPE, type_)
        return node

    def add_type(
        self,
        node: ua.NodeId,
        kind: ua.NodeClass,
        name: ua.QualifiedName,
        base: ua.NodeId,
        *,
        is_abstract: bool = False,
        **further: tuple[Any, ua.VariantType],
    ) -> ua.NodeId:
        """Add a type of objects, variables or data below its base."""
        attributes = {ua.AttributeIds.IsAbstract: (is_abstract, ua.VariantType.Boolean)}
        attributes |= {ua.AttributeIds[word]: value for word, value in further.items()}
        self._add(node, kind, name, attributes)
        self.refer(base, HAS_SUBTYPE, node)
        return node

    def add_method(self, node: ua.NodeId, name: ua.QualifiedName, **arguments: Any) -> ua.NodeId:
        """Add a method; ``inputs`` and ``outputs``: its arguments."""
        kinds = ua.VariantType
        attributes = {
            ua.AttributeIds.Executable: (True, kinds.Boolean),
            ua.AttributeIds.UserExecutable: (True, kinds.Boolean),
        }
        self._add(node, ua.NodeClass.Method, name, attributes)
        for word, browse_name in (("inputs", "InputArguments"), ("outputs", "OutputArguments")):
            if arguments.get(word):
                own = ua.NodeId(f"{node.Identifier}.{browse_name}", node.NamespaceIndex)
                listed = ua.Variant(arguments[word], kinds.ExtensionObject, is_array=True)
                self.add_variable(
                    own,
                    ua.QualifiedName(browse_name, 0),
                    standard(68),
                    VariableValue(
                        standard(296),
                        ua.DataValue(listed),
                        rank=ARRAY,
                        dimensions=(len(arguments[word]),),
                    ),
                )
                self.refer(node, HAS_PROPERTY, own)
        return node

    def _add(
        self,
        node: ua.NodeId,
        kind: ua.NodeClass,
        name: ua.QualifiedName,
        attributes: dict[Any, tuple[Any, ua.VariantType]],
        display: str = "",
    ) -> NodeData:
        if node in self.space:
            raise ValueError(f"{node} is there already")
        kinds = ua.VariantType
        shown = text(display or name.Name, "") if display else text(name.Name, "")
        attributes = {
            ua.AttributeIds.NodeId: (node, kinds.NodeId),
            ua.AttributeIds.NodeClass: (int(kind), kinds.Int32),
            ua.AttributeIds.BrowseName: (name, kinds.QualifiedName),
            ua.AttributeIds.DisplayName: (shown, kinds.LocalizedText),
            ua.AttributeIds.WriteMask: (0, kinds.UInt32),
            ua.AttributeIds.UserWriteMask: (0, kinds.UInt32),
            **attributes,
        }
        data = NodeData(node)
        for attribute, (value, variant) in attributes.items():
            data.attributes[attribute] = AttributeValue(ua.DataValue(ua.Variant(value, variant)))
        self.space[node] = data
        return data

    # --- references -----------------------------------------------------------------------------

    def refer(self, source: ua.NodeId, kind: int, target: ua.NodeId, *, both: bool = True) -> None:
        """Add a reference from a node to another, and back unless ``both`` is false."""
        reference = standard(kind)
        self.space[source].references.append(self._shown(target, reference, is_forward=True))
        if both and kind not in (HAS_TYPE, HAS_RULE):
            self.space[target].references.append(self._shown(source, reference, is_forward=False))

    def _shown(
        self, node: ua.NodeId, reference: ua.NodeId, *, is_forward: bool
    ) -> ua.ReferenceDescription:
        data = self.space[node]
        shown = ua.ReferenceDescription()
        shown.ReferenceTypeId = reference
        shown.IsForward = is_forward
        shown.NodeId = node
        shown.NodeClass = ua.NodeClass(self._value(data, ua.AttributeIds.NodeClass))
        shown.BrowseName = self._value(data, ua.AttributeIds.BrowseName)
        shown.DisplayName = self._value(data, ua.AttributeIds.DisplayName)
        types = [one.NodeId for one in data.references if one.ReferenceTypeId == _TYPE]
        if types:
            shown.TypeDefinition = types[0]
        return shown

    @staticmethod
    def _value(data: NodeData, attribute: ua.AttributeIds) -> Any:
        shown = data.attributes[attribute].value
        assert shown is not None
        assert shown.Value is not None
        return shown.Value.Value
