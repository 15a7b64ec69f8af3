# SPDX-License-Identifier: MIT
"""The data types of the companion model as dictionaries, for clients that know no definitions.

Out: the binary and the XML schema of enumerations and of the structure of positions.
"""

from __future__ import annotations

from nctakt.servers.opcua.model.companion import CNC_URI, ENUMERATIONS, POSITION_FIELDS

#: The namespace of the XML schema.
TYPES_XSD = "http://opcfoundation.org/UA/CNC/Types.xsd"


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
