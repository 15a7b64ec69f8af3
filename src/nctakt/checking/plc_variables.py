# SPDX-License-Identifier: MIT
"""Structures that the code of a PLC lays over the V.E variables, and the lists (ST-764).

In: a checked PLC program and a machine. Out: a warning for each member that lies where the list
has another type or size, within another one, or beyond the last one. Arrays of bytes are gaps. A
pointer that the code also moves elsewhere is not judged.
"""

from __future__ import annotations

from collections.abc import Iterator

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import NOTHING, Text
from nctakt.hli.variables_memory import describe
from nctakt.lists.machine.machine import Machine
from nctakt.st import tree
from nctakt.st.types import (
    ArrayType,
    Elementary,
    EnumType,
    Family,
    Node,
    PointerType,
    StringType,
    StructType,
    Type,
    Variable,
)

_CHANNELS, _GLOBAL = "gpVECh", "gpVEGlob"


@dataclass(frozen=True, slots=True)
class Pointed:
    """Assignment to a pointer: the channel of V.E variables, 0 for the global ones.

    ``channel`` is ``None`` for any other address.
    """

    pointer: Variable
    channel: int | None


@dataclass(frozen=True, slots=True)
class _Leaf:
    """A number, truth or text: its path, its place, and its type."""

    path: str
    offset: int
    size: int
    kind: str
    shown: str
    member: Variable | None = None


def pointed(target: object, value: object) -> Pointed | None:
    """Return the meaning of an assignment to a pointer to a structure; ``None`` for others."""
    variable = getattr(target, "target", None)
    if not isinstance(variable, Variable) or not isinstance(variable.type, PointerType):
        return None
    if not isinstance(variable.type.target, StructType):
        return None
    channel: int | None = None
    if _names(value, _GLOBAL):
        channel = 0
    elif isinstance(value, tree.Index) and _names(value.base, _CHANNELS):
        number = value.indices[0].value
        if isinstance(number, int) and number >= 0:  # another index is reported by itself
            channel = number + 1
    return Pointed(variable, channel)


def _names(node: object, root: str) -> bool:
    """Return whether an expression is a pointer of the interface, however it is spelt."""
    target = node.target if isinstance(node, tree.Name) else None
    return isinstance(target, Variable) and target.name == root


def differing(found: list[Pointed], machine: Machine) -> Iterator[tuple[Node, dict[str, object]]]:
    """Yield the members that do not lie on a variable of their kind: their names, and values."""
    channels: dict[Variable, set[int | None]] = {}
    for one in found:
        channels.setdefault(one.pointer, set()).add(one.channel)
    compared: set[tuple[int, int]] = set()
    for pointer, known in channels.items():
        if None in known:
            continue
        kind = pointer.type.target if isinstance(pointer.type, PointerType) else None
        for channel in sorted(one for one in known if one is not None):
            if not isinstance(kind, StructType) or channel > len(machine.channels):
                continue
            if (id(kind), channel) not in compared:
                compared.add((id(kind), channel))
                yield from _differences(kind, machine, channel)


def _differences(
    kind: StructType, machine: Machine, channel: int
) -> Iterator[tuple[Node, dict[str, object]]]:
    listed = {leaf.offset: leaf for leaf in _listed(machine, channel)}
    taken = {leaf.offset + byte: leaf for leaf in listed.values() for byte in range(leaf.size)}
    reported: set[Variable] = set()
    for leaf in _leaves(kind, kind.name, 0, None, max(listed, default=0)):
        other, member = listed.get(leaf.offset), leaf.member
        if member is None or member in reported:
            continue
        if other is not None and (other.kind, other.size) == (leaf.kind, leaf.size):
            continue
        if other is None:
            under = (taken.get(leaf.offset + byte) for byte in range(leaf.size))
            other = next((one for one in under if one is not None), None)
            if other is None and leaf.offset < max(taken, default=0):
                continue
        reported.add(member)
        yield (
            Node(member.start, member.start + len(member.name)),
            {
                "name": leaf.path,
                "offset": leaf.offset,
                "root": f"{_CHANNELS}[{channel - 1}]" if channel else _GLOBAL,
                "type": leaf.shown,
                "other": NOTHING if other is None else Text(other.shown, other.shown),
            },
        )


def _listed(machine: Machine, channel: int) -> Iterator[_Leaf]:
    for field in describe(machine, channel):
        kind = {"BOO": "truth", "REA": "real", "STR": "text", "VST": "text"}.get(field.type[:3])
        kind = kind or ("signed" if field.type.startswith("SGN") else "unsigned")
        for number in range(max(field.count, 1)):
            index = f"[{number}]" if field.count else ""
            offset = field.offset + number * field.size_bytes
            shown = f"V.E.{field.path}{index} ({field.type})"
            yield _Leaf(field.path, offset, field.size_bytes, kind, shown)


def _leaves(
    kind: Type, path: str, offset: int, member: Variable | None, last: int
) -> Iterator[_Leaf]:
    """Yield the leaves of a type; of an array none that begin far beyond offset ``last``.

    ``member``: that of the outermost structure.
    """
    if isinstance(kind, StructType):
        for one in kind.members.values():
            name = f"{path}.{one.name}"
            yield from _leaves(one.type, name, offset + one.offset, member or one, last)
    elif isinstance(kind, ArrayType) and not kind.is_open:
        size = max(kind.element.size, 1)
        is_gap = size == 1 and _kind_of(kind.element) == "unsigned"
        for begin in range(offset, 0 if is_gap else offset + kind.size, size):
            yield from _leaves(kind.element, path, begin, member, last)
            if begin > last:
                break
    else:
        yield _Leaf(path, offset, kind.size, _kind_of(kind), kind.name, member)


def _kind_of(kind: Type) -> str:
    if isinstance(kind, StringType):
        return "text"
    if isinstance(kind, EnumType):
        return "signed" if kind.base.is_signed else "unsigned"
    if not isinstance(kind, Elementary):
        return "address"
    if kind.family is Family.BOOL:
        return "truth"
    if kind.family is Family.REAL:
        return "real"
    return "signed" if kind.is_signed else "unsigned"
