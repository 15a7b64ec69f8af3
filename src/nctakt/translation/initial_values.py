# SPDX-License-Identifier: MIT
"""Initial values as bytes, as far as they are constant (ST-403)."""

from __future__ import annotations

import struct
from collections.abc import Callable as Function

from nctakt.kernel.st import kinds
from nctakt.st.tree import ArrayInitial, Repetition, StructInitial
from nctakt.st.types import (
    ArrayType,
    BlockType,
    Elementary,
    EnumType,
    Expression,
    Pou,
    Section,
    Storage,
    StringType,
    StructType,
    Type,
    Value,
    Variable,
)
from nctakt.translation.layout import as_word, kind_of

_SIZES = {
    kinds.BOOL: 1, kinds.I8: 1, kinds.U8: 1, kinds.I16: 2, kinds.U16: 2, kinds.I32: 4,
    kinds.U32: 4, kinds.I64: 8, kinds.U64: 8,
}  # fmt: skip


class Images:
    """The bytes of variables as they begin; each type's are made once."""

    def __init__(self, number_of: Function[[Pou], int]) -> None:
        self._number_of = number_of
        self._known: dict[int, bytes] = {}

    def of_type(self, sought: Type) -> bytes:
        """Return the bytes of a variable without an initial value of its own."""
        found = self._known.get(id(sought))
        if found is None:
            image = bytearray(sought.size)
            self._fill(image, sought)
            found = self._known[id(sought)] = bytes(image)
        return found

    def _fill(self, image: bytearray, sought: Type) -> None:
        if isinstance(sought, EnumType):
            put_scalar(image, 0, sought, sought.initial)
        elif isinstance(sought, Elementary) and sought.is_subrange:
            put_scalar(image, 0, sought, sought.low)
        elif isinstance(sought, ArrayType) and not sought.is_open:
            element = self.of_type(sought.element)
            if any(element):
                image[:] = element * (len(image) // max(len(element), 1))
        elif isinstance(sought, StructType):
            for one in sought.members.values():
                self.put_variable(image, one.offset, one)
        elif isinstance(sought, BlockType):
            image[:8] = struct.pack("<q", self._number_of(sought.pou))
            for one in sought.pou.members.values():
                if one.storage is Storage.INSTANCE and one.section is not Section.IN_OUT:
                    self.put_variable(image, one.offset, one)

    def of_variable(self, variable: Variable) -> bytes:
        """Return the bytes of a variable with its initial value, as far as it is constant."""
        image = bytearray(variable.type.size)
        self.put_variable(image, 0, variable)
        return bytes(image)

    def put_variable(self, image: bytearray, offset: int, variable: Variable) -> None:
        """Put a variable with its initial value at an offset."""
        if variable.bit >= 0:
            if variable.initial is not None and variable.initial.value:
                image[offset] |= 1 << variable.bit
            return
        image[offset : offset + variable.type.size] = self.of_type(variable.type)
        if variable.initial is not None:
            self.put(image, offset, variable.type, variable.initial)

    def put(self, image: bytearray, offset: int, sought: Type, value: Expression) -> None:
        """Put the constant parts of an initial value at an offset."""
        if isinstance(value, StructInitial):
            for member, part in value.bound:
                if member.bit < 0:
                    self.put(image, offset + member.offset, member.type, part)
                elif part.value:
                    image[offset + member.offset] |= 1 << member.bit
        elif isinstance(value, ArrayInitial) and isinstance(sought, ArrayType):
            for location, part in items_in_order(value):
                at = offset + location * sought.element.size
                if at + sought.element.size <= offset + sought.size:
                    self.put(image, at, sought.element, part)
        elif value.value is not None:
            put_scalar(image, offset, sought, value.value)


def items_in_order(value: ArrayInitial) -> list[tuple[int, Expression]]:
    """Return the elements of an array's initial value with their locations."""
    found: list[tuple[int, Expression]] = []
    location = 0
    for item in value.items:
        if isinstance(item, Repetition):
            for _ in range(item.number):
                for one in item.values:
                    found.append((location, one))
                    location += 1
        else:
            found.append((location, item))
            location += 1
    return found


def put_scalar(image: bytearray, offset: int, sought: Type, value: Value) -> None:
    """Put a number, a truth or a text at an offset."""
    if isinstance(sought, StringType):
        if isinstance(value, bytes):
            text = value[: sought.size - (2 if sought.is_wide else 1)]
            image[offset : offset + sought.size] = text.ljust(sought.size, b"\0")
        return
    kind = kind_of(sought)
    if kind is None or isinstance(value, bytes):
        return
    if kind in (kinds.F32, kinds.F64):
        struct.pack_into("<f" if kind == kinds.F32 else "<d", image, offset, float(value))
    else:
        size = _SIZES[kind]
        word = struct.pack("<q", as_word(int(value)))
        image[offset : offset + size] = word[:size]


def is_constant(value: Expression) -> bool:
    """Return whether an initial value is known before the run."""
    if isinstance(value, StructInitial):
        return all(is_constant(part) for _, part in value.bound)
    if isinstance(value, ArrayInitial):
        return all(is_constant(part) for _, part in items_in_order(value))
    return value.value is not None
