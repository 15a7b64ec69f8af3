# SPDX-License-Identifier: MIT
"""Symbols and their data types, as published to ADS clients (AD-3)."""

from __future__ import annotations

from nctakt.base.dataclass import dataclass


@dataclass(frozen=True, slots=True)
class DataType:
    """A type: name, number in ADS, size; elements of an array of ``base``, or members.

    ``bounds``: lower bound and count of each dimension of an array that is not counted from 0.
    """

    name: str
    number: int
    size_bytes: int
    elements: int = 0
    base: str = ""
    members: tuple[Member, ...] = ()
    bounds: tuple[tuple[int, int], ...] = ()

    @property
    def dimensions(self) -> tuple[tuple[int, int], ...]:
        """Lower bound and count of each dimension of an array."""
        return self.bounds or (((0, self.elements),) if self.elements else ())


@dataclass(frozen=True, slots=True)
class Member:
    """A member of a structure."""

    name: str
    type: DataType
    offset: int


@dataclass(frozen=True, slots=True)
class Symbol:
    """A symbol: where it is, and its type."""

    name: str
    group: int
    offset: int
    type: DataType
    unit: str
    is_writable: bool
