# SPDX-License-Identifier: MIT
"""The packed memory of V.E as a C header, for programs that read it.

In: a machine. Out: the text of a header with a structure for each section (``ve_global``,
``ve_channel_1`` …), whose offsets the compiler checks with ``_Static_assert``, and the offset of
each section in the shared memory. Names that are words of C get an underscore. A variable that
overlaps an earlier one cannot be a member: its offset is a number only.
"""

from __future__ import annotations

from collections.abc import Iterator

from nctakt.hli.variables_memory import Section, image_bytes, sections
from nctakt.lists.machine.external.variables import AccessRights, Node
from nctakt.lists.machine.external.variables_layout import Field, Placed, fields, pack_of
from nctakt.lists.machine.machine import Machine

_TYPES = {
    "BOOLEAN": "uint8_t",
    "SGN08": "int8_t",
    "UNS08": "uint8_t",
    "SGN16": "int16_t",
    "UNS16": "uint16_t",
    "SGN32": "int32_t",
    "UNS32": "uint32_t",
    "REAL64": "double",
}
_WORDS = frozenset(
    """auto break case char const continue default do double else enum extern float for goto if
    inline int long register restrict return short signed sizeof static struct switch typedef union
    unsigned void volatile while bool class delete explicit export false friend mutable namespace
    new operator private protected public template this throw true try typename using virtual
    asm constexpr nullptr typeof alignas alignof static_assert thread_local offsetof NULL""".split()
)


def describe_c(machine: Machine) -> str:
    """Return the header of a machine's memory."""
    return "\n".join(_Header(machine).lines()) + "\n"


def identifier(name: str) -> str:
    """Return a name of the list as an identifier of C."""
    return f"{name}_" if name in _WORDS else name


class _Header:
    """Writes one header; equal structures are declared once."""

    def __init__(self, machine: Machine) -> None:
        self._machine = machine
        self._pack = pack_of(machine.startup.member_alignment)
        self._structures: dict[tuple[str, tuple[Node, ...]], str] = {}
        self._names: list[str] = []

    def lines(self) -> Iterator[str]:
        """Yield the whole text."""
        parts = sections(self._machine)
        yield "/* Memory of the V.E variables. Made from the lists of a machine; do not edit. */"
        yield from ("#ifndef NCTAKT_VE_H", "#define NCTAKT_VE_H", "")
        yield from ("#include <stddef.h>", "#include <stdint.h>", "")
        yield f"#pragma pack(push, {self._pack})"
        for section in parts:
            for placed in section.placed:
                yield from self._declare(placed.variable.node)
        yield from ("#pragma pack(pop)", "")
        for section in parts:
            yield from self._section(section)
        yield f"#define VE_MEMORY_SIZE {image_bytes(self._machine)}"
        yield from ("", "#endif")

    def _declare(self, node: Node) -> Iterator[str]:
        """Yield the structures that a variable needs, the innermost first."""
        if not node.members or (node.type, _shape(node)) in self._structures:
            return
        for member in node.members:
            yield from self._declare(member)
        name = f"ve_{node.type}"
        while name in self._names:
            name += "_"
        self._names.append(name)
        self._structures[(node.type, _shape(node))] = name
        yield "typedef struct {"
        for member in node.members:
            yield f"    {self._member(member)};"
        yield f"}} {name};"

    def _member(self, node: Node) -> str:
        """Return a declaration without its semicolon."""
        name = identifier(node.name)
        count = f"[{node.array_elements}]" if node.array_elements else ""
        if node.members:
            return f"{self._structures[(node.type, _shape(node))]} {name}{count}"
        if node.type in _TYPES:
            return f"{_TYPES[node.type]} {name}{count}"
        return f"char {name}{count}[{node.size_bytes}]"

    def _section(self, section: Section) -> Iterator[str]:
        """Yield the structure of a section; its gaps are members, so that each offset is right."""
        name = f"ve_channel_{section.channel}" if section.channel else "ve_global"
        members: list[Placed] = []
        overlapping: list[Placed] = []
        end = 0
        body: list[str] = []
        for placed in sorted(section.placed, key=lambda placed: placed.offset):
            if placed.offset < end:
                overlapping.append(placed)
                continue
            if placed.offset > end:
                body.append(f"    uint8_t fill_at_{end}_[{placed.offset - end}];")
            body.append(f"    {self._member(placed.variable.node)};")
            members.append(placed)
            end = placed.end
        upper = name.upper()
        yield f"#define {upper}_OFFSET {section.offset}"
        yield f"#define {upper}_SIZE {section.size_bytes}"
        for placed in overlapping:
            yield f"#define {upper}_OFFSET_OF_{placed.variable.name} {placed.offset}"
        if body:
            yield from ("#pragma pack(push, 1)", "typedef struct {", *body, f"}} {name};")
            yield "#pragma pack(pop)"
            for placed in members:
                for field in filter(_is_first, fields(placed, self._pack)):
                    path = ".".join(identifier(part) for part in field.path.split("."))
                    condition = f"offsetof({name}, {path}) == {field.offset}"
                    yield f'_Static_assert({condition}, "{path}");'
        yield ""


def _shape(node: Node) -> tuple[Node, ...]:
    """Return the members of a structure; structures with equal members are the same in C."""
    return tuple(_plain(member) for member in node.members)


def _plain(node: Node) -> Node:
    """Return a member without access rights and synchronisation, which C does not know."""
    return Node(
        node.name,
        node.type,
        node.array_elements,
        True,
        AccessRights.READ_WRITE,
        node.size_bytes,
        tuple(_plain(member) for member in node.members),
    )


def _is_first(field: Field) -> bool:
    """Return whether a field lies in the first element of each array around it."""
    return "[" not in field.path.replace("[0]", "")
