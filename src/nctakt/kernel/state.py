# SPDX-License-Identifier: MIT
"""What copies the state of the realtime part's objects, and what returns their arrays.

In: the fields that ``state_fields`` finds in the C types. Out: ``COPIERS`` (class -> a function
that copies from one object to another), ``ARRAYS`` (class -> a function that returns the arrays
whose content is kept), ``SAME`` (class -> a function that says whether two objects have the same
ones of the arrays that are exchanged) and ``ArrayCopies``, which keeps that content; what a base
class declares, its own entries copy. Compiled, they are in ``_state``, which the build writes;
plain, they are made here.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable
from pathlib import Path
from types import MappingProxyType
from typing import Any, NamedTuple, Protocol

from nctakt.base.mode import is_compiled
from nctakt.kernel.state_fields import TypedClass, typed_classes

Copier = Callable[[Any, Any], None]
Arrays = Callable[[Any], tuple[Any, ...]]
Comparison = Callable[[Any, Any], bool]


class KeptArrays(Protocol):
    """The content of arrays at some moment."""

    def take(self) -> None:
        """Take the present content."""

    def put_back(self) -> None:
        """Put the content back as it was when it was taken."""


class Tables(NamedTuple):
    """What there is for each class, and what keeps the content of arrays."""

    copiers: dict[type, Copier]
    arrays: dict[type, Arrays]
    same: dict[type, Comparison]
    array_copies: Callable[[list[bytearray]], KeptArrays]


class PlainArrayCopies:
    """The content of arrays, taken when it is made."""

    def __init__(self, arrays: list[bytearray]) -> None:
        self._pairs = [(memoryview(one), memoryview(bytearray(one))) for one in arrays]

    def take(self) -> None:
        """Take the present content."""
        for live, kept in self._pairs:
            kept[:] = live

    def put_back(self) -> None:
        """Put the content back as it was when it was taken."""
        for live, kept in self._pairs:
            live[:] = kept


def _copier(found: TypedClass) -> Copier:
    """Return what copies the fields of a class in plain Python."""
    names = tuple(found.copied)

    def copy(source: Any, target: Any) -> None:
        for name in names:
            value = getattr(source, name)
            setattr(target, name, list(value) if type(value) is list else value)

    return copy


def _arrays(found: TypedClass) -> Arrays:
    """Return what returns the arrays of an object of a class in plain Python."""
    names = tuple(found.arrays)
    return lambda part: tuple(getattr(part, name) for name in names)


def _same(found: TypedClass) -> Comparison:
    """Return what compares the arrays of two objects of a class in plain Python."""
    names = tuple(found.exchanged)
    return lambda one, other: all(getattr(one, name) is getattr(other, name) for name in names)


def _plain() -> Tables:
    """Return the tables of the plain classes."""
    tables = Tables({}, {}, {}, PlainArrayCopies)
    for found in typed_classes(Path(__file__).parent):
        if found.copied or found.arrays:
            cls = getattr(importlib.import_module(found.module), found.name)
            if found.copied:
                tables.copiers[cls] = _copier(found)
            if found.arrays:
                tables.arrays[cls] = _arrays(found)
            if found.exchanged:
                tables.same[cls] = _same(found)
    return tables


def _compiled() -> Tables:
    """Return the tables of the compiled classes."""
    module = importlib.import_module("nctakt.kernel._state")
    return Tables(module.COPIERS, module.ARRAYS, module.SAME, module.ArrayCopies)


_FOUND = _compiled() if is_compiled() else _plain()
COPIERS = MappingProxyType(_FOUND.copiers)
ARRAYS = MappingProxyType(_FOUND.arrays)
SAME = MappingProxyType(_FOUND.same)
ArrayCopies = _FOUND.array_copies
