# SPDX-License-Identifier: MIT
"""The structures of the HLI as a C header, for a PLC in another process.

Out: a text that is the same for every machine: the image itself holds the numbers of channels and
axes and their offsets. The compiler checks each offset with ``_Static_assert``.
"""

from __future__ import annotations

from collections.abc import Iterator

from nctakt.hli.layout import MAGIC, STRUCTURES, UNIT, VERSION, Entry, Structure
from nctakt.hli.places import entries, padding_of, size_of, unit_offset
from nctakt.kernel.plc.technology_slots import SLOT_COUNT

_TYPES = {
    "BOOLEAN": "uint8_t",
    "UNS08": "uint8_t",
    "UNS16": "uint16_t",
    "UNS32": "uint32_t",
    "SGN32": "int32_t",
    "UNS64": "uint64_t",
    "REAL64": "double",
    "STRING": "char",
}


def describe_hli_c() -> str:
    """Return the text of the header."""
    return "\n".join(_lines()) + "\n"


def _lines() -> Iterator[str]:
    yield "/* The HLI of nctakt: what CNC and PLC exchange. Made by nctakt; do not edit. */"
    yield from ("#ifndef NCTAKT_HLI_H", "#define NCTAKT_HLI_H", "")
    yield from ("#include <stddef.h>", "#include <stdint.h>", "")
    yield f'#define HLI_MAGIC "{MAGIC.decode("ascii").rstrip(chr(0))}"'
    yield f"#define HLI_VERSION {VERSION}"
    yield f"#define HLI_UNITS {SLOT_COUNT}"
    for structure in STRUCTURES:
        yield from ("", f"/* {structure.meaning} */", f"typedef struct {structure.name} {{")
        for entry in structure.entries:
            yield f"    {_member(entry)}; {_comment(entry)}"
        if fill_up := padding_of(structure):
            yield f"    uint8_t fill_up[{fill_up}];"
        for name in structure.units:
            yield f"    {UNIT.name} {name}[HLI_UNITS];"
        yield f"}} {structure.name};"
        yield from _asserts(structure)
    yield from ("", "#endif")


def _member(entry: Entry) -> str:
    count = f"[{entry.count}]" if entry.count else ""
    return f"{_TYPES[entry.image_type]} {entry.member}{count}"


def _comment(entry: Entry) -> str:
    unit = f" ({entry.image_unit})" if entry.image_unit else ""
    return f"/* {entry.meaning.replace('`', '')}{unit} */"


def _asserts(structure: Structure) -> Iterator[str]:
    name = structure.name
    places = [(placed.entry.member, placed.offset) for placed in entries(structure)]
    places += [(unit, unit_offset(structure, unit)) for unit in structure.units]
    for member, offset in places:
        yield f'_Static_assert(offsetof({name}, {member}) == {offset}, "{member}");'
    yield f'_Static_assert(sizeof({name}) == {size_of(structure)}, "{name}");'
