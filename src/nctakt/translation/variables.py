# SPDX-License-Identifier: MIT
"""The variables of a translated program by their paths: addresses and types."""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterator

from nctakt.base.dataclass import dataclass
from nctakt.kernel.st import kinds
from nctakt.st.program import Program
from nctakt.st.types import (
    ArrayType,
    BlockType,
    InterfaceType,
    Kind,
    PointerType,
    Pou,
    ReferenceType,
    Section,
    Storage,
    StringType,
    StructType,
    Type,
    Variable,
)
from nctakt.translation.layout import kind_of

_PART = re.compile(r"\.?(\w+)|\[\s*(-?\d+(?:\s*,\s*-?\d+)*)\s*\]")


@dataclass(frozen=True, slots=True)
class PlacedVariable:
    """A variable: its place and its type."""

    address: int
    type: Type
    bit: int = -1
    is_constant: bool = False


def find_variable(program: Program, path: str) -> PlacedVariable | None:
    """Return the variable of a path such as ``MAIN.aTools[2].bWorn``; ``None`` if there is none.

    An address such as ``%IX0.3`` is the path of the variable that is declared at it (ST-402).
    """
    if path.startswith("%"):
        return _at_address(program, path.upper())
    parts = _PART.findall(path)
    if "".join(name or f"[{index}]" for name, index in parts) != re.sub(r"[.\s]", "", path):
        return None
    found: PlacedVariable | None = None
    scope: dict[str, Variable] | None = None
    for number, (name, indices) in enumerate(parts):
        if name and number == 0:
            found, scope = _first(program, name.lower())
        elif name and scope is not None:
            variable = scope.get(name.lower())
            if variable is None:
                return None
            found = _global(variable)
            scope = None
        elif name:
            found = None if found is None else _member(found, name.lower())
        else:
            found = None if found is None else _element(found, indices)
        if found is None and scope is None:
            return None
    return found


def own_values(program: Program) -> Iterator[tuple[str, Type]]:
    """Yield path and type of each scalar and text of a project's code, outside arrays."""
    for group in program.lists:
        prefix = f"{group.name}." if group.name else ""
        for variable in () if group.library else group.variables.values():
            if variable.storage is Storage.GLOBAL:
                yield from _values(f"{prefix}{variable.name}", variable.type)
    for pou in program.pous.values():
        if pou.kind is Kind.PROGRAM and not pou.library and pou.type is not None:
            yield from _values(pou.name, pou.type)


def _values(path: str, sought: Type) -> Iterator[tuple[str, Type]]:
    if isinstance(sought, BlockType | StructType):
        for member in _parts(sought):
            yield from _values(f"{path}.{member.name}", member.type)
    elif isinstance(sought, StringType) or kind_of(sought) is not None:
        if not isinstance(sought, PointerType | ReferenceType | InterfaceType):
            yield path, sought


def retained_paths(program: Program) -> Iterator[str]:
    """Yield the paths of all scalars and texts that are RETAIN or PERSISTENT (ST-406).

    Pointers, references, interfaces and single bits have no value that could be kept.
    """
    for group in program.lists:
        prefix = f"{group.name}." if group.name else ""
        for variable in group.variables.values():
            if variable.storage is Storage.GLOBAL:
                yield from _retained(f"{prefix}{variable.name}", variable, is_kept=False)
    for pou in program.pous.values():
        if pou.kind is Kind.PROGRAM and not pou.library:
            for variable in pou.members.values():
                yield from _retained(f"{pou.name}.{variable.name}", variable, is_kept=False)


def _retained(path: str, variable: Variable, *, is_kept: bool) -> Iterator[str]:
    if variable.section is Section.IN_OUT or variable.bit >= 0:
        return
    is_kept = is_kept or variable.is_retain or variable.is_persistent
    yield from _retained_parts(path, variable.type, is_kept=is_kept)


def _retained_parts(path: str, sought: Type, *, is_kept: bool) -> Iterator[str]:
    if isinstance(sought, BlockType | StructType):
        members = sought.pou.members if isinstance(sought, BlockType) else sought.members
        for member in members.values():
            yield from _retained(f"{path}.{member.name}", member, is_kept=is_kept)
    elif isinstance(sought, ArrayType):
        if is_kept or isinstance(sought.element, BlockType | ArrayType):
            ranges = [range(low, high + 1) for low, high in sought.bounds]
            for indices in itertools.product(*ranges):
                element = f"{path}[{','.join(map(str, indices))}]"
                yield from _retained_parts(element, sought.element, is_kept=is_kept)
    elif is_kept and (isinstance(sought, StringType) or kind_of(sought) is not None):
        if not isinstance(sought, PointerType | ReferenceType | InterfaceType):
            yield path


def instances_of(program: Program, base: Pou) -> Iterator[tuple[str, int, Pou]]:
    """Yield path, address and type of each instance of a block and those derived from it."""
    known: dict[int, bool] = {}
    for group in program.lists:
        prefix = f"{group.name}." if group.name else ""
        for one in group.variables.values():
            if one.storage is Storage.GLOBAL:
                address = kinds.NULL_BYTES + one.offset
                yield from instances_in(f"{prefix}{one.name}", one.type, address, base, known)
    for pou in program.pous.values():
        if pou.kind is Kind.PROGRAM and pou.type is not None:
            address = kinds.NULL_BYTES + pou.instance
            yield from instances_in(pou.name, pou.type, address, base, known)


def instances_in(
    path: str, sought: Type, address: int, base: Pou, known: dict[int, bool]
) -> Iterator[tuple[str, int, Pou]]:
    """Yield those within a variable; ``known``: which types have any."""
    if not _holds(sought, base, known):
        return
    if isinstance(sought, BlockType) and base in sought.pou.bases():
        yield path, address, sought.pou
    if isinstance(sought, ArrayType):
        ranges = [range(low, high + 1) for low, high in sought.bounds]
        for number, indices in enumerate(itertools.product(*ranges)):
            element, at = sought.element, address + number * sought.element.size
            name = f"{path}[{','.join(map(str, indices))}]"
            yield from instances_in(name, element, at, base, known)
    for one in _parts(sought):
        yield from instances_in(f"{path}.{one.name}", one.type, address + one.offset, base, known)


def _parts(sought: Type) -> list[Variable]:
    """Return the variables that lie in an instance or a structure."""
    if isinstance(sought, BlockType):
        members = sought.pou.members.values()
    elif isinstance(sought, StructType):
        members = sought.members.values()
    else:
        return []
    return [
        one
        for one in members
        if one.section is not Section.IN_OUT and one.storage is not Storage.GLOBAL
    ]


def _holds(sought: Type, base: Pou, known: dict[int, bool]) -> bool:
    """Return whether a type is that of an instance of a block, or has one within."""
    if isinstance(sought, ArrayType):
        return _holds(sought.element, base, known)
    found = known.get(id(sought))
    if found is None:
        found = isinstance(sought, BlockType) and base in sought.pou.bases()
        found = found or any(_holds(one.type, base, known) for one in _parts(sought))
        known[id(sought)] = found
    return found


def _at_address(program: Program, address: str) -> PlacedVariable | None:
    """Return the variable of a list or a program that is declared at a fixed address."""
    for group in program.lists:
        for variable in group.variables.values():
            if variable.address == address:
                return _global(variable)
    for pou in program.pous.values():
        if pou.kind is Kind.PROGRAM and pou.type is not None:
            instance = PlacedVariable(kinds.NULL_BYTES + pou.instance, pou.type)
            for name, variable in pou.members.items():
                if variable.address == address:
                    return _member(instance, name)
    return None


def _first(program: Program, name: str) -> tuple[PlacedVariable | None, dict[str, Variable] | None]:
    """Return the start of a path: a program, a list or one of its variables."""
    pou = program.pous.get(name)
    if pou is not None and pou.kind is Kind.PROGRAM and pou.type is not None:
        return PlacedVariable(kinds.NULL_BYTES + pou.instance, pou.type), None
    for group in program.lists:
        if group.name.lower() == name and name:
            return None, group.variables
    for group in program.lists:
        if name in group.variables:
            return _global(group.variables[name]), None
    return None, None


def _global(variable: Variable) -> PlacedVariable | None:
    if variable.storage is not Storage.GLOBAL:
        return None
    address = kinds.NULL_BYTES + variable.offset
    return PlacedVariable(address, variable.type, is_constant=variable.is_constant)


def _member(found: PlacedVariable, name: str) -> PlacedVariable | None:
    if isinstance(found.type, BlockType):
        variable = found.type.pou.members.get(name)
        if variable is not None and variable.storage is Storage.GLOBAL:
            return _global(variable)
    elif isinstance(found.type, StructType):
        variable = found.type.members.get(name)
    else:
        variable = None
    if variable is None or variable.section is Section.IN_OUT:  # that holds an address
        return None
    is_constant = found.is_constant or variable.is_constant
    return PlacedVariable(found.address + variable.offset, variable.type, variable.bit, is_constant)


def _element(found: PlacedVariable, indices: str) -> PlacedVariable | None:
    sought = found.type
    numbers = [int(one) for one in indices.split(",")]
    if not isinstance(sought, ArrayType) or len(numbers) != len(sought.bounds):
        return None
    number = 0
    for index, (low, high) in zip(numbers, sought.bounds, strict=True):
        if not low <= index <= high:
            return None
        number = number * (high - low + 1) + index - low
    address = found.address + number * sought.element.size
    return PlacedVariable(address, sought.element, is_constant=found.is_constant)
