# SPDX-License-Identifier: MIT
"""Symbols and their data types: what a client of ADS learns of them (AD-3)."""

from __future__ import annotations

from nctakt.base.dataclass import dataclass


@dataclass(frozen=True, slots=True)
class DataType:
    """A type: name, number in ADS, size; elements of an array of ``base``, or members."""

    name: str
    number: int
    size_bytes: int
    elements: int = 0
    base: str = ""
    members: tuple[Member, ...] = ()


@dataclass(frozen=True, slots=True)
class Member:
    """A member of a structure."""

    name: str
    type: DataType
    offset: int


@dataclass(frozen=True, slots=True)
class Symbol:
    """A symbol: where it stands, and its type."""

    name: str
    group: int
    offset: int
    type: DataType
    unit: str
    is_writable: bool
