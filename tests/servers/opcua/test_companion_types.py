# SPDX-License-Identifier: MIT
"""The types of the companion model are those that the OPC Foundation has published."""

from __future__ import annotations

import asyncio
from collections.abc import Iterator

import pytest

pytest.importorskip("asyncua", reason="needs the extra [opcua]")

from asyncua import ua
from asyncua.server.internal_server import InternalServer
from support.published_model import PublishedNode, node_set

from nctakt.servers.opcua.model.nodes import Nodes
from nctakt.servers.opcua.model.types import DATA_TYPES, CompanionTypes

pytestmark = pytest.mark.slow

INDEX = 2
KINDS = {
    "UAObject": ua.NodeClass.Object,
    "UAVariable": ua.NodeClass.Variable,
    "UAObjectType": ua.NodeClass.ObjectType,
    "UAVariableType": ua.NodeClass.VariableType,
    "UADataType": ua.NodeClass.DataType,
}
REFERENCES = {
    "HasComponent": 47,
    "HasProperty": 46,
    "HasSubtype": 45,
    "HasTypeDefinition": 40,
    "HasModellingRule": 37,
    "HasEncoding": 38,
    "HasDescription": 39,
    "GeneratesEvent": 41,
}


@pytest.fixture(scope="module")
def published(tmp_path_factory):
    """The published node set."""
    return node_set(tmp_path_factory.mktemp("npm"))


@pytest.fixture(scope="module")
def space():
    """An address space with our types."""

    async def build():
        server = InternalServer()
        await server.init()
        CompanionTypes(Nodes(server.aspace), INDEX).add_all()
        return server.aspace

    return asyncio.run(build())


def model_nodes(published: dict[str, PublishedNode]) -> Iterator[str]:
    """Yield the nodes of the model: the types, and all below them.

    The file has an instance named ``test``, too, with nodes that hang nowhere: no part of a type.
    """
    todo = [
        node
        for node, one in published.items()
        if one.kind not in ("UAObject", "UAVariable") or node in ("ns=1;i=6022", "ns=1;i=6038")
    ]
    seen = set()
    while todo:
        node = todo.pop()
        if node in seen or node not in published:
            continue
        seen.add(node)
        yield node
        todo += [
            target
            for kind, is_forward, target in published[node].references
            if is_forward and kind in ("HasComponent", "HasProperty", "HasEncoding")
        ]


def as_id(node: str) -> ua.NodeId:
    """Return our ID for a published one."""
    number = int(node.rpartition("=")[2])
    return ua.NodeId(number, INDEX if node.startswith("ns=1;") else 0)


def value(space, node, attribute):
    """Return an attribute of a node; ``None`` where it has none."""
    found = space.read_attribute_value(node, attribute)
    return None if found.Value is None else found.Value.Value


@pytest.mark.nightly
def test_each_published_node_of_the_model_is_there_and_no_other(space, published):
    """Numbers, kinds and names."""
    wanted = {as_id(node): published[node] for node in model_nodes(published)}
    ours = {node for node in space.keys() if node.NamespaceIndex == INDEX}
    assert ours == set(wanted)
    assert len(ours) > 490
    for node, one in wanted.items():
        assert value(space, node, ua.AttributeIds.NodeClass) == KINDS[one.kind]
        index, _, name = one.name.rpartition(":")
        own = value(space, node, ua.AttributeIds.BrowseName)
        assert (own.Name, own.NamespaceIndex) == (name, INDEX if index == "1" else 0)


def test_data_types_ranks_dimensions_and_rights(space, published):
    """As published; an abstract type is abstract."""
    aliases = {name: ua.NodeId(number) for name, number in DATA_TYPES.items()}
    further = {"EnumValueType": 7594, "ByteString": 15, "LocalizedText": 21}
    aliases |= {name: ua.NodeId(number) for name, number in further.items()}
    for node in model_nodes(published):
        one, ours = published[node], as_id(node)
        if one.kind == "UAVariable":
            name = one.attributes["DataType"]
            named = [
                as_id(other)
                for other, known in published.items()
                if known.kind == "UADataType" and known.name == f"1:{name}"
            ]
            data_type = aliases.get(name) or named[0]
            assert value(space, ours, ua.AttributeIds.DataType) == data_type, one
            rank = int(one.attributes.get("ValueRank", -1))
            assert value(space, ours, ua.AttributeIds.ValueRank) == rank, one
            shape = one.attributes.get("ArrayDimensions")
            dimensions = value(space, ours, ua.AttributeIds.ArrayDimensions)
            assert dimensions == ([int(shape)] if shape else None), one
            rights = int(one.attributes.get("AccessLevel", 1))
            assert value(space, ours, ua.AttributeIds.AccessLevel) == rights, one
        elif one.kind != "UAObject":
            is_abstract = one.attributes.get("IsAbstract") == "true"
            assert value(space, ours, ua.AttributeIds.IsAbstract) == is_abstract, one


def test_references_with_modelling_rules_are_equal(space, published):
    """Types, bases, components, properties, rules, encodings and events; no more, no less."""
    model = set(model_nodes(published))
    for node in model:
        wanted = {
            (REFERENCES[kind], as_id(target))
            for kind, is_forward, target in published[node].references
            if is_forward and (target in model or not target.startswith("ns=1;"))
        }
        if node == "ns=1;i=1007":  # published from the other end only
            wanted |= {(41, as_id("ns=1;i=1006")), (41, as_id("ns=1;i=1011"))}
        ours = {
            (one.ReferenceTypeId.Identifier, one.NodeId)
            for one in space[as_id(node)].references
            if one.IsForward and one.ReferenceTypeId.Identifier in REFERENCES.values()
        }
        subtypes = {(kind, target) for kind, target in ours if kind == 45}
        assert ours - subtypes == wanted, (node, published[node].name)
        bases = {
            as_id(target)
            for kind, is_forward, target in published[node].references
            if kind == "HasSubtype" and not is_forward
        }
        assert bases == {
            one.NodeId
            for one in space[as_id(node)].references
            if one.ReferenceTypeId.Identifier == 45 and not one.IsForward
        }


def test_enumerations_and_the_structure_are_equal(space, published):
    """Names, values and fields, in the definition and in EnumValues."""
    for node in model_nodes(published):
        one = published[node]
        if one.kind != "UADataType":
            continue
        definition = value(space, as_id(node), ua.AttributeIds.DataTypeDefinition)
        if isinstance(definition, ua.EnumDefinition):
            assert [(field.Name, str(field.Value)) for field in definition.Fields] == one.fields
            listed = next(
                target for kind, forward, target in one.references if kind == "HasProperty"
            )
            values = value(space, as_id(listed), ua.AttributeIds.Value)
            if isinstance(values[0], ua.LocalizedText):
                own = [(known.Text, str(number)) for number, known in enumerate(values)]
            else:
                own = [(known.DisplayName.Text, str(known.Value)) for known in values]
            assert own == one.fields
        else:
            names = [(field.Name, "Double") for field in definition.Fields]
            assert names == one.fields
            assert not any(field.IsOptional for field in definition.Fields)
            assert definition.DefaultEncodingId == ua.NodeId(5001, INDEX)
