# SPDX-License-Identifier: MIT
"""Queries of code about types and names: ANY, __VARINFO, instance paths (ST-620, ST-621)."""

from __future__ import annotations

from collections.abc import Iterator

from nctakt.st.tree import Member, Name
from nctakt.st.types import (
    ArrayType,
    BlockType,
    Elementary,
    EnumType,
    Expression,
    InterfaceType,
    PointerType,
    Pou,
    ReferenceType,
    Storage,
    StringType,
    StructType,
    Type,
    Variable,
)
from nctakt.translation.initial_values import put_scalar

_CLASSES = {"DATE_AND_TIME": "DATEANDTIME", "TIME_OF_DAY": "TIMEOFDAY"}
_PATH = "instance-path"


def class_name(found: Type) -> str:
    """Return the name of a type's class without its prefix."""
    match found:
        case Elementary(is_subrange=True):
            return "SUBRANGE"
        case Elementary(name=name):
            return _CLASSES.get(name, name)
        case StringType(is_wide=is_wide):
            return "WSTRING" if is_wide else "STRING"
        case EnumType():
            return "ENUM"
        case ArrayType():
            return "ARRAY"
        case PointerType():
            return "POINTER"
        case ReferenceType():
            return "REFERENCE"
        case InterfaceType():
            return "INTERFACE"
    return "USERDEF"


def class_number(found: Type, form: StructType) -> int:
    """Return the number of a type's class in ``TypeClass`` of a structure."""
    kind = form.members["typeclass"].type
    assert isinstance(kind, EnumType)
    return kind.values[f"type_{class_name(found)}".lower()].number


def information(expression: Expression, form: StructType) -> bytes:
    """Return the result of ``__VARINFO`` for a variable: the bytes of its structure."""
    found, target = expression.type, getattr(expression, "target", None)
    assert found is not None
    image = bytearray(form.size)
    element = found.element if isinstance(found, ArrayType) else found
    count = found.size // max(element.size, 1) if isinstance(found, ArrayType) else 1
    name = target.name if isinstance(target, Variable) else ""
    if not name and isinstance(expression, Name | Member):
        name = expression.name
    values: dict[str, int | bytes] = {
        "bitsize": 8 * found.size,
        "typeclass": class_number(found, form),
        "typename": found.name.encode("latin-1", "replace"),
        "numelements": count if isinstance(found, ArrayType) else 0,
        "basetypeclass": class_number(element, form),
        "elembitsize": 8 * element.size if isinstance(found, ArrayType) else 0,
        "symbol": name.encode("latin-1", "replace"),
    }
    for key, value in values.items():
        member = form.members[key]
        put_scalar(image, member.offset, member.type, value)
    return bytes(image)


class InstancePaths:
    """The texts of variables with ``instance-path`` in blocks with ``reflection``."""

    def __init__(self, project: str) -> None:
        self._project = project
        self._known: dict[int, bool] = {}

    def below(self, offset: int, found: Type, path: str) -> Iterator[tuple[int, StringType, bytes]]:
        """Yield where a path is kept in a variable of the data, and the path."""
        if not self._has_paths(found):
            return
        if isinstance(found, ArrayType):
            for index in range(found.size // max(found.element.size, 1)):
                name = f"{path}{_index_text(found, index)}"
                yield from self.below(offset + index * found.element.size, found.element, name)
        elif isinstance(found, BlockType):
            for one in self._members(found.pou):
                if _keeps_path(found.pou, one) and isinstance(one.type, StringType):
                    text = f"{self._project}.{path}".encode("latin-1", "replace")
                    yield offset + one.offset, one.type, text
                yield from self.below(offset + one.offset, one.type, f"{path}.{one.name}")
        elif isinstance(found, StructType):
            for one in found.members.values():
                yield from self.below(offset + one.offset, one.type, f"{path}.{one.name}")

    @staticmethod
    def _members(pou: Pou) -> list[Variable]:
        return [one for one in pou.members.values() if one.storage is Storage.INSTANCE]

    def _has_paths(self, found: Type) -> bool:
        if isinstance(found, ArrayType):
            return self._has_paths(found.element)
        known = self._known.get(id(found))
        if known is None:
            parts: list[Variable] = []
            if isinstance(found, BlockType):
                parts = self._members(found.pou)
                known = any(_keeps_path(found.pou, one) for one in parts)
            elif isinstance(found, StructType):
                parts = list(found.members.values())
            known = self._known[id(found)] = known or any(
                self._has_paths(one.type) for one in parts
            )
        return known


def _keeps_path(pou: Pou, variable: Variable) -> bool:
    return _PATH in variable.attributes and any(
        "reflection" in one.attributes for one in pou.bases()
    )


def _index_text(found: ArrayType, number: int) -> str:
    """Return the index of an element, given its number in the memory."""
    shown: list[str] = []
    for low, high in reversed(found.bounds):
        number, rest = divmod(number, high - low + 1)
        shown.append(str(low + rest))
    return f"[{','.join(reversed(shown))}]"
