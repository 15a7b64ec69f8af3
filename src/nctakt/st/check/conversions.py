# SPDX-License-Identifier: MIT
"""Which types convert into which without a word, with a warning, or not at all (ST-306)."""

from __future__ import annotations

import enum

from nctakt.st.tree import Call
from nctakt.st.types import (
    AnyType,
    ArrayType,
    BlockType,
    Elementary,
    EnumType,
    Expression,
    Family,
    InterfaceType,
    PointerType,
    ReferenceType,
    StringType,
    StructType,
    Type,
    same_type,
)
from nctakt.st.vocabulary.elementary import INTEGERS, UNTYPED, UNTYPED_REAL


class Verdict(enum.Enum):
    """Whether a value converts into a type."""

    FITS = "fits"
    SIGN_MAY_CHANGE = "signed -> unsigned"  # C0195, C0196
    DIGITS_MAY_GET_LOST = "integer -> real"
    POINTER_CHANGES = "pointer <-> integer, pointers of other types"  # C0033
    IMPOSSIBLE = "C0032"


def conversion(source: Type, target: Type, node: Expression | None = None) -> Verdict:
    """Return whether a value of type ``source`` converts into ``target`` by itself.

    ``node``: the value; a constant converts if its value fits, an address into any pointer.
    """
    if source is target or same_type(source, target) or isinstance(source, AnyType):
        return Verdict.FITS
    if isinstance(target, ReferenceType):
        return conversion(source, target.target, node)
    if isinstance(source, ReferenceType):
        return conversion(source.target, target, node)
    match target:
        case Elementary():
            return _to_elementary(source, target, node)
        case StringType():
            fits = isinstance(source, StringType) and source.is_wide == target.is_wide
            return Verdict.FITS if fits else Verdict.IMPOSSIBLE
        case EnumType():
            return _to_enumeration(source, target, node)
        case PointerType():
            return _to_pointer(source, target, node)
        case InterfaceType():
            return _to_interface(source, target, node)
        case AnyType():
            return Verdict.FITS
        case ArrayType():
            return _to_array(source, target)
        case StructType():
            fits = isinstance(source, StructType) and extends(source, target)
            return Verdict.FITS if fits else Verdict.IMPOSSIBLE
        case BlockType():
            fits = isinstance(source, BlockType) and target.pou in source.pou.bases()
            return Verdict.FITS if fits else Verdict.IMPOSSIBLE
    return Verdict.IMPOSSIBLE


def _to_elementary(source: Type, target: Elementary, node: Expression | None) -> Verdict:
    value = None if node is None else node.value
    if isinstance(source, EnumType):
        return _to_elementary(source.base, target, node)
    if isinstance(source, PointerType) and target.family in INTEGERS:
        return Verdict.POINTER_CHANGES
    if not isinstance(source, Elementary):
        return Verdict.IMPOSSIBLE
    if source is UNTYPED_REAL:
        return Verdict.FITS if target.family is Family.REAL else Verdict.IMPOSSIBLE
    if source.family in INTEGERS and target.family in INTEGERS:
        return _whole(source, target, value, node)
    if source is UNTYPED and target.family is Family.BOOL:
        return Verdict.FITS if value in (0, 1) else Verdict.IMPOSSIBLE
    if source.family in INTEGERS and target.family is Family.REAL:
        is_exact = source is UNTYPED or source.size < target.size
        return Verdict.FITS if is_exact else Verdict.DIGITS_MAY_GET_LOST
    if source.family is target.family:
        if source.family in (Family.BOOL, Family.DURATION, Family.DATE):
            is_same = source.name == target.name or source.family is Family.BOOL
            return Verdict.FITS if is_same else Verdict.IMPOSSIBLE
        fits = source.size <= target.size or (
            isinstance(value, float) and value == round_real(value)
        )
        return Verdict.FITS if fits else Verdict.DIGITS_MAY_GET_LOST
    return Verdict.IMPOSSIBLE


def round_real(value: float) -> float:
    """Return a number as REAL holds it."""
    import struct  # noqa: PLC0415 - constants of REAL are few

    try:
        rounded: float = struct.unpack("<f", struct.pack("<f", value))[0]
    except OverflowError:
        return float("inf") if value > 0 else float("-inf")
    return rounded


def _whole(
    source: Elementary, target: Elementary, value: object, node: Expression | None
) -> Verdict:
    if source is UNTYPED and value is None and isinstance(node, Call):
        # SEL(x, 1, 0): each of its literals has to fit.
        verdicts = [
            _whole(UNTYPED, target, one.value, one) for one in node.operands if one.type is UNTYPED
        ]
        return next((one for one in verdicts if one is not Verdict.FITS), Verdict.FITS)
    if isinstance(value, int):
        if target.low <= value <= target.high:
            return Verdict.FITS
        if not target.is_signed and -(target.high // 2) - 1 <= value < 0:
            return Verdict.SIGN_MAY_CHANGE
        return _sized(source, target)
    if target.low <= source.low and source.high <= target.high:
        return Verdict.FITS
    if target.is_subrange and target.size >= source.size:
        return Verdict.FITS
    return _sized(source, target)


def _sized(source: Elementary, target: Elementary) -> Verdict:
    if source is UNTYPED or target.size < source.size:
        return Verdict.IMPOSSIBLE
    return Verdict.SIGN_MAY_CHANGE


def _to_enumeration(source: Type, target: EnumType, node: Expression | None) -> Verdict:
    if target.is_strict or isinstance(source, EnumType):
        return Verdict.IMPOSSIBLE if target.is_strict else Verdict.FITS
    return _to_elementary(source, target.base, node)


def _to_pointer(source: Type, target: PointerType, node: Expression | None) -> Verdict:
    if isinstance(source, PointerType):
        if source.target is None or target.target is None:
            return Verdict.FITS
        if isinstance(node, Call) and node.function == "ADR":
            return Verdict.FITS
        first, second = source.target, target.target
        if isinstance(first, BlockType) and isinstance(second, BlockType):
            if second.pou in first.pou.bases():
                return Verdict.FITS
        return Verdict.POINTER_CHANGES
    if isinstance(source, Elementary) and source.family in INTEGERS:
        if node is not None and node.value == 0:
            return Verdict.FITS
        return Verdict.POINTER_CHANGES
    return Verdict.IMPOSSIBLE


def _to_interface(source: Type, target: InterfaceType, node: Expression | None) -> Verdict:
    if isinstance(source, BlockType):
        fits = any(target in bases_of(one) for pou in source.pou.bases() for one in pou.interfaces)
        return Verdict.FITS if fits else Verdict.IMPOSSIBLE
    if isinstance(source, InterfaceType):
        return Verdict.FITS if target in bases_of(source) else Verdict.IMPOSSIBLE
    if isinstance(source, Elementary) and node is not None and node.value == 0:
        return Verdict.FITS
    return Verdict.IMPOSSIBLE


def _to_array(source: Type, target: ArrayType) -> Verdict:
    if not isinstance(source, ArrayType) or source.dimensions != target.dimensions:
        return Verdict.IMPOSSIBLE
    if target.is_open and same_type(source.element, target.element):
        return Verdict.FITS
    lengths = [high - low for low, high in source.bounds]
    fits = lengths == [high - low for low, high in target.bounds]
    return (
        Verdict.FITS if fits and same_type(source.element, target.element) else Verdict.IMPOSSIBLE
    )


def bases_of(kind: InterfaceType) -> list[InterfaceType]:
    """Return an interface with all that it extends."""
    found = [kind]
    for base in found:
        found += [one for one in base.bases if one not in found]
    return found


def extends(kind: StructType, base: StructType) -> bool:
    """Whether a structure is or extends another one."""
    found: StructType | None = kind
    while found is not None:
        if found is base:
            return True
        found = found.base
    return False
