# SPDX-License-Identifier: MIT
"""The memory of a PLC project: which address everything has (ST-001, ST-330, ST-407).

From the lowest address on: bytes that no pointer reaches, the data area with globals and program
instances, the stack of calls, literals and initial images, the interface to the CNC.
"""

from __future__ import annotations

from nctakt.kernel.st import kinds
from nctakt.kernel.st.context import PlcContext
from nctakt.st.types import (
    ArrayType,
    Callable,
    Elementary,
    EnumType,
    Family,
    InterfaceType,
    PointerType,
    ReferenceType,
    Section,
    Storage,
    Type,
    Variable,
)

#: Bytes of the stack of calls unless the project says otherwise.
STACK_BYTES = 1 << 18

_SIGNED = {1: kinds.I8, 2: kinds.I16, 4: kinds.I32, 8: kinds.I64}
_UNSIGNED = {1: kinds.U8, 2: kinds.U16, 4: kinds.U32, 8: kinds.U64}


def aligned(number: int, align: int) -> int:
    """Return the next multiple of ``align``."""
    return -(-number // align) * align


def kind_of(kind_type: Type) -> int | None:
    """Return how a value of a type lies in memory; nothing for texts, structures and arrays."""
    match kind_type:
        case Elementary(is_bit=True):
            return kinds.U8  # its bit is one of a byte (ST-312)
        case Elementary(family=Family.BOOL):
            return kinds.BOOL
        case Elementary(family=Family.REAL, size=size):
            return kinds.F32 if size == 4 else kinds.F64
        case Elementary(size=size):
            return _SIGNED[size] if kind_type.is_signed else _UNSIGNED[size]
        case EnumType(base=base):
            return kind_of(base)
        case PointerType() | ReferenceType() | InterfaceType():
            return kinds.U64
    return None


def is_real(kind_type: Type | None) -> bool:
    """Return whether values of a type are real numbers."""
    return isinstance(kind_type, Elementary) and kind_type.family is Family.REAL


def is_unsigned(kind_type: Type | None) -> bool:
    """Return whether values of a type are unsigned whole numbers (ST-303)."""
    return kind_type is not None and kind_of(kind_type) in (
        kinds.U8, kinds.U16, kinds.U32, kinds.U64,
    )  # fmt: skip


def as_word(number: int) -> int:
    """Return a whole number of 64 bits with the same bits as a signed one."""
    return ((number + (1 << 63)) & ((1 << 64) - 1)) - (1 << 63)


def lay_out_frame(called: Callable) -> int:
    """Lay out a frame: result and parameters first; return the bytes that the caller shares.

    All that override a method have the same result and parameters, so the same locations for them.
    """
    shared = [called.result] if called.result is not None else []
    shared += [one for one in called.parameters if one.storage is Storage.FRAME]
    size = _placed(shared, 0)
    known = {id(one) for one in shared}
    others = [
        one
        for one in called.variables.values()
        if one.storage is Storage.FRAME and id(one) not in known
    ]
    called.frame_size = aligned(_placed(others, size), 8)
    return size


def _placed(variables: list[Variable], size: int) -> int:
    """Give variables of a frame their offsets from ``size`` on; return the end, aligned."""
    for one in variables:
        one.offset = aligned(size, max(slot_align(one), 1))
        size = one.offset + slot_size(one)
    return aligned(size, 8)


def slot_size(variable: Variable) -> int:
    """Return the bytes of a variable's slot in a frame; VAR_IN_OUT has an address, and bounds."""
    found = variable.type
    if variable.section is not Section.IN_OUT:
        return found.size
    return 8 + 8 * found.dimensions if isinstance(found, ArrayType) and found.is_open else 8


def slot_align(variable: Variable) -> int:
    """Return the alignment of a slot in a frame."""
    return 8 if variable.section is Section.IN_OUT else variable.type.align


class Layout:
    """Addresses, and the memory that is made of them."""

    def __init__(self, data_size: int, stack_bytes: int = STACK_BYTES) -> None:
        self.data_end = aligned(kinds.NULL_BYTES + data_size, 8)
        self.stack_end = self.data_end + aligned(stack_bytes, 8)
        self._literals = bytearray()
        self._known: dict[bytes, int] = {}
        self.data = bytearray(self.data_end - kinds.NULL_BYTES)

    def address(self, offset: int) -> int:
        """Return the address of a byte of the data area."""
        return kinds.NULL_BYTES + offset

    def literal(self, content: bytes) -> int:
        """Return the address of bytes that do not change."""
        found = self._known.get(content)
        if found is None:
            self._literals += bytes(aligned(len(self._literals), 8) - len(self._literals))
            found = self._known[content] = self.stack_end + len(self._literals)
            self._literals += content
        return found

    def known_literal(self, content: bytes) -> int | None:
        """Return the address of bytes that do not change, ``None`` where there are none such."""
        return self._known.get(content)

    @property
    def interface(self) -> int:
        """The address where the interface to the CNC begins, once all literals are known."""
        return aligned(self.stack_end + len(self._literals), 64)

    def memory(self, interface: bytes = b"") -> bytearray:
        """Return a memory: the initial data, an empty stack, an interface."""
        memory = bytearray(kinds.NULL_BYTES) + self.data
        memory += bytes(self.stack_end - self.data_end) + self._literals
        memory += bytes(self.interface - len(memory)) + interface
        memory += bytes(aligned(len(memory), 8) - len(memory)) + bytes(kinds.SLACK + 8)
        return memory

    def context(self, memory: bytearray) -> PlcContext:
        """Return a context with a memory of this layout."""
        return PlcContext(memory, self.data_end, self.stack_end, self.interface)
