# SPDX-License-Identifier: MIT
"""The types of companion models as nodes of an address space.

In: the facts of ``companion.py`` and ``machine_tool.py``. Out: nodes with the numbers of the
published models: types, data types, the components of types with their rules.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from types import MappingProxyType

from asyncua import ua

from nctakt.base.dataclass import dataclass
from nctakt.servers.opcua.model import machine_tool
from nctakt.servers.opcua.model import nodes as refs
from nctakt.servers.opcua.model.companion import (
    ANALOG_ITEM,
    ANALOG_RANGE,
    BINARY_DESCRIPTION,
    BINARY_NAMESPACE,
    BINARY_SCHEMA,
    CNC_URI,
    ENUMERATIONS,
    MANDATORY,
    OBJECT_TYPES,
    POSITION,
    POSITION_BINARY,
    POSITION_COMPONENTS,
    POSITION_FIELDS,
    POSITION_VARIABLE,
    POSITION_XML,
    PROPERTY,
    XML_DESCRIPTION,
    XML_NAMESPACE,
    XML_SCHEMA,
    Component,
    Enumeration,
    ObjectType,
)
from nctakt.servers.opcua.model.nodes import (
    ARRAY,
    READ,
    SCALAR,
    WRITE,
    Nodes,
    VariableValue,
    standard,
    text,
)

#: Data types of namespace 0 by their names.
DATA_TYPES = {
    "Boolean": 1,
    "Int32": 6,
    "UInt16": 5,
    "UInt32": 7,
    "Double": 11,
    "String": 12,
    "NodeId": 17,
    "Range": 884,
    "EUInformation": 887,
}

#: Folders of namespace 0: dictionaries of data types in XML and in binary form.
_XML_DICTIONARIES, _BINARY_DICTIONARIES = 92, 93

#: Types of namespace 0: encodings, descriptions and dictionaries of data types; values of enums,
#: and texts in a language.
_ENCODING_TYPE, _DESCRIPTION, _DICTIONARY, _ENUM_VALUE, _TEXT = 76, 69, 72, 7594, 21

#: The properties of an analog item: name, data type.
ANALOG_PROPERTIES = (("EURange", "Range"), ("EngineeringUnits", "EUInformation"))

_TYPES = {known.name: known for known in (*OBJECT_TYPES, *machine_tool.TYPES)}


#: The namespace of the XML schema.
TYPES_XSD = "http://opcfoundation.org/UA/CNC/Types.xsd"


@dataclass(frozen=True, slots=True)
class _Encoding:
    """How positions are encoded.

    ``numbers``: of the encoding, its schema, the schema's description, and its namespace.
    ``location``: of the type in the schema. ``folder``: where the schema is listed.
    """

    name: str
    numbers: tuple[int, int, int, int]
    uri: str
    schema: Callable[[], bytes]
    folder: int
    location: str


def binary_schema() -> bytes:
    """Return the dictionary of the binary encoding."""
    lines = [
        '<opc:TypeDictionary xmlns:opc="http://opcfoundation.org/BinarySchema/"'
        ' xmlns:ua="http://opcfoundation.org/UA/"'
        f' xmlns:tns="{CNC_URI}" DefaultByteOrder="LittleEndian" TargetNamespace="{CNC_URI}">',
        '<opc:Import Namespace="http://opcfoundation.org/UA/"/>',
        '<opc:StructuredType BaseType="ua:ExtensionObject" Name="CncPositionDataType">',
        *(f'<opc:Field TypeName="opc:Double" Name="{name}"/>' for name in POSITION_FIELDS),
        "</opc:StructuredType>",
    ]
    for enumeration in ENUMERATIONS:
        lines += [
            f'<opc:EnumeratedType LengthInBits="32" Name="{enumeration.name}">',
            *(
                f'<opc:EnumeratedValue Name="{name}" Value="{value}"/>'
                for value, name in enumerate(enumeration.names)
            ),
            "</opc:EnumeratedType>",
        ]
    return "\n".join([*lines, "</opc:TypeDictionary>", ""]).encode()


def xml_schema() -> bytes:
    """Return the dictionary of the XML encoding."""
    lines = [
        '<xs:schema elementFormDefault="qualified" xmlns:xs="http://www.w3.org/2001/XMLSchema"'
        f' targetNamespace="{TYPES_XSD}" xmlns:tns="{TYPES_XSD}">'
    ]
    for enumeration in ENUMERATIONS:
        lines += [
            f'<xs:simpleType name="{enumeration.name}"><xs:restriction base="xs:string">',
            *(
                f'<xs:enumeration value="{name}_{value}"/>'
                for value, name in enumerate(enumeration.names)
            ),
            "</xs:restriction></xs:simpleType>",
            f'<xs:element name="{enumeration.name}" type="tns:{enumeration.name}"/>',
        ]
    lines += [
        '<xs:complexType name="CncPositionDataType"><xs:sequence>',
        *(f'<xs:element name="{name}" type="xs:double"/>' for name in POSITION_FIELDS),
        "</xs:sequence></xs:complexType>",
        '<xs:element name="CncPositionDataType" type="tns:CncPositionDataType"/>',
        "</xs:schema>",
        "",
    ]
    return "\n".join(lines).encode()


_ENCODINGS = (
    _Encoding(
        "Default Binary",
        (POSITION_BINARY, BINARY_SCHEMA, BINARY_DESCRIPTION, BINARY_NAMESPACE),
        CNC_URI,
        binary_schema,
        _BINARY_DICTIONARIES,
        "CncPositionDataType",
    ),
    _Encoding(
        "Default XML",
        (POSITION_XML, XML_SCHEMA, XML_DESCRIPTION, XML_NAMESPACE),
        TYPES_XSD,
        xml_schema,
        _XML_DICTIONARIES,
        "//xs:element[@name='CncPositionDataType']",
    ),
)


def all_components(name: str) -> list[Component]:
    """Return the components of a type of objects, those of its base first."""
    known = _TYPES[name]
    base = all_components(known.base) if isinstance(known.base, str) else []
    return [*base, *known.components]


class CompanionTypes:
    """The types of a model in the namespace ``index``.

    ``foreign``: types of other models by their names.
    """

    def __init__(
        self,
        nodes: Nodes,
        index: int,
        objects: Sequence[ObjectType] = OBJECT_TYPES,
        enumerations: Sequence[Enumeration] = ENUMERATIONS,
        foreign: Mapping[str, ua.NodeId] = MappingProxyType({}),
    ) -> None:
        self._nodes = nodes
        self.index = index
        self._objects, self._enumerations = objects, enumerations
        self._known = dict(foreign)
        self._known |= {known.name: self.id(known.number) for known in objects}
        self._known |= {known.name: self.id(known.number) for known in enumerations}
        if objects is OBJECT_TYPES:
            self._known["CncPositionVariableType"] = self.id(POSITION_VARIABLE)
            self._known["CncPositionDataType"] = self.id(POSITION)

    def id(self, number: int) -> ua.NodeId:
        """Return the ID of a node of the model."""
        return ua.NodeId(number, self.index)

    def type(self, name: int | str) -> ua.NodeId:
        """Return the ID of a type, by its number in namespace 0 or its name here."""
        return standard(name) if isinstance(name, int) else self._known[name]

    def data_type(self, name: str) -> ua.NodeId:
        """Return the ID of a data type."""
        return standard(DATA_TYPES[name]) if name in DATA_TYPES else self.type(name)

    def name(self, words: str, *, is_standard: bool = False) -> ua.QualifiedName:
        """Return a name of the model, or of namespace 0."""
        return ua.QualifiedName(words, 0 if is_standard else self.index)

    def add_all(self) -> None:
        """Add all nodes of the model."""
        for enumeration in self._enumerations:
            self._add_enumeration(enumeration)
        if "CncPositionDataType" in self._known:
            self._add_position()
        for known in self._objects:
            self._add_object_type(known)
        for known in self._objects:
            owners = [(known.number, known.events)]
            owners += [(component.number, component.events) for component in known.components]
            for number, events in owners:
                for event in events:
                    self._nodes.refer(self.id(number), refs.GENERATES, self.type(event))

    # --- data types -----------------------------------------------------------------------------

    def _add_enumeration(self, enumeration: Enumeration) -> None:
        fields = [
            ua.EnumField(Value=value, DisplayName=text(name, ""), Name=name)
            for value, name in enumerate(enumeration.names)
        ]
        definition = ua.EnumDefinition(Fields=fields)
        self._nodes.add_type(
            self.id(enumeration.number),
            ua.NodeClass.DataType,
            self.name(enumeration.name),
            standard(29),
            DataTypeDefinition=(definition, ua.VariantType.ExtensionObject),
        )
        words = [text(name, "") for name in enumeration.names]
        values = [
            ua.EnumValueType(Value=value, DisplayName=word) for value, word in enumerate(words)
        ]
        kinds = ua.VariantType
        name, data_type, listed = (
            "EnumValues",
            _ENUM_VALUE,
            ua.Variant(values, kinds.ExtensionObject),
        )
        if enumeration.has_strings:
            name, data_type, listed = "EnumStrings", _TEXT, ua.Variant(words, kinds.LocalizedText)
        self._nodes.add_variable(
            self.id(enumeration.values_number),
            self.name(name, is_standard=True),
            standard(PROPERTY),
            VariableValue(
                standard(data_type), ua.DataValue(listed), rank=ARRAY, dimensions=(len(words),)
            ),
        )
        self._hang(
            enumeration.number, enumeration.values_number, refs.HAS_PROPERTY, enumeration.rule
        )

    def _add_position(self) -> None:
        """Add the structure of a position, its encodings, and the type of its variables."""
        fields = [
            ua.StructureField(
                Name=name,
                DataType=standard(DATA_TYPES["Double"]),
                ValueRank=SCALAR,
                IsOptional=False,
            )
            for name in POSITION_FIELDS
        ]
        definition = ua.StructureDefinition(
            DefaultEncodingId=self.id(POSITION_BINARY),
            BaseDataType=standard(22),
            StructureType=ua.StructureType.Structure,
            Fields=fields,
        )
        self._nodes.add_type(
            self.id(POSITION),
            ua.NodeClass.DataType,
            self.name("CncPositionDataType"),
            standard(22),
            DataTypeDefinition=(definition, ua.VariantType.ExtensionObject),
        )
        for encoding in _ENCODINGS:
            self._add_encoding(encoding)
        self._nodes.add_type(
            self.id(POSITION_VARIABLE),
            ua.NodeClass.VariableType,
            self.name("CncPositionVariableType"),
            standard(63),
            DataType=(self.id(POSITION), ua.VariantType.NodeId),
            ValueRank=(SCALAR, ua.VariantType.Int32),
        )
        self._add_position_parts(
            POSITION_VARIABLE, iter(number for _, number, _, _ in POSITION_COMPONENTS)
        )

    def _add_encoding(self, encoding: _Encoding) -> None:
        """Add an encoding of positions, with its schema and the schema's description."""
        number, schema, description, namespace = encoding.numbers
        name = self.name(encoding.name, is_standard=True)
        self._nodes.add_object(self.id(number), name, standard(_ENCODING_TYPE))
        self._nodes.refer(self.id(POSITION), refs.HAS_ENCODING, self.id(number))
        content = encoding.schema()
        self._text_variable(schema, self.name("CncSystems"), _DICTIONARY, content, 15)
        self._nodes.refer(standard(encoding.folder), refs.HAS_COMPONENT, self.id(schema))
        position = self.name("CncPositionDataType")
        self._text_variable(description, position, _DESCRIPTION, encoding.location)
        self._hang(schema, description, refs.HAS_COMPONENT)
        self._nodes.refer(self.id(number), refs.HAS_DESCRIPTION, self.id(description))
        uri = self.name("NamespaceUri", is_standard=True)
        self._text_variable(namespace, uri, PROPERTY, encoding.uri)
        self._hang(schema, namespace, refs.HAS_PROPERTY)

    def _text_variable(
        self,
        number: int,
        name: ua.QualifiedName,
        type_: int,
        value: str | bytes,
        data_type: int = DATA_TYPES["String"],
    ) -> None:
        kind = ua.VariantType.String if isinstance(value, str) else ua.VariantType.ByteString
        shown = ua.DataValue(ua.Variant(value, kind))
        self._nodes.add_variable(
            self.id(number),
            name,
            standard(type_),
            VariableValue(standard(data_type), shown),
        )

    # --- types of objects -----------------------------------------------------------------------

    def _add_object_type(self, known: ObjectType) -> None:
        self._nodes.add_type(
            self.id(known.number),
            ua.NodeClass.ObjectType,
            self.name(known.name),
            self.type(known.base),
            is_abstract=known.is_abstract,
        )
        for component in known.components:
            below = iter(component.below)
            self._add_component(known.number, component, component.number, below)

    def _add_component(
        self,
        parent: int,
        component: Component,
        number: int,
        below: Iterator[int],
    ) -> None:
        """Add a component of a type, or a copy of it, with its children."""
        if isinstance(component.type, str) and not component.data_type:
            self._nodes.add_object(
                self.id(number), self.name(component.name), self.type(component.type)
            )
            self._hang(parent, number, refs.HAS_COMPONENT, component.rule)
            for inner in all_components(component.type):
                self._copy(number, inner, below)
            for inner in component.surplus:
                self._add_component(number, inner, inner.number, iter(inner.below))
            return
        self._nodes.add_variable(
            self.id(number),
            self.name(component.name, is_standard=component.is_standard),
            self.type(component.type),
            VariableValue(
                self.data_type(component.data_type),
                ua.DataValue(),
                rank=ARRAY if component.dimensions else SCALAR,
                dimensions=component.dimensions if any(component.dimensions) else (),
                rights=component.rights,
            ),
        )
        kind = refs.HAS_PROPERTY if component.type == PROPERTY else refs.HAS_COMPONENT
        self._hang(parent, number, kind, component.rule)
        if component.type in (ANALOG_ITEM, ANALOG_RANGE):
            self._add_analog_parts(number, component, below)
        elif component.data_type == "CncPositionDataType":
            self._add_position_parts(number, below)

    def _copy(self, parent: int, component: Component, numbers: Iterator[int]) -> None:
        """Add a copy of a component below an object of its type, unless its number is 0."""
        number = next(numbers, 0)
        if number:
            self._add_component(parent, component, number, numbers)

    def _add_analog_parts(self, parent: int, component: Component, numbers: Iterator[int]) -> None:
        for (name, data_type), rule in zip(
            ANALOG_PROPERTIES, (MANDATORY, component.units_rule), strict=True
        ):
            number = next(numbers, 0)
            if number:
                own = self.name(name, is_standard=True)
                self._add_part(parent, number, own, PROPERTY, data_type, rule, READ)

    def _add_position_parts(self, parent: int, numbers: Iterator[int]) -> None:
        for (name, _, type_, data_type), number in zip(POSITION_COMPONENTS, numbers, strict=False):
            rights = READ | WRITE if type_ == PROPERTY else READ
            own = self.name(name)
            self._add_part(parent, number, own, type_, data_type, MANDATORY, rights)

    def _add_part(
        self,
        parent: int,
        number: int,
        name: ua.QualifiedName,
        type_: int,
        data_type: str,
        rule: int,
        rights: int,
    ) -> None:
        self._nodes.add_variable(
            self.id(number),
            name,
            standard(type_),
            VariableValue(self.data_type(data_type), ua.DataValue(), rights=rights),
        )
        kind = refs.HAS_PROPERTY if type_ == PROPERTY else refs.HAS_COMPONENT
        self._hang(parent, number, kind, rule)

    def _hang(self, parent: int, number: int, kind: int, rule: int = 0) -> None:
        self._nodes.refer(self.id(parent), kind, self.id(number))
        if rule:
            self._nodes.refer(self.id(number), refs.HAS_RULE, standard(rule))
