# SPDX-License-Identifier: MIT
"""The variables of a PLC that its text marks for clients: ``{attribute 'OPC.UA.DA' := '1'}``.

In: checked programs. Out: ``Value`` for each number, truth and text of a marked variable, by its
path. A mark counts for all parts of a variable, ``'0'`` takes a part out; a mark within a block or
structure counts for each of its instances. ``'OPC.UA.DA.Access' := '1'`` lets clients only read.
Whole numbers of 64 bits are left out, which a session's values cannot hold exactly, and with them
pointers, references, interfaces and single bits.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from dataclasses import replace

from nctakt.kernel.st import kinds
from nctakt.run.plcs.realtime_plc import distinct_names
from nctakt.servers.catalogue import Value
from nctakt.st.program import Program
from nctakt.st.types import (
    ArrayType,
    BlockType,
    EnumType,
    Kind,
    Section,
    Storage,
    StringType,
    StructType,
    Type,
    Variable,
)
from nctakt.translation.layout import kind_of
from nctakt.translation.variables import find_variable

#: Values that are shown at most: each of them comes with every frame.
MAX_MARKED = 2000

_MARK, _ACCESS, _READ_ONLY = "opc.ua.da", "opc.ua.da.access", "1"

#: The type of a value, as variables lists name it, by how it lies in memory.
_TYPES = {
    kinds.BOOL: "BOOLEAN",
    kinds.I8: "SGN08",
    kinds.I16: "SGN16",
    kinds.I32: "SGN32",
    kinds.U8: "UNS08",
    kinds.U16: "UNS16",
    kinds.U32: "UNS32",
    kinds.F32: "REAL64",
    kinds.F64: "REAL64",
}


def marked_values(programs: Sequence[Program]) -> dict[str, Value]:
    """Return the marked values of a session's PLCs by their names, ``MAX_MARKED`` at most.

    A path that an earlier PLC has, too, has its project before it, as elsewhere in a session.
    """
    found: dict[str, Value] = {}
    projects = distinct_names([program.name for program in programs])
    for number, program in enumerate(programs):
        for value in itertools.islice(_of_program(program), MAX_MARKED - len(found)):
            is_taken = any(find_variable(one, value.name) for one in programs[:number])
            name = f"{projects[number]}.{value.name}" if is_taken else value.name
            found[name] = replace(value, name=name)
    return found


def _of_program(program: Program) -> Iterator[Value]:
    for group in program.lists:
        prefix = f"{group.name}." if group.name else ""
        for one in group.variables.values():
            if not group.library and one.storage is Storage.GLOBAL:
                yield from _of_variable(f"{prefix}{one.name}", one, is_marked=False, is_open=True)
    for pou in program.pous.values():
        if pou.kind is Kind.PROGRAM and not pou.library:
            for one in pou.members.values():
                path = f"{pou.name}.{one.name}"
                yield from _of_variable(path, one, is_marked=False, is_open=True)


def _of_variable(
    path: str, variable: Variable, *, is_marked: bool, is_open: bool
) -> Iterator[Value]:
    """Yield the marked values of a variable; the last two: the marks of its parents."""
    if variable.section is Section.IN_OUT or variable.bit >= 0:
        return
    mark = variable.attributes.get(_MARK)
    is_marked = is_marked if mark is None else mark.strip() != "0"
    access = variable.attributes.get(_ACCESS)
    is_open = (is_open if access is None else access.strip() != _READ_ONLY) and (
        not variable.is_constant
    )
    yield from _of_type(path, variable.type, is_marked=is_marked, is_open=is_open)


def _of_type(path: str, kind: Type, *, is_marked: bool, is_open: bool) -> Iterator[Value]:
    if isinstance(kind, ArrayType):
        if is_marked or _has_mark(kind.innermost):
            ranges = [range(low, high + 1) for low, high in kind.bounds]
            for indices in itertools.product(*ranges):
                element = f"{path}[{','.join(map(str, indices))}]"
                yield from _of_type(element, kind.element, is_marked=is_marked, is_open=is_open)
    elif isinstance(kind, BlockType | StructType):
        for one in _members(kind):
            if one.storage is not Storage.GLOBAL:
                yield from _of_variable(
                    f"{path}.{one.name}", one, is_marked=is_marked, is_open=is_open
                )
    elif not is_marked:
        return
    elif isinstance(kind, StringType | EnumType):  # an enumeration by its items
        yield Value(path, "STRING", "", 0, is_open, kind.size)
    else:
        layout = kind_of(kind)
        type_ = None if layout is None else _TYPES.get(layout)
        if type_ is not None:
            yield Value(path, type_, "", 0, is_open)


def _members(kind: BlockType | StructType) -> list[Variable]:
    members = kind.pou.members if isinstance(kind, BlockType) else kind.members
    return list(members.values())


def _has_mark(kind: Type) -> bool:
    """Whether a type has members that are marked themselves."""
    if not isinstance(kind, BlockType | StructType):
        return False
    return any(
        _MARK in one.attributes
        or _has_mark(one.type.innermost if isinstance(one.type, ArrayType) else one.type)
        for one in _members(kind)
    )
